# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""From a bad scan to the eigenfunctions of its Laplacian.

A scan has triangles that are not joined, faces of any orientation, and needles. Repair makes a
surface of it; the intrinsic Delaunay triangulation makes good triangles of the surface.
"""

import numpy as np
from scipy.sparse.linalg import eigsh

import intrinsic

# ---- A scan: every triangle has three points of its own, some faces are reversed ----

sphere, faces = intrinsic.shapes.icosphere(4)
shape = sphere * [1.0, 1.0, 0.08]  # a lens, with needles at its rim
random = np.random.default_rng(0)
scan_V = shape[faces].reshape(-1, 3)
scan_F = np.arange(len(scan_V)).reshape(-1, 3)
reversed_faces = random.random(len(scan_F)) < 0.3
scan_F[reversed_faces] = scan_F[reversed_faces, ::-1]

report = intrinsic.info(scan_V, scan_F)
print(f"{report.components} components, smallest angle {report.min_angle_degrees:.1f} degrees")

# ---- Repair, and what it has done ----

mesh = intrinsic.repair(scan_V, scan_F)
print("repaired:", mesh.report)
assert intrinsic.info(mesh).is_valid and len(mesh.V) == len(sphere)

# ---- The Laplacian of the intrinsic Delaunay triangulation ----

T = intrinsic.Triangulation(mesh)
extrinsic = intrinsic.laplacian(T).toarray()  # before flips: that of the mesh
print(T.delaunay(), "flips")
L, M = intrinsic.laplacian(T), intrinsic.mass(T)


def greatest_off_diagonal(matrix):
    return (matrix - np.diag(np.diag(matrix))).max()


print(f"greatest entry off the diagonal: {greatest_off_diagonal(extrinsic):.3g} of the mesh, "
      f"{greatest_off_diagonal(L.toarray()):.1g} of the triangulation")
assert greatest_off_diagonal(L.toarray()) < 1e-9  # a maximum principle holds

# ---- Eigenfunctions: vibrations of the surface, the lowest first ----

values, functions = eigsh(L, 6, M, sigma=-0.01)
print("eigenvalues:", values.round(3))
assert abs(values[0]) < 1e-9 and values[1] > 0.1
