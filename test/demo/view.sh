#!/usr/bin/env bash
# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# The pages of `intrinsic view` and --view, opened in headless Chromium. Skipped if it is missing.
source "$(dirname "${BASH_SOURCE[0]}")/common.bash"

cp "$shipped" slivers.mesh.off
grid flat 6 0
grid sheared 4 3

needs_pages
expect 0 view good.mesh.off -o page.html
expect_files page.html
page_shows page.html 'view.viewer.views.length === 1' 'view.viewer.surfaces[0].numberOfPoints === 4' \
  'share(0, isPaper) > .2' 'share(0, isPaper) < .9' 'view.page.statistics["good.mesh.off"].polygons === 4'

# Edges that no numbers belong to are the sides of polygons.
off mixed '0 0 0,1 0 0,1 1 0,0 1 0,2 0 0,2 1 0' '0 1 2 3,4 2 1,4 5 2'
expect 0 view mixed.mesh.off -o page.html
page_shows page.html 'view.viewer.countEdges("edges") === 8' \
  'Array.from({length: 8}, (_, e) => view.viewer.surfaces[0].edges.slice(2 * e, 2 * e + 2).join("")).join() ===
    "01,03,12,14,23,24,25,45"' 'view.viewer.surfaces[0].triangles.length === 12'
rm page.html mixed.mesh.off
expect 0 view good.mesh.off -o page.html

# Bytes are the same, in each run and on standard output; nothing is loaded.
expect 0 view good.mesh.off -o again.html
cmp page.html again.html
expect 0 view good.mesh.off -o -
cmp page.html out
[ -z "$(grep -oE '(src|href)="[^"]*"' page.html | grep -v 'href="data:,"')" ] || fail 'the page loads files'
grep -q 'Copyright © 2010-2024 three.js authors' page.html || fail "three.js's licence is missing"
refuses 'never overwritten' view good.mesh.off -o good.mesh.off
rm ./*.html

# Two meshes are seen from one side; each has its own points.
expect 0 view flat.mesh.off sheared.mesh.off -o page.html
page_shows page.html 'view.viewer.views.length === 2' \
  'closePoints(clickAt([.25, .3, 0]).point, [.25, .3, 0])' 'clickAt([.25, .3, 0]).surface === "flat.mesh.off"' \
  'clickAt([1/3 + .01, 1/2 + .01, 0]).nearestVertex === 3 * 7 + 2' \
  'view.pick(2, 2) === null' 'view.viewer.resetCameras() === undefined' 'share(1, isPaper) < .98'

# What is wrong is red: one edge, all of several faces, and points.
code=0
"$program" info edge_of_three.mesh.off --view page.html >out || code=$?
[ "$code" -eq 2 ] || fail "info gave $code"
page_shows page.html 'view.viewer.marks.some(m => m.name === "non-manifold edge")' \
  'isRed(colorAt([.5, 0, 0]))' '!isRed(colorAt([.6, .45, 0]))'
expect 0 info needle.mesh.off --view page.html
page_shows page.html 'view.viewer.marks.length === 1' 'view.viewer.marks[0].polygons.length === 1'
for file in repeated.mesh.off bow_tie.mesh.off zero_length.mesh.off overflow.mesh.obj; do
  rm page.html
  "$program" info "$file" --view page.html >out || true
  page_shows page.html 'view.viewer.views.length === 1'
done
awk 'BEGIN {
  print "OFF\n24 8 0"
  for(i = 0; i < 8; ++i)
    print i, 0, 0 "\n" i + .5, 0, 0 "\n" i + .5, .0001, 0
  for(i = 0; i < 8; ++i)
    print 3, 3 * i, 3 * i + 1, 3 * i + 2
}' >needles.mesh.off
expect 0 info needles.mesh.off --view page.html
page_shows page.html 'view.viewer.marks[0].polygons.length === 8'

# A path that a square hides shows through it, pale; one that nothing hides is green.
off covered '0 0 .1,1 0 .1,1 1 .1,0 1 .1,.3 .3 0,.7 .3 0,.7 .7 0,.3 .7 0' '0 1 2,0 2 3,4 5 6,4 6 7'
for ends in '5 7 isPale !isGreen .5,.5,0' '1 3 isGreen !isPale .5,.5,.1'; do
  read -r from to is not place <<<"$ends"
  expect 0 path covered.mesh.off --from "$from" --to "$to" -o a.obj --view page.html
  page_shows page.html 'globalThis.isGreen = ([r, g, b]) => g > r + 70, true' \
    'globalThis.isPale = ([r, g, b]) => g > r + 15 && g < r + 60, true' \
    "$is(colorAt([$place]))" "$not(colorAt([$place]))" 'view.set({shown: {path: false}}) === undefined' \
    "!$is(colorAt([$place]))"
done
rm covered.mesh.off

# The Delaunay triangulation of a sheared grid, with its edges over those of the input.
expect 0 delaunay sheared.mesh.off -o a.ply --view page.html
page_shows page.html 'view.viewer.layers.join() === "input,intrinsic"' \
  'view.page.angles.length === 2' 'view.page.angles[0].counts.reduce((a, b) => a + b) === 3 * 32' \
  'view.page.angles[1].counts.reduce((a, b) => a + b) === 3 * 32' \
  'view.page.statistics.is_delaunay' 'view.page.statistics.seconds === undefined' \
  'view.set({shown: {input: false, intrinsic: false}}) === undefined' \
  'share(0, ([r, g, b]) => r > g + 60) === 0' \
  'view.set({shown: {intrinsic: true}}) === undefined' 'share(0, ([r, g, b]) => r > g + 60) > .001' \
  'Object.keys(clickAt([1.7, .4, 0]).faces).join() === "input,intrinsic"'
expect 0 delaunay sheared.mesh.off -o a.ply --view again.html
cmp page.html again.html

# Drawn without the subdivision, intrinsic faces and edges are where the subdivision has them, seen at
# pixels and at points that are picked; a ridge is crossed by edges that are not the input's.
frame='print((([l, w, t, h], gl = view.viewer.renderer.getContext(), p = new Uint8Array(4 * w * h)) => {
  view.viewer.draw(); gl.readPixels(l, gl.drawingBufferHeight - t - h, w, h, gl.RGBA, gl.UNSIGNED_BYTE, p);
  return Array.from(p.filter((_, i) => i % 20 < 3)).join(" ") })(["left", "width", "top", "height"]
    .map(k => Math.floor(view.viewer.views[0].pane.box[k]))))'
faces='print(Array.from({length: 400}, (_, i) => view.pick(310 + 44 * (i % 20), 20 + 38 * Math.floor(i / 20)))
  .map(p => p ? `${p.faces.input}/${p.faces.intrinsic}` : "-").join(" "))'
drawn()
{
  expect 0 "$@" --view page.html
  page_shows page.html 'view.set({shown: {input: false, intrinsic: false}}) === undefined' \
    'view.setColor("faces intrinsic") === undefined' "$frame" 'view.setColor("plain") === undefined' \
    'view.set({shown: {intrinsic: true}}) === undefined' "$frame" \
    'view.set({shown: {intrinsic: false}}) === undefined' 'view.setColor("faces input") === undefined' \
    "$frame" "$faces"
}
rough rough
for call in 'refine rough.mesh.off --min-angle 28' \
  'delaunay slivers.mesh.off' 'refine good.mesh.off --max-circumradius 0.1'; do
  drawn $call -o a.ply >subdivision.txt
  drawn $call -o a.ply --direct >direct.txt
  python3 - "$call" <<'PYTHON' || fail "$call --direct"
import sys
pages = [[line.split() for line in open(f"{name}.txt")] for name in ("subdivision", "direct")]
shares = []
for old, new, least in zip(*pages, (.97, .9, .985, .985)):
    assert len(old) == len(new)
    shares.append(sum(a == b if "/" in a or a == "-" or b == "-" else abs(int(a) - int(b)) < 12
                      for a, b in zip(old, new)) / len(old))
    print(sys.argv[1], f"{shares[-1]:.4f}")
    assert shares[-1] >= least, (shares, least)
assert len(set(pages[0][3])) > 4
PYTHON
done

# Distances are linear on intrinsic faces, with inserted vertices too: values at points that are picked
# and colors are those on the subdivision. Sources are drawn.
distances='print(Array.from({length: 400}, (_, i) => view.pick(310 + 44 * (i % 20), 20 + 38 * Math.floor(i / 20)))
  .map(p => p ? `${p.values.distance}/${p.values.distance_error}` : "-").join(" "))'
sources='share(0, ([r, g, b]) => Math.max(Math.abs(r - 20), Math.abs(g - 122), Math.abs(b - 90)) < 3) > 1e-5'
measured()
{
  expect 0 distance "$@" --method heat -o a.ply --view page.html
  page_shows page.html "$frame" 'view.setColor("field distance_error") === undefined' "$frame" "$distances" \
    "$sources"
}
for call in 'slivers.mesh.off --source 7 --source 9:0.2,0.3,0.5' 'rough.mesh.off --source 0 --min-angle 28'; do
  measured $call >subdivision.txt
  measured $call --direct >direct.txt
  python3 - "$call" <<'PYTHON' || fail "distance $call --direct"
import sys
old, new = [[line.split() for line in open(f"{name}.txt")] for name in ("subdivision", "direct")]
for a, b in zip(old[:2], new[:2]):
    share = sum(abs(int(x) - int(y)) < 12 for x, y in zip(a, b)) / len(a)
    print(sys.argv[1], f"{share:.4f}")
    assert len(a) == len(b) and share > .99, share
values = [[float(x) for p in points[2] for x in p.split("/") if x != "-"] for points in (old, new)]
assert len(values[0]) > 30 and max(values[0]) > 1
assert max(abs(x - y) for x, y in zip(*values, strict=True)) < 1e-5
PYTHON
done

# fan N: the edge between two points, with N points on either side, each of which is joined to the first:
# the Delaunay triangulation crosses it about 2 N times.
fan()
{
  awk -v n="$1" 'BEGIN {
    print "OFF\n" 2 * n + 2, 2 * n, 0
    print -1, 0, 0 "\n" n, 0, 0
    for(i = 0; i < n; ++i)
      print i, 1, 0 "\n" i, -1, 0
    print 3, 0, 1, 2 * n "\n" 3, 1, 0, 2 * n + 1
    for(i = 2; i < 2 * n; i += 2)
      print 3, 0, i + 2, i "\n" 3, 0, i + 1, i + 3
  }' >"fan$1.mesh.off"
}

# Where the edges of a face are crossed too often, or lengths are not those in space, there is the subdivision.
fan 40
fan 300
has_subdivision() { page_shows page.html "!view.viewer.surfaces[0].developed === $1" 'share(0, isPaper) > .1'; }
expect 0 delaunay fan40.mesh.off -o a.ply --view page.html --direct
has_subdivision false
expect 0 delaunay fan300.mesh.off -o a.ply --view page.html --direct
says 'note: the page shows the common subdivision, in spite of --direct: '
has_subdivision true

# Curvature of a tetrahedron's corner: the angle defect by a third of the area of its faces.
expect 0 refine good.mesh.off -o a.ply --view page.html --max-insertions 0 --min-angle 50
page_shows page.html 'view.viewer.marks[0].name === "faces below the bounds"' \
  'close(view.viewer.surfaces[0].pointData.curvature.values[0], Math.PI / 2 / .5, 1e-5)'
expect 0 operators sheared.mesh.off --prefix a --view page.html
page_shows page.html 'view.viewer.layers.length === 2'

# Distances are at the points where they are.
expect 0 distance flat.mesh.off -o a.ply --source 0 --method heat --view page.html
page_shows page.html 'view.viewer.state.color === "field distance"' \
  'clickAt([.01, .01, 0]).values.distance < .05' 'clickAt([.6, .5, 0]).values.distance > .6' \
  'view.viewer.surfaces[0].pointData.distance_error.values.every((error, p) => {
    const {pointData, points, description: {center, radius}} = view.viewer.surfaces[0];
    const [x, y] = [0, 1].map(k => center[k] + radius * points[3 * p + k]);
    return p >= 49 || close(pointData.distance.values[p] - error, Math.hypot(x, y), 1e-5) })' \
  'view.viewer.marks[0].points.join() === "0"'

# A function that is linear in the plane, on either triangulation, and points.
awk 'NR > 2 && NF == 3 { print NR - 3, 3 * $1 - 2 * $2 + 1 }' flat.mesh.off >values.mesh.txt
for options in "" "--min-angle 40 --max-insertions 50"; do
  expect 0 transfer flat.mesh.off --data values.mesh.txt -o a.txt --view page.html $options
  page_shows page.html 'view.viewer.state.color === "field transferred_function"' \
    '[[.1, .2, 0], [.6, .5, 0], [.9, .3, 0]].every(([x, y, z]) => {
      const {values} = clickAt([x, y, z]);
      return close(values.function, 3 * x - 2 * y + 1, .02) &&
        close(values.transferred_function, 3 * x - 2 * y + 1, .02) })'
  expect 0 transfer flat.mesh.off --data a.txt --back -o b.txt --view page.html $options
  page_shows page.html 'close(clickAt([.6, .5, 0]).values.transferred_function, 1.8, .02)'
done
printf '3\n0:0.2,0.3,0.5\n' >points.mesh.txt
expect 0 transfer flat.mesh.off --points points.mesh.txt -o a.txt --view page.html
page_shows page.html 'view.viewer.marks.length === 1' 'view.viewer.marks[0].points.length === 2' \
  'view.viewer.state.color === "plain"'
expect 0 transfer flat.mesh.off --points a.txt --back -o b.txt --view page.html
page_shows page.html 'view.viewer.marks[0].points.length === 2'
rm a.* b.*

# A flat square in the plane is the square; points are found from either side.
expect 0 flatten flat.mesh.off -o a.obj --view page.html
page_shows page.html 'view.viewer.views.length === 2' 'view.viewer.hasTexture' \
  'view.page.curves.length <= 1' \
  '(p => { const q = clickAt([.3, .3, 0]), r = clickAt([.7, .6, 0]);
    return close(Math.hypot(q.picture[0] - r.picture[0], q.picture[1] - r.picture[1]), .5, 1e-4) })()' \
  '(() => { const q = clickAt([.3, .6, 0]);
    const {pane} = view.viewer.views[1];
    const {center, radius} = view.viewer.surfaces[0].picture;
    const [x, y] = [0, 1].map(k => (q.picture[k] - center[k]) / radius);
    const at = pane.project(new pane.scene.position.constructor(x, y, 0));
    const back = view.pick(at[0] + pane.box.left, at[1] + pane.box.top);
    return closePoints(back.point, [.3, .6, 0]) })()'

# Functions of the input are colors with a legend, by the common subdivision and without it; new values come first.
awk 'BEGIN { print "ply\nformat ascii 1.0\nelement vertex 25\nproperty float x\nproperty float y\nproperty float z\nproperty double my-height\nproperty double curvature\nproperty float distance\nelement face 32\nproperty list uchar int vertex_indices\nend_header" }
  NR > 2 && NF == 3 { print $0, 2 * $1 - 3 * $2, 5, 7 } NR > 2 && NF == 4' sheared.mesh.off >functions.mesh.ply
for call in 'delaunay -o a.ply' 'delaunay -o a.ply --direct' 'distance -o a.ply --source 0' 'flatten -o a.obj' \
  'simplify -o a.ply --vertices 20'; do
  expect 0 ${call%% *} functions.mesh.ply ${call#* } --view page.html
  page_shows page.html 'view.viewer.fields.includes("my-height") && view.viewer.fields.includes("input_curvature")' \
    'close(clickAt([1.7, .4, 0]).values["my-height"], 2.2, 1e-4)' 'close(clickAt([1.7, .4, 0]).values.input_curvature, 5)' \
    "view.viewer.fields.includes('input_distance') === $([[ $call = distance* ]] && echo true || echo false)" \
    'view.setColor("field my-height") === undefined' \
    'document.querySelector(".legend-ticks").innerText.split(/\s+/).map(Number).every((x, i) => close(x, 2.5 * i))' \
    'view.set({shown: {input: false, intrinsic: false, is_seam: false, coarse: false}, isolines: false}) === undefined' \
    '(([r, g, b]) => b > r + 20)(colorAt([.3, .05, 0]))' '(([r, g, b]) => r > b + 20)(colorAt([3.83, .98, 0]))'
done

# A texture of the input is a checkerboard: in the page of the mesh beside its image, in others without.
# Corners without coordinates are grey.
awk 'NR > 2 && NF == 3 { print "v", $0 "\nvt", $1, $2 }
  NR > 2 && NF == 4 && ++n { for(k = 2; k < 5; ++k) c[k] = $k + 1 (n > 40 && n < 50 ? "" : "/" $k + 1)
    print "f", c[2], c[3], c[4] }' flat.mesh.off >texture.mesh.obj
board='view.setColor("projective") === undefined'
is_board='share(0, ([r, g, b]) => b > r + 20) > .2'
is_grey='(([r, g, b]) => Math.max(r, g, b) - Math.min(r, g, b) < 3 && r < 190)(colorAt([.45, .55, 0]))'
expect 0 view texture.mesh.obj -o page.html
page_shows page.html 'view.viewer.views.length === 2' 'view.viewer.state.color === "projective"' "$is_board" "$is_grey" \
  'closePoints(clickAt([.25, .3, 0]).picture, [.25, .3], 1e-5)' 'share(1, isPaper) > .1'
for call in 'delaunay -o a.ply' 'delaunay -o a.ply --direct' 'distance -o a.ply --source 0'; do
  expect 0 ${call%% *} texture.mesh.obj ${call#* } --view page.html
  page_shows page.html 'view.viewer.views.length === 1' 'view.viewer.state.color !== "projective"' \
    'view.set({shown: {input: false, intrinsic: false}}) === undefined' "$board" "$is_board" "$is_grey"
done

# On a curved surface, projective and linear interpolation differ.
expect 0 flatten good.mesh.off -o a.obj --view page.html
page_shows page.html 'view.viewer.markedPoints.join() === "is_cone"' \
  'share(0, ([r, g, b]) => b > r + 20) > .02' \
  '(() => { const before = share(0, ([r, g, b]) => b > r + 20); view.setColor("linear");
    return before !== share(0, ([r, g, b]) => b > r + 20) })()' \
  'view.setColor("field log_scale") === undefined' \
  'view.setColor("faces flat") === undefined' 'share(0, isPaper) > .2'

expect 0 sphere good.mesh.off -o a.ply --view page.html
page_shows page.html 'view.viewer.surfaces[0].picture.kind === "sphere"' \
  'close(Math.hypot(...clickAt([.2, .2, .6]).picture), 1)'
expect 0 uniformize flat.mesh.off -o a.obj --view page.html
page_shows page.html 'view.viewer.views.length === 2'

expect 0 simplify slivers.mesh.off -o a.ply --ratio 0.1 --view page.html
page_shows page.html 'view.viewer.state.color === "faces coarse"' 'view.viewer.state.shown.coarse' \
  'view.page.angles[1].name === "coarse"' 'share(0, isPaper) < .95'
if [ -n "$data" ]; then
  expect 0 hyperbolic "$data/meshes/eight.off" -o a.obj --view page.html
  page_shows page.html 'view.viewer.surfaces[0].picture.kind === "disk"' \
    'view.viewer.surfaces[0].picture.outlines.begin.length > 9' 'share(1, isPaper) < .85'
  # Each component has its disk.
  python3 - "$data/meshes/eight.off" >eights.mesh.off <<'PYTHON'
import sys
_, n, m, _, *words = open(sys.argv[1]).read().split()
n, m = int(n), int(m)
points, faces = words[:3 * n], words[3 * n:3 * n + 4 * m]
print("OFF", 2 * n, 2 * m, 0)
for shift in 0, 5:
    for i in range(n):
        print(float(points[3 * i]) + shift, *points[3 * i + 1:3 * i + 3])
for shift in 0, n:
    for i in range(m):
        print(3, *(int(v) + shift for v in faces[4 * i + 1:4 * i + 4]))
PYTHON
  expect 0 hyperbolic eights.mesh.off -o a.obj --view page.html --picture a.svg --tiles 2
  page_shows page.html '(({positions}) => [1, -1].every(side => Array.from({length: positions.length / 3},
      (_, i) => [positions[3 * i], positions[3 * i + 1]]).some(([x, y]) => side * x > .1)))(
    view.viewer.surfaces[0].picture)' 'close(view.viewer.surfaces[0].picture.radius, 2.02, 1e-6)' \
    '(({positions}) => Array.from({length: positions.length / 3}, (_, i) => Math.hypot(
      Math.abs(positions[3 * i]) - 1.02 / 2.02, positions[3 * i + 1])).every(r => r < 1 / 2.02))(
    view.viewer.surfaces[0].picture)' \
    '[150, 450].every(x => { const {left, top, width, height} = view.viewer.views[1].pane.box;
      const place = view.pick(left + width * x / 600, top + height / 2);
      return place && Math.hypot(...place.picture) < .6 })'
fi

# Pictures are XML, have every polygon, scale with a page, and are the same in each run.
expect 0 flatten flat.mesh.off -o a.obj --picture a.svg
expect 0 flatten flat.mesh.off -o a.obj --picture b.svg
cmp a.svg b.svg
python3 -c 'import sys, xml.dom.minidom as dom
paths = dom.parse("a.svg").getElementsByTagName("path")
polygons = [p for p in paths if p.hasAttribute("style")]
sys.exit(len(polygons) != 2 * 72)' || fail 'polygons are missing in a.svg'
python3 -c 'import sys, xml.dom.minidom as dom
picture = dom.parse("a.svg").documentElement
width, height = picture.getAttribute("width"), picture.getAttribute("height")
sys.exit(picture.getAttribute("viewBox") != f"0 0 {width} {height}")' || fail 'a.svg does not scale'

# A section is what is near, at its size: an edge of length 1/6 in a circle of 1/4 is 560 * 1/6 / (1/2) long.
expect 0 flatten flat.mesh.off -o a.obj --picture b.svg --section .5,.5,0 0.25
expect 0 distance flat.mesh.off -o a.ply --source 0 --picture c.svg --section 24 0.25
python3 -c 'import re, xml.dom.minidom as dom
for name, columns in ("b.svg", 2), ("c.svg", 1):
    groups = [g for g in dom.parse(name).getElementsByTagName("g") if g.hasAttribute("clip-path")]
    assert len(groups) == columns
    paths = [p for p in groups[0].getElementsByTagName("path") if p.hasAttribute("style")]
    assert 16 < len(paths) < 72, len(paths)
    points = [tuple(map(float, p.split(","))) for p in re.findall(r"[-\d.]+,[-\d.]+", paths[0].getAttribute("d"))]
    sides = sorted(abs(complex(*p) - complex(*q)) for p, q in zip(points, points[1:] + points[:1]))
    assert abs(sides[0] - 560 / 3) < .05, sides
    middle = [p for path in paths for p in re.findall(r"[-\d.]+,[-\d.]+", path.getAttribute("d"))]
    assert "300,300" in middle' || fail 'sections'

# Its lines are twice as wide as those of the whole.
python3 -c 'import re
a, b = (list(map(float, re.findall(r"}\.\w{[^}]*stroke-width:([\d.]+)", open(name).read()))) for name in ("a.svg", "b.svg"))
assert len(a) > 5 and all(abs(2 * x - y) < 1e-9 for x, y in zip(a, b)), (a, b)' || fail 'lines of sections'

# As PNG too, where the program can: beside each other, and drawn on.
result=0
"$program" flatten flat.mesh.off -o a.obj --picture a.png 2>err || result=$?
if [ "$result" -eq 2 ]; then
  says 'libcairo2-dev'
else
  claim "w, h, pixels = png('a.png')" '(w, h) == (2400, 1200)' 'len(pixels) == h * (3 * w + 1)' \
    'len(set(pixels)) >= 20'
fi