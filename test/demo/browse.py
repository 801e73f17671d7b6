# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Opens a page that the program wrote in headless Chromium: browse.py PAGE CLAIM... fails unless
the page loads without errors and requests, and every CLAIM, a JavaScript expression of `view`, that
is window.intrinsicView, and of the functions below, is true; "print(X)" prints X. With --screenshot
FILE, a picture of the page is left there, after the claims; --size is that of the window. The exit
code is 77 if there is no Chromium."""

import argparse
import html
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile

SCRIPT = """<script>
const problems = [], printed = [];
const problem = text => problems.push(String(text));
console.error = problem;
addEventListener('error', event => problem(event.message));
addEventListener('unhandledrejection', event => problem(event.reason));
addEventListener('securitypolicyviolation', event => problem(`blocked: ${event.blockedURI}`));
const print = text => printed.push(String(text)) > 0;
const close = (a, b, error = 1e-3) => Math.abs(a - b) <= error;
const closePoints = (p, q, error) => p.every((x, i) => close(x, q[i], error));
const isRed = ([r, g, b]) => r > 180 && g < 80 && b < 80;
const isPaper = ([r, g, b]) => r > 243 && g > 245 && b > 247;
const clickAt = point => intrinsicView.pick(...intrinsicView.project(point));
const colorAt = point => intrinsicView.pixel(...intrinsicView.project(point));
// The part of the pixels of a view that pass a test; 0 is the surface and 1 its picture.
const share = (i, test) => {
  const {viewer} = intrinsicView;
  viewer.draw();
  const gl = viewer.renderer.getContext();
  const {left, width, top, height} = viewer.views[i].pane.box;
  const pixels = new Uint8Array(4 * Math.floor(width) * Math.floor(height));
  gl.readPixels(left, gl.drawingBufferHeight - top - height, Math.floor(width), Math.floor(height),
    gl.RGBA, gl.UNSIGNED_BYTE, pixels);
  let hits = 0;
  for(let k = 0; k < pixels.length; k += 4)
    hits += test(pixels.subarray(k, k + 3));
  return 4 * hits / pixels.length;
};
function check(view, claims) {
  for(const claim of claims)
    try {
      const value = eval(claim);
      if(value !== true)
        problem(`${value} instead of true: ${claim}`);
    } catch(error) {
      problem(`${claim}: ${error}`);
    }
  for(const {name} of performance.getEntriesByType('resource'))
    if(!/^(blob|data):/.test(name))
      problem(`request: ${name}`);
}
addEventListener('intrinsic-view-ready', () => {
  check(intrinsicView, CLAIMS);
  const result = document.createElement('pre');
  result.id = 'result';
  result.hidden = true;
  result.textContent = JSON.stringify({problems, printed});
  document.body.append(result);
});
</script>
"""

OPTIONS = """--headless --no-sandbox --disable-quic --no-first-run --disable-background-networking
--disable-component-update --disable-sync --hide-scrollbars --use-angle=swiftshader
--enable-unsafe-swiftshader --virtual-time-budget=20000""".split()


def browser():
    for name in "chromium", "chromium-browser", "google-chrome":
        if shutil.which(name):
            return shutil.which(name)
    sys.exit(77)


# `eval` is for the claims only: the page itself does without.
def with_claims(page, claims):
    script = SCRIPT.replace("CLAIMS", json.dumps(claims).replace("<", "\\u003c"))
    page = page.replace("script-src 'unsafe-inline'", "script-src 'unsafe-eval' 'unsafe-inline'")
    return page.replace("<body>", "<body>\n" + script, 1)


def opened(page, directory, options):
    command = [browser(), *OPTIONS, f"--user-data-dir={directory}/user", *options]
    run = subprocess.run([*command, f"file://{page}"], capture_output=True, text=True, timeout=300)
    return run.stdout


def result_of(dom):
    found = re.search(r'<pre id="result"[^>]*>(.*?)</pre>', dom, re.S)
    if not found:
        error = re.search(r'<p class="error">(.*?)</p>', dom, re.S)
        return {"problems": [error[1] if error else "the page did not become ready"], "printed": []}
    return json.loads(html.unescape(found[1]))


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("page")
    parser.add_argument("claims", nargs="*")
    parser.add_argument("--screenshot")
    parser.add_argument("--size", default="1200,800")
    arguments = parser.parse_args()
    with open(arguments.page, encoding="utf-8") as file:
        page = with_claims(file.read(), arguments.claims)
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as directory:
        copy = os.path.join(directory, "page.html")
        with open(copy, "w", encoding="utf-8") as file:
            file.write(page)
        options = [f"--window-size={arguments.size}"]
        result = result_of(opened(copy, directory, options + ["--dump-dom"]))
        if arguments.screenshot:
            opened(copy, directory, options + [f"--screenshot={arguments.screenshot}"])
    print(*result["printed"], sep="\n", end="\n" if result["printed"] else "")
    sys.exit("\n".join(result["problems"]) or 0)


main()
