# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Triangulations against closed forms and positions in space."""

import copy
import pickle
import tempfile
import unittest
from pathlib import Path

import numpy as np
import scipy.sparse

import intrinsic
import support


def areas(lengths):
    a, b, c = np.sort(lengths, axis=1).T[::-1]
    return np.sqrt(np.maximum(0, (a + (b + c)) * (c - (a - b)) * (c + (a - b)) * (a + (b - c)))) / 4


def angles(lengths):
    """At each corner, from the lengths of the opposite sides."""
    a, b, c = lengths[:, [0, 1, 2]], lengths[:, [1, 2, 0]], lengths[:, [2, 0, 1]]
    return np.arccos(np.clip((b * b + c * c - a * a) / (2 * b * c), -1, 1))


def area_in_space(V, F):
    a, b, c = V[F].transpose(1, 0, 2)
    return np.linalg.norm(np.cross(b - a, c - a), axis=1).sum() / 2


class Delaunay(unittest.TestCase):
    def test_opposite_angles_and_area(self):
        for name, (V, F) in support.meshes().items():
            T = intrinsic.Triangulation(V, F)
            np.testing.assert_array_equal(T.F, F)
            T.delaunay()
            self.assertTrue(T.is_delaunay(), name)
            lengths = T.face_lengths
            opposite = np.zeros(len(T.lengths))
            counts = np.zeros(len(T.lengths))
            for k in range(3):  # side k leads from corner k to the next: the other is opposite
                np.add.at(opposite, T.face_edges[:, k], angles(lengths)[:, (k + 2) % 3])
                np.add.at(counts, T.face_edges[:, k], 1)
            self.assertLess(opposite[counts == 2].max(), np.pi + 1e-9, name)
            self.assertAlmostEqual(areas(lengths).sum() / area_in_space(V, F), 1, 12)
            np.testing.assert_array_equal(T.E[T.face_edges[:, 0]].sum(1), T.F[:, [0, 1]].sum(1))

    def test_exact_and_certificate(self):
        V, F = support.meshes()["cube"]
        T = intrinsic.Triangulation(V, F, exact=True)
        T.delaunay()
        certificate = T.certify()
        self.assertTrue(certificate.is_delaunay and certificate.is_geodesic)
        self.assertEqual(len(certificate.ties), 6)
        self.assertEqual(certificate.undecided, 0)
        skewed = intrinsic.Triangulation([[0, 0, 0], [4, 0, 0], [2, 1, 0], [2, -1, 0]],
                                         [[0, 1, 2], [1, 0, 3]])
        self.assertEqual(len(skewed.certify().non_delaunay_edges), 1)

    def test_weights(self):
        # In the plane, a triangle is a face if and only if all lifted points (x, |x|^2 - w) are
        # above its plane, and hidden vertices are the points inside the convex hull.
        n = 12
        x, y = (c.ravel() / n for c in np.meshgrid(np.arange(n + 1), np.arange(n + 1)))
        V = np.c_[x, y, 0 * x]
        V[:, :2] += 0.3 / n * np.sin([[7, 11]] * V[:, [1, 0]] * n) * (V * (1 - V))[:, [0, 1]]
        a = np.arange((n + 1) * n).reshape(n, n + 1)[:, :-1].ravel()
        F = np.r_[np.c_[a, a + 1, a + n + 2], np.c_[a, a + n + 2, a + n + 1]]
        weights = np.random.default_rng(5).uniform(0, 1.5 / n**2, len(V))
        T = intrinsic.Triangulation(V, F)
        result = T.weighted_delaunay(weights)
        height = (V**2).sum(axis=1) - result.weights
        corners = np.c_[V[:, :2], np.ones(len(V))]
        is_on_a_plane = np.zeros(len(V), bool)
        for f in T.F:
            above = height - corners @ np.linalg.solve(corners[f], height[f])
            self.assertGreater(above.min(), -1e-13)
            is_on_a_plane[f] = True
        self.assertTrue(is_on_a_plane.all())
        hidden = np.flatnonzero(result.weights > weights)
        np.testing.assert_array_equal(hidden, result.hidden_vertices)
        self.assertGreater(len(hidden), 5)
        # Linear functions are harmonic, and no edge has a negative weight.
        L = T.weighted_laplacian(result.weights)
        inside = np.flatnonzero(((0 < V[:, :2]) & (V[:, :2] < 1)).all(axis=1))
        np.testing.assert_allclose((L @ V)[inside], 0, atol=1e-12)
        self.assertLess((L - scipy.sparse.diags(L.diagonal())).tocsr()[inside].max(), 1e-9)
        exact = intrinsic.Triangulation(V, F, exact=True)
        np.testing.assert_allclose(exact.weighted_delaunay(weights).weights, result.weights,
                                   rtol=0, atol=1e-15)
        certificate = T.certify(weights, hidden)
        self.assertTrue(certificate.is_delaunay)
        self.assertEqual(certificate.undecided, 0)
        self.assertFalse(T.certify(weights).is_delaunay)
        raised = weights.copy()
        raised[hidden[0]] = result.weights[hidden[0]] + 1e-9
        np.testing.assert_array_equal(T.certify(raised, hidden).visible_vertices, hidden[:1])

    def test_equal_weights(self):
        V, F = support.meshes()["ellipsoid"]
        weighted, plain = (intrinsic.Triangulation(V, F) for _ in range(2))
        self.assertEqual(len(weighted.weighted_delaunay(np.full(len(V), 0.25)).hidden_vertices), 0)
        plain.delaunay()
        self.assertTrue(weighted.is_delaunay())
        difference = plain.weighted_laplacian(np.full(len(V), 0.25)) - intrinsic.laplacian(V, F)
        self.assertLess(abs(difference).max(), 1e-10)
        np.testing.assert_allclose(np.sort(weighted.lengths), np.sort(plain.lengths), rtol=1e-12)

    def test_bad_weights(self):
        T = intrinsic.Triangulation(*support.meshes()["cube"])
        with self.assertRaises(intrinsic.ArrayError):
            T.weighted_delaunay([1, 2])
        with self.assertRaises(intrinsic.InputError) as caught:
            T.weighted_delaunay([0, 0, np.nan, 0, 0, 0, 0, 0])
        self.assertEqual(caught.exception.row, 2)
        with self.assertRaises(intrinsic.InputError):
            T.certify(np.zeros(8), [8])
        with self.assertRaises(intrinsic.ArrayError):
            T.certify(hidden_vertices=[0])

    def test_lengths_alone(self):
        V, F = support.meshes()["ellipsoid"]
        first = intrinsic.Triangulation(V, F)
        alone = intrinsic.Triangulation(None, F, lengths=first.face_lengths)
        np.testing.assert_array_equal(alone.lengths, first.lengths)
        self.assertEqual(alone.delaunay(), first.delaunay())
        np.testing.assert_array_equal(alone.lengths, first.lengths)
        with self.assertRaises(intrinsic.InputError):
            alone.V

    def test_one_vertex_torus(self):
        # A square whose opposite sides are glued: both faces have one vertex only.
        with self.assertRaises(intrinsic.InputError):
            intrinsic.Triangulation(None, [[0, 0, 0]], lengths=[[1, 1, 1]])


class Constraints(unittest.TestCase):
    def test_constrained_edges_stay(self):
        """Flips keep constrained edges, and each other edge is Delaunay or cannot be flipped."""
        V, F = support.meshes()["noisy_sphere"]
        T = intrinsic.Triangulation(V * [1, 1, 9], F)
        kept = np.arange(0, len(T.E), 5)
        before, lengths = T.E[kept], T.lengths[kept]
        T.constrain(kept)
        self.assertGreater(T.delaunay(), 0)
        np.testing.assert_array_equal(np.sort(T.E[kept]), np.sort(before))
        np.testing.assert_array_equal(T.lengths[kept], lengths)
        np.testing.assert_array_equal(np.flatnonzero(T.constrained), kept)
        opposite = np.zeros(len(T.lengths))
        for k in range(3):
            np.add.at(opposite, T.face_edges[:, k], angles(T.face_lengths)[:, (k + 2) % 3])
        self.assertLess(opposite[~T.constrained].max(), np.pi + 1e-9)
        self.assertGreater(opposite[T.constrained].max(), np.pi)
        T.constrain(T.constrained, False)
        self.assertFalse(T.constrained.any() or T.is_delaunay())
        T.delaunay()
        free = intrinsic.Triangulation(V * [1, 1, 9], F)
        free.delaunay()
        self.assertAlmostEqual(T.lengths.sum() / free.lengths.sum(), 1, 12)

    def test_parts_of_constrained_edges(self):
        V, F = [[0, 0, 0], [9, 0, 0], [4, 3, 0], [5, -3, 0]], [[0, 1, 2], [1, 0, 3]]
        T = intrinsic.Triangulation(V, F)
        T.constrain((np.sort(T.E) == [0, 1]).all(axis=1))
        T.delaunay()
        T.refine(25, 1)
        self.assertAlmostEqual(T.lengths[T.constrained].sum(), 9, 12)
        self.assertGreater(T.constrained.sum(), 1)
        copied = pickle.loads(pickle.dumps(T))
        np.testing.assert_array_equal(copied.constrained, T.constrained)

    def test_bad_edges(self):
        T = intrinsic.Triangulation(*support.meshes()["cube"])
        for bad in ([-1], [len(T.E)], [0.5], "0", np.ones(3, bool), [[0]], None):
            with self.assertRaisesRegex(intrinsic.IntrinsicError, "edges"):
                T.constrain(bad)


class Refine(unittest.TestCase):
    def test_bounds(self):
        V, F = support.meshes()["strip"]
        T = intrinsic.Triangulation(V, F)
        report = T.refine(28)
        self.assertEqual(report.status, "bounds_met")
        self.assertGreaterEqual(np.degrees(angles(T.face_lengths).min()), 28 - 1e-9)
        self.assertEqual(T.n_vertices, len(V) + len(T.inserted[0]))
        self.assertEqual(report.insertions - report.removals, len(T.inserted[0]))
        self.assertEqual(len(T.V), T.n_vertices)
        self.assertAlmostEqual(areas(T.face_lengths).sum(), area_in_space(V, F), 12)
        limited = intrinsic.Triangulation(V, F).refine(28, max_insertions=1)
        self.assertEqual((limited.status, limited.insertions), ("insertion_limit", 1))

    def test_edges_are_geodesics_between_inserted_vertices(self):
        V, F = intrinsic.shapes.grid(1, 1)
        T = intrinsic.Triangulation(V * [20, 1, 1], F)
        T.refine(25)
        ends = T.V[T.E]  # in the plane, geodesics are straight
        np.testing.assert_allclose(np.linalg.norm(ends[:, 0] - ends[:, 1], axis=1), T.lengths,
                                   rtol=1e-12)


class Traces(unittest.TestCase):
    """Corners: coordinates must belong to the corners of F, whichever comes first."""

    def test_ends_and_lengths(self):
        for name, (V, F) in support.meshes().items():
            T = intrinsic.Triangulation(V, F)
            T.delaunay()
            curves = T.trace()
            self.assertEqual(len(curves), len(T.E))
            np.testing.assert_allclose(curves.points[curves.starts[:-1]], V[T.E[:, 0]], atol=1e-12)
            np.testing.assert_allclose(curves.points[curves.starts[1:] - 1], V[T.E[:, 1]],
                                       atol=1e-12)
            for i in range(len(curves)):
                line = curves.polyline(i)
                length = np.linalg.norm(np.diff(line, axis=0), axis=1).sum()
                self.assertAlmostEqual(length / T.lengths[i], 1, 9, name)
                self.assertEqual(len(line), max(T.crossings[i], 0) + 2)

    def test_points_are_in_common_faces(self):
        V, F = support.meshes()["ellipsoid"]
        T = intrinsic.Triangulation(V, F)
        T.delaunay()
        for faces, coordinates in T.trace():
            support_sets = [set(F[f][b > 0]) for f, b in zip(faces, coordinates)]
            for a, b in zip(support_sets, support_sets[1:]):
                self.assertTrue(any(a | b <= set(f) for f in F))

    def test_input_over_intrinsic(self):
        V, F = support.meshes()["noisy_sphere"]
        T = intrinsic.Triangulation(V, F)
        T.delaunay()
        curves = T.trace(of="input")
        self.assertEqual(len(curves), len(T.input_E))
        faces, coordinates = curves.faces, curves.barycentric
        there = T.transfer((faces, coordinates), to="input")
        start, end = (V[T.input_E[:, k]] for k in (0, 1))
        edge = np.repeat(np.arange(len(curves)), np.diff(curves.starts))
        on_line = start[edge] + curves.along[:, None] * (end - start)[edge]
        np.testing.assert_allclose(T.positions(there), on_line, atol=1e-9)

    def test_inserted_ends(self):
        V, F = support.meshes()["bumpy_grid"]
        T = intrinsic.Triangulation(V, F)
        T.refine(25, 0.1)
        curves = T.trace()
        np.testing.assert_allclose(curves.points[curves.starts[:-1]], T.V[T.E[:, 0]], atol=1e-9)
        np.testing.assert_allclose(curves.points[curves.starts[1:] - 1], T.V[T.E[:, 1]], atol=1e-9)


class Subdivision(unittest.TestCase):
    def test_area_and_parents(self):
        for name, (V, F) in support.meshes().items():
            T = intrinsic.Triangulation(V, F)
            T.delaunay()
            S = T.common_subdivision()
            self.assertAlmostEqual(area_in_space(S.V, S.F) / area_in_space(V, F), 1, 9, name)
            np.testing.assert_allclose(S.from_input @ V, S.V, atol=1e-12)
            np.testing.assert_array_equal(S.V[: len(V)], V)
            np.testing.assert_allclose(S.from_intrinsic @ np.ones(T.n_vertices), 1)
            # Each polygon lies in the plane of its input face, on the same side.
            n = np.cross(V[F][:, 1] - V[F][:, 0], V[F][:, 2] - V[F][:, 0])[S.input_face[S.polygon]]
            a, b, c = S.V[S.F].transpose(1, 0, 2)
            corner = V[F[S.input_face[S.polygon], 0]]
            self.assertLess(abs(((a - corner) * n).sum(1)).max(), 1e-9)
            self.assertGreater((np.cross(b - a, c - a) * n).sum(1).min(), -1e-12)


class Transfer(unittest.TestCase):
    def test_points_there_and_back(self):
        random = np.random.default_rng(5)
        for name, (V, F) in support.meshes().items():
            T = intrinsic.Triangulation(V, F)
            T.refine(20)
            b = random.dirichlet([1, 1, 1], 200)
            points = random.integers(0, len(F), 200), b
            there = T.transfer(points)
            back = T.transfer(there, to="input")
            np.testing.assert_allclose(T.positions(back), T.positions(points), atol=1e-8,
                                       err_msg=name)

    def test_vertices_are_vertices(self):
        V, F = support.meshes()["ellipsoid"]
        T = intrinsic.Triangulation(V, F)
        T.delaunay()
        for corner in range(3):
            points = np.arange(len(F)), np.eye(3)[np.full(len(F), corner)]
            faces, b = T.transfer(points)
            np.testing.assert_array_equal(b.max(1), 1)
            np.testing.assert_array_equal(T.F[faces, b.argmax(1)], F[:, corner])

    def test_functions(self):
        V, F = support.meshes()["bumpy_grid"]
        T = intrinsic.Triangulation(V, F)
        T.refine(25)
        f = V[:, 0] + 2 * V[:, 1]
        g = T.transfer(f)
        self.assertEqual(g.shape, (T.n_vertices,))
        before = intrinsic.mass(intrinsic.Triangulation(V, F), lumped=False) @ f
        after = intrinsic.mass(T, lumped=False) @ g
        self.assertAlmostEqual(before.sum(), after.sum(), 12)
        np.testing.assert_allclose(T.transfer(np.ones(len(V))), 1, rtol=1e-9)


class Files(unittest.TestCase):
    def test_save_and_load(self):
        V, F = support.meshes()["flat_torus"]
        T = intrinsic.Triangulation(V, F)
        T.refine(20)
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder, "T.save")
            T.save(path)
            same = intrinsic.Triangulation.load(path, V, F)
            for name in ("F", "E", "lengths", "crossings", "V"):
                np.testing.assert_array_equal(getattr(same, name), getattr(T, name))
            with self.assertRaises(intrinsic.InputError):
                intrinsic.Triangulation.load(path, *support.meshes()["cube"])
            text = path.read_bytes()
            lines = text.count(b"\n")
            for wrong, line in ((b"nothing\n", 1), (text[:text.rindex(b" ")], lines), (text + b"\n0\n", lines + 2),
                                (text[:40] + b"\xff" + text[41:], text[:40].count(b"\n") + 1)):
                path.write_bytes(wrong)
                with self.assertRaisesRegex(intrinsic.InputError, f"T.save: line {line}: "):
                    intrinsic.Triangulation.load(path)
            path.write_bytes(text + b"\n\n")
            intrinsic.Triangulation.load(path)

    def test_load_with_other_positions(self):
        """Positions must have the lengths of the file, up to one number that mollification adds."""
        V, F = support.meshes()["bumpy_grid"]
        moved, flat = V.copy(), V.copy()
        moved[7, 2] += 0.1
        flat[F[3, 0]] = flat[F[3, 1]]
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder, "T.save")

            def load(T, V):
                T.save(path)
                return intrinsic.Triangulation.load(path, V, F)

            T = intrinsic.Triangulation(V, F)
            load(T, V.astype(np.float32))
            load(T, V[:, [1, 2, 0]] + 5)
            for other in (2 * V, 0.5 * V, flat, np.vstack([V, V[:1]])):
                with self.assertRaisesRegex(intrinsic.InputError, "T.save: the .* in the file"):
                    load(T, other)
            with self.assertRaisesRegex(intrinsic.InputError, r" 7 .* in the file, and .* by V") as caught:
                load(T, moved)
            self.assertIn(7, caught.exception.edge)

            mollified = intrinsic.Triangulation(flat, F, mollify=0.01)
            np.testing.assert_array_equal(load(mollified, flat).lengths, mollified.lengths)
            given = intrinsic.Triangulation(None, F, lengths=T.face_lengths)
            np.testing.assert_array_equal(load(given, V).V, V)
            for saved in mollified, given:
                with self.assertRaisesRegex(intrinsic.InputError, "by V"):
                    load(saved, 2 * V)

    def test_constraints_that_cross_the_input(self):
        T = intrinsic.Triangulation([[0, 0, 0], [4, 0, 0], [2, 1, 0], [2, -1, 0]],
                                    [[0, 1, 2], [1, 0, 3]])
        T.delaunay()
        T.constrain(T.crossings > 0)
        with tempfile.TemporaryDirectory() as folder:
            T.save(Path(folder, "T.save"))
            same = intrinsic.Triangulation.load(Path(folder, "T.save"))
        np.testing.assert_array_equal(same.constrained, T.constrained)
        same.refine(20)
        copied = pickle.loads(pickle.dumps(same))
        self.assertEqual(copied.constrained.sum(), same.constrained.sum())
        self.assertTrue(copied.certify().is_geodesic)

    def test_pickle(self):
        V, F = support.meshes()["flat_torus"]
        lengths = support.lengths_of(V, F)
        for T in intrinsic.Triangulation(V, F), intrinsic.Triangulation(None, F, lengths=lengths):
            T.refine(20)
            for same in pickle.loads(pickle.dumps(T)), copy.deepcopy(T):
                T.delaunay()
                for name in ("F", "E", "lengths", "crossings", "input_F"):
                    np.testing.assert_array_equal(getattr(same, name), getattr(T, name))
        exact = pickle.loads(pickle.dumps(intrinsic.Triangulation(V, F, exact=True)))
        exact.delaunay()
        self.assertTrue(exact.certify().is_delaunay)
        np.testing.assert_array_equal(exact.V, V)


if __name__ == "__main__":
    unittest.main()
