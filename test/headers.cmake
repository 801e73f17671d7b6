# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# Every header that users include compiles on its own: the target `headers`, which would take nearly
# half of the time of all tests and is therefore for scripts/check_headers.sh.
file(GLOB_RECURSE headers CONFIGURE_DEPENDS
  RELATIVE "${PROJECT_SOURCE_DIR}/include" "${PROJECT_SOURCE_DIR}/include/*.h")
list(FILTER headers EXCLUDE REGEX "/internal/")
if(NOT Eigen_FOUND)
  list(FILTER headers EXCLUDE REGEX
    "operators|Tufted_surface|laplacian|poisson|heat|Heat|geodesic_distances|function_transfer|Factorization|Cholesky|sparse_assembly|Discrete|prolongation|Prolonged|Multigrid")
endif()
if(NOT Ceres_FOUND)
  list(FILTER headers EXCLUDE REGEX "Ceres")
endif()

# Applications of simplification use its core, which does not use them.
set(application
  "topology/|multigrid/|Surface_surgery|pinch_handles|Correspondence_map|Composed_map|prolongation_hierarchy|Multigrid_|Prolonged_")
file(GLOB_RECURSE core CONFIGURE_DEPENDS
  "${PROJECT_SOURCE_DIR}/include/CGAL/Intrinsic_simplification/*.h")
list(FILTER core EXCLUDE REGEX "Intrinsic_simplification/(internal/)?(${application})")
foreach(header IN LISTS core)
  file(STRINGS "${header}" includes
    REGEX "^#include <CGAL/Intrinsic_simplification/(internal/)?(${application})")
  if(includes)
    message(FATAL_ERROR "${header}: the core includes a header of an application")
  endif()
endforeach()

list(TRANSFORM headers REPLACE "(.+)" "#include <\\1>\n" OUTPUT_VARIABLE includes)
list(JOIN includes "" includes)
file(CONFIGURE OUTPUT headers/all_headers.h CONTENT "${includes}")

if(NOT CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # g++ does the rest of this file; others only look for warnings.
  file(CONFIGURE OUTPUT headers/all_headers.cpp CONTENT "#include \"all_headers.h\"\n")
  add_library(headers OBJECT EXCLUDE_FROM_ALL "${CMAKE_CURRENT_BINARY_DIR}/headers/all_headers.cpp")
  target_link_libraries(headers PRIVATE Intrinsic_triangulations)
  return()
endif()

# Makes `result` the headers that precede all else in `header`: what it includes first, what that one
# includes first, and so on.
function(first_includes header result)
  set(chain)
  while(EXISTS "${PROJECT_SOURCE_DIR}/include/${header}")
    file(STRINGS "${PROJECT_SOURCE_DIR}/include/${header}" includes REGEX "^#include <")
    list(FILTER includes EXCLUDE REGEX "CGAL/license/")
    list(APPEND includes "#include <none>")
    list(GET includes 0 include)
    string(REGEX REPLACE "#include <(.+)>" "\\1" header "${include}")
    list(APPEND chain "${header}")
  endwhile()
  set(${result} "${chain}" PARENT_SCOPE)
endfunction()

# Where a header precedes all else in another one, it is compiled on its own there. Many are preceded
# by `large`, which is therefore precompiled.
set(large CGAL/Intrinsic_triangulations/Delta_complex.h)
set(not_first ${headers})
foreach(header IN LISTS headers)
  first_includes("${header}" first_of_${header})
  list(REMOVE_ITEM not_first ${first_of_${header}})
endforeach()
foreach(header IN LISTS not_first)
  string(MAKE_C_IDENTIFIER "${header}" name)
  file(CONFIGURE OUTPUT headers/${name}.cpp CONTENT "#include <${header}>\n")
  if(large IN_LIST first_of_${header})
    list(APPEND after_large "${CMAKE_CURRENT_BINARY_DIR}/headers/${name}.cpp")
  else()
    list(APPEND others "${CMAKE_CURRENT_BINARY_DIR}/headers/${name}.cpp")
  endif()
endforeach()

add_custom_target(headers)
foreach(group IN ITEMS after_large others)
  add_library(headers_${group} OBJECT EXCLUDE_FROM_ALL ${${group}})
  target_link_libraries(headers_${group} PRIVATE Intrinsic_triangulations)
  target_compile_options(headers_${group} PRIVATE -O0)
  add_dependencies(headers headers_${group})
endforeach()
target_precompile_headers(headers_after_large PRIVATE <${large}>)
