# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# Adds the target CGAL_intrinsic_triangulations::Ceres if the Ceres Solver is found: the package with
# what `Ceres_minimizer` needs. Used by the build, and by the installed package when an application
# asks for it.

find_path(Ceres_INCLUDE_DIR ceres/ceres.h)
find_library(Ceres_LIBRARY ceres)
find_library(glog_LIBRARY glog)
mark_as_advanced(Ceres_INCLUDE_DIR Ceres_LIBRARY glog_LIBRARY)
if(Ceres_INCLUDE_DIR AND Ceres_LIBRARY AND glog_LIBRARY)
  set(Ceres_FOUND TRUE)
  if(NOT TARGET CGAL_intrinsic_triangulations::Ceres)
    add_library(CGAL_intrinsic_triangulations::Ceres INTERFACE IMPORTED GLOBAL)
    target_link_libraries(CGAL_intrinsic_triangulations::Ceres INTERFACE
      CGAL_intrinsic_triangulations::Intrinsic_triangulations ${Ceres_LIBRARY} ${glog_LIBRARY})
    target_include_directories(CGAL_intrinsic_triangulations::Ceres SYSTEM INTERFACE
      ${Ceres_INCLUDE_DIR})
  endif()
endif()
