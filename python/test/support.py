# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Meshes for tests, and the program to compare results with."""

import json
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import numpy as np

import intrinsic

sys.path.append(str(Path(__file__).parents[2] / "scripts"))
import read_results  # noqa: E402

PROGRAM = os.environ.get("INTRINSIC_PROGRAM")
needs_program = unittest.skipUnless(PROGRAM and os.access(PROGRAM, os.X_OK), "needs the program")


def turned(V, F, seed=1):
    """Return the mesh with each face starting at a random corner, and vertices and faces shuffled:
    nothing may depend on the order in which a mesh is usually given."""
    random = np.random.default_rng(seed)
    order = random.permutation(len(V))
    place = np.argsort(order)
    start = random.integers(0, 3, len(F))
    corners = (start[:, None] + np.arange(3)) % 3
    faces = np.take_along_axis(place[F], corners, axis=1)
    return V[order], faces[random.permutation(len(F))]


def noisy(V, size, seed=2):
    return V + size * np.random.default_rng(seed).standard_normal(V.shape)


def two_handles():
    """A cube of 5 x 3 x 1 smaller ones without two of them: genus two."""
    cells = {(x, y, 0) for x in range(5) for y in range(3)} - {(1, 1, 0), (3, 1, 0)}
    number, faces = {}, []
    sides = {(1, 0, 0): ((1, 0, 0), (1, 1, 0), (1, 1, 1), (1, 0, 1)),
             (-1, 0, 0): ((0, 0, 0), (0, 0, 1), (0, 1, 1), (0, 1, 0)),
             (0, 1, 0): ((0, 1, 0), (0, 1, 1), (1, 1, 1), (1, 1, 0)),
             (0, -1, 0): ((0, 0, 0), (1, 0, 0), (1, 0, 1), (0, 0, 1)),
             (0, 0, 1): ((0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)),
             (0, 0, -1): ((0, 0, 0), (0, 1, 0), (1, 1, 0), (1, 0, 0))}
    for cell in sorted(cells):
        for step, corners in sides.items():
            if tuple(np.add(cell, step)) not in cells:
                a, b, c, d = (number.setdefault(tuple(np.add(cell, k)), len(number))
                              for k in corners)
                faces += [(a, b, c), (a, c, d)]
    return np.array(list(number), float), np.array(faces)


def bumpy_grid(n=8):
    V, F = intrinsic.shapes.grid(n, n)
    V = V.copy()
    V[:, 2] = 0.2 * np.sin(5 * V[:, 0]) * np.cos(4 * V[:, 1])
    return V, F


def lengths_of(V, F):
    """Return the lengths of the sides opposite to the corners, rounded as the compiled part does."""
    d = V[F[:, [1, 2, 0]]] - V[F[:, [2, 0, 1]]]
    return np.sqrt(d[..., 0] * d[..., 0] + d[..., 1] * d[..., 1] + d[..., 2] * d[..., 2])


def meshes():
    """Ten surfaces by name: closed or with boundary, of several genera, some of them bad."""
    shapes = intrinsic.shapes
    sphere, torus = shapes.icosphere(3), shapes.torus(30, 12)
    stretched = shapes.icosphere(3)[0] * [8, 1, 0.5]
    return {
        "cube": shapes.cube(),
        "sphere": sphere,
        "folded_sphere": shapes.folded_sphere(3),
        "ellipsoid": turned(stretched, sphere[1]),
        "noisy_sphere": turned(noisy(sphere[0], 0.03), sphere[1]),
        "torus": torus,
        "flat_torus": turned(torus[0] * [1, 1, 0.2], torus[1]),
        "bumpy_grid": bumpy_grid(),
        "strip": turned(bumpy_grid()[0] * [6, 1, 1], bumpy_grid()[1]),
        "two_handles": two_handles(),
    }


def stretched(V, F, number):
    """Return so many copies of a mesh, each scaled along the axes, turned and shuffled."""
    random = np.random.default_rng(5)
    axes = [np.linalg.qr(random.standard_normal((3, 3)))[0] for _ in range(number)]
    return [turned(V * random.uniform(0.5, 2, 3) @ a, F, seed) for seed, a in enumerate(axes)]


def write_mesh(path, V, F):
    """Write a mesh as .off, or as .ply if the path ends so."""
    if path.suffix == ".ply":
        names = "\n".join(f"property double {name}" for name in "xyz")
        lines = [f"ply\nformat ascii 1.0\nelement vertex {len(V)}\n{names}\nelement face {len(F)}\n"
                 "property list uchar int vertex_indices\nend_header"]
    else:
        lines = [f"OFF\n{len(V)} {len(F)} 0"]
    lines += [" ".join(map(repr, map(float, p))) for p in V]
    lines += [f"{len(f)} " + " ".join(map(str, f)) for f in F]
    path.write_text("\n".join(lines) + "\n")


def printed_by_program(V, F, command, *options):
    """Return what a command prints about a mesh."""
    with tempfile.TemporaryDirectory() as folder:
        mesh = Path(folder, "mesh.off")
        write_mesh(mesh, V, F)
        return subprocess.run([PROGRAM, command, str(mesh), *options], capture_output=True,
                              text=True, check=True).stdout


def run_info(V, F):
    """Return what the program says about a mesh."""
    return json.loads(printed_by_program(V, F, "info", "--json"))


def run_program(command, V, F, *options, output=None, mesh="mesh.off"):
    """Run the program on a mesh. Return its statistics, and what it has written."""
    with tempfile.TemporaryDirectory() as folder:
        folder = Path(folder)
        mesh, stats = folder / mesh, folder / "stats.json"
        write_mesh(mesh, V, F)
        call = [PROGRAM, command, str(mesh), "--stats", str(stats), "--quiet"]
        options = [o.replace("FOLDER", str(folder)) for o in options]
        if output is not None:
            options += ["-o", str(folder / output)]
        done = subprocess.run(call + options, capture_output=True, text=True, check=False)
        if done.returncode != 0:
            raise RuntimeError(f"{command}: {done.stderr}")
        files = {f.name: read_results.read(str(f)) for f in sorted(folder.iterdir())
                 if f.suffix in (".ply", ".obj", ".off", ".mtx") and f != mesh}
        texts = {f.name: f.read_text() for f in folder.iterdir() if f.suffix == ".save"}
        return json.loads(stats.read_text()), files, texts
