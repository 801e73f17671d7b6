#!/usr/bin/env bash
# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# Hyperbolic metrics, flat tori and cylinders: files, statistics and exit codes of the commands
# hyperbolic and uniformize.
source "$(dirname "${BASH_SOURCE[0]}")/common.bash"

pi=3.14159265358979324

# plate NAME HOLES: unit cubes, three rows of 2 HOLES + 1, those in the middle of the second,
# fourth, ... column left out.
plate()
{
  awk -v holes="$2" '
    function full(x, y, z) {
      return z == 0 && y >= 0 && y < 3 && x >= 0 && x < 2 * holes + 1 && !(x % 2 == 1 && y == 1)
    }
    function corner(x, y, z,   key) {
      key = x " " y " " z
      if(!(key in seen)) { seen[key] = n++; point[n - 1] = key }
      return seen[key]
    }
    function add(a, b, c, d) { face[m++] = a " " b " " c; face[m++] = a " " c " " d }
    function side(x, y, dx, dy, dz,   a, b, c, d) {
      if(full(x + dx, y + dy, dz)) return
      if(dx) { x += dx > 0; a = corner(x, y, 0); b = corner(x, y + 1, 0); c = corner(x, y + 1, 1); d = corner(x, y, 1) }
      else if(dy) { y += dy > 0; a = corner(x, y, 0); b = corner(x, y, 1); c = corner(x + 1, y, 1); d = corner(x + 1, y, 0) }
      else { a = corner(x, y, dz > 0); b = corner(x + 1, y, dz > 0); c = corner(x + 1, y + 1, dz > 0); d = corner(x, y + 1, dz > 0) }
      if(dx + dy + dz > 0) add(a, b, c, d); else add(a, d, c, b)
    }
    BEGIN {
      for(x = 0; x < 2 * holes + 1; ++x)
        for(y = 0; y < 3; ++y)
          if(full(x, y, 0)) {
            side(x, y, 1, 0, 0); side(x, y, -1, 0, 0); side(x, y, 0, 1, 0); side(x, y, 0, -1, 0)
            side(x, y, 0, 0, 1); side(x, y, 0, 0, -1)
          }
      print "OFF\n" n, m, 0
      for(i = 0; i < n; ++i) print point[i]
      for(i = 0; i < m; ++i) print 3, face[i]
    }' >"$1.mesh.off"
}

# Closed surfaces: the area is that of Gauss and Bonnet.
for holes in 2 3; do
  plate plate$holes $holes
  expect 0 hyperbolic plate$holes.mesh.off -o plate.obj --svg plate.svg --tiles 2 --stats plate.json
  claim "s = json('plate.json')" "s.status == 'success'" 's.flipped_triangles == 0' \
    "s.groups[0].genus == $holes" 'near(s.max_curvature_error, 0, 1e-10)' \
    'near(s.max_gluing_error, 0, 1e-8)' 'near(s.groups[0].relation_error, 0, 1e-8)' \
    "near(s.area, 4 * pi * ($holes - 1), 1e-9)"
  # the domain and its neighbors, all in the disk
  [ "$(grep -c 'class="t0"' plate.svg)" = 1 ] || fail "no domain"
  [ "$(grep -c 'class="t1"' plate.svg)" -ge $((4 * holes)) ] || fail "too few images"
  claim "all(hypot(*z) < 1 for z in obj('plate.obj').texture)"
done
expect_files plate.json plate.obj plate.svg
cp plate.obj first.obj

# A hundred handles in a row are not too many for 115 digits, two hundred are.
plate plate100 100
expect 0 hyperbolic plate100.mesh.off -o large.obj --stats large.json
claim "s = json('large.json')" "s.max_gluing_error <= 1e-9"
rm large.*
plate plate200 200
expect 1 hyperbolic plate200.mesh.off -o large.obj --stats large.json
says 'the faces do not close up in the hyperbolic plane: not_glued'
expect 1 uniformize plate200.mesh.off -o large.obj
says 'not_glued'
says 'try '
[ ! -e large.obj ] && [ ! -e large.json ] || fail 'files after a failure'
expect 0 hyperbolic plate3.mesh.off -o plate.obj
cmp plate.obj first.obj

# The same with homogeneous coordinates; the quotients are in Klein's disk.
expect 0 hyperbolic plate2.mesh.off -o - --format obj --homogeneous
claim "all(w > 0 and hypot(u / w, v / w) < 1 for u, v, w in obj('out').texture)"

# A vertex without faces stays, and changes nothing else.
with_isolated plate2 more
expect 0 hyperbolic more.mesh.off -o plate.obj --stats plate.json
[ "$(head -n 1 plate.obj)" = 'v 9 9 9' ] || fail 'the isolated vertex lost its place'
claim "s = json('plate.json')" "near(s.area, 4 * pi, 1e-9)" 'near(s.max_curvature_error, 0, 1e-10)'

# A regular tetrahedron with four cones of pi / 2 has the area 2 pi; without cones it cannot be
# hyperbolic.
off regular '1 1 1,1 -1 -1,-1 1 -1,-1 -1 1' '0 1 2,0 2 3,0 3 1,1 3 2'
for v in 0 1 2 3; do echo "$v $(awk -v pi=$pi 'BEGIN { printf "%.17g", 1.5 * pi }')"; done >cones.mesh.txt
expect 0 hyperbolic regular.mesh.off -o plate.obj --cones cones.mesh.txt --stats plate.json
claim "near(json('plate.json').area, 2 * pi, 1e-9)"
expect 2 hyperbolic regular.mesh.off -o plate.obj
says 'Gauss-Bonnet'
expect 2 hyperbolic plate2.mesh.off -o plate.off
says 'cannot carry texture coordinates'

# A torus of revolution with many points: its modulus is near i sqrt(3^2 - 1).
awk -v m=80 -v n=40 -v pi=$pi 'BEGIN {
  print "OFF\n" m * n, 2 * m * n, 0
  for(i = 0; i < m; ++i)
    for(j = 0; j < n; ++j) {
      r = 3 + cos(2 * pi * j / n)
      print r * cos(2 * pi * i / m), r * sin(2 * pi * i / m), sin(2 * pi * j / n)
    }
  for(i = 0; i < m; ++i)
    for(j = 0; j < n; ++j) {
      a = i * n + j; b = (i + 1) % m * n + j; c = (i + 1) % m * n + (j + 1) % n; d = i * n + (j + 1) % n
      print 3, a, b, c "\n" 3, a, c, d
    }
}' >torus.mesh.off
expect 0 uniformize torus.mesh.off -o plate.obj --stats plate.json
claim "s = json('plate.json')" "s.surface_type == 'torus'" 'near(s.modulus[0], 0, 1e-9)' \
  'near(s.modulus[1], sqrt(8), 0.02)'

# A cylinder, a disk, and what is hyperbolic.
awk -v n=12 -v pi=$pi -v OFMT=%.17g 'BEGIN {
  print "OFF\n" 3 * n, 4 * n, 0
  for(j = 0; j < 3; ++j)
    for(i = 0; i < n; ++i) print cos(2 * pi * i / n), sin(2 * pi * i / n), j / 2
  for(j = 0; j < 2; ++j)
    for(i = 0; i < n; ++i) {
      a = j * n + i; b = j * n + (i + 1) % n
      print 3, a, b, b + n "\n" 3, a, b + n, a + n
    }
}' >cylinder.mesh.off
expect 0 uniformize cylinder.mesh.off -o plate.obj --stats plate.json
claim "s = json('plate.json')" "s.surface_type == 'annulus'" 's.modulus[0] == 0' \
  'near(s.modulus[1], 1 / (24 * sin(pi / 12)), 1e-9)'
off square '0 0 0,1 0 0,1 1 0,0 1 0,0.4 0.5 0' '0 1 4,1 2 4,2 3 4,3 0 4'
expect 0 uniformize square.mesh.off -o plate.obj --stats plate.json
# A disk becomes a hemisphere, whose texture is the unit disk.
claim "s = json('plate.json')" "s.surface_type == 'disk'" 's.disk and s.convex' \
  "m = obj('plate.obj')" 'near([hypot(*p) for p in m.points], [1] * len(m.points), 1e-14)' \
  'all(p[2] >= 0 for p in m.points) and all(hypot(*z) < 1 + 1e-14 for z in m.texture)' \
  'sum(p[2] == 0 for p in m.points) >= 4'
expect 0 uniformize plate2.mesh.off -o plate.obj --svg plate.svg --stats plate.json
claim "s = json('plate.json')" "s.surface_type == 'hyperbolic'" 'len(s.groups[0].generators) > 0'
expect 0 uniformize regular.mesh.off -o plate.obj --stats plate.json
claim "json('plate.json').surface_type == 'sphere'"
expect 2 uniformize torus.mesh.off -o plate.obj --svg plate.svg
says 'hyperbolic surfaces'
expect_files first.obj plate.json plate.obj plate.svg
