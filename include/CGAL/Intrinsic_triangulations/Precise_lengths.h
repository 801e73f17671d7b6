// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_PRECISE_LENGTHS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_PRECISE_LENGTHS_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Triangulation_pair.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/Development.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/Input_corners.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Edge_courses.h>
#include <CGAL/Intrinsic_triangulations/tolerances.h>

#include <optional>
#include <string>
#include <type_traits>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsBlocks
/// computes the lengths of straight edges of \f$T_2\f$ on the exact surface of \f$T_1\f$, with more
/// digits than `double` has.
/// \tparam Length `Double_double`, or a floating point number of Boost.Multiprecision with at most
///   a thousand binary digits
template <typename Traits, typename Length = Double_double>
class Precise_lengths
{
  typedef Triangulation_pair<Traits> Pair;
  template <typename N>
  using Corners = internal::Rounded_corners<N, typename Pair::Metric::Number>;

public:
  /// prepares for the lengths of `pair`, which is referred to. Complexity: linear in the vertices,
  /// edges and crossings.
  /// \throws Overflow_error if there are more crossings than a `Surface_mesh` can number
  explicit Precise_lengths(const Pair& pair)
    : m_pair(pair),
      m_courses(pair, Concurrency()),
      m_corners(internal::exact_input(pair)),
      m_long_corners(internal::exact_input(pair))
  {}

  /// returns the length of the edge of `h`. Its relative error is at most \f$2^{-90}\f$ if its
  /// type is `Double_double`, and otherwise at most \f$2^{13}\f$ times the `epsilon()` of its type.
  /// \throws Numerical_error if 1024 bits do not suffice
  Length operator()(Halfedge_index h)
  {
    std::optional<Length> result;
    if constexpr(std::is_same_v<Length, Double_double>)
      result = length(h, m_corners);
    if(!result)
      result = length(h, m_long_corners);
    if(!result)
      throw Numerical_error("edge " + std::to_string(m_pair.mesh().edge(h).idx()) +
                            " has no positive finite length");
    return *result;
  }

private:
  template <typename N>
  std::optional<Length> length(Halfedge_index h, Corners<N>& corners) const
  {
    const auto strip =
      internal::Development<Traits, Corners<N>>(m_pair, m_courses, corners).uncrossed_strip(h);
    const internal::Ball<N> length =
      root(strip.end * conj(strip.end)) * corners.length(strip.first.halfedge);
    const double high = to_double(length.x);
    if(!(length.radius <= internal::precise_length_error<Length>() * high))
      return std::nullopt;
    if constexpr(std::is_same_v<Length, Double_double>)
      return Double_double::exact_sum(high, to_double(N(length.x - N(high))));
    else
      return Length(length.x);
  }

  const Pair& m_pair;
  internal::Edge_courses<Traits> m_courses;
  Corners<Double_double> m_corners;
  Corners<internal::Long_float> m_long_corners;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_PRECISE_LENGTHS_H
