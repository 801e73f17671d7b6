# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Results are those of the program, to the bit."""

import re
import tempfile
import unittest
from pathlib import Path

import numpy as np
from numpy.testing import assert_array_equal

import intrinsic
import support
from support import printed_by_program, run_info, run_program


def faces_of(corners, starts):
    return [corners[a:b] for a, b in zip(starts, starts[1:])]


def assert_faces_equal(ours, theirs):
    for a, b in zip(ours, theirs, strict=True):
        assert_array_equal(a, b)


def assert_sparse_equal(ours, theirs):
    """Files have no entries that are zero, or have them."""
    assert_array_equal(ours.shape, theirs.shape)
    assert (ours != theirs).nnz == 0


def assert_connections_equal(ours, theirs):
    """The frames differ: Python has the frames of the input, and the program those of --save."""
    a, b = ours.toarray(), theirs.toarray()
    np.testing.assert_allclose(abs(a), abs(b), rtol=1e-9, atol=1e-12 * abs(b).max())
    np.testing.assert_allclose(np.linalg.eigvalsh(a), np.linalg.eigvalsh(b), atol=1e-9 * abs(b).max())


@support.needs_program
class Program(unittest.TestCase):
    def each(self, *left_out, instead=None):
        """Generate ten meshes; copies of the mesh `instead` replace those that are left out."""
        number = len(left_out)
        for name, (V, F) in support.meshes().items():
            if name not in left_out:
                self.mesh = name  # in tracebacks
                yield V, F
        for k, (V, F) in enumerate(support.stretched(*instead, number) if instead else []):
            self.mesh = k
            yield V, F

    def test_delaunay(self):
        for V, F in self.each():
            stats, files, texts = run_program("delaunay", V, F, "--save", "FOLDER/T.save",
                                              output="out.ply")
            T = intrinsic.Triangulation(V, F)
            self.assertEqual(T.delaunay(), stats["flips"])
            S, mesh = T.common_subdivision(), files["out.ply"]
            assert_array_equal(S.V, mesh.points)
            assert_faces_equal(faces_of(S.corners, S.starts), mesh.faces)
            assert_array_equal(S.input_face, mesh.face["input_face"])
            assert_array_equal(S.intrinsic_face, mesh.face["intrinsic_face"])
            self.assertEqual(T._core.to_text(), texts["T.save"])

    def test_exact_refine(self):
        for V, F in self.each():
            stats, files, texts = run_program("refine", V, F, "--exact", "--min-angle", "20",
                                              "--save", "FOLDER/T.save", output="out.ply")
            T = intrinsic.Triangulation(V, F, exact=True)
            flips = T.delaunay()
            report = T.refine(20)
            self.assertEqual(report.flips + flips, stats["flips"])
            self.assertEqual(report.status, stats["status"])
            self.assertEqual(T._core.to_text(), texts["T.save"])
            certificate = T.certify()
            self.assertEqual(certificate.is_delaunay, stats["certified"])
            self.assertEqual(len(certificate.ties), stats["ties"])
            self.assertEqual(certificate.decisions, stats["decisions"])

    def test_operators(self):
        for V, F in self.each():
            _, files, _ = run_program("operators", V, F, "--prefix", "FOLDER/P")
            ours = {"laplacian": intrinsic.laplacian(V, F),
                    "mass": intrinsic.mass(V, F, lumped=False),
                    "lumped_mass": intrinsic.mass(V, F),
                    "gradient": intrinsic.gradient(V, F),
                    "divergence": intrinsic.divergence(V, F)}
            for name, matrix in ours.items():
                assert_sparse_equal(matrix, files[f"P_{name}.mtx"].tocsc())
            assert_connections_equal(intrinsic.connection_laplacian(V, F),
                                     files["P_connection_laplacian.mtx"].tocsc())

    def test_distance(self):
        for V, F in self.each():
            for options, given in [(["--method", "exact"], {"method": "exact"}),
                                   (["--method", "heat"], {"method": "heat"}), ([], {}),
                                   (["--time-step", "2"], {"time_step_factor": 2})]:
                _, files, _ = run_program("distance", V, F, "--source", "3", "--source", "1", *options,
                                          output="out.ply")
                assert_array_equal(intrinsic.distance(V, F, [3, 1], **given),
                                   files["out.ply"].vertex["distance"])
            point = ([2], [[0.25, 0.25, 0.5]])
            _, files, _ = run_program("distance", V, F, "--source", "2:0.25,0.25,0.5",
                                      output="out.ply")
            assert_array_equal(intrinsic.distance(V, F, point), files["out.ply"].vertex["distance"])

    def test_path(self):
        for V, F in self.each():
            target = len(V) - 1
            stats, _, _ = run_program("path", V, F, "--from", "0", "--to", f"{target}",
                                      output="out.vtp")
            p = intrinsic.path(V, F, 0, target)
            self.assertEqual(p.length, stats["length"])
            self.assertEqual(len(p.faces), len(stats["places"]))

    def test_geodesic(self):
        for V, F in self.each("cube", instead=intrinsic.shapes.icosphere(2)):
            third, half = len(V) // 3, len(V) // 2
            stats, _, _ = run_program("path", V, F, "--from", "0", "--via", str(third), "--to",
                                      str(half), "--flips", output="out.vtp")
            p = intrinsic.geodesic(V, F, [0, third, half])
            self.assertEqual(p.length, stats["length"])
            self.assertEqual(p.is_complete, stats["status"] == "geodesic")
            self.assertEqual(len(p.faces), len(stats["places"]))

    def test_signed_distance(self):
        for V, F in self.each("cube"):
            p = intrinsic.path(V, F, 0, len(V) // 2)
            if len(p.faces) < 3:
                continue
            lines = "\n".join(f"v {x!r} {y!r} {z!r}" for x, y, z in p.points.tolist())
            chain = "l " + " ".join(str(i + 1) for i in range(len(p.points)))
            with tempfile.NamedTemporaryFile("w", suffix=".obj") as curve:
                curve.write(f"{lines}\n{chain}\n")
                curve.flush()
                _, files, _ = run_program("distance", V, F, "--curve", curve.name, "--signed",
                                          output="out.ply")
            ours = intrinsic.signed_distance(V, F, (p.faces, p.barycentric))
            # Files have positions, whose faces and coordinates are found again.
            np.testing.assert_allclose(ours, files["out.ply"].vertex["distance"],
                                       atol=1e-6 * abs(ours).max())

    def test_signed_distance_on_polygons(self):
        """The program splits squares. The boundary of one is the curve."""
        V, _ = support.bumpy_grid()
        first = np.array([i for i in range(len(V)) if i % 9 < 8 and i + 9 < len(V)])
        squares = np.stack([first, first + 1, first + 10, first + 9], axis=1)
        loop = [*squares[20], squares[20][0]]
        with tempfile.NamedTemporaryFile("w", suffix=".obj") as curve:
            curve.writelines(f"v {x!r} {y!r} {z!r}\n" for x, y, z in V[loop].tolist())
            curve.write("l 1 2 3 4 5\n")
            curve.flush()
            _, files, texts = run_program("distance", V, squares, "--curve", curve.name, "--signed",
                                          "--save", "FOLDER/T.save", output="out.ply")
        with tempfile.NamedTemporaryFile("w", suffix=".save") as saved:
            saved.write(texts["T.save"])
            saved.flush()
            F = intrinsic.Triangulation.load(saved.name).input_F
        assert_array_equal([np.unique(f) for f in F.reshape(-1, 6)], np.sort(squares))
        assert_array_equal(intrinsic.signed_distance(V, F, loop), files["out.ply"].vertex["distance"])

    def test_lengths_instead_of_positions(self):
        for V, F in self.each():
            given = {"lengths": support.lengths_of(V, F)}
            _, files, _ = run_program("operators", V, F, "--prefix", "FOLDER/P")
            assert_sparse_equal(intrinsic.laplacian(None, F, **given),
                                files["P_laplacian.mtx"].tocsc())
            assert_connections_equal(intrinsic.connection_laplacian(None, F, **given),
                                     files["P_connection_laplacian.mtx"].tocsc())
            _, files, _ = run_program("distance", V, F, "--source", "3", output="out.ply")
            assert_array_equal(intrinsic.distance(None, F, 3, **given),
                               files["out.ply"].vertex["distance"])
            stats, _, _ = run_program("path", V, F, "--from", "0", "--to", "5", "--flips",
                                      output="out.vtp")
            self.assertEqual(intrinsic.geodesic(None, F, [0, 5], **given).length, stats["length"])
            _, files, _ = run_program("flatten", V, F, output="out.obj")
            assert_array_equal(intrinsic.flatten(None, F, **given).subdivision.image,
                               files["out.obj"].texture)

    def test_transfer(self):
        for V, F in self.each():
            random = np.random.default_rng(6)
            faces, b = random.integers(0, len(F), 9), random.dirichlet([1, 1, 1], 9)
            text = "\n".join(f"{f}:{x!r},{y!r},{z!r}" for f, (x, y, z) in zip(faces, b.tolist()))
            values = V[:, 0] + V[:, 2] ** 2
            T = intrinsic.Triangulation(V, F)
            T.delaunay()
            T.refine(20)
            with tempfile.TemporaryDirectory() as folder:
                points, data = Path(folder, "points.txt"), Path(folder, "data.txt")
                points.write_text(text + "\n")
                data.write_text("".join(f"{i} {x!r}\n" for i, x in enumerate(values.tolist())))
                options = "--min-angle", "20", "--save", "FOLDER/places.save"
                _, _, texts = run_program("transfer", V, F, "--points", str(points), *options,
                                          output="out.save")
                there, (found, coordinates) = texts["out.save"], T.transfer((faces, b))
                for line, face, place in zip(there.splitlines(), found, coordinates, strict=True):
                    word = line.split()[1]
                    self.assertEqual(int(word.split(":")[0]), face)
                    self.assertEqual([float(x) for x in word.split(":")[1].split(",")],
                                     place.tolist())
                _, _, texts = run_program("transfer", V, F, "--data", str(data), *options,
                                          output="out.save")
                assert_array_equal([float(line.split()[1])
                                    for line in texts["out.save"].splitlines()], T.transfer(values))

    def test_hyperbolic(self):
        for V, F in support.stretched(*support.two_handles(), 10):
            stats, files, _ = run_program("hyperbolic", V, F, output="out.obj")
            m = intrinsic.to_hyperbolic(V, F)
            assert_array_equal(m.subdivision.image, files["out.obj"].texture)
            self.assertEqual(m.area, stats["area"])
        V, F = support.two_handles()
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder, "radii.txt")
            path.write_text("".join(f"{v} 0.01\n" for v in range(len(V))))
            _, files, _ = run_program("hyperbolic", V, F, "--radii", str(path), output="out.obj")
        m = intrinsic.to_hyperbolic(V, F, radii=np.full(len(V), 0.01))
        assert_array_equal(m.subdivision.image, files["out.obj"].texture)

    def test_info(self):
        for V, F in self.each():
            stats = run_info(V, F)
            ours = intrinsic.info(V, F)
            for name in ("vertices", "edges", "faces", "min_angle_degrees", "min_edge_length",
                         "max_edge_length", "is_valid"):
                self.assertEqual(getattr(ours, name), stats[name])

    def test_flatten(self):
        for V, F in self.each():
            self.compare_flat(V, F, intrinsic.flatten(V, F))

    def test_prescribed_cones(self):
        for V, F in support.stretched(*support.bumpy_grid(), 10):
            sides = np.sort(F[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2), axis=1)
            edges, number = np.unique(sides, axis=0, return_counts=True)
            inside = np.setdiff1d(np.arange(len(V)), edges[number == 1])
            values = {int(inside[3]): 1.0, int(inside[9]): -0.5, int(inside[20]): 0.0}
            with tempfile.TemporaryDirectory() as folder:
                path = Path(folder, "cones.txt")
                path.write_text("".join(f"{v} {x!r}\n" for v, x in values.items()))
                self.compare_flat(V, F, intrinsic.flatten(V, F, cones=values), "--cones", str(path))

    def test_boundaries(self):
        for V, F in self.each("cube", "sphere", "folded_sphere", "ellipsoid", "noisy_sphere",
                              "torus", "flat_torus", "two_handles"):
            for boundary in ("straight", "disk", "rectangle"):
                m = intrinsic.flatten(V, F, boundary=boundary)
                self.compare_flat(V, F, m, "--boundary", boundary)

    def test_circles(self):
        for V, F in self.each("cube"):
            radii = np.full(len(V), np.inf)
            for k in range(3):
                lengths = np.linalg.norm(V[F[:, k]] - V[F[:, (k + 1) % 3]], axis=1)
                np.minimum.at(radii, F[:, k], lengths / 10)
            with tempfile.TemporaryDirectory() as folder:
                path = Path(folder, "radii.txt")
                path.write_text("".join(f"{v} {r!r}\n" for v, r in enumerate(radii.tolist())))
                m = intrinsic.flatten(V, F, radii=radii)
                self.compare_flat(V, F, m, "--radii", str(path))

    def compare_flat(self, V, F, m, *options):
        stats, files, _ = run_program("flatten", V, F, *options, output="out.obj")
        S, mesh = m.subdivision, files["out.obj"]
        assert_array_equal(S.V, mesh.points)
        assert_array_equal(S.image, mesh.texture)
        assert_faces_equal(faces_of(S.corners, S.starts), mesh.faces)
        assert_faces_equal(faces_of(S.corner_image, S.starts), mesh.texture_faces)
        self.assertEqual(m.iterations, stats["iterations"])
        self.assertEqual(len(m.cones), stats["cones"])
        self.assertEqual(m.log_scale.min(), stats["log_scale_min"])

    def test_sphere(self):
        instead = intrinsic.shapes.folded_sphere(2)
        for V, F in self.each("torus", "flat_torus", "two_handles", instead=instead):
            _, files, _ = run_program("sphere", V, F, output="out.ply")
            mesh, m = files["out.ply"], intrinsic.to_sphere(V, F)
            assert_array_equal(m.subdivision.image, mesh.points)
            assert_array_equal(m.positions, mesh.points[: len(V)])
            assert_faces_equal(faces_of(m.subdivision.corners, m.subdivision.starts), mesh.faces)

    def test_uniformize(self):
        for V, F in self.each():
            result = intrinsic.uniformize(V, F)
            kind = "ply" if result.type in ("sphere", "disk") else "obj"
            stats, files, _ = run_program("uniformize", V, F, output=f"out.{kind}")
            self.assertEqual(result.type, stats["surface_type"])
            mesh, S = files[f"out.{kind}"], result.map.subdivision
            assert_array_equal(S.image, mesh.points if kind == "ply" else mesh.texture)
            if result.modulus is not None:
                self.assertEqual([result.modulus.real, result.modulus.imag], stats["modulus"])

    def test_simplify_options(self):
        """Each option of the program has a parameter."""
        for V, F in self.each("cube", instead=intrinsic.shapes.icosphere(2)):
            n, size = len(V) // 3, float(np.ptp(V))
            for options, given in [
                ([], {}),
                (["--weight", "curvature=1", "--weight", "x=0.5"],
                 {"weights": {"curvature": 1, "x": 0.5}, "functions": {"x": V[:, 0]}}),
                (["--refine", "20"], {"refine": 20}),
                (["--min-angle", "20"], {"min_angle": 20}),
                (["--refine", "25", "--min-angle", "25", "--max-insertions", "30"],
                 {"refine": 25, "min_angle": 25, "max_insertions": 30}),
                (["--close-loops", f"{9 * size}", "--pinch-handles", f"{9 * size}"],
                 {"close_loops": 9 * size, "pinch_handles": 9 * size}),
                (["--refine", "20", "--close-loops", f"{9 * size}", "--exact"],
                 {"refine": 20, "close_loops": 9 * size, "exact": True}),
            ]:
                self.compare_simplified(V, F, ["--vertices", str(n), *options], n, given)

    def compare_simplified(self, V, F, options, n, given):
        stats, files, _ = run_program("simplify", V, F, *options, "--prolongation", "FOLDER/P.mtx",
                                      "--coarse", "FOLDER/coarse.ply", output="out.ply",
                                      mesh="mesh.ply")
        coarse = intrinsic.simplify(V, F, n, **given)
        self.assertEqual(coarse.status, stats["status"])
        self.assertEqual(coarse.refinement_status, stats.get("coarse_refinement_status"))
        self.assertEqual(coarse.input_refinement_status, stats.get("refinement_status"))
        self.assertEqual(coarse.removed, stats["removed"])
        self.assertEqual(coarse.greatest_cost, stats["greatest_cost"])
        self.assertEqual(coarse.closed_loops, stats.get("closed_loops", 0))
        self.assertEqual(coarse.pinched_handles, stats.get("pinched_handles", 0))
        assert_sparse_equal(coarse.prolongation, files["P.mtx"].tocsc())
        mesh, written = coarse.coarse_mesh(), files["coarse.ply"]
        assert_array_equal(mesh.V, written.points)
        assert_faces_equal(mesh.F, written.faces)
        assert_array_equal(mesh.input_vertex, written.vertex["input_vertex"])

    def test_levels(self):
        for V, F in self.each("cube", instead=intrinsic.shapes.icosphere(2)):
            stats, files, _ = run_program(
                "simplify", V, F, "--vertices", str(len(V) // 4), "--levels", "3", "--prolongation",
                "FOLDER/P.mtx", output="out.ply")
            levels = intrinsic.simplify(V, F, stats["level_vertices"])
            self.assertEqual([len(v) for v in levels.level_vertices], stats["level_vertices"])
            for k, P in enumerate(levels.prolongations):
                assert_sparse_equal(P, files[f"P_{k + 1}.mtx"].tocsc())

    def test_net(self):
        """Triangles with halved sides are folded to tetrahedra."""
        random = np.random.default_rng(12)
        F = [[0, 3, 5], [3, 1, 4], [5, 4, 2], [3, 4, 5]]
        glue = [[0, 3, 1, 3], [1, 4, 2, 4], [2, 5, 0, 5]]
        for _ in range(10):
            corners = np.array([[0, 0, 0], [2, 0, 0], [1, 1.7, 0]]) + random.uniform(-0.2, 0.2, (3, 3))
            V = np.vstack([corners, (corners + np.roll(corners, -1, axis=0)) / 2])
            with tempfile.NamedTemporaryFile("w", suffix=".txt") as sides:
                sides.writelines(" ".join(map(str, row)) + "\n" for row in glue)
                sides.flush()
                stats, files, _ = run_program("convex", V, F, "--glue", sides.name, output="out.off")
            p = intrinsic.convex_polyhedron(V, F, glue=glue)
            assert_array_equal(p.V, files["out.off"].points)
            assert_faces_equal(p.F, files["out.off"].faces)
            assert_array_equal(p.vertex_map, stats["vertex_map"])

    def test_convex(self):
        for V, F in self.each("folded_sphere", "noisy_sphere", "torus", "flat_torus", "bumpy_grid",
                              "strip", "two_handles", instead=intrinsic.shapes.icosphere(1)):
            _, files, _ = run_program("convex", V, F, output="out.off")
            p = intrinsic.convex_polyhedron(V, F)
            assert_array_equal(p.V, files["out.off"].points)
            assert_faces_equal(p.F, files["out.off"].faces)

    def test_pack(self):
        instead = support.bumpy_grid(5)
        for V, F in self.each("torus", "flat_torus", "two_handles", instead=instead):
            stats, files, _ = run_program("pack", V, F, output="out.ply")
            packing, mesh = intrinsic.pack_circles(V, F), files["out.ply"]
            centers = np.zeros((len(V), 3))
            centers[:, : packing.centers.shape[1]] = packing.centers
            assert_array_equal(centers, mesh.points)
            assert_array_equal(packing.radii, mesh.vertex["radius"])
            self.assertEqual(packing.is_disk, stats["disk"])
            self.assertEqual(packing.max_tangency_error, stats["max_tangency_error"])
            for same in (None, 1e-300 * V, 1e200 * V):
                assert_array_equal(intrinsic.pack_circles(same, F).centers, packing.centers)

    def test_soups(self):
        V = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [0, -1, 0.2]])
        F = np.array([[0, 1, 2], [1, 0, 3], [0, 1, 4]])
        _, files, _ = run_program("operators", V, F, "--prefix", "FOLDER/P")
        soup = intrinsic.soup_operators(V, F)
        assert_sparse_equal(soup.laplacian, files["P_laplacian.mtx"].tocsc())
        assert_sparse_equal(soup.mass, files["P_lumped_mass.mtx"].tocsc())
        _, files, _ = run_program("distance", V, F, "--source", "3", "--source", "1",
                                  output="out.ply")
        assert_array_equal(intrinsic.soup_distance(V, F, [3, 1]), files["out.ply"].vertex["distance"])

    def test_page(self):
        V, F = support.meshes()["cube"]
        try:
            page = intrinsic.show(V, F, open=False, z_value=V[:, 2])
        except intrinsic.MissingPartError as error:
            self.assertIn("three.js", str(error))
            self.skipTest(str(error))
        self.assertIn("z_value", page.html)
        self.assertIn("<iframe srcdoc=", page._repr_html_())
        arrays = re.compile('id="arrays">([^<]+)<')
        for V, F in self.each():
            theirs = printed_by_program(V, F, "view", "-o", "-")
            self.assertEqual(arrays.search(intrinsic.show(V, F, open=False).html)[1],
                             arrays.search(theirs)[1])
        V, F = support.meshes()["cube"]
        name = "\u00e9 <b>"
        page = intrinsic.show(V, F, open=False, **{name: V[:, 0]})
        self.assertIn(r'"\u00e9 \u003cb>"', page.html)
        with self.assertRaises(intrinsic.ArrayError):
            intrinsic.show(V, F, open=False, f=V)


if __name__ == "__main__":
    unittest.main()
