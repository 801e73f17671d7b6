# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# Parses the large headers of other libraries once for all source files of `target`, and of others
# that name it in REUSE_FROM: they take most of the time where there are many files.
function(precompile_dependencies target)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "REUSE_FROM" "")
  # ccache can only cache g++'s use of a precompiled header with this.
  target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess>)
  if(arg_REUSE_FROM)
    target_precompile_headers(${target} REUSE_FROM ${arg_REUSE_FROM})
    return()
  endif()
  target_precompile_headers(${target} PRIVATE
    <CGAL/Exact_predicates_inexact_constructions_kernel.h>
    <CGAL/Simple_cartesian.h>
    <CGAL/Surface_mesh.h>
    <CGAL/boost/graph/IO/polygon_mesh_io.h>)
  if(Eigen_FOUND)
    target_precompile_headers(${target} PRIVATE <Eigen/SparseCholesky>)
  endif()
endfunction()
