// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_PLANE_VECTOR_H
#define CGAL_INTRINSIC_TRIANGULATIONS_PLANE_VECTOR_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <complex>

namespace CGAL::Intrinsic_triangulations::internal {

// Represents a vector in the plane with the product of complex numbers. `std::complex` supports
// only built-in number types.
template <typename FT>
struct Plane_vector
{
  FT x, y;

  friend Plane_vector operator+(const Plane_vector& v, const Plane_vector& w)
  {
    return {v.x + w.x, v.y + w.y};
  }
  friend Plane_vector operator-(const Plane_vector& v, const Plane_vector& w)
  {
    return {v.x - w.x, v.y - w.y};
  }
  friend Plane_vector operator-(const Plane_vector& v) { return {-v.x, -v.y}; }
  friend Plane_vector operator*(const FT& s, const Plane_vector& v) { return {s * v.x, s * v.y}; }
  friend Plane_vector operator*(const Plane_vector& v, const Plane_vector& w)
  {
    return {v.x * w.x - v.y * w.y, v.x * w.y + v.y * w.x};
  }
  friend Plane_vector conj(const Plane_vector& v) { return {v.x, -v.y}; }
  friend FT dot(const Plane_vector& v, const Plane_vector& w) { return v.x * w.x + v.y * w.y; }
  friend FT cross(const Plane_vector& v, const Plane_vector& w) { return v.x * w.y - v.y * w.x; }
  friend FT norm(const Plane_vector& v) { return v.x * v.x + v.y * v.y; }
  friend std::complex<double> to_complex(const Plane_vector& v)
  {
    return {static_cast<double>(v.x), static_cast<double>(v.y)};
  }
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_PLANE_VECTOR_H
