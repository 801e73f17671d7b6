# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Runs the program on damaged files and degenerate surfaces: fuzz.py PROGRAM DATA [--runs N] [--first I]
[--jobs J] [--keep DIRECTORY] [--server]. Run i is always the same, as long as the options of the program are.
Half of the runs read a small mesh of CGAL's data directory, in one of the formats that are read, with a few
changes, and at times with an absurd option; a curve is a damaged file, too, and the mesh then half of the time
is none. The others read a surface of few faces and isolated vertices, with sources on it and options, valid,
borderline or absurd, that the help of the command lists. The program must end in a minute with the exit code
0, 1 or 2, or 3 with --keep-going, say something unless that is 0, and leave no file after a failure. Files that fail are kept in the
directory, if there is one. With --server the program is the target `fuzz_server`, which is loaded once for all
runs. Exit code 77 without data."""

import argparse
import base64
import os
import random
import re
import resource
import shutil
import signal
import struct
import subprocess
import sys
import tempfile
import threading
import zlib
from concurrent.futures import ThreadPoolExecutor

SEEDS = """tetrahedron cube octahedron icosahedron 3torus cube-ouvert open_cube small_cube hedra P
    quad triangle star degtri_sliding mesh_with_colors torus_quad fold quint_tris
    reference_tetrahedron cross sphere""".split()

WORDS = """-1 0 1 2 3 255 256 65536 2147483647 2147483648 4294967295 4294967296 99999999999
    18446744073709551615 99999999999999999999999 -99999999999 1e308 -1e308 1e309 1e-320 1e-400 nan
    -inf inf 0x10 1.5 1,5 .5 5. + - . e +-1 1e 1/2/3 -1//2 / # 3#3 OFF COFF NOFF STOFF 4OFF nOFF
    CN4nOFF SKEL BINARY ply end_header element property list vertex face tristrips uchar float double
    int x y z red alpha nx s t texcoord normal vertex_indices ascii binary_little_endian binary_big_endian v vt vn f l o solid
    facet endfacet endsolid vertex edge vertex1 vertex2 <Lines> </Lines> <Points> </Piece> <!-- --> < > <>
    </DataArray> format="binary" Name="offsets" format="appended" offset="5" encoding="base64" _ = \\ fo unknown
    <AppendedData> header_type="UInt64" off SOLID Facet """.split() + ["", "\0", "\r", "\n", "\n\n", "\\\n", "\xff\xfe", "\xef\xbb\xbf", "9" * 400]


# Values for options, and the options of each command that take some.
NUMBERS = """nan inf -inf 1e308 -1e308 1e309 1e-320 1e-400 -1 -0 0 1 2.5 60 180 1e18 3e9 0x10 5. .5 1,5
    9223372036854775807 9223372036854775808 18446744073709551615 18446744073709551616
    99999999999999999999 -9223372036854775809 4294967296 . e x""".split() + [""]

PLACES = NUMBERS + """0 1 3 0:1,0,0 1:0.2,0.3,0.5 0:nan,0,1 0:1e308,-1e308,1 99:1,0,0 0,0,0 1e308,-1e308,0
    nan,0,0 1,2 0: :0 ,, 0:,, 0:0.5,0.5,0.5 1e-320,0,0""".split()

BAD_FILES = ["", ".", "/none/o", "mesh.off", "o.x"]
MESHES = ["o.off", "o.ply", "o.obj", "o.vtp"]

# Values of options that make sense, beside those of their types.
HINTS = {
    "--stats": ["o.json"], "--view": ["o.html"], "--picture": ["o.svg", "o.png"],
    "--format": ["off", "obj", "ply", "vtp"], "--save": ["o.txt"], "--svg": ["o.svg", "p.svg"],
    "--matrix": ["o.mtx"], "--prolongation": ["o.mtx"], "--precise": ["o.txt"],
    "--max-insertions": ["0", "1", "50", "300"], "--curve": ["mesh.off", "mesh.obj", "mesh.ply"],
    "--level-sets": ["q.obj", "q.ply", "q.vtp"], "--subdivision": MESHES, "--coarse": MESHES,
    "--cones": ["none", "greedy", "points.txt"],
    "--boundary": ["free", "straight", "rectangle", "disk", "scale", "curvature"],
    "--boundary-values": ["points.txt"], "--method": ["exact", "heat", "auto"], "--neighbors": ["3", "9"], "--tiles": ["0", "1", "3"],
    "--weight": ["area=1", "color=1", "curvature=0", "curvature=1", "area=1e300"]}


class Option:
    """An option as the help of a command lists it."""

    def __init__(self, name, type):
        self.name, self.type = name, type
        many = re.match(r"\[(.*?)\]", type)
        self.number_of_values = many[1].count(",") + 1 if many else 1 if type else 0

    def sensible(self, dice, points):
        if self.name in HINTS:
            return dice.choice(HINTS[self.name])
        if choice := re.search(r"\{(.*?)\}", self.type):
            return dice.choice(choice[1].split(","))
        if bounds := re.search(r"in \[(\S+) - (\S+)\]", self.type):
            value = dice.uniform(float(bounds[1]), float(bounds[2]))
            return dice.choice([bounds[1], bounds[2], str(int(value) if "INT" in self.type else value)])
        if re.match(r"\[?FLOAT", self.type):
            return dice.choice("0 1e-9 0.1 0.5 1 3 30 1e9".split())
        return dice.choice("0 1 2 3 4 10".split()) if "INT" in self.type else dice.choice(points)

    def drawn(self, dice, points):
        """The option with its values; one in five is borderline or absurd."""
        return [self.name] + [self.sensible(dice, points) if dice.random() < 0.8 else
                              dice.choice(self.absurd()) for _ in range(self.number_of_values)]

    def absurd(self):
        if self.name == "--max-insertions":  # billions of insertions may take their time
            return [word for word in NUMBERS if not word.isdigit() or int(word) < 1000 or int(word) >= 2 ** 64]
        if "TEXT" in self.type:
            return PLACES if self.type[:5] == "[TEXT" else BAD_FILES + NUMBERS[:6]
        return NUMBERS


def listed_options(help):
    """The options in a help text but for those that a call has in any case; of synonyms, each."""
    result = []
    for line in help.splitlines():
        if match := re.match(r"  ((?:-\w,)?--[a-z][^ ]*)(?: (\S+(?: \S+)*))?(?:  |$)", line):
            names = [name.split("{")[0] for name in match[1].split(",") if name.startswith("--")]
            type = re.sub(r" ?(Needs|Excludes):.*", "", match[2] or "")
            result += [Option(name, type) for name in names
                       if name not in ("--help", "--output", "--prefix", "--version")]
    return result


def listed_commands(help):
    block = help.split("Subcommands:")[1].split("\n\n")[0]
    return re.findall(r"^  (\w+)", block, re.MULTILINE)


# ---- Seeds ----


def read_off(path):
    lines = [words for line in open(path) if (words := line.split("#")[0].split())]
    vertices, faces = map(int, lines[1][:2])
    points = [[float(x) for x in words[:3]] for words in lines[2:vertices + 2]]
    return points, [[int(i) for i in words[1:int(words[0]) + 1]]
                    for words in lines[vertices + 2:vertices + faces + 2]]


def rows(values):
    return "".join(" ".join(map(str, row)) + "\n" for row in values)


def off(points, faces):
    return f"OFF\n{len(points)} {len(faces)} 0\n" + rows(points) + rows([len(f)] + f for f in faces)


def colored_off(points, faces):
    colors = [[7 * i % 256, 90, 200] for i in range(len(points))]
    return (f"# colors\nCNOFF\n{len(points)} {len(faces)} 0\r\n"
            + rows(p + [0, 0, 1] + c for p, c in zip(points, colors))
            + rows([len(f)] + f + [0.5, 0.1, 0.9] for f in faces))


def obj(points, faces):
    corner = iter(range(1, 1 + sum(map(len, faces))))
    return ("# mesh\nmtllib a.mtl\n" + rows(["v"] + p + [0.5, i % 2, 0] for i, p in enumerate(points))
            + rows(["vt", i / 8, i % 3, 0] for i, _ in enumerate(f for f in faces for _ in f))
            + "vn 0 0 1\nvn 0 1 0\ng a\n"
            + rows(["f"] + [f"{i - len(points)}/{c}/1" if i % 2 else f"{i + 1}/{-c if i % 5 else ''}/2"
                            for i, c in zip(f, corner)] for f in faces))


def plain_obj(points, faces):
    return rows(["v"] + p for p in points) + rows(["f"] + [i + 1 for i in f] for f in faces)


def ply_header(form, points, faces):
    return (f"ply\nformat {form} 1.0\ncomment a mesh\nelement vertex {len(points)}\n"
            "property float x\nproperty float y\nproperty double z\nproperty uchar red\n"
            "property uchar green\nproperty uchar blue\nproperty double quality\n"
            f"element face {len(faces)}\nproperty uchar flags\n"
            "property list uchar int vertex_indices\nproperty list uchar float texcoord\n"
            "end_header\n")


def texture(face):
    return [2 * len(face)] + [i % 5 / 4 for v in face for i in (v, v // 2)]


def ply(points, faces):
    return (ply_header("ascii", points, faces)
            + rows(p + [3, 2, i % 256, i / 7] for i, p in enumerate(points))
            + rows([1, len(f)] + f + texture(f) for f in faces))


def binary_ply(order, form):
    def write(points, faces):
        result = ply_header(form, points, faces).encode()
        for i, p in enumerate(points):
            result += struct.pack(order + "ffdBBBd", *p, 3, 2, i % 256, i / 7)
        for f in faces:
            result += struct.pack(f"{order}BB{len(f)}iB{2 * len(f)}f", 1, len(f), *f, *texture(f))
        return result
    return write


def strips(points, faces):
    strip = [i for f in faces for i in f + [-1]]
    return (f"ply\nformat ascii 1.0\nelement vertex {len(points)}\nproperty float x\n"
            "property float y\nproperty float z\nelement tristrips 1\n"
            "property list int int vertex_indices\nend_header\n" + rows(points)
            + rows([[len(strip)] + strip]))


def binary_off(points, faces):
    result = b"OFF BINARY\n" + struct.pack(">3i", len(points), len(faces), 0)
    for p in points:
        result += struct.pack(">3f", *p)
    for f in faces:
        result += struct.pack(f">{len(f) + 2}i", len(f), *f, 0)
    return result


def corners(points, faces):
    return [[points[i] for i in f[:3]] for f in faces]


def stl(points, faces):
    facets = ("facet normal 0 0 1\nouter loop\n" + rows(["vertex"] + p for p in t)
              + "endloop\nendfacet\n" for t in corners(points, faces))
    return "solid a\n" + "".join(facets) + "endsolid a\n"


def xyz(points, faces):
    return rows(points)


def binary_stl(points, faces):
    all = corners(points, faces)
    return (b"\0" * 80 + struct.pack("<I", len(all))
            + b"".join(struct.pack("<12fH", 0, 0, 1, *sum(t, []), 0) for t in all))


def vtp(points, faces):
    return (f"""<?xml version="1.0"?>
<VTKFile type="PolyData" version="0.1" byte_order="LittleEndian">\n<PolyData>\n<Piece>\n<PointData>
<DataArray format="ascii" type="Float64" Name="f">\n""" + rows([i] for i, _ in enumerate(points))
            + """</DataArray>\n</PointData>\n<Points>
<DataArray format="ascii" type="Float64" Name="Points" NumberOfComponents="3">\n""" + rows(points)
            + "</DataArray>\n</Points>\n<Polys>\n<DataArray format=\"ascii\" Name=\"connectivity\">\n"
            + rows(faces) + "</DataArray>\n<DataArray format=\"ascii\" Name=\"offsets\">\n"
            + rows([sum(map(len, faces[:i + 1]))] for i in range(len(faces)))
            + "</DataArray>\n</Polys>\n</Piece>\n</PolyData>\n</VTKFile>\n")


def encoded_vtp(is_raw, is_compressed=False):
    def data_of(size, bytes):
        """The numbers after their size or, in blocks of 64 bytes, after the sizes of blocks."""
        encode = (lambda b: b) if is_raw else base64.b64encode
        if not is_compressed:
            return encode(struct.pack("<I", size) + bytes)
        blocks = [zlib.compress(bytes[i:i + 64]) for i in range(0, size, 64)]
        header = [len(blocks), 64, size % 64, *map(len, blocks)]
        return encode(struct.pack(f"<{len(header)}I", *header)) + encode(b"".join(blocks))

    def write(points, faces):
        appended = b""

        def array(attributes, code, numbers):
            nonlocal appended
            data = data_of(struct.calcsize(code) * len(numbers),
                           struct.pack(f"<{len(numbers)}{code}", *numbers))
            type = {"f": "Float32", "i": "Int32"}[code]
            if not is_raw:
                return (f'<DataArray type="{type}" {attributes} format="binary">'
                        f"{data.decode()}</DataArray>\n").encode()
            appended += data
            return (f'<DataArray type="{type}" {attributes} format="appended" '
                    f'offset="{len(appended) - len(data)}"/>\n').encode()

        text = (b'<?xml version="1.0"?>\n<VTKFile type="PolyData" byte_order="LittleEndian"'
                + (b' compressor="vtkZLibDataCompressor"' if is_compressed else b"")
                + b"><PolyData>\n<Piece><Points>"
                + array('NumberOfComponents="3"', "f", sum(points, [])) + b"</Points>\n<Polys>"
                + array('Name="connectivity"', "i", sum(faces, []))
                + array('Name="offsets"', "i", [sum(map(len, faces[:i + 1])) for i in range(len(faces))])
                + b"</Polys></Piece></PolyData>\n")
        return text + (b'<AppendedData encoding="raw">_' + appended + b"</AppendedData>" if is_raw else b"") + b"</VTKFile>"
    return write


FORMATS = [("off", off), ("off", colored_off), ("off", binary_off), ("obj", obj), ("ply", ply),
           ("ply", binary_ply("<", "binary_little_endian")), ("ply", strips),
           ("ply", binary_ply(">", "binary_big_endian")), ("stl", stl), ("stl", binary_stl),
           ("vtp", vtp), ("vtp", encoded_vtp(False)), ("vtp", encoded_vtp(True)),
           ("vtp", encoded_vtp(False, True)), ("vtp", encoded_vtp(True, True)), ("xyz", xyz)]


def ply_curve(form, order=None):
    def write(points, faces):
        edges = [f[:2] for f in faces]
        header = (f"ply\nformat {form} 1.0\nelement vertex {len(points)}\nproperty float x\n"
                  f"property float y\nproperty double z\nelement edge {len(edges)}\n"
                  "property int vertex1\nproperty uchar flags\nproperty int vertex2\nend_header\n")
        if order is None:
            return header + rows(points) + rows([v, 7, w] for v, w in edges)
        return (header.encode() + b"".join(struct.pack(order + "ffd", *p) for p in points)
                + b"".join(struct.pack(order + "iBi", v, 7, w) for v, w in edges))
    return write


def vtp_curve(points, faces):
    return (f"""<?xml version="1.0"?>
<VTKFile type="PolyData" version="0.1">\n<PolyData>\n<!-- a curve -->
<Piece NumberOfPoints="{len(points)}" NumberOfLines="{len(faces)}">\n<Points>
<DataArray format="ascii" type="Float64" Name="Points" NumberOfComponents="3">\n""" + rows(points)
            + "</DataArray>\n</Points>\n<Lines>\n<DataArray format=\"ascii\" Name=\"connectivity\">\n"
            + rows(faces) + "</DataArray>\n<DataArray format=\"ascii\" Name=\"offsets\">\n"
            + rows([sum(map(len, faces[:i + 1]))] for i in range(len(faces)))
            + "</DataArray>\n</Lines>\n</Piece>\n</PolyData>\n</VTKFile>\n")


CURVE_FORMATS = [("obj", lambda p, f: rows(["v"] + q for q in p) + rows(["l"] + [i + 1 for i in g] for g in f)),
                 ("xyz", xyz), ("vtp", vtp_curve), ("ply", ply_curve("ascii")),
                 ("ply", ply_curve("binary_little_endian", "<")),
                 ("ply", ply_curve("binary_big_endian", ">"))]


def in_bytes(content):
    return content.encode() if isinstance(content, str) else content


def all_seeds(data):
    """An extension, the bytes of a file, and curves on its mesh, which are pairs of both; polygons are split
    in all meshes but some."""
    result = []
    for name in SEEDS:
        points, faces = read_off(f"{data}/meshes/{name}.off")
        if name not in ("hedra", "torus_quad", "P"):
            faces = [[f[0], f[k - 1], f[k]] for f in faces for k in range(2, len(f))]
        curves = [(extension, in_bytes(write(points, faces[:9]))) for extension, write in CURVE_FORMATS]
        result += [(extension, in_bytes(write(points, faces)), curves) for extension, write in FORMATS]
    return result


# ---- Damage ----


def place(dice, content):
    """Half of them in the header."""
    end = min(len(content), 400) if dice.random() < 0.5 else len(content)
    return dice.randrange(end + 1)


def damaged(dice, content, others):
    for _ in range(dice.choice([0, 1, 1, 1, 1, 2, 2, 3, 5, 8])):
        i, j = place(dice, content), place(dice, content)
        i, j = min(i, j), min(max(i, j), min(i, j) + dice.choice([1, 4, 20, 1000]))
        word = dice.choice(WORDS).encode("latin-1")
        kind = dice.randrange(12)
        if kind == 0:
            content = content[:i] + dice.randbytes(dice.choice([1, 1, 4])) + content[j:]
        elif kind == 1:
            content = content[:i] + content[j:]
        elif kind == 2:
            content = content[:j] + content[i:]
        elif kind == 3:
            content = content[:i] + b" " + word + b" " + content[i:]
        elif kind == 4:
            content = content[:i]
        elif kind == 5:
            other = dice.choice(others)[1]
            content = content[:i] + other[place(dice, other):]
        elif kind == 6:
            lines = content.split(b"\n")
            a, b = dice.randrange(len(lines)), dice.randrange(len(lines))
            lines[a] = lines[b]
            content = b"\n".join(lines)
        elif kind > 8:  # another digit in place of one
            digits = [k for k, c in enumerate(content) if 48 <= c <= 57] or [0]
            i = dice.choice(digits)
            content = content[:i] + b"%d" % dice.randrange(10) + content[i + 1:]
        else:  # another word in place of one
            words = content.split(b" ") if kind == 7 else content.split(b"\n")
            words[dice.randrange(min(len(words), dice.choice([30, 10**6])))] = word
            content = (b" " if kind == 7 else b"\n").join(words)
    return content


# ---- Degenerate surfaces ----

PARTS = [(1, []),  # an isolated vertex
         (3, [[0, 1, 2]]),
         (4, [[0, 1, 2], [0, 2, 3]]),
         (3, [[0, 1, 2], [2, 1, 0]]),  # closed
         (4, [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]),
         (5, [[0, 1, 2], [0, 2, 3], [0, 3, 4]]),  # a fan
         (5, [[0, 1, 2], [2, 3, 4]]),  # two fans at a vertex
         (4, [[0, 1, 2], [0, 2, 3], [0, 3, 1]]),  # around a vertex
         (6, [[0, 1, 3], [1, 4, 3], [1, 2, 4], [2, 5, 4], [2, 0, 5], [0, 3, 5]]),  # an annulus
         (5, [[0, 1, 2], [1, 0, 3], [0, 1, 4]]),  # three faces at an edge
         (4, [[0, 1, 2], [0, 1, 3]]),  # two orientations
         (5, [[0, 1, 2, 3, 4]])]  # a polygon


def torus(m, n):
    corner = [[i * n + j, (i + 1) % m * n + j, (i + 1) % m * n + (j + 1) % n, i * n + (j + 1) % n]
              for i in range(m) for j in range(n)]
    return m * n, [[c[0], c[1], c[2]] for c in corner] + [[c[0], c[2], c[3]] for c in corner]


def degenerate_surface(dice):
    """Points and faces of a few parts in any order; coordinates may be equal, or tiny, or huge."""
    points, faces = [], []
    grid = dice.choice([2, 10, 1000])
    scale = dice.choice([1] * 8 + [1e-3, 1e6, 1e-150, 1e150, 1e-320])
    for _ in range(dice.choice([1, 1, 1, 2, 2, 3, 4])):
        n, part = torus(3, 3) if dice.random() < 0.05 else dice.choice(PARTS[:5] if dice.random() < 0.6 else PARTS)
        faces += [[len(points) + i for i in f] for f in part]
        is_on_grid = dice.random() < 0.4
        points += [[dice.randrange(grid + 1) / grid * scale if is_on_grid else dice.gauss(0, 1) * scale
                    for _ in range(3)] for _ in range(n)]
    order = list(range(len(points)))
    dice.shuffle(order)
    dice.shuffle(faces)
    result = [None] * len(points)
    for i, p in zip(order, points):
        result[i] = p
    return result, [[order[i] for i in f] for f in faces]


def points_on(dice, points, faces):
    """Texts of points, most of them on the surface: few, so that some of a call are equal."""
    result = []
    for _ in range(dice.choice([1, 2, 4])):
        weights = dice.choice(["1,0,0", "0,1,0", "0,0,1", "0.5,0.5,0", "0,0.25,0.75", "0.5,0,0.5", "0.2,0.3,0.5",
                               "1,1e-17,0", "0.3333333333333333,0.3333333333333333,0.3333333333333334"])
        result.append(dice.choice([str(dice.randrange(len(points))), f"{dice.randrange(max(len(faces), 1))}:{weights}",
                                   ",".join(map(str, dice.choice(points)))]))
    return result + ([str(len(points)), dice.choice(PLACES)] if dice.random() < 0.1 else [])


# ---- Runs ----

OUTPUTS = {"distance": ["ply", "vtp"], "path": ["obj", "ply", "vtp"], "hyperbolic": ["obj", "ply", "vtp"],
           "flatten": ["obj", "ply", "vtp"], "uniformize": ["obj", "ply", "vtp"]}


def output(dice, command):
    if command == "info":
        return []
    extension = dice.choice(OUTPUTS.get(command, ["off", "obj", "ply", "vtp"]) + ["ply"])
    extension = "html" if command == "view" else extension
    return ["--prefix", "o"] if command == "operators" else ["-o", "o." + extension]


def arguments(dice, mesh, curve, commands):
    command = dice.choice(sorted(commands))
    result = [command, mesh]
    picture = dice.choice(["o.svg", "o.png"])
    if command == "info":
        return result + dice.choice([[], ["--json"], ["--view", "o.html", "--picture", picture]])
    result += output(dice, command)
    if command == "view":
        return result
    if result[-1] == "o.ply" and command not in ("operators", "transfer"):
        result += dice.choice([[], ["--binary"]])
    sources = [["--source", "0"], ["--source", "0:0.2,0.3,0.5"], ["--source", "0,0,0", "--exact-distance"],
               ["--curve", mesh, "--signed"], ["--curve", curve], ["--curve", curve, "--signed"]]
    if command in ("refine", "distance", "transfer", "operators", "simplify"):
        result += ["--max-insertions", "300"]
    result += {"distance": dice.choice(sources),
               "transfer": [dice.choice(["--points", "--data"]), mesh],
               "path": ["--from", "0", "--to", "1", dice.choice(["--flips", "--quiet"])]
                       if dice.random() < 0.8 else ["--homology"],
               "simplify": ["--ratio", "0.5", "--prolongation", "o.mtx"]}.get(command, [])
    if command == "simplify":
        result += dice.choice([[], ["--weight", "color=1"], ["--weight", "quality=2"]])
        result += dice.choice([[], ["--min-angle", "20"]])
    result += dice.choice([[], ["--repair"], ["--mollify", "1e-6"], ["--strict"]])
    if command in ("distance", "operators"):
        result += dice.choice([[], ["--neighbors", "9"]])
    result += dice.choice([[], [], ["--view", "o.html", "--picture", picture],
                           ["--picture", picture, "--section", dice.choice(PLACES), dice.choice(NUMBERS)]])
    if command in ("delaunay", "refine", "distance"):
        result += dice.choice([[], ["--direct"]])
    if dice.random() < 0.9:
        result += ["--stats", "o.json"]
    return with_options(dice, result, commands[command], dice.choice([0, 0, 0, 1, 2]), PLACES)


def arguments_on(dice, mesh, points, commands):
    """Of a call on a valid surface, most of whose options make sense."""
    command = dice.choice(sorted(commands))
    result = [command, mesh] + output(dice, command)

    def any_of(option, most):
        return [word for _ in range(dice.randrange(most + 1)) for word in (option, dice.choice(points))]

    if command == "distance":
        result += ["--source", dice.choice(points)] + any_of("--source", 3)
        result += dice.choice([[], ["--exact-distance"]])
    elif command == "path":
        start = ["--from", dice.choice(points)]
        end = start + ["--to", dice.choice(points)]
        result += dice.choice([end, end + ["--flips"] + any_of("--via", 3), start + ["--loop"] + any_of("--via", 3),
                               start + ["--straightest", dice.choice("0 30 -45 90 180 1e9".split()),
                                        dice.choice("0 1e-9 0.1 1 10".split())], ["--homology"]])
    elif command == "transfer":
        result += [dice.choice(["--points", "--data"]), "points.txt"]
    elif command == "simplify":
        result += dice.choice([["--ratio", "0.5"], ["--vertices", "1"], ["--error", "0.1"], []])
    if command in ("refine", "distance", "transfer", "operators", "simplify"):
        result += ["--max-insertions", "300"]
    result += dice.choice([[], [], ["--repair"], ["--mollify", "1e-6"]]) if command not in ("info", "view") else []
    result = with_options(dice, result, commands[command], dice.choice([0, 1, 1, 2, 2, 3, 5]), points)
    return result + (["--picture", "o.png"] if "--section" in result and "--picture" not in result else [])


def with_options(dice, call, options, number, points):
    result = list(call)
    for option in dice.choices(options, k=number) if options else []:
        if option.name in result:  # takes the place of a sensible value
            i = result.index(option.name)
            del result[i:i + 1 + option.number_of_values]
        result += option.drawn(dice, points)
    return result


def limit_memory():
    resource.setrlimit(resource.RLIMIT_AS, (4 << 30, 4 << 30))


def is_sanitized(program):
    with open(program, "rb") as file:
        return b"__asan_init" in file.read()


class Process:
    """A process for each run."""

    def __init__(self, options):
        self.program = [options.program]
        self.keywords = dict(capture_output=True, timeout=60, env=options.environment,
                             stdin=subprocess.DEVNULL, preexec_fn=options.prepare)

    def __call__(self, call, directory):
        """The exit code and what has been written."""
        try:
            result = subprocess.run(self.program + call, cwd=directory, **self.keywords)
            return result.returncode, result.stdout + result.stderr
        except subprocess.TimeoutExpired:
            return -signal.SIGALRM, b""


class Server:
    """One process that runs the program in children; each thread has its own."""

    def __init__(self, options):
        self.options, self.local = options, threading.local()

    def __call__(self, call, directory):
        if not hasattr(self.local, "process"):
            self.local.process = subprocess.Popen(
                [self.options.program], stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                env=self.options.environment, preexec_fn=self.options.prepare)
        process = self.local.process
        process.stdin.write(("\t".join([directory] + call) + "\n").encode())
        process.stdin.flush()
        code = int(process.stdout.readline())
        with open(directory + ".txt", "rb") as file:
            text = file.read()
        os.remove(directory + ".txt")
        return code, text


def all_options(run_program, scratch):
    """The options of each command."""
    def help(call):
        directory = f"{scratch}/help"
        os.makedirs(directory, exist_ok=True)
        return run_program(call + ["--help"], directory)[1].decode()
    return {command: listed_options(help([command])) for command in listed_commands(help([]))}


def complaint(call, code, text, directory, inputs):
    """What is wrong with a run; nothing is None."""
    left = [name for name in os.listdir(directory) if name not in inputs]
    if code == -signal.SIGALRM:
        return "more than a minute"
    if code not in (0, 1, 2) + (3,) * ("--keep-going" in call) or b"Sanitizer" in text or b"runtime error" in text:
        return f"exit code {code}: {text[:2000].decode(errors='replace')}"
    if code != 0 and not text.strip():
        return "no message"
    is_verdict = call[0] == "info" and code == 2 and (b"error: " in text or "--json" in call)  # with pictures
    if (code not in (0, 3) and left and not is_verdict
            or any(name.endswith(".part") for name in left)):
        return f"files are left: {left}"
    if "o.png" in left and not is_png(os.path.join(directory, "o.png")):
        return "o.png is no complete picture"
    return None


def is_png(path):
    with open(path, "rb") as file:
        content = file.read()
    return content.startswith(b"\x89PNG\r\n\x1a\n") and content[-8:-4] == b"IEND"


def damaged_run(dice, options, seeds):
    """A call and the files that it reads."""
    extension, content, curves = dice.choice(seeds)
    curve_extension, curve_content = dice.choice(curves)
    mesh, curve = "mesh." + extension, "curve." + curve_extension
    call = arguments(dice, mesh, curve, options.commands)
    inputs = {mesh: content if curve in call and dice.random() < 0.5 else damaged(dice, content, seeds)}
    if curve in call:
        inputs[curve] = damaged(dice, curve_content, curves)
    return call, inputs


def degenerate_run(dice, options):
    points, faces = degenerate_surface(dice)
    extension, write = dice.choice([("off", off), ("obj", plain_obj), ("ply", ply)])
    mesh, texts = "mesh." + extension, points_on(dice, points, faces)
    call = arguments_on(dice, mesh, texts, options.commands)
    lines = texts if "--points" in call else [f"{i} {i / 2}" for i in range(len(points))]
    inputs = {mesh: in_bytes(write(points, faces))}
    if "points.txt" in call:
        inputs["points.txt"] = in_bytes("\n".join(lines) + "\n")
    return call, inputs


def run(i, options, seeds, scratch):
    """Whether run i went well, and how it ended."""
    dice = random.Random(i)
    call, inputs = damaged_run(dice, options, seeds) if i % 2 == 0 else degenerate_run(dice, options)
    directory = f"{scratch}/{i}"
    os.mkdir(directory)
    for name, content in inputs.items():
        with open(f"{directory}/{name}", "wb") as file:
            file.write(content)
    code, text = options.run_program(call, directory)
    wrong = complaint(call, code, text, directory, inputs)
    if wrong:
        print(f"FAILED: run {i}: intrinsic {' '.join(call)}: {wrong}", flush=True)
        if options.keep:
            os.makedirs(options.keep, exist_ok=True)
            for name in inputs:
                shutil.copy(f"{directory}/{name}", f"{options.keep}/{i}.{name}")
    shutil.rmtree(directory)
    return not wrong, code


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program", type=os.path.abspath)
    parser.add_argument("data", type=os.path.abspath)
    parser.add_argument("--runs", type=int, default=600)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--keep")
    parser.add_argument("--server", action="store_true")
    options = parser.parse_args()
    options.prepare = None if is_sanitized(options.program) else limit_memory
    sanitizer = ("exitcode=99:detect_leaks=0:max_allocation_size_mb=2000:"
                 "malloc_context_size=4:print_stacktrace=1")
    options.environment = dict(os.environ, ASAN_OPTIONS=sanitizer, UBSAN_OPTIONS=sanitizer)
    options.run_program = (Server if options.server else Process)(options)
    if not os.path.isdir(f"{options.data}/meshes"):
        sys.exit(77)
    seeds = all_seeds(options.data)
    with tempfile.TemporaryDirectory() as scratch, ThreadPoolExecutor(options.jobs) as pool:
        options.commands = all_options(options.run_program, scratch)
        numbers = range(options.first, options.first + options.runs)
        ends = list(pool.map(lambda i: run(i, options, seeds, scratch), numbers))
    codes = [code for _, code in ends]
    print(f"{len(ends)} runs, exit codes: "
          + ", ".join(f"{c}: {codes.count(c)}" for c in sorted(set(codes), key=str)))
    sys.exit(0 if all(good for good, _ in ends) else 1)


if __name__ == "__main__":
    main()
