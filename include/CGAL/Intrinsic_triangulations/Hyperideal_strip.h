// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_HYPERIDEAL_STRIP_H
#define CGAL_INTRINSIC_TRIANGULATIONS_HYPERIDEAL_STRIP_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Decorated_length.h>
#include <CGAL/Intrinsic_triangulations/Ideal_strip.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsTraits
/// intersects the inner edges of a strip of triangles with circles at their corners with the
/// geodesic between its ends, in the hyperbolic surface of `Hyperideal_geometry_traits`.
///
/// Circles at the ends of the strip and at the ends of its inner edges have tangents that follow
/// from flips. The four vectors of a crossing satisfy
/// \f$ \alpha_a v_a + \alpha_b v_b = \alpha_i v_i + \alpha_j v_j \f$,
/// where \f$\alpha_x\f$ is the volume that the other three vectors span. All terms are positive. If
/// the strip is given by lengths without radii, it is an `Ideal_strip`.
///
/// \cgalModels `GeodesicStrip`
template <typename FT>
class Hyperideal_strip
{
  typedef Decorated_length<FT> Edge;

  struct Inner_edge
  {
    Edge from_a_to_source, from_a_to_target, edge;
    Edge from_b_to_source, from_b_to_target;
    Edge side;           // of the triangle beyond that is not an inner edge
    bool is_left_around; // whether the strip goes on around the source
  };

public:
  /// a crossing of the geodesic with an inner edge.
  typedef typename Ideal_strip<FT>::Crossing Crossing;

  /// starts a new strip in the triangle \f$aij\f$ that is left through \f$\overrightarrow{ij}\f$.
  void start(const Edge& ai, const Edge& ij, const Edge& ja)
  {
    m_has_radii = true;
    m_edges.clear();
    add_edge(ai, ja.reversed(), ij);
  }

  /// goes on through the triangle \f$jil\f$ beyond the last edge \f$\overrightarrow{ij}\f$ and
  /// leaves it through \f$\overrightarrow{il}\f$.
  void turn_around_source(const Edge& ji, const Edge& lj, const Edge& il)
  {
    const Edge ai = m_edges.back().from_a_to_source, al = from_a_to_apex(ji, lj, il);
    m_edges.back().side = lj;
    m_edges.back().is_left_around = true;
    add_edge(ai, al, il);
  }

  /// goes on through the triangle \f$jil\f$ beyond the last edge \f$\overrightarrow{ij}\f$ and
  /// leaves it through \f$\overrightarrow{lj}\f$.
  void turn_around_target(const Edge& ji, const Edge& lj, const Edge& il)
  {
    const Edge aj = m_edges.back().from_a_to_target, al = from_a_to_apex(ji, lj, il);
    m_edges.back().side = il;
    m_edges.back().is_left_around = false;
    add_edge(al, aj, lj);
  }

  /// ends the strip at the corner \f$l\f$ of the triangle \f$jil\f$ beyond the last edge
  /// \f$\overrightarrow{ij}\f$, and goes back along it. Complexity: linear in the inner edges.
  void finish(const Edge& ji, const Edge& lj, const Edge& il)
  {
    m_length = from_a_to_apex(ji, lj, il);
    m_edges.back().from_b_to_source = il.reversed();
    m_edges.back().from_b_to_target = lj;
    for(std::size_t m = m_edges.size() - 1; m-- > 0;)
      set_from_b(m_edges[m], m_edges[m + 1]);
  }

  /// starts a new strip without radii.
  void start(const FT& ai, const FT& ij, const FT& ja)
  {
    m_has_radii = false;
    m_ideal.start(ai, ij, ja);
  }
  /// goes on without radii.
  void turn_around_source(const FT& ij, const FT& jl, const FT& li)
  {
    m_ideal.turn_around_source(ij, jl, li);
  }
  /// goes on without radii.
  void turn_around_target(const FT& ij, const FT& jl, const FT& li)
  {
    m_ideal.turn_around_target(ij, jl, li);
  }
  /// ends a strip without radii.
  void finish(const FT& ij, const FT& jl, const FT& li) { m_ideal.finish(ij, jl, li); }

  /// returns the number of inner edges.
  std::size_t size() const { return m_has_radii ? m_edges.size() : m_ideal.size(); }

  /// returns the length of the tangent between the circles at the ends. \pre `finish()` has been
  /// called
  const FT& length() const { return m_has_radii ? m_length.tangent : m_ideal.length(); }

  /// returns the crossing of the geodesic with inner edge `m`. \pre `finish()` has been called
  Crossing crossing(std::size_t m) const
  {
    if(!m_has_radii)
      return m_ideal.crossing(m);
    const Inner_edge& x = m_edges[m];
    const FT factor = 1 / (m_length.tangent + (m_length.source_radius + m_length.target_radius));
    const FT without_a =
               volume(x.edge.reversed(), x.from_b_to_source.reversed(), x.from_b_to_target, factor),
             without_b = volume(x.edge, x.from_a_to_target.reversed(), x.from_a_to_source, factor),
             without_i =
               volume(m_length, x.from_b_to_target, x.from_a_to_target.reversed(), factor),
             without_j =
               volume(m_length, x.from_b_to_source, x.from_a_to_source.reversed(), factor);
    const FT on_line = without_a + without_b, on_edge = without_i + without_j;
    return {without_b / on_line, without_j / on_edge, on_edge / on_line};
  }

private:
  static FT volume(const Edge& ij, const Edge& jk, const Edge& ki, const FT& factor)
  {
    using std::sqrt;
    return sqrt(internal::squared_volume(internal::multiplied(ij, factor),
                                         internal::multiplied(jk, factor),
                                         internal::multiplied(ki, factor)));
  }

  void add_edge(const Edge& ai, const Edge& aj, const Edge& ij)
  {
    m_edges.push_back({ai, aj, ij, {}, {}, {}, false});
  }

  // Returns the edge from k to l, the corners opposite to ij.
  static Edge opposite_edge(const Edge& ij, const Edge& jk, const Edge& ki, const Edge& il,
                            const Edge& lj)
  {
    return {internal::Decorated_diamond<FT>(Diamond<Edge>{ij, jk, ki, il, lj}).flipped_tangent(),
            ki.source_radius, lj.source_radius};
  }

  Edge from_a_to_apex(const Edge& ji, const Edge& lj, const Edge& il) const
  {
    const Inner_edge& x = m_edges.back();
    return opposite_edge(ji.reversed(), x.from_a_to_target.reversed(), x.from_a_to_source, il, lj);
  }

  // Finds the edges from b to the ends of an edge ij from those to the next edge, il or lj.
  static void set_from_b(Inner_edge& x, const Inner_edge& next)
  {
    const bool is_left = x.is_left_around;
    const Edge ji = x.edge.reversed();
    const Edge other =
      opposite_edge(next.edge.reversed(), next.from_b_to_source.reversed(), next.from_b_to_target,
                    is_left ? x.side : ji, is_left ? ji : x.side);
    x.from_b_to_source = is_left ? next.from_b_to_source : other;
    x.from_b_to_target = is_left ? other : next.from_b_to_target;
  }

  Ideal_strip<FT> m_ideal;
  bool m_has_radii = false;
  std::vector<Inner_edge> m_edges;
  Edge m_length{};
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_HYPERIDEAL_STRIP_H
