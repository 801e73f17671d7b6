# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""The heat method on the triangles of a mesh as they are, to be compared with that on an intrinsic
triangulation (K. Crane, C. Weischedel, M. Wardetzky: The heat method for distance computation). Needs
scipy."""

import numpy as np
import scipy.sparse as sparse
from scipy.sparse.linalg import spsolve


def read_off(path):
    words = " ".join(line for line in open(path) if not line.startswith("#")).split()
    n, m = int(words[1]), int(words[2])
    points = np.array(words[4:4 + 3 * n], float).reshape(n, 3)
    faces = np.array(words[4 + 3 * n:4 + 3 * n + 4 * m], int).reshape(m, 4)[:, 1:]
    return points, faces


def read_property(path, name):
    """Of the vertices of a PLY file in ASCII."""
    lines = open(path).read().split("\n")
    end = lines.index("end_header")
    header = [line.split() for line in lines[:end]]
    start = next(i for i, words in enumerate(header) if words[:2] == ["element", "vertex"])
    count, names = int(header[start][2]), []
    for words in header[start + 1:]:
        if words[0] != "property":
            break
        names.append(words[-1])
    column = names.index(name)
    return np.array([line.split()[column] for line in lines[end + 1:end + 1 + count]], float)


def write_ply(path, points, faces, values, name):
    header = ["ply", "format ascii 1.0", f"element vertex {len(points)}",
              *(f"property double {x}" for x in ("x", "y", "z", name)), f"element face {len(faces)}",
              "property list uchar int vertex_indices", "end_header"]
    rows = [" ".join(map(repr, map(float, (*p, v)))) for p, v in zip(points, values)]
    open(path, "w").write("\n".join([*header, *rows, *(f"3 {a} {b} {c}" for a, b, c in faces), ""]))


def heat_distance(points, faces, source):
    corners = points[faces]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    doubled = np.linalg.norm(normals, axis=1)
    sides = [corners[:, (k + 2) % 3] - corners[:, (k + 1) % 3] for k in range(3)]  # opposite to corner k
    cotangents = [-np.einsum("ij,ij->i", sides[(k + 1) % 3], sides[(k + 2) % 3]) / doubled for k in range(3)]
    n = len(points)
    laplacian, mass = sparse.csr_matrix((n, n)), np.zeros(n)
    for k in range(3):
        i, j, w = faces[:, (k + 1) % 3], faces[:, (k + 2) % 3], cotangents[k] / 2
        laplacian += sparse.csr_matrix((np.r_[w, w, -w, -w], (np.r_[i, j, i, j], np.r_[i, j, j, i])), (n, n))
        np.add.at(mass, faces[:, k], doubled / 6)
    time = np.mean([np.linalg.norm(s, axis=1) for s in sides]) ** 2
    heat = spsolve((sparse.diags(mass) + time * laplacian).tocsc(), np.eye(1, n, source)[0])
    unit = normals / doubled[:, None]
    gradient = sum(heat[faces[:, k], None] * np.cross(unit, sides[k]) for k in range(3))
    direction = -gradient / np.linalg.norm(gradient, axis=1)[:, None]
    divergence = np.zeros(n)
    for k in range(3):
        after, before = sides[(k + 2) % 3], -sides[(k + 1) % 3]  # the sides that leave corner k
        part = (cotangents[(k + 2) % 3] * np.einsum("ij,ij->i", after, direction) +
                cotangents[(k + 1) % 3] * np.einsum("ij,ij->i", before, direction)) / 2
        np.add.at(divergence, faces[:, k], part)
    others = np.flatnonzero(np.arange(n) != source)
    result = np.zeros(n)
    result[others] = spsolve(laplacian[others][:, others].tocsc(), -divergence[others])
    return result
