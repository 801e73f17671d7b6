# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Matrices against formulas on the triangles that they are of."""

import unittest

import numpy as np

import intrinsic
import support
from test_triangulation import angles, area_in_space, areas


def cotan_laplacian(F, lengths, n):
    L = np.zeros((n, n))
    cotangent = 1 / np.tan(angles(lengths)) / 2
    for k in range(3):  # the corner opposite to the side from k + 1 to k + 2
        i, j = F[:, (k + 1) % 3], F[:, (k + 2) % 3]
        for a, b, sign in ((i, j, -1), (j, i, -1), (i, i, 1), (j, j, 1)):
            np.add.at(L, (a, b), sign * cotangent[:, k])
    return L


class Operators(unittest.TestCase):
    def test_formulas(self):
        for name, (V, F) in support.meshes().items():
            T = intrinsic.Triangulation(V, F)
            T.delaunay()
            L = intrinsic.laplacian(V, F).toarray()
            expected = cotan_laplacian(T.F, T.face_lengths, len(V))
            np.testing.assert_allclose(L, expected, atol=1e-9 * abs(L).max(), err_msg=name)
            self.assertLess((L - np.diag(np.diag(L))).max(), 1e-9 * abs(L).max())
            M = intrinsic.mass(V, F)
            self.assertAlmostEqual(M.sum() / area_in_space(V, F), 1, 12)
            at_vertices = np.zeros(len(V))
            np.add.at(at_vertices, T.F, areas(T.face_lengths)[:, None] / 3)
            np.testing.assert_allclose(M.diagonal(), at_vertices, rtol=1e-9)
            full = intrinsic.mass(V, F, lumped=False)
            np.testing.assert_allclose(full.sum(axis=1).A1, M.diagonal(), rtol=1e-9)

    def test_gradient_and_divergence(self):
        V, F = support.meshes()["noisy_sphere"]
        T = intrinsic.Triangulation(V, F)
        T.delaunay()
        G, D, L = intrinsic.gradient(T), intrinsic.divergence(T), intrinsic.laplacian(T)
        np.testing.assert_allclose((D @ G).toarray(), -L.toarray(), atol=1e-9)
        # The gradient of a function that is linear in the plane.
        flat, faces = intrinsic.shapes.grid(3, 4)
        f = 3 * flat[:, 0] - 2 * flat[:, 1]
        lengths = np.hypot(*(intrinsic.gradient(intrinsic.Triangulation(flat, faces)) @ f)
                           .reshape(-1, 2).T)
        np.testing.assert_allclose(lengths, 13**0.5)

    def test_eigenvalues_of_the_sphere(self):
        from scipy.sparse.linalg import eigsh

        V, F = intrinsic.shapes.icosphere(4)
        values = eigsh(intrinsic.laplacian(V, F), 9, intrinsic.mass(V, F), sigma=-0.1,
                       return_eigenvectors=False)
        np.testing.assert_allclose(np.sort(values), [0, 2, 2, 2, 6, 6, 6, 6, 6], atol=0.05)

    def test_connection_laplacian(self):
        V, F = support.meshes()["torus"]
        C = intrinsic.connection_laplacian(V, F)
        self.assertEqual(abs(C - C.conj().T).max(), 0)
        self.assertGreater(np.linalg.eigvalsh(C.toarray()).min(), -1e-9)

    def test_lengths_alone(self):
        V, F = support.meshes()["ellipsoid"]
        lengths = intrinsic.Triangulation(V, F).face_lengths
        L = intrinsic.laplacian(None, F, lengths=lengths)
        self.assertEqual(abs(L - intrinsic.laplacian(V, F)).max(), 0)

    def test_equal_points(self):
        V, F = [[0, 0, 0], [1, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 3], [1, 2, 3]]
        for call in (intrinsic.soup_operators, intrinsic.laplacian, intrinsic.Triangulation):
            with self.assertRaisesRegex(intrinsic.InputError, "vertices 1 and 2.*mollify") as caught:
                call(V, F)
            self.assertEqual((caught.exception.edge, caught.exception.face), ((1, 2), 1))
        with self.assertRaisesRegex(intrinsic.InputError, "vertices 1 and 2"):
            intrinsic.soup_distance(V, F, 0)
        L = intrinsic.soup_operators(V, F, mollify=1e-8).laplacian
        self.assertTrue(np.isfinite(L.toarray()).all())
        with self.assertRaises(intrinsic.InputError):
            intrinsic.laplacian(intrinsic.Triangulation(V, F, mollify=1e-8), mollify=-5)

    def test_surfaces_are_soups(self):
        V, F = support.meshes()["bumpy_grid"]
        soup = intrinsic.soup_operators(V, F)
        self.assertAlmostEqual(soup.mass.sum(), area_in_space(V, F), 9)
        self.assertLess(abs(soup.laplacian.sum(axis=1)).max(), 1e-9)
        closed_V, closed_F = support.meshes()["noisy_sphere"]
        difference = intrinsic.soup_operators(closed_V, closed_F).laplacian - intrinsic.laplacian(
            closed_V, closed_F)
        self.assertLess(abs(difference).max(), 1e-9)

    def test_points_without_faces(self):
        V = intrinsic.shapes.icosphere(4)[0]
        cloud = intrinsic.soup_operators(V, [])
        np.testing.assert_array_equal(intrinsic.soup_operators(V).mass.toarray(),
                                      cloud.mass.toarray())
        self.assertLess(abs(cloud.mass.sum() - 4 * np.pi), 0.3)
        self.assertLess(abs(cloud.laplacian.sum(axis=1)).max(), 1e-9)


class Mollification(unittest.TestCase):
    """A triangle on a line has no angles, so 1e-8 of the mean length of its edges is added."""

    V, F = np.array([[0., 0, 0], [1, 0, 0], [2, 0, 0]]), np.array([[0, 1, 2]])
    lengths = np.array([[1., 2, 1]]) + 1e-8 * 4 / 3

    def mollified(self, compute):
        with self.assertWarns(intrinsic.MollificationWarning) as caught:
            result = compute()
        self.assertEqual(caught.filename, __file__)  # of the caller
        return result

    def test_operators(self):
        L = self.mollified(lambda: intrinsic.laplacian(self.V, self.F)).toarray()
        np.testing.assert_allclose(L, cotan_laplacian(self.F, self.lengths, 3), rtol=1e-6)
        self.mollified(lambda: intrinsic.connection_laplacian(self.V, self.F))
        with self.assertRaises(intrinsic.NumericalError):
            intrinsic.laplacian(self.V, self.F, mollify=0)

    def test_distances(self):
        for compute in (lambda: intrinsic.distance(self.V, self.F, 0, "heat"),
                        lambda: intrinsic.DistanceSolver(self.V, self.F).distance(0),
                        lambda: abs(intrinsic.log_map(self.V, self.F, 0).vectors)):
            np.testing.assert_allclose(self.mollified(compute), [0, 1, 2], atol=1e-7)
        line = self.mollified(lambda: intrinsic.exp_map(self.V, self.F, 0, 0.5))
        np.testing.assert_allclose(line.points[-1], [0.5, 0, 0], atol=1e-7)
        field = self.mollified(lambda: intrinsic.transport(self.V, self.F, [0], [2j]))
        np.testing.assert_allclose(abs(field), 2, rtol=1e-6)


if __name__ == "__main__":
    unittest.main()
