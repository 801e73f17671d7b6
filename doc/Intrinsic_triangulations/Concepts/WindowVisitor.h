// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

/// \ingroup PkgIntrinsicTriangulationsConcepts
/// \cgalConcept
///
/// follows the search for exact shortest paths: to show progress, or to stop the search by an
/// exception.
///
/// \cgalHasModel `CGAL::Intrinsic_triangulations::Default_window_visitor`
class WindowVisitor
{
public:
  /// is called after `number` windows of one side have been propagated together. An exception
  /// leaves the search, which `CGAL::Intrinsic_triangulations::Shortest_paths::run()` can continue.
  void after_windows(std::size_t number);
};
