#!/usr/bin/env bash
# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# Maps to the plane, their files, statistics and exit codes of the command flatten.
source "$(dirname "${BASH_SOURCE[0]}")/common.bash"

pi=3.14159265358979324

# is_conformal FILE: the statistics are those of a map that nothing is wrong with.
is_conformal()
{
  claim "s = json('$1')" "s.status == 'success'" \
    's.flipped_triangles == s.degenerate_triangles == 0' \
    'near(s.max_curvature_error, 0, 1e-10)' 'near(s.max_cross_ratio_error, 0, 1e-8)'
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
  claim "s = json('a.json')" "s.cones == 0" \
    'near([s.log_scale_min, s.log_scale_max, s.log_scale_square_sum], [0, 0, 0], 1e-12)' \
    "near(area(obj('a.obj')), 1, 1e-12)" "near(flat_area(obj('a.obj')), 1, 1e-12)"
done
expect 0 flatten square.mesh.off -o a.obj --boundary rectangle --stats a.json
claim "near(box(obj('a.obj').texture), [1, 1], 1e-12)" "near(json('a.json').log_scale_max, 0, 1e-12)"

# A rectangle ten times as long as wide has its own corners.
awk 'NF == 3 && NR > 2 { print 10 * $1, $2, $3; next } { print }' square.mesh.off >long.mesh.off
expect 0 flatten long.mesh.off -o a.obj --boundary rectangle --stats a.json
claim "near(box(obj('a.obj').texture), [10, 1], 1e-11)"

# Every parallelogram becomes a rectangle that its map fills.
expect 0 flatten sheared.mesh.off -o a.obj --boundary rectangle --stats a.json
is_conformal a.json
claim "m = obj('a.obj')" 'near(flat_area(m), box(m.texture)[0] * box(m.texture)[1], 1e-11)' \
  'near(flat_area(m), 1, 1e-11)'

# A square with equal quarters becomes a disk with its boundary vertices on a circle around the
# middle.
expect 0 flatten square.mesh.off -o a.ply --boundary disk --stats a.json
is_conformal a.json
claim "m = ply('a.ply')" \
  "z = {v: t[2 * i:2 * i + 2] for f, t in zip(m.faces, m.face['texcoord']) for i, v in enumerate(f)}" \
  'center = [fsum(z[v][k] for v in range(81)) / 81 for k in range(2)]' \
  'r = [dist(z[v], center) for v in range(81) if v < 9 or v > 71 or v % 9 in (0, 8)]' \
  'len(r) == 32' 'max(r) - min(r) < 1e-8 * max(r)'

# The cones of a regular tetrahedron: defects of pi at each vertex are its own.
printf '0 %s\n1 %s # comment\n\n# nothing\n2 %s\n3\t%s\r\n' $pi $pi $pi $pi >cones
expect 0 flatten regular.mesh.off -o a.obj --cones cones --stats a.json
is_conformal a.json
claim "s = json('a.json')" "s.cones == 4" 'near([s.log_scale_min, s.log_scale_max], [0, 0], 1e-12)' \
  "near([area(obj('a.obj')), flat_area(obj('a.obj'))], [8 * sqrt(3)] * 2, 1e-12)" # edges are sqrt(8)

# Nine digits of them miss the sum by 2.4e-9, which is no minimum: the failure is told, nothing is
# written.
rm a.obj
printf '%s 3.141592653\n' 0 1 2 3 >digits
expect 1 flatten regular.mesh.off -o a.obj --cones digits --stats b.json
says "the minimization has not converged (unbounded); error of curvature: 5.89"
says 'try '
[ ! -e a.obj ] && [ ! -e b.json ] || fail 'files after a failure'

# Unless it is wanted with what is wrong with it.
expect 3 flatten regular.mesh.off -o a.obj --cones digits --stats b.json --keep-going
says 'warning: the minimization has not converged (unbounded)'
claim "s = json('b.json')" "s.status == 'not_converged'" 's.promises.curvature.kept is False' \
  'near(s.promises.curvature.error, 5.89e-10, 1e-12)' 's.promises.curvature.bound == 1e-10' \
  's.promises.cross_ratio.kept is True' 'near(area(obj("a.obj")), 8 * sqrt(3), 1e-6)'
rm a.obj b.json digits
expect 0 flatten regular.mesh.off -o a.obj --cones cones --stats a.json --keep-going # a success
is_conformal a.json
claim "s = json('a.json')" 'all(p.kept for p in s.promises.values())'

# Three cones of 4 pi / 3 leave no curvature at the fourth vertex: by symmetry its edges, which
# three equal triangles share, have lengths in the ratio 1 / sqrt(3) to the others, so its scale
# factor is 1 / 3.
third=$(awk -v pi=$pi 'BEGIN { printf "%.17g", 4 * pi / 3 }')
printf '0 %s\n1 %s\n2 %s\n' "$third" "$third" "$third" >cones
expect 0 flatten regular.mesh.off -o a.obj --cones cones --stats a.json
is_conformal a.json
claim "s = json('a.json')" "near(s.log_scale_max - s.log_scale_min, log(3), 1e-9)" \
  "near(flat_area(obj('a.obj')), area(obj('a.obj')), 1e-9)"

# An empty file makes a torus flat, and so does none; elsewhere the curvature has to go somewhere.
printf '# nothing\n' >empty
for cones in empty none; do
  expect 0 flatten torus.mesh.off -o a.obj --cones $cones --stats a.json
  is_conformal a.json
  claim "json('a.json').cones == 0" "near(flat_area(obj('a.obj')), area(obj('a.obj')), 1e-9)"
  expect 2 flatten regular.mesh.off -o b.obj --cones $cones
  says 'prescribed on the surface sum up to 12.5664 radians less than 2 pi times its Euler char'
  says '(Gauss-Bonnet): cones can have the difference'
done

# Exterior angles of a triangle on the boundary of the square; straight elsewhere.
printf '0 %s\n8 %s\n80 %s\n' "$(awk -v p=$pi 'BEGIN { printf "%.17g", 2 * p / 3 }')"{,,} | tr -s '\n' >angles
[ "$(wc -l <angles)" -eq 3 ] || fail "angles: $(cat angles)"
expect 0 flatten square.mesh.off -o a.obj --boundary curvature --boundary-values angles --cones none --stats a.json
is_conformal a.json
claim "b = box(obj('a.obj').texture)" 'near(b[1] / b[0], sqrt(3) / 2, 1e-9)'

# Scaled by two on all of the boundary, a flat surface is scaled by two.
awk 'BEGIN { for(v = 0; v < 81; ++v)
  if(v < 9 || v > 71 || v % 9 == 0 || v % 9 == 8) printf "%d %.17g\n", v, log(2) }' >scales
expect 0 flatten square.mesh.off -o a.obj --boundary scale --boundary-values scales --stats a.json
is_conformal a.json
claim "near(json('a.json').log_scale_min, log(2), 1e-12)" "near(flat_area(obj('a.obj')), 4, 1e-11)"

# Circles. Those of a hexagon of touching circles stay; their radii are a property, or in a file.
off hexagon '0 0 0,2 0 0,1 2 0,-1 2 0,-2 0 0,-1 -2 0,1 -2 0' \
  '0 1 2,0 2 3,0 3 4,0 4 5,0 5 6,0 6 1'
expect 0 pack hexagon.mesh.off -o a.ply
for v in 0 1 2 3 4 5 6; do echo "$v 0.33333333333333333"; done >circles
for radii in radius circles; do
  expect 0 flatten a.ply --radii $radii -o b.ply --unit-square --stats a.json
  is_conformal a.json
  claim "s = json('a.json')" "r = list(ply('b.ply').vertex['radius'])" 's.cones == 0' \
    'near([s.log_scale_min, s.log_scale_max], [0, 0], 1e-10)' 'near(r[:7], [s.scale / 3] * 7, 1e-10)'
done
expect 0 flatten a.ply --radii circles --boundary rectangle -o b.ply --stats a.json
is_conformal a.json
# With a circle at every other vertex, a torus has another map; with radii of zero, the same bytes.
for v in $(seq 0 2 143); do echo "$v 0.1"; done >circles
for v in $(seq 0 143); do echo "$v 0"; done >zeros
expect 0 flatten torus.mesh.off -o a.ply --cones none
expect 0 flatten torus.mesh.off -o b.ply --cones none --radii zeros
cmp a.ply b.ply
expect 0 flatten torus.mesh.off -o b.ply --cones none --radii circles --stats a.json
is_conformal a.json
claim "a, b = [ply(f).vertex for f in ('a.ply', 'b.ply')]" "'radius' not in a" \
  "u, r = [list(b[k])[:144] for k in ('log_scale', 'radius')]" \
  "max(abs(x - y) for x, y in zip(u, list(a['log_scale']))) > 1e-5" \
  'near(r, [0 if v % 2 else exp(u[v]) / 10 for v in range(144)], 1e-12)'
rm a.* b.* circles zeros

# Components side by side; vertices without faces stay where they are.
# Exact decisions: a map that is certified; where one is not, the statistics say why.
expect 0 flatten "$shipped" -o a.obj --exact --stats a.json
claim "s = json('a.json')" 's.certified' 's.greatest_excess == 0' 's.exchanged_crossings == 0' \
  's.undecided_crossings == 0' 'sum(s.decisions.values()) >= 2 * s.edges'
expect 0 flatten square.mesh.off -o a.obj --boundary rectangle --exact --stats a.json
claim "s = json('a.json')" \
  's.certified or s.greatest_excess > 0 or s.exchanged_crossings + s.undecided_crossings > 0'
# An octahedron with a vertex at a distance of 1e-9 of an edge: on the surface of the positions, not
# of their rounded distances, which takes the vertex to be on the edge.
off thin '0 0 1,1 0 0,0 1 0,-1 0 0,0 -1 0,0 0 -1,0.499999999 0.5 1e-9' \
  '1 2 6,2 0 6,0 1 6,0 2 3,0 3 4,0 4 1,5 2 1,5 3 2,5 4 3,5 1 4'
expect 0 flatten thin.mesh.off -o a.obj --exact --stats a.json
claim "s = json('a.json')" 's.certified' 's.promises.rounded_curvature.error < 1e-8' \
  's.max_curvature_error < 1e-8' 's.max_cross_ratio_error < 1e-8'
expect 0 flatten two_components.mesh.off -o a.obj
expect 0 flatten isolated.mesh.off -o a.obj
[ "$(head -n 1 a.obj)" = 'v 9 9 9' ] || fail 'the isolated vertex lost its place'
expect 0 flatten zero_length.mesh.off -o a.obj --mollify 1e-3
rm a.* angles cones empty scales

cp "$shipped" slivers.mesh.off
checksum=$(cksum <slivers.mesh.off)
expect 0 flatten slivers.mesh.off -o a.ply --stats statistics.json
[ ! -s out ] || fail 'standard output is not empty'
promises=$(printf '%s error bound kept ' layout curvature exterior_angle orientation cross_ratio closing)
has_keys statistics.json $surface_keys cones iterations status promises $promises \
  max_curvature_error max_cross_ratio_error flipped_triangles degenerate_triangles flipped_slivers flipped_faces charts \
  overlap_area overlapping_charts log_scale_min log_scale_max log_scale_square_sum flips ptolemy_flips \
  $subdivision_keys crowded_faces seconds read build cones optimize layout trace subdivide write peak_memory_bytes
is_conformal statistics.json

# Cones are marked, as many as are told; each edge has two vertices and a mark.
claim "m = ply('a.ply')" "sum(m.vertex['is_cone']) == json('statistics.json').cones" \
  "len(m.face['texcoord']) == len(m.faces)" "set(m.edge['is_seam']) == {0, 1}"

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
claim "m = obj('out')" "len(set(m.texture)) == len(m.texture)" # equal corners share coordinates
mv out linear.obj
expect 0 flatten slivers.mesh.off -o a.obj --homogeneous
claim "near([x / t[2] for t in obj('a.obj').texture for x in t[:2]],
    [x for t in obj('linear.obj').texture for x in t], 1e-9)"
expect 0 flatten slivers.mesh.off -o a.vtp
claim "{tuple(t) for t in vtp('a.vtp')['PointData', 'texcoord']} == set(obj('linear.obj').texture)"
grep -q '<PointData TCoords="texcoord">' a.vtp

# The output covers the same surface.
for format in ply obj; do
  "$program" info "a.$format" >out || true
  grep -q 'Euler characteristic  0' out || fail "bad subdivision in a.$format: $(cat out)"
done
expect_files a.obj a.ply a.vtp linear.obj statistics.json
rm a.* statistics.json linear.obj

# The matrix takes the positions of the vertices of the mesh to those of the output.
expect 0 flatten slivers.mesh.off -o a.obj --matrix a.mtx
claim "a = mtx('a.mtx')" "a.header == '%%MatrixMarket matrix coordinate real general'" \
  "p = obj('a.obj').points" "(a.rows, a.columns) == (len(p), len(off('slivers.mesh.off').points))" \
  'near(a @ ([1] * a.columns), [1] * a.rows, 1e-12)' \
  'all(near(a @ list(x), y, 1e-12) for x, y in zip(zip(*p[:a.columns]), zip(*p)))'
expect 0 flatten slivers.mesh.off -o b.obj --matrix -
cmp out a.mtx
expect 2 flatten slivers.mesh.off -o a.obj --matrix a.obj
rm a.* b.obj

# In the triangulation of the mesh nothing is flipped; where that cannot be, nothing is written.
expect 0 flatten square.mesh.off -o a.obj --solver cetm --stats a.json
is_conformal a.json
claim "s = json('a.json')" "s.flips == s.ptolemy_flips == 0" 'near(s.log_scale_max, 0, 1e-12)'
printf '0 %s\n' "$(awk -v p=$pi 'BEGIN { printf "%.17g", -1.5 * p }')" >cones
awk -v p=$pi 'BEGIN { for(v = 1; v < 4; ++v) printf "%d %.17g\n", v, 11 * p / 6 }' >>cones
expect 0 flatten regular.mesh.off -o a.obj --cones cones --stats a.json
is_conformal a.json
rm a.*
expect 1 flatten regular.mesh.off -o a.obj --cones cones --solver cetm
says 'the triangulation of the mesh has no such scale factors (no_minimum)'
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
expect 0 flatten tube.mesh.off -o a.obj --cones none --stats a.json
says 'note: faces too small for coordinates in double: '
claim "s = json('a.json')" "s.status == 'success'" 'len(s.crowded_faces) > 0'
rm a.obj a.json

# The Ceres Solver gives the same, or the program says that it is not there.
if "$program" flatten square.mesh.off -o a.obj --solver ceres --stats a.json --quiet 2>err; then
  expect 0 flatten torus.mesh.off -o a.obj --solver ceres --stats a.json
  expect 0 flatten torus.mesh.off -o a.obj --stats b.json
  claim "all(near(json('a.json')[k], json('b.json')[k], 1e-9) for k in ('log_scale_min', 'log_scale_max'))"
  rm a.* b.json
else
  says '--solver ceres: this program was built without the Ceres Solver'
fi

# bad FILE TEXT OPTIONS...: a file with these lines is refused, with this message.
bad()
{
  printf '%b' "$2" >values
  refuses "$1" flatten "${@:3}" -o a.obj
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
bad 'values: line 1: vertex 10 is not on the boundary' '10 1\n' square.mesh.off --boundary scale --boundary-values values
bad 'values: line 1: vertex 10 is not on the boundary' '10 1\n' square.mesh.off --boundary curvature --boundary-values values
bad 'sum up to 5.28319 radians less than' '0 1\n' square.mesh.off --cones none --boundary curvature --boundary-values values
bad 'sum up to 0.716815 radians more than' '0 3\n8 3\n80 1\n' square.mesh.off --cones none --boundary curvature --boundary-values values
bad '(Gauss-Bonnet): a cone inside or other exterior angles can have the difference' '0 1\n' square.mesh.off --cones none --boundary curvature --boundary-values values
off fan '0 0 0.3,1 0 0,0 1 0,-1 0 0,0 -1 0' '0 1 2,0 2 3,0 3 4,0 4 1'
bad '(Gauss-Bonnet): the cones, and vertices with prescribed scale factors, are too few' '' fan.mesh.off --boundary straight
bad 'no angle is left at vertex 0' '0 7\n' regular.mesh.off --cones values

expect_files
[ "$(cksum <slivers.mesh.off)" = "$checksum" ] || fail 'the input was changed'

# A strip that winds around an axis 1.4 times, flattened without scaling, covers a part of the plane
# twice, unless it is cut.
python3 -c '
from math import *
n = 30
print("OFF\n%d %d 0" % (2 * n + 2, 2 * n))
for i in range(n + 1):
  for r in 1, 1.5:
    print(r * cos(0.3 * i), r * sin(0.3 * i), 0.1 * i)
for i in range(0, 2 * n, 2):
  print(3, i, i + 1, i + 3)
  print(3, i, i + 3, i + 2)' >winding.mesh.off
expect 0 flatten winding.mesh.off -o a.obj --cones none --stats a.json
says 'covered more than once'
claim "s = json('a.json')" "near(s.overlap_area, overlap(obj('a.obj')), 1e-9)" 's.overlap_area > 0.1' \
  '(s.charts, s.overlapping_charts) == (1, [[0, 0]])'
for layout in least-squares spectral incremental; do
  expect 0 flatten winding.mesh.off -o $layout.obj --cones none --layout $layout --stats b.json
  is_conformal b.json
  claim "a, b = obj('a.obj'), obj('$layout.obj')" 'near(flat_area(a), flat_area(b), 1e-9)' \
    'near(overlap(a), overlap(b), 1e-9)' 'a.faces == b.faces'
done
cmp a.obj least-squares.obj # the default
expect 2 flatten winding.mesh.off -o b.obj --layout round
expect 0 flatten winding.mesh.off -o b.obj --cones none --no-overlap --stats b.json
claim "s = json('b.json')" '(s.charts, s.overlap_area, s.overlapping_charts) == (2, 0, [])' \
  "a, b = obj('a.obj'), obj('b.obj')" 'overlap(b) < 1e-9' 'near(flat_area(a), flat_area(b), 1e-9)' \
  'a.points == b.points' 'a.faces == b.faces'
expect 0 flatten winding.mesh.off -o b.obj --cones none --no-overlap --unit-square --stats b.json
claim "s, m = json('b.json'), obj('b.obj')" 'overlap(m) < 1e-9' \
  "near(flat_area(m), flat_area(obj('a.obj')) * s.scale ** 2, 1e-9)" \
  'max(box(m.texture)) <= 1 < max(box(m.texture)) + 1e-9'
expect 0 flatten slivers.mesh.off -o b.obj --no-overlap --stats b.json
claim "json('b.json').overlap_area == 0"
rm a.* b.* least-squares.* spectral.* incremental.*

# The last line has two numbers of flips, which help explains.
grid twisted 4 1.5
expect 0 flatten twisted.mesh.off -o a.obj --stats a.json
claim "s = json('a.json')" "' %d + %d flips, ' % (s.flips, s.ptolemy_flips) in open('out').read() + open('err').read()" \
  's.flips > 0'
expect 0 flatten --help
says '"flips" and "ptolemy_flips" in the statistics'
rm a.*

# The bound on scale factors holds inside, and not on the boundary.
if [ -n "$data" ]; then
  expect 0 flatten --help
  says 'all logarithmic scale factors inside are at most this; 5 by default. It is no bound on the boundary'
  expect 0 flatten "$data/meshes/nefertiti.off" -o a.ply --boundary disk --cones greedy --max-log-scale 0.2
  claim "f = off('$data/meshes/nefertiti.off').faces" \
    'sides = Counter(frozenset((t[i - 1], t[i])) for t in f for i in range(3))' \
    'border = {v for side, n in sides.items() if n == 1 for v in side}' \
    "u = list(enumerate(ply('a.ply').vertex['log_scale'][:1 + max(map(max, f))]))" \
    'max(abs(x) for v, x in u if v not in border) <= 0.2' 'max(abs(x) for v, x in u if v in border) > 0.2'
  rm a.ply
fi

if [ -n "$data" ]; then
  for mesh in elephant.off diplodocus.off cube-ouvert.off sphere.stl blobby_3cc.off fandisk.off; do
    expect 0 flatten "$data/meshes/$mesh" -o mesh.obj --stats mesh.json
    is_conformal mesh.json
    claim "is_harmless('mesh.obj')"
  done
  for shape in rectangle disk; do
    expect 0 flatten "$data/meshes/nefertiti.off" -o mesh.obj --boundary $shape --stats mesh.json
    is_conformal mesh.json
  done
fi
