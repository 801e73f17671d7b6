# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Intrinsic simplification: fewer vertices, and a bijective map to the input."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from . import _core
from ._arrays import Floats, Integers, count, number, points_on, sparse
from ._meshes import attempt, check_progress, surface
from .errors import InputError
from .triangulation import Progress, SurfacePoints, Triangulation


@dataclass(frozen=True)
class CoarseMesh:
    """The coarse triangulation as an ordinary mesh in space.

    Attributes
    ----------
    V : (k, 3) float array
        Positions, in the unit of the input.
    F : (t, 3) int array
        The corners of its faces.
    input_vertex : (k,) int array
        The vertex of the input; -1 for vertices that were inserted because of loops or several
        edges with the same ends.
    input_points : pair of (k,) int and (k, 3) float arrays
        The point of the input at each vertex: a face and barycentric coordinates. The face is -1
        at vertices without faces.
    quality : dict
        "distance_to_coarse" and "distance_to_fine", how far both surfaces are apart, and numbers of
        "inserted_vertices", "flipped_faces", "degenerate_faces" and "self_intersections".
    """

    V: Floats
    F: Integers
    input_vertex: Integers
    input_points: SurfacePoints
    quality: dict[str, float]

    @property
    def vertices(self) -> Floats:
        """The same as `V`, for other packages."""
        return self.V

    @property
    def faces(self) -> Integers:
        """The same as `F`, for other packages."""
        return self.F


class Simplification:
    """A coarse intrinsic Delaunay triangulation with the map from the input."""

    def __init__(self, on: _core.Surface, core: _core.Simplification) -> None:
        self._surface = on
        self._core = core

    @property
    def vertices(self) -> Integers:
        """The vertices of the input that are left, (k,), in their order."""
        return self._core.vertices()

    @property
    def F(self) -> Integers:
        """The corners of the coarse faces, (t, 3), as indices of `vertices`."""
        return self._core.faces()

    @property
    def lengths(self) -> Floats:
        """The lengths of the coarse edges, (e,), in the unit of V."""
        return self._core.lengths()

    @property
    def face_edges(self) -> Integers:
        """The edge from each corner of a face to the next one, (t, 3)."""
        return self._core.face_edges()

    @property
    def face_lengths(self) -> Floats:
        """The length of the side opposite to each corner, (t, 3)."""
        result: Floats = self.lengths[self.face_edges[:, [1, 2, 0]]]
        return result

    @property
    def removed(self) -> int:
        """The number of vertices that have been removed."""
        return self._core.removed()

    @property
    def greatest_cost(self) -> float:
        """The greatest cost of a removal, a length."""
        return self._core.greatest_cost()

    @property
    def prolongation(self) -> Any:
        """The (n, k) sparse matrix that maps functions at the coarse vertices to the input. Its
        rows are barycentric coordinates: not negative, with sum 1."""
        return sparse(self._core.prolongation())

    def to_coarse(self, points: tuple[ArrayLike, ArrayLike]) -> SurfacePoints:
        """Map points of the input, faces and barycentric coordinates, to the coarse surface."""
        given = points_on(points, self._surface.number_of_faces(), "points")
        return self._core.mapped(True, *given)

    def to_fine(self, points: tuple[ArrayLike, ArrayLike]) -> SurfacePoints:
        """Map points of the coarse surface to the input."""
        return self._core.mapped(False, *points_on(points, len(self.F), "points"))

    def triangulation(self) -> Triangulation:
        """Return the coarse surface, for other functions: `laplacian(s.triangulation())`.
        It has no positions. Loops and several edges with the same ends are ordinary in it."""
        return Triangulation._of_core(None, self._core.triangulation())

    def coarse_mesh(self) -> CoarseMesh:
        """Return the coarse triangulation in space: edges straight, faces flat."""
        if not self._surface.has_positions():
            raise InputError("the surface has no positions; give V instead of lengths")
        return CoarseMesh(*self._core.coarse_mesh())

    def __repr__(self) -> str:
        return f"<Simplification: {len(self.vertices)} vertices, {self.removed} removed>"


def simplify(
    V: Any,
    F: ArrayLike | None = None,
    n: int | None = None,
    *,
    ratio: float | None = None,
    max_cost: float | None = None,
    lengths: ArrayLike | None = None,
    mollify: float | str = "auto",
    progress: Progress | None = None,
) -> Simplification:
    """Remove vertices in the order of their cost, and keep distances as well as possible.

    Parameters
    ----------
    V, F, lengths, mollify
        As of `laplacian()`.
    n : int
        The number of vertices to be left. Vertices without faces stay and do not count.
    ratio : float
        Instead of n: the part of the vertices to be left, more than 0 and at most 1.
    max_cost : float
        Instead of both: the greatest cost of a removal, in the unit of V.
    progress : callable
        Is called with "simplify" and the number of removals.

    Returns
    -------
    Simplification
        It has more vertices than n if no others can be removed.

    Examples
    --------
    >>> import intrinsic
    >>> V, F = intrinsic.shapes.icosphere(3)
    >>> coarse = intrinsic.simplify(V, F, 100)
    >>> coarse
    <Simplification: 100 vertices, 542 removed>
    >>> P = coarse.prolongation
    >>> P.shape, bool(abs(P.sum(axis=1) - 1).max() < 1e-12)
    ((642, 100), True)
    """
    if sum(x is not None for x in (n, ratio, max_cost)) != 1:
        raise InputError("give one of n, ratio and max_cost")
    wanted = None if n is None else count(n, "n", 1)
    part = None if ratio is None else number(ratio, "ratio", 1e-9, 1)
    cost = np.inf if max_cost is None else number(max_cost, "max_cost", 0)
    check_progress(progress)
    on = surface(V, F, lengths, mollify)
    vertices = on.number_of_vertices()
    isolated = on.number_of_isolated_vertices()
    if part is not None:
        wanted = int(np.ceil(part * (vertices - isolated)))
    target = 0 if wanted is None else isolated + min(wanted, vertices - isolated)
    return Simplification(on, attempt(
        mollify, lambda slack: _core.Simplification(on, target, cost, slack, progress)))
