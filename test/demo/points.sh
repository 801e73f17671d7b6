#!/usr/bin/env bash
# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# Clouds of points: operators and distance triangulate each point with its neighbors.
source "$(dirname "${BASH_SOURCE[0]}")/common.bash"

# sphere N: a spiral of points on the unit sphere, with something behind each.
sphere()
{
  awk -v n="$1" 'BEGIN {
    for(i = 0; i < n; ++i) {
      z = 1 - (2 * i + 1) / n
      r = sqrt(1 - z * z)
      a = i * 3.141592653589793 * (3 - sqrt(5))
      printf "%.17g %.17g %.17g%s\n", r * cos(a), r * sin(a), z, i % 2 ? " 0 0 1" : ""
    }
  }'
}

{ echo '# a cloud'; sphere 1000; } >cloud.mesh.xyz
{ printf 'OFF\n1000 0 0\n'; sphere 1000 | cut -d' ' -f1-3; } >cloud.mesh.off
{
  printf 'ply\nformat ascii 1.0\nelement vertex 1000\n'
  printf 'property double %s\n' x y z
  echo end_header
  sphere 1000 | cut -d' ' -f1-3
} >cloud.mesh.ply
for format in xyz off ply; do
  expect 0 operators cloud.mesh.$format --neighbors 20 --prefix a --stats a.json
  says "cloud.mesh.$format: note: no faces, so the points are triangulated with their neighbors"
  claim "s = json('a.json')" 's.tufted' 's.neighbors == 20' 's.vertices == 1000' 's.is_delaunay' \
    'one = [1] * 1000' "near(mtx('a_laplacian.mtx') @ one, [0] * 1000, 1e-12)" \
    "abs(fsum(mtx('a_mass.mtx') @ one) - 4 * pi) < 0.1" \
    "near(mtx('a_divergence.mtx') @ (mtx('a_gradient.mtx') @ one), [0] * 1000, 1e-10)"
  cp a_laplacian.mtx first.$format
done
cmp first.xyz first.off
cmp first.xyz first.ply
rm a* first*

expect 0 distance cloud.mesh.xyz --neighbors 20 --source 0 -o a.ply
claim "a = ply('a.ply')" 'len(a.points) == 1000' 'a.faces == []' \
  'chords = [dist(a.points[0], p) for p in a.points]' \
  'truth = [2 * atan2(d, sqrt(max(0, 4 - d * d))) for d in chords]' \
  "sum(abs(d - t) for d, t in zip(a.vertex['distance'], truth)) <= 0.03 * sum(truth)"
rm a*

# Meshes are no clouds, and clouds must be asked for.
expect 0 distance good.mesh.off --neighbors 20 --source 0 -o a.ply
cp a.ply first
expect 0 distance good.mesh.off --source 0 -o a.ply
cmp a.ply first
rm a* first
refuses 'has no faces' operators cloud.mesh.off --prefix a
refuses 'triangulate points with --neighbors 30' operators cloud.mesh.xyz --prefix a
printf '0 0 0\n1 0 x\n' >wrong.mesh.xyz
refuses 'line 2 cannot be understood' operators wrong.mesh.xyz --prefix a --neighbors 5
: >nothing.mesh.xyz
expect 2 operators nothing.mesh.xyz --prefix a --neighbors 5
expect_files

# Copies of points would count as neighbors.
printf '0 0 0\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n' >copies.mesh.xyz
refuses 'copies.mesh.xyz: points 0 and 1 are at the same position; --repair merges such points' \
  distance copies.mesh.xyz --neighbors 3 --source 0 -o a.ply
expect 0 distance copies.mesh.xyz --neighbors 3 --source 0 -o a.ply --repair
says 'repaired: points merged with an equal one: 1'
claim "near(sorted(ply('a.ply').vertex['distance']), [0, 1, 1, 2 ** .5], 0.2)"
rm a.ply
