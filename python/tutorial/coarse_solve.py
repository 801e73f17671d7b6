# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""A coarse solve, and its prolongation.

Simplification removes vertices and keeps the distances on the surface. The prolongation maps a
solution on the coarse surface to all vertices.
"""

import numpy as np
from scipy.sparse.linalg import splu

import intrinsic

V, F = intrinsic.shapes.folded_sphere(5)
coarse = intrinsic.simplify(V, F, 1000)
P = coarse.prolongation
print(coarse, "greatest cost of a removal:", round(coarse.greatest_cost, 4))
assert np.allclose(P.sum(axis=1), 1) and P.min() >= 0

# ---- Diffusion for some time, on both surfaces ----

time = 0.02
L, M = intrinsic.laplacian(V, F), intrinsic.mass(V, F)
right_side = M @ (V[:, 2] > 0.5).astype(float)
fine = splu((M + time * L).tocsc()).solve(right_side)

T = coarse.triangulation()  # it has lengths, and needs no positions
L2, M2 = intrinsic.laplacian(T), intrinsic.mass(T)
approximate = P @ splu((M2 + time * L2).tocsc()).solve(P.T @ right_side)

error = np.sqrt((approximate - fine) @ M @ (approximate - fine) / (fine @ M @ fine))
print(f"with {len(coarse.vertices)} of {len(V)} vertices, the relative error is {error:.2%}")
assert error < 0.05

# ---- Points go there and back ----

points = np.arange(5), np.full((5, 3), 1 / 3)
back = coarse.to_fine(coarse.to_coarse(points))
center = V[F[:5]].mean(axis=1)
assert np.allclose(np.einsum("kc,kcx->kx", back[1], V[F[back[0]]]), center, atol=1e-6)
