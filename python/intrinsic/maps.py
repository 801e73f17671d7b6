# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Discrete conformal maps to the plane, the sphere and the hyperbolic plane."""

from __future__ import annotations

import functools
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, TypeVar

import numpy as np
from numpy.typing import ArrayLike

from . import _core
from ._arrays import (Floats, Integers, choice, flag, floats, integers, number, points_on, shortened,
                      sparse)
from ._meshes import attempt, check_progress, surface
from .errors import InputError, MapError
from .triangulation import Progress, _fan


@dataclass(frozen=True, eq=False)
class MapSubdivision:
    """The pieces into which the input is cut so that the map is projective on each of them.

    Attributes
    ----------
    V : (k, 3) float array or None
        Positions on the input; the first n belong to its vertices. None without positions.
    corners : (c,) int array
        The vertices of all pieces, one convex polygon after the other, counterclockwise.
    starts : (p + 1,) int array
        Where in `corners` each polygon starts.
    input_face : (p,) int array
        The face of the input that contains each polygon.
    from_input : (k, n) sparse matrix
        Takes a function at the vertices of the input to all vertices, linear on its faces.
    corner_image : (c,) int array
        The row of `image` at each corner.
    image : (i, 2) or (i, 3) float array
        Positions in the plane, the Poincare disk or on the sphere. A vertex on a cut has several.
    homogeneous : (i, 3) or (i, 4) float array
        The same, in homogeneous coordinates, which are linear on each polygon.
    """

    V: Floats | None
    corners: Integers
    starts: Integers
    input_face: Integers
    from_input: Any
    corner_image: Integers
    image: Floats
    homogeneous: Floats

    @property
    def F(self) -> Integers:
        """The polygons cut into triangles, (t, 3)."""
        return self.corners[_fan(self.starts)[0]]

    @property
    def FT(self) -> Integers:
        """The rows of `image` at the corners of `F`, (t, 3): indices of texture coordinates."""
        return self.corner_image[_fan(self.starts)[0]]

    @property
    def uv(self) -> Floats:
        """The image of each corner of `F`, (t, 3, 2) or (t, 3, 3): texture coordinates."""
        return self.image[self.FT]

    @property
    def cut_vertices(self) -> Integers:
        """The vertices that have several images."""
        pairs = np.unique(np.stack([self.corners, self.corner_image], axis=1), axis=0)
        vertices, counts = np.unique(pairs[:, 0], return_counts=True)
        result: Integers = vertices[counts > 1]
        return result


class ConformalMap:
    """A discrete conformal map of a surface.

    It can be called with points of the surface, and returns their images: `map(faces, barycentric)`
    or `map((faces, barycentric))`.
    """

    def __init__(self, on: _core.Surface, core: Any) -> None:
        self._surface = on
        self._core = core

    @property
    def status(self) -> str:
        """"success", or the promise that the map does not keep."""
        return str(self._core.status())

    @property
    def promises(self) -> dict[str, tuple[float, float]]:
        """What a success has: for each name, the error that was measured and its bound."""
        return dict(self._core.promises())

    @property
    def log_scale(self) -> Floats:
        """The logarithm of the scale factor at each vertex, (n,)."""
        scales: Floats = self._core.log_scales()
        return scales

    @property
    def iterations(self) -> int:
        """The number of steps of all minimizations."""
        return int(self._core.iterations())

    @property
    def max_curvature_error(self) -> float:
        """The greatest difference of a curvature from its prescribed value, in radians."""
        return float(self._core.max_curvature_error())

    @property
    def crowded_faces(self) -> Integers:
        """The faces whose images are too small for numbers of type float64."""
        faces: Integers = self._core.crowded_faces()
        return faces

    @functools.cached_property
    def subdivision(self) -> MapSubdivision:
        """The pieces on which the map is projective, with their images."""
        d = self._core.subdivision()
        is_sphere = "sphere" in d
        return MapSubdivision(
            d.get("points"), d["corners"], d["starts"], d["input_face"],
            sparse(d["from_input"], by_rows=True),
            d["corners"] if is_sphere else d["corner_texture"],
            d["sphere" if is_sphere else "texture"],
            d["homogeneous" if is_sphere else "homogeneous_texture"])

    def __call__(self, faces: Any, barycentric: ArrayLike | None = None) -> Floats:
        """Return the images (k, 2) or (k, 3) of points. Points are faces (k,) and barycentric
        coordinates (k, 3), in the order of the corners of each face, or the pair of both arrays."""
        given = points_on(faces, self._surface.number_of_faces(), "points", barycentric)
        images: Floats = self._core.images(*given)
        return images

    def __repr__(self) -> str:
        return f"<{type(self).__name__}: {self.status}>"


class FlatMap(ConformalMap):
    """A map to the plane. Texture coordinates are `map.subdivision.uv`.

    The subdivision has them at the corners of its faces. Edges of the flat triangulation cut faces
    of the input.
    """

    def __init__(self, on: _core.Surface, core: Any, prescribed: Integers | None = None) -> None:
        super().__init__(on, core)
        self._prescribed = np.zeros(0, np.int64) if prescribed is None else prescribed

    @property
    def cones(self) -> Integers:
        """The inner vertices with cones: cones that were placed, or prescribed angle defects that are
        not zero."""
        return np.concatenate([self._core.cones(), self._prescribed])

    @property
    def radii(self) -> Floats:
        """The radius of the circle at each vertex in the plane, (n,); zero without a circle."""
        radii: Floats = self._core.radii()
        return radii


class SphereMap(ConformalMap):
    """A map to the unit sphere, or of a disk to a hemisphere.

    Attributes
    ----------
    positions : (n, 3) float array
        The image of each vertex.
    is_disk : bool
        Whether the surface is a disk, and its image a hemisphere.
    """

    @property
    def positions(self) -> Floats:
        """The image of each vertex, (n, 3), on the unit sphere."""
        positions: Floats = self._core.positions()
        return positions

    @property
    def radii(self) -> Floats:
        """The angle of the circle at each vertex on the unit sphere, (n,); zero without a circle."""
        radii: Floats = self._core.radii()
        return radii

    @property
    def is_disk(self) -> bool:
        """Whether the surface is a disk, and its image a hemisphere."""
        return bool(self._core.is_disk())


class HyperbolicMap(ConformalMap):
    """A map to the Poincare disk; boundary loops become geodesics."""

    @property
    def area(self) -> float:
        """The area of the hyperbolic surface."""
        return float(self._core.area())

    @property
    def radius(self) -> float:
        """The greatest hyperbolic distance of a point from the center of the disk."""
        return float(self._core.radius())

    @property
    def radii(self) -> Floats:
        """The hyperbolic radius of the circle at each vertex, (n,); zero without a circle."""
        radii: Floats = self._core.radii()
        return radii


AnyMap = TypeVar("AnyMap", bound=ConformalMap)

_KINDS = {"PlanarMap": FlatMap, "SphericalMap": SphereMap, "HyperbolicMap": HyperbolicMap}


def _bound(on: _core.Surface, core: Any) -> Any:
    return _KINDS[type(core).__name__](on, core)


def _advice(status: str, function: str) -> str:
    """Return what a caller of a function can do after this status."""
    if status in ("triangle_inequality", "no_minimum"):
        return "leave out keep_triangulation=True, so that edges are flipped"
    if status == "not_circular":
        return "use to_sphere() if the surface is a disk, or else flatten() with a free boundary"
    if function != "flatten":
        return "use flatten(), which places cones"
    if status in ("not_converged", "wrong_curvature"):
        return "give another boundary, cones='greedy', or mollify=1e-6, which lengthens edges"
    return ("give cones='greedy' and max_log_scale=2, so that scale factors differ less, or "
            "boundary='free'")


def _checked(result: AnyMap, function: str) -> AnyMap:
    if result.status == "success":
        return result
    error = MapError(f"{result._core.message()}; {_advice(result.status, function)}")
    error.status = result.status
    error.map = result if result._core.is_laid_out() else None
    raise error


def _vertex_values(values: Any, n: int, name: str) -> tuple[Integers, Floats]:
    """Return vertices and values, of a mapping or of an array with one value for each vertex."""
    if isinstance(values, Mapping):
        vertices = integers(list(values.keys()), (None,), f"the vertices of {name}", n, "vertices")
        return vertices, floats(list(values.values()), (len(vertices),), f"the values of {name}")
    return np.arange(n), floats(values, (n,), name)


def _one_for_each(on: _core.Surface, values: Any, name: str) -> Floats:
    """Return a value for each vertex; zero if none is given."""
    result = np.zeros(on.number_of_vertices())
    if values is not None:
        vertices, given = _vertex_values(values, len(result), name)
        result[vertices] = given
    return result


_SHAPES = ("disk", "rectangle")
_BOUNDARIES = ("free", "straight", "scale", "curvature", *_SHAPES)
_LAYOUTS = ("least-squares", "spectral", "incremental")


def _conditions(
    on: _core.Surface, cones: Any, boundary: str, values: Any
) -> tuple[Integers, Floats]:
    """Return for each vertex whether a logarithmic scale factor is prescribed instead of a
    curvature, and the value."""
    n = on.number_of_vertices()
    has_log_scale, prescribed = np.zeros(n, np.int64), np.zeros(n)
    border = on.border_vertices()
    if len(border) == 0 and boundary in ("straight", "scale", "curvature"):
        raise InputError(f"boundary is {boundary!r}, and the surface has no boundary")
    if not isinstance(cones, str):
        vertices, defects = _vertex_values(cones, n, "cones")
        is_inside = np.isin(vertices, on.faces()) & ~np.isin(vertices, border)
        is_wrong = ~is_inside & (defects != 0)
        if is_wrong.any():
            wrong = int(vertices[np.argmax(is_wrong)])
            where = "is on the boundary" if wrong in border else "has no face"
            error = InputError(f"cones has a value at vertex {wrong}, which {where}")
            error.vertex = wrong
            raise error
        prescribed[vertices] = defects
    if boundary == "free":
        has_log_scale[border] = 1
    if boundary in ("scale", "curvature"):
        vertices, wanted = _vertex_values(values, n, "boundary_values")
        chosen = np.isin(vertices, border)
        if isinstance(values, Mapping) and not chosen.all():
            error = InputError(f"boundary_values has vertex {vertices[np.argmin(chosen)]}, which "
                               "is not on the boundary")
            error.vertex = int(vertices[np.argmin(chosen)])
            raise error
        prescribed[vertices[chosen]] = wanted[chosen]
        has_log_scale[vertices[chosen]] = boundary == "scale"
    return has_log_scale, prescribed


def flatten(
    V: Any,
    F: ArrayLike | None = None,
    *,
    cones: Any = None,
    boundary: str = "free",
    boundary_values: Any = None,
    radii: Any = None,
    max_log_scale: float | None = None,
    max_area_distortion: float | None = None,
    layout: str = "least-squares",
    keep_triangulation: bool = False,
    exact: bool = False,
    lengths: ArrayLike | None = None,
    mollify: float | str = "auto",
    no_overlap: bool = False,
    unit_square: bool = False,
    progress: Progress | None = None,
) -> FlatMap:
    """Map a surface to the plane, discretely conformally.

    Parameters
    ----------
    V, F, lengths, mollify
        As of `laplacian()`, but V is no Triangulation.
    cones : "greedy", "exchanged", "none", mapping or (n,) floats
        "greedy" places cones inside until scale factors are within `max_log_scale`; the default,
        except for disks and rectangles. "exchanged" drops and moves greedy cones; often fewer
        remain, and it takes longer. A mapping from vertices to angle defects, or an array with
        the defect of each vertex, in radians, prescribes them.
    boundary : str
        "free" does not scale the boundary. "straight" makes all exterior angles zero. "scale" and
        "curvature" prescribe logarithms of scale factors, or exterior angles in radians. "disk"
        and "rectangle" give each component this shape.
    boundary_values : mapping or (n,) floats
        With "scale" and "curvature": values at vertices on the boundary. Others of a mapping are
        straight, with exterior angle 0.
    radii : mapping or (n,) floats
        Radii of circles around the vertices, which are mapped to circles. The map then keeps
        inversive distances instead of lengths. Circles of neighbors may touch, but not meet: they
        may overlap by 1e-8 of the distance of their centers. The boundary "disk" is refused with
        circles: `to_sphere()` maps a disk with circles to a hemisphere.
    max_log_scale : float
        The bound of absolute logarithmic scale factors, at inner vertices, for greedy and exchanged
        cones; 5 if not given. Disks and rectangles need `cones`, too.
    max_area_distortion : float
        The same bound as the factor, above 1, by which areas may grow or shrink. If both are
        given, the stricter bound counts.
    layout : "least-squares", "spectral" or "incremental"
        The method that lays out the flat faces.
    keep_triangulation : bool
        Whether edges are not flipped. Then many surfaces have no map.
    exact : bool
        Whether the flips to the intrinsic Delaunay triangulation are decided exactly.
    no_overlap, unit_square : bool
        Whether charts that overlap themselves are cut, and whether the image is scaled to the unit
        square.
    progress : callable
        Is called with a stage, "cones", "optimize", "layout", "trace" or "subdivide", and a number
        of steps.

    Returns
    -------
    FlatMap

    Raises
    ------
    MapError
        If the map does not keep its promises; the error has its `status`, and the `map`.

    Examples
    --------
    >>> import intrinsic
    >>> V, F = intrinsic.shapes.grid(4, 4)
    >>> map = intrinsic.flatten(V, F, boundary="disk")
    >>> uv = map.subdivision.image
    >>> radius = 0.5 ** 0.5 / 1.7724538509 * 2 ** 0.5  # of a disk with the area of the square
    >>> bool((abs(uv - uv.max(axis=0) / 2) < radius * 1.01).all())
    True
    >>> map([0], [[1, 0, 0]]).shape
    (1, 2)
    """
    choice(boundary, "boundary", _BOUNDARIES)
    choice(layout, "layout", _LAYOUTS)
    keeps_triangulation, is_exact = flag(keep_triangulation, "keep_triangulation"), flag(exact, "exact")
    cuts_overlaps, is_scaled = flag(no_overlap, "no_overlap"), flag(unit_square, "unit_square")
    if (boundary_values is not None) != (boundary in ("scale", "curvature")):
        raise InputError("boundary_values are for the boundaries 'scale' and 'curvature'")
    has_bound = max_log_scale is not None or max_area_distortion is not None
    given = "cones='none'" if isinstance(cones, str) else "prescribed cones"
    if cones is None:
        cones = "none" if boundary in _SHAPES else "greedy"
        given = f"the boundary {boundary!r}, which has no cones by default"
    if isinstance(cones, str) and cones not in ("greedy", "exchanged", "none"):
        raise InputError(
            f"cones is {shortened(cones)}; it must be 'greedy', 'exchanged', 'none' or have values")
    if has_bound and not (isinstance(cones, str) and cones != "none"):
        name = "max_area_distortion" if max_log_scale is None else "max_log_scale"
        raise InputError(f"{name} is for cones='greedy' or 'exchanged', not for {given}")
    log_scale = area_distortion = np.inf
    if max_log_scale is not None:
        log_scale = number(max_log_scale, "max_log_scale", 0, is_open=True)
    if max_area_distortion is not None:
        area_distortion = number(max_area_distortion, "max_area_distortion", 1, is_open=True)
    elif max_log_scale is None:
        log_scale = 5.0
    check_progress(progress)
    on = surface(V, F, lengths, mollify)
    kind, values = _conditions(on, cones, boundary, boundary_values)
    prescribed_cones = np.setdiff1d(np.flatnonzero(values), on.border_vertices())
    radius = _one_for_each(on, radii, "radii")
    if boundary == "disk" and radius.any():
        raise InputError("radii: with the boundary 'disk', the centers of circles at the boundary do "
                         "not lie on a circle; use to_sphere(), or another boundary")

    def compute(slack: float) -> FlatMap:
        core = _core.flatten(on, cones if isinstance(cones, str) else "none", log_scale,
                             area_distortion, boundary, layout, keeps_triangulation,
                             is_exact, slack, kind, values, radius, progress)
        return _checked(FlatMap(on, core, prescribed_cones), "flatten")

    result = attempt(mollify, compute)
    if cuts_overlaps:
        result._core.cut_overlaps()
    if is_scaled:
        result._core.fit_into_unit_square()
    return result


def to_sphere(
    V: Any, F: ArrayLike | None = None, *, radii: Any = None, lengths: ArrayLike | None = None,
    mollify: float | str = "auto", progress: Progress | None = None,
) -> SphereMap:
    """Map a sphere to the unit sphere, or a disk to a hemisphere, discretely conformally.

    Parameters
    ----------
    V, F, radii, lengths, mollify, progress
        As of `flatten()`.

    Returns
    -------
    SphereMap
        Its `positions` (n, 3) are the vertices of an inscribed convex polyhedron, or the centers of
        circles.

    Examples
    --------
    >>> import intrinsic
    >>> V, F = intrinsic.shapes.cube()
    >>> map = intrinsic.to_sphere(V, F)
    >>> bool((abs((map.positions ** 2).sum(axis=1) - 1) < 1e-12).all())
    True
    """
    check_progress(progress)
    on = surface(V, F, lengths, mollify)
    radius = _one_for_each(on, radii, "radii")
    return attempt(mollify, lambda slack: _checked(
        SphereMap(on, _core.to_sphere(on, radius, slack, progress)), "to_sphere"))


def to_hyperbolic(
    V: Any, F: ArrayLike | None = None, *, cones: Any = None, radii: Any = None,
    lengths: ArrayLike | None = None, mollify: float | str = "auto",
    progress: Progress | None = None,
) -> HyperbolicMap:
    """Map a surface to the hyperbolic plane, discretely conformally.

    Parameters
    ----------
    V, F, radii, lengths, mollify, progress
        As of `flatten()`. Every component has genus two or more, or enough boundaries or cones.
    cones : mapping or (n,) floats
        Angle defects, in radians; zero if not given.

    Returns
    -------
    HyperbolicMap
    """
    check_progress(progress)
    on = surface(V, F, lengths, mollify)
    curvatures = _one_for_each(on, cones, "cones")
    radius = _one_for_each(on, radii, "radii")
    return attempt(mollify, lambda slack: _checked(
        HyperbolicMap(on, _core.to_hyperbolic(on, curvatures, radius, slack, progress)),
        "to_hyperbolic"))


@dataclass(frozen=True, eq=False)
class Uniformization:
    """The metric of constant curvature of a surface.

    Attributes
    ----------
    type : str
        "sphere", "disk", "torus", "annulus" or "hyperbolic".
    map : SphereMap, FlatMap or HyperbolicMap
        The map. It leads to the sphere from a sphere or disk, to the plane from a torus or annulus,
        and to the hyperbolic plane otherwise.
    modulus : complex or None
        The modulus of a torus, or the imaginary unit times the modulus of an annulus.
    """

    type: str
    map: Any
    modulus: complex | None


def uniformize(
    V: Any, F: ArrayLike | None = None, *, radii: Any = None, lengths: ArrayLike | None = None,
    mollify: float | str = "auto", progress: Progress | None = None,
) -> Uniformization:
    """Give a connected surface the conformal metric of constant curvature that suits its topology.

    Parameters
    ----------
    V, F, radii, lengths, mollify, progress
        As of `flatten()`.

    Returns
    -------
    Uniformization

    Examples
    --------
    A torus of revolution is a rectangle with sides glued:

    >>> import intrinsic
    >>> V, F = intrinsic.shapes.torus(60, 30, radius=2, tube=1)
    >>> result = intrinsic.uniformize(V, F)
    >>> result.type, bool(abs(result.modulus - 1j * 3 ** 0.5) < 0.01)
    ('torus', True)
    """
    check_progress(progress)
    on = surface(V, F, lengths, mollify)
    radius = _one_for_each(on, radii, "radii")

    def compute(slack: float) -> Uniformization:
        kind, core, modulus = _core.uniformize(on, radius, slack, progress)
        return Uniformization(kind, _checked(_bound(on, core), "uniformize"), modulus)

    return attempt(mollify, compute)
