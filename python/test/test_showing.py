# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Pages that show triangulations and maps."""

import json
import re
import unittest

import numpy as np

import intrinsic
import support


def shown(*arguments, **options):
    """Return the description of the page, and of its only surface."""
    page = intrinsic.show(*arguments, open=False, **options).html
    description = json.loads(re.search(r'id="page">([^<]+)<', page)[1])
    surface, = description["surfaces"]
    return description, surface


def counts_of_angles(lengths):
    """Return how many angles of triangles with these side lengths lie in each interval of five
    degrees."""
    a, b, c = np.moveaxis(np.stack([np.roll(lengths, k, axis=1) for k in range(3)]), 2, 0)
    cosines = np.clip((b * b + c * c - a * a) / (2 * b * c), -1, 1)
    return np.histogram(np.degrees(np.arccos(cosines)), bins=36, range=(0, 180))[0]


@unittest.skipUnless(intrinsic._core.has_pages, "pages were not built")
class ShowingTest(unittest.TestCase):

    def setUp(self):
        self.V, self.F = support.meshes()["ellipsoid"]

    def test_triangulation(self):
        T = intrinsic.Triangulation(self.V, self.F)
        T.delaunay()
        T.refine(25)
        subdivision = T.common_subdivision()
        description, surface = shown(T, on_input=self.V[:, 0], on_all=T.V[:, 1])
        self.assertEqual(surface["points"]["size"], subdivision.V.size)
        for side, faces in ("input", self.F), ("intrinsic", T.F):
            polygons = surface["polygon_data"][side + "_face"]
            self.assertEqual(polygons["parts"], len(subdivision.starts) - 1)
            self.assertEqual(polygons["owners"], len(faces))
        self.assertLessEqual({"on_input", "on_all"}, set(surface["point_data"]))
        self.assertLessEqual({"input_edge", "intrinsic_edge"}, set(surface["edge_data"]))
        angles = {histogram["name"]: histogram["counts"] for histogram in description["angles"]}
        np.testing.assert_array_equal(angles["intrinsic"], counts_of_angles(T.face_lengths))

    def test_direct(self):
        T = intrinsic.Triangulation(self.V, self.F)
        T.delaunay()
        T.refine(25)
        _, surface = shown(T, direct=True, on_input=self.V[:, 0], on_all=T.V[:, 1])
        self.assertEqual(surface["points"]["size"], self.V.size)
        self.assertEqual(surface["developed"]["edges"],
                         {"input": len(T.input_E), "intrinsic": len(T.E)})
        self.assertLessEqual({"on_input", "on_all"}, set(surface["point_data"]))
        mollified = intrinsic.Triangulation(self.V, self.F, mollify=0.1)
        self.assertNotIn("developed", shown(mollified, direct=True)[1])

    def test_maps(self):
        flat = intrinsic.flatten(self.V, self.F)
        octahedron = np.vstack([np.eye(3), -np.eye(3)]), np.array(
            [[0, 1, 2], [1, 3, 2], [3, 4, 2], [4, 0, 2], [1, 0, 5], [3, 1, 5], [4, 3, 5], [0, 4, 5]])
        sphere = intrinsic.to_sphere(*octahedron)
        for map_, kind in (flat, "plane"), (sphere, "sphere"):
            pieces = map_.subdivision
            n = len(map_.log_scale)
            _, surface = shown(map_, f=np.arange(n))
            self.assertEqual(surface["points"]["size"], pieces.V.size)
            self.assertEqual(surface["picture"]["kind"], kind)
            self.assertLessEqual({"f", "log_scale"}, set(surface["point_data"]))

    def test_infinite_values(self):
        V, F = np.vstack([self.V, self.V + 9]), np.vstack([self.F, self.F + len(self.V)])
        _, surface = shown(V, F, d=intrinsic.distance(V, F, 0))
        self.assertIn("d", json.dumps(surface))
        with self.assertRaisesRegex(intrinsic.InputError, "row 1 of d is not a number"):
            shown(V, F, d=np.where(np.arange(len(V)) == 1, np.nan, 0))

    def test_errors(self):
        lengths = np.ones((4, 3))
        F = np.array([[0, 1, 2], [0, 3, 1], [1, 3, 2], [2, 3, 0]])
        T = intrinsic.Triangulation(None, F, lengths=lengths)
        with self.assertRaisesRegex(intrinsic.InputError, "no positions"):
            intrinsic.show(T, open=False)
        with self.assertRaisesRegex(intrinsic.InputError, "no positions"):
            intrinsic.show(intrinsic.to_sphere(None, F, lengths=lengths), open=False)
        T = intrinsic.Triangulation(self.V, self.F)
        with self.assertRaisesRegex(intrinsic.ArrayError, "bad"):
            intrinsic.show(T, open=False, bad=np.zeros(len(self.V) + 1))
        with self.assertRaisesRegex(intrinsic.ArrayError, "bad"):
            intrinsic.show(intrinsic.flatten(self.V, self.F), open=False, bad=np.zeros((2, 2)))


if __name__ == "__main__":
    unittest.main()
