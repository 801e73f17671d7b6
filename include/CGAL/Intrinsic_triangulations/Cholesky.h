// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CHOLESKY_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CHOLESKY_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <type_traits>

#ifdef CGAL_INTRINSIC_TRIANGULATIONS_USE_CHOLMOD
#include <CGAL/Intrinsic_triangulations/internal/operators/Supernodal_Cholesky.h>

#include <complex>
#endif

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// Adapts one of Eigen's Cholesky factorizations of Hermitian matrices given by their upper
// triangles, by default the one for positive definite matrices. Rows are not permuted.
template <typename Scalar,
          typename Base = Eigen::SimplicialLLT<Eigen::SparseMatrix<Scalar>, Eigen::Upper,
                                               Eigen::NaturalOrdering<int>>>
class Simplicial_Cholesky : Base
{
public:
  typedef Eigen::SparseMatrix<Scalar> Matrix;
  typedef Eigen::Matrix<Scalar, Eigen::Dynamic, 1> Vector;
  typedef Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic> Columns;

  // Returns the elimination order that keeps the factor sparse. Its k-th entry is the row that is
  // eliminated in step k.
  static Eigen::VectorXi fill_reducing_order(const Matrix& upper)
  {
    Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> order;
    Eigen::AMDOrdering<int>()(upper.template selfadjointView<Eigen::Upper>(), order);
    return order.indices();
  }

  void analyze(const Matrix& upper, bool /* has_many_solutions */ = false)
  {
    Base::analyzePattern(upper);
  }

  // Returns false if the factorization does not exist.
  bool factorize(const Matrix& upper)
  {
    Base::factorize(upper);
    return Base::info() == Eigen::Success;
  }

  Vector solve(const Vector& right_side) const { return Base::solve(right_side); }
  Columns solve_columns(const Columns& right_sides) const { return Base::solve(right_sides); }

  // Returns the number of entries of the factor. Eigen knows it after the analysis, but has no
  // public function for it.
  double size() const { return static_cast<double>(Base::m_matrix.nonZeros()); }
};

// Factorizes matrices that may be indefinite as L D L^T. The signs of D are the signs of the
// eigenvalues.
template <typename Scalar>
using Indefinite_Cholesky =
  Simplicial_Cholesky<Scalar, Eigen::SimplicialLDLT<Eigen::SparseMatrix<Scalar>, Eigen::Upper,
                                                    Eigen::NaturalOrdering<int>>>;

// Selects the factorization for numbers of this type. Types unknown to Eigen have specializations.
template <typename Scalar>
struct Cholesky_of
{
#ifdef CGAL_INTRINSIC_TRIANGULATIONS_USE_CHOLMOD
  static constexpr bool is_for_CHOLMOD =
    std::is_same<Scalar, double>::value || std::is_same<Scalar, std::complex<double>>::value;
  typedef std::conditional_t<is_for_CHOLMOD, Supernodal_Cholesky<Scalar>,
                             Simplicial_Cholesky<Scalar>>
    type;
#else
  typedef Simplicial_Cholesky<Scalar> type;
#endif
};

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsBlocks
/// the factorization that all packages use for numbers of this type.
template <typename Scalar>
using Cholesky = typename internal::Cholesky_of<Scalar>::type;

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CHOLESKY_H
