# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Makes arrays that the compiled part accepts from the arguments of users, or names their error."""

from __future__ import annotations

import reprlib
from numbers import Integral, Real
from typing import Any, Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .errors import ArrayError, InputError

Floats = NDArray[np.float64]
Integers = NDArray[np.int64]
Complexes = NDArray[np.complex128]

_GREATEST_INDEX = 2**32 - 2  # of the compiled part


def array_of(values: ArrayLike | None, name: str) -> NDArray[Any]:
    """Return an array of any type and shape."""
    if values is None:
        raise ArrayError(f"{name} is None; give an array")
    if getattr(values, "format", None) is not None and hasattr(values, "todense"):
        raise ArrayError(f"{name} is a sparse matrix; give an array")
    if isinstance(values, np.ma.MaskedArray):
        raise ArrayError(f"{name} is a masked array; give a plain one")
    try:
        array = np.asarray(values)
    except Exception as error:  # of any type: other packages have their own reasons
        if "inhomogeneous" in str(error):
            raise ArrayError(f"{name} has rows of different lengths") from None
        raise ArrayError(f"{name} is not an array of numbers: {error}") from error
    return array


def _shaped(array: NDArray[Any], shape: tuple[int | None, ...], name: str) -> NDArray[Any]:
    """Return an array of this shape. An empty list has no rows of any size."""
    if array.shape == (0,) and shape[0] in (None, 0):
        return array.reshape([n or 0 for n in shape])
    if array.ndim == len(shape) and all(
        expected in (None, n) for n, expected in zip(array.shape, shape)
    ):
        return array
    letters = iter("nmk")
    text = ", ".join(next(letters) if n is None else str(n) for n in shape)
    raise ArrayError(f"{name} has the shape {array.shape}; it must be ({text}{',' * (len(shape) == 1)})")


def _first_row(is_bad: NDArray[np.bool_]) -> int:
    return int(np.argwhere(is_bad)[0][0])


def unchecked_floats(values: ArrayLike, shape: tuple[int | None, ...], name: str) -> Floats:
    """Return numbers of type float64, stored by rows; a copy only if it is needed."""
    array = array_of(values, name)
    if array.dtype.kind not in "fiu" and not (array.size == 0 and array.dtype == object):
        raise ArrayError(f"{name} has the type {array.dtype}; it must be real numbers")
    array = _shaped(array, shape, name)
    if array.dtype == np.float64:
        return np.require(array, None, ["C", "A"])
    with np.errstate(over="ignore"):
        return np.require(array, np.float64, ["C", "A"])


def floats(values: ArrayLike, shape: tuple[int | None, ...], name: str) -> Floats:
    """Return finite numbers of type float64, stored by rows; a copy only if it is needed."""
    result = unchecked_floats(values, shape, name)
    return _checked(np.isfinite(result), "finite", result, values, name)


def floats_or_infinity(values: ArrayLike, shape: tuple[int | None, ...], name: str) -> Floats:
    """Return numbers as `floats()` does, which may be infinite."""
    result = unchecked_floats(values, shape, name)
    return _checked(~np.isnan(result), "a number", result, values, name)


def _checked(is_good: Any, what: str, result: Floats, values: ArrayLike, name: str) -> Floats:
    if not is_good.all():
        row = _first_row(~is_good)
        error = InputError(f"row {row} of {name} is not {what}: {array_of(values, name)[row]}")
        error.row = row
        raise error
    return result


def unchecked_integers(
    values: ArrayLike | None, shape: tuple[int | None, ...], name: str
) -> tuple[NDArray[Any], Integers]:
    """Return an array as it is given, and its numbers of type int64, stored by rows. They may be
    wrong if they are out of range."""
    array = array_of(values, name)
    if array.size == 0 and array.dtype.kind == "f":  # from an empty list
        array = array.astype(np.int64)
    in_range = array
    if array.dtype.kind == "O" and all(isinstance(i, int) for i in array.flat):
        in_range = np.asarray(np.clip(array, -1, _GREATEST_INDEX + 1), np.int64)  # of huge numbers
    if in_range.dtype.kind not in "iu":
        hint = {"f": "; convert it by .astype(int)",
                "b": "; np.flatnonzero() returns the indices of a mask"}.get(array.dtype.kind, "")
        raise ArrayError(f"{name} has the type {array.dtype}; it must be integers{hint}")
    return (_shaped(array, shape, name),
            np.require(_shaped(in_range, shape, name), np.int64, ["C", "A"]))


def integers(
    values: ArrayLike | None, shape: tuple[int | None, ...], name: str, size: int | None, what: str
) -> Integers:
    """Return indices of type int64, stored by rows, from 0 to `size` - 1."""
    array, result = unchecked_integers(values, shape, name)
    limit = _GREATEST_INDEX + 1 if size is None else size
    unsigned = result.view(np.uint64)  # in which negative numbers are huge
    if array.size > 0 and unsigned.max() >= limit:
        row = _first_row(unsigned >= limit)
        known = f"the {what} are 0 to {limit - 1}" if limit > 0 else f"there are no {what}"
        error = InputError(f"row {row} of {name} is {_row_text(array[row])}, and {known}")
        error.row = row
        raise error
    return result


def vertices(values: Any, size: int, name: str, wanted: int | None = None) -> Integers:
    """Return indices of vertices, as many as are wanted; one may be a number."""
    if values is None:
        raise ArrayError(f"{name} must be given")
    return integers(np.atleast_1d(array_of(values, name)), (wanted,), name, size, "vertices")


def _scalar(value: Any, name: str, kind: str) -> Any:
    """Return a real number; neither a truth value nor a text is one."""
    scalar = value[()] if isinstance(value, np.ndarray) and value.ndim == 0 else value
    if isinstance(scalar, (bool, np.bool_)) or not isinstance(scalar, Real):
        raise ArrayError(f"{name} is {shortened(value)}; it must be {kind}")
    return scalar


class _Shortener(reprlib.Repr):
    def repr_int(self, x: int, level: int) -> str:
        try:
            return super().repr_int(x, level)
        except ValueError:  # Python writes no more than 4300 digits
            return f"an integer of {x.bit_length()} bits"


def shortened(value: Any) -> str:
    """Return the representation of a value in a message."""
    return _Shortener().repr(value)


def _row_text(row: Any) -> str:
    """Return an integer or a row of an array in a message."""
    if isinstance(row, int):
        return shortened(row)
    is_huge = isinstance(row, np.ndarray) and row.dtype == object
    return shortened(row.tolist()) if is_huge else str(row)


def number(
    value: Any, name: str, least: float, greatest: float = np.inf, *, is_open: bool = False
) -> float:
    """Return a finite number that is not less, or with `is_open` greater, than `least`."""
    scalar = _scalar(value, name, "a number")
    try:
        result = float(scalar)
    except OverflowError:  # of a huge integer
        result = np.inf
    if not (least <= result <= greatest) or not np.isfinite(result) or is_open and result == least:
        bounds = f", {'more than' if is_open else 'at least'} {least:g}" if least > -np.inf else ""
        bounds += f" and at most {greatest:g}" if np.isfinite(greatest) else ""
        raise InputError(f"{name} is {result}; it must be finite{bounds}")
    return result


def count(value: Any, name: str, least: int, greatest: int = _GREATEST_INDEX) -> int:
    """Return an integer between two others."""
    scalar = _scalar(value, name, "an integer")
    if not isinstance(scalar, Integral) and scalar % 1 != 0:  # NaN and infinity, too
        raise ArrayError(f"{name} is {shortened(value)}; it must be an integer")
    result = int(scalar)
    if not least <= result <= greatest:
        raise InputError(f"{name} is {shortened(result)}; it must be from {least} to {greatest}")
    return result


def flag(value: Any, name: str) -> bool:
    """Return a truth value. Texts and numbers are no truth values: "no" would be true."""
    if isinstance(value, (bool, np.bool_)):
        return bool(value)
    raise ArrayError(f"{name} is {shortened(value)}; it must be True or False")


def choice(value: Any, name: str, names: Sequence[str]) -> str:
    """Return one of several names."""
    if isinstance(value, str) and value in names:
        return value
    *others, last = map(repr, names)
    raise InputError(f"{name} is {shortened(value)}; it must be {', '.join(others)} or {last}")


def complexes(values: Any, shape: tuple[int | None, ...], name: str) -> Complexes:
    """Return finite complex numbers, stored by rows."""
    array = array_of(values, name)
    if array.dtype.kind not in "fiuc" and array.size > 0:
        raise ArrayError(f"{name} has the type {array.dtype}; it must be complex numbers")
    result = np.require(_shaped(array, shape, name), np.complex128, ["C", "A"])
    with np.errstate(over="ignore"):
        is_bad = ~np.isfinite(np.abs(result))
    if is_bad.any():
        row = _first_row(is_bad) if array.ndim > 0 else None
        what = name if row is None else f"row {row} of {name}"
        error = InputError(f"the length of {what} is not finite")
        error.row = row
        raise error
    return result


def points_on(
    points: Any, number_of_faces: int, name: str, barycentric: Any = None
) -> tuple[Integers, Floats]:
    """Return faces (k,) and barycentric coordinates (k, 3) of points; one point may be (3,).
    `points` is the pair of both, or the faces if `barycentric` is given."""
    try:
        faces, coordinates = points if barycentric is None else (points, barycentric)
    except (TypeError, ValueError):
        raise ArrayError(f"{name} must be a pair of faces and barycentric coordinates") from None
    rows = integers(np.atleast_1d(array_of(faces, name)), (None,), f"the faces of {name}",
                    number_of_faces, "faces")
    of_points = array_of(coordinates, name)
    weights = floats(of_points if of_points.size == 0 else np.atleast_2d(of_points), (len(rows), 3),
                     f"the barycentric coordinates of {name}")
    is_bad = (weights < 0).any(axis=1) | (np.abs(weights.sum(axis=1) - 1) > 1e-6)
    if is_bad.any():
        row = _first_row(is_bad)
        error = InputError(f"row {row} of the barycentric coordinates of {name} is {weights[row]}; "
                           "they must not be negative, and their sum must be one")
        error.row = row
        raise error
    return rows, weights


def sparse(arrays: tuple[Any, Any, Any, Any], by_rows: bool = False) -> Any:
    """Return the sparse matrix of arrays of the compiled part."""
    try:
        import scipy.sparse
    except ImportError:
        raise ImportError("matrices need scipy; install it") from None
    values, inner, starts, shape = arrays
    kind = scipy.sparse.csr_matrix if by_rows else scipy.sparse.csc_matrix
    return kind((values, inner, starts), shape=shape)
