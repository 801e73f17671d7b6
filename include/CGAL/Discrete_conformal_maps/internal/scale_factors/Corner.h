// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_CORNER_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_CORNER_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Wide_number.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/number_types.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>

namespace CGAL::Discrete_conformal_maps::internal {

// Returns the exponent of two that is just above `x`.
template <typename FT>
int exponent_of(const FT& x)
{
  using std::frexp;
  int result = 0;
  (void)frexp(x, &result);
  return result;
}
inline int exponent_of(const Double_double& x) { return exponent_of(x.high()); }

// Stores the cosine and the sine of an angle, up to a common factor.
template <typename FT>
struct Corner
{
  FT cosine, sine;

  FT angle() const
  {
    using std::atan2;
    return atan2(sine, cosine);
  }

  // Returns the corner, scaled by a power of two so that the greater of both is from 1/2 to 1.
  // Returns NaN if both are zero.
  Corner scaled() const
  {
    const FT size = (std::max)(cosine < 0 ? FT(-cosine) : cosine, sine < 0 ? FT(-sine) : sine);
    if(!(size > 0))
      return {cosine / size, sine / size};
    using std::ldexp;
    const int exponent = exponent_of(size);
    return {ldexp(cosine, -exponent), ldexp(sine, -exponent)};
  }

  // Returns the angle in double precision.
  double rounded_angle() const
  {
    const Corner unit = scaled();
    return std::atan2(static_cast<double>(unit.sine), static_cast<double>(unit.cosine));
  }

  // Returns the corner of the sum of both angles.
  friend Corner operator*(const Corner& a, const Corner& b)
  {
    return {a.cosine * b.cosine - a.sine * b.sine, a.cosine * b.sine + a.sine * b.cosine};
  }
};

// Stores the excess of 2 pi over an angle and the angles that are subtracted from it. It has as
// many digits as `double`, even if it is small.
template <typename FT>
class Angle_difference
{
public:
  explicit Angle_difference(const FT& angle)
    : m_rest(2 * CGAL_PI - static_cast<double>(angle)), m_turned{FT(1), FT(0)}
  {
    using std::cos;
    using std::sin;
    if(angle != 0)
      m_turned = {cos(angle), sin(angle)};
  }

  // Returns the data of a corner that are needed besides the corner itself.
  static double rounded_angle(const Corner<FT>& corner) { return corner.rounded_angle(); }

  // Subtracts an angle. Complex numbers are multiplied, which takes much less time than an inverse
  // tangent of high precision.
  void subtract(const Corner<FT>& corner, double rounded_angle)
  {
    m_rest -= rounded_angle;
    m_turned = (m_turned * corner).scaled();
  }

  void subtract_half_turn()
  {
    m_rest -= CGAL_PI;
    m_turned = {-m_turned.cosine, -m_turned.sine};
  }

  // Adds the excess of pi over the angle.
  void add_supplement(const Corner<FT>& corner, double rounded_angle)
  {
    m_rest += CGAL_PI - rounded_angle;
    m_turned = (m_turned * Corner<FT>{-corner.cosine, -corner.sine}).scaled();
  }

  double value() const
  {
    const double rest = -m_turned.rounded_angle();
    return rest + 2 * CGAL_PI * std::round((m_rest - rest) / (2 * CGAL_PI));
  }

private:
  double m_rest;       // the difference with few digits
  Corner<FT> m_turned; // the sum of all angles, up to full turns
};

// For `double`, `atan2` is cheap: angles are summed directly.
template <>
class Angle_difference<double>
{
public:
  explicit Angle_difference(double angle) : m_angle(angle), m_rest(2 * CGAL_PI) {}

  static double rounded_angle(const Corner<double>& corner) { return corner.angle(); }

  void subtract(const Corner<double>& /* corner */, double angle) { m_rest -= angle; }
  void subtract_half_turn() { m_rest -= CGAL_PI; }
  void add_supplement(const Corner<double>& /* corner */, double angle)
  {
    m_rest += CGAL_PI - angle;
  }

  double value() const { return m_rest - m_angle; }

private:
  double m_angle, m_rest;
};

// Angles need no separate exponents: both sides of a corner have the same.
template <typename Mantissa>
class Angle_difference<Wide_number<Mantissa>> : public Angle_difference<Mantissa>
{
  typedef Angle_difference<Mantissa> Base;
  typedef Wide_number<Mantissa> FT;

public:
  explicit Angle_difference(const FT& angle) : Base(angle.in_range_of_mantissa()) {}

  static double rounded_angle(const Corner<FT>& corner)
  {
    return Base::rounded_angle(without_exponent(corner));
  }

  void subtract(const Corner<FT>& corner, double rounded_angle)
  {
    Base::subtract(without_exponent(corner), rounded_angle);
  }
  void add_supplement(const Corner<FT>& corner, double rounded_angle)
  {
    Base::add_supplement(without_exponent(corner), rounded_angle);
  }

private:
  static Corner<Mantissa> without_exponent(const Corner<FT>& corner)
  {
    const auto [cosine, sine] = in_common_unit(corner.cosine, corner.sine);
    return {cosine, sine};
  }
};

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_CORNER_H
