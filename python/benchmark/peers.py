# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Prints a table of small tasks by `intrinsic` and, if they can be imported, by potpourri3d and
pygeodesic, in one process. Times of the processor in ms, the median of three; each task includes
what the call needs besides arrays, unless it says "next".

usage: PYTHONPATH=build/python:PEERS python3 python/benchmark/peers.py MESH.off ...
"""

import statistics
import sys
import time
from pathlib import Path

import numpy as np

import intrinsic

try:
    import potpourri3d
except ImportError:
    potpourri3d = None
try:
    import pygeodesic.geodesic as pygeodesic
except ImportError:
    pygeodesic = None


def read_off(path):
    words = Path(path).read_text().split()
    n, m = int(words[1]), int(words[2])
    V = np.array(words[4 : 4 + 3 * n], float).reshape(n, 3)
    F = np.array(words[4 + 3 * n : 4 + 3 * n + 4 * m], int).reshape(m, 4)[:, 1:]
    return V, np.ascontiguousarray(F)


def milliseconds(*calls):
    """Return the median time of each call; calls follow each other in each of three rounds."""
    times = [[] for _ in calls]
    for _ in range(3):
        for call, of_call in zip(calls, times):
            start = time.process_time()
            if call is not None:
                call()
            of_call.append(1000 * (time.process_time() - start))
    return [statistics.median(t) if call is not None else None for call, t in zip(calls, times)]


def tasks(V, F):
    """Yield the name of each task, our call, and the peer's with its name."""
    far = len(V) // 2
    p, g = potpourri3d, pygeodesic
    yield ("heat distance", lambda: intrinsic.DistanceSolver(V, F).distance(0), "potpourri3d",
           p and (lambda: p.MeshHeatMethodDistanceSolver(V, F).compute_distance(0)))
    ours = intrinsic.DistanceSolver(V, F)
    theirs = p and p.MeshHeatMethodDistanceSolver(V, F)
    yield ("heat distance, next", lambda: ours.distance(far), "potpourri3d",
           p and (lambda: theirs.compute_distance(far)))
    many = np.linspace(0, len(V) - 1, 32).astype(int)
    yield ("heat distances from each of 32, next", lambda: ours.from_each(many), "potpourri3d",
           p and (lambda: [theirs.compute_distance(int(v)) for v in many]))
    yield ("exact distance", lambda: intrinsic.distance(V, F, 0, "exact"), "pygeodesic",
           g and (lambda: g.PyGeodesicAlgorithmExact(V, F).geodesicDistances(np.array([0]))))
    yield ("vector heat, transport", lambda: intrinsic.transport(V, F, [0], [1 + 0j]),
           "potpourri3d",
           p and (lambda: p.MeshVectorHeatSolver(V, F).transport_tangent_vector(0, [1.0, 0.0])))
    yield ("logarithmic map (theirs by heat)", lambda: intrinsic.log_map(V, F, 0), "potpourri3d",
           p and (lambda: p.MeshVectorHeatSolver(V, F).compute_log_map(0)))
    yield ("geodesic by flips", lambda: intrinsic.geodesic(V, F, [0, far]), "potpourri3d",
           p and (lambda: p.EdgeFlipGeodesicSolver(V, F).find_geodesic_path(0, far)))


def text(value):
    return "" if value is None else f"{value:,.1f}"


def main():
    print("| mesh | vertices | task | ours | peer | peer's |\n| --- | ---: | --- | ---: | --- | ---: |")
    for path in sys.argv[1:]:
        V, F = read_off(path)
        for name, ours, peer, theirs in tasks(V, F):
            own, other = milliseconds(ours, theirs)
            print(f"| {Path(path).stem} | {len(V):,} | {name} | {text(own)} | {peer} "
                  f"| {text(other)} |", flush=True)


if __name__ == "__main__":
    main()
