# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Intrinsic triangulations: flips, refinement, and the exact correspondence with the input."""

from __future__ import annotations

import functools
import os
import threading
from dataclasses import dataclass
from numbers import Real
from typing import Any, Callable, Iterator, TypeVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._arrays import (Floats, Integers, array_of, choice, count, flag, floats, floats_or_infinity,
                      integers, number, points_on, sparse, vertices)
from ._meshes import Result, attempt, check_progress, mollification, surface
from .errors import ArrayError, InputError

Progress = Callable[[str, int], Any]
SurfacePoints = tuple[Integers, Floats]
Method = TypeVar("Method", bound=Callable[..., Any])


def _locked(method: Method) -> Method:
    """Let other threads wait while one is in a method: the lock of the interpreter is released."""

    @functools.wraps(method)
    def call(self: Any, *args: Any, **kwargs: Any) -> Any:
        with self._lock:
            return method(self, *args, **kwargs)

    return call  # type: ignore[return-value]


def _fan(starts: Integers) -> tuple[Integers, Integers]:
    """Return the corners of the triangles of a fan in each polygon, as indices of the list of all
    corners, and the polygon of each."""
    sizes = np.diff(starts)
    polygon = np.repeat(np.arange(len(sizes)), sizes - 2)
    first = np.cumsum(sizes - 2) - (sizes - 2)
    k = np.arange(len(polygon)) - first[polygon]
    base = starts[polygon]
    return np.stack([base, base + k + 1, base + k + 2], axis=1), polygon


@dataclass(frozen=True, eq=False)
class Curves:
    """Polylines on a triangulation, one for each edge of another one.

    Attributes
    ----------
    starts : (k + 1,) int array
        Points `starts[i]` to `starts[i + 1] - 1` belong to curve `i`.
    faces : (p,) int array
        The face in which each point lies.
    barycentric : (p, 3) float array
        Its barycentric coordinates, in the order of the corners of the face.
    along : (p,) float array
        Its position on the edge, from 0 to 1.
    points : (p, 3) float array or None
        Its position, in the units of V; None if the surface has no positions.
    """

    starts: Integers
    faces: Integers
    barycentric: Floats
    along: Floats
    points: Floats | None

    def __len__(self) -> int:
        return len(self.starts) - 1

    def __getitem__(self, i: int) -> SurfacePoints:
        part = slice(*self._range(i))
        return self.faces[part], self.barycentric[part]

    def __iter__(self) -> Iterator[SurfacePoints]:
        return (self[i] for i in range(len(self)))

    def polyline(self, i: int) -> Floats:
        """Return the positions (p, 3) of the points of curve `i`."""
        if self.points is None:
            raise InputError("the surface has no positions; give V instead of lengths")
        return self.points[slice(*self._range(i))]

    def _range(self, i: int) -> tuple[int, int]:
        if not -len(self) <= i < len(self):
            raise IndexError(i)
        i %= len(self)
        return int(self.starts[i]), int(self.starts[i + 1])


@dataclass(frozen=True, eq=False)
class CommonSubdivision:
    """The polygons into which the edges of both triangulations cut the surface.

    Attributes
    ----------
    V : (k, 3) float array or None
        Positions; the first belong to the triangulation's vertices. None without positions.
    corners : (c,) int array
        The vertices of all polygons, one polygon after the other, counterclockwise.
    starts : (p + 1,) int array
        Where in `corners` each polygon starts.
    input_face, intrinsic_face : (p,) int arrays
        The faces that contain each polygon.
    from_input : (k, n) sparse matrix
        Takes a function at the vertices of the input to all vertices, linear on input faces.
    from_intrinsic : (k, n2) sparse matrix
        Takes a function at the vertices of the intrinsic triangulation to all vertices.
    """

    V: Floats | None
    corners: Integers
    starts: Integers
    input_face: Integers
    intrinsic_face: Integers
    from_input: Any
    from_intrinsic: Any

    @property
    def F(self) -> Integers:
        """The polygons cut into triangles, (t, 3)."""
        return self.corners[_fan(self.starts)[0]]

    @property
    def polygon(self) -> Integers:
        """The polygon that contains each triangle of `F`, (t,)."""
        return _fan(self.starts)[1]


@dataclass(frozen=True, eq=False)
class Refinement:
    """What a refinement has done.

    Attributes
    ----------
    status : str
        "bounds_met", or "bounds_met_but_excused" if small angles of the input excuse the remaining
        faces. "insertion_limit" if more insertions are not allowed, "no_room" if rounding prevents
        them.
    insertions, removals, flips : int
        Numbers of operations.
    remaining_faces : (r,) int array
        Faces that violate a bound.
    excused_faces : int
        How many of these are excused by a small-angle vertex.
    is_exact : bool
        Whether decisions were exact.
    """

    status: str
    insertions: int
    removals: int
    flips: int
    remaining_faces: Integers
    excused_faces: int
    is_exact: bool


@dataclass(frozen=True, eq=False)
class WeightedDelaunay:
    """What flips to a weighted Delaunay triangulation have done.

    Attributes
    ----------
    flips : int
        Their number.
    hidden_vertices : (h,) int array
        The vertices that others hide, because their weights are too small.
    weights : (n_vertices,) float array
        The weights for which the triangulation is weighted Delaunay. Hidden vertices have the
        least weight with which others do not hide them, the other vertices have their own.
    """

    flips: int
    hidden_vertices: Integers
    weights: Floats


@dataclass(frozen=True, eq=False)
class Certificate:
    """What exact arithmetic has found about a triangulation.

    Attributes
    ----------
    is_delaunay : bool
        Whether it certainly is geodesic and Delaunay, or weighted Delaunay for the given weights.
    is_geodesic : bool
        Whether its edges certainly are straight and its faces do not overlap.
    undecided : int
        Number of edges and vertices about which something remains undecided.
    ties : int array
        Edges of four cocircular points.
    non_delaunay_edges, non_straight_edges, folded_vertices : int arrays
        The elements that violate the conditions.
    visible_vertices : int array
        The vertices that were given as hidden, although their weights are great enough.
    decisions : dict
        Numbers of decisions "lengths", "floating_point", "multiprecision" and "exact".
    """

    is_delaunay: bool
    is_geodesic: bool
    undecided: int
    ties: Integers
    non_delaunay_edges: Integers
    non_straight_edges: Integers
    folded_vertices: Integers
    visible_vertices: Integers
    decisions: dict[str, int]


class Triangulation:
    """An intrinsic triangulation of a surface, with the exact correspondence to the input.

    At first it is the input. Flips and refinement change it, and never the surface: the vertices
    of the input keep their indices, and inserted vertices follow them.

    Parameters
    ----------
    V : (n, 3) array of floats, or a mesh object, or None
        Positions, in any unit; an object with vertices and faces, or points and cells, and no F;
        None with `lengths`.
    F : (m, 3) array of integers
        The corners of each face, from 0, counterclockwise.
    exact : bool
        Whether `delaunay()` and `refine()` decide exactly which edges are Delaunay.
    lengths : (m, 3) array of floats
        Instead of V: the length of the side opposite to each corner. Both faces of an edge give
        exactly the same length. Indices in F are then less than 3 m.
    mollify : float or "auto"
        Lengthens all edges until triangle inequalities have this slack, relative to the mean edge
        length. The default 0 changes no length. "auto" lengthens edges only if rounding leaves no
        triangulation otherwise; an edge between equal positions needs a number.

    Raises
    ------
    NotAManifoldError
        If an edge or a vertex is not manifold; the error has its `edge` or `vertex`.
    InputError
        If the arrays do not describe a surface for another reason.

    Examples
    --------
    Two faces at the long diagonal of a kite:

    >>> import intrinsic
    >>> V = [[0, 0, 0], [4, 0, 0], [2, 1, 0], [2, -1, 0]]
    >>> T = intrinsic.Triangulation(V, [[0, 1, 2], [1, 0, 3]])
    >>> T.is_delaunay()
    False
    >>> T.delaunay()
    1
    >>> T.E[T.crossings > 0]
    array([[3, 2]])
    >>> round(float(T.lengths[T.crossings > 0][0]), 12)
    2.0
    """

    def __init__(
        self,
        V: Any,
        F: ArrayLike | None = None,
        exact: bool = False,
        *,
        lengths: ArrayLike | None = None,
        mollify: float | str = 0.0,
    ) -> None:
        is_exact = flag(exact, "exact")
        on = surface(V, F, lengths, mollify)
        core = attempt(mollify, lambda slack: _core.Triangulation(on, slack, mollify == "auto"))
        self._set(on, core, is_exact)

    def _set(self, on: _core.Surface | None, core: _core.Triangulation, exact: bool) -> None:
        self._surface = on
        self._core = core
        self._exact = exact
        self._is_changing = False
        self._lock = threading.RLock()

    @classmethod
    def _of_core(cls, on: _core.Surface | None, core: _core.Triangulation) -> "Triangulation":
        result = cls.__new__(cls)
        result._set(on, core, False)
        return result

    @_locked
    def copy(self) -> "Triangulation":
        """Return a triangulation that is the same, and stays when this one changes."""
        result = Triangulation._of_core(self._surface, self._core.copy())
        result._exact = self._exact
        return result

    # ---- Changes ----

    def _change(self, change: Callable[[], Any]) -> Any:
        if self._is_changing:
            raise InputError("progress must not change the triangulation")
        self._is_changing = True
        try:
            return change()
        finally:
            self._is_changing = False

    @_locked
    def delaunay(self, exact: bool | None = None, *, progress: Progress | None = None) -> int:
        """Flip edges until the triangulation is intrinsic Delaunay.

        Parameters
        ----------
        exact : bool
            Whether all decisions are exact; by default as in the constructor.
        progress : callable
            Is called with "flip" and the number of flips, some times a second. An exception that
            it raises stops the flips; so does Control-C. The triangulation is valid then.

        Returns
        -------
        int
            The number of flips.
        """
        is_exact = self._exact if exact is None else flag(exact, "exact")
        check_progress(progress)
        flips: int = self._change(lambda: self._core.make_delaunay(is_exact, progress))
        return flips

    @_locked
    def weighted_delaunay(
        self, weights: ArrayLike, exact: bool | None = None, *, progress: Progress | None = None
    ) -> WeightedDelaunay:
        """Flip edges until the triangulation is weighted Delaunay.

        Then the power centers of two neighboring faces have a nonnegative signed distance. With
        equal weights, the triangulation is Delaunay.

        Parameters
        ----------
        weights : (n_vertices,) floats
            Squared lengths of any sign, such as squared radii of circles at the vertices.
        exact : bool
            Whether 155 decimal digits decide; by default as in the constructor.
        progress : callable
            As of `delaunay()`.

        Returns
        -------
        WeightedDelaunay

        Examples
        --------
        >>> import intrinsic
        >>> V = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]
        >>> T = intrinsic.Triangulation(V, [[0, 1, 2], [0, 2, 3]])
        >>> T.weighted_delaunay([0, 0.1, 0, 0]).flips
        1
        """
        given = floats(weights, (self.n_vertices,), "weights")
        is_exact = self._exact if exact is None else flag(exact, "exact")
        check_progress(progress)
        done = self._change(lambda: self._core.make_weighted_delaunay(given, is_exact, progress))
        return WeightedDelaunay(**done)

    @_locked
    def weighted_laplacian(self, weights: ArrayLike) -> Any:
        """Return the Laplacian of the triangulation as it is, for weights of vertices.

        Entries are quotients of dual and primal lengths, where power centers are the vertices of
        the dual. With equal weights this is the cotangent Laplacian.

        Parameters
        ----------
        weights : (n_vertices,) floats
            As the result of `weighted_delaunay()` has them, so that entries off the diagonal are
            not positive.

        Returns
        -------
        (n_vertices, n_vertices) sparse matrix
            Positive semidefinite on a weighted Delaunay triangulation without boundary.
        """
        given = floats(weights, (self.n_vertices,), "weights")
        return sparse(_core.weighted_laplacian(self._core, given))

    @_locked
    def refine(
        self,
        min_angle: float = 25.0,
        max_circumradius: float = np.inf,
        *,
        simplicial: bool = False,
        max_insertions: int | None = None,
        exact: bool | None = None,
        progress: Progress | None = None,
    ) -> Refinement:
        """Insert vertices until all faces obey bounds, and keep the triangulation Delaunay.

        Parameters
        ----------
        min_angle : float
            The least angle, in degrees, from 0 to 60. Beyond 30 the refinement may not end
            before `max_insertions`.
        max_circumradius : float
            The greatest circumradius, in the unit of V.
        simplicial : bool
            Whether the result has no loops, and at most one edge between two vertices.
        max_insertions : int
            The number of vertices that may be inserted; depends on the bounds if not given.
        exact : bool
            Whether decisions are exact from the beginning; by default as in the constructor.
        progress : callable
            As of `delaunay()`, with "refine".

        Returns
        -------
        Refinement

        Examples
        --------
        >>> import intrinsic
        >>> T = intrinsic.Triangulation([[0, 0, 0], [9, 0, 0], [9, 1, 0], [0, 1, 0]],
        ...                             [[0, 1, 2], [0, 2, 3]])
        >>> T.refine(25).status
        'bounds_met'
        >>> T.n_vertices > 4
        True
        """
        angle = number(min_angle, "min_angle", 0, 60)
        has_radius = not isinstance(max_circumradius, Real) or max_circumradius != np.inf
        radius = number(max_circumradius, "max_circumradius", 0, is_open=True) if has_radius else np.inf
        is_simplicial = flag(simplicial, "simplicial")
        limit = None if max_insertions is None else count(max_insertions, "max_insertions", 0)
        is_exact = self._exact if exact is None else flag(exact, "exact")
        check_progress(progress)
        done = self._change(lambda: self._core.refine(
            angle, radius, is_simplicial, limit, is_exact, progress))
        return Refinement(**done)

    # ---- Elements ----

    @_locked
    def constrain(self, edges: ArrayLike, constrained: bool = True) -> None:
        """Forbid flips of some edges, or allow them again.

        A triangulation with constraints is Delaunay beside them. If a vertex is inserted on a
        constrained edge, both parts stay constrained.

        Parameters
        ----------
        edges : (k,) array of integers, or (e,) array of booleans
            Rows of `E`.
        constrained : bool
            Whether flips are forbidden.

        Examples
        --------
        >>> import intrinsic
        >>> V = [[0, 0, 0], [4, 0, 0], [2, 1, 0], [2, -1, 0]]
        >>> T = intrinsic.Triangulation(V, [[0, 1, 2], [1, 0, 3]])
        >>> T.constrain((T.E == [0, 1]).all(axis=1) | (T.E == [1, 0]).all(axis=1))
        >>> T.delaunay(), T.constrained.sum()
        (0, 1)
        """
        rows = _chosen_edges(edges, len(self._core.edges(False)))
        is_constrained = flag(constrained, "constrained")
        self._change(lambda: self._core.constrain(rows, is_constrained))

    @property
    @_locked
    def constrained(self) -> NDArray[np.bool_]:
        """Which edges are not flipped, (e,)."""
        return self._core.constraints().astype(bool)

    @_locked
    def is_delaunay(self) -> bool:
        """Return whether all edges are Delaunay, up to rounding."""
        return self._core.is_delaunay()

    @property
    @_locked
    def F(self) -> Integers:
        """The corners of each face, (m2, 3). Corners may be equal: loops are ordinary edges."""
        return self._core.faces(False)

    @property
    @_locked
    def E(self) -> Integers:
        """The ends of each edge, (e, 2). Several edges may have the same ends."""
        return self._core.edges(False)

    @property
    @_locked
    def face_edges(self) -> Integers:
        """The edge from each corner of a face to the next one, (m2, 3)."""
        return self._core.face_edges(False)

    @property
    @_locked
    def lengths(self) -> Floats:
        """The length of each edge, (e,), in the unit of V."""
        return self._core.lengths(False)

    @property
    @_locked
    def face_lengths(self) -> Floats:
        """The length of the side opposite to each corner of a face, (m2, 3)."""
        result: Floats = self.lengths[self.face_edges[:, [1, 2, 0]]]
        return result

    @property
    @_locked
    def crossings(self) -> Integers:
        """How many edges of the input each edge crosses, (e,); -1 for edges of the input."""
        return self._core.normal_coordinates()

    @property
    @_locked
    def n_vertices(self) -> int:
        """The number of vertices, the inserted ones too."""
        return self._core.number_of_vertices()

    @property
    @_locked
    def inserted(self) -> SurfacePoints:
        """Where the inserted vertices are on the input: faces (i,) and coordinates (i, 3)."""
        return self._core.inserted_vertices()

    @property
    @_locked
    def input_F(self) -> Integers:
        """The faces of the input, (m, 3)."""
        return self._core.faces(True)

    @property
    @_locked
    def input_E(self) -> Integers:
        """The edges of the input, (e1, 2)."""
        return self._core.edges(True)

    @property
    @_locked
    def V(self) -> Floats:
        """The positions of all vertices, the inserted ones too, (n2, 3)."""
        return np.concatenate([self._positions(), self.positions(self.inserted)])

    def _positions(self) -> Floats:
        if self._surface is None or not self._surface.has_positions():
            raise InputError("the surface has no positions: it was made from lengths, read without V, "
                             "or simplified")
        return self._surface.positions()

    def positions(self, points: tuple[ArrayLike, ArrayLike]) -> Floats:
        """Return the positions (k, 3) of points of the input, faces and barycentric
        coordinates."""
        faces, coordinates = points_on(points, self._core.number_of_faces(True), "points")
        corners = self._positions()[self._core.input_corners(faces)]
        result: Floats = np.einsum("kc,kcx->kx", coordinates, corners)
        return result

    # ---- The correspondence ----

    @_locked
    def trace(self, edges: ArrayLike | None = None, *, of: str = "intrinsic") -> Curves:
        """Trace edges of one triangulation over the other.

        Parameters
        ----------
        edges : (k,) array of integers
            Which edges; all if not given.
        of : "intrinsic" or "input"
            The triangulation of the edges: rows of `E`, or of `input_E`.

        Returns
        -------
        Curves
            Points of the input for "intrinsic", with positions; points of the intrinsic
            triangulation for "input", without.

        Examples
        --------
        >>> import intrinsic
        >>> V = [[0, 0, 0], [4, 0, 0], [2, 1, 0], [2, -1, 0]]
        >>> T = intrinsic.Triangulation(V, [[0, 1, 2], [1, 0, 3]])
        >>> _ = T.delaunay()
        >>> T.trace(T.crossings > 0).polyline(0)
        array([[ 2., -1.,  0.],
               [ 2.,  0.,  0.],
               [ 2.,  1.,  0.]])
        """
        is_input = _is_input(of, "of")
        n = len(self._core.edges(is_input))
        rows = np.arange(n) if edges is None else _chosen_edges(edges, n)
        starts, faces, coordinates, along = self._core.trace(is_input, rows)
        has_points = not is_input and self._surface is not None and self._surface.has_positions()
        points = self.positions((faces, coordinates)) if has_points else None
        return Curves(starts, faces, coordinates, along, points)

    @_locked
    def _page(self, functions: dict[str, ArrayLike], direct: bool) -> str:
        """Return a page that shows the surface with both triangulations, and functions at the
        vertices of the input or at all vertices."""
        self._positions()
        n, n2 = self._core.number_of_input_vertices(), self._core.number_of_vertices()
        return _core.page_of_triangulation(self._core, [
            (name, floats_or_infinity(f, (n2 if array_of(f, name).shape == (n2,) else n,), name))
            for name, f in functions.items()], direct)

    @_locked
    def common_subdivision(self) -> CommonSubdivision:
        """Return the polygons into which the edges of both triangulations cut the surface."""
        d = self._core.common_subdivision()
        return CommonSubdivision(
            d.get("points"), d["corners"], d["starts"], d["input_face"], d["intrinsic_face"],
            sparse(d["from_input"], by_rows=True), sparse(d["from_intrinsic"], by_rows=True))

    @_locked
    def transfer(self, what: Any, *, to: str = "intrinsic") -> Any:
        """Map points, or a function, from one triangulation to the other.

        Parameters
        ----------
        what : pair of (k,) integers and (k, 3) floats, or (n,) floats
            Points as faces and barycentric coordinates, or the values of a function at the
            vertices.
        to : "intrinsic" or "input"
            The triangulation on which the result is.

        Returns
        -------
        pair of (k,) ints and (k, 3) floats, or (n2,) floats
            The same points on the other triangulation. Or the function that is linear on its faces
            and closest to the given one in the L2 norm. Its integral is the same.
        """
        from_input = not _is_input(to, "to")
        if isinstance(what, tuple):
            faces, coordinates = points_on(what, self._core.number_of_faces(from_input), "what")
            return self._core.points_across(from_input, faces, coordinates)
        size = self._core.number_of_input_vertices() if from_input else self.n_vertices
        return self._core.function_across(from_input, floats(what, (size,), "what"))

    @_locked
    def certify(
        self, weights: ArrayLike | None = None, hidden_vertices: ArrayLike | None = None
    ) -> Certificate:
        """Prove in exact arithmetic that the triangulation is geodesic and Delaunay, or weighted
        Delaunay.

        Parameters
        ----------
        weights : (n_vertices,) floats
            As they were given to `weighted_delaunay()`; by default there are none.
        hidden_vertices : ints
            As the result of `weighted_delaunay()` has them. Their weights must be less than the
            least weights with which others do not hide them.

        Returns
        -------
        Certificate

        Examples
        --------
        >>> import intrinsic
        >>> V = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]
        >>> T = intrinsic.Triangulation(V, [[0, 1, 2], [0, 2, 3]], exact=True)
        >>> _ = T.delaunay()
        >>> c = T.certify()
        >>> c.is_delaunay, len(c.ties)
        (True, 1)
        """
        if weights is not None:
            given = floats(weights, (self.n_vertices,), "weights")
            hidden = vertices(np.zeros(0, np.int64) if hidden_vertices is None else hidden_vertices,
                              self.n_vertices, "hidden_vertices")
            return Certificate(**self._core.certify_weighted(given, hidden))
        if hidden_vertices is not None:
            raise ArrayError("hidden_vertices has no effect without weights")
        return Certificate(**self._core.certify())

    # ---- Files ----

    @_locked
    def save(self, path: str | os.PathLike[str]) -> None:
        """Write both triangulations and their correspondence to a text file, in the format of
        the program's --save."""
        with open(path, "w", encoding="ascii", newline="\n") as file:
            file.write(self._core.to_text())

    @classmethod
    def load(
        cls, path: str | os.PathLike[str], V: Any = None, F: ArrayLike | None = None
    ) -> "Triangulation":
        """Read a file of `save()`. With the original V and F, results have positions.

        V and F must have the faces and the lengths of the input. If the input was mollified, it may
        have longer edges.
        """
        with open(path, encoding="latin-1") as file:  # any byte can be read, for its line
            text = file.read()
        on = None if V is None else surface(V, F, mollify=1)  # V may have edges without length
        try:
            result = cls._of_core(on, _core.Triangulation.from_text(text, on))
            if on is not None:
                _check_positions(result, on, text.rstrip().endswith("exact lengths"))
        except InputError as error:
            error.args = (f"{os.fspath(path)}: {error}",)
            raise
        return result

    @_locked
    def __reduce__(self) -> tuple[Any, ...]:
        on = self._surface
        points = None if on is None or not on.has_positions() else (on.positions(), self.input_F)
        return _unpickled, (points, self._core.to_text(), self._exact)

    def __repr__(self) -> str:
        return f"<Triangulation: {self.n_vertices} vertices, {len(self.F)} faces>"


def _check_positions(T: Triangulation, on: _core.Surface, can_be_mollified: bool) -> None:
    """Raise an error unless a surface with positions has the faces and lengths of the input.

    Mollification adds one number to all lengths. Positions in single precision are allowed.
    """
    if not np.array_equal(T.input_F, on.faces()) or (
            on.number_of_vertices() != T._core.number_of_input_vertices()):
        raise InputError("the faces in the file differ from F")
    ends, lengths = T.input_E, T._core.lengths(True)
    by_V = np.linalg.norm(np.diff(on.positions()[ends], axis=1)[:, 0], axis=1)
    added = max(np.median(lengths - by_V), 0) if can_be_mollified else 0
    error = np.abs(lengths - by_V - added)
    e = int(error.argmax())
    if error[e] > 1e-6 * lengths.max():
        i, j = map(int, ends[e])
        refusal = InputError(f"the length of the edge from {i} to {j} is {lengths[e]} in the file, and "
                             f"{by_V[e]} by V")
        refusal.edge = i, j
        raise refusal


def _unpickled(points: tuple[Floats, Integers] | None, text: str, exact: bool) -> Triangulation:
    on = None if points is None else _core.Surface.of_points(*points, True)
    result = Triangulation._of_core(on, _core.Triangulation.from_text(text, on))
    result._exact = exact
    return result


def _chosen_edges(edges: ArrayLike, n: int) -> Integers:
    """Return the indices of edges, which may be chosen by a mask."""
    chosen = array_of(edges, "edges")
    if chosen.dtype == bool:
        if chosen.shape != (n,):
            raise ArrayError(f"edges has the shape {chosen.shape}; a mask must be ({n},)")
        chosen = np.flatnonzero(chosen)
    return integers(chosen, (None,), "edges", n, "edges")


def _is_input(side: str, name: str) -> bool:
    return choice(side, name, ("input", "intrinsic")) == "input"


def computed_on(
    V: Any, F: ArrayLike | None, lengths: ArrayLike | None, mollify: float | str,
    compute: Callable[[Triangulation], Result], progress: Progress | None = None,
    is_delaunay: bool = True,
) -> Result:
    """Return the result of `compute(T)`. T is V if it is a triangulation, otherwise the
    triangulation of a mesh, which is intrinsic Delaunay if `is_delaunay`. With "auto", edges are
    lengthened if a NumericalError ends it."""
    if isinstance(V, Triangulation):
        if F is not None or lengths is not None:
            raise ArrayError("a Triangulation has faces and lengths; leave F and lengths out, and name "
                             "all further arguments, as in distance(T, sources=0)")
        mollification(mollify)
        with V._lock:
            return compute(V)
    on = surface(V, F, lengths, mollify)

    def made(slack: float) -> Result:
        T = Triangulation._of_core(on, _core.Triangulation(on, slack, mollify == "auto"))
        if is_delaunay:
            T.delaunay(progress=progress)
        return compute(T)

    return attempt(mollify, made)
