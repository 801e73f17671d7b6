#!/usr/bin/env bash
# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# Distances, their files, statistics and exit codes of the command distance.
source "$(dirname "${BASH_SOURCE[0]}")/common.bash"

# is_euclidean FILE SOURCE: on a flat convex mesh the last property of the vertices is the distance
# to vertex SOURCE, up to what the heat method is known to miss: three percent on average.
is_euclidean()
{
  vertices "$1" | awk -v s="$2" '
    { x[NR - 1] = $1; y[NR - 1] = $2; distance[NR - 1] = $NF }
    END {
      for(v = 0; v < NR; ++v) {
        truth = sqrt((x[v] - x[s]) ^ 2 + (y[v] - y[s]) ^ 2)
        error = distance[v] > truth ? distance[v] - truth : truth - distance[v]
        errors += error
        truths += truth
        if(error > 0.1 * sqrt((x[NR - 1] - x[0]) ^ 2 + (y[NR - 1] - y[0]) ^ 2))
          exit 1
      }
      exit !(distance[s] == 0 && errors <= 0.03 * truths)
    }' || fail "$1 does not hold the distances to vertex $2"
}

grid square 40 0
grid sheared 40 2
for source in 0 840 1100; do
  for mesh in square sheared; do
    expect 0 distance $mesh.mesh.off --source $source -o a.ply --subdivision b.ply --quiet
    is_euclidean a.ply $source
    is_euclidean b.ply $source
  done
done

# The input again, with one more number for each vertex; the subdivision has the same numbers there,
# and between two of them on the edges.
vertices a.ply | awk '{ print $1, $2, $3 }' | cmp - <(sed -n 3,1683p sheared.mesh.off)
sed '1,/^end_header/d' a.ply | tail -n +1682 | cmp - <(tail -n +1684 sheared.mesh.off)
vertices b.ply | awk 'NR <= 1681 { print $NF }' | cmp - <(vertices a.ply | awk '{ print $NF }')
[ "$(vertices b.ply | wc -l)" -gt 1681 ] || fail 'no crossings'

# Mirrored in the diagonal, the square is itself, and so are the distances to a vertex on the
# diagonal.
expect 0 distance square.mesh.off --source 0 -o a.ply
vertices a.ply | awk '
  { distance[NR - 1] = $NF }
  END {
    for(j = 0; j <= 40; ++j)
      for(i = 0; i <= j; ++i) {
        difference = distance[41 * j + i] - distance[41 * i + j]
        if(difference > 1e-9 || difference < -1e-9) # the condition of the matrices times 1e-16
          exit 1
      }
  }' || fail 'the distances are not symmetric'

# Several sources: the nearest counts.
expect 0 distance square.mesh.off --source 0 --source 1680 -o a.ply --stats a.json
vertices a.ply | awk '
  {
    near = sqrt($1 ^ 2 + $2 ^ 2)
    far = sqrt((1 - $1) ^ 2 + (1 - $2) ^ 2)
    truth = near < far ? near : far
    errors += $NF > truth ? $NF - truth : truth - $NF
    truths += truth
  }
  END { exit !(errors <= 0.03 * truths) }' || fail 'not the distance to the nearest source'

cp "$shipped" slivers.mesh.off
expect 0 distance slivers.mesh.off --source 7 -o - --subdivision b.vtp --stats statistics.json
expected='command input vertices edges faces euler_characteristic boundary_loops components flips '
expected+='is_delaunay shared_edges crossings edge_length_sum min_angle_degrees sources max_distance '
expected+='unreachable_vertices subdivision vertices edges faces seconds read build flip solve trace '
expected+='subdivide write peak_memory_bytes '
[ "$(keys statistics.json)" = "$expected" ] || fail "keys: $(keys statistics.json)"
grep -q '"is_delaunay": true' statistics.json
grep -qF "\"max_distance\": $(vertices out | awk '{ print $NF }' | sort -g | tail -n 1)" statistics.json
rm a.* b.* statistics.json

# The same bytes on standard output, the same numbers in each format.
expect 0 distance slivers.mesh.off --source 7 -o a.vtp --save a.save --quiet
[ ! -s err ] || fail "not quiet: $(cat err)"
expect 0 distance slivers.mesh.off --source 7 -o - --format vtp --quiet
cmp a.vtp out
expect 0 distance slivers.mesh.off --source 7 -o - --quiet
sed '1,/Name="distance"/d; /<\/DataArray>/,$d' a.vtp | cmp - <(vertices out | awk '{ print $NF }')
expect_files a.save a.vtp
rm a.*

# distances MESH NUMBERS...: to vertex 0, as long as all are zero, one or -1.
distances()
{
  local mesh=$1
  shift
  vertices "$mesh" | awk '{ print $NF == 0 || $NF == -1 ? $NF : "+" }' | cmp - <(printf '%s\n' "$@") ||
    fail "distances in $mesh: $(vertices "$mesh")"
}

# What cannot be reached is said, in the files too.
expect 0 distance two_components.mesh.off --source 0 -o a.ply --subdivision b.ply --stats a.json
says '3 vertices out of reach (distance -1)'
grep -q '"unreachable_vertices": 3,' a.json
distances a.ply 0 + + + -1 -1 -1
distances b.ply 0 + + + -1 -1 -1
expect 0 distance two_components.mesh.off --source 0 --source 5 -o a.ply
distances a.ply 0 + + + + 0 +
expect 0 distance isolated.mesh.off --source 0 -o a.ply
distances a.ply 0 -1 -1 -1 -1
expect 0 distance isolated.mesh.off --source 0 -o a.ply --repair
distances a.ply 0 + + +
rm a.* b.*

# A face without area has no heat equation, unless it is mollified.
off flat '0 0 0,1 0 0,2 0 0' '0 1 2'
expect 1 distance flat.mesh.off --source 0 -o a.ply
expect 0 distance flat.mesh.off --source 0 -o - --mollify 1e-3
expect 0 distance zero_length.mesh.off --source 0 -o - --mollify 1e-3
expect 0 distance slivers.mesh.off --source 0 -o - --time-step 4

# Wrong calls.
expect 2 distance slivers.mesh.off -o a.ply
expect 2 distance slivers.mesh.off --source 0
for source in 1320 -1 99999999999; do
  expect 2 distance slivers.mesh.off --source=$source -o a.ply
  says "slivers.mesh.off: there is no vertex $source to be a source; the vertices are 0 to 1319"
done
expect 2 distance slivers.mesh.off --source one -o a.ply
for path in a.off a.obj; do
  expect 2 distance slivers.mesh.off --source 0 -o $path
  says "$path: this format cannot carry distances (.ply and .vtp can)"
  expect 2 distance slivers.mesh.off --source 0 -o a.ply --subdivision $path
done
expect 2 distance slivers.mesh.off --source 0 -o - --format off
expect 2 distance slivers.mesh.off --source 0 -o a.stl
expect 2 distance slivers.mesh.off --source 0 -o a.ply --subdivision a.ply
expect 2 distance slivers.mesh.off --source 0 -o a.ply --time-step 0
expect 2 distance polygon.mesh.off --source 0 -o a.ply
expect_files

if [ -w /dev/full ]; then
  expect 1 distance slivers.mesh.off --source 0 -o a.ply --subdivision b.ply --stats /dev/full
  expect_files
fi

if [ -n "$data" ]; then
  for mesh in elephant.off cube-ouvert.off sphere.stl colored_tetra.ply; do
    expect 0 distance "$data/meshes/$mesh" --source 0 -o mesh.ply
    ! grep -qi 'nan\|inf' mesh.ply || fail "$mesh has distances that are no numbers"
  done
fi
