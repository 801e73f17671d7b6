#!/usr/bin/env bash
# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# The manual names every option of every command, and every key of the statistics.
source "$(dirname "${BASH_SOURCE[0]}")/common.bash"

manual=("$tests"/../../doc/Intrinsic_triangulations/Program*.txt)

# names WHAT TEXT: a page about the program has the text.
names()
{
  grep -qF -- "$2" "${manual[@]}" || fail "the manual does not name the $1 $2"
}

for command in info view delaunay refine distance path transfer operators flatten sphere hyperbolic \
  uniformize convex pack simplify; do
  expect 0 $command --help
  names command "\`$command"
  for option in $(grep -oE -- '--[a-z][a-z-]*' out | sort -u); do
    names "option of $command" "$option"
  done
done

# keys ARGUMENTS...: runs the program with statistics, whose keys the manual names.
keys()
{
  expect 0 "$@" --stats stats.json --quiet
  for key in $(python3 -c 'import json; print(*json.load(open("stats.json")))'); do
    names "statistics of $1:" "\`$key\`"
  done
}

grid square 6 0
sphere=$data/meshes/tetrahedron.off
keys delaunay square.mesh.off -o out.ply --exact
keys refine square.mesh.off -o out.ply
keys distance square.mesh.off --source 0 --method heat -o out.ply
keys distance square.mesh.off --source 0 -o out.ply
keys path square.mesh.off --from 0 --to 30 --flips -o out.obj
keys operators square.mesh.off --prefix out
keys flatten square.mesh.off -o out.obj --exact
keys sphere "$sphere" -o out.ply
keys hyperbolic "$data/meshes/eight.off" -o out.obj
keys uniformize "$data/meshes/torus_quad.off" -o out.obj
keys convex "$sphere" -o out.off
keys pack square.mesh.off -o out.ply
keys simplify square.mesh.off -o out.ply --vertices 20 --min-angle 10
