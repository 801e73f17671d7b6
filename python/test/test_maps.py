# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Conformal maps against what is prescribed and closed forms."""

import inspect
import re
import unittest

import numpy as np

import intrinsic
import support
from intrinsic.maps import _advice


def signed_areas(uv):
    a, b, c = uv.transpose(1, 0, 2)
    x, y = b - a, c - a
    return (x[:, 0] * y[:, 1] - x[:, 1] * y[:, 0]) / 2


def angle_sums(uv, F, n):
    result = np.zeros(n)
    for k in range(3):
        x, y = uv[:, (k + 1) % 3] - uv[:, k], uv[:, (k + 2) % 3] - uv[:, k]
        cross = x[:, 0] * y[:, 1] - x[:, 1] * y[:, 0]
        np.add.at(result, F[:, k], np.arctan2(cross, (x * y).sum(1)))
    return result


class Flat(unittest.TestCase):
    def test_orientation_and_pieces(self):
        for name, (V, F) in support.meshes().items():
            m = intrinsic.flatten(V, F)
            self.assertEqual(m.status, "success", name)
            S = m.subdivision
            self.assertGreater(signed_areas(S.uv).min(), 0, name)
            np.testing.assert_array_equal(S.V[: len(V)], V)
            np.testing.assert_allclose(S.from_input @ V, S.V, atol=1e-12)
            self.assertEqual(S.uv.shape, (len(S.F), 3, 2))
            closed = name not in ("bumpy_grid", "strip")
            self.assertEqual(len(S.cut_vertices) > 0, closed)

    def test_angle_sums(self):
        V, F = support.meshes()["noisy_sphere"]
        m = intrinsic.flatten(V, F)
        S = m.subdivision
        sums = angle_sums(S.uv, S.F, len(S.V))
        inside = np.setdiff1d(np.arange(len(S.V)), m.cones)
        np.testing.assert_allclose(sums[inside], 2 * np.pi, atol=1e-6)
        self.assertLess(len(m.cones), 20)
        self.assertAlmostEqual((2 * np.pi - sums[m.cones]).sum(), 4 * np.pi, 6)

    def test_prescribed_cones(self):
        V, F = support.meshes()["ellipsoid"]
        cones = {3: np.pi, 50: np.pi, 200: np.pi, 400: np.pi}
        m = intrinsic.flatten(V, F, cones=cones)
        S = m.subdivision
        sums = angle_sums(S.uv, S.F, len(S.V))
        np.testing.assert_allclose(sums[list(cones)], np.pi, atol=1e-6)
        everywhere = np.zeros(len(V))
        everywhere[list(cones)] = np.pi
        again = intrinsic.flatten(V, F, cones=everywhere)
        np.testing.assert_array_equal(again.subdivision.image, S.image)
        self.assertEqual(m.cones.tolist(), [3, 50, 200, 400])
        self.assertEqual(again.cones.tolist(), [3, 50, 200, 400])
        with self.assertRaises(intrinsic.InputError):
            intrinsic.flatten(V, F, cones={3: np.pi})  # Gauss-Bonnet

    def test_cones_are_inside(self):
        V, F = intrinsic.shapes.grid(10, 10)
        V = np.vstack([V, [[9, 9, 9]]])  # without a face
        m = intrinsic.flatten(V, F, cones={61: 0, 60: 1, 0: 0, 121: 0})
        self.assertEqual(m.cones.tolist(), [60])
        for vertex, where in ((0, "is on the boundary"), (121, "has no face")):
            with self.assertRaisesRegex(intrinsic.InputError, f"vertex {vertex}, which {where}") as caught:
                intrinsic.flatten(V, F, cones={60: 1, vertex: 1})
            self.assertEqual(caught.exception.vertex, vertex)

    def test_bounds_are_for_placed_cones(self):
        V, F = support.meshes()["bumpy_grid"]
        inside = ((V[:, :2] > 0) & (V[:, :2] < 1)).all(axis=1)
        for bound in ({"max_log_scale": 0.3}, {"max_area_distortion": 2}):
            name = next(iter(bound))
            for given, said in (({"boundary": "disk"}, "the boundary 'disk'"),
                                ({"boundary": "rectangle"}, "the boundary 'rectangle'"),
                                ({"cones": "none"}, "cones='none'"),
                                ({"cones": {40: 1}}, "prescribed cones")):
                with self.assertRaisesRegex(intrinsic.InputError,
                                            f"{name} is for cones='greedy'.* not for {said}"):
                    intrinsic.flatten(V, F, **given, **bound)
            m = intrinsic.flatten(V, F, boundary="disk", cones="greedy", **bound)
            self.assertLessEqual(abs(m.log_scale[inside]).max(), 0.35)

    def test_plane_stays(self):
        flat, faces = support.turned(*intrinsic.shapes.grid(4, 6))
        m = intrinsic.flatten(flat, faces)
        np.testing.assert_allclose(m.log_scale, 0, atol=1e-9)
        uv = m.subdivision.image
        self.assertAlmostEqual(np.ptp(uv[:, 0]) * np.ptp(uv[:, 1]), 1, 6)

    def test_shapes_of_boundaries(self):
        V, F = support.meshes()["bumpy_grid"]
        n = 8
        border = np.flatnonzero(((V[:, :2] == 0) | (V[:, :2] == 1)).any(1))
        S = intrinsic.flatten(V, F, boundary="disk").subdivision
        position = self.positions(S)
        center = (position.min(0) + position.max(0)) / 2
        radius = np.linalg.norm(position[border] - center, axis=1)
        self.assertLess(np.ptp(radius) / radius.mean(), 0.02)
        S = intrinsic.flatten(V, F, boundary="rectangle").subdivision
        position = self.positions(S)
        is_on_side = np.minimum(abs(position), abs(position - position.max(0))) < 1e-6
        self.assertTrue(is_on_side[border].any(1).all())
        self.assertEqual(is_on_side[border].all(1).sum(), 4)
        turn = dict.fromkeys(border.tolist(), 2 * np.pi / (4 * n))
        S = intrinsic.flatten(V, F, boundary="curvature", boundary_values=turn,
                              cones="none").subdivision
        np.testing.assert_allclose(angle_sums(S.uv, S.F, len(S.V))[border],
                                   np.pi - 2 * np.pi / (4 * n), atol=1e-6)

    @staticmethod
    def positions(S):
        position = np.zeros((len(S.V), 2))
        position[S.corners] = S.image[S.corner_image]
        return position

    def test_points(self):
        """The images of points of the subdivision, in the order of corners of F."""
        V, F = support.meshes()["strip"]
        m = intrinsic.flatten(V, F)
        S = m.subdivision
        images = {}
        for corner, image in zip(S.corners, S.corner_image):
            images.setdefault(int(corner), set()).add(int(image))
        where = np.arange(len(F)), np.full((len(F), 3), 1 / 3)
        np.testing.assert_array_equal(m(where), m(*where))
        for wrong in ((where[0],), (where[0], None), (None,), (0,)):
            with self.assertRaisesRegex(intrinsic.ArrayError, "points"):
                m(*wrong)
        for k in range(3):
            at_corners = m(np.arange(len(F)), np.eye(3)[np.full(len(F), k)])
            for vertex, z in zip(F[:, k], at_corners):
                nearest = min(np.abs(S.image[i] - z).max() for i in images[vertex])
                self.assertLess(nearest, 1e-9)

    def test_options(self):
        V, F = support.meshes()["bumpy_grid"]
        uv = intrinsic.flatten(V, F, unit_square=True).subdivision.image
        self.assertLessEqual(uv.max(), 1)
        self.assertGreaterEqual(uv.min(), 0)
        for layout in ("spectral", "incremental"):
            m = intrinsic.flatten(V, F, layout=layout)
            self.assertGreater(signed_areas(m.subdivision.uv).min(), 0)
        few = intrinsic.flatten(*support.meshes()["folded_sphere"], max_log_scale=1)
        self.assertLessEqual(abs(few.log_scale).max(), 1)
        for cones in ("greedy", "exchanged"):
            even = intrinsic.flatten(*support.meshes()["folded_sphere"], cones=cones,
                                     max_log_scale=5, max_area_distortion=np.exp(2))
            self.assertLessEqual(abs(even.log_scale).max(), 1)
        with self.assertRaises(intrinsic.InputError):
            intrinsic.flatten(V, F, max_area_distortion=1)

    def test_lengths_alone(self):
        V, F = support.meshes()["bumpy_grid"]
        lengths = intrinsic.Triangulation(V, F).face_lengths
        m = intrinsic.flatten(None, F, lengths=lengths)
        self.assertIsNone(m.subdivision.V)
        np.testing.assert_allclose(m.log_scale, intrinsic.flatten(V, F).log_scale, atol=1e-9)

    def test_circles(self):
        V, F = support.meshes()["noisy_sphere"]
        m = intrinsic.flatten(V, F)
        np.testing.assert_array_equal(m.radii, 0)
        again = intrinsic.flatten(V, F, radii=np.zeros(len(V)))
        np.testing.assert_array_equal(again.subdivision.image, m.subdivision.image)
        # circles that almost touch, on the edges that are shortest at both ends
        sides = np.concatenate([F[:, [0, 1]], F[:, [1, 2]], F[:, [2, 0]]])
        lengths = np.linalg.norm(V[sides[:, 0]] - V[sides[:, 1]], axis=1)
        radii = np.full(len(V), np.inf)
        np.minimum.at(radii, sides[:, 0], lengths / 2.5)
        radii[::3] = 0
        m = intrinsic.flatten(V, F, radii=radii, unit_square=True)
        self.assertEqual(m.status, "success")
        unscaled = intrinsic.flatten(V, F, radii=dict(enumerate(radii)))
        np.testing.assert_allclose(unscaled.radii, radii * np.exp(unscaled.log_scale), rtol=1e-12)
        S, T = m.subdivision, unscaled.subdivision
        np.testing.assert_allclose(m.radii * np.ptp(T.image), unscaled.radii * np.ptp(S.image),
                                   rtol=1e-9)
        # sides that were not flipped keep their inversive distances
        compared = 0
        original = np.sort(sides, axis=1)
        order = {tuple(s): n for s, n in zip(original, lengths)}
        for face, uv in zip(T.F, T.uv):
            for k in range(3):
                side = tuple(sorted((int(face[k]), int(face[(k + 1) % 3]))))
                r, s = (radii[list(side)] if side in order else (0, 0))
                if r * s == 0:
                    continue
                a, b = unscaled.radii[list(side)]
                length = np.linalg.norm(uv[k] - uv[(k + 1) % 3])
                self.assertAlmostEqual((length ** 2 - a ** 2 - b ** 2) / (2 * a * b),
                                       (order[side] ** 2 - r ** 2 - s ** 2) / (2 * r * s), 6)
                compared += 1
        self.assertGreater(compared, 100)
        for wrong in ({0: -1}, {0: 10}, {0: np.nan}, {len(V): 0}, np.zeros(3)):
            with self.assertRaises(intrinsic.InputError):
                intrinsic.flatten(V, F, radii=wrong)
        with self.assertRaises(intrinsic.InputError):
            intrinsic.flatten(V, F, radii=radii, exact=True)
        with self.assertRaisesRegex(intrinsic.InputError, "use to_sphere"):
            intrinsic.flatten(V, F, radii=radii, boundary="disk")

    def test_failure(self):
        # Without flips there are no such scale factors.
        V, F = support.meshes()["noisy_sphere"]
        cones = {0: 6.2, 1: 6.2, 2: 4 * np.pi - 12.4}
        with self.assertRaises(intrinsic.MapError) as caught:
            intrinsic.flatten(V * [5, 1, 1], F, cones=cones, keep_triangulation=True, mollify=0)
        self.assertEqual(caught.exception.status, "triangle_inequality")
        self.assertIsNone(caught.exception.map)
        self.assertRegex(str(caught.exception), "; nothing is laid out; errors that cannot be "
                         "measured: curvature, exterior_angle; leave out keep_triangulation=True")
        self.assertEqual(intrinsic.flatten(V * [5, 1, 1], F, cones=cones).status, "success")

    def test_advice_names_parameters_and_functions_of_this_package(self):
        named = set()
        for status in ("not_converged", "triangle_inequality", "no_minimum", "wrong_curvature",
                       "not_laid_out", "layout_collapsed", "not_closed", "not_circular",
                       "not_rectangular", "not_convex", "not_inscribed", "not_conformal",
                       "not_glued"):
            for function in ("flatten", "to_sphere", "to_hyperbolic", "uniformize"):
                text = _advice(status, function)
                known = inspect.signature(getattr(intrinsic, function)).parameters
                for name in re.findall(r"(\w+)=", text):
                    if name != "keep_triangulation":  # which only flatten() has, and these follow
                        self.assertIn(name, known, text)
                    named.add(name)
                for name in re.findall(r"(\w+)\(\)", text):
                    self.assertTrue(callable(getattr(intrinsic, name)), text)
                    named.add(name)
        self.assertIn("cones", named)
        self.assertIn("flatten", named)


class Sphere(unittest.TestCase):
    def test_round_spheres(self):
        for name in ("cube", "sphere", "folded_sphere", "ellipsoid", "noisy_sphere"):
            V, F = support.meshes()[name]
            m = intrinsic.to_sphere(V, F)
            self.assertEqual(m.status, "success")
            np.testing.assert_allclose(np.linalg.norm(m.positions, axis=1), 1, rtol=1e-12)
            a, b, c = m.subdivision.image[m.subdivision.FT].transpose(1, 0, 2)
            self.assertGreater((np.cross(b - a, c - a) * a).sum(1).min(), -1e-12, name)
            np.testing.assert_array_equal(m.subdivision.image[: len(V)], m.positions)
            for k in range(3):
                at = m(np.arange(len(F)), np.eye(3)[np.full(len(F), k)])
                np.testing.assert_allclose(at, m.positions[F[:, k]], atol=1e-9)

    def test_hemisphere(self):
        V, F = support.meshes()["bumpy_grid"]
        m = intrinsic.to_sphere(V, F)
        border = np.flatnonzero(((V[:, :2] == 0) | (V[:, :2] == 1)).any(1))
        self.assertTrue(m.is_disk)
        np.testing.assert_allclose(m.positions[border, 2], 0, atol=1e-12)
        self.assertGreater(np.delete(m.positions[:, 2], border).min(), 0)

    def test_circles(self):
        V = np.array([[1, 0, 0], [0, 1, 0], [0, 0, 1], [-1, 0, 0], [0, -1, 0], [0, 0, -1]], float)
        F = [[0, 1, 2], [1, 3, 2], [3, 4, 2], [4, 0, 2], [1, 0, 5], [3, 1, 5], [4, 3, 5], [0, 4, 5]]
        m = intrinsic.to_sphere(V, F, radii=np.full(6, 0.5**0.5))  # they touch
        np.testing.assert_allclose(m.radii, np.pi / 4, rtol=1e-12)
        same = intrinsic.uniformize(V, F, radii=np.full(6, 0.5**0.5)).map
        np.testing.assert_array_equal(same.positions, m.positions)
        np.testing.assert_array_equal(intrinsic.to_sphere(V, F).radii, 0)
        with self.assertRaises(intrinsic.InputError):
            intrinsic.to_sphere(V, F, radii={0: 1, 1: 1})

    def test_torus_is_refused(self):
        with self.assertRaises(intrinsic.InputError):
            intrinsic.to_sphere(*support.meshes()["torus"])


class Uniform(unittest.TestCase):
    def test_types(self):
        expected = {"cube": "sphere", "bumpy_grid": "disk", "torus": "torus",
                    "two_handles": "hyperbolic"}
        for name, kind in expected.items():
            result = intrinsic.uniformize(*support.meshes()[name])
            self.assertEqual((result.type, result.map.status), (kind, "success"))
            self.assertEqual(result.modulus is None, kind != "torus")

    def test_hyperbolic_area(self):
        m = intrinsic.to_hyperbolic(*support.meshes()["two_handles"])
        self.assertAlmostEqual(m.area, 4 * np.pi, 6)  # 2 pi (2 genus - 2)
        self.assertLess(np.linalg.norm(m.subdivision.image, axis=1).max(), 1)

    def test_circles(self):
        V, F = support.meshes()["two_handles"]
        sides = np.concatenate([F[:, [0, 1]], F[:, [1, 2]], F[:, [2, 0]]])
        lengths = np.linalg.norm(V[sides[:, 0]] - V[sides[:, 1]], axis=1)
        radii = np.full(len(V), np.inf)
        np.minimum.at(radii, sides[:, 0], lengths / 2.5)
        radii[::3] = 0
        m = intrinsic.to_hyperbolic(V, F, radii=radii)
        self.assertEqual(m.status, "success")
        self.assertAlmostEqual(m.area, 4 * np.pi, 6)
        np.testing.assert_allclose(np.tanh(m.radii), 2 * radii * np.exp(m.log_scale), rtol=1e-12)
        # sides that were not flipped keep their inversive distances
        compared = 0
        order = {tuple(s): n for s, n in zip(np.sort(sides, axis=1), lengths)}
        S = m.subdivision
        for face, z in zip(S.F, S.uv):
            for k in range(3):
                side = tuple(sorted((int(face[k]), int(face[(k + 1) % 3]))))
                r, s = (radii[list(side)] if side in order else (0, 0))
                p, q = z[k], z[(k + 1) % 3]
                if r * s == 0 or max(p @ p, q @ q) > 0.9:
                    continue
                a, b = m.radii[list(side)]
                cosh = 1 + 2 * (p - q) @ (p - q) / ((1 - p @ p) * (1 - q @ q))
                after = (cosh - np.cosh(a) * np.cosh(b)) / (np.sinh(a) * np.sinh(b))
                before = (order[side] ** 2 - r ** 2 - s ** 2) / (2 * r * s)
                self.assertAlmostEqual(after / before, 1, 6)
                compared += 1
        self.assertGreater(compared, 20)
        same = intrinsic.uniformize(V, F, radii=dict(enumerate(radii))).map
        np.testing.assert_array_equal(same.subdivision.image, S.image)
        zero = intrinsic.to_hyperbolic(V, F, radii=np.zeros(len(V)))
        np.testing.assert_array_equal(zero.subdivision.image,
                                      intrinsic.to_hyperbolic(V, F).subdivision.image)
        np.testing.assert_array_equal(zero.radii, 0)
        for wrong in ({0: -1}, {1: 10}, {len(V): 0}):
            with self.assertRaises(intrinsic.InputError):
                intrinsic.to_hyperbolic(V, F, radii=wrong)

    def test_torus_from_lengths(self):
        # A rectangle of 1 x 2 with its sides glued, in 3 x 4 squares of two faces.
        n, m = 3, 4
        _, F = intrinsic.shapes.torus(n, m)
        across, up = 1 / n, 2 / m
        long = np.hypot(across, up)
        first = np.array([up, long, across])  # opposite to corners a, b, c
        second = np.array([across, up, long])
        lengths = np.repeat([first, second], n * m, axis=0)
        result = intrinsic.uniformize(None, F, lengths=lengths)
        self.assertEqual(result.type, "torus")
        self.assertAlmostEqual(abs(result.modulus), 2, 9)


if __name__ == "__main__":
    unittest.main()
