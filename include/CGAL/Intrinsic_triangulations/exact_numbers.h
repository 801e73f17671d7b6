// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_EXACT_NUMBERS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_EXACT_NUMBERS_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Fraction_traits.h>
#include <CGAL/number_type_basic.h>
#include <CGAL/tags.h>

#include <type_traits>
#include <utility>

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

namespace internal {

// Determines whether a number has the form a + b sqrt(c), like `Sqrt_extension`.
template <typename K, typename = void>
struct Is_extension : std::false_type
{};

template <typename K>
struct Is_extension<K, std::void_t<decltype(std::declval<K>().a1(), std::declval<K>().root())>>
  : std::true_type
{};

// Returns whether numbers of this type are fractions of integers.
template <typename K>
constexpr bool is_fraction()
{
  return !Is_extension<K>::value &&
         std::is_same_v<typename Fraction_traits<K>::Is_fraction, Tag_true>;
}

// Returns whether numbers of this type have the form a + b sqrt(c) with fractions of one type.
template <typename K>
constexpr bool is_extension_of_fractions()
{
  if constexpr(Is_extension<K>::value)
    return std::is_same_v<typename K::NT, typename K::ROOT> && is_fraction<typename K::NT>();
  else
    return false;
}

} // namespace internal

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
