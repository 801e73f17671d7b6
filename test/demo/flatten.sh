#!/usr/bin/env bash
# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# Maps to the plane, their files, statistics and exit codes of the command flatten.
source "$(dirname "${BASH_SOURCE[0]}")/common.bash"

pi=3.14159265358979324

# near A B TOLERANCE: whether two numbers are.
near()
{
  awk -v a="$1" -v b="$2" -v t="$3" 'BEGIN { exit !(a != "" && b != "" && a - b <= t && b - a <= t) }' ||
    fail "$1 is not $2"
}

# is_conformal FILE: the statistics are those of a map that nothing is wrong with.
is_conformal()
{
  grep -q '"status": "success"' "$1"
  grep -q '"flipped_triangles": 0,' "$1"
  grep -q '"degenerate_triangles": 0,' "$1"
  near "$(number "$1" max_curvature_error)" 0 1e-10
  near "$(number "$1" max_cross_ratio_error)" 0 1e-8
}

# areas FILE: what the polygons of an OBJ file cover in space and in the plane.
areas()
{
  awk -F'[ /]' '
    function corner(i, k) { return $(2 * i + k) }
    function area3(a, b, c,   k) {
      for(k = 0; k < 3; ++k) { p[k] = v[b, k] - v[a, k]; q[k] = v[c, k] - v[a, k] }
      a = p[1] * q[2] - p[2] * q[1]; b = p[2] * q[0] - p[0] * q[2]; c = p[0] * q[1] - p[1] * q[0]
      return sqrt(a ^ 2 + b ^ 2 + c ^ 2) / 2
    }
    function area2(a, b, c) {
      return ((x[b] - x[a]) * (y[c] - y[a]) - (y[b] - y[a]) * (x[c] - x[a])) / 2
    }
    $1 == "v" { ++n; v[n, 0] = $2; v[n, 1] = $3; v[n, 2] = $4 }
    $1 == "vt" { ++m; x[m] = $2; y[m] = $3 }
    $1 == "f" {
      for(i = 3; 2 * i <= NF; ++i) {
        space += area3($2, corner(i - 1, 0), corner(i, 0))
        plane += area2($3, corner(i - 1, 1), corner(i, 1))
      }
    }
    END { printf "%.17g %.17g\n", space, plane }' "$1"
}

# box FILE: the greatest coordinates of the texture of an OBJ file; the least must be zero.
box()
{
  awk '$1 == "vt" {
      if(!n++ || $2 < x) x = $2
      if(n == 1 || $3 < y) y = $3
      if(n == 1 || $2 > X) X = $2
      if(n == 1 || $3 > Y) Y = $3
    }
    END { if(x ^ 2 + y ^ 2 > 1e-20) exit 1; printf "%.17g %.17g\n", X, Y }' "$1" ||
    fail "$1 does not start at the origin"
}

# A regular tetrahedron with edges of length sqrt(8), and a torus as 12 x 12 cells of two triangles.
off regular '1 1 1,1 -1 -1,-1 1 -1,-1 -1 1' '0 1 2,0 2 3,0 3 1,1 3 2'
awk -v n=12 -v pi=$pi 'BEGIN {
  print "OFF\n" n * n, 2 * n * n, 0
  for(j = 0; j < n; ++j)
    for(i = 0; i < n; ++i) {
      r = 2 + cos(2 * pi * i / n)
      print r * cos(2 * pi * j / n), r * sin(2 * pi * j / n), sin(2 * pi * i / n)
    }
  for(j = 0; j < n; ++j)
    for(i = 0; i < n; ++i) {
      a = n * j + i; b = n * j + (i + 1) % n
      c = n * ((j + 1) % n) + i; d = n * ((j + 1) % n) + (i + 1) % n
      print 3, a, c, d
      print 3, a, d, b
    }
}' >torus.mesh.off

# What is flat stays as it is: scale factors of one, areas and lengths as in space.
grid square 8 0
grid sheared 8 3
for mesh in square sheared; do
  expect 0 flatten $mesh.mesh.off -o a.obj --stats a.json
  is_conformal a.json
  for key in log_scale_min log_scale_max log_scale_square_sum; do
    near "$(number a.json $key)" 0 1e-12
  done
  grep -q '"cones": 0,' a.json
  read -r space plane <<<"$(areas a.obj)"
  near "$space" 1 1e-12
  near "$plane" 1 1e-12
done
expect 0 flatten square.mesh.off -o a.obj --boundary rectangle --stats a.json
read -r width height <<<"$(box a.obj)"
near "$width" 1 1e-12
near "$height" 1 1e-12
near "$(number a.json log_scale_max)" 0 1e-12

# A rectangle ten times as long as wide has its own corners.
awk 'NF == 3 && NR > 2 { print 10 * $1, $2, $3; next } { print }' square.mesh.off >long.mesh.off
expect 0 flatten long.mesh.off -o a.obj --boundary rectangle --stats a.json
read -r width height <<<"$(box a.obj)"
near "$width" 10 1e-11
near "$height" 1 1e-11

# Every parallelogram becomes a rectangle that its map fills.
expect 0 flatten sheared.mesh.off -o a.obj --boundary rectangle --stats a.json
is_conformal a.json
read -r width height <<<"$(box a.obj)"
read -r space plane <<<"$(areas a.obj)"
near "$plane" "$(awk -v a="$width" -v b="$height" 'BEGIN { printf "%.17g", a * b }')" 1e-11
near "$plane" 1 1e-11

# A square with equal quarters becomes a disk with its boundary vertices on a circle around the
# middle.
expect 0 flatten square.mesh.off -o a.ply --boundary disk --stats a.json
is_conformal a.json
awk '/^end_header/ { body = 1; next } body && $1 > 2 && NF > 6 { # faces
       for(i = 0; i < $1; ++i) { x[$(i + 2)] = $($1 + 3 + 2 * i); y[$(i + 2)] = $($1 + 4 + 2 * i) }
     }
     END {
       for(v = 0; v < 81; ++v) { a += x[v] / 81; b += y[v] / 81 }
       for(v = 0; v < 81; ++v)
         if(v < 9 || v > 71 || v % 9 == 0 || v % 9 == 8) {
           r = sqrt((x[v] - a) ^ 2 + (y[v] - b) ^ 2)
           if(!n++ || r < least) least = r
           if(r > greatest) greatest = r
         }
       exit !(n == 32 && greatest - least < 1e-8 * greatest)
     }' a.ply || fail 'not a circle'

# The cones of a regular tetrahedron: defects of pi at each vertex are its own.
printf '0 %s\n1 %s # comment\n\n# nothing\n2 %s\n3\t%s\r\n' $pi $pi $pi $pi >cones
expect 0 flatten regular.mesh.off -o a.obj --cones cones --stats a.json
is_conformal a.json
near "$(number a.json log_scale_min)" 0 1e-12
near "$(number a.json log_scale_max)" 0 1e-12
grep -q '"cones": 4,' a.json
read -r space plane <<<"$(areas a.obj)"
near "$space" 13.856406460551018 1e-12 # sqrt(3) times the squared length of an edge
near "$plane" 13.856406460551018 1e-12

# Nine digits of them miss the sum by 2.4e-9, which is no minimum: the failure is told, nothing is
# written.
rm a.obj
printf '%s 3.141592653\n' 0 1 2 3 >digits
expect 1 flatten regular.mesh.off -o a.obj --cones digits --stats b.json
says 'the minimization has not converged: unbounded, with an error of curvatures of 5.89'
[ ! -e a.obj ] && [ ! -e b.json ] || fail 'files after a failure'
rm digits

# Three cones of 4 pi / 3 leave no curvature at the fourth vertex: by symmetry its edges, which
# three equal triangles share, have lengths in the ratio 1 / sqrt(3) to the others, so its scale
# factor is 1 / 3.
third=$(awk -v pi=$pi 'BEGIN { printf "%.17g", 4 * pi / 3 }')
printf '0 %s\n1 %s\n2 %s\n' "$third" "$third" "$third" >cones
expect 0 flatten regular.mesh.off -o a.obj --cones cones --stats a.json
is_conformal a.json
near "$(awk -v a="$(number a.json log_scale_max)" -v b="$(number a.json log_scale_min)" \
  'BEGIN { printf "%.12f", a - b }')" 1.098612288668 1e-9
read -r space plane <<<"$(areas a.obj)"
near "$plane" "$space" 1e-9

# An empty file makes a torus flat, and so does none; elsewhere the curvature has to go somewhere.
printf '# nothing\n' >empty
for cones in empty none; do
  expect 0 flatten torus.mesh.off -o a.obj --cones $cones --stats a.json
  is_conformal a.json
  grep -q '"cones": 0,' a.json
  read -r space plane <<<"$(areas a.obj)"
  near "$plane" "$space" 1e-9
  expect 2 flatten regular.mesh.off -o b.obj --cones $cones
  says 'prescribed on component 0 sum up to 12.5664 radians less than 2 pi times its Euler char'
done

# Exterior angles of a triangle on the boundary of the square; straight elsewhere.
printf '0 %s\n8 %s\n80 %s\n' "$(awk -v p=$pi 'BEGIN { printf "%.17g", 2 * p / 3 }')"{,,} | tr -s '\n' >angles
[ "$(wc -l <angles)" -eq 3 ] || fail "angles: $(cat angles)"
expect 0 flatten square.mesh.off -o a.obj --boundary curvature angles --cones none --stats a.json
is_conformal a.json
read -r width height <<<"$(box a.obj)"
near "$(awk -v w="$width" -v h="$height" 'BEGIN { printf "%.12f", h / w }')" 0.866025403784 1e-9

# Scaled by two on all of the boundary, a flat surface is scaled by two.
awk 'BEGIN { for(v = 0; v < 81; ++v)
  if(v < 9 || v > 71 || v % 9 == 0 || v % 9 == 8) printf "%d %.17g\n", v, log(2) }' >scales
expect 0 flatten square.mesh.off -o a.obj --boundary scale scales --stats a.json
is_conformal a.json
near "$(number a.json log_scale_min)" 0.69314718055994531 1e-12
read -r space plane <<<"$(areas a.obj)"
near "$plane" 4 1e-11

# Components side by side; vertices without faces stay where they are.
expect 0 flatten two_components.mesh.off -o a.obj
expect 0 flatten isolated.mesh.off -o a.obj
[ "$(head -n 1 a.obj)" = 'v 9 9 9' ] || fail 'the isolated vertex lost its place'
expect 0 flatten zero_length.mesh.off -o a.obj --mollify 1e-3
rm a.* angles cones empty scales

cp "$shipped" slivers.mesh.off
checksum=$(cksum <slivers.mesh.off)
expect 0 flatten slivers.mesh.off -o a.ply --stats statistics.json
[ ! -s out ] || fail 'standard output is not empty'
expected='command input vertices edges faces euler_characteristic boundary_loops components cones '
expected+='iterations status max_curvature_error max_cross_ratio_error flipped_triangles '
expected+='degenerate_triangles log_scale_min log_scale_max log_scale_square_sum flips ptolemy_flips '
expected+='subdivision vertices edges faces seconds read build cones optimize trace subdivide layout '
expected+='write peak_memory_bytes '
[ "$(keys statistics.json)" = "$expected" ] || fail "keys: $(keys statistics.json)"
is_conformal statistics.json

# Cones are marked, as many as are told; each edge has two vertices and a mark.
[ "$(vertices a.ply | awk '$5 == 1' | wc -l)" -eq "$(number statistics.json cones)" ] || fail 'cones'
grep -q '^property list uchar double texcoord$' a.ply
grep -q '^property int is_seam$' a.ply

# The same bytes once more and on standard output, the same numbers in each format.
for format in ply obj vtp; do
  for kind in --linear --homogeneous; do
    expect 0 flatten slivers.mesh.off -o "a.$format" $kind --quiet
    [ ! -s err ] || fail "not quiet: $(cat err)"
    expect 0 flatten slivers.mesh.off -o - --format $format $kind --quiet
    cmp "a.$format" out
  done
done
expect 0 flatten slivers.mesh.off -o - --quiet
grep '^vt' out | sort -u >texture
[ "$(wc -l <texture)" -eq "$(grep -c '^vt' out)" ] || fail 'equal corners do not share coordinates'
expect 0 flatten slivers.mesh.off -o a.obj --homogeneous
grep '^vt' a.obj | awk '{ printf "%.9f %.9f\n", $2 / $4, $3 / $4 }' | sort |
  cmp - <(awk '{ printf "%.9f %.9f\n", $2, $3 }' texture | sort)
expect 0 flatten slivers.mesh.off -o a.vtp
awk '/Name="texcoord"/ { body = 1; next } /<\/DataArray/ { body = 0 } body { print "vt", $1, $2 }' a.vtp |
  sort -u | cmp - texture
grep -q '<PointData TCoords="texcoord">' a.vtp

# The output covers the same surface.
for format in ply obj; do
  "$program" info "a.$format" >out || true
  grep -q 'Euler characteristic  0' out || fail "bad subdivision in a.$format: $(cat out)"
done
expect_files a.obj a.ply a.vtp statistics.json texture
rm a.* statistics.json texture

# interpolates MATRIX OBJ MESH: the matrix takes the points of the mesh, which come first in the OBJ
# file, to all of its points, with weights that sum to one.
interpolates()
{
  awk -v n="$(awk 'NR == 2 { print $1 }' "$3")" '
    FNR == NR { if($1 == "v") { x[++m, 0] = $2; x[m, 1] = $3; x[m, 2] = $4 }; next }
    FNR == 1 { if($0 != "%%MatrixMarket matrix coordinate real general") exit 1; next }
    FNR == 2 { rows = $1; if(rows != m || $2 != n) exit 1; next }
    { sum[$1] += $3; for(k = 0; k < 3; ++k) y[$1, k] += $3 * x[$2, k] }
    END {
      for(i = 1; i <= rows; ++i) {
        if((sum[i] - 1) ^ 2 > 1e-24) exit 1
        for(k = 0; k < 3; ++k) if((x[i, k] - y[i, k]) ^ 2 > 1e-24) exit 1
      }
    }' "$2" "$1"
}

# The matrix takes the positions of the vertices of the mesh to those of the output.
expect 0 flatten slivers.mesh.off -o a.obj --matrix a.mtx
interpolates a.mtx a.obj slivers.mesh.off || fail 'the matrix is wrong'
expect 0 flatten slivers.mesh.off -o b.obj --matrix -
cmp out a.mtx
expect 2 flatten slivers.mesh.off -o a.obj --matrix a.obj
rm a.* b.obj

# In the triangulation of the mesh nothing is flipped; where that cannot be, nothing is written.
expect 0 flatten square.mesh.off -o a.obj --solver cetm --stats a.json
is_conformal a.json
grep -q '"ptolemy_flips": 0,' a.json
grep -q '"flips": 0,' a.json
near "$(number a.json log_scale_max)" 0 1e-12
printf '0 %s\n' "$(awk -v p=$pi 'BEGIN { printf "%.17g", -1.5 * p }')" >cones
awk -v p=$pi 'BEGIN { for(v = 1; v < 4; ++v) printf "%d %.17g\n", v, 11 * p / 6 }' >>cones
expect 0 flatten regular.mesh.off -o a.obj --cones cones --stats a.json
is_conformal a.json
rm a.*
expect 1 flatten regular.mesh.off -o a.obj --cones cones --solver cetm
says 'the triangulation of the mesh has no such scale factors: no_minimum'
rm cones

# A tube with four faces around: each ring has a fifth of the size of the one before.
tube()
{
  awk -v n="$1" 'BEGIN {
    print "OFF\n" 4 * n + 4, 8 * n + 2, 0
    for(i = 0; i <= n; ++i) print "0 0 " i "\n1 0 " i "\n1 1 " i "\n0 1 " i
    for(i = 0; i < n; ++i)
      for(j = 0; j < 4; ++j) {
        a = 4 * i + j; b = 4 * i + (j + 1) % 4
        print 3, a, b, b + 4 "\n" 3, a, b + 4, a + 4
      }
    print 3, 4 * n, 4 * n + 1, 4 * n + 2 "\n" 3, 4 * n, 4 * n + 2, 4 * n + 3
  }' >"$2.mesh.off"
}
tube 5 short
expect 0 flatten short.mesh.off -o a.obj --cones none --stats a.json
is_conformal a.json
rm a.*
tube 60 tube
expect 1 flatten tube.mesh.off -o a.obj --cones none --stats a.json
says 'some faces are smaller than rounding in the plane: layout_collapsed'
[ ! -e a.obj ] && [ ! -e a.json ] || fail 'files after a failure'

# The Ceres Solver gives the same with fewer digits, or says that it is not there.
if "$program" flatten square.mesh.off -o a.obj --solver ceres --stats a.json --quiet 2>err; then
  expect 0 flatten torus.mesh.off -o a.obj --solver ceres --stats a.json
  expect 0 flatten torus.mesh.off -o a.obj --stats b.json
  for key in log_scale_min log_scale_max; do
    near "$(number a.json $key)" "$(number b.json $key)" 1e-5
  done
  rm a.* b.json
else
  says '--solver ceres: this program was built without the Ceres Solver'
fi
expect 2 flatten square.mesh.off -o a.obj --solver simplex

# bad FILE TEXT OPTIONS...: a file with these lines is refused, with this message.
bad()
{
  local text=$1
  printf '%b' "$2" >values
  shift 2
  expect 2 flatten "$@" -o a.obj
  says "$text"
  rm values
}

bad "values: line 2: '1x' is not a finite number" '# a\n1 1x\n' regular.mesh.off --cones values
bad "values: line 1: 'nan' is not a finite number" '1 nan\n' regular.mesh.off --cones values
bad 'values: line 1: is not "index value"' '1\n' regular.mesh.off --cones values
bad 'values: line 1: is not "index value"' '1 2 3\n' regular.mesh.off --cones values
bad 'values: line 1: is not "index value"' 'one 2\n' regular.mesh.off --cones values
bad 'values: line 1: there is no vertex 4; the vertices are 0 to 3' '4 1\n' regular.mesh.off --cones values
bad 'values: line 1: there is no vertex -1;' '-1 1\n' regular.mesh.off --cones values
bad 'values: line 3: vertex 1 is in line 1 already' '1 1\n2 1\n1 2\n' regular.mesh.off --cones values
bad 'values: line 1: vertex 0 is not inside the surface' '0 1\n' square.mesh.off --cones values
bad 'values: line 1: vertex 0 is not inside the surface' '0 1\n' isolated.mesh.off --cones values
bad 'values: line 1: vertex 10 is not on the boundary' '10 1\n' square.mesh.off --boundary scale values
bad 'values: line 1: vertex 10 is not on the boundary' '10 1\n' square.mesh.off --boundary curvature values
bad 'sum up to 5.28319 radians less than' '0 1\n' square.mesh.off --cones none --boundary curvature values
bad 'sum up to 0.716815 radians more than' '0 3\n8 3\n80 1\n' square.mesh.off --cones none --boundary curvature values
bad 'no angle is left at vertex 0' '0 7\n' regular.mesh.off --cones values

# Wrong calls.
expect 2 flatten slivers.mesh.off
expect 2 flatten good.mesh.obj -o good.mesh.obj
says 'never overwritten'
expect 2 flatten slivers.mesh.off -o a.off
says 'a.off: this format cannot carry texture coordinates (.obj, .ply and .vtp can)'
expect 2 flatten slivers.mesh.off -o - --format off
expect 2 flatten slivers.mesh.off -o a.obj --cones missing
says 'missing: cannot be opened'
expect 2 flatten regular.mesh.off -o a.obj --cones none --max-log-scale 3
expect 2 flatten regular.mesh.off -o a.obj --max-log-scale 0
expect 2 flatten square.mesh.off -o a.obj --boundary scale
says 'the name of a file is missing'
expect 2 flatten square.mesh.off -o a.obj --boundary disk free
expect 2 flatten square.mesh.off -o a.obj --boundary round
says "'round' is none of free, straight, scale, curvature, rectangle and disk"
for shape in rectangle disk; do
  expect 2 flatten regular.mesh.off -o a.obj --boundary $shape
  says 'regular.mesh.off: a component has no boundary'
done
expect 2 flatten needle.mesh.off -o a.obj --boundary rectangle
says 'too few vertices'
expect 2 flatten polygon.mesh.off -o a.obj
expect_files
[ "$(cksum <slivers.mesh.off)" = "$checksum" ] || fail 'the input was changed'

if [ -n "$data" ]; then
  for mesh in elephant.off diplodocus.off cube-ouvert.off sphere.stl blobby_3cc.off fandisk.off; do
    expect 0 flatten "$data/meshes/$mesh" -o mesh.obj --stats mesh.json
    is_conformal mesh.json
    ! grep -qi 'nan\|inf' mesh.obj || fail "$mesh has coordinates that are no numbers"
  done
  for shape in rectangle disk; do
    expect 0 flatten "$data/meshes/nefertiti.off" -o mesh.obj --boundary $shape --stats mesh.json
    is_conformal mesh.json
  done
fi
