// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_DIAGNOSE_SURFACE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_DIAGNOSE_SURFACE_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/diagnose.h>

namespace CGAL::Intrinsic_triangulations {

/*!
\ingroup PkgIntrinsicTriangulationsDiagnosis

\brief examines an intrinsic surface: `diagnose()` of its mesh, with its lengths.

\tparam Surface a model of `IntrinsicSurface`
\param surface the surface
\returns the defects found and numbers about the surface, for instance its least angle

Takes time linear in the size of the mesh, but for the inverse of Ackermann's function.
*/
template <class Surface>
Input_diagnosis diagnose_surface(const Surface& surface)
{
  return diagnose(surface.mesh(), parameters::edge_length_map(surface.length_map()));
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_DIAGNOSE_SURFACE_H
