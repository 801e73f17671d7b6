#!/usr/bin/env bash
# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# Functions at vertices, normals, colors and texture coordinates of the input are in all outputs.
source "$(dirname "${BASH_SOURCE[0]}")/common.bash"

# with_data FROM TO [explode]: the mesh as PLY and OBJ with linear functions, normals and texture
# coordinates. If exploded, each face has a chart of its own, all edges are seams, and no two faces
# share a point; every third face is reversed, and there are an isolated point and a degenerate face.
with_data()
{
  PYTHONPATH=$tests python3 - "$@" <<'PYTHON'
import sys
from files import data_of, off, texture_of
name, to, explode = sys.argv[1], sys.argv[2], len(sys.argv) > 3
mesh = off(name)
points, faces = mesh.points, mesh.faces
if explode:
    points = [points[v] for f in faces for v in f] + [points[faces[0][0]], (90, 90, 90)]
    faces = [list(range(3 * i, 3 * i + 3)) for i in range(len(faces))]
charts = [i if explode else 0 for i in range(len(faces))]
if explode:
    faces = [f[::-1] if i % 3 == 0 else f for i, f in enumerate(faces)] + [[0, 1, len(points) - 2]]
    charts.append(-1)
words = lambda numbers: " ".join(map(repr, numbers))
with open(to + ".mesh.ply", "w") as out:
    print("ply\nformat ascii 1.0\nelement vertex", len(points), file=out)
    for x in ["double x", "double y", "double z", "uchar red", "uchar green", "uchar blue",
              "uchar alpha", "double f", "int constant", "double nx", "double ny", "double nz"]:
        print("property", x, file=out)
    print("element face", len(faces), file=out)
    print("property list uchar double texcoord\nproperty list uchar int vertex_indices\nend_header", file=out)
    for p in points:
        print(words(p), "10 250 30 255", words(data_of(p)), file=out)
    for f, chart in zip(faces, charts):
        texture = [x for v in f for x in texture_of(points[v], chart)]
        print(len(texture), words(texture), len(f), words(f), file=out)
with open(to + ".mesh.obj", "w") as out:
    for p in points:
        print("v", words(p), words([10 / 255, 250 / 255, 30 / 255]), file=out)
        print("vn", words(data_of(p)[2:]), file=out)
    i = 0
    for f, chart in zip(faces, charts):
        for v in f:
            print("vt", words(texture_of(points[v], chart)), "0", file=out)
        print("f", *(f"{v + 1}/{i + k + 1}/{v + 1}" for k, v in enumerate(f)), file=out)
        i += len(f)
PYTHON
}

with_data "$shipped" slivers
grid sheared 12 2.3
grid plain 8 0
with_data sheared.mesh.off sheared
with_data sheared.mesh.off charts explode
with_data "$shipped" broken explode

# ---- Every vertex has the values that are linear in its position, and every corner ----

for command in delaunay 'refine --min-angle 25' 'refine --min-angle 25 --simplicial' \
  'refine --max-circumradius 0.1' 'simplify --vertices 40' 'simplify --vertices 40 --refine 25' \
  'simplify --vertices 40 --min-angle 25' flatten 'flatten --homogeneous' 'flatten --boundary disk'; do
  for mesh in slivers sheared; do
    [[ $command != *disk* ]] || [ $mesh = sheared ] || continue
    words=($command)
    expect 0 "${words[0]}" $mesh.mesh.ply "${words[@]:1}" -o a.ply --quiet
    texture=texcoord
    [[ $command != flatten* || $command = *homo* ]] || texture=input_texcoord
    claim "m = ply('a.ply')" "has_data(m, m.points, '$texture')"
  done
done

expect 0 distance slivers.mesh.ply -o a.ply --source 0 --subdivision b.ply --min-angle 25
claim "m = ply('a.ply')" "has_data(m, m.points, 'texcoord')" "'distance' in m.vertex"
claim "m = ply('b.ply')" "has_data(m, m.points, 'texcoord')" "'distance' in m.vertex"

off octahedron '1 0 0,-1 0 0,0 1 0,0 -1 0,0 0 1,0 0 -1' '0 2 4,2 1 4,1 3 4,3 0 4,2 0 5,1 2 5,3 1 5,0 3 5'
with_data octahedron.mesh.off octahedron
expect 0 sphere octahedron.mesh.ply -o a.ply
claim "m = ply('a.ply')" "p = list(zip(*(m.vertex['input_' + x] for x in 'xyz')))" "has_data(m, p, 'texcoord')"

# Coarse meshes have the functions, at inserted vertices too.
for options in '--vertices 40' '--vertices 4' '--vertices 40 --refine 25' '--vertices 40 --min-angle 25'; do
  expect 0 simplify slivers.mesh.ply $options --coarse a.ply --stats a.json
  claim "m = ply('a.ply')" 'has_functions(m, m.points)' "'texcoord' not in m.face"
done
expect 0 simplify slivers.mesh.ply --vertices 4 --coarse a.ply --stats a.json
claim "json('a.json').coarse_mesh.inserted_vertices > 0" "-1 in ply('a.ply').vertex['input_vertex']"
rm a.json

# Loops that are closed and handles that are cut have vertices and faces of their own.
expect 0 simplify sheared.mesh.ply -o a.ply --vertices 60 --close-loops 100
claim "m = ply('a.ply')" "len(m.vertex['f']) == len(m.points)" "set(m.vertex['constant']) == {7}"

# ---- Each face has the chart of its input face ----

for command in delaunay 'refine --min-angle 25' 'simplify --vertices 40' 'simplify --vertices 40 --min-angle 25' \
  'flatten --homogeneous'; do
  expect 0 $command charts.mesh.ply -o a.ply --repair --quiet
  claim "m = ply('a.ply')" "has_data(m, m.points, 'texcoord', m.face['input_face'])"
  expect 0 $command charts.mesh.ply -o a.ply --repair --quiet
  expect 0 $command broken.mesh.ply -o a.ply --repair --quiet
  claim "m = ply('a.ply')" "has_data(m, m.points, 'texcoord', m.face['input_face'])"
done
# No face of a simplicial mesh crosses a seam: neither one of all edges nor one that flips would cross.
by_chart="charts = [round((t[0] - texture_of(m.points[f[0]])[0]) / 10) for t, f in zip(m.face['texcoord'], m.faces)]"
expect 0 refine charts.mesh.ply -o a.ply --repair --simplicial --min-angle 20 --quiet
claim "m = ply('a.ply')" "$by_chart" "has_data(m, m.points, 'texcoord', charts)" "len(set(charts)) == 2 * 12 ** 2"
PYTHONPATH=$tests python3 - >halves.mesh.obj <<'PYTHON'
from files import off, texture_of
mesh = off("sheared.mesh.off")
corners = []
for i, f in enumerate(mesh.faces): # 24 in a row
    for v in f:
        t = texture_of(mesh.points[v], int(i % 24 >= 12))
        corners.append(f"{v + 1}/{len(corners) + 1}")
        print("vt", *map(repr, t))
for p in mesh.points:
    print("v", *map(repr, p))
for i in range(len(mesh.faces)):
    print("f", *corners[3 * i:3 * i + 3])
PYTHON
expect 0 refine halves.mesh.obj -o a.ply --simplicial
claim "m = ply('a.ply')" "$by_chart" "set(charts) == {0, 1}" \
  "all(near(t, [x for v in f for x in texture_of(m.points[v], c)], 1e-9) for t, f, c in zip(m.face['texcoord'], m.faces, charts))" \
  "all((sum(m.points[v][0] - 2.3 * m.points[v][1] for v in f) / 3 > 1 / 2) == c for f, c in zip(m.faces, charts))"
expect 0 refine halves.mesh.obj -o a.off --simplicial
expect 0 refine sheared.mesh.off -o b.off --simplicial
cmp a.off b.off # has no texture, and so no seams

# A point has as many texture coordinates as there are charts around it, in VTP as many copies.
expect 0 delaunay charts.mesh.obj -o a.obj --repair --quiet
for format in ply vtp; do
  expect 0 delaunay charts.mesh.ply -o a.$format --repair --quiet
done
claim "m = ply('a.ply')" "n = len({(v, c) for f, c in zip(m.faces, m.face['input_face']) for v in f})" \
  "len(obj('a.obj').texture) == n" "a = vtp('a.vtp')" "p = a['Points', 'Points']" "len(p) == n" \
  "len(a['PointData', 'texcoord']) == n" "len(a['PointData', 'f']) == n" \
  "all(near(a['PointData', 'texcoord'][v], texture_of(p[v], c), 1e-9) for f, (c,) in zip(a['Polys', 'connectivity'], a['CellData', 'input_face']) for v in f)"

# ---- Formats ----

# The input as it is, in each format and back.
expect 0 distance slivers.mesh.ply -o a.ply --source 0
expect 0 distance a.ply -o b.ply --source 0
claim "a, b = ply('a.ply'), ply('b.ply')" "b.face == a.face" \
  "all(b.vertex[x] == a.vertex[x] for x in a.vertex)" "b.vertex['input_distance'] == a.vertex['distance']"
expect 0 distance slivers.mesh.obj -o b.ply --source 0
claim "a, b = ply('a.ply'), ply('b.ply')" "b.face['texcoord'] == a.face['texcoord']" \
  "all(b.vertex[x] == a.vertex[x] for x in ('red', 'green', 'blue', 'nx', 'ny', 'nz'))"
expect 0 delaunay slivers.mesh.ply -o a.obj
expect 0 delaunay slivers.mesh.obj -o b.obj
cmp a.obj b.obj
expect 0 delaunay slivers.mesh.ply -o a.off
expect 0 delaunay "$shipped" -o b.off
cmp a.off b.off
expect 0 delaunay slivers.mesh.ply -o a.ply --binary
expect 0 delaunay slivers.mesh.ply -o b.ply
claim "ply('a.ply') == ply('b.ply')"
grep -a -q 'property uchar alpha' a.ply

printf 'CNOFF\n3 1 0\n0 0 0 0 0 1 255 0 9\n1 0 0 0 0 1 0.5 0 0.25 1\n0 1 0 0 1 0 3\n3 0 1 2\n' >a.mesh.off
expect 0 distance a.mesh.off -o a.ply --source 0
claim "v = ply('a.ply').vertex" "v['red'][:2] == [255, 127]" "v['nz'] == [1, 1, 0]" "'alpha' not in v"
printf 'STOFF\n3 1 0\n0 0 0 .25 1\n1 0 0 .5 1\n0 1 0 .75 0\n3 0 1 2\n' >a.mesh.off
expect 0 distance a.mesh.off -o a.ply --source 0
claim "ply('a.ply').face['texcoord'] == [[.25, 1, .5, 1, .75, 0]]"
printf 'ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nproperty float s\nproperty float t\nproperty float kind\nproperty float <a&b>\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0 1 2 5 6\n1 0 0 3 4 5 6\n0 1 0 5 6 5 6\n3 0 1 2\n' >a.mesh.ply
expect 0 delaunay a.mesh.ply -o a.obj
claim "obj('a.obj').texture == [(1, 2), (3, 4), (5, 6)]"
expect 0 delaunay a.mesh.ply -o a.ply
claim "v = ply('a.ply').vertex" "v['kind'] == [0, 0, 0]" "v['input_kind'] == [5, 5, 5]" "v['s'] == [1, 3, 5]"
expect 0 delaunay a.mesh.ply -o a.vtp
grep -q 'Name="&#60;a&#38;b&#62;"' a.vtp

# A crease: normals differ at the points of the diagonal. A corner has no texture coordinates.
printf 'v 0 0 0\nv 1 0 0\nv 1 1 1\nv 0 1 0\nvn 0 0 1\nvn 0 1 0\nvt 1 2\nvt 3 4\nf 1/1/1 2/2/1 3//1\nf 1/1/2 3//2 4/2/2\n' >a.mesh.obj
expect 0 delaunay a.mesh.obj -o a.ply
claim "f = ply('a.ply').face" "f['normal'] == [[0, 0, 1] * 3, [0, 1, 0] * 3]" "sorted(map(sorted, f['texcoord'])) == [[0, 0, 1, 2, 3, 4]] * 2"
expect 0 delaunay a.mesh.obj -o a.obj
claim "[w for w in lines_of('a.obj') if w.startswith('f')][0].count('//') == 1"
expect 0 delaunay a.mesh.obj -o a.vtp
claim "len(vtp('a.vtp')['Points', 'Points']) == 6"

# Polygons are split with their corners.
printf 'v 0 0 0\nv 2 0 0\nv 2 1 0\nv 1 .2 0\nv 0 1 0\nvt 0 0\nvt 2 0\nvt 2 1\nvt 1 .2\nvt 0 1\nf 1/1 2/2 3/3 4/4 5/5\n' >a.mesh.obj
for repair in '' --repair; do
  expect 0 refine a.mesh.obj -o a.ply --min-angle 25 $repair
  claim "m = ply('a.ply')" "all(near(t, [x for v in f for x in m.points[v][:2]], 1e-12) for t, f in zip(m.face['texcoord'], m.faces))"
done

# Of points that are merged, the first counts.
printf 'ply\nformat ascii 1.0\nelement vertex 6\nproperty float x\nproperty float y\nproperty float z\nproperty float h\nelement face 2\nproperty list uchar int vertex_indices\nend_header\n0 0 0 1\n1 0 0 2\n0 1 0 3\n1 0 0 20\n1 1 0 4\n0 1 0 30\n3 0 1 2\n3 3 4 5\n' >a.mesh.ply
expect 0 distance a.mesh.ply -o a.ply --source 0 --repair
claim "ply('a.ply').vertex['h'] == [1, 2, 3, 4]"

# A tufted cover has the data of what it covers.
printf 'ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\nproperty float z\nproperty float h\nelement face 3\nproperty list uchar int vertex_indices\nproperty list uchar float texcoord\nend_header\n0 0 0 0\n1 0 0 1\n0 1 0 1\n0 -1 0 -1\n0 0 1 1\n3 0 1 2 6 0 0 1 0 0 1\n3 0 1 3 6 5 0 6 0 5 -1\n3 0 1 4 6 9 0 10 0 9 0\n' >a.mesh.ply
expect 0 distance a.mesh.ply -o a.ply --source 0 --subdivision b.ply
claim "m = ply('b.ply')" "all(near(h, sum(p), 1e-12) for h, p in zip(m.vertex['h'], m.points))" \
  "all(near(t, [x for v in f for x in (m.points[v][0] + [0, 5, 9][i], m.points[v][1])], 1e-12) for t, f, i in zip(m.face['texcoord'], m.faces, m.face['input_face']))"
claim "ply('a.ply').face['texcoord'][1] == [5, 0, 6, 0, 5, -1]"

# ---- Groups of .obj files ----

# Faces have the group of the face of the input that they are part of; one lies in none yet.
{
  printf 'mtllib a.mtl b.mtl\n'
  awk 'NR > 2 && NF == 3 { print "v", $0 }
    NR > 2 && NF == 4 {
      n++
      if(n == 20) print "o  grid"
      if(n % 30 == 7) print "usemtl", (n % 60 > 30 ? "red paint # of the" : "blue")
      if(n % 50 == 9) print "g left", n
      print "f", $2 + 1, $3 + 1, $4 + 1
    }' sheared.mesh.off
} >groups.mesh.obj
same_groups="all(g.get(k, []) == i.groups[f].get(k, []) for g, f in zip(o.groups, parents, strict=True) for k in ('o', 'g', 'usemtl'))"
for command in 'delaunay --exact' 'refine --min-angle 25' 'simplify --vertices 40' \
  'simplify --vertices 40 --min-angle 25' 'flatten --boundary disk' 'delaunay --repair'; do
  for format in obj ply; do
    expect 0 ${command%% *} groups.mesh.obj -o a.$format --quiet ${command#* }
  done
  claim "i, o, parents = obj('groups.mesh.obj'), obj('a.obj'), ply('a.ply').face['input_face']" "$same_groups" \
    "o.libraries == [['a.mtl', 'b.mtl']]" "len({tuple(g.get('usemtl', [])) for g in o.groups}) == 3"
done
# Of the polygons of an output, too.
expect 0 delaunay groups.mesh.obj -o a.obj
for format in obj ply; do
  expect 0 delaunay a.obj -o b.$format --quiet
done
claim "i, o, parents = obj('a.obj'), obj('b.obj'), ply('b.ply').face['input_polygon']" "$same_groups"
expect 0 refine groups.mesh.obj -o a.obj --simplicial
claim "o = obj('a.obj')" "len({tuple(g.get('usemtl', [])) for g in o.groups}) == 3"

# Repair removes a face and splits a polygon; so does the program without it.
printf 'v 0 0 0\nv 2 0 0\nv 2 1 0\nv 0 1 0\nv 3 0 0\nusemtl none\nf 1 1 2\nusemtl quad\nf 1 2 3 4\nusemtl triangle\nf 2 5 3\n' >a.mesh.obj
expect 0 delaunay a.mesh.obj -o a.obj --repair
claim "sorted(g['usemtl'][0] for g in obj('a.obj').groups) == ['quad', 'quad', 'triangle']"
sed '/f 1 1 2/d' a.mesh.obj >b.mesh.obj
expect 0 delaunay b.mesh.obj -o a.obj
claim "sorted(g['usemtl'][0] for g in obj('a.obj').groups) == ['quad', 'quad', 'triangle']"

# Colors are fractions or integers, for all vertices and components together.
triangle='0 0 0,1 0 0,0 1 0'
printf 'COFF\n3 1 0\n0 0 0 0.5 0 0 1.0\n1 0 0 1.0 0 0 1.0\n0 1 0 1.0 0 0 1.0\n3 0 1 2\n' >f.off
printf 'COFF\n3 1 0\n0 0 0 1 0 0 255\n1 0 0 255 0 0 255\n0 1 0 2 0 0 255\n3 0 1 2\n' >i.off
printf 'v 0 0 0 0.1 0.2 0.3\nv 1 0 0 1.0000001 0 0\nv 0 1 0 0.6 0.4 0.2\nf 1 2 3\n' >f.obj
expect 0 delaunay f.off -o a.ply
claim "v = ply('a.ply').vertex" "v['red'] == [127, 255, 255]" "v['alpha'] == [255] * 3"
expect 0 delaunay i.off -o a.ply
claim "ply('a.ply').vertex['red'] == [1, 255, 2]"
expect 0 delaunay f.obj -o a.ply
claim "ply('a.ply').vertex['red'] == [25, 255, 153]"
for blue in 0.25 1; do
  {
    printf 'ply\nformat ascii 1.0\nelement vertex 3\n'
    printf 'property float %s\n' x y z red green blue
    printf 'element face 1\nproperty list uchar int vertex_indices\nend_header\n'
    tr , '\n' <<<"$triangle" | while read -r p; do echo "$p 1 0 $blue"; done
    echo '3 0 1 2'
  } >f.ply
  expect 0 delaunay f.ply -o a.ply
  claim "v = ply('a.ply').vertex" "v['red'] == [1] * 3" "v['blue'] == [$blue] * 3"
  [ "$(grep -c '^property double \(red\|green\|blue\)' a.ply)" -eq 3 ] || fail 'colors have several types'
  expect 0 delaunay f.ply -o a.obj
  grep -q "^v 1 0 0 1 0 $blue\$" a.obj || fail 'fractions are no colors in .obj'
done
rm f.* i.off a.ply a.obj
