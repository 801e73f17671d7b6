# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Reads the files that the program writes: files.py CLAIM... fails unless every CLAIM, a Python
expression in the names below, is true; "NAME = EXPRESSION" gives a value a name,
"print(EXPRESSION)" prints it. Vertices, faces and edges are numbered from 0."""

import json as json_format
import re
import struct
import sys
import zlib
from collections import Counter, defaultdict
from math import acos, acosh, atan2, atanh, degrees, dist, exp, fsum, hypot, log, pi, sin, sqrt


class Named(dict):
    """A JSON object whose keys are attributes."""

    __getattr__ = dict.__getitem__


def json(path):
    with open(path) as file:
        return json_format.load(file, object_hook=Named)


def keys(value):
    """All keys of a JSON object and of those inside, in their order."""
    if isinstance(value, list):
        return [k for x in value for k in keys(x)]
    return [k for key in value for k in [key] + keys(value[key])] if isinstance(value, dict) else []


def lines_of(path):
    with open(path) as file:
        return file.read().split("\n")


def number(word):
    return float(word) if re.search("[.enai]", word) else int(word)


class Mesh:
    """Points, faces and edges; `vertex`, `face` and `edge` hold lists of values by name."""

    def __init__(self):
        self.points, self.faces, self.edges = [], [], []
        self.texture, self.texture_faces = [], []
        self.groups, self.libraries = [], []
        self.vertex, self.face, self.edge = (defaultdict(list) for _ in range(3))

    def __eq__(self, other):
        return vars(self) == vars(other)


def ply_header(file):
    """The elements, as names, numbers and properties, which are names and types; of lists, those of
    the size, too. And whether numbers are binary."""
    elements = []
    for words in map(str.split, map(bytes.decode, file)):
        if words[0] == "format":
            is_binary = words[1] == "binary_little_endian"
        elif words[0] == "element":
            elements.append((words[1], int(words[2]), []))
        elif words[0] == "property":
            elements[-1][2].append((words[-1], [w for w in words[1:-1] if w != "list"]))
        elif words[0] == "end_header":
            return elements, is_binary


def ply(path):
    file, mesh = open(path, "rb"), Mesh()
    elements, is_binary = ply_header(file)
    words = iter([] if is_binary else file.read().decode().split())

    def read(type):
        if not is_binary:
            return number(next(words))
        code = "<" + {"uchar": "B", "int": "i", "uint": "I", "double": "d"}[type]
        return struct.unpack(code, file.read(struct.calcsize(code)))[0]

    for element, count, properties in elements:
        values = getattr(mesh, element)
        for _ in range(count):
            for name, types in properties:
                value = read(types[0])
                if len(types) > 1:
                    value = [read(types[1]) for _ in range(value)]
                values[name].append(value)
    mesh.points = list(zip(*(mesh.vertex[x] for x in "xyz")))
    mesh.faces = mesh.face.get("vertex_indices", [])
    mesh.edges = list(zip(mesh.edge["vertex1"], mesh.edge["vertex2"]))
    return mesh


def obj(path):
    mesh, group = Mesh(), {}
    for words in filter(None, map(str.split, lines_of(path))):
        if words[:1] == ["v"]:
            mesh.points.append(tuple(map(float, words[1:4])))
        elif words[:1] == ["vt"]:
            mesh.texture.append(tuple(map(float, words[1:])))
        elif words[:1] == ["mtllib"]:
            mesh.libraries.append(words[1:])
        elif words[0] in ("o", "g", "usemtl"):
            group = {**group, words[0]: words[1:]}
        elif words[:1] == ["f"]:
            mesh.groups.append(group)
            corners = [[int(i) - 1 for i in w.split("/") if i] for w in words[1:]]
            mesh.faces.append([c[0] for c in corners])
            mesh.texture_faces.append([c[1] for c in corners if len(c) > 1])
    return mesh


def off(path):
    words = iter(" ".join(lines_of(path)).split())
    mesh = Mesh()
    assert next(words) == "OFF"
    vertices, faces, _ = (int(next(words)) for _ in range(3))
    mesh.points = [tuple(float(next(words)) for _ in range(3)) for _ in range(vertices)]
    mesh.faces = [[int(next(words)) for _ in range(int(next(words)))] for _ in range(faces)]
    return mesh


class Matrix:
    """A Matrix Market file: entries {(row, column): value}, both triangles of a symmetric one."""

    def __init__(self, path):
        lines = [line for line in lines_of(path) if line]
        self.header, self.comments = lines[0], [l for l in lines[1:] if l[0] == "%"]
        lines = [l.split() for l in lines if l[0] != "%"]
        self.rows, self.columns, self.size = map(int, lines[0])
        self.stored = {(int(l[0]) - 1, int(l[1]) - 1): complex(*map(float, l[2:])) for l in lines[1:]}
        self.has_right_size = len(lines) - 1 == self.size == len(self.stored)
        self.entries = dict(self.stored)
        if not self.header.endswith("general"):
            self.entries.update({(j, i): z.conjugate() for (i, j), z in self.stored.items()})

    def __matmul__(self, values):
        sums = [[] for _ in range(self.rows)]
        for (i, j), z in self.entries.items():
            sums[i].append(z.real * values[j])
        return [fsum(s) for s in sums]


mtx = Matrix


def vtp(path):
    """The arrays of a VTP file as {(section, name): lists of numbers, one for each line}."""
    result, section, name = {}, None, None
    for line in lines_of(path):
        if m := re.match(r"<(PointData|CellData|Points|Lines|Polys)\b", line.strip()):
            section = m.group(1)
        elif m := re.search(r'<DataArray.*Name="(\w+)"', line):
            name = m.group(1)
            result[section, name] = []
        elif "</DataArray" in line:
            name = None
        elif name:
            result[section, name].append([number(w) for w in line.split()])
    return result


# ---- Measures ----


def png(path):
    """The width, the height and the bytes of the rows, each after the byte of its filter."""
    with open(path, "rb") as file:
        data, pieces = file.read(), b""
    assert data[:8] == b"\x89PNG\r\n\x1a\n"
    width, height = struct.unpack(">II", data[16:24])
    place = 8
    while place < len(data):
        size, kind = struct.unpack(">I4s", data[place:place + 8])
        pieces += data[place + 8:place + 8 + size] if kind == b"IDAT" else b""
        place += size + 12
    return width, height, zlib.decompress(pieces)


def near(a, b, tolerance):
    """Whether two numbers, or those of two lists, differ by no more than the tolerance."""
    if isinstance(a, (int, float)):
        return abs(a - b) <= tolerance
    a, b = list(a), list(b)
    return len(a) == len(b) and all(abs(x - y) <= tolerance for x, y in zip(a, b))


def minus(p, q):
    return [a - b for a, b in zip(p, q)]


def cross(p, q):
    return (p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0])


def area(mesh):
    """In space; faces are flat."""
    result = 0
    for face in mesh.faces:
        p = [mesh.points[v] for v in face]
        parts = [cross(minus(p[i - 1], p[0]), minus(p[i], p[0])) for i in range(2, len(p))]
        result += hypot(*map(sum, zip(*parts))) / 2
    return result


def volume(mesh):
    """Enclosed by a closed surface; negative if normals point inward."""
    result = 0
    for face in mesh.faces:
        p = [mesh.points[v] for v in face]
        result += fsum(x * y for i in range(2, len(p)) for x, y in zip(p[0], cross(p[i - 1], p[i])))
    return result / 6


def signed_area(points, face):
    """In the plane."""
    p = [points[v] for v in face]
    return fsum(p[i - 1][0] * p[i][1] - p[i - 1][1] * p[i][0] for i in range(len(p))) / 2


def flat_area(mesh):
    return fsum(signed_area(mesh.texture, f) for f in mesh.texture_faces)


def common_area(a, b):
    """Of two convex polygons in the plane, counterclockwise: one is clipped by the sides of the other."""
    for p, q in zip(b, b[1:] + b[:1]):
        height = [(q[0] - p[0]) * (z[1] - p[1]) - (q[1] - p[1]) * (z[0] - p[0]) for z in a]
        clipped = []
        for i, z in enumerate(a):
            before, h = height[i - 1], height[i]
            if before * h < 0:
                t = before / (before - h)
                clipped.append([x + t * (y - x) for x, y in zip(a[i - 1], z)])
            if h >= 0:
                clipped.append(z)
        a = clipped
    return signed_area(a, range(len(a)))


def overlap(mesh):
    """Of all pairs of faces in the plane."""
    faces = [[mesh.texture[v][:2] for v in f] for f in mesh.texture_faces]
    return fsum(common_area(a, b) for i, a in enumerate(faces) for b in faces[:i])


def is_ordinary(mesh):
    """Whether vertices determine edges, each in one face or two of opposite directions."""
    sides = [(f[i - 1], f[i]) for f in mesh.faces for i in range(len(f))]
    return len(set(sides)) == len(sides) and all(a != b for a, b in sides)


def data_of(p):
    """The functions f, constant, nx, ny and nz of meshes with data, at a point."""
    x, y, z = p
    return [1 + 2 * x - 3 * y + z / 2, 7, x + y, y - z, 3 * z - x]


def texture_of(p, chart=0):
    return [p[0] + p[2] / 2 + 10 * chart, p[1] - p[2] - 3 * chart]


def has_functions(mesh, points, scale=1):
    """Whether a mesh from PLY has these at all points, and a constant color."""
    names = ["f", "constant", "nx", "ny", "nz"]
    colors = zip(*(mesh.vertex[x] for x in ("red", "green", "blue", "alpha")))
    return (all(near(values, data_of(p), 1e-12 * scale)
                for *values, p in zip(*(mesh.vertex[x] for x in names), points, strict=True))
            and set(mesh.vertex["constant"]) == {7} and set(colors) == {(10, 250, 30, 255)})


def has_data(mesh, points, texture, charts=None):
    """Whether a mesh from PLY has these functions, and texture coordinates at all corners."""
    scale = max(abs(x) for p in points for x in p) + 13 * max(charts or [0])
    return (has_functions(mesh, points, scale)
            and all(near(t, [x for v in f for x in texture_of(points[v], c)], 1e-12 * scale)
                    for t, f, c in zip(mesh.face[texture], mesh.faces, charts or [0] * len(mesh.faces),
                                       strict=True)))


def sums(keys, values):
    """The sums of the values with equal keys, but for the key -1, by key."""
    result = defaultdict(float)
    for key, value in zip(keys, values):
        if key != -1:
            result[key] += value
    return dict(sorted(result.items()))


def box(points):
    """Width and height of points in the plane; the least coordinates must be zero."""
    assert hypot(min(p[0] for p in points), min(p[1] for p in points)) < 1e-10
    return max(p[0] for p in points), max(p[1] for p in points)


def length(mesh, edge):
    return dist(*(mesh.points[v] for v in edge))


def shape(mesh):
    """The least angle in degrees and the greatest circumradius of the intrinsic faces, in space. The
    length of an intrinsic edge is that of its parts in the common subdivision; its sides are among
    those of the parts of the face."""
    parent, sides = {}, defaultdict(dict)
    whole = sums(mesh.edge["intrinsic_edge"], (length(mesh, e) for e in mesh.edges))
    for (v, w), e in zip(mesh.edges, mesh.edge["intrinsic_edge"]):
        parent[v, w] = parent[w, v] = e
    for face, triangle in zip(mesh.faces, mesh.face["intrinsic_face"]):
        for corner in zip(face, face[1:] + face[:1]):
            if (e := parent[corner]) >= 0:
                sides[triangle][e] = whole[e]
    angles, radii = [], []
    for a, b, c in (side.values() for side in sides.values()):
        s = sqrt((a + b + c) * (b + c - a) * (a + b - c) * (a + c - b))
        radii.append(a * b * c / s)
        angles += [degrees(atan2(s, y * y + z * z - x * x)) for x, y, z in
                   ((a, b, c), (b, c, a), (c, a, b))]
    return min(angles), max(radii)


def ends_parts_of_input_edges(mesh):
    """An inserted vertex on an input edge ends two parts of it, and no part of another one."""
    edge = {v: e for v, (k, e) in enumerate(zip(mesh.vertex["kind"], mesh.vertex["input_edge"])) if k == 2}
    parts = Counter((v, e) for ends, e in zip(mesh.edges, mesh.edge["input_edge"]) if e >= 0
                    for v in ends if v in edge)
    return parts == {(v, e): 2 for v, e in edge.items() if e >= 0}


def coarse_areas(mesh):
    """Of each coarse face in a plane, by its number."""
    return sums(mesh.face["coarse_face"], (signed_area(mesh.points, f) for f in mesh.faces))


def coarse_edges(mesh):
    """The number of coarse edges, and their length together."""
    lengths = sums(mesh.edge["coarse_edge"], (length(mesh, e) for e in mesh.edges))
    return len(lengths), fsum(lengths.values())


def lines(path):
    """The number of poly-lines in a VTP file, and their length together."""
    arrays = vtp(path)
    points = arrays["Points", "Points"]
    paths = arrays["Lines", "connectivity"]
    return len(paths), fsum(dist(points[v], points[w]) for p in paths for v, w in zip(p, p[1:]))


def is_colored(mesh):
    """The faces have one color for each coarse face, and another on the other side of its edges."""
    color, coarse = {}, {}
    for face, c, *rgb in zip(mesh.faces, *(mesh.face[x] for x in ("coarse_face", "red", "green", "blue"))):
        if color.setdefault(c, rgb) != rgb:
            return False
        coarse.update({corner: c for corner in zip(face, face[1:] + face[:1])})
    return all(c == d or color[c] != color[d]
               for (v, w), c in coarse.items() if (d := coarse.get((w, v))) is not None)


def is_prolongation(matrix, rows, columns):
    """Of this size, no entry is negative, and each row has the sum 1."""
    return ((matrix.rows, matrix.columns) == (rows, columns)
            and all(z.real >= 0 for z in matrix.entries.values())
            and near(matrix @ ([1] * columns), [1] * rows, 1e-12))


def errors(distances, points, *sources):
    """What is missed to the distances to the nearest of some places, and these distances."""
    truth = [min(dist(p[:2], s[:2]) for s in sources) for p in points]
    return [abs(a - b) for a, b in zip(distances, truth)], truth


def is_harmless(*paths):
    """No coordinate or entry is infinite or NaN."""
    return not any(re.search("nan|inf", line, re.I) for path in paths for line in lines_of(path))


if __name__ == "__main__":
    for claim in sys.argv[1:]:
        if re.match(r"[\w, ]+ = |print\(", claim):
            exec(claim)
        elif not eval(claim):
            sys.exit("not so: " + claim)
