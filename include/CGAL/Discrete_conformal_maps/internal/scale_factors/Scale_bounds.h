// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_SCALE_BOUNDS_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_SCALE_BOUNDS_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Doubled_problem.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

// Compares scale factors at possible cones with a bound.
class Scale_bounds
{
  typedef Eigen::VectorXd Vector;

public:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  explicit Scale_bounds(const Doubled_problem& problem) : m_problem(problem)
  {
    // Prescriptions on the boundary, or other than zero, are kept.
    const Vector target = problem.target_defect();
    for(Vertex_index v : problem.surface().vertices())
      m_may_be_cone.push_back(!problem.is_on_boundary(v) && target[Eigen::Index(v.idx())] == 0);
  }

  // Returns for each vertex whether it can be a cone.
  const std::vector<char>& may_be_cone() const { return m_may_be_cone; }

  // Returns the vertex whose scale factor is farthest from zero, if it is out of bounds and can be
  // a cone.
  std::size_t vertex_beyond(double bound, const Vector& scale) const
  {
    std::size_t worst = none;
    double farthest = bound;
    for(std::size_t v = 0; v < m_problem.size(); ++v)
      if(const double distance = std::abs(scale[Eigen::Index(v)]);
         m_may_be_cone[v] && distance > farthest) {
        farthest = distance;
        worst = v;
      }
    return worst == none || m_problem.is_fixed()[worst] ? none : worst;
  }

  // Returns for each component whether a scale factor is out of bounds.
  std::vector<char> components_beyond(double bound, const Vector& scale) const
  {
    std::vector<char> result(m_problem.components().size(), 0);
    for(std::size_t v = 0; v < m_problem.size(); ++v)
      if(m_may_be_cone[v] && std::abs(scale[Eigen::Index(v)]) > bound)
        result[m_problem.components()[v]] = 1;
    return result;
  }

  // Returns scale factors after a change by a number for each component without prescribed scale
  // factors. Zero is then in the middle between the least and the greatest one. No other numbers
  // make the greatest absolute value smaller.
  Vector centered(Vector scale) const
  {
    typedef std::pair<double, double> Range;
    const double infinity = std::numeric_limits<double>::infinity();
    std::vector<Range> range(m_problem.components().size(), Range(infinity, -infinity));
    for(std::size_t v = 0; v < m_problem.size(); ++v)
      if(m_may_be_cone[v]) {
        const double u = scale[Eigen::Index(v)];
        auto& [least, greatest] = range[m_problem.components()[v]];
        least = (std::min)(least, u);
        greatest = (std::max)(greatest, u);
      }
    const std::vector<std::size_t> fixed = m_problem.number_of_fixed();
    for(std::size_t v = 0; v < m_problem.size(); ++v)
      if(const std::size_t c = m_problem.components()[v]; fixed[c] == 0 && m_may_be_cone[v])
        scale[Eigen::Index(v)] -= (range[c].first + range[c].second) / 2;
    return scale;
  }

  // Returns the possible cone of a component whose scale factor is farthest from the mean, and its
  // distance from the mean.
  std::pair<std::size_t, double> farthest_from_mean(std::size_t c, const Vector& scale) const
  {
    std::size_t least = none, greatest = none;
    double sum = 0, count = 0;
    for(std::size_t v = 0; v < m_problem.size(); ++v)
      if(m_problem.components()[v] == c) {
        const double u = scale[Eigen::Index(v)];
        sum += m_problem.number_of_copies(v) * u;
        count += m_problem.number_of_copies(v);
        if(!m_may_be_cone[v])
          continue;
        if(least == none || u < scale[Eigen::Index(least)])
          least = v;
        if(greatest == none || u > scale[Eigen::Index(greatest)])
          greatest = v;
      }
    if(least == none)
      return {none, 0};
    const double below = sum / count - scale[Eigen::Index(least)],
                 above = scale[Eigen::Index(greatest)] - sum / count;
    return above > below ? std::pair(greatest, above) : std::pair(least, below);
  }

  // Returns the vertex that is beyond a bound at the minimum, too, if the minimum is closer to
  // `scale` than half of the last step.
  std::size_t certainly_beyond(double bound, const Vector& scale, double step) const
  {
    return step < bound / 10 ? vertex_beyond(bound + step / 2, centered(scale)) : none;
  }

private:
  const Doubled_problem& m_problem;
  std::vector<char> m_may_be_cone;
};

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_SCALE_BOUNDS_H
