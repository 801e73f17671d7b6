# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""The exceptions of the package.

All are derived from `IntrinsicError`. If an element of the arrays is wrong, an attribute has its
index, counted from zero; otherwise the attribute is None. Messages name elements too.
"""

from __future__ import annotations


class IntrinsicError(Exception):
    """Is raised if something cannot be computed.

    Attributes
    ----------
    edge : tuple of int or None
        The two vertices of the edge that causes the error.
    vertex : int or None
        The vertex that causes the error.
    face : int or None
        The face that causes the error, a row of F.
    row : int or None
        The row of an array that causes the error.
    """

    edge: tuple[int, int] | None = None
    vertex: int | None = None
    face: int | None = None
    row: int | None = None


class InputError(IntrinsicError, ValueError):
    """Is raised if arrays do not describe a surface, or if a parameter has no meaning."""


class ArrayError(InputError, TypeError):
    """Is raised if an array has the wrong type or shape."""


class NotAManifoldError(InputError):
    """Is raised if an edge has more than two faces, or a vertex more than one fan of faces.

    Other reasons are that the orientations of the two faces of an edge differ, or that a component
    is not orientable, as a Moebius strip.
    """


class NegativeCurvatureError(InputError):
    """Is raised if a vertex has more than 360 degrees, so that no convex polyhedron has the
    surface."""


class NumericalError(IntrinsicError, ArithmeticError):
    """Is raised if rounding errors prevent a result."""


class UnderflowError(NumericalError):
    """Is raised if heat does not reach all of a surface; a greater time step factor helps."""


class MapError(NumericalError):
    """Is raised if a map does not keep its promises.

    Attributes
    ----------
    status : str
        The name of the status, as "not_converged".
    map : object
        The map as far as it has been found; None if it cannot be laid out.
    """

    status: str = ""
    map: object = None


class LimitError(IntrinsicError):
    """Is raised if numbers of crossings or flips are beyond a limit."""


class MissingPartError(IntrinsicError, OSError):
    """Is raised if this package was built without a part that a function needs."""


class AccuracyWarning(UserWarning):
    """Is given if a tenth of the distances by heat are estimated to be wrong by 10 % or more."""


class MollificationWarning(UserWarning):
    """Is given if edges have been lengthened, relative to their mean, to find a result."""
