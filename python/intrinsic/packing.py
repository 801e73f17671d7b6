# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Circles that touch if an edge of the mesh joins their vertices."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from . import _core
from ._arrays import Floats, integers
from ._meshes import arrays, surface, triangles


@dataclass(frozen=True, eq=False)
class CirclePacking:
    """Circles at the vertices of a sphere or a disk.

    Attributes
    ----------
    centers : (n, 2) or (n, 3) float array
        The centers, in the unit disk for a disk and on the unit sphere for a sphere.
    radii : (n,) float array
        The radii; on the sphere, the angles between centers and circles.
    is_disk : bool
        Whether the circles are in the unit disk.
    max_tangency_error : float
        The greatest distance between the circles of an edge.
    """

    centers: Floats
    radii: Floats
    is_disk: bool
    max_tangency_error: float


def pack_circles(V: Any, F: ArrayLike | None = None) -> CirclePacking:
    """Pack circles that touch if an edge joins their vertices. Only the connectivity counts.

    Circles of a sphere are on the unit sphere. Circles of a disk are in the unit disk, and circles
    of its boundary touch the unit circle.

    Parameters
    ----------
    V : (n, 3) array of floats, or a mesh object, or None
        Positions; only their number counts. None if there are none.
    F : (m, 3) array of integers
        The corners of each face, from 0.

    Returns
    -------
    CirclePacking

    Raises
    ------
    InputError
        If the surface is neither a sphere nor a disk, or if several edges have the same ends.
    NumericalError
        If the circles that are found do not touch.

    Examples
    --------
    >>> import intrinsic
    >>> V, F = intrinsic.shapes.icosphere(0)
    >>> packing = intrinsic.pack_circles(V, F)
    >>> bool(abs(packing.radii - packing.radii[0]).max() < 1e-9), packing.is_disk
    (True, False)
    """
    if V is None:
        faces = integers(triangles(F), (None, 3), "F", None, "vertices")
        on = surface(None, faces, np.ones(faces.shape))
    else:
        points, faces = arrays(V, F)
        on = surface(_any_positions(len(points)), faces)
    return CirclePacking(**_core.pack_circles(on))


def _any_positions(n: int) -> Floats:
    """Return n different points on a circle, such that all lengths of edges are valid."""
    angle = np.arange(n) * (np.pi * (3 - np.sqrt(5)))
    return np.column_stack([np.cos(angle), np.sin(angle), np.zeros(n)])
