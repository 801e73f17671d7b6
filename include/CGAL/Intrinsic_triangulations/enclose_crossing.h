// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_ENCLOSE_CROSSING_H
#define CGAL_INTRINSIC_TRIANGULATIONS_ENCLOSE_CROSSING_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Correspondence.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Corresponding_crossings.h>

#include <CGAL/Interval_nt.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// The places of crossings, derived anew from the metric of T1, with the errors of numbers of type
// `N`.
template <typename Traits, typename N>
class Crossing_enclosure
{
  typedef Corresponding_crossings<Traits> Crossings;
  typedef Rounded_corners<N, Input_metric_of<Traits>,
                          decltype(std::declval<Triangulation_pair<Traits>>().input())>
    Corners;
  typedef Corresponding_decisions<Traits> Decisions;

public:
  explicit Crossing_enclosure(const Correspondence<Traits>& correspondence)
    : m_crossings(correspondence),
      m_corners(correspondence.triangulation().input_metric(),
                correspondence.triangulation().input()),
      m_development(correspondence.triangulation(), m_crossings, m_corners)
  {}

  // Returns the places of crossing `m` on the halfedge `h` of T2, the first of its edge.
  Trace_point<Interval_nt<>> operator()(Halfedge_index h, std::size_t m)
  {
    const Halfedge_index input = m_crossings(h, m);
    const auto from_source = m_development.strip(h);
    const auto from_target = m_development.strip(opposite(h));
    const auto& near = from_source.crossed[m];
    const auto& far = from_target.crossed[m_crossings.count(h) - 1 - m];
    const auto direction = conj(from_source.end);
    auto right = -(direction * near.source), left = direction * near.target;
    if(!is_first_halfedge(near.halfedge))
      std::swap(left, right);
    return {{first_halfedge(Edge_index(input)), part(right, left)},
            {h, part(Decisions::height(near) * Decisions::squared_length(far),
                     Decisions::height(far) * Decisions::squared_length(near))}};
  }

private:
  // Returns a / (a + b) for the imaginary parts of `a` and `b`, which are not negative. The
  // quotient of sums is rounded a few times.
  static Interval_nt<> part(const Ball<N>& a, const Ball<N>& b)
  {
    const N error(16 * Rounding<N>::unit());
    const N lower = quotient(least(a), greatest(b), N(0)),
            upper = quotient(greatest(a), least(b), N(1));
    return {CGAL::to_interval(N(lower - error * lower)).first,
            (std::min)(CGAL::to_interval(N(upper + error * upper)).second, 1.)};
  }

  static N quotient(const N& a, const N& b, const N& otherwise)
  {
    return a + b > 0 ? N(a / (a + b)) : otherwise;
  }

  static N least(const Ball<N>& a) { return (std::max)(N(a.y - N(a.radius)), N(0)); }
  static N greatest(const Ball<N>& a) { return (std::max)(N(a.y + N(a.radius)), N(0)); }

  Crossings m_crossings;
  Corners m_corners;
  Development<Traits, Crossings, Corners> m_development;
};

// a number of type `double` may lie between two that enclose it
inline bool is_narrow(const Interval_nt<>& place, double width)
{
  return place.sup() - place.inf() <= width ||
         std::nextafter(std::nextafter(place.inf(), 1.), 1.) >= place.sup();
}

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsCertificates
/// encloses the places at which an edge of \f$T_1\f$ and an edge of \f$T_2\f$ cross on the exact
/// surface, however many flips led to \f$T_2\f$. More and more digits are used until the intervals
/// are narrow enough.
///
/// \param correspondence the crossings
/// \param id the index of the crossing
/// \param width the greatest width of an interval; if it is less than the spacing of numbers of
///        type `double`, at most one of them lies inside the interval
/// \returns the places on the first halfedges of both edges, as `Correspondence::crossing()`
///   returns them rounded. Intervals are wider than requested only if 1024 bits do not suffice:
///   where two edges run along each other, in faces without area, any place that they share is a
///   crossing.
///
/// Complexity: linear in the crossings of the edge of \f$T_2\f$.
/// \tparam Traits `Euclidean_geometry_traits<double>` or `Exact_Euclidean_geometry_traits`
/// \pre the edges of \f$T_2\f$ are straight, see `Delaunay_certificate::is_geodesic()`
template <typename Traits>
Trace_point<Interval_nt<>> enclose_crossing(const Correspondence<Traits>& correspondence,
                                            Delta_complex::size_type id, double width = 0x1p-50)
{
  static_assert(internal::has_metric<Traits>(), "places need the metric of a Euclidean geometry");
  const Halfedge_index h = correspondence.crossing(id).on_intrinsic.halfedge;
  const std::size_t m = id - correspondence.crossings_on_intrinsic().before(Edge_index(h));
  auto result = internal::Crossing_enclosure<Traits, double>(correspondence)(h, m);
  const auto is_narrow = [&] {
    return internal::is_narrow(result.on_input.t, width) &&
           internal::is_narrow(result.on_intrinsic.t, width);
  };
  for(long bits = 128; bits <= internal::most_digits && !is_narrow(); bits *= 2) {
    const internal::Long_float_precision precision(bits);
    result = internal::Crossing_enclosure<Traits, internal::Long_float>(correspondence)(h, m);
  }
  return result;
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_ENCLOSE_CROSSING_H
