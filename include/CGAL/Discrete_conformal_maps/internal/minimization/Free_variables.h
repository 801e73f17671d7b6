// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MINIMIZATION_FREE_VARIABLES_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MINIMIZATION_FREE_VARIABLES_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Minimization.h>

#include <CGAL/assertions.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

inline double max_norm(const Eigen::VectorXd& v)
{
  return v.size() == 0 ? 0 : v.lpNorm<Eigen::Infinity>();
}

// Returns the greatest difference of two variables in a direction for which a Hessian has an entry.
template <typename Direction>
double greatest_difference(const Eigen::SparseMatrix<double>& hessian, const Direction& direction)
{
  typedef std::decay_t<decltype(direction[0])> FT;
  const FT* d = direction.data();
  double result = 0;
  for(Eigen::Index column = 0; column < hessian.outerSize(); ++column)
    for(Eigen::SparseMatrix<double>::InnerIterator i(hessian, column); i; ++i)
      result = (std::max)(result, std::abs(static_cast<double>(FT(d[i.row()] - d[column]))));
  return result;
}

// Stores the free variables, and the floating components, which have no fixed variable.
class Free_variables
{
public:
  typedef std::vector<Eigen::Index> Indices;

  Free_variables(const Minimization_domain& domain, std::size_t size)
    : m_has_zero_row_sums(!domain.component.empty()),
      m_is_fixed(domain.is_fixed.empty() ? std::vector<char>(size, 0) : domain.is_fixed)
  {
    CGAL_precondition(m_is_fixed.size() == size);
    CGAL_precondition(domain.component.empty() || domain.component.size() == size);
    for(std::size_t i = 0; i < size; ++i)
      if(!m_is_fixed[i])
        m_indices.push_back(static_cast<Eigen::Index>(i));
    collect_floating(domain.component);
  }

  const Indices& indices() const { return m_indices; }
  // Returns whether the rows of every Hessian sum to zero, because constants on a component change
  // nothing.
  bool has_zero_row_sums() const { return m_has_zero_row_sums; }
  const std::vector<Indices>& floating_components() const { return m_floating; }

  // Returns the point unchanged, because every point is allowed.
  const Eigen::VectorXd& feasible(const Eigen::VectorXd& point) const { return point; }

  // Returns the distance of a gradient from the gradient of a minimum.
  double norm(const Eigen::VectorXd& gradient, const Eigen::VectorXd& /* point */) const
  {
    return max_norm(gradient);
  }

  void set_fixed_to_zero(Eigen::VectorXd& v) const
  {
    for(std::size_t i = 0; i < m_is_fixed.size(); ++i)
      if(m_is_fixed[i])
        v[static_cast<Eigen::Index>(i)] = 0;
  }

  // Removes the means on components, and returns the greatest mean.
  double remove_means(Eigen::VectorXd& v) const
  {
    double greatest = 0;
    for(const Indices& component : m_floating) {
      const double mean = sum(component, v) / static_cast<double>(component.size());
      for(Eigen::Index i : component)
        v[i] -= mean;
      greatest = (std::max)(greatest, std::abs(mean));
    }
    return greatest;
  }

private:
  void collect_floating(const std::vector<std::size_t>& component)
  {
    std::vector<Indices> members;
    std::vector<char> has_fixed;
    for(std::size_t i = 0; i < component.size(); ++i) {
      if(component[i] >= members.size()) {
        members.resize(component[i] + 1);
        has_fixed.resize(component[i] + 1, 0);
      }
      members[component[i]].push_back(static_cast<Eigen::Index>(i));
      if(m_is_fixed[i])
        has_fixed[component[i]] = 1;
    }
    for(std::size_t c = 0; c < members.size(); ++c)
      if(!has_fixed[c] && !members[c].empty())
        m_floating.push_back(std::move(members[c]));
  }

  static double sum(const Indices& component, const Eigen::VectorXd& v)
  {
    double result = 0;
    for(Eigen::Index i : component)
      result += v[i];
    return result;
  }

  bool m_has_zero_row_sums;
  std::vector<char> m_is_fixed;
  Indices m_indices;
  std::vector<Indices> m_floating;
};

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MINIMIZATION_FREE_VARIABLES_H
