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

# What other programs write.
plain='0 0 0\n1 0 0\n0 1 0\n0 0 1\n'
alike a.mesh.off "OFF4 4 6\n$plain$faces"
alike a.mesh.off "COFF4 4 0\n${plain//\\n/ 9 9 9\\n}$faces"
alike a.mesh.off "4 4 0\n$plain$faces"
alike a.mesh.off "# a\n4 4\n$plain$faces"
alike a.mesh.off "OFF\n4 4\n$plain$faces"
alike a.mesh.off "OFF\n4 4 # no edges\n\n$plain$faces"
alike a.mesh.off "OFF\n4\n4\n6\n$plain$faces"
for keyword in off Off coff noff; do
  alike a.mesh.off "$keyword\n4 4 0\n$plain$faces"
done
alike a.mesh.off "OFF\n4 4 0\n$plain${faces/0 2 1/0\\n2 # a\\n\\n1}"
alike a.mesh.off "OFF\n4 4 0\n0 0\n0\n${plain#*n}${faces//3 /3\\n}"
mark='\xef\xbb\xbf'
alike a.mesh.off "${mark}OFF\n4 4 0\n$plain$faces"
alike a.mesh.off "OFF\r4 4 0\r${plain//\\n/\\r}${faces//\\n/\\r}"
for encoding in UTF-16LE UTF-16BE; do
  { [ $encoding = UTF-16LE ] && printf '\xff\xfe' || printf '\xfe\xff'; } >b.mesh.off
  iconv -t $encoding good.off >>b.mesh.off
  expect 0 delaunay b.mesh.off -o o.off --quiet
  cmp o.off good.off
  rm o.off b.mesh.off
done

points='v 0 0 0\nv 1 0 0 1 0 0\nv 0 1 0 1.0\nv 0 0 1\n'
alike a.mesh.obj "# a\nmtllib b\n${points}vt 0 0\ng c\nf 1 3 2\nf 1/1 2/1 4/1 # d\nf 2//1 3//1 4//\nl 1 2\nf -2 1 -1"
alike a.mesh.obj "f 1 3 2\r\nf\t1  2 4 \r\n${points//\\n/\\r\\n}s off\r\nf 2/1/1 3/2/1 4/3/1\r\n  f 3 1 4\r\n"

alike a.mesh.obj "${mark}${points}f 1 3 \\\\\n 2\nf 1 \\\\ \r\n2 \\\\\n4\nfo 2 3 4\nf 3 1 4\n"
alike a.mesh.obj "# C:\\\\\n${points}unknown 7 \\\\\nf 1 2 3\n@ x\nf 1 3 2 # b \\\\\nf 1 2 4\nf 2 3 4\nf 3 1 4\nvp 0.3\np 1"

header='format ascii 1.0\nelement vertex 4\nproperty uchar a\nproperty float x\nproperty list int int l\n'
header+='property double y\nproperty int8 z\n'
rows='0 0 2 5 5 0 0\n0 1 0\n0 0\n0 0 1 5 1 0\n0 0 0 0 1\n'
list='property list uchar int vertex_indices\nproperty short s\nend_header\n'
alike a.mesh.ply "ply\n${header}element face 4\n$list${rows}${faces//\\n/ 9\\n}"
alike a.mesh.ply "${mark}ply\n${header}element face 4\n$list${rows}${faces//\\n/ 9\\n}"
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

facets="facet normal 0 0 1\n outer loop\n  vertex 0 0 -0\n  vertex 0 1 0\n  vertex 1 0 0\n endloop
endfacet\n"
mesh a.mesh.stl "solid facet\n${facets}facet\nvertex 0 0 0 vertex 1 0 0 vertex 0 0 1\nendfacet\nendsolid\n"
expect 0 info a.mesh.stl
says 'note: corners merged because the file has no indices: 2'
says 'faces                 2'
mesh b.mesh.stl "SOLID FACET\n$(tr a-z A-Z <<<"${facets//\\n/@}" | sed 's/@/\\n/g')FACET\nVertex 0 0 0 vertex 1 0 0 VERTEX 0 0 1
EndFacet\nENDSOLID\n"
mesh c.mesh.stl "${mark}solid\n${facets}facet\nvertex 0 0 0 vertex 1 0 0 vertex 0 0 1\nendfacet\nendsolid\n"
expect 0 delaunay a.mesh.stl -o a.off --quiet
for other in b c; do
  expect 0 delaunay $other.mesh.stl -o o.off --quiet
  cmp a.off o.off
done
rm a.off o.off

# The content says what the format is.
mesh triangle.mesh.stl "solid x\n${facets}endsolid\n"
"$program" delaunay triangle.mesh.stl -o stl.off --quiet
for format in off obj ply stl vtp; do
  [ $format = stl ] && cp triangle.mesh.stl o.stl || "$program" delaunay good.mesh.off -o o.$format --quiet
  for extension in off obj ply stl vtp txt; do
    [ $format != $extension ] || continue
    cp o.$format a.mesh.$extension
    expect 0 delaunay a.mesh.$extension -o p.off
    says "a.mesh.$extension: note: read as ${format^^}, the format of its content"
    [ $format = stl ] || cmp p.off good.off
    [ $format != stl ] || cmp p.off stl.off
    expect 0 info a.mesh.$extension
    says "note: read as ${format^^}, the format of its content"
  done
  rm o.$format
done
rm p.off stl.off a.mesh.*

# foreign NAME TEXT CONVERTER
foreign()
{
  mesh "$1" "$2"
  refuses "$1: this format is not read; \`$3 $1" info "$1"
}
foreign a.mesh.msh '$MeshFormat\n4.1 0 8\n' 'meshio convert'
foreign b.mesh.obj '$MeshFormat\n4.1 0 8\n' 'meshio convert'
foreign a.mesh.vtk '# vtk DataFile Version 3.0\n' 'meshio convert'
foreign b.mesh.off '# vtk DataFile Version 3.0\n' 'meshio convert'
foreign a.mesh.glb 'glTF\2\0\0\0' 'assimp export'
foreign a.mesh.GLTF '{}' 'assimp export'
foreign a.mesh.3mf 'PK\3\4' 'assimp export'
foreign a.mesh.step 'ISO-10303-21;\n' 'gmsh -2'
foreign a.mesh.STP 'x' 'gmsh -2'
mesh a.mesh.mtx 'x'
refuses 'neither the extension nor the content is of .off, .obj, .ply, .stl or .vtp' info a.mesh.mtx
rm a.mesh.* b.mesh.*

# VTP: what the program writes, and other encodings of numbers.
for output in good.vtp; do
  expect 0 delaunay good.mesh.off -o $output --quiet
  expect 0 delaunay $output -o o.off --quiet
  cmp o.off good.off
  rm o.off
done
python3 - <<'PYTHON'
import base64, struct, zlib
points = [0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1]
cells, ends = [0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3], [3, 6, 9, 12]
encode = {True: base64.b64encode, False: bytes}
for name, order, size, point, index, is_base64, block in (
        ("inline", "<", "I", "d", "q", True, 0), ("short", ">", "Q", "f", "i", True, 0),
        ("raw", "<", "I", "d", "i", False, 0), ("appended", "<", "Q", "f", "q", True, 0),
        ("zlib_inline", "<", "I", "f", "q", True, 32), ("zlib_raw", ">", "Q", "d", "i", False, 40),
        ("zlib_appended", "<", "I", "d", "q", True, 32768)):
    types = {"d": "Float64", "f": "Float32", "q": "Int64", "i": "Int32"}
    appended = b""

    def array(attributes, code, numbers):
        global appended
        data = struct.pack(f"{order}{len(numbers)}{code}", *numbers)
        if block > 0:  # as VTK writes by default
            blocks = [data[i:i + block] for i in range(0, len(data), block)]
            streams = [zlib.compress(b) for b in blocks]
            header = [len(blocks), block, len(data) % block, *map(len, streams)]
            data = (encode[is_base64](struct.pack(f"{order}{len(header)}{size}", *header))
                    + encode[is_base64](b"".join(streams)))
        else:
            data = encode[is_base64](struct.pack(order + size, len(data)) + data)
        if name in ("inline", "short", "zlib_inline"):
            return f'<DataArray type="{types[code]}" {attributes} format="binary">{data.decode()}</DataArray>\n'
        appended += data
        return f'<DataArray type="{types[code]}" {attributes} format="appended" offset="{len(appended) - len(data)}"/>\n'

    text = (f'<?xml version="1.0"?>\n<VTKFile type="PolyData" byte_order="{"Little" if order == "<" else "Big"}Endian"'
            f' header_type="UInt{64 if size == "Q" else 32}"'
            + (' compressor="vtkZLibDataCompressor"' if block > 0 else "") + f'><PolyData>\n<Piece><CellData>'
            + array('Name="x"', "i", [7] * 4) + "</CellData><Points>"
            + array('NumberOfComponents="3"', point, points) + "</Points>\n<Verts></Verts><Polys>"
            + array('Name="connectivity"', index, cells) + array('Name="offsets"', index, ends)
            + "</Polys></Piece></PolyData>\n")
    if appended:
        text += f'<AppendedData encoding="{"base64" if is_base64 else "raw"}">_'
    with open(name + ".mesh.vtp", "wb") as file:
        file.write(text.encode() + appended + (b"</AppendedData>" if appended else b"") + b"</VTKFile>")
PYTHON
for name in inline short raw appended zlib_inline zlib_raw zlib_appended; do
  expect 0 delaunay $name.mesh.vtp -o o.off --quiet
  cmp o.off good.off
  rm o.off
done
expect 0 delaunay <(cat inline.mesh.vtp) -o a.off
"$program" delaunay inline.mesh.vtp -o b.off --stats /dev/stdout 2>err | grep -q '"flips"' ||
  fail 'no statistics in a pipe'
cmp a.off b.off
rm a.off b.off
expect 2 info <(sed 's/header_type/compressor="vtkLZ4DataCompressor" header_type/' inline.mesh.vtp)
says 'the numbers are compressed by vtkLZ4DataCompressor; save the file without compression'
expect 2 info <(sed 's/header_type/compressor="vtkZLibDataCompressor" header_type/' inline.mesh.vtp)
expect 2 info <(sed 's/eJ/AA/' zlib_inline.mesh.vtp)
says 'the compressed numbers are damaged'

# wrong NAME TEXT MESSAGE
wrong()
{
  mesh "$1" "$2"
  refuses "$1: $3" info "$1"
}

bad='cannot be understood:'
wrong a.mesh.off 'OFFF\n' "line 1 $bad 'OFF' or a number of vertices expected at the beginning"
wrong a.mesh.off "OFF\n4 4 0\n$plain${faces/ 2 1/ 2}" "line 7 $bad a number is missing"
wrong a.mesh.off "OFF\n4 4 0\n${plain/1 0 0/1 0}$faces" "line 4 $bad a number is missing"
wrong a.mesh.off "4 4 x\n$plain$faces" "line 1 $bad 'x' is not a number"
wrong a.mesh.off "OFF\n4 5\n$plain$faces" 'ends too early'
wrong a.mesh.obj "${points}f 1 2\n 3\n" "line 6 $bad a line begins with a number"
wrong a.mesh.obj "${points}f 1 \\\\\n 2 \\\\\n x\n" "line 7 $bad 'x' is not a number"
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
wrong a.mesh.obj "${points}f 1 2 3\nf 1 2 5\nf 1 9 2\nf 1 9 3\n" "line 7 $bad there is no vertex 9; the file has 4"
wrong a.mesh.obj "${points}vt 0 0\nf 1/1 2/7 3/9\n" "line 6 $bad there is no texture coordinate 9; the file has 1"
wrong a.mesh.obj "${points}vt 0 0\nf 1/1 2/-2 3/1\n" "line 6 $bad there is no texture coordinate -2; count from 1"
wrong a.mesh.obj "${points}vt 0 0\nf 1/1 2/0 3/1\n" "line 6 $bad there is no texture coordinate 0"
wrong a.mesh.obj "${points}vt 0 0\nf 1/1 2/x 3/1\n" "line 6 $bad 'x' is not a number"
wrong a.mesh.obj "${points}vn 0 0 1\nf 1//1 2//1 3//2\n" "line 6 $bad there is no normal 2; the file has 1"
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
wrong a.mesh.ply "ply\n${header}element face 2\n$list${rows}3 0 1 2 9\n3 0 1 7 9\n" \
  "line 19 $bad a face names a vertex that does not exist; there are 4"
wrong a.mesh.ply "ply\n${header}element face 1\n$list${rows}3 0 1 -1 9\n" \
  "line 18 $bad a face names a vertex that does not exist; there are 4"
wrong a.mesh.ply "ply\n${header/ascii/binary_big_endian}element face 1\n$list$rows" 'ends too early'
wrong a.mesh.stl 'solid a\nfacet\nvertex 0 0 0\nvertex 1 0 0\nendfacet\n' \
  "line 5 $bad a facet has fewer than three"
wrong a.mesh.stl "solid a\n${facets%e*}" 'ends too early'
wrong a.mesh.off 'OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n# end\nmore\n' \
  "line 8 $bad 'more' follows the last of 1 faces"
wrong a.mesh.ply "ply\n${header}element face 1\n$list${rows}3 0 1 2 9\nmore\n" \
  "line 19 $bad 'more' follows the last element"
python3 -c '
import struct
corners = 0, 0, 0, 1, 0, 0, 0, 1, 0
facet = struct.pack("<I12fH", 1, 0, 0, 1, *corners, 0)
ply = b"ply\nformat binary_big_endian 1.0\nelement vertex 3\n" + b"".join(
    b"property float %c\n" % x for x in b"xyz")
ply += b"element face 1\nproperty list uchar int vertex_indices\nend_header\n"
files = {"stl": b"solid".ljust(80) + facet,
         "off": b"OFF BINARY\n" + struct.pack(">3i9f5i", 3, 1, 3, *corners, 3, 0, 1, 2, 0),
         "ply": ply + struct.pack(">9fB3i", *corners, 3, 0, 1, 2)}
for extension, content in files.items():
    for name, end in ("a", b""), ("b", b"abc"), ("c", b"\n"):
        with open(f"{name}.mesh.{extension}", "wb") as file:
            file.write(content + end)'
declare -A last=([stl]='the last of 1 facets' [off]='the last of 1 faces' [ply]='the last element')
for extension in stl off ply; do
  expect 0 info a.mesh.$extension
  refuses "has 3 bytes behind ${last[$extension]}, which ends the file" info b.mesh.$extension
  refuses "has 1 bytes behind ${last[$extension]}, which ends the file" info c.mesh.$extension
done
wrong a.mesh.stl 'solid a\nfacets\n' "line 2 $bad 'facet' or 'endsolid' expected"


# "-" is standard input.
"$program" delaunay - -o - <good.mesh.off >a.off
"$program" delaunay good.mesh.off -o - >b.off
cmp a.off b.off
rm a.off b.off
