// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_SURFACE_PATH_H
#define CGAL_INTRINSIC_TRIANGULATIONS_SURFACE_PATH_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Surface_point.h>

#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsPaths
/// a path over a triangulation that is straight in every face.
template <typename FT>
struct Surface_path
{
  FT length;                             ///< its length; infinite if there is no path
  std::vector<Surface_point<FT>> places; ///< where it starts, meets edges and vertices, and ends
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_SURFACE_PATH_H
