#!/usr/bin/env bash
# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# Sets up what is missing, builds the program, makes two meshes Delaunay, a real one of CGAL's and
# one that this repository ships, refines two bad real ones to angles of 25 degrees, flattens two
# others, a closed one through cones and one with boundary to a disk, maps one to the sphere and one
# to the hyperbolic plane, and simplifies one.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"
trap 'echo "demo.sh: failed at: $BASH_COMMAND" >&2' ERR

meshes=(build/cgal_data/meshes/man.off demo/data/slivers.off)
bad_meshes=(build/cgal_data/meshes/{blade,cheese}.off)
closed_mesh=build/cgal_data/meshes/elephant.off
open_mesh=build/cgal_data/meshes/nefertiti.off
sphere_mesh=build/cgal_data/meshes/bull.off
hyperbolic_mesh=build/cgal_data/meshes/eight.off
fine_mesh=build/cgal_data/meshes/camel.off

# print_values NAME FORMAT: the name and values of its statistics s, as a Python f-string formats them.
print_values()
{
  python3 test/demo/files.py "s = json('results/$1.json')" "print(f'''{\"$1\":16}$2''')"
}

print_row()
{
  print_values "$1" '{s.vertices:10}{s.flips:10}{s.min_angle_degrees:12.4f}'\
'{s.crossings:12}{s.subdivision.faces:12}{sum(s.seconds.values()):10.3f}'
}

# least_angle MESH: as `intrinsic info` says it.
least_angle()
{
  build/intrinsic info "$1" --json >results/info.json || true
  python3 test/demo/files.py "print(json('results/info.json').min_angle_degrees)"
}

print_refined_row()
{
  print_values "$(basename "$1" .off)" "{s.vertices:10}{s.inserted_vertices:10}"\
"{$(least_angle "$1"):12.4f}{s.min_angle_degrees:12.4f}{s.faces_below_bound:12}"\
"{s.seconds.refine:10.3f}  {s.status}"
}

# print_map_row MESH KEY ...: the values under the keys, and the status.
print_map_row()
{
  local key format=
  for key in "${@:2}"; do
    format+="{'true' if s.$key is True else format(s.$key, '.6g'):>14}"
  done
  print_values "$(basename "$1" .off)" "$format  {s.status}"
}

# print_coarse_row MESH
print_coarse_row()
{
  print_values "$(basename "$1" .off)" "{s.vertices:10}{s.coarse_vertices:10}{s.operations:12}"\
"{s.area_ratio:12.4f}{$(least_angle "$1"):12.4f}{s.min_angle_degrees:12.4f}"\
"{s.seconds.simplify:10.3f}  {s.status}"
}

scripts/set_up.sh
cmake -S . -B build -G Ninja >build/configure.log || { cat build/configure.log >&2; false; }
cmake --build build --target intrinsic

mkdir -p results
for mesh in "${meshes[@]}"; do
  name=$(basename "$mesh" .off)
  build/intrinsic delaunay "$mesh" -o "results/$name.ply" --stats "results/$name.json"
done
for mesh in "${bad_meshes[@]}"; do
  name=$(basename "$mesh" .off)
  build/intrinsic refine "$mesh" -o "results/$name.ply" --stats "results/$name.json" --min-angle 25
done
build/intrinsic flatten "$closed_mesh" -o results/elephant.obj --stats results/elephant.json
build/intrinsic flatten "$open_mesh" -o results/nefertiti.obj --stats results/nefertiti.json \
  --boundary disk
build/intrinsic sphere "$sphere_mesh" -o results/bull.ply --stats results/bull.json
build/intrinsic hyperbolic "$hyperbolic_mesh" -o results/eight.obj --stats results/eight.json \
  --svg results/eight.svg --tiles 1
build/intrinsic simplify "$fine_mesh" -o results/camel.ply --stats results/camel.json --ratio 0.01

printf '\n%-16s%10s%10s%12s%12s%12s%10s\n' \
  mesh vertices flips 'min angle' crossings 'sub. faces' seconds
for mesh in "${meshes[@]}"; do
  print_row "$(basename "$mesh" .off)"
done

printf '\n%-16s%10s%10s%12s%12s%12s%10s  %s\n' \
  refined vertices inserted 'angle was' 'angle is' 'faces below' seconds status
for mesh in "${bad_meshes[@]}"; do
  print_refined_row "$mesh"
done

printf '\n%-16s%14s%14s%14s%14s%14s%14s  %s\n' \
  flattened vertices cones 'Ptolemy flips' 'curv. error' 'cross ratios' flipped status
for mesh in "$closed_mesh" "$open_mesh"; do
  print_map_row "$mesh" vertices cones ptolemy_flips max_curvature_error max_cross_ratio_error \
    flipped_triangles
done

printf '\n%-16s%14s%14s%14s%14s%14s  %s\n' \
  sphere vertices 'Ptolemy flips' convex 'curv. error' 'cross ratios' status
print_map_row "$sphere_mesh" vertices ptolemy_flips convex max_curvature_error max_cross_ratio_error
printf '\n%-16s%14s%14s%14s%14s%14s  %s\n' \
  hyperbolic vertices 'Ptolemy flips' area 'curv. error' 'gluing error' status
print_map_row "$hyperbolic_mesh" vertices ptolemy_flips area max_curvature_error max_gluing_error

printf '\n%-16s%10s%10s%12s%12s%12s%12s%10s  %s\n' \
  simplified vertices coarse operations 'area ratio' 'angle was' 'angle is' seconds status
print_coarse_row "$fine_mesh"
echo
echo "Common subdivisions (.ply; .obj with texture coordinates), coarse faces (camel.ply), a tiling (eight.svg) and statistics (.json) are in $PWD/results"
