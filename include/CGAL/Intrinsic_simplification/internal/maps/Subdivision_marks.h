// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_MAPS_SUBDIVISION_MARKS_H
#define CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_MAPS_SUBDIVISION_MARKS_H

#include <CGAL/license/Intrinsic_simplification.h>

#include <CGAL/Intrinsic_simplification/Subdivision_place.h>
#include <CGAL/Intrinsic_simplification/Surface_level.h>
#include <CGAL/Intrinsic_simplification/Surface_map.h>
#include <CGAL/Intrinsic_simplification/internal/maps/Crossing_order.h>
#include <CGAL/Intrinsic_simplification/internal/maps/Curve_tracer.h>
#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Edge_point.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Intrinsic_simplification {
namespace internal {

using Intrinsic_triangulations::opposite;

// The vertices and edges of a subdivision: the edges of the fine level with marks on them, and
// those of the coarse level as chains of pieces. Halfedges are those of the subdivision where
// nothing else is said: an edge of the fine level with n marks becomes n + 1 edges; a piece of the
// coarse level is another, unless it runs along an edge of the fine level.
//
// Curves that come to a vertex within rounding run through it: where they cross the edges there,
// their marks are moved to the vertex, in their order along the edge. So what does not cross before
// does not cross then.
class Subdivision_marks
{
public:
  typedef Delta_complex::size_type size_type;

  explicit Subdivision_marks(const Surface_map& map)
    : m_map(map),
      m_fine(map.fine().mesh()),
      m_coarse(map.coarse().mesh()),
      m_number_of_vertices(m_fine.number_of_vertices()),
      m_piece_before(m_number_of_vertices, none),
      m_is_along(m_fine.number_of_edges(), 0)
  {}

  void trace_coarse_edges()
  {
    Curve_tracer tracer(m_map, false);
    for(Edge_index e : m_coarse.edges()) {
      m_first_piece.push_back(number(m_pieces.size()));
      size_type mark = none;
      for(const Curve_segment& s : tracer.trace(m_coarse.halfedge(e, 0)))
        add_piece(s, e, mark);
    }
    m_first_piece.push_back(number(m_pieces.size()));
    order_crossings();
    run_through_near_vertices();
    m_piece_before.resize(m_number_of_vertices, none);
    for(size_type p = 0; p + 1 < m_pieces.size(); ++p)
      if(m_pieces[p].edge == m_pieces[p + 1].edge)
        m_piece_before[m_pieces[p].target] = p;
  }

  // To be called after the others have been traced.
  void trace_fine_edges()
  {
    m_first_fine_bend = m_number_of_vertices;
    Curve_tracer tracer(m_map, true);
    for(Edge_index e : m_fine.edges())
      if(!m_is_along[e]) {
        const auto& segments = tracer.trace(m_fine.halfedge(e, 0));
        for(std::size_t n = 0; n + 1 < segments.size(); ++n)
          if(segments[n].to.corners == 7)
            add_fine_bend(e, segments[n]);
      }
  }

  void sort()
  {
    sort_marks();
    m_first_mark.assign(m_fine.number_of_edges() + 1, 0);
    m_first_kept.assign(m_fine.number_of_edges() + 1, 0);
    m_mark_of_vertex.resize(m_number_of_vertices, none);
    m_piece_before.resize(m_number_of_vertices, none); // none before bends of fine edges
    for(size_type n = 0, kept = 0; n < m_marks.size(); ++n) {
      Mark& mark = m_marks[n];
      mark.kept_before = kept;
      ++m_first_mark[mark.edge + 1];
      if(end_at(mark.ratio) == End::none) {
        ++kept;
        ++m_first_kept[mark.edge + 1];
        m_mark_of_vertex[mark.vertex] = n;
      }
    }
    for(std::size_t e = 1; e < m_first_mark.size(); ++e) {
      m_first_mark[e] += m_first_mark[e - 1];
      m_first_kept[e] += m_first_kept[e - 1];
    }
    number_pieces();
    collect_chords();
  }

  size_type number_of_vertices() const { return m_number_of_vertices; }
  size_type number_of_edges() const
  {
    return number_of_fine_pieces() + number(m_piece_of_chord.size());
  }

  // A piece that bounds a face together with a piece of a fine edge runs along that, whatever
  // rounding says. Returns whether there were any; `mesh` does not hold any more then.
  template <typename Mesh>
  bool merge_bigons(const Mesh& mesh)
  {
    std::vector<size_type> rest;
    for(size_type p : m_piece_of_chord)
      if(!merge_with_fine_piece(m_pieces[p].halfedge, mesh))
        rest.push_back(p);
    if(rest.size() == m_piece_of_chord.size())
      return false;
    m_piece_of_chord.swap(rest);
    for(size_type c = 0; c < m_piece_of_chord.size(); ++c)
      m_pieces[m_piece_of_chord[c]].halfedge = chord(c);
    collect_chords();
    return true;
  }

  // of an edge of the fine level
  size_type number_of_pieces(Edge_index e) const
  {
    return m_first_kept[e + 1] - m_first_kept[e] + 1;
  }

  // piece number `p` of the halfedge `h` of the fine level, counted from its source
  Halfedge_index fine_piece(Halfedge_index h, size_type p) const
  {
    const Edge_index e(h);
    const size_type first = m_first_kept[e] + e.idx();
    if(h.idx() % 2 == 0)
      return Halfedge_index(2 * (first + p));
    return Halfedge_index(2 * (first + number_of_pieces(e) - 1 - p) + 1);
  }

  // the numbers of the pieces of an edge of the coarse level
  size_type first_piece(Edge_index e) const { return m_first_piece[e.idx()]; }
  size_type end_of_pieces(Edge_index e) const { return m_first_piece[e.idx() + 1]; }

  // in the direction of the first halfedge of its edge
  Halfedge_index coarse_piece(size_type p) const { return m_pieces[p].halfedge; }

  // the face of the fine level beside `h`, which is part of its halfedge `parent`, or inside the
  // face
  Face_index fine_face(Halfedge_index h, Halfedge_index parent) const
  {
    return parent.is_valid()
             ? m_fine.face(parent)
             : m_pieces[m_piece_of_chord[h.idx() / 2 - number_of_fine_pieces()]].segment.face;
  }

  // the halfedges that leave `v`, in counterclockwise order
  void collect_spokes(Vertex_index v, std::vector<Halfedge_index>& out) const
  {
    out.clear();
    if(is_fine_vertex(v))
      return collect_spokes_of_fine_vertex(v, out);
    const size_type mark = m_mark_of_vertex[v], piece = m_piece_before[v];
    if(mark == none) {
      out = {coarse_piece(piece + 1), opposite(coarse_piece(piece))};
      return;
    }
    const auto& [left, right] = m_marks[mark].out;
    out.push_back(after_mark(mark));
    add_if_valid(left, out);
    out.push_back(opposite(before_mark(mark)));
    add_if_valid(right, out);
  }

  Subdivision_place fine_place(Vertex_index v) const
  {
    if(is_fine_vertex(v))
      return vertex_place(v, m_fine);
    const size_type mark = m_mark_of_vertex[v];
    if(mark == none)
      return {Halfedge_index(), location(m_pieces[m_piece_before[v]].segment)};
    return edge_place(m_fine.halfedge(m_marks[mark].edge, 0), place_on_edge(m_marks[mark].ratio),
                      m_fine);
  }

  Subdivision_place coarse_place(Vertex_index v) const
  {
    if(!is_fine_vertex(v) && v.idx() >= m_first_fine_bend)
      return {Halfedge_index(), m_fine_bends[v.idx() - m_first_fine_bend]};
    const Vertex_index coarse = is_fine_vertex(v)
                                  ? m_map.coarse().level_vertex(m_map.fine().surface_vertex(v))
                                  : Vertex_index();
    if(coarse.is_valid())
      return vertex_place(coarse, m_coarse);
    if(m_piece_before[v] == none)
      return {Halfedge_index(), image_of_vertex(v, m_map)};
    const Coarse_piece& piece = m_pieces[m_piece_before[v]];
    const double x = piece.segment.to.along[0], y = piece.segment.to.along[1];
    return edge_place(m_coarse.halfedge(piece.edge, 0), y / (x + y), m_coarse);
  }

private:
  static constexpr size_type none = (std::numeric_limits<size_type>::max)();

  static void add_if_valid(Halfedge_index h, std::vector<Halfedge_index>& out)
  {
    if(h.is_valid())
      out.push_back(h);
  }

  // A point on an edge of the fine level, with a ratio between nothing and infinity from the source
  // to the target. Unless it has been moved to an end it is a vertex.
  struct Mark
  {
    Edge_index edge;
    double ratio;
    size_type piece; // that comes to it, until pieces are left out
    Vertex_index vertex;
    size_type kept_before;             // on all edges before, and on this one
    std::array<Halfedge_index, 2> out; // the chords that leave it to the left and to the right
  };

  // where a curve has come into a face: at which corner, after how many pieces and vertices
  struct Entry
  {
    std::size_t corner;
    size_type pieces, vertices;
  };

  enum class End
  {
    none,
    source,
    target
  };

  // to which end of its edge a mark is moved
  static End end_at(double ratio)
  {
    return ratio <= rounding() ? End::source : ratio * rounding() >= 1 ? End::target : End::none;
  }

  // A piece that leaves a vertex of the fine level into a corner of a face, and where the face,
  // counterclockwise from this corner, is met again; at last the order of those along the same
  // edge.
  struct Chord_end
  {
    std::size_t corner;
    std::tuple<std::size_t, size_type, std::ptrdiff_t> order;
    Halfedge_index out;

    friend bool operator<(const Chord_end& a, const Chord_end& b)
    {
      return std::tie(a.corner, a.order) < std::tie(b.corner, b.order);
    }
  };

  static size_type number(std::size_t n)
  {
    if(n >= none / 4)
      throw Intrinsic_triangulations::Overflow_error("too many pieces for a subdivision");
    return static_cast<size_type>(n);
  }

  bool is_fine_vertex(Vertex_index v) const { return v.idx() < m_fine.number_of_vertices(); }

  size_type number_of_fine_pieces() const { return m_first_kept.back() + m_fine.number_of_edges(); }

  Halfedge_index side(const Curve_segment& s, std::size_t n) const
  {
    return Intrinsic_triangulations::sides(s.face, m_fine)[n];
  }

  // the number of the mark where the piece starts becomes that where it ends
  void add_piece(Curve_segment s, Edge_index e, size_type& mark)
  {
    s.face = m_map.fine().level_face(s.face);
    const size_type from = std::exchange(mark, none);
    if(is_pair(s.to.corners)) {
      mark = number(m_marks.size());
      add_crossing(s);
    }
    m_pieces.push_back({s, e, {from, mark}, Vertex_index(), Halfedge_index()});
  }

  void add_crossing(const Curve_segment& s)
  {
    const std::size_t n = side_number(s.to);
    const Halfedge_index h = side(s, n);
    const double from = s.to.weight[n], to = s.to.weight[(n + 1) % 3];
    add_mark(m_fine.edge(h), h.idx() % 2 == 0 ? to / from : from / to, number(m_pieces.size()),
             Vertex_index());
  }

  void add_mark(Edge_index e, double ratio, size_type piece, Vertex_index v)
  {
    m_marks.push_back({e, ratio, piece, v, 0, {}});
  }

  // by edges, and along them
  void sort_marks()
  {
    std::vector<size_type> order(m_marks.size());
    std::iota(order.begin(), order.end(), size_type(0));
    std::stable_sort(order.begin(), order.end(), [&](size_type x, size_type y) {
      return std::pair(m_marks[x].edge, m_marks[x].ratio) <
             std::pair(m_marks[y].edge, m_marks[y].ratio);
    });
    renumber_marks(order);
  }

  // number `n` becomes what has been number `order[n]`
  void renumber_marks(const std::vector<size_type>& order)
  {
    std::vector<Mark> marks;
    std::vector<size_type> place(order.size());
    for(size_type n = 0; n < order.size(); ++n) {
      marks.push_back(m_marks[order[n]]);
      place[order[n]] = n;
    }
    m_marks.swap(marks);
    for(Coarse_piece& piece : m_pieces)
      for(size_type& mark : piece.marks)
        if(mark != none)
          mark = place[mark];
  }

  // Sorts the crossings by their places at first, but it is the curves that tell the order. Then
  // places are made to agree.
  void order_crossings()
  {
    sort_marks();
    std::vector<size_type> order(m_marks.size());
    std::iota(order.begin(), order.end(), size_type(0));
    const Crossing_order curves(m_pieces, m_fine);
    const auto are_exchanged = [&](size_type x, size_type y) {
      return m_marks[x].edge == m_marks[y].edge &&
             curves.compare(m_marks[x].piece, m_marks[y].piece) > 0;
    };
    for(std::size_t n = 1; n < order.size(); ++n)
      for(std::size_t k = n; k > 0 && are_exchanged(order[k - 1], order[k]); --k)
        std::swap(order[k - 1], order[k]);
    renumber_marks(order);
    for(std::size_t n = 1; n < m_marks.size(); ++n)
      if(m_marks[n].edge == m_marks[n - 1].edge)
        m_marks[n].ratio = (std::max)(m_marks[n].ratio, m_marks[n - 1].ratio);
  }

  static double place_on_edge(double ratio) { return std::isinf(ratio) ? 1 : ratio / (1 + ratio); }

  // Moves what is near to an end of an edge there, and cuts off the corners where that leads from a
  // vertex to itself.
  void run_through_near_vertices()
  {
    const std::vector<Coarse_piece> pieces = std::exchange(m_pieces, {});
    const std::vector<size_type> first = std::exchange(m_first_piece, {});
    for(std::size_t e = 0; e + 1 < first.size(); ++e) {
      m_first_piece.push_back(number(m_pieces.size()));
      for(size_type p = first[e]; p < first[e + 1]; ++p)
        keep_piece(pieces[p]);
    }
    m_first_piece.push_back(number(m_pieces.size()));
  }

  void keep_piece(Coarse_piece piece)
  {
    const Curve_segment& s = piece.segment;
    if(s.from.corners != 7)
      m_entry = {corner_near(s, s.from, piece.marks[0]), number(m_pieces.size()),
                 m_number_of_vertices};
    const std::size_t exit = corner_near(s, s.to, piece.marks[1]);
    if(exit < 3 && exit == m_entry.corner) {
      m_pieces.resize(m_entry.pieces);
      m_number_of_vertices = m_entry.vertices;
      return;
    }
    piece.target = exit < 3 ? m_fine.source(side(s, exit)) : new_vertex();
    if(piece.marks[1] != none)
      m_marks[piece.marks[1]].vertex = piece.target;
    if(s.from.corners != 7 && m_entry.corner < 3 && exit < 3)
      m_is_along[Edge_index(edge_along(s, m_entry.corner, exit))] = 1;
    m_pieces.push_back(piece);
  }

  Vertex_index new_vertex()
  {
    const Vertex_index v(m_number_of_vertices);
    m_number_of_vertices = number(m_number_of_vertices + std::size_t(1));
    return v;
  }

  // at which corner a point is or has been moved to; 3 if at none
  std::size_t corner_near(const Curve_segment& s, const Face_point& p, size_type mark) const
  {
    if(is_single(p.corners))
      return corner_number(p);
    const End end = mark == none ? End::none : end_at(m_marks[mark].ratio);
    if(end == End::none)
      return 3;
    const std::size_t n = side_number(p);
    const bool is_at_source = (end == End::source) == (side(s, n).idx() % 2 == 0);
    return is_at_source ? n : (n + 1) % 3;
  }

  void add_fine_bend(Edge_index e, const Curve_segment& s)
  {
    const double ratio = s.to.along[1] / s.to.along[0];
    if(end_at(ratio) != End::none)
      return;
    add_mark(e, ratio, none, new_vertex());
    Surface_map::Location p = location(s);
    p.first = m_map.coarse().level_face(p.first);
    m_fine_bends.push_back(p);
  }

  static Surface_map::Location location(const Curve_segment& s)
  {
    Surface_map::Location p{s.face, s.to.weight};
    normalize(p.second);
    return p;
  }

  // the halfedge of the fine level from one corner to another
  Halfedge_index edge_along(const Curve_segment& s, std::size_t from, std::size_t to) const
  {
    return to == (from + 1) % 3 ? side(s, from) : opposite(side(s, to));
  }

  // An edge of the coarse level that is one of the fine level takes its place. What else runs along
  // that is put into a face at first, in the order in which it comes.
  void number_pieces()
  {
    m_is_taken.assign(number_of_fine_pieces(), 0);
    for(size_type p = 0; p < m_pieces.size(); ++p) {
      const Halfedge_index h = whole_edge(p);
      if(h.is_valid() && number_of_pieces(Edge_index(h)) == 1 && take(fine_piece(h, 0))) {
        m_pieces[p].halfedge = fine_piece(h, 0);
      } else {
        m_pieces[p].halfedge = chord(m_piece_of_chord.size());
        m_piece_of_chord.push_back(p);
      }
    }
  }

  // the halfedge of the fine level that is the edge of a piece, or null
  Halfedge_index whole_edge(size_type p) const
  {
    const Curve_segment& s = m_pieces[p].segment;
    const Edge_index e = m_pieces[p].edge;
    return is_single(s.from.corners) && is_single(s.to.corners) &&
               first_piece(e) + 1 == end_of_pieces(e)
             ? edge_along(s, corner_number(s.from), corner_number(s.to))
             : Halfedge_index();
  }

  // whether no other piece runs along a piece of a fine edge
  bool take(Halfedge_index fine_piece)
  {
    return std::exchange(m_is_taken[fine_piece.idx() / 2], 1) == 0;
  }

  // the first halfedge of a chord
  Halfedge_index chord(std::size_t n) const
  {
    return Halfedge_index(number(2 * (number_of_fine_pieces() + n)));
  }

  template <typename Mesh>
  bool merge_with_fine_piece(Halfedge_index& h, const Mesh& mesh)
  {
    for(Halfedge_index side : {h, opposite(h)}) {
      const Halfedge_index other = mesh.next(side);
      if(mesh.next(other) == side && other.idx() / 2 < number_of_fine_pieces() && take(other)) {
        h = side == h ? opposite(other) : other;
        return true;
      }
    }
    return false;
  }

  void collect_chords()
  {
    m_chord_ends.clear();
    for(Mark& mark : m_marks)
      mark.out = {};
    for(size_type p : m_piece_of_chord) {
      const Coarse_piece& piece = m_pieces[p];
      const Curve_segment& s = piece.segment;
      add_to_mark(s, s.from, piece.marks[0], piece.halfedge);
      add_to_mark(s, s.to, piece.marks[1], opposite(piece.halfedge));
      if(is_single(s.from.corners)) {
        size_type end = p;
        while(m_pieces[end].segment.to.corners == 7)
          ++end;
        add_chord_end(p, s.from, m_pieces[end].segment.to, m_pieces[end].marks[1], piece.halfedge);
      }
      if(is_single(s.to.corners)) {
        size_type start = p;
        while(m_pieces[start].segment.from.corners == 7)
          --start;
        add_chord_end(p, s.to, m_pieces[start].segment.from, m_pieces[start].marks[0],
                      opposite(piece.halfedge));
      }
    }
    std::sort(m_chord_ends.begin(), m_chord_ends.end());
  }

  void add_to_mark(const Curve_segment& s, const Face_point& end, size_type mark,
                   Halfedge_index out)
  {
    if(mark != none)
      m_marks[mark].out[side(s, side_number(end)).idx() % 2] = out;
  }

  void add_chord_end(size_type piece, const Face_point& at_corner, const Face_point& other,
                     size_type other_mark, Halfedge_index out)
  {
    const Face_index f = m_pieces[piece].segment.face;
    const std::size_t c = corner_number(at_corner);
    if(other_mark == none) {
      const std::size_t turn = (corner_number(other) + 3 - c) % 3;
      const auto p = static_cast<std::ptrdiff_t>(piece);
      m_chord_ends.push_back({corner_index(f, c), {turn, 0, turn == 1 ? p : -p}, out});
    } else {
      const std::size_t n = side_number(other);
      const size_type mark = mark_along(Intrinsic_triangulations::sides(f, m_fine)[n], other_mark);
      m_chord_ends.push_back({corner_index(f, c), {(n + 3 - c) % 3, 1 + mark, 0}, out});
    }
  }

  static std::size_t corner_index(Face_index f, std::size_t c) { return 3 * std::size_t(f) + c; }

  // the number of a mark on the halfedge `h` of the fine level, counted from its source
  size_type mark_along(Halfedge_index h, size_type mark) const
  {
    const Edge_index e(h);
    return h.idx() % 2 == 0 ? mark - m_first_mark[e] : m_first_mark[e + 1] - 1 - mark;
  }

  // the pieces on the two sides of a mark, in the direction of the first halfedge
  Halfedge_index before_mark(size_type mark) const
  {
    return Halfedge_index(2 * (m_marks[mark].kept_before + m_marks[mark].edge.idx()));
  }
  Halfedge_index after_mark(size_type mark) const
  {
    return Halfedge_index(2 * (m_marks[mark].kept_before + m_marks[mark].edge.idx() + 1));
  }

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
    const bool is_first = h.idx() % 2 == 0;
    const auto mark = [&](size_type n) -> const Mark& {
      return m_marks[is_first ? m_first_mark[e] + n : m_first_mark[e + 1] - 1 - n];
    };
    const End source = is_first ? End::source : End::target;
    size_type moved = 0;
    for(; moved < m_first_mark[e + 1] - m_first_mark[e] && end_at(mark(moved).ratio) == source;
        ++moved)
      add_if_valid(mark(moved).out[is_first ? 1 : 0], out);
    out.push_back(fine_piece(h, 0));
    while(moved-- > 0)
      add_if_valid(mark(moved).out[is_first ? 0 : 1], out);
  }

  static Subdivision_place vertex_place(Vertex_index v, const Delta_complex& mesh)
  {
    if(mesh.is_isolated(v))
      return {Halfedge_index(), {}};
    return edge_place(Intrinsic_triangulations::first_spoke(v, mesh), 0, mesh);
  }

  static Subdivision_place edge_place(Halfedge_index h, double t, const Delta_complex& mesh)
  {
    namespace IT = Intrinsic_triangulations;
    IT::Edge_point<double> p{h, t};
    if(mesh.is_border(h))
      p = IT::reversed(p, mesh);
    return {p.halfedge, IT::face_location(p, mesh)};
  }

  const Surface_map& m_map;
  const Delta_complex &m_fine, &m_coarse;
  size_type m_number_of_vertices;
  std::vector<Coarse_piece> m_pieces;
  Entry m_entry{};
  std::vector<size_type> m_first_piece;  // of each edge of the coarse level
  std::vector<size_type> m_piece_before; // of each vertex inside an edge of the coarse level
  std::vector<char>
    m_is_along; // whether an edge of the coarse level runs along one of the fine level
  std::vector<char> m_is_taken; // whether one runs along a piece of an edge of the fine level
  std::vector<Mark> m_marks;    // in the order of edges and along them
  std::vector<size_type> m_first_mark; // of each edge of the fine level
  std::vector<size_type>
    m_first_kept; // the same, not counting those that have been moved to an end
  std::vector<size_type> m_mark_of_vertex;
  std::vector<size_type>
    m_piece_of_chord;                  // of each edge that is no part of an edge of the fine level
  std::vector<Chord_end> m_chord_ends; // in the order of corners and counterclockwise around them
  size_type m_first_fine_bend = none;
  std::vector<Surface_map::Location> m_fine_bends;
};

// A point as a point of the face `f` that is nearest across an edge, or the corner at a vertex that
// they share; no face if `f` is not next to it.
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

} // namespace internal
} // namespace Intrinsic_simplification
} // namespace CGAL

#endif // CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_MAPS_SUBDIVISION_MARKS_H
