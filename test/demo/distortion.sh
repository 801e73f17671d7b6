#!/usr/bin/env bash
# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# Colors of pages for how far maps are from isometries, in headless Chromium. Skipped if it is missing.
source "$(dirname "${BASH_SOURCE[0]}")/common.bash"

needs_pages
grid flat 6 0
rough rough

# Distortions of polygons are those of the map, by differences in the middle of a triangle, in the plane
# and in Poincare's disk.
distortions='(() => {
  const s = view.viewer.surfaces[0], {description: d, polygonData: data, picture} = s;
  const {begin, corners} = s.polygons, at = (p, i) => Array.from(p.subarray(3 * i, 3 * i + 3));
  const mix = (points, b) => [0, 1, 2].map(k => points.reduce((sum, p, i) => sum + b[i] * p[k], 0));
  const minus = (p, q) => p.map((x, k) => x - q[k]), dot = (p, q) => p.reduce((t, x, k) => t + x * q[k], 0);
  const image = {
    plane: ([x, y, w]) => [x / w, y / w, 0],
    disk: ([x, y, w]) => {
      const z = [x / w, y / w].map((t, k) => d.texture_center[k] + d.texture_radius * t);
      const f = 1 / (1 + Math.sqrt(1 - dot(z, z)));
      return [f * z[0], f * z[1], 0]; }};
  // The squared singular values of the linear map that takes u to f and v to g.
  const squares = (u, v, f, g) => {
    const e = Math.sqrt(dot(u, u)), x = dot(u, v) / e, y = Math.sqrt(dot(v, v) - x * x);
    const a = f.map(t => t / e), b = g.map((t, k) => (t - x * a[k]) / y);
    const sum = dot(a, a) + dot(b, b), root = Math.hypot(dot(a, a) - dot(b, b), 2 * dot(a, b));
    return [(sum + root) / 2, (sum - root) / 2]; };
  let checked = 0, shift;
  for(let i = 0; i + 1 < begin.length; ++i)
    if(begin[i + 1] - begin[i] === 3) {
      const c = Array.from(corners.subarray(begin[i], begin[i + 1]));
      const places = c.map(x => at(s.points, s.point(x))), h = 1e-4, m = 1 / 3;
      const f = b => image[picture.kind](mix(c.map(x => at(s.texture, x)), b));
      const [u, v] = [minus(places[1], places[0]), minus(places[2], places[0])];
      const df = [[m - h, m + h, m], [m - h, m, m + h]].map(b => minus(f(b), f(b.map(x => 2 / 3 - x)))
        .map(x => x / 2 / h));
      const turn = dot(u, u) * dot(v, v) - dot(u, v) ** 2;
      if(!(turn > 1e-6 * Math.max(dot(u, u), dot(v, v))))
        continue; // the page has too few digits
      const [most, least] = squares(u, v, ...df);
      if(!close(Math.sqrt(most / least) / data.angle_distortion.values[i], 1, 5e-3))
        return `angle of ${i}: ${Math.sqrt(most / least)}, ${data.angle_distortion.values[i]}`;
      if(picture.kind === "disk")
        { ++checked; continue; }
      shift ??= Math.log(most * least) / 2 - data.area_distortion.values[i];
      if(!close(Math.log(most * least) / 2 - data.area_distortion.values[i], shift, 1e-2))
        return `area of ${i}`;
      const [p, q, r] = c.map(x => image.plane(at(s.texture, x)));
      const [linearMost, linearLeast] = squares(u, v, minus(q, p), minus(r, p));
      if(!close(Math.sqrt(linearMost / linearLeast) / data.linear_angle_distortion.values[i], 1, 5e-3))
        return `linear angle of ${i}`;
      let error = 0;
      for(let k = 0; k < 3; ++k)
        for(let t = 0; t <= 1; t += 1 / 256) {
          const [x, y] = [c[k], c[(k + 1) % 3]].map(j => at(s.texture, j));
          const [a, b, z] = [x, y, mix([x, y], [1 - t, t])].map(image.plane);
          const linear = mix([a, b], [1 - t, t]);
          error = Math.max(error, Math.sqrt(dot(minus(z, linear), minus(z, linear)) /
            dot(minus(b, a), minus(b, a))));
        }
      if(!close(error, data.interpolation_error.values[i], 2e-3))
        return `interpolation of ${i}: ${error}, ${data.interpolation_error.values[i]}`;
      ++checked;
    }
  return checked > 5 || checked })()'
# Whole areas are equal.
equal_areas='(() => {
  const s = view.viewer.surfaces[0], sums = [0, 0], point = c => Array.from(s.points.subarray(3 * c, 3 * c + 3));
  s.polygonOfTriangle.forEach((polygon, t) => {
    const [a, b, c] = Array.from(s.triangles.subarray(3 * t, 3 * t + 3)).map(c => point(s.point(c)));
    const u = b.map((x, k) => x - a[k]), v = c.map((x, k) => x - a[k]);
    const area = Math.hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]);
    if(Number.isNaN(s.polygonData.area_distortion.values[polygon]))
      return; // it has no area
    sums[0] += area;
    sums[1] += area * Math.exp(s.polygonData.area_distortion.values[polygon]); });
  return close(sums[1] / sums[0], 1, 1e-4) || sums.join() })()'
expect 0 flatten rough.mesh.off -o a.obj --view page.html
page_shows page.html "$distortions" "$equal_areas" 'view.setColor("field angle_distortion") === undefined' \
  'share(0, isPaper) > .1' 'view.setColor("field interpolation_error") === undefined' \
  'share(0, ([r, g, b]) => b > r + 20) > .02' 'clickAt([.5, .5, .06]) === null ||
  clickAt([.5, .5, .06]).values.angle_distortion >= 1'
expect 0 flatten flat.mesh.off -o a.obj --view page.html
page_shows page.html 'view.viewer.surfaces[0].polygonData.angle_distortion.values.every(x => close(x, 1))' \
  'view.viewer.surfaces[0].polygonData.interpolation_error.values.every(x => close(x, 0))' \
  'view.viewer.surfaces[0].polygonData.area_distortion.values.every(x => close(x, 0))'
expect 0 sphere good.mesh.off -o a.ply --view page.html
page_shows page.html "$equal_areas" \
  'view.viewer.surfaces[0].polygonData.angle_distortion.values.every(x => x < 4)'

# Areas change as a whole as the statistics say, up to polygons whose sides bend on the coarse surface.
expect 0 simplify rough.mesh.off -o a.ply --vertices 20 --weight curvature=1 --weight area=2 \
  --weight area_change=6 --view page.html
page_shows page.html "$(sed 's/area_distortion/area_change/; s/, 1, 1e-4)/, view.page.statistics.area_ratio, .04)/' \
  <<<"$equal_areas")" 'view.page.statistics.area_ratio < .95' \
  'view.setColor("field area_change") === undefined' 'share(0, isPaper) > .1'
expect 0 simplify flat.mesh.off -o a.ply --vertices 20 --view page.html
page_shows page.html 'view.viewer.surfaces[0].polygonData.area_change.values.every(x => close(x, 0))'

if [ -n "$data" ]; then
  expect 0 hyperbolic "$data/meshes/eight.off" -o a.obj --view page.html
  page_shows page.html "$distortions" "$equal_areas" \
    'view.viewer.surfaces[0].polygonData.linear_angle_distortion === undefined'
fi
