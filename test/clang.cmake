# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# clang++ accepts all headers, with the same warnings as errors. scripts/check_clang.sh has it compile
# the program and the unit tests, too.
find_program(CLANGXX clang++)
if(NOT CLANGXX OR NOT CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  return()
endif()

set(clang_dir "${PROJECT_BINARY_DIR}/clang")
add_test(NAME clang.configure
  COMMAND ${CMAKE_COMMAND} -S "${PROJECT_SOURCE_DIR}" -B "${clang_dir}" -G "${CMAKE_GENERATOR}"
    -DCMAKE_CXX_COMPILER=${CLANGXX} -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_FLAGS_DEBUG=-O0
    -DCMAKE_COMPILE_WARNING_AS_ERROR=ON)
set_tests_properties(clang.configure PROPERTIES FIXTURES_SETUP clang)
add_test(NAME clang.headers COMMAND ${CMAKE_COMMAND} --build "${clang_dir}" --target headers)
set_tests_properties(clang.headers PROPERTIES FIXTURES_REQUIRED clang)
