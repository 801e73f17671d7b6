// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_CONE_PLACEMENT_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_CONE_PLACEMENT_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/internal/minimization/Dirichlet_solver.h>
#include <CGAL/Intrinsic_triangulations/Mesh_components.h>

#include <Eigen/SparseCore>

#include <cmath>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

// Places greedy cones. One linear system estimates the scale factors that make the surface flat. A
// cone is placed at the vertex with the greatest estimate, which is zero at this vertex from then
// on. A new cone needs no new factorization. It needs one column of the inverse, from which the
// shares of earlier cones are subtracted. `Laplacian` is the Hessian of the energy at some scale
// factors, and the estimate is good near them.
//
// Constants on a component without fixed vertices are in the kernel of the Laplacian. One vertex is
// held on it, and every right-hand side that sums to zero has a solution. The first cone of the
// component absorbs the remaining curvature.
class Cone_placement
{
  typedef Eigen::VectorXd Vector;
  typedef Intrinsic_triangulations::Mesh_components Components;

public:
  // `is_held` contains the fixed vertices, and one of every component without fixed vertices.
  Cone_placement(const Eigen::SparseMatrix<double>& Laplacian, const std::vector<char>& is_held,
                 const Components& components, const std::shared_ptr<Shared_order>& order)
    : m_solver(Laplacian, is_held, order), m_components(components), m_first(components.size(), -1)
  {}

  // Estimates scale factors; the sum of `defect` is zero on components without fixed vertices.
  void estimate(const Vector& defect) { m_estimate = solve(-defect); }

  // Makes `v` the first cone of its component, which has no fixed vertices.
  void add_first(std::size_t v) { m_first[m_components[v]] = index(v); }

  const Vector& estimate() const { return m_estimate; }

  // Replaces all cones. The first one in each component with a first cone takes its role. `defect`
  // is the argument of `estimate()`.
  void restart(const std::vector<std::size_t>& cones, const Vector& defect)
  {
    std::vector<char> needs_first;
    for(Eigen::Index& first : m_first)
      needs_first.push_back(std::exchange(first, -1) >= 0);
    m_columns.clear();
    for(std::size_t v : cones)
      if(std::exchange(needs_first[m_components[v]], 0))
        add_first(v);
    estimate(defect);
    for(std::size_t v : cones)
      if(m_first[m_components[v]] != index(v))
        add(v);
  }

  // Returns solutions that are zero at fixed vertices.
  Vector solve_with_fixed(const Vector& right_side) { return m_solver.solve(right_side); }

  // Uses `u` as the estimate, which is zero at all cones.
  void set_estimate(const Vector& u) { m_estimate = u; }

  // Moves the estimate along constants, to zero at the first cone of its component.
  void move_to_first(std::size_t v)
  {
    add_first(v);
    const double at_first = m_estimate[index(v)];
    for(std::size_t w = 0; w < std::size_t(m_estimate.size()); ++w)
      if(m_components[w] == m_components[v])
        m_estimate[index(w)] -= at_first;
  }

  // Returns the vertex of component `c` with the greatest estimate, among the candidates.
  std::size_t worst(std::size_t c, const std::vector<char>& is_candidate) const
  {
    std::size_t result = 0;
    double greatest = -1;
    for(std::size_t v = 0; v < std::size_t(m_estimate.size()); ++v)
      if(m_components[v] == c && is_candidate[v] && std::abs(m_estimate[index(v)]) > greatest) {
        greatest = std::abs(m_estimate[index(v)]);
        result = v;
      }
    return result;
  }

  // Makes `v` a cone, where the estimate becomes zero.
  void add(std::size_t v)
  {
    Vector source = Vector::Zero(m_estimate.size());
    source[index(v)] = 1;
    const Vector column = zero_at_cones(solve(source));
    m_columns.push_back({index(v), column});
    m_estimate -= (m_estimate[index(v)] / column[index(v)]) * column;
    for(const Column& c : m_columns)
      m_estimate[c.at] = 0;
  }

  // Returns the change of scale factors that reduces a gradient to zero, to first order.
  Vector step(const Vector& gradient) { return zero_at_cones(solve(-gradient)); }

private:
  struct Column
  {
    Eigen::Index at;
    Vector values;
  };

  static Eigen::Index index(std::size_t i) { return static_cast<Eigen::Index>(i); }

  // Subtracts columns, so that values are zero at cones. Each column is zero at the earlier cones.
  Vector zero_at_cones(Vector values) const
  {
    for(const Column& c : m_columns) {
      values -= (values[c.at] / c.values[c.at]) * c.values;
      values[c.at] = 0;
    }
    return values;
  }

  // Returns a solution that is zero at fixed vertices and first cones.
  Vector solve(Vector right_side)
  {
    Vector sum = Vector::Zero(index(m_first.size())), at_first = sum;
    for(std::size_t v = 0; v < std::size_t(right_side.size()); ++v)
      sum[index(m_components[v])] += right_side[index(v)];
    for(std::size_t c = 0; c < m_first.size(); ++c)
      if(m_first[c] >= 0)
        right_side[m_first[c]] -= sum[index(c)];
    Vector result = m_solver.solve(right_side);
    for(std::size_t c = 0; c < m_first.size(); ++c)
      if(m_first[c] >= 0)
        at_first[index(c)] = result[m_first[c]];
    for(std::size_t v = 0; v < std::size_t(right_side.size()); ++v)
      result[index(v)] -= at_first[index(m_components[v])];
    return result;
  }

  Dirichlet_solver m_solver;
  const Components& m_components;
  std::vector<Eigen::Index> m_first; // the first cone of each component, -1 if there is none
  std::vector<Column> m_columns;
  Vector m_estimate;
};

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_CONE_PLACEMENT_H
