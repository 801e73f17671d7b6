#!/usr/bin/env bash
# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# What the program says when something is wrong: each row of a table is a call, and what it says; no
# file is written. In the end, every message in the sources of the program must have been seen.
source "$(dirname "${BASH_SOURCE[0]}")/common.bash"

off pillow '0 0 0,1 0 0,0 1 0' '0 1 2,2 1 0'
off narrow_polygon "$square" '0 1'
off bow "0 0 0,1 1 0,1 0 0,0 1 0" '0 1 2 3'
off line '0 0 0,1 0 0,3 0 0,2 0 0' '0 1 2 3'
off doubled "$square" '0 1 2 3,0 1 2,0 2 3'
off lonely '0 0 0,1 1 1' ''
grid flat 4 0
# text NAME LINES: separated by ;
text() { tr ';' '\n' <<<"$2" >"$1"; }
text four.mesh.txt '0 4.7;1 4.7;2 4.7;3 4.7'
text a.mesh.xyz '0 0 0;1 0 0;2 0 0;3 0 0'
text number.mesh.off 'OFF;3 1 0;0 0 zero;1 0 0;0 1 0;3 0 1 2'
printf 'OFF\n3 1 0\n0 0' >missing.mesh.off
text infinite.mesh.off 'OFF;3 1 0;0 0 1e999;1 0 0;0 1 0;3 0 1 2'
text head.mesh.off 'OBJ;3 1 0'
text short.mesh.off 'OFF;3 1 0;0 0;1 0 0;0 1 0;3 0 1 2'
text negative.mesh.off 'OFF;-3 1 0'
printf 'OFF BINARY\n\xff\xff\xff\xfd\0\0\0\1\0\0\0\0' >binary.mesh.off
text index.mesh.off 'OFF;3 1 0;0 0 0;1 0 0;0 1 0;3 0 1 7'
text half.mesh.off 'OFF;3 1 0;0 0 0;1 0 0;0 1 0;3 0 1 1.5'
text far.mesh.off '4OFF;3 1 0;0 0 0 0;1 0 0 1;0 1 0 1;3 0 1 2'
text index.mesh.obj 'v 0 0 0;v 1 0 0;v 0 1 0;f 1 2 0'
text texture.mesh.obj 'v 0 0 0;v 1 0 0;v 0 1 0;vt 0 0;f 1/1 2/7 3/1'
text word.mesh.obj 'v 0 0 0;v 1 0 0;v 0 1 0;f 1 2;3'
text a.mesh.ply 'plx'
text b.mesh.ply 'ply;element vertex 3'
text c.mesh.ply 'ply;format ebcdic 1.0'
text d.mesh.ply 'ply;format ascii 1.0;something'
text e.mesh.ply 'ply;format ascii 1.0;property float x'
text f.mesh.ply 'ply;format ascii 1.0;element vertex 1;property list float int x'
text g.mesh.ply 'ply;format ascii 1.0;element vertex 1;property string x'
text h.mesh.ply 'ply;format ascii 1.0;element vertex -1'
text i.mesh.ply 'ply;format ascii 1.0;element face 1;property list int int vertex_indices;end_header;-2 0 0'
ply_vertices='element vertex 3;property float x;property float y;property float z'
ply_face='element face 1;property list uchar int vertex_indices;end_header'
text k.mesh.ply "ply;format ascii 1.0;$ply_vertices;property float heat;$ply_face;0 0 0 1;1 0 0 1;0 1 0 1;3 0 1 2"
{
  tr ';' '\n' <<<"ply;format binary_little_endian 1.0;$ply_vertices;property float heat;$ply_face"
  for point in '\0\0\0\0\0\0\0\0' '\0\0\x80\x3f\0\0\0\0' '\0\0\0\0\0\0\x80\x3f'; do
    printf "$point"'\0\0\0\0\0\0\xc0\x7f' # at a height of 0, NaN
  done
  printf '\3\0\0\0\0\1\0\0\0\2\0\0\0'
} >j.mesh.ply
text a.mesh.stl 'solid;what'
text b.mesh.stl 'solid;facet normal 0 0 1;outer loop;vertex 0 0 0;vertex 1 0 0;vertex 0 1 0;vertex 1 1 1;endloop;endfacet;endsolid'
text c.mesh.stl 'solid;facet normal 0 0 1;outer loop;vertex 0 0 0;vertex 1 0 0;vertex 0 1 0;endloop'
text d.mesh.stl 'solid;facet normal 0 0 1;outer loop;vertex 0 0 0;vertex 1 0 0;endloop;endfacet;endsolid'
vtp='<VTKFile type="PolyData"><Piece><Points><DataArray type="Float32" NumberOfComponents="3" format='
text a.mesh.vtp "$vtp\"binary\">AAAA"
text b.mesh.vtp "$vtp\"binary\">AA.A"
text c.mesh.vtp "$vtp\"binary\">AA=="
text d.mesh.vtp "$vtp\"ascii\">0 1 2 3</DataArray>"
text after.mesh.off 'OFF;3 1 0;0 0 0;1 0 0;0 1 0;3 0 1 2;more'
text e.mesh.vtp '<VTKFile type="PolyData"></VTKFile>;more'
text f.mesh.vtp '<VTKFile type="PolyData"></VTKFile>;<!-- a --><more>'
text g.mesh.vtp '<VTKFile type="PolyData"><AppendedData>_</AppendedData></VTKFile>;<more'
text h.mesh.vtp '<VTKFile type="PolyData"></VTKFile>;<!-- a'
text words.txt '0 1 2'
text nothing.txt '# nothing'
text spaced.txt '1 0 0'
printf '0:1,0,0\n0:0.5,0.5,0 0:0.5,0.5,0\n' >pair.txt
text line.obj 'v 0 0 0;v 1 0 0;l 1 2'
text half.obj 'v 0.25 0 0;v 0.25 0.125 0;l 1 2'
text across.obj 'v 0 0 0;v 5 0 0;l 1 2'
text far.obj 'v 0 0 0;v 0 0 9;l 1 2'
ply_edge='element edge 1;property uchar vertex1;property uchar vertex2;end_header'
text edge.ply "ply;format ascii 1.0;$ply_vertices;$ply_edge;0 0 0;1 0 0;0 1 0;0 3"
{
  tr ';' '\n' <<<"ply;format binary_little_endian 1.0;$ply_vertices;$ply_edge"
  printf '\0\0\0\0\0\0\0\0\0\0\0\0\0\0\xc0\x7f\0\0\0\0\0\0\0\0' # NaN
  printf '\0\0\0\0\0\0\0\0\0\0\0\0\0\1'
} >nan.ply
text value.txt '0 one'
text range.txt '99 1'
text twice.txt '0 1;0 2'
text inside.txt '0 1'
text below.txt '0 -1'
text meeting.txt '0 0.2;1 0.2'
mkdir folder.off folder.ply
off repeated_only "$square" '0 2 2'

off pillow "$tetrahedron" "$tetrahedron_faces"
off two_triangles '0 0 0,1 0 0,0 1 0,5 0 0,6 0 0,5 1 0' '0 1 2,3 4 5'
off apart '0 0 0,1 0 0,0 1 0,7 7 7' '0 1 2'
off moebius '0 0 0,1 0 0,0 1 0,1 1 1,0 0 2' '0 1 2,1 3 2,2 3 4,3 0 4,4 0 1'
off crossed '0 0 0,1 0 0,1 1 0,0 1 0' '0 2 1 3'
off star "$(awk 'BEGIN { for(i = 0; i < 1001; ++i) print cos(4 * i * 3.14159265 / 1001), sin(4 * i * 3.14159265 / 1001), 0 }' |
  paste -sd ,)" "$(seq -s ' ' 0 1000)"
off folded "$square,0 0 1,0 0 2" '0 1 2 3,1 0 4,4 0 2,3 2 5,5 2 0,1 4 3,1 3 5'

expect 0 delaunay flat.mesh.off -o flat.mesh.ply
ln -s flat.mesh.ply link.mesh.ply
cp flat.mesh.ply flat.svg
ln -s value.txt link.txt
ln value.txt hard.txt
: >seen
ls >files
# calls COMMAND...: rows of CODE | what is said | arguments, of which a word may not have spaces
calls()
{
  local code said arguments words
  while IFS='|' read -r code said arguments; do
    read -ra words <<<"$arguments"
    expect "${code// /}" "$@" "${words[@]}"
    says "$(sed 's/^ *//; s/ *$//' <<<"$said")"
    cat out err >>seen
  done
  [ "$(ls)" = "$(cat files)" ] || fail "$* has written: $(ls | diff files -)"
}

# What all commands refuse that read a mesh and write one;
for command in delaunay refine 'distance --source 0' flatten 'simplify --vertices 9' 'path --from 0 --to 1' \
  sphere hyperbolic uniformize; do
  # shellcheck disable=SC2086
  calls $command <<'TABLE'
2 | --output | flat.mesh.ply
2 | mesh is required | -o a.ply
2 | there is no option '--unknown' | flat.mesh.ply -o a.ply --unknown
2 | no such output format: '.stl' (there are off, obj, ply and vtp) | flat.mesh.ply -o a.stl
2 | no_extension: no such output format: '' | flat.mesh.ply -o no_extension
2 | is a directory | flat.mesh.ply -o folder.ply
2 | there is no directory | flat.mesh.ply -o nowhere/a.ply
2 | is the input, which is never overwritten | flat.mesh.ply -o flat.mesh.ply
2 | is the input, which is never overwritten | flat.mesh.ply -o link.mesh.ply
2 | is the input, which is never overwritten | flat.mesh.ply -o a.ply --stats ./flat.mesh.ply
2 | is named for two outputs | flat.mesh.ply -o a.ply --stats a.ply
2 | is named for two outputs | flat.mesh.ply -o a.ply --stats ./a.ply
2 | is named for two outputs | flat.mesh.ply -o - --stats -
2 | ; split it, or leave out --strict | polygon.mesh.off --strict -o a.ply
2 | --threads: '0' is not an integer | flat.mesh.ply -o a.ply --threads 0
2 | --threads: 'x' is not an integer | flat.mesh.ply -o a.ply --threads x
TABLE
done

# and each.
calls <<'TABLE'
2 | flat.mesh.ply: has a boundary; if it is a net, --glue names the sides to glue | convex flat.mesh.ply -o a.off
2 | no such file | info nothing.mesh.off
2 | is a directory | info folder.off
2 | line 3 cannot be understood: 'zero' is not a number | info number.mesh.off
2 | ends too early | info missing.mesh.off
2 | a number is missing | info short.mesh.off
2 | '1e999' is not a finite number | info infinite.mesh.off
2 | 'OFF' or a number of vertices expected at the beginning | info head.mesh.off
2 | a number of elements is negative | info negative.mesh.off
2 | a number of elements is negative; the first line counts vertices, faces and edges | info binary.mesh.off
2 | 'more' follows the last of 1 faces, which ends the file; remove what follows | info after.mesh.off
2 | 'more' follows </VTKFile> | info e.mesh.vtp
2 | '<more>' follows </VTKFile> | info f.mesh.vtp
2 | '<more' follows </VTKFile> | info g.mesh.vtp
2 | ends too early | info h.mesh.vtp
2 | there is no vertex 7 | info index.mesh.off
2 | '1.5' is not an integer | info half.mesh.off
2 | a vertex is infinitely far away | info far.mesh.off
2 | there is no vertex 0 | info index.mesh.obj
2 | line 5 cannot be understood: there is no texture coordinate 7; the file has 1 | info texture.mesh.obj
2 | a line begins with a number; a line that continues in the next one ends with a backslash | info word.mesh.obj
2 | 'ply' expected | info a.mesh.ply
2 | 'format' expected | info b.mesh.ply
2 | the format is none of ascii, binary_little_endian and binary_big_endian | info c.mesh.ply
2 | 'element', 'property', 'comment' or 'end_header' expected | info d.mesh.ply
2 | a property comes before any element | info e.mesh.ply
2 | the size of a list must be an integer | info f.mesh.ply
2 | this type of numbers is unknown | info g.mesh.ply
2 | a number of elements is negative | info h.mesh.ply
2 | the size of a list is negative or not an integer | info i.mesh.ply
2 | 'facet' or 'endsolid' expected | info a.mesh.stl
2 | a facet has more than three vertices | info b.mesh.stl
2 | ends too early | info c.mesh.stl
2 | a facet has fewer than three vertices | info d.mesh.stl
2 | ends too early | info a.mesh.vtp
2 | a character is not of base64 | info b.mesh.vtp
2 | ends too early | info c.mesh.vtp
2 | line 1 cannot be understood: a number is missing | info d.mesh.vtp
2 | has no faces after the repair | delaunay repeated_only.mesh.off --repair -o a.ply
2 | no point has neighbors in two directions | operators a.mesh.xyz --neighbors 3 --prefix a
2 | has fewer than three corners | delaunay narrow_polygon.mesh.off -o a.ply
2 | crosses or touches itself, seen along every axis | delaunay crossed.mesh.off -o a.ply
2 | line.mesh.off: face 0 has no area, because a line contains its corners; remove it from the file | delaunay line.mesh.off -o a.ply
2 | line.mesh.off: face 0 has no area | delaunay line.mesh.off -o a.ply --repair
2 | , and cannot be split into triangles; split it in the file | delaunay star.mesh.off --repair -o a.ply
2 | cannot be split into triangles without an edge that another face has | delaunay folded.mesh.off -o a.ply
2 | ; correct it in the file | delaunay index.mesh.ply -o a.ply
2 | ; --repair may mend it | delaunay repeated.mesh.off -o a.ply
2 | --repair makes it a surface | delaunay edge_of_three.mesh.off -o a.ply
2 | --repair cuts it open | delaunay moebius.mesh.off -o a.ply
2 | this format cannot be binary (.ply can) | delaunay flat.mesh.off -o a.vtp --binary
2 | is named for two outputs | delaunay flat.mesh.off -o a.ply --save a.ply
2 | there is no option '--unknown-option' | info flat.mesh.off --unknown-option
2 | --mollify: '-1' is not a number | delaunay flat.mesh.off -o a.off --mollify -1
2 | --constrain-angle: '200' is not a number | delaunay flat.mesh.off -o a.off --constrain-angle 200
2 | this format cannot carry distances (.ply and .vtp can) | distance flat.mesh.off --source 0 -o - --format off
2 | --level is for --level-sets; name a file for the curves | distance flat.mesh.off --source 0 -o a.ply --level 1
2 | --level-sets needs a surface; --repair may make it one | distance edge_of_three.mesh.off --source 0 -o a.ply --level-sets b.obj
2 | this format has no lines (.obj, .ply and .vtp have) | distance flat.mesh.off --source 0 -o a.ply --level-sets b.off
2 | ' is not a point of the mesh: on triangles that are not a surface, give a vertex or x,y,z | distance edge_of_three.mesh.off --source 0:1,0,0 -o a.ply
2 | has no signed distance: no part of the curve is on its component (add a part on it; --repair removes isolated vertices) | distance two_triangles.mesh.off --curve line.obj --signed -o a.ply
2 | intrinsic: --section requires --picture | delaunay flat.mesh.off -o a.ply --section 0 1
2 | intrinsic: --direct requires --view | delaunay flat.mesh.off -o a.ply --direct
2 | intrinsic: --direct requires --view | distance flat.mesh.off --source 0 -o a.ply --direct --picture a.svg
2 | intrinsic: --mollify excludes --direct | delaunay flat.mesh.off -o a.ply --direct --mollify 1e-5 --view a.html
2 | intrinsic: --mollify excludes --strict | refine flat.mesh.off -o a.ply --strict --mollify 1e-5
2 | there is no option '--mollify' | pack flat.mesh.off -o a.ply --mollify 1e-5
2 | intrinsic: --homogeneous excludes --linear | flatten flat.mesh.off -o a.obj --linear --homogeneous
2 | intrinsic: --homogeneous excludes --linear | hyperbolic flat.mesh.off -o a.obj --homogeneous --linear
2 | --format is for standard output, and names of files determine formats; leave it out | delaunay flat.mesh.off -o a.ply --format obj
2 | --format is for standard output, and names of files determine formats | simplify flat.mesh.off --coarse a.ply --format obj --vertices 9
2 | intrinsic: --max-insertions requires --min-angle | distance flat.mesh.off --source 0 -o a.ply --max-insertions 9
2 | intrinsic: --max-insertions requires --min-angle | operators flat.mesh.off --prefix a --max-insertions 9
2 | --max-insertions has no effect on --min-angle 0; give a greater angle | distance flat.mesh.off --source 0 -o a.ply --min-angle 0 --max-insertions 9
2 | --max-insertions has no effect on --min-angle 0 | operators flat.mesh.off --prefix a --min-angle 0 --max-insertions 9
2 | --max-insertions has no effect on --min-angle 0 | transfer flat.mesh.off --data value.txt -o a.txt --min-angle 0 --max-insertions 9
2 | --max-insertions has no effect on --min-angle 0 | refine flat.mesh.off -o a.ply --min-angle 0 --max-insertions 9
2 | --max-insertions is for --refine and --min-angle; add one of them | simplify flat.mesh.off -o a.ply --vertices 9 --max-insertions 9
2 | --levels is for --prolongation, --save and --stats; add one of them | simplify flat.mesh.off -o a.ply --vertices 9 --levels 3
2 | a.mesh.xyz: has points only; exact distances and curves need a surface | distance a.mesh.xyz --neighbors 3 --source 0 --method exact -o a.ply
2 | flat.mesh.off: has no faces after the repair; use --weld with a distance less than the edge lengths | delaunay flat.mesh.off -o a.off --weld 100
2 | --weight: curvature has two weights; give one | simplify flat.mesh.off --vertices 5 -o a.ply --weight curvature=1 --weight curvature=2
2 | a.mesh.xyz: has points only, and --weld merges points of faces; leave it out | operators a.mesh.xyz --neighbors 3 --weld 0.1 --prefix a
2 | intrinsic: --mollify: '2' is not a number from 1e-16 to 1 | delaunay flat.mesh.off -o a.ply --mollify 2
2 | intrinsic: Exactly 1 option from [--vertices,--ratio,--error] is required | simplify flat.mesh.off -o a.obj
2 | intrinsic: --method excludes --exact-distance | distance flat.mesh.off --source 0 -o a.ply --method exact --exact-distance
2 | a.jpg: --picture needs a name that ends with .svg or .png | delaunay flat.mesh.off -o a.ply --picture a.jpg
2 | a.ply: --output needs a name that ends with .html or .htm | view flat.mesh.off -o a.ply
2 | a.ply.txt: --view needs a name that ends with .html or .htm | delaunay flat.mesh.off -o a.ply --view a.ply.txt
2 | no_extension: --view needs a name that ends with .html or .htm | info flat.mesh.off --view no_extension
2 | a.txt: --circles needs a name that ends with .svg or .png | pack flat.mesh.off -o a.ply --circles a.txt
2 | '5,5,5' is not a point of the mesh: it is | delaunay flat.mesh.off -o a.ply --picture a.svg --section 5,5,5 0.7
2 | --section: the radius must be a finite number above zero | delaunay flat.mesh.off -o a.ply --picture a.svg --section 0 0
2 | --section: on triangles that are not a surface, the point must have the form x,y,z | operators edge_of_three.mesh.off --prefix a --picture a.svg --section 0 1
2 | --signed needs a --curve | distance flat.mesh.off --source 0 --signed -o a.ply
2 | --source or --curve is missing | distance flat.mesh.off -o a.ply
2 | --signed is for a --curve alone, without --source | distance flat.mesh.off --source 0 --curve line.obj --signed -o a.ply
2 | ; choose one on it, or give FACE:a,b,c | distance flat.mesh.off --source 0,0,9 -o a.ply
2 | the curve does not separate the surface into its left and its right | distance flat.mesh.off --curve half.obj --signed --exact-distance -o a.ply
2 | away from the surface, more than | distance flat.mesh.off --curve far.obj -o a.ply
2 | line 14 cannot be understood: an edge names a vertex that does not exist; there are 3 | distance flat.mesh.off --curve edge.ply -o a.ply
2 | point 2 has a coordinate that is not finite | distance flat.mesh.off --curve nan.ply -o a.ply
2 | is not connected to the one before | distance two_triangles.mesh.off --curve across.obj -o a.ply
2 | inside.txt: has values for 1 of 25 vertices | transfer flat.mesh.off --data inside.txt -o a.txt
2 | nothing.txt: has no points | transfer flat.mesh.off --points nothing.txt -o a.txt
2 | spaced.txt: line 1: '0' follows a point; lines of two points are for --back, and coordinates have commas and no blanks between them, such as 1,0,2.5 | transfer flat.mesh.off --points spaced.txt -o a.txt
2 | pair.txt: line 2: '0:0.5,0.5,0' follows a point | transfer flat.mesh.off --points pair.txt -o a.txt
2 | there is no vertex 99 to be a source; the vertices are 0 to 24 | distance flat.mesh.off --source 99 -o a.ply
2 | --exact: --solver cetm makes no triangulation Delaunay | flatten flat.mesh.off -o a.obj --exact --solver cetm
2 | --max-log-scale is for --cones greedy or exchanged, not for --cones none | flatten flat.mesh.off -o a.obj --max-log-scale 3 --cones none
2 | --max-area-distortion is for --cones greedy or exchanged, not for --cones none | flatten flat.mesh.off -o a.obj --max-area-distortion 4 --cones none
2 | --max-log-scale places cones, and --boundary disk has none by default: add --cones greedy, or leave it out | flatten flat.mesh.off -o a.obj --max-log-scale 0.3 --boundary disk
2 | --max-area-distortion places cones, and --boundary rectangle has none by default | flatten flat.mesh.off -o a.obj --max-area-distortion 4 --boundary rectangle
2 | --boundary: 'round' is none of free, straight, scale, curvature, rectangle and disk | flatten flat.mesh.off -o a.obj --boundary round
2 | --boundary scale needs a file of values: add --boundary-values | flatten flat.mesh.off -o a.obj --boundary scale
2 | needs a file of values: add --boundary-values | flatten --boundary curvature flat.mesh.off -o a.obj
2 | --boundary-values is for --boundary scale and curvature | flatten flat.mesh.off -o a.obj --boundary-values inside.txt
2 | the radius at vertex 0 is negative | flatten flat.mesh.off -o a.obj --radii below.txt
2 | the circles at vertices 1 and 0 meet | flatten flat.mesh.off -o a.obj --radii meeting.txt
2 | there is no vertex 99 | flatten flat.mesh.off -o a.obj --radii range.txt
2 | cold: no such file | flatten k.mesh.ply -o a.obj --radii cold
2 | the radius at vertex 0 is negative or not a finite number | flatten j.mesh.ply -o a.obj --radii heat
2 | --radii: the mesh had to be repaired, and its vertices differ from the file | flatten repeated.mesh.off --repair -o a.obj --radii inside.txt
2 | --radii: --exact cannot decide about circles | flatten flat.mesh.off -o a.obj --radii inside.txt --exact
2 | --radii: --solver ceres has no energy of circles | flatten flat.mesh.off -o a.obj --radii inside.txt --solver ceres
2 | --radii: with --boundary disk, the centers of circles at the boundary do not lie on a circle; use `intrinsic sphere`, or another --boundary | flatten flat.mesh.off -o a.obj --radii inside.txt --boundary disk
2 | there is no command 'flaten'; did you mean 'flatten'? | flaten flat.mesh.off -o a.obj
2 | there is no command 'dist'; did you mean 'distance'? | --threads 2 dist flat.mesh.off
2 | there is no command 'geodesics' | geodesics
2 | there is no option '--bounary'; did you mean '--boundary'? | flatten flat.mesh.off -o a.obj --bounary free
2 | there is no option '--vertcies'; did you mean '--vertices'? | simplify flat.mesh.off -o a.ply --vertcies=9
2 | there is no option '--thread'; did you mean '--threads'? | delaunay flat.mesh.off -o a.ply --thread 2
2 | unexpected: 2 3; --source takes one value: give --source again for each further one | distance flat.mesh.off --source 1 2 3 -o a.ply
2 | unexpected: flat.mesh.off; --source takes one value | distance --source 1 2 flat.mesh.off -o a.ply
2 | unexpected: 3 4; --via takes one value | path flat.mesh.off --from 0 --to 1 --flips --via 2 3 4 -o a.obj
2 | unexpected: one more | delaunay flat.mesh.off one -o a.ply more
2 | there is no option '--xyzzy' | --xyzzy delaunay flat.mesh.off -o a.ply
2 | --error: '-1' is not a number from 0 upwards | simplify flat.mesh.off -o a.ply --error -1
2 | --error: 'nan' is not a number from 0 upwards | simplify flat.mesh.off -o a.ply --error nan
2 | --ratio: '2' is not a number from 1e-09 to 1 | simplify flat.mesh.off -o a.ply --ratio 2
2 | --max-log-scale: '0' is not a number above 0 | flatten flat.mesh.off -o a.obj --max-log-scale 0
2 | --max-area-distortion: '1' is not a number above 1 | flatten flat.mesh.off -o a.obj --max-area-distortion 1
2 | --vertices: '-3' is not an integer from 1 upwards | simplify flat.mesh.off -o a.ply --vertices -3
2 | --vertices: '1.5' is not an integer from 1 upwards | simplify flat.mesh.off -o a.ply --vertices 1.5
2 | --max-insertions: '-1' is not an integer from 0 upwards | refine flat.mesh.off -o a.ply --max-insertions -1
2 | --min-angle: '61' is not a number from 0 to 60 | refine flat.mesh.off -o a.ply --min-angle 61
2 | --neighbors: '2' is not an integer from 3 to 10000 | operators flat.mesh.off --prefix a --neighbors 2
2 | --level: 'inf' is not a finite number | distance flat.mesh.off --source 0 -o a.ply --level-sets b.ply --level inf
2 | --component: 'one' is not an integer from 0 upwards | sphere two_triangles.mesh.off -o a.ply --component one
2 | --component: '0x1' is not an integer from 0 upwards | sphere two_triangles.mesh.off -o a.ply --component 0x1
2 | --component 10: the components of the mesh are 0 to 1 | sphere two_triangles.mesh.off -o a.ply --component 010
2 | --mollify: '0x1p-9' is not a number | delaunay flat.mesh.off -o a.off --mollify 0x1p-9
2 | '0x1' is not a number | path flat.mesh.off --from 0x1 --to 1 -o a.obj
2 | area=0x1: a weight must be a number that is not negative | simplify flat.mesh.off -o a.ply --ratio 0.5 --weight area=0x1
2 | --weld: '0' is not a number above 0 | delaunay flat.mesh.off -o a.ply --weld 0
2 | has no faces; `intrinsic distance` and `intrinsic operators` triangulate points with --neighbors 30 | info a.mesh.xyz
2 | neither the extension nor the content is of .off, .obj, .ply, .stl or .vtp | info words.txt
2 | line 1: vertex 0 is not inside | flatten flat.mesh.off -o a.obj --cones inside.txt
2 | is not "index value" | flatten flat.mesh.off -o a.obj --cones words.txt
2 | 'one' is not a finite number | flatten flat.mesh.off -o a.obj --cones value.txt
2 | there is no vertex 99; the vertices are 0 to 24 | flatten flat.mesh.off -o a.obj --cones range.txt
2 | vertex 0 is in line 1 | flatten flat.mesh.off -o a.obj --cones twice.txt
2 | this format cannot carry texture coordinates (.obj, .ply and .vtp can) | flatten flat.mesh.off -o a.off
2 | this format cannot carry texture coordinates | flatten flat.mesh.off -o - --format off
2 | this format cannot carry texture coordinates | hyperbolic flat.mesh.off -o a.off
2 | too few vertices | flatten needle.mesh.off --boundary rectangle -o a.obj
2 | a component has no boundary | flatten pillow.mesh.off --boundary rectangle -o a.obj
2 | simplex | flatten flat.mesh.off --solver simplex -o a.obj
2 | --svg is for hyperbolic surfaces | uniformize flat.mesh.off -o a.obj --svg a.svg
2 | this format has no lines (.obj, .ply and .vtp have) | path flat.mesh.off --from 0 --to 1 -o a.off
2 | --straightest starts at --from, and takes no other points | path flat.mesh.off --from 0 --to 1 --straightest 10 1 -o a.obj
2 | --straightest: the length is negative | path flat.mesh.off --from 0 --straightest 0 -1 -o a.obj
2 | --straightest: 'nan' is not a finite number | path flat.mesh.off --from 0 --straightest nan 1 -o a.obj
2 | a straightest path of this length crosses more than | path pillow.mesh.off --from 0:.3,.3,.4 --straightest 30 1e9 -o a.obj
2 | a point is too far away to have a nearest point of the mesh | path flat.mesh.off --from 1e308,0,0 --to 1 -o a.obj
2 | a loop goes back to --from and has no --to | path flat.mesh.off --from 0 --to 1 --loop -o a.obj
2 | --to or --loop is missing | path flat.mesh.off --from 0 -o a.obj
2 | --from is missing | path flat.mesh.off --to 0 -o a.obj
2 | --homology finds all loops by itself | path flat.mesh.off --homology --from 0 -o a.obj
2 | each loop of --homology has its own | path flat.mesh.off --homology -o a.obj --save a.save
2 | --via is for --flips and --loop | path flat.mesh.off --from 0 --to 1 --via 2 -o a.obj
2 | there is no path from 0 to 4 | path two_triangles.mesh.off --from 0 --to 4 -o a.obj
2 | there is no path from 0 to 4 | path two_triangles.mesh.off --from 0 --to 4 --flips -o a.obj
2 | 'x' is not a point of the mesh | path flat.mesh.off --from x --to 1 -o a.obj
2 | vertex 3 has no face | path apart.mesh.off --from 3 --to 1 -o a.obj
2 | barycentric coordinates must not be negative, and must sum up to 1 | path flat.mesh.off --from 0:1,1,1 --to 1 -o a.obj
2 | the faces are 0 to 31 | path flat.mesh.off --from 99:1,0,0 --to 1 -o a.obj
2 | give a vertex, FACE:a,b,c or x,y,z, such as 7, 12:0.5,0.2,0.3 or 1,0,2.5 | path flat.mesh.off --from 0,1 --to 1 -o a.obj
2 | is not a vertex: --flips and --loop go from vertex to vertex | path flat.mesh.off --from .3,.1,0 --to 1 --flips -o a.obj
2 | has no faces | path lonely.mesh.off --from 0 --to 1 -o a.obj
2 | folder.off: is a directory | flatten flat.mesh.off -o a.obj --cones folder.off
2 | a weight must be a number that is not negative | simplify flat.mesh.off -o a.ply --ratio 0.5 --weight area=-1
2 | is not NAME=W | simplify flat.mesh.off -o a.ply --ratio 0.5 --weight area
2 | weights that are not given are zero, and changes of area alone are not a cost | simplify flat.mesh.off -o a.ply --ratio 0.5 --weight area_change=1
2 | --levels needs --vertices or --ratio | simplify flat.mesh.off -o a.ply --error 0.1 --levels 3
2 | the mesh had to be repaired, and its vertices differ from the file | simplify repeated.mesh.off --repair -o a.ply --ratio 0.5 --weight color=1
2 | vertices have no property 'heat' (.ply can have properties) | simplify flat.mesh.off -o a.ply --ratio 0.5 --weight heat=1
2 | vertices have no property 'cold'; they have | simplify k.mesh.ply -o a.ply --ratio 0.5 --weight cold=1
2 | vertices have no colors (.ply, .off and .obj can have them) | simplify flat.mesh.off -o a.ply --ratio 0.5 --weight color=1
2 | a value of 'heat' is not finite | simplify j.mesh.ply -o a.ply --ratio 0.5 --weight heat=1
2 | --component 2: the components of the mesh are 0 to 1 | uniformize two_triangles.mesh.off -o a.obj --component 2
2 | --view shows one component, and the mesh has 2: add --component or --largest | sphere two_triangles.mesh.off -o a.ply --view a.html
2 | --time-step is for heat; leave out --method exact and --exact-distance | distance flat.mesh.off --source 0 --method exact --time-step 1 -o a.ply
2 | ; try --boundary free | flatten good.mesh.off --boundary disk -o a.obj
2 | : the mesh has no boundary; leave it out | flatten good.mesh.off --boundary straight -o a.obj
2 | --tiles is for --svg and --view; leave it out, or add one of them | hyperbolic good.mesh.off --tiles 2 -o a.obj
2 | --tiles: a surface with cones has no tiling; leave it out | hyperbolic good.mesh.off --cones four.mesh.txt --tiles 2 --svg a.svg -o a.obj
2 | ' is on the boundary, and this direction leads out of the surface; angles are counterclockwise from a side of face 0, choose another | path flat.mesh.off --from 0 --straightest 200 1 -o a.obj
2 | --svg is for one hyperbolic surface: add --component or --largest | uniformize two_triangles.mesh.off -o a.obj --svg a.svg
2 | --homogeneous is for flat and hyperbolic surfaces, and all components are spheres or disks: leave it out | uniformize two_triangles.mesh.off --homogeneous -o a.obj
2 | --homogeneous is for flat and hyperbolic surfaces; this surface is of type disk: leave it out | uniformize flat.mesh.off --homogeneous -o a.obj
1 | cannot be written | delaunay flat.mesh.off -o /proc/a.ply
TABLE

# No output replaces a file that is read, whatever its option, by no other spelling or link. Missing
# files have one message.
is_read='which is never overwritten; name another file'
before=$(md5sum -- *.txt *.obj nan.ply flat.svg)
calls <<TABLE
2 | value.txt: is the input of --data, $is_read | transfer flat.mesh.off --data value.txt -o value.txt
2 | ./value.txt: is the input of --data, $is_read | transfer flat.mesh.off --data value.txt -o ./value.txt
2 | link.txt: is the input of --data, $is_read | transfer flat.mesh.off --data value.txt -o link.txt
2 | value.txt: is the input of --data, $is_read | transfer flat.mesh.off --data link.txt -o a.txt --stats value.txt
2 | hard.txt: is the input of --data, $is_read | transfer flat.mesh.off --data value.txt -o a.txt --save hard.txt
2 | words.txt: is the input of --points, $is_read | transfer flat.mesh.off --points words.txt -o words.txt
2 | half.obj: is the input of --curve, $is_read | distance flat.mesh.off --curve half.obj -o a.ply --level-sets half.obj
2 | nan.ply: is the input of --curve, $is_read | distance flat.mesh.off --curve nan.ply -o nan.ply
2 | inside.txt: is the input of --cones, $is_read | flatten flat.mesh.off --cones inside.txt -o a.obj --matrix inside.txt
2 | inside.txt: is the input of --boundary-values, $is_read | flatten flat.mesh.off --boundary scale --boundary-values inside.txt -o a.obj --stats inside.txt
2 | inside.txt: is the input of --radii, $is_read | flatten flat.mesh.off --radii inside.txt -o a.obj --matrix inside.txt
2 | inside.txt: is the input of --radii, $is_read | sphere flat.mesh.off --radii inside.txt -o a.ply --precise inside.txt
2 | inside.txt: is the input of --radii, $is_read | uniformize flat.mesh.off --radii inside.txt -o a.obj --stats inside.txt
2 | inside.txt: is the input of --cones, $is_read | hyperbolic flat.mesh.off --cones inside.txt -o a.obj --stats inside.txt
2 | words.txt: is the input of --glue, $is_read | convex flat.mesh.off --glue words.txt -o a.off --save words.txt
2 | flat.svg: is the input, $is_read | info flat.svg --picture flat.svg
2 | missing: no such file | info missing
2 | missing: no such file | transfer flat.mesh.off --data missing -o a.txt
2 | missing: no such file | transfer flat.mesh.off --points missing -o a.txt
2 | missing: no such file | distance flat.mesh.off --curve missing -o a.ply
2 | missing: no such file | flatten flat.mesh.off --cones missing -o a.obj
2 | missing: no such file | flatten flat.mesh.off --boundary scale --boundary-values missing -o a.obj
2 | missing: no such file | flatten flat.mesh.off --radii missing -o a.obj
2 | missing: no such file | convex flat.mesh.off --glue missing -o a.off
TABLE
[ "$(md5sum -- *.txt *.obj nan.ply flat.svg)" = "$before" ] || fail 'an input has changed'
# A device may be both.
expect 0 transfer good.mesh.off --data <(printf '0 1\n1 2\n2 3\n3 4\n') -o /dev/null --stats /dev/stdout

# Every message in the sources has been seen, here or in the test of a command, except those that no call
# can reach.
grep -hE '^ *(says|refuses) ' "$tests"/*.sh >>seen
python3 - "$tests/../../demo" seen <<'PYTHON' || fail 'messages that no test has seen'
import re, sys
from pathlib import Path
# another build, a damaged disk, or a fault of the program
UNREACHED = """built without | cannot be opened | cannot be read | could not be written completely | the PNG picture cannot be drawn
  | has not come | is not planned | too many corners
  | there are no faces | 'endfacet' expected""".split("|")
seen = open(sys.argv[2], errors="replace").read()
missing = []
for source in sorted(Path(sys.argv[1]).rglob("*.[ch]*")):
    text = re.sub(r'"\s*\n\s*"', "", source.read_text())
    for call in re.findall(r'(?:throw [\w:]*[eE]rror\(|\bfail\(|\brefuse\()(.*?)\);\n', text, re.S):
        pieces = [p.replace(r'\"', '"') for p in re.findall(r'"((?:[^"\\]|\\.)*)"', call)]
        longest = max(pieces, key=len, default="")
        for piece in (p.strip() for p in pieces if len(p.strip()) > 9 or p is longest):
            if piece not in seen and not any(u.strip() in longest for u in UNREACHED):
                missing.append(f"{source.name}: {piece}")
print(*missing, sep="\n")
sys.exit(bool(missing))
PYTHON

# An option has a value.
for option in --cones --stats --boundary --boundary-values; do
  expect 2 flatten flat.mesh.off -o a.obj "$option" ''
  says "$option: "
  says 'the value is empty; give one, or leave out the option'
done

# No option takes the mesh, or has a range of hundreds of digits.
expect 0 flatten --boundary free flat.mesh.off -o a.obj
rm a.obj
for command in delaunay refine distance path transfer operators flatten hyperbolic uniformize sphere simplify; do
  expect 0 $command --help
  ! grep -E '[0-9]{20}' out || fail "$command --help prints a range of many digits"
  ! grep -iE 'twice the time|half of the time' out || fail "$command --help has a measured time"
  ! grep -q -e '--max-insertions' out || grep -q 'at most 10,000,000' out || fail "$command --help has no greatest limit"
done

# Help shows how values are given: one by one, or two separated by a space.
expect 0 distance --help
says '--source TEXT (repeatable)'
says '--level FLOAT:a finite number (repeatable)'
expect 0 path --help
says '--via TEXT (repeatable)'
! grep -F '[' <(grep -- '--straightest ' out) || fail 'a pair has brackets'
expect 0 delaunay --help
says '--section POINT RADIUS'
says '--section 17 0.05'
expect 0 view --help
says 'mesh TEXT ... REQUIRED'
