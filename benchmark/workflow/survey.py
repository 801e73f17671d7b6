#!/usr/bin/env python3
# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""survey.py PROGRAM FOLDER: computes all maps that suit the topology of each surface of a folder, as
hard_surfaces.py writes them, and prints tables by family and by map. FAMILY is what precedes the last
underscore in FAMILY_INDEX.off."""

import argparse
import json
import math
import statistics
from pathlib import Path

from run import run

CALLS = {"plane": "flatten -o OUT.obj", "disk": "flatten --boundary disk -o OUT.obj",
         "rectangle": "flatten --boundary rectangle -o OUT.obj", "sphere": "sphere -o OUT.ply",
         "uniformize": "uniformize -o OUT.obj"}

# The greatest errors of a success, whatever the program has promised.
BOUNDS = {"max_curvature_error": 1e-9, "max_cross_ratio_error": 1e-8, "flipped_triangles": 0, "concave_edges": 0}

COLUMNS = ["surfaces", "maps", "found", "crowded", "failed", "too slow", "contradictory", "mollified",
           "median steps", "most steps", "curvature error", "cross-ratio error", "seconds"]


def topology(path):
    """Returns Euler characteristic and number of boundary loops of a mesh in the format OFF."""
    numbers = path.read_text().split()[1:]
    vertices, faces = int(numbers[0]), int(numbers[1])
    corners = list(map(int, numbers[3 + 3 * vertices:]))
    sides = set()
    for i in range(0, 4 * faces, 4):
        a, b, c = corners[i + 1:i + 4]
        sides |= {(a, b), (b, c), (c, a)}
    border = {a: b for b, a in sides if (a, b) not in sides}
    characteristic = vertices - (len(sides) + len(border)) // 2 + faces
    loops = 0
    while border:
        loops += 1
        vertex = next(iter(border))
        while vertex in border:
            vertex = border.pop(vertex)
    return characteristic, loops


def suitable_calls(path):
    """Returns names of maps. Spheres and disks are uniformized by the map to the sphere."""
    kind = topology(path)
    if kind == (1, 1):
        return ["plane", "disk", "rectangle", "sphere"]
    return ["plane", "sphere" if kind == (2, 0) else "uniformize"]


def is_within(error, bound):
    return isinstance(error, (int, float)) and math.isfinite(error) and error <= bound


def contradictions(row):
    """Returns the properties of a success that it should not have."""
    values = row.get("statistics", {})
    kind = "crowded" if is_crowded(row) else "success"
    found = [] if values.get("status") == "success" else [f"status {values.get('status')}"]
    found += [f"{k} {values[k]}" for k, bound in BOUNDS.items()
              if k in values and not is_within(values[k], bound) and (kind == "success" or bound > 0)]
    if kind == "success":
        found += [f"{k} {p['error']} of {p['bound']}" for k, p in values.get("promises", {}).items()
                  if not (is_within(p["error"], p["bound"]) and p["kept"])]
    return found


def is_crowded(row):
    """Returns whether a success has faces that are too small for its picture, which it names."""
    return row["outcome"] == "success" and bool(row.get("statistics", {}).get("crowded_faces"))


def summary(rows):
    """Returns the columns of a table for some rows."""
    done = [r for r in rows if r["outcome"] == "success"]
    figures = lambda key: [r["statistics"][key] for r in done if key in r.get("statistics", {})]
    greatest = lambda values: f"{max(values):.1e}" if values else ""
    steps = figures("iterations")
    return [len({r["mesh"] for r in rows}), len(rows), sum(not is_crowded(r) for r in done),
            sum(map(is_crowded, done)), sum(r["outcome"] in ("failure", "refused", "crash") for r in rows),
            sum(r["outcome"] == "timeout" for r in rows), sum(bool(contradictions(r)) for r in done),
            len(figures("mollification")), statistics.median_low(steps) if steps else "",
            max(steps, default=""), greatest(figures("max_curvature_error")),
            greatest(figures("max_cross_ratio_error")), f"{max(r['seconds'] for r in rows):.2f}"]


def print_table(rows, key):
    names = sorted({r[key] for r in rows})
    lines = [[key, *COLUMNS]] + [[n, *summary([r for r in rows if r[key] == n])] for n in names]
    lines.append(["all", *summary(rows)])
    widths = [max(len(str(line[i])) for line in lines) for i in range(len(lines[0]))]
    for i, line in enumerate(lines):
        print("|", " | ".join(f"{str(x):{'<' if k == 0 else '>'}{w}}"
                              for k, (x, w) in enumerate(zip(line, widths))), "|")
        if i == 0:
            print("|", " | ".join("-" * w if k == 0 else "-" * (w - 1) + ":" for k, w in enumerate(widths)), "|")
    print()


def complaint(row):
    """Returns what is wrong with a row, in one line."""
    if row["outcome"] != "success":
        return f"{row['outcome']}: {row['message']}"
    wrong = contradictions(row)
    if "mollification" in row.get("statistics", {}):
        wrong.append(f"mollified: {row['message']}")
    return "; ".join(wrong)


def survey(arguments):
    rows = []
    if arguments.rows and arguments.rows.exists():
        rows = [json.loads(line) for line in arguments.rows.read_text().splitlines()]
    known = {(r["mesh"], r["map"]) for r in rows}
    family = lambda path: path.stem.rsplit("_", 1)[0]
    number = lambda path: int(path.stem.rsplit("_", 1)[1])
    # the first of each family come first: an interrupted survey has something of all
    for path in sorted(arguments.folder.glob("*.off"), key=lambda p: (number(p), family(p))):
        for name in suitable_calls(path):
            if (path.name, name) in known:
                continue
            command, *options = CALLS[name].split()
            row = run(arguments.program, path, arguments.timeout, command, options)
            row.update(map=name, family=family(path))
            rows.append(row)
            if arguments.rows:
                with open(arguments.rows, "a", encoding="utf-8") as file:
                    file.write(json.dumps(row) + "\n")
    return rows


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("program", type=lambda path: Path(path).resolve())
    parser.add_argument("folder", type=Path)
    parser.add_argument("--timeout", type=float, default=20, help="seconds of the processor for each map")
    parser.add_argument("--rows", type=Path, help="JSON lines, one for each map; those in it are not computed again")
    parser.add_argument("--failures", type=Path, help="text file of surfaces, maps and what is wrong with them")
    arguments = parser.parse_args()
    rows = survey(arguments)
    print_table(rows, "family")
    print_table(rows, "map")
    if arguments.failures:
        lines = sorted((complaint(r), r["mesh"], r["map"]) for r in rows if complaint(r))
        arguments.failures.write_text("".join(f"{mesh} {name}: {text}\n" for text, mesh, name in lines))


if __name__ == "__main__":
    main()
