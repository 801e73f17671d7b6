#!/usr/bin/env bash
# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# --repair mends what it can, tells what it did, and is the only thing that changes a mesh.
source "$(dirname "${BASH_SOURCE[0]}")/common.bash"

# mended NAME TEXT: strictly refused as it is, accepted with --repair, which says what it did.
mended()
{
  expect 2 delaunay "$1" -o result.off --strict
  expect 0 delaunay "$1" -o result.off --stats result.json --repair --quiet
  says "$1: repaired: $2"
  claim "json('result.json').repairs['${2%: *}'] == ${2##*: }"
  expect 0 info result.off
  rm result.off result.json
}

mended repeated.mesh.off 'degenerate or duplicate faces removed: 1'
mended edge_of_three.mesh.off 'points duplicated to make the surface manifold: 4'
mended orientation.mesh.off 'faces reversed: 1'
# Half of a closed surface is reversed: normals point outward. More than half: few faces change.
cube_points='0 0 0,1 0 0,1 1 0,0 1 0,0 0 1,1 0 1,1 1 1,0 1 1'
outward='0 3 2 1,4 5 6 7,0 1 5 4'
off half_reversed "$cube_points" "$outward,1 5 6 2,2 6 7 3,3 7 4 0"
off half_outward "$cube_points" '0 1 2 3,4 7 6 5,0 4 5 1,1 2 6 5,2 3 7 6,3 0 4 7'
off inward "$cube_points" '0 1 2 3,4 7 6 5,0 4 5 1,1 5 6 2,2 3 7 6,3 7 4 0'
for expected in 'half_reversed 3 1' 'half_outward 3 1' 'inward 1 -1'; do
  read -r mesh reversed volume <<<"$expected"
  expect 0 delaunay "$mesh.mesh.off" -o result.off --repair
  says "faces reversed: $reversed"
  claim "near(volume(off('result.off')), $volume, 1e-12)"
done
rm result.off
mended bow_tie.mesh.off 'points duplicated to make the surface manifold: 1'
mended zero_length.mesh.off 'points merged with an equal one: 1'

expect 0 delaunay isolated.mesh.off -o - --repair
says 'isolated points removed: 1'
expect 0 delaunay good.mesh.off -o - --repair
! grep -q repaired err || fail 'a good mesh was repaired'

# Repaired meshes need no repair, even if points were merged and duplicated again.
off parted '0 0 0,1 0 0,0 1 0,0 0 1,0 0 0,1 0 0,0 -1 0' '0 1 2,0 1 3,4 5 6'
expect 0 delaunay parted.mesh.off -o first.off --repair
says 'points duplicated to make the surface manifold: '
says 'the surface is manifold only if they are apart'
! grep -q 'repair merges' err || fail 'a repaired mesh is to be repaired'
expect 0 delaunay first.off -o second.off --repair
! grep -q 'repaired\|repair merges' err || fail 'a repaired mesh was repaired'
rm first.off second.off

# Two sides of a triangle are a closed surface; a face with an opposite one on a surface is not.
off pillow '0 0 0,1 0 0,0 1 0' '0 1 2,2 1 0'
expect 0 delaunay pillow.mesh.off -o result.off --repair
! grep -q repaired err || fail 'a triangle with two sides was repaired'
claim "len(off('result.off').faces) == 2"
rm result.off
off flap '0 0 0,1 0 0,0 1 0,1 1 0' '0 1 2,2 1 0,3 2 1'
mended flap.mesh.off 'degenerate or duplicate faces removed: 1'

expect 2 delaunay index.mesh.ply -o result.off --repair
expect 2 delaunay overflow.mesh.obj -o result.off --repair
expect_files

if [ -n "$data" ]; then
  for mesh in cube_quad.off blobby-shuffled.off quads_to_stitch.off; do
    expect 2 delaunay "$data/meshes/$mesh" -o result.off --strict
    expect 0 delaunay "$data/meshes/$mesh" -o result.off --repair
  done
fi

# Polygons with holes: bridges to two holes, and a hole with a corner on the boundary.
off keyhole '0 0 0,5 0 0,5 3 0,0 3 0,1 1 0,2 1 0,2 2 0,1 2 0,3 1 0,4 1 0,4 2 0,3 2 0' \
  '0 1 2 3 0 4 7 11 10 9 8 11 7 6 5 4'
off touching '0 0 0,3 0 0,3 3 0,0 3 0,2 1 0,1 2 0' '0 1 2 3 0 5 4'
for expected in 'keyhole 13' 'touching 7.5'; do
  read -r mesh area <<<"$expected"
  refuses 'face with a repeated vertex' delaunay "$mesh.mesh.off" -o a.ply
  expect 0 delaunay "$mesh.mesh.off" -o a.ply --repair --stats a.json
  says 'repaired: polygons with holes split into triangles: 1'
  claim "m = ply('a.ply')" "near(area(m), $area, 1e-12)"
  claim "json('a.json').components == 1" "json('a.json').boundary_loops == (3 if '$mesh' == 'keyhole' else 1)"
done
rm a.ply a.json
# Parts beside each other are no holes.
off pinched '0 0 0,2 0 0,1 1 0,-2 0 0,-1 1 0' '0 1 2 0 4 3'
expect 0 delaunay pinched.mesh.off -o a.ply --repair
says 'faces added by splitting pinched ones: 1'
rm a.ply
