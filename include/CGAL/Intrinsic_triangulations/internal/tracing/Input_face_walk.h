// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_INPUT_FACE_WALK_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_INPUT_FACE_WALK_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Correspondence.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Correspondence_marks.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Face_map.h>
#include <CGAL/Intrinsic_triangulations/tolerances.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Finds points of a face of T1 with vertices of T2 inside it: walks from a corner of the face
// straight to the point, through regions of faces of T2. If rounding leads to a wrong region, all
// regions are searched.
template <typename Traits>
class Input_face_walk
{
  typedef typename Traits::FT FT;
  typedef Delta_complex::size_type size_type;
  typedef Correspondence_marks<Traits> Marks;
  typedef Barycentric_coordinates<FT> Coordinates;

public:
  // a region of a face of T2
  typedef std::pair<Face_index, std::size_t> Place;

  explicit Input_face_walk(const Correspondence<Traits>& correspondence)
    : m_correspondence(correspondence), m_mesh(correspondence.mesh(Side::intrinsic))
  {}

  // returns the place on T2 of the point `p` of a face of T1
  Face_location<FT> operator()(const Face_location<FT>& p) const
  {
    const Place place = place_of(p);
    return {place.first, Face_of_place(place, *this).map.inverse()(p.second)};
  }

  // returns the region that has the point `p` of a face of T1, up to rounding
  Place place_of(const Face_location<FT>& p) const
  {
    Place place = first_place(p.first);
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

  Region region(const Place& place) const { return regions_of(place.first)[place.second]; }

  // Calls `visit(place)` for the regions of the face of T1 in which `start` lies, once each, until
  // it returns true.
  template <typename Visit>
  void for_each_place(const Place& start, const Visit& visit) const
  {
    std::set<Place> seen{start};
    std::vector<Place> waiting{start};
    while(!waiting.empty()) {
      const Place place = waiting.back();
      waiting.pop_back();
      if(visit(place))
        return;
      const Region corners = region(place);
      for(std::size_t c = 0; c < corners.size(); ++c) {
        const std::optional<Place> neighbor = beyond(corners[c], place);
        if(neighbor && seen.insert(*neighbor).second)
          waiting.push_back(*neighbor);
      }
    }
  }

private:
  std::size_t side_of(Halfedge_index h) const { return side_number(h, m_mesh); }

  // returns the region at the source of the first side of a face of T1
  Place first_place(Face_index f) const
  {
    const Halfedge_index input = m_correspondence.mesh(Side::input).halfedge(f);
    const Halfedge_index spoke = m_correspondence.spoke_before(Side::input, input);
    const Face_regions regions = regions_of(m_mesh.face(spoke));
    const std::size_t s = side_of(spoke);
    if(m_correspondence.spoke_before(Side::intrinsic, spoke) == input &&
       m_correspondence.is_shared(Side::intrinsic, Edge_index(spoke)))
      return {m_mesh.face(spoke), regions.region_at_side(s, 0)};
    // to the left of the curve that leaves this corner
    const auto mark = m_correspondence.crossings_on_intrinsic().position(
      m_mesh.next(spoke), m_correspondence.crossing(Side::input, input, 0).id);
    return {m_mesh.face(spoke), regions.region_at_side((s + 1) % 3, mark + 1)};
  }

  Face_regions regions_of(Face_index f) const
  {
    const Marks marks(Side::intrinsic, f, m_correspondence);
    return Face_regions({marks.crossings(0), marks.crossings(1), marks.crossings(2)});
  }

  // a region with its corners on T2 and T1
  struct Face_of_place
  {
    Face_of_place(const Place& place, const Input_face_walk& walk)
      : marks(Side::intrinsic, place.first, walk.m_correspondence)
    {
      const Face_map<FT, Marks> face_map(marks, walk.m_correspondence.mesh(Side::input));
      region = face_map.regions()[place.second];
      map = face_map.region_map(place.second).second;
    }

    const Coordinates& corner(std::size_t c) const { return map.image(c == map.size() ? 0 : c); }

    Marks marks;
    Region region;
    Polygon_map<FT> map;
  };

  // returns the region beyond the piece of a side after `corner`; none beyond the face of T1
  std::optional<Place> beyond(const Region_corner& corner, const Place& place) const
  {
    const Halfedge_index o = m_mesh.opposite(sides(place.first, m_mesh)[corner.side]);
    if(corner.arc_follows || m_correspondence.is_shared(Side::intrinsic, Edge_index(o)))
      return {};
    const std::size_t piece = corner.is_vertex() ? 0 : corner.mark + 1;
    const std::size_t from_target =
      m_correspondence.number_of_crossings(Side::intrinsic, Edge_index(o)) - piece;
    return Place(m_mesh.face(o),
                 regions_of(m_mesh.face(o)).region_at_side(side_of(o), from_target));
  }

  // Returns the region beyond the piece through which the line from the first corner of the face of
  // T1 to `p` leaves the region; none if `p` is not beyond it.
  std::optional<Place> next_place(const Place& place, const Coordinates& p) const
  {
    const Face_of_place face(place, *this);
    const Coordinates start{FT(1), FT(0), FT(0)};
    std::optional<Place> result;
    FT best(0);
    for(std::size_t c = 0; c < face.region.size(); ++c) {
      const FT right = -orientation(start, p, face.corner(c));
      const FT left = orientation(start, p, face.corner(c + 1));
      if((std::min)(right, left) >= best && right + left > 0 &&
         orientation(face.corner(c), face.corner(c + 1), p) < 0) {
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
      const Coordinates &a = face.corner(c), &b = face.corner(c + 1);
      least = (std::min)(least, squared_distance(a, b, p));
      if(dot(a, b, a, b) > CGAL::square(region_tolerance<FT>())) {
        ++long_pieces;
        is_outside = is_outside || orientation(a, b, p) < 0;
      }
    }
    return long_pieces > 1 && !is_outside ? FT(0) : least;
  }

  // returns the squared distance of `p` from the piece from `a` to `b`
  static FT squared_distance(const Coordinates& a, const Coordinates& b, const Coordinates& p)
  {
    const FT square = dot(a, b, a, b);
    const FT t =
      square > 0 ? (std::min)((std::max)(FT(dot(a, b, a, p) / square), FT(0)), FT(1)) : FT(0);
    Coordinates foot;
    for(std::size_t s = 0; s < 3; ++s)
      foot[s] = a[s] + t * (b[s] - a[s]);
    return dot(foot, p, foot, p);
  }

  const Correspondence<Traits>& m_correspondence;
  const Delta_complex& m_mesh;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_INPUT_FACE_WALK_H
