# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""report.py TABLE.csv REPORT.html: how many runs of each command succeeded, and pictures of time,
accuracy and success by size. Needs matplotlib."""

import csv
import html
import io
import statistics
import sys

import matplotlib

matplotlib.use("svg")
import matplotlib.pyplot as plt

OUTCOMES = ["success", "refused", "failure", "timeout", "crash"]
COLORS = {"success": "#1f6fb4", "refused": "#aab4be", "failure": "#c8501e", "timeout": "#7a2fa0", "crash": "#111111"}
# how good a result is: column, and what it says
ACCURACY = {"delaunay": ("min_angle_degrees", "least angle (degrees)"), "refine": ("min_angle_degrees", "least angle (degrees)"),
            "flatten": ("max_curvature_error", "error of curvature"), "fixed": ("max_curvature_error", "error of curvature"),
            "sphere": ("max_curvature_error", "error of curvature"), "uniformize": ("max_curvature_error", "error of curvature"),
            "simplify": ("area_ratio", "area kept")}


def svg(figure):
    text = io.StringIO()
    figure.savefig(text, format="svg", bbox_inches="tight")
    plt.close(figure)
    return text.getvalue()[text.getvalue().index("<svg"):]


def number(row, column):
    return float(row[column]) if row[column] else None


def scatter(rows, column, label):
    """The values of a column against the number of vertices; the color says how the run ended."""
    figure, axes = plt.subplots(figsize=(4.2, 2.8))
    for outcome in OUTCOMES:
        points = [(number(r, "vertices"), number(r, column)) for r in rows if r["outcome"] == outcome]
        points = [(x, y) for x, y in points if x and y is not None and y > 0]
        if points:
            axes.scatter(*zip(*points), s=12, color=COLORS[outcome], label=outcome)
    axes.set(xlabel="vertices", ylabel=label, xscale="log", yscale="log" if axes.has_data() else "linear")
    return svg(figure)


def outcomes(rows, commands):
    """The share of each outcome, by command, of the meshes that were not refused by all commands."""
    figure, axes = plt.subplots(figsize=(8.6, .45 * len(commands) + .8))
    left = [0] * len(commands)
    for outcome in OUTCOMES:
        counts = [sum(r["command"] == c and r["outcome"] == outcome for r in rows) for c in commands]
        axes.barh(commands, counts, left=left, color=COLORS[outcome], label=outcome)
        left = [a + b for a, b in zip(left, counts)]
    axes.invert_yaxis()
    axes.set_xlabel("meshes")
    axes.legend(ncol=5, loc="upper center", bbox_to_anchor=(.5, 1.2), frameon=False)
    return svg(figure)


def summary(rows, commands):
    lines = ["<tr><th>command</th>" + "".join(f"<th>{o}</th>" for o in OUTCOMES) + "<th>median s</th><th>most s</th></tr>"]
    for c in commands:
        own = [r for r in rows if r["command"] == c]
        seconds = [float(r["seconds"]) for r in own if r["outcome"] == "success"] or [float("nan")]
        cells = [sum(r["outcome"] == o for r in own) for o in OUTCOMES]
        cells += [f"{statistics.median(seconds):.3f}", f"{max(seconds):.3f}"]
        lines.append(f"<tr><td>{c}</td>" + "".join(f"<td>{x}</td>" for x in cells) + "</tr>")
    return "<table>" + "\n".join(lines) + "</table>"


def failures(rows):
    bad = [r for r in rows if r["outcome"] in ("failure", "timeout", "crash")]
    lines = [f"<tr><td>{html.escape(r['mesh'])}</td><td>{r['command']}</td><td>{r['outcome']}</td>"
             f"<td>{html.escape(r['message'])}</td></tr>" for r in bad]
    return f"<h2>{len(bad)} runs that failed</h2><table>" + "\n".join(lines) + "</table>"


with open(sys.argv[1], newline="") as file:
    rows = list(csv.DictReader(file))
commands = list(dict.fromkeys(r["command"] for r in rows))
parts = [f"<h1>{len({r['mesh'] for r in rows})} meshes, {len(rows)} runs</h1>", summary(rows, commands),
         outcomes(rows, commands)]
for command in commands:
    own = [r for r in rows if r["command"] == command]
    parts.append(f"<h2>{command}</h2>" + scatter(own, "seconds", "seconds"))
    if command in ACCURACY:
        parts.append(scatter(own, *ACCURACY[command]))
parts.append(failures(rows))
with open(sys.argv[2], "w") as file:
    file.write('<!doctype html><html lang="en"><head><meta charset="utf-8"><title>Runs of the program</title><style>'
               "body{font:15px sans-serif;max-width:66em;margin:2em auto}td,th{padding:.15em .8em;text-align:right}"
               "td:first-child,td:last-child{text-align:left}</style></head><body>" + "\n".join(parts) + "</body></html>\n")
