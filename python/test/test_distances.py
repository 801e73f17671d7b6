# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Distances and paths against closed forms and each other."""

import unittest
import warnings

import numpy as np

import intrinsic
import support


class Exact(unittest.TestCase):
    def test_plane(self):
        V, F = support.turned(*intrinsic.shapes.grid(7, 9))
        V = support.noisy(V, [0.03, 0.03, 0])
        # A convex hull is needed for straight lines: the border is not moved.
        flat, faces = intrinsic.shapes.grid(7, 9)
        inside = (flat[:, 0] % 1 != 0) & (flat[:, 1] % 1 != 0)
        flat[inside] += 0.03 * np.random.default_rng(8).standard_normal((inside.sum(), 3)) * [1, 1, 0]
        flat, faces = support.turned(flat, faces)
        for source in (0, 40):
            d = intrinsic.distance(flat, faces, source, "exact")
            np.testing.assert_allclose(d, np.linalg.norm(flat - flat[source], axis=1), atol=1e-12)

    def test_points_in_faces(self):
        flat, faces = support.turned(*intrinsic.shapes.grid(5, 5))
        random = np.random.default_rng(11)
        where = random.integers(0, len(faces), 6), random.dirichlet([1, 1, 1], 6)
        positions = np.einsum("kc,kcx->kx", where[1], flat[faces[where[0]]])
        d = intrinsic.distance(flat, faces, where, "exact")
        expected = np.linalg.norm(flat[:, None] - positions[None], axis=2).min(axis=1)
        np.testing.assert_allclose(d, expected, atol=1e-12)

    def test_cube(self):
        V, F = support.turned(*intrinsic.shapes.cube())
        source = int(np.argmin(V.sum(1)))
        d2 = intrinsic.distance(V, F, source, "exact") ** 2
        steps = V.sum(1).astype(int)  # how many coordinates differ
        np.testing.assert_allclose(d2, np.array([0, 1, 2, 5])[steps], atol=1e-12)

    def test_unreachable(self):
        V, F = intrinsic.shapes.cube()
        two = np.vstack([V, V + 3]), np.vstack([F, F + 8])
        d = intrinsic.distance(*two, 0)
        self.assertTrue(np.isfinite(d[:8]).all() and np.isinf(d[8:]).all())
        p = intrinsic.path(*two, 0, 9)
        self.assertTrue(np.isinf(p.length) and len(p.faces) == 0 and p.points.shape == (0, 3))


class Frames(unittest.TestCase):
    """On a flat mesh whose edges are far from Delaunay, tangent vectors are vectors of the plane."""

    def setUp(self):
        V, F = intrinsic.shapes.grid(8, 8)
        inside = ((V[:, :2] > 0) & (V[:, :2] < 1)).all(axis=1)
        V = np.where(inside[:, None], support.noisy(V, [0.01, 0.01, 0]), V) @ [[1, 0, 0], [3, 1, 0], [0, 0, 1]]
        self.V, self.F = support.turned(V, F)
        sides = np.vstack([self.F[:, [0, 1]], self.F[:, [1, 2]], self.F[:, [2, 0]]])
        edges, number = np.unique(np.sort(sides, axis=1), axis=0, return_counts=True)
        self.inner = np.setdiff1d(np.arange(len(V)), edges[number == 1])
        self.frames = intrinsic.tangent_frames(self.V, self.F)
        self.axis = self.frames.x[:, 0] + 1j * self.frames.x[:, 1]  # of each vertex, in the plane
        self.assertGreater(intrinsic.Triangulation(self.V, self.F).delaunay(), 100)

    def test_directions(self):
        x, y = self.frames.x, self.frames.y
        np.testing.assert_allclose(self.frames.normals, np.tile([0, 0, 1], (len(x), 1)))
        np.testing.assert_allclose(np.linalg.norm(x, axis=1), 1)
        np.testing.assert_allclose(np.cross(x, y), self.frames.normals, atol=1e-15)
        for v, neighbor in enumerate(self.frames.neighbors):
            self.assertTrue(((self.F == v).any(axis=1) & (self.F == neighbor).any(axis=1)).any())

    def test_logarithms(self):
        for v in self.inner[::5]:
            log = intrinsic.log_map(self.V, self.F, v)
            z = log.vectors[:, None]
            seen = z.real * self.frames.x[v] + z.imag * self.frames.y[v]
            np.testing.assert_allclose(seen[log.is_straight], (self.V - self.V[v])[log.is_straight],
                                       atol=1e-9)

    def test_connection(self):
        for surface in ((self.V, self.F), (intrinsic.Triangulation(self.V, self.F),)):
            C = intrinsic.connection_laplacian(*surface).toarray()[np.ix_(self.inner, self.inner)]
            axis = self.axis[self.inner]
            in_plane = axis[:, None] * C * axis.conj()
            L = intrinsic.laplacian(*surface).toarray()[np.ix_(self.inner, self.inner)]
            np.testing.assert_allclose(in_plane, L, atol=1e-9)

    def test_transport(self):
        # Constant with a short time, since the angles of boundary vertices are scaled.
        source = self.inner[np.argmin(abs(self.V[self.inner] - self.V.mean(axis=0)).sum(axis=1))]
        field = intrinsic.transport(self.V, self.F, source, 1j / self.axis[source],
                                    time_step_factor=0.01) * self.axis
        near = self.inner[np.argsort(np.linalg.norm(self.V[self.inner] - self.V[source], axis=1))[:6]]
        np.testing.assert_allclose(field[near], 1j, atol=1e-3)

    def test_missing(self):
        V = np.vstack([self.V, [[7, 7, 7]]])
        frames = intrinsic.tangent_frames(V, self.F)
        self.assertEqual(frames.neighbors[-1], -1)
        self.assertEqual(abs(frames.x[-1]).max(), 0)
        lengths = np.ones((1, 3))
        with self.assertRaisesRegex(intrinsic.InputError, "positions"):
            intrinsic.tangent_frames(intrinsic.Triangulation(None, [[0, 1, 2]], lengths=lengths))


class Heat(unittest.TestCase):
    def test_errors(self):
        V, F = intrinsic.shapes.icosphere(4)
        exact = intrinsic.distance(V, F, 5, "exact")
        result = intrinsic.distance(V, F, 5, "heat", full=True)
        self.assertEqual(result.method, "heat")
        errors = abs(result.values - exact)[exact > 0] / exact[exact > 0]
        self.assertLess(errors.mean(), 0.03)
        self.assertLess(abs(result.relative_error["mean"] - errors.mean()), 0.02)
        self.assertEqual(intrinsic.distance(V, F, 5, full=True).method, "exact")
        self.assertEqual(intrinsic.distance(V, F, 5, time_step_factor=2, full=True).method, "heat")

    def test_exact_distances_have_no_time_step(self):
        V, F = intrinsic.shapes.icosphere(1)
        for call in (lambda **k: intrinsic.distance(V, F, 0, "exact", **k),
                     lambda **k: intrinsic.signed_distance(V, F, [*F[0], F[0, 0]], "exact", **k),
                     lambda **k: intrinsic.DistanceSolver(V, F, "exact", **k)):
            call()
            for factor in (1, 3.0, -1):
                with self.assertRaisesRegex(intrinsic.InputError, "time_step_factor is for"):
                    call(time_step_factor=factor)
        np.testing.assert_array_equal(
            intrinsic.DistanceSolver(V, F).distance(0),
            intrinsic.DistanceSolver(V, F, time_step_factor=1).distance(0))

    def test_sources(self):
        # Zero at a source, also with rounding; the distance in the face at its corners.
        V, F = intrinsic.shapes.cube()
        solver = intrinsic.DistanceSolver(V * [1, 1, 1e-7], F)
        for v in range(len(V)):
            self.assertEqual(solver.distance(v)[v], 0)
        V, F = intrinsic.shapes.icosphere(2)
        point = [0.2, 0.3, 0.5]
        d = intrinsic.DistanceSolver(V, F).distance(([5], [point]))
        np.testing.assert_allclose(d[F[5]], np.linalg.norm(V[F[5]] - point @ V[F[5]], axis=1),
                                   rtol=1e-12)

    def test_solver(self):
        V, F = support.meshes()["noisy_sphere"]
        solver = intrinsic.DistanceSolver(V, F)
        for sources in (0, [3, 77], ([4, 9], [[0.2, 0.3, 0.5], [1, 0, 0]])):
            once = intrinsic.distance(V, F, sources, "heat")
            many = solver.distance(sources)
            np.testing.assert_allclose(many, once, rtol=1e-9)
        exact = intrinsic.DistanceSolver(V, F, "exact")
        np.testing.assert_allclose(exact.distance([1, 2]),
                                   intrinsic.distance(V, F, [1, 2], "exact"), atol=1e-12)

    def test_no_distance_is_less_than_in_space(self):
        V, F = intrinsic.shapes.grid(12, 12)
        solver = intrinsic.DistanceSolver(V, F)
        straight = np.linalg.norm(V - V[:, None], axis=2)
        for v in (0, 5, 80):
            self.assertTrue((solver.distance(v) >= straight[v] * (1 - 1e-12)).all())
        for is_parallel in (False, True):
            D = solver.from_each(np.arange(len(V)), parallel=is_parallel)
            self.assertTrue((D >= straight * (1 - 1e-12)).all())

    def test_from_each(self):
        V, F = support.turned(*intrinsic.shapes.folded_sphere(3))
        T = intrinsic.Triangulation(V, F)
        vertices = np.arange(0, len(V), 37)
        points = [3, 70], [[0.2, 0.3, 0.5], [0, 0, 1]]
        for method in ("heat", "exact"):
            solver = intrinsic.DistanceSolver(T, method=method)
            D = solver.from_each(vertices)
            self.assertEqual(D.shape, (len(vertices), len(V)))
            for row, v in zip(D, vertices):
                np.testing.assert_allclose(row, solver.distance(v), atol=1e-10)
            np.testing.assert_array_equal(D, solver.from_each(vertices, parallel=True))
            for row, f, b in zip(solver.from_each(points), *points):
                np.testing.assert_allclose(row, solver.distance(([f], [b])), atol=1e-10)
        with self.assertRaises(intrinsic.InputError):
            solver.from_each([len(V)])


class Accuracy(unittest.TestCase):
    def test_warning(self):
        """Heat is wrong on a long strip of thin triangles without positions, and says so."""
        n = 60
        V = np.array([(i / 20, 1e-3 * (i % 2), 0) for i in range(n)])
        F = np.array([(i, i + 1, i + 2) if i % 2 == 0 else (i + 1, i, i + 2) for i in range(n - 2)])
        lengths = support.lengths_of(V, F)
        with self.assertWarns(intrinsic.AccuracyWarning) as caught:
            d = intrinsic.distance(None, F, 0, "heat", lengths=lengths)
        self.assertEqual(caught.filename, __file__)
        self.assertGreater(np.quantile(abs(d[1:] / V[1:, 0] - 1), 0.9), 0.1)
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            exact = intrinsic.distance(None, F, 0, lengths=lengths)
            intrinsic.distance(*intrinsic.shapes.icosphere(3), 0, "heat")
        np.testing.assert_allclose(exact, np.hypot(V[:, 0], V[:, 1]), rtol=1e-12)


class Soups(unittest.TestCase):
    def test_book(self):
        """Five squares at one edge: distances through it are distances in a plane."""
        V, F = intrinsic.shapes.grid(24, 24)
        x = V[:, 0] - V[:, 0].min()
        rows, faces = [], []
        spine = np.flatnonzero(x == 0)
        for k in range(5):
            a = 2 * np.pi * k / 5
            rows.append(np.stack([x * np.cos(a), x * np.sin(a), V[:, 1]], axis=1))
            index = np.arange(len(V)) + k * len(V)
            index[spine] = spine
            faces.append(index[F] if k % 2 == 0 else index[F[:, ::-1]])
        P, faces = np.concatenate(rows), np.concatenate(faces)
        used = np.unique(faces)
        faces = np.searchsorted(used, faces)
        P = P[used]
        source = int(np.flatnonzero(used == np.argmin(abs(V - V.mean(axis=0)).sum(axis=1)))[0])
        d = intrinsic.soup_distance(P, faces, source)
        r = np.hypot(P[:, 0], P[:, 1])
        page = np.where(np.isclose(P[:, 1], 0) & (P[:, 0] >= 0), r, -r)  # unfolded
        flat = np.hypot(page - page[source], P[:, 2] - P[source, 2])
        self.assertLess(abs(d - flat).mean() / flat.max(), 0.02)

    def test_bad_sources(self):
        V, F = intrinsic.shapes.icosphere(1)
        for bad in ([], None, [len(V)], [-1], 0.5, "0", ([0], [[1, 0, 0]])):
            with self.assertRaisesRegex(intrinsic.IntrinsicError, "sources"):
                intrinsic.soup_distance(V, F, bad)


class AllPairs(unittest.TestCase):
    def test_exact_and_coarse(self):
        V, F = support.meshes()["bumpy_grid"]
        D = intrinsic.all_pairs(V, F)
        for v in (0, 40):
            np.testing.assert_allclose(D[v], intrinsic.distance(V, F, v, "exact"), atol=1e-12)
        np.testing.assert_array_equal(D, intrinsic.all_pairs(V, F, parallel=True))
        steps = []
        near = intrinsic.all_pairs(V, F, coarse=60, progress=lambda *step: steps.append(step))
        self.assertEqual(steps[-1], ("all_pairs", 60))
        far = D > 0.5
        self.assertLess((abs(near - D)[far] / D[far]).mean(), 0.02)


class Paths(unittest.TestCase):
    def test_lengths(self):
        random = np.random.default_rng(3)
        for name, (V, F) in support.meshes().items():
            d = intrinsic.distance(V, F, 0, "exact")
            for target in random.integers(1, len(V), 5):
                p = intrinsic.path(V, F, 0, int(target))
                self.assertAlmostEqual(p.length, d[target], 9, name)
                line = np.linalg.norm(np.diff(p.points, axis=0), axis=1).sum()
                self.assertAlmostEqual(line, p.length, 9, name)
                np.testing.assert_allclose(p.points[[0, -1]], V[[0, target]], atol=1e-12)
                positions = np.einsum("kc,kcx->kx", p.barycentric, V[F[p.faces]])
                np.testing.assert_allclose(positions, p.points, atol=1e-12)

    def test_from_points(self):
        flat, faces = support.turned(*intrinsic.shapes.grid(4, 4))
        ends = (3, [0.2, 0.3, 0.5]), (17, [0.1, 0.1, 0.8])
        p = intrinsic.path(flat, faces, *ends)
        positions = [np.array(b) @ flat[faces[f]] for f, b in ends]
        self.assertAlmostEqual(p.length, np.linalg.norm(positions[1] - positions[0]), 12)
        np.testing.assert_allclose(p.points[[0, -1]], positions, atol=1e-12)


class Tangents(unittest.TestCase):
    def test_there_and_back(self):
        for name, (V, F) in support.meshes().items():
            if name in ("cube", "two_handles"):
                continue  # lines hit vertices, and turn at rounding
            source = len(V) // 3
            log = intrinsic.log_map(V, F, source)
            d = intrinsic.distance(V, F, source, "exact")
            np.testing.assert_allclose(abs(log.vectors), d, atol=1e-9, err_msg=name)
            for target in np.flatnonzero(log.is_straight & (d > 0))[:20]:
                line = intrinsic.exp_map(V, F, source, log.vectors[target])
                np.testing.assert_allclose(line.points[-1], V[target], atol=1e-6, err_msg=name)
                np.testing.assert_allclose(line.points[0], V[source], atol=1e-12)

    def test_limit(self):
        V, F = intrinsic.shapes.icosphere(1)
        with self.assertRaisesRegex(intrinsic.LimitError, "1000000 edges; shorten"):
            intrinsic.exp_map(V, F, 0, 1e9)

    def test_boundary(self):
        V, F = intrinsic.shapes.grid(2, 2)
        line = intrinsic.exp_map(V, F, 4, 10)
        self.assertFalse(line.is_complete)
        self.assertAlmostEqual(line.length, np.linalg.norm(line.points[-1] - V[4]), 12)


class Geodesics(unittest.TestCase):
    def test_plane(self):
        flat, faces = support.turned(*intrinsic.shapes.grid(6, 6))
        start, end = 3, 44
        p = intrinsic.geodesic(flat, faces, [start, 20, end])
        self.assertTrue(p.is_complete)
        self.assertAlmostEqual(p.length, np.linalg.norm(flat[start] - flat[end]), 12)
        np.testing.assert_allclose(p.points[[0, -1]], flat[[start, end]], atol=1e-12)

    def test_pairs(self):
        flat, faces = support.turned(*intrinsic.shapes.grid(6, 6))
        pairs = np.array([[3, 44], [44, 3], [0, 48], [7, 7]])
        for (v, w), p in zip(pairs, intrinsic.geodesics(flat, faces, pairs)):
            self.assertTrue(p.is_complete)
            self.assertAlmostEqual(p.length, np.linalg.norm(flat[v] - flat[w]), 12)
            if v != w:
                np.testing.assert_allclose(p.points[[0, -1]], flat[[v, w]], atol=1e-12)
        self.assertEqual(intrinsic.geodesics(flat, faces, np.empty((0, 2), int)), [])

    def test_pairs_of_components(self):
        V, F = intrinsic.shapes.grid(2, 2)
        both = np.concatenate([V, V + [9, 0, 0]]), np.concatenate([F, F + len(V)])
        near, far = intrinsic.geodesics(*both, [[0, 8], [0, 9]])
        self.assertAlmostEqual(near.length, np.linalg.norm(V[8] - V[0]), 12)
        self.assertEqual((far.length, len(far.faces)), (np.inf, 0))

    def test_loops(self):
        V, F = intrinsic.shapes.torus(40, 20, radius=2, tube=1)
        meridian = intrinsic.geodesic(V, F, [0, 5, 10, 15], loop=True)
        circle = np.linalg.norm(np.diff(V[[*range(20), 0]], axis=0), axis=1).sum()
        self.assertTrue(0.99 * circle < meridian.length <= circle)
        none = intrinsic.geodesic(V, F, [0, 1, 21], loop=True)  # around a face
        self.assertEqual((none.length, len(none.faces)), (0, 0))
        T = intrinsic.Triangulation(V, F)
        T.refine(20)
        self.assertEqual(intrinsic.geodesic(T, None, [0, 5, 10, 15], loop=True).length,
                         meridian.length)


class Curves(unittest.TestCase):
    def test_homology(self):
        around, tube, radius = 40, 20, 3
        V, F = intrinsic.shapes.torus(around, tube, radius=radius, tube=0.5)
        loops = intrinsic.homology_loops(V, F)
        # A polygon around the tube, and the inner equator: both consist of edges.
        lengths = 2 * tube * 0.5 * np.sin(np.pi / tube), 2 * around * (radius - 0.5) * np.sin(np.pi / around)
        self.assertEqual(len(loops), 2)
        for loop, length in zip(loops, lengths):
            self.assertTrue(loop.is_complete)
            self.assertLessEqual(loop.length, length + 1e-12)
            self.assertGreater(loop.length, 0.98 * length)
            np.testing.assert_allclose(loop.points[0], loop.points[-1], atol=1e-12)
            steps = np.linalg.norm(np.diff(loop.points, axis=0), axis=1)
            self.assertAlmostEqual(steps.sum(), loop.length, 11)
        self.assertEqual(intrinsic.homology_loops(*intrinsic.shapes.icosphere(1)), [])
        self.assertEqual(intrinsic.homology_loops(*intrinsic.shapes.grid(3, 3)), [])

    def test_level_set(self):
        V, F = support.turned(*intrinsic.shapes.grid(9, 7))
        slope = V @ [1, 2, 0]
        line, = intrinsic.level_set(V, F, slope, 1.3)
        np.testing.assert_allclose(line.points @ [1, 2, 0], 1.3, atol=1e-14)
        self.assertAlmostEqual(line.length, np.hypot(1, 0.5), 12)
        self.assertEqual(intrinsic.level_set(V, F, slope, 3.5), [])
        V, F = intrinsic.shapes.icosphere(3)
        d = intrinsic.distance(V, F, 0)
        circle, = intrinsic.level_set(V, F, d, 1)
        np.testing.assert_array_equal(circle.points[0], circle.points[-1])
        between = np.einsum("pc,pc->p", d[F[circle.faces]], circle.barycentric)
        np.testing.assert_allclose(between, 1, atol=1e-12)
        for values in (d[1:], np.full(len(V), np.nan), None):
            with self.assertRaises(intrinsic.IntrinsicError):
                intrinsic.level_set(V, F, values, 1)

    def test_infinite_values(self):
        V, F = intrinsic.shapes.icosphere(2)
        V, F = np.vstack([V, V + 5, [[9, 9, 9]]]), np.vstack([F, F + len(V)])
        d = intrinsic.distance(V, F, 0)
        self.assertEqual(np.isinf(d).sum(), len(V) // 2 + 1)
        circle, = intrinsic.level_set(V, F, d, 1)
        self.assertLess(abs(circle.points).max(), 1 + 1e-12)
        d[30] = np.inf
        with self.assertRaisesRegex(intrinsic.InputError, "infinite at some vertices") as caught:
            intrinsic.level_set(V, F, d, 1)
        self.assertIn(30, F[caught.exception.face])
        self.assertEqual(caught.exception.row, 30)

    def test_distances(self):
        V, F = support.turned(*intrinsic.shapes.grid(10, 10))
        line, = intrinsic.level_set(V, F, V[:, 0], 0.37)
        d = intrinsic.distance(V, F, curve=(line.faces, line.barycentric), method="exact")
        np.testing.assert_allclose(d, abs(V[:, 0] - 0.37), atol=1e-14)
        corner = int(np.argmin(V.sum(axis=1)))
        both = intrinsic.distance(V, F, corner, "exact", curve=(line.faces, line.barycentric))
        np.testing.assert_allclose(both, np.minimum(d, np.linalg.norm(V - V[corner], axis=1)), atol=1e-14)
        for method, error in (("exact", 1e-14), ("heat", 0.03)):
            solver = intrinsic.DistanceSolver(V, F, method)
            found = solver.distance(curve=(line.faces, line.barycentric))
            np.testing.assert_allclose(found, d, atol=error)
        with self.assertRaises(intrinsic.ArrayError):
            solver.distance()


class Transport(unittest.TestCase):
    def test_plane(self):
        flat, faces = intrinsic.shapes.grid(8, 8)
        inside = np.flatnonzero(((flat[:, :2] > 0) & (flat[:, :2] < 1)).all(1))
        field = intrinsic.transport(flat, faces, inside[:1], [1j])
        # The grid has the same edges at all vertices inside: frames are parallel. At the boundary
        # they are not, which has an effect on heat nearby.
        np.testing.assert_allclose(field[inside], 1j, atol=0.05)

    def test_one_vector_for_each_vertex(self):
        V, F = intrinsic.shapes.icosphere(2)
        once = intrinsic.transport(V, F, [4, 0], [1j, 1])
        np.testing.assert_allclose(intrinsic.transport(V, F, [4, 0, 4], [1j, 1, 1j]), once, atol=1e-9)
        for vertices, vectors, rows in (([0, 0], [1, 1j], "0 and 1"), ([4, 0, 4], [1j, 1, 1], "0 and 2")):
            with self.assertRaisesRegex(intrinsic.InputError, "different vectors, in rows " + rows) as caught:
                intrinsic.transport(V, F, vertices, vectors)
            self.assertEqual(caught.exception.vertex, vertices[0])
            self.assertEqual(caught.exception.row, len(vertices) - 1)

    def test_solver_keeps_its_triangulation(self):
        V, F = support.meshes()["bumpy_grid"]
        T = intrinsic.Triangulation(V, F)
        T.delaunay()
        solver = intrinsic.DistanceSolver(T)
        before = solver.distance(5)
        T.refine(25, 0.05)
        np.testing.assert_array_equal(solver.distance(5), before)

    def test_isolated_vertices(self):
        V, F = intrinsic.shapes.cube()
        V = np.vstack([V, [[9, 9, 9]]])
        for method in ("exact", "heat"):
            self.assertTrue(np.isinf(intrinsic.distance(V, F, 0, method)[8]))
            d = intrinsic.distance(V, F, 8, method)
            self.assertEqual(d[8], 0)
            self.assertTrue(np.isinf(d[:8]).all())
        for call in (lambda: intrinsic.path(V, F, 0, 8), lambda: intrinsic.log_map(V, F, 8),
                     lambda: intrinsic.exp_map(V, F, 8, 1), lambda: intrinsic.vertex_point(F, 8)):
            with self.assertRaises(intrinsic.InputError):
                call()


class Signed(unittest.TestCase):
    def test_straight_line(self):
        V, F = intrinsic.shapes.grid(20, 20)
        middle = np.flatnonzero(V[:, 0] == 0.5)
        up = middle[np.argsort(V[middle, 1])]
        d = intrinsic.signed_distance(V, F, up)
        np.testing.assert_allclose(d, V[:, 0] - 0.5, atol=1e-15)
        np.testing.assert_allclose(intrinsic.signed_distance(V, F, up[::-1]), -d, atol=1e-15)
        by_heat = intrinsic.signed_distance(V, F, up, "heat", full=True)
        self.assertEqual(by_heat.method, "heat")
        np.testing.assert_allclose(by_heat.values, d, atol=0.03)

    def test_method(self):
        V, F = intrinsic.shapes.torus(24, 12)
        meridian, opposite = [*range(12), 0], [144, *range(155, 143, -1)]
        both = intrinsic.signed_distance(V, F, [meridian, opposite], full=True)
        self.assertEqual(both.method, "exact")
        self.assertEqual(abs(both.values[[*range(12), *range(144, 156)]]).max(), 0)
        np.testing.assert_array_equal(np.sign(both.values[12:144]), -np.sign(both.values[156:]))
        one = intrinsic.signed_distance(V, F, meridian, full=True)
        self.assertEqual(one.method, "heat")
        with self.assertRaises(intrinsic.InputError):
            intrinsic.signed_distance(V, F, meridian, "exact")

    def test_curves_of_points(self):
        V, F = support.turned(*intrinsic.shapes.grid(10, 10))
        middle = np.flatnonzero(V[:, 0] == 0.5)
        up = middle[np.argsort(V[middle, 1])]
        d = intrinsic.signed_distance(V, F, up)
        found = [intrinsic.vertex_point(F, v) for v in up]
        curve = np.concatenate([f for f, _ in found]), np.concatenate([b for _, b in found])
        np.testing.assert_allclose(intrinsic.signed_distance(V, F, curve), d, atol=1e-9)
        halves = [up[:6], up[5:]]
        np.testing.assert_allclose(intrinsic.signed_distance(V, F, halves), d, atol=1e-9)

    def test_curves_that_are_paths(self):
        V, F = intrinsic.shapes.grid(10, 10)
        line, = intrinsic.level_set(V, F, V[:, 0], 0.37)  # with greater values on its left
        d = 0.37 - V[:, 0]
        np.testing.assert_allclose(intrinsic.signed_distance(V, F, line), d, atol=1e-12)
        np.testing.assert_allclose(intrinsic.distance(V, F, curve=line), abs(d), atol=1e-12)
        solver = intrinsic.DistanceSolver(V, F, "exact")
        np.testing.assert_allclose(solver.distance(curve=line), abs(d), atol=1e-12)
        end = intrinsic.path(V, F, 0, 10)  # along the side x = 0 or y = 0, which is another part
        both = intrinsic.distance(V, F, curve=[line, end])
        np.testing.assert_allclose(
            both, np.minimum(abs(d), intrinsic.distance(V, F, curve=end)), atol=1e-12)
        mixed = intrinsic.distance(V, F, curve=[line, [0, 1]])
        self.assertEqual(mixed[1], 0)
        self.assertTrue((mixed <= abs(d) + 1e-12).all())

    def test_path_without_points_is_no_curve(self):
        V, F = intrinsic.shapes.grid(3, 3)
        nowhere = intrinsic.path(np.vstack([V, V + [9, 0, 0]]), np.vstack([F, F + len(V)]), 0,
                                 len(V))
        self.assertEqual(len(nowhere.faces), 0)
        with self.assertRaisesRegex(intrinsic.InputError, "fewer than two points"):
            intrinsic.signed_distance(V, F, nowhere)


if __name__ == "__main__":
    unittest.main()
