// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_BENCHMARK_METHOD_H
#define INTRINSIC_BENCHMARK_METHOD_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>

#include <cstddef>
#include <cstdint>

// Defines the common parts of methods that keep a correspondence. A method is a class that is
// constructed from a triangulation T2 = T1. Its member function make_Delaunay() returns the number
// of flips. Its member function subdivide() finds the connectivity of the common subdivision and
// returns its size. Either throws IT::Error if it fails. A method that can refine has a member
// function refine(), to angles of 25 degrees, which returns the number of insertions.
namespace Methods {

namespace IT = CGAL::Intrinsic_triangulations;
using IT::Delta_complex;
using IT::Edge_index;
using IT::Face_index;
using IT::Halfedge_index;
using IT::Vertex_index;

// Reports that the result of a method is not a triangulation or not a subdivision of the surface.
class Failure : public IT::Error
{
public:
  using IT::Error::Error;
};

struct Subdivision_size
{
  std::size_t vertices, edges, faces;

  friend bool operator==(const Subdivision_size& a, const Subdivision_size& b)
  {
    return a.vertices == b.vertices && a.edges == b.edges && a.faces == b.faces;
  }
};

// Checks that the Euler characteristic is the characteristic of the surface.
inline void check(const Subdivision_size& size, const Delta_complex& surface)
{
  const auto alternating_sum = [](std::size_t v, std::size_t e, std::size_t f) {
    return static_cast<std::int64_t>(v + f) - static_cast<std::int64_t>(e);
  };
  if(alternating_sum(size.vertices, size.edges, size.faces) !=
     alternating_sum(surface.number_of_vertices(), surface.number_of_edges(),
                     surface.number_of_faces()))
    throw Failure("the Euler characteristic is wrong");
}

} // namespace Methods

#endif // INTRINSIC_BENCHMARK_METHOD_H
