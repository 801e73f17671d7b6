# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Takes pictures of pages that the program writes, and puts them side by side, with captions, into one
PNG file. A picture is twice as many pixels wide as in the manual. Needs Chromium and pngquant."""

import base64
import html
import json
import os
import subprocess
import tempfile
from pathlib import Path

BROWSER = """chromium --headless --no-sandbox --disable-quic --no-first-run --disable-background-networking
--disable-component-update --disable-sync --hide-scrollbars --use-angle=swiftshader
--enable-unsafe-swiftshader --allow-file-access-from-files --remote-debugging-pipe""".split()


class Browser:
    """A browser without windows, which is told by messages in JSON over two pipes."""

    def __init__(self):
        self.directory = tempfile.TemporaryDirectory(ignore_cleanup_errors=True)
        (reads, self.commands), (self.answers, writes) = os.pipe(), os.pipe()
        ends = {3: os.dup(reads), 4: os.dup(writes)}  # not 3 or 4 themselves

        def place():
            for target, end in ends.items():
                os.dup2(end, target)

        low = [os.open(os.devnull, os.O_RDONLY) for _ in range(2)]
        self.process = subprocess.Popen(
            [*BROWSER, f"--user-data-dir={self.directory.name}"], preexec_fn=place, close_fds=True,
            pass_fds=(3, 4), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        for end in (reads, writes, *ends.values(), *low):
            os.close(end)
        self.rest, self.number, self.session = b"", 0, {}
        target = self.tell("Target.createTarget", url="about:blank")["targetId"]
        session = self.tell("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]
        self.session = {"sessionId": session}
        self.tell("Page.enable")

    def tell(self, method, **parameters):
        self.number += 1
        message = {"id": self.number, "method": method, "params": parameters, **self.session}
        os.write(self.commands, json.dumps(message).encode() + b"\0")
        while True:
            answer = self.message()
            if answer.get("id") == self.number:
                if "error" in answer:
                    raise RuntimeError(f"{method}: {answer['error']}")
                return answer["result"]

    def message(self):
        while b"\0" not in self.rest:
            data = os.read(self.answers, 1 << 20)
            if not data:
                raise RuntimeError("the browser has ended")
            self.rest += data
        text, self.rest = self.rest.split(b"\0", 1)
        return json.loads(text)

    def wait(self, expression):
        """Until a promise is kept."""
        result = self.tell("Runtime.evaluate", expression=expression, awaitPromise=True)
        if "exceptionDetails" in result:
            raise RuntimeError(result["exceptionDetails"])

    def picture(self, page, width, height, is_view):
        self.tell("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=2,
                  mobile=False)
        self.tell("Page.navigate", url=f"file://{Path(page).resolve()}")
        while self.message().get("method") != "Page.loadEventFired":
            pass
        if is_view:
            self.wait("window.isDrawn")
        self.wait("new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done)))")
        return base64.b64decode(self.tell("Page.captureScreenshot", format="png")["data"])

    def close(self):
        os.close(self.commands)
        os.close(self.answers)
        self.process.terminate()
        self.process.wait()
        self.directory.cleanup()


# What the script of a picture may use; `viewer` is that of the page. PARTS and PICTURE become WITHOUT_PANEL and
# that script.
SCRIPT = """<script>
isDrawn = new Promise((resolve, reject) => addEventListener('intrinsic-view-ready', () => {
  try {
    draw();
    resolve();
  } catch(error) {
    reject(error);
  }
}));
const draw = () => {
  const {viewer} = intrinsicView;
  const vector = (...p) => new viewer.views[0].pane.camera.position.constructor(...p);

  // Leaves one view: 0 is the surface and 1 its image.
  const only = i => {
    viewer.views.forEach(({pane}, k) => k === i || pane.element.remove());
    viewer.views = [viewer.views[i]];
    viewer.size = null;
    viewer.resize();
  };

  // The direction to the viewer, and upwards; then the view is moved, in widths of the surface.
  const look = (way, up, zoom = 1, right = 0, top = 0) => {
    for(const {pane} of viewer.views.filter(v => !v.pane.isPlane)) {
      const w = vector(...way).normalize(), r = vector().crossVectors(vector(...up), w).normalize();
      const {low, high} = pane.extentBox;
      const center = vector(...low.map((x, k) => (x + high[k]) / 2));
      const distance = pane.distance(center, w, vector(...up)) / zoom;
      center.addScaledVector(r, right).addScaledVector(vector().crossVectors(w, r), top);
      pane.controls.target.copy(center);
      pane.camera.up.set(...up);
      pane.camera.position.copy(center).addScaledVector(w, distance);
      pane.camera.lookAt(center);
      pane.controls.update();
    }
  };
  // Magnifies the first view, or the plane.
  const closer = (zoom, right = 0, top = 0) => {
    for(const {pane} of viewer.views) {
      const {camera, controls} = pane;
      const shift = vector(right, top, 0).applyQuaternion(camera.quaternion);
      const way = camera.position.clone().sub(controls.target);
      controls.target.add(shift);
      camera.position.copy(controls.target).addScaledVector(way, pane.isPlane ? 1 : 1 / zoom);
      camera.zoom = pane.isPlane ? zoom : 1;
      camera.updateProjectionMatrix();
      controls.update();
    }
  };

  const show = (...layers) => viewer.set({shown: Object.fromEntries(
    Object.keys(viewer.state.shown).map(key => [key, layers.includes(key)]))});
  const style = (layer, width, color) => {
    for(const {pane} of viewer.views)
      for(const [name, {material}] of pane.layers)
        if(name === layer || name.startsWith(layer + ' ')) {
          if(material.linewidth)
            material.linewidth = width;
          else
            material.size = width;
          if(color)
            material.color.set(color);
        }
  };
  const scaled = (name, low, high) => Object.assign(viewer.scale(name), {low, high});

  const placeOf = ({surface, isPicture}, vertex) => {
    const i = isPicture && surface.pointOfCorner ? surface.pointOfCorner.indexOf(vertex) : vertex;
    return vector(...(isPicture ? surface.picture.positions : surface.points).slice(3 * i, 3 * i + 3));
  };

  // A word at a vertex, where it is seen.
  const spot = (vertex, word, dx = 0, dy = 0) => {
    for(const view of viewer.views) {
      const {pane} = view, place = placeOf(view, vertex);
      const [x, y] = pane.project(place), hit = pane.pick(x, y);
      if(hit && hit.point.distanceTo(place) > .25)
        continue;
      const label = document.createElement('div');
      label.className = 'spot';
      label.textContent = word;
      label.style.left = `${pane.box.left + x + dx}px`;
      label.style.top = `${pane.box.top + y + dy}px`;
      viewer.stage.append(label);
    }
  };

  // Draws the edges at which the surface bends by more than an angle, and its boundary.
  const creases = (degrees, width, color) => {
    for(const {surface, pane} of viewer.views) {
      const {begin, corners} = surface.polygons, normals = new Map(), ends = [];
      const point = c => vector(...surface.points.slice(3 * surface.point(c), 3 * surface.point(c) + 3));
      surface.forEachSide((c, d, i) => {
        let normal = vector();
        for(let k = begin[i] + 2; k < begin[i + 1]; ++k) {
          const [p, q, r] = [begin[i], k - 1, k].map(j => point(corners[j]));
          normal.add(vector().crossVectors(q.sub(p), r.sub(p)));
        }
        normal.normalize();
        const key = [surface.point(c), surface.point(d)].sort().join();
        if(!normals.has(key))
          normals.set(key, {normal, c, d});
        else {
          if(normals.get(key).normal.dot(normal) < Math.cos(degrees * Math.PI / 180))
            ends.push(c, d);
          normals.delete(key);
        }
      });
      for(const {c, d} of normals.values())
        ends.push(c, d);
      pane.show('creases', true, () => {
        const model = [...pane.layers.values()].find(({material}) => material.linewidth);
        const result = model.clone();
        result.geometry = new model.geometry.constructor();
        result.geometry.setPositions(new Float32Array(ends.flatMap(c => point(c).toArray())));
        result.material = model.material.clone();
        result.material.polygonOffsetUnits = -200;
        result.renderOrder = 60;
        return result;
      });
      style('creases', width, color);
    }
  };

  const legend = (name, words, digits = 3) => {
    const {low, high, stops} = viewer.scale(name);
    const box = document.createElement('div');
    box.className = 'legend';
    const text = x => String(Number(x.toPrecision(digits))).replace('-', '\\u2212');
    box.innerHTML = `<span>${words}</span> <span>${text(low)}</span>
      <i style="background: linear-gradient(to right, ${stops.join(', ')})"></i>
      <span>${text(high)}</span>`;
    viewer.stage.append(box);
  };

  // What lines and points mean.
  const key = (...entries) => {
    const box = document.createElement('div');
    box.className = 'legend';
    box.innerHTML = entries.map(([color, words]) =>
      `<b style="background: ${color}"></b> ${words}`).join(' &ensp; ');
    viewer.stage.append(box);
  };

  PARTS
  PICTURE
  viewer.draw();
};
</script>
"""

WITHOUT_PANEL = """
  document.getElementById('panel').remove();
  viewer.resize();
  viewer.renderer.setClearColor('#ffffff');
"""

STYLE = """<style>
  #stage { background: #fff !important; }
  .pane { border: none !important; }
  .pane .caption { display: none; }
  .spot { position: absolute; transform: translate(-50%, -50%); width: 18px; height: 18px; text-align: center;
    font: bold 12px/18px "DejaVu Sans", sans-serif; color: #fff; background: #14202c; border-radius: 50%; }
  .legend { position: absolute; bottom: 0; width: 100%; padding: 3px 0; background: #fff; text-align: center;
    color: #22303c;
    font: 14px/18px "DejaVu Sans", sans-serif; }
  .legend b { display: inline-block; width: 22px; height: 4px; margin-bottom: 3px; }
  .legend i { display: inline-block; width: 110px; height: 10px; border: 1px solid #8795a3; }
</style>
"""

FRAME = """<!doctype html><meta charset="utf-8"><style>
  body { margin: 0; background: #fff; font: 15px/19px "DejaVu Sans", sans-serif; color: #22303c; }
  main { display: flex; flex-wrap: wrap; justify-content: center; gap: 0 8px; }
  figure { margin: 0; text-align: center; }
  figcaption { padding: 2px 6px 6px; }
  img, iframe { display: block; border: none; margin: auto; }
</style><main>"""


class Tile:
    """A page, after a script, or a picture, with a caption below it."""

    def __init__(self, source, width, height, caption="", script="", is_whole=False):
        self.source, self.size, self.caption = Path(source), (width, height), caption
        self.script, self.is_whole = script, is_whole

    def picture(self, number, browser):
        if self.source.suffix != ".html":
            return self.source
        page = self.source.with_suffix(f".{number}.html")
        text = self.source.read_text(encoding="utf-8")
        script = SCRIPT.replace("PARTS", "" if self.is_whole else WITHOUT_PANEL).replace("PICTURE", self.script)
        script += "" if self.is_whole else STYLE
        page.write_text(text.replace("<body>", "<body>\n" + script, 1), encoding="utf-8")
        picture = page.with_suffix(".png")
        picture.write_bytes(browser.picture(page, *self.size, True))
        return picture


def compose(browser, target, width, height, tiles, colors=256):
    """Writes a picture of tiles, `width` pixels wide in the manual."""
    figures = []
    for i, tile in enumerate(tiles):
        w, h = tile.size
        figures.append(f'<figure style="width: {w}px"><img src="{tile.picture(i, browser).resolve()}" '
                       f'width="{w}" height="{h}"><figcaption>{html.escape(tile.caption, False)}'
                       '</figcaption></figure>')
    width = max([width, *(tile.size[0] for tile in tiles)])
    page, picture = Path("composed.html"), Path("composed.png")
    page.write_text(FRAME + "\n".join(figures) + "</main>", encoding="utf-8")
    picture.write_bytes(browser.picture(page, width, height, False))
    subprocess.run(["pngquant", "--force", "--speed", "1", "--output", str(target), str(colors), str(picture)],
                   check=True)
