// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Traces the edges of a mesh over its intrinsic Delaunay triangulation, with one thread and with
// several.

#include <CGAL/Intrinsic_triangulations/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/make_Delaunay.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <iostream>

namespace IT = CGAL::Intrinsic_triangulations;
typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Mesh;
typedef IT::Correspondence<> Correspondence;

// Returns the sum of the positions of all crossings, which shows every bit of them.
double sum_of_places(const Correspondence& correspondence)
{
  double sum = 0;
  for(Correspondence::size_type c = 0; c < correspondence.number_of_crossings(); ++c)
    sum += correspondence.crossing(c).on_input.t;
  return sum;
}

int main(int argc, char* argv[])
{
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : CGAL::data_file_path("meshes/armadillo.off"),
                                  mesh))
    return 1;

  IT::Intrinsic_triangulation<> tri(mesh);
  IT::make_Delaunay(tri);

  const auto in_parallel = IT::parameters::concurrency_tag(CGAL::Parallel_tag());
  const Correspondence one_thread(tri), several_threads(tri, in_parallel);
  const IT::Common_subdivision<> subdivision(several_threads, in_parallel);

  std::cout << several_threads.number_of_crossings() << " crossings, "
            << subdivision.mesh().number_of_faces() << " faces of the common subdivision\n";
  return sum_of_places(one_thread) == sum_of_places(several_threads) ? 0 : 1;
}
