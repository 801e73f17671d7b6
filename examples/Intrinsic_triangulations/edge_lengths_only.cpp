// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Flips a flat torus that has no embedding to Delaunay: one vertex, two triangles, and three edges
// with lengths. At the start the triangulation is sheared far.

#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/make_Delaunay.h>

#include <array>
#include <cmath>
#include <iostream>

namespace IT = CGAL::Intrinsic_triangulations;

// Makes the three halfedges, all from vertex 0 to itself, the sides of face `f`.
void set_triangle(const std::array<unsigned, 3>& sides, IT::Face_index f, IT::Delta_complex& torus)
{
  for(std::size_t s = 0; s < 3; ++s) {
    const IT::Halfedge_index h(sides[s]);
    torus.set_next(h, IT::Halfedge_index(sides[(s + 1) % 3]));
    torus.set_target(h, IT::Vertex_index(0));
    torus.set_face(h, f);
    torus.set_halfedge(f, h);
  }
}

// Edge 0 runs around the torus, edge 1 along it, edge 2 is the diagonal of the two.
IT::Delta_complex make_torus()
{
  IT::Delta_complex torus;
  torus.resize(1, 3, 2);
  set_triangle({0, 2, 5}, IT::Face_index(0), torus);
  set_triangle({4, 1, 3}, IT::Face_index(1), torus);
  torus.set_halfedge(IT::Vertex_index(0), IT::Halfedge_index(0));
  return torus;
}

int main()
{
  IT::Delta_complex torus = make_torus();
  auto length = torus.add_property_map<IT::Edge_index, double>("e:my_length").first;
  length[IT::Edge_index(0)] = 1;
  length[IT::Edge_index(1)] = std::hypot(20.25, 1);
  length[IT::Edge_index(2)] = std::hypot(21.25, 1);

  IT::Intrinsic_triangulation<> tri(torus, IT::parameters::edge_length_map(length));
  std::cout << IT::make_Delaunay(tri) << " flips\n";
  for(IT::Edge_index e : tri.mesh().edges())
    std::cout << "edge of length " << tri.length(e) << ", normal coordinate "
              << tri.coordinates().normal_coordinate(e) << '\n';
}
