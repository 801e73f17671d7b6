// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_LAYOUT_PLANE_PREDICATES_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_LAYOUT_PLANE_PREDICATES_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <boost/multiprecision/cpp_int.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace CGAL::Discrete_conformal_maps::internal {

// Exact predicates on points of the plane with coordinates of any floating point type: a filter
// first, then integers.
template <typename FT>
class Plane_predicates
{
public:
  typedef std::array<FT, 2> Point;

  // 1 if `p`, `q`, `r` turn left, 0 if they are on a line
  int orientation(const Point& p, const Point& q, const Point& r) const
  {
    const FT unit = std::numeric_limits<FT>::epsilon();
    const FT a = (q[0] - p[0]) * (r[1] - p[1]), b = (q[1] - p[1]) * (r[0] - p[0]);
    const FT det = a - b, bound = 4 * unit * (abs_of(a) + abs_of(b));
    return is_certain(det, bound) ? sign_of(det) : exact_orientation(p, q, r);
  }

  // 1 if `s` is inside the circle through `p`, `q`, `r`, if these turn left
  int in_circle(const Point& p, const Point& q, const Point& r, const Point& s) const
  {
    const FT unit = std::numeric_limits<FT>::epsilon();
    const Lift<FT> a(p, s), b(q, s), c(r, s);
    const FT det = a.square * cross(b, c) + b.square * cross(c, a) + c.square * cross(a, b);
    const FT bound = 16 * unit *
                     (a.square * crossed_sizes(b, c) + b.square * crossed_sizes(c, a) +
                      c.square * crossed_sizes(a, b));
    return is_certain(det, bound) ? sign_of(det) : exact_in_circle(p, q, r, s);
  }

private:
  typedef boost::multiprecision::number<boost::multiprecision::cpp_int::backend_type,
                                        boost::multiprecision::et_off>
    Integer;

  template <typename T>
  struct Lift
  {
    template <typename Coordinates>
    Lift(const Coordinates& p, const Coordinates& origin)
      : x(T(p[0]) - T(origin[0])), y(T(p[1]) - T(origin[1])), square(x * x + y * y)
    {}
    T x, y, square;
  };

  template <typename T>
  static T cross(const Lift<T>& a, const Lift<T>& b)
  {
    return a.x * b.y - a.y * b.x;
  }

  static FT crossed_sizes(const Lift<FT>& a, const Lift<FT>& b)
  {
    return abs_of(a.x * b.y) + abs_of(a.y * b.x);
  }

  static FT abs_of(const FT& x) { return x < 0 ? FT(-x) : x; }

  template <typename T>
  static int sign_of(const T& x)
  {
    return x > 0 ? 1 : x < 0 ? -1 : 0;
  }

  // A product too small for a number is not to be trusted.
  static bool is_certain(const FT& det, const FT& bound)
  {
    const FT least = (std::numeric_limits<FT>::min)() / std::numeric_limits<FT>::epsilon();
    return abs_of(det) > bound && abs_of(det) > least;
  }

  // The coordinates, multiplied by the least power of two that makes all of them integers. Signs
  // stay.
  template <std::size_t n>
  static std::array<std::array<Integer, 2>, n> scaled(const std::array<Point, n>& points)
  {
    using std::frexp;
    using std::ldexp;
    constexpr int digits = std::numeric_limits<FT>::digits;
    int least = std::numeric_limits<int>::max(), exponent;
    for(const Point& p : points)
      for(const FT& x : p)
        if(x != 0) {
          (void)frexp(x, &exponent);
          least = (std::min)(least, exponent);
        }
    std::array<std::array<Integer, 2>, n> result;
    for(std::size_t i = 0; i < n; ++i)
      for(std::size_t c = 0; c < 2; ++c) {
        const FT mantissa = frexp(points[i][c], &exponent);
        result[i][c] = static_cast<Integer>(FT(ldexp(mantissa, digits)));
        if(points[i][c] != 0)
          result[i][c] <<= exponent - least;
      }
    return result;
  }

  static int exact_orientation(const Point& p, const Point& q, const Point& r)
  {
    const auto [a, b, c] = scaled<3>({p, q, r});
    return sign_of(cross(Lift<Integer>(b, a), Lift<Integer>(c, a)));
  }

  static int exact_in_circle(const Point& p, const Point& q, const Point& r, const Point& s)
  {
    const auto e = scaled<4>({p, q, r, s});
    const Lift<Integer> a(e[0], e[3]), b(e[1], e[3]), c(e[2], e[3]);
    return sign_of(
      Integer(a.square * cross(b, c) + b.square * cross(c, a) + c.square * cross(a, b)));
  }
};

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_LAYOUT_PLANE_PREDICATES_H
