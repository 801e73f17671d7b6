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
        back = coarse.to_fine(*coarse.to_coarse(*points))
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

    def test_levels(self):
        """Linear functions on a flat surface are prolonged from each level exactly."""
        V, F = intrinsic.shapes.grid(20, 20)
        levels = intrinsic.simplify(V, F, [200, 60, 9])
        fine = V
        for vertices, P in zip(levels.level_vertices, levels.prolongations, strict=True):
            self.assertEqual(P.shape, (len(fine), len(vertices)))
            np.testing.assert_allclose(P @ V[vertices], fine, atol=1e-9)
            fine = V[vertices]
        np.testing.assert_allclose(levels.prolongation @ fine, V, atol=1e-9)
        np.testing.assert_array_equal(levels.vertices, levels.level_vertices[-1])

    def test_functions_with_weights(self):
        """Vertices gather where the gradient of a function changes."""
        V, F = intrinsic.shapes.grid(24, 24)
        x = V[:, 0] / np.ptp(V[:, 0])
        f = np.maximum(0, x - 0.7)
        even = intrinsic.simplify(V, F, 60).vertices
        bent = intrinsic.simplify(V, F, 60, weights={"area": 0.1, "f": 1},
                                  functions={"f": np.stack([f, 2 * f], axis=1)}).vertices
        near = abs(x - 0.7) < 0.1
        self.assertGreater(near[bent].sum(), 1.5 * near[even].sum())

    def test_refined(self):
        """Points are mapped through inserted vertices. On a flat surface they keep their positions."""
        V, F = intrinsic.shapes.grid(12, 12)
        random = np.random.default_rng(5)
        V = (V + random.uniform(-0.3, 0.3, V.shape) / 12) * [5, 1, 0]
        points = random.integers(0, len(F), 200), random.dirichlet([1, 1, 1], 200)
        at = np.einsum("kc,kcx->kx", points[1], V[F[points[0]]])
        coarse = intrinsic.simplify(V, F, 30, refine=25, min_angle=25)
        self.assertIn(-1, coarse.vertices)
        self.assertEqual(coarse.prolongation.shape, (len(V), len(coarse.vertices)))
        back = coarse.to_fine(coarse.to_coarse(points))
        np.testing.assert_allclose(np.einsum("kc,kcx->kx", back[1], V[F[back[0]]]), at, atol=1e-7)
        mesh = coarse.coarse_mesh()
        faces, barycentric = mesh.input_points
        np.testing.assert_allclose(np.einsum("kc,kcx->kx", barycentric, V[F[faces]]), mesh.V,
                                   atol=1e-9)

    def test_status(self):
        V, F = support.meshes()["strip"]
        coarse = intrinsic.simplify(V, F, 20, min_angle=25, max_insertions=2)
        self.assertEqual((coarse.status, coarse.refinement_status), ("reached", "insertion_limit"))
        self.assertIsNone(coarse.input_refinement_status)
        coarse = intrinsic.simplify(V, F, 20, refine=25, max_insertions=2)
        self.assertEqual(coarse.input_refinement_status, "insertion_limit")
        self.assertIsNone(coarse.refinement_status)
        V, F = intrinsic.shapes.icosphere(2)
        both = intrinsic.simplify(V, F, max_cost=0.01, refine=20, min_angle=20)
        self.assertEqual((both.status, both.input_refinement_status, both.refinement_status),
                         ("reached", "bounds_met", "bounds_met"))
        for n, status in ((1, "nothing_removable"), (3, "reached"), (10**6, "reached"),
                          ([9, 1], "nothing_removable")):
            self.assertEqual(intrinsic.simplify(V, F, n).status, status)

    def test_topology(self):
        V, F = support.meshes()["two_handles"]
        closed = intrinsic.simplify(V, F, len(V), pinch_handles=1e3)
        self.assertEqual(closed.pinched_handles, 2)
        n, m = len(closed.vertices), len(closed.F)
        self.assertEqual(n - 3 * m / 2 + m, 2)
        V, F = intrinsic.shapes.grid(9, 9)
        disk = intrinsic.simplify(V, F, 40, close_loops=1e3)
        self.assertEqual((disk.closed_loops, disk.pinched_handles), (1, 0))
        self.assertEqual(40 - 3 * len(disk.F) / 2 + len(disk.F), 2)
        faces, _ = disk.to_fine((np.arange(len(disk.F)), np.full((len(disk.F), 3), 1 / 3)))
        self.assertTrue((faces < 0).any() and (faces >= 0).any())
        self.assertEqual(intrinsic.simplify(V, F, 40, close_loops=1e-3).closed_loops, 0)

    def test_bad_parameters(self):
        V, F = intrinsic.shapes.icosphere(1)
        x = V[:, 0]
        for given, named in [
            ({"n": []}, "n is empty"), ({"n": [9, 9]}, "n.1. is 9"), ({"n": [20, "9"]}, "n.1."),
            ({"n": [[9]]}, "n.0."), ({"n": [20, [9]]}, "n.1."), ({"n": "9"}, "n is '9'"),
            ({"n": np.array([20, 9.5])}, "n.1."),
            ({"weights": 1}, "weights is 1"), ({"weights": {1: 1}}, "weights is"),
            ({"weights": {}}, "not a cost"), ({"weights": {"area_change": 1}}, "not a cost"),
            ({"weights": {"curvature": -1}}, "weights.'curvature'. is -1"),
            ({"weights": {"curvature": np.nan}}, "weights.'curvature'. is nan"),
            ({"weights": {"curvatur": 1}}, "has 'curvatur', which is not in functions"),
            ({"functions": {"x": x}}, "functions has 'x', which has no weight"),
            ({"functions": {"area": x}, "weights": {"area": 1}}, "functions has 'area'"),
            ({"functions": [x], "weights": {"area": 1}}, "functions is"),
            ({"functions": {"x": x[:-1]}, "weights": {"x": 1}}, "functions.'x'. has the shape"),
            ({"functions": {"x": x[:, None][:, :0]}, "weights": {"x": 1}}, "no columns"),
            ({"functions": {"x": x * np.nan}, "weights": {"x": 1}}, "row 0 of functions.'x'."),
            ({"functions": {"x": x.astype(str)}, "weights": {"x": 1}}, "functions.'x'. has the type"),
        ]:
            with self.subTest(given=given), self.assertRaisesRegex(intrinsic.IntrinsicError, named):
                intrinsic.simplify(V, F, **{"n": 9, **given})

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

    def test_net_of_lengths(self):
        """A regular tetrahedron from the lengths of its net."""
        F = np.array([[0, 3, 5], [3, 1, 4], [5, 4, 2], [3, 4, 5]])
        glue = np.array([[0, 3, 1, 3], [1, 4, 2, 4], [2, 5, 0, 5]], np.uint8)
        p = intrinsic.convex_polyhedron(None, F, lengths=np.ones((4, 3)), glue=glue)
        self.assertEqual(p.vertex_map.tolist(), [0, 0, 0, 1, 2, 3])
        distances = np.linalg.norm(p.V[:, None] - p.V[None], axis=2)
        np.testing.assert_allclose(distances, 1 - np.eye(4), atol=1e-12)

    def test_bad_nets(self):
        V = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]])
        F = [[0, 1, 2], [0, 2, 3]]
        for glue, named in [
            ([[0, 1, 0, 3]], "side from 2 to 1 is not glued|side from 1 to 2 is not glued"),
            ([[0, 2, 0, 3]], "row 0 of glue: the side from 0 to 2 is not on the boundary"),
            ([[0, 1, 0, 3], [1, 0, 2, 3]], "row 1 of glue: the side from .* is glued twice"),
            ([[0, 1, 1, 0]], "row 0 of glue: .*glued twice"),
            ([[0, 1, 2, 3]], "row 0 of glue: the surface would not be oriented"),
            ([[0, 1, 2, 9]], "row 0 of glue is"), ([[0, 1, 2]], "glue has the shape"), ([], "glue"),
            ("0 1 2 3", "glue"), ([[0.5, 1, 2, 3]], "glue has the type"),
        ]:
            with self.subTest(glue=glue), self.assertRaisesRegex(intrinsic.IntrinsicError, named):
                intrinsic.convex_polyhedron(V, F, glue=glue)
        with self.assertRaisesRegex(intrinsic.InputError, "different lengths"):
            intrinsic.convex_polyhedron(V * [2, 1, 1], F, glue=[[0, 1, 0, 3], [2, 1, 2, 3]])

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

    def test_most_faces_keep_their_orientation(self):
        V, F = intrinsic.shapes.icosphere(1)
        for face in (0, 5, 79):
            turned = F.copy()
            turned[face] = turned[face, ::-1]
            fixed = intrinsic.repair(V, turned)
            self.assertEqual(fixed.report, {"faces reversed": 1})
            for a, b in zip(fixed.F, F):
                self.assertIn(list(a), [list(np.roll(b, k)) for k in range(3)])


if __name__ == "__main__":
    unittest.main()
