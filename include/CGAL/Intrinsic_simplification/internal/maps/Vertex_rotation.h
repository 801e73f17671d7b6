// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_MAPS_VERTEX_ROTATION_H
#define CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_MAPS_VERTEX_ROTATION_H

#include <CGAL/license/Intrinsic_simplification.h>

#include <CGAL/Intrinsic_simplification/internal/maps/Marked_fine_edges.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_simplification::internal {

// The edges of a subdivision and their cyclic order around its vertices. The pieces of edges of the
// fine level come first. A piece of an edge of the coarse level is one of them if it runs along it;
// otherwise it is a chord of a face, which is an edge of its own.
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

  // piece `p` of an edge of the coarse level, in the direction of the first halfedge of that
  Halfedge_index coarse_piece(Curve_index p) const { return m_halfedge[p]; }

  // the piece of which a chord is one of the halfedges
  const Coarse_piece& piece_of_chord(Halfedge_index h) const
  {
    const Curve_index chord = Edge_index(h).idx() - m_edges.kept().number_of_pieces();
    return m_pieces[m_piece_of_chord[chord]];
  }

  // A piece that bounds a face together with a piece of a fine edge runs along that, whatever
  // rounding says. Returns whether there were any; `mesh` is outdated then.
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

  // the halfedges that leave `v`, in counterclockwise order
  void collect_spokes(Vertex_index v, std::vector<Halfedge_index>& out) const
  {
    out.clear();
    if(m_edges.is_fine_vertex(v))
      return collect_spokes_of_fine_vertex(v, out);
    const Curve_index mark = m_edges.mark_of(v), piece = m_edges.piece_before(v);
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
  // A piece that leaves a vertex of the fine level into a corner of a face, and where the face,
  // counterclockwise from this corner, is met again; at last the order of those along one edge.
  struct Chord_end
  {
    std::size_t corner;
    std::tuple<std::size_t, Curve_index, std::ptrdiff_t> order;
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

  // An edge of the coarse level that is one of the fine level takes its place. What else runs along
  // that is put into a face at first, in the order in which it comes.
  void number_pieces()
  {
    m_is_taken.assign(m_edges.kept().number_of_pieces(), 0);
    for(Curve_index p = 0; p < m_pieces.size(); ++p) {
      const Halfedge_index h = whole_edge(p);
      if(h.is_valid() && m_edges.kept().size(Edge_index(h)) == 0 &&
         take(m_edges.kept().piece(h, 0))) {
        m_halfedge.push_back(m_edges.kept().piece(h, 0));
      } else {
        m_halfedge.push_back(chord(m_piece_of_chord.size()));
        m_piece_of_chord.push_back(p);
      }
    }
  }

  // the halfedge of the fine level that is the edge of a piece, or null
  Halfedge_index whole_edge(Curve_index p) const
  {
    const Curve_segment& s = m_pieces[p].segment;
    const Edge_index e = m_pieces[p].edge;
    return is_at_corner(s.from) && is_at_corner(s.to) &&
               m_edges.first_piece(e) + 1 == m_edges.end_of_pieces(e)
             ? edge_along(s, corner_number(s.from), corner_number(s.to), m_fine)
             : Halfedge_index();
  }

  // whether no other piece runs along a piece of a fine edge
  bool take(Halfedge_index fine_piece)
  {
    return std::exchange(m_is_taken[Edge_index(fine_piece).idx()], 1) == 0;
  }

  // the first halfedge of a chord
  Halfedge_index chord(std::size_t n) const
  {
    return first_halfedge(Edge_index(checked_index(m_edges.kept().number_of_pieces() + n)));
  }

  template <typename Mesh>
  bool merge_with_fine_piece(Halfedge_index& h, const Mesh& mesh)
  {
    for(Halfedge_index side : {h, opposite(h)}) {
      const Halfedge_index other = mesh.next(side);
      if(mesh.next(other) == side && Edge_index(other).idx() < m_is_taken.size() && take(other)) {
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
      if(is_at_corner(s.from)) {
        Curve_index end = p;
        while(is_bend(m_pieces[end].segment.to))
          ++end;
        add_chord_end(p, s.from, m_pieces[end].segment.to, m_pieces[end].marks[1], m_halfedge[p]);
      }
      if(is_at_corner(s.to)) {
        Curve_index start = p;
        while(is_bend(m_pieces[start].segment.from))
          --start;
        add_chord_end(p, s.to, m_pieces[start].segment.from, m_pieces[start].marks[0],
                      opposite(m_halfedge[p]));
      }
    }
    std::sort(m_chord_ends.begin(), m_chord_ends.end());
  }

  void add_to_mark(const Curve_segment& s, const Face_point& end, Curve_index mark,
                   Halfedge_index out)
  {
    if(mark != no_index)
      m_chords_at_mark[mark][is_first_halfedge(side_of_end(s, end, m_fine)) ? 0 : 1] = out;
  }

  // the chord that leaves a mark on the left of `h`, or null
  Halfedge_index chord_on_left(Halfedge_index h, Curve_index mark) const
  {
    return m_chords_at_mark[mark][is_first_halfedge(h) ? 0 : 1];
  }

  void add_chord_end(Curve_index piece, const Face_point& at_corner, const Face_point& other,
                     Curve_index other_mark, Halfedge_index out)
  {
    const Curve_segment& s = m_pieces[piece].segment;
    const std::size_t c = corner_number(at_corner);
    if(other_mark == no_index) {
      const std::size_t turn = (corner_number(other) + 3 - c) % 3;
      const auto p = static_cast<std::ptrdiff_t>(piece);
      m_chord_ends.push_back({corner_index(s.face, c), {turn, 0, turn == 1 ? p : -p}, out});
    } else {
      const Curve_index mark =
        m_edges.numbers().position(side_of_end(s, other, m_fine), other_mark);
      m_chord_ends.push_back(
        {corner_index(s.face, c), {(side_number(other) + 3 - c) % 3, 1 + mark, 0}, out});
    }
  }

  static std::size_t corner_index(Face_index f, std::size_t c) { return 3 * std::size_t(f) + c; }

  // ---- Around a vertex ----

  void collect_spokes_of_fine_vertex(Vertex_index v, std::vector<Halfedge_index>& out) const
  {
    if(m_fine.is_isolated(v))
      return;
    Intrinsic_triangulations::for_each_spoke(v, m_fine, [&](Halfedge_index h) {
      collect_spokes_along(h, out);
      if(m_fine.is_border(h))
        return;
      const std::size_t corner =
        corner_index(m_fine.face(h), Intrinsic_triangulations::side_number(h, m_fine));
      auto end = std::lower_bound(m_chord_ends.begin(), m_chord_ends.end(),
                                  Chord_end{corner, {0, 0, 0}, Halfedge_index()});
      for(; end != m_chord_ends.end() && end->corner == corner; ++end)
        out.push_back(end->out);
    });
  }

  // the first piece of `h`, and the chords at the marks that have been moved to its source
  void collect_spokes_along(Halfedge_index h, std::vector<Halfedge_index>& out) const
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
