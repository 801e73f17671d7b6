# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""A texture for a closed surface.

A closed surface has no map to the plane without cuts. Cones are placed, the surface is cut through
them, and each triangle keeps its angles.
"""

import numpy as np

import intrinsic

V, F = intrinsic.shapes.folded_sphere(4)
map = intrinsic.flatten(V, F, unit_square=True)
print(map, "with", len(map.cones), "cones")

# ---- Texture coordinates at the corners of faces, as files have them ----

S = map.subdivision  # faces are cut where edges of the flat triangulation cross them
print(f"{len(F)} faces, {len(S.F)} in the subdivision, {len(S.cut_vertices)} vertices on the cut")
lines = ["v %r %r %r" % tuple(p) for p in S.V.tolist()]
lines += ["vt %r %r" % tuple(z) for z in S.image.tolist()]
lines += ["f " + " ".join(f"{v + 1}/{t + 1}" for v, t in zip(face, texture))
          for face, texture in zip(S.F.tolist(), S.FT.tolist())]
obj = "\n".join(lines)  # write it to a file, and any program shows it
assert obj.count("\nf ") == len(S.F)

# ---- No triangle is turned over, and sizes change as the scale factors say ----

a, b, c = S.uv.transpose(1, 0, 2)
area = ((b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0]) / 2
assert (area > 0).all() and S.image.min() >= 0 and S.image.max() <= 1
print(f"scale factors from {np.exp(map.log_scale.min()):.2f} to {np.exp(map.log_scale.max()):.2f}")

# ---- The map takes any point: where is the center of face 7? ----

print("the center of face 7 is at", map([7], [[1 / 3, 1 / 3, 1 / 3]])[0].round(4))
