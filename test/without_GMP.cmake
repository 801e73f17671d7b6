# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# All headers compile where CGAL has neither GMP nor MPFR, and exact decisions are possible. CGAL's
# target would add both.
add_executable(without_GMP EXCLUDE_FROM_ALL without_GMP/main.cpp)
set_target_properties(without_GMP PROPERTIES
  RUNTIME_OUTPUT_DIRECTORY "${CMAKE_CURRENT_BINARY_DIR}/without_GMP")
target_compile_features(without_GMP PRIVATE cxx_std_17)
target_compile_definitions(without_GMP PRIVATE CGAL_DISABLE_GMP=1)
target_compile_options(without_GMP PRIVATE $<$<CONFIG:Release>:-O0>)
target_include_directories(without_GMP PRIVATE "${CMAKE_CURRENT_BINARY_DIR}/headers"
  "${PROJECT_SOURCE_DIR}/include")
target_include_directories(without_GMP SYSTEM PRIVATE ${CGAL_INCLUDE_DIRS} ${Boost_INCLUDE_DIRS})
if(Eigen_FOUND)
  target_link_libraries(without_GMP PRIVATE Eigen3::Eigen)
  target_compile_definitions(without_GMP PRIVATE CGAL_EIGEN3_ENABLED)
endif()

add_test(NAME without_GMP.build
  COMMAND ${CMAKE_COMMAND} --build "${PROJECT_BINARY_DIR}" --target without_GMP)
add_test(NAME without_GMP.run COMMAND without_GMP)
set_tests_properties(without_GMP.build PROPERTIES FIXTURES_SETUP without_GMP)
set_tests_properties(without_GMP.run PROPERTIES FIXTURES_REQUIRED without_GMP)
