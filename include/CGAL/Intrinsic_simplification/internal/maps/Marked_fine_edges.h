// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_MAPS_MARKED_FINE_EDGES_H
#define CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_MAPS_MARKED_FINE_EDGES_H

#include <CGAL/license/Intrinsic_simplification.h>

#include <CGAL/Intrinsic_simplification/internal/maps/Crossing_order.h>
#include <CGAL/Intrinsic_simplification/internal/maps/Traced_curves.h>
#include <CGAL/Intrinsic_triangulations/Edge_marks.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_simplification::internal {

using Intrinsic_triangulations::first_halfedge;
using Intrinsic_triangulations::is_first_halfedge;

// Stores the marks on the edges of the fine level, in their order, and the pieces of the edges of
// the coarse level between them. Vertices of a subdivision are vertices of the fine level, vertices
// that only the coarse level has, marks, and bends. A vertex on the boundary that only the coarse
// level has is a mark, too.
//
// Curves that reach a vertex within rounding run through it. Their marks on the edges at the vertex
// are moved to the vertex, in their order along the edge. So curves that did not cross before do
// not cross afterwards. Marks that have not been moved are kept.
class Marked_fine_edges
{
public:
  typedef Intrinsic_triangulations::Edge_marks Edge_marks;

  // Finds the marks, with or without bends of edges of the fine level on the coarse surface. Edges
  // of the coarse level are traced in this mode.
  Marked_fine_edges(const Surface_map& map, bool with_fine_bends, Tracing_mode mode)
    : m_map(map),
      m_fine(map.fine().mesh()),
      m_mode(mode),
      m_rounding(rounding(mode)),
      m_number_of_vertices(m_fine.number_of_vertices())
  {
    Traced_curves traced(map, mode);
    order_crossings(traced);
    number_new_vertices();
    m_is_along.assign(m_fine.number_of_edges(), 0);
    run_through_near_vertices(traced);
    m_first_fine_bend = m_number_of_vertices;
    add_new_border_vertices();
    if(with_fine_bends)
      add_fine_bends();
    sort_marks(ratios(), m_marks, m_pieces);
    number_marks();
    m_piece_before.assign(m_number_of_vertices, no_index);
    for_each_vertex_on_edge([&](Vertex_index v, Curve_index p) { m_piece_before[v] = p; });
  }

  const Surface_map& map() const { return m_map; }
  Tracing_mode mode() const { return m_mode; }
  Curve_index number_of_vertices() const { return m_number_of_vertices; }
  bool is_fine_vertex(Vertex_index v) const { return v.idx() < m_fine.number_of_vertices(); }

  // ---- Vertices that only the coarse level has ----

  bool is_new_vertex(Vertex_index v) const
  {
    return !is_fine_vertex(v) && v.idx() - m_fine.number_of_vertices() < m_new_vertices.size();
  }

  // Returns the vertex of the subdivision for a vertex that only the coarse level has.
  Vertex_index new_vertex(Vertex_index v) const
  {
    return m_new_vertices[v.idx() - m_fine.number_of_vertices()];
  }
  const std::vector<Vertex_index>& new_vertices() const { return m_new_vertices; }

  // Returns the curves along the edges of the coarse level.
  Curve_strands strands() const { return {m_pieces, m_first_piece, m_map.coarse().mesh()}; }

  // Returns the first piece of an edge that starts at the vertex `v` of the coarse level.
  Strand first_strand(Vertex_index v) const
  {
    return strands().first(first_outgoing_halfedge(v, m_map.coarse().mesh()));
  }

  // ---- Pieces of edges of the coarse level ----

  const std::vector<Coarse_piece>& pieces() const { return m_pieces; }
  Curve_index first_piece(Edge_index e) const { return m_first_piece[e.idx()]; }
  Curve_index end_of_pieces(Edge_index e) const { return m_first_piece[e.idx() + 1]; }

  // Returns the piece that ends at a vertex inside an edge of the coarse level, otherwise none.
  Curve_index piece_before(Vertex_index v) const { return m_piece_before[v.idx()]; }

  // Calls visit(v, p) for each vertex between two pieces of an edge; `p` is the first piece.
  template <typename Visit>
  void for_each_vertex_on_edge(const Visit& visit) const
  {
    for(Curve_index p = 0; p + 1 < m_pieces.size(); ++p)
      if(m_pieces[p].edge == m_pieces[p + 1].edge)
        visit(m_pieces[p].target, p);
  }

  // ---- Marks ----

  const Curve_mark& mark(Curve_index n) const { return m_marks[n]; }
  Curve_index mark_of(Vertex_index v) const { return m_mark_of_vertex[v.idx()]; }
  Curve_index mark_of_coarse(Vertex_index v) const { return mark_of(m_vertex_of_coarse[v.idx()]); }

  const Edge_marks& numbers() const { return m_numbers; }
  const Edge_marks& kept() const { return m_kept; }

  // Returns the pieces on the two sides of a mark that is kept, in the direction of the first
  // halfedge.
  std::pair<Halfedge_index, Halfedge_index> pieces_around_mark(Curve_index n) const
  {
    const Halfedge_index h = first_halfedge(m_marks[n].edge);
    return {m_kept.piece(h, m_kept_before[n]), m_kept.piece(h, m_kept_before[n] + 1)};
  }

  // Returns whether a mark is moved to the source of the halfedge `h`.
  bool is_at_source(Halfedge_index h, Curve_index n) const
  {
    const double ratio = m_marks[n].ratio;
    return is_first_halfedge(h) ? ratio <= m_rounding : is_at_target_of_first(ratio);
  }

  // ---- Bends of edges of the fine level ----

  bool is_fine_bend(Vertex_index v) const { return v.idx() >= m_first_fine_bend; }
  const Surface_map::Location& fine_bend(Vertex_index v) const
  {
    return m_fine_bends[v.idx() - m_first_fine_bend];
  }

private:
  typedef std::vector<Curve_mark> Marks;
  typedef std::vector<Coarse_piece> Pieces;

  // Stores where a curve has entered a face: its corner, and the numbers of pieces and vertices
  // before.
  struct Entry
  {
    std::size_t corner;
    Curve_index pieces, vertices;
  };

  bool is_at_target_of_first(double ratio) const
  {
    return !(ratio <= m_rounding) && ratio * m_rounding >= 1;
  }
  bool is_kept(double ratio) const
  {
    return !(ratio <= m_rounding) && !is_at_target_of_first(ratio);
  }

  // ---- The order ----

  // The curves determine the final order of crossings, which are sorted by their positions. Then
  // positions are changed to agree with it.
  void order_crossings(Traced_curves& traced) const
  {
    Marks& marks = traced.marks;
    std::vector<Curve_index> order = indices(marks.size());
    Crossing_order curves(traced, m_map);
    const auto are_exchanged = [&](Curve_index x, Curve_index y) {
      return marks[x].edge == marks[y].edge && curves.compare(marks[x].piece, marks[y].piece) > 0;
    };
    for(std::size_t n = 1; n < order.size(); ++n)
      for(std::size_t k = n; k > 0 && are_exchanged(order[k - 1], order[k]); --k)
        std::swap(order[k - 1], order[k]);
    renumber(order, marks, traced.pieces);
    for(std::size_t n = 1; n < marks.size(); ++n)
      if(marks[n].edge == marks[n - 1].edge)
        marks[n].ratio = (std::max)(marks[n].ratio, marks[n - 1].ratio);
  }

  std::vector<double> ratios() const
  {
    std::vector<double> result;
    result.reserve(m_marks.size());
    for(const Curve_mark& mark : m_marks)
      result.push_back(mark.ratio);
    return result;
  }

  void number_marks()
  {
    std::vector<Curve_index> all(m_fine.number_of_edges(), 0), kept(all);
    m_mark_of_vertex.assign(m_number_of_vertices, no_index);
    for(Curve_index n = 0; n < m_marks.size(); ++n) {
      const std::size_t e = m_marks[n].edge;
      m_kept_before.push_back(kept[e]);
      ++all[e];
      if(is_kept(m_marks[n].ratio)) {
        ++kept[e];
        m_mark_of_vertex[m_marks[n].vertex] = n;
      }
    }
    m_numbers = Edge_marks(std::move(all));
    m_kept = Edge_marks(std::move(kept));
  }

  // ---- Vertices ----

  void number_new_vertices()
  {
    const Surface_level &fine = m_map.fine(), &coarse = m_map.coarse();
    m_vertex_of_coarse.reserve(coarse.mesh().number_of_vertices());
    for(Vertex_index v : coarse.mesh().vertices()) {
      m_vertex_of_coarse.push_back(fine.level_vertex(coarse.surface_vertex(v)));
      if(!m_vertex_of_coarse.back().is_valid()) {
        m_vertex_of_coarse.back() = add_vertex();
        m_new_vertices.push_back(v);
      }
    }
  }

  // Adds vertices on the boundary as marks that are kept, at any position.
  void add_new_border_vertices()
  {
    for(Vertex_index v : m_new_vertices) {
      if(!m_map.coarse().mesh().is_border(v))
        continue;
      const Strand s = first_strand(v);
      const Curve_segment& segment = m_pieces[s.piece].segment;
      const auto [edge, ratio] =
        edge_ratio(segment, s.is_forward ? segment.from : segment.to, m_fine);
      const double least = 2 * m_rounding;
      m_marks.push_back(
        {edge, std::clamp(ratio, least, 1 / least), no_index, m_vertex_of_coarse[v]});
    }
  }

  Vertex_index add_vertex()
  {
    const Vertex_index v(m_number_of_vertices);
    m_number_of_vertices = checked_index(m_number_of_vertices + std::size_t(1));
    return v;
  }

  // Moves marks near an end of an edge to this end. Cuts off corners if this connects a vertex to
  // itself.
  void run_through_near_vertices(Traced_curves& traced)
  {
    m_marks = std::move(traced.marks);
    Entry entry{};
    for(std::size_t e = 0; e + 1 < traced.first_piece.size(); ++e) {
      m_first_piece.push_back(checked_index(m_pieces.size()));
      for(Curve_index p = traced.first_piece[e]; p < traced.first_piece[e + 1]; ++p)
        keep_piece(traced.pieces[p], p == traced.first_piece[e], p + 1 == traced.first_piece[e + 1],
                   entry);
    }
    m_first_piece.push_back(checked_index(m_pieces.size()));
  }

  void keep_piece(Coarse_piece piece, bool is_first, bool is_last, Entry& entry)
  {
    const Curve_segment& s = piece.segment;
    if(is_first || !is_bend(s.from))
      entry = {corner_near(s, s.from, piece.marks[0]), checked_index(m_pieces.size()),
               m_number_of_vertices};
    const std::size_t exit = corner_near(s, s.to, piece.marks[1]);
    if(exit < 3 && exit == entry.corner) {
      m_pieces.resize(entry.pieces);
      m_number_of_vertices = entry.vertices;
      return;
    }
    const auto side = Intrinsic_triangulations::sides(s.face, m_fine);
    piece.target = exit < 3 ? m_fine.source(side[exit])
                   : is_last
                     ? m_vertex_of_coarse[m_map.coarse().mesh().target(first_halfedge(piece.edge))]
                     : add_vertex();
    if(piece.marks[1] != no_index)
      m_marks[piece.marks[1]].vertex = piece.target;
    if(!is_bend(s.from) && entry.corner < 3 && exit < 3)
      m_is_along[Edge_index(edge_along(s, entry.corner, exit, m_fine))] = 1;
    m_pieces.push_back(piece);
  }

  // Returns the corner that a point is at or has been moved to, or 3 if it is at none.
  std::size_t corner_near(const Curve_segment& s, const Face_point& p, Curve_index mark) const
  {
    if(is_at_corner(p))
      return corner_number(p);
    if(mark == no_index || is_kept(m_marks[mark].ratio))
      return 3;
    const std::size_t n = side_number(p);
    return is_at_source(side_of_end(s, p, m_fine), mark) ? n : (n + 1) % 3;
  }

  // Adds bends of edges of the fine level. Edges of the coarse level have been traced before: an
  // edge along which they run has no bends.
  void add_fine_bends()
  {
    Curve_tracer tracer(m_map, true);
    for(Edge_index e : m_fine.edges())
      if(!m_is_along[e]) {
        const auto& segments = tracer.trace(first_halfedge(e));
        for(std::size_t n = 0; n + 1 < segments.size(); ++n)
          if(is_bend(segments[n].to))
            add_fine_bend(e, segments[n]);
      }
  }

  void add_fine_bend(Edge_index e, const Curve_segment& s)
  {
    const double ratio = s.to.along[1] / s.to.along[0];
    if(!is_kept(ratio))
      return;
    m_marks.push_back({e, ratio, no_index, add_vertex()});
    Surface_map::Location p{m_map.coarse().level_face(s.face), s.to.weight};
    normalize(p.second);
    m_fine_bends.push_back(p);
  }

  const Surface_map& m_map;
  const Delta_complex& m_fine;
  Tracing_mode m_mode;
  double m_rounding;
  Curve_index m_number_of_vertices, m_first_fine_bend = no_index;
  std::vector<Vertex_index> m_vertex_of_coarse; // of each vertex of the coarse level
  std::vector<Vertex_index> m_new_vertices;     // vertices of the coarse level only
  Pieces m_pieces;
  std::vector<Curve_index> m_first_piece; // of each edge of the coarse level, and the end
  std::vector<Curve_index> m_piece_before, m_mark_of_vertex; // of each vertex
  Marks m_marks;                                             // in the order of edges and along them
  Edge_marks m_numbers, m_kept;
  std::vector<Curve_index> m_kept_before; // the number of kept marks before each on its edge
  std::vector<char> m_is_along; // whether an edge of the coarse level runs along a fine edge
  std::vector<Surface_map::Location> m_fine_bends;
};

} // namespace CGAL::Intrinsic_simplification::internal

#endif // CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_MAPS_MARKED_FINE_EDGES_H
