#!/usr/bin/env bash
# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# Installs what the program needs, builds it, runs each of its commands on a mesh of CGAL's or one that
# this repository ships, and writes results/index.html, which shows all results.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"
trap 'echo "demo.sh: failed at: $BASH_COMMAND" >&2' ERR

# name | title | what to look at | command | mesh | arguments
runs=(
  'man|Intrinsic Delaunay triangulation|Edges of the input in gray, edges of the Delaunay triangulation in red: geodesics on the same surface.|delaunay|man.off|'
  'slivers|Delaunay, decided exactly|A torus of long triangles. Every decision is exact, and the result is certified.|delaunay|slivers.off|--exact'
  'joint|Refinement|All angles have 25 degrees or more, though the input has needles.|refine|joint.off|--min-angle 25'
  'mannequin|Geodesic distance|Dark is near; the page in 3D has isolines. Exact: the lengths of shortest paths.|distance|mannequin-devil.off|--source 0'
  'elephant|Map to the plane through cones|A closed surface, cut through cones chosen by the program; squares stay squares, of other sizes.|flatten|elephant.off|'
  'nefertiti|Map to a disk|A surface with boundary, mapped to the unit disk without a flipped triangle.|flatten|nefertiti.off|--boundary disk'
  'bull|Map to the sphere|A surface of genus zero as a convex polyhedron inscribed in the sphere, which is certified.|sphere|bull.off|'
  'eight|Hyperbolic metric|A surface with two handles in the Poincare disk, with the tiling by its group.|hyperbolic|eight.off|--tiles 2'
  'camel|Intrinsic simplification|One vertex in a hundred is left. The coarse edges lie on the surface of the input, which has not moved.|simplify|camel.off|--ratio 0.01')

scripts/set_up.sh program
cmake -S . -B build -G Ninja >build/configure.log || { cat build/configure.log >&2; false; }
echo "Building the program with $(nproc) processes"
cmake --build build --target intrinsic

mkdir -p results
number=0
for run in "${runs[@]}"; do
  IFS='|' read -r name title text command mesh arguments <<<"$run"
  printf '[%d/%d] intrinsic %s %s\n' $((++number)) ${#runs[@]} "$command" "$mesh $arguments"
  path=build/cgal_data/meshes/$mesh
  [ -f "$path" ] || path=demo/data/$mesh
  extension=ply
  case $command in flatten | hyperbolic) extension=obj ;; esac
  pages=(--picture "results/$name.png")
  # Without three.js, which is fetched when the program is configured, there are no pages.
  ! grep -q '^-- Three .*yes' build/configure.log || pages+=(--view "results/$name.html")
  # shellcheck disable=SC2086
  build/intrinsic "$command" "$path" $arguments -o "results/$name.$extension" \
    --stats "results/$name.json" "${pages[@]}" --quiet
done
printf '%s\n' "${runs[@]}" | python3 scripts/results_page.py results
