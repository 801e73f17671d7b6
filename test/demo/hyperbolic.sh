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

# join A B: both meshes as components of one.
join()
{
  awk 'FNR == 2 { n[++file] = $1; faces += $2 }
    FNR > 2 { if(FNR - 2 <= n[file]) point[++points] = $0
      else face[++m] = $1 " " $2 + from " " $3 + from " " $4 + from }
    FNR == 2 && file == 2 { from = n[1] }
    END {
      print "OFF\n" points, m, 0
      for(i = 1; i <= points; ++i) print point[i]
      for(i = 1; i <= m; ++i) print face[i]
    }' "$1" "$2"
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
says 'the faces do not close up in the hyperbolic plane (not_glued)'
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
refuses 'the surface is a sphere, which is hyperbolic only with cones: use uniformize' \
  hyperbolic regular.mesh.off -o plate.obj
with_isolated regular lonely
refuses 'the surface is a sphere' hyperbolic lonely.mesh.off -o plate.obj
off disks '9 9 9,0 0 0,1 0 0,0 1 0,2 0 0,3 0 0,2 1 0' '1 2 3,4 5 6'
refuses 'the component of vertex 1 is a disk' hyperbolic disks.mesh.off -o plate.obj
for v in 0 1 2 3; do echo "$v 1"; done >few.mesh.txt
refuses 'its area would be -8.56637 (Gauss-Bonnet)' \
  hyperbolic regular.mesh.off -o plate.obj --cones few.mesh.txt

# Its circles that touch at midpoints still do so: by symmetry, radii are half of the side of a
# regular triangle with three angles of pi / 6.
for v in 0 1 2 3; do echo "$v $(awk 'BEGIN { printf "%.17g", sqrt(2) }')"; done >circles.mesh.txt
expect 0 hyperbolic regular.mesh.off -o plate.ply --cones cones.mesh.txt --radii circles.mesh.txt
claim "r = list(ply('plate.ply').vertex['radius'])" \
  'near(r[:4], [acosh(1 / (2 * sin(pi / 12)))] * 4, 1e-10)'
# Radii of zero leave the bytes.
awk '{ print $1, 0 }' circles.mesh.txt >zeros.mesh.txt
expect 0 hyperbolic plate2.mesh.off -o plate.ply
expect 0 hyperbolic plate2.mesh.off -o zero.ply --radii zeros.mesh.txt
cmp plate.ply zero.ply
for v in $(seq 0 3 40); do echo "$v 0.4"; done >circles.mesh.txt
expect 0 hyperbolic plate2.mesh.off -o plate.ply --radii circles.mesh.txt --stats plate.json
claim "s = json('plate.json')" 'near(s.area, 4 * pi, 1e-9)' "p = ply('plate.ply').vertex" \
  "u, r = [list(p[k]) for k in ('log_scale', 'radius')]" "n = sum(x > 0 for x in r)" 'n == 14' \
  'near(r[:41:3], [atanh(0.8 * exp(x)) for x in u[:41:3]], 1e-12)'
expect 0 uniformize plate2.mesh.off -o zero.ply --radii circles.mesh.txt
cmp plate.ply zero.ply
# Circles of a tetrahedron that touch do so on the sphere.
for v in 0 1 2 3; do echo "$v $(awk 'BEGIN { printf "%.17g", sqrt(2) }')"; done >touching.mesh.txt
for command in sphere uniformize; do
  expect 0 $command regular.mesh.off --radii touching.mesh.txt -o plate.ply
  claim "near(list(ply('plate.ply').vertex['radius'])[:4], [acos(-1 / 3) / 2] * 4, 1e-12)"
done
rm zero.ply plate.ply

# A component with boundary has its own genus and area, not those of its double: with geodesic
# boundaries, 2 pi (2 genus - 2 + boundaries), by Gauss and Bonnet.
awk 'NR == 2 { $2 -= 2; n = $1 } NR == n + 6 || NR == n + 43 { next } { print }' plate2.mesh.off \
  >punctured.mesh.off
expect 0 hyperbolic punctured.mesh.off -o plate.obj --stats plate.json
claim "s = json('plate.json')" "g = s.groups[0]" '(g.genus, g.boundary_loops) == (2, 2)' \
  'near(g.area, 8 * pi, 1e-9) and near(s.area, 8 * pi, 1e-9)' 'g.genus_of_double == 5' \
  'len(g.generators) == 10'
# a square without two of its cells
awk 'function full(x, y) { return !(y == 1 && (x == 1 || x == 3)) }
  BEGIN {
    for(y = 0; y < 3; ++y) for(x = 0; x < 5; ++x) m += 2 * full(x, y)
    print "OFF\n24", m, 0
    for(y = 0; y < 4; ++y) for(x = 0; x < 6; ++x) print x, y, 0
    for(y = 0; y < 3; ++y)
      for(x = 0; x < 5; ++x)
        if(full(x, y)) { a = 6 * y + x; print 3, a, a + 1, a + 7 "\n" 3, a, a + 7, a + 6 }
  }' >pants.mesh.off
for command in hyperbolic uniformize; do
  expect 0 $command pants.mesh.off -o plate.obj --stats plate.json
  claim "s = json('plate.json')" "g = s.groups[0]" \
    '(g.genus, g.boundary_loops, g.genus_of_double) == (0, 3, 2)' \
    'near(g.area, 2 * pi, 1e-9) and near(s.area, 2 * pi, 1e-9)'
done

# The errors of relations are those of what is written, here in fractions: of the generators in
# numbers of type double, and of those with more digits.
plate plate16 16
expect 0 hyperbolic plate16.mesh.off -o plate.obj --stats plate.json
python3 - <<'PYTHON' || fail 'relation errors'
import json
from fractions import Fraction
def error(generators, relation):
  def times(x, y):
    (p, q, r, s), (t, u, v, w) = x, y
    return (p * t - q * u + r * v + s * w, p * u + q * t + s * v - r * w,
            p * v - q * w + r * t + s * u, p * w + q * v + s * t - r * u)
  product = (1, 0, 0, 0)
  for i in relation:
    a, b, c, d = map(Fraction, generators[abs(i) - 1])
    product = times(product, (a, b, c, d) if i > 0 else (a, -b, -c, -d))
  return float(max(abs(abs(product[0]) - 1), *map(abs, product[1:])))
group = json.load(open('plate.json'))['groups'][0]
rounded = error(group['generators'], group['relation'])
precise = error(group['precise_generators'], group['relation'])
assert abs(rounded - group['relation_error']) <= 1e-9 * rounded, (rounded, group['relation_error'])
stated = group['precise_relation_error']
assert precise <= 1e-9 and abs(precise - stated) <= 1e-6 * precise, (precise, stated)
PYTHON

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

# Circles on it are mapped as by flatten. Beside another component they keep their vertices.
for v in $(seq 0 2 3199); do echo "$v 0.03"; done >circles.mesh.txt
expect 0 uniformize torus.mesh.off -o a.ply --radii circles.mesh.txt --stats plate.json
expect 0 flatten torus.mesh.off -o b.ply --radii circles.mesh.txt --cones none
claim "near(json('plate.json').modulus[0], 0, 1e-9)" \
  "a, b = [list(ply(f).vertex['radius']) for f in ('a.ply', 'b.ply')]" 'a == b' \
  'near([x > 0 for x in a[:4]], [1, 0, 1, 0], 0)'
join regular.mesh.off torus.mesh.off >both.mesh.off
awk '{ print $1 + 4, $2 }' circles.mesh.txt >moved.mesh.txt
expect 0 uniformize both.mesh.off -o b.ply --radii moved.mesh.txt
claim "a, b = [list(ply(f).vertex['radius']) for f in ('a.ply', 'b.ply')]" 'b[:4] == [0] * 4' \
  'near(b[4:3204], a[:3200], 1e-12)'
rm a.ply b.ply

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

# Options that are not for a surface are refused, and what hyperbolic and sphere cannot do names
# the command that can.
refused() { refuses "$@" -o refused.obj; }
for flat in torus cylinder; do
  refused '--svg is for hyperbolic surfaces' uniformize $flat.mesh.off --svg refused.svg
  refused '--tiles is for hyperbolic surfaces' uniformize $flat.mesh.off --tiles 2 --view a.html
done
for round in square regular; do
  refused '--svg is for hyperbolic surfaces' uniformize $round.mesh.off --svg refused.svg
  refused '--homogeneous is for flat and hyperbolic surfaces' \
    uniformize $round.mesh.off --homogeneous
done
refused 'the surface is a disk, which' hyperbolic square.mesh.off
refused 'the surface is a torus, which is hyperbolic only with cones: use uniformize' \
  hyperbolic torus.mesh.off
refused 'the surface is an annulus, which' hyperbolic cylinder.mesh.off
refused 'the surface is a torus, neither a sphere nor a disk: use uniformize' sphere torus.mesh.off
refused 'the surface is an annulus, neither' sphere cylinder.mesh.off
refused 'the surface is a surface of genus 2 with 2 boundaries, neither' sphere punctured.mesh.off
refused '--boundary straight: the mesh has no boundary' flatten torus.mesh.off --boundary straight
expect_files first.obj plate.json plate.obj plate.svg
