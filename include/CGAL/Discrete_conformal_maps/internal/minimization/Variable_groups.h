// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MINIMIZATION_VARIABLE_GROUPS_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MINIMIZATION_VARIABLE_GROUPS_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/internal/tolerances.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

// Finds groups of variables whose weights in a Laplacian are much greater within the group than to
// other variables. Vertices of a surface that are close to each other form such groups. Groups
// result from single-linkage clustering.
class Variable_groups
{
public:
  typedef std::vector<std::size_t> Group;

  // Groups with a fixed variable do not count. A single free variable is a group.
  Variable_groups(const Eigen::SparseMatrix<double>& Laplacian, const std::vector<char>& is_fixed)
    : m_parent(std::size_t(Laplacian.cols())), m_weight(m_parent.size(), 0)
  {
    std::iota(m_parent.begin(), m_parent.end(), std::size_t(0));
    for(std::size_t v = 0; v < m_parent.size(); ++v) {
      m_members.push_back({v});
      m_is_free.push_back(!is_fixed[v]);
    }
    for(const Tie& t : ties(Laplacian))
      join(t);
    for(std::size_t v = 0; v < m_parent.size(); ++v)
      if(m_is_free[v] && m_members[v].size() == 1 && m_parent[v] == v)
        m_groups.push_back(m_members[v]);
    std::reverse(m_groups.begin(), m_groups.end());
  }

  // Returns the groups. A group comes before the groups that it contains.
  const std::vector<Group>& groups() const { return m_groups; }

private:
  struct Tie
  {
    double weight;
    std::size_t v, w;
  };

  // Returns the ties in the order of decreasing weights.
  static std::vector<Tie> ties(const Eigen::SparseMatrix<double>& Laplacian)
  {
    std::vector<Tie> result;
    for(Eigen::Index column = 0; column < Laplacian.cols(); ++column)
      for(Eigen::SparseMatrix<double>::InnerIterator i(Laplacian, column); i; ++i)
        if(i.row() < column && i.value() < 0)
          result.push_back({-i.value(), std::size_t(i.row()), std::size_t(column)});
    std::stable_sort(result.begin(), result.end(),
                     [](const Tie& a, const Tie& b) { return a.weight > b.weight; });
    return result;
  }

  std::size_t root(std::size_t v)
  {
    while(m_parent[v] != v)
      v = m_parent[v] = m_parent[m_parent[v]];
    return v;
  }

  void join(const Tie& tie)
  {
    std::size_t a = root(tie.v), b = root(tie.w);
    if(a == b)
      return;
    for(std::size_t part : {a, b})
      if(m_is_free[part] &&
         (m_members[part].size() == 1 || m_weight[part] > tolerance::group_ratio * tie.weight))
        m_groups.push_back(m_members[part]);
    if(m_members[a].size() < m_members[b].size())
      std::swap(a, b);
    m_parent[b] = a;
    m_is_free[a] &= m_is_free[b];
    m_weight[a] = tie.weight;
    m_members[a].insert(m_members[a].end(), m_members[b].begin(), m_members[b].end());
    Group().swap(m_members[b]);
  }

  std::vector<std::size_t> m_parent;
  std::vector<double> m_weight; // of the weakest tie in each tree, at its root
  std::vector<Group> m_members; // of each tree, at its root
  std::vector<char> m_is_free;
  std::vector<Group> m_groups;
};

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MINIMIZATION_VARIABLE_GROUPS_H
