// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MINIMIZATION_ANY_VISITOR_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MINIMIZATION_ANY_VISITOR_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Flattening_visitor.h>

#include <cstddef>
#include <functional>

namespace CGAL::Discrete_conformal_maps::internal {

// Refers to a visitor whose type is known only at run time, so that algorithms are compiled once
// for all visitors. It is a model of `FlatteningVisitor`.
class Any_visitor
{
public:
  // Returns a reference to a model of `FlatteningVisitor`.
  template <typename Visitor>
  static Any_visitor of(Visitor& visitor)
  {
    Any_visitor result;
    result.m_start = [&visitor](Flattening_stage stage) { visitor.start(stage); };
    result.m_after_iteration = [&visitor](std::size_t iteration, double norm, double length) {
      visitor.after_iteration(iteration, norm, length);
    };
    return result;
  }

  void start(Flattening_stage stage) { m_start(stage); }
  void after_iteration(std::size_t iteration, double gradient_norm, double step_length)
  {
    m_after_iteration(iteration, gradient_norm, step_length);
  }

private:
  Any_visitor() = default;

  std::function<void(Flattening_stage)> m_start;
  std::function<void(std::size_t, double, double)> m_after_iteration;
};

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MINIMIZATION_ANY_VISITOR_H
