#!/usr/bin/env bash
# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# Files, formats, statistics and exit codes of the command delaunay.
source "$(dirname "${BASH_SOURCE[0]}")/common.bash"

cp "$shipped" slivers.mesh.off
checksum=$(cksum <slivers.mesh.off)

expect 0 delaunay slivers.mesh.off -o a.ply --stats a.json --save a.save
[ ! -s out ] || fail 'standard output is not empty'
expect_files a.json a.ply a.save

# The same bytes once more, and in every format.
for format in ply off obj vtp; do
  expect 0 delaunay slivers.mesh.off -o "a.$format" --quiet
  [ ! -s err ] || fail "not quiet: $(cat err)"
  expect 0 delaunay slivers.mesh.off -o - --format "$format" --quiet
  cmp "a.$format" out
done
expect 0 delaunay slivers.mesh.off -o b.ply --save b.save
cmp a.ply b.ply
cmp a.save b.save

# The subdivision can be read again and covers the same surface.
for format in ply off obj; do
  "$program" info "a.$format" >out || true
  grep -q 'Euler characteristic  0' out || fail "bad subdivision in a.$format: $(cat out)"
done
rm a.* b.*

expect 0 delaunay slivers.mesh.off -o - --stats statistics.json
has_keys statistics.json $surface_keys flips $edge_keys $subdivision_keys seconds read build \
  flip trace subdivide write peak_memory_bytes
claim "s = json('statistics.json')" 's.is_delaunay' 's.vertices == 1320'
rm statistics.json

# Exact decisions on faces with cocircular corners.
printf 'OFF\n4 2 0\n0 0 0\n3 0 4\n3 5 4\n0 5 0\n3 0 1 2\n3 0 2 3\n' >square.mesh.off
expect 0 delaunay square.mesh.off -o exact.ply --exact --stats statistics.json
claim "s = json('statistics.json')" 's.certified' 's.ties == 1' 's.is_delaunay' 's.decisions.exact == 1'
expect 0 delaunay slivers.mesh.off -o exact.ply --exact --stats statistics.json
claim "s = json('statistics.json')" 's.certified' 'sum(s.decisions.values()) >= s.edges'
rm exact.ply statistics.json

# Weights of vertices flip a diagonal of the square, or hide a point inside it.
printf 'OFF\n5 4 0\n0 0 0\n2 0 0\n2 2 0\n0 2 0\n1.2 1 0\n3 0 1 4\n3 1 2 4\n3 2 3 4\n3 3 0 4\n' >star.mesh.off
printf '4 -9\n' >weights.txt
expect 0 delaunay star.mesh.off -o star.ply --weights weights.txt --stats statistics.json
says '1 hidden vertices'
claim "s = json('statistics.json')" 's.hidden_vertices == [4]' 's.is_weighted_delaunay' \
  '"is_delaunay" not in s'
expect 0 delaunay star.mesh.off -o star.ply --weights weights.txt --exact --stats statistics.json
claim "s = json('statistics.json')" 's.hidden_vertices == [4]' 's.is_weighted_delaunay' \
  's.certified' 's.undecided == 0' 's.ties >= 1'
printf '0 0.5\n2 0.5\n' >weights.txt
expect 0 delaunay square.mesh.off -o star.ply --weights weights.txt --stats statistics.json
claim "s = json('statistics.json')" 's.flips == 0' 's.hidden_vertices == []'
printf '1 0.5\n3 0.5\n' >weights.txt
expect 0 delaunay square.mesh.off -o star.ply --weights weights.txt --stats statistics.json
claim "s = json('statistics.json')" 's.flips == 1' 's.is_weighted_delaunay'
rm star.mesh.off star.ply weights.txt statistics.json

# accordion STEPS...: a strip that is folded along parallel lines; each step x,z leads to the next
# fold. On both ends, four points are the corners of a rectangle, with the roots of all x^2 + z^2.
accordion()
{
  python3 - "$@" <<'END' >accordion.mesh.off
import sys

steps = [tuple(map(int, s.split(","))) for s in sys.argv[1:]]
x = z = 0
points, faces, last = [], [], None
for i, (dx, dz) in enumerate([(0, 0)] + steps):
    x, z = x + dx, z + dz
    heights = (-469, 0, 57, 469) if i in (0, len(steps)) else (-469, 469)
    column = range(len(points), len(points) + len(heights))
    points += [(x, y, z) for y in heights]
    if last:
        faces += [(a, column[0], b) for a, b in zip(last, last[1:])]
        faces += [(last[-1], a, b) for a, b in zip(column, column[1:])]
    last = column
print("OFF", len(points), len(faces), 0)
for p in points:
    print(*p)
for f in faces:
    print(3, *f)
END
}

# Eleven roots, three of which are products of others, are decided; thirteen primes are not.
accordion 10,-10 5,11 11,-10 3,1 8,-9 6,1 7,-11 4,10 2,-4 8,10 9,-7
expect 0 delaunay accordion.mesh.off -o exact.ply --exact --stats statistics.json
claim "s = json('statistics.json')" 's.certified' 's.ties == 1' 's.undecided == 0' 's.is_delaunay'
grep -q 'certified' err && fail "a certified result is nothing to speak of: $(cat err)"
accordion 1,1 2,1 3,-2 4,1 5,-2 6,1 5,-4 7,2 6,-5 8,3 8,-5 9,4 10,-1
expect 0 delaunay accordion.mesh.off -o exact.ply --exact --stats statistics.json
claim "s = json('statistics.json')" 'not s.certified' 's.ties == 0' 's.undecided == 1' \
  'not s.is_delaunay'
says 'not certified; undecided because of too many square roots: 1'
rm exact.ply statistics.json

# Handled, not refused.
expect 0 delaunay isolated.mesh.off -o -
says 'note: isolated vertex: 1'
sed -n 3p out | grep -qx '9 9 9' || fail 'the isolated vertex lost its place'
expect 0 delaunay two_components.mesh.off -o -
expect 0 delaunay cap.mesh.off -o -
expect 0 delaunay zero_length.mesh.off -o - --mollify 1e-6
expect 0 delaunay slivers.mesh.off -o - --constrain-angle 20

expect_files

# What cannot be written is a failure and leaves what was there.
echo old >a.off
mkdir -p full
if [ -w /dev/full ]; then
  result=0
  "$program" delaunay slivers.mesh.off -o - --quiet >/dev/full 2>err || result=$?
  [ "$result" -eq 1 ] || fail "a full device gave $result"
  expect 1 delaunay slivers.mesh.off -o a.off --stats /dev/full
  [ "$(cat a.off)" = old ] || fail 'a failed run replaced a file'
fi
expect_files a.off
rm a.off

[ "$(cksum <slivers.mesh.off)" = "$checksum" ] || fail 'the input was changed'

if [ -n "$data" ]; then
  for mesh in elephant.off cube-ouvert.off degtri_sliding.off sphere.stl colored_tetra.ply; do
    expect 0 delaunay "$data/meshes/$mesh" -o "mesh.ply" --stats mesh.json
    claim "json('mesh.json').is_delaunay"
  done
fi
