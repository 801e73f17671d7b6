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

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <numeric>
#include <tuple>
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
template <typename FT>
bool is_on_side(const Curve_point<3, FT>& p)
{
  return is_pair(p.corners);
}
inline bool is_bend(const Face_point& p) { return !is_at_corner(p) && !is_on_side(p); }

inline std::size_t corner_number(const Face_point& p)
{
  return p.corners == bit(0) ? 0 : p.corners == bit(1) ? 1 : 2;
}

template <typename FT>
std::size_t side_number(const Curve_point<3, FT>& p)
{
  return (p.corners & bit(2)) == 0 ? 0 : (p.corners & bit(0)) == 0 ? 1 : 2;
}

// Returns the side of the face of a segment on which one of its ends lies.
template <typename FT>
Halfedge_index side_of_end(const Traced_segment<FT>& s, const Curve_point<3, FT>& end,
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
template <typename FT>
std::pair<Edge_index, FT> edge_ratio(const Traced_segment<FT>& s, const Curve_point<3, FT>& end,
                                     const Delta_complex& mesh)
{
  const std::size_t n = side_number(end);
  const Halfedge_index h = side_of_end(s, end, mesh);
  const FT &from = end.weight[n], &to = end.weight[(n + 1) % 3];
  return {Edge_index(h),
          FT(Intrinsic_triangulations::is_first_halfedge(h) ? to / from : from / to)};
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

// Returns the indices of `n` marks, in their order.
inline std::vector<Curve_index> indices(std::size_t n)
{
  std::vector<Curve_index> result(n);
  std::iota(result.begin(), result.end(), Curve_index(0));
  return result;
}

// Renumbers marks: mark `order[n]` becomes mark `n`.
inline void renumber(const std::vector<Curve_index>& order, std::vector<Curve_mark>& marks,
                     std::vector<Coarse_piece>& pieces)
{
  std::vector<Curve_mark> result;
  std::vector<Curve_index> place(order.size());
  for(Curve_index n = 0; n < order.size(); ++n) {
    result.push_back(marks[order[n]]);
    place[order[n]] = n;
  }
  marks.swap(result);
  for(Coarse_piece& piece : pieces)
    for(Curve_index& mark : piece.marks)
      if(mark != no_index)
        mark = place[mark];
}

// Sorts marks by their edges, and by their ratios along them. The ratios may have more digits than
// the marks.
template <typename FT>
void sort_marks(const std::vector<FT>& ratio, std::vector<Curve_mark>& marks,
                std::vector<Coarse_piece>& pieces)
{
  std::vector<Curve_index> order = indices(marks.size());
  std::stable_sort(order.begin(), order.end(), [&](Curve_index x, Curve_index y) {
    return std::tie(marks[x].edge, ratio[x]) < std::tie(marks[y].edge, ratio[y]);
  });
  renumber(order, marks, pieces);
}

// Stores the edges of the coarse level as chains of pieces. Pieces of one edge are consecutive.
// Their marks on edges of the fine level are sorted along these edges.
struct Traced_curves
{
  std::vector<Coarse_piece> pieces;
  std::vector<Curve_index> first_piece; // of each edge of the coarse level, and the end
  std::vector<Curve_mark> marks;

  Traced_curves(const Surface_map& map, Tracing_mode mode)
  {
    with_number(mode, [&](auto number) { trace<decltype(number)>(map, mode); });
  }

private:
  template <typename FT>
  void trace(const Surface_map& map, Tracing_mode mode)
  {
    Curve_tracer<FT> tracer(map, false, mode);
    std::vector<FT> ratio; // of each mark
    for(Edge_index e : map.coarse().mesh().edges()) {
      first_piece.push_back(checked_index(pieces.size()));
      const auto& segments = tracer.trace(Intrinsic_triangulations::first_halfedge(e));
      Curve_index mark = no_index;
      for(std::size_t n = 0; n < segments.size(); ++n)
        add_piece(segments[n], e, n + 1 < segments.size(), mark, map.fine(), ratio);
    }
    first_piece.push_back(checked_index(pieces.size()));
    sort_marks(ratio, marks, pieces);
  }

  // Adds a piece. `mark` is the mark at its start, and becomes the mark at its end. An edge may end
  // at a vertex on a side, which is not a crossing.
  template <typename FT>
  void add_piece(Traced_segment<FT> s, Edge_index e, bool is_followed, Curve_index& mark,
                 const Surface_level& fine, std::vector<FT>& ratio)
  {
    s.face = fine.level_face(s.face);
    const Curve_index from = std::exchange(mark, no_index);
    if(is_followed && is_on_side(s.to)) {
      mark = checked_index(marks.size());
      const auto [edge, at] = edge_ratio(s, s.to, fine.mesh());
      ratio.push_back(at);
      marks.push_back(
        {edge, static_cast<double>(at), checked_index(pieces.size()), Vertex_index()});
    }
    pieces.push_back({rounded(s), e, {from, mark}, Vertex_index()});
  }
};

} // namespace CGAL::Intrinsic_simplification::internal

#endif // CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_MAPS_TRACED_CURVES_H
