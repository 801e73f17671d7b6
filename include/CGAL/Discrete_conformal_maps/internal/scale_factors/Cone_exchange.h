// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_CONE_EXCHANGE_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_CONE_EXCHANGE_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Cone_placement.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Doubled_problem.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Scale_bounds.h>
#include <CGAL/Discrete_conformal_maps/internal/tolerances.h>

#include <Eigen/Core>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

// Removes and moves the cones of one component while an estimate of its scale factors stays within
// a bound. The estimate is u = a + sum of kappa_c g_c + t over all cones c. Here a are the scale
// factors without cones, g_c columns of the inverse Laplacian, and kappa_c curvatures of cones.
// With the constant t, u is zero at all cones. If scale factors are prescribed in the component, no
// constant exists. Otherwise the sum of curvatures is known.
class Cone_exchange
{
  typedef Eigen::VectorXd Vector;
  typedef Eigen::Index Index;

public:
  struct Component
  {
    std::vector<Index> candidates;         // for cones, in ascending order
    Vector without_cones;                  // scale factors
    std::function<Vector(Index)> column;   // of the inverse Laplacian
    std::optional<double> total_curvature; // unless scale factors are prescribed
    std::size_t least_number_of_cones;
  };

  Cone_exchange(Component component, const std::vector<Index>& cones)
    : m_component(std::move(component))
  {
    for(Index c : cones)
      m_cones.push_back({c, m_component.column(c)});
  }

  // Returns the cones. Each round removes one cone, replaces two by one, or moves one such that the
  // greatest scale factor is less.
  std::vector<Index> cones_within(double bound)
  {
    solve();
    for(std::size_t round = 0; round < tolerance::exchanges_of_cones && exchange(bound); ++round)
      solve();
    std::vector<Index> result;
    for(const Cone& c : m_cones)
      result.push_back(c.at);
    return result;
  }

private:
  struct Cone
  {
    Index at;
    Vector column;
  };

  struct Extent
  {
    double greatest;
    Index at;
  };

  Index size() const { return static_cast<Index>(m_cones.size()); }

  // Returns whether the number of cones, or the greatest scale factor, has decreased.
  bool exchange(double bound)
  {
    if(!m_inverse.allFinite())
      return false;
    if((is_one_too_many() && drop_one_before(size(), bound)) || replace(true, bound))
      return true;
    const double less = tolerance::gain_of_move * extent(m_solution).greatest;
    return move(less) || replace(false, less);
  }

  // Solves for the curvatures of cones and the constant.
  void solve()
  {
    const bool floats = m_component.total_curvature.has_value();
    const Index k = size(), n = k + (floats ? 1 : 0);
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n, n);
    Vector right_side = Vector::Zero(n);
    for(Index i = 0; i < k; ++i) {
      const Index at = m_cones[std::size_t(i)].at;
      for(Index j = 0; j < k; ++j)
        matrix(i, j) = m_cones[std::size_t(j)].column[at];
      right_side[i] = -m_component.without_cones[at];
    }
    if(floats) {
      matrix.row(k).head(k).setOnes();
      matrix.col(k).head(k).setOnes();
      right_side[k] = *m_component.total_curvature;
    }
    m_inverse = matrix;
    if(n > 0)
      m_inverse = matrix.partialPivLu().inverse();
    m_solution = m_inverse * right_side;
  }

  // Returns the solution without cone i, whose curvature becomes zero.
  Vector solution_without(Index i) const
  {
    return m_solution - (m_solution[i] / m_inverse(i, i)) * m_inverse.col(i);
  }

  // Returns the scale factor at cone i after the cone has been removed.
  double scale_without(Index i) const { return std::abs(m_solution[i] / m_inverse(i, i)); }

  // Returns the greatest scale factor of a solution, and its vertex.
  Extent extent(const Vector& solution) const
  {
    const Index k = size();
    Vector u = m_component.without_cones;
    for(Index i = 0; i < k; ++i)
      u += solution[i] * m_cones[std::size_t(i)].column;
    if(solution.size() > k)
      u.array() += solution[k];
    Extent result{0, m_component.candidates.front()};
    for(Index v : m_component.candidates)
      if(!(std::abs(u[v]) <= result.greatest))
        result = {std::abs(u[v]), v};
    return result;
  }

  // Returns the cones in the order of the scale factors that their vertices have after a removal.
  std::vector<Index> least_needed() const
  {
    std::vector<Index> result(m_cones.size());
    std::iota(result.begin(), result.end(), Index(0));
    std::stable_sort(result.begin(), result.end(),
                     [this](Index i, Index j) { return scale_without(i) < scale_without(j); });
    return result;
  }

  // Removes a cone, and adds a cone at the greatest scale factor of the result, if scale factors
  // are then within the limit. With `is_pair`, the cone with the greatest correlation is removed,
  // too.
  bool replace(bool is_pair, double limit)
  {
    if(is_pair && !is_one_too_many())
      return false;
    const std::vector<Index> order = least_needed();
    for(std::size_t n = 0; n < (std::min)(order.size(), tolerance::replaced_cones); ++n) {
      const std::vector<Cone> cones = m_cones;
      const Index i = order[n], j = is_pair ? most_dependent(i) : i;
      m_cones.erase(m_cones.begin() + (std::max)(i, j));
      if(is_pair)
        m_cones.erase(m_cones.begin() + (std::min)(i, j));
      solve();
      if(add_worst() <= limit)
        return true;
      m_cones = cones;
      solve();
    }
    return false;
  }

  // Returns whether the curvature of the component permits fewer cones.
  bool is_one_too_many() const
  {
    return m_cones.size() > (std::max)(m_component.least_number_of_cones, std::size_t(1));
  }

  // Returns the other cone with the greatest correlation in the inverse.
  Index most_dependent(Index i) const
  {
    const auto correlation = [&](Index j) {
      return m_inverse(i, j) * m_inverse(i, j) / std::abs(m_inverse(j, j));
    };
    Index result = i == 0 ? 1 : 0;
    for(Index j = 0; j < size(); ++j)
      if(j != i && correlation(j) > correlation(result))
        result = j;
    return result;
  }

  // Adds a cone at the greatest scale factor. Returns the greatest scale factor afterwards.
  double add_worst()
  {
    const Index v = extent(m_solution).at;
    m_cones.push_back({v, m_component.column(v)});
    solve();
    return extent(m_solution).greatest;
  }

  // Adds a cone at the greatest scale factor, and removes the cone whose removal leaves the least
  // scale factors. If the greatest scale factor exceeds the limit, restores the previous cones and
  // returns false.
  bool move(double limit)
  {
    const Index added = size();
    add_worst();
    const bool is_dropped = drop_one_before(added, limit);
    if(!is_dropped)
      m_cones.pop_back();
    solve();
    return is_dropped;
  }

  // Removes one of the first `end` cones, if scale factors are then within the limit. Chooses the
  // cone whose removal leaves the least scale factors.
  bool drop_one_before(Index end, double limit)
  {
    double least = limit;
    std::optional<Index> best;
    for(Index i : least_needed())
      if(i < end && scale_without(i) <= least)
        if(const double greatest = extent(solution_without(i)).greatest; greatest <= least) {
          least = greatest;
          best = i;
        }
    if(best)
      m_cones.erase(m_cones.begin() + *best);
    return best.has_value();
  }

  Component m_component;
  std::vector<Cone> m_cones;
  Eigen::MatrixXd m_inverse;
  Vector m_solution; // curvatures of cones, and the constant
};

// Returns a component without cones. `defect` is the argument of `Cone_placement::estimate()`.
inline Cone_exchange::Component exchangeable(std::size_t c, const Doubled_problem& problem,
                                             const Scale_bounds& bounds, Cone_placement& placement,
                                             const Eigen::VectorXd& defect)
{
  Cone_exchange::Component result;
  Eigen::VectorXd own = Eigen::VectorXd::Zero(defect.size());
  for(std::size_t v = 0; v < problem.size(); ++v)
    if(problem.components()[v] == c) {
      own[Eigen::Index(v)] = defect[Eigen::Index(v)];
      if(bounds.may_be_cone()[v])
        result.candidates.push_back(Eigen::Index(v));
    }
  result.without_cones = placement.solve_with_fixed(-own);
  result.column = [&placement, size = defect.size()](Eigen::Index v) {
    return placement.solve_with_fixed(Eigen::VectorXd::Unit(size, v));
  };
  const std::size_t fixed = problem.number_of_fixed()[c],
                    needed = Doubled_problem::needed_cones(problem.curvature_excess()[c]);
  if(fixed == 0)
    result.total_curvature = own.sum();
  result.least_number_of_cones = needed - (std::min)(needed, fixed);
  return result;
}

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_CONE_EXCHANGE_H
