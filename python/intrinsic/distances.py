# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Geodesic distances, shortest paths, and the exponential and logarithmic map."""

from __future__ import annotations

import warnings
from dataclasses import dataclass
from typing import Any, Callable, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._arrays import (Complexes, Floats, Integers, array_of, choice, complexes, count, flag,
                      floats_or_infinity, integers, number, points_on, shortened)
from ._arrays import vertices as vertices_of
from ._meshes import Result, check_progress, level_of_caller, surface, triangles
from .errors import AccuracyWarning, ArrayError, InputError
from .operators import computed_on_soup
from .simplification import simplify
from .triangulation import Progress, SurfacePoints, Triangulation, computed_on

_GREATEST_SILENT_ERROR = 0.1  # relative, of a tenth of the distances
_LEAST_TIME_STEP_FACTOR, _GREATEST_TIME_STEP_FACTOR = 1e-300, 1.6e13  # beyond, rounding decides
_NO_VERTICES = np.zeros(0, np.int64)
_NO_POINTS = (np.zeros(0, np.int64), np.zeros((0, 3)))
_NO_CURVE = (*_NO_POINTS, np.zeros(1, np.int64))

Sources = tuple[Integers, Integers, Floats]


def _sources(sources: Any, T: Triangulation) -> Sources:
    """Return vertices, and faces with coordinates: sources are the one or the other."""
    if isinstance(sources, tuple):
        if len(sources) != 2 or np.ndim(sources[1]) == 0:
            raise ArrayError(f"sources is {shortened(sources)}; a tuple is a pair of faces and "
                             "barycentric coordinates, and vertices are a list or an array")
        faces, coordinates = points_on(sources, T._core.number_of_faces(True), "sources")
        result = _NO_VERTICES, faces, coordinates
    else:
        result = vertices_of(sources, T._core.number_of_input_vertices(), "sources"), *_NO_POINTS
    if len(result[0]) + len(result[1]) == 0:
        raise InputError("there are no sources; give at least one")
    return result


def _sources_and_curve(
    sources: Any, curve: Any, T: Triangulation
) -> tuple[Integers, Integers, Floats, Integers, Floats, Integers]:
    """Return the arrays of `_sources()` and of `_curve()`. One of both is enough."""
    if sources is None and curve is None:
        raise ArrayError("sources are missing; give vertices, or points as faces and coordinates, "
                         "or a curve")
    points = (_NO_VERTICES, *_NO_POINTS) if sources is None else _sources(sources, T)
    return (*points, *(_NO_CURVE if curve is None else _curve(curve, T)))


def _method(method: str) -> str:
    return choice(method, "method", ("auto", "exact", "heat"))


class Distances(NamedTuple):
    """Distances and how they were found.

    Attributes
    ----------
    values : (n,) float array
        The distance of each vertex, in the unit of V; infinite where no source can reach it.
    method : str
        "exact" or "heat".
    relative_error : dict or None
        Of heat, an estimate: "mean", "ninety_percent" (nine of ten vertices have no greater one)
        and "greatest", from exact distances of "vertices" vertices near the sources.
    """

    values: Floats
    method: str
    relative_error: dict[str, float] | None


def distance(
    V: Any,
    F: ArrayLike | None = None,
    sources: Any = None,
    method: str = "auto",
    *,
    curve: Any = None,
    time_step_factor: float | None = None,
    lengths: ArrayLike | None = None,
    mollify: float | str = "auto",
    full: bool = False,
    progress: Progress | None = None,
) -> Any:
    """Return the geodesic distance of each vertex from the nearest source.

    Parameters
    ----------
    V, F, lengths, mollify, progress
        As of `laplacian()`.
    sources : int, (k,) integers, or pair of (k,) integers and (k, 3) floats
        A vertex, vertices, or points as faces and barycentric coordinates.
    method : "auto", "exact" or "heat"
        "exact" gives the lengths of shortest paths, up to rounding. "heat" is faster on large
        meshes and has errors of some percent. If they are estimated to be large, it gives an
        `AccuracyWarning`. "auto" is exact up to 65,000 vertices with one source, or more with
        several. At this limit it takes about two seconds.
    curve : (k,) integers, pair of (k,) integers and (k, 3) floats, Path, or a list of these
        One or more polylines, as of `signed_distance()`. All their points are sources, too.
    time_step_factor : float
        The time for which heat flows, in squared mean edge lengths. "auto" is then "heat"; "exact"
        has no such time.
    full : bool
        Whether the method and an estimate of the error are returned, too.

    Returns
    -------
    (n,) float array, or Distances if `full`
        In the unit of V; infinite where no source can reach a vertex. On a Triangulation, vertices
        of its input have distances, and inserted ones do not.

    Examples
    --------
    Around a corner of a cube:

    >>> import intrinsic
    >>> V, F = intrinsic.shapes.cube()
    >>> d = intrinsic.distance(V, F, 0)
    >>> round(float(d.max() ** 2), 12)  # to the opposite corner of the unit cube
    5.0
    """
    return _measured(
        lambda T, kind, factor: _core.distances(
            T._core, _sources_and_curve(sources, curve, T), kind, factor, progress),
        (V, F, lengths, mollify), method, time_step_factor, full, progress)


def soup_distance(
    V: Any, F: ArrayLike | None = None, sources: Any = None, *, neighbors: int = 30,
    time_step_factor: float | None = None, mollify: float | str = "auto",
    progress: Progress | None = None,
) -> Floats:
    """Return distances by heat on triangles that do not form a surface, or on points alone.

    Parameters
    ----------
    V, F, neighbors, mollify, progress
        As of `soup_operators()`.
    sources : int or (k,) integers
        Vertices.
    time_step_factor : float
        The time for which heat flows, in squared mean edge lengths.

    Returns
    -------
    (n,) float array
        In the unit of V; infinite where no source can reach a vertex.

    Examples
    --------
    Points of a circle, without faces:

    >>> import intrinsic, numpy as np
    >>> r, a = np.meshgrid(np.linspace(0, 1, 20)[1:], np.linspace(0, 2 * np.pi, 40)[:-1])
    >>> V = np.stack([r * np.cos(a), r * np.sin(a), 0 * a], axis=-1).reshape(-1, 3)
    >>> d = intrinsic.soup_distance(V, sources=0)
    >>> bool(abs(d - np.linalg.norm(V - V[0], axis=1)).mean() < 0.05)
    True
    """
    factor = _time_step_factor(time_step_factor)

    def distances(size: int, soup: _core.Soup) -> Floats:
        given = vertices_of(sources, size, "sources")
        if len(given) == 0:
            raise InputError("there are no sources; give at least one")
        return soup.distances(given, factor)

    return computed_on_soup(V, F, neighbors, mollify, progress, distances)


def _measured(
    values_on: Callable[..., Any], mesh: tuple[Any, Any, Any, Any], method: str,
    time_step_factor: float | None, full: bool, progress: Progress | None,
) -> Any:
    """Return distances, described if `full`. `mesh` has the first arguments of `computed_on()`."""
    kind = _method(method)
    factor = _time_step_factor(time_step_factor, kind)
    is_full = flag(full, "full")
    if factor is not None and kind == "auto":
        kind = "heat"

    def compute(T: Triangulation) -> Distances:
        values, about = values_on(T, kind, factor)
        return Distances(values[: T._core.number_of_input_vertices()], about["method"],
                         about.get("relative_error"))

    result = computed_on(*mesh, compute, check_progress(progress))
    error = (result.relative_error or {}).get("ninety_percent", 0)
    if not error <= _GREATEST_SILENT_ERROR:
        warnings.warn(
            f"a tenth of the distances by heat are wrong by {100 * error:.2g} % or more; exact "
            "distances have none of these errors", AccuracyWarning, stacklevel=level_of_caller())
    return result if is_full else result.values


def _time_step_factor(factor: float | None, method: str = "heat") -> float | None:
    """Return the checked factor, or None if it is not given."""
    if factor is None:
        return None
    if method == "exact":
        raise InputError("time_step_factor is for method='heat'; leave it out")
    return _given_factor(factor)


def _given_factor(factor: float) -> float:
    return number(factor, "time_step_factor", _LEAST_TIME_STEP_FACTOR, _GREATEST_TIME_STEP_FACTOR)


class DistanceSolver:
    """Distances from many sets of sources on one surface, after one factorization.

    `distance()` gives the same distances by heat with the same time step. Here their errors are not
    estimated, so there is no `AccuracyWarning`.

    Parameters
    ----------
    V, F, lengths, mollify, progress
        As of `laplacian()`.
    method : "heat" or "exact"
        "heat" factorizes two matrices now, and solves with them for each set of sources. "exact"
        searches for each set from the beginning.
    time_step_factor : float
        With "heat": the time for which heat flows, in squared mean edge lengths; 1 if not given.

    Examples
    --------
    >>> import intrinsic
    >>> V, F = intrinsic.shapes.icosphere(3)
    >>> solver = intrinsic.DistanceSolver(V, F)
    >>> d = solver.distance(0)
    >>> bool(abs(d.max() - 3.1416) < 0.1)
    True
    """

    def __init__(
        self,
        V: Any,
        F: ArrayLike | None = None,
        method: str = "heat",
        *,
        time_step_factor: float | None = None,
        lengths: ArrayLike | None = None,
        mollify: float | str = "auto",
        progress: Progress | None = None,
    ) -> None:
        choice(method, "method", ("heat", "exact"))
        given_factor = _time_step_factor(time_step_factor, method)
        factor = 1.0 if given_factor is None else given_factor

        def prepared(T: Triangulation) -> tuple[Triangulation, _core.Heat | None]:
            on = T.copy() if T is V else T  # it must not change
            return on, _core.Heat(on._core, factor) if method == "heat" else None

        self._on, self._heat = computed_on(V, F, lengths, mollify, prepared,
                                           check_progress(progress))

    def distance(self, sources: Any = None, *, curve: Any = None) -> Floats:
        """Return the distance (n,) of each vertex from the nearest source, as `distance()`."""
        T = self._on
        with T._lock:
            given = _sources_and_curve(sources, curve, T)
            n = T._core.number_of_input_vertices()
            if self._heat is not None:
                return self._heat.distances(T._core, given)[:n]
            return _core.distances(T._core, given, "exact", None, None)[0][:n]

    def from_each(self, sources: Any, *, parallel: bool = False) -> Floats:
        """Return the distances (k, n) of each vertex from each of k sources.

        Parameters
        ----------
        sources : (k,) integers, or pair of (k,) integers and (k, 3) floats
            Vertices, or points as faces and barycentric coordinates. With heat, all sources
            together take less time than one after the other.
        parallel : bool
            Whether several threads are used. The result is bitwise the same.

        Returns
        -------
        (k, n) float array
            In the unit of V; infinite where a source cannot reach a vertex.
        """
        T = self._on
        is_parallel = flag(parallel, "parallel")
        with T._lock:
            given = _sources(sources, T)
            if self._heat is None:
                return _core.distances_from_each(T._core, *given, is_parallel, None)
            n = T._core.number_of_input_vertices()
            return self._heat.distances_from_each(T._core, *given, is_parallel)[:, :n]


def all_pairs(
    V: Any, F: ArrayLike | None = None, *, coarse: int | None = None,
    lengths: ArrayLike | None = None, mollify: float | str = "auto",
    parallel: bool = False, progress: Progress | None = None,
) -> Floats:
    """Return the geodesic distances between all pairs of vertices.

    Parameters
    ----------
    V, F, lengths, mollify
        As of `laplacian()`.
    coarse : int
        Distances are computed between so many vertices of a simplified surface, and prolonged to
        all pairs. Distances that are short compared with coarse edges are too large. All are exact
        if it is not given.
    parallel : bool
        Whether several threads are used. The result is the same, to the bit.
    progress : callable
        Is called with "all_pairs" and the number of rows, after every 64 rows.

    Returns
    -------
    (n, n) float array
        In the unit of V; infinite where there is no path. Symmetric up to rounding.

    Examples
    --------
    >>> import intrinsic
    >>> V, F = intrinsic.shapes.icosphere(2)
    >>> D = intrinsic.all_pairs(V, F)
    >>> D.shape, bool(abs(D - D.T).max() < 1e-12)
    ((162, 162), True)
    >>> approximate = intrinsic.all_pairs(V, F, coarse=80)
    >>> far = D > 1
    >>> bool((abs(approximate - D)[far] / D[far]).mean() < 0.02)
    True
    """
    check_progress(progress)
    is_parallel = flag(parallel, "parallel")
    if coarse is not None:
        if isinstance(V, Triangulation):
            raise ArrayError("coarse is for a mesh, not for a Triangulation")
        small = simplify(V, F, count(coarse, "coarse", 1), lengths=lengths, mollify=mollify)
        P = small.prolongation
        among = _distances_between_all(small.triangulation(), is_parallel, progress)
        result: Floats = P @ (P @ among).T
        return result
    return _on_input(V, F, lengths, mollify,
                     lambda T: _distances_between_all(T, is_parallel, progress))


def _distances_between_all(
    T: Triangulation, is_parallel: bool, progress: Progress | None
) -> Floats:
    n = T._core.number_of_input_vertices()
    result = np.empty((n, n))
    for first in range(0, n, 64):
        rows = np.arange(first, min(first + 64, n))
        with T._lock:
            result[rows] = _core.distances_from_each(T._core, rows, *_NO_POINTS, is_parallel, None)
        if progress is not None:
            progress("all_pairs", first + len(rows))
    return result


@dataclass(frozen=True, eq=False, repr=False)
class Path:
    """A line on a surface.

    Attributes
    ----------
    length : float
        In the unit of V; infinite if there is no path.
    faces : (p,) int array
        A face of each point. The points are the ends, the crossings and the passed vertices.
    barycentric : (p, 3) float array
        The barycentric coordinates of the points, in the order of the corners of the face.
    points : (p, 3) float array or None
        Their positions; None if the surface has none.
    is_complete : bool
        Whether the line has reached its end: one that is followed may meet the boundary before.
    """

    length: float
    faces: Integers
    barycentric: Floats
    points: Floats | None
    is_complete: bool = True

    def __repr__(self) -> str:
        return f"<Path: length {self.length:g}, {len(self.faces)} points>"


def _path(T: Triangulation, length: float, faces: Integers, coordinates: Floats,
          is_complete: bool = True) -> Path:
    has_points = T._surface is not None and T._surface.has_positions()
    points = None
    if has_points:
        points = T.positions((faces, coordinates)) if len(faces) > 0 else np.empty((0, 3))
    return Path(length, faces, coordinates, points, is_complete)


def _on_input(V: Any, F: ArrayLike | None, lengths: ArrayLike | None, mollify: float | str,
              compute: Callable[[Triangulation], Result]) -> Result:
    """Return the result of `compute(T)`, for a triangulation that need not be Delaunay."""
    return computed_on(V, F, lengths, mollify, compute, is_delaunay=False)


def vertex_point(F: ArrayLike, vertex: int) -> SurfacePoints:
    """Return a vertex as a point of a surface: a face (1,) and coordinates (1, 3)."""
    faces = integers(triangles(F), (None, 3), "F", None, "vertices")
    found = np.argwhere(faces == count(vertex, "vertex", 0))
    if len(found) == 0:
        raise InputError(f"vertex {vertex} has no face")
    return _corner(*found[0])


def _corner(face: int, corner: int) -> SurfacePoints:
    """Return a corner of a face as a point."""
    return np.array([face], np.int64), np.eye(3)[[corner]]


def _one_point(point: Any, T: Triangulation, name: str) -> SurfacePoints:
    if isinstance(point, tuple):
        faces, coordinates = points_on(point, T._core.number_of_faces(True), name)
        if len(faces) != 1:
            raise ArrayError(f"{name} has {len(faces)} points; it must be one")
        return faces, coordinates
    vertex = int(vertices_of(point, T._core.number_of_input_vertices(), name, 1)[0])
    place = T._core.place_of_vertex(vertex)
    if place is None:
        raise InputError(f"vertex {vertex} has no face")
    return _corner(*place)


def path(
    V: Any, F: ArrayLike | None = None, source: Any = None, target: Any = None, *,
    lengths: ArrayLike | None = None, mollify: float | str = "auto",
) -> Path:
    """Return the shortest path between two points, exact up to rounding.

    Parameters
    ----------
    V, F, lengths, mollify
        As of `laplacian()`.
    source, target : int, or pair of an integer and 3 floats
        A vertex, or a point as a face and its barycentric coordinates.

    Returns
    -------
    Path
        Its length is infinite, and it has no points, if there is none.

    Examples
    --------
    >>> import intrinsic
    >>> V, F = intrinsic.shapes.cube()
    >>> p = intrinsic.path(V, F, 0, 7)
    >>> round(p.length ** 2, 12), p.points[0].tolist(), p.points[-1].tolist()
    (5.0, [0.0, 0.0, 0.0], [1.0, 1.0, 1.0])
    """

    def compute(T: Triangulation) -> Path:
        ends = [_one_point(p, T, name) for p, name in ((source, "source"), (target, "target"))]
        return _path(T, *_core.shortest_path(T._core, np.concatenate([e[0] for e in ends]),
                                             np.concatenate([e[1] for e in ends])))

    return _on_input(V, F, lengths, mollify, compute)


def geodesic(
    V: Any, F: ArrayLike | None = None, vertices: Any = None, *, loop: bool = False,
    lengths: ArrayLike | None = None, mollify: float | str = "auto",
) -> Path:
    """Return the geodesic that a path along edges becomes if it is shortened by flips.

    It is straight, but need not be the shortest one between its ends: it leads around handles and
    holes as the path does.

    Parameters
    ----------
    V, F, lengths, mollify
        As of `laplacian()`.
    vertices : (k,) integers
        The vertices that the path leads through, along the shortest edges between them.
    loop : bool
        Whether the path leads from the last vertex back to the first.

    Returns
    -------
    Path
        Complete, unless it touches itself. A loop that contracts, or a path from a vertex to itself,
        has no points and length 0.

    Examples
    --------
    Around the hole of a torus; the shortest loops are inside:

    >>> import intrinsic
    >>> V, F = intrinsic.shapes.torus(40, 20, radius=2, tube=1)
    >>> equator = intrinsic.geodesic(V, F, [0, 200, 400, 600], loop=True)
    >>> bool(abs(equator.length - 6.28) < 0.1)
    True
    """

    def compute(T: Triangulation) -> Path:
        through = vertices_of(vertices, T._core.number_of_input_vertices(), "vertices")
        if len(through) < (1 if is_loop else 2):
            raise InputError("vertices are too few; a path has at least two, and a loop one")
        if is_loop:
            through = np.append(through, through[0])
        return _path(T, *_core.geodesic_through(T._core, through, is_loop))

    is_loop = flag(loop, "loop")
    return _on_input(V, F, lengths, mollify, compute)


def geodesics(
    V: Any, F: ArrayLike | None = None, pairs: Any = None, *,
    lengths: ArrayLike | None = None, mollify: float | str = "auto",
) -> list[Path]:
    """Return a geodesic between each of many pairs of vertices, by flips.

    The shortest path along edges is shortened to a geodesic. It can be longer than the result of
    `path()`, and takes less time.

    Parameters
    ----------
    V, F, lengths, mollify
        As of `laplacian()`.
    pairs : (k, 2) integers
        The first and the last vertex of each path.

    Returns
    -------
    list of Path
        Complete, unless they touch themselves. The length of a path is infinite, and it has no
        points, if there is none. A path from a vertex to itself has no points and length 0.

    Examples
    --------
    >>> import intrinsic
    >>> V, F = intrinsic.shapes.cube()
    >>> [round(p.length ** 2, 12) for p in intrinsic.geodesics(V, F, [[0, 1], [0, 7]])]
    [1.0, 5.0]
    """

    def compute(T: Triangulation) -> list[Path]:
        ends = integers(pairs, (None, 2), "pairs", T._core.number_of_input_vertices(), "vertices")
        return [_path(T, *found) for found in _core.geodesics_between(T._core, ends)]

    return _on_input(V, F, lengths, mollify, compute)


def homology_loops(
    V: Any, F: ArrayLike | None = None, *, lengths: ArrayLike | None = None,
    mollify: float | str = "auto", progress: Progress | None = None,
) -> list[Path]:
    """Return closed geodesics around all handles and holes, the shortest ones first.

    Every closed curve is homologous to a combination of them with integer coefficients: they are a
    basis of the first homology group. The loops are short, but need not be the shortest ones.

    Parameters
    ----------
    V, F, lengths, mollify, progress
        As of `laplacian()`.

    Returns
    -------
    list of Path
        2 g loops for each closed component of genus g, and 2 g + b - 1 with b > 0 boundary loops.
        Complete, unless they touch themselves.

    Examples
    --------
    Around the tube of a torus, and around its hole:

    >>> import intrinsic
    >>> V, F = intrinsic.shapes.torus(40, 20, radius=2, tube=0.5)
    >>> [round(loop.length, 1) for loop in intrinsic.homology_loops(V, F)]
    [3.1, 9.4]
    """
    return computed_on(V, F, lengths, mollify,
                       lambda T: [_path(T, *found) for found in _core.homology_loops(T._core)],
                       check_progress(progress))


def level_set(
    V: Any, F: ArrayLike | None = None, values: Any = None, level: float = 0.0, *,
    lengths: ArrayLike | None = None, mollify: float | str = "auto",
) -> list[Path]:
    """Return the curves on which a function has a value. It is linear on the faces of F.

    The curves of equal distance of the program differ, because it interpolates distances on the
    Delaunay triangulation.

    Parameters
    ----------
    V, F, lengths, mollify
        As of `laplacian()`.
    values : (n,) floats
        The value at each vertex, such as a distance. They may be infinite on whole components,
        which then have no curves.
    level : float
        The value on the curves. A vertex with this value counts as above it.

    Returns
    -------
    list of Path
        With greater values on their left. Curves from boundary to boundary come first. A closed
        curve ends where it starts.

    Examples
    --------
    A circle of latitude on a sphere:

    >>> import intrinsic, numpy as np
    >>> V, F = intrinsic.shapes.icosphere(4)
    >>> circle, = intrinsic.level_set(V, F, V[:, 2], 0.6)
    >>> bool(abs(circle.length - 1.6 * np.pi) < 0.01)
    True
    """
    at = number(level, "level", -np.inf, np.inf)

    def compute(T: Triangulation) -> list[Path]:
        given = floats_or_infinity(values, (T._core.number_of_input_vertices(),), "values")
        return [_path(T, *found)
                for found in _core.level_set(T._core, _finite_on_components(given, T), at)]

    return _on_input(V, F, lengths, mollify, compute)


def _finite_on_components(values: Floats, T: Triangulation) -> Floats:
    """Return values with a constant on components where all are infinite."""
    is_infinite = np.isinf(values)
    corners = is_infinite[T.input_F]
    mixed = corners.any(axis=1) & ~corners.all(axis=1)
    if mixed.any():
        face = int(np.argmax(mixed))
        error = InputError(f"values are infinite at some vertices of face {face}, and finite at others")
        error.face, error.row = face, int(T.input_F[face][corners[face]][0])
        raise error
    return np.where(is_infinite, 0.0, values)


def signed_distance(
    V: Any, F: ArrayLike | None = None, curve: Any = None, method: str = "auto", *,
    time_step_factor: float | None = None, lengths: ArrayLike | None = None,
    mollify: float | str = "auto", full: bool = False, progress: Progress | None = None,
) -> Any:
    """Return the signed distance of each vertex from a curve, negative on the left of it.

    Parameters
    ----------
    V, F, lengths, mollify, progress
        As of `laplacian()`.
    curve : (k,) integers, pair of (k,) integers and (k, 3) floats, Path, or a list of these
        The points of a polyline, or of several ones: vertices, or faces and barycentric
        coordinates, or the points of a `Path`. Two points that follow each other must be in a
        common face.
    method : "auto", "exact" or "heat"
        "exact" gives the lengths of shortest paths, up to rounding. The curve must separate its
        left from its right, such as a loop around a region. "heat" has errors of some
        percent, and bridges gaps of a curve. "auto" is exact, within the limit of `distance()`,
        if the curve separates the surface.
    time_step_factor : float
        The time for which heat flows, in squared mean edge lengths. "auto" is then "heat". By
        default it is 0.7 at first, and more if normals do not reach all faces.
    full : bool
        Whether the method and an estimate of the error are returned, too.

    Returns
    -------
    (n,) float array, or Distances if `full`
        In the unit of V; infinite on a component without a part of the curve.

    Examples
    --------
    From the sides of a cube, with the bottom on the left:

    >>> import intrinsic
    >>> V, F = intrinsic.shapes.cube()
    >>> intrinsic.signed_distance(V, F, [0, 2, 6, 4, 0]).tolist()
    [0.0, 1.0, 0.0, 1.0, 0.0, 1.0, 0.0, 1.0]
    """
    return _measured(
        lambda T, kind, factor: _core.signed_distances(
            T._core, *_curve(curve, T), kind, factor, progress),
        (V, F, lengths, mollify), method, time_step_factor, full, progress)


def _curve(curve: Any, T: Triangulation) -> tuple[Integers, Floats, Integers]:
    if curve is None:
        raise ArrayError("curve is missing; give vertices, or points as faces and coordinates, or "
                         "a Path")
    parts = curve if _is_list_of_curves(curve) else [curve]
    found = [_polyline(part, T) for part in parts]
    sizes = [len(faces) for faces, _ in found]
    if min(sizes) < 2:
        which = "curve" if len(parts) == 1 else f"part {np.argmin(sizes)} of curve"
        raise InputError(f"{which} has fewer than two points")
    starts = np.cumsum([0] + sizes)
    return (np.concatenate([f for f, _ in found]), np.concatenate([b for _, b in found]),
            starts.astype(np.int64))


def _is_list_of_curves(curve: Any) -> bool:
    if not isinstance(curve, list) or len(curve) == 0:
        return False
    if isinstance(curve[0], Path):
        return True
    is_pair = isinstance(curve[0], tuple) and len(curve[0]) > 0
    return array_of(curve[0][0] if is_pair else curve[0], "curve").ndim > 0


def _polyline(part: Any, T: Triangulation) -> SurfacePoints:
    if isinstance(part, Path):
        part = part.faces, part.barycentric
    if isinstance(part, tuple):
        return points_on(part, T._core.number_of_faces(True), "curve")
    corners = T.input_F
    vertices = integers(part, (None,), "curve", T._core.number_of_input_vertices(), "vertices")
    first = np.full(T._core.number_of_input_vertices(), -1)
    first[corners.ravel()[::-1]] = np.arange(corners.size)[::-1]
    place = first[vertices]
    if (place < 0).any():
        raise InputError(f"vertex {vertices[np.argmax(place < 0)]} of curve has no face")
    return (place // 3).astype(np.int64), np.eye(3)[place % 3]


@dataclass(frozen=True, eq=False)
class LogMap:
    """The logarithmic map at a vertex.

    Attributes
    ----------
    vectors : (n,) complex array
        For each vertex, a tangent vector with the first direction and the length of the shortest
        path; infinite without a path. Lengths are in the unit of `V`. Angles refer to
        `tangent_frames()`.
    is_straight : (n,) bool array
        Whether the shortest path is straight. Then `exp_map()` leads to the vertex, unless the path
        touches the boundary or a vertex of more than 360 degrees.
    """

    vectors: Complexes
    is_straight: NDArray[np.bool_]


def log_map(
    V: Any, F: ArrayLike | None = None, source: Any = None, *, lengths: ArrayLike | None = None,
    mollify: float | str = "auto",
) -> LogMap:
    """Return the logarithmic map at a vertex, from exact shortest paths.

    Parameters
    ----------
    V, F, lengths, mollify
        As of `laplacian()`.
    source : int
        The vertex.

    Returns
    -------
    LogMap

    Examples
    --------
    >>> import intrinsic
    >>> V, F = intrinsic.shapes.icosphere(2)
    >>> log = intrinsic.log_map(V, F, 0)
    >>> d = intrinsic.distance(V, F, 0, "exact")
    >>> bool(abs(abs(log.vectors) - d).max() < 1e-12)
    True
    """

    def compute(T: Triangulation) -> LogMap:
        vectors, statuses = _core.logarithms(T._core, _vertex(source, T))
        return LogMap(vectors, statuses == 0)

    return _on_input(V, F, lengths, mollify, compute)


def exp_map(
    V: Any, F: ArrayLike | None = None, source: Any = None, vector: complex = 0, *,
    lengths: ArrayLike | None = None, mollify: float | str = "auto",
) -> Path:
    """Follow the straightest line from a vertex.

    Parameters
    ----------
    V, F, lengths, mollify
        As of `laplacian()`.
    source : int
        The vertex.
    vector : complex
        The direction and the length, as from `log_map()`. Angles are scaled as `TangentFrames`
        explains, also at corners of the boundary. A path over more than a million edges raises
        `LimitError`.

    Returns
    -------
    Path
        It is not complete if it meets the boundary.

    Examples
    --------
    >>> import intrinsic
    >>> V, F = intrinsic.shapes.icosphere(2)
    >>> log = intrinsic.log_map(V, F, 0)
    >>> line = intrinsic.exp_map(V, F, 0, log.vectors[50])
    >>> bool(abs(line.points[-1] - V[50]).max() < 1e-9)
    True
    """
    if array_of(vector, "vector").ndim != 0:
        raise ArrayError(f"vector is {shortened(vector)}; it must be one complex number")
    direction = complex(complexes(vector, (), "vector"))
    return _on_input(V, F, lengths, mollify, lambda T: _path(
        T, *_core.exponential(T._core, _vertex(source, T), direction)))


def transport(
    V: Any, F: ArrayLike | None = None, vertices: Any = None, vectors: Any = None, *,
    time_step_factor: float = 1.0, lengths: ArrayLike | None = None,
    mollify: float | str = "auto", progress: Progress | None = None,
) -> Complexes:
    """Transport tangent vectors from vertices to all others, along shortest paths, by heat.

    Parameters
    ----------
    V, F, lengths, mollify, progress
        As of `laplacian()`.
    vertices : (k,) integers
        The vertices of the given vectors. A vertex has only one vector.
    vectors : (k,) complex numbers
        The vectors, with the angles of `tangent_frames()`.
    time_step_factor : float
        The time for which heat flows, in squared mean edge lengths.

    Returns
    -------
    (n,) complex array
        At each vertex, the vector of the nearest source, transported. Near vertices with two
        nearest sources, it is a smooth mixture of both. It is zero where no source can reach.
        Angles are scaled as `TangentFrames` explains, also at corners of the boundary.

    Examples
    --------
    >>> import intrinsic
    >>> V, F = intrinsic.shapes.icosphere(2)
    >>> field = intrinsic.transport(V, F, [0], [2j])
    >>> bool(abs(abs(field) - 2).max() < 1e-6)
    True
    """
    factor = _given_factor(time_step_factor)

    def compute(T: Triangulation) -> Complexes:
        n = T._core.number_of_input_vertices()
        sources = vertices_of(vertices, n, "vertices")
        return _core.transported(T._core, sources, _vectors_at(sources, vectors), factor)[:n]

    return computed_on(V, F, lengths, mollify, compute, check_progress(progress))


def _vectors_at(sources: Integers, vectors: Any) -> Complexes:
    if len(sources) == 0:
        raise InputError("vertices are missing; give at least one, with its vector")
    given = array_of(vectors, "vectors")
    result = complexes(given[None] if given.ndim == 0 else given, sources.shape, "vectors")
    first, of_source = np.unique(sources, return_index=True, return_inverse=True)[1:]
    differs = result != result[first[of_source]]
    if differs.any():
        row = int(np.argmax(differs))
        error = InputError(f"vertex {sources[row]} has different vectors, in rows "
                           f"{first[of_source[row]]} and {row} of vectors; give one of them")
        error.row, error.vertex = row, int(sources[row])
        raise error
    return result


def _vertex(vertex: Any, T: Triangulation) -> int:
    return int(vertices_of(vertex, T._core.number_of_input_vertices(), "source", 1)[0])
