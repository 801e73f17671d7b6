#!/usr/bin/env bash
# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# Circle packings: the files, statistics and exit codes of the command pack.
source "$(dirname "${BASH_SOURCE[0]}")/common.bash"

# The four circles of a tetrahedron are equal.
expect 0 pack good.mesh.off -o good.ply --circles good.svg --stats good.json
says '4 circles on the sphere'
claim "s = json('good.json')" 'not s.disk' "s.status == 'success'" 's.max_tangency_error < 1e-10'
claim "near(list(ply('good.ply').vertex['radius']), [0.9553166181245093] * 4, 1e-10)"
[ "$(grep -c '<circle' good.svg)" -eq 4 ] || fail 'a circle is missing'
rm good.ply good.svg good.json

# The picture of a sphere shows no circle beyond its sides: large circles are cut off, and circles
# outside are left out.
awk 'BEGIN {
  n = 16; m = 15; pi = atan2(0, -1)
  print "OFF\n" n * m + 2, 2 * n * m, 0
  for(j = 1; j <= m; ++j)
    for(i = 0; i < n; ++i) {
      a = pi * j / (m + 1); b = 2 * pi * (i + j / 2) / n
      print sin(a) * cos(b), sin(a) * sin(b), cos(a)
    }
  print "0 0 1\n0 0 -1"
  for(i = 0; i < n; ++i) {
    k = (i + 1) % n
    print 3, n * m, i, k "\n" 3, n * m + 1, n * (m - 1) + k, n * (m - 1) + i
    for(j = 0; j < m - 1; ++j)
      print 3, n * j + i, n * (j + 1) + i, n * j + k "\n" 3, n * j + k, n * (j + 1) + i, n * (j + 1) + k
  }
}' >ball.mesh.off
expect 0 pack ball.mesh.off -o ball.ply --circles ball.svg
python3 - <<'PYTHON' || fail 'circles are drawn beyond the picture'
import re
from math import hypot
text = open("ball.svg").read()
circles = [tuple(map(float, c)) for c in re.findall(r'cx="(.*?)" cy="(.*?)" r="(.*?)"', text)]
assert 'clip-path="url(#c)"' in text and 100 < len(circles) < 242, len(circles)
for x, y, r in circles:
    assert hypot(max(0, -x, x - 1000), max(0, -y, y - 1000)) <= r
PYTHON
rm ball.ply ball.svg

# Circles of a disk touch the unit circle, which is drawn, too.
off hexagon '0 0 0,2 0 0,1 2 0,-1 2 0,-2 0 0,-1 -2 0,1 -2 0' \
  '0 1 2,0 2 3,0 3 4,0 4 5,0 5 6,0 6 1'
expect 0 pack hexagon.mesh.off -o hexagon.ply --circles hexagon.svg --stats hexagon.json
says '7 circles in the disk'
claim "json('hexagon.json').disk" \
  "near(list(ply('hexagon.ply').vertex['radius']), [1 / 3] * 7, 1e-10)"
[ "$(grep -c '<circle' hexagon.svg)" -eq 8 ] || fail 'a circle is missing'
# The same as PNG.
if "$program" pack hexagon.mesh.off -o hexagon.ply --circles hexagon.png 2>err; then
  claim "w, h, pixels = png('hexagon.png')" 'w == h == 2000' 'len(pixels) == h * (3 * w + 1)' \
    'len(set(pixels)) > 1'
  rm hexagon.png
else
  says 'built without Cairo'
fi
rm hexagon.ply hexagon.svg hexagon.json

refuses 'circles are packed on spheres and disks' pack two_components.mesh.off -o x.off

# In nested triangles, circles shrink by a constant factor: no positions are good enough.
awk 'BEGIN {
  n = 404
  print "OFF\n" n, 2 * n - 4, 0
  for(v = 0; v < n; ++v) print v, v * v % 53, v * 7 % 31
  print "3 0 2 1\n3 1 2 3\n3 2 0 3"
  a = 0; b = 1; c = 3
  for(v = 4; v < n; ++v) {
    if(v % 3 == 0) { print 3, b, c, v "\n" 3, c, a, v; c = v }
    if(v % 3 == 1) { print 3, c, a, v "\n" 3, a, b, v; a = b; b = c; c = v }
    if(v % 3 == 2) { print 3, a, b, v "\n" 3, b, c, v; b = a; a = c; c = v }
  }
  print 3, a, b, c
}' >nested.mesh.off
expect 1 pack nested.mesh.off -o nested.ply
says 'circles do not touch: '
expect_files

# Positions do not matter.
off point '0 0 0,0 0 0,0 0 0,0 0 0' '0 2 1,0 1 3,1 2 3,2 0 3'
off huge '0 0 0,1e100 0 0,0 1e100 0,0 0 1e100' '0 2 1,0 1 3,1 2 3,2 0 3'
for mesh in point huge; do
  expect 0 pack $mesh.mesh.off -o a.ply
  claim "near(list(ply('a.ply').vertex['radius']), [0.9553166181245093] * 4, 1e-10)"
done
rm a.ply
off isolated '0 0 0,1 0 0,0 1 0,0 0 1,5 5 5' '0 2 1,0 1 3,1 2 3,2 0 3'
refuses 'isolated.mesh.off: vertex 4 has no face; --repair removes such vertices' pack isolated.mesh.off -o a.ply
refuses 'isolated.mesh.off: vertex 4 has no face; --repair removes such vertices' convex isolated.mesh.off -o a.ply
expect_files
