#!/usr/bin/env bash
# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# What is read in each format, and what is said where a file does not follow it.
source "$(dirname "${BASH_SOURCE[0]}")/common.bash"

# mesh NAME TEXT: a file with this text, in which backslashes mean what they mean to printf.
mesh()
{
  printf "$2" >"$1"
}

# alike NAME TEXT [OUTPUT]: the file is the mesh that gives this output, or good.mesh.off.
alike()
{
  mesh "$1" "$2"
  expect 0 delaunay "$1" -o o.off --quiet
  cmp o.off "${3:-good.off}" || fail "$1 is another mesh"
  rm o.off
}

expect 0 delaunay good.mesh.off -o good.off --quiet
faces='3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n'

alike a.mesh.off "# a\n\nOFF # b\n# c\n4 4 0 # d\n0 0 0#e\n1 0 0 f\n\n0 1 0\n#g\n0 0 1\n$faces"
alike a.mesh.off "OFF 4 4 6\r\n0 0 0\r\n\t+1. 0e5 0\r\n0 1E0 1e-999\r\n0 .0 1\r\n${faces%??}"
alike a.mesh.off "CNOFF\n4 4 0\n0 0 0 1 2 3 9\n1 0 0 1 2 3 0.5 1 0\n0 1 0 1 2 3\n0 0 1 1 2 3\n$faces"
alike a.mesh.off "ST4OFF\n4 4 0\n0 0 0 2 1 1\n2 0 0 2\n0 3 0 3\n0 0 4 4\n${faces//3\\n/3 255 0 0\\n}"
alike a.mesh.off "SKEL\n4 4\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2.0 1\n${faces#*\\n}"
head='OFF BINARY\n\0\0\0\4\0\0\0\4\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\77\200\0\0\0\0\0\0\0\0\0\0\0\0\0\0'
head+='\77\200\0\0\0\0\0\0\0\0\0\0\0\0\0\0\77\200\0\0'
binary_faces='\0\0\0\3\0\0\0\0\0\0\0\2\0\0\0\1@\0\0\0\3\0\0\0\0\0\0\0\1\0\0\0\3@'
binary_faces+='\0\0\0\3\0\0\0\1\0\0\0\2\0\0\0\3@\0\0\0\3\0\0\0\2\0\0\0\0\0\0\0\3@'
alike a.mesh.off "$head${binary_faces//@/}"
alike a.mesh.off "$head${binary_faces//@/\\0\\0\\0\\1aaaa}"

points='v 0 0 0\nv 1 0 0 1 0 0\nv 0 1 0 1.0\nv 0 0 1\n'
alike a.mesh.obj "# a\nmtllib b\n${points}vt 0 0\ng c\nf 1 3 2\nf 1/1 2/1 4/1 # d\nf 2//1 3//1 4//\nl 1 2\nf -2 1 -1"
alike a.mesh.obj "f 1 3 2\r\nf\t1  2 4 \r\n${points//\\n/\\r\\n}s off\r\nf 2/1/1 3/2/1 4/3/1\r\n  f 3 1 4\r\n"

header='format ascii 1.0\nelement vertex 4\nproperty uchar a\nproperty float x\nproperty list int int l\n'
header+='property double y\nproperty int8 z\n'
rows='0 0 2 5 5 0 0\n0 1 0\n0 0\n0 0 1 5 1 0\n0 0 0 0 1\n'
list='property list uchar int vertex_indices\nproperty short s\nend_header\n'
alike a.mesh.ply "ply\n${header}element face 4\n$list${rows}${faces//\\n/ 9\\n}"
alike a.mesh.ply "ply\r\ncomment a\r\n${header//\\n/\\r\\n}obj_info b\r\nelement other 2\r\nproperty char c
element face 4\r\nproperty list uint16 uint vertex_index\r\nend_header\r\n${rows}7 8 3 0 2 1 3 0 1 3
3 1 2 3 3 2 0 3"
strips='element tristrips 2\nproperty list int int vertex_indices\nend_header\n'
off strips "$tetrahedron" '0 2 1,0 1 3,3 1 2,2 0 3'
expect 0 delaunay strips.mesh.off -o strips.off --quiet
alike a.mesh.ply "ply\n$header$strips${rows}8 0 2 1 -1 0 1 3 2\n7 2 0 3 3 -1 -1 -1" strips.off
expect 0 delaunay good.mesh.off -o a.ply --binary --quiet
expect 0 delaunay good.mesh.off -o b.ply --quiet
claim "ply('a.ply') == ply('b.ply')" "len(ply('a.ply').face['input_face']) == 4"
expect 0 delaunay good.mesh.off -o - --format ply --binary --quiet
cmp a.ply out
expect 0 delaunay a.ply -o good2.off --quiet
cmp good.off good2.off
rm a.ply b.ply good2.off
expect 2 delaunay good.mesh.off -o a.vtp --binary
says 'a.vtp: this format cannot be binary (.ply can)'

facets="facet normal 0 0 1\n outer loop\n  vertex 0 0 -0\n  vertex 0 1 0\n  vertex 1 0 0\n endloop
endfacet\n"
mesh a.mesh.stl "solid facet\n${facets}facet\nvertex 0 0 0 vertex 1 0 0 vertex 0 0 1\nendfacet\nendsolid\n"
expect 0 info a.mesh.stl
says 'note: corners merged because the file has no indices: 2'
says 'faces                 2'

# wrong NAME TEXT MESSAGE
wrong()
{
  mesh "$1" "$2"
  expect 2 info "$1"
  says "$1: $3"
}

bad='cannot be understood:'
wrong a.mesh.off 'OFFF\n' "line 1 $bad 'OFF' expected"
wrong a.mesh.off '# a\nOFF\n-1 1 0\n' "line 3 $bad a number of elements is negative"
wrong a.mesh.off 'OFF\n3 99999999999 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n' 'ends too early'
wrong a.mesh.off 'OFF\n3 1 0\n0 0 0\n1 0\n0 1 0\n3 0 1 2\n' "line 4 $bad a number is missing"
wrong a.mesh.off 'OFF\n1 1 0\n0 1.2.3 0\n3 0 1 2\n' "line 3 $bad '1.2.3' is not a number"
wrong a.mesh.off 'OFF\n1 1 0\n0 1e999 0\n3 0 1 2\n' "line 3 $bad '1e999' is not a finite number"
wrong a.mesh.off 'OFF\n1 1 0\n0 0 0\n99999999999 0 0 0\n' "line 4 $bad a number is missing"
wrong a.mesh.off 'OFF\n1 1 0\n0 0 0\n3 0 0 1\n' "line 4 $bad there is no vertex 1"
wrong a.mesh.off 'OFF\n1 1 0\n0 0 0\n3 0 0 0.5\n' "line 4 $bad '0.5' is not an integer"
wrong a.mesh.off 'OFF BINARY\n\0\0\0\4\0\0\0\4\0' 'ends too early'
wrong a.mesh.obj "${points}f 1 2 -5\n" "line 5 $bad there is no vertex -5"
wrong a.mesh.obj "${points}\nf 1 2 0\n" "line 6 $bad there is no vertex 0"
wrong a.mesh.obj "${points}f 1 2 x\n" "line 5 $bad 'x' is not a number"
wrong a.mesh.obj "v 1 2 inf\n" "line 1 $bad 'inf' is not a finite number"
wrong a.mesh.obj "v 1 2 3\n" 'has no faces'
wrong a.mesh.ply 'plx\n' "line 1 $bad 'ply' expected"
wrong a.mesh.ply 'ply\nformat utf8 1.0\n' "line 2 $bad the format is none of ascii"
wrong a.mesh.ply 'ply\nformat ascii 1.0\nproperty int a\n' "line 3 $bad a property comes before any"
wrong a.mesh.ply 'ply\nformat ascii 1.0\nelement vertex 1\nproperty real x\n' "line 4 $bad this type of numbers"
wrong a.mesh.ply 'ply\nformat ascii 1.0\nelement vertex -1\n' "line 3 $bad a number of elements is"
wrong a.mesh.ply 'ply\nformat ascii 1.0\nelement vertex 1\nproperty int x\nend_header\n' \
  "vertices have no coordinate 'y'"
wrong a.mesh.ply "ply\n${header}element face 1\nend_header\n$rows" \
  "has no list 'vertex_indices' of element 'face'"
wrong a.mesh.ply "ply\n${header}element face 1\n$list$rows-1 1\n" "line 18 $bad the size of a list is"
wrong a.mesh.ply "ply\n${header}element face 1\n${list}0 0 nan\n" "line 13 $bad 'nan' is not a finite"
wrong a.mesh.ply "ply\n${header/ascii/binary_big_endian}element face 1\n$list$rows" 'ends too early'
wrong a.mesh.stl 'solid a\nfacet\nvertex 0 0 0\nvertex 1 0 0\nendfacet\n' \
  "line 5 $bad a facet has fewer than three"
wrong a.mesh.stl "solid a\n${facets%e*}" 'ends too early'
wrong a.mesh.stl 'solid a\nfacets\n' "line 2 $bad 'facet' or 'endsolid' expected"

mesh a.mesh.ply "ply\n${header}element face 2\n$list${rows}3 0 1 7 9\n3 0 1 -1 9\n"
expect 2 info a.mesh.ply
says 'face index out of range: 2, first at face 0'
