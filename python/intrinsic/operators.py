# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Matrices of the intrinsic Delaunay triangulation."""

from __future__ import annotations

from typing import Any, Callable, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from . import _core
from ._arrays import count, flag, sparse
from ._meshes import Result, arrays, attempt, check_progress, mollification
from .errors import InputError
from .triangulation import Progress, computed_on


def laplacian(
    V: Any, F: ArrayLike | None = None, *, lengths: ArrayLike | None = None,
    mollify: float | str = "auto", progress: Progress | None = None,
) -> Any:
    """Return the cotangent Laplacian of the intrinsic Delaunay triangulation.

    Entries off the diagonal are not positive, up to rounding, except for border edges opposite to
    obtuse angles. So a maximum principle holds at inner vertices.

    Parameters
    ----------
    V : (n, 3) array of floats, or a mesh object, or a Triangulation
        Positions. A Triangulation is used unchanged, and has no F.
    F : (m, 3) array of integers
        The corners of each face, from 0.
    lengths : (m, 3) array of floats
        Instead of V: the length of the side opposite to each corner. Both faces of an edge give
        exactly the same length. Indices in F are then less than 3 m.
    mollify : float or "auto"
        As of `Triangulation`; "auto" lengthens edges only if rounding leaves no result otherwise.
        An edge between equal positions needs a number. A Triangulation is as it is.
    progress : callable
        As of `Triangulation.delaunay()`.

    Returns
    -------
    (n, n) sparse matrix
        Symmetric and positive semidefinite, without unit. It maps a function to its integrated
        Laplacian, with the sign of -div grad.

    Examples
    --------
    >>> import intrinsic
    >>> V, F = intrinsic.shapes.icosphere(2)
    >>> L = intrinsic.laplacian(V, F)
    >>> L.shape
    (162, 162)
    >>> bool(abs(L.sum(axis=1)).max() < 1e-12)
    True
    """
    return _matrix("laplacian", V, F, lengths, mollify, progress)


def mass(
    V: Any, F: ArrayLike | None = None, *, lumped: bool = True, lengths: ArrayLike | None = None,
    mollify: float | str = "auto", progress: Progress | None = None,
) -> Any:
    """Return the mass matrix of the intrinsic Delaunay triangulation.

    Parameters
    ----------
    lumped : bool
        Whether the matrix is diagonal, with a third of the area of its faces at each vertex.
        Otherwise it has the integrals of products of hat functions.
    V, F, lengths, mollify, progress
        As of `laplacian()`.

    Returns
    -------
    (n, n) sparse matrix
        In squares of the unit of V. The sum of its entries is the area.

    Examples
    --------
    >>> import intrinsic
    >>> V, F = intrinsic.shapes.icosphere(2)
    >>> M = intrinsic.mass(V, F)
    >>> round(float(M.sum()), 3)  # the area of the unit sphere is 12.566
    12.329
    """
    return _matrix("lumped_mass" if flag(lumped, "lumped") else "mass", V, F, lengths, mollify, progress)


def gradient(
    V: Any, F: ArrayLike | None = None, *, lengths: ArrayLike | None = None,
    mollify: float | str = "auto", progress: Progress | None = None,
) -> Any:
    """Return the gradients of a function in the faces of the intrinsic Delaunay triangulation.

    Returns
    -------
    (2 m, n) sparse matrix
        Rows `2 f` and `2 f + 1` give the components in face `f`, along its first side and to the
        left of it, per unit of `V`. For the faces, make a `Triangulation` and give it as V.
    """
    return _matrix("gradient", V, F, lengths, mollify, progress)


def divergence(
    V: Any, F: ArrayLike | None = None, *, lengths: ArrayLike | None = None,
    mollify: float | str = "auto", progress: Progress | None = None,
) -> Any:
    """Return the matrix that maps vectors in faces, as of `gradient()`, to integrated
    divergences.

    Returns
    -------
    (n, 2 m) sparse matrix
        In the unit of V. The Laplacian is its negative product with the gradient.
    """
    return _matrix("divergence", V, F, lengths, mollify, progress)


def connection_laplacian(
    V: Any, F: ArrayLike | None = None, *, lengths: ArrayLike | None = None,
    mollify: float | str = "auto", progress: Progress | None = None,
) -> Any:
    """Return the connection Laplacian of the intrinsic Delaunay triangulation.

    Returns
    -------
    (n, n) sparse matrix of complex numbers
        Hermitian. Tangent vectors are complex numbers in the frames of `tangent_frames()`. Angles
        are scaled as `TangentFrames` explains, also at corners of the boundary.
    """
    return sparse(computed_on(V, F, lengths, mollify, lambda T: _core.connection_laplacian(T._core),
                              check_progress(progress)))


def _matrix(
    name: str, V: Any, F: ArrayLike | None, lengths: ArrayLike | None, mollify: float | str,
    progress: Progress | None,
) -> Any:
    return sparse(computed_on(V, F, lengths, mollify, lambda T: _core.operator_of(T._core, name),
                              check_progress(progress)))


class SoupOperators(NamedTuple):
    """Matrices of triangles that need not be a surface: `L, M = soup_operators(V, F)`.

    Attributes
    ----------
    laplacian : (n, n) sparse matrix
        As of `laplacian()`.
    mass : (n, n) sparse matrix
        The diagonal one.
    """

    laplacian: Any
    mass: Any


def soup_operators(
    V: Any, F: ArrayLike | None = None, *, neighbors: int = 30, mollify: float | str = "auto",
    progress: Progress | None = None,
) -> SoupOperators:
    """Return the Laplacian and the mass matrix of any triangles, or of points alone.

    Edges may have three faces or more, and vertices several fans of any orientation: the matrices
    belong to the tufted cover.

    Parameters
    ----------
    V : (n, 3) array of floats, or a mesh object
        Positions.
    F : (m, 3) array of integers
        The corners of each face. Without faces, points are triangulated with their neighbors.
    neighbors : int
        How many neighbors of each point, at least 3; all others if they are fewer.
    mollify, progress
        As of `laplacian()`.

    Returns
    -------
    SoupOperators

    Examples
    --------
    Three faces at one edge:

    >>> import intrinsic
    >>> V = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [0, -1, 0]]
    >>> operators = intrinsic.soup_operators(V, [[0, 1, 2], [0, 1, 3], [0, 1, 4]])
    >>> float(operators.mass.sum())
    1.5
    """
    return computed_on_soup(
        V, F, neighbors, mollify, progress,
        lambda _, soup: SoupOperators(sparse(soup.operator_of("laplacian")),
                                      sparse(soup.operator_of("lumped_mass"))))


def computed_on_soup(
    V: Any, F: ArrayLike | None, neighbors: int, mollify: float | str, progress: Progress | None,
    compute: Callable[[int, _core.Soup], Result],
) -> Result:
    """Return the result of `compute(number_of_points, soup)`, mollified as far as needed."""
    is_cloud = F is None and isinstance(V, (np.ndarray, list, tuple))
    points, faces = arrays(V, np.zeros((0, 3), np.int64) if is_cloud else F)
    number = min(count(neighbors, "neighbors", 3), max(len(points) - 1, 3))
    repeated = (faces == np.roll(faces, 1, axis=1)).any(axis=1)
    if repeated.any():
        error = InputError(f"row {int(np.argmax(repeated))} of F names a vertex twice")
        error.face = error.row = int(np.argmax(repeated))
        raise error
    mollification(mollify)
    check_progress(progress)
    return attempt(mollify, lambda slack: compute(
        len(points), _core.Soup(points, faces, number, slack, progress)))
