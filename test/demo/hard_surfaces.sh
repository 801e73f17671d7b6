#!/usr/bin/env bash
# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# The families of hard surfaces are valid meshes, and the survey of their maps counts what is there.
source "$(dirname "${BASH_SOURCE[0]}")/common.bash"
workflow=$tests/../../benchmark/workflow

python3 "$workflow/hard_surfaces.py" surfaces --count 5 --seed 3
python3 - surfaces <<'EOF' || fail 'a surface is not valid'
import sys
from collections import Counter
from fractions import Fraction
from pathlib import Path

def check(path):
    """Each vertex has one fan of faces, all of the same orientation and of exact areas above zero."""
    words = path.read_text().split()
    n, m = int(words[1]), int(words[2])
    point = [list(map(Fraction, map(float, words[4 + 3 * i:7 + 3 * i]))) for i in range(n)]
    start = 4 + 3 * n
    face = [list(map(int, words[start + 4 * i + 1:start + 4 * i + 4])) for i in range(m)]
    side = Counter((f[k - 1], f[k]) for f in face for k in range(3))
    assert max(side.values()) == 1, "an edge has two faces on one side"
    after = {(f[k], f[k - 2]): (f[k], f[k - 1]) for f in face for k in range(3)}
    for v in range(n):
        outgoing = [h for h in after if h[0] == v] if n < 100 else []
        starts = [h for h in outgoing if (h[1], v) not in side]
        assert len(starts) <= 1, "a vertex has several fans"
        if outgoing:
            h, seen = (starts or outgoing)[0], set()
            while h in after and h not in seen:
                seen.add(h)
                h = after[h]
            assert len(seen) == len(outgoing), "a vertex has several fans"
    for a, b, c in face:
        u, w = ([y - x for x, y in zip(point[a], point[d])] for d in (b, c))
        assert any(u[k - 1] * w[k] != u[k] * w[k - 1] for k in range(3)), "a face has no area"
    reached, waiting = {face[0][0]}, [face[0][0]]
    neighbors = {}
    for a, b in side:
        neighbors.setdefault(a, set()).add(b)
        neighbors.setdefault(b, set()).add(a)
    while waiting:
        new = neighbors[waiting.pop()] - reached
        reached |= new
        waiting += new
    assert len(reached) == n <= 2000, "not connected"

paths = sorted(Path(sys.argv[1]).glob("*.off"))
assert len(paths) == 50, len(paths)
for path in paths:
    try:
        check(path)
    except AssertionError as e:
        sys.exit(f"{path}: {e}")
EOF
python3 "$workflow/hard_surfaces.py" again --count 5 --seed 3
diff -r surfaces again || fail 'a seed gives other surfaces'

# Programs that say what they found, whether it is true or not.
mkdir -p few
cp surfaces/polygons_0.off surfaces/limbs_0.off surfaces/tubes_4.off few
say() { # NAME STATISTICS EXIT
  printf '#!/bin/sh\nwhile [ "$1" != --stats ]; do shift; done\necho '"'%s'"' >"$2"\nexit %s\n' "$2" "$3" >"$1"
  chmod +x "$1"
}
say right '{"status": "success", "iterations": 7, "max_curvature_error": 1e-12, "max_cross_ratio_error": 1e-9}' 0
say liar '{"status": "success", "iterations": 7, "max_curvature_error": 1e-3}' 0
say lost '{"status": "success", "iterations": 7, "max_curvature_error": NaN}' 0
say crowded '{"status": "success", "iterations": 300, "crowded_faces": [3, 8], "max_curvature_error": 1e-12, "flipped_triangles": 9}' 0
say mollified '{"status": "success", "iterations": 1, "mollification": 1e-6}' 0
say fails '{}' 1
expect_counts() { # PROGRAM COUNTS: maps, found, crowded, failed, too slow, contradictory, mollified
  python3 "$workflow/survey.py" "./$1" few --failures "$1.txt" >table
  counts=$(grep '^| all' table | head -1 | tr -d ' ' | cut -d'|' -f4-10)
  [ "$counts" = "$2" ] || fail "$1: $counts instead of $2"
}
expect_counts right '11|11|0|0|0|0|0'
expect_counts liar '11|11|0|0|0|11|0'
expect_counts lost '11|11|0|0|0|11|0'
expect_counts crowded '11|0|11|0|0|0|0'
expect_counts mollified '11|11|0|0|0|0|11'
expect_counts fails '11|0|0|11|0|0|0'
[ ! -s right.txt ] || fail 'complaints about what is right'
grep -q '^polygons_0.off disk: max_curvature_error 0.001' liar.txt || fail 'what is contradictory'
for map in plane circles disk rectangle sphere; do
  grep -q "^polygons_0.off $map: failure" fails.txt || fail "no $map of a polygon"
done
grep -q '^limbs_0.off disk' fails.txt && fail 'a disk of a sphere'
true
