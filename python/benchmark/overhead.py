# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Prints a table of the time that calls take, the part of it that is spent outside of the compiled
part, and the time of a C++ program that makes the same result of the same arrays, for a folded
sphere. The compiled part makes the mesh, as C++ does; it also copies positions and checks edge
lengths. Calls of both sides take turns. Times of the processor, the least of many.

usage: PYTHONPATH=build/python python3 python/benchmark/overhead.py PROGRAM [LEVEL ...]

PROGRAM is made of calls.cpp.
"""

import subprocess
import sys
import tempfile
import time

import numpy as np

import intrinsic
from intrinsic import _core

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
SECONDS = 4  # for the calls of a row
LEAST_ROUNDS, REPETITIONS = 2, 3  # each side repeats its call, since the other one empties caches


class Compiled:
    """Counts the time in functions of the compiled part, and keeps its objects to time their end."""

    def __init__(self):
        self.nanoseconds, self.kept = 0, []
        for name, thing in list(vars(_core).items()):
            if isinstance(thing, type):
                for member, value in list(vars(thing).items()):
                    if isinstance(value, staticmethod):
                        setattr(thing, member, staticmethod(self.timed(value.__func__)))
                    elif member == "__init__" or callable(value) and not member.startswith("_"):
                        setattr(thing, member, self.timed(value))
            elif callable(thing):
                setattr(_core, name, self.timed(thing))

    def timed(self, function):
        def call(*arguments, **named):
            start = time.process_time_ns()
            result = function(*arguments, **named)
            self.nanoseconds += time.process_time_ns() - start
            self.kept.append((arguments, result))
            return result

        return call


def milliseconds(call, compiled, *arguments):
    """Return the least time of a call, and of its part that is not compiled."""
    times = []
    for _ in range(REPETITIONS):
        compiled.nanoseconds, start = 0, time.process_time_ns()
        call(*arguments)
        end = time.process_time_ns()
        compiled.kept.clear()
        times.append(((time.process_time_ns() - start) / 1e6, (end - start - compiled.nanoseconds) / 1e6))
    return np.min(times, axis=0)


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


def compared(call, compiled, program, name, V, F):
    """Return the least times of Python, of its part that is not compiled, and of C++."""
    times, end = [], time.monotonic() + SECONDS
    while len(times) < LEAST_ROUNDS or time.monotonic() < end:
        times.append((*milliseconds(call, compiled, V, F), program(name, REPETITIONS)))
    return np.min(times, axis=0)


def main():
    compiled = Compiled()
    print("\n| call | vertices | Python (ms) | not compiled (ms) | overhead | C++ (ms) |\n"
          "| --- | ---: | ---: | ---: | ---: | ---: |")
    for level in map(int, sys.argv[2:] or ["5", "6"]):
        V, F = intrinsic.shapes.folded_sphere(level)
        program = Program(sys.argv[1], V, F)
        for name, (text, call) in CALLS.items():
            ours, python, theirs = compared(call, compiled, program, name, V, F)
            print(f"| `{text}` | {len(V):,} | {ours:,.1f} | {python:.2f} "
                  f"| {100 * python / ours:.2g} % | {theirs:,.1f} |", flush=True)
        program.end()


if __name__ == "__main__":
    main()
