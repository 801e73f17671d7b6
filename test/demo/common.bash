# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# Shared by the tests of the program, which get its path and the directory of CGAL's data files:
# a scratch directory, which is the current one, and small meshes, good and broken.
set -euo pipefail

program=$(realpath "$1")
data=${2:+$(realpath "$2")}
tests=$(realpath "$(dirname "${BASH_SOURCE[0]}")")
shipped=$(realpath "$tests/../../demo/data/slivers.off")
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch"

fail()
{
  echo "FAILED: $*" >&2
  exit 1
}

# expect CODE ARGUMENTS...: runs the program; its output is left in out and err. All errors have one
# form; `info` prints the defects of a mesh instead.
expect()
{
  local code=$1 result=0
  shift
  "$program" "$@" >out 2>err || result=$?
  [ "$result" -eq "$code" ] || fail "intrinsic $* gave $result instead of $code: $(cat err)"
  [ "$code" -ne 1 ] && [ "$code" -ne 2 ] || grep -q '^intrinsic: ' err || { [ "$1" = info ] && ! [ -s err ]; } ||
    fail "intrinsic $* has an error of another form: $(cat err)"
}

# says TEXT: the last run wrote it to standard output or standard error.
says()
{
  grep -qF -- "$1" out err || fail "expected '$1' in: $(cat out err)"
}

# refuses TEXT ARGUMENTS...: the call is wrong, and the program says why.
refuses()
{
  expect 2 "${@:2}"
  says "$1"
}

# expect_files NAMES...: there is nothing but these beside the meshes, hidden files included.
expect_files()
{
  local found
  found=$(find . -maxdepth 1 -type f ! -name '*.mesh.*' ! -name out ! -name err -printf '%f\n' | sort)
  [ "$found" = "$(printf '%s\n' "$@" | sort)" ] || fail "unexpected files: $found"
}

# off NAME POINTS FACES: coordinates and indices are separated by spaces, elements by commas.
off()
{
  local points faces
  IFS=, read -ra points <<<"$2"
  IFS=, read -ra faces <<<"$3"
  {
    printf 'OFF\n%d %d 0\n' "${#points[@]}" "${#faces[@]}"
    printf '%s\n' "${points[@]}"
    for face in "${faces[@]}"; do
      echo "$(wc -w <<<"$face") $face"
    done
  } >"$1.mesh.off"
}

# grid NAME N SHEAR: the flat unit square as N x N cells (or, with a shear, a parallelogram as high with
# the same cells cut apart), each of them two triangles; vertex i of row j has the number (N + 1) j + i.
grid()
{
  awk -v n="$2" -v shear="$3" 'BEGIN {
    print "OFF\n" (n + 1) ^ 2, 2 * n * n, 0
    for(j = 0; j <= n; ++j)
      for(i = 0; i <= n; ++i)
        print (i + shear * j) / n, j / n, 0
    for(j = 0; j < n; ++j)
      for(i = 0; i < n; ++i) {
        v = (n + 1) * j + i
        print 3, v, v + 1, v + n + 2
        print 3, v, v + n + 2, v + n + 1
      }
  }' >"$1.mesh.off"
}

# rough NAME: a wave of 70 triangles over a sheared rectangle.
rough()
{
  awk 'BEGIN {
    print "OFF\n48 70 0"
    for(j = 0; j < 6; ++j)
      for(i = 0; i < 8; ++i)
        print i / 8 + (j % 2) / 3, j / 6, .06 * (i % 2 + 2 * (j % 3 == 1))
    for(j = 0; j < 5; ++j)
      for(i = 0; i < 7; ++i)
        print 3, 8 * j + i, 8 * j + i + 1, 8 * j + i + 9 "\n" 3, 8 * j + i, 8 * j + i + 9, 8 * j + i + 8
  }' >"$1.mesh.off"
}

# with_isolated NAME NEW: the mesh with one more vertex before all others, in no face.
with_isolated()
{
  awk 'NR == 2 { print $1 + 1, $2, 0 "\n9 9 9" } NR == 1 || NR > 2 && NF == 3 { print }
    NR > 2 && NF == 4 { print 3, $2 + 1, $3 + 1, $4 + 1 }' "$1.mesh.off" >"$2.mesh.off"
}

# claim EXPRESSIONS...: all are true, in the names of files.py.
claim()
{
  python3 "$tests/files.py" "$@" || fail "$(head -n 1 <<<"$1") ..."
}

surface_keys='command input vertices edges faces euler_characteristic boundary_loops components'
edge_keys='is_delaunay shared_edges crossings edge_length_sum min_angle_degrees'
subdivision_keys='subdivision vertices edges faces'
# has_keys FILE NAMES...: the names in a JSON file, in their order.
has_keys()
{
  claim "' '.join(keys(json('$1'))) == '${*:2}'"
}

# page_shows PAGE CLAIMS...: see browse.py.
page_shows()
{
  python3 "$tests/browse.py" "$@" || { [ $? -eq 77 ] && skip 'Chromium is missing'; fail "page $1"; }
}

skip()
{
  echo "SKIPPED: $*"
  exit 77
}

# needs_pages: ends the test if the program writes none.
needs_pages()
{
  local result=0
  "$program" view good.mesh.off -o needed.html 2>err || result=$?
  rm -f needed.html
  if [ "$result" -eq 2 ] && grep -q 'built without three.js' err; then
    skip 'the program was built without three.js'
  fi
}

square='0 0 0,1 0 0,1 1 0,0 1 0'
tetrahedron='0 0 0,1 0 0,0 1 0,0 0 1'
tetrahedron_faces='0 2 1,0 1 3,1 2 3,2 0 3'

off good "$tetrahedron" "$tetrahedron_faces"
off isolated "9 9 9,$tetrahedron" '1 3 2,1 2 4,2 3 4,3 1 4'
off two_components "$tetrahedron,5 0 0,6 0 0,5 1 0" "$tetrahedron_faces,4 5 6"
off cap '0 0 0,1 0 0,2 0 0,1 1 0' '0 1 3,1 2 3,0 2 1'
off needle '0 0 0,1 0 0,1 0.001 0' '0 1 2'

off polygon "$square" '0 1 2 3'
off repeated "$square" '0 1 2,0 2 2'
off edge_of_three "$square,0 0 1" '0 1 2,1 0 3,0 1 4'
off bow_tie "$square,5 5 5" '0 1 2,0 3 4'
off zero_length '0 0 0,1 0 0,1 0 0,0 1 0' '0 1 3,1 2 3'
printf 'OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 3 2\n' >orientation.mesh.off
printf 'OFF\n3 1 0\n0 0 0\n1 nan 0\n0 1 0\n3 0 1 2\n' >nan.mesh.off
printf 'OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n' >index.mesh.off
printf 'OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n' >truncated.mesh.off
printf 'OFF\n3 1 0\n0 0 0\n1 oops 0\n0 1 0\n3 0 1 2\n' >garbage.mesh.off
printf 'OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n' >no_faces.mesh.off
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n' >index.mesh.obj
printf 'ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement tristrips 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n' >index.mesh.ply
printf 'v -1e308 0 0\nv 1e308 0 0\nv 0 1 0\nf 1 2 3\n' >overflow.mesh.obj
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1/1 2/2 3/3\n' >good.mesh.obj
printf 'not a mesh\n' >words.mesh.obj
: >empty.mesh.off
printf 'something\n' >unknown.mesh.xyz
