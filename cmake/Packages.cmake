# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# Debian packages, one of each component: `cpack` in the build directory, or the target `package`,
# writes them into build/packages.

find_program(DPKG_SHLIBDEPS dpkg-shlibdeps)
mark_as_advanced(DPKG_SHLIBDEPS)
if(NOT DPKG_SHLIBDEPS)
  return()
endif()

file(READ package_info/Intrinsic_triangulations/maintainer maintainer)
string(STRIP "${maintainer}" CPACK_PACKAGE_CONTACT)
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME cgal-intrinsic-triangulations)
set(CPACK_PACKAGE_VENDOR "${CPACK_PACKAGE_CONTACT}")
set(CPACK_PACKAGE_DIRECTORY "${PROJECT_BINARY_DIR}/packages")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)

set(debian_dir "${PROJECT_BINARY_DIR}/debian")
set(debian_version "${PROJECT_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE}")
string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)
configure_file(packaging/debian/copyright.in "${debian_dir}/copyright" @ONLY)
configure_file(packaging/debian/changelog.in "${debian_dir}/changelog.Debian" @ONLY)
configure_file(packaging/debian/intrinsic.1.in "${debian_dir}/intrinsic.1" @ONLY)
configure_file(CHANGES.md "${debian_dir}/changelog" COPYONLY)
foreach(name IN ITEMS changelog changelog.Debian intrinsic.1)
  execute_process(COMMAND gzip -9nc "${debian_dir}/${name}" OUTPUT_FILE "${debian_dir}/${name}.gz")
endforeach()

# Adds the package `name` of an install component. The further arguments are fields of the package and
# their values, as CPack calls them: SECTION, DEPENDS, RECOMMENDS, SUGGESTS, ARCHITECTURE, SHLIBDEPS.
function(add_debian_package component name description)
  string(TOUPPER ${component} id)
  set(prefix CPACK_DEBIAN_${id})
  set(${prefix}_PACKAGE_NAME ${name} PARENT_SCOPE)
  set(${prefix}_DESCRIPTION "${description}" PARENT_SCOPE)
  while(ARGN)
    list(POP_FRONT ARGN field value)
    set(${prefix}_PACKAGE_${field} "${value}" PARENT_SCOPE)
  endwhile()
  set(CPACK_COMPONENTS_ALL ${CPACK_COMPONENTS_ALL} ${component} PARENT_SCOPE)
  install(FILES "${debian_dir}/copyright" "${debian_dir}/changelog.gz"
    "${debian_dir}/changelog.Debian.gz"
    DESTINATION share/doc/${name} COMPONENT ${component} EXCLUDE_FROM_ALL)
endfunction()

set(headers libcgal-intrinsic-triangulations-dev)
add_debian_package(headers ${headers}
  "intrinsic triangulations of surface meshes (headers)
C++ headers in the style of CGAL, with files for CMake: intrinsic Delaunay
triangulations with exact correspondence, geodesics, discrete conformal maps,
and intrinsic simplification."
  SECTION libdevel ARCHITECTURE all
  DEPENDS "libcgal-dev (>= 5.5), libeigen3-dev (>= 3.3)"
  RECOMMENDS libsuitesparse-dev SUGGESTS "libceres-dev, libtbb-dev")
if(TARGET Intrinsic_triangulations_compiled)
  set(compiled_depends "${headers} (= ${debian_version})")
  if(SuiteSparse_FOUND)
    string(APPEND compiled_depends ", libsuitesparse-dev")
  endif()
  if(TBB_FOUND)
    string(APPEND compiled_depends ", libtbb-dev")
  endif()
  add_debian_package(compiled libcgal-intrinsic-triangulations-compiled-dev
    "intrinsic triangulations of surface meshes (compiled library)
A static library of functions that applications otherwise compile from the
headers. It shortens the compilation of applications. Results do not change."
    SECTION libdevel DEPENDS "${compiled_depends}")
endif()
if(TARGET intrinsic)
  add_debian_package(program intrinsic
    "program for intrinsic triangulations of surface meshes
A command-line program for surface meshes: intrinsic Delaunay triangulations,
geodesic distances and paths, matrices for solvers, conformal maps, and
simplification."
    SECTION math SHLIBDEPS ON RECOMMENDS libopenblas0-serial)
  install(FILES "${debian_dir}/intrinsic.1.gz"
    DESTINATION share/man/man1 COMPONENT program EXCLUDE_FROM_ALL)
endif()
if(Debian_Python)
  add_debian_package(python3 python3-intrinsic
    "intrinsic triangulations of surface meshes (Python 3 package)
Functions for arrays of numpy: intrinsic Delaunay triangulations, geodesic
distances, matrices of scipy, conformal maps, and simplification of surface
meshes."
    SECTION python SHLIBDEPS ON DEPENDS "${Debian_Python}"
    RECOMMENDS "libopenblas0-serial, python3-scipy")
endif()

include(CPack)
