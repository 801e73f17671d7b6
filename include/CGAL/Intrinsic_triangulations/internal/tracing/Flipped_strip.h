// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_FLIPPED_STRIP_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_FLIPPED_STRIP_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <cstddef>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Represents a strip of hyperbolic triangles from the corner a to the corner b. Edges from a and b
// to the ends of its inner edges follow from flips. `Flip` has
// - `Edge`, the type of an edge with an orientation,
// - `reversed(edge)`, which returns the edge with the other orientation,
// - `flipped(ij, jk, ki, il, lj)`, which returns the edge kl instead of ij.
template <typename Flip>
class Flipped_strip
{
public:
  typedef typename Flip::Edge Edge;

  struct Inner_edge
  {
    Edge from_a_to_source, from_a_to_target, edge;
    Edge from_b_to_source, from_b_to_target;
    Edge side;           // the outer side of the triangle beyond
    bool is_left_around; // whether the strip continues around the source
  };

  // Starts in the triangle aij that is left through ij.
  void start(const Edge& ai, const Edge& ij, const Edge& ja)
  {
    m_edges.clear();
    add_edge(ai, Flip::reversed(ja), ij);
  }

  // Continues through the triangle jil beyond the last edge ij and leaves it through il.
  void turn_around_source(const Edge& ji, const Edge& lj, const Edge& il)
  {
    const Edge ai = m_edges.back().from_a_to_source, al = from_a_to_apex(ji, lj, il);
    m_edges.back().side = lj;
    m_edges.back().is_left_around = true;
    add_edge(ai, al, il);
  }

  // Leaves the triangle through lj.
  void turn_around_target(const Edge& ji, const Edge& lj, const Edge& il)
  {
    const Edge aj = m_edges.back().from_a_to_target, al = from_a_to_apex(ji, lj, il);
    m_edges.back().side = il;
    m_edges.back().is_left_around = false;
    add_edge(al, aj, lj);
  }

  // Ends at the corner l of the triangle jil, which is b, and returns along the strip.
  void finish(const Edge& ji, const Edge& lj, const Edge& il)
  {
    m_line = from_a_to_apex(ji, lj, il);
    m_edges.back().from_b_to_source = Flip::reversed(il);
    m_edges.back().from_b_to_target = lj;
    for(std::size_t m = m_edges.size() - 1; m-- > 0;)
      set_from_b(m_edges[m], m_edges[m + 1]);
  }

  std::size_t size() const { return m_edges.size(); }
  const Inner_edge& operator[](std::size_t m) const { return m_edges[m]; }

  // Returns the edge from a to b.
  const Edge& line() const { return m_line; }

private:
  void add_edge(const Edge& ai, const Edge& aj, const Edge& ij)
  {
    m_edges.push_back({ai, aj, ij, Edge{}, Edge{}, Edge{}, false});
  }

  Edge from_a_to_apex(const Edge& ji, const Edge& lj, const Edge& il) const
  {
    const Inner_edge& x = m_edges.back();
    return Flip::flipped(Flip::reversed(ji), Flip::reversed(x.from_a_to_target), x.from_a_to_source,
                         il, lj);
  }

  // Computes the edges from b to the ends of the next edge, il or lj, from the edges to the ends of
  // the edge ij.
  static void set_from_b(Inner_edge& x, const Inner_edge& next)
  {
    const auto other = [&](const Edge& after, const Edge& before) {
      return Flip::flipped(Flip::reversed(next.edge), Flip::reversed(next.from_b_to_source),
                           next.from_b_to_target, after, before);
    };
    const auto& ji = Flip::reversed(x.edge);
    x.from_b_to_source = x.is_left_around ? next.from_b_to_source : other(ji, x.side);
    x.from_b_to_target = x.is_left_around ? other(x.side, ji) : next.from_b_to_target;
  }

  std::vector<Inner_edge> m_edges;
  Edge m_line{};
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_FLIPPED_STRIP_H
