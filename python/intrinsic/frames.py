# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Frames of tangent vectors."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from . import _core
from ._arrays import Floats, Integers
from .errors import InputError
from .triangulation import Triangulation, computed_on


class TangentFrames(NamedTuple):
    """Frames of the tangent vectors at vertices.

    A tangent vector is a complex number. Its angle starts at the first edge of the vertex,
    counterclockwise, and is scaled such that a full turn is 2 pi. At a boundary vertex, the first
    edge is on the boundary, with the surface on its left. At such a vertex, the angle from one
    boundary edge to the other is scaled to pi.

    A tangent vector z is `z.real * x + z.imag * y` in space if the angles of faces have the sum
    2 pi, or pi at a boundary vertex. For other sums it is not. At a corner of a flat square, 1j points along
    the diagonal, and -1 along the second side. `log_map()`, `exp_map()`, `transport()` and
    `connection_laplacian()` use the scaled angles, also at such corners.

    Attributes
    ----------
    neighbors : (n,) int array
        The vertex at the other end of the first edge; -1 for vertices without faces.
    x, y : (n, 3) float arrays
        The directions of 1 and of 1j in space. `x` is the first edge without its part along the
        normal, and `y` is the cross product of the normal with `x`.
    normals : (n, 3) float array
        The sums of the normals of faces at each vertex, weighted by areas, with length 1.
    """

    neighbors: Integers
    x: Floats
    y: Floats
    normals: Floats


def tangent_frames(V: Any, F: ArrayLike | None = None) -> TangentFrames:
    """Return the frames of `log_map()`, `exp_map()`, `transport()` and `connection_laplacian()`.

    Parameters
    ----------
    V, F
        As of `laplacian()`. A Triangulation has the frames of its input.

    Returns
    -------
    TangentFrames
        Directions are zero where positions do not determine them.

    Examples
    --------
    A direction in space as a tangent vector:

    >>> import intrinsic
    >>> V, F = intrinsic.shapes.grid(4, 4)
    >>> x, y = (intrinsic.tangent_frames(V, F)[k][12] for k in (1, 2))
    >>> east = complex(x @ [1, 0, 0], y @ [1, 0, 0])
    >>> intrinsic.exp_map(V, F, 12, 0.25 * east).points[-1].round(12).tolist()
    [0.75, 0.5, 0.0]
    """

    def compute(T: Triangulation) -> TangentFrames:
        if T._surface is None or not T._surface.has_positions():
            raise InputError("the surface has no positions; frames in space need V")
        points, corners = T._surface.positions(), T.input_F
        a, b, c = (points[corners[:, k]] for k in range(3))
        normals = np.zeros_like(points)
        np.add.at(normals, corners.ravel(), np.repeat(np.cross(b - a, c - a), 3, axis=0))
        normals = _unit(normals)
        neighbors = _core.first_neighbors(T._core)
        edges = np.where(neighbors[:, None] < 0, 0.0, points[neighbors] - points)
        x = _unit(edges - (edges * normals).sum(axis=1, keepdims=True) * normals)
        return TangentFrames(neighbors, x, np.cross(normals, x), normals)

    return computed_on(V, F, None, "auto", compute, is_delaunay=False)


def _unit(vectors: Floats) -> Floats:
    """Return vectors with length 1, or 0 if their length is not a positive number."""
    scale = np.abs(vectors).max(axis=1, keepdims=True)
    scaled = np.divide(vectors, scale, out=np.zeros_like(vectors), where=scale > 0)
    length = np.linalg.norm(scaled, axis=1, keepdims=True)
    return np.divide(scaled, length, out=np.zeros_like(vectors), where=length > 0)
