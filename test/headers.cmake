# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# Every header that users include compiles on its own: one object per header that includes nothing
# else.
file(GLOB_RECURSE headers CONFIGURE_DEPENDS
  RELATIVE "${PROJECT_SOURCE_DIR}/include" "${PROJECT_SOURCE_DIR}/include/*.h")
list(FILTER headers EXCLUDE REGEX "/internal/")
if(NOT Eigen_FOUND)
  list(FILTER headers EXCLUDE REGEX
    "operators|Tufted_surface|laplacian|poisson|heat|Heat|function_transfer|Factorization|Sparse_assembly|Discrete|prolongation|Prolonged|Multigrid")
endif()
if(NOT Ceres_FOUND)
  list(FILTER headers EXCLUDE REGEX "Ceres")
endif()
foreach(header IN LISTS headers)
  string(MAKE_C_IDENTIFIER "${header}" name)
  file(CONFIGURE OUTPUT headers/${name}.cpp CONTENT "#include <${header}>\n")
  list(APPEND header_sources "${CMAKE_CURRENT_BINARY_DIR}/headers/${name}.cpp")
endforeach()

add_library(headers OBJECT EXCLUDE_FROM_ALL ${header_sources})
target_link_libraries(headers PRIVATE Intrinsic_triangulations)
target_compile_options(headers PRIVATE -O0)
if(NOT CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # Self-containedness is checked by g++; others only look for warnings, faster in one piece.
  set_target_properties(headers PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 0)
endif()

add_test(NAME headers
  COMMAND ${CMAKE_COMMAND} --build "${PROJECT_BINARY_DIR}" --target headers --parallel 1)
