#!/usr/bin/env python3
# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""How large the pages of a torus of half a million triangles are, and how long they take to open
in headless Chromium without a graphics processor: benchmark_pages.py [PROGRAM], which is
build/intrinsic by default. Seconds are by the clock, the least of five runs, from navigation until
all pixels of the first picture have been read back."""

import math
import os
import re
import subprocess
import sys
import tempfile

RINGS, SECTORS, SHEAR = 708, 353, 2

SCRIPT = """<script>
addEventListener('intrinsic-view-ready', () => {
  const {viewer} = intrinsicView;
  viewer.draw();
  const gl = viewer.renderer.getContext();
  const width = gl.drawingBufferWidth, height = gl.drawingBufferHeight;
  gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4 * width * height));
  console.log(`seen after ${performance.now()} ms`);
});
</script>
"""

BROWSER = """chromium --headless --no-sandbox --disable-quic --no-first-run
--disable-background-networking --disable-component-update --disable-sync --use-angle=swiftshader
--enable-unsafe-swiftshader --window-size=1200,800 --enable-logging=stderr --v=0
--remote-debugging-port=0""".split()


# Sheared, so that Delaunay edges cross those of the mesh.
def write_torus(path):
    with open(path, "w", encoding="utf-8") as file:
        file.write(f"OFF\n{RINGS * SECTORS} {2 * RINGS * SECTORS} 0\n")
        for i in range(RINGS):
            for j in range(SECTORS):
                s, t = 2 * math.pi * (i + SHEAR * j) / RINGS, 2 * math.pi * j / SECTORS
                r = 1 + 0.4 * math.cos(t)
                file.write(f"{r * math.cos(s)!r} {r * math.sin(s)!r} {0.4 * math.sin(t)!r}\n")
        for i in range(RINGS):
            for j in range(SECTORS):
                k, turn = (j + 1) % SECTORS, SHEAR * SECTORS if j + 1 == SECTORS else 0
                a, b = i * SECTORS + j, (i + 1) % RINGS * SECTORS + j
                c, d = (i + 1 + turn) % RINGS * SECTORS + k, (i + turn) % RINGS * SECTORS + k
                file.write(f"3 {a} {b} {c}\n3 {a} {c} {d}\n")


def seconds_to_open(page, directory):
    command = [*BROWSER, f"--user-data-dir={directory}/user", f"file://{page}"]
    with subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE,
                          text=True) as browser:
        seen = None
        for line in browser.stderr:
            seen = re.search(r"seen after ([0-9.]+) ms", line)
            if seen:
                break
        browser.kill()
    return float(seen[1]) / 1000 if seen else sys.exit(f"{page} does not open")


def main():
    program = os.path.abspath(sys.argv[1] if len(sys.argv) > 1 else "build/intrinsic")
    print("| page | bytes | bytes per triangle | until the first picture |")
    print("| --- | ---: | ---: | ---: |")
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as directory:
        mesh, page = f"{directory}/torus.off", f"{directory}/page.html"
        write_torus(mesh)
        for name, arguments in {
            "view": ["view", mesh, "-o", page],
            "delaunay": ["delaunay", mesh, "-o", f"{directory}/out.ply", "--view", page],
            "distance": ["distance", mesh, "--source", "0", "-o", f"{directory}/out.ply", "--view",
                         page],
        }.items():
            subprocess.run([program, *arguments, "--quiet"], check=True)
            size = os.path.getsize(page)
            with open(page, encoding="utf-8") as file:
                text = file.read().replace("<body>", "<body>\n" + SCRIPT, 1)
            with open(page, "w", encoding="utf-8") as file:
                file.write(text)
            seconds = min(seconds_to_open(page, directory) for _ in range(5))
            print(f"| `intrinsic {name}` | {size:,} | {size / (2 * RINGS * SECTORS):.0f} "
                  f"| {seconds:.1f} s |", flush=True)


main()
