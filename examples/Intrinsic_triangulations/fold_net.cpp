// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Folds a triangle to a tetrahedron: glues both halves of each side to each other, and computes the
// convex polyhedron with this surface.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Intrinsic_triangulations/convex_polyhedron.h>
#include <CGAL/Intrinsic_triangulations/edge_lengths.h>
#include <CGAL/Intrinsic_triangulations/glue_boundary.h>
#include <CGAL/Surface_mesh.h>

#include <iostream>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;
typedef CGAL::Exact_predicates_inexact_constructions_kernel::Point_3 Point;
typedef CGAL::Surface_mesh<Point> Mesh;

// Makes the net from the corners 0, 2, 4 of a triangle and the midpoints of its sides.
Mesh make_net()
{
  Mesh net;
  std::vector<IT::Vertex_index> v;
  for(const Point& p : {Point(0, 0, 0), Point(1, 0, 0), Point(2, 0, 0), Point(1.8, 1, 0),
                        Point(1.6, 2, 0), Point(0.8, 1, 0)})
    v.push_back(net.add_vertex(p));
  net.add_face(v[0], v[1], v[5]);
  net.add_face(v[1], v[2], v[3]);
  net.add_face(v[1], v[3], v[5]);
  net.add_face(v[5], v[3], v[4]);
  return net;
}

int main()
{
  Mesh net = make_net();
  const auto length = net.add_property_map<IT::Edge_index, double>("e:length").first;
  IT::compute_edge_lengths(net, length);
  IT::Paired_sides sides(net, length);
  for(unsigned corner : {0, 2, 4}) {
    const IT::Vertex_index from(corner), midpoint(corner + 1), to((corner + 2) % 6);
    sides.add(from, midpoint, to, midpoint);
  }
  IT::Glued_surface glued = IT::glue_boundary(net, length, sides.complete_pairs());

  const IT::Convex_polyhedron polyhedron = IT::convex_polyhedron(
    glued.mesh, IT::parameters::edge_length_map(IT::stored_length_map<double>(glued.mesh)));
  std::cout << (polyhedron.certificate().is_convex() ? "convex, " : "not convex, ")
            << polyhedron.mesh().number_of_faces() << " faces, edges equal to "
            << polyhedron.max_edge_error() << '\n';
  for(const IT::Vertex_index v : glued.mesh.vertices())
    std::cout << "vertex " << v.idx() << " at " << polyhedron.point(v) << '\n';
}
