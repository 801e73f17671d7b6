# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""What arrays are taken, and what is said about others: never a crash."""

import unittest
import warnings
from types import SimpleNamespace

import numpy as np

import intrinsic
from intrinsic import ArrayError, InputError, IntrinsicError, NotAManifoldError

V, F = intrinsic.shapes.icosphere(1)


class TakenArrays(unittest.TestCase):
    def setUp(self):
        T = intrinsic.Triangulation(V, F)
        T.delaunay()
        self.lengths = T.lengths

    def check(self, V, F):
        T = intrinsic.Triangulation(V, F)
        T.delaunay()
        np.testing.assert_array_equal(T.lengths, self.lengths)
        np.testing.assert_array_equal(T.input_F, np.asarray(F, int))

    def test_integer_types(self):
        for kind in "bBhHiIlLqQ":
            self.check(V, F.astype(kind))
        for kind in (">i4", ">i8", "<u2", ">u2"):
            self.check(V, F.astype(kind))

    def test_layouts(self):
        self.check(np.asfortranarray(V), np.asfortranarray(F))
        wide_V, wide_F = np.zeros((len(V), 7)), np.zeros((2 * len(F), 5), int)
        wide_V[:, 1:6:2], wide_F[::2, 1:4] = V, F
        self.check(wide_V[:, 1:6:2], wide_F[::2, 1:4])
        self.check(V[::-1][::-1], F[::-1][::-1])

    def test_read_only_and_byte_order(self):
        fixed_V, fixed_F = V.copy(), F.copy()
        fixed_V.flags.writeable = fixed_F.flags.writeable = False
        self.check(fixed_V, fixed_F)
        self.check(V.astype(">f8"), F.astype(">i4"))
        self.check(np.frombuffer(V.tobytes()).reshape(-1, 3), F)

    def test_lists_and_other_floats(self):
        self.check(V.tolist(), F.tolist())
        self.check(V.astype(np.longdouble), F)
        T = intrinsic.Triangulation(V.astype(np.float32), F)
        wide = intrinsic.Triangulation(V.astype(np.float32).astype(float), F)
        np.testing.assert_array_equal(T.lengths, wide.lengths)

    def test_inputs_are_left_alone(self):
        before_V, before_F = V.copy(), F.copy()
        intrinsic.flatten(V, F)
        intrinsic.simplify(V, F, 10)
        np.testing.assert_array_equal(V, before_V)
        np.testing.assert_array_equal(F, before_F)

    def test_later_changes_of_inputs_do_not_matter(self):
        mine = V.copy()
        T = intrinsic.Triangulation(mine, F)
        mine[:] = np.nan
        T.delaunay()
        np.testing.assert_array_equal(T.lengths, self.lengths)

    def test_results_live_longer_than_their_objects(self):
        lengths = intrinsic.Triangulation(V, F).lengths
        total = lengths.sum()
        [intrinsic.Triangulation(V, F) for _ in range(20)]
        self.assertEqual(lengths.sum(), total)


def bipyramid(n):
    """Both apices come first and have many edges."""
    angles = 2 * np.pi * np.arange(n) / n
    rim = np.stack([np.cos(angles), np.sin(angles), np.zeros(n)], axis=1)
    i, j = 2 + np.arange(n), 2 + (np.arange(n) + 1) % n
    faces = [np.stack([np.zeros(n, int), i, j], axis=1), np.stack([j, i, np.ones(n, int)], axis=1)]
    return np.vstack([[[0, 0, 1], [0, 0, -2]], rim]), np.concatenate(faces)


def damaged(F, n, random):
    """Return the faces with a few random changes, each of which may leave a surface."""
    for _ in range(random.integers(0, 5)):
        i, kind = random.integers(len(F)), random.integers(5)
        if kind == 0:
            F = F[random.random(len(F)) < 0.9] if len(F) > 3 else F
        elif kind == 1:
            F = np.concatenate([F[:i], F[i:i + 1, ::-1], F[i + 1:]])
        elif kind == 2:
            F = np.concatenate([F, np.roll(F[i:i + 1], 1, axis=1)])
        elif kind == 3:
            F = np.where(F == random.integers(n), random.integers(n), F)
        else:
            F = np.concatenate([F, random.permutation(n)[None, :3]])
    return random.permutation(np.array([np.roll(f, k) for f, k in
                                        zip(F, random.integers(0, 3, len(F)))]))


def is_surface(F):
    """By brute force: no side twice in one direction, and one fan at each vertex."""
    sides = [(f[k], f[(k + 1) % 3]) for f in F for k in range(3)]
    if len(set(sides)) < len(sides) or any(a == b for a, b in sides):
        return False
    for v in np.unique(F):
        fans = []
        for f in F[(F == v).any(axis=1)]:
            rim = set(f) - {v}
            fans = [fan for fan in fans if not fan & rim] + [
                rim.union(*(fan for fan in fans if fan & rim))]
        if len(fans) > 1:
            return False
    return True


class Surfaces(unittest.TestCase):
    def test_against_brute_force(self):
        random = np.random.default_rng(6)
        count = {True: 0, False: 0}
        for _ in range(300):
            for V, F in (intrinsic.shapes.icosphere(0), bipyramid(12)):
                order = random.permutation(len(V))
                F = damaged(order[F], len(V), random)
                try:
                    T = intrinsic.Triangulation(V[np.argsort(order)], F)
                    is_taken = True
                    np.testing.assert_array_equal(T.input_F, F)
                except InputError:
                    is_taken = False
                self.assertEqual(is_taken, is_surface(F), F.tolist())
                count[is_taken] += 1
        self.assertGreater(min(count.values()), 100)


class Elements(unittest.TestCase):
    """Errors name the element."""

    def error(self, V, F, kind=InputError, **lengths):
        with self.assertRaises(kind) as caught:
            intrinsic.Triangulation(V, F, **lengths)
        return caught.exception

    def test_nan(self):
        bad = V.copy()
        bad[17, 1] = np.nan
        self.assertEqual(self.error(bad, F).row, 17)
        bad[17, 1] = -np.inf
        self.assertEqual(self.error(bad, F).row, 17)

    def test_index(self):
        for index in (len(V), -1, 2**31, 2**40, -(2**62)):
            bad = F.copy()
            bad[9, 2] = index
            error = self.error(V, bad)
            self.assertEqual(error.face, 9)
            self.assertIn("row 9 of F", str(error))
        bad = F.astype(np.uint64)
        bad[3, 0] = 2**64 - 1
        self.assertEqual(self.error(V, bad).face, 3)
        bad = F.tolist()
        bad[5][1] = 10**30
        self.assertEqual(self.error(V, bad).face, 5)

    def test_edge_with_three_faces(self):
        bad_V = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [0, -1, 0]]
        error = self.error(bad_V, [[0, 1, 2], [1, 0, 3], [0, 1, 4]], NotAManifoldError)
        self.assertEqual(sorted(error.edge), [0, 1])

    def test_edge_with_three_faces_and_one_fan_at_each_vertex(self):
        V = [[0, 0, 0], [1, 0, 0], [0, -1, 0], [0, 1, 0], [0, 0, 1], [1, 1, 1]]
        F = [[0, 1, 2], [0, 1, 3], [0, 3, 4], [0, 4, 1], [3, 1, 5], [1, 4, 5]]
        error = self.error(V, F, NotAManifoldError)
        self.assertEqual(sorted(error.edge), [0, 1])

    def test_orientation(self):
        error = self.error([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, -1, 0]],
                           [[0, 1, 2], [0, 1, 3]], NotAManifoldError)
        self.assertEqual(sorted(error.edge), [0, 1])

    def test_vertex_with_two_fans(self):
        error = self.error([[0, 0, 0], [1, 0, 0], [0, 1, 0], [-1, 0, 0], [0, -1, 0]],
                           [[0, 1, 2], [0, 3, 4]], NotAManifoldError)
        self.assertEqual(error.vertex, 0)

    def test_empty(self):
        for bad_V, bad_F in ((V, []), (V, F[:0]), (V[:0], F[:0]), ([], [])):
            self.error(bad_V, bad_F)

    def test_repeated_vertex(self):
        self.assertEqual(self.error(V, [*F[:4].tolist(), [1, 1, 2]]).face, 4)

    def test_equal_positions(self):
        bad = V.copy()
        bad[F[7, 0]] = bad[F[7, 1]]
        self.assertEqual(set(self.error(bad, F).edge), {F[7, 0], F[7, 1]})

    def test_lengths_of_one_edge_that_differ(self):
        lengths = np.ones((2, 3))
        lengths[1, 2] = 1.5
        error = self.error(None, [[0, 1, 2], [1, 0, 3]], lengths=lengths)
        self.assertEqual(sorted(error.edge), [0, 1])
        lengths[1, 2] = np.nextafter(1, 2)
        self.assertIn("1 and 1.0000000000000002",
                      str(self.error(None, [[0, 1, 2], [1, 0, 3]], lengths=lengths)))

    def test_triangle_inequality(self):
        error = self.error(None, [[0, 1, 2]], lengths=[[1, 1, 3]])
        self.assertEqual(error.face, 0)
        self.assertEqual(sorted(self.error(None, [[0, 1, 2]], lengths=[[1, 1, -1]]).edge), [0, 1])

    def test_shapes_and_types(self):
        for bad_V, bad_F in [(V[:, :2], F), (V.T, F), (V, F.T), (V, F[0]), (V, F[None]),
                             (V.ravel(), F), (V, F.astype(float)), (V + 1j, F), (V.astype(str), F),
                             (V, F.astype(bool)), (None, F), (V, "F"), ("V", F), (V, object()),
                             (V, [[0, 1], [1, 2, 3]]), (3, 4), (V, {}), (np.ma.array(V), F), (V, np.zeros((0, 2), int))]:
            error = self.error(bad_V, bad_F, ArrayError)
            self.assertGreater(len(str(error)), 10)

    def test_masks(self):
        # .astype(int) of a mask would be vertices 0 and 1.
        mask = np.arange(len(V)) == 3
        with self.assertRaisesRegex(ArrayError, "flatnonzero"):
            intrinsic.distance(V, F, mask)

    def test_barycentric_coordinates(self):
        with self.assertRaisesRegex(InputError, "sum must be one"):
            intrinsic.distance(V, F, ([0], [[0.5, 0.5, 0.5]]))


def mutations():
    """Generate arrays that are wrong, or odd, in one or two ways."""
    random = np.random.default_rng(43)

    @np.errstate(all="ignore")
    def positions(V):
        kind = random.integers(0, 14)
        i, k = random.integers(len(V)), random.integers(3)
        if kind < 4:
            V[i, k] = [np.nan, np.inf, -np.inf, 1e308][kind]
        elif kind < 8:
            V[i] = [V[0], 1e200, 1e-320, 0][kind - 4]
        return {8: V[:0], 9: V[:i], 10: V[:, :k], 11: V.astype(np.float32) * np.float32(1e38),
                12: V.astype("U8" if k else object), 13: V.astype(">f4")}.get(kind, V)

    def faces(F):
        kind = random.integers(0, 16)
        i, k = random.integers(len(F)), random.integers(3)
        if kind < 6:
            F[i, k] = [-1, 10**6, 2**32, 2**63 - 1, F[i, (k + 1) % 3], 0][kind]
        elif kind < 9:
            F[i] = [F[0], F[i, ::-1], F[i, 0]][kind - 6]
        return {9: F[:0], 10: F[:i], 11: F[:, :k], 12: F.astype(float), 13: np.vstack([F, F[i:]]),
                14: F.astype(np.uint64) - np.uint64(1), 15: F.reshape(-1)[: 3 * i]}.get(kind, F)

    @np.errstate(all="ignore")
    def layout(array):
        kind = random.integers(0, 9)
        if kind == 0:
            array = np.asfortranarray(array)
        elif kind == 1:
            array = np.repeat(array, 2, axis=0)[::2]
        elif kind == 2:
            array = array[::-1].copy()[::-1]
        elif kind == 3:
            array = array.astype(array.dtype.newbyteorder())
        elif kind == 4:
            array = array.astype({"f": np.float32, "i": np.int16}.get(array.dtype.kind, array.dtype))
        elif kind == 5:
            array = array[..., None] if random.integers(4) == 0 else array.copy()
            array.flags.writeable = False
        elif kind == 6:
            array = np.frombuffer(b"x" + array.tobytes(), array.dtype, offset=1).reshape(
                array.shape) if array.dtype != object else array  # not aligned
        return array

    for _ in range(500):
        which = random.integers(3)
        new_V = positions(V.copy()) if which != 0 else V
        new_F = faces(F.copy()) if which != 1 else F
        yield layout(new_V), layout(new_F)


def soups():
    """Generate faces that are a surface, or almost: some are removed, turned, glued or added."""
    random = np.random.default_rng(7)
    shapes = [intrinsic.shapes.cube()[1], intrinsic.shapes.icosphere(0)[1],
              intrinsic.shapes.torus(3, 3)[1], intrinsic.shapes.grid(2, 2)[1],
              np.array([[0, 1, 2], [0, 2, 3], [0, 3, 1], [1, 3, 2]])]
    for i in range(3000):
        F = shapes[i % len(shapes)]
        F = F[random.random(len(F)) < random.choice([0.3, 0.7, 0.95, 1])]
        n = int(F.max(initial=0)) + 1
        for _ in range(random.integers(0, 3)):
            kind = random.integers(4)
            if kind == 0 and len(F) > 0:
                F[random.integers(len(F))] = F[random.integers(len(F)), ::-1]
            elif kind == 1:
                F = np.vstack([F, random.permutation(n)[:3]]) if n > 2 else F
            elif kind == 2:
                F = np.where(F == random.integers(n), random.integers(n), F)
            else:
                F = np.vstack([F, F[: random.integers(3)]])
        yield random.standard_normal((n, 3)), F


class Diagnosis(unittest.TestCase):
    def test_diagnosis(self):
        """What is a surface is decided in two ways, in short and by the diagnosis."""
        counts = [0, 0]
        for V, F in soups():
            is_valid = len(F) > 0 and intrinsic.info(V, F).is_valid
            counts[is_valid] += 1
            if is_valid:
                np.testing.assert_array_equal(intrinsic.Triangulation(V, F).F, F)
            else:
                with self.assertRaises(InputError):
                    intrinsic.Triangulation(V, F)
        self.assertGreater(min(counts), 500)


class Malformed(unittest.TestCase):
    def test_all_functions(self):
        functions = [
            lambda V, F: intrinsic.Triangulation(V, F).delaunay(),
            lambda V, F: intrinsic.Triangulation(V, F).refine(20, max_insertions=50),
            lambda V, F: intrinsic.Triangulation(None, F, lengths=V),
            intrinsic.laplacian,
            intrinsic.connection_laplacian,
            lambda V, F: intrinsic.distance(V, F, 0),
            lambda V, F: intrinsic.DistanceSolver(V, F).distance([0, 1]),
            lambda V, F: intrinsic.signed_distance(V, F, [0, 1]),
            lambda V, F: intrinsic.path(V, F, 0, 5),
            lambda V, F: intrinsic.geodesic(V, F, [0, 1, 2], loop=True),
            lambda V, F: intrinsic.geodesics(V, F, [[0, 5]]),
            lambda V, F: intrinsic.log_map(V, F, 0),
            lambda V, F: intrinsic.exp_map(V, F, 0, 1),
            lambda V, F: intrinsic.transport(V, F, [0], [1]),
            lambda V, F: intrinsic.all_pairs(V, F, coarse=9),
            intrinsic.flatten,
            intrinsic.to_sphere,
            intrinsic.to_hyperbolic,
            intrinsic.uniformize,
            lambda V, F: intrinsic.simplify(V, F, 5),
            intrinsic.info,
            intrinsic.repair,
            intrinsic.soup_operators,
            intrinsic.convex_polyhedron,
        ]
        refused = 0
        for i, (V, F) in enumerate(mutations()):
            for k, function in enumerate(functions):
                try:
                    with warnings.catch_warnings():
                        warnings.simplefilter("ignore", intrinsic.MollificationWarning)
                        function(V, F)
                except IntrinsicError as error:
                    refused += 1
                    self.assertGreater(len(str(error)), 10, f"input {i}, function {k}")
                except Exception as error:  # anything else is a bug
                    self.fail(f"input {i}, function {k}: {type(error).__name__}: {error}")
        self.assertGreater(refused, 250 * len(functions))

    def test_parameters(self):
        for call in [
            lambda: intrinsic.distance(V, F),
            lambda: intrinsic.distance(V, F, 42),
            lambda: intrinsic.distance(V, F, -1),
            lambda: intrinsic.distance(V, F, []),
            lambda: intrinsic.distance(V, F, 0.5),
            lambda: intrinsic.distance(V, F, 0, "fast"),
            lambda: intrinsic.distance(V, F, ([0], [[0.5, 0.5, 0.5]])),
            lambda: intrinsic.distance(V, F, ([80], [[1, 0, 0]])),
            lambda: intrinsic.distance(V, F, ([0], [[2, -1, 0]])),
            lambda: intrinsic.distance(V, F, ([0, 1], [[1, 0, 0]])),
            lambda: intrinsic.distance(V, F, 0, time_step_factor=0),
            lambda: intrinsic.distance(V, F, 0, mollify=-1),
            lambda: intrinsic.distance(V, F, 0, mollify="some"),
            lambda: intrinsic.path(V, F, 0),
            lambda: intrinsic.path(V, F, 0, [1, 2]),
            lambda: intrinsic.signed_distance(V, F, [0]),
            lambda: intrinsic.signed_distance(V, F, []),
            lambda: intrinsic.signed_distance(V, F, [0, 3]),
            lambda: intrinsic.geodesic(V, F, [0]),
            lambda: intrinsic.geodesic(V, F, [0, 99]),
            lambda: intrinsic.geodesic(V, F),
            lambda: intrinsic.geodesics(V, F, [[0, 99]]),
            lambda: intrinsic.geodesics(V, F, [0, 1]),
            lambda: intrinsic.geodesics(V, F),
            lambda: intrinsic.transport(V, F, [0], []),
            lambda: intrinsic.transport(V, F, [0], ["up"]),
            lambda: intrinsic.transport(V, F, [0], [np.nan]),
            lambda: intrinsic.log_map(V, F, 100),
            lambda: intrinsic.exp_map(V, F, 0, np.nan),
            lambda: intrinsic.exp_map(V, F, 0, [1, 2]),
            lambda: intrinsic.Triangulation(V, F).refine(-1),
            lambda: intrinsic.Triangulation(V, F).refine(np.nan),
            lambda: intrinsic.Triangulation(V, F).refine(25, max_insertions=-1),
            lambda: intrinsic.Triangulation(V, F).trace([500]),
            lambda: intrinsic.Triangulation(V, F).trace(of="output"),
            lambda: intrinsic.Triangulation(V, F).transfer(np.zeros(3)),
            lambda: intrinsic.Triangulation(V, F).delaunay(progress=3),
            lambda: intrinsic.flatten(V, F, boundary="round"),
            lambda: intrinsic.flatten(V, F, boundary="disk"),
            lambda: intrinsic.flatten(V, F, boundary="straight"),
            lambda: intrinsic.flatten(V, F, cones="many"),
            lambda: intrinsic.flatten(V, F, cones={99: 1.0}),
            lambda: intrinsic.flatten(V, F, cones={0: np.nan}),
            lambda: intrinsic.flatten(V, F, cones={0: 1.0}),
            lambda: intrinsic.simplify(V, F),
            lambda: intrinsic.simplify(V, F, 0),
            lambda: intrinsic.simplify(V, F, 2.5),
            lambda: intrinsic.simplify(V, F, 5, ratio=0.5),
            lambda: intrinsic.simplify(V, F, ratio=2),
            lambda: intrinsic.soup_operators(V, np.zeros((0, 3), int), neighbors=1),
            lambda: intrinsic.repair(V, F, weld=-1),
            lambda: intrinsic.laplacian(V, F, lengths=np.ones((80, 3))),
            lambda: intrinsic.laplacian(intrinsic.Triangulation(V, F), F),
        ]:
            with self.assertRaises(IntrinsicError):
                call()

    def test_missing_arguments(self):
        for name, call in {
            "source": lambda: intrinsic.path(V, F),
            "target": lambda: intrinsic.path(V, F, 0),
            "vertices": lambda: intrinsic.geodesic(V, F),
            "pairs": lambda: intrinsic.geodesics(V, F),
        }.items():
            with self.assertRaisesRegex(ArrayError, f"{name} (must be given|is None)"):
                call()

    def test_arrays_of_other_packages_that_raise(self):
        """As tensors do that record gradients."""
        class Tensor:
            def __array__(self, *arguments, **keywords):
                raise RuntimeError("no numbers here")

        for name, call in {
            "V": lambda t: intrinsic.laplacian(t, F),
            "F": lambda t: intrinsic.laplacian(SimpleNamespace(points=V, faces=t)),
            "curve": lambda t: intrinsic.signed_distance(V, F, [t]),
            "edges": lambda t: intrinsic.Triangulation(V, F).trace(t),
            "vector": lambda t: intrinsic.exp_map(V, F, 0, t),
            "vectors": lambda t: intrinsic.transport(V, F, [0], t),
            "what": lambda t: intrinsic.Triangulation(V, F).transfer(t),
            "heat": lambda t: intrinsic.show(intrinsic.Triangulation(V, F), open=False, heat=t),
        }.items():
            if name == "heat" and not intrinsic._core.has_pages:
                continue
            with self.assertRaisesRegex(ArrayError, f"^{name} is not an array.*no numbers here"):
                call(Tensor())

    def test_rows_of_different_lengths(self):
        rows = [[1, 2], [3]]
        for name, call in {
            "F": lambda: intrinsic.laplacian(SimpleNamespace(points=V, cells=[("triangle", rows)])),
            "edges": lambda: intrinsic.Triangulation(V, F).trace(rows),
            "vectors": lambda: intrinsic.transport(V, F, [0, 1], rows),
            "curve": lambda: intrinsic.signed_distance(V, F, [rows]),
        }.items():
            with self.assertRaisesRegex(ArrayError, f"^{name} has rows of different lengths"):
                call()

    def test_names_and_rows(self):
        T = intrinsic.Triangulation(V, F)
        values = np.zeros(len(V))
        values[7] = np.nan
        with self.assertRaisesRegex(InputError, "row 7 of what"):
            T.transfer(values)
        with self.assertRaisesRegex(InputError, "faces of what"):
            T.transfer(([80], [[1, 0, 0]]))
        with self.assertRaisesRegex(InputError, "row 1 of vectors") as caught:
            intrinsic.transport(V, F, [0, 1], [1, np.inf])
        self.assertEqual(caught.exception.row, 1)

    def test_every_part_of_a_curve_has_two_points(self):
        path = [*F[0], F[0, 0]]
        for curve, message in [([path, []], "part 1 of curve"), ([[3], path], "part 0 of curve"),
                               ([[0], [5]], "part 0 of curve"), ([3], "curve has fewer")]:
            with self.assertRaisesRegex(InputError, message):
                intrinsic.signed_distance(V, F, curve)

    def test_empty_lists_have_no_rows(self):
        T = intrinsic.Triangulation(V, F)
        self.assertEqual(intrinsic.geodesics(V, F, []), [])
        self.assertEqual(intrinsic.geodesics(V, F, np.zeros(0)), [])
        for faces, coordinates in (([], []), ([], np.zeros((0, 3)))):
            self.assertEqual(T.positions((faces, coordinates)).shape, (0, 3))
            self.assertEqual(T.transfer((faces, coordinates))[1].shape, (0, 3))
        self.assertEqual(intrinsic.convex_polyhedron(V, F, glue=[]).kind,
                         intrinsic.convex_polyhedron(V, F).kind)
        for bad in ([0], [[]], np.zeros((0, 3), int)):
            with self.assertRaisesRegex(ArrayError, "pairs has the shape"):
                intrinsic.geodesics(V, F, bad)

    def test_indices_without_positions(self):
        """Memory is proportional to the arrays, not to an index."""
        lengths = intrinsic.Triangulation(V, F).face_lengths
        for index in (F.size, 10**6, 2**32 - 2):
            bad = np.where(np.arange(len(F))[:, None] == [[5, -1, -1]], index, F)
            for call in (lambda: intrinsic.Triangulation(None, bad, lengths=lengths),
                         lambda: intrinsic.pack_circles(None, bad)):
                with self.assertRaisesRegex(InputError, "row 5 of F") as caught:
                    call()
                self.assertEqual(caught.exception.face, 5)

    def test_numbers_beyond_the_range(self):
        for F2 in (10**30, -(10**30), [[10**30, 1, 2]]):
            with self.assertRaisesRegex(InputError, "F has the shape|row 0 of F"):
                intrinsic.Triangulation(V, F2)
        with self.assertRaisesRegex(InputError, "from 1 to 4294967294"):
            intrinsic.simplify(V, F, 10**30)
        for vertices, row, text in [(2**64, 0, "18446744073709551616,"), ([3, -(2**70)], 1, str(-2**70)),
                                    ([1, 10**5000], 1, "an integer of 16610 bits")]:
            with self.assertRaisesRegex(InputError, f"row {row} of sources is {text}"):
                intrinsic.distance(V, F, vertices)
        with self.assertRaisesRegex(InputError, r"row 0 of F is \[0, 1, 18446744073709551616\]"):
            intrinsic.laplacian(V, [[0, 1, 2**64]])
        with self.assertRaisesRegex(InputError, "level is an integer of 16610 bits"):
            intrinsic.shapes.icosphere(10**5000)

    def test_quads(self):
        """The message has a way to split them."""
        V, _ = intrinsic.shapes.grid(3, 3)
        F = np.array([[i, i + 1, i + 5, i + 4] for i in range(11) if i % 4 < 3])
        for call in (lambda faces: intrinsic.laplacian(V, faces),
                     lambda faces: intrinsic.repair(V, faces),
                     lambda faces: intrinsic.pack_circles(None, faces),
                     lambda faces: intrinsic.vertex_point(faces, 0)):
            for faces in (F, F.tolist()):
                with self.assertRaisesRegex(ArrayError, r"F has the shape \(9, 4\)") as caught:
                    call(faces)
            call(eval(str(caught.exception).partition("triangles: ")[2], {"np": np, "F": F}))


if __name__ == "__main__":
    unittest.main()
