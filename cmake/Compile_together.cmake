# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# Adds sources, without .cpp, to `sources`. They are compiled together, as a group of a target with
# UNITY_BUILD_MODE GROUP: that takes half of the time if their templates are the same.
function(compile_together group)
  list(TRANSFORM ARGN APPEND .cpp)
  set_source_files_properties(${ARGN} PROPERTIES UNITY_GROUP ${group})
  set(sources ${sources} ${ARGN} PARENT_SCOPE)
endfunction()
