# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Prints a table of how long calls take for a folded sphere, and which part of that is spent before the
algorithm: on checking arrays and on making the mesh of them. Times of the processor, the least of five.

usage: PYTHONPATH=build/python python3 python/benchmark/overhead.py [LEVEL ...]
"""

import sys
import time

import intrinsic
from intrinsic import _meshes

CALLS = {
    "Triangulation(V, F).delaunay()": lambda V, F: intrinsic.Triangulation(V, F).delaunay(),
    "laplacian(V, F)": intrinsic.laplacian,
    'distance(V, F, 0, "exact")': lambda V, F: intrinsic.distance(V, F, 0, "exact"),
    'distance(V, F, 0, "heat")': lambda V, F: intrinsic.distance(V, F, 0, "heat"),
    "path(V, F, 0, 1)": lambda V, F: intrinsic.path(V, F, 0, 1),
    "flatten(V, F)": intrinsic.flatten,
    "to_sphere(V, F)": intrinsic.to_sphere,
    "simplify(V, F, 1000)": lambda V, F: intrinsic.simplify(V, F, 1000),
}


def seconds(call, *arguments):
    times = []
    for _ in range(5):
        start = time.process_time()
        call(*arguments)
        times.append(time.process_time() - start)
    return min(times)


def main():
    for level in map(int, sys.argv[1:] or ["6"]):
        V, F = intrinsic.shapes.folded_sphere(level)
        arrays = seconds(_meshes.arrays, V, F)
        before = seconds(_meshes.surface, V, F)
        print("\n| call | vertices | ms | arrays | arrays and mesh |\n| --- | ---: | ---: | ---: | ---: |")
        for name, call in CALLS.items():
            whole = seconds(call, V, F)
            print(f"| `{name}` | {len(V):,} | {1000 * whole:,.0f} | {100 * arrays / whole:.2g} % "
                  f"| {100 * before / whole:.2g} % |", flush=True)


if __name__ == "__main__":
    main()
