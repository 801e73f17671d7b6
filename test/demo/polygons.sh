#!/usr/bin/env bash
# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# Faces of more than three corners are split into triangles, unless --strict is given.
source "$(dirname "${BASH_SOURCE[0]}")/common.bash"

expect 0 delaunay polygon.mesh.off -o a.ply --stats a.json
says 'polygon.mesh.off: note: polygons split into triangles: 1'
claim "a, s = ply('a.ply'), json('a.json')" 'len(a.faces) == 2' "a.face['input_polygon'] == [0, 0]" \
  's.faces == 2' 's.polygons == 1'
expect 0 info polygon.mesh.off
says 'note: face that is not a triangle: 1, first at face 0 - commands split it, unless --strict is given'
expect 0 delaunay good.mesh.off -o b.ply --strict
cp b.ply first
expect 0 delaunay good.mesh.off -o b.ply
cmp b.ply first # and no property "input_polygon"
! grep -q input_polygon b.ply || fail 'triangles are no polygons'
rm a* b* first

# A prism over a star, whose concave lids have a collinear corner; the sides are not planar.
awk 'BEGIN {
  n = 12
  print "OFF\n" 2 * n, n + 2, 0
  for(z = 0; z < 2; ++z)
    for(i = 0; i < n; ++i) {
      a = (i + 0.2 * z) * 6.283185307179586 / n
      r = i % 2 ? 0.4 : 1
      print r * cos(a), r * sin(a), z
    }
  printf "%d", n; for(i = n - 1; i >= 0; --i) printf " %d", i; print ""
  printf "%d", n; for(i = 0; i < n; ++i) printf " %d", n + i; print ""
  for(i = 0; i < n; ++i) print 4, i, (i + 1) % n, n + (i + 1) % n, n + i
}' >star.mesh.off
for command in delaunay refine; do
  expect 0 $command star.mesh.off -o a.ply --stats a.json
  claim "a, s = ply('a.ply'), json('a.json')" 's.faces == 2 * 10 + 12 * 2' 's.polygons == 14' \
    's.euler_characteristic == 2' "set(a.face['input_polygon']) == set(range(14))" \
    "all((p == 0) == (f < 10) for f, p in zip(a.face['input_face'], a.face['input_polygon']))"
done
# The lids keep their area; seen from above, the lower one is clockwise.
claim "a = ply('a.ply')" "near(-fsum(signed_area(a.points, f)
  for f, p in zip(a.faces, a.face['input_polygon']) if p == 0), 12 * 0.5 * 0.4 * sin(pi / 6), 1e-6)"
expect 0 distance star.mesh.off --source 0 -o a.ply
claim "a = ply('a.ply')" 'len(a.faces) == 44' "max(a.face['input_polygon']) == 13"
expect 0 flatten star.mesh.off -o a.ply --cones greedy
claim "set(ply('a.ply').face['input_polygon']) == set(range(14))"
expect 0 simplify star.mesh.off -o a.ply --ratio 0.5
rm a*

# Two squares back to back have no diagonal in common.
off pillow "$square" '0 1 2 3,3 2 1 0'
expect 0 delaunay pillow.mesh.off -o a.ply --stats a.json
claim "json('a.json').euler_characteristic == 2"
# A polygon that crosses itself has no inside: only a repair fills it, with the sides that it has.
off crossing '0 0 0,1 1 0,1 0 0,0 1 0' '0 1 2 3'
off skew '1 4 3,2 3 0,3 0 2,4 4 4,3 1 1' '0 1 2 3 4'
for mesh in crossing skew; do
  refuses "$mesh.mesh.off: face 0 crosses or touches itself, seen along every axis" \
    delaunay $mesh.mesh.off -o b.ply
  expect 0 delaunay $mesh.mesh.off -o a.ply --repair --stats a.json
  says "$mesh.mesh.off: note: polygons split into triangles: 1"
  claim "a, s = ply('a.ply'), json('a.json')" 's.polygons == 1' 's.vertices == s.faces + 2' \
    "a.face['input_polygon'] == [0] * s.faces" \
    'sides = {(f[i], f[(i + 1) % 3]) for f in a.faces for i in range(3)}' \
    'all((v, (v + 1) % s.vertices) in sides for v in range(s.vertices))'
done
off two '0 0 0,1 1 0' '0 1'
expect 2 delaunay two.mesh.off -o b.ply
off twice "$square,0 0 1" '0 1 2 3,0 1 1 4'
refuses 'face with a repeated vertex: 1, first at face 1' delaunay twice.mesh.off -o b.ply
rm a*

# Soups may have polygons too.
off book "$square,0 0 1,1 0 1,0 0 -1,1 0 -1" '0 1 2 3,0 1 5 4,1 0 6 7'
expect 0 operators book.mesh.off --prefix a --stats a.json
claim "s = json('a.json')" 's.polygons == 3' 's.tufted' 's.faces == 6' \
  "near(fsum(mtx('a_lumped_mass.mtx') @ ([1] * 8)), 3, 1e-14)"
refuses 'non-manifold edge: 1, first between vertices 0 and 1 (face 0); --repair makes it a surface' \
  delaunay book.mesh.off -o b.ply
expect 0 delaunay book.mesh.off -o b.ply --repair
claim "sorted(ply('b.ply').face['input_polygon']) == [0, 0, 1, 1, 2, 2]"
rm a* b*

# Three square pages of 20 x 20 quadrangles on a common spine: distances within each page.
awk 'BEGIN {
  n = 20
  print "OFF\n" (n + 1) * (3 * n + 1), 3 * n * n, 0
  for(j = 0; j <= n; ++j)
    for(i = 0; i <= 3 * n; ++i) {
      page = i ? int((i - 1) / n) : 0
      r = i ? (i - page * n) / n : 0
      a = page * 2.0943951023931953
      print r * cos(a), r * sin(a), j / n
    }
  for(page = 0; page < 3; ++page)
    for(j = 0; j < n; ++j)
      for(i = 0; i < n; ++i) {
        inner = j * (3 * n + 1) + (i ? page * n + i : 0)
        outer = j * (3 * n + 1) + page * n + i + 1
        print 4, inner, outer, outer + 3 * n + 1, inner + 3 * n + 1
      }
}' >pages.mesh.off
expect 0 distance pages.mesh.off --source 0 -o a.ply
claim "a = ply('a.ply')" 'len(a.faces) == 2400' "max(a.face['input_polygon']) == 1199" \
  "e = [abs(d - hypot(*p)) for d, p in zip(a.vertex['distance'], a.points)]" \
  'max(e) < 0.1' 'fsum(e) / len(e) < 0.02'
rm a*
expect_files

if [ -n "$data" ]; then
  for mesh in cube_quad.off quads_to_stitch.off torus_quad.off; do
    expect 0 delaunay "$data/meshes/$mesh" -o a.ply
    expect 2 delaunay "$data/meshes/$mesh" -o a.ply --strict
  done
fi
