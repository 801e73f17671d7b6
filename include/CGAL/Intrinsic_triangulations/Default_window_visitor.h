// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_DEFAULT_WINDOW_VISITOR_H
#define CGAL_INTRINSIC_TRIANGULATIONS_DEFAULT_WINDOW_VISITOR_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <cstddef>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsPaths
/// a visitor that does nothing.
///
/// \cgalModels `WindowVisitor`
struct Default_window_visitor
{
  void after_windows(std::size_t) {} ///< does nothing.
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_DEFAULT_WINDOW_VISITOR_H
