// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_CONE_PLACEMENT_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_CONE_PLACEMENT_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Delta_complex.h>
#include <CGAL/Discrete_conformal_maps/internal/minimization/Dirichlet_solver.h>
#include <CGAL/Intrinsic_triangulations/internal/operators/Mesh_components.h>

#include <Eigen/SparseCore>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

// Greedy cones. The scale factors that make the surface flat are estimated by one linear system; a
// cone is placed where they are greatest, and the estimate is zero there from then on. For a new
// cone the system is not factorized again: it takes one column of the inverse, from which what
// former cones take away is subtracted.
class Cone_placement
{
  typedef Eigen::VectorXd Vector;

public:
  // `Laplacian` and `defect` are those of the surface, cones are not needed on components with
  // fixed vertices
  Cone_placement(const Eigen::SparseMatrix<double>& Laplacian, const Vector& defect,
                 const std::vector<char>& is_fixed)
    : m_solver(Laplacian, is_fixed)
  {
    m_estimate = m_solver.solve(-defect);
  }

  const Vector& estimate() const { return m_estimate; }

  // the vertex of component `c` with the greatest estimate
  std::size_t worst(const Intrinsic_triangulations::internal::Mesh_components& component,
                    std::size_t c) const
  {
    std::size_t result = 0;
    double greatest = -1;
    for(std::size_t v = 0; v < std::size_t(m_estimate.size()); ++v)
      if(component[v] == c && std::abs(m_estimate[index(v)]) > greatest) {
        greatest = std::abs(m_estimate[index(v)]);
        result = v;
      }
    return result;
  }

  // Makes the estimate zero at `v`.
  void add(std::size_t v)
  {
    Vector source = Vector::Zero(m_estimate.size());
    source[index(v)] = 1;
    Vector column = m_solver.solve(source);
    for(const Column& c : m_columns)
      column -= (column[c.at] / c.values[c.at]) * c.values;
    m_columns.push_back({index(v), column});
    m_estimate -= (m_estimate[index(v)] / column[index(v)]) * column;
    for(const Column& c : m_columns)
      m_estimate[c.at] = 0;
  }

private:
  struct Column
  {
    Eigen::Index at;
    Vector values;
  };

  static Eigen::Index index(std::size_t i) { return static_cast<Eigen::Index>(i); }

  Dirichlet_solver m_solver;
  std::vector<Column> m_columns;
  Vector m_estimate;
};

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_CONE_PLACEMENT_H
