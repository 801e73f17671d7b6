// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_MAPS_VERTEX_PLACES_H
#define CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_MAPS_VERTEX_PLACES_H

#include <CGAL/license/Intrinsic_simplification.h>

#include <CGAL/Intrinsic_simplification/Surface_map.h>
#include <CGAL/Intrinsic_simplification/internal/maps/Marked_fine_edges.h>
#include <CGAL/Intrinsic_triangulations/Edge_point.h>
#include <CGAL/Intrinsic_triangulations/Surface_point.h>

#include <cmath>

// This file contains the positions of the vertices of a subdivision on its two levels.

namespace CGAL::Intrinsic_simplification::internal {

typedef Intrinsic_triangulations::Surface_point<double> Level_point;

inline Level_point edge_place(Halfedge_index h, double t, const Delta_complex& mesh)
{
  namespace IT = Intrinsic_triangulations;
  IT::Edge_point<double> p{h, t};
  if(mesh.is_border(h))
    p = IT::reversed(p, mesh);
  return IT::edge_location(p);
}

inline Level_point vertex_place(Vertex_index v, const Delta_complex& mesh)
{
  if(mesh.is_isolated(v))
    return Intrinsic_triangulations::Vertex_location();
  return Intrinsic_triangulations::Vertex_location{
    Intrinsic_triangulations::first_outgoing_halfedge(v, mesh)};
}

// Returns the position of a vertex of the subdivision on the fine level.
inline Level_point fine_place(Vertex_index v, const Marked_fine_edges& edges)
{
  const Delta_complex& fine = edges.map().fine().mesh();
  if(edges.is_fine_vertex(v))
    return vertex_place(v, fine);
  if(edges.mark_of(v) == no_index) {
    Strand s{edges.piece_before(v), true};
    if(edges.is_new_vertex(v)) {
      s = edges.first_strand(edges.new_vertex(v));
      s.is_forward = !s.is_forward;
    }
    Surface_map::Location p{edges.pieces()[s.piece].segment.face, edges.strands().end(s).weight};
    normalize(p.second);
    return p;
  }
  const Curve_mark& mark = edges.mark(edges.mark_of(v));
  const double t = std::isinf(mark.ratio) ? 1 : mark.ratio / (1 + mark.ratio);
  return edge_place(first_halfedge(mark.edge), t, fine);
}

// Returns the position on the first halfedge of its edge where a piece ends.
inline double place_of_end(const Coarse_piece& piece)
{
  const double x = piece.segment.to.along[0], y = piece.segment.to.along[1];
  return y / (x + y);
}

// Returns the position on the coarse level of a vertex that only the fine level has, as edges are
// traced.
inline Level_point image_of_removed_vertex(Vertex_index v, const Marked_fine_edges& edges)
{
  const Surface_map& map = edges.map();
  if(edges.mode() == Tracing_mode::through_near_vertices)
    return image_of_vertex(v, map);
  return with_number(edges.mode(), [&](auto number) {
    Curve_tracer<decltype(number)> tracer(map, true, edges.mode());
    const Curve_segment first =
      rounded(tracer.trace(Intrinsic_triangulations::first_outgoing_halfedge(v, map.fine().mesh()))
                .front());
    Surface_map::Location p(map.coarse().level_face(first.face), first.from.weight);
    normalize(p.second);
    return p;
  });
}

// Returns the position of a vertex of the subdivision on the coarse level.
inline Level_point coarse_place(Vertex_index v, const Marked_fine_edges& edges)
{
  const Surface_map& map = edges.map();
  if(edges.is_fine_bend(v))
    return edges.fine_bend(v);
  const Vertex_index coarse = edges.is_new_vertex(v)    ? edges.new_vertex(v)
                              : edges.is_fine_vertex(v) ? map.coarse_vertex(v)
                                                        : Vertex_index();
  if(coarse.is_valid())
    return vertex_place(coarse, map.coarse().mesh());
  if(edges.piece_before(v) == no_index)
    return image_of_removed_vertex(v, edges);
  const Coarse_piece& piece = edges.pieces()[edges.piece_before(v)];
  return edge_place(first_halfedge(piece.edge), place_of_end(piece), map.coarse().mesh());
}

// Returns a point as the nearest point of the face `f` across an edge, or as a common corner at a
// vertex. The face is null if `f` is not adjacent.
inline Surface_map::Location moved_into(Face_index f, const Surface_map::Location& p,
                                        const Delta_complex& mesh)
{
  namespace IT = Intrinsic_triangulations;
  Halfedge_index across, at_vertex;
  double least = 2, most = -1;
  for(Halfedge_index h : IT::sides(p.first, mesh)) {
    const Coordinates b = IT::coordinates_from(h, p, mesh);
    if(mesh.face(mesh.opposite(h)) == f && b[2] < least) {
      across = mesh.opposite(h);
      least = b[2];
    }
    for(Halfedge_index g : IT::sides(f, mesh))
      if(mesh.source(g) == mesh.source(h) && b[0] > most) {
        at_vertex = g;
        most = b[0];
      }
  }
  if(across.is_valid()) {
    const Coordinates b = IT::coordinates_from(mesh.opposite(across), p, mesh);
    return IT::face_location(IT::Edge_point<double>{across, b[0] / (b[0] + b[1])}, mesh);
  }
  if(at_vertex.is_valid())
    return IT::face_location(IT::Edge_point<double>{at_vertex, 0}, mesh);
  return {Face_index(), {}};
}

} // namespace CGAL::Intrinsic_simplification::internal

#endif // CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_MAPS_VERTEX_PLACES_H
