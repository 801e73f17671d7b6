#!/usr/bin/env bash
# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# Bounds, files, statistics and exit codes of the command refine.
source "$(dirname "${BASH_SOURCE[0]}")/common.bash"

# is_at_least ANGLE FILE; positions have ten digits to spare for this.
is_at_least()
{
  claim "shape(ply('$2'))[0] >= $1 - 1e-6"
}

# has_kinds PLY JSON: the kinds of vertices are as many as the statistics say, inserted vertices
# come between the other two, and those on an input edge end a part of it.
has_kinds()
{
  claim "m = ply('$1')" "s = json('$2')" 'ends_parts_of_input_edges(m)' \
    "m.vertex['kind'] == [0] * s.vertices + [2] * s.inserted_vertices + [1] * s.crossings"
}

cp "$shipped" slivers.mesh.off
expect 0 refine slivers.mesh.off -o a.ply --stats a.json --save a.save
[ ! -s out ] || fail 'standard output is not empty'
says 'vertices inserted (bounds_met)'
expect_files a.json a.ply a.save
is_at_least 25 a.ply
has_kinds a.ply a.json
claim "s = json('a.json')" 's.inserted_vertices > 0' \
  "m = ply('a.ply')" 'near(shape(m)[0], s.min_angle_degrees, 1e-6)' \
  "m.points[:1320] == off('slivers.mesh.off').points"
"$program" info a.ply >out || true
grep -q 'Euler characteristic  0' out || fail "bad subdivision: $(cat out)"

has_keys a.json $surface_keys flips inserted_vertices faces_below_bound faces_excused status \
  $edge_keys $subdivision_keys seconds read build flip refine trace subdivide write peak_memory_bytes
claim "s = json('a.json')" 's.is_delaunay' "s.status == 'bounds_met'" 's.faces_below_bound == 0'

# The same bytes once more, and in every format.
expect 0 refine slivers.mesh.off -o b.ply --save b.save --quiet
[ ! -s err ] || fail "not quiet: $(cat err)"
cmp a.ply b.ply
cmp a.save b.save
for format in ply off obj vtp; do
  expect 0 refine slivers.mesh.off -o "a.$format"
  expect 0 refine slivers.mesh.off -o - --format "$format"
  cmp "a.$format" out
done
rm a.* b.*

expect 0 refine slivers.mesh.off -o a.ply --min-angle 30
is_at_least 30 a.ply

# A parallelogram without narrow corners.
grid sheared 4 0.5
expect 0 refine sheared.mesh.off -o a.ply --max-circumradius 0.02 --stats a.json
has_kinds a.ply a.json
is_at_least 25 a.ply
claim "m = ply('a.ply')" 'near(fsum(signed_area(m.points, f) for f in m.faces), 1, 1e-9)' \
  'shape(m)[1] <= 0.02 * (1 + 1e-9)'
expect 0 refine sheared.mesh.off -o a.ply --min-angle 0 --stats a.json
claim "json('a.json').inserted_vertices == 0"
# Every command takes zero for no bound, and any small angle.
for command in refine 'distance --source 0' 'simplify --vertices 300'; do
  expect 0 ${command%% *} sheared.mesh.off ${command#${command%% *}} -o a.ply --min-angle 1e-4
  expect 0 ${command%% *} sheared.mesh.off ${command#${command%% *}} -o a.ply --min-angle 0
  [ "$command" = refine ] && continue
  expect 0 ${command%% *} sheared.mesh.off ${command#${command%% *}} -o b.ply
  cmp a.ply b.ply
done
for angle in 0 1e-4; do
  expect 0 operators sheared.mesh.off --prefix a --min-angle $angle
done
rm a_* b.ply

# Too narrow for the bound.
expect 0 refine needle.mesh.off -o - --stats a.json
says '(bounds_met_but_excused)'
claim "s = json('a.json')" 's.faces_excused > 0' 's.faces_excused == s.faces_below_bound'

# A limit is kept and told.
expect 0 refine slivers.mesh.off -o a.ply --stats a.json --max-insertions 20
says '20 vertices inserted (insertion_limit)'
has_kinds a.ply a.json
claim "s = json('a.json')" 's.inserted_vertices == 20' 's.faces_below_bound > 0' \
  's.faces_excused == 0' "s.status == 'insertion_limit'"
expect 0 refine slivers.mesh.off -o a.ply --stats a.json --max-insertions 0
claim "json('a.json').inserted_vertices == 0"
rm a.*
seq 0 1319 | sed 's/$/ 1/' >values.mesh.txt
for command in 'distance --source 0 -o a.ply' 'operators --prefix a' 'transfer --data values.mesh.txt -o a.txt' \
  'simplify --vertices 300 -o a.ply'; do
  expect 0 ${command%% *} slivers.mesh.off ${command#* } --min-angle 25 --max-insertions 5 --stats a.json
  says insertion_limit
  says 'raise --max-insertions'
  claim "s = json('a.json')" \
    "'insertion_limit' in (s.get('status'), s.get('coarse_refinement_status'))" \
    "5 in (s.get('inserted_vertices'), s.get('coarse_inserted_vertices'))"
  rm a*
done
expect 0 simplify slivers.mesh.off -o a.ply --vertices 300 --min-angle 25 --max-insertions 5
says ' -> 300 vertices (reached) -> 305 with --min-angle (insertion_limit), '
says 'slivers.mesh.off: warning: --min-angle 25 is not reached: '
expect 0 simplify slivers.mesh.off -o a.ply --vertices 300 --refine 25 --max-insertions 5
says 'slivers.mesh.off: warning: --refine 25 is not reached: '
rm a.*

# Exact decisions on request, with a certificate of the refined triangulation.
expect 0 refine slivers.mesh.off -o a.ply --exact --stats a.json
is_at_least 25 a.ply
has_kinds a.ply a.json
claim "s = json('a.json')" 's.certified' 's.is_delaunay' "s.status == 'bounds_met'" \
  'sum(s.decisions.values()) >= s.vertices + s.inserted_vertices'
rm a.*

# Where rounding leaves doubts, the same without request: vertices as near to a corner of a square
# as rounding allows.
near="0 0 0,1 0 0,1 1 0,0 1 0,1e-16 3e-17 0,0.7 0.3 1e-15,0.7000000000000001 0.3 0"
off doubtful "$near" "0 1 4,1 2 5,2 3 6,3 0 4,4 1 5,5 2 6,4 5 6,3 4 6"
for options in '' --exact; do
  expect 0 refine doubtful.mesh.off -o a.ply --stats a.json --max-insertions 20000 $options
  claim "s = json('a.json')" "s.status != 'insertion_limit'" 's.is_delaunay'
  has_kinds a.ply a.json
done
expect 0 refine doubtful.mesh.off -o a.ply --stats a.json
says 'with exact decisions'
claim "json('a.json').exact_decisions"
rm a.*

# Handled, not refused.
expect 0 refine isolated.mesh.off -o -
sed -n 3p out | grep -qx '9 9 9' || fail 'the isolated vertex lost its place'
expect 0 refine two_components.mesh.off -o -
expect 0 refine cap.mesh.off -o -
expect 0 refine zero_length.mesh.off -o - --mollify 1e-6
expect 0 refine slivers.mesh.off -o - --constrain-angle 20

# Wrong calls.
for angle in -1 61 nan many; do
  expect 2 refine slivers.mesh.off -o a.ply --min-angle=$angle
done
for radius in -1 0 nan; do
  expect 2 refine slivers.mesh.off -o a.ply --max-circumradius=$radius
done
for radius in 1e-9 1e-320; do
  refuses 'more than the default of 10000000' refine sheared.mesh.off -o a.ply --max-circumradius $radius
done
for limit in -1 many; do
  expect 2 refine slivers.mesh.off -o a.ply --max-insertions=$limit
done
expect_files

# Refined before it is solved: eight times as wide as high, the cells of the grid are too.
grid cells 16 0
awk 'FNR > 2 && NF == 3 { $1 *= 8 } { print }' cells.mesh.off >wide.mesh.off
expect 0 distance wide.mesh.off --source 144 -o a.ply --subdivision b.ply --min-angle 30 --stats a.json
claim "m = ply('a.ply')" "d = m.vertex['distance']" 'len(d) == 289' \
  'e, truth = errors(d, m.points, (4, 0.5))' 'sum(e) <= 0.03 * sum(truth)' \
  "json('a.json').max_distance == max(d)" "ply('b.ply').vertex['distance'][:289] == d"
is_at_least 30 b.ply
rm a.* b.*

# The certificate is that of the refined triangulation.
expect 0 distance wide.mesh.off --source 144 -o a.ply --min-angle 30 --exact --stats a.json
claim "s = json('a.json')" 's.certified' 's.inserted_vertices > 0' \
  'sum(s.decisions.values()) >= s.edges + 3 * s.inserted_vertices'
rm a.*

# The sum of the masses is the area.
expect 0 operators wide.mesh.off --prefix w --min-angle 25 --stats w.json
claim "m = mtx('w_lumped_mass.mtx')" "m.rows == 289 + json('w.json').inserted_vertices" \
  'near(fsum(z.real for z in m.entries.values()), 8, 1e-12)'
rm w_* w.json
for angle in -1 61; do
  expect 2 distance wide.mesh.off --source 0 -o a.ply --min-angle=$angle
  expect 2 operators wide.mesh.off --prefix w --min-angle=$angle
done
expect_files

if [ -n "$data" ]; then
  for mesh in elephant.off sphere.stl bones.off star.off; do
    expect 0 refine "$data/meshes/$mesh" -o mesh.ply --stats mesh.json
    claim "json('mesh.json').status.startswith('bounds_met')"
    has_kinds mesh.ply mesh.json
    claim "json('mesh.json').faces_below_bound > 0 or shape(ply('mesh.ply'))[0] >= 25 - 1e-6"
  done
fi

# A pillow with a thin corner: its triangulation is no simplicial complex before.
off pillow '0 0 0,1 0 0,0.5 0.1 0' '0 1 2,0 2 1'
expect 0 refine pillow.mesh.off -o a.ply --simplicial --min-angle 0 --stats a.json
claim "s = json('a.json')" "m = ply('a.ply')" "s.status == 'bounds_met'" \
  "m.vertex['kind'] == [0] * 3 + [2] * s.inserted_vertices" \
  'len({frozenset(f) for f in m.faces}) == len(m.faces) > 2' \
  'len({frozenset(e) for e in m.edges}) == len(m.edges)' 'all(len(set(e)) == 2 for e in m.edges)' \
  's.flat_faces.faces == len(m.faces)' 's.flat_faces.edges == len(m.edges)' \
  "near(s.flat_faces.area_ratio, area(m) / area(off('pillow.mesh.off')), 1e-9)"
expect 0 info a.ply --json
claim "near(json('a.json').flat_faces.min_angle_degrees, json('out').min_angle_degrees, 1e-9)"
for format in off obj vtp; do
  expect 0 refine slivers.mesh.off -o "a.$format" --simplicial
done
refuses 'the triangulation is not simplicial after the greatest allowed number of insertions, 1; allow more by --max-insertions' \
  refine pillow.mesh.off -o b.ply --simplicial --max-insertions 1
rm a.*
