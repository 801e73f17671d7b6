// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Sums of two numbers of type `double` are compared with numbers of 120 digits.

#include "../Intrinsic_triangulations/testing.h"

#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Corner.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/number_types.h>

#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>

namespace Test_double_double {

namespace DCM = CGAL::Discrete_conformal_maps;
using Number = DCM::internal::Double_double;
using Big = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<120>,
                                          boost::multiprecision::et_off>;

Big big(const Number& x) { return Big(x.high()) + Big(x.low()); }

// Returns a number with random digits, a random sign and an exponent up to `range` by absolute
// value.
Number random_number(CGAL::Random& random, int range)
{
  const double high = std::ldexp(random.get_double(0.5, 1), random.get_int(-range, range + 1)) *
                      (random.get_bool() ? 1 : -1);
  const double unit = std::numeric_limits<double>::epsilon();
  return Number(high) +
         Number(high * std::ldexp(random.get_double(-unit, unit), -random.get_int(0, 20)));
}

// Returns the error in squares of half a unit of `double`, relative to `scale`.
double error(const Number& x, const Big& expected, const Big& scale)
{
  return std::ldexp(static_cast<double>(Big(abs((big(x) - expected) / scale))), 106);
}

double error(const Number& x, const Big& expected)
{
  return expected == 0 ? (x == 0 ? 0 : std::numeric_limits<double>::infinity())
                       : error(x, expected, expected);
}

TEST(Double_double, arithmetic_has_the_error_bounds_of_the_literature)
{
  CGAL::Random random(1);
  double sum = 0, product = 0, quotient = 0, root = 0;
  for(int i = 0; i < 200000; ++i) {
    const int range = i % 2 == 0 ? 1 : 200;
    const Number x = random_number(random, range);
    // Every third pair cancels.
    const Number y =
      i % 3 == 0 ? x * Number(-1 + random.get_double(-1e-15, 1e-15)) : random_number(random, range);
    sum = (std::max)(sum, error(x + y, big(x) + big(y)));
    sum = (std::max)(sum, error(x - y, big(x) - big(y)));
    product = (std::max)(product, error(x * y, big(x) * big(y)));
    quotient = (std::max)(quotient, error(x / y, big(x) / big(y)));
    root = (std::max)(root, error(sqrt(abs(x)), Big(sqrt(Big(abs(big(x)))))));
  }
  EXPECT_LE(sum, 3);
  EXPECT_LE(product, 7);
  EXPECT_LE(quotient, 16);
  EXPECT_LE(root, 4);
}

TEST(Double_double, first_part_is_the_rounded_number)
{
  CGAL::Random random(2);
  for(int i = 0; i < 20000; ++i) {
    const Number x = random_number(random, 40) * random_number(random, 40),
                 y = x + random_number(random, 80);
    for(const Number& z : {x, y, x / y, sqrt(abs(x)), exp(x / abs(x))})
      EXPECT_EQ(z.high(), z.high() + z.low());
  }
}

TEST(Double_double, transcendental_functions_have_all_digits)
{
  CGAL::Random random(3);
  for(int i = 0; i < 2000; ++i) {
    const Number x = random_number(random, i % 2 == 0 ? 9 : 40), y = random_number(random, 40);
    const Big size = (std::max)(Big(1), Big(abs(big(x))));
    EXPECT_LE(error(log(abs(x)), log(Big(abs(big(x)))), 1 + abs(log(Big(abs(big(x)))))), 100);
    EXPECT_LE(error(atan2(y, x), atan2(big(y), big(x))), 100);
    if(abs(x) < 1000) {
      EXPECT_LE(error(sin(x), sin(big(x)), size), 100);
      EXPECT_LE(error(cos(x), cos(big(x)), size), 100);
    }
    if(abs(x) < 600) {
      EXPECT_LE(error(exp(x), exp(big(x)), exp(big(x)) * size), 100);
    }
  }
  const Big pi = boost::math::constants::pi<Big>();
  EXPECT_LE(error(CGAL::Intrinsic_triangulations::pi<Number>(), pi), 4);
  EXPECT_LE(error(CGAL::Intrinsic_triangulations::internal::ln_two(), log(Big(2))), 1);
}

TEST(Double_double, is_ordered_by_both_parts)
{
  CGAL::Random random(4);
  for(int i = 0; i < 20000; ++i) {
    const Number x = random_number(random, 1), y = i % 2 == 0 ? x + Number(x.low()) : x;
    EXPECT_EQ(x < y, big(x) < big(y));
    EXPECT_EQ(x <= y, big(x) <= big(y));
    EXPECT_EQ(x > y, big(x) > big(y));
    EXPECT_EQ(x >= y, big(x) >= big(y));
    EXPECT_EQ(x == y, big(x) == big(y));
    EXPECT_EQ(x != y, big(x) != big(y));
  }
}

TEST(Double_double, ends_of_the_range)
{
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(sqrt(Number(0)), 0);
  EXPECT_TRUE(std::isnan(sqrt(Number(-1)).high()));
  EXPECT_EQ(exp(Number(2000)), infinity);
  EXPECT_EQ(exp(Number(-2000)), 0);
  EXPECT_EQ(log(Number(0)), -infinity);
  EXPECT_EQ(log(Number(infinity)), infinity);
  EXPECT_EQ(atan2(Number(0), Number(1)), 0);
  EXPECT_TRUE(std::isnan(sin(Number(infinity)).high()));
}

} // namespace Test_double_double
