# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Meshes of other packages are taken by what they have, and results go to them."""

import tempfile
import unittest
from pathlib import Path
from types import SimpleNamespace

import numpy as np

import intrinsic

try:
    import meshio
except ImportError:
    meshio = None

V, F = intrinsic.shapes.icosphere(2)


class Meshes(unittest.TestCase):
    def check(self, mesh):
        expected = intrinsic.laplacian(V, F)
        self.assertEqual(abs(intrinsic.laplacian(mesh) - expected).max(), 0)
        np.testing.assert_array_equal(intrinsic.Triangulation(mesh).F, F)
        np.testing.assert_array_equal(intrinsic.distance(mesh, sources=3),
                                      intrinsic.distance(V, F, 3))
        self.assertTrue(intrinsic.info(mesh).is_valid)
        self.assertEqual(len(intrinsic.simplify(mesh, n=50).vertices), 50)

    def test_vertices_and_faces(self):
        self.check(SimpleNamespace(vertices=V, faces=F))  # trimesh

    def test_points_and_packed_faces(self):
        packed = np.column_stack([np.full(len(F), 3), F]).ravel()
        self.check(SimpleNamespace(points=V, faces=packed))  # pyvista
        quads = np.column_stack([np.full(len(F), 4), F]).ravel()
        with self.assertRaises(intrinsic.ArrayError):
            intrinsic.laplacian(SimpleNamespace(points=V, faces=quads))

    def test_points_and_cells(self):
        blocks = [SimpleNamespace(type="line", data=F[:2, :2]),
                  SimpleNamespace(type="triangle", data=F[:50]),
                  SimpleNamespace(type="triangle", data=F[50:])]
        self.check(SimpleNamespace(points=V, cells=blocks))
        self.check(SimpleNamespace(points=V, cells=[("triangle", F)]))
        blocks.append(SimpleNamespace(type="quad", data=F[:, [0, 1, 2, 2]]))
        with self.assertRaises(intrinsic.ArrayError):
            intrinsic.laplacian(SimpleNamespace(points=V, cells=blocks))

    def test_no_mesh(self):
        for thing in (V, object(), "mesh.off", 3, None):
            with self.assertRaises(intrinsic.ArrayError):
                intrinsic.laplacian(thing)

    @unittest.skipUnless(meshio, "needs meshio")
    def test_objects_of_this_package_that_are_no_meshes(self):
        T = intrinsic.Triangulation(V, F)
        calls = {"flatten": lambda: intrinsic.flatten(T),
                 "simplify": lambda: intrinsic.simplify(T, n=9),
                 "info": lambda: intrinsic.info(T),
                 "Triangulation": lambda: intrinsic.Triangulation(T),
                 "flatten with faces": lambda: intrinsic.flatten(T, F)}
        for name, call in calls.items():
            with self.subTest(name), self.assertRaisesRegex(
                    intrinsic.ArrayError, "V is a Triangulation, but this function takes a mesh"):
                call()

    def test_arguments_after_a_mesh_need_names(self):
        mesh = SimpleNamespace(vertices=V, faces=F)
        cells = SimpleNamespace(points=V, cells=[("triangle", F)])
        for call in (lambda: intrinsic.distance(mesh, 0), lambda: intrinsic.path(mesh, 0, 5),
                     lambda: intrinsic.simplify(cells, 9, n=9), lambda: intrinsic.info(mesh, F),
                     lambda: intrinsic.distance(intrinsic.Triangulation(V, F), 0)):
            with self.assertRaisesRegex(intrinsic.ArrayError, "name all further arguments"):
                call()
        np.testing.assert_array_equal(intrinsic.distance(mesh, sources=0),
                                      intrinsic.distance(V, F, 0))

    def test_meshio(self):
        self.check(meshio.Mesh(V, [("triangle", F)]))
        coarse = intrinsic.simplify(V, F, 40).coarse_mesh()
        d = intrinsic.distance(coarse, sources=0)
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder, "coarse.vtk")
            meshio.Mesh(coarse.vertices, [("triangle", coarse.faces)],
                        point_data={"distance": d}).write(path)
            again = meshio.read(path)
        np.testing.assert_array_equal(again.points, coarse.V)
        np.testing.assert_array_equal(intrinsic.distance(again, sources=0), d)
        texture = intrinsic.flatten(V, F).subdivision
        meshio.Mesh(texture.uv.reshape(-1, 2),
                    [("triangle", np.arange(3 * len(texture.F)).reshape(-1, 3))])


if __name__ == "__main__":
    unittest.main()
