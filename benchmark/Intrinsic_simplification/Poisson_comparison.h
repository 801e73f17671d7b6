// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_SIMPLIFICATION_BENCHMARK_POISSON_COMPARISON_H
#define INTRINSIC_SIMPLIFICATION_BENCHMARK_POISSON_COMPARISON_H

#include "surfaces.h"

#include <CGAL/Intrinsic_simplification/Evolving_surface.h>
#include <CGAL/Intrinsic_simplification/Surface_level.h>
#include <CGAL/Intrinsic_simplification/Surface_map.h>
#include <CGAL/Intrinsic_simplification/prolongation.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/operators.h>
#include <CGAL/Intrinsic_triangulations/poisson.h>

#include <Eigen/SparseCore>

#include <cmath>
#include <limits>

namespace IS = CGAL::Intrinsic_simplification;
namespace IT = CGAL::Intrinsic_triangulations;

// Measures how accurately a Poisson equation on a surface is solved on a coarse one. It is L u = M
// (z - mean z), with z the third coordinate, L the cotan Laplacian and M the lumped mass. A
// prolongation P maps coarse values to fine ones; the coarse right-hand side is P^T M (z - mean z).
// Solutions have mean zero, and errors are relative, in the norm of M.
class Poisson_comparison
{
public:
  explicit Poisson_comparison(const Mesh& mesh)
    : m_fine(IS::Evolving_surface(mesh)),
      m_mass(IT::lumped_mass_matrix(m_fine).diagonal()),
      m_moments(moments_of_height(mesh)),
      m_solution(solve(m_fine, m_moments))
  {}

  double error(const IS::Surface_level& coarse,
               const Eigen::SparseMatrix<double>& prolongation) const
  {
    try {
      const Eigen::VectorXd values =
        prolongation * solve(coarse, prolongation.transpose() * m_moments);
      return norm(without_mean(values) - m_solution) / norm(m_solution);
    } catch(const IT::Numerical_error&) {
      return std::numeric_limits<double>::quiet_NaN(); // a face without area
    }
  }

private:
  static Eigen::VectorXd solve(const IS::Surface_level& level, const Eigen::VectorXd& moments)
  {
    return IT::Poisson_solver<>(level).solve(moments);
  }

  Eigen::VectorXd moments_of_height(const Mesh& mesh) const
  {
    Eigen::VectorXd height(m_mass.size());
    for(Mesh::Vertex_index v : mesh.vertices())
      height[v] = mesh.point(v).z();
    return m_mass.cwiseProduct(without_mean(height));
  }

  Eigen::VectorXd without_mean(const Eigen::VectorXd& values) const
  {
    return (values.array() - m_mass.dot(values) / m_mass.sum()).matrix();
  }

  double norm(const Eigen::VectorXd& values) const
  {
    return std::sqrt(values.cwiseAbs2().dot(m_mass));
  }

  IS::Surface_level m_fine;
  Eigen::VectorXd m_mass, m_moments, m_solution;
};

#endif // INTRINSIC_SIMPLIFICATION_BENCHMARK_POISSON_COMPARISON_H
