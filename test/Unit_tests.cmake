# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

include(GoogleTest)
find_package(OpenMesh QUIET NO_MODULE) # CGAL's module does not find it

add_custom_target(unit_tests)
add_custom_target(unit_tests_syntax)

# One executable with the tests in the source files of a directory, which need what the target
# <name>_dependencies has, and for compilers that only look for warnings a target <name>_syntax.
function(add_unit_tests name)
  file(GLOB sources CONFIGURE_DEPENDS *.cpp)
  if(NOT Ceres_FOUND)
    list(FILTER sources EXCLUDE REGEX "_ceres_")
  endif()
  if(NOT TBB_FOUND)
    list(FILTER sources EXCLUDE REGEX "_parallel")
  endif()
  add_library(${name}_dependencies INTERFACE)
  target_link_libraries(${name}_dependencies
    INTERFACE Intrinsic_triangulations CGAL::Data GTest::gtest_main)
  if(SuiteSparse_FOUND)
    # Both factorizations are tested, but only one can be that of the algorithms.
    target_include_directories(${name}_dependencies SYSTEM INTERFACE ${SuiteSparse_INCLUDE_DIR})
    target_link_libraries(${name}_dependencies INTERFACE ${CHOLMOD_LIBRARY})
    target_compile_definitions(${name}_dependencies INTERFACE TEST_SUPERNODAL_CHOLESKY)
  endif()
  if(TBB_FOUND)
    target_link_libraries(${name}_dependencies INTERFACE CGAL_intrinsic_triangulations::TBB)
  endif()
  if(OpenMesh_FOUND)
    target_link_libraries(${name}_dependencies INTERFACE OpenMeshCore)
    target_compile_definitions(${name}_dependencies INTERFACE CGAL_USE_OPENMESH)
    target_compile_options(${name}_dependencies INTERFACE # in OpenMesh's headers
      $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
  endif()

  add_executable(${name} ${sources})
  target_link_libraries(${name} PRIVATE ${name}_dependencies)
  # With CGAL's assertions on. Full optimisation would take longer than it saves.
  target_compile_options(${name} PRIVATE -UNDEBUG $<$<CONFIG:Release>:-O1>)
  add_dependencies(unit_tests ${name})
  precompile_dependencies(${name})
  target_precompile_headers(${name} PRIVATE <gtest/gtest.h>)
  set_source_files_properties("${PROJECT_SOURCE_DIR}/test/Intrinsic_triangulations/counted_new.cpp"
    PROPERTIES SKIP_PRECOMPILE_HEADERS ON SKIP_UNITY_BUILD_INCLUSION ON)
  set_source_files_properties("${PROJECT_SOURCE_DIR}/test/Intrinsic_triangulations/test_exact_truth.cpp"
    PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON) # it asks CGAL for CORE

  # Precompiled by a target of its own, for which the option would leave nothing.
  file(CONFIGURE OUTPUT ${name}_nothing.cpp CONTENT "")
  add_library(${name}_precompiled OBJECT EXCLUDE_FROM_ALL ${name}_nothing.cpp)
  target_link_libraries(${name}_precompiled PRIVATE ${name}_dependencies)
  target_compile_options(${name}_precompiled PRIVATE -UNDEBUG)
  precompile_dependencies(${name}_precompiled)
  target_precompile_headers(${name}_precompiled PRIVATE <gtest/gtest.h>)

  add_library(${name}_syntax OBJECT EXCLUDE_FROM_ALL ${sources})
  precompile_dependencies(${name}_syntax REUSE_FROM ${name}_precompiled)
  target_link_libraries(${name}_syntax PRIVATE ${name}_dependencies)
  target_compile_options(${name}_syntax PRIVATE -UNDEBUG -fsyntax-only)
  add_dependencies(unit_tests_syntax ${name}_syntax)

  # Templates are instantiated once for several files, each of which has its own namespace.
  set_target_properties(${name} ${name}_syntax PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 8)

  gtest_discover_tests(${name} DISCOVERY_MODE PRE_TEST DISCOVERY_TIMEOUT 60)
endfunction()
