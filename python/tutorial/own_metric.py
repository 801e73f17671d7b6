# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""An own metric, without positions.

Lengths are enough. Column i of `lengths` has the side opposite to corner i of each face; the two
faces of an edge must agree.
"""

import numpy as np

import intrinsic

# ---- A flat torus of width 1 and height 2: it has no place in space ----

n, m = 8, 12
_, F = intrinsic.shapes.torus(n, m)  # only how faces are joined
across, up = 1 / n, 2 / m
long = np.hypot(across, up)
lengths = np.repeat([[up, long, across], [across, up, long]], n * m, axis=0)

T = intrinsic.Triangulation(None, F, lengths=lengths)
print(T, "with", T.delaunay(), "flips")
assert np.isclose(intrinsic.mass(T).sum(), 2)

# ---- Distances, as in the plane with all copies of the source ----

d = intrinsic.distance(None, F, 0, "exact", lengths=lengths)
i, j = np.divmod(np.arange(n * m), m)
x, y = i * across, j * up
expected = np.hypot(np.minimum(x, 1 - x), np.minimum(y, 2 - y))
assert np.allclose(d, expected)

# ---- Its conformal class is a number ----

result = intrinsic.uniformize(None, F, lengths=lengths)
print(result.type, "with modulus", np.round(result.modulus, 9))
assert result.type == "torus" and np.isclose(result.modulus, 2j)

# ---- Another metric: lengths are scaled near vertex 0 ----

scale = 0.5 * np.exp(-20 * d * d)  # logarithms of factors, at vertices
i, j, k = F.T
stretched = lengths * np.exp(np.stack([scale[j] + scale[k], scale[k] + scale[i],
                                       scale[i] + scale[j]], axis=1) / 2)
print("the area is now", round(float(intrinsic.mass(None, F, lengths=stretched).sum()), 3))
flat = intrinsic.uniformize(None, F, lengths=stretched)
# Scaling is discretely conformal where edges stay Delaunay: the modulus hardly changes.
print("and the modulus", np.round(flat.modulus, 4))
assert abs(flat.modulus - 2j) < 0.001
