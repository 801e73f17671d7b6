# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Finds positions and faces in arrays and in meshes of other packages."""

from __future__ import annotations

import os
import sys
import warnings
from typing import Any, Callable, TypeVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._arrays import (Floats, Integers, array_of, floats, integers, number, shortened,
                      unchecked_floats, unchecked_integers)
from .errors import (ArrayError, InputError, MapError, MollificationWarning, NumericalError,
                     UnderflowError)

Result = TypeVar("Result")

SLACKS = (1e-8, 1e-6)


class TriangleMesh:
    """A mesh of triangles."""

    V: Floats
    F: Integers

    @property
    def vertices(self) -> Floats:
        """The same as `V`, for other packages."""
        return self.V

    @property
    def faces(self) -> Integers:
        """The same as `F`, for other packages."""
        return self.F


def _packed_faces(faces: Any) -> Any:
    """Return rows of corners, also of pyvista's list 3, i, j, k, 3, ..."""
    array = array_of(faces, "F")
    if array.ndim != 1 or array.size % 4 != 0 or array.dtype.kind not in "iu":
        return faces
    rows = array.reshape(-1, 4)
    if (rows[:, 0] != 3).any():
        raise ArrayError("the mesh has faces that are not triangles")
    return rows[:, 1:]


def _cells(cells: Any) -> Any:
    """Return the triangles of meshio's list of blocks of cells."""
    blocks = [(getattr(b, "type", None) or b[0], getattr(b, "data", None)) for b in cells]
    triangles = [b if b is not None else c[1] for (kind, b), c in zip(blocks, cells)
                 if kind == "triangle"]
    others = {kind for kind, _ in blocks if kind not in ("triangle", "vertex", "line")}
    if others:
        raise ArrayError(f"the mesh has cells of type {', '.join(sorted(others))}; only triangles "
                         "are accepted")
    return np.concatenate([integers(t, (None, 3), "F", None, "vertices") for t in triangles] or
                          [np.zeros((0, 3), int)])


def _refuse_own_object(mesh: Any) -> None:
    """Raise an error for an object of this package that is no mesh, such as a Triangulation."""
    if type(mesh).__module__.partition(".")[0] == __package__:
        raise ArrayError(f"V is a {type(mesh).__name__}, but this function takes a mesh; give V and F")


def vertices_and_faces(mesh: Any) -> tuple[Any, Any]:
    """Return positions and faces of an object of another package. It has `vertices` and `faces`
    (trimesh), `points` and `cells` (meshio), or `points` and `faces` (pyvista)."""
    if isinstance(mesh, (str, os.PathLike)):
        raise ArrayError("V is the name of a file; read it, for example by meshio.read()")
    if hasattr(mesh, "vertices") and hasattr(mesh, "faces"):
        return mesh.vertices, mesh.faces
    _refuse_own_object(mesh)
    if hasattr(mesh, "points") and hasattr(mesh, "cells") and not hasattr(mesh, "faces"):
        return mesh.points, _cells(mesh.cells)
    if hasattr(mesh, "points") and hasattr(mesh, "faces"):
        return mesh.points, _packed_faces(mesh.faces)
    raise ArrayError("F is missing, and V is no mesh: it has neither vertices and faces nor points "
                     "and cells")


def _positions_and_faces(V: Any, F: Any) -> tuple[Any, Any]:
    """Return V and F, or the positions and faces of the mesh V."""
    if F is None:
        return vertices_and_faces(V)
    if (hasattr(V, "vertices") or hasattr(V, "points")) and (hasattr(V, "faces") or hasattr(V, "cells")):
        raise ArrayError("V is a mesh with faces; leave F out, and name all further arguments, as "
                         "in distance(mesh, sources=0)")
    _refuse_own_object(V)
    return V, F


def arrays(V: Any, F: ArrayLike | None) -> tuple[Floats, Integers]:
    """Return checked arrays (n, 3) and (m, 3)."""
    V, F = _positions_and_faces(V, F)
    points = floats(V, (None, 3), "V")
    return points, _faces(F, len(points))


def _unchecked_arrays(V: Any, F: Any) -> tuple[Floats, Integers]:
    """Return arrays (n, 3) and (m, 3), whose values the compiled part checks."""
    return (unchecked_floats(V, (None, 3), "V"),
            unchecked_integers(triangles(F), (None, 3), "F")[1])


def triangles(F: Any) -> NDArray[Any]:
    """Return F as an array. Quadrilaterals are refused, with the way to split them."""
    faces = array_of(F, "F")
    if faces.ndim == 2 and faces.shape[1] == 4:
        raise ArrayError(f"F has the shape {faces.shape}; it must be (m, 3). Split quads into "
                         "triangles: np.vstack([F[:, [0, 1, 2]], F[:, [0, 2, 3]]])")
    return faces


def _faces(F: Any, size: int | None) -> Integers:
    try:
        return integers(triangles(F), (None, 3), "F", size, "vertices")
    except InputError as error:
        if error.row is not None:
            error.face = error.row
        raise


def surface(
    V: Any, F: ArrayLike | None, lengths: ArrayLike | None = None, mollify: float | str = 0.0
) -> _core.Surface:
    """Return the surface of arrays, or of lengths alone if V is None."""
    if lengths is None:
        V, F = _positions_and_faces(V, F)
        points, faces = _unchecked_arrays(V, F)
        _check_not_empty(faces)
        try:
            return _core.Surface.of_points(points, faces, bool(mollification(mollify)))
        except InputError:
            arrays(V, F)  # names a row that is wrong
            raise
    if V is not None:
        raise ArrayError("give either V or lengths, and None for the other")
    faces = _faces(F, None)
    _check_not_empty(faces)
    _check_numbering(faces)
    return _core.Surface.of_lengths(floats(lengths, (len(faces), 3), "lengths"), faces)


def _check_not_empty(faces: Integers) -> None:
    if len(faces) == 0:
        raise InputError("F has no rows; give at least one face")


def _check_numbering(faces: Integers) -> None:
    """Without positions, the greatest index is the number of vertices: a wrong one would take any
    amount of memory."""
    bad = np.flatnonzero((faces >= faces.size).any(axis=1))
    if len(bad) > 0:
        error = InputError(f"row {bad[0]} of F is {faces[bad[0]]}; without V, indices must be less "
                           f"than {faces.size}, three times the number of faces")
        error.row = error.face = int(bad[0])
        raise error


def mollification(mollify: float | str) -> float | None:
    """Return the slack, or None if it is to be found."""
    if isinstance(mollify, str):
        if mollify == "auto":
            return None
        raise ArrayError(f"mollify is {mollify!r}; it must be 'auto' or a number")
    return number(mollify, "mollify", 0, 1)


def level_of_caller() -> int:
    """Return the number of frames up to the first one outside of this package."""
    folder = os.path.dirname(__file__)
    frame, level = sys._getframe(1), 1
    while frame.f_back is not None and os.path.dirname(frame.f_code.co_filename) == folder:
        frame, level = frame.f_back, level + 1
    return level


def attempt(mollify: float | str, compute: Callable[[float], Result]) -> Result:
    """Return the result of `compute(slack)`. With "auto", the slack is the least one of a list for
    which it raises no NumericalError. Slack does not help against underflow, and a map that fails
    would be replaced by the map of another surface."""
    slack = mollification(mollify)
    if slack is not None:
        return compute(slack)
    try:
        return compute(0.0)
    except (UnderflowError, MapError):
        raise
    except NumericalError as error:
        first = error
    for slack in SLACKS:
        try:
            result = compute(slack)
        except NumericalError:
            continue
        warnings.warn(f"computed with mollify={slack}: {first}", MollificationWarning,
                      stacklevel=level_of_caller())
        return result
    raise first


def check_progress(progress: Any) -> Any:
    if progress is not None and not callable(progress):
        raise ArrayError(f"progress is {shortened(progress)}; it must be a function of a stage and a "
                         "number of steps, or None")
    return progress
