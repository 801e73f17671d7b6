// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SUBDIVISION_PLACE_COMPARISON_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SUBDIVISION_PLACE_COMPARISON_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Intrinsic_triangulations/Correspondence.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/Ideal_development.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/Rational_interval.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/Root_tower.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/Uncertain.h>
#include <CGAL/enum.h>

#include <cstddef>
#include <optional>

namespace CGAL::Discrete_conformal_maps::internal {

using Intrinsic_triangulations::Correspondence;
using Intrinsic_triangulations::Delta_complex;
using Intrinsic_triangulations::Edge_index;
using Intrinsic_triangulations::Halfedge_index;
using Intrinsic_triangulations::opposite;
using Intrinsic_triangulations::Side;
using Intrinsic_triangulations::internal::Filter_interval;
using Intrinsic_triangulations::internal::Rational_interval;

// The complex plane, with intervals for coordinates.
template <typename Interval>
class Interval_plane
{
public:
  typedef Interval FT;

  struct Point
  {
    FT x, y;

    friend Point operator+(const Point& a, const Point& b) { return {a.x + b.x, a.y + b.y}; }
    friend Point operator-(const Point& a, const Point& b) { return {a.x - b.x, a.y - b.y}; }
    friend Point operator*(const Point& a, const Point& b)
    {
      return {a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x};
    }
  };

  // x + i scale sqrt(square)
  static Point point(const FT& x, const FT& scale = FT(0), const FT& square = FT(0))
  {
    return {x, scale * sqrt(square)};
  }

  // the sign of p Im a - q Im b, if Im a and Im b are certainly positive
  static Uncertain<Sign> compare(const FT& p, const Point& a, const FT& q, const Point& b)
  {
    return certainly(sign(a.y) == POSITIVE) && certainly(sign(b.y) == POSITIVE)
             ? sign(p * a.y - q * b.y)
             : Uncertain<Sign>::indeterminate();
  }
};

// The complex plane over a field that has those square roots that were asked for.
class Root_plane
{
  typedef Intrinsic_triangulations::internal::Root_tower<Exact_rational> Tower;

public:
  typedef Exact_rational FT;
  typedef Intrinsic_triangulations::internal::Root_complex<FT> Point;

  Root_plane() = default;
  Root_plane(const Root_plane&) = delete; // points refer to it

  // \throws Numerical_error if there are too many roots, or `square` is negative
  Point point(const FT& x, const FT& scale = FT(0), const FT& square = FT(0))
  {
    const auto root = square < 0 ? std::nullopt : m_tower.root(square);
    if(!root)
      throw Intrinsic_triangulations::Numerical_error("the height of a face has no exact number");
    return {&m_tower, {x}, m_tower.product(*root, {scale})};
  }

  // indeterminate if the line through both points says nothing about its place on the edge
  Uncertain<Sign> compare(const FT& p, const Point& a, const FT& q, const Point& b) const
  {
    const Sign sign_a = m_tower.sign(a.y), sign_b = m_tower.sign(b.y);
    if(sign_a == NEGATIVE || sign_b == NEGATIVE || (sign_a == ZERO && sign_b == ZERO))
      return Uncertain<Sign>::indeterminate();
    return m_tower.sign(
      Tower::sum(m_tower.product(a.y, {p}), Tower::negative(m_tower.product(b.y, {q}))));
  }

private:
  // An equality takes a time that grows more than exponentially with the number of roots.
  static constexpr std::size_t maximum_number_of_roots = 8;

  Tower m_tower{maximum_number_of_roots};
};

// Compares the places of crossings with edges of T^A along an edge of T^B with other places. The
// lengths of T^A are taken as exact: the faces that an edge of T^B passes are laid out in a plane in
// which the crossed edge of T^A has the ends 0 and 1. The heights of the ends of the edge of T^B
// over it are in the ratio in which it is divided.
template <typename Plane>
class Place_comparison
{
  typedef typename Plane::FT FT;
  typedef typename Plane::Point Point;

public:
  explicit Place_comparison(const Correspondence<>& ab) : m_ab(ab) {}

  // the sign of the place of crossing `p` on the halfedge `h` of T^B, minus `t`
  Uncertain<Sign> operator()(Halfedge_index h, std::size_t p, const FT& t) const
  {
    const auto entrance = [&](std::size_t m) {
      return m_ab.crossing(Side::intrinsic, h, static_cast<Delta_complex::size_type>(m))
        .across.halfedge;
    };
    const std::size_t n = m_ab.number_of_crossings(Side::intrinsic, Edge_index(h));
    Plane plane;
    const Point source = end_of_strip(
      plane, opposite(entrance(p)), [&](std::size_t m) { return entrance(p - m); }, p);
    const Point target = end_of_strip(
      plane, entrance(p), [&](std::size_t m) { return opposite(entrance(p + m)); }, n - 1 - p);
    return plane.compare(1 - t, source, t, target);
  }

private:
  // The end of a strip of `n` + 1 faces that starts in the face of `base`, whose ends are 0 and 1,
  // and goes on through exit(1), ..., exit(n).
  template <typename Exit>
  Point end_of_strip(Plane& plane, Halfedge_index base, const Exit& exit, std::size_t n) const
  {
    const Delta_complex& mesh = m_ab.mesh(Side::input);
    Point s = plane.point(FT(0)), t = plane.point(FT(1));
    for(std::size_t m = 1;; ++m) {
      const Point apex = s + (t - s) * this->apex(plane, base);
      if(m > n)
        return apex;
      (exit(m) == mesh.next(base) ? s : t) = apex;
      base = opposite(exit(m));
    }
  }

  // where the third corner of the face of `base` is if its ends are 0 and 1
  Point apex(Plane& plane, Halfedge_index base) const
  {
    const Delta_complex& mesh = m_ab.mesh(Side::input);
    const auto length = [&](Halfedge_index h) {
      return FT(m_ab.triangulation().input_length(mesh.edge(h)));
    };
    const FT c = length(base), a = length(mesh.next(base)), b = length(mesh.prev(base));
    const FT scale = 1 / (2 * c * c);
    return plane.point((c * c + (b - a) * (b + a)) * scale, scale,
                       (a + b + c) * (a + b - c) * (b + c - a) * (c + a - b));
  }

  const Correspondence<>& m_ab;
};

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SUBDIVISION_PLACE_COMPARISON_H
