// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_TRIANGULATION_OVER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_TRIANGULATION_OVER_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/rebase.h>

namespace CGAL::Intrinsic_triangulations {

/// \deprecated Use `rebase()`.
template <typename Traits>
[[deprecated("use rebase()")]] Intrinsic_triangulation<Traits>
triangulation_over(const Intrinsic_triangulation<Traits>& base,
                   const Intrinsic_triangulation<Traits>& tri)
{
  return rebase(base, tri);
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_TRIANGULATION_OVER_H
