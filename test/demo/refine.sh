#!/usr/bin/env bash
# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# Bounds, files, statistics and exit codes of the command refine.
source "$(dirname "${BASH_SOURCE[0]}")/common.bash"

# shape FILE: the least angle in degrees and the greatest circumradius of the intrinsic faces,
# measured in space. The length of an intrinsic edge is that of its parts in the common subdivision;
# its sides are among those of the parts of the face.
shape()
{
  awk '
    /^element/ { n[$2] = $3 }
    /^end_header/ { body = 1; next }
    !body { next }
    n["vertex"]-- > 0 { x[v + 0] = $1; y[v + 0] = $2; z[v++] = $3; next }
    n["face"]-- > 0 { face[f++] = $0; next }
    {
      d = sqrt((x[$1] - x[$2]) ^ 2 + (y[$1] - y[$2]) ^ 2 + (z[$1] - z[$2]) ^ 2)
      parent[$1, $2] = parent[$2, $1] = $4
      if($4 >= 0)
        length_of[$4] += d
    }
    function angle(a, b, c) { # opposite to a
      s = sqrt((a + b + c) * (b + c - a) * (a + b - c) * (a + c - b))
      return atan2(s, b * b + c * c - a * a) * 180 / 3.14159265358979
    }
    END {
      for(i = 0; i < f; ++i) {
        m = split(face[i], p, " ") - 3
        for(c = 0; c < m; ++c) {
          e = parent[p[c + 2], p[(c + 1) % m + 2]]
          if(e >= 0 && !((p[m + 3], e) in seen)) {
            seen[p[m + 3], e] = 1
            side[p[m + 3], count[p[m + 3]]++] = length_of[e]
          }
        }
      }
      least = 180
      for(t in count) {
        if(count[t] != 3)
          exit 1
        a = side[t, 0]; b = side[t, 1]; c = side[t, 2]
        for(k = 0; k < 3; ++k) {
          w = k == 0 ? angle(a, b, c) : k == 1 ? angle(b, c, a) : angle(c, a, b)
          if(w < least)
            least = w
        }
        if(a * b * c / s > radius)
          radius = a * b * c / s
      }
      printf "%.9g %.9g\n", least, radius
    }' "$1"
}

# is_at_least ANGLE FILE; positions have ten digits to spare for this.
is_at_least()
{
  shape "$2" | awk -v bound="$1" '{ exit !($1 >= bound - 1e-6) }' ||
    fail "$2 has the angle and radius $(shape "$2")"
}

# has_kinds PLY JSON: the kinds of vertices are as many as the statistics say, inserted vertices
# come between the other two, and those on an input edge end a part of it.
has_kinds()
{
  vertices "$1" | awk -v input="$(number "$2" vertices)" \
    -v inserted="$(number "$2" inserted_vertices)" -v crossings="$(number "$2" crossings)" '
    $4 != (NR <= input ? 0 : NR <= input + inserted ? 2 : 1) { ++bad }
    END { exit bad > 0 || NR != input + inserted + crossings }' || fail "kinds of vertices in $1"
  awk '
    /^element/ { n[$2] = $3 }
    /^end_header/ { body = 1; next }
    !body { next }
    n["vertex"]-- > 0 { if($4 == 2) edge[v + 0] = $6; ++v; next }
    n["face"]-- > 0 { next }
    { for(i = 1; i <= 2; ++i) if($i in edge && $3 >= 0) ++parts[$i, $3] }
    END {
      for(w in edge)
        if(edge[w] >= 0 && parts[w, edge[w]] != 2)
          exit 1
      for(key in parts) {
        split(key, k, SUBSEP)
        if(edge[k[1]] != k[2])
          exit 1
      }
    }' "$1" || fail "places of inserted vertices in $1"
}

# area FILE: of the flat polygons of a PLY file.
area()
{
  awk '
    /^element/ { n[$2] = $3 }
    /^end_header/ { body = 1; next }
    !body { next }
    n["vertex"]-- > 0 { x[v + 0] = $1; y[v++] = $2; next }
    n["face"]-- > 0 {
      for(c = 0; c < $1; ++c) {
        i = $(c + 2)
        j = $((c + 1) % $1 + 2)
        sum += x[i] * y[j] - x[j] * y[i]
      }
    }
    END { printf "%.9f\n", sum / 2 }' "$1"
}

cp "$shipped" slivers.mesh.off
expect 0 refine slivers.mesh.off -o a.ply --stats a.json --save a.save
[ ! -s out ] || fail 'standard output is not empty'
says 'vertices inserted (bounds_met)'
expect_files a.json a.ply a.save
is_at_least 25 a.ply
has_kinds a.ply a.json
[ "$(number a.json inserted_vertices)" -gt 0 ] || fail 'nothing inserted'
awk -v a="$(shape a.ply | cut -d ' ' -f 1)" -v b="$(number a.json min_angle_degrees)" \
  'BEGIN { exit !(a - b < 1e-6 && b - a < 1e-6) }' || fail 'min_angle_degrees'
paste <(vertices a.ply | head -n 1320) <(sed -n 3,1322p slivers.mesh.off) |
  awk '$1 != $(NF - 2) || $2 != $(NF - 1) || $3 != $NF { exit 1 }' || fail 'input vertices moved'
"$program" info a.ply >out || true
grep -q 'Euler characteristic  0' out || fail "bad subdivision: $(cat out)"

expected='command input vertices edges faces euler_characteristic boundary_loops components flips '
expected+='inserted_vertices faces_below_bound faces_excused status is_delaunay shared_edges crossings '
expected+='edge_length_sum min_angle_degrees subdivision vertices edges faces seconds read build flip '
expected+='refine trace subdivide write peak_memory_bytes '
[ "$(keys a.json)" = "$expected" ] || fail "keys: $(keys a.json)"
grep -q '"is_delaunay": true' a.json
grep -q '"status": "bounds_met"' a.json
grep -q '"faces_below_bound": 0,' a.json

# The same bytes once more, and in every format.
expect 0 refine slivers.mesh.off -o b.ply --save b.save --quiet
[ ! -s err ] || fail "not quiet: $(cat err)"
cmp a.ply b.ply
cmp a.save b.save
for format in ply off obj vtp; do
  expect 0 refine slivers.mesh.off -o "a.$format"
  expect 0 refine slivers.mesh.off -o - --format "$format"
  cmp "a.$format" out
done
rm a.* b.*

expect 0 refine slivers.mesh.off -o a.ply --min-angle 30
is_at_least 30 a.ply

# A parallelogram without narrow corners.
grid sheared 4 0.5
expect 0 refine sheared.mesh.off -o a.ply --max-circumradius 0.02 --stats a.json
has_kinds a.ply a.json
[ "$(area a.ply)" = 1.000000000 ] || fail "area $(area a.ply)"
is_at_least 25 a.ply
shape a.ply | awk '{ exit !($2 <= 0.02 * (1 + 1e-9)) }' || fail "radius: $(shape a.ply)"
expect 0 refine sheared.mesh.off -o a.ply --min-angle 0 --stats a.json
[ "$(number a.json inserted_vertices)" -eq 0 ] || fail 'insertions without a bound'

# Too narrow for the bound.
expect 0 refine needle.mesh.off -o - --stats a.json
says '(bounds_met_but_excused)'
[ "$(number a.json faces_excused)" -gt 0 ] || fail 'no excuse'
[ "$(number a.json faces_excused)" = "$(number a.json faces_below_bound)" ] || fail 'without excuse'

# A limit is kept and told.
expect 0 refine slivers.mesh.off -o a.ply --stats a.json --max-insertions 20
says '20 vertices inserted (insertion_limit)'
has_kinds a.ply a.json
[ "$(number a.json inserted_vertices)" -eq 20 ] || fail 'not the limit'
[ "$(number a.json faces_below_bound)" -gt 0 ] || fail 'no faces left'
[ "$(number a.json faces_excused)" -eq 0 ] || fail 'excused at no narrow vertex'
grep -q '"status": "insertion_limit"' a.json
expect 0 refine slivers.mesh.off -o a.ply --stats a.json --max-insertions 0
[ "$(number a.json inserted_vertices)" -eq 0 ] || fail 'not the limit'
rm a.*

# Handled, not refused.
expect 0 refine isolated.mesh.off -o -
sed -n 3p out | grep -qx '9 9 9' || fail 'the isolated vertex lost its place'
expect 0 refine two_components.mesh.off -o -
expect 0 refine cap.mesh.off -o -
expect 0 refine zero_length.mesh.off -o - --mollify 1e-6
expect 0 refine slivers.mesh.off -o - --constrain-angle 20

# Wrong calls.
expect 2 refine slivers.mesh.off
expect 2 refine slivers.mesh.off -o slivers.mesh.off
says 'never overwritten'
expect 2 refine slivers.mesh.off -o a.stl
expect 2 refine bow_tie.mesh.off -o a.ply
for angle in -1 61 nan many; do
  expect 2 refine slivers.mesh.off -o a.ply --min-angle=$angle
done
for radius in -1 0 nan; do
  expect 2 refine slivers.mesh.off -o a.ply --max-circumradius=$radius
done
for limit in -1 many; do
  expect 2 refine slivers.mesh.off -o a.ply --max-insertions=$limit
done
expect_files

# Refined before it is solved: eight times as wide as high, the cells of the grid are too.
grid cells 16 0
awk 'FNR > 2 && NF == 3 { $1 *= 8 } { print }' cells.mesh.off >wide.mesh.off
expect 0 distance wide.mesh.off --source 144 -o a.ply --subdivision b.ply --min-angle 30 --stats a.json
vertices a.ply | awk '
  {
    truth = sqrt(($1 - 4) ^ 2 + ($2 - 0.5) ^ 2)
    errors += $NF > truth ? $NF - truth : truth - $NF
    truths += truth
  }
  END { exit !(NR == 289 && errors <= 0.03 * truths) }' || fail 'distances after refinement'
grep -qF "\"max_distance\": $(vertices a.ply | awk '{ print $NF }' | sort -g | tail -n 1)" a.json
is_at_least 30 b.ply
cmp <(vertices b.ply | awk 'NR <= 289 { print $NF }') <(vertices a.ply | awk '{ print $NF }')
rm a.* b.*

# The sum of the masses is the area.
expect 0 operators wide.mesh.off --prefix w --min-angle 25 --stats w.json
rows=$(sed -n '2s/ .*//p' w_lumped_mass.mtx)
[ "$rows" -eq $((289 + $(number w.json inserted_vertices))) ] || fail "$rows rows"
awk 'NR > 2 { s += $3 } END { exit !(s > 8 - 1e-12 && s < 8 + 1e-12) }' w_lumped_mass.mtx ||
  fail 'the mass is not the area'
rm w_* w.json
for angle in -1 0 61; do
  expect 2 distance wide.mesh.off --source 0 -o a.ply --min-angle=$angle
  expect 2 operators wide.mesh.off --prefix w --min-angle=$angle
done
expect_files

if [ -n "$data" ]; then
  for mesh in elephant.off sphere.stl bones.off star.off; do
    expect 0 refine "$data/meshes/$mesh" -o mesh.ply --stats mesh.json
    grep -q '"status": "bounds_met' mesh.json || fail "$mesh: $(cat mesh.json)"
    has_kinds mesh.ply mesh.json
    [ "$(number mesh.json faces_below_bound)" -gt 0 ] || is_at_least 25 mesh.ply
  done
fi
