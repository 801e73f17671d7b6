// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GEODESICS_VIEW_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GEODESICS_VIEW_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Flat_face.h>
#include <CGAL/Intrinsic_triangulations/tolerances.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <complex>
#include <cstdint>
#include <limits>

namespace CGAL::Intrinsic_triangulations::internal {

// Describes where a view enters the face on the side of the origin. It enters through the side
// before its `edge`, at the opposite corner, through the side after it, or inside of the face.
// Views of the first three kinds lie side by side on `edge` in this order.
enum class Entry : std::uint8_t
{
  before,
  corner,
  after,
  inside
};

// Represents the view of an origin through a part of an edge. The face of the side `edge`, which
// defines the frame, is on the side of the origin. The rays from a vertex or a point start at its
// position. Rays from the interior of a segment are parallel (Bommes and Kobbelt 2007).
template <typename FT>
struct View
{
  typedef std::uint32_t Index;
  typedef std::complex<FT> Vector;
  static constexpr Index null = (std::numeric_limits<Index>::max)();

  Vector position; // of the origin; the unit vector against the rays if they are parallel
  FT begin, end;
  FT before; // the length of the path to the origin, or by parallel rays to the start of `edge`
  Index edge;
  Index origin; // a vertex, or the number of vertices plus the index of a source
  Index parent; // the view before it; null if it was opened at the origin
  bool is_parallel = false;
  Entry entry = Entry::inside;

  // Empties the part of the edge, for coordinates of any size.
  void close() { end = -std::numeric_limits<FT>::infinity(); }

  // Returns the length of the path to the point `z`.
  FT length_to(const Vector& z) const
  {
    return is_parallel ? (std::max)(FT(before - dot(z, position)), FT(0))
                       : FT(before + norm_of(z - position));
  }

  // Returns the derivative of the length of the path to the point of the edge at `x`.
  FT slope(const FT& x) const
  {
    return is_parallel ? FT(-position.real()) : FT((x - position.real()) / norm_of(x - position));
  }

  // Returns the length of the shortest path to the part of the edge.
  FT least_length() const
  {
    return length_to(is_parallel ? (position.real() > 0 ? end : begin)
                                 : std::clamp(position.real(), begin, end));
  }

  // Returns the position at which the line from the origin to the point `z` beyond the edge crosses
  // the edge. Rays along the edge cross it at infinity.
  FT crossing(const Vector& z) const
  {
    const Vector& p = position;
    if(is_parallel)
      return z.imag() == 0 ? z.real() : FT(z.real() - p.real() * (z.imag() / p.imag()));
    const FT height = p.imag() - z.imag();
    return height > 0 ? p.real() + (z.real() - p.real()) * (p.imag() / height) : z.real();
  }

  // Returns whether `z`, beyond the edge or on it, is visible.
  bool sees(const Vector& z, const FT& tolerance) const
  {
    const FT x = crossing(z);
    return begin - tolerance <= x && x <= end + tolerance;
  }

  // Returns the size of the frame, to which its rounding errors are proportional.
  FT scale() const { return is_parallel ? CGAL::abs(before) : extent(); }

  // Returns the position at which the ray through the point of the edge at `x` meets the side from
  // 0 to `apex`. It is from 0 to 1. Nearly equal products are not subtracted. If all points are on
  // one line, the ray meets it in that point.
  FT hit(const FT& x, const Vector& apex) const { return hit(position, x, apex); }

  // Returns the position on the side from `apex` to the end of the edge, whose length is `l`.
  FT hit_beyond(const FT& x, const Vector& apex, const FT& l) const
  {
    const Vector p(is_parallel ? FT(-position.real()) : FT(l - position.real()), position.imag());
    return 1 - hit(p, l - x, Vector(l - apex.real(), apex.imag()));
  }

  // Cuts off the part in which all paths are longer than paths by one of the ends of the edge,
  // whose length is `l`. Returns whether a part remains.
  bool cut_off(const FT& to_source, const FT& to_target, const FT& l)
  {
    return is_parallel ? cut_off_parallel(to_source, to_target, l)
                       : cut_off_point(to_source - before, to_target - before, l);
  }

private:
  FT extent() const { return CGAL::abs(position.real()) + CGAL::abs(position.imag()); }

  FT hit(const Vector& p, const FT& x, const Vector& apex) const
  {
    const FT to_source = p.imag() * x;
    const FT to_both =
      p.imag() * apex.real() + apex.imag() * (is_parallel ? FT(-p.real()) : FT(x - p.real()));
    if(to_both > 0)
      return (std::min)(FT(to_source / to_both), FT(1));
    return apex.real() > x ? FT(x / apex.real()) : FT(1);
  }

  bool cut_off_point(const FT& by_source, const FT& by_target, const FT& length)
  {
    const FT slack = path_tolerance<FT>() * (before + extent() + length);
    const FT rest = cut_off(position, by_source + slack, begin, end);
    if(!(rest <= end))
      return false;
    const Vector from_target(length - position.real(), position.imag());
    const FT other = cut_off(from_target, by_target + slack, FT(length - end), length - rest);
    begin = rest;
    if(other > length - end)
      end = length - other;
    return begin <= end;
  }

  // Compares paths from `p` with paths that have the length `before` at 0 and follow the edge. The
  // difference of lengths decreases. Returns the position, from `begin` to `end`, up to which paths
  // from `p` are longer by more than `slack`. A position beyond `end` stands for all.
  static FT cut_off(const Vector& p, const FT& before, const FT& begin, const FT& end)
  {
    const auto is_longer = [&](const FT& x) {
      const FT along = before + x;
      return along < 0 || std::norm(p - x) > along * along;
    };
    if(!is_longer(begin))
      return begin;
    if(is_longer(end))
      return std::numeric_limits<FT>::infinity();
    const FT x = (std::norm(p) - before * before) / (2 * (p.real() + before));
    const FT safe = x - path_tolerance<FT>() * norm_of(p);
    return begin < safe && safe < end && is_longer(safe) ? safe : begin;
  }

  // Cuts off a part for parallel paths, whose lengths are linear along the edge. A quotient 0 / 0
  // cuts off nothing.
  bool cut_off_parallel(const FT& to_source, const FT& to_target, const FT& length)
  {
    const FT slack = path_tolerance<FT>() * (CGAL::abs(before) + length);
    begin = (std::max)(begin, FT((before - to_source - slack) / (1 + position.real())));
    end = (std::min)(end, FT((to_target + length + slack - before) / (1 - position.real())));
    return begin <= end;
  }
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GEODESICS_VIEW_H
