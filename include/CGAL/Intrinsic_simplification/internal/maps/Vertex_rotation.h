// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_MAPS_VERTEX_ROTATION_H
#define CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_MAPS_VERTEX_ROTATION_H

#include <CGAL/license/Intrinsic_simplification.h>

#include <CGAL/Intrinsic_simplification/internal/maps/Marked_fine_edges.h>
#include <CGAL/Intrinsic_simplification/internal/maps/Traced_curves.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_simplification::internal {

// Determines the edges of a subdivision and their cyclic order around its vertices. The pieces of
// edges of the fine level come first. A piece of an edge of the coarse level may run along one of
// them, and is the same edge then. Otherwise it is a chord of a face, which is a separate edge.
class Vertex_rotation
{
public:
  explicit Vertex_rotation(const Marked_fine_edges& edges)
    : m_edges(edges), m_pieces(edges.pieces()), m_fine(edges.map().fine().mesh())
  {
    number_pieces();
    collect_chords();
  }

  Curve_index number_of_edges() const
  {
    return m_edges.kept().number_of_pieces() + checked_index(m_piece_of_chord.size());
  }

  // Returns piece `p` of an edge of the coarse level, in the direction of the first halfedge of
  // this edge.
  Halfedge_index coarse_piece(Curve_index p) const { return m_halfedge[p]; }

  // Returns the piece that has a chord as one of its halfedges.
  const Coarse_piece& piece_of_chord(Halfedge_index h) const
  {
    const Curve_index chord = Edge_index(h).idx() - m_edges.kept().number_of_pieces();
    return m_pieces[m_piece_of_chord[chord]];
  }

  // Merges each piece with a piece of a fine edge if both bound a face together, independently of
  // rounding. Returns whether such pieces existed; `mesh` is then outdated.
  template <typename Mesh>
  bool merge_bigons(const Mesh& mesh)
  {
    std::vector<Curve_index> rest;
    for(Curve_index p : m_piece_of_chord)
      if(!merge_with_fine_piece(m_halfedge[p], mesh))
        rest.push_back(p);
    if(rest.size() == m_piece_of_chord.size())
      return false;
    m_piece_of_chord.swap(rest);
    for(std::size_t c = 0; c < m_piece_of_chord.size(); ++c)
      m_halfedge[m_piece_of_chord[c]] = chord(c);
    collect_chords();
    return true;
  }

  // Collects the halfedges that leave `v`, in counterclockwise order.
  void collect_outgoing_halfedges(Vertex_index v, std::vector<Halfedge_index>& out) const
  {
    out.clear();
    if(m_edges.is_fine_vertex(v))
      return collect_outgoing_halfedges_of_fine_vertex(v, out);
    const Curve_index mark = m_edges.mark_of(v), piece = m_edges.piece_before(v);
    if(m_edges.is_new_vertex(v))
      return collect_outgoing_halfedges_of_new_vertex(v, mark, out);
    if(mark == no_index) {
      out = {m_halfedge[piece + 1], opposite(m_halfedge[piece])};
      return;
    }
    const auto [before, after] = m_edges.pieces_around_mark(mark);
    const Halfedge_index h = first_halfedge(m_edges.mark(mark).edge);
    out.push_back(after);
    add_if_valid(chord_on_left(h, mark), out);
    out.push_back(opposite(before));
    add_if_valid(chord_on_left(opposite(h), mark), out);
  }

private:
  // Stores a corner of a face, or a mark on one of its sides.
  typedef std::pair<std::size_t, Curve_index> Position;

  // Represents a piece that leaves a vertex of the fine level into a corner of a face. The
  // positions where it meets the sides of the face again are counted counterclockwise from this
  // corner. The last criterion is the order of pieces along one edge.
  struct Chord_end
  {
    std::size_t corner;
    std::tuple<Position, Position, std::ptrdiff_t> order;
    Halfedge_index out;

    friend bool operator<(const Chord_end& a, const Chord_end& b)
    {
      return std::tie(a.corner, a.order) < std::tie(b.corner, b.order);
    }
  };

  static void add_if_valid(Halfedge_index h, std::vector<Halfedge_index>& out)
  {
    if(h.is_valid())
      out.push_back(h);
  }

  // ---- Numbers ----

  // Numbers the pieces. An edge of the coarse level that is an edge of the fine level replaces it.
  // Other pieces along it are first moved into a face, in their order of tracing.
  void number_pieces()
  {
    m_is_taken.assign(m_edges.kept().number_of_pieces(), 0);
    for(Curve_index p = 0; p < m_pieces.size(); ++p) {
      const Halfedge_index h = whole_edge(p);
      if(h.is_valid() && m_edges.kept().size(Edge_index(h)) == 0 &&
         claim(m_edges.kept().piece(h, 0))) {
        m_halfedge.push_back(m_edges.kept().piece(h, 0));
      } else {
        m_halfedge.push_back(chord(m_piece_of_chord.size()));
        m_piece_of_chord.push_back(p);
      }
    }
  }

  // Returns the halfedge of the fine level that is the edge of a piece, or null.
  Halfedge_index whole_edge(Curve_index p) const
  {
    const Curve_segment& s = m_pieces[p].segment;
    const Edge_index e = m_pieces[p].edge;
    return is_at_corner(s.from) && is_at_corner(s.to) &&
               m_edges.first_piece(e) + 1 == m_edges.end_of_pieces(e)
             ? edge_along(s, corner_number(s.from), corner_number(s.to), m_fine)
             : Halfedge_index();
  }

  // Returns whether no other piece runs along a piece of a fine edge.
  bool claim(Halfedge_index fine_piece)
  {
    return std::exchange(m_is_taken[Edge_index(fine_piece).idx()], 1) == 0;
  }

  Halfedge_index chord(std::size_t n) const
  {
    return first_halfedge(Edge_index(checked_index(m_edges.kept().number_of_pieces() + n)));
  }

  template <typename Mesh>
  bool merge_with_fine_piece(Halfedge_index& h, const Mesh& mesh)
  {
    for(Halfedge_index side : {h, opposite(h)}) {
      const Halfedge_index other = mesh.next(side);
      if(mesh.next(other) == side && Edge_index(other).idx() < m_is_taken.size() && claim(other)) {
        h = side == h ? opposite(other) : other;
        return true;
      }
    }
    return false;
  }

  // ---- Ends of chords ----

  void collect_chords()
  {
    m_chord_ends.clear();
    m_chords_at_mark.assign(m_edges.numbers().size(), {});
    for(Curve_index p : m_piece_of_chord) {
      const auto& [s, e, marks, target] = m_pieces[p];
      add_to_mark(s, s.from, marks[0], m_halfedge[p]);
      add_to_mark(s, s.to, marks[1], opposite(m_halfedge[p]));
      if(is_at_corner(s.from))
        add_chord_end({p, true}, s.from, m_halfedge[p]);
      if(is_at_corner(s.to))
        add_chord_end({p, false}, s.to, opposite(m_halfedge[p]));
    }
    std::sort(m_chord_ends.begin(), m_chord_ends.end());
  }

  void add_to_mark(const Curve_segment& s, const Face_point& end, Curve_index mark,
                   Halfedge_index out)
  {
    if(mark != no_index)
      m_chords_at_mark[mark][is_first_halfedge(side_of_end(s, end, m_fine)) ? 0 : 1] = out;
  }

  // Returns the chord that leaves a mark on the left of `h`, or null.
  Halfedge_index chord_on_left(Halfedge_index h, Curve_index mark) const
  {
    return m_chords_at_mark[mark][is_first_halfedge(h) ? 0 : 1];
  }

  // Adds an end of a chord. A chord may end at a vertex inside the face. Then curves on its right
  // and on its left, which cross no edge, determine its position.
  void add_chord_end(const Strand& chord, const Face_point& at_corner, Halfedge_index out)
  {
    const Curve_strands strands = m_edges.strands();
    const std::size_t c = corner_number(at_corner);
    const auto [right, chords_on_right] = exit(chord, at_corner.corners, Turn::right);
    const Strand left = exit(chord, at_corner.corners, Turn::left).first;
    const Position first = position(right, c), last = position(left, c);
    std::ptrdiff_t tie = chords_on_right;
    if(strands.edge(left) == strands.edge(chord) && is_at_corner(strands.end(left)))
      tie = (first.first == 1 ? 1 : -1) * static_cast<std::ptrdiff_t>(chord.piece);
    m_chord_ends.push_back(
      {corner_index(strands.piece(chord).segment.face, c), {first, last, tie}, out});
  }

  // Returns the position where the curve on one side of a chord leaves its face. If the curve
  // returns to the corner by another chord, this is the next chord at the corner, and its curve is
  // followed. Returns the number of these chords, too.
  std::pair<Strand, std::ptrdiff_t> exit(const Strand& chord, Corner_set corner, Turn turn) const
  {
    const Curve_strands strands = m_edges.strands();
    Strand end = chord;
    for(std::ptrdiff_t chords = 0;; ++chords) {
      strands.leave_face(end, turn);
      if(strands.end(end).corners != corner || end.piece == chord.piece)
        return {end, chords};
      end.is_forward = !end.is_forward;
    }
  }

  // Returns the position where a curve from corner `c` of a face reaches another corner or a side,
  // counterclockwise from this corner.
  Position position(const Strand& s, std::size_t c) const
  {
    const Curve_strands strands = m_edges.strands();
    const Face_point& end = strands.end(s);
    if(is_at_corner(end))
      return {(corner_number(end) + 3 - c) % 3, 0};
    const Curve_index mark =
      strands.is_last(s) ? m_edges.mark_of_coarse(strands.target(s)) : strands.end_mark(s);
    const Halfedge_index h = side_of_end(strands.piece(s).segment, end, m_fine);
    return {(side_number(end) + 3 - c) % 3, 1 + m_edges.numbers().position(h, mark)};
  }

  static std::size_t corner_index(Face_index f, std::size_t c) { return 3 * std::size_t(f) + c; }

  // ---- Around a vertex ----

  void collect_outgoing_halfedges_of_fine_vertex(Vertex_index v,
                                                 std::vector<Halfedge_index>& out) const
  {
    if(m_fine.is_isolated(v))
      return;
    Intrinsic_triangulations::for_each_outgoing_halfedge(v, m_fine, [&](Halfedge_index h) {
      collect_outgoing_halfedges_along(h, out);
      if(m_fine.is_border(h))
        return;
      const std::size_t corner =
        corner_index(m_fine.face(h), Intrinsic_triangulations::side_number(h, m_fine));
      auto end = std::lower_bound(m_chord_ends.begin(), m_chord_ends.end(), corner,
                                  [](const Chord_end& a, std::size_t b) { return a.corner < b; });
      for(; end != m_chord_ends.end() && end->corner == corner; ++end)
        out.push_back(end->out);
    });
  }

  // Collects the halfedges that leave a vertex of only the coarse level, in counterclockwise order.
  void collect_outgoing_halfedges_of_new_vertex(Vertex_index v, Curve_index mark,
                                                std::vector<Halfedge_index>& out) const
  {
    const Curve_strands strands = m_edges.strands();
    for_each_outgoing_halfedge(
      m_edges.new_vertex(v), m_edges.map().coarse().mesh(), [&](Halfedge_index h) {
        const Strand s = strands.first(h);
        out.push_back(s.is_forward ? m_halfedge[s.piece] : opposite(m_halfedge[s.piece]));
      });
    if(mark == no_index)
      return;
    auto [before, after] = m_edges.pieces_around_mark(mark);
    if(m_fine.is_border(first_halfedge(m_edges.mark(mark).edge)))
      std::tie(before, after) = std::pair(opposite(after), opposite(before));
    if(out.front() != after)
      out.insert(out.begin(), after);
    if(out.back() != opposite(before))
      out.push_back(opposite(before));
  }

  // Collects the first piece of `h`, and the chords at the marks that have been moved to its
  // source.
  void collect_outgoing_halfedges_along(Halfedge_index h, std::vector<Halfedge_index>& out) const
  {
    const Edge_index e(h);
    Curve_index moved = 0;
    for(; moved < m_edges.numbers().size(e) && m_edges.is_at_source(h, m_edges.numbers()(h, moved));
        ++moved)
      add_if_valid(chord_on_left(opposite(h), m_edges.numbers()(h, moved)), out);
    out.push_back(m_edges.kept().piece(h, 0));
    while(moved-- > 0)
      add_if_valid(chord_on_left(h, m_edges.numbers()(h, moved)), out);
  }

  const Marked_fine_edges& m_edges;
  const std::vector<Coarse_piece>& m_pieces;
  const Delta_complex& m_fine;
  std::vector<Halfedge_index> m_halfedge;    // of each piece
  std::vector<char> m_is_taken;              // whether one runs along a piece of a fine edge
  std::vector<Curve_index> m_piece_of_chord; // of each chord
  std::vector<std::array<Halfedge_index, 2>>
    m_chords_at_mark;                  // that leave it on the left and right of the first halfedge
  std::vector<Chord_end> m_chord_ends; // in the order of corners and counterclockwise around them
};

} // namespace CGAL::Intrinsic_simplification::internal

#endif // CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_MAPS_VERTEX_ROTATION_H
