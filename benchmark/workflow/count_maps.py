#!/usr/bin/env python3
# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""count_maps.py PROGRAM FOLDER LIST: counts the maps to the plane that the program finds with flips and
in fixed triangulations, for the meshes of a folder that a list names, one in a line."""

import sys
from pathlib import Path

from run import run

TIMEOUT = 60  # seconds of the processor for each map
METHODS = {"flips": [], "fixed triangulations": ["--solver", "cetm"]}


def main():
    program, folder, names = Path(sys.argv[1]).resolve(), Path(sys.argv[2]), Path(sys.argv[3])
    meshes = [folder / name for name in names.read_text().split()]
    print("| method | meshes | maps found | with edges made longer |\n| --- | ---: | ---: | ---: |")
    for method, options in METHODS.items():
        rows = [run(program, mesh, TIMEOUT, "flatten", ["-o", "OUT.obj", *options]) for mesh in meshes]
        found = [row for row in rows if row["outcome"] == "success"]
        longer = sum("mollification" in row["statistics"] for row in found)
        print(f"| {method} | {len(meshes)} | {len(found) - longer} | {longer} |", flush=True)


if __name__ == "__main__":
    main()
