#!/usr/bin/env bash
# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# Prints which jobs are done by which types or functions, and the header where each stands. A job
# with several lines has several mechanisms. Fails if a header does not define what it should.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

status=0

# mechanism JOB NAME HEADER
mechanism() {
  if ! grep -qsE "^ *(class|struct) $2\b|\b$2\(" "$3"; then
    echo "mechanisms: $3 does not define $2" >&2
    status=1
  fi
  printf '%-14s%-24s%s\n' "$1" "$2" "$3"
}

headers=include/CGAL/Intrinsic_triangulations
internal=$headers/internal

mechanism crossing Edge_course $headers/Edge_course.h
mechanism strip Euclidean_strip $headers/Euclidean_strip.h
mechanism strip Ideal_strip $headers/Ideal_strip.h
mechanism strip Certain_strip $internal/certificates/Certain_strip.h
mechanism strip Development $internal/certificates/Development.h
mechanism strip Developed_location $internal/insertion/Exact_insertion.h
mechanism strip Circumcenter_walk $internal/refinement/Circumcenter_walk.h
mechanism point surface_point $headers/Surface_point.h
mechanism locator Face_regions $internal/tracing/Face_regions.h
mechanism locator Input_face_walk $internal/tracing/Input_face_walk.h
mechanism insertion Vertex_inserter $headers/Vertex_inserter.h
mechanism flips flip_waiting $headers/Edge_stack.h
mechanism Dijkstra Dijkstra_search $headers/Dijkstra_search.h
mechanism union-find Mesh_components $headers/Mesh_components.h
mechanism assembly assemble $headers/sparse_assembly.h
mechanism factors Factorization $headers/Factorization.h
mechanism tree-cotree Tree_cotree $headers/Tree_cotree.h
mechanism 'cut graph' Cut_graph $headers/Cut_graph.h
mechanism layout Unfolded_faces include/CGAL/Discrete_conformal_maps/internal/planar_layouts/Unfolded_faces.h
mechanism converter add_edges_and_polygons demo/writing/subdivision_elements.h
mechanism canvas Canvas demo/pictures/Canvas.h
exit $status
