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
  Vector solve(Vector right_side) const
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

  // The number of entries of the factor.
  double size() const { return this->m_cholmod.lnz; }

private:
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
