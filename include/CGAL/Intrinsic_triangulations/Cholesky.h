// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CHOLESKY_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CHOLESKY_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/internal/operators/Simplicial_Cholesky.h>

#include <type_traits>

#ifdef CGAL_INTRINSIC_TRIANGULATIONS_USE_CHOLMOD
#include <CGAL/Intrinsic_triangulations/internal/operators/Supernodal_Cholesky.h>

#include <complex>
#endif

namespace CGAL::Intrinsic_triangulations {

namespace internal {

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
