#!/usr/bin/env bash
# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# scripts/read_results.py reads all that the program writes. Skipped without numpy and scipy.
source "$(dirname "${BASH_SOURCE[0]}")/common.bash"

for python in python3 /usr/bin/python3 ''; do
  if [ -n "$python" ] && "$python" -c 'import numpy, scipy' 2>err; then break; fi
done
[ -n "$python" ] || { echo 'SKIPPED: numpy or scipy is missing'; exit 77; }
reader=$tests/../../scripts/read_results.py

# holds EXPRESSIONS...: all are true, with `read` of the reader.
holds()
{
  PYTHONPATH=$(dirname "$reader") "$python" - "$@" <<'PYTHON' || fail 'read_results'
import sys
import numpy as np
from read_results import read
for claim in sys.argv[1:]:
    assert eval(claim), claim
PYTHON
}

grid flat 8 0

# Each format has what the others have.
for name in a.ply a.vtp b.ply; do
  expect 0 distance flat.mesh.off --source 0 -o $name $([ $name = b.ply ] && echo --binary) --quiet
done
expect 0 delaunay flat.mesh.off -o a.off --quiet
expect 0 delaunay flat.mesh.off -o d.ply --quiet
holds '(read("a.ply").points == read("flat.mesh.off").points).all()' \
  'all((read(f).vertex["distance"] == read("a.ply").vertex["distance"]).all() for f in ["b.ply", "a.vtp"])' \
  'all((read(f).points == read("a.ply").points).all() for f in ["b.ply", "a.vtp"])' \
  'all(np.array_equal(read(f).faces, read("a.ply").faces) for f in ["b.ply", "a.vtp"])' \
  'np.abs(read("a.ply").vertex["distance"] - np.hypot(*read("a.ply").points.T[:2])).max() < .1' \
  'len(read("d.ply").edges) == len(read("d.ply").edge["input_edge"]) == 3 * 64 + 16' \
  'len(read("a.off").faces) == len(read("d.ply").faces) == 128'

# Colors and normals of .obj are neither positions nor texture coordinates.
printf 'v 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 0 1 0 0 0 1\nvn 0 0 1\nf 1//1 2//1 3//1\n' > normals.mesh.obj
expect 0 delaunay normals.mesh.obj -o n.obj --quiet
holds 'read("n.obj").points.tolist() == [[0, 0, 0], [1, 0, 0], [0, 1, 0]]' \
  'read("n.obj").vertex["green"].tolist() == [0, 1, 0]' \
  '[len(f) for f in read("n.obj").texture_faces] == [0]'

# Matrices: on the unit square the mass is one, constants are in the kernel of the symmetric Laplacian,
# and the gradient of a linear function has length one.
expect 0 operators flat.mesh.off --prefix m --quiet
holds 'abs(read("m_mass.mtx").sum() - 1) < 1e-12' 'abs(read("m_laplacian.mtx") @ np.ones(81)).max() < 1e-12' \
  'abs(read("m_laplacian.mtx") - read("m_laplacian.mtx").T).max() == 0' \
  'abs(read("m_connection_laplacian.mtx") - read("m_connection_laplacian.mtx").getH()).max() == 0' \
  'np.allclose(np.hypot(*(read("m_gradient.mtx") @ read("flat.mesh.off").points[:, 0]).reshape(-1, 2).T), 1)'

# Maps, hierarchies, paths and statistics.
expect 0 flatten flat.mesh.off -o f.obj --stats f.json --quiet
expect 0 simplify flat.mesh.off -o s.vtp --ratio 0.3 --prolongation P.mtx --quiet
expect 0 path flat.mesh.off --from 0 --to 80 -o p.vtp --quiet
expect 0 path flat.mesh.off --from 0 --to 80 -o p.obj --quiet
holds 'read("f.json")["status"] == "success"' 'read("f.obj").texture.shape[1] == 2' \
  '[len(f) for f in read("f.obj").faces] == [len(f) for f in read("f.obj").texture_faces]' \
  'np.allclose(read("P.mtx") @ np.ones(read("P.mtx").shape[1]), 1)' \
  'len(read("s.vtp").lines) > 0' 'len(read("s.vtp").face["coarse_face"]) == len(read("s.vtp").faces)' \
  'len(read("p.vtp").lines[0]) == len(read("p.obj").lines[0]) > 2' \
  'abs(np.linalg.norm(np.diff(read("p.vtp").points[read("p.vtp").lines[0]], axis=0), axis=1).sum() - 2 ** .5) < 1e-12'

"$python" "$reader" a.ply P.mtx f.json >said || fail 'the reader as a program'
grep -q '81 vertices; 128 faces; vertex: distance' said || fail "$(cat said)"
