// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CERTIFY_DELAUNAY_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CERTIFY_DELAUNAY_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/Certifier.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Edge_courses.h>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsCertificates
/// certifies in exact arithmetic that \f$T_2\f$ is a geodesic Delaunay triangulation of the
/// surface of \f$T_1\f$, however it was made. Integer coordinates determine the triangles of
/// \f$T_1\f$ that an edge of \f$T_2\f$ passes. Laid out along them, every edge must be a straight
/// segment. Every edge that is not constrained must satisfy the local Delaunay condition (Equation
/// 2.6).
///
/// The surface is given by the exact positions of the input's vertices, or by its exact squared
/// lengths or lengths. Inserted vertices lie at their barycentric coordinates divided by their
/// sum, exactly. Around each of them the faces must turn once.
///
/// A decision remains undecided only if 1024 bits do not distinguish its sign from zero. It must
/// also involve more than twelve square roots that are independent over the rationals. Without
/// exact traits, it can instead involve a strip of more than about a thousand triangles. The
/// certificate names the edge or vertex of such a decision, and does not confirm the result.
///
/// Complexity: linear in the edges and crossings, as long as decisions are made in floating point.
/// A tie that involves \f$m\f$ independent square roots takes \f$3^m\f$ products.
/// \tparam Traits `Euclidean_geometry_traits<double>`, `Exact_Euclidean_geometry_traits`, or traits
///   derived from them that measure in the same way
/// \tparam NamedParameters a sequence of named parameters
/// \param tri the triangulation
/// \param np
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{concurrency_tag}
///     \cgalParamDescription{whether several threads are used; see \ref it_parallel}
///     \cgalParamType{`CGAL::Sequential_tag`, `CGAL::Parallel_tag` or
///                    `CGAL::Parallel_if_available_tag`}
///     \cgalParamDefault{`CGAL::Sequential_tag`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
/// \throws Invalid_input if \f$T_1\f$ is given by lengths that violate the triangle inequality
template <typename Traits, typename NamedParameters = CGAL::parameters::Default_named_parameters>
Delaunay_certificate
certify_Delaunay(const Intrinsic_triangulation<Traits>& tri,
                 const NamedParameters& np = CGAL::parameters::default_values())
{
  static_assert(internal::has_metric<Traits>(),
                "a certificate needs Exact_Euclidean_geometry_traits, Euclidean_geometry_traits<"
                "double>, or traits derived from them with the same geometry");
  const Concurrency concurrency = concurrency_of(np);
  const internal::Edge_courses<Traits> courses(tri, concurrency);
  return internal::Certifier<Traits>(tri, courses, concurrency).run();
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CERTIFY_DELAUNAY_H
