# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# An overlay port, which builds the sources that it belongs to.
get_filename_component(SOURCE_PATH "${CMAKE_CURRENT_LIST_DIR}/../../.." ABSOLUTE)

# Headers do not depend on the configuration.
if(NOT "compiled" IN_LIST FEATURES)
  set(VCPKG_BUILD_TYPE release)
endif()

vcpkg_check_features(OUT_FEATURE_OPTIONS feature_options
  FEATURES compiled WITH_compiled_library
  INVERTED_FEATURES program CMAKE_DISABLE_FIND_PACKAGE_CLI11)
vcpkg_cmake_configure(SOURCE_PATH "${SOURCE_PATH}"
  OPTIONS ${feature_options} -DBUILD_TESTING=OFF -DWITH_SuiteSparse=OFF -DWITH_Ceres=OFF
    -DWITH_TBB=OFF -DWITH_Cairo=OFF -DWITH_ZLIB=OFF -DWITH_Three=OFF -DWITH_Python=OFF)
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(PACKAGE_NAME cgal_intrinsic_triangulations
  CONFIG_PATH share/cmake/CGAL_intrinsic_triangulations)
if("program" IN_LIST FEATURES)
  vcpkg_copy_tools(TOOL_NAMES intrinsic AUTO_CLEAN)
endif()
file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/debug/include" "${CURRENT_PACKAGES_DIR}/debug/share")
vcpkg_install_copyright(FILE_LIST "${SOURCE_PATH}/LICENSE")
