// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_PATH_ACROSS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_PATH_ACROSS_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/curve_across.h>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsPaths
/// \deprecated the name of `curve_across()` for paths until version 1.
template <typename Traits>
[[deprecated("use curve_across()")]] Surface_path<typename Traits::FT>
path_across(const Correspondence<Traits>& correspondence, Side side,
            const Surface_path<typename Traits::FT>& path)
{
  return curve_across(correspondence, side, path);
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_PATH_ACROSS_H
