// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_COMPILED_MAKE_DELAUNAY_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_COMPILED_MAKE_DELAUNAY_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/internal/compiled/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/make_Delaunay.h>

#include <cstddef>

namespace CGAL::Intrinsic_triangulations::internal {

CGAL_INTRINSIC_TRIANGULATIONS_COMPILED template Flipping_result
make_Delaunay(Intrinsic_triangulation<>&, std::size_t, Default_flip_visitor&, Concurrency);
CGAL_INTRINSIC_TRIANGULATIONS_COMPILED template Flipping_result
flip_exactly(Intrinsic_triangulation<>&, std::size_t, Default_flip_visitor&, Concurrency,
             Tie_decisions);

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_COMPILED_MAKE_DELAUNAY_H
