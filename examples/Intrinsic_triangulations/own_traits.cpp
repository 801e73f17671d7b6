// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Defines a geometry: only edges that become shorter by a tenth or more are flipped.

#include <CGAL/Intrinsic_triangulations/Euclidean_geometry_traits.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/make_Delaunay.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <iostream>

namespace IT = CGAL::Intrinsic_triangulations;
typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Mesh;

// Each flip makes the sum of all lengths smaller, so that flipping ends. Lengths alone decide, as
// exact decisions know only the condition that is replaced here.
struct Thrifty_traits : IT::Euclidean_geometry_traits<>
{
  struct Is_locally_Delaunay : IT::Euclidean_geometry_traits<>::Is_locally_Delaunay
  {
    typedef IT::Euclidean_geometry_traits<>::Is_locally_Delaunay Base;

    bool operator()(const IT::Diamond<double>& length) const
    {
      return Base::operator()(length) || Compute_flipped_length()(length) > .9 * length.ij;
    }
  };

  Is_locally_Delaunay is_locally_Delaunay_object() const { return Is_locally_Delaunay(); }
};

template <typename Traits>
void flip(const Mesh& mesh)
{
  IT::Intrinsic_triangulation<Traits> tri(mesh);
  const std::size_t flips = IT::make_Delaunay(tri);
  double length = 0;
  for(IT::Edge_index e : tri.mesh().edges())
    length += tri.length(e);
  std::cout << flips << " flips, edges of length " << length << " in all\n";
}

int main(int argc, char* argv[])
{
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : CGAL::data_file_path("meshes/fandisk.off"),
                                  mesh))
    return 1;
  flip<IT::Euclidean_geometry_traits<>>(mesh);
  flip<Thrifty_traits>(mesh);
}
