#!/usr/bin/env python3
# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Builds and runs benchmarks, and writes their tables into doc/PACKAGE/tables, from where pages of the
manual include them, and a summary of them. Without names of tables all are made, except long ones. A
table is replaced only if its benchmark succeeds."""

import argparse
import datetime
import os
import re
import subprocess
import sys
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
IT, DCM, IS = "Intrinsic_triangulations", "Discrete_conformal_maps", "Intrinsic_simplification"
CGAL_MESHES, GENERATED = "meshes of CGAL's data", "generated meshes"
MIXED = CGAL_MESHES + " and generated meshes"


class Run:
    """A benchmark: files of its tables in the order in which it prints them ('-' skips one), its command,
    meshes, names with which the chosen rows begin, and its target if this is not the command."""

    def __init__(self, files, command, meshes, rows=(), target=None, long=False):
        self.files, self.meshes, self.rows, self.long = files.split(), meshes, rows, long
        self.target = target or command.split()[0]
        self.command = command if target else "{build}/benchmark/" + command

    def names(self):
        return [file.split("/")[1] for file in self.files if file != "-"]


WORKFLOW = "{python} benchmark/workflow/"
ALL, REFINED, SMALL = (f"benchmark/meshes/{name}.txt" for name in ("all", "refined", "small"))

RUNS = [
    Run(f"{IT}/Delaunay", "benchmark_Delaunay", CGAL_MESHES),
    Run(f"{IT}/exact_decisions", "benchmark_exactness", MIXED),
    Run(f"{IT}/robustness", "benchmark_robustness 1000 200", "near-degenerate meshes of the tests"),
    Run(f"{IT}/refinement - -", "benchmark_refinement", CGAL_MESHES),
    Run(f"{IT}/simplicial", "benchmark_simplicial @" + ALL, "the manifold meshes of " + ALL),
    Run(f"{IT}/shortest_paths", "benchmark_shortest_paths", CGAL_MESHES),
    Run(f"{IT}/edge_paths", "benchmark_edge_paths --paths 300 @" + ALL, "the surfaces of " + ALL,
        rows=("armadillo", "all")),
    Run(f"{IT}/heat", "benchmark_heat", CGAL_MESHES),
    # $SIGNED_DISTANCE_PEER is `--peer PROGRAM`, or empty.
    Run(f"{IT}/signed_distance {IT}/signed_sections",
        "benchmark_signed_distance $SIGNED_DISTANCE_PEER 256 "
        "{meshes}/fandisk.off {meshes}/camel.off {meshes}/armadillo.off {meshes}/refined_elephant.off "
        "{meshes}/ChineseDragon-10kv.off", MIXED),
    Run(f"{IT}/soups {IT}/irregular_soups", "benchmark_tufted", CGAL_MESHES + ", and soups made from them"),
    Run(f"{IT}/flip_to", "benchmark_flip_to", CGAL_MESHES),
    Run(f"{IT}/convex_polyhedra", "benchmark_convex_polyhedron", GENERATED),
    Run(f"{IT}/threads {DCM}/map_threads {IS}/simplification_threads", "benchmark_parallel",
        "a generated torus with a million faces"),
    Run(f"{IT}/pages", "{python} benchmark/Intrinsic_triangulations/benchmark_pages.py {build}/intrinsic",
        "a generated torus", target="intrinsic"),
    Run(f"{IT}/python_calls",
        "env PYTHONPATH={build}/python {python} python/benchmark/overhead.py {build}/python/intrinsic_calls",
        "a generated sphere", target="intrinsic_calls"),
    # $PYTHON_PEERS is the path of the modules potpourri3d and pygeodesic.
    Run(f"{IT}/python_peers", "env PYTHONPATH={build}/python:$PYTHON_PEERS {python} python/benchmark/peers.py "
        "{meshes}/armadillo.off {meshes}/lion-head.off {meshes}/refined_elephant.off", CGAL_MESHES,
        target="intrinsic_python", long=True),
    Run(f"{DCM}/flatten", "benchmark_flatten", MIXED),
    Run(f"{DCM}/flatten_Eigen", "benchmark_flatten_Eigen {meshes}/armadillo.off 130000", MIXED),
    Run(f"{DCM}/sphere", "benchmark_sphere", MIXED),
    Run(f"{DCM}/hyperbolic", "benchmark_hyperbolic", GENERATED),
    Run(f"{DCM}/cones", "benchmark_cones", CGAL_MESHES),
    Run(f"{DCM}/minimizers", "benchmark_minimizers", CGAL_MESHES),
    Run(f"{DCM}/layouts", "benchmark_layout", CGAL_MESHES),
    Run(f"{DCM}/circles", "benchmark_circles", CGAL_MESHES),
    Run(f"{DCM}/circle_maps",
        WORKFLOW + "hard_surfaces.py {build}/circle_surfaces --count 5 --seed 4177 && "
        "{build}/benchmark/benchmark_circle_maps 5 {build}/circle_surfaces/*.off",
        "surfaces of benchmark/workflow/hard_surfaces.py", target="benchmark_circle_maps", long=True),
    Run(f"{DCM}/circle_packings", "benchmark_circle_packings 1000 10000", GENERATED),
    Run(f"{DCM}/hard_problems", "benchmark_flatten_robustness", "generated meshes of the tests"),
    Run(f"{DCM}/maps_found",
        WORKFLOW + "count_maps.py {build}/intrinsic {meshes} " + SMALL, "meshes of " + SMALL, target="intrinsic"),
    Run(f"{DCM}/survey_families {DCM}/survey_maps",
        WORKFLOW + "hard_surfaces.py {build}/surfaces --count 100 --seed 404 && "
        + WORKFLOW + "survey.py {build}/intrinsic {build}/surfaces --timeout 60",
        "surfaces of benchmark/workflow/hard_surfaces.py", target="intrinsic", long=True),
    Run(f"{IS}/simplify {IS}/resolutions", "benchmark_simplify", MIXED),
    Run(f"{IS}/quality {IS}/quality_means", "benchmark_simplify_quality", MIXED),
    Run(f"{IS}/distortion", "benchmark_distortion", MIXED),
    Run(f"{IS}/distances {IS}/all_pairs", "benchmark_distances", CGAL_MESHES),
    Run(f"{IS}/multigrid", "benchmark_multigrid", MIXED),
    Run(f"{IS}/pieces", "benchmark_pieces", CGAL_MESHES),
    Run(f"{IS}/coarse_refinement", "benchmark_coarse_refinement @" + REFINED, "meshes of " + REFINED),
    Run(f"{IS}/topology", "benchmark_topology {meshes}/cheese.off 0.01 0.02 0.05 0.1", "cheese of CGAL's data"),
]

# Rows of the summary: a task, what it is compared with, a table, and a row and a column of it for each side.
SUMMARY = [
    ("Delaunay flips of the armadillo", "CGAL's `Intrinsic_Delaunay_triangulation_3`, which keeps no correspondence",
     f"{IT}/Delaunay", ("armadillo", "construction and flips (ms)"), ("armadillo", "CGAL (ms)")),
    ("exact distances from a vertex of the armadillo", "CGAL's `Surface_mesh_shortest_path`",
     f"{IT}/shortest_paths", ("armadillo", "all distances (s)"), ("armadillo", "CGAL (s)")),
    ("common subdivisions after flips, of 1,000 near-degenerate meshes", "signposts", f"{IT}/robustness",
     ("flips to Delaunay | integer coordinates", "with a common subdivision"),
     ("flips to Delaunay | signposts", "with a common subdivision")),
    ("maps to the plane of the meshes of `benchmark/meshes/small.txt`",
     "fixed triangulations, with the same rule for cones", f"{DCM}/maps_found", ("flips", "maps found"),
     ("fixed triangulations", "maps found")),
    ("error of a Poisson solution on a coarse surface, relative to one weight", "edge collapses with quadrics",
     f"{IS}/quality_means", ("geometric mean", "default"), ("geometric mean", "quadrics")),
]
SUMMARY_FILE = f"{IT}/summary"


def path_of(file):
    """Returns the file of a table PACKAGE/NAME."""
    package, name = file.split("/")
    return ROOT / "doc" / package / "tables" / (name + ".md")


def cells_of(row):
    return [cell.strip() for cell in row.strip().strip("|").split("|")]


def tables_in(output):
    """Returns tables as lists of lines, each with headings and a rule at its beginning."""
    lines, result = output.splitlines(), []
    for line, following in zip(lines, [*lines[1:], ""]):
        if re.fullmatch(r"\|(?: *:?-+:? *\|)+", following.strip()):
            result.append([])
        if line.startswith("|") and result:
            result[-1].append("| " + " | ".join(cells_of(line)) + " |")
    return result


def chosen_rows(table, names):
    """Returns headings and the rows whose first cell begins with one of the names, or all."""
    return table[:2] + [row for row in table[2:] if not names or row[2:].startswith(tuple(names))]


def machine(build):
    """Returns the processor, the compiler, the date, and whether other processes disturb times."""
    processor = re.search(r"model name\s*: (.*)", Path("/proc/cpuinfo").read_text())
    found = next(build.glob("CMakeFiles/*/CMakeCXXCompiler.cmake")).read_text()
    compiler = [re.search(rf'CMAKE_CXX_COMPILER_{key} "(.*)"', found)[1] for key in ("ID", "VERSION")]
    parts = [processor[1] if processor else "unknown processor", " ".join(compiler).replace("GNU", "g++"),
             datetime.date.today().isoformat()]
    if os.getloadavg()[0] > 1.5:
        parts.append("beside other work of the machine")
    return ", ".join(parts)


def python_of(build):
    """Returns the interpreter for which the package for Python is built."""
    cache = build / "CMakeCache.txt"
    found = re.search(r"^_Python3_EXECUTABLE:\w+=(.+)", cache.read_text() if cache.exists() else "", re.MULTILINE)
    return found[1] if found else sys.executable


def expanded(command, build):
    """Returns a command with names of folders, and with the meshes of a list in place of @LIST."""
    meshes = build / "cgal_data/meshes"
    command = command.format(build=build, meshes=meshes, python=python_of(build))
    paths = lambda found: " ".join(f"{meshes}/{name}" for name in (ROOT / found[1]).read_text().split())
    return re.sub(r"@(\S+)", paths, command)


def build_target(build, target):
    """Builds a target. Returns whether it succeeds."""
    return subprocess.run(["cmake", "--build", build, "--target", target], stdout=subprocess.DEVNULL).returncode == 0


def write(path, text):
    """Replaces a file by a new one, which is written beside it before."""
    path.parent.mkdir(exist_ok=True)
    beside = path.with_suffix(".new")
    beside.write_text(text)
    os.replace(beside, path)


def cell_of(file, row, column):
    """Returns a cell of a table with the unit of its column."""
    lines = path_of(file).read_text().splitlines()
    found = next(line for line in lines[2:] if line.startswith(f"| {row} |"))
    unit = re.search(r" \((.*)\)$", column)
    return cells_of(found)[cells_of(lines[0]).index(column)] + (" " + unit[1] if unit else "")


def summary():
    """Returns the summary of all comparisons."""
    table = ["| task | compared with | here | other |", "| --- | --- | ---: | ---: |"]
    for task, other, file, *sides in SUMMARY:
        table.append(f"| {task} | {other} | " + " | ".join(cell_of(file, *side) for side in sides) + " |")
    return "\n".join(table)


def make(run, build):
    """Runs a benchmark and writes its tables. Returns whether it succeeds."""
    start, source = time.monotonic(), machine(build)
    words = run.command.replace("{build}/benchmark/", "").replace("{build}/", "build/").replace("{python}", "python3")
    words = words.replace("{meshes}/", "").replace("{meshes}", "build/cgal_data/meshes")
    print(f"{', '.join(run.names())}: {words}", flush=True)
    if not build_target(build, run.target):
        print(f"  failed: target {run.target}", file=sys.stderr)
        return False
    ended = subprocess.run(["sh", "-c", expanded(run.command, build)], cwd=ROOT, stdout=subprocess.PIPE, text=True)
    tables = tables_in(ended.stdout)
    if ended.returncode or len(tables) != len(run.files):
        print(f"  failed: exit code {ended.returncode}, {len(tables)} tables", file=sys.stderr)
        return False
    for file, table in zip(run.files, tables):
        if file != "-":
            rows = "\n".join(chosen_rows(table, run.rows))
            write(path_of(file), f"{rows}\n\nMeasured by `{words}` on {run.meshes}; {source}.\n")
    print(f"  {time.monotonic() - start:.0f} s", flush=True)
    return True


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("names", nargs="*", help="of tables, as in doc/PACKAGE/tables/NAME.md")
    parser.add_argument("--build", type=Path, default=ROOT / "build")
    parser.add_argument("--list", action="store_true", help="prints names of tables")
    arguments = parser.parse_args()
    runs = [run for run in RUNS if set(arguments.names) & set(run.names()) or not (arguments.names or run.long)]
    if unknown := set(arguments.names) - {name for run in RUNS for name in run.names()}:
        parser.error("no table " + ", ".join(sorted(unknown)))
    if arguments.list:
        print("\n".join(name + (" (long)" if run.long else "") for run in RUNS for name in run.names()))
        return 0
    succeeded = [make(run, arguments.build.resolve()) for run in runs]
    write(path_of(SUMMARY_FILE), summary() + "\n")
    return 0 if all(succeeded) else 1


if __name__ == "__main__":
    sys.exit(main())
