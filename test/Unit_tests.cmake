# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

include(GoogleTest)
find_package(OpenMesh QUIET NO_MODULE) # CGAL's module does not find it

add_custom_target(unit_tests)
add_custom_target(unit_tests_syntax)

# What all of them need.
add_library(unit_test_options INTERFACE)
target_link_libraries(unit_test_options
  INTERFACE Intrinsic_triangulations CGAL::Data GTest::gtest_main)
# With CGAL's assertions on. Full optimisation would take longer than it saves.
target_compile_options(unit_test_options INTERFACE -UNDEBUG $<$<CONFIG:Release>:-O1>
  $<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess>) # ccache can only cache precompiled headers with it
if(SuiteSparse_FOUND)
  # Both factorizations are tested, but only one can be that of the algorithms.
  target_include_directories(unit_test_options SYSTEM INTERFACE ${CHOLMOD_INCLUDE_DIR})
  target_link_libraries(unit_test_options INTERFACE ${CHOLMOD_LIBRARY})
  target_compile_definitions(unit_test_options INTERFACE TEST_SUPERNODAL_CHOLESKY)
endif()
if(Ceres_FOUND)
  target_link_libraries(unit_test_options INTERFACE CGAL_intrinsic_triangulations::Ceres)
endif()
if(TBB_FOUND)
  target_link_libraries(unit_test_options INTERFACE CGAL_intrinsic_triangulations::TBB)
endif()
if(OpenMesh_FOUND)
  target_link_libraries(unit_test_options INTERFACE OpenMeshCore)
  target_compile_definitions(unit_test_options INTERFACE CGAL_USE_OPENMESH)
endif()

# What the compiled library holds is compiled once, too, but with assertions.
add_library(unit_test_dependencies INTERFACE)
target_link_libraries(unit_test_dependencies INTERFACE unit_test_options)
if(TARGET Intrinsic_triangulations_compiled)
  get_target_property(sources Intrinsic_triangulations_compiled SOURCES)
  list(TRANSFORM sources PREPEND "${PROJECT_SOURCE_DIR}/src/")
  add_library(unit_tests_library STATIC EXCLUDE_FROM_ALL ${sources})
  target_link_libraries(unit_tests_library PRIVATE unit_test_options)
  target_link_libraries(unit_test_dependencies INTERFACE unit_tests_library)
  target_compile_definitions(unit_test_dependencies INTERFACE
    CGAL_INTRINSIC_TRIANGULATIONS_COMPILED=extern)
endif()

# Large headers that all of them include, precompiled by a target of its own: -fsyntax-only would
# leave nothing of them.
file(CONFIGURE OUTPUT nothing.cpp CONTENT "")
add_library(unit_tests_precompiled OBJECT EXCLUDE_FROM_ALL
  "${CMAKE_CURRENT_BINARY_DIR}/nothing.cpp")
target_link_libraries(unit_tests_precompiled PRIVATE unit_test_dependencies)
target_precompile_headers(unit_tests_precompiled PRIVATE
  "${CMAKE_CURRENT_SOURCE_DIR}/Intrinsic_triangulations/testing.h"
  $<$<BOOL:${Eigen_FOUND}>:<Eigen/SparseCholesky$<ANGLE-R>>)

# Surfaces for tests are generated and read by functions that are compiled once.
file(GLOB surface_sources CONFIGURE_DEPENDS
  "${CMAKE_CURRENT_SOURCE_DIR}/Intrinsic_triangulations/*.cpp")
list(FILTER surface_sources EXCLUDE REGEX "/(test_[^/]*|counted_new)\\.cpp$")
add_library(unit_test_surfaces STATIC EXCLUDE_FROM_ALL ${surface_sources})
target_link_libraries(unit_test_surfaces PRIVATE unit_test_dependencies)
target_precompile_headers(unit_test_surfaces REUSE_FROM unit_tests_precompiled)
set_target_properties(unit_test_surfaces PROPERTIES UNITY_BUILD ON)

# One executable with the tests in the source files of a directory, and for compilers that only look
# for warnings a target <name>_syntax.
function(add_unit_tests name)
  file(GLOB sources CONFIGURE_DEPENDS test_*.cpp counted_new.cpp)
  if(NOT Ceres_FOUND)
    list(FILTER sources EXCLUDE REGEX "_ceres_")
  endif()
  if(NOT TBB_FOUND)
    list(FILTER sources EXCLUDE REGEX "_parallel")
  endif()
  set_source_files_properties("${PROJECT_SOURCE_DIR}/test/Intrinsic_triangulations/counted_new.cpp"
    PROPERTIES SKIP_PRECOMPILE_HEADERS ON SKIP_UNITY_BUILD_INCLUSION ON)
  set_source_files_properties("${PROJECT_SOURCE_DIR}/test/Intrinsic_triangulations/test_exact_truth.cpp"
    PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON) # it asks CGAL for CORE
  # Templates are instantiated once for several files, each of which has its own namespace: in two
  # halves where there are many.
  list(LENGTH sources number)
  math(EXPR half "(${number} + 1) / 2")
  if(number LESS 24)
    set(half ${number})
  endif()
  add_executable(${name} ${sources})
  add_library(${name}_syntax OBJECT EXCLUDE_FROM_ALL ${sources})
  target_compile_options(${name}_syntax PRIVATE -fsyntax-only)
  foreach(target IN ITEMS ${name} ${name}_syntax)
    target_link_libraries(${target} PRIVATE unit_test_surfaces unit_test_dependencies)
    target_precompile_headers(${target} REUSE_FROM unit_tests_precompiled)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE ${half})
  endforeach()
  add_dependencies(unit_tests ${name})
  add_dependencies(unit_tests_syntax ${name}_syntax)
  gtest_discover_tests(${name} DISCOVERY_MODE PRE_TEST DISCOVERY_TIMEOUT 60)
endfunction()
