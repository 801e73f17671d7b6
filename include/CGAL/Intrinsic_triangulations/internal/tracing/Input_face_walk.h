// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_INPUT_FACE_WALK_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_INPUT_FACE_WALK_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Correspondence.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Face_map.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Input_face_regions.h>
#include <CGAL/Intrinsic_triangulations/tolerances.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>

namespace CGAL::Intrinsic_triangulations::internal {

// Finds points of a face of T1 with vertices of T2 inside it: walks from a corner of the face
// straight to the point, through regions of faces of T2. If rounding leads to a wrong region, all
// regions are searched.
template <typename Traits>
class Input_face_walk : public Input_face_regions<Traits>
{
  typedef Input_face_regions<Traits> Base;
  typedef typename Traits::FT FT;
  typedef Barycentric_coordinates<FT> Coordinates;
  using Base::m_correspondence, Base::m_mesh;

public:
  typedef typename Base::Place Place;
  typedef typename Base::Piece Piece;
  typedef typename Base::Face_of_place Face_of_place;
  using Base::beyond, Base::for_each_place;

  explicit Input_face_walk(const Correspondence<Traits>& correspondence) : Base(correspondence) {}

  // returns the place on T2 of the point `p` of a face of T1
  Face_location<FT> operator()(const Face_location<FT>& p) const
  {
    const Place place = place_of(p);
    return {place.first, Face_of_place(place, *this).map_from(Side::input)(p.second)};
  }

  // returns the region that has the point `p` of a face of T1, up to rounding
  Place place_of(const Face_location<FT>& p) const
  {
    Place place = this->place_at_source(m_correspondence.mesh(Side::input).halfedge(p.first));
    const Place start = place;
    for(std::size_t steps = 0; steps <= m_mesh.number_of_faces(); ++steps) {
      const std::optional<Place> next = next_place(place, p.second);
      if(!next)
        break;
      place = *next;
    }
    return squared_distance(place, p.second) > CGAL::square(region_tolerance<FT>())
             ? closest_place(start, p.second)
             : place;
  }

private:
  // Returns the region beyond the piece through which the line from the first corner of the face of
  // T1 to `p` leaves the region; none if `p` is not beyond it.
  std::optional<Place> next_place(const Place& place, const Coordinates& p) const
  {
    const Face_of_place face(place, *this);
    const Coordinates start{FT(1), FT(0), FT(0)};
    std::optional<Place> result;
    FT best(0);
    for(std::size_t c = 0; c < face.region.size(); ++c) {
      const FT right = -orientation(start, p, face.corner(Side::input, c));
      const FT left = orientation(start, p, face.corner(Side::input, c + 1));
      if((std::min)(right, left) >= best && right + left > 0 &&
         orientation(face.corner(Side::input, c), face.corner(Side::input, c + 1), p) < 0) {
        best = (std::min)(right, left);
        result = beyond(face.region[c], place);
      }
    }
    return result;
  }

  // Returns the region in the face of T1 that is closest to `p`. Each is looked at once.
  Place closest_place(const Place& start, const Coordinates& p) const
  {
    std::pair<FT, Place> best(squared_distance(start, p), start);
    for_each_place(start, [&](const Place& place) {
      best = (std::min)(best, std::make_pair(squared_distance(place, p), place));
      return false;
    });
    return best.second;
  }

  // Returns the squared distance of `p` from a region, in barycentric coordinates. Pieces that are
  // so short that rounding may turn them do not determine where the inside is.
  FT squared_distance(const Place& place, const Coordinates& p) const
  {
    const Face_of_place face(place, *this);
    std::size_t long_pieces = 0;
    bool is_outside = false;
    FT least = std::numeric_limits<FT>::infinity();
    for(std::size_t c = 0; c < face.region.size(); ++c) {
      const Coordinates &a = face.corner(Side::input, c), &b = face.corner(Side::input, c + 1);
      least = (std::min)(least, internal::squared_distance(a, b, p));
      if(dot(a, b, a, b) > CGAL::square(region_tolerance<FT>())) {
        ++long_pieces;
        is_outside = is_outside || orientation(a, b, p) < 0;
      }
    }
    return long_pieces > 1 && !is_outside ? FT(0) : least;
  }
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_INPUT_FACE_WALK_H
