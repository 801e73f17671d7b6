#!/usr/bin/env bash
# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# Targets, files, statistics and exit codes of the command simplify.
source "$(dirname "${BASH_SOURCE[0]}")/common.bash"

# is_prolongation MTX ROWS COLUMNS: of this size, no entry is negative, and each row has the sum 1.
is_prolongation()
{
  claim "is_prolongation(mtx('$1'), $2, $3)"
}

# is_colored FILE: one color for each coarse face, another beyond its edges.
is_colored()
{
  claim "is_colored(ply('$1'))"
}

# A square: flat, but for its corners, which alone cannot be removed without cost.
grid square 8 0
expect 0 simplify square.mesh.off -o a.ply --error 1e-12 --weight curvature=1 --stats a.json --prolongation a.mtx
[ ! -s out ] || fail 'standard output is not empty'
says '81 -> 4 vertices (reached)'
says ', weight curvature=1'
expect_files a.json a.mtx a.ply
is_prolongation a.mtx 81 4
claim "s = json('a.json')" '(s.coarse_vertices, s.coarse_faces, s.removed) == (4, 2, 77)' \
  'near(s.area_ratio, 1, 1e-12)' 'near(s.min_angle_degrees, 45, 1e-9)'
# A function that is linear on the plane is the prolongation of itself. The corners keep their
# places, and the two triangles are half of the square each.
claim "m = ply('a.ply')" "corners = [p for p, c in zip(m.points, m.vertex['coarse_vertex']) if c >= 0]" \
  'corners == [(0, 0, 0), (1, 0, 0), (0, 1, 0), (1, 1, 0)]' \
  "[c for c in m.vertex['coarse_vertex'] if c >= 0] == [0, 1, 2, 3]" \
  "f = [2 * p[0] - 3 * p[1] for p, k in zip(m.points, m.vertex['kind']) if k == 0]" \
  "near(mtx('a.mtx') @ [2 * p[0] - 3 * p[1] for p in corners], f, 1e-9)" \
  'list(coarse_areas(m)) == [0, 1]' 'near(coarse_areas(m).values(), [0.5, 0.5], 1e-9)' \
  'near(coarse_edges(m), [5, 4 + sqrt(2)], 1e-9)'
is_colored a.ply
grep -q '^property uchar red' a.ply

has_keys a.json $surface_keys coarse_vertices coarse_faces removed status greatest_cost weights curvature \
  skipped isolated protected border_loop self_face low_degree not_flattenable not_separable operations area_ratio \
  min_angle_degrees $subdivision_keys seconds read build simplify map write peak_memory_bytes

# The same bytes once more, and in every format.
expect 0 simplify square.mesh.off -o b.ply --error 1e-12 --weight curvature=1 --prolongation b.mtx --quiet
[ ! -s err ] || fail "not quiet: $(cat err)"
cmp a.ply b.ply
cmp a.mtx b.mtx
for format in ply vtp off obj; do
  expect 0 simplify square.mesh.off -o "a.$format" --vertices 20
  expect 0 simplify square.mesh.off -o - --vertices 20 --format "$format"
  cmp "a.$format" out
done
claim "m = ply('a.ply')" "near(lines('a.vtp'), coarse_edges(m), 1e-9)" 'n = coarse_edges(m)[0]' \
  "data = {name: [x for x, in values] for (part, name), values in vtp('a.vtp').items()
    if part == 'CellData'}" \
  "data['coarse_edge'] == list(range(n)) + [-1] * len(m.faces)" \
  "data['coarse_face'] == [-1] * n + m.face['coarse_face']" \
  "len(obj('a.obj').faces) == len(off('a.off').faces) == len(m.faces)" \
  "len(off('a.off').points) == len(m.points)"
rm a.* b.*

# A parallelogram, in six decimals: coarse edges cross fine ones, and are its sides and the shorter
# diagonal.
grid sheared 7 0.3
expect 0 simplify sheared.mesh.off -o a.ply --vertices 4
claim "m = ply('a.ply')" 'list(coarse_areas(m)) == [0, 1]' \
  'near(coarse_areas(m).values(), [0.5, 0.5], 5e-6)' 'near(coarse_edges(m), [5, 5.30872], 5e-6)'
is_colored a.ply

# By default the corners of flat parts stay, as few vertices as there may be. The weights in force are
# those that are given, or all default ones.
for cells in 4 12; do
  grid square_$cells $cells 0
  for n in 4 5 6 10; do
    expect 0 simplify square_$cells.mesh.off -o a.ply --vertices $n --stats a.json
    claim "s = json('a.json')" 's.coarse_vertices == '$n 'near(s.area_ratio, 1, 1e-12)' \
      "list(s.weights) == ['area', 'area_change', 'boundary_change', 'curvature']"
  done
done
expect 0 simplify square.mesh.off -o a.ply --vertices 10 --weight area=2 --weight boundary_change=1 --stats a.json
says ', weight area=2, weight boundary_change=1'
claim "json('a.json').weights == {'area': 2, 'boundary_change': 1}"
rm a.*

# Targets: a number, a part, and more than there are.
cp "$shipped" slivers.mesh.off
expect 0 simplify slivers.mesh.off -o a.ply --vertices 100 --stats a.json --prolongation a.mtx
is_prolongation a.mtx 1320 100
claim "(json('a.json').coarse_vertices, json('a.json').removed) == (100, 1220)" \
  "[c for c in ply('a.ply').vertex['coarse_vertex'] if c >= 0] == list(range(100))"
expect 0 simplify slivers.mesh.off -o a.ply --ratio 0.1 --stats a.json --weight area=1
claim "json('a.json').coarse_vertices == 132"
expect 0 simplify slivers.mesh.off -o a.ply --ratio 1 --stats a.json
claim "json('a.json').removed == 0" "near(json('a.json').area_ratio, 1, 1e-12)"
for n in 5000 18446744073709551615; do
  expect 0 simplify slivers.mesh.off -o a.ply --vertices $n --stats a.json
  claim "json('a.json').removed == 0" "json('a.json').status == 'reached'"
done
rm a.*

# Colors: a square that is black, and on the right half of it striped. With a weight, hardly a
# vertex is left where it is black, and the other way round where the properties of a .ply file are.
grid plain 16 0
awk 'NR == 1 { print "COFF"; next } NR > 2 && NF == 3 { c = $1 > 0.5 ? 255 * (int(16 * $1) % 2) : 0; print $0, c, c / 5, 0, 255; next } { print }' \
  plain.mesh.off >striped.mesh.off
{
  printf 'ply\nformat ascii 1.0\nelement vertex 289\n'
  printf 'property %s\n' 'float x' 'float y' 'double z' 'uchar red' 'uchar green' 'uchar blue' 'float heat' 'short depth'
  printf 'element face 512\nproperty list uchar int vertex_indices\nend_header\n'
  awk 'NR > 2 && NF == 3 { c = $1 > 0.5 ? 255 * (int(16 * $1) % 2) : 0; print $0, c, c / 5, 0, $1 < 0.5 ? int(16 * $1) % 2 : 0, -c }
    NR > 2 && NF == 4' plain.mesh.off
} >striped.mesh.ply

# alike: a.ply and b.ply differ in the data of their inputs alone.
alike()
{
  claim "a, b = ply('a.ply'), ply('b.ply')" 'a.points == b.points' 'a.face == b.face' 'a.edge == b.edge' \
    "all(a.vertex[x] == b.vertex[x] for x in ('kind', 'coarse_vertex'))"
}

# sides FILE CLAIMS...: about how many coarse vertices in a PLY file are on the left and on the
# right.
sides()
{
  claim "m = ply('$1')" "x = [p[0] for p, c in zip(m.points, m.vertex['coarse_vertex']) if c >= 0]" \
    'left, right = sum(a < 0.5 for a in x), sum(a > 0.5 for a in x)' "${@:2}"
}

expect 0 simplify plain.mesh.off -o a.ply --vertices 100
sides a.ply 'left > 35' 'right > 35'
expect 0 simplify striped.mesh.off -o b.ply --vertices 100
alike
for weight in color=100 depth=100; do
  expect 0 simplify striped.mesh.ply -o a.ply --vertices 100 --weight $weight
  sides a.ply 'left < 12' 'right > 70'
done
expect 0 simplify striped.mesh.ply -o a.ply --vertices 100 --weight heat=100
sides a.ply 'left > 70' 'right < 12'
expect 0 simplify striped.mesh.ply -o a.ply --vertices 100 --weight color=5
expect 0 simplify striped.mesh.off -o b.ply --vertices 100 --weight color=5
alike
expect 0 simplify striped.mesh.off -o b.ply --vertices 100 --weight color=5 --refine 25
expect 0 simplify striped.mesh.ply -o b.ply --vertices 100 --weight color=0 --weight area=1
refuses 'no colors' simplify good.mesh.obj -o c.ply --vertices 100 --weight color=1
refuses "no property 'cold'; they have blue, depth, green, heat" \
  simplify striped.mesh.ply -o c.ply --vertices 100 --weight cold=1
# A tetrahedron in binary; only there numbers can be no numbers.
binary()
{
  local zero='\0\0\0\0' one='\0\0\200\77'
  printf 'ply\nformat binary_little_endian 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n'
  printf 'property float heat\nelement face 4\nproperty list uchar int vertex_indices\nend_header\n'
  printf "$zero$zero$zero$1$one$zero$zero$one$zero$one$zero$zero$zero$zero$one$one"
  printf '\3\0\0\0\0\2\0\0\0\1\0\0\0\3\0\0\0\0\1\0\0\0\3\0\0\0'
  printf '\3\1\0\0\0\2\0\0\0\3\0\0\0\3\2\0\0\0\0\0\0\0\3\0\0\0'
}
binary '\0\0\0\0' >binary.mesh.ply
expect 0 simplify binary.mesh.ply -o c.ply --vertices 4 --weight heat=1
binary '\0\0\300\177' >binary.mesh.ply
refuses 'not finite' simplify binary.mesh.ply -o c.ply --vertices 4 --weight heat=1
rm c.ply
rm a.* b.*

# Levels: matrices from each to the one before, and the saved form.
expect 0 simplify slivers.mesh.off -o a.ply --vertices 100 --levels 3 --prolongation a.mtx --stats a.json --save a.txt
expect_files a.json a.ply a.txt a_1.mtx a_2.mtx a_3.mtx
claim "json('a.json').level_vertices == [559, 237, 100]"
is_prolongation a_1.mtx 1320 559
is_prolongation a_2.mtx 559 237
is_prolongation a_3.mtx 237 100
is_colored a.ply
claim "lines_of('a.txt')[:2] == ['intrinsic_simplification 1', '1320 3960 2640']"
expect 0 simplify slivers.mesh.off -o b.ply --vertices 100 --levels 3 --save b.txt
cmp a.txt b.txt
rm a* b.*

# Refinement before: the vertices of the mesh keep their numbers, and its rows are those of the
# prolongation. Coarse edges lie on the mesh, so faces have its area together; the saved form has
# the mesh with more vertices, then the levels.
expect 0 simplify slivers.mesh.off -o b.ply --ratio 1
expect 0 simplify slivers.mesh.off -o a.ply --refine 25 --vertices 200 --prolongation a.mtx --stats a.json --save a.txt
is_prolongation a.mtx 1320 200
claim "m, s = ply('a.ply'), json('a.json')" "near(area(m) / area(ply('b.ply')), 1, 1e-9)" \
  "mtx('a.mtx').comments == ['% rows: the vertices of the mesh, without those inserted',
    '% columns: the vertices of level 1']" \
  "saved = lines_of('a.txt')" "saved[0] == 'intrinsic_triangulation 3'" \
  "start = saved.index('intrinsic_simplification 1')" 'sizes = saved[start + 1]' \
  'int(sizes.split()[0]) == 1320 + s.inserted_vertices' 'sizes in saved[:start]' \
  "set(m.face['input_face']) == set(range(2640))" 's.inserted_vertices > 0' 's.refinement_status' \
  "m.vertex['kind'].count(0) == 1320" "m.vertex['kind'].count(2) == s.inserted_vertices"
is_colored a.ply

# Refinement afterwards: good angles, of the coarse triangulation that all output is about.
expect 0 simplify slivers.mesh.off -o b.ply --vertices 20 --prolongation b.mtx --stats b.json
expect 0 simplify slivers.mesh.off -o a.ply --vertices 20 --min-angle 25 --prolongation a.mtx --stats a.json --save a.txt
claim "m, s, t = ply('a.ply'), json('a.json'), json('b.json')" \
  's.coarse_vertices == t.coarse_vertices + s.coarse_inserted_vertices' \
  's.coarse_inserted_vertices > 0' 's.coarse_faces_below_bound == s.coarse_faces_excused' \
  't.min_angle_degrees < 25 <= s.min_angle_degrees or s.coarse_faces_excused > 0' \
  'near(s.area_ratio, t.area_ratio, 1e-9)' "is_prolongation(mtx('a.mtx'), 1320, s.coarse_vertices)" \
  "set(m.face['coarse_face']) == set(range(s.coarse_faces))" \
  "set(m.face['input_face']) == set(range(2640))" \
  "sorted(c for c in m.vertex['coarse_vertex'] if c >= 0) == list(range(s.coarse_vertices))" \
  "m.vertex['kind'].count(2) == s.coarse_inserted_vertices" "near(area(m) / area(ply('b.ply')), 1, 1e-9)"
is_colored a.ply
grep -q '^4 ' a.txt
expect 0 simplify slivers.mesh.off -o a.vtp --vertices 20 --levels 3 --refine 20 --min-angle 30 --prolongation a.mtx
[ -s a_3.mtx ] || fail "no third matrix"
rm a.* a_?.mtx

# The coarse triangulation as an ordinary mesh: vertices of the mesh, few others, and what is wrong. A
# torus with three vertices has no other choice than loops and double edges.
expect 0 simplify slivers.mesh.off -o a.ply --vertices 100 --stats a.json
expect 0 simplify slivers.mesh.off -o b.ply --vertices 100 --coarse c.ply --stats b.json
cmp a.ply b.ply
claim "m, s, p = ply('c.ply'), json('b.json').coarse_mesh, off('slivers.mesh.off').points" \
  'len(m.points) == s.vertices == 100 + s.inserted_vertices' 'len(m.faces) == s.faces' \
  'is_ordinary(m)' "all(p[i] == q for i, q in zip(m.vertex['input_vertex'], m.points) if i >= 0)" \
  "m.vertex['input_vertex'].count(-1) == s.inserted_vertices" '0 < s.distance_to_coarse < 1' \
  '0 < s.distance_to_fine < 1'
says ', coarse mesh: '
for format in off obj ply vtp; do
  expect 0 simplify slivers.mesh.off --vertices 100 --coarse "c.$format" --binary --stats c.json
done
claim "len(off('c.off').points) == len(obj('c.obj').points) == len(ply('c.ply').points)"
expect 0 simplify square.mesh.off --vertices 5 --coarse c.off --stats c.json
claim "s, m = json('c.json').coarse_mesh, off('c.off')" 'near(area(m), 1, 1e-12)' \
  's.distance_to_coarse == s.distance_to_fine == s.flipped_faces == s.self_intersections == 0' \
  '(s.vertices, s.faces, s.inserted_vertices, s.degenerate_faces) == (5, 4, 0, 0) or s.faces == 3'
expect 2 simplify slivers.mesh.off --vertices 100 --coarse c.stl
expect 2 simplify slivers.mesh.off -o c.ply --vertices 100 --coarse c.ply
rm a.* b.* c.*

# What is inserted in flat faces is removed without cost: eight times as wide as high, and refined.
grid cells 16 0
awk 'FNR > 2 && NF == 3 { $1 *= 8 } { print }' cells.mesh.off >wide.mesh.off
expect 0 simplify wide.mesh.off -o a.ply --refine 30 --error 1e-12 --weight curvature=1 --stats a.json
claim "json('a.json').inserted_vertices > 100" "a = coarse_areas(ply('a.ply'))" \
  'list(a) == [0, 1]' 'near(a.values(), [4, 4], 1e-9)'
rm a.*

# Nothing left to remove is no failure, but told.
expect 0 simplify good.mesh.off -o a.ply --vertices 1 --stats a.json
says '(nothing_removable)'
claim "s = json('a.json')" "s.status == 'nothing_removable'" 's.removed == 0 or s.coarse_faces > 0'

# Handled, not refused.
expect 0 simplify isolated.mesh.off -o a.ply --vertices 4 --prolongation a.mtx --stats a.json
claim "s = json('a.json')" '(s.removed, s.skipped.isolated) == (0, 1)'
is_prolongation a.mtx 5 5
expect 0 simplify two_components.mesh.off -o - --vertices 5
expect 0 simplify cap.mesh.off -o - --vertices 3
expect 0 simplify needle.mesh.off -o - --vertices 1
expect 0 simplify zero_length.mesh.off -o - --vertices 3 --mollify 1e-6
rm a.*

# What vertices are removed from is certified; without doubts the result is what it is without.
expect 0 simplify slivers.mesh.off -o a.ply --vertices 100
for angle in '' '--refine 25'; do
  expect 0 simplify slivers.mesh.off -o b.ply --vertices 100 $angle --exact --stats b.json
  claim "m, s = ply('b.ply'), json('b.json')" 's.certified' 's.ties == 0' 's.coarse_vertices == 100' \
    'sum(s.decisions.values()) >= s.edges' 'len(coarse_areas(m)) == s.coarse_faces'
done
expect 0 simplify cap.mesh.off -o b.ply --vertices 1 --exact --stats b.json
claim "json('b.json').certified"
rm a.* b.*

# Topology: the boundary of a square is closed if the bound is not below its length, and a torus
# of 12 times 6 vertices is cut along one of its hexagons. The rest stays as it is.
grid flat 4 0
expect 0 simplify flat.mesh.off -o b.ply --ratio 1 --close-loops 3.99 --stats b.json
claim "json('b.json').closed_loops == 0"
for option in '' --exact '--refine 25'; do
  expect 0 simplify flat.mesh.off -o b.ply --ratio 1 --close-loops 4 $option --stats b.json
  claim "m, s = ply('b.ply'), json('b.json')" \
    '(s.closed_loops, s.boundary_loops_before, s.boundary_loops_after) == (1, 1, 0)' \
    's.filled_area > 0.9' "list(m.face['input_face']).count(-1) >= 16" \
    "max(m.face['input_face']) == 31"
done
python3 -c '
from math import *
print("OFF\n72 144 0")
for i in range(12):
  for j in range(6):
    s, t = i * pi / 6, j * pi / 3
    print((3 + cos(t)) * cos(s), (3 + cos(t)) * sin(s), sin(t))
for i in range(12):
  for j in range(6):
    a, b, c, d = (i % 12 * 6 + j, (i + 1) % 12 * 6 + j, (i + 1) % 12 * 6 + (j + 1) % 6, i * 6 + (j + 1) % 6)
    print(3, a, b, c)
    print(3, a, c, d)' >torus.mesh.off
expect 0 simplify torus.mesh.off --coarse b.ply --vertices 3 --stats b.json
claim "m, s = ply('b.ply'), json('b.json').coarse_mesh" 'is_ordinary(m)' 's.inserted_vertices > 0' \
  '2 * len(m.points) == len(m.faces)'
expect 0 simplify torus.mesh.off -o b.ply --vertices 20 --pinch-handles 5.99 --stats b.json
claim "s = json('b.json')" '(s.pinched_handles, s.genus_before, s.genus_after) == (0, 1, 1)'
expect 0 simplify torus.mesh.off -o b.ply --vertices 20 --pinch-handles 6.01 --stats b.json \
  --prolongation b.mtx
claim "s = json('b.json')" '(s.pinched_handles, s.genus_before, s.genus_after) == (1, 1, 0)' \
  'abs(s.filled_area - 3 * 3 ** 0.5) < 1e-9' 's.coarse_faces == 36'
is_prolongation b.mtx 72 20
rm b.*

# Wrong calls.
for option in --close-loops --pinch-handles; do
  for length in -1 nan many; do
    expect 2 simplify slivers.mesh.off -o a.ply --vertices 10 $option=$length
  done
done
expect 2 simplify slivers.mesh.off -o a.ply
expect 2 simplify slivers.mesh.off -o a.ply --vertices 10 --ratio 0.5
expect 2 simplify slivers.mesh.off -o a.ply --vertices 10 --error 0.5
expect 2 simplify slivers.mesh.off -o a.ply --vertices 10 --prolongation a.ply
for n in 0 -1 many 1.5; do
  expect 2 simplify slivers.mesh.off -o a.ply --vertices=$n
done
for ratio in 0 -0.1 1.1 nan many; do
  expect 2 simplify slivers.mesh.off -o a.ply --ratio=$ratio
done
for error in -1 nan many; do
  expect 2 simplify slivers.mesh.off -o a.ply --error=$error
done
for weight in curvature area_change area_change=1 boundary_change=1 curvature=0 area_change=-1 color =1 area= area=-1 area=nan area=inf area=1x; do
  refuses '--weight' simplify slivers.mesh.off -o a.ply --vertices 10 --weight $weight
done
refuses '--weight' simplify slivers.mesh.off -o a.ply --vertices 10 --weight area=0 --weight color=0
expect_files

if [ -n "$data" ]; then
  for mesh in elephant.off sphere.stl bones.off star.off; do
    expect 0 simplify "$data/meshes/$mesh" -o mesh.ply --ratio 0.1 --prolongation mesh.mtx --stats mesh.json
    claim "m, s = ply('mesh.ply'), json('mesh.json')" 'len(coarse_areas(m)) == s.coarse_faces' \
      "is_prolongation(mtx('mesh.mtx'), s.vertices, s.coarse_vertices)" 'is_colored(m)'
  done
fi
