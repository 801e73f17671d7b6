// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_BENCHMARK_INTEGER_COORDINATE_METHOD_H
#define INTRINSIC_BENCHMARK_INTEGER_COORDINATE_METHOD_H

#include "method.h"

#include <CGAL/Intrinsic_triangulations/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/Correspondence.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/make_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/refine.h>

#include <cstddef>

namespace Methods {

// Wraps the method of the library.
class Integer_coordinate_method
{
public:
  explicit Integer_coordinate_method(const IT::Intrinsic_triangulation<>& tri) : m_tri(tri) {}

  std::size_t make_Delaunay()
  {
    const std::size_t flips = IT::make_Delaunay(m_tri);
    if(!IT::is_Delaunay(m_tri))
      throw Failure("not Delaunay");
    return flips;
  }

  // Returns the number of insertions.
  std::size_t refine() { return IT::refine(m_tri, IT::parameters::minimum_angle(25.)).insertions; }

  Subdivision_size subdivide() const
  {
    const IT::Correspondence<> correspondence(m_tri);
    const IT::Common_subdivision<> subdivision(correspondence);
    const auto& mesh = subdivision.mesh();
    const Subdivision_size size{mesh.number_of_vertices(), mesh.number_of_edges(),
                                mesh.number_of_faces()};
    check(size, m_tri.input_mesh());
    for(Face_index f : mesh.faces())
      if(const auto degree = mesh.degree(f); degree < 3 || degree > 6)
        throw Failure("a face is no convex polygon");
    return size;
  }

private:
  IT::Intrinsic_triangulation<> m_tri;
};

} // namespace Methods

#endif // INTRINSIC_BENCHMARK_INTEGER_COORDINATE_METHOD_H
