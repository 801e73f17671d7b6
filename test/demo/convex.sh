#!/usr/bin/env bash
# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# Convex polyhedra of meshes and nets: the files, statistics and exit codes of the command convex.
source "$(dirname "${BASH_SOURCE[0]}")/common.bash"

# A dented octahedron becomes the octahedron whose vertex is on the other side.
off dent '1 0 0,-1 0 0,0 1 0,0 -1 0,0 0 -0.5,0 0 -1' \
  '0 2 4,2 1 4,1 3 4,3 0 4,2 0 5,1 2 5,3 1 5,0 3 5'
expect 0 convex dent.mesh.off -o dent.obj --stats dent.json --subdivision dent.ply
says 'convex polyhedron, 6 vertices'
claim "s = json('dent.json')" 's.convex' 's.convex_edges == 12' 's.max_edge_error < 1e-11'
claim "p = obj('dent.obj').points" 'near([dist(p[4], p[5])], [1.5], 1e-10)' \
  'near([dist(p[0], p[1])], [2], 1e-10)'
claim "{'input_x', 'intrinsic_edge'} <= set(ply('dent.ply').vertex)"
rm dent.obj dent.json dent.ply

# Six squares fold to a cube.
off cross '1 0 0,2 0 0,2 1 0,3 1 0,3 2 0,2 2 0,2 3 0,2 4 0,1 4 0,1 3 0,1 2 0,0 2 0,0 1 0,1 1 0' \
  '0 1 2 13,2 3 4 5,13 2 5 10,12 13 10 11,10 5 6 9,9 6 7 8'
printf '%s\n' '1 2 3 2 # a comment' '4 5 6 5' '10 11 10 9' '13 12 13 0' '0 1 8 7' '3 4 7 6' \
  '12 11 8 9' >cross.txt
expect 0 convex cross.mesh.off --glue cross.txt -o cube.obj --stats cube.json
claim "p = obj('cube.obj').points" 'len(p) == 8' \
  'near(sorted(dist(p[i], p[j]) for i in range(8) for j in range(i)), [1] * 12 + [2 ** .5] * 12 + [3 ** .5] * 4, 1e-10)' \
  "len(json('cube.json').vertex_map) == 14"
rm cube.obj cube.json

# What is wrong with a file of sides is said with its line.
printf '1 2 3 2\n4 5 7 99\n' >wrong.txt
refuses 'line 2' convex cross.mesh.off --glue wrong.txt -o x.off
printf '1 2 3 14\n' >wrong.txt
refuses 'vertex 14: the mesh has 14, counted from 0' convex cross.mesh.off --glue wrong.txt -o x.off
printf '1 2 2 3\n' >wrong.txt
refuses 'the surface would not be oriented; the sides must run in opposite directions around the net' \
  convex cross.mesh.off --glue wrong.txt -o x.off
printf '1 2 3 2\n1 2 3 4\n' >wrong.txt
refuses 'is glued twice' convex cross.mesh.off --glue wrong.txt -o x.off
printf '1 2 3 2\n' >wrong.txt
refuses 'is not glued' convex cross.mesh.off --glue wrong.txt -o x.off
printf '0 2 3 2\n' >wrong.txt
refuses 'is not on the boundary of the mesh' convex cross.mesh.off --glue wrong.txt -o x.off
printf '1 2 3 2 5\n' >wrong.txt
refuses 'more than four numbers in a line' convex cross.mesh.off --glue wrong.txt -o x.off
off oblong '0 0 0,2 0 0,2 1 0,0 1 0' '0 1 2 3'
printf '0 1 2 1\n' >wrong.txt
refuses 'the two sides have different lengths, ' convex oblong.mesh.off --glue wrong.txt -o x.off
refuses '--subdivision: a net has no positions in space; leave out --glue' \
  convex cross.mesh.off --glue cross.txt --subdivision x.ply -o x.off

# So is what keeps a mesh from being the surface of a convex polyhedron.
refuses 'has a boundary; if it is a net, --glue names the sides to glue' convex cross.mesh.off -o x.off
off saddle '0 0 0,2 0 0,2 1 0,1 1 0,1 2 0,0 2 0,0 0 1,2 0 1,2 1 1,1 1 1,1 2 1,0 2 1' \
  '6 7 8 9 10 11,5 4 3 2 1 0,0 1 7 6,1 2 8 7,2 3 9 8,3 4 10 9,4 5 11 10,5 0 6 11'
refuses 'negative curvature' convex saddle.mesh.off -o x.off
expect_files cross.txt wrong.txt

# An error in a last line without an end is an error in this line.
grid net 1 0
for line in '0 1 2 99' '0 1 2'; do
  printf '%s' "$line" >sides.txt
  refuses "$([ "$line" = '0 1 2' ] && echo 'ends too early' || echo 'line 1 cannot be understood: vertex 99')" \
    convex net.mesh.off --glue sides.txt -o a.off
done
expect_files cross.txt wrong.txt sides.txt
