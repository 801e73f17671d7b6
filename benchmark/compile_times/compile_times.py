# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Prints how long programs that call one function each take to compile, in seconds of the processor
and compared with a program that only has a mesh: from the headers alone, and with the compiled library.

usage: compile_times.py COMPILER [OPTION ...] --library [OPTION ...]

Options after --library come with the compiled library.
"""

import os
import pathlib
import resource
import subprocess
import sys

RUNS = 3
BASE = "surface_mesh"
PROGRAMS = ["make_Delaunay", "refine", "flatten", "simplify"]


def seconds(command, name, options):
    """Compiles the program once. Other processes change user times too, but those of runs that follow
    each other alike."""
    source = pathlib.Path(__file__).with_name(name + ".cpp")
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    subprocess.run([*command, *options, "-O2", "-c", source, "-o", os.devnull], check=True)
    return resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before


def best(command, name, options):
    """Returns the least time of the program and the least ratio to the base, compiled before it."""
    pairs = []
    for _ in range(RUNS):
        base = seconds(command, BASE, [])
        pairs.append((seconds(command, name, options), base))
    return min(time for time, _ in pairs), min(time / base for time, base in pairs)


def main():
    arguments = sys.argv[1:]
    last = arguments.index("--library")
    command, library = arguments[:last], arguments[last + 1:]
    print(f"{'program':14} {'headers':>16} {'with the library':>20}")
    for name in PROGRAMS:
        columns = [best(command, name, options) for options in ([], library)]
        print(f"{name:14}" + "".join(f"{time:12.1f} s {ratio:4.2f}" for time, ratio in columns),
              flush=True)


if __name__ == "__main__":
    main()
