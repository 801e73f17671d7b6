// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GEODESICS_SECTOR_IN_FACE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GEODESICS_SECTOR_IN_FACE_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Edge_point.h>
#include <CGAL/Intrinsic_triangulations/Flat_face.h>
#include <CGAL/Intrinsic_triangulations/angles.h>
#include <CGAL/Intrinsic_triangulations/tolerances.h>

#include <algorithm>
#include <complex>
#include <cstddef>
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

  // Returns the visible part of side `s`, from 0 to 1. The second number is not greater than the
  // first if nothing is visible.
  // \pre the point is not on this side
  std::pair<FT, FT> part_of_side(const Flat_face<FT>& face, std::size_t s) const
  {
    const Vector a = face.to_corner(s, at.second), b = face.to_corner((s + 1) % 3, at.second);
    const FT angle = std::arg(b * std::conj(a));
    for(int turn = 0; turn < 2; ++turn) {
      const FT at_a = first + std::arg(a * std::conj(start)) + 2 * turn * pi<FT>();
      if(begin < at_a + angle && at_a < end)
        return {begin > at_a ? hit(a, b, begin) : FT(0),
                end < at_a + angle ? hit(a, b, end) : FT(1)};
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

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GEODESICS_SECTOR_IN_FACE_H
