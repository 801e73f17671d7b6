// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_TRACE_H
#define CGAL_INTRINSIC_SIMPLIFICATION_TRACE_H

#include <CGAL/license/Intrinsic_simplification.h>

#include <CGAL/Intrinsic_simplification/Surface_level.h>
#include <CGAL/Intrinsic_simplification/Surface_map.h>
#include <CGAL/Intrinsic_simplification/internal/maps/Curve_tracer.h>

#include <algorithm>
#include <array>
#include <vector>

namespace CGAL::Intrinsic_simplification {

/// \ingroup PkgIntrinsicSimplificationRef
/// the kind of the position of a point of a traced edge on the other surface.
enum class Trace_place
{
  vertex, ///< at a vertex: one coordinate is one, the others are exactly zero
  edge,   ///< inside an edge: the coordinate that does not belong to it is exactly zero
  face    ///< inside a face, at a bend or an end of the curve
};

/// \ingroup PkgIntrinsicSimplificationRef
/// an end of a piece of a traced edge.
struct Trace_end
{
  std::array<double, 3> coordinates; ///< in the face of the piece
  Trace_place place;                 ///< the kind of this position
  double t; ///< the position on the traced edge: 0 at its source, 1 at its target
};

/// \ingroup PkgIntrinsicSimplificationRef
/// a straight piece of a traced edge, inside one face of the other surface or along one of its
/// edges.
struct Trace_piece
{
  Face_index face;               ///< the face
  std::array<Trace_end, 2> ends; ///< the first end and the last end
};

namespace internal {

inline Trace_end trace_end(const Face_point& p)
{
  Coordinates b = p.weight;
  normalize(b);
  const Trace_place place = is_single(p.corners) ? Trace_place::vertex
                            : is_pair(p.corners) ? Trace_place::edge
                                                 : Trace_place::face;
  return {b, place, p.along[1] / (p.along[0] + p.along[1])};
}

// Returns the result of a tracer with indices of `level`.
inline std::vector<Trace_piece> trace_pieces(const std::vector<Curve_segment>& segments,
                                             const Surface_level& level)
{
  std::vector<Trace_piece> result;
  result.reserve(segments.size());
  double last = 0; // rounding shall not lead back
  for(const Curve_segment& s : segments) {
    result.push_back({level.level_face(s.face), {trace_end(s.from), trace_end(s.to)}});
    for(Trace_end& end : result.back().ends)
      last = end.t = (std::max)(end.t, last);
  }
  return result;
}

} // namespace internal

/// \ingroup PkgIntrinsicSimplificationRef
/// traces an edge of the coarse level over the fine level (Section 5.2.2).
///
/// The curve is straight on the coarse surface. On the fine surface it is a sequence of straight
/// pieces. It starts and ends at vertices, or at points with inserted vertices. It runs through
/// other vertices that it passes within rounding. It may bend on edges and inside faces, because a
/// scaling bends a curve at the edges that it crosses at that time. Without scaling, it is a
/// geodesic, and all its pieces end on edges.
/// \param h a halfedge of the coarse level
/// \param map the map
/// \returns the pieces from the source of `h` to its target. Each begins at the end of the piece
///   before. If this point is on an edge, the pieces are in the faces on its two sides. Despite
///   rounding, vertices and edges along the curve are always consistent. Positions on `h` never
///   decrease.
///
/// Complexity: linear in the points at which the curve crosses an edge at any time. Each takes time
/// for the operations that move it, up to a logarithm.
inline std::vector<Trace_piece> trace_coarse_edge(Halfedge_index h, const Surface_map& map)
{
  return internal::trace_pieces(internal::Curve_tracer(map, false).trace_through_near_vertices(h),
                                map.fine());
}

/// \ingroup PkgIntrinsicSimplificationRef
/// traces an edge of the fine level over the coarse level, as `trace_coarse_edge()` does in the
/// other direction. A removed vertex as an end is inside a face, or on a boundary edge.
/// \param h a halfedge of the fine level
/// \param map the map
/// \returns the pieces, with the guarantees of `trace_coarse_edge()`
///
/// Complexity: the complexity of `trace_coarse_edge()`.
inline std::vector<Trace_piece> trace_fine_edge(Halfedge_index h, const Surface_map& map)
{
  return internal::trace_pieces(internal::Curve_tracer(map, true).trace_through_near_vertices(h),
                                map.coarse());
}

} // namespace CGAL::Intrinsic_simplification

#endif // CGAL_INTRINSIC_SIMPLIFICATION_TRACE_H
