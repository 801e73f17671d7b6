# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# cmake -D source=DIRECTORY -D version=VERSION -D work=DIRECTORY -P vcpkg.cmake: checks the manifest of
# the port for vcpkg, and runs its portfile without features. Functions below stand for vcpkg's: these
# configure with the options of the port, and install the headers.

cmake_minimum_required(VERSION 3.22)
set(port "${source}/packaging/vcpkg/cgal-intrinsic-triangulations")

function(check)
  if(NOT (${ARGN}))
    message(SEND_ERROR "vcpkg: this does not hold: ${ARGN}")
  endif()
endfunction()

file(READ "${port}/vcpkg.json" manifest)
string(JSON name GET "${manifest}" name)
string(JSON port_version GET "${manifest}" version)
string(JSON license GET "${manifest}" license)
check(name STREQUAL cgal-intrinsic-triangulations)
check(port_version VERSION_EQUAL version)
check(license STREQUAL GPL-3.0-or-later)

# Each feature has a description and is a feature of the portfile, and conversely.
function(vcpkg_check_features)
  cmake_parse_arguments(PARSE_ARGV 0 arg "" OUT_FEATURE_OPTIONS "FEATURES;INVERTED_FEATURES")
  check(NOT DEFINED arg_UNPARSED_ARGUMENTS)
  set(options)
  set(names)
  foreach(kind IN ITEMS FEATURES INVERTED_FEATURES)
    set(values FEATURES OFF INVERTED_FEATURES ON)
    list(FIND values ${kind} i)
    math(EXPR i "${i} + 1")
    list(GET values ${i} value)
    while(arg_${kind})
      list(POP_FRONT arg_${kind} feature variable)
      string(JSON description ERROR_VARIABLE error GET "${manifest}" features ${feature} description)
      check(error STREQUAL NOTFOUND)
      list(APPEND options -D${variable}=${value})
      list(APPEND names ${feature})
    endwhile()
  endforeach()
  string(JSON number LENGTH "${manifest}" features)
  list(LENGTH names number_of_names)
  check(number EQUAL number_of_names)
  set(${arg_OUT_FEATURE_OPTIONS} ${options} PARENT_SCOPE)
endfunction()

function(vcpkg_cmake_configure)
  cmake_parse_arguments(PARSE_ARGV 0 arg "" SOURCE_PATH OPTIONS)
  check(NOT DEFINED arg_UNPARSED_ARGUMENTS)
  check(arg_SOURCE_PATH STREQUAL source)
  execute_process(COMMAND ${CMAKE_COMMAND} -S "${arg_SOURCE_PATH}" -B "${work}/build"
      "-DCMAKE_INSTALL_PREFIX=${CURRENT_PACKAGES_DIR}" -DCMAKE_BUILD_TYPE=Release ${arg_OPTIONS}
    RESULT_VARIABLE failure OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(failure OR output MATCHES "not used by the project")
    message(FATAL_ERROR "vcpkg: an option of the port does not exist:\n${output}")
  endif()
endfunction()

function(vcpkg_cmake_install)
  execute_process(COMMAND ${CMAKE_COMMAND} --install "${work}/build" COMMAND_ERROR_IS_FATAL ANY
    OUTPUT_QUIET)
endfunction()

function(vcpkg_cmake_config_fixup)
  cmake_parse_arguments(PARSE_ARGV 0 arg "" "PACKAGE_NAME;CONFIG_PATH" "")
  check(NOT DEFINED arg_UNPARSED_ARGUMENTS)
  check(EXISTS "${CURRENT_PACKAGES_DIR}/${arg_CONFIG_PATH}/CGAL_intrinsic_triangulationsConfig.cmake")
  string(TOLOWER CGAL_intrinsic_triangulations expected)
  check(arg_PACKAGE_NAME STREQUAL expected)
endfunction()

function(vcpkg_install_copyright)
  cmake_parse_arguments(PARSE_ARGV 0 arg "" "" FILE_LIST)
  check(EXISTS "${arg_FILE_LIST}")
endfunction()

file(REMOVE_RECURSE "${work}")
set(CURRENT_PACKAGES_DIR "${work}/packages")
set(FEATURES core)
include("${port}/portfile.cmake")
check(EXISTS "${CURRENT_PACKAGES_DIR}/include/CGAL/Intrinsic_triangulations/make_Delaunay.h")
check(NOT EXISTS "${CURRENT_PACKAGES_DIR}/lib")
check(NOT EXISTS "${CURRENT_PACKAGES_DIR}/bin")
