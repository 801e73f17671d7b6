// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_COMPILED_INTRINSIC_TRIANGULATION_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_COMPILED_INTRINSIC_TRIANGULATION_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>

namespace CGAL {

template <typename Kernel>
class Point_3;
template <typename FT>
struct Simple_cartesian;
class Epick;

namespace Intrinsic_triangulations {

// Lists the instances in the compiled library. Its macro is `extern` for users of the library, and
// empty while the library is built. The macros of the other headers in this folder work in the same
// way.
CGAL_INTRINSIC_TRIANGULATIONS_COMPILED template Intrinsic_triangulation<>::Intrinsic_triangulation(
  const Surface_mesh<Point_3<Simple_cartesian<double>>>&,
  const CGAL::parameters::Default_named_parameters&);
CGAL_INTRINSIC_TRIANGULATIONS_COMPILED template Intrinsic_triangulation<>::Intrinsic_triangulation(
  const Surface_mesh<Point_3<Epick>>&, const CGAL::parameters::Default_named_parameters&);

} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_COMPILED_INTRINSIC_TRIANGULATION_H
