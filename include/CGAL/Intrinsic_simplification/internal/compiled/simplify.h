// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_COMPILED_SIMPLIFY_H
#define CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_COMPILED_SIMPLIFY_H

#include <CGAL/license/Intrinsic_simplification.h>

#include <CGAL/Intrinsic_simplification/simplify.h>
#include <CGAL/Intrinsic_triangulations/internal/compiled/Intrinsic_triangulation.h>

#include <cstddef>

namespace CGAL::Intrinsic_simplification {

CGAL_INTRINSIC_TRIANGULATIONS_COMPILED template Evolving_surface::Evolving_surface(
  const Surface_mesh<Point_3<Simple_cartesian<double>>>&,
  const CGAL::parameters::Default_named_parameters&);
CGAL_INTRINSIC_TRIANGULATIONS_COMPILED template Evolving_surface::Evolving_surface(
  const Surface_mesh<Point_3<Epick>>&, const CGAL::parameters::Default_named_parameters&);

namespace internal {

CGAL_INTRINSIC_TRIANGULATIONS_COMPILED template Simplification_result
simplified(Evolving_surface&, Transport_cost&, std::size_t, double,
           Default_simplification_visitor&);
CGAL_INTRINSIC_TRIANGULATIONS_COMPILED template Simplification_result
simplified(Evolving_surface&, std::size_t, double, Default_simplification_visitor&);

} // namespace internal
} // namespace CGAL::Intrinsic_simplification

#endif // CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_COMPILED_SIMPLIFY_H
