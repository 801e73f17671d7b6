# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""All parameters of all functions that are numbers, truth values or names, taken from signatures: a
value that has no meaning raises an exception with the parameter's name, and every other value gives
a result without NaN."""

import dataclasses
import inspect
import unittest
import warnings
from fractions import Fraction

import numpy as np

import intrinsic
import support
from intrinsic import IntrinsicError

V, F = intrinsic.shapes.icosphere(1)
VG, FG = intrinsic.shapes.grid(4, 4)
VH, FH = support.two_handles()
V8, F8 = intrinsic.shapes.cube()


def triangulation():
    T = intrinsic.Triangulation(V, F)
    T.delaunay()
    return T


# Calls with valid arguments, to which the tested one is added.
CALLS = {
    "Triangulation": lambda **k: intrinsic.Triangulation(V, F, **k).lengths,
    "Triangulation.delaunay": lambda **k: intrinsic.Triangulation(V, F).delaunay(**k),
    "Triangulation.weighted_delaunay":
        lambda **k: intrinsic.Triangulation(V, F).weighted_delaunay(V[:, 0] / 10, **k),
    "Triangulation.refine": lambda **k: intrinsic.Triangulation(VG, FG).refine(
        **{"min_angle": 20, "max_insertions": 100} | k),
    "Triangulation.constrain": lambda **k: triangulation().constrain([0], **k),
    "Triangulation.trace": lambda **k: triangulation().trace(**k),
    "Triangulation.transfer": lambda **k: triangulation().transfer(V[:, 0], **k),
    "DistanceSolver": lambda **k: intrinsic.DistanceSolver(V, F, **k).distance(0),
    "DistanceSolver.from_each": lambda **k: intrinsic.DistanceSolver(V, F).from_each([0, 1], **k),
    "all_pairs": lambda **k: intrinsic.all_pairs(V, F, **k),
    "connection_laplacian": lambda **k: intrinsic.connection_laplacian(V, F, **k),
    "convex_polyhedron": lambda **k: intrinsic.convex_polyhedron(V8, F8, **k),
    "distance": lambda **k: intrinsic.distance(V, F, 0, **k),
    "divergence": lambda **k: intrinsic.divergence(V, F, **k),
    "exp_map": lambda **k: intrinsic.exp_map(V, F, 0, **{"vector": 1} | k),
    "flatten": lambda **k: intrinsic.flatten(VG, FG, **k).subdivision,
    "geodesic": lambda **k: intrinsic.geodesic(V, F, [0, 9, 20], **k),
    "geodesics": lambda **k: intrinsic.geodesics(V, F, [[0, 9]], **k),
    "gradient": lambda **k: intrinsic.gradient(V, F, **k),
    "homology_loops": lambda **k: intrinsic.homology_loops(V, F, **k),
    "info": lambda **k: intrinsic.info(V, F, **k),
    "laplacian": lambda **k: intrinsic.laplacian(V, F, **k),
    "level_set": lambda **k: intrinsic.level_set(V, F, V[:, 2], **k),
    "log_map": lambda **k: intrinsic.log_map(V, F, 0, **k),
    "mass": lambda **k: intrinsic.mass(V, F, **k),
    "path": lambda **k: intrinsic.path(V, F, 0, 9, **k),
    "repair": lambda **k: intrinsic.repair(V, F, **k),
    "show": lambda **k: intrinsic.show(V, F, **{"open": False} | k).html and None,
    "signed_distance": lambda **k: intrinsic.signed_distance(V, F, [*F[0], F[0, 0]], **k),
    "simplify": lambda **k: intrinsic.simplify(
        V, F, **{"max_insertions": 100} | ({} if {"ratio", "max_cost"} & k.keys() else {"n": 20}) | k
    ).prolongation,
    "soup_distance": lambda **k: intrinsic.soup_distance(V, **{"sources": 0} | k),
    "soup_operators": lambda **k: intrinsic.soup_operators(V, **k),
    "to_hyperbolic": lambda **k: intrinsic.to_hyperbolic(VH, FH, **k).subdivision,
    "to_sphere": lambda **k: intrinsic.to_sphere(V, F, **k).subdivision,
    "transport": lambda **k: intrinsic.transport(V, F, [0], [1], **k),
    "uniformize": lambda **k: intrinsic.uniformize(V, F, **k).map.subdivision,
    "vertex_point": lambda **k: intrinsic.vertex_point(F, **k),
    "shapes.cube": lambda **k: intrinsic.shapes.cube(**k),
    "shapes.icosphere": lambda **k: intrinsic.shapes.icosphere(**k),
    "shapes.torus": lambda **k: intrinsic.shapes.torus(**{"around": 9} | k),
    "shapes.grid": lambda **k: intrinsic.shapes.grid(**{"rows": 3} | k),
    "shapes.folded_sphere": lambda **k: intrinsic.shapes.folded_sphere(**{"level": 1} | k),
}

SEQUENCES = {("simplify", "n")}  # take lists of numbers, too

TYPES = {
    "float": [True, np.True_, "1", b"1", 1j, [1.0], {}, object(), np.ones(1), np.array("1"), None],
    "int": [True, np.False_, "1", b"1", 1.5, np.nan, np.inf, [1], {}, object(), np.array([2]), None],
    "bool": ["no", "", 2, 0.0, np.nan, [], [True], object(), None],
    "str": [1, True, b"auto", "", "AUTO", ["auto"], np.nan, object(), None],
    "complex": ["1", b"1", True, [1, 2], [[1]], {}, object(), np.nan, complex(0, np.inf), None],
}
NUMBERS = {
    "float": [np.nan, np.inf, -np.inf, -1.0, -5e-324, 0, 5e-324, 1e-300, 1e-9, 0.5, 1, 2, 59.0, 61.0,
              1e9, 1e13, 1e300, 10**400, np.float32(0.5), Fraction(1, 2), np.array(0.5)],
    "int": [-(10**30), -1, 0, 1, 2, 3, 4, 5.0, np.uint8(6), np.array(7), 10**30, 2**32, 2**64],
    "bool": [True, False, np.True_],
    "str": [],
    "complex": [0, 0.5, 1j, np.complex64(1 + 1j), np.array(0.25), 5e-324, 1e308 + 1.7e308j],
}
# Numbers without a bound, of which tests have no great ones: results would not fit into memory.
TOO_MANY = {"shapes.icosphere": 12, "shapes.torus": 1000, "shapes.grid": 1000,
            "shapes.folded_sphere": 12}


def functions():
    """Yield names and functions of the interface."""
    for module, prefix in ((intrinsic, ""), (intrinsic.shapes, "shapes.")):
        names = intrinsic.__all__ if not prefix else [
            n for n, f in vars(module).items() if inspect.isfunction(f) and f.__module__ == module.__name__]
        for name in names:
            thing = getattr(module, name)
            if inspect.isfunction(thing) and not name.startswith("_"):
                yield prefix + name, thing
    for name in ("Triangulation", "DistanceSolver"):
        thing = getattr(intrinsic, name)
        yield name, thing.__init__
        for member, value in vars(thing).items():
            if inspect.isfunction(value) and not member.startswith("_") and member != "save":
                yield f"{name}.{member}", value


def kinds(annotation):
    """Return the kinds of an annotation, and None if that is allowed."""
    parts = [p.strip() for p in str(annotation).split("|")]
    return [k for k in TYPES if k in parts], "None" in parts


def parameters():
    """Yield a function, a parameter, its kinds, and whether it may be None."""
    for name, function in functions():
        for parameter in inspect.signature(function).parameters.values():
            found, may_be_none = kinds(parameter.annotation)
            if found:
                yield name, parameter.name, found, may_be_none


def numbers_in(result):
    """Yield all arrays of numbers of a result."""
    if isinstance(result, np.ndarray):
        if result.dtype.kind in "fc":
            yield result
    elif hasattr(result, "nnz"):
        yield result.data
    elif isinstance(result, (float, complex)):
        yield np.array(result)
    elif dataclasses.is_dataclass(result):
        for field in dataclasses.fields(result):
            yield from numbers_in(getattr(result, field.name))
    elif isinstance(result, (list, tuple)):
        for part in result:
            yield from numbers_in(part)


class Arguments(unittest.TestCase):
    def test_all_functions_are_tested(self):
        for name, *_ in parameters():
            self.assertIn(name, CALLS)

    def refused(self, name, parameter, value):
        """Return whether a call raises an exception, which must name the parameter."""
        try:
            result = CALLS[name](**{parameter: value})
        except IntrinsicError as error:
            words = {parameter, parameter.replace("_", " ")}
            self.assertTrue(any(w in str(error) for w in words), f"{error}")
            return True
        for numbers in numbers_in(result):
            self.assertFalse(np.isnan(numbers).any())
        return False

    def test_types(self):
        """Objects of another type are refused."""
        count = 0
        for name, parameter, found, may_be_none in parameters():
            for value in TYPES[found[0]]:
                is_taken = (value is None and may_be_none) or (
                    (name, parameter) in SEQUENCES and np.ndim(value) == 1) or (
                    value is not None and isinstance(value, str) and "str" in found and value == "auto")
                if is_taken:
                    continue
                with self.subTest(name=name, parameter=parameter, value=repr(value)):
                    count += 1
                    self.assertTrue(self.refused(name, parameter, value))
        self.assertGreater(count, 700)

    def test_numbers(self):
        """Numbers out of range are refused, other ones give results."""
        counts = {True: 0, False: 0}
        for name, parameter, found, _ in parameters():
            for value in (v for kind in found for v in NUMBERS[kind]):
                if name in TOO_MANY and TOO_MANY[name] < value < 2**62:
                    continue
                with self.subTest(name=name, parameter=parameter, value=repr(value)):
                    with warnings.catch_warnings():
                        warnings.simplefilter("error", RuntimeWarning)
                        counts[self.refused(name, parameter, value)] += 1
        self.assertGreater(min(counts.values()), 200)

    def test_vectors(self):
        for size in (1e-300, 1e-200, 1e200, 1e308):
            lengths = abs(intrinsic.transport(V, F, [0], [size])) / size
            self.assertLess(abs(lengths - 1).max(), 0.5)
            self.assertEqual(lengths[0], 1)
        for bad in (True, "1", None, np.nan, 1.7e308 + 1.7e308j, [], [1, 2]):
            with self.assertRaisesRegex(IntrinsicError, "vectors"):
                intrinsic.transport(V, F, [0], bad)

    def test_neighbors(self):
        """More neighbors than points are all points."""
        points = np.random.default_rng(1).standard_normal((40, 3))
        few, many = (intrinsic.soup_operators(points, neighbors=n) for n in (39, 10**9))
        self.assertEqual((few.laplacian != many.laplacian).nnz, 0)


if __name__ == "__main__":
    unittest.main()
