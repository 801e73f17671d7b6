#!/usr/bin/env bash
# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# Targets, files, statistics and exit codes of the command simplify.
source "$(dirname "${BASH_SOURCE[0]}")/common.bash"

# is_prolongation MTX ROWS COLUMNS: of this size, no entry is negative, and each row has the sum 1.
is_prolongation()
{
  awk -v rows="$2" -v columns="$3" '
    /^%/ { next }
    !size { size = 1; bad = $1 != rows || $2 != columns; next }
    { bad += $3 < 0; sum[$1] += $3 }
    END {
      for(i = 1; i <= rows; ++i)
        bad += sum[i] < 1 - 1e-12 || sum[i] > 1 + 1e-12
      exit bad > 0
    }' "$1" || fail "$1 is no prolongation from $3 to $2 vertices"
}

# reproduces MTX PLY: a function on the plane that is linear is the prolongation of itself.
reproduces()
{
  awk '
    NR == FNR && /^element vertex/ { n = $3 }
    NR == FNR && /^end_header/ { body = 1; next }
    NR == FNR && body && n-- > 0 && $5 == 0 { f[v] = 2 * $1 - 3 * $2; if($4 >= 0) coarse[$4] = f[v]; ++v }
    NR == FNR || /^%/ { next }
    !size { size = 1; next }
    { sum[$1 - 1] += $3 * coarse[$2 - 1] }
    END {
      for(i = 0; i < v; ++i)
        if((sum[i] - f[i]) ^ 2 > 1e-18)
          exit 1
    }' "$2" "$1" || fail "$1 does not reproduce a linear function"
}

# coarse_areas FILE: of each coarse face in a plane, from the faces in a PLY file.
coarse_areas()
{
  awk '
    /^element/ { n[$2] = $3 }
    /^end_header/ { body = 1; next }
    !body { next }
    n["vertex"] > 0 { --n["vertex"]; x[v + 0] = $1; y[v++] = $2; next }
    n["face"] > 0 {
      --n["face"]
      sum = 0
      for(i = 2; i < $1 + 2; ++i) {
        j = i < $1 + 1 ? i + 1 : 2
        sum += x[$i] * y[$j] - y[$i] * x[$j]
      }
      area[$(NF - 3)] += sum / 2
    }
    END { for(f in area) printf "%d %.9f\n", f, area[f] }' "$1" | sort -n
}

# area FILE: of the faces in a PLY file, which are flat.
area()
{
  awk '
    /^element/ { n[$2] = $3 }
    /^end_header/ { body = 1; next }
    !body { next }
    n["vertex"] > 0 { --n["vertex"]; x[v + 0] = $1; y[v + 0] = $2; z[v++] = $3; next }
    n["face"] > 0 {
      --n["face"]
      a = b = c = 0
      for(i = 3; i < $1 + 1; ++i) {
        px = x[$i] - x[$2]; py = y[$i] - y[$2]; pz = z[$i] - z[$2]
        qx = x[$(i + 1)] - x[$2]; qy = y[$(i + 1)] - y[$2]; qz = z[$(i + 1)] - z[$2]
        a += py * qz - pz * qy; b += pz * qx - px * qz; c += px * qy - py * qx
      }
      sum += sqrt(a ^ 2 + b ^ 2 + c ^ 2) / 2
    }
    END { printf "%.9g\n", sum }' "$1"
}

# coarse_edges FILE: the number of coarse edges in a PLY file, and their length together.
coarse_edges()
{
  awk '
    /^element/ { n[$2] = $3 }
    /^end_header/ { body = 1; next }
    !body { next }
    n["vertex"] > 0 { --n["vertex"]; x[v + 0] = $1; y[v + 0] = $2; z[v++] = $3; next }
    n["face"] > 0 { --n["face"]; next }
    n["edge"] > 0 && $4 >= 0 {
      is_edge[$4] = 1
      sum += sqrt((x[$1] - x[$2]) ^ 2 + (y[$1] - y[$2]) ^ 2 + (z[$1] - z[$2]) ^ 2)
    }
    END {
      for(e in is_edge)
        ++edges
      printf "%d %.9f\n", edges, sum
    }' "$1"
}

# lines FILE: the number of poly-lines in a VTP file, and their length together.
lines()
{
  awk '
    /Name="Points"/ { part = "points"; next }
    /^<Lines>/ { in_lines = 1 }
    /Name="connectivity"/ { part = in_lines ? "lines" : ""; next }
    /^<\/DataArray>/ { part = ""; in_lines = 0 }
    part == "points" { x[n] = $1; y[n] = $2; z[n++] = $3 }
    part == "lines" {
      ++count
      for(i = 2; i <= NF; ++i)
        sum += sqrt((x[$i] - x[$(i - 1)]) ^ 2 + (y[$i] - y[$(i - 1)]) ^ 2 + (z[$i] - z[$(i - 1)]) ^ 2)
    }
    END { printf "%d %.9f\n", count, sum }' "$1"
}

# cell_values NAME FILE: the values of cells in a VTP file.
cell_values()
{
  awk -v name="Name=\"$1\"" '
    /^<CellData>/ { cells = 1 }
    /^<\/CellData>/ { exit }
    /^<\/DataArray>/ { on = 0 }
    on
    cells && index($0, name) { on = 1 }' "$2"
}

# is_colored FILE: the faces of a PLY file have one color for each coarse face, and another on the
# other side of its edges.
is_colored()
{
  awk '
    /^element/ { n[$2] = $3 }
    /^end_header/ { body = 1; next }
    !body { next }
    n["vertex"] > 0 { --n["vertex"]; next }
    n["face"] > 0 {
      --n["face"]
      f = $(NF - 3)
      c = $(NF - 2) " " $(NF - 1) " " $NF
      bad += (f in color) && color[f] != c
      color[f] = c
      for(i = 2; i < $1 + 2; ++i) {
        j = i < $1 + 1 ? i + 1 : 2
        if(($j, $i) in face) {
          g = face[$j, $i]
          bad += f != g && color[g] == c
        }
        face[$i, $j] = f
      }
    }
    END { exit bad > 0 }' "$1" || fail "$1 is not colored properly"
}

# A square: flat, but for its corners, which alone cannot be removed without cost.
grid square 8 0
expect 0 simplify square.mesh.off -o a.ply --error 1e-12 --weight area=0 --stats a.json --prolongation a.mtx
[ ! -s out ] || fail 'standard output is not empty'
says '81 -> 4 vertices (reached)'
expect_files a.json a.mtx a.ply
is_prolongation a.mtx 81 4
reproduces a.mtx a.ply
[ "$(number a.json coarse_vertices) $(number a.json coarse_faces)" = '4 2' ] || fail 'not two triangles'
[ "$(number a.json removed)" = 77 ] || fail 'not all removed'
awk -v r="$(number a.json area_ratio)" 'BEGIN { exit !(r > 1 - 1e-12 && r < 1 + 1e-12) }' ||
  fail 'the area has changed'
awk -v a="$(number a.json min_angle_degrees)" 'BEGIN { exit !(a > 45 - 1e-9 && a < 45 + 1e-9) }' ||
  fail 'not half a square'
# The corners keep their places, and the two triangles are half of the square each.
[ "$(vertices a.ply | awk '$4 >= 0 { print $1, $2, $4 }' | tr '\n' ,)" = '0 0 0,1 0 1,0 1 2,1 1 3,' ] ||
  fail 'not the corners'
[ "$(coarse_areas a.ply | tr '\n' ,)" = '0 0.500000000,1 0.500000000,' ] || fail 'coarse faces'
[ "$(coarse_edges a.ply)" = '5 5.414213562' ] || fail 'coarse edges are not straight'
is_colored a.ply
grep -q '^property uchar red' a.ply

expected='command input vertices edges faces euler_characteristic boundary_loops components '
expected+='coarse_vertices coarse_faces removed status greatest_cost skipped isolated protected border_loop '
expected+='self_face low_degree not_flattenable not_separable operations area_ratio min_angle_degrees '
expected+='subdivision vertices edges faces seconds read build simplify map write peak_memory_bytes '
[ "$(keys a.json)" = "$expected" ] || fail "keys: $(keys a.json)"

# The same bytes once more, and in every format.
expect 0 simplify square.mesh.off -o b.ply --error 1e-12 --weight area=0 --prolongation b.mtx --quiet
[ ! -s err ] || fail "not quiet: $(cat err)"
cmp a.ply b.ply
cmp a.mtx b.mtx
for format in ply vtp off obj; do
  expect 0 simplify square.mesh.off -o "a.$format" --vertices 20
  expect 0 simplify square.mesh.off -o - --vertices 20 --format "$format"
  cmp "a.$format" out
done
[ "$(lines a.vtp)" = "$(coarse_edges a.ply)" ] || fail "lines: $(lines a.vtp)"
n=$(lines a.vtp | cut -d ' ' -f 1)
cmp <(cell_values coarse_edge a.vtp | head -n "$n") <(seq 0 $((n - 1))) || fail 'numbers of lines'
! cell_values coarse_edge a.vtp | tail -n "+$((n + 1))" | grep -qvx -- -1 || fail 'coarse edges of faces'
! cell_values coarse_face a.vtp | head -n "$n" | grep -qvx -- -1 || fail 'coarse faces of lines'
cmp <(cell_values coarse_face a.vtp | tail -n "+$((n + 1))") \
  <(awk '/^element/ { n[$2] = $3 } /^end_header/ { body = 1; next }
    body && n["vertex"]-- <= 0 && n["face"]-- > 0 { print $(NF - 3) }' a.ply) || fail 'coarse faces'
[ "$(grep -c '^f' a.obj)" = "$(sed -n 's/^element face //p' a.ply)" ] || fail 'faces in .obj'
[ "$(sed -n '2s/ 0$//p' a.off)" = "$(vertices a.ply | wc -l) $(grep -c '^f' a.obj)" ] || fail 'faces in .off'
rm a.* b.*

# A parallelogram, in six decimals: coarse edges cross fine ones, and are its sides and the shorter
# diagonal.
grid sheared 7 0.3
expect 0 simplify sheared.mesh.off -o a.ply --vertices 4 --weight area=0
[ "$(coarse_areas a.ply | awk '{ printf "%d %.5f,", $1, $2 }')" = '0 0.50000,1 0.50000,' ] ||
  fail 'halves of the parallelogram'
[ "$(coarse_edges a.ply | awk '{ printf "%d %.5f", $1, $2 }')" = '5 5.30872' ] || fail 'edges of the parallelogram'
is_colored a.ply

# Targets: a number, a part, and more than there are.
cp "$shipped" slivers.mesh.off
expect 0 simplify slivers.mesh.off -o a.ply --vertices 100 --stats a.json --prolongation a.mtx
[ "$(number a.json coarse_vertices)" = 100 ] || fail 'not 100 vertices'
[ "$(number a.json removed)" = 1220 ] || fail 'not 1220 removed'
is_prolongation a.mtx 1320 100
[ "$(vertices a.ply | awk '$4 >= 0' | wc -l)" = 100 ] || fail 'not 100 numbers'
cmp <(vertices a.ply | awk '$4 >= 0 { print $4 }') <(seq 0 99) || fail 'numbers out of order'
expect 0 simplify slivers.mesh.off -o a.ply --ratio 0.1 --stats a.json --weight area=1 --weight curvature=0
[ "$(number a.json coarse_vertices)" = 132 ] || fail 'not a tenth'
expect 0 simplify slivers.mesh.off -o a.ply --ratio 1 --stats a.json
[ "$(number a.json removed)" = 0 ] || fail 'something removed'
awk -v r="$(number a.json area_ratio)" 'BEGIN { exit !(r > 1 - 1e-12 && r < 1 + 1e-12) }' ||
  fail 'the area has changed'
expect 0 simplify slivers.mesh.off -o a.ply --vertices 5000 --stats a.json
[ "$(number a.json removed)" = 0 ] || fail 'something removed'
rm a.*

# Colors: a square that is black, and on the right half of it striped. With a weight, hardly a
# vertex is left where it is black, and the other way round where the properties of a .ply file are.
grid plain 16 0
awk 'NR == 1 { print "COFF"; next } NR > 2 && NF == 3 { c = $1 > 0.5 ? 255 * (int(16 * $1) % 2) : 0; print $0, c, c / 5, 0, 255; next } { print }' \
  plain.mesh.off >striped.mesh.off
{
  printf 'ply\nformat ascii 1.0\nelement vertex 289\n'
  printf 'property %s\n' 'float x' 'float y' 'double z' 'uchar red' 'uchar green' 'uchar blue' 'float heat' 'short depth'
  printf 'element face 512\nproperty list uchar int vertex_indices\nend_header\n'
  awk 'NR > 2 && NF == 3 { c = $1 > 0.5 ? 255 * (int(16 * $1) % 2) : 0; print $0, c, c / 5, 0, $1 < 0.5 ? int(16 * $1) % 2 : 0, -c }
    NR > 2 && NF == 4' plain.mesh.off
} >striped.mesh.ply

# sides FILE: how many coarse vertices in a PLY file are on the left and how many on the right.
sides()
{
  vertices "$1" | awk '$4 >= 0 { left += $1 < 0.5; right += $1 > 0.5 } END { print left, right }'
}

expect 0 simplify plain.mesh.off -o a.ply --vertices 100
read -r left right <<<"$(sides a.ply)"
[ "$left" -gt 35 ] && [ "$right" -gt 35 ] || fail "without weights: $left and $right"
expect 0 simplify striped.mesh.off -o b.ply --vertices 100
cmp a.ply b.ply
for weight in color=100 depth=100; do
  expect 0 simplify striped.mesh.ply -o a.ply --vertices 100 --weight $weight
  read -r left right <<<"$(sides a.ply)"
  [ "$left" -lt 12 ] && [ "$right" -gt 70 ] || fail "$weight: $left and $right"
done
expect 0 simplify striped.mesh.ply -o a.ply --vertices 100 --weight heat=100
read -r left right <<<"$(sides a.ply)"
[ "$left" -gt 70 ] && [ "$right" -lt 12 ] || fail "heat: $left and $right"
expect 0 simplify striped.mesh.ply -o a.ply --vertices 100 --weight color=5
expect 0 simplify striped.mesh.off -o b.ply --vertices 100 --weight color=5
cmp a.ply b.ply
expect 0 simplify striped.mesh.off -o b.ply --vertices 100 --weight color=5 --refine 25
expect 0 simplify striped.mesh.ply -o b.ply --vertices 100 --weight color=0 --weight height=0
expect 2 simplify plain.mesh.off -o c.ply --vertices 100 --weight color=1
says 'no colors'
expect 2 simplify good.mesh.obj -o c.ply --vertices 100 --weight color=1
says 'no colors'
expect 2 simplify plain.mesh.off -o c.ply --vertices 100 --weight heat=1
says "no property 'heat'"
expect 2 simplify striped.mesh.ply -o c.ply --vertices 100 --weight cold=1
says "no property 'cold'; they have blue, depth, green, heat"
# A tetrahedron in binary; only there numbers can be no numbers.
binary()
{
  local zero='\0\0\0\0' one='\0\0\200\77'
  printf 'ply\nformat binary_little_endian 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n'
  printf 'property float heat\nelement face 4\nproperty list uchar int vertex_indices\nend_header\n'
  printf "$zero$zero$zero$1$one$zero$zero$one$zero$one$zero$zero$zero$zero$one$one"
  printf '\3\0\0\0\0\2\0\0\0\1\0\0\0\3\0\0\0\0\1\0\0\0\3\0\0\0'
  printf '\3\1\0\0\0\2\0\0\0\3\0\0\0\3\2\0\0\0\0\0\0\0\3\0\0\0'
}
binary '\0\0\0\0' >binary.mesh.ply
expect 0 simplify binary.mesh.ply -o c.ply --vertices 4 --weight heat=1
binary '\0\0\300\177' >binary.mesh.ply
expect 2 simplify binary.mesh.ply -o c.ply --vertices 4 --weight heat=1
says 'not finite'
rm c.ply
# A repair moves the numbers of vertices.
{
  sed 2q striped.mesh.off | sed '2s/289 /290 /'
  sed -n '3p;3,$p' striped.mesh.off
} | awk 'NR > 4 && $1 == 3 { ++$2; ++$3; ++$4 } { print }' >repeated_color.mesh.off
expect 2 simplify repeated_color.mesh.off -o c.ply --vertices 100 --weight color=1 --repair
says 'had to be repaired'
rm a.* b.*

# Levels: matrices from each to the one before, and the saved form.
expect 0 simplify slivers.mesh.off -o a.ply --vertices 100 --levels 3 --prolongation a.mtx --stats a.json --save a.txt
expect_files a.json a.ply a.txt a_1.mtx a_2.mtx a_3.mtx
[ "$(grep -A 4 level_vertices a.json | tr -dc '0-9 ' | tr -s ' ')" = ' 559 237 100 ' ] ||
  fail "levels: $(grep -A 4 level_vertices a.json)"
is_prolongation a_1.mtx 1320 559
is_prolongation a_2.mtx 559 237
is_prolongation a_3.mtx 237 100
is_colored a.ply
[ "$(head -n 2 a.txt | tr '\n' ,)" = 'intrinsic_simplification 1,1320 3960 2640,' ] || fail "saved: $(head -n 2 a.txt)"
expect 0 simplify slivers.mesh.off -o b.ply --vertices 100 --levels 3 --save b.txt
cmp a.txt b.txt
expect 2 simplify slivers.mesh.off -o a.ply --error 1 --levels 3
says '--levels'
rm a* b.*

# Refinement before: the vertices of the mesh keep their numbers, and its rows are those of the
# prolongation. Coarse edges lie on the mesh, so faces have its area together; the saved form has
# the mesh with more vertices, then the levels.
expect 0 simplify slivers.mesh.off -o b.ply --ratio 1
expect 0 simplify slivers.mesh.off -o a.ply --refine 25 --vertices 200 --prolongation a.mtx --stats a.json --save a.txt
[ "$(area a.ply)" = "$(area b.ply)" ] || fail "area $(area a.ply) instead of $(area b.ply)"
[ "$(sed -n '2,3p' a.mtx | tr '\n' ,)" = '% rows: the vertices of the mesh, without those inserted,% columns: the vertices of level 1,' ] ||
  fail "comments: $(sed -n '2,3p' a.mtx)"
cmp <(sed -n '1p;1320q' a.txt) <(echo 'intrinsic_triangulation 2')
read -r v e f <<<"$(sed -n '/^intrinsic_simplification 1$/ { n; p }' a.txt)"
[ "$v" = $((1320 + $(number a.json inserted_vertices))) ] || fail "saved with $v vertices"
grep -qx "$v $e $f" <(sed '/^intrinsic_simplification/q' a.txt) || fail 'not the same triangulation in both parts'
cmp <(awk '/^element/ { n[$2] = $3 } /^end_header/ { body = 1; next }
    body && n["vertex"]-- <= 0 && n["face"]-- > 0 { print $(NF - 4) }' a.ply | sort -nu) <(seq 0 2639) || fail 'input faces'
is_prolongation a.mtx 1320 200
[ "$(number a.json inserted_vertices)" -gt 0 ] || fail 'nothing inserted'
[ "$(number a.json refinement_status)" != '' ] || fail 'no status of the refinement'
[ "$(vertices a.ply | awk '$5 == 0' | wc -l)" = 1320 ] || fail 'not the vertices of the mesh'
[ "$(vertices a.ply | awk '$5 == 2' | wc -l)" = "$(number a.json inserted_vertices)" ] || fail 'kinds'
is_colored a.ply

# What is inserted in flat faces is removed without cost: eight times as wide as high, and refined.
grid cells 16 0
awk 'FNR > 2 && NF == 3 { $1 *= 8 } { print }' cells.mesh.off >wide.mesh.off
expect 0 simplify wide.mesh.off -o a.ply --refine 30 --error 1e-12 --weight area=0 --weight area_change=0 --stats a.json
[ "$(number a.json inserted_vertices)" -gt 100 ] || fail 'nothing inserted'
[ "$(coarse_areas a.ply | tr '\n' ,)" = '0 4.000000000,1 4.000000000,' ] || fail "coarse faces: $(coarse_areas a.ply)"
rm a.* b.*

# Nothing left to remove is no failure, but told.
expect 0 simplify good.mesh.off -o a.ply --vertices 1 --stats a.json
says '(nothing_removable)'
grep -q '"status": "nothing_removable"' a.json
[ "$(number a.json removed)" = 0 ] || grep -q '"coarse_faces": [1-9]' a.json || fail 'no faces left'

# Handled, not refused.
expect 0 simplify isolated.mesh.off -o a.ply --vertices 4 --prolongation a.mtx --stats a.json
[ "$(number a.json removed) $(number a.json isolated)" = '0 1' ] || fail 'the isolated vertex was counted'
is_prolongation a.mtx 5 5
expect 0 simplify two_components.mesh.off -o - --vertices 5
expect 0 simplify cap.mesh.off -o - --vertices 3
expect 0 simplify needle.mesh.off -o - --vertices 1
expect 0 simplify zero_length.mesh.off -o - --vertices 3 --mollify 1e-6
rm a.*

# Wrong calls.
expect 2 simplify slivers.mesh.off -o a.ply
expect 2 simplify slivers.mesh.off --vertices 10
expect 2 simplify slivers.mesh.off -o a.ply --vertices 10 --ratio 0.5
expect 2 simplify slivers.mesh.off -o a.ply --vertices 10 --error 0.5
expect 0 simplify square.mesh.off -o square.mesh.ply --ratio 1
expect 2 simplify square.mesh.ply -o square.mesh.ply --vertices 10
says 'never overwritten'
expect 2 simplify slivers.mesh.off -o a.ply --vertices 10 --prolongation a.ply
expect 2 simplify slivers.mesh.off -o a.stl --vertices 10
says 'no such output format'
expect 2 simplify bow_tie.mesh.off -o a.ply --vertices 10
for n in 0 -1 many 1.5; do
  expect 2 simplify slivers.mesh.off -o a.ply --vertices=$n
done
for ratio in 0 -0.1 1.1 nan many; do
  expect 2 simplify slivers.mesh.off -o a.ply --ratio=$ratio
done
for error in -1 nan many; do
  expect 2 simplify slivers.mesh.off -o a.ply --error=$error
done
for weight in curvature area_change area_change=-1 color =1 area= area=-1 area=nan area=inf area=1x; do
  expect 2 simplify slivers.mesh.off -o a.ply --vertices 10 --weight $weight
  says '--weight'
done
expect 2 simplify slivers.mesh.off -o a.ply --vertices 10 --weight curvature=0 --weight area=0
says '--weight'
expect_files

if [ -n "$data" ]; then
  for mesh in elephant.off sphere.stl bones.off star.off; do
    expect 0 simplify "$data/meshes/$mesh" -o mesh.ply --ratio 0.1 --prolongation mesh.mtx --stats mesh.json
    is_prolongation mesh.mtx "$(number mesh.json vertices)" "$(number mesh.json coarse_vertices)"
    [ "$(coarse_areas mesh.ply | wc -l)" = "$(number mesh.json coarse_faces)" ] || fail "coarse faces of $mesh"
    is_colored mesh.ply
  done
fi
