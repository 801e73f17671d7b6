// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_MULTIGRID_SOLVER_H
#define CGAL_INTRINSIC_SIMPLIFICATION_MULTIGRID_SOLVER_H

#include <CGAL/license/Intrinsic_simplification.h>

#include <CGAL/Intrinsic_simplification/internal/tolerances.h>
#include <CGAL/Intrinsic_triangulations/Factorization.h>
#include <CGAL/Intrinsic_triangulations/conjugate_gradients.h>
#include <CGAL/Intrinsic_triangulations/sparse_assembly.h>

#include <CGAL/assertions.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <vector>

namespace CGAL::Intrinsic_simplification {

namespace internal {

// Stores the connected components of the graph of a symmetric matrix, and the components on which
// constants are mapped to zero.
class Matrix_components
{
public:
  typedef Eigen::SparseMatrix<double> Matrix;

  explicit Matrix_components(const Matrix& matrix)
    : m_label(static_cast<std::size_t>(matrix.cols()), none)
  {
    for(int j = 0; j < matrix.cols(); ++j)
      if(m_label[index(j)] == none)
        explore(j, matrix);
  }

  // Constructs components of the unknowns of a coarse level, with the indices of components of the
  // fine level.
  Matrix_components(const Matrix_components& fine, const Matrix& prolongation)
    : m_label(static_cast<std::size_t>(prolongation.cols()), none),
      m_is_floating(fine.m_is_floating)
  {
    for(int j = 0; j < prolongation.cols(); ++j)
      for(Matrix::InnerIterator entry(prolongation, j); entry; ++entry)
        m_label[index(j)] = fine[index(entry.row())];
  }

  std::size_t size() const { return m_is_floating.size(); }
  std::size_t operator[](std::size_t unknown) const { return m_label[unknown]; }
  bool is_floating(std::size_t component) const { return m_is_floating[component] != 0; }

private:
  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

  static std::size_t index(Eigen::Index i) { return static_cast<std::size_t>(i); }

  // Explores a component. A sum of all entries that rounding can have caused counts as zero.
  void explore(int start, const Matrix& matrix)
  {
    double sum = 0, size = 0;
    std::vector<int> open{start};
    m_label[index(start)] = m_is_floating.size();
    while(!open.empty()) {
      const int j = open.back();
      open.pop_back();
      for(Matrix::InnerIterator entry(matrix, j); entry; ++entry) {
        sum += entry.value();
        size += std::abs(entry.value());
        if(std::size_t& label = m_label[index(entry.row())]; label == none) {
          label = m_is_floating.size();
          open.push_back(static_cast<int>(entry.row()));
        }
      }
    }
    m_is_floating.push_back(std::abs(sum) <= matrix_rounding * size ? 1 : 0);
  }

  std::vector<std::size_t> m_label; // of each unknown
  std::vector<char> m_is_floating;  // of each component
};

typedef Eigen::SparseMatrix<double> Matrix;
typedef Eigen::VectorXd Vector;

// Represents a symmetric matrix with a smoother. Columns serve as rows.
class Multigrid_level
{
public:
  explicit Multigrid_level(Matrix matrix)
  {
    m_matrix.swap(matrix); // Eigen's matrices are not moved
    m_matrix.makeCompressed();
    const Vector diagonal = m_matrix.diagonal();
    m_inverse_diagonal = (diagonal.array() > 0).select(diagonal.cwiseInverse(), 0); // empty rows
  }

  const Matrix& matrix() const { return m_matrix; }

  Vector residual(const Vector& b, const Vector& x) const { return b - m_matrix.transpose() * x; }

  // Applies a Gauss-Seidel sweep.
  void smooth(const Vector& b, Vector& x) const
  {
    for(Eigen::Index j = 0; j < x.size(); ++j)
      relax(j, b, x);
  }

  // Applies a Gauss-Seidel sweep in reverse order, so that both sweeps together are symmetric.
  void smooth_back(const Vector& b, Vector& x) const
  {
    for(Eigen::Index j = x.size(); j-- > 0;)
      relax(j, b, x);
  }

private:
  void relax(Eigen::Index j, const Vector& b, Vector& x) const
  {
    double rest = b[j];
    for(Matrix::InnerIterator entry(m_matrix, j); entry; ++entry)
      rest -= entry.value() * x[entry.index()];
    x[j] += rest * m_inverse_diagonal[j];
  }

  Matrix m_matrix;
  Vector m_inverse_diagonal;
};

// Solves on the coarsest level. On a component where the matrix maps constants to zero, the first
// value is zero.
class Coarse_solver
{
public:
  Coarse_solver(const Matrix& matrix, const Matrix_components& components)
    : m_unknowns(select_unknowns(static_cast<std::size_t>(matrix.cols()), components)),
      m_factorization(m_unknowns.transpose() * matrix * m_unknowns, "coarse matrix")
  {}

  Vector operator()(const Vector& b) const
  {
    return m_unknowns * m_factorization.solve(m_unknowns.transpose() * b);
  }

private:
  static Matrix select_unknowns(std::size_t size, const Matrix_components& components)
  {
    std::vector<char> is_determined(components.size());
    for(std::size_t c = 0; c < components.size(); ++c)
      is_determined[c] = components.is_floating(c) ? 0 : 1;
    std::vector<std::size_t> unknowns;
    for(std::size_t v = 0; v < size; ++v) {
      char& determined = is_determined[components[v]];
      if(determined)
        unknowns.push_back(v);
      determined = 1;
    }
    return Intrinsic_triangulations::selection_matrix<double>(size, unknowns);
  }

  Matrix m_unknowns;
  Intrinsic_triangulations::Factorization<double> m_factorization;
};

// Applies one V-cycle, an approximate inverse that is symmetric, and positive definite if the
// matrix is. Coarser levels have the Galerkin matrices P^T A P.
class Multigrid_cycle
{
public:
  Multigrid_cycle(const Matrix& matrix, const Matrix_components& components,
                  const std::vector<Matrix>& prolongations)
    : m_prolongations(prolongations)
  {
    Matrix_components coarse_components = components;
    m_levels.emplace_back(matrix);
    for(const Matrix& p : prolongations) {
      m_levels.emplace_back(Matrix(p.transpose() * m_levels.back().matrix() * p));
      coarse_components = Matrix_components(coarse_components, p);
    }
    m_coarse_solver = std::make_unique<Coarse_solver>(m_levels.back().matrix(), coarse_components);
  }

  const Multigrid_level& finest() const { return m_levels.front(); }

  Vector operator()(const Vector& b) const { return cycle(0, b); }

  // Returns the number of entries of the matrices and prolongations of all levels.
  std::size_t number_of_entries() const
  {
    Eigen::Index result = 0;
    for(const Multigrid_level& level : m_levels)
      result += level.matrix().nonZeros();
    for(const Matrix& p : m_prolongations)
      result += p.nonZeros();
    return static_cast<std::size_t>(result);
  }

private:
  Vector cycle(std::size_t n, const Vector& b) const
  {
    if(n == m_prolongations.size())
      return (*m_coarse_solver)(b);
    const Multigrid_level& level = m_levels[n];
    const Matrix& p = m_prolongations[n];
    Vector x = Vector::Zero(b.size());
    level.smooth(b, x);
    x += p * cycle(n + 1, p.transpose() * level.residual(b, x));
    level.smooth_back(b, x);
    return x;
  }

  std::vector<Matrix> m_prolongations;
  std::vector<Multigrid_level> m_levels; // the finest first
  std::unique_ptr<Coarse_solver> m_coarse_solver;
};

} // namespace internal

using Intrinsic_triangulations::to_string;

/// \ingroup PkgIntrinsicSimplificationApplications
/// the outcome of an iteration.
typedef Intrinsic_triangulations::Iteration_status Multigrid_status;

/// \ingroup PkgIntrinsicSimplificationApplications
/// a solution with its estimated relative error in the energy norm \f$\sqrt{x^T A x}\f$, from its
/// residual and the preconditioner.
typedef Intrinsic_triangulations::Iterative_solution<double> Multigrid_result;

/// \ingroup PkgIntrinsicSimplificationApplications
/// solves equations \f$A x = b\f$ of Laplace and Poisson problems with many unknowns, by the
/// conjugate gradient method. The preconditioner is one V-cycle on a hierarchy of surfaces. It
/// sweeps with the method of Gauss and Seidel on each level downwards, and in reverse upwards.
/// Matrices of coarse levels are \f$P^T A P\f$; the coarsest one has a Cholesky factorization. The
/// number of iterations hardly depends on the number of unknowns.
///
/// The matrix belongs to a Dirichlet energy plus any nonnegative diagonal, such as \f$L + \alpha
/// M\f$ or \f$L\f$ alone. On each of its connected components it is positive definite, or singular:
/// it maps exactly the constants to zero, up to rounding. On a singular component, a solution
/// exists only if the sum of \f$b\f$ vanishes, and is unique up to a constant. So \f$b\f$ is
/// replaced by \f$b - m \sum b / \sum m\f$ with the masses \f$m\f$. The mean of the solution,
/// weighted with the masses, is zero. `Intrinsic_triangulations::Poisson_solver` does the same.
///
/// Memory: 12 bytes for each entry of the matrices and prolongations, see `number_of_entries()`.
class Multigrid_solver
{
public:
  /// the type of matrices.
  typedef Eigen::SparseMatrix<double> Matrix;
  /// the type of functions: a value for each unknown.
  typedef Eigen::VectorXd Vector;

  /// multiplies matrices and factorizes the matrix of the coarsest level. Complexity: linear if
  /// each level is smaller by a factor, plus a Cholesky factorization on the coarsest level.
  /// \param matrix the symmetric matrix \f$A\f$
  /// \param masses a number for each unknown, not negative and not all zero on a component, for
  ///   example from `Intrinsic_triangulations::lumped_mass_matrix()`
  /// \param prolongations the prolongations to each level from the next coarser one, the finest
  ///   first, as from `prolongation_hierarchy()`; may be empty
  /// \throws Intrinsic_triangulations::Numerical_error if rounding leaves the coarsest matrix
  ///   without a factorization
  Multigrid_solver(const Matrix& matrix, const Vector& masses,
                   const std::vector<Matrix>& prolongations)
    : m_components(matrix), m_masses(masses), m_cycle(matrix, m_components, prolongations)
  {
    CGAL_precondition(matrix.rows() == matrix.cols() && masses.size() == matrix.cols());
    CGAL_precondition(prolongations.empty() || prolongations[0].rows() == matrix.cols());
  }

  /// solves for one right-hand side. Complexity: linear for each iteration.
  /// \param b the right-hand side
  /// \param tolerance the estimated relative error at which to stop
  /// \param maximum_number_of_iterations the greatest number of V-cycles
  Multigrid_result solve(Vector b, double tolerance = 1e-10,
                         std::size_t maximum_number_of_iterations = 200) const
  {
    make_compatible(b);
    return Intrinsic_triangulations::solve_by_conjugate_gradients(*this, b, tolerance,
                                                                  maximum_number_of_iterations);
  }

  /// returns the product of the matrix and a vector.
  Vector product(const Vector& x) const { return m_cycle.finest().matrix().transpose() * x; }

  /// applies the preconditioner, which is symmetric, too.
  Vector preconditioned(Vector r) const
  {
    make_compatible(r);
    Vector z = m_cycle(r);
    remove_means(z); // otherwise, rounding would let constants grow
    return z;
  }

  /// returns the number of entries of all matrices and prolongations.
  std::size_t number_of_entries() const { return m_cycle.number_of_entries(); }

private:
  typedef std::vector<double> Component_sums;

  std::size_t component(Eigen::Index v) const { return m_components[static_cast<std::size_t>(v)]; }

  Component_sums sums(const Vector& values) const
  {
    Component_sums result(m_components.size(), 0);
    for(Eigen::Index v = 0; v < values.size(); ++v)
      result[component(v)] += values[v];
    return result;
  }

  // Returns for each unknown the quotient of both sums. It is zero on components whose matrix is
  // positive definite.
  Vector quotients(const Component_sums& numerator) const
  {
    const Component_sums denominator = sums(m_masses);
    Vector result = Vector::Zero(m_masses.size());
    for(Eigen::Index v = 0; v < result.size(); ++v)
      if(const std::size_t c = component(v); m_components.is_floating(c) && denominator[c] > 0)
        result[v] = numerator[c] / denominator[c];
    return result;
  }

  void make_compatible(Vector& b) const { b -= m_masses.cwiseProduct(quotients(sums(b))); }
  void remove_means(Vector& x) const { x -= quotients(sums(m_masses.cwiseProduct(x))); }

  internal::Matrix_components m_components;
  Vector m_masses;
  internal::Multigrid_cycle m_cycle;
};

} // namespace CGAL::Intrinsic_simplification

#endif // CGAL_INTRINSIC_SIMPLIFICATION_MULTIGRID_SOLVER_H
