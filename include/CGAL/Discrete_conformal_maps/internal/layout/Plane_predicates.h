// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_LAYOUT_PLANE_PREDICATES_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_LAYOUT_PLANE_PREDICATES_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/internal/scale_factors/number_types.h>
#include <CGAL/Intrinsic_triangulations/exact_numbers.h>

#ifdef CGAL_USE_MPFR
#include <mpfr.h>
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <type_traits>

namespace CGAL::Discrete_conformal_maps::internal {

// Evaluates exact predicates on points with coordinates of type `double` or `Double_double`. A
// filter comes first, and exact numbers follow if it fails. A point that is not finite is on every
// line, circle and plane.
template <typename FT>
class Plane_predicates
{
public:
  typedef std::array<FT, 2> Point;
  typedef Intrinsic_triangulations::Exact_ring Exact_ring;

  // Returns 1 if `p`, `q`, `r` turn left, 0 if they are collinear, and -1 if they turn right.
  int orientation(const Point& p, const Point& q, const Point& r) const
  {
    const FT unit = std::numeric_limits<FT>::epsilon();
    const Row<FT> a = row<FT>(q, p), b = row<FT>(r, p);
    const FT bound = 4 * unit * crossed_sizes(a, b);
    if(const FT det = cross(a, b); is_certain(det, bound))
      return sign_of(det);
    if(!are_finite(p, q, r))
      return 0;
    return sign_of(cross(row<Exact_ring>(q, p), row<Exact_ring>(r, p)));
  }

  // Returns 1 if `s` is inside the circle through `p`, `q`, `r`, provided that these points turn
  // left.
  int in_circle(const Point& p, const Point& q, const Point& r, const Point& s) const
  {
    return sign_of_determinant(p, q, r, s);
  }

  // Returns 1 if `p`, `q`, `r` turn left as seen from `s` in space.
  int orientation(const std::array<FT, 3>& p, const std::array<FT, 3>& q,
                  const std::array<FT, 3>& r, const std::array<FT, 3>& s) const
  {
    return sign_of_determinant(p, q, r, s);
  }

private:
  template <typename T>
  struct Row
  {
    T x, y, z;
  };

  static Exact_ring exact(double x) { return x; }
  static Exact_ring exact(const Double_double& x)
  {
    return Exact_ring(x.high()) + Exact_ring(x.low());
  }

  // Converts a number, which is an integer times a power of two, without rounding.
  template <typename Number>
  static Exact_ring exact(const Number& x)
  {
    if(x == 0)
      return 0;
    int exponent = 0;
    const Number fraction = frexp(x, &exponent);
    constexpr int digits = std::numeric_limits<Number>::digits;
    const Exact_ring size = positive_integer(Number(ldexp(abs_of(fraction), digits)));
    return (x > 0 ? size : -size) * power_of_two(exponent - digits);
  }

  template <typename Number>
  static Exact_ring positive_integer(Number x)
  {
#if defined(CGAL_HAS_MPZF) && defined(CGAL_USE_MPFR)
    Gmpz integer;
    mpfr_get_z(integer.mpz(), x.value(), MPFR_RNDZ);
    return Exact_ring(integer);
#else // sums numbers of type `double`
    Exact_ring result = 0;
    while(x != 0) {
      int exponent = 0;
      const double leading = static_cast<double>(Number(frexp(x, &exponent)));
      result += Exact_ring(leading) * power_of_two(exponent);
      x -= ldexp(Number(leading), exponent);
    }
    return result;
#endif
  }

  static Exact_ring power_of_two(int exponent)
  {
    constexpr int step = 1000;
    Exact_ring result = 1;
    for(; exponent > step; exponent -= step)
      result *= std::ldexp(1., step);
    for(; exponent < -step; exponent += step)
      result *= std::ldexp(1., -step);
    return result * std::ldexp(1., exponent);
  }

  template <typename T>
  static T difference(const FT& x, const FT& y)
  {
    if constexpr(std::is_same<T, FT>::value)
      return x - y;
    else
      return exact(x) - exact(y);
  }

  template <typename T>
  static Row<T> row(const std::array<FT, 3>& p, const std::array<FT, 3>& origin)
  {
    return {difference<T>(p[0], origin[0]), difference<T>(p[1], origin[1]),
            difference<T>(p[2], origin[2])};
  }

  // Returns the row of a determinant for a point of the plane that is lifted to a paraboloid.
  template <typename T>
  static Row<T> row(const Point& p, const Point& origin)
  {
    const T x = difference<T>(p[0], origin[0]), y = difference<T>(p[1], origin[1]);
    return {x, y, x * x + y * y};
  }

  template <typename T>
  static T cross(const Row<T>& a, const Row<T>& b)
  {
    return a.x * b.y - a.y * b.x;
  }

  static FT crossed_sizes(const Row<FT>& a, const Row<FT>& b)
  {
    return abs_of(a.x * b.y) + abs_of(a.y * b.x);
  }

  template <typename Number>
  static Number abs_of(const Number& x)
  {
    return x < 0 ? Number(-x) : x;
  }

  template <typename T>
  static int sign_of(const T& x)
  {
    return x > 0 ? 1 : x < 0 ? -1 : 0;
  }

  // Returns whether the sign of a determinant is certain. It is not if a product may have
  // underflowed.
  static bool is_certain(const FT& det, const FT& bound)
  {
    const FT least = (std::numeric_limits<FT>::min)() / std::numeric_limits<FT>::epsilon();
    return abs_of(det) > bound && abs_of(det) > least;
  }

  template <typename... Points>
  static bool are_finite(const Points&... point)
  {
    const auto is_finite = [](const auto& p) {
      return std::all_of(p.begin(), p.end(), [](const FT& x) { return x - x == 0; });
    };
    return (is_finite(point) && ...);
  }

  // Returns whether four points of the plane are two pairs of mirror images, and hence cocircular.
  // The double of a disk has many such ties, for which exact numbers are slow.
  template <typename Coordinates>
  static bool is_trapezoid(const Coordinates& p, const Coordinates& q, const Coordinates& r,
                           const Coordinates& s)
  {
    if constexpr(std::is_same<Coordinates, Point>::value) {
      const auto is_mirrored = [](const Point& a, const Point& b) {
        return a[0] == b[0] && a[1] == -b[1];
      };
      return (is_mirrored(p, q) && is_mirrored(r, s)) || (is_mirrored(p, r) && is_mirrored(q, s)) ||
             (is_mirrored(p, s) && is_mirrored(q, r));
    }
    return false;
  }

  template <typename T>
  static T determinant(const Row<T>& a, const Row<T>& b, const Row<T>& c)
  {
    return a.z * cross(b, c) + b.z * cross(c, a) + c.z * cross(a, b);
  }

  template <typename Coordinates>
  static int sign_of_determinant(const Coordinates& p, const Coordinates& q, const Coordinates& r,
                                 const Coordinates& s)
  {
    const FT unit = std::numeric_limits<FT>::epsilon();
    const Row<FT> a = row<FT>(p, s), b = row<FT>(q, s), c = row<FT>(r, s);
    const FT bound = 16 * unit *
                     (abs_of(a.z) * crossed_sizes(b, c) + abs_of(b.z) * crossed_sizes(c, a) +
                      abs_of(c.z) * crossed_sizes(a, b));
    if(const FT det = determinant(a, b, c); is_certain(det, bound))
      return sign_of(det);
    if(!are_finite(p, q, r, s) || is_trapezoid(p, q, r, s))
      return 0;
    return sign_of(
      determinant(row<Exact_ring>(p, s), row<Exact_ring>(q, s), row<Exact_ring>(r, s)));
  }
};

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_LAYOUT_PLANE_PREDICATES_H
