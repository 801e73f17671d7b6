# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Shows what the program has written into a directory: results_page.py DIRECTORY reads lines
"name|title|text|command|mesh|arguments" from standard input and, for each, DIRECTORY/NAME.json, the
statistics of the run. It prints a table and writes DIRECTORY/index.html with links to the files
NAME.*."""

import html
import json
import sys
from pathlib import Path

# What is said of a result: label, and the value as a format of the statistics.
FACTS = {
    "delaunay": [("flips", "{flips:,}"), ("least angle", "{min_angle_degrees:.2f}&deg;"),
                 ("crossings", "{crossings:,}"), ("certified", "{certified}")],
    "refine": [("inserted vertices", "{inserted_vertices:,}"),
               ("least angle", "{min_angle_degrees:.2f}&deg;"),
               ("faces below the bound", "{faces_below_bound}")],
    "distance": [("greatest distance", "{max_distance:.4g}")],
    "flatten": [("cones", "{cones}"), ("Ptolemy flips", "{ptolemy_flips:,}"),
                ("error of curvature", "{max_curvature_error:.1e}"),
                ("flipped triangles", "{flipped_triangles}")],
    "sphere": [("convex", "{convex}"), ("Ptolemy flips", "{ptolemy_flips:,}"),
               ("error of curvature", "{max_curvature_error:.1e}")],
    "hyperbolic": [("area", "{area:.4f}"), ("Ptolemy flips", "{ptolemy_flips:,}"),
                   ("error of gluing", "{max_gluing_error:.1e}")],
    "simplify": [("vertices left", "{coarse_vertices:,}"), ("area kept", "{area_ratio:.4f}"),
                 ("least angle", "{min_angle_degrees:.2f}&deg;")],
}

LINKS = [(".html", "open in 3D"), (".png", "picture"), (".ply", "mesh"), (".obj", "mesh"),
         (".json", "statistics")]

PAGE = """<!doctype html>
<html lang="en"><head><meta charset="utf-8"><title>Intrinsic triangulations: results</title>
<meta name="viewport" content="width=device-width">
<style>
body {{font: 16px/1.45 "DejaVu Sans", sans-serif; color: #1c2630; background: #f4f5f7; margin: 2em auto; max-width: 76em; padding: 0 1em}}
main {{display: grid; grid-template-columns: repeat(auto-fill, minmax(22em, 1fr)); gap: 1.4em}}
article {{background: #fff; border: 1px solid #d9dee3; border-radius: 6px; padding: 1em}}
h2 {{font-size: 1.1em; margin: 0 0 .4em}} p {{margin: .4em 0}} code {{font-size: .85em}}
img {{width: 100%; height: 15em; object-fit: contain; background: #fff}}
table {{border-collapse: collapse; font-size: .9em}} td {{padding: .1em 1em .1em 0}}
a {{color: #1f5f99; margin-right: 1em}}
</style></head><body>
<h1>Intrinsic triangulations</h1>
<p>{count} results, each with its picture, a page that shows it in 3D, the mesh and the statistics.</p>
<main>
{articles}</main></body></html>
"""


def facts(statistics):
    """Those of its kind that the statistics have."""
    result = [("vertices", f"{statistics['vertices']:,}")]
    for label, pattern in FACTS[statistics["command"]]:
        try:
            result.append((label, pattern.format(**statistics)))
        except KeyError:
            pass
    if "status" in statistics:
        result.append(("status", statistics["status"].replace("_", " ")))
    return result + [("seconds", f"{sum(statistics['seconds'].values()):.2f}")]


def article(directory, run, statistics):
    name, title, text, command, mesh, arguments = run
    links = [(name + end, label) for end, label in LINKS if (directory / (name + end)).exists()]
    rows = "".join(f"<tr><td>{label}</td><td>{value}</td></tr>" for label, value in facts(statistics))
    anchors = "".join(f'<a href="{file}">{label}</a>' for file, label in links)
    return (f"<article><h2>{html.escape(title)}</h2>\n"
            f'<a href="{links[0][0]}"><img src="{name}.png" alt="{html.escape(title)}"></a>\n'
            f"<p>{html.escape(text)}</p>\n"
            f"<p><code>intrinsic {html.escape(' '.join((command, mesh, arguments)))}</code></p>\n"
            f"<table>{rows}</table>\n<p>{anchors}</p></article>\n")


def main():
    directory = Path(sys.argv[1])
    articles = []
    for line in sys.stdin:
        run = line.rstrip("\n").split("|")
        statistics = json.loads((directory / (run[0] + ".json")).read_text())
        articles.append(article(directory, run, statistics))
        described = ", ".join(f"{label} {value}" for label, value in facts(statistics))
        print(f"{run[0]:<10} {run[3]:<10} {described}".replace("&deg;", "°"))
    page = directory / "index.html"
    page.write_text(PAGE.format(count=len(articles), articles="".join(articles)))
    print(f"\nLook at the results: file://{page.resolve()}")


main()
