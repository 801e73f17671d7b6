// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_ELEMENT_ACROSS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_ELEMENT_ACROSS_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Correspondence.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/Element_locator.h>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsCertificates
/// finds the vertex, the edge or the face of one triangulation in which a point of the other one
/// lies, by exact decisions: a vertex or an edge only if the point lies on it exactly, a face only
/// if the point lies inside it.
///
/// \param correspondence the crossings of both
/// \param side the triangulation on which `p` lies
/// \param p a point with barycentric coordinates that are not negative; the point is exactly that
///        of these numbers divided by their sum
///
/// Complexity: logarithmic in the number of crossings on the sides of the face, for each of them
/// linear in those on one or two edges of \f$T_2\f$. In a face of \f$T_1\f$ that contains inserted
/// vertices: as `point_across()`, and for every side of the regions that are looked at linear in
/// its crossings.
/// \tparam Traits `Euclidean_geometry_traits<double>` or `Exact_Euclidean_geometry_traits`
/// \throws Numerical_error if a decision is not made by 1024 bits and involves more than twelve
///         independent square roots, or edges of \f$T_2\f$ are bent
/// \pre the edges of \f$T_2\f$ are straight, see `Delaunay_certificate::is_geodesic()`
template <typename Traits>
Surface_element element_across(const Correspondence<Traits>& correspondence, Side side,
                               const Face_location<double>& p)
{
  return internal::Element_locator<Traits>(correspondence)(side, p);
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_ELEMENT_ACROSS_H
