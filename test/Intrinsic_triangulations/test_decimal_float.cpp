// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "testing.h"

#include <CGAL/Exact_rational.h>
#include <CGAL/Intrinsic_triangulations/Decimal_float.h>
#include <CGAL/Random.h>

#include <cstdint>

// These tests compare numbers with many digits with rational numbers.
namespace Test_decimal_float {

namespace IT = CGAL::Intrinsic_triangulations;
using CGAL::Exact_rational;
using Number = IT::Decimal_float<115>;
constexpr int digits = std::numeric_limits<Number>::digits;

// Returns a number as a sum of numbers of type `double`.
Exact_rational exact(Number x)
{
  Exact_rational result = 0;
  while(x != 0) {
    const double part = static_cast<double>(x);
    result += Exact_rational(part);
    x -= part;
  }
  return result;
}

Exact_rational size(const Exact_rational& x) { return x < 0 ? Exact_rational(-x) : x; }

Exact_rational power_of_two(int exponent) { return Exact_rational(std::ldexp(1., exponent)); }

// Returns whether a result is the nearest number, or as near. Half a unit in its last digit is
// less than `|y| * 2^-digits`.
bool is_nearest(const Number& x, const Exact_rational& y)
{
  return size(exact(x) - y) <= size(y) * power_of_two(-digits);
}

// Returns a number with random digits, and an exponent between -40 and 40.
Number random_number(CGAL::Random& random)
{
  Number result(0);
  for(int i = 0; i < 9; ++i)
    result += ldexp(Number(random.get_double(-1, 1)), -45 * i);
  return ldexp(result, random.get_int(-40, 40));
}

TEST(Decimal_float, operations_round_to_nearest)
{
  CGAL::Random random(1);
  for(int trial = 0; trial < 1000; ++trial) {
    const Number x = random_number(random), y = random_number(random);
    const Exact_rational a = exact(x), b = exact(y);
    ASSERT_TRUE(is_nearest(x + y, a + b));
    ASSERT_TRUE(is_nearest(x - y, a - b));
    ASSERT_TRUE(is_nearest(x * y, a * b));
    ASSERT_TRUE(is_nearest(x / y, a / b));
    ASSERT_EQ(exact(-x), -a);
    ASSERT_EQ(exact(abs(x)), size(a));
    const Exact_rational root = exact(sqrt(abs(x))), unit = power_of_two(-digits);
    ASSERT_LE(root * (1 - unit) * root * (1 - unit), size(a));
    ASSERT_GE(root * (1 + unit) * root * (1 + unit), size(a));
    ASSERT_EQ(x < y, a < b);
    ASSERT_EQ(x <= y, a <= b);
    ASSERT_EQ(x > y, a > b);
    ASSERT_EQ(x >= y, a >= b);
    ASSERT_NE(x, y);
    ASSERT_EQ(x, Number(x));
  }
}

TEST(Decimal_float, functions_satisfy_their_equations)
{
  CGAL::Random random(2);
  const Number bound = 1000 * std::numeric_limits<Number>::epsilon(); // without MPFR
  for(int trial = 0; trial < 100; ++trial) {
    const Number x = Number(random.get_double(-1, 1)) + random_number(random) / 1e16;
    const Number c = cos(x), s = sin(x);
    EXPECT_LE(abs(c * c + s * s - 1), bound);
    EXPECT_LE(abs(atan2(s, c) - x), bound);
    EXPECT_LE(abs(log(exp(x)) - x), bound);
    int exponent = 0;
    const Number part = frexp(x, &exponent);
    EXPECT_GE(abs(part), 0.5);
    EXPECT_LT(abs(part), 1);
    EXPECT_EQ(ldexp(part, exponent), x);
  }
}

TEST(Decimal_float, converts_texts)
{
  CGAL::Random random(3);
  for(int trial = 0; trial < 100; ++trial) {
    const Number x = random_number(random);
    EXPECT_EQ(Number(x.str(std::numeric_limits<Number>::max_digits10)), x);
    EXPECT_EQ(std::stod(x.str(17)), static_cast<double>(Number(x.str(17))));
  }
  EXPECT_EQ(Number(0.375).str(2), "0.38");
  EXPECT_EQ(Number(-0.25).str(9), "-0.25");
  EXPECT_EQ(Number(0).str(9), "0");
  EXPECT_EQ(exact(Number("1.5")), Exact_rational(1.5));
}

TEST(Decimal_float, converts_all_numbers)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  constexpr auto least = (std::numeric_limits<std::int64_t>::min)();
  constexpr auto greatest = (std::numeric_limits<std::uint64_t>::max)();
  EXPECT_EQ(exact(Number(least)), -power_of_two(63));
  EXPECT_EQ(exact(Number(greatest)) + 1, power_of_two(64));
  EXPECT_EQ(exact(Number(true)), 1);
  EXPECT_EQ(static_cast<double>(Number(0.1f)), double(0.1f));
  EXPECT_EQ(static_cast<double>(Number(5e-324)), 5e-324);
  EXPECT_EQ(static_cast<double>(Number(infinity)), infinity);
  EXPECT_FALSE(isfinite(Number(infinity)));
  const Number none = std::numeric_limits<Number>::quiet_NaN();
  EXPECT_FALSE(none == none || none < 1 || none >= 1 || isfinite(none));
  EXPECT_TRUE(isfinite(Number(1e300) * Number(1e300)));
  EXPECT_GT((std::numeric_limits<Number>::min)(), 0);
  EXPECT_EQ((std::numeric_limits<Number>::min)() / ldexp(Number(1), digits + 1), 0);
  EXPECT_TRUE(isfinite((std::numeric_limits<Number>::max)()));
  EXPECT_FALSE(isfinite((std::numeric_limits<Number>::max)() * 2));
  // The nearest numbers to one are a unit away.
  const Number unit = std::numeric_limits<Number>::epsilon();
  EXPECT_NE(1 + unit, Number(1));
  EXPECT_EQ(1 + unit / 2, Number(1));
  const IT::Decimal_float<309> longer = IT::Decimal_float<309>(unit) + 1;
  EXPECT_EQ(Number(longer), 1 + unit);
  EXPECT_EQ(IT::Decimal_float<309>(1 + unit), longer);
}

} // namespace Test_decimal_float
