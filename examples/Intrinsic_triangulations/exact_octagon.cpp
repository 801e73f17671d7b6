// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Flips a regular octagon with opposite sides glued: a translation surface of genus 2, whose
// squared lengths are in Q(sqrt 2). Its corners lie on one circle, so that all five diagonals are
// ties.

#include <CGAL/Exact_rational.h>
#include <CGAL/Intrinsic_triangulations/Exact_Euclidean_geometry_traits.h>
#include <CGAL/Intrinsic_triangulations/certify_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/make_Delaunay.h>
#include <CGAL/Sqrt_extension.h>

#include <array>
#include <iostream>

namespace IT = CGAL::Intrinsic_triangulations;

typedef CGAL::Sqrt_extension<CGAL::Exact_rational, CGAL::Exact_rational> Number;

// Makes the halfedges, all from vertex 0 to itself, the sides of the next face.
void add_triangle(const std::array<unsigned, 3>& sides, IT::Delta_complex& mesh)
{
  const IT::Face_index f = mesh.add_face();
  for(std::size_t s = 0; s < 3; ++s) {
    const IT::Halfedge_index h(sides[s]);
    mesh.set_next(h, IT::Halfedge_index(sides[(s + 1) % 3]));
    mesh.set_target(h, IT::Vertex_index(0));
    mesh.set_face(h, f);
    mesh.set_halfedge(f, h);
  }
}

// Edges 0 to 3 are the sides, each glued to the opposite one; edges 4 to 8 are the diagonals of a
// fan.
IT::Delta_complex make_octagon()
{
  IT::Delta_complex mesh;
  mesh.resize(1, 9, 0);
  for(const auto& sides : {std::array<unsigned, 3>{0, 2, 9},
                           {8, 4, 11},
                           {10, 6, 13},
                           {12, 1, 15},
                           {14, 3, 17},
                           {16, 5, 7}})
    add_triangle(sides, mesh);
  mesh.set_halfedge(IT::Vertex_index(0), IT::Halfedge_index(0));
  return mesh;
}

int main()
{
  IT::Delta_complex mesh = make_octagon();
  auto square = mesh.add_property_map<IT::Edge_index, Number>("e:square", Number(1)).first;
  const std::array<Number, 3> diagonal{Number(2, 1, 2), Number(3, 2, 2), Number(4, 2, 2)};
  for(unsigned d = 0; d < 5; ++d) // over two, three, four, three, two sides
    square[IT::Edge_index(4 + d)] = diagonal[d < 3 ? d : 4 - d];

  IT::Intrinsic_triangulation<IT::Exact_Euclidean_geometry_traits<Number>> tri(
    mesh, IT::parameters::squared_edge_length_map(square));
  std::cout << IT::make_Delaunay(tri) << " flips, " << IT::certify_Delaunay(tri).ties.size()
            << " ties\n";
}
