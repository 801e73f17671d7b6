# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Distances and paths on a CAD mesh.

The triangles of CAD meshes are as long as the parts are straight. Distances by windows are exact on
every triangulation; heat needs good triangles, which the intrinsic triangulation has.
"""

import numpy as np

import intrinsic

# ---- A rod of two faces on each side: no vertex but the corners ----

cube, F = intrinsic.shapes.cube()
V = cube * [10.0, 1.0, 1.0]
corner, opposite = 0, 7

# ---- Exact: unfolded, the shortest path is a straight line ----

path = intrinsic.path(V, F, corner, opposite)
print(f"the shortest path has the length {path.length:.4f} and {len(path.points)} points")
assert np.isclose(path.length, np.hypot(10, 2))
assert np.isclose(np.linalg.norm(np.diff(path.points, axis=0), axis=1).sum(), path.length)

# ---- Points between vertices are faces with barycentric coordinates ----

middle = intrinsic.path(V, F, (0, [0.2, 0.3, 0.5]), (5, [1 / 3, 1 / 3, 1 / 3]))
positions = [np.array([0.2, 0.3, 0.5]) @ V[F[0]], V[F[5]].mean(axis=0)]
assert np.allclose(middle.points[[0, -1]], positions)

# ---- More vertices where there are none: refinement keeps the surface ----

T = intrinsic.Triangulation(V, F)
report = T.refine(25, max_circumradius=0.2)
print(f"{report.insertions} vertices inserted: {report.status}")
on_input = T.inserted  # where they are: faces and barycentric coordinates
exact = intrinsic.DistanceSolver(T, method="exact").distance(corner)
assert np.allclose(exact, intrinsic.distance(V, F, corner))

# ---- The direction of each vertex: a map of the neighborhood ----

log = intrinsic.log_map(V, F, corner)
assert np.allclose(abs(log.vectors), exact)
line = intrinsic.exp_map(V, F, corner, log.vectors[1])
assert np.allclose(line.points[-1], V[1])
print("angles at the corner, in degrees:", np.degrees(np.angle(log.vectors[[1, 2, 4]])).round(1))
