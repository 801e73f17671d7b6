# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# CGAL is needed, everything else is used when it is found and its option is not turned off.

option(WITH_GMP "Let CGAL use GMP and MPFR" ON)
if(NOT WITH_GMP)
  set(CGAL_DISABLE_GMP ON)
endif()

# No versions in find_package(): CGAL 6 and Eigen 5 call themselves incompatible with lesser ones that
# are asked for.
find_package(CGAL REQUIRED)
if(CGAL_VERSION VERSION_LESS 5.5)
  message(FATAL_ERROR "CGAL 5.5 or later is needed; found ${CGAL_VERSION} in ${CGAL_DIR}")
endif()

option(WITH_Eigen "Use Eigen" ON)
if(WITH_Eigen)
  find_package(Eigen3 QUIET NO_MODULE)
  if(Eigen3_FOUND AND Eigen3_VERSION VERSION_GREATER_EQUAL 3.3)
    set(Eigen_FOUND TRUE)
  endif()
endif()

option(WITH_SuiteSparse "Use CHOLMOD in the program and the benchmarks" ON)
if(WITH_SuiteSparse)
  include(CHOLMOD)
endif()
option(WITH_Ceres "Use the Ceres Solver in the program and the benchmarks" ON)
if(WITH_Ceres)
  include(Ceres)
endif()
option(WITH_TBB "Use several threads in the program and the benchmarks" ON)
if(WITH_TBB)
  include(TBB)
endif()

option(WITH_Cairo "Let the program draw PNG pictures with Cairo" ON)
if(WITH_Cairo)
  find_path(Cairo_INCLUDE_DIR cairo.h PATH_SUFFIXES cairo)
  find_library(Cairo_LIBRARY cairo)
  mark_as_advanced(Cairo_INCLUDE_DIR Cairo_LIBRARY)
  if(Cairo_INCLUDE_DIR AND Cairo_LIBRARY)
    set(Cairo_FOUND TRUE)
  endif()
endif()

option(WITH_ZLIB "Let the program read compressed VTP files with zlib" ON)
if(WITH_ZLIB)
  find_package(ZLIB QUIET)
endif()

option(WITH_Three "Fetch three.js for the pages of --view, if this is the top-level project" ON)
if(WITH_Three AND PROJECT_IS_TOP_LEVEL)
  include(Three)
endif()

option(WITH_Python "Build the package for Python, if pybind11 and numpy are found" ON)

option(WITH_compiled_library
  "Build the library of what applications would compile from the headers otherwise"
  ${PROJECT_IS_TOP_LEVEL})

message(STATUS "Dependency     option  found")
message(STATUS "CGAL           needed  ${CGAL_VERSION}")
foreach(name IN ITEMS GMP Eigen SuiteSparse Ceres TBB Cairo ZLIB Three)
  string(SUBSTRING "${name}               " 0 15 name_column)
  string(SUBSTRING "${WITH_${name}}        " 0 8 option_column)
  if(WITH_${name} AND ${name}_FOUND)
    message(STATUS "${name_column}${option_column}yes")
  else()
    message(STATUS "${name_column}${option_column}no")
  endif()
endforeach()
