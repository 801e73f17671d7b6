// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_MAPS_CURVE_STRANDS_H
#define CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_MAPS_CURVE_STRANDS_H

#include <CGAL/license/Intrinsic_simplification.h>

#include <CGAL/Intrinsic_simplification/internal/maps/Traced_curves.h>
#include <CGAL/Intrinsic_triangulations/Delta_complex.h>

#include <cstddef>
#include <vector>

namespace CGAL::Intrinsic_simplification::internal {

// Represents a piece of an edge of the coarse level, followed with or against the direction of its
// edge.
struct Strand
{
  std::size_t piece;
  bool is_forward;
};

// States how a curve continues at a vertex of the coarse level inside a fine face. It follows the
// next edge on one side, so that it does not cross any edge.
enum class Turn
{
  left,
  right
};

// Follows edges of the coarse level over the faces of the fine level.
class Curve_strands
{
public:
  Curve_strands(const std::vector<Coarse_piece>& pieces,
                const std::vector<Curve_index>& first_piece, const Delta_complex& coarse)
    : m_pieces(pieces), m_first_piece(first_piece), m_coarse(coarse)
  {}

  const Coarse_piece& piece(const Strand& s) const { return m_pieces[s.piece]; }
  Edge_index edge(const Strand& s) const { return piece(s).edge; }

  const Face_point& end(const Strand& s) const
  {
    return s.is_forward ? piece(s).segment.to : piece(s).segment.from;
  }
  Curve_index end_mark(const Strand& s) const { return piece(s).marks[s.is_forward ? 1 : 0]; }

  // Returns whether the piece is the last one of its edge.
  bool is_last(const Strand& s) const
  {
    const Edge_index e = edge(s);
    return s.is_forward ? s.piece + 1 == m_first_piece[e.idx() + 1]
                        : s.piece == m_first_piece[e.idx()];
  }

  // Returns whether both follow one edge in one direction.
  bool is_on_same_way(const Strand& s, const Strand& other) const
  {
    return halfedge(s) == halfedge(other);
  }

  // Returns the first piece of the halfedge `h` of the coarse level.
  Strand first(Halfedge_index h) const
  {
    const Edge_index e(h);
    return Intrinsic_triangulations::is_first_halfedge(h)
             ? Strand{m_first_piece[e.idx()], true}
             : Strand{m_first_piece[e.idx() + 1] - std::size_t(1), false};
  }

  // Returns the vertex of the coarse level at the end of the edge.
  Vertex_index target(const Strand& s) const { return m_coarse.target(halfedge(s)); }

  void advance(Strand& s, Turn turn) const
  {
    if(is_last(s))
      s = first(next(halfedge(s), turn));
    else
      s.piece = s.is_forward ? s.piece + 1 : s.piece - 1;
  }

  // Follows the curve to its exit from the face, and returns whether it leaves. An edge that comes
  // from outside is preceded by at most two edges of its face.
  bool leave_face(Strand& s, Turn turn) const
  {
    for(int edges = 0; is_bend(end(s)); advance(s, turn))
      if(is_last(s) && ++edges > 2)
        return false;
    return true;
  }

private:
  Halfedge_index halfedge(const Strand& s) const
  {
    const Halfedge_index h = Intrinsic_triangulations::first_halfedge(edge(s));
    return s.is_forward ? h : Intrinsic_triangulations::opposite(h);
  }

  // Vertices inside faces are not on the boundary.
  Halfedge_index next(Halfedge_index h, Turn turn) const
  {
    return turn == Turn::left ? m_coarse.next(h)
                              : m_coarse.opposite(m_coarse.prev(m_coarse.opposite(h)));
  }

  const std::vector<Coarse_piece>& m_pieces;
  const std::vector<Curve_index>& m_first_piece; // of each edge of the coarse level, and the end
  const Delta_complex& m_coarse;
};

} // namespace CGAL::Intrinsic_simplification::internal

#endif // CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_MAPS_CURVE_STRANDS_H
