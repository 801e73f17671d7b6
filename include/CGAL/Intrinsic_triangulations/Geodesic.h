// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_GEODESIC_H
#define CGAL_INTRINSIC_TRIANGULATIONS_GEODESIC_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Edge_point.h>

#include <complex>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsTangent
/// determines what a geodesic does at the boundary.
enum class At_boundary
{
  stop, ///< it ends at the boundary
  slide ///< it follows the boundary, to the side of the smaller angle, left at a right angle
};

/// \ingroup PkgIntrinsicTriangulationsTangent
/// states how a geodesic has ended.
enum class Geodesic_status
{
  reached,             ///< it has its full length
  slid_along_boundary, ///< it has its full length, the last part of it along the boundary
  stopped_at_boundary  ///< it met the boundary before
};

/// \ingroup PkgIntrinsicTriangulationsTangent
/// returns a short sentence for `status`.
inline const char* to_string(Geodesic_status status)
{
  switch(status) {
    case Geodesic_status::reached: return "the geodesic has its full length";
    case Geodesic_status::slid_along_boundary: return "the geodesic slid along the boundary";
    case Geodesic_status::stopped_at_boundary: return "the geodesic stopped at the boundary";
  }
  return "unknown";
}

/// \ingroup PkgIntrinsicTriangulationsTangent
/// the end of a geodesic. Tangent vectors there are complex numbers in the frame of the face
/// `end.first`, whose real axis is along `halfedge(end.first)`.
template <typename FT>
struct Geodesic
{
  Geodesic_status status;     ///< how it ended
  Face_location<FT> end;      ///< its end
  std::complex<FT> direction; ///< the unit vector along it at its end
  std::complex<FT> transport; ///< parallel transport along it: a tangent vector at its start times
                              ///< this number is a vector at its end
  FT length;                  ///< its length
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_GEODESIC_H
