# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# Adds the target CGAL_intrinsic_triangulations::CHOLMOD if SuiteSparse is found: the package with
# CHOLMOD's factorizations. Used by the build, and by the installed package when an application asks
# for it.

include(CheckCXXSourceCompiles)
include(CMakePushCheckState)

# Eigen includes <cholmod.h>
find_path(CHOLMOD_INCLUDE_DIR cholmod.h PATH_SUFFIXES suitesparse)
find_library(CHOLMOD_LIBRARY cholmod)
mark_as_advanced(CHOLMOD_INCLUDE_DIR CHOLMOD_LIBRARY)
if(CHOLMOD_INCLUDE_DIR AND CHOLMOD_LIBRARY)
  set(SuiteSparse_FOUND TRUE)
  if(NOT TARGET CGAL_intrinsic_triangulations::CHOLMOD)
    add_library(CGAL_intrinsic_triangulations::CHOLMOD INTERFACE IMPORTED GLOBAL)
    target_link_libraries(CGAL_intrinsic_triangulations::CHOLMOD INTERFACE
      CGAL_intrinsic_triangulations::Intrinsic_triangulations ${CHOLMOD_LIBRARY})
    target_include_directories(CGAL_intrinsic_triangulations::CHOLMOD SYSTEM INTERFACE
      ${CHOLMOD_INCLUDE_DIR})
    target_compile_definitions(CGAL_intrinsic_triangulations::CHOLMOD INTERFACE
      CGAL_INTRINSIC_TRIANGULATIONS_USE_CHOLMOD)
    # the threads of CHOLMOD, which are held back, are those of the OpenMP of g++
    cmake_push_check_state(RESET)
    set(CMAKE_REQUIRED_LIBRARIES gomp)
    check_cxx_source_compiles("#include <omp.h>
      int main() { omp_set_max_active_levels(0); }" CGAL_INTRINSIC_TRIANGULATIONS_HAS_GOMP)
    cmake_pop_check_state()
    if(CGAL_INTRINSIC_TRIANGULATIONS_HAS_GOMP)
      target_link_libraries(CGAL_intrinsic_triangulations::CHOLMOD INTERFACE gomp)
      target_compile_definitions(CGAL_intrinsic_triangulations::CHOLMOD INTERFACE
        CGAL_INTRINSIC_TRIANGULATIONS_USE_GOMP)
    endif()
  endif()
endif()
