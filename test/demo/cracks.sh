#!/usr/bin/env bash
# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# Edges that were meant to be one: points that coincide, or nearly do, on the boundary.
source "$(dirname "${BASH_SOURCE[0]}")/common.bash"

# split N GAP: a flat grid of N x N squares, of which each has its own points; square (i, j) is moved by GAP
# times (i, j). Scaled by SIZE.
split()
{
  awk -v n="$1" -v gap="$2" -v size="${3:-1}" 'BEGIN {
    print "OFF\n" 4 * n * n, n * n, 0
    for(j = 0; j < n; ++j)
      for(i = 0; i < n; ++i)
        for(k = 0; k < 4; ++k)
          printf "%.17g %.17g 0\n", size * (i + (k == 1 || k == 2) + i * gap), size * (j + (k > 1) + j * gap)
    for(f = 0; f < n * n; ++f)
      print 4, 4 * f, 4 * f + 1, 4 * f + 2, 4 * f + 3
  }'
}

# With coincident points: (n + 1)^2 places for 4 n^2 points.
for size in 1e-9 1 1e9; do
  split 3 0 $size >split.mesh.off
  expect 0 distance split.mesh.off --source 0 --exact-distance -o a.ply --stats a.json
  says 'split.mesh.off: note: points on the boundary that coincide with another: 20, first 4 with 1; --repair merges them'
  says 'note: connected components: 9'
  claim "json('a.json').coincident_points == 20" "ply('a.ply').vertex['distance'].count(-1) == 32"
  expect 0 info split.mesh.off
  says 'note: points on the boundary that coincide with another: 20, first 4 with 1; --repair merges them'
  expect 0 distance split.mesh.off --source 0 --exact-distance -o a.ply --stats a.json --repair
  ! grep -q coincide err || fail 'points coincide after the repair'
  claim "s, m = json('a.json'), ply('a.ply')" 's.components == 1' 's.vertices == 16' \
    's.repairs["points merged with an equal one"] == 20' "'coincident_points' not in s" \
    "all(near(d, dist(p, (0, 0, 0)), 1e-12 * $size) for d, p in zip(m.vertex['distance'], m.points))"
done

# With gaps: the message names a distance that suffices, and no point is moved further.
for gap in 1e-7 1e-5; do
  split 3 $gap >split.mesh.off
  expect 0 delaunay split.mesh.off -o a.off --stats a.json
  claim "json('a.json').close_points == 20" "'coincident_points' not in json('a.json')"
  grep -q 'nearly coincide with another: 20, first 4 with 1, at most ' err || fail "$(cat err)"
  distance=$(sed -n 's/.*--weld \([^ ]*\) merges them/\1/p' err)
  expect 0 delaunay split.mesh.off -o a.off --repair
  says 'nearly coincide with another: 20'
  expect 0 delaunay split.mesh.off -o a.off --weld "$distance" --stats a.json
  says 'repaired: points merged with one nearby: 20'
  ! grep -q coincide err || fail 'points nearly coincide after the weld'
  claim "s, m, o = json('a.json'), off('a.off'), off('split.mesh.off')" 's.components == 1' 's.vertices == 16' \
    'all(p in o.points for p in m.points)' \
    "all(min(dist(p, q) for q in m.points) <= $distance for p in o.points)"
done

# Points that are as near as others but joined by an edge are no crack, nor are those of a thin strip with
# short edges; a weld may close what it is told to.
off thin '0 0 0,1 0 0,1 1e-6 0,0 1e-6 0' '0 1 2,0 2 3'
expect 0 delaunay thin.mesh.off -o a.off
! grep -q coincide err || fail 'edges are called cracks'
split 1 0 >one.mesh.off
expect 0 delaunay one.mesh.off -o a.off --weld 0.5
! grep -q repaired err || fail 'points that are far apart were merged'
expect 2 delaunay one.mesh.off -o a.off --weld 1.5
says 'has no faces after the repair'

# Binary STL with corners one unit in the last place apart.
python3 - <<'PYTHON'
import struct
one, more = 1.0, struct.unpack("<f", struct.pack("<I", 0x3F800001))[0]
facets = [[(0, 0, 0), (one, 0, 0), (0, one, 0)], [(more, 0, 0), (one, one, 0), (0, more, 0)]]
with open("near.mesh.stl", "wb") as file:
    file.write(bytes(80) + struct.pack("<I", 2))
    for corners in facets:
        file.write(struct.pack("<12fH", 0, 0, 1, *sum(corners, ()), 0))
PYTHON
expect 0 info near.mesh.stl
says 'points on the boundary that nearly coincide with another: 2, first 3 with 1, at most 1.19e-07 apart; --weld 1.3e-07 merges them'
expect 0 distance near.mesh.stl --source 0 --exact-distance -o a.ply --weld 1.3e-7
claim "m = ply('a.ply')" 'len(m.points) == 4' "max(m.vertex['distance']) < 1.5" "min(m.vertex['distance']) == 0"

# Random clouds of points: no point is further than the distance from the one it becomes, none that stay are
# nearer to each other, except those at one place that make the surface manifold.
for seed in 1 2 3; do
  python3 - $seed <<'PYTHON'
import random, sys
dice = random.Random(int(sys.argv[1]))
points = [[dice.random() for _ in range(3)] for _ in range(300)]
with open("cloud.mesh.off", "w") as file:
    file.write("OFF\n300 100 0\n" + "".join("%r %r %r\n" % tuple(p) for p in points)
               + "".join(f"3 {3 * i} {3 * i + 1} {3 * i + 2}\n" for i in range(100)))
PYTHON
  expect 0 distance cloud.mesh.off --source 0 -o a.ply --weld 0.1
  claim "m, o = ply('a.ply'), off('cloud.mesh.off')" \
    'all(p == q or dist(p, q) > 0.1 for i, p in enumerate(m.points) for q in m.points[:i])' \
    'all(p in o.points for p in m.points)'
done
rm -f a.*
expect_files
