#!/usr/bin/env bash
# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# Points and functions across, and what the command transfer refuses.
source "$(dirname "${BASH_SOURCE[0]}")/common.bash"

cp "$shipped" slivers.mesh.off
grid sheared 20 2

printf '# points\n0\n7:0.2,0.3,0.5\n1.17,0.43,0 # near\n\n12:0.5,0.5,0\n' >points.mesh.txt
for options in "" "--min-angle 30" "--exact"; do
  expect 0 transfer sheared.mesh.off --points points.mesh.txt -o a.txt --stats a.json $options
  claim "s = json('a.json')" 's.points == 4' 's.greatest_error_there_and_back < 1e-12' 's.is_delaunay'
  [ "$(wc -l <a.txt)" = 4 ] || fail "not four lines: $(cat a.txt)"
  expect 0 transfer sheared.mesh.off --points a.txt --back -o b.txt --stats b.json $options
  claim "s = json('b.json')" 's.points == 4' 's.greatest_error_there_and_back < 1e-12'
  # places inside faces are the old ones up to rounding; others may be seen from another face
  claim "lines = [[[float(x) for x in w.replace(':', ',').split(',')] for l in open(f) for w in l.split()]
    for f in ('a.txt', 'b.txt')]" \
    'all(near(lines[0][i], lines[1][i], 1e-9) for i in (2, 4))' 'len(lines[0]) == 8' \
    'all(near(lines[0][i], lines[1][i], 1e-12) for i in (1, 3, 5, 7))' \
    'lines[0][2] == [7, 0.2, 0.3, 0.5]'
done
rm a.* b.*

# A function that is linear in the plane is linear on both triangulations, and comes back.
awk 'NR > 2 && NF == 3 { print NR - 3, 3 * $1 - 2 * $2 + 1 }' sheared.mesh.off >values.mesh.txt
for options in "" "--min-angle 30"; do
  expect 0 transfer sheared.mesh.off --data values.mesh.txt -o a.txt --stats a.json \
    --save a.save --view a.html $options
  claim "s = json('a.json')" 's.greatest_error_there_and_back < 1e-9' \
    'near(s.integral, s.transferred_integral, 1e-9)' 's["values"] == 441'
  claim "a, b = (dict(map(float, l.split()) for l in open(f)) for f in ('a.txt', 'values.mesh.txt'))" \
    'all(near(a[v], b[v], 1e-9) for v in b)' 'len(a) >= len(b)'
  expect 0 transfer sheared.mesh.off --data a.txt --back -o b.txt $options
  claim "a, b = (dict(map(float, l.split()) for l in open(f)) for f in ('b.txt', 'values.mesh.txt'))" \
    'a.keys() == b.keys()' 'all(near(a[v], b[v], 1e-9) for v in b)'
done
rm a.* b.*

# Any function keeps its integral.
awk 'NR == 2 { for(v = 0; v < $1; ++v) print v, (v * 7919) % 101 }' slivers.mesh.off >any.mesh.txt
expect 0 transfer slivers.mesh.off --data any.mesh.txt -o - --stats a.json
claim "s = json('a.json')" 'near(s.integral, s.transferred_integral, 1e-9 * abs(s.integral))'
rm a.*

# Wrong calls.
refuses 'give --points or --data, and not both' transfer sheared.mesh.off -o a.txt
expect 2 transfer sheared.mesh.off --points points.mesh.txt --data values.mesh.txt -o a.txt
refuses 'nothing.txt: no such file' transfer sheared.mesh.off --points nothing.txt -o a.txt
printf '99999\n' >wrong.mesh.txt
refuses "'99999' is not a point of the mesh" transfer sheared.mesh.off --points wrong.mesh.txt -o a.txt
printf '0,0,99\n' >wrong.mesh.txt
expect 2 transfer sheared.mesh.off --points wrong.mesh.txt -o a.txt
refuses 'give FACE:a,b,c' transfer sheared.mesh.off --points wrong.mesh.txt --back -o a.txt
# Words behind a point are no part of it.
for line in '1.0 0.2 0.3' '0.1, 0.2, 0.3' '60 abc' '3:0.2,0.3,0.5 junk' '0 1 1' '1.0' '1e0'; do
  printf '# points\n0\n%s\n' "$line" >wrong.mesh.txt
  refuses 'wrong.mesh.txt: line 3: ' transfer sheared.mesh.off --points wrong.mesh.txt -o a.txt
done
expect_files
