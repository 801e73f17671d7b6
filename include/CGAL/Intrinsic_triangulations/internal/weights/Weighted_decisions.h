// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_WEIGHTS_WEIGHTED_DECISIONS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_WEIGHTS_WEIGHTED_DECISIONS_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/exact_numbers.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/Ball.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/Exact_decisions.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/Input_corners.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Edge_courses.h>
#include <CGAL/Intrinsic_triangulations/internal/weights/Weight_elimination.h>
#include <CGAL/Intrinsic_triangulations/internal/weights/Weight_form.h>

#include <CGAL/Uncertain.h>
#include <CGAL/enum.h>

#include <utility>

namespace CGAL::Intrinsic_triangulations::internal {

// Decides predicates of T2 with weights of its vertices. `weights.ball<N>(v)` contains the weight
// of a vertex.
template <typename Traits, typename Weights>
class Weighted_decisions : public Exact_decisions<Traits>
{
  typedef Exact_decisions<Traits> Base;
  using Base::m_mesh;

public:
  Weighted_decisions(const Triangulation_pair<Traits>& pair, const Edge_courses<Traits>& courses,
                     const Weights& weights)
    : Base(pair, courses), m_weights(weights)
  {
    Base::allow_roots(most_roots);
  }

  // Returns whether the edge of `h` is weighted Delaunay. If 1024 binary digits do not distinguish
  // it from a tie, it counts as a tie.
  bool is_weighted_Delaunay(Halfedge_index h) const
  {
    Uncertain<Sign> result = Uncertain<Sign>::indeterminate();
    Base::try_with_more_digits([&](auto& corners) {
      result = rounded_sign(h, Base::development(corners));
      return is_certain(result);
    });
    return !certainly(result == NEGATIVE);
  }

  // Returns the sign of the dual edge of the edge of `h`: ZERO is a tie.
  // \throws Numerical_error if it is not determined
  Sign dual_edge_sign(Halfedge_index h)
  {
    if(m_weights.ties().count(m_mesh.edge(h)) > 0)
      return ZERO;
    if(!m_weights.is_enclosed())
      throw Numerical_error("the weights of hidden vertices are not enclosed");
    return Base::template decide<Exact_field, Exact_corners_to_scale>(
      [&](const auto& development) { return sign(h, development); });
  }

private:
  // Fractions with more roots take minutes.
  static constexpr std::size_t most_roots = 4;

  template <typename Development>
  Uncertain<Sign> sign(Halfedge_index h, const Development& development) const
  {
    if constexpr(Development::is_rounded)
      return rounded_sign(h, development);
    else
      return Weight_elimination<Development>(m_mesh, m_weights, development).sign(h);
  }

  template <typename Development>
  Uncertain<Sign> rounded_sign(Halfedge_index h, const Development& development) const
  {
    typedef decltype(Development::Complex::x) N;
    return sign_of_real(dual_edge_form(h, m_mesh, development).value([&](Vertex_index v) {
      return m_weights.template ball<N>(v);
    }));
  }

  const Weights& m_weights;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_WEIGHTS_WEIGHTED_DECISIONS_H
