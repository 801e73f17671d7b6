// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_HYPERIDEAL_STRIP_H
#define CGAL_INTRINSIC_TRIANGULATIONS_HYPERIDEAL_STRIP_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Decorated_length.h>
#include <CGAL/Intrinsic_triangulations/Ideal_strip.h>
#include <CGAL/Intrinsic_triangulations/Normal_coordinates.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Flipped_strip.h>

#include <cmath>
#include <cstddef>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

template <typename FT>
struct Decorated_flip
{
  typedef Decorated_length<FT> Edge;

  static Edge reversed(const Edge& edge) { return edge.reversed(); }

  static Edge flipped(const Edge& ij, const Edge& jk, const Edge& ki, const Edge& il,
                      const Edge& lj)
  {
    return {Decorated_diamond<FT>(Diamond<Edge>{ij, jk, ki, il, lj}).flipped_tangent(),
            ki.source_radius, lj.source_radius};
  }
};

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsTraits
/// intersects the inner edges of a strip with the geodesic between its ends, in the hyperbolic
/// surface of `Hyperideal_geometry_traits`. The triangles of the strip have circles at their
/// corners.
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

public:
  /// a crossing of the geodesic with an inner edge.
  typedef typename Ideal_strip<FT>::Crossing Crossing;

  /// starts a new strip in the triangle \f$aij\f$ that is left through \f$\overrightarrow{ij}\f$.
  void start(const Edge& ai, const Edge& ij, const Edge& ja)
  {
    m_has_radii = true;
    m_decorated.start(ai, ij, ja);
  }

  /// continues through the triangle \f$jil\f$ beyond the last edge \f$\overrightarrow{ij}\f$,
  /// and leaves it through \f$\overrightarrow{il}\f$.
  void turn_around_source(const Edge& ji, const Edge& lj, const Edge& il)
  {
    m_decorated.turn_around_source(ji, lj, il);
  }

  /// continues through the triangle \f$jil\f$ beyond the last edge \f$\overrightarrow{ij}\f$,
  /// and leaves it through \f$\overrightarrow{lj}\f$.
  void turn_around_target(const Edge& ji, const Edge& lj, const Edge& il)
  {
    m_decorated.turn_around_target(ji, lj, il);
  }

  /// ends the strip at the corner \f$l\f$ of the triangle \f$jil\f$ beyond the last edge
  /// \f$\overrightarrow{ij}\f$, and computes the
  /// crossings along it. Complexity: linear in the inner edges.
  void finish(const Edge& ji, const Edge& lj, const Edge& il) { m_decorated.finish(ji, lj, il); }

  /// starts a new strip without radii.
  void start(const FT& ai, const FT& ij, const FT& ja)
  {
    m_has_radii = false;
    m_ideal.start(ai, ij, ja);
  }
  /// continues without radii.
  void turn_around_source(const FT& ij, const FT& jl, const FT& li)
  {
    m_ideal.turn_around_source(ij, jl, li);
  }
  /// continues without radii.
  void turn_around_target(const FT& ij, const FT& jl, const FT& li)
  {
    m_ideal.turn_around_target(ij, jl, li);
  }
  /// ends a strip without radii.
  void finish(const FT& ij, const FT& jl, const FT& li) { m_ideal.finish(ij, jl, li); }

  /// returns the number of inner edges.
  std::size_t size() const { return m_has_radii ? m_decorated.size() : m_ideal.size(); }

  /// returns the length of the tangent between the circles at the ends. \pre `finish()` has been
  /// called
  const FT& length() const { return m_has_radii ? m_decorated.line().tangent : m_ideal.length(); }

  /// returns the crossing of the geodesic with inner edge `m`. \pre `finish()` has been called
  Crossing crossing(std::size_t m) const
  {
    if(!m_has_radii)
      return m_ideal.crossing(m);
    const auto& x = m_decorated[m];
    const Edge& line = m_decorated.line();
    const FT factor = 1 / (line.tangent + (line.source_radius + line.target_radius));
    const FT without_a =
               volume(x.edge.reversed(), x.from_b_to_source.reversed(), x.from_b_to_target, factor),
             without_b = volume(x.edge, x.from_a_to_target.reversed(), x.from_a_to_source, factor),
             without_i = volume(line, x.from_b_to_target, x.from_a_to_target.reversed(), factor),
             without_j = volume(line, x.from_b_to_source, x.from_a_to_source.reversed(), factor);
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

  Ideal_strip<FT> m_ideal;
  internal::Flipped_strip<internal::Decorated_flip<FT>> m_decorated;
  bool m_has_radii = false;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_HYPERIDEAL_STRIP_H
