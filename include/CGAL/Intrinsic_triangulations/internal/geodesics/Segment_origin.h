// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GEODESICS_SEGMENT_ORIGIN_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GEODESICS_SEGMENT_ORIGIN_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Edge_point.h>
#include <CGAL/Intrinsic_triangulations/Flat_face.h>
#include <CGAL/Intrinsic_triangulations/Surface_curve.h>
#include <CGAL/Intrinsic_triangulations/angles.h>
#include <CGAL/Intrinsic_triangulations/internal/geodesics/View.h>
#include <CGAL/Intrinsic_triangulations/tolerances.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace CGAL::Intrinsic_triangulations::internal {

// Stores directions around a point that are in one face, from `begin` to `end`. They are angles on
// the surface, counterclockwise, with `start`, a direction in the face, at `first`.
template <typename FT>
struct Sector_in_face
{
  typedef std::complex<FT> Vector;

  Face_location<FT> at;
  Vector start;
  FT first, begin, end;

  // Removes the directions that make less than a right angle with the direction at `middle`.
  void exclude(const FT& middle)
  {
    const FT right = pi<FT>() / 2;
    if(middle - right <= begin)
      begin = (std::max)(begin, FT(middle + right));
    else if(middle + right >= end)
      end = (std::min)(end, FT(middle - right));
  }

  // Widens the sector, so that no gap is between the rays from a point and the parallel rays beside
  // them. A gap not wider than rounding errors is kept: the segments on both sides are one line.
  void widen()
  {
    const bool is_empty = end - begin <= rounding_unit<FT>();
    begin -= is_empty ? FT(0) : path_tolerance<FT>();
    end += is_empty ? FT(begin - end) : path_tolerance<FT>();
  }

  // Returns the visible part of side `s` with the length `l`. The second number is not greater than
  // the first if nothing is visible. Near a side, a rounding error of a position on it is a large
  // error of the direction. The part is therefore widened, and leaves no gap beside parallel rays.
  // \pre the point is not on this side
  std::pair<FT, FT> part_of_side(const Flat_face<FT>& face, std::size_t s, const FT& l) const
  {
    const Vector a = face.to_corner(s, at.second), b = face.to_corner((s + 1) % 3, at.second);
    // The angle is -pi if rounding moves the point across the side.
    const FT angle = CGAL::abs(std::arg(b * std::conj(a)));
    const FT error = path_tolerance<FT>() * (l + norm_of(a));
    for(int turn = 0; turn < 2; ++turn) {
      const FT at_a = first + std::arg(a * std::conj(start)) + 2 * turn * pi<FT>();
      if(begin < end && begin < at_a + angle && at_a < end)
        return {begin > at_a ? (std::max)(FT(0), FT(hit(a, b, begin) * l - error)) : FT(0),
                end < at_a + angle ? (std::min)(l, FT(hit(a, b, end) * l + error)) : l};
    }
    return {FT(0), FT(0)};
  }

private:
  // Returns the position at which the ray in the direction at `angle` meets the side from `a` to
  // `b`.
  FT hit(const Vector& a, const Vector& b, const FT& angle) const
  {
    const Vector d = start * std::polar(FT(1), FT(angle - first));
    const FT to_a = (std::max)(cross(a, d), FT(0)), to_b = (std::max)(cross(d, b), FT(0));
    return to_a + to_b > 0 ? FT(to_a / (to_a + to_b)) : FT(0);
  }
};

// Represents a segment, or a point with two equal ends, in one face.
template <typename FT>
struct Segment_origin
{
  typedef std::uint32_t Index;
  typedef std::complex<FT> Vector;

  Curve_segment<FT> segment;
  std::size_t number; // of the source
  Index first;        // the origin of the same point in the first of its faces

  bool is_point() const { return segment.source == segment.target; }

  Face_location<FT> source() const { return {segment.face, segment.source}; }

  // Returns the point of the segment that is nearest to a point of the face.
  Face_location<FT> nearest(const Flat_face<FT>& face, const std::array<FT, 3>& q) const
  {
    return at(face.between(segment.source, q), face);
  }

  // Returns the point from which a parallel ray reaches `z`, in the frame of side `s`.
  Face_location<FT> foot(const Flat_face<FT>& face, std::size_t s, const Vector& z) const
  {
    return at(z * face.direction(s) + face.to_corner(s, segment.source), face);
  }

  // Returns the view through side `s`, whose length is `l`, by the parallel rays that leave the
  // face through this side. It may be empty.
  View<FT> view(const Flat_face<FT>& face, std::size_t s, const FT& l, Index edge,
                Index origin) const
  {
    const Vector to_frame = std::conj(face.direction(s));
    const Vector p = -face.to_corner(s, segment.source) * to_frame,
                 q = -face.to_corner(s, segment.target) * to_frame,
                 t = normalized(along(face) * to_frame);
    const Vector back = t.real() < 0 ? Vector(t.imag(), -t.real()) : Vector(-t.imag(), t.real());
    View<FT> result{back, FT(0), l, dot(p, back), edge, origin, View<FT>::null, true};
    if(!(back.imag() > 0)) {
      result.end = FT(-1);
      return result;
    }
    const FT a = result.crossing(p), b = result.crossing(q);
    result.begin = (std::max)(FT(0), (std::min)(a, b));
    result.end = (std::min)(l, (std::max)(a, b));
    return result;
  }

  Vector along(const Flat_face<FT>& face) const
  {
    return face.between(segment.source, segment.target);
  }

private:
  // Returns the point of the segment that is nearest to the point at `v` from the start.
  Face_location<FT> at(const Vector& v, const Flat_face<FT>& face) const
  {
    const Vector d = along(face);
    const FT squared = dot(d, d);
    const FT t = squared > 0 ? std::clamp<FT>(dot(v, d) / squared, FT(0), FT(1)) : FT(0);
    std::array<FT, 3> place;
    for(std::size_t k = 0; k < 3; ++k)
      place[k] = (1 - t) * segment.source[k] + t * segment.target[k];
    return {segment.face, place};
  }
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GEODESICS_SEGMENT_ORIGIN_H
