#!/usr/bin/env bash
# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# Maps to the sphere, their files, statistics and exit codes of the command sphere.
source "$(dirname "${BASH_SOURCE[0]}")/common.bash"

# is_convex FILE: the statistics are those of a map that nothing is wrong with.
is_convex()
{
  claim "s = json('$1')" "s.status == 'success'" 's.convex' \
    's.concave_edges == s.flipped_triangles == s.bound_violations == 0' \
    's.max_cross_ratio_error < 1e-8' 's.max_inscribed_error < 1e-15'
}

# on_sphere FILE: all vertices of an OBJ file have distance one from the origin.
on_sphere()
{
  claim "near([fsum(x * x for x in p) for p in obj('$1').points], [1] * len(obj('$1').points), 1e-14)"
}

# A regular tetrahedron comes back, but for a rotation: six edges of length sqrt(8 / 3).
off regular '5 5 5,5 3 3,3 5 3,3 3 5' '0 1 2,0 2 3,0 3 1,1 3 2'
expect 0 sphere regular.mesh.off -o regular.obj --stats regular.json --precise regular.txt
says 'sphere, convex'
is_convex regular.json
on_sphere regular.obj
expect_files regular.json regular.obj regular.txt
claim "len(obj('regular.obj').faces) == 4"
claim "p = [list(map(float, l.split()[1:])) for l in lines_of('regular.txt') if l]" 'len(p) == 4' \
  'all(near(dist(p[i], p[j]) ** 2, 8 / 3, 1e-12) for i in range(4) for j in range(i))'
rm regular.json regular.obj regular.txt

# A square becomes a hemisphere with the boundary on the equator, and has the unit disk as texture.
grid square 6 0
expect 0 sphere square.mesh.off -o square.obj --stats square.json
says hemisphere
is_convex square.json
claim "json('square.json').disk"
on_sphere square.obj
claim "m = obj('square.obj')" 'all(p[2] >= 0 for p in m.points)' \
  'sum(p[2] == 0 for p in m.points) >= 24' \
  'm.texture and all(fsum(x * x for x in z) <= 1 + 1e-14 for z in m.texture)'
expect 0 sphere square.mesh.off -o square.ply
claim "{'homogeneous_w', 'input_x'} <= set(ply('square.ply').vertex)"
expect 0 sphere square.mesh.off -o - --format off
grep -q '^OFF' out
# the same bytes again
expect 0 sphere square.mesh.off -o again.ply
cmp square.ply again.ply
rm square.json square.obj square.ply again.ply

# Vertices without faces stay: above the sphere's center, or on the equator beside a disk.
expect 0 sphere isolated.mesh.off -o isolated.ply --stats isolated.json --precise isolated.txt
is_convex isolated.json
claim "[values[0] for values in ply('isolated.ply').vertex.values()] == [0, 0, 1, 0, 0, 9, 9, 9, 0, 0, 0, 0]"
[ "$(wc -l <isolated.txt)" = 5 ] || fail 'not all positions'
with_isolated square more
expect 0 sphere more.mesh.off -o isolated.obj --stats isolated.json
is_convex isolated.json
on_sphere isolated.obj
[ "$(head -n 1 isolated.obj)" = 'v 1 0 0' ] || fail "$(head -n 1 isolated.obj)"
expect 0 uniformize isolated.mesh.off -o isolated.obj --stats isolated.json
claim "json('isolated.json').surface_type == 'sphere'"
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
  claim "json('dino.json').extended_precision" "json('dino.json').lost_in_output > 0"
fi

# Long limbs: a tetrahedron with a spike of 25 rings on a face. All digits of --precise hold: as
# fractions, the points are on the sphere, and no two of them are the same, as they are in double.
awk 'BEGIN {
  n = 25
  print "OFF\n" 4 + 3 * n, 4 + 6 * n, 0
  print "0 0 -3\n3 0 0\n-1.5 2.6 0\n-1.5 -2.6 0"
  for(i = 1; i <= n; ++i)
    print 0.3, 0, i * 0.5 "\n" -0.15, 0.26, i * 0.5 "\n" -0.15, -0.26, i * 0.5
  print "3 0 2 1\n3 0 3 2\n3 0 1 3"
  for(i = 0; i < n; ++i)
    for(j = 0; j < 3; ++j) {
      a = 1 + 3 * i + j; b = 1 + 3 * i + (j + 1) % 3
      print 3, a, b, b + 3 "\n" 3, a, b + 3, a + 3
    }
  print 3, 1 + 3 * n, 2 + 3 * n, 3 + 3 * n
}' >spike.mesh.off
expect 0 sphere spike.mesh.off -o spike.ply --precise spike.txt --stats spike.json
python3 - <<'PYTHON' || fail 'precise positions'
from fractions import Fraction
lines = [line.split() for line in open('spike.txt')]
assert [int(line[0]) for line in lines] == list(range(79))
points = [tuple(map(Fraction, line[1:])) for line in lines]
error = max(abs(x * x + y * y + z * z - 1) for x, y, z in points)
assert error < 3e-31, float(error)
assert len(set(points)) == 79
assert len({tuple(map(float, p)) for p in points}) < 79
PYTHON
rm spike.*
