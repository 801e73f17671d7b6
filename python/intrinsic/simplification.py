# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Intrinsic simplification: fewer vertices, and a bijective map to the input."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Mapping, Sequence

import numpy as np
from numpy.typing import ArrayLike

from . import _core
from ._arrays import (Floats, Integers, array_of, count, flag, floats, number, points_on, shortened,
                      sparse)
from ._meshes import TriangleMesh, attempt, check_progress, surface
from .errors import ArrayError, InputError
from .triangulation import Progress, SurfacePoints, Triangulation


@dataclass(frozen=True, eq=False)
class CoarseMesh(TriangleMesh):
    """The coarse triangulation as an ordinary mesh in space.

    Attributes
    ----------
    V : (k, 3) float array
        Positions, in the unit of the input.
    F : (t, 3) int array
        The corners of its faces.
    input_vertex : (k,) int array
        The vertex of the input; -1 for vertices that were inserted, for example because of loops
        or several edges with the same ends.
    input_points : pair of (k,) int and (k, 3) float arrays
        The point of the input at each vertex: a face and barycentric coordinates. The face is -1
        at vertices without faces, and inside disks that close loops.
    quality : dict
        "distance_to_coarse" and "distance_to_fine", how far both surfaces are apart, and numbers of
        "inserted_vertices", "flipped_faces", "degenerate_faces" and "self_intersections".
    """

    V: Floats
    F: Integers
    input_vertex: Integers
    input_points: SurfacePoints
    quality: dict[str, float]


class Simplification:
    """A coarse intrinsic Delaunay triangulation with the map from the input."""

    def __init__(self, on: _core.Surface, core: _core.Simplification) -> None:
        self._surface = on
        self._core = core

    @property
    def vertices(self) -> Integers:
        """The vertices of the input that are left, (k,), in their order; -1 for inserted vertices
        and vertices that disks and cuts have added."""
        return self._core.level_vertices()[-1]

    @property
    def level_vertices(self) -> list[Integers]:
        """The same as `vertices` for each level; `vertices` is the last one."""
        return self._core.level_vertices()

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
    def status(self) -> str:
        """"reached", or "nothing_removable" if more vertices are left than n or ratio wants. With
        max_cost it is always "reached". Vertices inserted for min_angle do not count."""
        return self._core.status()

    @property
    def refinement_status(self) -> str | None:
        """How the refinement for min_angle has ended, as `status` of `Triangulation.refine()`: for
        example "bounds_met" or "insertion_limit". None without min_angle."""
        return self._core.coarse_refinement()

    @property
    def input_refinement_status(self) -> str | None:
        """How the refinement of the input by `refine` has ended, in the same words. None without
        `refine`."""
        return self._core.fine_refinement()

    @property
    def removed(self) -> int:
        """The number of vertices that have been removed."""
        return self._core.removed()

    @property
    def greatest_cost(self) -> float:
        """The greatest cost of a removal, a length."""
        return self._core.greatest_cost()

    @property
    def closed_loops(self) -> int:
        """The number of boundary loops that have been closed by disks."""
        return self._core.closed_loops()

    @property
    def pinched_handles(self) -> int:
        """The number of handles that have been cut."""
        return self._core.pinched_handles()

    @property
    def prolongation(self) -> Any:
        """The (n, k) sparse matrix that maps functions at the coarse vertices to the input. Its
        rows are barycentric coordinates: not negative, with sum 1."""
        return sparse(self._core.prolongation())

    @property
    def prolongations(self) -> list[Any]:
        """The sparse matrices from each level to the level before. The first one leads to the
        input."""
        return [sparse(arrays) for arrays in self._core.prolongations()]

    def to_coarse(self, points: Any, barycentric: ArrayLike | None = None) -> SurfacePoints:
        """Map points of the input to the coarse surface. Points are faces (k,) and barycentric
        coordinates (k, 3), or the pair of both arrays."""
        given = points_on(points, self._surface.number_of_faces(), "points", barycentric)
        return self._core.mapped(True, *given)

    def to_fine(self, points: Any, barycentric: ArrayLike | None = None) -> SurfacePoints:
        """Map points of the coarse surface to the input, given in the same way. The face is -1 for
        a point in a disk that closes a loop."""
        return self._core.mapped(False, *points_on(points, len(self.F), "points", barycentric))

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


_CHANGES = "area_change", "boundary_change"
_PARTS = "curvature", "area", *_CHANGES


def _checked_weights(weights: Any, functions: Any) -> dict[str, float]:
    """Return the positive weights of parts of the cost and of functions."""
    if not isinstance(weights, Mapping) or not all(isinstance(name, str) for name in weights):
        raise ArrayError(f"weights is {shortened(weights)}; it must be a dict of names and numbers")
    given = {name: number(weight, f"weights[{name!r}]", 0) for name, weight in weights.items()}
    for name in given:
        if name not in _PARTS and name not in functions:
            raise InputError(f"weights has {name!r}, which is not in functions; parts of the cost are "
                             + ", ".join(_PARTS))
    result = {name: weight for name, weight in given.items() if weight > 0}
    if all(name in _CHANGES for name in result):
        raise InputError("weights that are not given are zero, and changes of area alone are not a "
                         "cost; give another weight that is positive, as curvature: 1")
    return result


def _checked_functions(functions: Any, weights: Any, vertices: int) -> dict[str, Floats]:
    """Return the functions with weights, each with columns."""
    if not isinstance(functions, Mapping) or not all(isinstance(name, str) for name in functions):
        raise ArrayError(f"functions is {shortened(functions)}; it must be a dict of names and arrays")
    result = {}
    for name, values in functions.items():
        if name in _PARTS:
            raise InputError(f"functions has {name!r}, the name of a part of the cost")
        if weights is None or name not in weights:
            raise InputError(f"functions has {name!r}, which has no weight in weights")
        array = array_of(values, f"functions[{name!r}]")
        shape = (vertices, None) if array.ndim == 2 else (vertices,)
        result[name] = floats(array, shape, f"functions[{name!r}]").reshape(vertices, -1)
        if result[name].shape[1] == 0:
            raise ArrayError(f"functions[{name!r}] has no columns")
    return result


def _checked_sizes(n: Any) -> list[int]:
    """Return the numbers of vertices of the levels."""
    is_text = isinstance(n, (str, bytes))
    is_array = isinstance(n, np.ndarray) and n.ndim > 0
    if not is_array and (is_text or not isinstance(n, Sequence)):
        return [count(n, "n", 1)]
    sizes = [count(size, f"n[{i}]", 1) for i, size in enumerate(n)]
    if len(sizes) == 0:
        raise ArrayError("n is empty; give a number of vertices for each level")
    for i, (a, b) in enumerate(zip(sizes, sizes[1:])):
        if b >= a:
            raise InputError(f"n[{i + 1}] is {b}; it must be less than n[{i}], which is {a}")
    return sizes


def simplify(
    V: Any,
    F: ArrayLike | None = None,
    n: int | Sequence[int] | None = None,
    *,
    ratio: float | None = None,
    max_cost: float | None = None,
    weights: Mapping[str, float] | None = None,
    functions: Mapping[str, ArrayLike] | None = None,
    refine: float = 0.0,
    min_angle: float = 0.0,
    max_insertions: int | None = None,
    close_loops: float = 0.0,
    pinch_handles: float = 0.0,
    exact: bool = False,
    lengths: ArrayLike | None = None,
    mollify: float | str = "auto",
    progress: Progress | None = None,
) -> Simplification:
    """Remove vertices in the order of their cost, and keep distances as well as possible.

    Parameters
    ----------
    V, F, lengths, mollify
        As of `laplacian()`, but V is no Triangulation.
    n : int or sequence of ints
        The number of vertices to be left. Vertices without faces stay and do not count. A
        decreasing sequence makes a level for each number.
    ratio : float
        Instead of n: the part of the vertices to be left, more than 0 and at most 1.
    max_cost : float
        Instead of both: the greatest cost of a removal, in the unit of V.
    weights : dict of str to float
        The weights of "curvature", "area", "area_change", "boundary_change" and functions in the
        cost. Weights that are not given are zero. By default, the first four have the weights 1, 2,
        6 and 12.
    functions : dict of str to (n,) or (n, c) float arrays
        Functions at the vertices that have weights. More vertices stay where their gradients
        change.
    refine : float
        If positive, vertices are inserted first, so that angles have this many degrees. At most 30.
        The result has the `input_refinement_status`.
    min_angle : float
        If positive, vertices are inserted into the coarse triangulation, so that angles have this
        many degrees. At most 60. The result has the `refinement_status`.
    max_insertions : int
        The greatest number of insertions of each refinement. The default grows with the faces. At
        this limit, or at small angles of the surface, angles can remain below a bound.
    close_loops : float
        First close boundary loops up to this length by disks, in the unit of V.
    pinch_handles : float
        First cut handles along closed curves of edges up to this length, and close both sides by
        disks.
    exact : bool
        Decide exactly which edges are Delaunay before vertices are removed.
    progress : callable
        Is called with "simplify" or "refine" and the number of steps.

    Returns
    -------
    Simplification
        It has more vertices than n if no others can be removed, or if vertices are inserted. Its
        `status` distinguishes both.

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

    Three levels, for a multigrid solver:

    >>> levels = intrinsic.simplify(V, F, [160, 40, 10])
    >>> [P.shape for P in levels.prolongations]
    [(642, 160), (160, 40), (40, 10)]
    """
    if sum(x is not None for x in (n, ratio, max_cost)) != 1:
        raise InputError("give one of n, ratio and max_cost")
    sizes = [0] if n is None else _checked_sizes(n)
    part = None if ratio is None else number(ratio, "ratio", 1e-9, 1)
    cost = np.inf if max_cost is None else number(max_cost, "max_cost", 0)
    angles = number(refine, "refine", 0, 30), number(min_angle, "min_angle", 0, 60)
    limit = None if max_insertions is None else count(max_insertions, "max_insertions", 0)
    bounds = number(close_loops, "close_loops", 0), number(pinch_handles, "pinch_handles", 0)
    is_exact = flag(exact, "exact")
    check_progress(progress)
    on = surface(V, F, lengths, mollify)
    vertices = on.number_of_vertices()
    isolated = on.number_of_isolated_vertices()
    values = {} if functions is None else _checked_functions(functions, weights, vertices)
    given = None if weights is None else _checked_weights(weights, values)
    if part is not None:
        sizes = [int(np.ceil(part * (vertices - isolated)))]
    targets = [0 if max_cost is not None else isolated + size for size in sizes]
    used = {} if given is None else {name: f for name, f in values.items() if name in given}
    return Simplification(on, attempt(mollify, lambda slack: _core.Simplification(
        on, targets, cost, given, used, *angles, limit, *bounds, is_exact, slack, progress)))
