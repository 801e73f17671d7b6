// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_DISK_MOTION_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_DISK_MOTION_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <array>
#include <cmath>
#include <complex>
#include <cstddef>

namespace CGAL::Discrete_conformal_maps {

/// \ingroup PkgDiscreteConformalMapsHyperbolic
/// a motion of the hyperbolic plane in the Poincare disk: the Moebius transformation \f$ z \mapsto
/// (a z + b) / (\bar b z + \bar a) \f$ with \f$|a|^2 - |b|^2 = 1\f$. A matrix and its negative are
/// the same motion.
///
/// Relative errors of entries add up in products. A motion that moves the origin by the distance
/// \f$d\f$ has errors of about \f$\epsilon e^d\f$ at its image, for a rounding unit \f$\epsilon\f$.
///
/// \tparam FT_ a floating point type, of any precision
template <typename FT_ = double>
class Disk_motion
{
public:
  /// the number type.
  typedef FT_ FT;

  /// returns the identity.
  Disk_motion() : m_entry{FT(1), FT(0), FT(0), FT(0)} {}

  /// returns a motion with given entries.
  /// \pre \f$|a|^2 - |b|^2 = 1\f$, up to rounding
  Disk_motion(const FT& real_a, const FT& imaginary_a, const FT& real_b, const FT& imaginary_b)
    : m_entry{real_a, imaginary_a, real_b, imaginary_b}
  {}

  /// returns the translation along the real axis that moves the origin by \f$x\f$, to the right if
  /// \f$x > 0\f$. \param sinh the hyperbolic sine of \f$x/2\f$
  static Disk_motion translation(const FT& sinh)
  {
    using std::sqrt;
    return {sqrt(1 + sinh * sinh), FT(0), sinh, FT(0)};
  }

  /// returns the rotation around the origin by an angle, given the cosine and the sine of its half.
  static Disk_motion rotation(const FT& cosine, const FT& sine)
  {
    return {cosine, sine, FT(0), FT(0)};
  }

  /// returns the translation that moves the origin to a point \f$(x, y, t)\f$ of the hyperboloid.
  static Disk_motion translation_to(const FT& x, const FT& y, const FT& t)
  {
    using std::sqrt;
    const FT a = sqrt((t + 1) / 2);
    return {a, FT(0), x / (2 * a), y / (2 * a)};
  }

  /// returns the entries: real and imaginary part of \f$a\f$, real and imaginary part of \f$b\f$.
  const std::array<FT, 4>& entries() const { return m_entry; }

  /// returns \f$a\f$, in double precision.
  std::complex<double> a() const { return to_complex(m_entry[0], m_entry[1]); }
  /// returns \f$b\f$, in double precision.
  std::complex<double> b() const { return to_complex(m_entry[2], m_entry[3]); }

  /// returns the composition: `g` is applied first.
  Disk_motion operator*(const Disk_motion& g) const
  {
    const auto& [p, q, r, s] = m_entry;
    const auto& [t, u, v, w] = g.m_entry;
    return {p * t - q * u + r * v + s * w, p * u + q * t + s * v - r * w,
            p * v - q * w + r * t + s * u, p * w + q * v + s * t - r * u};
  }

  /// returns the inverse.
  Disk_motion inverse() const { return {m_entry[0], -m_entry[1], -m_entry[2], -m_entry[3]}; }

  /// returns the image of a point of the disk.
  std::complex<double> operator()(const std::complex<double>& z) const
  {
    return (a() * z + b()) / (std::conj(b()) * z + std::conj(a()));
  }

  /// returns the image of the origin on the hyperboloid \f$x^2 + y^2 - t^2 = -1\f$, as
  /// \f$(x, y, t)\f$.
  std::array<FT, 3> image_of_origin() const
  {
    const auto& [p, q, r, s] = m_entry;
    return {2 * (p * r - q * s), 2 * (p * s + q * r), p * p + q * q + r * r + s * s};
  }

  /// returns the greatest entry of the difference from the identity, for the matrix or its
  /// negative.
  double distance_to_identity() const
  {
    using std::abs;
    double result = static_cast<double>(abs(FT(abs(m_entry[0]) - 1)));
    for(std::size_t i = 1; i < 4; ++i) {
      const auto entry = static_cast<double>(abs(m_entry[i]));
      result = entry <= result ? result : entry; // keeps NaN
    }
    return result;
  }

private:
  static std::complex<double> to_complex(const FT& x, const FT& y)
  {
    return {static_cast<double>(x), static_cast<double>(y)};
  }

  std::array<FT, 4> m_entry;
};

} // namespace CGAL::Discrete_conformal_maps

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_DISK_MOTION_H
