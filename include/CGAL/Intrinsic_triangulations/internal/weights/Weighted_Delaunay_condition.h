// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_WEIGHTS_WEIGHTED_DELAUNAY_CONDITION_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_WEIGHTS_WEIGHTED_DELAUNAY_CONDITION_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/exact_numbers.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/Exact_decisions.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/Input_corners.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Edge_courses.h>
#include <CGAL/Intrinsic_triangulations/internal/weights/Vertex_weights.h>
#include <CGAL/Intrinsic_triangulations/internal/weights/Weight_elimination.h>
#include <CGAL/Intrinsic_triangulations/internal/weights/Weight_form.h>
#include <CGAL/Intrinsic_triangulations/tolerances.h>
#include <CGAL/Intrinsic_triangulations/weighted_formulas.h>

#include <CGAL/Uncertain.h>
#include <CGAL/enum.h>

#include <algorithm>
#include <cstddef>

namespace CGAL::Intrinsic_triangulations::internal {

// Represents the local weighted Delaunay condition.
template <typename Traits>
class Weighted_Delaunay_condition
{
public:
  Weighted_Delaunay_condition(const Delta_complex& mesh, const Vertex_weights& weights)
    : m_mesh(mesh), m_weights(weights)
  {}

  // Returns whether the edge of `h` is weighted Delaunay for any rounding of lengths. The weights
  // of its corners must be known exactly.
  bool is_certain(Halfedge_index h, const Diamond<double>& length) const
  {
    const auto corners = diamond_corners(h, m_mesh);
    const auto given = [&](std::size_t i) { return m_weights.given(corners[i]); };
    return std::none_of(corners.begin(), corners.end(),
                        [&](Vertex_index v) { return m_weights.is_hidden(v); }) &&
           Is_locally_weighted_Delaunay<double>{certified_length_error()}.is_certain(
             length, {given(0), given(1), given(2), given(3)});
  }

  // Returns the sign of the dual edge of the edge of `h`: ZERO is a tie.
  // \throws Numerical_error if it is not determined
  Sign sign(Halfedge_index h, Exact_decisions<Traits>& decisions) const
  {
    if(m_weights.ties().count(m_mesh.edge(h)) > 0)
      return ZERO;
    if(!m_weights.is_enclosed())
      throw Numerical_error("the weights of hidden vertices are not enclosed");
    decisions.allow_roots(most_roots);
    return decisions.template decide<Exact_field, Exact_corners_to_scale>(
      [&](const auto& development) { return sign_in(development, h); });
  }

private:
  // Fractions with more roots take minutes.
  static constexpr std::size_t most_roots = 4;

  template <typename Development>
  Uncertain<Sign> sign_in(const Development& development, Halfedge_index h) const
  {
    if constexpr(Development::is_rounded)
      return rounded_dual_edge_sign(h, m_mesh, development, m_weights);
    else
      return Weight_elimination<Development>(m_mesh, m_weights, development).sign(h);
  }

  const Delta_complex& m_mesh;
  const Vertex_weights& m_weights;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_WEIGHTS_WEIGHTED_DELAUNAY_CONDITION_H
