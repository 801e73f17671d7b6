# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# clang++ accepts all headers. Without arguments, the script has it compile the rest, too.
find_program(CLANGXX clang++)
find_program(NINJA ninja)
if(CLANGXX AND NINJA AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  add_test(NAME clang COMMAND "${PROJECT_SOURCE_DIR}/scripts/check_clang.sh"
    "${PROJECT_BINARY_DIR}/clang" headers)
endif()
