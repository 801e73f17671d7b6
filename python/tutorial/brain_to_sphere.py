# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""A spherical map of a folded surface, such as a brain.

Folded surfaces of genus zero are compared on the sphere. The map keeps angles. The vertices become
vertices of a convex polyhedron, so that no triangle is turned over.
"""

import numpy as np

import intrinsic

V, F = intrinsic.shapes.folded_sphere(5, folds=7, depth=0.3)
map = intrinsic.to_sphere(V, F)
on_sphere = map.positions
print(map, "of", len(V), "vertices; errors and bounds:", map.promises)
assert np.allclose(np.linalg.norm(on_sphere, axis=1), 1)

# ---- A function of the surface, averaged over the sphere ----

radius = np.linalg.norm(V, axis=1)
outer, inner = on_sphere[radius > 1.1], on_sphere[radius < 0.9]
print(f"{len(outer)} vertices outside, {len(inner)} in folds")

# ---- The same place on a second surface: the nearest vertex on the sphere ----

other, _ = intrinsic.shapes.folded_sphere(5, folds=7, depth=0.2)
other_on_sphere = intrinsic.to_sphere(other, F).positions


def rotation(to, of):
    """The rotation that moves the points `of` as near to the points `to` as possible."""
    u, _, v = np.linalg.svd(to.T @ of)
    return u @ np.diag([1, 1, np.linalg.det(u @ v)]) @ v


turned = other_on_sphere @ rotation(on_sphere, other_on_sphere).T
distance = np.degrees(np.arccos(np.clip((turned * on_sphere).sum(axis=1), -1, 1)))
print(f"corresponding vertices are {distance.mean():.2f} degrees apart on average")
assert distance.mean() < 5
