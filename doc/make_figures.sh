#!/usr/bin/env bash
# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# make_figures.sh PROGRAM DATA: draws the figures of the manuals: those that explain ideas, and those that
# show pages or results, from meshes that CGAL ships. Needs Chromium, matplotlib, and pngquant to make files
# small.
set -euo pipefail
program=$(realpath "$1")
meshes=$(realpath "$2")/meshes
doc=$(realpath "$(dirname "${BASH_SOURCE[0]}")")
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch"

# screenshot PACKAGE NAME CLAIMS...: of page.html, after the claims, which may change what is shown.
screenshot()
{
  local picture=$doc/$1/fig/$2.png
  mkdir -p "$(dirname "$picture")"
  python3 "$doc/../test/demo/browse.py" page.html "${@:3}" --size 1200,720 --screenshot shot.png
  pngquant --force --speed 1 --output "$picture" 256 shot.png
}

# result COMMAND MESH ARGUMENTS...: its page and its picture.
result()
{
  "$program" "$1" "$meshes/$2" "${@:3}" --quiet --view page.html --picture picture.svg
}

python3 "$doc/draw_figures.py"
result delaunay joint.off -o out.ply
python3 "$doc/Intrinsic_triangulations/fig/draw_subdivision.py" out.ply shot.png
pngquant --force --output "$doc/Intrinsic_triangulations/fig/delaunay.png" 128 shot.png
result delaunay cow.off -o out.ply
screenshot Intrinsic_triangulations viewer_delaunay
result flatten nefertiti.off -o out.obj --boundary disk
screenshot Intrinsic_triangulations viewer_flatten
result hyperbolic eight.off -o out.obj --tiles 2
screenshot Discrete_conformal_maps viewer_hyperbolic 'view.set({shown: {is_seam: true}}) === undefined'
result distance elephant.off -o out.ply --source 0
screenshot Intrinsic_triangulations viewer_distance
result flatten elephant.off -o out.obj
screenshot Discrete_conformal_maps flatten
screenshot Intrinsic_triangulations viewer_distortion 'view.setColor("field angle_distortion") === undefined'
result refine joint.off -o out.ply
screenshot Intrinsic_triangulations viewer_refine
result path elephant.off -o out.obj --from 0 --to 2000
screenshot Intrinsic_triangulations viewer_path
result uniformize knot1.off -o out.ply
screenshot Intrinsic_triangulations viewer_uniformize
awk 'NF == 3 && NR > 2 && n < 2904 { print n++, sin(18 * $1) }' "$meshes/cow.off" >values.txt
result transfer cow.off -o out.txt --data values.txt --min-angle 25
screenshot Intrinsic_triangulations viewer_transfer
result operators cow.off --prefix out
screenshot Intrinsic_triangulations viewer_operators 'view.setColor("field curvature") === undefined' \
  'view.set({isolines: false}) === undefined'
"$program" view "$meshes/elephant.off" "$meshes/cow.off" -o page.html
screenshot Intrinsic_triangulations viewer_view
"$program" info "$meshes/blobby-shuffled.off" --view page.html >info.txt || true
screenshot Intrinsic_triangulations viewer_info
"$program" delaunay "$meshes/cow.off" -o out.ply --quiet --section 100 0.05 \
  --picture "$doc/Intrinsic_triangulations/fig/section.svg"
result sphere cow.off -o out.ply
screenshot Discrete_conformal_maps sphere 'view.setColor("faces input") === undefined'
result simplify elephant.off -o out.ply --ratio 0.06
screenshot Intrinsic_simplification simplify
