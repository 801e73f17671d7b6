# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

include(CMakePackageConfigHelpers)
include(GNUInstallDirs)

set(package_dir "${CMAKE_INSTALL_DATADIR}/cmake/${PROJECT_NAME}")

configure_package_config_file(cmake/Config.cmake.in "${PROJECT_NAME}Config.cmake"
  INSTALL_DESTINATION "${package_dir}" NO_SET_AND_CHECK_MACRO)
# The headers suit all architectures. Config.cmake.in checks the architecture of the compiled library.
write_basic_package_version_file("${PROJECT_NAME}ConfigVersion.cmake"
  COMPATIBILITY SameMinorVersion ARCH_INDEPENDENT)

install(DIRECTORY include/ DESTINATION include COMPONENT headers)
install(TARGETS Intrinsic_triangulations EXPORT targets COMPONENT headers)
install(EXPORT targets NAMESPACE ${PROJECT_NAME}:: COMPONENT headers
  FILE "${PROJECT_NAME}Targets.cmake" DESTINATION "${package_dir}")
if(TARGET Intrinsic_triangulations_compiled)
  install(TARGETS Intrinsic_triangulations_compiled EXPORT compiled_targets COMPONENT compiled)
  install(EXPORT compiled_targets NAMESPACE ${PROJECT_NAME}:: COMPONENT compiled
    FILE "${PROJECT_NAME}CompiledTargets.cmake" DESTINATION "${package_dir}")
endif()
install(FILES
  "${PROJECT_BINARY_DIR}/${PROJECT_NAME}Config.cmake"
  "${PROJECT_BINARY_DIR}/${PROJECT_NAME}ConfigVersion.cmake"
  cmake/CHOLMOD.cmake
  cmake/Ceres.cmake
  cmake/TBB.cmake
  DESTINATION "${package_dir}" COMPONENT headers)
