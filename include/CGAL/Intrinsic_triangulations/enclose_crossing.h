// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_ENCLOSE_CROSSING_H
#define CGAL_INTRINSIC_TRIANGULATIONS_ENCLOSE_CROSSING_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Correspondence.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Crossing_encloser.h>
#include <CGAL/Intrinsic_triangulations/tolerances.h>

#include <CGAL/Interval_nt.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsCertificates
/// encloses the positions at which an edge of \f$T_2\f$ crosses edges of \f$T_1\f$ on the exact
/// surface, after any number of flips. More and more digits are used until the intervals are
/// narrow enough.
///
/// \param correspondence the crossings
/// \param e the edge of \f$T_2\f$
/// \param width the greatest width of an interval. If it is less than the spacing of numbers of
///   type `double`, at most one of them lies inside the interval
/// \returns for each crossing, from the source of the first halfedge of `e` on, intervals for its
///   positions on the first halfedges of both edges. `Correspondence::crossing()` returns them
///   rounded. Intervals are wider than requested only if 1024 bits do not suffice. If two edges
///   run along each other, in faces without area, any position that they share is a crossing.
///
/// Complexity: linear in the crossings of `e`.
/// \tparam Traits `Euclidean_geometry_traits<double>` or `Exact_Euclidean_geometry_traits`
/// \pre the edges of \f$T_2\f$ are straight, see `Delaunay_certificate::is_geodesic()`
template <typename Traits>
std::vector<Trace_point<Interval_nt<>>>
enclose_crossings(const Correspondence<Traits>& correspondence, Edge_index e,
                  double width = internal::crossing_width())
{
  static_assert(internal::has_metric<Traits>(),
                "positions need the metric of a Euclidean geometry");
  return internal::Crossing_encloser<Traits>(correspondence.triangulation(),
                                             correspondence.courses())(first_halfedge(e), width);
}

/// \ingroup PkgIntrinsicTriangulationsCertificates
/// encloses the positions of one crossing, as `enclose_crossings()` does for all crossings of an
/// edge.
///
/// \param correspondence the crossings
/// \param id the index of the crossing
/// \param width the greatest width of an interval, see `enclose_crossings()`
/// \returns the positions on the first halfedges of both edges
///
/// Complexity: linear in the crossings of the edge of \f$T_2\f$.
/// \tparam Traits `Euclidean_geometry_traits<double>` or `Exact_Euclidean_geometry_traits`
/// \pre the edges of \f$T_2\f$ are straight, see `Delaunay_certificate::is_geodesic()`
template <typename Traits>
Trace_point<Interval_nt<>> enclose_crossing(const Correspondence<Traits>& correspondence,
                                            Delta_complex::size_type id,
                                            double width = internal::crossing_width())
{
  const Edge_index e(correspondence.crossing(id).on_intrinsic.halfedge);
  return enclose_crossings(correspondence, e,
                           width)[id - correspondence.crossings_on_intrinsic().before(e)];
}

/// \ingroup PkgIntrinsicTriangulationsCertificates
/// the distance between rounded and exact positions of crossings.
struct Place_certificate
{
  /// the greatest distance, along an edge of either triangulation, of a rounded position from the
  /// farther end of the interval that encloses it. It is relative to the longest edge of \f$T_1\f$
  double greatest_error = 0;
  /// the number of crossings of edges that run along each other in faces without area, whose exact
  /// position is undefined
  std::size_t indefinite = 0;
};

/// \ingroup PkgIntrinsicTriangulationsCertificates
/// compares the positions of all crossings of `correspondence` with intervals that enclose them,
/// see `enclose_crossings()`.
///
/// Complexity: linear in the edges and crossings.
/// \tparam Traits `Euclidean_geometry_traits<double>` or `Exact_Euclidean_geometry_traits`
/// \pre the edges of \f$T_2\f$ are straight, see `Delaunay_certificate::is_geodesic()`
template <typename Traits>
Place_certificate certify_places(const Correspondence<Traits>& correspondence)
{
  const auto& tri = correspondence.triangulation();
  internal::Crossing_encloser<Traits> enclosed(tri, correspondence.courses());
  double longest = 0;
  for(Edge_index e : tri.input_mesh().edges())
    longest = (std::max)(longest, tri.input_length(e));
  const auto error = [](double place, const Interval_nt<>& exact) {
    return (std::max)(exact.sup() - place, place - exact.inf());
  };
  Place_certificate result;
  for(Edge_index e : tri.mesh().edges()) {
    Delta_complex::size_type id = correspondence.crossings_on_intrinsic().before(e);
    for(const auto& exact : enclosed(first_halfedge(e), internal::crossing_width())) {
      const auto place = correspondence.crossing(id++);
      if(internal::is_narrow(exact, internal::greatest_crossing_width()))
        result.greatest_error =
          (std::max)({result.greatest_error,
                      error(place.on_input.t, exact.on_input.t) *
                        tri.input_length(Edge_index(place.on_input.halfedge)) / longest,
                      error(place.on_intrinsic.t, exact.on_intrinsic.t) * tri.length(e) / longest});
      else
        ++result.indefinite;
    }
  }
  return result;
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_ENCLOSE_CROSSING_H
