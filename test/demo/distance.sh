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
    expect 0 distance $mesh.mesh.off --source $source -o a.ply --subdivision b.ply --quiet --method heat
    is_euclidean a.ply $source
    is_euclidean b.ply $source
  done
done

# By default, they are those to rounding.
for options in '' '--method auto' '--method exact' --exact-distance; do
  # shellcheck disable=SC2086
  expect 0 distance sheared.mesh.off --source 840 -o a.ply --stats a.json $options
  says '(exact)'
  claim "m = ply('a.ply')" "json('a.json').method == 'exact'" \
    "all(near(d, dist(p, m.points[840]), 1e-12) for d, p in zip(m.vertex['distance'], m.points))"
done
expect 0 distance sheared.mesh.off --source 840 -o a.ply --subdivision b.ply

# The input again, with one more number for each vertex; the subdivision has the same numbers there,
# and between two of them on the edges.
claim "a, b, m = ply('a.ply'), ply('b.ply'), off('sheared.mesh.off')" \
  '(a.points, a.faces) == (m.points, m.faces)' 'len(b.points) > 1681' \
  "b.vertex['distance'][:1681] == a.vertex['distance']"

# Mirrored in the diagonal, the square is itself, and so are the distances to a vertex on the
# diagonal.
expect 0 distance square.mesh.off --source 0 -o a.ply --method heat
# The bound is the condition of the matrices times 1e-16.
claim "d = ply('a.ply').vertex['distance']" \
  'all(near(d[41 * j + i], d[41 * i + j], 1e-9) for j in range(41) for i in range(j))'

# Several sources: the nearest counts.
expect 0 distance square.mesh.off --source 0 --source 1680 -o a.ply --stats a.json --method heat
claim "m = ply('a.ply')" \
  "e, truth = errors(m.vertex['distance'], m.points, (0, 0), (1, 1))" 'sum(e) <= 0.03 * sum(truth)'

cp "$shipped" slivers.mesh.off
expect 0 distance slivers.mesh.off --source 7 -o - --subdivision b.vtp --stats statistics.json
has_keys statistics.json $surface_keys flips $edge_keys method sources max_distance \
  unreachable_vertices $subdivision_keys seconds read build flip solve trace subdivide write peak_memory_bytes
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

# Lengths do not determine the area of a face, and the exact metric does.
off thin '0 0 0,1 0 0,0 1 0,0.5 1e-17 0' '0 3 2,3 1 2,0 1 3'
expect 0 distance thin.mesh.off --source 0 -o a.ply --method heat --strict
distances a.ply 0 + + +
rm a.*

# A face without area has no heat equation: its edges become longer, unless that is not allowed.
off flat '0 0 0,1 0 0,2 0 0' '0 1 2'
expect 0 distance flat.mesh.off --source 0 -o a.ply
claim "ply('a.ply').vertex['distance'] == [0, 1, 2]"
expect 0 distance flat.mesh.off --source 0 -o a.ply --stats a.json --method heat
says 'flat.mesh.off: computed with --mollify 1e-8: the area of face 0 is zero, like the areas of all faces at vertex'
claim "s = json('a.json')" 's.mollification == 1e-8' 'near(s.added_length, 4e-8 / 3, 1e-15)'
rm a.*
for option in --strict --exact; do
  expect 1 distance flat.mesh.off --source 0 -o a.ply --method heat "$option"
  says 'the area of face 0 is zero, like the areas of all faces at vertex'
  [ ! -e a.ply ] || fail 'a file after a failure'
done
expect 0 distance flat.mesh.off --source 0 -o - --mollify 1e-3
expect 0 distance zero_length.mesh.off --source 0 -o - --mollify 1e-3
expect 0 distance slivers.mesh.off --source 0 -o - --time-step 4

# Heat that a thousand short edges let flow for a short time does not reach the end of a strip of
# long ones; it flows for longer then, unless a time is given.
python3 - > strip.mesh.off << 'end'
columns = [i / 1000 for i in range(3000)] + [3 + i for i in range(400)]
print('OFF\n%d %d 0' % (2 * len(columns), 2 * len(columns) - 2))
for x in columns:
    print('%.17g 0 0\n%.17g 0.001 0' % (x, x))
for i in range(0, 2 * len(columns) - 2, 2):
    print('3 %d %d %d\n3 %d %d %d' % (i, i + 2, i + 1, i + 1, i + 2, i + 3))
end
expect 0 distance strip.mesh.off --source 0 -o a.ply --stats a.json
claim "near(json('a.json').max_distance, hypot(402, 0.001), 1e-9)"
expect 0 distance strip.mesh.off --source 0 -o a.ply --stats a.json --method heat
claim "s = json('a.json')" 's.time_step_factor > 1' 'near(s.max_distance, 402, 4)'
rm a.*
expect 1 distance strip.mesh.off --source 0 -o a.ply --time-step 1
says 'no heat reaches vertex'
says 'a greater time step factor is needed'

# Wrong calls.
for source in 1320 -1 99999999999; do
  refuses "slivers.mesh.off: there is no vertex $source to be a source; the vertices are 0 to 1319" \
    distance slivers.mesh.off --source=$source -o a.ply
done
expect 2 distance slivers.mesh.off --source one -o a.ply
for path in a.off a.obj; do
  refuses "$path: this format cannot carry distances (.ply and .vtp can)" \
    distance slivers.mesh.off --source 0 -o $path
  expect 2 distance slivers.mesh.off --source 0 -o a.ply --subdivision $path
done
expect 2 distance slivers.mesh.off --source 0 -o - --format off
expect 2 distance slivers.mesh.off --source 0 -o a.ply --subdivision a.ply
expect 2 distance slivers.mesh.off --source 0 -o a.ply --time-step 0
expect_files

# ---- Methods ----

# With heat, the last line and the statistics have the estimate of the error; it is that of all
# vertices here.
expect 0 distance slivers.mesh.off --source 7 -o a.ply --stats a.json --method heat
says '(by heat, errors '
expect 0 distance slivers.mesh.off --source 7 -o b.ply
claim "h, e = (ply(f).vertex['distance'] for f in ('a.ply', 'b.ply'))" "s = json('a.json')" \
  'errors_of = sorted(abs(a / b - 1) for a, b in zip(h, e) if b > 0)' "s.method == 'heat'" \
  's.relative_error.vertices == len(errors_of)' 'near(s.relative_error.greatest, errors_of[-1], 1e-5)' \
  'near(s.relative_error.mean, sum(errors_of) / len(errors_of), 1e-5)' \
  's.time_step_factor == 1'
expect 0 distance square.mesh.off --source 7 -o a.ply --stats a.json --method heat
claim "json('a.json').relative_error.ninety_percent < .1"
! grep -q warning err || fail "a warning: $(cat err)"
expect 0 distance slivers.mesh.off --source 7 -o a.ply --stats a.json --time-step 1
claim "json('a.json').method == 'heat'"

# Two triangles, a cube of squares, a grid whose boundary is the source: exact by default.
off rhombus '0 0 0,1 3 0,2 0 0,1 -3 0' '0 2 1,0 3 2'
expect 0 distance rhombus.mesh.off --source 2 -o a.ply
claim "ply('a.ply').vertex['distance'] == [2, sqrt(10), 0, sqrt(10)]"
off quads '1 1 -1,1 -1 -1,1 1 1,1 -1 1,-1 1 -1,-1 -1 -1,-1 1 1,-1 -1 1' \
  '0 4 6 2,3 2 6 7,7 6 4 5,5 1 3 7,1 0 2 3,5 4 0 1'
expect 0 distance quads.mesh.off --source 0 -o a.ply --stats a.json
claim "d = ply('a.ply').vertex['distance']" 'near(max(d), sqrt(20), 1e-14)' \
  "[near(x, y, 1e-14) for x, y in zip(sorted(d), [0, 2, 2, 2, sqrt(8), sqrt(8), sqrt(8), sqrt(20)])] == [True] * 8"
expect 0 distance quads.mesh.off --source 0 -o a.ply --method heat
says 'quads.mesh.off: warning: a tenth of the distances by heat are wrong by'
expect 0 distance quads.mesh.off --source 0 -o a.ply --method heat --quiet
[ ! -s err ] || fail "not quiet: $(cat err)"
grid even 20 0
python3 -c "print(*('--source %d' % (21 * j + i) for j in range(21) for i in range(21)
  if i * j * (20 - i) * (20 - j) == 0))" >boundary
# shellcheck disable=SC2046
expect 0 distance even.mesh.off $(cat boundary) -o a.ply
claim "m = ply('a.ply')" "all(near(d, min(p[0], 1 - p[0], p[1], 1 - p[1]), 1e-13)
  for d, p in zip(m.vertex['distance'], m.points))"
printf 'v %s 0\n' '0 0' '1 0' '1 1' '0 1' >border.mesh.obj
echo 'l 1 2 3 4 1' >>border.mesh.obj
expect 0 distance even.mesh.off --curve border.mesh.obj -o b.ply
claim "all(near(c, d, 1e-13) for c, d in zip(ply('a.ply').vertex['distance'], ply('b.ply').vertex['distance']))"

# By heat no value is below the distance in space, nor zero away from the sources; how many were is
# said.
for i in 1 2 3 4 5 6 7 8; do
  python3 - $i >needles.mesh.off <<'END'
import random, sys
dice = random.Random(int(sys.argv[1]))
n = 6
print('OFF\n%d %d 0' % (2 * n, 2 * n - 2))
for k in range(2 * n):
    print(k // 2 + dice.uniform(-.4, .4), 8 * dice.random() * (k % 2) + k % 2, dice.uniform(-3, 3))
for k in range(2 * n - 2):
    print(3, k, k + 1 + k % 2, k + 2 - k % 2)
END
  for source in 1 4; do
    expect 0 distance needles.mesh.off --source $source -o a.ply --method heat --stats a.json
    claim "m = ply('a.ply')" "d = m.vertex['distance']" "all(x > 0 for v, x in enumerate(d) if v != $source)" \
      "all(x >= dist(p, m.points[$source]) * (1 - 1e-11) for x, p in zip(d, m.points))" \
      "json('a.json').raised_vertices == 0 or '$(grep -c 'values raised' err)' == '1'"
  done
done

# An isolated vertex as a source, sources at one place.
off alone '0 0 0,1 0 0,0 1 0,5 5 5' '0 1 2'
for method in auto exact heat; do
  expect 0 distance alone.mesh.off --source 3 -o a.ply --method $method
  claim "ply('a.ply').vertex['distance'] == [-1, -1, -1, 0]"
  expect 0 distance alone.mesh.off --source 0 --source 3 --source 3 --source 0:1,0,0 -o a.ply --method $method
  claim "d = ply('a.ply').vertex['distance']" 'd[0] == d[3] == 0' 'd[1] > .9' 'd[2] > .9'
done
expect 2 distance even.mesh.off --source 0 -o c.ply --method best
expect 2 distance even.mesh.off --source 0 -o c.ply --method heat --exact-distance
rm a.* b.* boundary

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
says "'0,0,3' is not a point of the mesh: it is 3.000000 away from it, more than 0.070711"
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

# a square and a parallelogram, whose boundary deflects heat far from the curve
for case in "square 0.5 0.02" "sheared 1.4 0.07"; do
  read -r mesh x bound <<<"$case"
  circle left.mesh.obj 1 "$x"
  circle right.mesh.obj -1 "$x"
  expect 0 distance $mesh.mesh.off --curve left.mesh.obj --signed -o a.ply --stats a.json
  on_circle a.ply "$x" "$bound" ''
  claim "s = json('a.json')" 'near(s.curve.length, 1.2563, 1e-3)' 's.curve.polylines == 1' \
    's.curve.points == 81' 's.min_distance < -0.15' 's.sources == []'
  expect 0 distance $mesh.mesh.off --curve right.mesh.obj --signed -o a.ply --min-angle 28
  on_circle a.ply "$x" "$bound" -
  expect 0 distance $mesh.mesh.off --curve right.mesh.obj -o a.ply --subdivision b.ply
  on_circle a.ply "$x" 0.05 abs
done
circle left.mesh.obj 1 0.5
expect 0 distance square.mesh.off --curve left.mesh.obj --signed -o a.ply --view a.html --picture a.svg
rm a.* b.*

# marked FILE: the length in pixels of the lines of a picture that are marked.
marked()
{
  python3 - "$1" <<'END'
import math, sys, xml.dom.minidom as dom
lines = [p.getAttribute("d")[1:].split() for p in dom.parse(sys.argv[1]).getElementsByTagName("path")
         if p.getAttribute("class") == "p"]
points = [[tuple(map(float, p.split(","))) for p in line] for line in lines]
print(sum(math.dist(p, q) for line in points for p, q in zip(line, line[1:])))
END
}

# Pictures show a curve: all of it where nothing is in front of it, in pixels of the square;
expect 0 distance square.mesh.off --curve left.mesh.obj -o a.ply --picture a.svg
claim "near($(marked a.svg), 560 * 1.2563, 3)"
# around a box, half of the sides; all of the edges of the top, whether this box or a finer one is shown;
off box '0 0 0,1 0 0,1 1 0,0 1 0,0 0 2,1 0 2,1 1 2,0 1 2' \
  '0 3 2 1,4 5 6 7,0 1 5 4,1 2 6 5,2 3 7 6,3 0 4 7'
for height in 0 0.7 2; do
  printf "v %s $height\n" '0 0' '1 0' '1 1' '0 1' >around.mesh.obj
  echo 'l 1 2 3 4 1' >>around.mesh.obj
  expect 0 distance box.mesh.off --curve around.mesh.obj -o a.ply --picture $height.svg
  expect 0 distance box.mesh.off --curve around.mesh.obj -o a.ply --min-angle 30 --picture fine$height.svg
done
claim "near($(marked 0.svg), $(marked 2.svg) / 2, 3)" "near($(marked 0.7.svg), $(marked 2.svg) / 2, 3)" \
  "near($(marked fine0.7.svg), $(marked 0.7.svg), 3)" "$(marked 2.svg) > 500"
# nothing of what is behind; and what path finds, as a line from one side of the square to the other.
printf 'v 0 0 1\nv 1 0 1\nl 1 2\n' >front.mesh.obj
printf 'v 0 1 1\nv 1 1 1\nl 1 2\n' >back.mesh.obj
expect 0 distance box.mesh.off --curve front.mesh.obj -o a.ply --picture front.svg
expect 0 distance box.mesh.off --curve back.mesh.obj -o a.ply --picture back.svg
claim "near(min($(marked front.svg), $(marked back.svg)), 0, 3)" "max($(marked front.svg), $(marked back.svg)) > 200"
expect 0 path square.mesh.off --from 0,.3,0 --to 1,.4,0 -o a.ply --picture a.svg
claim "near($(marked a.svg), 560 * hypot(1, .1), 1)"
rm ./*.svg a.ply

# What path writes is a curve.
expect 0 path square.mesh.off --from 0.1,0.1,0 --to 0.9,0.7,0 -o path.mesh.obj
expect 0 distance square.mesh.off --curve path.mesh.obj --source 0 -o a.ply
expect 0 distance square.mesh.off --curve path.mesh.obj --signed --time-step 9 -o a.ply
printf '0 0.5 0\n1 0.5 0\n' >line.mesh.xyz
expect 0 distance square.mesh.off --curve line.mesh.xyz --signed -o a.ply
claim "m = ply('a.ply')" \
  "all(near(d, 0.5 - p[1], 1e-9) for d, p in zip(m.vertex['distance'], m.points))"
rm a.*

# In each format, with the bytes that .obj gives.
same_in_each_format()
{
  local output
  for output in path.mesh.obj path.mesh.ply path.mesh.vtp "binary.mesh.ply --binary"; do
    # shellcheck disable=SC2086
    expect 0 path "$1" "${@:2}" -o $output
    expect 0 distance "$1" --curve "${output%% *}" -o a.ply --stats a.json
    [ "$output" != path.mesh.obj ] || cp a.ply b.ply
    cmp a.ply b.ply
    claim "json('a.json').curve.polylines == 1"
    expect 0 distance "$1" --curve "${output%% *}" --signed --time-step 9 -o a.ply
    [ "$output" != path.mesh.obj ] || cp a.ply c.ply
    cmp a.ply c.ply
  done
  rm a.* b.* c.*
}
same_in_each_format square.mesh.off --from 0.1,0.1,0 --to 0.9,0.7,0
same_in_each_format square.mesh.off --from 3:.2,.3,.5 --straightest 200 0.3
same_in_each_format good.mesh.off --from 0:.2,.3,.5 --to 3:.2,.3,.5
same_in_each_format good.mesh.off --from 0 --to 3 --flips

# edges FILE FORMAT MIXED: the circle as edges in any order, and the first of them in the direction of
# the circle; with other properties and a face, as other programs write them.
edges()
{
  python3 - "$@" <<'END'
import math, random, struct, sys
path, form, is_mixed = sys.argv[1], sys.argv[2], sys.argv[3] == "mixed"
dice, n = random.Random(5), 80
points = [(0.5 + 0.2 * math.cos(2 * math.pi * k / n), 0.45 + 0.2 * math.sin(2 * math.pi * k / n), 0)
          for k in range(n)]
edges = [(k, (k + 1) % n) for k in range(n)]
dice.shuffle(edges)
if is_mixed:
    edges[1:] = [e if dice.random() < 0.5 else e[::-1] for e in edges[1:]]
header = f"""ply
format {form} 1.0
comment curve
element edge {n}
property uchar flags
property int vertex2
property list uchar int marks
property int vertex1
element vertex {n}
property float x
property float y
property float z
property double quality
element face 1
property list uchar int vertex_indices
end_header
"""
rows = [("BiBii", 7, w, 1, 3, v) for v, w in edges] + [("fffd", *p, 0.5) for p in points]
rows.append(("Biii", 3, 0, 1, 2))
with open(path, "wb") as file:
    file.write(header.encode())
    for types, *row in rows:
        file.write((" ".join(map(str, row)) + "\n").encode() if form == "ascii"
                   else struct.pack((">" if "big" in form else "<") + types, *row))
END
}
for format in ascii binary_little_endian binary_big_endian; do
  for order in given mixed; do
    edges edges.mesh.ply $format $order
    expect 0 distance square.mesh.off --curve edges.mesh.ply --signed -o a.ply --stats a.json
    on_circle a.ply 0.5 0.05 ''
    claim "s = json('a.json').curve" 'near(s.length, 1.2563, 1e-3)' 's.polylines == 1' 's.points == 81'
  done
done

# Edges are joined up to where three of them, or one, have an end.
printf 'ply\nformat ascii 1.0\nelement vertex 6\nproperty double x\nproperty double y\nproperty double z
element edge 5\nproperty int vertex1\nproperty int vertex2\nend_header
0 0 0\n.5 0 0\n1 0 0\n.5 1 0\n.2 .8 0\n.2 .8 0\n0 1\n1 2\n1 3\n4 3\n5 5\n' >fork.mesh.ply
expect 0 distance square.mesh.off --curve fork.mesh.ply -o a.ply --stats a.json
claim "s = json('a.json').curve" 's.polylines == 4' 's.points == 9' \
  'near(s.length, 2 + hypot(.3, .2), 1e-9)'

# Two pieces, with what another program may add, are the lines of the OBJ file.
cat >pieces.mesh.vtp <<'END'
<?xml version='1.0'?>
<!-- <Points> of a curve -->
<VTKFile version="1.0" type="PolyData" header_type="UInt64"><PolyData>
<Piece NumberOfPoints="3" NumberOfLines="1">
  <PointData><DataArray type="Float64" Name="heat" format="appended" offset="0"/></PointData>
  <Points>
    <DataArray NumberOfComponents="3" Name="Points" type="Float32" format="ascii" RangeMax="1">
      0.1 0.1 0 0.5 0.3
      0 0.9 0.1 0
      <InformationKey name="L2_NORM_RANGE"><Value index="0">7</Value></InformationKey>
    </DataArray>
  </Points>
  <Verts><DataArray Name="connectivity" format="ascii">9 9</DataArray></Verts>
  <Lines>
    <DataArray Name="offsets" type="Int64" format="ascii">3</DataArray>
    <DataArray Name='connectivity' type="Int64" format='ascii'>0 1 2</DataArray>
  </Lines>
  <Strips><DataArray Name="offsets" format="ascii">4</DataArray></Strips>
</Piece>
<Piece><Points><DataArray NumberOfComponents="3" format="ascii">.1 .9 0 .9 .9 0</DataArray></Points><Lines>
<DataArray Name="connectivity" format="ascii">1 0 0 1</DataArray><DataArray Name="offsets" format="ascii">2 4
</DataArray></Lines></Piece></PolyData></VTKFile>
END
printf 'v %s\n' '.1 .1 0' '.5 .3 0' '.9 .1 0' '.1 .9 0' '.9 .9 0' >pieces.mesh.obj
printf 'l %s\n' '1 2 3' '5 4' '4 5' >>pieces.mesh.obj
for extension in obj vtp; do
  expect 0 distance square.mesh.off --curve pieces.mesh.$extension -o $extension.ply --stats a.json
  claim "s = json('a.json').curve" 's.polylines == 3' 's.points == 7'
done
cmp obj.ply vtp.ply
rm a.* obj.ply vtp.ply

refuses_curve() { refuses "$1" distance "${@:2}" -o a.ply; }
printf 'v 0 0 0\n' >none.mesh.obj
printf 'v 0 0 0\nl 1\n' >one.mesh.obj
printf 'v 0 0 0\nl 1 9\n' >bad.mesh.obj
printf 'v 0 0 0\nv 0 0 1\nl 1 2\n' >far.mesh.obj
refuses_curve 'none.mesh.obj: has no polylines' square.mesh.off --curve none.mesh.obj
refuses_curve 'one.mesh.obj: a polyline has less than two points' square.mesh.off --curve one.mesh.obj
refuses_curve 'bad.mesh.obj: line 2 cannot be understood: there is no vertex 9; the file has 1' square.mesh.off --curve bad.mesh.obj
refuses_curve 'far.mesh.obj: point 2 is 1.000000 away from the surface' square.mesh.off --curve far.mesh.obj
refuses_curve 'curves are read from .obj, .ply, .vtp and .xyz' square.mesh.off --curve square.mesh.off
refuses_curve 'nothing.obj: no such file' square.mesh.off --curve nothing.obj
edges whole.mesh.ply ascii given
edges binary.mesh.ply binary_little_endian given
# changed FILE EXPRESSION FROM: the file FROM, changed by sed.
changed() { sed "$2" "$3" >"$1"; }
changed bad.mesh.ply '25s/[0-9]*$/80/' whole.mesh.ply
refuses_curve 'bad.mesh.ply: line 25 cannot be understood: an edge names a vertex that does not exist; there are 80' \
  square.mesh.off --curve bad.mesh.ply
changed bad.mesh.ply '25s/ [0-9]*/ -1/' whole.mesh.ply
refuses_curve 'line 25 cannot be understood: an edge names a vertex' square.mesh.off --curve bad.mesh.ply
changed bad.mesh.ply '25s/ [0-9]*/ .5/' whole.mesh.ply
refuses_curve 'line 25 cannot be understood: an edge names a vertex' square.mesh.off --curve bad.mesh.ply
changed bad.mesh.ply 's/vertex1/vertex3/' whole.mesh.ply
refuses_curve "edges have no properties 'vertex1' and 'vertex2'" square.mesh.off --curve bad.mesh.ply
changed bad.mesh.ply '100,$d' whole.mesh.ply
refuses_curve 'ends too early' square.mesh.off --curve bad.mesh.ply
LC_ALL=C changed bad.mesh.ply 's/^end_header$/&\n\x01\xff\xff\xff\xff/' binary.mesh.ply
refuses_curve "byte $(($(sed '/^end_header$/q' binary.mesh.ply | wc -c) + 1)): an edge names a vertex" \
  square.mesh.off --curve bad.mesh.ply
head -c 700 binary.mesh.ply >bad.mesh.ply
refuses_curve 'ends too early' square.mesh.off --curve bad.mesh.ply
changed bad.mesh.ply '4s/edge/chain/' whole.mesh.ply
refuses_curve 'has no polylines' square.mesh.off --curve bad.mesh.ply

# Damaged lines of .vtp: what is said, and how the file above is changed.
while IFS='|' read -r said change; do
  changed bad.mesh.vtp "${change# }" pieces.mesh.vtp
  refuses_curve "${said% }" square.mesh.off --curve bad.mesh.vtp
done <<'TABLE'
line 3 cannot be understood: <VTKFile type="PolyData"> expected at the beginning | s/ type="PolyData"/ type="ImageData"/
line 1 cannot be understood: <VTKFile type="PolyData"> expected at the beginning | 1s/xml/x/
line 8 cannot be understood: a character is not of base64 | 7s/ascii/binary/
line 16 cannot be understood: the offset of appended numbers is missing | 16s/ascii/appended/
line 7 cannot be understood: points do not have three coordinates each | 7s/"3"/"2"/
line 7 cannot be understood: points do not have three coordinates each | 7s/NumberOfComponents="3"//
line 10 cannot be understood: a number is missing | 9s/ 0$//
line 9 cannot be understood: 'nan' is not a finite number | 9s/0.1/nan/
line 9 cannot be understood: 'zero' is not a number | 9s/0.1/zero/
line 16 cannot be understood: a line names a point that does not exist; there are 3 in this piece | 16s/0 1 2/0 1 3/
line 21 cannot be understood: a line names a point that does not exist; there are 2 in this piece | 21s/1 0 0 1/1 0 0 2/
line 16 cannot be understood: an index of a point or an offset is negative | 16s/0 1 2/0 -1 2/
line 15 cannot be understood: an index of a point or an offset is negative | 15s/3/-3/
line 16 cannot be understood: an index of a point or an offset is not an integer | 16s/0 1 2/0 1.5 2/
line 21 cannot be understood: the offsets of cells are not ascending | 21s/2 4$/4 2/
line 19 cannot be understood: the last of the offsets of lines is not the number of their points | 16s/0 1 2/0 1 2 1/
line 19 cannot be understood: the last of the offsets of lines is not the number of their points | 15s/3/4/
line 19 cannot be understood: the last of the offsets of lines is not the number of their points | 15s/3//
a polyline has less than two points | 21s/2 4$/1 4/
ends too early; it is not complete | 12,$d
ends too early; it is not complete | 22s/.VTKFile>//
ends too early; it is not complete | 2s/-->//
has no polylines | s/Lines>/Cells>/g
TABLE
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

# Level sets: circles around the center of a square, and straight lines beside a curve.
off fan '0 0 0,1 0 0,0 1 0,-1 0 0,0 -1 0' '0 1 2,0 2 3,0 3 4,0 4 1'
expect 0 distance fan.mesh.off --source 0 --exact-distance -o a.ply --level-sets b.ply --level 0.5 --level 0.25
claim "m = ply('b.ply')" "all(near(abs(p[0]) + abs(p[1]), l, 1e-12) for e, l in zip(m.edges, m.edge['level']) for p in (m.points[v] for v in e))" \
  "Counter(m.edge['level']) == {.5: 4, .25: 4}"
expect 0 distance fan.mesh.off --source 0 --exact-distance -o a.ply --level-sets b.vtp --level 0.5
claim "near(lines('b.vtp'), [1, 4 * sqrt(.5)], 1e-12)"
! grep -q warning err || fail 'a level with a curve has no warning'
expect 0 distance fan.mesh.off --source 0 --exact-distance -o a.ply --level-sets b.ply --level 0.5 --level 1.5 --level 0
says 'fan.mesh.off: warning: level 1.5 has no curve; distances are from 0 to 1'
says 'fan.mesh.off: warning: level 0 has no curve; distances are from 0 to 1'
claim "Counter(ply('b.ply').edge['level']) == {.5: 4}"
expect 0 distance slivers.mesh.off --source 0 -o a.ply --min-angle 25 --level-sets b.obj
claim "len([w for w in lines_of('b.obj') if w.startswith('l')]) >= 10"
