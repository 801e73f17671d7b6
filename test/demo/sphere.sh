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
claim "s = json('square.json')" 's.disk' 's.flat is False' 's.flipped_in_output == 0' 's.flipped_faces == []' \
  's.components == 1' '[(c.component, c.vertices, c.faces, c.first_face) for c in s.component_maps] == [(0, 49, 72, 0)]' \
  'all(s[k] == c[k] for c in s.component_maps for k in ("disk", "flat", "status", "promises", "subdivision"))'
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
claim "s = json('isolated.json')" "s.surface_type == s.component_maps[0].surface_type == 'sphere'" \
  's.component_maps[0].vertices == 4'
rm isolated.json isolated.obj isolated.ply isolated.txt

# strip NAME N: unit squares in a row; vertices 2 i and 2 i + 1 are across.
strip()
{
  awk -v n="$2" 'BEGIN {
    print "OFF\n" 2 * n + 2, 2 * n, 0
    for(i = 0; i <= n; ++i) print i, 0, 0 "\n" i, 1, 0
    for(i = 0; i < n; ++i) {
      a = 2 * i
      print 3, a, a + 2, a + 3 "\n" 3, a, a + 3, a + 1
    }
  }' >"$1.mesh.off"
}

# Disks without vertices inside become polygons in the unit circle: each square of a strip keeps its
# cross ratio, whatever the command.
strip strip 8
for command in sphere uniformize; do
  expect 0 $command strip.mesh.off -o strip.obj --stats strip.json
  says 'inscribed polygon, convex'
  is_convex strip.json
  on_sphere strip.obj
  claim "s = json('strip.json')" 's.flat is True and s.disk and s.lost_in_output == 0' \
    's.flipped_in_output == 0 and s.flipped_faces == [] and s.component_maps[0].flat is True' \
    "p = obj('strip.obj').points" 'len(p) == 18 and all(x[2] == 0 for x in p)' \
    'near([dist(p[i], p[i + 2]) * dist(p[i + 3], p[i + 1]) / dist(p[i], p[i + 1]) / dist(p[i + 2], p[i + 3]) for i in range(0, 16, 2)], [1] * 8, 1e-8)' \
    "obj('strip.obj').texture == [(x, y) for x, y, z in p]"
done
# of two triangles no more than two are lost, and the same with obtuse angles at the boundary
off rectangle '0 0 0,4 0 0,4 3 0,0 3 0' '0 1 2,0 2 3'
off kite '0 0 0,4 0 0,9 1 0,4 9 0' '0 1 2,0 2 3'
for mesh in rectangle kite; do
  expect 0 sphere $mesh.mesh.off -o strip.obj --stats strip.json
  is_convex strip.json
  claim "json('strip.json').lost_in_output == 0" "flat_area(obj('strip.obj')) > 0"
done
# a strip with ends that are too small for coordinates in double
strip strip 400
expect 0 sphere strip.mesh.off -o strip.obj --stats strip.json
says 'note: faces too small for coordinates in double: '
claim "s = json('strip.json')" "s.status == 'success'" 'len(s.crowded_faces) > 0'
# faces of a component have their numbers in the mesh
awk '
  NR == 1 { print }
  NR == 2 { v = $1; print v + 4, $2 + 2, 0 "\n0 90 0\n1 90 0\n1 91 0\n0 91 0" }
  NR > 2 && NR <= v + 2 { print }
  NR == v + 3 { print "3 0 1 2\n3 0 2 3" }
  NR > v + 2 && NR > 2 { print 3, $2 + 4, $3 + 4, $4 + 4 }' strip.mesh.off >two.mesh.off
expect 0 sphere two.mesh.off -o two.obj --component 1 --stats two.json
claim "s = json('two.json')" 's.crowded_faces == [f + 2 for f in json("strip.json").crowded_faces]'
rm strip.obj strip.json two.obj two.json

# Disks of a few thin triangles, whose angles are known but not after flips.
off thin '0.1455 56.9 -0.05769,0.02501 -34.82 -0.01768,-0.1463 -3.555 -0.05791,0.07906 -23.13 0.01459,0.001911 33.01 0.01795,-0.07133 -61.42 -0.03389' \
  '4 0 2,4 2 5,2 0 5,5 3 4,0 1 5,3 1 0,4 3 0'
off thinner '-27.6 0.03 -0.0279,26.4 -0.0675 -0.0172,-20.5 -0.0376 -0.0282,16.2 0.0536 0.0332,-5.07 -0.0947 -0.0468,8.2 -0.0803 -0.0142,21.8 0.00182 -0.048,2.79 -0.0306 0.0327' \
  '0 6 4,2 7 0,1 7 5,6 3 1,6 0 3,4 7 2,1 5 4,2 0 4,1 3 7,1 4 6,0 7 3'
off flat '0.0306 0.00408 0,2.34 0.000766 0,2.07 0.0267 0,1.17 0.0209 0,0.653 0.0139 0,0.396 0.0284 0,1.78 0.0242 0,1.94 0.00907 0' \
  '7 3 4,3 6 5,4 5 0,4 3 5,1 2 7,7 2 6,0 7 4,0 1 7,2 5 6,7 6 3'
for mesh in thin thinner flat; do
  expect 0 sphere $mesh.mesh.off -o strip.ply --stats strip.json --strict
  is_convex strip.json
  claim "p = ply('strip.ply').points" 'near([dist(x, (0, 0, 0)) for x in p], [1] * len(p), 1e-14)' \
    'all(x[2] >= -1e-15 for x in p)'
done
rm strip.ply strip.json

# Components are mapped one by one; vertices keep their indices, and one without faces its place.
strip strip 3
off parts '9 9 9,0 0 0,1 0 0,0 1 0,0 0 1,5 0 0,6 0 0,5 1 0,7 7 0' '1 3 2,1 2 4,5 6 7,2 3 4,3 1 4,6 8 7'
expect 0 sphere parts.mesh.off -o parts.ply --stats parts.json --precise parts.txt
says '2 components'
says 'component 1, 2 faces, first face 2: inscribed polygon'
claim "s = json('parts.json')" '[(c.component, c.vertices, c.faces, c.first_face) for c in s.component_maps] == [(0, 4, 4, 0), (1, 4, 2, 2)]' \
  's.components == 2' '[c.flat for c in s.component_maps] == [False, True]' \
  "all(c.status == 'success' for c in s.component_maps)" '[c.center[0] for c in s.component_maps] == [0, 2.5]' \
  "m = ply('parts.ply')" 'm.points[0] == (9, 9, 9)' 'm.vertex["input_vertex"][:9] == list(range(9))' \
  'near([hypot(*m.points[i]) for i in (1, 2, 3, 4)], [1] * 4, 1e-14)' \
  'near([hypot(m.points[i][0] - 2.5, m.points[i][1]) for i in (5, 6, 7, 8)], [1] * 4, 1e-14)' \
  'set(m.face["input_face"]) == set(range(6))' \
  'all(set(f) <= {5, 6, 7} | set(range(9, len(m.points))) for f, i in zip(m.faces, m.face["input_face"]) if i == 2)'
[ "$(cut -d' ' -f1 parts.txt | tr '\n' ' ')" = '1 2 3 4 5 6 7 8 ' ] || fail 'precise positions'
# one of them, as if it were alone
expect 0 sphere parts.mesh.off -o part.ply --component 1 --stats parts.json
claim "s = json('parts.json')" 's.component.index == 1 and s.component.of == 2 and s.component.first_face == 2' \
  's.components == 2' '[(c.component, c.vertices, c.faces, c.first_face) for c in s.component_maps] == [(1, 4, 2, 2)]' \
  "m = ply('part.ply')" 'm.vertex["input_vertex"][:9] == list(range(9))' \
  'near([hypot(*m.points[i]) for i in (5, 6, 7, 8)], [1] * 4, 1e-14)' \
  'set(m.face["input_face"]) == {2, 5}'
expect 0 sphere parts.mesh.off -o largest.ply --largest
cmp part.ply largest.ply
expect 2 sphere parts.mesh.off -o none.ply --component 0 --largest
rm parts.* part.ply largest.ply
# polygons that are split keep their numbers
off quads "$square,5 0 0,6 0 0,6 1 0,5 1 0" '0 1 2 3,4 5 6 7'
expect 0 sphere quads.mesh.off -o quads.ply
claim "set(ply('quads.ply').face['input_polygon']) == {0, 1}"
expect 0 sphere quads.mesh.off -o quads.ply --component 1
claim "set(ply('quads.ply').face['input_polygon']) == {1}"
rm quads.ply
# a component that is neither a sphere nor a disk is named
off three '0 0 0,1 0 0,0 1 0,5 0 0,8 0 0,5 3 0,5.5 .5 0,7 .5 0,5.5 2 0' \
  '0 1 2,3 4 7,3 7 6,4 5 8,4 8 7,5 3 6,5 6 8'
refuses 'component 1, 6 faces, first face 1: ' sphere three.mesh.off -o none.ply
expect_files
expect 3 sphere three.mesh.off -o three.ply --stats three.json --keep-going
says 'left out: '
claim "s = json('three.json')" "s.component_maps[0].status == 'success' and 'left_out' in s.component_maps[1]" \
  's.components == 2' \
  "set(ply('three.ply').face['input_face']) == {0}"
rm three.ply three.json
expect 0 uniformize three.mesh.off -o three.obj --stats three.json
claim "s = json('three.json')" "[c.surface_type for c in s.component_maps] == ['disk', 'annulus']" \
  's.components == 2' 's.component_maps[1].modulus[1] > 0' "m = obj('three.obj')" 'm.points[3:6] == [(5, 0, 0), (8, 0, 0), (5, 3, 0)]' \
  'near(hypot(m.points[0][0] - 9.5, m.points[0][1]), 1, 1e-14)' 'flat_area(m) > 0'
expect 0 uniformize three.mesh.off -o again.obj
cmp three.obj again.obj
rm three.obj three.json again.obj

# Long limbs: more digits than double has are needed, and the statistics say what the output has
# lost.
if [ -n "$data" ] && [ -f "$data/meshes/dino.off" ]; then
  expect 0 sphere "$data/meshes/dino.off" -o dino.ply --stats dino.json
  is_convex dino.json
  claim "json('dino.json').extended_precision" "json('dino.json').lost_in_output > 0"
fi

# Long limbs: a tetrahedron with a spike of 40 rings on a face. All digits of --precise hold: as
# fractions, the points are on the sphere, and no two of them are the same, as they are in double.
awk 'BEGIN {
  n = 40
  print "OFF\n" 4 + 3 * n, 4 + 6 * n, 0
  print "0 0 -3\n3 0 0\n-1.5 2.6 0\n-1.5 -2.6 0"
  for(i = 1; i <= n; ++i)
    print 0.3, 0, i * 0.5 "\n-0.15", 0.26, i * 0.5 "\n-0.15", -0.26, i * 0.5
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
assert [int(line[0]) for line in lines] == list(range(124))
points = [tuple(map(Fraction, line[1:])) for line in lines]
error = max(abs(x * x + y * y + z * z - 1) for x, y, z in points)
assert error < 3e-31, float(error)
assert len(set(points)) == 124
assert len({tuple(map(float, p)) for p in points}) < 124
PYTHON
rm spike.*
expect 0 sphere --help
says 'lengths of edges, and often scale factors, have the digits of `double` only'
