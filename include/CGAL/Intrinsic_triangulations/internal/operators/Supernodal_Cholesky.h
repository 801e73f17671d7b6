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
#include <utility>

namespace CGAL::Intrinsic_triangulations::internal {

// Limits regions of OpenMP that this thread begins to one thread, during the lifetime of the
// object.
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

// Makes this thread treat subnormal numbers as zero, during the lifetime of the object. If entries
// of a factor decay with distance, as with heat, many are subnormal, which slows processors down.
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

// Solves equations with a supernodal factor of CHOLMOD, for several right-hand sides at once.
// CHOLMOD itself calls BLAS for each block, and the call dominates if right-hand sides are few. A
// row stores the values of all right-hand sides.
template <typename Scalar, int number_of_sides = 1>
class Supernodal_solution
{
  static constexpr bool is_one = number_of_sides == 1;
  typedef Eigen::Map<const Eigen::Matrix<Scalar, Eigen::Dynamic, 1>> Column;
  typedef Eigen::Matrix<Scalar, 1, number_of_sides> Row;
  typedef Eigen::Matrix<Scalar, Eigen::Dynamic, number_of_sides,
                        is_one ? Eigen::ColMajor : Eigen::RowMajor>
    Rows;

public:
  explicit Supernodal_solution(const cholmod_factor& factor)
    : m_factor(factor), m_below(static_cast<Eigen::Index>(factor.maxesize), number_of_sides)
  {}

  // Replaces the columns by solutions. Their number is at most the number of right-hand sides.
  template <typename Columns>
  void operator()(Columns&& columns)
  {
    const int* order = static_cast<const int*>(m_factor.Perm);
    m_x.setZero(columns.rows(), number_of_sides);
    for(Eigen::Index k = 0; k < columns.cols(); ++k)
      for(Eigen::Index i = 0; i < m_x.rows(); ++i)
        m_x(i, k) = columns(order[i], k);
    const int n = static_cast<int>(m_factor.nsuper);
    for(int s = 0; s < n; ++s)
      eliminate(block(s));
    for(int s = n; s-- > 0;)
      substitute(block(s));
    for(Eigen::Index k = 0; k < columns.cols(); ++k)
      for(Eigen::Index i = 0; i < m_x.rows(); ++i)
        columns(order[i], k) = m_x(i, k);
  }

private:
  // Represents columns of the factor with the same rows below their triangle.
  struct Block
  {
    Eigen::Index first, columns, rows;
    const Scalar* entries;
    const int* row; // below the triangle

    Scalar diagonal(Eigen::Index j) const { return entries[j * rows + j]; }
    // Returns the entries of column `j` below the diagonal in the triangle.
    Column inside(Eigen::Index j) const { return {entries + j * rows + j + 1, columns - j - 1}; }
    // Returns the entries of column `j` below the triangle.
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
    auto below = m_below.topRows(block.rows - block.columns);
    below.setZero();
    for(Eigen::Index j = 0; j < block.columns; ++j) {
      const Row x = m_x.row(block.first + j) /= block.diagonal(j);
      m_x.middleRows(block.first + j + 1, block.columns - j - 1) -= block.inside(j).lazyProduct(x);
      below += block.below(j).lazyProduct(x);
    }
    for(Eigen::Index i = 0; i < below.rows(); ++i)
      m_x.row(block.row[i]) -= below.row(i);
  }

  // Solves for the unknowns of a block in the equations of the upper triangle.
  void substitute(const Block& block)
  {
    auto below = m_below.topRows(block.rows - block.columns);
    for(Eigen::Index i = 0; i < below.rows(); ++i)
      below.row(i) = m_x.row(block.row[i]);
    for(Eigen::Index j = block.columns; j-- > 0;) {
      const auto inside = m_x.middleRows(block.first + j + 1, block.columns - j - 1);
      const Row known = product(block.inside(j), inside) + product(block.below(j), below);
      m_x.row(block.first + j) = (m_x.row(block.first + j) - known) / block.diagonal(j);
    }
  }

  // Returns the scalar products of a column of the factor with all columns of `rows`.
  template <typename Block_of_rows>
  static Row product(const Column& column, const Block_of_rows& rows)
  {
    if constexpr(is_one)
      return Row(column.dot(rows));
    Row result = Row::Zero();
    for(Eigen::Index i = 0; i < column.size(); ++i)
      result += Eigen::numext::conj(column[i]) * rows.row(i);
    return result;
  }

  const cholmod_factor& m_factor;
  Rows m_x, m_below;
};

// Adapts Eigen's interface to CHOLMOD, supernodal if this is faster. Hermitian matrices are given
// by their upper triangles (entries below are ignored), in their order. The class adds settings,
// its own elimination order, errors, and solutions in many threads with one factor.
template <typename Scalar>
class Supernodal_Cholesky
  : Eigen::CholmodBase<Eigen::SparseMatrix<Scalar>, Eigen::Upper, Supernodal_Cholesky<Scalar>>
{
  typedef Eigen::CholmodBase<Eigen::SparseMatrix<Scalar>, Eigen::Upper, Supernodal_Cholesky> Base;

public:
  typedef Eigen::SparseMatrix<Scalar> Matrix;
  typedef Eigen::Matrix<Scalar, Eigen::Dynamic, 1> Vector;
  typedef Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic> Columns;

  Supernodal_Cholesky() : Supernodal_Cholesky(CHOLMOD_NATURAL) {}

  // Returns the elimination order that keeps the factor sparse. Its k-th entry is the row that is
  // eliminated in step k. Nested dissection costs more than minimum degree. The faster
  // factorization outweighs this cost from about this size on.
  static Eigen::VectorXi fill_reducing_order(const Matrix& upper)
  {
    Supernodal_Cholesky factor(upper.rows() > 100000 ? CHOLMOD_NESDIS : CHOLMOD_AMD);
    factor.analyze(upper);
    return Eigen::Map<const Eigen::VectorXi>(static_cast<const int*>(factor.m_cholmodFactor->Perm),
                                             upper.rows());
  }

  // Prepares for factorizations. Each of them may have many solutions.
  void analyze(const Matrix& upper, bool has_many_solutions = false)
  {
    // At 80 operations per entry, factorizations of both kinds take equally long with OpenBLAS. At
    // 120, the simplicial factorization takes a little longer than the supernodal one. But its
    // solutions take five sixths of the time, so ten solutions outweigh this.
    this->m_cholmod.supernodal_switch = has_many_solutions ? 120 : 80;
    Base::analyzePattern(upper);
    check(this->m_cholmod.status);
  }

  // Returns false if the matrix is not positive definite. By default, CHOLMOD uses four threads for
  // each supernode on any machine. For matrices of surfaces, they cost more time than they save.
  bool factorize(const Matrix& upper)
  {
    [[maybe_unused]] const One_thread_of_OpenMP one_thread;
    [[maybe_unused]] const Subnormals_as_zero subnormals;
    Base::factorize(upper);
    check(this->m_cholmod.status);
    return Base::info() == Eigen::Success;
  }

  // Solves without Eigen's `solve()`, whose single workspace cannot be shared by threads.
  Vector solve(Vector right_side) const
  {
    if(!this->m_cholmodFactor->is_super)
      return is_sparse(right_side) ? solution_of_sparse(right_side)
                                   : simplicial_solution(std::move(right_side));
    Supernodal_solution<Scalar>{*this->m_cholmodFactor}(right_side);
    return right_side;
  }

  // Solves for all columns, several at once.
  Columns solve_columns(Columns right_sides) const
  {
    constexpr int at_once = 8;
    if(right_sides.cols() == 0)
      return right_sides;
    if(!this->m_cholmodFactor->is_super)
      return simplicial_solution(std::move(right_sides));
    Supernodal_solution<Scalar, at_once> solution(*this->m_cholmodFactor);
    for(Eigen::Index k = 0; k < right_sides.cols(); k += at_once)
      solution(
        right_sides.middleCols(k, (std::min)(Eigen::Index(at_once), right_sides.cols() - k)));
    return right_sides;
  }

  // Returns the number of entries of the factor.
  double size() const { return this->m_cholmod.lnz; }

private:
  // Returns whether nonzeros are so few that skipping columns saves time.
  static bool is_sparse(const Vector& right_side)
  {
    return 64 * (right_side.array() != Scalar(0)).count() <= right_side.size();
  }

  // Solves with the simplicial factor for a sparse right side. Unlike CHOLMOD, it skips columns of
  // unknowns that are zero.
  Vector solution_of_sparse(const Vector& right_side) const
  {
    const int* order = static_cast<const int*>(this->m_cholmodFactor->Perm);
    Vector x(right_side.size());
    for(Eigen::Index i = 0; i < x.size(); ++i)
      x[i] = right_side[order[i]];
    eliminate_nonzeros(x);
    x = simplicial_solution(std::move(x), CHOLMOD_Lt);
    Vector result(x.size());
    for(Eigen::Index i = 0; i < x.size(); ++i)
      result[order[i]] = x[i];
    return result;
  }

  // Solves the equations of the lower triangle, and skips unknowns that are zero.
  void eliminate_nonzeros(Vector& x) const
  {
    const cholmod_factor& factor = *this->m_cholmodFactor;
    const int* first = static_cast<const int*>(factor.p);
    const int* size = static_cast<const int*>(factor.nz);
    const int* row = static_cast<const int*>(factor.i);
    const Scalar* entry = static_cast<const Scalar*>(factor.x);
    for(Eigen::Index j = 0; j < x.size(); ++j)
      if(x[j] != Scalar(0)) {
        int k = first[j];
        const int end = k + size[j];
        const Scalar value = x[j] /= entry[k];
        while(++k < end)
          x[row[k]] -= entry[k] * value;
      }
  }

  template <typename Dense>
  Dense simplicial_solution(Dense right_side, int system = CHOLMOD_A) const
  {
    cholmod_common workspace;
    cholmod_start(&workspace);
    cholmod_dense b = Eigen::viewAsCholmod(right_side);
    cholmod_dense* x = cholmod_solve(system, this->m_cholmodFactor, &b, &workspace);
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
