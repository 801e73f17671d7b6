// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Flips the edges of a mesh until its triangulation is intrinsic Delaunay.

#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/make_Delaunay.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <iostream>

namespace IT = CGAL::Intrinsic_triangulations;
typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Mesh;

int main(int argc, char* argv[])
{
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : CGAL::data_file_path("meshes/cow.off"),
                                  mesh))
    return 1;

  IT::Intrinsic_triangulation<> tri(mesh); // the mesh is only read
  const std::size_t flips = IT::make_Delaunay(tri);

  std::size_t shared = 0;
  for(IT::Edge_index e : tri.mesh().edges())
    shared += tri.coordinates().is_shared(e) ? 1 : 0;
  std::cout << flips << " flips; " << shared << " of " << tri.mesh().number_of_edges()
            << " edges are edges of the input\n";
}
