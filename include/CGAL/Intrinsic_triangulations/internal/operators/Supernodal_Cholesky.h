// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_OPERATORS_SUPERNODAL_CHOLESKY_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_OPERATORS_SUPERNODAL_CHOLESKY_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/exceptions.h>

#include <CGAL/FPU.h>

#include <Eigen/CholmodSupport>
#include <Eigen/SparseCore>

#ifdef CGAL_INTRINSIC_TRIANGULATIONS_USE_GOMP
#include <omp.h>
#endif
#ifdef CGAL_HAS_SSE2
#include <pmmintrin.h>
#endif

#include <algorithm>
#include <new>

namespace CGAL::Intrinsic_triangulations::internal {

// As long as it lives, regions of OpenMP that are begun by this thread have one thread.
class One_thread_of_OpenMP
{
#ifdef CGAL_INTRINSIC_TRIANGULATIONS_USE_GOMP
public:
  One_thread_of_OpenMP() { omp_set_max_active_levels(0); }
  ~One_thread_of_OpenMP() { omp_set_max_active_levels(m_levels); }
  One_thread_of_OpenMP(const One_thread_of_OpenMP&) = delete;
  One_thread_of_OpenMP& operator=(const One_thread_of_OpenMP&) = delete;

private:
  int m_levels = omp_get_max_active_levels();
#endif
};

// As long as it lives, this thread takes subnormal numbers for zero. Where entries of a factor
// decay with distance, as with heat, many are subnormal, which slows processors down.
class Subnormals_as_zero
{
#ifdef CGAL_HAS_SSE2
public:
  Subnormals_as_zero() { _mm_setcsr(m_state | _MM_FLUSH_ZERO_ON | _MM_DENORMALS_ZERO_ON); }
  ~Subnormals_as_zero() { _mm_setcsr(m_state); }
  Subnormals_as_zero(const Subnormals_as_zero&) = delete;
  Subnormals_as_zero& operator=(const Subnormals_as_zero&) = delete;

private:
  unsigned m_state = _mm_getcsr();
#endif
};

// Solves equations with a supernodal factor of CHOLMOD. CHOLMOD itself calls BLAS for each block,
// which takes longer than the block where there is one right-hand side.
template <typename Scalar>
class Supernodal_solution
{
  typedef Eigen::Matrix<Scalar, Eigen::Dynamic, 1> Vector;
  typedef Eigen::Map<const Vector> Column;

public:
  explicit Supernodal_solution(const cholmod_factor& factor)
    : m_factor(factor), m_below(static_cast<Eigen::Index>(factor.maxesize))
  {}

  Vector operator()(const Vector& right_side)
  {
    const int* order = static_cast<const int*>(m_factor.Perm);
    m_x.resize(right_side.size());
    for(Eigen::Index i = 0; i < m_x.size(); ++i)
      m_x[i] = right_side[order[i]];
    const int n = static_cast<int>(m_factor.nsuper);
    for(int s = 0; s < n; ++s)
      eliminate(block(s));
    for(int s = n; s-- > 0;)
      substitute(block(s));
    Vector result(m_x.size());
    for(Eigen::Index i = 0; i < m_x.size(); ++i)
      result[order[i]] = m_x[i];
    return result;
  }

private:
  // Columns of the factor with the same rows below their triangle.
  struct Block
  {
    Eigen::Index first, columns, rows;
    const Scalar* entries;
    const int* row; // below the triangle

    Scalar diagonal(Eigen::Index j) const { return entries[j * rows + j]; }
    // the entries of column `j` below the diagonal in the triangle
    Column inside(Eigen::Index j) const { return {entries + j * rows + j + 1, columns - j - 1}; }
    // entries below the triangle
    Column below(Eigen::Index j) const { return {entries + j * rows + columns, rows - columns}; }
  };

  Block block(int s) const
  {
    const auto at = [s](const void* numbers, int k = 0) {
      return static_cast<const int*>(numbers)[s + k];
    };
    const int first = at(m_factor.super), columns = at(m_factor.super, 1) - first;
    const int begin = at(m_factor.pi), rows = at(m_factor.pi, 1) - begin;
    return {first, columns, rows, static_cast<const Scalar*>(m_factor.x) + at(m_factor.px),
            static_cast<const int*>(m_factor.s) + begin + columns};
  }

  // Solves for the unknowns of a block in the equations of the lower triangle.
  void eliminate(const Block& block)
  {
    auto below = m_below.head(block.rows - block.columns);
    below.setZero();
    for(Eigen::Index j = 0; j < block.columns; ++j) {
      const Scalar x = m_x[block.first + j] /= block.diagonal(j);
      m_x.segment(block.first + j + 1, block.columns - j - 1) -= x * block.inside(j);
      below += x * block.below(j);
    }
    for(Eigen::Index i = 0; i < below.size(); ++i)
      m_x[block.row[i]] -= below[i];
  }

  // the same in the upper triangle
  void substitute(const Block& block)
  {
    auto below = m_below.head(block.rows - block.columns);
    for(Eigen::Index i = 0; i < below.size(); ++i)
      below[i] = m_x[block.row[i]];
    for(Eigen::Index j = block.columns; j-- > 0;) {
      const auto inside = m_x.segment(block.first + j + 1, block.columns - j - 1);
      const Scalar known = block.inside(j).dot(inside) + block.below(j).dot(below);
      m_x[block.first + j] = (m_x[block.first + j] - known) / block.diagonal(j);
    }
  }

  const cholmod_factor& m_factor;
  Vector m_x, m_below;
};

// Eigen's interface to CHOLMOD, supernodal if that pays. Hermitian matrices are given by their
// upper triangles (entries below are ignored), in their order. It adds settings, an order of
// elimination of its own, errors, and solutions in many threads with one factor.
template <typename Scalar>
class Supernodal_Cholesky
  : Eigen::CholmodBase<Eigen::SparseMatrix<Scalar>, Eigen::Upper, Supernodal_Cholesky<Scalar>>
{
  typedef Eigen::CholmodBase<Eigen::SparseMatrix<Scalar>, Eigen::Upper, Supernodal_Cholesky> Base;

public:
  typedef Eigen::SparseMatrix<Scalar> Matrix;
  typedef Eigen::Matrix<Scalar, Eigen::Dynamic, 1> Vector;

  Supernodal_Cholesky() : Supernodal_Cholesky(CHOLMOD_NATURAL) {}

  // The order of elimination that keeps the factor sparse: its k-th entry is the k-th row to go.
  // Nested dissection costs more than minimum degree; the factorizations repay it from about this
  // size on.
  static Eigen::VectorXi fill_reducing_order(const Matrix& upper)
  {
    Supernodal_Cholesky factor(upper.rows() > 100000 ? CHOLMOD_NESDIS : CHOLMOD_AMD);
    factor.analyze(upper);
    return Eigen::Map<const Eigen::VectorXi>(static_cast<const int*>(factor.m_cholmodFactor->Perm),
                                             upper.rows());
  }

  void analyze(const Matrix& upper)
  {
    Base::analyzePattern(upper);
    check(this->m_cholmod.status);
  }

  // Returns false if the matrix is not positive definite. CHOLMOD would wake four threads for each
  // supernode, whatever the machine has; with surfaces they cost more time than they save.
  bool factorize(const Matrix& upper)
  {
    [[maybe_unused]] const One_thread_of_OpenMP one_thread;
    [[maybe_unused]] const Subnormals_as_zero subnormals;
    Base::factorize(upper);
    check(this->m_cholmod.status);
    return Base::info() == Eigen::Success;
  }

  // Eigen's `solve()` has one workspace, which threads cannot share.
  Vector solve(const Vector& right_side) const
  {
    return this->m_cholmodFactor->is_super
             ? Supernodal_solution<Scalar>(*this->m_cholmodFactor)(right_side)
             : simplicial_solution(right_side);
  }

  // The number of entries of the factor.
  double size() const { return this->m_cholmod.lnz; }

private:
  Vector simplicial_solution(Vector right_side) const
  {
    cholmod_common workspace;
    cholmod_start(&workspace);
    cholmod_dense b = Eigen::viewAsCholmod(right_side);
    cholmod_dense* x = cholmod_solve(CHOLMOD_A, this->m_cholmodFactor, &b, &workspace);
    const int status = workspace.status;
    if(x)
      std::copy_n(static_cast<const Scalar*>(x->x), right_side.size(), right_side.data());
    cholmod_free_dense(&x, &workspace);
    cholmod_finish(&workspace);
    check(status);
    return right_side;
  }

  explicit Supernodal_Cholesky(int ordering)
  {
    cholmod_common& settings = this->m_cholmod;
    // operations per entry: where both kinds take equally long, with OpenBLAS
    settings.supernodal_switch = 80;
    settings.final_ll = 1; // the other form does not find out whether a matrix is positive
    settings.quick_return_if_not_posdef = 1;
    settings.print = 0;
    settings.nmethods = 1;
    settings.method[0].ordering = ordering;
    // Minimum degree is as good for parts of this size, and takes a fraction of the time.
    settings.method[0].nd_small = 1000;
  }

  static void check(int status)
  {
    if(status == CHOLMOD_OUT_OF_MEMORY)
      throw std::bad_alloc();
    if(status < CHOLMOD_OK)
      throw Numerical_error("the factor of a matrix is too large for CHOLMOD");
  }
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_OPERATORS_SUPERNODAL_CHOLESKY_H
