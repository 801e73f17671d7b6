// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MINIMIZATION_GROUPED_ENERGY_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MINIMIZATION_GROUPED_ENERGY_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/internal/minimization/Shared_order.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

// Represents an energy as a function of the distances by which groups of its variables move. Its
// Hessian must be a Laplacian. Differences within groups remain, so that a minimum is found without
// steps that they limit. It is the start of a search with all variables.
template <typename Energy>
class Grouped_energy
{
public:
  typedef typename Energy::FT FT;
  typedef Eigen::VectorXd Vector;
  typedef Eigen::SparseMatrix<double> Matrix;

  // `group` contains the number of the group of each variable, less than `number_of_groups`.
  Grouped_energy(Energy& energy, const std::vector<std::size_t>& group,
                 std::size_t number_of_groups)
    : m_energy(energy),
      m_group(group),
      m_members(number_of_groups),
      m_start(energy.scale_factors()),
      m_move(number_of_groups, FT(0))
  {
    for(std::size_t v = 0; v < group.size(); ++v)
      m_members[group[v]].push_back(v);
  }

  std::size_t size() const { return m_members.size(); }
  std::shared_ptr<Shared_order> shared_order() const { return m_order; }
  bool has_worked_enough() const { return m_energy.has_worked_enough(); }

  // Returns the distances by which groups have moved.
  const std::vector<FT>& scale_factors() const { return m_move; }
  const FT& scale_factor(std::size_t g) const { return m_move[g]; }

  void set_origin(const std::vector<FT>& move)
  {
    m_move = move;
    std::vector<FT> u = m_start;
    for(std::size_t v = 0; v < u.size(); ++v)
      u[v] += m_move[m_group[v]];
    m_energy.set_origin(u);
  }

  // Evaluates the energy at the origin. \pre `x` is zero
  void evaluate(const Vector& x)
  {
    m_energy.evaluate(Vector::Zero(Eigen::Index(m_energy.size())));
    m_has_Hessian = false;
    m_gradient = Vector::Zero(x.size());
    for(std::size_t v = 0; v < m_group.size(); ++v)
      m_gradient[Eigen::Index(m_group[v])] += m_energy.gradient()[Eigen::Index(v)];
  }

  const Vector& gradient() const { return m_gradient; }
  double gradient_error() const { return m_energy.gradient_error(); }

  double derivative_at(const std::vector<std::size_t>& groups, const std::vector<FT>& move)
  {
    std::vector<std::size_t> variables;
    std::vector<FT> u;
    for(std::size_t i = 0; i < groups.size(); ++i)
      for(std::size_t v : m_members[groups[i]]) {
        variables.push_back(v);
        u.push_back(m_start[v] + move[i]);
      }
    return m_energy.derivative_at(variables, u);
  }

  // Returns the Hessian. Its rows sum to zero, up to the rounding of weights between groups.
  const Matrix& Hessian() const
  {
    if(!m_has_Hessian)
      assemble_Hessian();
    m_has_Hessian = true;
    return m_Hessian;
  }

private:
  void assemble_Hessian() const
  {
    std::vector<Eigen::Triplet<double>> entries;
    const Matrix& all = m_energy.Hessian();
    for(Eigen::Index column = 0; column < all.cols(); ++column)
      for(Matrix::InnerIterator i(all, column); i; ++i)
        if(const int g = group(i.row()), h = group(column); g != h) {
          entries.emplace_back(g, h, i.value());
          entries.emplace_back(h, h, -i.value());
        }
    m_Hessian.resize(Eigen::Index(size()), Eigen::Index(size()));
    m_Hessian.setFromTriplets(entries.begin(), entries.end());
  }

  int group(Eigen::Index v) const { return static_cast<int>(m_group[std::size_t(v)]); }

  Energy& m_energy;
  const std::vector<std::size_t>& m_group;
  std::vector<std::vector<std::size_t>> m_members;
  std::vector<FT> m_start, m_move;
  Vector m_gradient;
  mutable Matrix m_Hessian;
  mutable bool m_has_Hessian = false;
  std::shared_ptr<Shared_order> m_order = std::make_shared<Shared_order>();
};

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_MINIMIZATION_GROUPED_ENERGY_H
