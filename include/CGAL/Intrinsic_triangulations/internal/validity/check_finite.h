// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_VALIDITY_CHECK_FINITE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_VALIDITY_CHECK_FINITE_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/exceptions.h>

#include <CGAL/number_utils.h>

#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

template <typename FT>
bool is_finite_value(const FT& x)
{
  return CGAL::is_finite(x);
}

template <typename FT>
bool is_finite_value(const std::complex<FT>& z)
{
  return CGAL::is_finite(z.real()) && CGAL::is_finite(z.imag());
}

// Checks a value at the vertex with index `v`. One value that is not finite would spoil a whole
// result. `what` is the name of the value in a message.
// \throws Invalid_input if the value is not finite
template <typename Value>
void check_finite(const Value& value, std::size_t v, const char* what)
{
  if(!is_finite_value(value))
    throw Invalid_input(std::string(what) + " at vertex " + std::to_string(v) +
                        " is infinite or NaN");
}

// Checks the values at all vertices, which are a range in the order of their indices.
// \throws Invalid_input if a value is not finite
template <typename Range>
void check_all_finite(const Range& values, const char* what)
{
  std::size_t v = 0;
  for(const auto& value : values)
    check_finite(value, v++, what);
}

// Checks that the weights of all vertices are finite. Rounded weights must not exceed the squares
// of lengths in general, so that no product overflows.
// \throws Invalid_input if a weight is out of this range
template <typename FT>
void check_weights(const std::vector<FT>& weights)
{
  check_all_finite(weights, "the weight");
  if constexpr(std::numeric_limits<FT>::is_iec559)
    for(std::size_t v = 0; v < weights.size(); ++v)
      if(const int exponent = std::numeric_limits<FT>::max_exponent / 4 - 2;
         std::abs(weights[v]) > std::ldexp(FT(1), exponent))
        throw Invalid_input("the weight at vertex " + std::to_string(v) +
                            " exceeds the squares of lengths, 2^" + std::to_string(exponent));
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_VALIDITY_CHECK_FINITE_H
