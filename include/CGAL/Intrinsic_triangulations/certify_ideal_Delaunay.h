// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CERTIFY_IDEAL_DELAUNAY_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CERTIFY_IDEAL_DELAUNAY_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Ideal_geometry_traits.h>
#include <CGAL/Intrinsic_triangulations/Ideal_strip.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/exact_numbers.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Edge_courses.h>

#include <CGAL/Interval_nt.h>
#include <CGAL/number_utils.h>
#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsCertificates
/// the results of exact decisions about the edges of an ideal triangulation that lie in two faces
/// and are not constrained.
struct Ideal_Delaunay_certificate
{
  std::size_t decided_in_floating_point = 0;  ///< the number of edges for which intervals sufficed
  std::size_t decided_exactly = 0;            ///< the number of edges that took rational numbers
  std::vector<Edge_index> ties;               ///< the edges for which Equation 4.5 is an equality
  std::vector<Edge_index> non_Delaunay_edges; ///< the edges that violate Equation 4.5

  /// an upper bound of how much the left side of Equation 4.5 exceeds the right side at a failing
  /// edge, relative to the right side. It is zero if no edge fails. If rounding of `double` is the
  /// cause, it is of the order of \f$10^{-16}\f$ to \f$10^{-13}\f$.
  double greatest_excess = 0;

  /// returns whether no edge violates Equation 4.5.
  bool is_Delaunay() const { return non_Delaunay_edges.empty(); }
};

namespace internal {

// These intervals are only used while a Protect_FPU_rounding<true> exists.
typedef Interval_nt<false> Filter_interval;

// Returns the length of the edge `e` of T2 in the strip of ideal triangles of T1 that it crosses.
// The lengths of T1 count as exact.
template <typename FT, typename Traits>
FT length_in_strip(Ideal_strip<FT>& strip, Edge_index e, const Triangulation_pair<Traits>& pair,
                   const Edge_courses<Traits>& courses)
{
  const Halfedge_index h = first_halfedge(e);
  return pair.coordinates().is_shared(e) ? FT(pair.shared_length(h))
                                         : pair.lay_out(strip, h, courses(h));
}

// Decides Equation 4.5 for the edges of a mesh. `interval_length` and `exact_length` return the
// lengths of edges, which are multiplied by the factors of both ends. `interval_length` is called
// while intervals are rounded upwards.
template <typename Interval_length, typename Exact_length>
class Ideal_Delaunay_certifier
{
public:
  Ideal_Delaunay_certifier(const Delta_complex& mesh, const std::vector<double>& factor,
                           const Interval_length& interval_length, const Exact_length& exact_length)
    : m_mesh(mesh),
      m_factor(factor),
      m_interval_length(interval_length),
      m_exact_length(exact_length)
  {}

  template <typename Is_fixed>
  Ideal_Delaunay_certificate operator()(const Is_fixed& is_fixed)
  {
    decide_by_intervals(is_fixed);
    m_length.resize(m_filter_failures.empty() ? 0 : m_mesh.num_edges());
    for(Edge_index e : m_filter_failures)
      decide_exactly(e);
    return std::move(m_result);
  }

private:
  template <typename FT>
  FT scaled(const FT& length, Edge_index e) const
  {
    const auto factor = [&](unsigned int i) { return FT(m_factor[m_mesh.vertex(e, i).idx()]); };
    return FT(length * factor(0) * factor(1));
  }

  template <typename Is_fixed>
  void decide_by_intervals(const Is_fixed& is_fixed)
  {
    const Protect_FPU_rounding<true> upwards;
    std::vector<Filter_interval> length;
    length.reserve(m_mesh.num_edges());
    for(Edge_index e : m_mesh.edges())
      length.push_back(scaled(m_interval_length(e), e));
    const auto map =
      boost::make_function_property_map<Edge_index>([&](Edge_index e) { return length[e.idx()]; });
    for(Edge_index e : m_mesh.edges()) {
      if(m_mesh.is_border(e) || is_fixed(e))
        continue;
      const Ideal_Delaunay_condition<Filter_interval> condition(
        diamond(map, m_mesh.halfedge(e), m_mesh));
      if(!certainly(condition.inner < condition.outer) &&
         !certainly(condition.inner > condition.outer)) {
        m_filter_failures.push_back(e);
        continue;
      }
      ++m_result.decided_in_floating_point;
      if(certainly(condition.inner > condition.outer))
        fail(e, (condition.inner / condition.outer - 1).sup());
    }
  }

  void decide_exactly(Edge_index e)
  {
    const auto map = boost::make_function_property_map<Edge_index>(
      [this](Edge_index x) -> Exact_field { return exact_length(x); });
    const Ideal_Delaunay_condition<Exact_field> condition(diamond(map, m_mesh.halfedge(e), m_mesh));
    ++m_result.decided_exactly;
    if(condition.inner > condition.outer)
      fail(e, to_interval(Exact_field(condition.inner / condition.outer - 1)).second);
    else if(condition.inner == condition.outer)
      m_result.ties.push_back(e);
  }

  // Returns the exact length of an edge. It is stored, because it is part of several conditions.
  const Exact_field& exact_length(Edge_index e)
  {
    std::optional<Exact_field>& length = m_length[e.idx()];
    if(!length)
      length = scaled(m_exact_length(e), e);
    return *length;
  }

  void fail(Edge_index e, double excess)
  {
    m_result.non_Delaunay_edges.push_back(e);
    m_result.greatest_excess = (std::max)(m_result.greatest_excess, excess);
  }

  const Delta_complex& m_mesh;
  const std::vector<double>& m_factor;
  const Interval_length& m_interval_length;
  const Exact_length& m_exact_length;
  std::vector<Edge_index> m_filter_failures;
  std::vector<std::optional<Exact_field>> m_length;
  Ideal_Delaunay_certificate m_result;
};

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsCertificates
/// decides exactly, without a tolerance, which edges of \f$T_2\f$ satisfy the local ideal Delaunay
/// condition (Equation 4.5), however \f$T_2\f$ was made.
///
/// The lengths of \f$T_1\f$ and the factors of vertices are taken as exact numbers. The stored
/// lengths of \f$T_2\f$, which flips have rounded, are not used. Integer coordinates determine
/// exactly which triangles of \f$T_1\f$ an edge passes, and its length is a rational function of
/// their lengths. Intervals decide most edges, and rational numbers the remaining edges.
///
/// An ideal triangulation is ideal Delaunay for these numbers if all its edges pass. Arcs of any
/// triangulation are geodesics of the ideal polyhedron, and disjoint.
///
/// A triangulation made with `double` can have edges that fail by rounding: `make_Delaunay()` flips
/// an edge only if it certainly is not Delaunay.
///
/// \tparam Ideal_traits `Ideal_geometry_traits` with lengths of type `double`, or
///   `Hyperideal_geometry_traits` without radii
/// \param tri the triangulation
/// \param factor factors of all vertices, positive: they scale the length of an edge by the product
///        of the factors of its ends
///
/// Complexity: linear in the edges and crossings for intervals. For an undecided edge, numbers of
/// digits are linear in the number of triangles that it and the edges of its diamond pass.
/// \throws Overflow_error if there are more crossings than a `Surface_mesh` can number
/// \pre no vertex has been inserted; `tri` has no garbage
template <typename Ideal_traits>
Ideal_Delaunay_certificate certify_ideal_Delaunay(const Intrinsic_triangulation<Ideal_traits>& tri,
                                                  const std::vector<double>& factor)
{
  CGAL_precondition(tri.number_of_inserted_vertices() == 0 && !tri.mesh().has_garbage());
  CGAL_precondition(factor.size() == tri.mesh().number_of_vertices());
  const internal::Edge_courses<Ideal_traits> courses(tri, Concurrency());
  Ideal_strip<internal::Filter_interval> in_intervals;
  Ideal_strip<Exact_field> exact;
  return internal::Ideal_Delaunay_certifier(
    tri.mesh(), factor,
    [&](Edge_index e) { return internal::length_in_strip(in_intervals, e, tri, courses); },
    [&](Edge_index e) { return internal::length_in_strip(exact, e, tri, courses); })(
    [&](Edge_index e) { return tri.is_constrained(e); });
}

/// \ingroup PkgIntrinsicTriangulationsCertificates
/// decides exactly which edges of \f$T_2\f$ of `tri` satisfy the local ideal Delaunay condition
/// with the unscaled lengths of \f$T_1\f$: all factors are 1. Complexity: the complexity of the
/// function with factors.
template <typename Ideal_traits>
Ideal_Delaunay_certificate certify_ideal_Delaunay(const Intrinsic_triangulation<Ideal_traits>& tri)
{
  return certify_ideal_Delaunay(tri, std::vector<double>(tri.mesh().number_of_vertices(), 1.));
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CERTIFY_IDEAL_DELAUNAY_H
