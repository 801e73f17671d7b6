# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Draws the figures of the manuals that explain ideas: draw_figures.py writes SVG files into the
folders fig beside it. What has a formula is computed."""

import cmath
import math
from pathlib import Path

HERE = Path(__file__).resolve().parent
BLUE, GREY, ORANGE, GREEN, INK = "#1f6fb4", "#8a8a8a", "#c8501e", "#147a5a", "#222222"
PALE = "#eef4fa"
SMALL = 19  # captions: 11 pixels where a page shows 900 pixels at 520


class Figure:
    """Shapes in coordinates that lead upwards, in a picture of `width` x `height` pixels."""

    def __init__(self, path, title, width, height):
        self.path, self.height, self.center, self.scale = path, height, (0, 0), 1
        self.lines = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" '
                      f'viewBox="0 0 {width} {height}" font-family="DejaVu Sans, Verdana, sans-serif" '
                      f'font-size="20" text-anchor="middle">', f"<title>{title}</title>",
                      f'<rect width="{width}" height="{height}" fill="#ffffff"/>']

    def frame(self, x, y, scale):
        """From here on, the origin is at the pixel x, y."""
        self.center, self.scale = (x, y), scale

    def at(self, p):
        x, y = (p.real, p.imag) if isinstance(p, complex) else p
        return self.center[0] + self.scale * x, self.center[1] - self.scale * y

    def path_of(self, points):
        return " ".join("{:.1f},{:.1f}".format(*self.at(p)) for p in points)

    def line(self, *points, color=INK, width=2.5, dash=None, arrow=False):
        extra = f' stroke-dasharray="{dash}"' if dash else ""
        self.lines.append(f'<polyline points="{self.path_of(points)}" fill="none" stroke="{color}" '
                          f'stroke-width="{width}" stroke-linejoin="round" stroke-linecap="round"{extra}/>')
        if arrow:
            self.head(points[-2], points[-1], color)

    def head(self, p, q, color):
        (x0, y0), (x1, y1) = self.at(p), self.at(q)
        way = complex(x1 - x0, y1 - y0)
        way /= abs(way)
        tips = [complex(x1, y1)] + [complex(x1, y1) - 11 * way * cmath.exp(s * .4j) for s in (1, -1)]
        corners = " ".join(f"{t.real:.1f},{t.imag:.1f}" for t in tips)
        self.lines.append(f'<polygon points="{corners}" fill="{color}"/>')

    def polygon(self, *points, fill=PALE, color="none", width=2.5, opacity=1):
        self.lines.append(f'<polygon points="{self.path_of(points)}" fill="{fill}" stroke="{color}" '
                          f'stroke-width="{width}" stroke-linejoin="round" fill-opacity="{opacity}"/>')

    def circle(self, p, radius, fill="none", color=INK, width=1.5):
        x, y = self.at(p)
        self.lines.append(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="{radius * self.scale:.1f}" '
                          f'fill="{fill}" stroke="{color}" stroke-width="{width}"/>')

    def dot(self, *points, color=INK, pixels=4):
        for p in points:
            self.circle(p, pixels / self.scale, color, "none")

    def text(self, p, words, color=INK, size=20, dx=0, dy=6, anchor="middle", halo=False):
        x, y = self.at(p)
        extra = ' stroke="#ffffff" stroke-width="4" paint-order="stroke" stroke-linejoin="round"' if halo else ""
        self.lines.append(f'<text x="{x + dx:.1f}" y="{y + dy:.1f}" fill="{color}" font-size="{size}" '
                          f'text-anchor="{anchor}"{extra}>{words}</text>')

    def write(self):
        (HERE / self.path).write_text("\n".join(self.lines + ["</svg>", ""]))


def arc(p, q, bend, steps=40):
    """From p to q, off the straight line by `bend` in the middle, to the left."""
    side = 1j * (q - p)
    return [p + t * (q - p) + 4 * bend * t * (1 - t) * side for t in (i / steps for i in range(steps + 1))]


def hyperbolic_line(p, q, steps=40):
    """Between two points of the unit circle, in the Poincare disk."""
    middle = (p + q) / 2
    if abs(middle) < 1e-9:
        return [p, q]
    center = middle / abs(middle) ** 2
    a, b = cmath.phase(p - center), cmath.phase(q - center)
    turn = (b - a + math.pi) % (2 * math.pi) - math.pi
    return [center + abs(p - center) * cmath.exp(1j * (a + turn * i / steps)) for i in range(steps + 1)]


def ptolemy():
    """An ideal quadrangle with horocycles, the flip of its diagonal, and the vectors on the light cone."""
    fig = Figure("Discrete_conformal_maps/fig/ptolemy.svg", "A Ptolemy flip and the light cone", 900, 330)
    angles = [10, 105, 190, 290]
    corners = [cmath.exp(1j * math.radians(a)) for a in angles]
    radii = [.22, .3, .18, .26]
    for x, diagonal in ((150, (0, 2)), (450, (1, 3))):
        fig.frame(x, 150, 125)
        fig.circle(0j, 1, "#fbfcfd", GREY)
        for p, r in zip(corners, radii):
            fig.circle((1 - r) * p, r, "#dfeaf5", GREY)
        for i in range(4):
            fig.line(*hyperbolic_line(corners[i], corners[(i + 1) % 4]), color=BLUE)
        fig.line(*hyperbolic_line(*(corners[i] for i in diagonal)), color=ORANGE)
        for p, name in zip(corners, "jkil"):
            fig.text(1.13 * p, f"<tspan font-style='italic'>{name}</tspan>")
    fig.frame(0, 0, 1)
    fig.line((285, -150), (315, -150), arrow=True)
    fig.text((300, -318), "ℓ<tspan baseline-shift='sub' font-size='14'>kl</tspan> "
             "ℓ<tspan baseline-shift='sub' font-size='14'>ij</tspan> = "
             "ℓ<tspan baseline-shift='sub' font-size='14'>jk</tspan> "
             "ℓ<tspan baseline-shift='sub' font-size='14'>il</tspan> + "
             "ℓ<tspan baseline-shift='sub' font-size='14'>ki</tspan> "
             "ℓ<tspan baseline-shift='sub' font-size='14'>lj</tspan>", dy=0)
    # the cone z = r, seen a little from above, with the hyperboloid in it
    fig.frame(740, 285, 105)

    def seen(r, a, z):
        return complex(r * math.cos(a), 1.02 * z + .3 * r * math.sin(a))

    rim = [seen(1.15, i * math.pi / 30, 2.1) for i in range(61)]
    fig.polygon(seen(0, 0, 0), *(seen(1.15, a, 2.1) for a in [math.pi + i * math.pi / 30 for i in range(31)]),
                fill="#f3f5f7")
    fig.line(*rim, color=GREY, width=1.5)
    fig.line(rim[0], 0j, rim[30], color=GREY, width=1.5)
    heights = [2 - .04 * i for i in range(40)] + [.42]
    side = [complex(.548 * math.sqrt(z * z - .16), 1.02 * z) for z in heights]
    bowl = [complex(-p.real, p.imag) for p in side] + side[::-1]
    fig.line(*bowl, color=GREEN, width=1.5)
    fig.line(.245 + .612j, .46 + .45j, color=GREEN, width=1)
    fig.text(.53 + .4j, "H²", GREEN)
    tips = [seen(.55 * h, math.radians(a), h) for a, h in ((345, 1.45), (75, 1.8), (190, 1.35), (262, 1.15))]
    fig.polygon(*tips, fill="#dfeaf5", color=BLUE, width=2, opacity=.75)
    fig.line(tips[0], tips[2], color=ORANGE)
    for p in tips:
        fig.line(0j, p, color=INK, width=1.2, arrow=True)
    for p, name, dx, dy in zip(tips, "jkil", (20, 18, -19, -16), (0, -6, -4, 21)):
        fig.text(p, f"v<tspan baseline-shift='sub' font-size='14'>{name}</tspan>", dx=dx, dy=dy, size=SMALL, halo=True)
    fig.write()


def interpolation():
    """A square in two triangles, one of them scaled: linear and projective interpolation."""
    fig = Figure("Discrete_conformal_maps/fig/interpolation.svg", "Linear and projective interpolation", 900, 300)
    square = [0j, 1 + 0j, 1 + 1j, 1j]
    image = [0j, 1 + 0j, .8 + .62j, .2 + .62j]
    # Scale factors e^u with equal ratios over circumcircles: weights of the projective map of a square to
    # this trapezoid.
    weights = [1, 1, 1 / .6, 1 / .6]

    def place(x, y, projective):
        ids = (0, 1, 2) if x >= y else (0, 2, 3)
        b = (1 - x, x - y, y) if x >= y else (1 - y, x, y - x)
        w = [bi * (weights[i] if projective else 1) for bi, i in zip(b, ids)]
        return sum(wi * image[i] for wi, i in zip(w, ids)) / sum(w)

    n = 8
    for x, title, kind in ((70, "a square on the surface", None), (350, "linear", False), (630, "projective", True)):
        fig.frame(x, 240, 200)
        for i in range(n):
            for j in range(n):
                cell = [(i / n, j / n), ((i + 1) / n, j / n), ((i + 1) / n, (j + 1) / n), (i / n, (j + 1) / n)]
                points = [complex(*c) if kind is None else place(*c, kind) for c in cell]
                fig.polygon(*points, fill="#3d6f9f" if (i + j) % 2 else "#eef1f4")
        outer = square if kind is None else image
        fig.line(*outer, outer[0], color=INK, width=2)
        fig.line(outer[0], outer[2], color=ORANGE)
        fig.text(.5 + 0j, title, dy=32)
    fig.write()


def three_way():
    """Edges of three triangulations in a quadrangle, and what they cut it into."""
    fig = Figure("Discrete_conformal_maps/fig/three_way.svg", "Common subdivision of three triangulations", 900, 210)
    a, b, c, d = corners = [0j, 1.5 - .1j, 1.7 + .95j, .2 + 1.1j]
    p, q = .5 + .5j, 1.1 + .6j
    layers = [([(a, p), (b, p), (d, p), (p, q), (b, q), (c, q), (d, q)], GREY),
              ([(a, p), (b, p), (d, p), (b, d), (b, q), (c, q), (d, q)], BLUE),
              ([(a, p), (d, p), (p, q), (a, q), (b, q), (c, q), (p, c)], ORANGE)]
    names = ["<tspan font-style='italic'>T</tspan><tspan baseline-shift='sub' font-size='14'>1</tspan>, the input",
             "<tspan font-style='italic'>T</tspan><tspan baseline-shift='sub' font-size='14'>2</tspan>, Delaunay",
             "<tspan font-style='italic'>T</tspan><tspan baseline-shift='sub' font-size='14'>3</tspan>, ideal Delaunay",
             "their subdivision"]
    for k, name in enumerate(names):
        fig.frame(25 + 222 * k, 142, 112)
        fig.polygon(*corners, fill=PALE)
        shown = layers if k == 3 else [layers[k]]
        segments = [s for lines, _ in shown for s in lines]
        for lines, color in shown:
            for ends in lines:
                fig.line(*ends, color=color, width=2)
        fig.line(*corners, corners[0], width=2)
        if k == 3:
            for i, s in enumerate(segments):
                for t in segments[:i]:
                    x = crossing(*s, *t)
                    if x is not None:
                        fig.dot(x, pixels=3)
        fig.dot(p, q, *corners, pixels=4)
        fig.text(.8 - .1j, name, dy=42, size=SMALL)
    fig.write()


def crossing(p, q, r, s):
    """Where two segments cross inside, or None."""
    d, e = q - p, s - r
    area = (d.conjugate() * e).imag
    if abs(area) < 1e-12:
        return None
    t, u = ((r - p).conjugate() * e).imag / area, ((r - p).conjugate() * d).imag / area
    return p + t * d if 1e-9 < t < 1 - 1e-9 and 1e-9 < u < 1 - 1e-9 else None


def peacock():
    """All edges of a Delaunay triangulation at the vertex at infinity, and the plane that the rest unfolds to."""
    fig = Figure("Discrete_conformal_maps/fig/peacock.svg", "A peacock triangulation", 900, 390)
    fig.frame(210, 170, 140)
    fig.circle(0j, 1, "#fbfcfd", GREY)
    root = -.86j
    tips = [.88 * cmath.exp(1j * math.radians(a)) * (1 if i % 2 else .72)
            for i, a in enumerate(range(-28, 209, 26))]
    for i, p in enumerate(tips):
        bend = .16 * (p.real) / 1.2
        fig.line(*arc(root, p, bend), color=GREEN, width=1.8)
        if i:
            fig.line(*arc(tips[i - 1], p, -.06), color=BLUE, width=1.8)
    fig.line(*arc(tips[-1], root, .25), color=BLUE, width=0)
    fig.dot(*tips)
    fig.dot(root, color=ORANGE, pixels=6)
    fig.text(root, "∞", ORANGE, dx=18, dy=8, size=20)
    fig.text(-1.38j, "shortest geodesics from ∞ to all vertices", size=SMALL, dy=0)
    fig.frame(660, 175, 120)
    points = [-1.5 - .5j, -1 + .35j, -.7 - .7j, -.35 + .75j, 0 - .15j, .35 - .85j, .5 + .6j, .95 - .1j,
              1.5 + .3j, 1.3 - .75j]
    hull = [0, 2, 5, 9, 8, 6, 3, 1]
    edges = [(0, 4), (2, 4), (1, 4), (3, 4), (6, 4), (7, 4), (5, 4), (7, 5), (7, 9), (7, 8), (7, 6)]
    fig.polygon(*(points[i] for i in hull), color=BLUE)
    for i, j in edges:
        fig.line(points[i], points[j], color=BLUE, width=1.8)
    for i in hull:
        p = points[i]
        fig.line(p, p * (1 + .42 / abs(p)), color=GREEN, width=1.8, arrow=True)
    fig.dot(*points)
    fig.text(-1.57j, "the plane: neighbors of ∞ at the border", size=SMALL, dy=0)
    fig.write()


def star():
    """The star of a vertex with positive curvature, cut open, and flattened by the scale of the vertex."""
    fig = Figure("Intrinsic_simplification/fig/star.svg", "Flattening a star", 900, 310)
    spokes = [1, .9, 1.1, .95, 1.05, .85]
    angles = [math.radians(a) for a in (48, 52, 46, 50, 45, 54)]
    sides = [math.sqrt(a * a + b * b - 2 * a * b * math.cos(t))
             for a, b, t in zip(spokes, spokes[1:] + spokes[:1], angles)]

    def angles_at(scale):
        return [math.acos(((scale * a) ** 2 + (scale * b) ** 2 - s * s) / (2 * scale * a * scale * b))
                for a, b, s in zip(spokes, spokes[1:] + spokes[:1], sides)]

    low, high = .55, 1.
    for _ in range(60):
        middle = (low + high) / 2
        low, high = (low, middle) if sum(angles_at(middle)) < 2 * math.pi else (middle, high)

    def fan(scale, around, start):
        result, direction = [], start
        for r, t in zip(spokes + spokes[:1], around + [0]):
            result.append(scale * r * cmath.exp(1j * direction))
            direction += t
        return result

    captions = ["cut open: 295° in all", "scaled to flatness", "the vertex removed"]
    for k, caption in enumerate(captions):
        fig.frame(150 + 300 * k, 145, 108)
        scale = 1 if k == 0 else high
        rim = fan(scale, angles_at(scale), math.radians(125 if k == 0 else 60))
        fig.polygon(*rim, *([0j] if k == 0 else []), fill=PALE)
        if k < 2:
            for p in rim:
                fig.line(0j, p, color=GREY, width=1.8)
            fig.dot(0j, color=ORANGE, pixels=6)
        else:
            for i, j in ((0, 2), (2, 5), (2, 4)):
                fig.line(rim[i], rim[j], color=ORANGE, width=1.8)
        fig.line(*rim, color=BLUE)
        fig.dot(*rim)
        fig.text(-1.3j, caption, size=SMALL)
    fig.write()


def transport():
    """The mass of a removed vertex goes to its neighbors, with the vector to where it came from."""
    fig = Figure("Intrinsic_simplification/fig/transport.svg", "Transport of curvature", 760, 310)
    rim = [r * cmath.exp(1j * math.radians(a)) for r, a in
           ((1, 10), (.85, 70), (1.05, 125), (.9, 185), (1.1, 240), (.9, 305))]
    shares = [.3, .12, .2, .1, .18, .1]
    for x, is_after in ((190, False), (570, True)):
        fig.frame(x, 145, 112)
        fig.polygon(*rim, fill=PALE, color=BLUE)
        if not is_after:
            for p in rim:
                fig.line(0j, p, color=GREY, width=1.2)
                fig.line(.2 * p, .72 * p, color=ORANGE, width=2, arrow=True)
            fig.dot(0j, color=GREEN, pixels=16)
        else:
            for i, j in ((0, 2), (2, 5), (2, 4)):
                fig.line(rim[i], rim[j], color=GREY, width=1.2)
            for p, share in zip(rim, shares):
                fig.dot(p, color=GREEN, pixels=16 * math.sqrt(share))
                fig.line(p, p - .42 * p / abs(p), color=ORANGE, width=2, arrow=True)
        fig.dot(*rim, pixels=3)
        fig.text(-1.32j, "before: the mass of a vertex" if not is_after else
                 "after: at its neighbors", size=SMALL)
    fig.write()


def tufted():
    """Three triangles at an edge, seen along it: fronts and backs are glued around it."""
    fig = Figure("Intrinsic_triangulations/fig/tufted.svg", "The tufted cover at an edge of three faces", 760, 300)
    ways = [cmath.exp(1j * math.radians(a)) for a in (20, 130, 255)]
    fig.frame(180, 140, 105)
    for w in ways:
        fig.line(0j, w)
    fig.dot(0j, color=ORANGE, pixels=6)
    fig.text(-1.3j, "three triangles at an edge", size=SMALL)
    fig.frame(560, 140, 105)
    for k, w in enumerate(ways):
        nxt = ways[(k + 1) % 3]
        gap = .09
        p, q = w + gap * 1j * w, nxt - gap * 1j * nxt
        a, b = .3 * w + gap * 1j * w, .3 * nxt - gap * 1j * nxt
        turn = [a + (b - a) * t for t in (0, 1)]
        pull = .16 * (w + nxt) / max(abs(w + nxt), .3)
        curve = [(1 - t) ** 2 * a + 2 * t * (1 - t) * pull + t * t * b for t in (i / 20 for i in range(21))]
        color = (BLUE, GREEN, ORANGE)[k]
        fig.line(p, turn[0], *curve, turn[1], q, color=color)
    for w in ways:
        fig.line(w + .09j * w, w + .09 * w, w - .09j * w, color=GREY, width=1.2, dash="3 3")
    fig.text(-1.3j, "facing sides are glued", size=SMALL)
    fig.write()


def stages():
    """The stages of a decision that is exact."""
    fig = Figure("Intrinsic_triangulations/fig/stages.svg", "Stages of an exact decision", 900, 250)
    boxes = [("stored lengths", "with error bounds:", "nearly all edges"),
             ("squared lengths", "of straight edges:", "ties, too"),
             ("strips, rounded", "53, 102 or 512 bits", "with error bounds"),
             ("strips, exact", "sums of roots:", "ties, too")]
    for k, (name, *words) in enumerate(boxes):
        x = 10 + 229 * k
        fig.polygon((x, -40), (x + 192, -40), (x + 192, -140), (x, -140), color=BLUE, width=2)
        fig.text((x + 96, -66), name)
        for i, line in enumerate(words):
            fig.text((x + 96, -94 - 22 * i), line, size=17, color="#444444")
        if k < 3:
            fig.line((x + 195, -90), (x + 226, -90), arrow=True, width=2)
            fig.text((x + 210, -74), "?", size=18, dy=0)
        fig.line((x + 96, -142), (x + 96, -186), arrow=True, width=2, color=GREEN)
    fig.polygon((10, -190), (889, -190), (889, -232), (10, -232), fill="#e8f3ee", color=GREEN, width=2)
    fig.text((450, -211), "the sign is certain: flip, keep, or a tie, which keeps the edge", size=SMALL)
    fig.write()


if __name__ == "__main__":
    for draw in (ptolemy, interpolation, three_way, peacock, star, transport, tufted, stages):
        draw()
