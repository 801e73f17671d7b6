#!/usr/bin/env python3
# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws a common subdivision as `intrinsic delaunay MESH -o SUBDIVISION.ply` writes it: on the left the
faces of the input, on the right those of the intrinsic Delaunay triangulation, which bend around the
edges of the surface.

usage: draw_subdivision.py SUBDIVISION.ply PICTURE.png [AZIMUTH ELEVATION]     (needs matplotlib)
"""
import sys

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import LineCollection, PolyCollection


def read_ply(path):
    """Returns points, polygons, parents of polygons (input, intrinsic), and edges with parents."""
    lines = iter(open(path).read().split("\n"))
    counts = {}
    for line in lines:
        words = line.split()
        if words[0] == "element":
            counts[words[1]] = int(words[2])
        if words[0] == "end_header":
            break
    points = np.array([next(lines).split()[:3] for _ in range(counts["vertex"])], float)
    faces = [[int(x) for x in next(lines).split()] for _ in range(counts["face"])]
    edges = np.array([next(lines).split() for _ in range(counts["edge"])], int)
    polygons = [f[1:1 + f[0]] for f in faces]
    return points, polygons, np.array([f[1 + f[0]:] for f in faces]), edges


def view(azimuth, elevation):
    """The rotation after which x leads right, y up and z to the viewer."""
    a, e = np.radians([azimuth, elevation])
    right = np.array([-np.sin(a), np.cos(a), 0])
    forward = np.array([np.cos(a) * np.cos(e), np.sin(a) * np.cos(e), np.sin(e)])
    return np.array([right, np.cross(forward, right), forward])


def normal(corners):
    n = sum(np.cross(corners[i] - corners[0], corners[i + 1] - corners[0])
            for i in range(1, len(corners) - 1))
    return n / (np.linalg.norm(n) or 1)


def color(parent, light):
    hue = (0.61803 * parent) % 1
    base = np.array(matplotlib.colors.hsv_to_rgb((0.08 + 0.5 * hue, 0.25 + 0.2 * hue, 1)))
    return base * (0.45 + 0.55 * light)


def draw(axes, points, polygons, parents, edges, title):
    shown = []
    for polygon, parent in zip(polygons, parents):
        corners = points[polygon]
        n = normal(corners)
        if n[2] > 0:
            light = max(0, n @ np.array([-0.3, 0.5, 0.81]))
            lines = [corners[[i, (i + 1) % len(polygon)], :2] for i in range(len(polygon))
                     if frozenset((polygon[i], polygon[(i + 1) % len(polygon)])) in edges]
            shown.append((corners[:, 2].mean(), corners[:, :2], color(parent, light), lines))
    shown.sort(key=lambda item: item[0])
    for depth, (_, outline, fill, lines) in enumerate(shown):
        axes.add_collection(PolyCollection([outline], facecolors=[fill], edgecolors=[fill],
                                           linewidths=0.3, zorder=depth))
        axes.add_collection(LineCollection(lines, colors="black", linewidths=0.45, zorder=depth))
    axes.set_title(title, fontsize=11)
    axes.autoscale_view()
    axes.set_aspect("equal")
    axes.axis("off")


def main(source, picture, azimuth=30, elevation=30):
    points, polygons, parents, edges = read_ply(source)
    points = points @ view(float(azimuth), float(elevation)).T
    figure, axes = plt.subplots(1, 2, figsize=(11, 5))
    titles = "input", "intrinsic Delaunay triangulation"
    for side in (0, 1):
        drawn = {frozenset(e[:2]) for e in edges if e[2 + side] >= 0}
        draw(axes[side], points, polygons, parents[:, side], drawn, titles[side])
    figure.tight_layout()
    figure.savefig(picture, dpi=100)


main(*sys.argv[1:])
