// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_EXACT_NUMBERS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_EXACT_NUMBERS_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/number_type_basic.h>
#ifdef CGAL_USE_GMP
#include <CGAL/Gmpq.h>
#include <CGAL/Mpzf.h>
#else
#include <CGAL/Exact_rational.h>
#endif
#ifndef CGAL_HAS_MPZF
#include <CGAL/MP_Float.h>
#endif

namespace CGAL::Intrinsic_triangulations {

// These types of CGAL compile in a fraction of the time of `CGAL::Exact_rational` and its like.

/// \ingroup PkgIntrinsicTriangulationsCertificates
/// the type of numbers in which sums and products of numbers of type `double` are exact.
#ifdef CGAL_HAS_MPZF
typedef Mpzf Exact_ring;
#else
typedef MP_Float Exact_ring;
#endif

/// \ingroup PkgIntrinsicTriangulationsCertificates
/// the type of numbers in which quotients are exact, too.
#ifdef CGAL_USE_GMP
typedef Gmpq Exact_field;
#else
typedef Exact_rational Exact_field;
#endif

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_EXACT_NUMBERS_H
