# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# The Debian packages are made, unpacked and used.
add_test(NAME packages.debian
  COMMAND bash "${CMAKE_CURRENT_SOURCE_DIR}/packages/check.sh" "${PROJECT_BINARY_DIR}")
set_tests_properties(packages.debian PROPERTIES SKIP_RETURN_CODE 77
  ENVIRONMENT "CXX=${CMAKE_CXX_COMPILER};CXXFLAGS=${CMAKE_CXX_FLAGS}")

# The port for vcpkg is run with functions that stand for vcpkg's.
add_test(NAME packages.vcpkg COMMAND ${CMAKE_COMMAND} -D source=${PROJECT_SOURCE_DIR}
  -D version=${PROJECT_VERSION} -D work=${CMAKE_CURRENT_BINARY_DIR}/vcpkg
  -P "${CMAKE_CURRENT_SOURCE_DIR}/packages/vcpkg.cmake")
