#!/usr/bin/env bash
# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# Distances, their files, statistics and exit codes of the command distance.
source "$(dirname "${BASH_SOURCE[0]}")/common.bash"

# is_euclidean FILE SOURCE: on a flat convex mesh the distances of the vertices are those
# to vertex SOURCE, up to what the heat method is known to miss: three percent on average.
is_euclidean()
{
  claim "m = ply('$1')" "d = m.vertex['distance']" "d[$2] == 0" \
    "e, truth = errors(d, m.points, m.points[$2])" 'sum(e) <= 0.03 * sum(truth)' \
    'max(e) <= 0.1 * dist(m.points[0], m.points[-1])'
}

grid square 40 0
grid sheared 40 2
for source in 0 840 1100; do
  for mesh in square sheared; do
    expect 0 distance $mesh.mesh.off --source $source -o a.ply --subdivision b.ply --quiet
    is_euclidean a.ply $source
    is_euclidean b.ply $source
  done
done

# The input again, with one more number for each vertex; the subdivision has the same numbers there,
# and between two of them on the edges.
claim "a, b, m = ply('a.ply'), ply('b.ply'), off('sheared.mesh.off')" \
  '(a.points, a.faces) == (m.points, m.faces)' 'len(b.points) > 1681' \
  "b.vertex['distance'][:1681] == a.vertex['distance']"

# Mirrored in the diagonal, the square is itself, and so are the distances to a vertex on the
# diagonal.
expect 0 distance square.mesh.off --source 0 -o a.ply
# The bound is the condition of the matrices times 1e-16.
claim "d = ply('a.ply').vertex['distance']" \
  'all(near(d[41 * j + i], d[41 * i + j], 1e-9) for j in range(41) for i in range(j))'

# Several sources: the nearest counts.
expect 0 distance square.mesh.off --source 0 --source 1680 -o a.ply --stats a.json
claim "m = ply('a.ply')" \
  "e, truth = errors(m.vertex['distance'], m.points, (0, 0), (1, 1))" 'sum(e) <= 0.03 * sum(truth)'

cp "$shipped" slivers.mesh.off
expect 0 distance slivers.mesh.off --source 7 -o - --subdivision b.vtp --stats statistics.json
expected='command input vertices edges faces euler_characteristic boundary_loops components flips '
expected+='is_delaunay shared_edges crossings edge_length_sum min_angle_degrees sources max_distance '
expected+='unreachable_vertices subdivision vertices edges faces seconds read build flip solve trace '
expected+='subdivide write peak_memory_bytes'
has_keys statistics.json $expected
claim "s = json('statistics.json')" 's.is_delaunay' "s.max_distance == max(ply('out').vertex['distance'])"
rm a.* b.* statistics.json

# The same bytes on standard output, the same numbers in each format.
expect 0 distance slivers.mesh.off --source 7 -o a.vtp --save a.save --quiet
[ ! -s err ] || fail "not quiet: $(cat err)"
expect 0 distance slivers.mesh.off --source 7 -o - --format vtp --quiet
cmp a.vtp out
expect 0 distance slivers.mesh.off --source 7 -o - --quiet
claim "[x for x, in vtp('a.vtp')['PointData', 'distance']] == ply('out').vertex['distance']"
expect_files a.save a.vtp
rm a.*

# distances MESH SIGNS...: to vertex 0, as long as they are zero, positive or -1.
distances()
{
  claim "[(d > 0) - (d < 0) for d in (d if d in (0, -1) else abs(d)
    for d in ply('$1').vertex['distance'])] == [int(s) for s in '${*:2}'.replace('+', '1').split()]"
}

# What cannot be reached is said, in the files too.
expect 0 distance two_components.mesh.off --source 0 -o a.ply --subdivision b.ply --stats a.json
says '3 vertices out of reach (distance -1)'
claim "json('a.json').unreachable_vertices == 3"
distances a.ply 0 + + + -1 -1 -1
distances b.ply 0 + + + -1 -1 -1
expect 0 distance two_components.mesh.off --source 0 --source 5 -o a.ply
distances a.ply 0 + + + + 0 +
expect 0 distance isolated.mesh.off --source 0 -o a.ply
distances a.ply 0 -1 -1 -1 -1
expect 0 distance isolated.mesh.off --source 0 -o a.ply --repair
distances a.ply 0 + + +
rm a.* b.*

# A face without area has no heat equation, unless it is mollified.
off flat '0 0 0,1 0 0,2 0 0' '0 1 2'
expect 1 distance flat.mesh.off --source 0 -o a.ply
expect 0 distance flat.mesh.off --source 0 -o - --mollify 1e-3
expect 0 distance zero_length.mesh.off --source 0 -o - --mollify 1e-3
expect 0 distance slivers.mesh.off --source 0 -o - --time-step 4

# Wrong calls.
expect 2 distance slivers.mesh.off -o a.ply
expect 2 distance slivers.mesh.off --source 0
for source in 1320 -1 99999999999; do
  expect 2 distance slivers.mesh.off --source=$source -o a.ply
  says "slivers.mesh.off: there is no vertex $source to be a source; the vertices are 0 to 1319"
done
expect 2 distance slivers.mesh.off --source one -o a.ply
for path in a.off a.obj; do
  expect 2 distance slivers.mesh.off --source 0 -o $path
  says "$path: this format cannot carry distances (.ply and .vtp can)"
  expect 2 distance slivers.mesh.off --source 0 -o a.ply --subdivision $path
done
expect 2 distance slivers.mesh.off --source 0 -o - --format off
expect 2 distance slivers.mesh.off --source 0 -o a.stl
expect 2 distance slivers.mesh.off --source 0 -o a.ply --subdivision a.ply
expect 2 distance slivers.mesh.off --source 0 -o a.ply --time-step 0
expect 2 distance polygon.mesh.off --source 0 -o a.ply --strict
expect_files

# ---- Points anywhere ----

# points_are_close FILE X Y: distances in the plane to the point, approximately.
points_are_close()
{
  claim "m = ply('$1')" "e, truth = errors(m.vertex['distance'], m.points, ($2, $3))" \
    'sum(e) <= 0.03 * sum(truth)'
}

for options in "" "--exact-distance" "--min-angle 30"; do
  expect 0 distance sheared.mesh.off --source 1.17,0.43,0.01 -o a.ply --stats a.json $options
  points_are_close a.ply 1.17 0.43
done
claim "s = json('a.json').sources[0]" "near(sum(s['barycentric']), 1, 1e-12)"
expect 0 distance sheared.mesh.off --source 1.17,0.43,0 --exact-distance -o a.ply
claim "m = ply('a.ply')" \
  "all(near(d, dist(p, (1.17, 0.43, 0)), 1e-9) for d, p in zip(m.vertex['distance'], m.points))"
# A vertex is a vertex, whatever its name.
expect 0 distance square.mesh.off --source 840 -o a.ply
expect 0 distance square.mesh.off --source "$(sed -n 843p square.mesh.off | tr ' ' ,)" -o b.ply
claim "ply('a.ply').vertex['distance'] == ply('b.ply').vertex['distance']"
expect 0 distance square.mesh.off --source 3 --source 7:0.2,0.3,0.5 --source 0.9,0.9,0 -o a.ply \
  --stats a.json --view a.html --picture a.svg
claim "s = json('a.json').sources" 's[0] == 3' "s[1] == {'face': 7, 'barycentric': [0.2, 0.3, 0.5]}"
expect 2 distance square.mesh.off --source 0,0,3 -o a.ply
says "'0,0,3' is no point of the mesh: it is 3.000000 away from it, more than 0.070711"
expect 2 distance square.mesh.off --source 0:1,1,1 -o a.ply
expect 2 distance square.mesh.off --source 99999:1,0,0 -o a.ply
rm a.* b.*

# ---- Curves ----

# circle FILE DIRECTION X: around (X, 0.45) with radius 0.2, counterclockwise or not.
circle()
{
  python3 - "$2" "$3" >"$1" <<'END'
import math, sys
n = 80
for k in range(n):
    a = 2 * math.pi * k / n * int(sys.argv[1])
    print('v', float(sys.argv[2]) + 0.2 * math.cos(a), 0.45 + 0.2 * math.sin(a), 0)
print('l', *range(1, n + 1), 1)
END
}

# on_circle FILE X BOUND FUNCTION: relative to its mean, the function of signed distances is so
# close.
on_circle()
{
  claim "m = ply('$1')" "t = [$4(dist(p, ($2, 0.45, 0)) - 0.2) for p in m.points]" \
    "sum(abs(d - e) for d, e in zip(m.vertex['distance'], t)) <= $3 * sum(map(abs, t))"
}

# a square and a parallelogram
for case in "square 0.5" "sheared 1.4"; do
  read -r mesh x <<<"$case"
  circle left.mesh.obj 1 "$x"
  circle right.mesh.obj -1 "$x"
  expect 0 distance $mesh.mesh.off --curve left.mesh.obj --signed -o a.ply --stats a.json
  on_circle a.ply "$x" 0.05 ''
  claim "s = json('a.json')" 'near(s.curve.length, 1.2563, 1e-3)' 's.curve.polylines == 1' \
    's.curve.points == 81' 's.min_distance < -0.15' 's.sources == []'
  expect 0 distance $mesh.mesh.off --curve right.mesh.obj --signed -o a.ply --min-angle 28
  on_circle a.ply "$x" 0.05 -
  expect 0 distance $mesh.mesh.off --curve right.mesh.obj -o a.ply --subdivision b.ply
  on_circle a.ply "$x" 0.05 abs
done
circle left.mesh.obj 1 0.5
expect 0 distance square.mesh.off --curve left.mesh.obj --signed -o a.ply --view a.html --picture a.svg
rm a.* b.*

# What path writes is a curve.
expect 0 path square.mesh.off --from 0.1,0.1,0 --to 0.9,0.7,0 -o path.mesh.obj
expect 0 distance square.mesh.off --curve path.mesh.obj --source 0 -o a.ply
expect 0 distance square.mesh.off --curve path.mesh.obj --signed --time-step 9 -o a.ply
printf '0 0.5 0\n1 0.5 0\n' >line.mesh.xyz
expect 0 distance square.mesh.off --curve line.mesh.xyz --signed -o a.ply
claim "m = ply('a.ply')" \
  "all(near(d, 0.5 - p[1], 1e-9) for d, p in zip(m.vertex['distance'], m.points))"
rm a.*

refuses_curve()
{
  expect 2 distance "${@:2}" -o a.ply
  says "$1"
}
printf 'v 0 0 0\n' >none.mesh.obj
printf 'v 0 0 0\nl 1\n' >one.mesh.obj
printf 'v 0 0 0\nl 1 9\n' >bad.mesh.obj
printf 'v 0 0 0\nv 0 0 1\nl 1 2\n' >far.mesh.obj
refuses_curve 'none.mesh.obj: has no polylines' square.mesh.off --curve none.mesh.obj
refuses_curve 'one.mesh.obj: a polyline has less than two points' square.mesh.off --curve one.mesh.obj
refuses_curve 'names a point that does not exist' square.mesh.off --curve bad.mesh.obj
refuses_curve 'far.mesh.obj: point 2 is 1.000000 away from the surface' square.mesh.off --curve far.mesh.obj
refuses_curve 'curves are read from .obj and .xyz' square.mesh.off --curve square.mesh.off
refuses_curve 'no such file' square.mesh.off --curve nothing.obj
refuses_curve '--signed needs a --curve' square.mesh.off --source 0 --signed
refuses_curve '--source or --curve is missing' square.mesh.off
refuses_curve 'without --source' square.mesh.off --source 0 --curve left.mesh.obj --signed
refuses_curve 'not for --curve' square.mesh.off --curve left.mesh.obj --exact-distance
printf 'v 0 0 0\nv 1 0 0\nl 1 2\n' >edge.mesh.obj
refuses_curve 'has no signed distance' two_components.mesh.off --curve edge.mesh.obj --signed
expect_files

if [ -w /dev/full ]; then
  expect 1 distance slivers.mesh.off --source 0 -o a.ply --subdivision b.ply --stats /dev/full
  expect_files
fi

if [ -n "$data" ]; then
  for mesh in elephant.off cube-ouvert.off sphere.stl colored_tetra.ply; do
    expect 0 distance "$data/meshes/$mesh" --source 0 -o mesh.ply
    claim "is_harmless('mesh.ply')"
  done
fi
