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

#ifdef CGAL_INTRINSIC_TRIANGULATIONS_USE_CHOLMOD
namespace internal {

template <typename Scalar>
constexpr bool is_for_CHOLMOD =
  std::is_same<Scalar, double>::value || std::is_same<Scalar, std::complex<double>>::value;

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsBlocks
/// the factorization that all packages use for numbers of this type.
template <typename Scalar>
using Cholesky =
  std::conditional_t<internal::is_for_CHOLMOD<Scalar>, internal::Supernodal_Cholesky<Scalar>,
                     internal::Simplicial_Cholesky<Scalar>>;
#else
/// \ingroup PkgIntrinsicTriangulationsBlocks
/// the factorization that all packages use for numbers of this type.
template <typename Scalar>
using Cholesky = internal::Simplicial_Cholesky<Scalar>;
#endif

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CHOLESKY_H
