# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Prints a table of the time that calls take in Python and in C++, from the same arrays of a folded
sphere. Both sides make the mesh and free the result. Python also checks the arrays, copies the
positions and makes the arrays of the result. Calls of both take turns. Times of the processor, the
least of many.

usage: PYTHONPATH=build/python python3 python/benchmark/overhead.py PROGRAM [LEVEL ...]

PROGRAM is made of calls.cpp.
"""

import subprocess
import sys
import tempfile
import time

import numpy as np

import intrinsic

CALLS = {
    "delaunay": ("Triangulation(V, F).delaunay()", lambda V, F: intrinsic.Triangulation(V, F).delaunay()),
    "laplacian": ("laplacian(V, F)", intrinsic.laplacian),
    "exact": ('distance(V, F, 0, "exact")', lambda V, F: intrinsic.distance(V, F, 0, "exact")),
    "heat": ('distance(V, F, 0, "heat")', lambda V, F: intrinsic.distance(V, F, 0, "heat")),
    "path": ("path(V, F, 0, 1)", lambda V, F: intrinsic.path(V, F, 0, 1)),
    "flatten": ("flatten(V, F)", intrinsic.flatten),
    "to_sphere": ("to_sphere(V, F)", intrinsic.to_sphere),
    "simplify": ("simplify(V, F, 1000)", lambda V, F: intrinsic.simplify(V, F, 1000)),
}
SECONDS = 10  # for the calls of a row
LEAST_ROUNDS, REPETITIONS = 4, 3  # each side repeats its call, since the other one empties caches


def milliseconds(call, repetitions, *arguments):
    times = []
    for _ in range(repetitions):
        start = time.process_time_ns()
        call(*arguments)
        times.append((time.process_time_ns() - start) / 1e6)
    return min(times)


class Program:
    """The other side, which holds the same arrays."""

    def __init__(self, path, V, F):
        with tempfile.NamedTemporaryFile() as arrays:
            arrays.write(np.array([len(V), len(F)]).tobytes() + V.tobytes() + F.tobytes())
            arrays.flush()
            self.process = subprocess.Popen([path, arrays.name], text=True, stdin=subprocess.PIPE,
                                            stdout=subprocess.PIPE)
            self("delaunay", 1)  # has read the arrays

    def __call__(self, name, repetitions):
        print(name, repetitions, file=self.process.stdin, flush=True)
        return float(self.process.stdout.readline())

    def end(self):
        self.process.communicate()


def compared(call, program, name, V, F):
    """Return the least time of both sides."""
    times, end = [], time.monotonic() + SECONDS
    while len(times) < LEAST_ROUNDS or time.monotonic() < end:
        times.append((milliseconds(call, REPETITIONS, V, F), program(name, REPETITIONS)))
    return np.min(times, axis=0)


def main():
    print("\n| call | vertices | Python (ms) | C++ (ms) | overhead |\n| --- | ---: | ---: | ---: | ---: |")
    for level in map(int, sys.argv[2:] or ["5", "6"]):
        V, F = intrinsic.shapes.folded_sphere(level)
        program = Program(sys.argv[1], V, F)
        for name, (text, call) in CALLS.items():
            ours, theirs = compared(call, program, name, V, F)
            print(f"| `{text}` | {len(V):,} | {ours:,.1f} | {theirs:,.1f} "
                  f"| {100 * (ours - theirs) / theirs:.1f} % |", flush=True)
        program.end()


if __name__ == "__main__":
    main()
