# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

include(GoogleTest)
find_package(OpenMesh QUIET)

# One executable with the tests in the source files of a directory.
function(add_unit_tests name)
  file(GLOB sources CONFIGURE_DEPENDS *.cpp)
  if(NOT Ceres_FOUND)
    list(FILTER sources EXCLUDE REGEX "_ceres_")
  endif()
  add_executable(${name} ${sources})
  target_link_libraries(${name} PRIVATE Intrinsic_triangulations CGAL::Data GTest::gtest_main)
  if(OpenMesh_FOUND)
    target_link_libraries(${name} PRIVATE OpenMeshCore)
    target_compile_definitions(${name} PRIVATE CGAL_USE_OPENMESH)
  endif()

  # With CGAL's assertions on. Full optimisation would take longer than it saves.
  target_compile_options(${name} PRIVATE -UNDEBUG $<$<CONFIG:Release>:-O1>)
  precompile_dependencies(${name})
  target_precompile_headers(${name} PRIVATE <gtest/gtest.h>)
  set_source_files_properties("${PROJECT_SOURCE_DIR}/test/Intrinsic_triangulations/counted_new.cpp"
    PROPERTIES SKIP_PRECOMPILE_HEADERS ON)

  gtest_discover_tests(${name} DISCOVERY_MODE PRE_TEST DISCOVERY_TIMEOUT 60)
endfunction()
