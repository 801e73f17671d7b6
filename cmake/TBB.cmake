# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# Adds the target CGAL_intrinsic_triangulations::TBB if TBB is found: the package with
# `CGAL::Parallel_tag`. Used by the build, and by the installed package when an application asks for
# it.

find_package(TBB QUIET)
if(TBB_FOUND)
  include(CGAL_TBB_support)
  if(NOT TARGET CGAL_intrinsic_triangulations::TBB)
    add_library(CGAL_intrinsic_triangulations::TBB INTERFACE IMPORTED GLOBAL)
    target_link_libraries(CGAL_intrinsic_triangulations::TBB INTERFACE
      CGAL_intrinsic_triangulations::Intrinsic_triangulations CGAL::TBB_support)
  endif()
endif()
