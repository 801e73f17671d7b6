#!/usr/bin/env bash
# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# Maps to the sphere, their files, statistics and exit codes of the command sphere.
source "$(dirname "${BASH_SOURCE[0]}")/common.bash"

# below A BOUND: whether a number is less.
below()
{
  awk -v a="$1" -v b="$2" 'BEGIN { exit !(a != "" && a < b) }' || fail "$1 is not below $2"
}

# is_convex FILE: the statistics are those of a map that nothing is wrong with.
is_convex()
{
  grep -q '"status": "success"' "$1"
  grep -q '"convex": true' "$1"
  for key in concave_edges flipped_triangles bound_violations; do
    [ "$(number "$1" $key)" = 0 ] || fail "$key in $1"
  done
  below "$(number "$1" max_cross_ratio_error)" 1e-8
  below "$(number "$1" max_inscribed_error)" 1e-15
}

# on_sphere FILE: all vertices of an OBJ file have distance one from the origin.
on_sphere()
{
  awk '$1 == "v" { ++n; if(($2 ^ 2 + $3 ^ 2 + $4 ^ 2 - 1) ^ 2 > 1e-28) exit 1 } END { if(!n) exit 1 }' "$1" ||
    fail "$1 is not on the sphere"
}

# A regular tetrahedron comes back, but for a rotation: six edges of length sqrt(8 / 3).
off regular '5 5 5,5 3 3,3 5 3,3 3 5' '0 1 2,0 2 3,0 3 1,1 3 2'
expect 0 sphere regular.mesh.off -o regular.obj --stats regular.json --precise regular.txt
says 'sphere, convex'
is_convex regular.json
on_sphere regular.obj
expect_files regular.json regular.obj regular.txt
[ "$(grep -c '^f ' regular.obj)" = 4 ]
awk '{ for(k = 0; k < 3; ++k) p[NR, k] = $(k + 2) }
  END {
    for(i = 1; i <= 4; ++i)
      for(j = 1; j < i; ++j) {
        d = 0
        for(k = 0; k < 3; ++k) d += (p[i, k] - p[j, k]) ^ 2
        if((d - 8 / 3) ^ 2 > 1e-24) exit 1
      }
  }' regular.txt || fail "the tetrahedron is not regular"
rm regular.json regular.obj regular.txt

# A square becomes a hemisphere with the boundary on the equator, and has the unit disk as texture.
grid square 6 0
expect 0 sphere square.mesh.off -o square.obj --stats square.json
says hemisphere
is_convex square.json
grep -q '"disk": true' square.json
on_sphere square.obj
awk '$1 == "v" { if($4 < 0) exit 1; boundary += $4 == 0 }
  $1 == "vt" { if($2 ^ 2 + $3 ^ 2 > 1 + 1e-14) exit 1; ++n }
  END { exit !(n && boundary >= 24) }' square.obj || fail "no hemisphere"
expect 0 sphere square.mesh.off -o square.ply
grep -q '^property double homogeneous_w$' square.ply
grep -q '^property double input_x$' square.ply
expect 0 sphere square.mesh.off -o - --format off
grep -q '^OFF' out
# the same bytes again
expect 0 sphere square.mesh.off -o again.ply
cmp square.ply again.ply
rm square.json square.obj square.ply again.ply

# Vertices without faces stay: above the sphere's center, or on the equator beside a disk.
expect 0 sphere isolated.mesh.off -o isolated.ply --stats isolated.json --precise isolated.txt
is_convex isolated.json
[ "$(vertices isolated.ply | head -n 1)" = '0 0 1 0 0 9 9 9 0 0 0 0' ] || fail "$(vertices isolated.ply | head -n 1)"
[ "$(wc -l <isolated.txt)" = 5 ] || fail 'not all positions'
with_isolated square more
expect 0 sphere more.mesh.off -o isolated.obj --stats isolated.json
is_convex isolated.json
on_sphere isolated.obj
[ "$(head -n 1 isolated.obj)" = 'v 1 0 0' ] || fail "$(head -n 1 isolated.obj)"
expect 0 uniformize isolated.mesh.off -o isolated.obj --stats isolated.json
grep -q '"surface_type": "sphere"' isolated.json
rm isolated.json isolated.obj isolated.ply isolated.txt

# Bad input and bad calls write nothing.
off two '0 0 0,1 0 0,0 1 0,5 5 5,6 5 5,5 6 5' '0 1 2,3 4 5'
expect 2 sphere two.mesh.off -o two.ply
says 'not connected'
expect 2 sphere regular.mesh.off
expect 2 sphere regular.mesh.off -o sphere.xyz
expect_files

# Long limbs: more digits than double has are needed, and the statistics say what the output has
# lost.
if [ -n "$data" ] && [ -f "$data/meshes/dino.off" ]; then
  expect 0 sphere "$data/meshes/dino.off" -o dino.ply --stats dino.json
  is_convex dino.json
  grep -q '"extended_precision": true' dino.json
  [ "$(number dino.json lost_in_output)" -gt 0 ]
fi
