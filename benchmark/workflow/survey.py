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
import random
import statistics
import tempfile
from pathlib import Path

from run import run

CALLS = {"plane": "flatten -o OUT.obj", "circles": "flatten --radii RADII -o OUT.obj",
         "disk": "flatten --boundary disk -o OUT.obj", "rectangle": "flatten --boundary rectangle -o OUT.obj", "sphere": "sphere -o OUT.ply",
         "uniformize": "uniformize -o OUT.obj"}

# The greatest errors of a success, whatever the program has promised.
BOUNDS = {"max_curvature_error": 1e-9, "max_cross_ratio_error": 1e-8, "flipped_triangles": 0, "concave_edges": 0}

COLUMNS = ["surfaces", "maps", "found", "crowded", "failed", "too slow", "contradictory", "mollified",
           "median steps", "most steps", "curvature error", "cross-ratio error", "seconds"]


def read(path):
    """Returns points and faces of a mesh in the format OFF."""
    numbers = path.read_text().split()[1:]
    vertices, faces = int(numbers[0]), int(numbers[1])
    coordinates = list(map(float, numbers[3:3 + 3 * vertices]))
    corners = list(map(int, numbers[3 + 3 * vertices:]))
    return ([tuple(coordinates[i:i + 3]) for i in range(0, 3 * vertices, 3)],
            [corners[i + 1:i + 4] for i in range(0, 4 * faces, 4)])


def topology(path):
    """Returns the Euler characteristic of a mesh and the numbers of vertices of its boundary loops."""
    points, faces = read(path)
    sides = {side for a, b, c in faces for side in ((a, b), (b, c), (c, a))}
    border = {b: a for a, b in sides if (b, a) not in sides}
    characteristic = len(points) - (len(sides) + len(border)) // 2 + len(faces)
    loops = []
    while border:
        loops.append(len(border))
        vertex = next(iter(border))
        while vertex in border:
            vertex = border.pop(vertex)
        loops[-1] -= len(border)
    return characteristic, loops


def suitable_calls(path):
    """Returns names of maps. Spheres and disks are uniformized by the map to the sphere. A rectangle has
    at least four vertices on its boundary."""
    characteristic, loops = topology(path)
    if characteristic == 1 and len(loops) == 1:
        rectangle = ["rectangle"] if loops[0] >= 4 else []
        return ["plane", "circles", "disk", *rectangle, "sphere"]
    return ["plane", "circles", "sphere" if characteristic == 2 and not loops else "uniformize"]


def distance_to_segment(p, q, r):
    """Returns the distance of a point p from the segment between q and r, or zero if rounding exceeds it."""
    along, from_q = [[b - a for a, b in zip(q, x)] for x in (r, p)]
    t = sum(a * b for a, b in zip(along, from_q)) / sum(a * a for a in along)
    rounding = 1e-14 * (math.hypot(*from_q) + math.hypot(*along))
    return max(0, math.dist(from_q, [min(max(t, 0), 1) * a for a in along]) - rounding)


def random_radii(points, faces):
    """Returns radii of circles that do not meet: random parts of distances in space, which are no longer than on the
    surface. Each circle lies in the faces around its vertex. So it does not meet itself on a thin surface, and does
    not cross other sides of the boundary."""
    rng = random.Random(len(points))
    order = sorted(range(len(points)), key=lambda v: points[v])
    least = [math.inf] * len(points)
    for face in faces:
        for k, v in enumerate(face):
            least[v] = min(least[v], distance_to_segment(points[v], points[face[k - 1]], points[face[k - 2]]))
    for i, v in enumerate(order):
        for step in (-1, 1):
            k = i + step
            while 0 <= k < len(order) and abs(points[order[k]][0] - points[v][0]) < 2 * least[v]:
                least[v] = min(least[v], math.dist(points[order[k]], points[v]) / 2)
                k += step
    return [distance * rng.uniform(0, 0.99) for distance in least]


def write_radii(path, file):
    """Writes random radii for the vertices of a mesh."""
    file.write_text("".join(f"{v} {r!r}\n" for v, r in enumerate(random_radii(*read(path)))))


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
            with tempfile.NamedTemporaryFile("w", suffix=".txt") as radii:
                if "RADII" in options:
                    write_radii(path, Path(radii.name))
                options = [radii.name if o == "RADII" else o for o in options]
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
