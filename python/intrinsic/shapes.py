# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Small surfaces for examples and tests. All return V (n, 3) and F (m, 3)."""

from __future__ import annotations

import numpy as np

from ._arrays import Floats, Integers, count, number
from .errors import InputError

Shape = tuple[Floats, Integers]

_GREATEST_LEVEL = 13  # of edges with indices of 32 bits
_GREATEST_FOLDS = 2**20  # whose sines have digits


def cube() -> Shape:
    """Return the unit cube with 8 vertices; vertex 4 x + 2 y + z is at (x, y, z)."""
    V = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], float)
    sides = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    return V, np.array([t for a, b, c, d in sides for t in ((a, b, c), (a, c, d))], np.int64)


def icosphere(level: int = 3) -> Shape:
    """Return the unit sphere with 10 * 4**level + 2 vertices, from an icosahedron."""
    g = (1 + 5**0.5) / 2
    V = [[-1, g, 0], [1, g, 0], [-1, -g, 0], [1, -g, 0], [0, -1, g], [0, 1, g], [0, -1, -g],
         [0, 1, -g], [g, 0, -1], [g, 0, 1], [-g, 0, -1], [-g, 0, 1]]
    F = np.array([[0, 11, 5], [0, 5, 1], [0, 1, 7], [0, 7, 10], [0, 10, 11], [1, 5, 9], [5, 11, 4],
                  [11, 10, 2], [10, 7, 6], [7, 1, 8], [3, 9, 4], [3, 4, 2], [3, 2, 6], [3, 6, 8],
                  [3, 8, 9], [4, 9, 5], [2, 4, 11], [6, 2, 10], [8, 6, 7], [9, 8, 1]], np.int64)
    points = np.array(V, float)
    for _ in range(count(level, "level", 0, _GREATEST_LEVEL)):
        sides = np.sort(np.concatenate([F[:, [0, 1]], F[:, [1, 2]], F[:, [2, 0]]]), axis=1)
        ends, index = np.unique(sides, axis=0, return_inverse=True)
        a, b, c = index.reshape(3, -1) + len(points)
        points = np.concatenate([points, points[ends].mean(axis=1)])
        i, j, k = F.T
        F = np.concatenate([np.stack(t, axis=1) for t in
                            ((i, a, c), (a, j, b), (c, b, k), (a, b, c))])
    return points / np.linalg.norm(points, axis=1, keepdims=True), F


def torus(around: int = 40, across: int = 20, radius: float = 2.0, tube: float = 1.0) -> Shape:
    """Return a torus of revolution around the z axis; vertices 0 to `across` - 1 are a
    meridian."""
    n, m = count(around, "around", 3), count(across, "across", 3)
    u, v = np.meshgrid(2 * np.pi * np.arange(n) / n, 2 * np.pi * np.arange(m) / m, indexing="ij")
    thickness = number(tube, "tube", 0, is_open=True)
    if not number(radius, "radius", 0) > thickness:
        raise InputError(f"radius is {radius}; it must be greater than tube, {thickness}")
    ring = radius + thickness * np.cos(v)
    V = np.stack([ring * np.cos(u), ring * np.sin(u), thickness * np.sin(v)], axis=-1).reshape(-1, 3)
    i, j = (a.ravel() for a in np.meshgrid(np.arange(n), np.arange(m), indexing="ij"))
    a, b = i * m + j, (i + 1) % n * m + j
    c, d = (i + 1) % n * m + (j + 1) % m, i * m + (j + 1) % m
    F = np.concatenate([np.stack([a, b, c], axis=1), np.stack([a, c, d], axis=1)])
    return V, F.astype(np.int64)


def grid(rows: int = 10, columns: int = 10) -> Shape:
    """Return the unit square with rows * columns squares of two faces each, in the plane z = 0."""
    n, m = count(rows, "rows", 1), count(columns, "columns", 1)
    y, x = np.meshgrid(np.arange(n + 1) / n, np.arange(m + 1) / m, indexing="ij")
    V = np.stack([x, y, 0 * x], axis=-1).reshape(-1, 3)
    i, j = (a.ravel() for a in np.meshgrid(np.arange(n), np.arange(m), indexing="ij"))
    a = i * (m + 1) + j
    b, c, d = a + 1, a + m + 2, a + m + 1
    F = np.concatenate([np.stack([a, b, c], axis=1), np.stack([a, c, d], axis=1)])
    return V, F.astype(np.int64)


def folded_sphere(level: int = 4, folds: float = 5, depth: float = 0.25) -> Shape:
    """Return a sphere with folds, like a brain: the radius waves between 1 - depth and
    1 + depth."""
    height = number(depth, "depth", 0, 0.99)
    frequency = number(folds, "folds", 0, _GREATEST_FOLDS)
    V, F = icosphere(level)
    wave = np.prod(np.sin(frequency * V + [0.3, 1.1, 2.0]), axis=1)
    return V * (1 + height * np.clip(2 * wave, -1, 1))[:, None], F
