# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Simplification: the map must be one, and what is kept must be kept."""

import unittest

import numpy as np

import intrinsic
import support
from test_triangulation import areas


class Simplify(unittest.TestCase):
    def test_prolongation(self):
        for name in ("noisy_sphere", "flat_torus", "strip", "two_handles", "folded_sphere"):
            V, F = support.meshes()[name]
            n = max(12, len(V) // 4)
            coarse = intrinsic.simplify(V, F, n)
            self.assertEqual(len(coarse.vertices), n, name)
            self.assertEqual(coarse.removed, len(V) - n)
            P = coarse.prolongation
            self.assertEqual(P.shape, (len(V), n))
            self.assertGreaterEqual(P.min(), 0)
            np.testing.assert_allclose(P.sum(axis=1), 1, atol=1e-12)
            self.assertEqual(abs(P[coarse.vertices] - np.eye(n)).max(), 0)
            euler = len(V) - 3 * len(F) / 2 + len(F)
            if name != "strip":
                self.assertEqual(n - 3 * len(coarse.F) / 2 + len(coarse.F), euler)

    def test_points(self):
        V, F = support.meshes()["flat_torus"]
        coarse = intrinsic.simplify(V, F, 80)
        random = np.random.default_rng(4)
        points = random.integers(0, len(F), 100), random.dirichlet([1, 1, 1], 100)
        back = coarse.to_fine(coarse.to_coarse(points))
        position = np.einsum("kc,kcx->kx", points[1], V[F[points[0]]])
        again = np.einsum("kc,kcx->kx", back[1], V[F[back[0]]])
        np.testing.assert_allclose(again, position, atol=1e-7)
        # Vertices are mapped as the prolongation says, at whichever corner they are given.
        P = coarse.prolongation.toarray()
        for k in range(3):
            faces, b = coarse.to_coarse((np.arange(len(F)), np.eye(3)[np.full(len(F), k)]))
            rows = np.zeros((len(F), len(coarse.vertices)))
            for c in range(3):
                np.add.at(rows, (np.arange(len(F)), coarse.F[faces, c]), b[:, c])
            np.testing.assert_allclose(rows, P[F[:, k]], atol=1e-9)

    def test_coarse_surface(self):
        V, F = support.meshes()["sphere"]
        coarse = intrinsic.simplify(V, F, 60)
        area = areas(coarse.face_lengths).sum()
        self.assertLess(abs(area / 12.56 - 1), 0.1)
        T = intrinsic.Triangulation(None, coarse.F, lengths=coarse.face_lengths)
        self.assertTrue(T.is_delaunay())
        same = coarse.triangulation()
        np.testing.assert_array_equal(same.F, coarse.F)
        np.testing.assert_array_equal(same.face_lengths, coarse.face_lengths)
        mesh = coarse.coarse_mesh()
        self.assertEqual(intrinsic.info(mesh).components, 1)
        np.testing.assert_array_equal(mesh.V[:60], V[coarse.vertices])
        self.assertLess(mesh.quality["distance_to_coarse"], 0.3)

    def test_points_of_coarse_mesh(self):
        """Each vertex of a coarse mesh, also an inserted one, lies at its point of the input."""
        V, F = support.meshes()["torus"]
        V = np.vstack([V, [[9, 9, 9]]])  # without a face
        mesh = intrinsic.simplify(V, F, 5).coarse_mesh()
        faces, barycentric = mesh.input_points
        self.assertGreater((mesh.input_vertex < 0).sum(), 0)
        self.assertEqual((faces < 0).tolist(), (mesh.input_vertex == len(V) - 1).tolist())
        on = faces >= 0
        at = (V[F[faces[on]]] * barycentric[on][:, :, None]).sum(axis=1)
        np.testing.assert_allclose(at, mesh.V[on], atol=1e-12)

    def test_loops(self):
        """A coarse triangulation with loops is a Triangulation, but no mesh."""
        V, F = support.meshes()["torus"]
        coarse = intrinsic.simplify(V, F, 3)
        T = coarse.triangulation()
        self.assertTrue((coarse.F == np.roll(coarse.F, 1, axis=1)).any())
        self.assertAlmostEqual(intrinsic.mass(T).sum() / areas(coarse.face_lengths).sum(), 1, 9)
        self.assertEqual(intrinsic.distance(T, sources=0).shape, (3,))
        with self.assertRaises(intrinsic.InputError):
            intrinsic.laplacian(None, coarse.F, lengths=coarse.face_lengths)

    def test_targets(self):
        V, F = support.meshes()["noisy_sphere"]
        self.assertEqual(len(intrinsic.simplify(V, F, ratio=0.1).vertices),
                         int(np.ceil(0.1 * len(V))))
        some = intrinsic.simplify(V, F, max_cost=0.02)
        self.assertLessEqual(some.greatest_cost, 0.02)
        self.assertGreater(some.removed, 0)
        self.assertEqual(intrinsic.simplify(V, F, 10**6).removed, 0)
        extra = np.vstack([V, [[9, 9, 9], [8, 8, 8]]])  # without faces
        self.assertEqual(len(intrinsic.simplify(extra, F, 100).vertices), 102)

    def test_refined_coarse_points_are_complete(self):
        with self.assertRaises(intrinsic.InputError):
            lengths = intrinsic.Triangulation(*intrinsic.shapes.icosphere(2)).face_lengths
            intrinsic.simplify(None, intrinsic.shapes.icosphere(2)[1], 20,
                               lengths=lengths).coarse_mesh()


class Polyhedron(unittest.TestCase):
    def test_reflected_cap(self):
        # A corner of a cube that is pushed in gives the cube again.
        V, F = intrinsic.shapes.cube()
        p = intrinsic.convex_polyhedron(V, F)
        ends = np.concatenate([F[:, [0, 1]], F[:, [1, 2]], F[:, [2, 0]]])
        np.testing.assert_allclose(np.linalg.norm(p.V[ends[:, 0]] - p.V[ends[:, 1]], axis=1),
                                   np.linalg.norm(V[ends[:, 0]] - V[ends[:, 1]], axis=1), rtol=1e-9)
        self.assertEqual(p.triangulation.n_vertices, 8)
        self.assertEqual(p.kind, "convex")

    def test_flat(self):
        V = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]
        p = intrinsic.convex_polyhedron(V, [[0, 1, 2], [0, 2, 1]])
        self.assertTrue(p.is_flat)
        self.assertEqual(p.kind, "polygon")

    def test_thin(self):
        # A failure names what is not convex.
        angles = 2 * np.pi * np.arange(7) / 7
        z = 7.525650929438565e-06
        V = np.vstack([np.stack([np.cos(angles), np.sin(angles), 0 * angles], axis=1),
                       [[0, 0, z], [0, 0, -z]]])
        F = [f for i in range(7) for f in ((i, (i + 1) % 7, 7), ((i + 1) % 7, i, 8))]
        try:
            p = intrinsic.convex_polyhedron(V, F)
        except intrinsic.NumericalError as error:
            self.assertRegex(str(error), "(edges|faces): [1-9]|degree: [02-9]")
        else:
            np.testing.assert_allclose(np.linalg.norm(p.V[F] - p.V[np.roll(F, 1, axis=1)], axis=2),
                                       np.linalg.norm(V[F] - V[np.roll(F, 1, axis=1)], axis=2),
                                       rtol=1e-8)

    def test_negative_curvature(self):
        with self.assertRaises(intrinsic.NegativeCurvatureError) as caught:
            intrinsic.convex_polyhedron(*support.meshes()["folded_sphere"])
        self.assertIsNotNone(caught.exception.vertex)


class Repairs(unittest.TestCase):
    def test_repair_and_info(self):
        V, F = intrinsic.shapes.icosphere(2)
        torn = V[F].reshape(-1, 3), np.arange(3 * len(F)).reshape(-1, 3)
        self.assertEqual(intrinsic.info(*torn).components, len(F))
        self.assertFalse(intrinsic.info(V, F[:0]).is_valid)
        whole = intrinsic.repair(*torn)
        self.assertEqual(len(whole.V), len(V))
        about = intrinsic.info(whole)
        self.assertTrue(about.is_valid)
        self.assertEqual((about.components, about.euler_characteristic), (1, 2))
        welded = intrinsic.repair(support.noisy(torn[0], 1e-9), torn[1], weld=1e-6)
        self.assertEqual(len(welded.V), len(V))


if __name__ == "__main__":
    unittest.main()
