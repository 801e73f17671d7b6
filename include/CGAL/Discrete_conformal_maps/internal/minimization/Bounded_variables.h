// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MINIMIZATION_BOUNDED_VARIABLES_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MINIMIZATION_BOUNDED_VARIABLES_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/internal/minimization/Free_variables.h>
#include <CGAL/Discrete_conformal_maps/internal/tolerances.h>

#include <CGAL/assertions.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace CGAL::Discrete_conformal_maps::internal {

// Variables with lower bounds, and fixed ones. No direction is free of change.
class Bounded_variables
{
public:
  typedef Free_variables::Indices Indices;
  typedef Eigen::VectorXd Vector;

  Bounded_variables(const Minimization_domain& domain, const Vector& lower_bound)
    : m_fixed(domain, static_cast<std::size_t>(lower_bound.size())), m_lower_bound(lower_bound)
  {
    CGAL_precondition(m_fixed.floating_components().empty());
  }

  const Indices& indices() const { return m_fixed.indices(); }
  const Vector& lower_bound() const { return m_lower_bound; }

  void set_fixed_to_zero(Vector& v) const { m_fixed.set_fixed_to_zero(v); }
  double remove_means(Vector&) const { return 0; }

  // Variables some roundings from their bounds, or below them, are put there: functions may not
  // distinguish them.
  Vector feasible(const Vector& point) const
  {
    Vector result = point;
    for(const Eigen::Index i : indices()) {
      const double l = m_lower_bound[i];
      const double margin = tolerance::variable * std::abs(l);
      if(std::isfinite(l) && result[i] <= l + margin)
        result[i] = l;
    }
    return result;
  }

  // Where a variable is at its bound, only a negative derivative is too much.
  double norm(const Vector& gradient, const Vector& point) const
  {
    double result = 0;
    for(const Eigen::Index i : indices()) {
      const double g = gradient[i];
      if(!(point[i] == m_lower_bound[i] && g > 0))
        result = std::abs(g) <= result ? result : std::abs(g); // keeps NaN
    }
    return result;
  }

private:
  Free_variables m_fixed;
  Vector m_lower_bound;
};

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MINIMIZATION_BOUNDED_VARIABLES_H
