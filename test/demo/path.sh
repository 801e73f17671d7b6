#!/usr/bin/env bash
# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# Paths, their files, statistics and exit codes of the command path; exact distances.
source "$(dirname "${BASH_SOURCE[0]}")/common.bash"

# In a square, whose vertices are 41 i + j, shortest paths and geodesics are straight lines.
grid square 40 0
for options in '' '--flips'; do
  expect 0 path square.mesh.off --from 0 --to 1678 $options -o a.ply --stats a.json
  claim "s, m = json('a.json'), ply('a.ply')" 'near(s.length, dist(m.points[0], m.points[-1]), 1e-12)' \
    's.crossings + 2 == len(m.points) == len(s.places)' 's.places[0]["vertex"] == 0' \
    's.places[-1]["vertex"] == 1678'
done
claim "s = json('a.json')" 's.status == "geodesic"' 's.length < s.length_along_edges' \
  's.intrinsic_edges[0]["source"] == 0' 's.intrinsic_edges[-1]["target"] == 1678'

# Between points of faces, and points in space near the surface.
expect 0 path square.mesh.off --from 7:0.2,0.3,0.5 --to 0.9,0.7,0.05 -o a.ply --stats a.json
claim "s, m = json('a.json'), ply('a.ply')" 's.status == "shortest"' \
  'near(s.length, dist(m.points[0], m.points[-1]), 1e-12)' \
  'dist(m.points[-1], (0.9, 0.7, 0)) < 1e-12' 's.places[0]["barycentric"] == [0.2, 0.3, 0.5]'

# Points far away are none of the mesh.
rm -f a.*
for options in '--from 0 --to 0.9,0.7,5' '--from 1e6,1e6,0 --to 0' '--from 0.5,0.5,2 --straightest 0 1' \
  '--from 0 --to 5 --flips --via 0.5,0.5,-1'; do
  refuses 'away from it' path square.mesh.off $options -o a.ply
done

# Straight on.
expect 0 path square.mesh.off --from 0.5,0.5,0 --straightest 30 0.25 -o a.ply --stats a.json
claim "s, m = json('a.json'), ply('a.ply')" 's.status == "straightest"' \
  'near(s.length, 0.25, 1e-12)' 'near(dist(m.points[0], m.points[-1]), 0.25, 1e-12)'
expect 0 path square.mesh.off --from 0.5,0.5,0 --straightest 30 9 -o a.ply --stats a.json
claim "json('a.json').status == 'stopped_at_boundary'"

# From a point to itself: a line of two points.
expect 0 path square.mesh.off --from 5 --to 5 -o a.ply --stats a.json
claim "s, m = json('a.json'), ply('a.ply')" 's.length == 0' 's.crossings == 0' 'len(m.points) == 2'

# A loop around a face, and a geodesic from a vertex to itself, contract to a point.
for options in '--loop --via 41 --via 42' '--to 0 --flips'; do
  expect 0 path square.mesh.off --from 0 $options -o a.ply --stats a.json --view a.html
  says 'no line: the path contracts to a point'
  claim "s, m = json('a.json'), ply('a.ply')" 's.status == "contracted"' \
    's.length == s.crossings == 0' 's.places == s.intrinsic_edges == []' 'm.points == []'
done

rm -f a.*
# At a vertex zero degrees is along the side that leaves it in its first face, which is 0 41 42 for
# vertex 0; in a face it is along the first side. On the boundary other angles lead out of the surface.
for call in '0 0 1 0' '0 45 0.70710678118654757 0.70710678118654757' '0 90 0 1' '0:1,0,0 0 1 0' \
  '0:0.2,0.3,0.5 30 0.8660254037844386 0.5' '861 90 1 0'; do
  read -r from degrees x y <<<"$call"
  expect 0 path square.mesh.off --from "$from" --straightest "$degrees" 0.01 -o a.ply --stats a.json
  claim "s, m = json('a.json'), ply('a.ply')" 's.status == "straightest"' \
    "dist(m.points[-1], [p + 0.01 * d for p, d in zip(m.points[0], ($x, $y, 0))]) < 1e-12"
done
claim "s = json('a.json')" 's.places[0]["vertex"] == 861'
rm -f a.*
for call in '0 -1' '0 91' '0 180' '0:1,0,0 -90' '0.51,0,0 -90' '40 180.001' '1680 89.999'; do
  read -r from degrees <<<"$call"
  refuses 'leads out of the surface' \
    path square.mesh.off --from "$from" --straightest "$degrees" 0.1 -o a.ply
done
printf 'OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0.3\n0 1 0\n3 0 1 2\n3 0 2 3\n' >roof.mesh.off
expect 0 path roof.mesh.off --from 0 --straightest 0 0.1 -o a.ply --stats a.json
claim "s, m = json('a.json'), ply('a.ply')" 'near(s.length, 0.1, 1e-15)' 'dist(m.points[1], (0.1, 0, 0)) < 1e-15'
rm -f a.*
expect 2 path roof.mesh.off --from 0 --straightest 93 0.1 -o a.ply

# Angles are measured along all faces of a vertex: of 270 degrees inside and on the boundary, and of
# eight times 60 degrees. From the middle of a face, lines are in the direction of its edges.
python3 - <<'END'
from math import cos, pi, sin, sqrt
def fan(name, corners, closed):
    faces = [(0, i + 1, i + 2) for i in range(len(corners) - 1)] + [(0, len(corners), 1)] * closed
    with open(name, "w") as file:
        print("OFF\n%d %d 0\n0 0 0" % (len(corners) + 1, len(faces)), file=file)
        for p in corners: print(*map(repr, p), file=file)
        for f in faces: print(3, *f, file=file)
h = sqrt((sqrt(.5) - .5) / 1.5)
fan("cone.mesh.off", [(1., 0., 0.), (0., 1., 0.), (0., 0., 1.)], True)
fan("saddle.mesh.off", [(cos(k * pi / 4), sin(k * pi / 4), h * (-1)**k) for k in range(8)], True)
fan("reflex.mesh.off", [(cos(k * pi / 4), sin(k * pi / 4), 0.) for k in range(7)], False)
END
for call in 'cone 135 0 1 1' 'cone 225 1 0 1' 'cone -45 1 0 1' 'cone 405 0 1 1' 'saddle 210 -1.7071067811865475 0.7071067811865475 0' \
  'saddle 450 1.7071067811865475 -0.7071067811865475 0' 'saddle -30 1.7071067811865475 -0.7071067811865475 0' \
  'reflex 225 -1 -1 0' 'reflex 270 0 -1 0'; do
  read -r mesh degrees x y z <<<"$call"
  expect 0 path $mesh.mesh.off --from 0 --straightest "$degrees" 0.125 -o a.ply
  claim "m = ply('a.ply'); r = dist((0, 0, 0), ($x, $y, $z))" \
    "dist(m.points[-1], (0.125 * $x / r, 0.125 * $y / r, 0.125 * $z / r)) < 1e-15"
  rm -f a.*
done
for degrees in 270.001 -0.001 360 400; do
  refuses 'leads out of the surface' path reflex.mesh.off --from 0 --straightest "$degrees" 0.1 -o a.ply
done

# Any angle, in turns; no length that would take all memory.
for options in '--straightest 390 0.25' '--straightest -330 0.25'; do
  expect 0 path square.mesh.off --from 0.5,0.5,0 $options -o b.ply --stats b.json
  expect 0 path square.mesh.off --from 0.5,0.5,0 --straightest 30 0.25 -o a.ply
  claim "m, n = ply('a.ply'), ply('b.ply')" 'dist(m.points[-1], n.points[-1]) < 1e-12'
done
rm b.*
printf 'OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n' > closed.mesh.off
for options in 'nan 1' 'inf 1' '30 nan' '30 inf' '30 -1' '30 1e9'; do
  rm -f a.*
  expect 2 path closed.mesh.off --from 0.1,0.2,0 --straightest $options -o a.ply
done

# Lines in all formats.
cp "$shipped" slivers.mesh.off
expect 0 path slivers.mesh.off --from 7 --to 3 -o a.obj
[ "$(grep -c '^v ' a.obj)" -eq "$(($(grep '^l ' a.obj | wc -w) - 1))" ] || fail "a.obj: no line"
expect 0 path slivers.mesh.off --from 7 --to 3 -o a.vtp --stats a.json
claim "s = json('a.json')" 's.command == "path"' 's.crossings == len(s.places) - 2' 's.seconds.search >= 0'
expect 0 path slivers.mesh.off --from 7 --to 3 --flips -o a.obj --save a.save
[ -s a.save ] || fail "nothing saved"
rm a.*

# In a skewed plane, coordinates rounded, crossings of a geodesic beside a vertex round to it: each
# place names the vertex that has its position.
awk 'BEGIN {
  print "OFF\n63 96 0"
  for(j = 0; j < 7; ++j)
    for(i = 0; i < 9; ++i)
      printf "%.17g %.17g %.17g\n", .7591227352534609 * i + .0307661409368741 * j,
        .5216393424061284 * i - .6262737096991106 * j, -.389390638402371 * i - .7789959467876367 * j
  for(j = 0; j < 6; ++j)
    for(i = 0; i < 8; ++i) {
      v = 9 * j + i
      print 3, v, v + 1, v + 10
      print 3, v, v + 10, v + 9
    }
}' >skew.mesh.off
for ends in '40 26' '0 62' '9 44' '18 8' '54 8' '45 35' '36 17' '1 61'; do
  read -r from to <<<"$ends"
  expect 0 path skew.mesh.off --from "$from" --to "$to" --flips -o a.obj --stats a.json
  claim "s, m, g = json('a.json'), obj('a.obj'), off('skew.mesh.off')" \
    'all(dist(m.points[i], g.points[p["vertex"]]) < 1e-12 for i, p in enumerate(s.places) if "vertex" in p)' \
    'all("vertex" in p or min(dist(m.points[i], q) for q in g.points) > 1e-9 for i, p in enumerate(s.places))'
done
rm a.*

# In a square all paths that can lie beside themselves without crossings are shortened to the
# straight line, however often they overlap.
grid plain 8 0
for call in '0 8 4 76' '9 44 9 44 30' '4 76 36 44 40' '40 44 40 44 40 44 41' '0 80 0 80' '36 44 76 40 4'; do
  read -r -a v <<<"$call"
  expect 0 path plain.mesh.off --from "${v[0]}" --to "${v[-1]}" --flips $(printf -- '--via %s ' "${v[@]:1:${#v[@]}-2}") \
    -o a.ply --stats a.json
  claim "s, m = json('a.json'), ply('a.ply')" 's.status == "geodesic"' \
    'near(s.length, dist(m.points[0], m.points[-1]), 1e-12)'
done
rm a.*

# Loops of a homology basis: around a square tube without lids, in two directions on a flat torus,
# none on a sphere.
printf 'OFF\n8 8 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 3\n1 0 3\n1 1 3\n0 1 3\n' > tube.mesh.off
printf '3 0 1 5\n3 0 5 4\n3 1 2 6\n3 1 6 5\n3 2 3 7\n3 2 7 6\n3 3 0 4\n3 3 4 7\n' >> tube.mesh.off
for format in obj ply; do
  expect 0 path tube.mesh.off --homology -o a.$format --stats a.json
  claim "s, m = json('a.json'), $format('a.$format')" 'len(s.loops) == 1' \
    's.loops[0]["status"] == "geodesic"' 'near(s.loops[0]["length"], 4, 1e-12)' \
    'len(m.points) == len(s.loops[0]["places"])' 'dist(m.points[0], m.points[-1]) == 0'
done
expect 0 path closed.mesh.off --homology -o a.ply --stats a.json
claim "s, m = json('a.json'), ply('a.ply')" 's.loops == []' 'm.points == []'
expect 0 path closed.mesh.off --homology -o a.obj
[ "$(cat a.obj)" = "# no vertices" ]
if [ -f "$data/meshes/eight.off" ]; then
  expect 0 path "$data/meshes/eight.off" --homology -o a.ply --stats a.json
  claim "s, m = json('a.json'), ply('a.ply')" 'len(s.loops) == 4' \
    'all(l["status"] == "geodesic" and 0 < l["length"] <= l["length_along_edges"] for l in s.loops)' \
    'len(m.points) == sum(l["crossings"] + 2 for l in s.loops)'
  expect 0 path "$data/meshes/eight.off" --homology -o a.vtp
  claim "lines('a.vtp')[0] == 4"
fi

# The shortest loops of a torus of revolution: a meridian and the inner equator.
awk 'BEGIN {
  n = 24
  turn = 8 * atan2(1, 1) / n
  print "OFF\n" n * n, 2 * n * n, 0
  for(i = 0; i < n; ++i)
    for(j = 0; j < n; ++j) {
      r = 2 + cos(turn * j)
      printf "%.17g %.17g %.17g\n", r * cos(turn * i), r * sin(turn * i), sin(turn * j)
    }
  for(i = 0; i < n; ++i)
    for(j = 0; j < n; ++j) {
      k = (j + 1) % n
      l = (i + 1) % n
      print 3, n * i + j, n * l + j, n * l + k
      print 3, n * i + j, n * l + k, n * i + k
    }
}' >ring.mesh.off
expect 0 path ring.mesh.off --homology -o a.ply --stats a.json
claim "s = json('a.json')" 'chord = 48 * sin(pi / 24)' 'len(s.loops) == 2' \
  'all(l["status"] == "geodesic" and 6.2 < l["length"] <= chord + 1e-12 for l in s.loops)'
rm a.*

# Of a long line only what is near is drawn, however small a section is.
expect 0 path square.mesh.off --from 0 --to 1678 -o a.ply --picture a.svg --section 0 1e-12
[ "$(wc -c < a.svg)" -lt 100000 ] || fail "a.svg: parts that are out of reach"
rm a.*

# Exact distances: straight lines in the square.
expect 0 distance square.mesh.off --source 3 --exact-distance -o a.ply
claim "m = ply('a.ply')" \
  "all(near(d, dist(p, m.points[3]), 1e-12) for d, p in zip(m.vertex['distance'], m.points))"
rm a.*

expect 2 path square.mesh.off --from 0 --to 1681 -o a.ply
expect_files
