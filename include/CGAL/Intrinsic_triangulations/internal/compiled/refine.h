// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_COMPILED_REFINE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_COMPILED_REFINE_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/internal/compiled/make_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/refine.h>

namespace CGAL::Intrinsic_triangulations::internal {

typedef Face_bounds<Euclidean_geometry_traits<double>, const No_face> Default_face_bounds;

CGAL_INTRINSIC_TRIANGULATIONS_COMPILED template Refinement_result
refine_until_filter_fails(Intrinsic_triangulation<>&, const Default_face_bounds&,
                          const Refinement_limits&, Default_refinement_visitor&);
CGAL_INTRINSIC_TRIANGULATIONS_COMPILED template Refinement_result
refine_exactly(Intrinsic_triangulation<>&, const Default_face_bounds&, const Refinement_limits&,
               Default_refinement_visitor&, Refinement_result);

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_COMPILED_REFINE_H
