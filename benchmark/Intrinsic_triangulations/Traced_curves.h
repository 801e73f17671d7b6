// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_BENCHMARK_TRACED_CURVES_H
#define INTRINSIC_BENCHMARK_TRACED_CURVES_H

#include "method.h"

#include <CGAL/Intrinsic_triangulations/Edge_point.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace Methods {

// An edge of T2 as it was traced over T1.
struct Traced_curve
{
  Halfedge_index halfedge;                       // of T2, from the start of the curve
  std::vector<IT::Edge_point<double>> crossings; // where it leaves faces of T1
  Face_index end;                                // the face in which it ends
};

// Finds out whether traced curves are the edges of a triangulation with the connectivity of T2, and
// counts the pieces into which they cut T1. The curves must start and end at the right vertices,
// must not meet each other, and must leave every vertex in the order of T2. T1 has no loops and no
// parallel edges.
class Traced_curves
{
public:
  Traced_curves(const Delta_complex& input, const Delta_complex& mesh)
    : m_input(input),
      m_mesh(mesh),
      m_on_edge(input.number_of_edges()),
      m_in_corner(input.number_of_halfedges()),
      m_shared(input.number_of_halfedges())
  {}

  // Throws Failure if the curve does not lead from vertex to vertex.
  void add(Traced_curve curve)
  {
    trim(curve);
    if(curve.crossings.empty())
      return add_shared(curve.halfedge);
    check_continuity(curve);
    const std::size_t c = m_curves.size(), last = curve.crossings.size() - 1;
    add_end(curve.halfedge, curve.crossings.front().halfedge, {c, 0});
    add_end(m_mesh.opposite(curve.halfedge), m_input.opposite(curve.crossings.back().halfedge),
            {c, last});
    for(std::size_t k = 0; k <= last; ++k) {
      const auto& p = curve.crossings[k];
      m_on_edge[m_input.edge(p.halfedge)].push_back({is_first(p.halfedge) ? p.t : 1 - p.t, {c, k}});
    }
    m_curves.push_back(std::move(curve));
  }

  // Throws Failure if the curves meet or are in the wrong order.
  Subdivision_size subdivide()
  {
    sort_crossings();
    number_pieces();
    Subdivision_size size{m_input.number_of_vertices(), m_input.number_of_edges(),
                          m_input.number_of_faces()};
    for(Face_index f : m_input.faces()) {
      const std::size_t pieces = count_pieces(f);
      size.edges += pieces;
      size.faces += pieces;
    }
    for(const auto& crossings : m_on_edge) {
      size.vertices += crossings.size();
      size.edges += crossings.size();
    }
    for(Vertex_index v : m_input.vertices())
      if(!m_input.is_isolated(v))
        check_order(v);
    return size;
  }

private:
  // crossing number `k` of a curve
  struct Crossing
  {
    std::size_t curve, k;
  };
  // a crossing on the first halfedge of its edge
  struct Placed_crossing
  {
    double t;
    Crossing crossing;
  };
  // the end of a curve in a corner, with its crossing of the opposite side
  struct Curve_end
  {
    Halfedge_index halfedge; // of T2
    Crossing crossing;
  };

  // ---- One curve ----

  bool has_corner(Face_index f, Vertex_index v) const
  {
    const Halfedge_index h = m_input.halfedge(f);
    return m_input.source(h) == v || m_input.target(h) == v || m_input.target(m_input.next(h)) == v;
  }

  // The end may be off by some rounding, in any face at the right vertex.
  void trim(Traced_curve& curve) const
  {
    const Vertex_index v = m_mesh.target(curve.halfedge);
    if(!has_corner(curve.end, v))
      throw Failure("a trace does not reach its end");
    auto& crossings = curve.crossings;
    const auto is_at_end = [&](const IT::Edge_point<double>& p) {
      return m_input.source(p.halfedge) == v || m_input.target(p.halfedge) == v;
    };
    while(!crossings.empty() && is_at_end(crossings.back()))
      crossings.pop_back();
  }

  void add_shared(Halfedge_index h)
  {
    const Halfedge_index shared = m_input.halfedge(m_mesh.source(h), m_mesh.target(h));
    if(!shared.is_valid())
      throw Failure("a trace does not reach its end");
    if(m_shared[shared].is_valid())
      throw Failure("two traces coincide");
    m_shared[shared] = h;
    m_shared[m_input.opposite(shared)] = m_mesh.opposite(h);
  }

  void check_continuity(const Traced_curve& curve) const
  {
    for(std::size_t k = 1; k < curve.crossings.size(); ++k) {
      const Halfedge_index entry = m_input.opposite(curve.crossings[k - 1].halfedge);
      const Halfedge_index exit = curve.crossings[k].halfedge;
      if(exit != m_input.next(entry) && exit != m_input.prev(entry))
        throw Failure("a trace runs into a vertex");
    }
  }

  // `h` starts in the corner opposite to `side`, which it crosses.
  void add_end(Halfedge_index h, Halfedge_index side, const Crossing& crossing)
  {
    const Halfedge_index corner = m_input.prev(side);
    if(m_input.is_border(side) || m_input.source(corner) != m_mesh.source(h))
      throw Failure("a trace runs into a vertex");
    m_in_corner[corner].push_back({h, crossing});
  }

  // ---- All curves ----

  void sort_crossings()
  {
    for(const Traced_curve& curve : m_curves)
      m_rank.emplace_back(curve.crossings.size());
    for(auto& crossings : m_on_edge) {
      std::stable_sort(
        crossings.begin(), crossings.end(),
        [](const Placed_crossing& p, const Placed_crossing& q) { return p.t < q.t; });
      for(std::size_t rank = 0; rank < crossings.size(); ++rank)
        rank_of(crossings[rank].crossing) = rank;
    }
    for(Halfedge_index corner : m_input.halfedges())
      sort_ends(corner);
  }

  // along the first halfedge of its edge
  std::size_t& rank_of(const Crossing& c) { return m_rank[c.curve][c.k]; }

  static bool is_first(Halfedge_index h) { return h.idx() % 2 == 0; }

  // counterclockwise
  void sort_ends(Halfedge_index corner)
  {
    auto& ends = m_in_corner[corner];
    const bool is_forward = m_input.is_border(corner) || is_first(m_input.next(corner));
    std::sort(ends.begin(), ends.end(), [&](const Curve_end& a, const Curve_end& b) {
      const std::size_t first = rank_of(a.crossing), second = rank_of(b.crossing);
      return is_forward ? first < second : second < first;
    });
  }

  // Piece k of a curve ends at its crossing k.
  void number_pieces()
  {
    std::size_t number = 0;
    for(const Traced_curve& curve : m_curves) {
      m_first_piece.push_back(number);
      number += curve.crossings.size() + 1;
    }
  }

  // The pieces of curves that meet the boundary of a face, in order along it.
  std::vector<std::size_t> pieces_around(Face_index f) const
  {
    std::vector<std::size_t> result;
    Halfedge_index h = m_input.halfedge(f);
    for(int side = 0; side < 3; ++side, h = m_input.next(h)) {
      const auto& ends = m_in_corner[h];
      for(auto end = ends.rbegin(); end != ends.rend(); ++end)
        result.push_back(piece(end->crossing, m_input.next(h)));
      const std::size_t before = result.size();
      for(const Placed_crossing& p : m_on_edge[m_input.edge(h)])
        result.push_back(piece(p.crossing, h));
      if(!is_first(h))
        std::reverse(result.begin() + static_cast<std::ptrdiff_t>(before), result.end());
    }
    return result;
  }

  // of the curve at this crossing, in the face of `h`
  std::size_t piece(const Crossing& c, Halfedge_index h) const
  {
    const bool leaves = m_curves[c.curve].crossings[c.k].halfedge == h;
    return m_first_piece[c.curve] + c.k + (leaves ? 0 : 1);
  }

  // They must be nested.
  std::size_t count_pieces(Face_index f) const
  {
    std::size_t count = 0;
    std::vector<std::size_t> open;
    for(std::size_t piece : pieces_around(f))
      if(!open.empty() && open.back() == piece) {
        open.pop_back();
        ++count;
      } else
        open.push_back(piece);
    if(!open.empty())
      throw Failure("traces cross each other");
    return count;
  }

  void check_order(Vertex_index v) const
  {
    std::vector<Halfedge_index> traced, expected;
    for_each_spoke(v, m_input, [&](Halfedge_index spoke) {
      if(m_shared[spoke].is_valid())
        traced.push_back(m_shared[spoke]);
      for(const Curve_end& end : m_in_corner[spoke])
        traced.push_back(end.halfedge);
    });
    for_each_spoke(v, m_mesh, [&](Halfedge_index spoke) { expected.push_back(spoke); });
    std::rotate(traced.begin(), std::find(traced.begin(), traced.end(), expected[0]), traced.end());
    if(traced != expected)
      throw Failure("traces leave a vertex in the wrong order");
  }

  template <typename Visit>
  static void for_each_spoke(Vertex_index v, const Delta_complex& mesh, const Visit& visit)
  {
    const Halfedge_index first = IT::first_spoke(v, mesh);
    for(Halfedge_index h = first;;) {
      visit(h);
      if(mesh.is_border(h) || (h = IT::next_spoke(h, mesh)) == first)
        return;
    }
  }

  const Delta_complex &m_input, &m_mesh;
  std::vector<Traced_curve> m_curves;
  std::vector<std::vector<Placed_crossing>> m_on_edge; // of T1
  std::vector<std::vector<Curve_end>> m_in_corner;     // at the source of each halfedge of T1
  std::vector<Halfedge_index> m_shared;                // of T2, for each halfedge of T1
  std::vector<std::vector<std::size_t>> m_rank;        // of each crossing of each curve
  std::vector<std::size_t> m_first_piece;              // of each curve
};

} // namespace Methods

#endif // INTRINSIC_BENCHMARK_TRACED_CURVES_H
