# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# Fetches three.js, with which the pages of --view draw: sets Three_FOUND, and Three_FILES to its
# modules and its licence. Without a network, Three_ARCHIVE can name the archive of the npm registry.
# The hash is what makes the archive trusted, so that the certificates of proxies do not matter.

set(Three_VERSION 0.170.0)
set(Three_SHA512 1502be2c4a587347c10fe27c83aa12132c8dce3a7e43b2acd42e7af1659aa0c44b5be4e434d5a67a759e1a0263575d3919dfa9ff6aa5d5972362f3623d9061b9)
set(Three_DIR "${PROJECT_BINARY_DIR}/three")
set(Three_ARCHIVE "${Three_DIR}/three-${Three_VERSION}.tgz" CACHE FILEPATH "Archive of three.js")
mark_as_advanced(Three_ARCHIVE)

if(NOT EXISTS "${Three_ARCHIVE}")
  file(DOWNLOAD "https://registry.npmjs.org/three/-/three-${Three_VERSION}.tgz"
    "${Three_ARCHIVE}.part" STATUS status INACTIVITY_TIMEOUT 20 TLS_VERIFY OFF)
  list(GET status 0 code)
  if(code EQUAL 0)
    file(RENAME "${Three_ARCHIVE}.part" "${Three_ARCHIVE}")
  else()
    file(REMOVE "${Three_ARCHIVE}.part")
    message(STATUS "three.js cannot be fetched: ${status}")
  endif()
endif()

if(EXISTS "${Three_ARCHIVE}")
  file(SHA512 "${Three_ARCHIVE}" hash)
  if(NOT hash STREQUAL Three_SHA512)
    message(FATAL_ERROR "${Three_ARCHIVE} is not version ${Three_VERSION} of three.js")
  endif()
  set(Three_FILES
    package/LICENSE package/build/three.module.min.js
    package/examples/jsm/controls/TrackballControls.js
    package/examples/jsm/lines/LineSegments2.js
    package/examples/jsm/lines/LineSegmentsGeometry.js
    package/examples/jsm/lines/LineMaterial.js)
  if(NOT EXISTS "${Three_DIR}/package/LICENSE")
    file(ARCHIVE_EXTRACT INPUT "${Three_ARCHIVE}" DESTINATION "${Three_DIR}"
      PATTERNS ${Three_FILES})
  endif()
  list(TRANSFORM Three_FILES PREPEND "${Three_DIR}/")
  set(Three_FOUND TRUE)
endif()
