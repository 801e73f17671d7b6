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

# Between points of faces, and points in space, which are the same.
expect 0 path square.mesh.off --from 7:0.2,0.3,0.5 --to 0.9,0.7,5 -o a.ply --stats a.json
claim "s, m = json('a.json'), ply('a.ply')" 's.status == "shortest"' \
  'near(s.length, dist(m.points[0], m.points[-1]), 1e-12)' \
  'dist(m.points[-1], (0.9, 0.7, 0)) < 1e-12' 's.places[0]["barycentric"] == [0.2, 0.3, 0.5]'

# Straight on.
expect 0 path square.mesh.off --from 0.5,0.5,0 --straightest 30 0.25 -o a.ply --stats a.json
claim "s, m = json('a.json'), ply('a.ply')" 's.status == "straightest"' \
  'near(s.length, 0.25, 1e-12)' 'near(dist(m.points[0], m.points[-1]), 0.25, 1e-12)'
expect 0 path square.mesh.off --from 0.5,0.5,0 --straightest 30 9 -o a.ply --stats a.json
claim "json('a.json').status == 'stopped_at_boundary'"

# From a point to itself: a line of two points.
expect 0 path square.mesh.off --from 5 --to 5 -o a.ply --stats a.json
claim "s, m = json('a.json'), ply('a.ply')" 's.length == 0' 's.crossings == 0' 'len(m.points) == 2'

# Points far away have a nearest point, unless their squared distance is out of range.
expect 0 path square.mesh.off --from 1e6,1e6,0 --to -1e6,-1e6,0 -o a.ply --stats a.json
claim "s = json('a.json')" 's.places[0]["vertex"] == 1680' 's.places[-1]["vertex"] == 0'

rm -f a.*
expect 2 path square.mesh.off --from 1e308,1e308,-1e308 --to 0 -o a.ply

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
if [ -f "$data/meshes/eight.off" ]; then
  expect 0 path "$data/meshes/eight.off" --homology -o a.ply --stats a.json
  claim "s, m = json('a.json'), ply('a.ply')" 'len(s.loops) == 4' \
    'all(l["status"] == "geodesic" and 0 < l["length"] <= l["length_along_edges"] for l in s.loops)' \
    'len(m.points) == sum(l["crossings"] + 2 for l in s.loops)'
  expect 0 path "$data/meshes/eight.off" --homology -o a.vtp
  claim "lines('a.vtp')[0] == 4"
fi
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

# Calls that make no sense.
for options in '--from 0' '--from 0 --to 1681' '--from 0 --to 1,2' '--from x --to 3' \
  '--from 0 --to 5:0.5,0.5,0.5' '--from 0 --to 5:0.2,0.3,0.5 --flips' '--from 0 --to 3 --via 5' \
  '--from 0 --to 3 --loop' '--from 0 --to 3 --straightest 1 1' '--from 0 --to 99999:1,0,0'; do
  expect 2 path square.mesh.off $options -o a.ply
done
expect 2 path square.mesh.off --from 0 --to 3 -o a.off
expect_files
