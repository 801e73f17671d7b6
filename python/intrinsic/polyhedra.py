# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""The convex polyhedron that has a given surface."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from numpy.typing import ArrayLike

from . import _core
from ._arrays import Floats, Integers, integers, number
from ._meshes import TriangleMesh, surface
from .triangulation import Triangulation


@dataclass(frozen=True, eq=False)
class ConvexPolyhedron(TriangleMesh):
    """A convex polyhedron, or a polygon with two sides.

    Attributes
    ----------
    V : (n, 3) float array
        The positions of the vertices, in the order and the unit of the input. Glued vertices are
        one vertex, see `vertex_map`.
    F : (m, 3) int array
        The triangles of the polyhedron.
    flat_vertices : (k,) int array
        Vertices without curvature, which are on faces and edges.
    kind : str
        "convex", or "polygon" for a polygon with two sides, if exact predicates confirm it for `V`.
        "convex_before_rounding" if only rounding to `V` makes some edges concave.
    max_edge_error : float
        The greatest difference of the length of an edge on the surface and in space, relative to
        it.
    triangulation : Triangulation
        The intrinsic triangulation of the input whose faces are faces of the polyhedron.
    vertex_map : (k,) int array or None
        The vertex that each vertex of a net has become, or -1 without faces; None without `glue`.
    """

    V: Floats
    F: Integers
    flat_vertices: Integers
    kind: str
    max_edge_error: float
    triangulation: Triangulation
    vertex_map: Integers | None = None

    @property
    def is_flat(self) -> bool:
        """Whether it is a polygon with two sides."""
        return self.kind == "polygon"


def convex_polyhedron(
    V: Any, F: ArrayLike | None = None, *, lengths: ArrayLike | None = None,
    flatness: float | None = None, glue: ArrayLike | None = None,
) -> ConvexPolyhedron:
    """Return the convex polyhedron that has the surface of a mesh, which need not be convex.

    By Alexandrov's theorem there is exactly one if the surface is a sphere and no vertex has more
    than 360 degrees.

    Parameters
    ----------
    V, F, lengths
        As of `laplacian()`, but V is no Triangulation.
    flatness : float
        The curvature, in radians, up to which a vertex counts as flat; by default the rounding
        error.
    glue : (k, 4) int array
        If V and F are a net, the sides that are glued. A row a, b, c, d glues two sides: a to b is
        one, c to d is the other, and a meets c.

    Returns
    -------
    ConvexPolyhedron

    Raises
    ------
    NegativeCurvatureError
        If a vertex has more than 360 degrees; the error has the `vertex`.
    NumericalError
        If no polyhedron is found whose convexity and edge lengths measurements confirm.

    Examples
    --------
    A pyramid on a cube, pushed inwards, is the pyramid outwards:

    >>> import intrinsic
    >>> V = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0.2, 0.2, 0.2]]
    >>> F = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]
    >>> p = intrinsic.convex_polyhedron(V, F)
    >>> p.F.shape, p.is_flat
    ((4, 3), False)

    A triangle is the net of a tetrahedron:

    >>> V = [[0, 0, 0], [2, 0, 0], [1, 3**0.5, 0], [1, 0, 0], [1.5, 0.75**0.5, 0], [0.5, 0.75**0.5, 0]]
    >>> F = [[0, 3, 5], [3, 1, 4], [5, 4, 2], [3, 4, 5]]
    >>> p = intrinsic.convex_polyhedron(V, F, glue=[[0, 3, 1, 3], [1, 4, 2, 4], [2, 5, 0, 5]])
    >>> p.V.shape, p.vertex_map
    ((4, 3), array([0, 0, 0, 1, 2, 3]))
    """
    tolerance = None if flatness is None else number(flatness, "flatness", 0, 1)
    on, vertex_map = surface(V, F, lengths), None
    if glue is not None:
        sides = integers(glue, (None, 4), "glue", on.number_of_vertices(), "vertices")
        on, vertex_map = _core.glued_surface(on, sides)
    d = _core.convex_polyhedron(on, tolerance)
    return ConvexPolyhedron(d["points"], d["faces"], d["flat_vertices"], d["kind"],
                            d["max_edge_error"], Triangulation._of_core(on, d["triangulation"]),
                            vertex_map)
