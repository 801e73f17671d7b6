// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INPUT_NUMBER_KINDS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INPUT_NUMBER_KINDS_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Fraction_traits.h>
#include <CGAL/tags.h>

#include <type_traits>
#include <utility>

namespace CGAL::Intrinsic_triangulations::internal {

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

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INPUT_NUMBER_KINDS_H
