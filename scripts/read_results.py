# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Reads the files that the program `intrinsic` writes into numpy and scipy:

    import read_results as results
    mesh = results.read("out.ply")         # or .vtp, .obj, .off
    mesh.points                            # array of n x 3 numbers
    mesh.faces                             # list of arrays of vertices, from 0
    mesh.vertex["distance"]                # one value for each vertex
    mesh.face["input_face"]                # one for each face, mesh.edge[...] for each edge
    L = results.read("P_laplacian.mtx")    # sparse matrix, both triangles of a symmetric one
    results.read("stats.json")["vertices"]

As a program, read_results.py FILE... says what is in the files. Needs numpy, and scipy for matrices."""

import json
import sys
import xml.etree.ElementTree as xml
from dataclasses import dataclass, field
from pathlib import Path

import numpy

PLY_TYPES = {"char": "i1", "uchar": "u1", "short": "i2", "ushort": "u2", "int": "i4", "uint": "u4",
             "float": "f4", "double": "f8", "int64": "i8"}


@dataclass
class Mesh:
    """Vertices, faces, edges or poly-lines, and values at them by name."""

    points: numpy.ndarray = None
    faces: list = field(default_factory=list)
    edges: numpy.ndarray = None  # pairs of vertices (.ply)
    lines: list = field(default_factory=list)  # of vertices (.vtp, .obj)
    vertex: dict = field(default_factory=dict)
    face: dict = field(default_factory=dict)
    edge: dict = field(default_factory=dict)
    texture: numpy.ndarray = None  # coordinates u v, or u w, v w, w (.obj)
    texture_faces: list = field(default_factory=list)  # indices of these for each face


def ply_elements(file):
    """Name, size and properties (name, type of the size of a list or None, type), and the format."""
    elements = []
    while (words := file.readline().decode().split()) != ["end_header"]:
        if words[0] == "format":
            is_binary = words[1] != "ascii"
        elif words[0] == "element":
            elements.append((words[1], int(words[2]), []))
        elif words[0] == "property":
            size, kind = (words[2], words[3]) if words[1] == "list" else (None, words[1])
            elements[-1][2].append((words[-1], size and PLY_TYPES[size], PLY_TYPES[kind]))
    return elements, is_binary


class Ply_values:
    """The values of a PLY file one after the other."""

    def __init__(self, file, is_binary):
        self.data = file.read() if is_binary else file.read().split()
        self.is_binary, self.place = is_binary, 0

    def take(self, kind, n):
        kind = numpy.dtype("<" + kind)
        begin = self.place
        self.place += n * (kind.itemsize if self.is_binary else 1)
        if self.is_binary:
            return numpy.frombuffer(self.data, kind, n, begin)
        return numpy.array(self.data[begin:self.place]).astype(kind)


def read_ply(path):
    with open(path, "rb") as file:
        elements, is_binary = ply_elements(file)
        values = Ply_values(file, is_binary)
    columns = {}
    for name, n, properties in elements:
        rows = [[values.take(kind, values.take(size, 1)[0] if size else 1)
                 for _, size, kind in properties] for _ in range(n)]
        columns[name] = {p[0]: [r[k] for r in rows] if p[1] else numpy.array([r[k][0] for r in rows])
                         for k, p in enumerate(properties)}
    mesh = Mesh(vertex=columns["vertex"], face=columns.get("face", {}), edge=columns.get("edge", {}))
    mesh.points = numpy.column_stack([mesh.vertex.pop(x) for x in "xyz"])
    mesh.faces = mesh.face.pop("vertex_indices", [])
    if mesh.edge:
        mesh.edges = numpy.column_stack([mesh.edge.pop("vertex1"), mesh.edge.pop("vertex2")])
    return mesh


def vtp_arrays(piece, section):
    """The arrays of a section of a VTP file by name."""
    result = {}
    for array in piece.findall(f"{section}/DataArray"):
        kind = float if array.get("type").startswith("Float") else int
        values = numpy.array((array.text or "").split(), dtype=kind)
        columns = int(array.get("NumberOfComponents", 1))
        result[array.get("Name")] = values.reshape(-1, columns) if columns > 1 else values
    return result


def read_vtp(path):
    piece = xml.parse(path).getroot().find("PolyData/Piece")
    mesh = Mesh(points=vtp_arrays(piece, "Points")["Points"], vertex=vtp_arrays(piece, "PointData"))
    chains = {}
    for section in "Polys", "Lines":
        cells = vtp_arrays(piece, section)
        chains[section] = numpy.split(cells["connectivity"], cells["offsets"])[:-1] if cells else []
    mesh.faces, mesh.lines = chains["Polys"], chains["Lines"]
    # Lines come before polygons; values belong to both.
    mesh.face = {name: values[len(mesh.lines):] for name, values in vtp_arrays(piece, "CellData").items()}
    return mesh


def read_obj(path):
    mesh, points, texture = Mesh(), [], []
    for line in Path(path).read_text().splitlines():
        words = line.split("#")[0].split() or [""]
        if words[0] in ("v", "vt"):
            (points if words[0] == "v" else texture).append([float(w) for w in words[1:]])
        elif words[0] == "l":
            mesh.lines.append(numpy.array([int(w) - 1 for w in words[1:]]))
        elif words[0] == "f":
            corners = [(w + "/").split("/")[:2] for w in words[1:]]  # without normals
            mesh.faces.append(numpy.array([int(v) - 1 for v, vt in corners]))
            mesh.texture_faces.append(numpy.array([int(vt) - 1 for v, vt in corners if vt]))
    rows = numpy.array(points)
    mesh.points, mesh.texture = rows[:, :3], numpy.array(texture)
    for name, values in zip(("red", "green", "blue"), rows.T[3:]):
        mesh.vertex[name] = values
    return mesh


def read_off(path):
    words = iter(Path(path).read_text().split()[1:])
    vertices, faces, _ = (int(next(words)) for _ in range(3))
    points = numpy.array([[float(next(words)) for _ in range(3)] for _ in range(vertices)])
    corners = [numpy.array([int(next(words)) for _ in range(int(next(words)))]) for _ in range(faces)]
    return Mesh(points=points, faces=corners)


def read_mtx(path):
    from scipy.io import mmread
    return mmread(path).tocsr()


def read_json(path):
    with open(path) as file:
        return json.load(file)


READERS = {".ply": read_ply, ".vtp": read_vtp, ".obj": read_obj, ".off": read_off,
           ".mtx": read_mtx, ".json": read_json}


def read(path):
    """A mesh, a matrix or statistics, by the extension of the file."""
    return READERS[Path(path).suffix](path)


def description(result):
    if isinstance(result, dict):
        return "statistics: " + ", ".join(result)
    if not isinstance(result, Mesh):
        return f"matrix of {result.shape[0]} x {result.shape[1]} with {result.nnz} entries"
    parts = [f"{len(result.points)} vertices", f"{len(result.faces)} faces"]
    parts += [f"{len(result.lines)} lines"] if result.lines else []
    parts += [f"{kind}: {', '.join(values)}" for kind in ("vertex", "face", "edge")
              if (values := getattr(result, kind))]
    return "; ".join(parts)


if __name__ == "__main__":
    for name in sys.argv[1:]:
        print(f"{name}: {description(read(name))}")
