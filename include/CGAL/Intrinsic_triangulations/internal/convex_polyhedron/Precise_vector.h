// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CONVEX_POLYHEDRON_PRECISE_VECTOR_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CONVEX_POLYHEDRON_PRECISE_VECTOR_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Double_double.h>

#include <CGAL/enum.h>

namespace CGAL::Intrinsic_triangulations::internal {

// Represents a vector in space with twice the digits of `double`.
struct Precise_vector
{
  Double_double x, y, z;

  friend Precise_vector operator+(const Precise_vector& a, const Precise_vector& b)
  {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
  }
  friend Precise_vector operator-(const Precise_vector& a, const Precise_vector& b)
  {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
  }
  friend Precise_vector operator*(const Double_double& s, const Precise_vector& a)
  {
    return {s * a.x, s * a.y, s * a.z};
  }
  friend Double_double operator*(const Precise_vector& a, const Precise_vector& b)
  {
    return a.x * b.x + a.y * b.y + a.z * b.z;
  }
  friend Precise_vector cross(const Precise_vector& a, const Precise_vector& b)
  {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
  }
};

// Returns the orientation of four points, or COPLANAR if it may be an effect of relative errors
// `error` of products of coordinates.
inline Orientation orientation(const Precise_vector& a, const Precise_vector& b,
                               const Precise_vector& c, const Precise_vector& d, double error)
{
  const auto absolute = [](const Precise_vector& v) {
    return Precise_vector{abs(v.x), abs(v.y), abs(v.z)};
  };
  const Precise_vector u = b - a, v = c - a, w = d - a, p = absolute(u), q = absolute(v),
                       r = absolute(w);
  const Precise_vector products{p.y * q.z + p.z * q.y, p.z * q.x + p.x * q.z,
                                p.x * q.y + p.y * q.x};
  const Double_double determinant = cross(u, v) * w, bound = error * (products * r);
  return determinant > bound ? POSITIVE : determinant < -bound ? NEGATIVE : COPLANAR;
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CONVEX_POLYHEDRON_PRECISE_VECTOR_H
