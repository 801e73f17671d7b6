// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_IDEAL_STRIP_H
#define CGAL_INTRINSIC_TRIANGULATIONS_IDEAL_STRIP_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsTraits
/// intersects the inner edges of a strip of ideal triangles with the geodesic between its ends.
///
/// This computes what a layout in the light cone gives (Equations 4.6 to 4.9), without one: Ptolemy's
/// relation gives the Penner lengths from both ends of the geodesic to all vertices of the strip, and
/// the four points of a crossing have one linear relation, whose coefficients are products of
/// such lengths. All numbers are positive, so no digit is lost, however long the strip or different the
/// lengths.
///
/// The strip leaves the corner \f$a\f$ of a first triangle through the opposite side
/// \f$\overrightarrow{ij}\f$, goes on from triangle to triangle and ends at a corner \f$b\f$. An object can
/// be used again; it then allocates no memory.
///
/// \cgalModels `GeodesicStrip`
template <typename FT>
class Ideal_strip
{
  // the Penner lengths from an end of the geodesic to those of an inner edge
  struct Lengths
  {
    FT source, target;
  };

  // an inner edge, and the triangle before it
  struct Inner_edge
  {
    FT length;       // of the edge
    Lengths from_a;  // from the start of the geodesic
    FT to_source;    // the sides of the triangle from the vertex that the edge before does not have
    FT to_target;    // to the ends of the edge before
    bool has_source; // whether the edge before starts at the same vertex
  };

public:
  /// a crossing of the geodesic with an inner edge. With vectors \f$q\f$ in the light cone,
  /// \f$(1-s)\,q_a + s\,q_b = \mu\,((1-t)\,q_i + t\,q_j)\f$.
  struct Crossing
  {
    FT along_line, ///< \f$s\f$
      along_edge,  ///< \f$t\f$
      scale;       ///< \f$\mu\f$
  };

  /// starts a new strip in the triangle \f$aij\f$ that is left through \f$\overrightarrow{ij}\f$.
  void start(const FT& ai, const FT& ij, const FT& ja)
  {
    m_edges.clear();
    m_edges.push_back({ij, {ai, ja}, FT(0), FT(0), true});
  }

  /// goes on through the triangle \f$jil\f$ beyond the last edge \f$\overrightarrow{ij}\f$ and leaves it
  /// through \f$\overrightarrow{il}\f$.
  void turn_around_source(const FT& ij, const FT& jl, const FT& li)
  {
    const Lengths from_a = m_edges.back().from_a;
    m_edges.push_back({li, {from_a.source, to_apex(from_a, ij, jl, li)}, li, jl, true});
  }

  /// goes on through the triangle \f$jil\f$ beyond the last edge \f$\overrightarrow{ij}\f$ and leaves it
  /// through \f$\overrightarrow{lj}\f$.
  void turn_around_target(const FT& ij, const FT& jl, const FT& li)
  {
    const Lengths from_a = m_edges.back().from_a;
    m_edges.push_back({jl, {to_apex(from_a, ij, jl, li), from_a.target}, li, jl, false});
  }

  /// ends the strip at the corner \f$b = l\f$ of the triangle \f$jil\f$ beyond the last edge
  /// \f$\overrightarrow{ij}\f$.
  void finish(const FT& ij, const FT& jl, const FT& li)
  {
    m_length = to_apex(m_edges.back().from_a, ij, jl, li);
    m_from_b.resize(m_edges.size());
    m_from_b.back() = {li, jl};
    for(std::size_t m = m_edges.size() - 1; m > 0; --m)
      m_from_b[m - 1] = before(m);
  }

  /// the number of inner edges.
  std::size_t size() const { return m_edges.size(); }

  /// the Penner length of the geodesic. \pre `finish()` has been called
  const FT& length() const { return m_length; }

  /// the crossing of the geodesic with inner edge `m`. The coefficient of each of the four points in
  /// their relation is the product of the three lengths among the others. \pre `finish()` has been called
  Crossing crossing(std::size_t m) const
  {
    const Inner_edge& e = m_edges[m];
    const Lengths &a = e.from_a, &b = m_from_b[m];
    const FT at_a = b.source * b.target, at_b = a.source * a.target; // times the length of the edge
    const FT at_i = b.target * a.target, at_j = b.source * a.source; // times that of the geodesic
    return {at_b / (at_a + at_b), at_j / (at_i + at_j),
            m_length * (at_i + at_j) / (e.length * (at_a + at_b))};
  }

private:
  // from an end of the geodesic to the apex l of the triangle jil (Equation 4.4)
  static FT to_apex(const Lengths& from, const FT& ij, const FT& jl, const FT& li)
  {
    return (from.source * jl + from.target * li) / ij;
  }

  // the lengths from b to the ends of the edge before inner edge `m`
  Lengths before(std::size_t m) const
  {
    const Inner_edge &e = m_edges[m], &previous = m_edges[m - 1];
    const Lengths& b = m_from_b[m];
    // the new vertex is the apex of the same triangle, seen from the other side
    return e.has_source
             ? Lengths{b.source, (b.source * e.to_target + b.target * previous.length) / e.length}
             : Lengths{(b.source * previous.length + b.target * e.to_source) / e.length, b.target};
  }

  std::vector<Inner_edge> m_edges;
  std::vector<Lengths> m_from_b;
  FT m_length{};
};

} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_IDEAL_STRIP_H
