#!/usr/bin/env bash
# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# Matrices, their files and exit codes of the command operators.
source "$(dirname "${BASH_SOURCE[0]}")/common.bash"

matrices=({connection_laplacian,divergence,gradient,laplacian,lumped_mass,mass}.mtx)

# The triangle with sides 3, 4 and 5 has the cotangents 0, 3/4 and 4/3 and the area 6. The file must
# have the nearest numbers to the last digit.
off triangle '0 0 0,4 0 0,0 3 0' '0 1 2'
expect 0 operators triangle.mesh.off --prefix t --quiet
[ ! -s out ] && [ ! -s err ] || fail "not quiet: $(cat out err)"
expect_files "${matrices[@]/#/t_}"
cmp t_lumped_mass.mtx - <<'TEXT'
%%MatrixMarket matrix coordinate real symmetric
3 3 3
1 1 2
2 2 2
3 3 2
TEXT
cmp t_mass.mtx - <<'TEXT'
%%MatrixMarket matrix coordinate real symmetric
3 3 6
1 1 1
2 1 0.5
3 1 0.5
2 2 1
3 2 0.5
3 3 1
TEXT
claim "m = mtx('t_laplacian.mtx').stored" 'm[1, 0] == -0.375' 'm[2, 0] == -2 / 3'
grep -qx '%%MatrixMarket matrix coordinate complex hermitian' t_connection_laplacian.mtx
rm t_*

# On the flat square, areas and derivatives of polynomials are known.
n=20
grid grid $n 0
expect 0 operators grid.mesh.off --prefix g --save g.save --stats g.json
expect_files g.json g.save "${matrices[@]/#/g_}"

# names of what the claims below are about
square="m = off('grid.mesh.off')" laplacian="laplacian = mtx('g_laplacian.mtx')"
gradient="gradient = mtx('g_gradient.mtx')" lumped="lumped = mtx('g_lumped_mass.mtx')"
x2='x2 = [p[0] ** 2 for p in m.points]'

# Rounding of sums of a few numbers below five.
claim "$square" "$laplacian" "$lumped" 'one = [1] * len(m.points)' \
  'near(laplacian @ one, [0] * len(one), 1e-14)' \
  "near(mtx('g_mass.mtx') @ one, lumped @ one, 1e-14)" \
  "near(fsum(mtx('g_mass.mtx') @ one), 1, 1e-12)"

# x^2 has the Laplacian 2, which the five points around a vertex get right.
claim "$square" "$laplacian" "$lumped" "$x2" 'areas = lumped @ ([1] * len(x2))' \
  'r = [l + 2 * a for l, a, p in zip(laplacian @ x2, areas, m.points) if 0 < min(p[:2]) and max(p[:2]) < 1]' \
  "len(r) == ($n - 1) ** 2" 'near(r, [0] * len(r), 1e-14)'

# The gradient of 3 x + 4 y has the length 5; divergence and gradient make the Laplacian.
claim "$square" "$laplacian" "$gradient" "$x2" \
  'g = gradient @ [3 * p[0] + 4 * p[1] for p in m.points]' "len(g) == 4 * $n ** 2" \
  'near([hypot(*g[i:i + 2]) for i in range(0, len(g), 2)], [5] * (len(g) // 2), 1e-12)' \
  "near(mtx('g_divergence.mtx') @ (gradient @ x2), [-y for y in laplacian @ x2], 1e-14)"

# Where no two vertices have two edges, the entries of the connection Laplacian have the absolute
# values of those of the Laplacian, at the same places. It is Hermitian.
claim "$laplacian" "connection = mtx('g_connection_laplacian.mtx')" \
  'list(laplacian.stored) == list(connection.stored)' \
  'near(map(abs, laplacian.stored.values()), map(abs, connection.stored.values()), 1e-14)' \
  'all(z.imag == 0 for (i, j), z in connection.stored.items() if i == j)'

# Triangles are lower, and the header tells the entries.
for matrix in g_*.mtx; do
  claim "m = mtx('$matrix')" 'm.has_right_size' \
    "m.header.endswith('general') or all(i >= j for i, j in m.stored)"
done
claim "sum(not mtx(f'g_{m}.mtx').header.endswith('general')
  for m in ('connection_laplacian', 'laplacian', 'lumped_mass', 'mass')) == 4"

has_keys g.json $surface_keys flips $edge_keys matrices seconds read build flip write peak_memory_bytes
claim "'g_mass.mtx' in json('g.json').matrices"
rm g_* g.*

# The weights of a closed Delaunay triangulation are not negative, up to rounding.
cp "$shipped" slivers.mesh.off
expect 0 operators slivers.mesh.off --prefix s
claim "all(z.real <= 1e-12 for (i, j), z in mtx('s_laplacian.mtx').stored.items() if i != j)"
cp s_laplacian.mtx first
expect 0 operators slivers.mesh.off --prefix s
cmp s_laplacian.mtx first
rm s_* first

# Rows of isolated vertices are empty.
expect 0 operators isolated.mesh.off --prefix i
claim "all(0 not in place for place in mtx('i_mass.mtx').entries)"
rm i_*

# Lengths do not determine the area of a face, and the exact metric does.
off thin '0 0 0,1 0 0,0 1 0,0.5 1e-17 0' '0 3 2,3 1 2,0 1 3'
expect 0 operators thin.mesh.off --prefix t --strict
claim "t = mtx('t_laplacian.mtx')" 'near(max(map(abs, t.entries.values())) / 5e16, 1, 1e-12)'
rm t_*

# A face without area has no Laplacian, unless it is mollified. Nothing is written without it.
off flat '0 0 0,1 0 0,2 0 0' '0 1 2'
expect 1 operators flat.mesh.off --prefix f --strict
says 'the area of face 0 is zero, like the areas of all faces at vertex'
expect_files
expect 0 operators flat.mesh.off --prefix f
says 'flat.mesh.off: computed with --mollify 1e-8: the area of face 0 is zero, like the areas of all faces at vertex'
rm f_*
expect 0 operators flat.mesh.off --prefix f --mollify 1e-3
rm f_*

# Wrong calls.
expect 2 operators slivers.mesh.off
expect 2 operators --prefix a
expect 2 operators slivers.mesh.off --prefix missing/a
expect 2 operators slivers.mesh.off --prefix a --stats a_mass.mtx
expect 2 operators repeated.mesh.off --prefix a
mkdir a_gradient.mtx
expect 2 operators slivers.mesh.off --prefix a
if [ -w /dev/full ]; then
  expect 1 operators slivers.mesh.off --prefix b --stats /dev/full
fi
expect_files

if [ -n "$data" ]; then
  for mesh in elephant.off cube-ouvert.off sphere.stl colored_tetra.ply; do
    expect 0 operators "$data/meshes/$mesh" --prefix mesh
    claim "is_harmless(*'$(echo mesh_*.mtx)'.split())"
  done
fi
