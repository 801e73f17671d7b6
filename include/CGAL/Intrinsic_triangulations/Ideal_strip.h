// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_IDEAL_STRIP_H
#define CGAL_INTRINSIC_TRIANGULATIONS_IDEAL_STRIP_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/internal/tracing/Flipped_strip.h>

#include <cstddef>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// Flips edges with Penner lengths, which have no orientation.
template <typename FT>
struct Ptolemy_flip
{
  typedef FT Edge;

  static const FT& reversed(const FT& length) { return length; }

  // Returns the length of the flipped edge by Ptolemy's relation (Equation 4.4).
  static FT flipped(const FT& ij, const FT& jk, const FT& ki, const FT& il, const FT& lj)
  {
    return (ki * lj + jk * il) / ij;
  }
};

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsTraits
/// intersects the inner edges of a strip of decorated ideal triangles with the geodesic between its
/// ends.
///
/// The result equals the result of a layout in the light cone (Equations 4.6 to 4.9), but is
/// computed from Penner lengths alone. Lengths between the ends of the strip and the ends of its
/// inner edges follow from Ptolemy's relation. The four light-like vectors of a crossing satisfy
/// \f$ \alpha_a q_a + \alpha_b q_b = \alpha_i q_i + \alpha_j q_j \f$. Here \f$\alpha_x\f$ is the
/// product of the three Penner lengths among the other three. All terms are positive, so no digit
/// is cancelled. With an exact number type every result is exact. An object can be used for many
/// strips; it allocates memory only for the longest ones.
///
/// \cgalModels `GeodesicStrip`
template <typename FT>
class Ideal_strip
{
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
  void start(const FT& ai, const FT& ij, const FT& ja) { m_strip.start(ai, ij, ja); }

  /// continues through the triangle \f$jil\f$ beyond the last edge \f$\overrightarrow{ij}\f$,
  /// and leaves it through \f$\overrightarrow{il}\f$.
  void turn_around_source(const FT& ij, const FT& jl, const FT& li)
  {
    m_strip.turn_around_source(ij, jl, li);
  }

  /// continues through the triangle \f$jil\f$ beyond the last edge \f$\overrightarrow{ij}\f$,
  /// and leaves it through \f$\overrightarrow{lj}\f$.
  void turn_around_target(const FT& ij, const FT& jl, const FT& li)
  {
    m_strip.turn_around_target(ij, jl, li);
  }

  /// ends the strip at the corner \f$l\f$ of the triangle \f$jil\f$ beyond the last edge
  /// \f$\overrightarrow{ij}\f$, and computes the
  /// crossings along it. Complexity: linear in the inner edges.
  void finish(const FT& ij, const FT& jl, const FT& li) { m_strip.finish(ij, jl, li); }

  /// returns the number of inner edges.
  std::size_t size() const { return m_strip.size(); }

  /// returns the Penner length of the geodesic. \pre `finish()` has been called
  const FT& length() const { return m_strip.line(); }

  /// returns the crossing of the geodesic with inner edge `m`. \pre `finish()` has been called
  Crossing crossing(std::size_t m) const
  {
    const auto& edge = m_strip[m];
    const FT &ai = edge.from_a_to_source, &aj = edge.from_a_to_target;
    const FT &bi = edge.from_b_to_source, &bj = edge.from_b_to_target;
    // Only quotients of the products of three lengths are needed, which stay in range.
    const FT a_to_b = (bi / ai) * (bj / aj), i_to_j = (bj / bi) * (aj / ai);
    const FT b_to_j = (length() / edge.edge) * (bi / aj);
    return {1 / (1 + a_to_b), 1 / (1 + i_to_j), b_to_j * (1 + i_to_j) / (1 + a_to_b)};
  }

private:
  internal::Flipped_strip<internal::Ptolemy_flip<FT>> m_strip;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_IDEAL_STRIP_H
