// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_CIRCLE_PACKING_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_CIRCLE_PACKING_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Delta_complex.h>
#include <CGAL/Discrete_conformal_maps/Map_status.h>
#include <CGAL/Discrete_conformal_maps/Minimization.h>

#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Discrete_conformal_maps {

/// \ingroup PkgDiscreteConformalMapsCircles
/// a circle in the plane with its interior.
struct Planar_circle
{
  std::complex<double> center; ///< the center
  double radius;               ///< the radius
};

/// \ingroup PkgDiscreteConformalMapsCircles
/// a circle on the unit sphere with the cap inside it.
struct Spherical_circle
{
  std::array<double, 3> center; ///< the center of the cap, a unit vector
  double angle;                 ///< the angle between the center and the circle, less than pi
};

namespace internal {

// Returns the circle on the sphere whose stereographic image from the south pole is `circle`.
inline Spherical_circle on_sphere(const Planar_circle& circle)
{
  const auto& [c, r] = circle;
  const double power = (std::abs(c) - r) * (std::abs(c) + r);
  const std::array<double, 3> axis{2 * c.real(), 2 * c.imag(), 1 - power};
  const double length = std::hypot(axis[0], axis[1], axis[2]);
  return {{axis[0] / length, axis[1] / length, axis[2] / length}, std::atan2(2 * r, 1 + power)};
}

// Returns the distance of two circles on the sphere along the great circle through their centers:
// negative if they overlap.
inline double distance(const Spherical_circle& a, const Spherical_circle& b)
{
  const auto &p = a.center, &q = b.center;
  const double cosine = p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
  const double sine =
    std::hypot(p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]);
  return std::atan2(sine, cosine) - (a.angle + b.angle);
}

} // namespace internal

/// \ingroup PkgDiscreteConformalMapsCircles
/// circles at the vertices of a triangulated sphere or disk. Circles at the ends of an edge touch,
/// and interiors are disjoint. See `pack_circles()`.
class Circle_packing
{
public:
  /// \cond SKIP_IN_MANUAL
  Circle_packing() = default;
  Circle_packing(std::vector<Planar_circle> circles, bool is_disk, double max_tangency_error,
                 Map_status status, Minimization_result minimization)
    : m_circles(std::move(circles)),
      m_is_disk(is_disk),
      m_max_tangency_error(max_tangency_error),
      m_status(status),
      m_minimization(std::move(minimization))
  {}
  /// \endcond

  /// returns the number of circles.
  std::size_t size() const { return m_circles.size(); }

  /// returns whether the circles pack the unit disk. Otherwise they pack the sphere.
  bool is_disk() const { return m_is_disk; }

  /// returns the circle of the vertex `v` in the plane. For a sphere this is its stereographic
  /// image from the south pole, which lies between three of the circles.
  const Planar_circle& circle(Vertex_index v) const { return m_circles[v.idx()]; }

  /// returns the circle of the vertex `v` on the unit sphere. The circles of a disk are on the
  /// northern hemisphere.
  Spherical_circle spherical_circle(Vertex_index v) const { return internal::on_sphere(circle(v)); }

  /// returns the greatest difference between the distance of two centers and the sum of both radii,
  /// over all edges. On the unit sphere these are angles. In the unit disk, the distance of the
  /// center of a boundary circle from the unit circle is also compared with its radius.
  double max_tangency_error() const { return m_max_tangency_error; }

  /// returns whether circles touch within \f$10^{-10}\f$ and no face is reversed, as measured on
  /// the result; otherwise the reason.
  Map_status status() const { return m_status; }

  /// returns how the minimization has ended.
  const Minimization_result& minimization() const { return m_minimization; }

private:
  std::vector<Planar_circle> m_circles;
  bool m_is_disk = false;
  double m_max_tangency_error = 0;
  Map_status m_status = Map_status::not_converged;
  Minimization_result m_minimization;
};

} // namespace CGAL::Discrete_conformal_maps

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_CIRCLE_PACKING_H
