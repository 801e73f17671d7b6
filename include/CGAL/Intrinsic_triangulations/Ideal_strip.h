// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_IDEAL_STRIP_H
#define CGAL_INTRINSIC_TRIANGULATIONS_IDEAL_STRIP_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <cstddef>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsTraits
/// intersects the inner edges of a strip of decorated ideal triangles with the geodesic between its
/// ends.
///
/// This computes what a layout in the light cone would give (Equations 4.6 to 4.9), but from Penner
/// lengths alone: those between the ends of the strip and the ends of its inner edges follow from
/// Ptolemy's relation, and the four light-like vectors of a crossing satisfy
/// \f$ \alpha_a q_a + \alpha_b q_b = \alpha_i q_i + \alpha_j q_j \f$,
/// where \f$\alpha_x\f$ is the product of the three Penner lengths among the other three. All terms
/// are positive: no digit is cancelled, and with an exact number type every result is exact. An
/// object can be used again; it then allocates no memory.
///
/// \cgalModels `GeodesicStrip`
template <typename FT>
class Ideal_strip
{
  struct Inner_edge
  {
    FT from_a_to_source, from_a_to_target, length;
    FT from_b_to_source, from_b_to_target;
    FT side;             // of the triangle beyond that is not an inner edge
    bool is_left_around; // whether the strip goes on around the source
  };

public:
  /// a crossing of the geodesic with an inner edge:
  /// \f$(1-s) q_a + s q_b = \mu ((1-t) q_i + t q_j)\f$ in the light cone.
  struct Crossing
  {
    FT along_line, ///< \f$s\f$, in \f$[0,1]\f$
      along_edge,  ///< \f$t\f$, in \f$[0,1]\f$
      scale;       ///< \f$\mu\f$, positive
  };

  /// starts a new strip in the triangle \f$aij\f$ that is left through \f$\overrightarrow{ij}\f$.
  void start(const FT& ai, const FT& ij, const FT& ja)
  {
    m_edges.clear();
    add_edge(ai, ja, ij);
  }

  /// goes on through the triangle \f$jil\f$ beyond the last edge \f$\overrightarrow{ij}\f$ and
  /// leaves it through \f$\overrightarrow{il}\f$.
  void turn_around_source(const FT& ij, const FT& jl, const FT& li)
  {
    const FT ai = m_edges.back().from_a_to_source, al = from_a_to_apex(ij, jl, li);
    m_edges.back().side = jl;
    m_edges.back().is_left_around = true;
    add_edge(ai, al, li);
  }

  /// goes on through the triangle \f$jil\f$ beyond the last edge \f$\overrightarrow{ij}\f$ and
  /// leaves it through \f$\overrightarrow{lj}\f$.
  void turn_around_target(const FT& ij, const FT& jl, const FT& li)
  {
    const FT aj = m_edges.back().from_a_to_target, al = from_a_to_apex(ij, jl, li);
    m_edges.back().side = li;
    m_edges.back().is_left_around = false;
    add_edge(al, aj, jl);
  }

  /// ends the strip at the corner \f$l\f$ of the triangle \f$jil\f$ beyond the last edge
  /// \f$\overrightarrow{ij}\f$, and goes back along it. Complexity: linear in the inner edges.
  void finish(const FT& ij, const FT& jl, const FT& li)
  {
    m_length = from_a_to_apex(ij, jl, li);
    m_edges.back().from_b_to_source = li;
    m_edges.back().from_b_to_target = jl;
    for(std::size_t m = m_edges.size() - 1; m-- > 0;)
      set_from_b(m_edges[m], m_edges[m + 1]);
  }

  /// returns the number of inner edges.
  std::size_t size() const { return m_edges.size(); }

  /// returns the Penner length of the geodesic. \pre `finish()` has been called
  const FT& length() const { return m_length; }

  /// returns the crossing of the geodesic with inner edge `m`. \pre `finish()` has been called
  Crossing crossing(std::size_t m) const
  {
    const Inner_edge& edge = m_edges[m];
    const FT &ai = edge.from_a_to_source, &aj = edge.from_a_to_target;
    const FT &bi = edge.from_b_to_source, &bj = edge.from_b_to_target;
    // of the products of three lengths only quotients are needed, which stay in range
    const FT a_to_b = (bi / ai) * (bj / aj), i_to_j = (bj / bi) * (aj / ai);
    const FT b_to_j = (m_length / edge.length) * (bi / aj);
    return {1 / (1 + a_to_b), 1 / (1 + i_to_j), b_to_j * (1 + i_to_j) / (1 + a_to_b)};
  }

private:
  void add_edge(const FT& ai, const FT& aj, const FT& ij)
  {
    m_edges.push_back({ai, aj, ij, FT(0), FT(0), FT(0), false});
  }

  // Ptolemy's relation (Equation 4.4): the length between the corners opposite to ij of the
  // triangles aij and jil
  static FT opposite_length(const FT& ij, const FT& ai, const FT& aj, const FT& jl, const FT& li)
  {
    return (ai * jl + aj * li) / ij;
  }

  FT from_a_to_apex(const FT& ij, const FT& jl, const FT& li) const
  {
    const Inner_edge& edge = m_edges.back();
    return opposite_length(ij, edge.from_a_to_source, edge.from_a_to_target, jl, li);
  }

  // Finds the lengths from b to the ends of an edge ij from those to the next edge, il or lj.
  static void set_from_b(Inner_edge& edge, const Inner_edge& next)
  {
    const FT &bn = next.from_b_to_source, &bm = next.from_b_to_target;
    if(edge.is_left_around) {
      edge.from_b_to_source = bn;
      edge.from_b_to_target = opposite_length(next.length, bn, bm, edge.side, edge.length);
    } else {
      edge.from_b_to_source = opposite_length(next.length, bn, bm, edge.length, edge.side);
      edge.from_b_to_target = bm;
    }
  }

  std::vector<Inner_edge> m_edges;
  FT m_length{};
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_IDEAL_STRIP_H
