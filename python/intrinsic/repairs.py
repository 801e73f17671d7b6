# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""The defects of a mesh, and its repair."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from . import _core
from ._arrays import Floats, Integers, number
from ._meshes import TriangleMesh, arrays


@dataclass(frozen=True, eq=False)
class Info:
    """Numbers about a mesh, and its defects.

    Attributes
    ----------
    vertices, edges, faces, components, boundary_loops, euler_characteristic : int
        Numbers. Components are connected by edges. The last number leaves out isolated vertices,
        and counts a vertex once for each of its fans of faces.
    min_angle_degrees, min_edge_length, max_edge_length : float
        Extremes; lengths in the unit of V.
    is_valid : bool
        Whether the functions of this package accept the mesh.
    defects : list of dict
        For each kind: "kind", "is_fatal", "count" and a "message" that names the first element.
    coincident_points, close_points : int
        Vertices on the boundary at the position of another vertex, and nearly at it.
    """

    vertices: int
    edges: int
    faces: int
    euler_characteristic: int
    boundary_loops: int
    components: int
    min_angle_degrees: float
    min_edge_length: float
    max_edge_length: float
    is_valid: bool
    defects: list[dict[str, Any]]
    coincident_points: int
    close_points: int


def info(V: Any, F: ArrayLike | None = None) -> Info:
    """Return the size, the topology and the defects of a mesh.

    Parameters
    ----------
    V : (n, 3) array of floats, or a mesh object
        Positions.
    F : (m, 3) array of integers
        The corners of each face, from 0.

    Returns
    -------
    Info

    Examples
    --------
    >>> import intrinsic
    >>> report = intrinsic.info([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [0, -1, 0]],
    ...                         [[0, 1, 2], [0, 1, 3], [0, 1, 4]])
    >>> report.is_valid
    False
    >>> report.defects[0]["message"]
    'non-manifold edge: 1, first between vertices 0 and 1 (face 0)'
    """
    return Info(**_core.diagnose(*arrays(V, F)))


@dataclass(frozen=True, eq=False)
class Repair(TriangleMesh):
    """A repaired mesh.

    Attributes
    ----------
    V : (k, 3) float array
        Positions, in the unit of the input. Indices may have changed.
    F : (t, 3) int array
        The corners of the faces.
    report : dict
        What was done, and how often.
    """

    V: Floats
    F: Integers
    report: dict[str, int]


def repair(V: Any, F: ArrayLike | None = None, *, weld: float = 0.0) -> Repair:
    """Make a surface of triangles.

    Merges points, removes broken and duplicate faces and isolated points, orients faces, and
    duplicates points at which the surface is not manifold. At most half of the faces of a component
    are reversed; if it is half of a closed component, its normals point outward.

    Parameters
    ----------
    V, F
        As of `info()`.
    weld : float
        Points are merged that are at most so far apart, in the unit of V.

    Returns
    -------
    Repair

    Examples
    --------
    Two triangles whose orientations differ:

    >>> import intrinsic
    >>> fixed = intrinsic.repair([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]],
    ...                          [[0, 1, 2], [1, 2, 3]])
    >>> fixed.report
    {'faces reversed': 1}
    """
    points, faces = arrays(V, F)
    V2, F2, report = _core.repair(points, faces, number(weld, "weld", 0))
    return Repair(V2, np.asarray(F2).reshape(-1, 3), dict(report))
