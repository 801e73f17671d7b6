// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_LOBACHEVSKY_FUNCTION_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_LOBACHEVSKY_FUNCTION_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Intrinsic_triangulations/corner_formulas.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <vector>

namespace CGAL::Discrete_conformal_maps {

namespace internal {

// Returns the coefficients |B_2k| / (2k (2k + 1)!) of Clausen's function, for k = 1, 2, ... Further
// terms are negligible for arguments up to 2 pi / 3, where each term is a ninth of the previous
// one.
template <typename FT>
std::vector<FT> Clausen_coefficients()
{
  std::vector<FT> bernoulli, result; // |B_2k| / (2k)!, by Euler's sum of positive terms
  const int terms = 2 + std::numeric_limits<FT>::digits / 3;
  for(int k = 1; k <= terms; ++k) {
    const FT products = std::inner_product(bernoulli.begin(), bernoulli.end(), bernoulli.rbegin(),
                                           FT(k == 1 ? 0.25 : 0));
    bernoulli.push_back(products / FT(2 * k + 1));
    result.push_back(bernoulli.back() / FT(2 * k * (2 * k + 1)));
  }
  return result;
}

// Returns the sum over k of c_k f_k x^(2k + 1), where f_k is given.
template <typename FT, typename Factor>
FT odd_series(const FT& x, const Factor& factor)
{
  static const std::vector<FT> coefficient = Clausen_coefficients<FT>();
  FT sum(0);
  for(std::size_t k = coefficient.size(); k > 0; --k)
    sum = sum * (x * x) + factor(k) * coefficient[k - 1];
  return sum * (x * x * x);
}

} // namespace internal

/// \ingroup PkgDiscreteConformalMapsFormulas
/// returns Milnor's Lobachevsky function \f$Л(\theta) = -\int_0^\theta \log |2 \sin u|\,du\f$ for
/// \f$0 \le \theta \le \pi\f$, to full precision. It is half of Clausen's function of the double
/// angle, computed by expansions around 0 and \f$\pi\f$. Complexity: linear in the digits of `FT`.
/// \tparam FT a floating point type, of any precision
template <typename FT>
FT Lobachevsky_function(const FT& theta)
{
  using std::log;
  const FT pi = Intrinsic_triangulations::pi<FT>();
  if(2 * theta > pi)
    return -Lobachevsky_function(FT(pi - theta));
  const FT x = 2 * theta;
  if(!(x > 0))
    return FT(0);
  if(3 * x < 2 * pi)
    return (x - x * log(x) + internal::odd_series(x, [](std::size_t) { return FT(1); })) / 2;
  const FT y = pi - x;
  return (y * log(FT(2)) - internal::odd_series(y,
                                                [](std::size_t k) {
                                                  using std::ldexp;
                                                  return ldexp(FT(1), 2 * static_cast<int>(k)) - 1;
                                                })) /
         2;
}

} // namespace CGAL::Discrete_conformal_maps

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_LOBACHEVSKY_FUNCTION_H
