# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""table.py RUNS TABLE.csv: collects the JSON files that run.py has written into one table."""

import csv
import json
import sys
from pathlib import Path

COLUMNS = ["mesh", "command", "outcome", "vertices", "faces", "euler_characteristic", "boundary_loops",
           "components", "seconds", "peak_memory_bytes", "status", "mollification", "flips",
           "ptolemy_flips", "min_angle_degrees", "max_curvature_error", "max_cross_ratio_error",
           "flipped_triangles", "inserted_vertices", "faces_below_bound", "coarse_vertices", "area_ratio", "message"]

rows = []
for path in sorted(Path(sys.argv[1]).glob("*/*.json")):
    row = json.loads(path.read_text())
    statistics = row.pop("statistics", {})
    statistics.pop("seconds", None)  # by stage; the row has the time of the whole run
    rows.append({**statistics, **row})
with open(sys.argv[2], "w", newline="") as file:
    table = csv.DictWriter(file, COLUMNS, restval="", extrasaction="ignore")
    table.writeheader()
    table.writerows(rows)
