# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# The Debian packages are made, unpacked and used.
add_test(NAME packages.debian
  COMMAND bash "${CMAKE_CURRENT_SOURCE_DIR}/packages/check.sh" "${PROJECT_BINARY_DIR}")
set_tests_properties(packages.debian PROPERTIES SKIP_RETURN_CODE 77
  ENVIRONMENT "CXX=${CMAKE_CXX_COMPILER};CXXFLAGS=${CMAKE_CXX_FLAGS}")
