#!/usr/bin/env bash
# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# The diagnosis of good, noteworthy and broken meshes, and the exit codes.
source "$(dirname "${BASH_SOURCE[0]}")/common.bash"

expect 0 info good.mesh.off
says 'Euler characteristic  2'
expect 0 info good.mesh.obj
expect 0 info isolated.mesh.off
says 'note: isolated vertex: 1, first at vertex 0'
expect 0 info two_components.mesh.off
says 'components            2'
! grep -E 'component: |(note|error):' out || fail 'two components are called a defect'
expect 0 delaunay two_components.mesh.off -o -
says 'note: connected components: 2'
# Only edges connect faces: two disks share a vertex.
off pinched '0 0 0,1 0 0,0 1 0,-1 0 0,0 -1 0' '0 1 2,0 3 4'
expect 2 info pinched.mesh.off
says 'components            2'
says 'boundary loops        2'
says 'Euler characteristic  2'
expect 0 info cap.mesh.off
says 'note: degenerate face: 1, first at face 2'
expect 0 info needle.mesh.off
says 'note: needle face: 1, first at face 0'

# broken NAME TEXT: refused by both commands, which name the file and the defect; nothing is
# written.
broken()
{
  refuses "$2" info "$1"
  refuses "$2" delaunay "$1" -o result.off --stats result.json --save result.save --strict
  says "$1"
  expect_files
}

broken repeated.mesh.off 'face with a repeated vertex: 1, first at face 1'
refuses 'edges                 3' info repeated.mesh.off
says 'faces                 1'
says 'Euler characteristic  1'
broken edge_of_three.mesh.off 'non-manifold edge: 1, first between vertices 0 and 1 (face 0)'
broken orientation.mesh.off 'inconsistent orientation: 1, first between vertices 0 and 2'
off moebius '0 0 0,1 0 0,0 1 0,1 1 1,0 0 2' '0 1 2,1 3 2,2 3 4,3 0 4,4 0 1'
broken moebius.mesh.off 'non-orientable component: 1, first at face 0'
broken bow_tie.mesh.off 'non-manifold vertex: 1, first at vertex 0'
broken zero_length.mesh.off 'zero-length edge: 1, first between vertices 1 and 2 (face 1)'
broken overflow.mesh.obj 'invalid edge length: 1, first between vertices 0 and 1'
off huge '0 0 0,1e40 0 0,0 1e40 0' '0 1 2'
broken huge.mesh.off 'edge length outside 2^-127 to 2^127'
says 'scale the mesh'
broken index.mesh.obj 'line 4 cannot be understood: there is no vertex 4; the file has 3'
broken index.mesh.ply 'face index out of range: 1, first at face 0'
broken index.mesh.off 'line 6 cannot be understood'
broken nan.mesh.off 'line 4 cannot be understood'
broken garbage.mesh.off 'line 4 cannot be understood'
broken truncated.mesh.off 'ends too early'
broken no_faces.mesh.off 'has no faces'
broken words.mesh.obj 'has no faces'
broken empty.mesh.off 'is empty'
broken unknown.mesh.xyz 'line 1 cannot be understood'
broken missing.mesh.off 'no such file'
broken / 'is a directory'

expect 0 info good.mesh.off --json
says '"euler_characteristic": 2'
says '"defects": []'
refuses '"is_valid": false' info bow_tie.mesh.off --json
refuses '"min_angle_degrees": null' info index.mesh.ply --json

# A vertex as near to the edge of a square as the rounding of its coordinates.
off near '0 0 0,1 0 0,1 1 0,0 1 0,0.5 1e-16 0' '0 1 4,1 2 4,2 3 4,3 0 4'
expect 0 info near.mesh.off
says 'note: vertex within rounding of an edge: 1, first at vertex 4 (face 0) - '
expect 0 info near.mesh.off --json
says '"vertex": 4'

for command in '' delaunay; do
  expect 0 $command --help
  says 'Examples:'
  mv out option
  expect 0 help $command
  cmp out option || fail "help $command is not $command --help"
done
rm option
expect 0 --version
says 'intrinsic '
expect 2
expect 2 info

# Polygons are no error, as commands split them, unless that is impossible.
expect 0 info polygon.mesh.off
says 'note: face that is not a triangle: 1, first at face 0 - commands split it, unless --strict is given'
! grep -q 'error:' out || fail 'a quadrilateral is called an error'
expect 0 info polygon.mesh.off --json
says '"is_valid": true'
says '"is_fatal": false'
off crossed '0 0 0,1 0 0,1 1 0,0 1 0' '0 2 1 3'
refuses 'error: crossed.mesh.off: face 0 crosses or touches itself' info crossed.mesh.off
refuses '"is_valid": false' info crossed.mesh.off --json
