# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

include(CMakePackageConfigHelpers)
include(GNUInstallDirs)

set(package_dir "${CMAKE_INSTALL_DATADIR}/cmake/${PROJECT_NAME}")

configure_package_config_file(cmake/Config.cmake.in "${PROJECT_NAME}Config.cmake"
  INSTALL_DESTINATION "${package_dir}" NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file("${PROJECT_NAME}ConfigVersion.cmake"
  COMPATIBILITY SameMinorVersion ARCH_INDEPENDENT)

install(DIRECTORY include/ DESTINATION include)
install(TARGETS Intrinsic_triangulations EXPORT targets)
install(EXPORT targets NAMESPACE ${PROJECT_NAME}::
  FILE "${PROJECT_NAME}Targets.cmake" DESTINATION "${package_dir}")
install(FILES
  "${PROJECT_BINARY_DIR}/${PROJECT_NAME}Config.cmake"
  "${PROJECT_BINARY_DIR}/${PROJECT_NAME}ConfigVersion.cmake"
  cmake/CHOLMOD.cmake
  cmake/Ceres.cmake
  cmake/TBB.cmake
  DESTINATION "${package_dir}")
