#!/usr/bin/env bash
# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# Sets up what is missing, builds the program and makes two meshes Delaunay: a real one of CGAL's,
# and one that this repository ships.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"
trap 'echo "demo.sh: failed at: $BASH_COMMAND" >&2' ERR

meshes=(build/cgal_data/meshes/man.off demo/data/slivers.off)

# value FILE KEY: the number under a key of a flat JSON object without spaces.
value()
{
  sed -n "s/.*\"$2\":\([^,}]*\).*/\1/p" <<<"$1"
}

print_row()
{
  local json outer subdivision seconds
  json=$(tr -d ' \n' <"results/$1.json")
  subdivision=$(sed 's/.*"subdivision":\({[^}]*}\).*/\1/' <<<"$json")
  seconds=$(sed 's/.*"seconds":{\([^}]*\)}.*/\1/' <<<"$json" | tr ',' '\n' |
    awk -F: '{ sum += $2 } END { printf "%.3f", sum }')
  outer=$(sed 's/:{[^}]*}/:0/g' <<<"$json")
  printf '%-16s%10s%10s%12.4f%12s%12s%10s\n' "$1" "$(value "$outer" vertices)" \
    "$(value "$outer" flips)" "$(value "$outer" min_angle_degrees)" \
    "$(value "$outer" crossings)" "$(value "$subdivision" faces)" "$seconds"
}

scripts/set_up.sh
cmake -S . -B build -G Ninja >build/configure.log || { cat build/configure.log >&2; false; }
cmake --build build --target intrinsic

mkdir -p results
for mesh in "${meshes[@]}"; do
  name=$(basename "$mesh" .off)
  build/intrinsic delaunay "$mesh" -o "results/$name.ply" --stats "results/$name.json"
done

printf '\n%-16s%10s%10s%12s%12s%12s%10s\n' \
  mesh vertices flips 'min angle' crossings 'sub. faces' seconds
for mesh in "${meshes[@]}"; do
  print_row "$(basename "$mesh" .off)"
done
echo
echo "Common subdivisions (.ply) and statistics (.json) are in $PWD/results"
