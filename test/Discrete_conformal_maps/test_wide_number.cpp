// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Numbers with a separate exponent are compared with numbers of 120 digits.

#include "../Intrinsic_triangulations/testing.h"

#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Corner.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Delaunay_filter.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/number_conversion.h>

#include <boost/multiprecision/cpp_bin_float.hpp>

namespace Test_wide_number {

namespace DCM = CGAL::Discrete_conformal_maps;
using DCM::internal::converted;
using DCM::internal::Decimal_1500;
using DCM::internal::Double_double;
using DCM::internal::Wide_number;
using Big = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<120>,
                                          boost::multiprecision::et_off>;

Big big(double x) { return x; }
Big big(const Double_double& x) { return Big(x.high()) + Big(x.low()); }
template <typename Mantissa>
Big big(const Wide_number<Mantissa>& x)
{
  return ldexp(big(x.mantissa()), static_cast<int>(x.exponent()));
}

template <typename Mantissa>
class Wide_numbers : public testing::Test
{
protected:
  typedef Wide_number<Mantissa> Number;

  // Returns a number with a random sign and exponent.
  Number random_number(int range)
  {
    const double unit = std::numeric_limits<double>::epsilon();
    const Mantissa mantissa = Mantissa(m_random.get_double(0.5, 1)) +
                              Mantissa(m_random.get_double(-unit, unit)) * Mantissa(unit);
    return Number(m_random.get_bool() ? mantissa : -mantissa, m_random.get_int(-range, range + 1));
  }

  // Returns the error in units of rounding, relative to `scale`.
  static double error(const Number& x, const Big& expected, const Big& scale)
  {
    const double unit = static_cast<double>(std::numeric_limits<Mantissa>::epsilon());
    return static_cast<double>(Big(abs((big(x) - expected) / scale))) / unit;
  }
  static double error(const Number& x, const Big& expected) { return error(x, expected, expected); }

  CGAL::Random m_random{7};
};

typedef testing::Types<double, Double_double> Mantissas;
TYPED_TEST_SUITE(Wide_numbers, Mantissas);

TYPED_TEST(Wide_numbers, arithmetic_beyond_the_range_of_double)
{
  for(int i = 0; i < 1000; ++i) {
    const auto x = this->random_number(5000), y = this->random_number(5000),
               z = ldexp(this->random_number(60), int(x.exponent()));
    EXPECT_LE(this->error(x * y, big(x) * big(y)), 8);
    EXPECT_LE(this->error(x / y, big(x) / big(y)), 8);
    EXPECT_LE(this->error(x + z, big(x) + big(z), abs(big(x)) + abs(big(z))), 8);
    EXPECT_LE(this->error(x - z, big(x) - big(z), abs(big(x)) + abs(big(z))), 8);
    EXPECT_LE(this->error(sqrt(abs(x)), sqrt(abs(big(x)))), 8);
    EXPECT_EQ(x < y, big(x) < big(y));
    EXPECT_EQ(x <= z, big(x) <= big(z));
    EXPECT_EQ(x == y, big(x) == big(y));
    EXPECT_TRUE(x == x && x <= x && !(x < x));
    EXPECT_EQ(x + 0., x);
    EXPECT_EQ(x - x, 0.);
  }
}

TYPED_TEST(Wide_numbers, elementary_functions)
{
  typedef Wide_number<TypeParam> Number;
  for(int i = 0; i < 200; ++i) {
    const double power = this->m_random.get_double(-5000, 5000);
    // Errors of a power are the errors of the exponent, times the exponent.
    EXPECT_LE(this->error(exp(Number(power)), exp(Big(power))), 8 * (1 + std::abs(power)));
    const Number x = abs(this->random_number(5000));
    EXPECT_LE(this->error(log(x), log(big(x)), 1 + abs(log(big(x)))), 200);
    const Number y = ldexp(this->random_number(30), int(x.exponent()));
    EXPECT_LE(this->error(atan2(y, x), atan2(big(y), big(x))), 200);
  }
}

TYPED_TEST(Wide_numbers, zero_has_an_order_in_every_window)
{
  typedef Wide_number<TypeParam> Number;
  for(const Number& x : {exp(Number(3000.)), exp(Number(-3000.))}) {
    EXPECT_TRUE(Number(0.) < x && x > 0. && -x < 0. && Number(0.) > -x);
    EXPECT_TRUE(-x < x && x != 0. && !(Number(0.) >= x));
  }
}

TYPED_TEST(Wide_numbers, angles_of_corners_beyond_the_range_of_double)
{
  typedef Wide_number<TypeParam> Number;
  typedef DCM::internal::Corner<Number> Corner;
  const Big pi = boost::math::constants::pi<Big>();
  for(const Number& x : {exp(Number(3000.)), exp(Number(-3000.))}) {
    EXPECT_LE(this->error(Corner{0., x}.angle(), pi / 2), 200);
    EXPECT_LE(this->error(Corner{-x, 0.}.angle(), pi), 200);
    EXPECT_EQ((Corner{x, 0.}.angle()), 0.);
  }
  for(int i = 0; i < 100; ++i) {
    const double target = this->m_random.get_double(-4, 4);
    DCM::internal::Angle_difference<Number> difference{Number(target)};
    Big rest = 2 * pi - Big(target);
    for(int k = 0; k < 10; ++k) {
      const Number sine = abs(this->random_number(5000));
      const Corner corner{ldexp(this->random_number(20), int(sine.exponent())), sine};
      difference.subtract(corner, difference.rounded_angle(corner));
      rest -= atan2(big(corner.sine), big(corner.cosine));
    }
    EXPECT_NEAR(difference.value(), static_cast<double>(rest), 1e-14);
  }
}

// The filter is certain for most random edges, and never wrong: close to a tie, it fails.
TYPED_TEST(Wide_numbers, filtered_Delaunay_decisions_agree_with_many_digits)
{
  typedef DCM::internal::Delaunay_filter<TypeParam> Filter;
  const auto filtered = [](const auto& x) {
    typedef std::decay_t<decltype(x.ij)> Number;
    return DCM::internal::Delaunay_filter<Number>::is_Delaunay(x);
  };
  EXPECT_EQ(Filter::is_useful, (std::is_same_v<TypeParam, Double_double>));
  int certain = 0, close = 0;
  for(int i = 0; i < 2000; ++i) {
    const int shift = this->m_random.get_int(-5000, 5000), range = i % 4 == 0 ? 2000 : 4;
    const auto length = [&] { return ldexp(abs(this->random_number(range)), shift); };
    CGAL::Intrinsic_triangulations::Diamond<Wide_number<TypeParam>> edge{
      length(), length(), length(), length(), length()};
    Big k = big(edge.jk) * big(edge.ki), l = big(edge.il) * big(edge.lj);
    const Big outer = (big(edge.jk) * big(edge.jk) + big(edge.ki) * big(edge.ki)) / k +
                      (big(edge.il) * big(edge.il) + big(edge.lj) * big(edge.lj)) / l;
    Big square = big(edge.ij) * big(edge.ij), inner = square / k + square / l;
    const bool is_tie = i % 4 == 2;
    if(is_tie) { // this makes both sides equal, up to the rounding of a square root
      edge.ij *= Wide_number<TypeParam>(static_cast<double>(Big(sqrt(Big(outer / inner)))));
      square = big(edge.ij) * big(edge.ij), inner = square / k + square / l;
    }
    const auto decision = filtered(edge);
    if(CGAL::is_certain(decision)) {
      ++certain;
      close += is_tie ? 1 : 0;
      EXPECT_EQ(CGAL::get_certain(decision), inner <= outer);
    }
  }
  EXPECT_GE(certain, 900);
  EXPECT_EQ(close, 0);
}

TYPED_TEST(Wide_numbers, no_number_is_lost_among_infinities)
{
  typedef Wide_number<TypeParam> Number;
  const Number infinity = std::numeric_limits<Number>::infinity(), x = exp(Number(3000.));
  EXPECT_FALSE(infinity.is_finite());
  EXPECT_TRUE(x < infinity && -infinity < x);
  EXPECT_EQ(x + infinity, infinity);
  EXPECT_FALSE((infinity - infinity).is_finite());
  EXPECT_EQ(static_cast<double>(x), std::numeric_limits<double>::infinity());
  EXPECT_EQ(static_cast<double>(1 / x), 0.);
  EXPECT_FALSE(exp(Number(1e30)).is_finite());
  EXPECT_EQ(exp(Number(-1e30)), 0.);
}

TYPED_TEST(Wide_numbers, conversions_keep_what_fits)
{
  for(int i = 0; i < 100; ++i) {
    const auto x = this->random_number(5000);
    const Decimal_1500 same = converted<Decimal_1500>(x);
    EXPECT_EQ(converted<Wide_number<double>>(same), converted<Wide_number<double>>(x));
    const auto y = this->random_number(300);
    EXPECT_EQ(converted<Double_double>(converted<Decimal_1500>(y)), converted<Double_double>(y));
  }
}

} // namespace Test_wide_number
