// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GEODESICS_SEGMENT_ORIGIN_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GEODESICS_SEGMENT_ORIGIN_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Edge_point.h>
#include <CGAL/Intrinsic_triangulations/Flat_face.h>
#include <CGAL/Intrinsic_triangulations/Surface_curve.h>
#include <CGAL/Intrinsic_triangulations/internal/geodesics/View.h>

#include <algorithm>
#include <array>
#include <complex>
#include <cstddef>
#include <cstdint>

namespace CGAL::Intrinsic_triangulations::internal {

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
