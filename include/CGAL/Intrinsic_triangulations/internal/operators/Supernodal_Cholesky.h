// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_OPERATORS_SUPERNODAL_CHOLESKY_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_OPERATORS_SUPERNODAL_CHOLESKY_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/exceptions.h>

#include <CGAL/FPU.h>

#include <Eigen/SparseCore>

#include <suitesparse/cholmod.h>
#ifdef CGAL_INTRINSIC_TRIANGULATIONS_USE_GOMP
#include <omp.h>
#endif
#ifdef CGAL_HAS_SSE2
#include <pmmintrin.h>
#endif

#include <algorithm>
#include <cstddef>
#include <new>
#include <type_traits>

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

// CHOLMOD's workspace and settings.
class Cholmod_workspace
{
public:
  Cholmod_workspace()
  {
    cholmod_start(&m_common);
    m_common.supernodal = CHOLMOD_AUTO;
    // operations per entry: where both kinds take equally long, with OpenBLAS
    m_common.supernodal_switch = 80;
    m_common.final_ll = 1; // the other form does not find out whether a matrix is positive
    m_common.quick_return_if_not_posdef = 1;
    m_common.print = 0;
    m_common.nmethods = 1;
    // Minimum degree is as good for parts of this size, and takes a fraction of the time.
    m_common.method[0].nd_small = 1000;
  }
  ~Cholmod_workspace() { cholmod_finish(&m_common); }
  Cholmod_workspace(const Cholmod_workspace&) = delete;
  Cholmod_workspace& operator=(const Cholmod_workspace&) = delete;

  cholmod_common* operator->() { return &m_common; }

  cholmod_factor* analyze(cholmod_sparse matrix, int ordering)
  {
    m_common.method[0].ordering = ordering;
    cholmod_factor* factor = cholmod_analyze(&matrix, &m_common);
    check();
    return factor;
  }

  // Returns false if the matrix is not positive definite. CHOLMOD would wake four threads for each
  // supernode, whatever the machine has; with surfaces they cost more time than they save.
  bool factorize(cholmod_sparse matrix, cholmod_factor* factor)
  {
    [[maybe_unused]] const One_thread_of_OpenMP one_thread;
    [[maybe_unused]] const Subnormals_as_zero subnormals;
    cholmod_factorize(&matrix, factor, &m_common);
    check();
    return m_common.status == CHOLMOD_OK;
  }

  cholmod_dense* solve(cholmod_factor* factor, cholmod_dense right_side)
  {
    cholmod_dense* x = cholmod_solve(CHOLMOD_A, factor, &right_side, &m_common);
    check();
    return x;
  }

  void free(cholmod_factor* factor) { cholmod_free_factor(&factor, &m_common); }
  void free(cholmod_dense* vector) { cholmod_free_dense(&vector, &m_common); }

private:
  void check() const
  {
    if(m_common.status == CHOLMOD_OUT_OF_MEMORY)
      throw std::bad_alloc();
    if(m_common.status < CHOLMOD_OK)
      throw Numerical_error("the factor of a matrix is too large for CHOLMOD");
  }

  cholmod_common m_common;
};

// CHOLMOD's Cholesky factorization, supernodal where that pays, of Hermitian matrices given by
// their upper triangles (what is below is ignored), in the order they have.
template <typename Scalar>
class Supernodal_Cholesky
{
public:
  typedef Eigen::SparseMatrix<Scalar> Matrix;
  typedef Eigen::Matrix<Scalar, Eigen::Dynamic, 1> Vector;

  Supernodal_Cholesky() = default;
  ~Supernodal_Cholesky() { clear(); }
  Supernodal_Cholesky(const Supernodal_Cholesky&) = delete;
  Supernodal_Cholesky& operator=(const Supernodal_Cholesky&) = delete;

  // The order of elimination that keeps the factor sparse: its k-th entry is the k-th row to go.
  // Nested dissection costs more than minimum degree; the factorizations repay it from about this
  // size on.
  static Eigen::VectorXi fill_reducing_order(const Matrix& upper)
  {
    Cholmod_workspace workspace;
    cholmod_factor* factor =
      workspace.analyze(view(upper), upper.rows() > 100000 ? CHOLMOD_NESDIS : CHOLMOD_AMD);
    Eigen::VectorXi order =
      Eigen::Map<const Eigen::VectorXi>(static_cast<const int*>(factor->Perm), upper.rows());
    workspace.free(factor);
    return order;
  }

  void analyze(const Matrix& upper)
  {
    clear();
    m_factor = m_workspace.analyze(view(upper), CHOLMOD_NATURAL);
  }

  // Returns false if the matrix is not positive definite.
  bool factorize(const Matrix& upper) { return m_workspace.factorize(view(upper), m_factor); }

  Vector solve(Vector right_side) const
  {
    cholmod_dense b{};
    b.nrow = b.nzmax = b.d = static_cast<std::size_t>(right_side.size());
    b.ncol = 1;
    b.x = right_side.data();
    b.xtype = xtype;
    Cholmod_workspace workspace; // its own, so that many threads can solve with one factor
    cholmod_dense* x = workspace.solve(m_factor, b);
    std::copy_n(static_cast<const Scalar*>(x->x), right_side.size(), right_side.data());
    workspace.free(x);
    return right_side;
  }

  // The number of entries of the factor.
  double size() { return m_workspace->lnz; }

private:
  static constexpr int xtype = std::is_same<Scalar, double>::value ? CHOLMOD_REAL : CHOLMOD_COMPLEX;

  // CHOLMOD's interface has no constants, but it does not write here.
  static cholmod_sparse view(const Matrix& upper)
  {
    cholmod_sparse result{};
    result.nrow = result.ncol = static_cast<std::size_t>(upper.rows());
    result.nzmax = static_cast<std::size_t>(upper.nonZeros());
    result.p = const_cast<int*>(upper.outerIndexPtr());
    result.i = const_cast<int*>(upper.innerIndexPtr());
    result.x = const_cast<Scalar*>(upper.valuePtr());
    result.stype = 1; // the upper triangle
    result.itype = CHOLMOD_INT;
    result.xtype = xtype;
    result.dtype = CHOLMOD_DOUBLE;
    result.sorted = result.packed = 1;
    return result;
  }

  void clear()
  {
    if(m_factor)
      m_workspace.free(m_factor);
    m_factor = nullptr;
  }

  Cholmod_workspace m_workspace;
  cholmod_factor* m_factor = nullptr;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_OPERATORS_SUPERNODAL_CHOLESKY_H
