#!/usr/bin/env bash
# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# make_figures.sh PROGRAM DATA [NAME...]: draws the figures of the manuals, those that explain ideas and
# those that show results on meshes that CGAL ships, or the results with these names only. Needs Chromium,
# pngquant, and Python with numpy and scipy; PYTHON is its name if it is not python3.
set -euo pipefail
program=$(realpath "$1")
meshes=$(realpath "$2")/meshes
doc=$(realpath "$(dirname "${BASH_SOURCE[0]}")")
python=${PYTHON:-python3}
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch"

"$python" "$doc/draw_figures.py"
"$python" "$doc/draw_results.py" "$program" "$meshes" "${@:3}"
