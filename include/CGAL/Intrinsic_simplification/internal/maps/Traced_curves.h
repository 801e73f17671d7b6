// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_MAPS_TRACED_CURVES_H
#define CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_MAPS_TRACED_CURVES_H

#include <CGAL/license/Intrinsic_simplification.h>

#include <CGAL/Intrinsic_simplification/Surface_level.h>
#include <CGAL/Intrinsic_simplification/Surface_map.h>
#include <CGAL/Intrinsic_simplification/internal/maps/Curve_tracer.h>
#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Edge_point.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>

#include <array>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_simplification::internal {

// Numbers marks and pieces.
typedef Delta_complex::size_type Curve_index;
constexpr Curve_index no_index = (std::numeric_limits<Curve_index>::max)();

inline Curve_index checked_index(std::size_t n)
{
  if(n >= no_index / 4)
    throw Intrinsic_triangulations::Overflow_error("too many pieces for a subdivision");
  return static_cast<Curve_index>(n);
}

// The following functions return whether a point of a curve is at a corner, on a side, or inside
// its face, where the curve bends.
inline bool is_at_corner(const Face_point& p) { return is_single(p.corners); }
inline bool is_on_side(const Face_point& p) { return is_pair(p.corners); }
inline bool is_bend(const Face_point& p) { return !is_at_corner(p) && !is_on_side(p); }

inline std::size_t corner_number(const Face_point& p)
{
  return p.corners == bit(0) ? 0 : p.corners == bit(1) ? 1 : 2;
}

inline std::size_t side_number(const Face_point& p)
{
  return (p.corners & bit(2)) == 0 ? 0 : (p.corners & bit(0)) == 0 ? 1 : 2;
}

// Returns the side of the face of a segment on which one of its ends lies.
inline Halfedge_index side_of_end(const Curve_segment& s, const Face_point& end,
                                  const Delta_complex& mesh)
{
  return Intrinsic_triangulations::sides(s.face, mesh)[side_number(end)];
}

// Returns the halfedge from one corner of the face of a segment to another.
inline Halfedge_index edge_along(const Curve_segment& s, std::size_t from, std::size_t to,
                                 const Delta_complex& mesh)
{
  const auto side = Intrinsic_triangulations::sides(s.face, mesh);
  return to == (from + 1) % 3 ? side[from] : Intrinsic_triangulations::opposite(side[to]);
}

// Returns the edge on which an end of a segment lies. Also returns the ratio of its distances from
// the source and the target of the first halfedge.
inline std::pair<Edge_index, double> edge_ratio(const Curve_segment& s, const Face_point& end,
                                                const Delta_complex& mesh)
{
  const std::size_t n = side_number(end);
  const Halfedge_index h = side_of_end(s, end, mesh);
  const double from = end.weight[n], to = end.weight[(n + 1) % 3];
  return {Edge_index(h), Intrinsic_triangulations::is_first_halfedge(h) ? to / from : from / to};
}

// Represents a straight part of an edge of the coarse level in a face of the fine level. Stores the
// marks at its ends, and the vertex where it ends.
struct Coarse_piece
{
  Curve_segment segment;
  Edge_index edge;
  std::array<Curve_index, 2> marks;
  Vertex_index target;
};

// Represents a point on an edge of the fine level. The ratio, between zero and infinity, leads from
// the source to the target of its first halfedge.
struct Curve_mark
{
  Edge_index edge;
  double ratio;
  Curve_index piece; // the traced piece that ends at it
  Vertex_index vertex;
};

// Stores the edges of the coarse level as chains of pieces, and their marks on edges of the fine
// level, in the order of tracing. Pieces of one edge are consecutive.
struct Traced_curves
{
  std::vector<Coarse_piece> pieces;
  std::vector<Curve_index> first_piece; // of each edge of the coarse level, and the end
  std::vector<Curve_mark> marks;

  explicit Traced_curves(const Surface_map& map)
  {
    Curve_tracer tracer(map, false);
    for(Edge_index e : map.coarse().mesh().edges()) {
      first_piece.push_back(checked_index(pieces.size()));
      const auto& segments = tracer.trace(Intrinsic_triangulations::first_halfedge(e));
      Curve_index mark = no_index;
      for(std::size_t n = 0; n < segments.size(); ++n)
        add_piece(segments[n], e, n + 1 < segments.size(), mark, map.fine());
    }
    first_piece.push_back(checked_index(pieces.size()));
  }

private:
  // Adds a piece. `mark` is the mark at its start, and becomes the mark at its end. An edge may end
  // at a vertex on a side, which is not a crossing.
  void add_piece(Curve_segment s, Edge_index e, bool is_followed, Curve_index& mark,
                 const Surface_level& fine)
  {
    s.face = fine.level_face(s.face);
    const Curve_index from = std::exchange(mark, no_index);
    if(is_followed && is_on_side(s.to)) {
      mark = checked_index(marks.size());
      add_crossing(s, fine.mesh());
    }
    pieces.push_back({s, e, {from, mark}, Vertex_index()});
  }

  void add_crossing(const Curve_segment& s, const Delta_complex& fine)
  {
    const auto [edge, ratio] = edge_ratio(s, s.to, fine);
    marks.push_back({edge, ratio, checked_index(pieces.size()), Vertex_index()});
  }
};

} // namespace CGAL::Intrinsic_simplification::internal

#endif // CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_MAPS_TRACED_CURVES_H
