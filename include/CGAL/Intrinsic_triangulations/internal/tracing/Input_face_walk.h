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
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Describes the regions into which the faces of T1 and T2 cut each other, and their neighbors in a
// face of T1 or T2. Locates points of a face of T1 with vertices of T2 inside it: walks straight
// from a corner of the face to the point. If rounding leads to a wrong region, all regions are
// searched.
template <typename Traits>
class Input_face_walk
{
  typedef typename Traits::FT FT;
  typedef Delta_complex::size_type size_type;
  typedef Correspondence_marks<Traits> Marks;
  typedef Barycentric_coordinates<FT> Coordinates;

public:
  // Identifies a region of a face of T2.
  typedef std::pair<Face_index, std::size_t> Region_id;

  // Represents a piece of a halfedge of T2, which has a region on its left.
  struct Piece
  {
    Halfedge_index halfedge;
    std::size_t number;
  };

  // Stores a region with its corners on both triangulations.
  struct Mapped_region
  {
    Mapped_region(const Region_id& id, const Input_face_walk& regions)
      : intrinsic_face(id.first), region(regions.region(id))
    {
      const Marks marks(Side::intrinsic, id.first, regions.m_correspondence);
      const Face_map<FT, Marks> face_map(marks, regions.m_correspondence.mesh(Side::input));
      std::tie(input_face, map) = face_map.region_map(id.second);
    }

    Face_index face(Side side) const { return side == Side::input ? input_face : intrinsic_face; }

    const Coordinates& corner(Side side, std::size_t c) const
    {
      c = c == map.size() ? 0 : c;
      return side == Side::input ? map.image(c) : map.corner(c);
    }

    // Returns the quotient of the vectors of a corner on the other side and on `side`.
    FT scale(Side side, std::size_t c) const
    {
      return side == Side::input ? FT(1 / map.scale(c)) : map.scale(c);
    }

    Polygon_map<FT> map_from(Side side) const { return side == Side::input ? map.inverse() : map; }

    Face_index intrinsic_face, input_face;
    Region region;
    Polygon_map<FT> map; // from T2 to T1
  };

  explicit Input_face_walk(const Correspondence<Traits>& correspondence)
    : m_correspondence(correspondence), m_mesh(correspondence.mesh(Side::intrinsic))
  {}

  Region region(const Region_id& id) const { return regions_of(id.first)[id.second]; }

  // Returns the region on the left of a piece.
  Region_id region_at(const Piece& piece) const
  {
    const Face_index f = m_mesh.face(piece.halfedge);
    return {f, regions_of(f).region_at_side(side_number(piece.halfedge, m_mesh), piece.number)};
  }

  // Returns the piece of a side after `corner`, or none on the boundary of the face of T1.
  std::optional<Piece> piece_after(const Region_corner& corner, const Region_id& id) const
  {
    const Halfedge_index h = sides(id.first, m_mesh)[corner.side];
    if(corner.arc_follows || m_correspondence.is_shared(Side::intrinsic, Edge_index(h)))
      return {};
    return Piece{h, number_of_piece(corner)};
  }

  // Returns a piece in the opposite direction, with the other region on its left.
  Piece reversed(const Piece& piece) const
  {
    return {m_mesh.opposite(piece.halfedge),
            m_correspondence.number_of_crossings(Side::intrinsic, Edge_index(piece.halfedge)) -
              piece.number};
  }

  // Returns the region beyond the piece of a side after `corner`, or none beyond the face of T1.
  std::optional<Region_id> beyond(const Region_corner& corner, const Region_id& id) const
  {
    const std::optional<Piece> piece = piece_after(corner, id);
    return piece ? std::optional<Region_id>(region_at(reversed(*piece))) : std::nullopt;
  }

  // Calls `visit(c, neighbor)` for the corners of a region with a neighbor in the face of `side`.
  // The neighbor lies beyond the piece after corner `c` of an edge of the other side.
  template <typename Visit>
  void for_each_exit(Side side, const Region_id& id, const Visit& visit) const
  {
    const Region corners = region(id);
    for(std::size_t c = 0; c < corners.size(); ++c)
      if(side == Side::intrinsic) {
        if(corners[c].arc_follows)
          visit(c, beyond_curve(corners[c].is_vertex() ? corners.next(c) : corners[c], id));
      } else if(const std::optional<Region_id> neighbor = beyond(corners[c], id))
        visit(c, *neighbor);
  }

  // Returns the halfedge of the side other than `side` after corner `c` of a region, which lies on
  // its left.
  Halfedge_index halfedge_after(Side side, const Region_id& id, std::size_t c) const
  {
    const Region corners = region(id);
    if(side == Side::input)
      return sides(id.first, m_mesh)[corners[c].side];
    const Marks marks(side, id.first, m_correspondence);
    return corners[c].is_vertex()
             ? marks.across(corners.next(c).side, corners.next(c).mark).halfedge
             : opposite(marks.across(corners[c].side, corners[c].mark).halfedge);
  }

  // Calls `visit(id)` once for each region of the face of T1 that contains `start`, until it
  // returns true.
  template <typename Visit>
  void for_each_region(const Region_id& start, const Visit& visit) const
  {
    std::set<Region_id> seen{start};
    std::vector<Region_id> waiting{start};
    while(!waiting.empty()) {
      const Region_id id = waiting.back();
      waiting.pop_back();
      if(visit(id))
        return;
      for_each_exit(Side::input, id, [&](std::size_t, const Region_id& neighbor) {
        if(seen.insert(neighbor).second)
          waiting.push_back(neighbor);
      });
    }
  }

  // Returns the region on the left of the halfedge `h` of T1 next to its crossing `p`, after it or
  // before it.
  Region_id region_at_crossing(Halfedge_index h, size_type p, bool is_after) const
  {
    const auto crossing = m_correspondence.crossing(Side::input, h, p);
    const Halfedge_index leaving = crossing.across.halfedge;
    const Halfedge_index x = is_after ? leaving : m_mesh.opposite(leaving);
    const std::size_t mark = m_correspondence.crossings_on_intrinsic().position(x, crossing.id);
    return region_at({x, is_after ? mark : mark + 1});
  }

  // Returns the region of the face `f` of T2 in which `p` lies.
  Region_id region_in_face(Face_index f, const Coordinates& p) const
  {
    const Marks marks(Side::intrinsic, f, m_correspondence);
    return {f, Face_map<FT, Marks>(marks, m_correspondence.mesh(Side::input)).region_of(p)};
  }

  // Returns the region in the face of the halfedge `h` of T1 at its source, next to `h`.
  Region_id region_at_source(Halfedge_index h) const
  {
    const Halfedge_index outgoing = m_correspondence.outgoing_before(Side::input, h);
    if(m_correspondence.outgoing_before(Side::intrinsic, outgoing) == h &&
       m_correspondence.is_shared(Side::intrinsic, Edge_index(outgoing)))
      return region_at({outgoing, 0});
    return region_at_crossing(h, 0, false);
  }

  // Returns the position on T2 of the point `p` of a face of T1.
  Face_location<FT> operator()(const Face_location<FT>& p) const
  {
    const Region_id id = region_of(p);
    return {id.first, Mapped_region(id, *this).map_from(Side::input)(p.second)};
  }

  // Returns the region that contains the point `p` of a face of T1, up to rounding.
  Region_id region_of(const Face_location<FT>& p) const
  {
    Region_id id = region_at_source(m_correspondence.mesh(Side::input).halfedge(p.first));
    const Region_id start = id;
    for(std::size_t steps = 0; steps <= m_mesh.number_of_faces(); ++steps) {
      const std::optional<Region_id> next = next_region(id, p.second);
      if(!next)
        break;
      id = *next;
    }
    return squared_distance(id, p.second) > CGAL::square(region_tolerance<FT>())
             ? closest_region(start, p.second)
             : id;
  }

private:
  // Returns the region beyond the piece through which a line leaves the region. The line leads from
  // the first corner of the face of T1 to `p`. Returns nothing if `p` is not beyond the piece.
  std::optional<Region_id> next_region(const Region_id& id, const Coordinates& p) const
  {
    const Mapped_region face(id, *this);
    const Coordinates start{FT(1), FT(0), FT(0)};
    std::optional<Region_id> result;
    FT best(0);
    for(std::size_t c = 0; c < face.region.size(); ++c) {
      const FT right = -orientation(start, p, face.corner(Side::input, c));
      const FT left = orientation(start, p, face.corner(Side::input, c + 1));
      if((std::min)(right, left) >= best && right + left > 0 &&
         orientation(face.corner(Side::input, c), face.corner(Side::input, c + 1), p) < 0) {
        best = (std::min)(right, left);
        result = beyond(face.region[c], id);
      }
    }
    return result;
  }

  // Returns the region in the face of T1 that is closest to `p`. Each region is visited once.
  Region_id closest_region(const Region_id& start, const Coordinates& p) const
  {
    std::pair<FT, Region_id> best(squared_distance(start, p), start);
    for_each_region(start, [&](const Region_id& id) {
      best = (std::min)(best, std::make_pair(squared_distance(id, p), id));
      return false;
    });
    return best.second;
  }

  // Returns the squared distance of `p` from a region, in barycentric coordinates. Pieces so short
  // that rounding may turn them are not used to decide whether `p` is inside.
  FT squared_distance(const Region_id& id, const Coordinates& p) const
  {
    const Mapped_region face(id, *this);
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

  // Returns the region on the other side of the curve that leaves the face of T2 at `mark`.
  Region_id beyond_curve(const Region_corner& mark, const Region_id& id) const
  {
    const Face_regions regions = regions_of(id.first);
    const std::size_t before = regions.region_at_side(mark.side, mark.mark);
    return {id.first,
            before == id.second ? regions.region_at_side(mark.side, mark.mark + 1) : before};
  }

  static std::size_t number_of_piece(const Region_corner& corner)
  {
    return corner.is_vertex() ? 0 : corner.mark + 1;
  }

  Face_regions regions_of(Face_index f) const
  {
    const Marks marks(Side::intrinsic, f, m_correspondence);
    return Face_regions({marks.crossings(0), marks.crossings(1), marks.crossings(2)});
  }

  const Correspondence<Traits>& m_correspondence;
  const Delta_complex& m_mesh;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_INPUT_FACE_WALK_H
