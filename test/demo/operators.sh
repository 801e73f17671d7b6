#!/usr/bin/env bash
# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# Matrices, their files and exit codes of the command operators.
source "$(dirname "${BASH_SOURCE[0]}")/common.bash"

matrices=({connection_laplacian,divergence,gradient,laplacian,lumped_mass,mass}.mtx)

# entries FILE: row, column and value of every entry, both triangles of a symmetric matrix.
entries()
{
  awk '
    NR == 1 { is_symmetric = $5 != "general"; next }
    NR == 2 { next }
    { print $1, $2, $3 }
    is_symmetric && $1 != $2 { print $2, $1, $3 }' "$1"
}

# apply FILE VECTOR: the product of a real matrix with a file of numbers, line by line.
apply()
{
  entries "$1" | awk -v rows="$(sed -n '2s/ .*//p' "$1")" '
    FNR == NR { x[FNR] = $1; next }
    { y[$1] += $3 * x[$2] }
    END { for(i = 1; i <= rows; ++i) printf "%.17g\n", y[i] }' "$2" -
}

# are_close FILE FILE BOUND: so are their numbers, line by line.
are_close()
{
  paste "$1" "$2" | awk -v bound="$3" '
    { d = $1 - $2 }
    NF != 2 || !(d <= bound && -d <= bound) { print NR ": " $0; exit 1 }' ||
    fail 'numbers differ by more than rounding'
}

# values EXPRESSION: its values in x and y at the vertices of the grid, a number per line.
values()
{
  sed -n 3,443p grid.mesh.off | awk "{ x = \$1; y = \$2; printf \"%.17g\n\", $1 }"
}

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
grep -qx '2 1 -0.375' t_laplacian.mtx
grep -qx '3 1 -0.6666666666666666' t_laplacian.mtx
grep -qx '%%MatrixMarket matrix coordinate complex hermitian' t_connection_laplacian.mtx
rm t_*

# On the flat square, areas and derivatives of polynomials are known.
n=20
grid grid $n 0
expect 0 operators grid.mesh.off --prefix g --save g.save --stats g.json
expect_files g.json g.save "${matrices[@]/#/g_}"
values 1 >one
values 0 >zero

# Rounding of sums of a few numbers below five.
apply g_laplacian.mtx one >sums
are_close sums zero 1e-14
apply g_mass.mtx one >sums
apply g_lumped_mass.mtx one >lumped
are_close sums lumped 1e-14
are_close <(awk '{ s += $1 } END { printf "%.17g\n", s }' sums) <(echo 1) 1e-12

# x^2 has the Laplacian 2, which the five points around a vertex get right.
values 'x ^ 2' >square
is_inside='(x > 0.01 && x < 0.99 && y > 0.01 && y < 0.99)'
paste <(apply g_laplacian.mtx square) lumped <(values "$is_inside") |
  awk '$3 { printf "%.17g\n", $1 + 2 * $2 }' >residuals
[ "$(wc -l <residuals)" -eq $(((n - 1) ** 2)) ] || fail 'not all inner vertices'
are_close residuals <(sed 's/.*/0/' residuals) 1e-14

# The gradient of 3 x + 4 y has the length 5; divergence and gradient make the Laplacian.
values '3 * x + 4 * y' >linear
apply g_gradient.mtx linear | awk '{ s += $1 ^ 2 } NR % 2 == 0 { print sqrt(s); s = 0 }' >slopes
[ "$(wc -l <slopes)" -eq $((2 * n * n)) ] || fail 'not two rows for each face'
are_close slopes <(sed 's/.*/5/' slopes) 1e-12
apply g_gradient.mtx square >field
apply g_divergence.mtx field | awk '{ printf "%.17g\n", -$1 }' >product
are_close product <(apply g_laplacian.mtx square) 1e-14

# Where no two vertices have two edges, the entries of the connection Laplacian have the absolute
# values of those of the Laplacian, at the same places. It is Hermitian.
cmp <(sed 1d g_laplacian.mtx | cut -d ' ' -f 1,2) <(sed 1d g_connection_laplacian.mtx | cut -d ' ' -f 1,2)
moduli='NR > 2 { printf "%.17g\n", sqrt($3 ^ 2 + $4 ^ 2) }'
are_close <(awk "$moduli" g_laplacian.mtx) <(awk "$moduli" g_connection_laplacian.mtx) 1e-14
awk 'NR > 2 && $1 == $2 && $4 != 0 { exit 1 }' g_connection_laplacian.mtx

# Triangles are lower, and the header tells the entries.
for matrix in g_*.mtx; do
  [ "$(sed -n '2s/.* //p' $matrix)" -eq $(($(wc -l <$matrix) - 2)) ] || fail "entries of $matrix"
done
for matrix in g_{connection_laplacian,laplacian,lumped_mass,mass}.mtx; do
  awk 'NR > 2 && $1 < $2 { exit 1 }' "$matrix" || fail "$matrix has an upper triangle"
done

expected='command input vertices edges faces euler_characteristic boundary_loops components flips '
expected+='is_delaunay shared_edges crossings edge_length_sum min_angle_degrees matrices seconds read '
expected+='build flip write peak_memory_bytes '
[ "$(keys g.json)" = "$expected" ] || fail "keys: $(keys g.json)"
grep -q '"g_mass.mtx"' g.json
rm g_* g.* one zero sums lumped square residuals linear slopes field product

# The weights of a closed Delaunay triangulation are not negative, up to rounding.
cp "$shipped" slivers.mesh.off
expect 0 operators slivers.mesh.off --prefix s
awk 'NR > 2 && $1 != $2 && $3 > 1e-12 { exit 1 }' s_laplacian.mtx || fail 'a negative weight'
cp s_laplacian.mtx first
expect 0 operators slivers.mesh.off --prefix s
cmp s_laplacian.mtx first
rm s_* first

# Rows of isolated vertices are empty.
expect 0 operators isolated.mesh.off --prefix i
! grep -q '^1 \| 1 ' i_mass.mtx || fail 'an isolated vertex has mass'
rm i_*

# A face without area has no Laplacian, unless it is mollified. Nothing is written without it.
off flat '0 0 0,1 0 0,2 0 0' '0 1 2'
expect 1 operators flat.mesh.off --prefix f
expect_files
expect 0 operators flat.mesh.off --prefix f --mollify 1e-3
rm f_*

# Wrong calls.
expect 2 operators slivers.mesh.off
expect 2 operators --prefix a
expect 2 operators slivers.mesh.off --prefix missing/a
expect 2 operators slivers.mesh.off --prefix a --stats a_mass.mtx
expect 2 operators bow_tie.mesh.off --prefix a
mkdir a_gradient.mtx
expect 2 operators slivers.mesh.off --prefix a
if [ -w /dev/full ]; then
  expect 1 operators slivers.mesh.off --prefix b --stats /dev/full
fi
expect_files

if [ -n "$data" ]; then
  for mesh in elephant.off cube-ouvert.off sphere.stl colored_tetra.ply; do
    expect 0 operators "$data/meshes/$mesh" --prefix mesh
    ! grep -qi 'nan\|inf' mesh_*.mtx || fail "$mesh has entries that are no numbers"
  done
fi
