# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Points FACE:a,b,c of all commands that take or print them: corners.py PROGRAM. Positions are computed here
from the faces of the files. Works in the current directory."""

import subprocess
import sys

from files import dist, json, near, ply
from fuzz import FORMATS, off

WEIGHTS = [0.625, 0.25, 0.125]

# A convex polygon in the plane, so that distances are those of the plane.
POINTS = [[0, 0, 0], [1, 0, 0], [0.25, 0.75, 0], [1.5, 1, 0]]
DELAUNAY = [[0, 1, 2], [1, 3, 2]]
FLIPPED = [[0, 1, 3], [0, 3, 2]]  # the diagonal that is not Delaunay


def run(*arguments):
    result = subprocess.run([sys.argv[1], *arguments, "--quiet"], capture_output=True, text=True)
    assert result.returncode == 0, result.stderr


def write(name, content):
    with open(name, "wb") as file:
        file.write(content.encode() if isinstance(content, str) else content)
    return name


def rotations(face):
    return [face[k:] + face[:k] for k in range(len(face))]


def combination(weights, points):
    return [sum(w * p[k] for w, p in zip(weights, points, strict=True)) for k in range(3)]


def text(face, weights=WEIGHTS):
    return f"{face}:" + ",".join(map(str, weights))


def place(word):
    face, weights = word.split(":")
    return int(face), [float(w) for w in weights.split(",")]


def intrinsic_corners(path):
    """The corners of the faces of T2 in a file of --save, from the sources of their halfedges."""
    lines = [list(line.split()) for line in open(path)][1:]
    for _ in range(2):
        vertices, edges, faces = map(int, lines.pop(0))
        edge = [list(map(int, line[:4])) for line in lines[vertices:vertices + edges]]
        first = [int(line[0]) for line in lines[vertices + edges:vertices + edges + faces]]
        lines = lines[vertices + edges + faces:]
    source = lambda h: edge[h // 2][1 - h % 2]
    following = lambda h: edge[h // 2][2 + h % 2]
    return [[source(h), source(following(h)), source(following(following(h)))] for h in first]


def check_path(mesh, face, corners, *options):
    run("path", mesh, "--from", text(face), "--to", "0", "-o", "o.ply", "--stats", "o.json", *options)
    start, found = combination(WEIGHTS, corners), json("o.json").places[0]
    assert near(ply("o.ply").points[0], start, 1e-15), (mesh, ply("o.ply").points[0], start)
    assert found["face"] == face and found["barycentric"] == WEIGHTS, (mesh, found)
    run("path", mesh, "--from", "0", "--to", text(face), "-o", "o.ply", "--stats", "o.json", *options)
    assert near(ply("o.ply").points[-1], start, 1e-15) and json("o.json").places[-1]["barycentric"] == WEIGHTS


def check_distance(mesh, face, corners, *options):
    run("distance", mesh, "--source", text(face), "--exact-distance", "-o", "o.ply", "--stats", "o.json", *options)
    start, result = combination(WEIGHTS, corners), ply("o.ply")
    assert near(result.vertex["distance"], [dist(p, start) for p in result.points], 1e-14), mesh
    assert json("o.json").sources == [{"face": face, "barycentric": WEIGHTS}], mesh


def check_transfer(mesh, face, corners, *options):
    start = combination(WEIGHTS, corners)
    write("points.txt", text(face) + "\n" + ",".join(map(str, start)) + "\n")
    run("transfer", mesh, "--points", "points.txt", "-o", "there.txt", "--save", "o.save", *options)
    run("transfer", mesh, "--points", "there.txt", "--back", "-o", "back.txt", *options)
    run("distance", mesh, "--source", "0", "-o", "o.ply", *options)
    points, faces = ply("o.ply").points, intrinsic_corners("o.save")
    for file in ("there.txt", "back.txt"):
        for line in open(file):
            here, there = map(place, line.split())
            assert here[0] == face and near(here[1], WEIGHTS, 1e-14), (mesh, line)
            assert near(combination(there[1], [points[v] for v in faces[there[0]]]), start, 1e-14), (mesh, line)


def check_all(mesh, face, corners, *options):
    for check in (check_path, check_distance, check_transfer):
        check(mesh, face, corners, *options)


# Each format, each rotation, both faces; and an edge that is flipped.
for number, (extension, content) in enumerate(FORMATS):
    if extension == "xyz":
        continue
    for rotation in zip(*map(rotations, DELAUNAY)):
        mesh = write(f"{number}.{extension}", content(POINTS, rotation))
        for face, corners in enumerate(rotation):
            check_path(mesh, face, [POINTS[v] for v in corners])
        check_transfer(mesh, 1, [POINTS[v] for v in rotation[1]])
for rotation in zip(*map(rotations, FLIPPED)):
    mesh = write("flipped.off", off(POINTS, rotation))
    for face, corners in enumerate(rotation):
        check_all(mesh, face, [POINTS[v] for v in corners])

# A face that --repair reverses.
for rotation in zip(rotations(DELAUNAY[0]), rotations(DELAUNAY[1][::-1])):
    mesh = write("reversed.off", off(POINTS, rotation))
    for face, corners in enumerate(rotation):
        check_all(mesh, face, [POINTS[v] for v in corners], "--repair")

# The triangles of a polygon have its corners in its order, also where --repair reverses it.
HEXAGON = [[0, 0, 0], [2, 0, 0], [3, 1, 0], [2, 3, 0], [0, 2, 0], [-1, 1, 0]]
for rotation in rotations([*range(6)]):
    polygons = (rotation[:4], rotation[:1] + rotation[3:])
    for faces, options in ((polygons, ()), ((polygons[0], polygons[1][::-1]), ("--repair",))):
        mesh = write("polygons.off", off(HEXAGON, faces))
        run("distance", mesh, "--source", "0", "-o", "o.ply", *options)
        result = ply("o.ply")
        for face, triangle in enumerate(result.faces):
            order = faces[result.face["input_polygon"][face]]
            corners = sorted((list(result.points[v]) for v in triangle), key=[HEXAGON[v] for v in order].index)
            check_path(mesh, face, corners, *options)

# A soup: triangles of the file, of whichever side of the cover.
mesh = write("soup.off", off([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1]],
                             [[1, 0, 2], [0, 1, 3], [1, 4, 0]]))
run("distance", mesh, "--source", "0.25,0.5,0", "-o", "o.ply", "--stats", "o.json")
assert json("o.json").sources == [{"face": 0, "barycentric": [0.25, 0.25, 0.5]}], json("o.json").sources
