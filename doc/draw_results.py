# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Draws the figures of the manuals that show results: draw_results.py PROGRAM MESHES [NAME...] runs the
program on meshes that CGAL ships, in the current directory, and writes pictures into the folders fig
beside it: all, or those that are named. Each is 700 pixels wide in the manual."""

import math
import subprocess
import sys
from pathlib import Path

import numpy as np

from draw_figures import BLUE, GREEN, GREY, INK, ORANGE, Figure
from figure_shots import Browser, Tile, compose
from plain_heat import heat_distance, read_off, read_property, write_ply

HERE = Path(__file__).resolve().parent
PROGRAM, MESHES = sys.argv[1], Path(sys.argv[2])
TRIANGULATIONS, MAPS, SIMPLIFICATION = (
    "Intrinsic_triangulations", "Discrete_conformal_maps", "Intrinsic_simplification")
WIDTH = 700
FIGURES = {}

# What figures have in common; see SCRIPT in figure_shots.py.
EDGES = "style('input', 1.2, '#14202c'); style('intrinsic', 1.3, '#c8501e');"
KEY = "key(['#14202c', 'edges of the input'], ['#c8501e', 'intrinsic edges']);"
BACK = "look([-.5, .25, -1], [0, 1, 0]);"  # of the elephant


def figure(package, height):
    """Makes a function that returns tiles draw a picture of the same name."""
    def decorate(tiles):
        picture = HERE / package / "fig" / f"{tiles.__name__}.png"
        FIGURES[tiles.__name__] = lambda browser: compose(browser, picture, WIDTH, height, tiles())
        return tiles
    return decorate


def vector_figure(package, title, height):
    """The same for a function that draws into a Figure."""
    def decorate(draw):
        def write(_):
            result = Figure(f"{package}/fig/{draw.__name__}.svg", title, WIDTH, height)
            draw(result)
            result.write()
        FIGURES[draw.__name__] = write
        return draw
    return decorate


def run(command, mesh, *words, page="page.html"):
    """Runs the program with a page, whose name it returns."""
    path = mesh if Path(mesh).exists() else MESHES / mesh
    subprocess.run([PROGRAM, command, path, "--quiet", "--view", page, *map(str, words)], check=True)
    return page


def view(mesh):
    """A page of a mesh."""
    page = f"{Path(mesh).stem}.html"
    subprocess.run([PROGRAM, "view", mesh, "-o", page], check=True)
    return page


# ---- Triangulations ----

@figure(TRIANGULATIONS, 357)
def delaunay():
    page = run("refine", "pinion_small.off", "-o", "out.ply", "--min-angle", 25)
    script = EDGES + "closer(1.06); creases(35, 2.6, '#14202c');"
    return [Tile(page, 340, 330, "the input", "show('input'); " + script),
            Tile(page, 340, 330, "an intrinsic triangulation of it", "show('intrinsic'); " + script)]


@figure(TRIANGULATIONS, 420)
def viewer_delaunay():
    page = run("delaunay", "cow.off", "-o", "out.ply")
    return [Tile(page, WIDTH, 420, "", EDGES + "style('input', 1); style('intrinsic', 1.8);" + KEY +
                 "closer(2.6, .12, .02);")]


@figure(TRIANGULATIONS, 460)
def viewer_refine():
    page = run("refine", "joint.off", "-o", "out.ply")
    return [Tile(page, WIDTH, 460, "", EDGES + "style('input', .8);" + KEY + "closer(.95, 0, -.04);")]


@figure(TRIANGULATIONS, 400)
def viewer_info():
    subprocess.run([PROGRAM, "info", MESHES / "blobby-shuffled.off", "--view", "page.html"],
                   stdout=subprocess.DEVNULL)
    return [Tile("page.html", WIDTH, 400, "", "key(['#d81e1e', 'edges between faces of different orientation']); "
                 "closer(.97, 0, -.04);")]


@figure(TRIANGULATIONS, 420)
def viewer_transfer():
    with open("values.txt", "w") as file:
        points, _ = read_off(MESHES / "cow.off")
        file.writelines(f"{i} {math.sin(9 * p[0])}\n" for i, p in enumerate(points))
    page = run("transfer", "cow.off", "-o", "out.txt", "--data", "values.txt", "--min-angle", 25)
    return [Tile(page, WIDTH, 420, "", "scaled('transferred_function', -1, 1); closer(.97, 0, -.03); "
                 "legend('transferred_function', 'function');")]


@figure(TRIANGULATIONS, 360)
def viewer_operators():
    page = run("operators", "eight.off", "--prefix", "out")
    return [Tile(page, WIDTH, 360, "", "scaled('curvature', -60, 60); viewer.set({color: 'field curvature', isolines: false}); "
                 "show('intrinsic'); style('intrinsic', .8, '#14202c'); look([0, 1, .2], [1, 0, 0]); "
                 "closer(.95, 0, -.03); legend('curvature', 'Gaussian curvature');")]


def section(_):
    run("delaunay", "cow.off", "-o", "out.ply", "--section", 100, .05, "--picture", "section.svg")
    dark = Path("section.svg").read_text().replace(".i{stroke:#566473", f".i{{stroke:{INK}")
    (HERE / TRIANGULATIONS / "fig/section.svg").write_text(dark)


FIGURES["section"] = section


# ---- Distances ----

@figure(TRIANGULATIONS, 350)
def viewer_distance():
    page = run("distance", "elephant.off", "-o", "out.ply", "--source", 0)
    return [Tile(page, 345, 350, "", "closer(.98, 0, -.05); legend('distance', 'distance');"),
            Tile(page, 345, 350, "", BACK + "show(); closer(.98, 0, -.05);")]


@figure(TRIANGULATIONS, 350)
def viewer_path():
    page = run("path", "elephant.off", "-o", "out.obj", "--from", 691, "--to", 2552)
    return [Tile(page, 345, 350), Tile(page, 345, 350, "", BACK)]


def distances(mesh, source):
    """Exact ones, those by heat on the intrinsic Delaunay triangulation, and those on the mesh itself."""
    run("distance", mesh, "-o", "exact.ply", "--source", source, "--method", "exact", page="exact.html")
    run("distance", mesh, "-o", "heat.ply", "--source", source, "--method", "heat", page="heat.html")
    points, faces = read_off(mesh)
    exact, heat = (read_property(f"{name}.ply", "distance") for name in ("exact", "heat"))
    plain = heat_distance(points, faces, source)
    write_ply("plain.ply", points, faces, plain, "distance")
    write_ply("error.ply", points, faces, 100 * abs(heat - exact) / max(exact), "error")
    return exact, heat, plain


def error(values, exact):
    return f"mean error {100 * np.mean(abs(values - exact)) / np.mean(exact):.2g} %"


@figure(TRIANGULATIONS, 614)
def isolines():
    exact, heat, plain = distances(MESHES / "camel.off", 0)
    camera = "look([1, .2, .35], [0, 1, 0]);"
    leg = "viewer.set({color: 'plain'}); " + camera + "closer(9, .87, -.53);"
    whole = f"scaled('distance', 0, {max(exact)}); show(); " + camera
    scale = "closer(.9, 0, -.06); legend('distance', 'distance', 2);"
    page = view("plain.ply")
    return [Tile(page, 345, 280, "the mesh", leg + "show('edges'); style('edges', 1, '#14202c');"),
            Tile("heat.html", 345, 280, "its intrinsic Delaunay triangulation",
                 leg + "show('intrinsic'); style('intrinsic', 1.1);"),
            Tile(page, 345, 280, "on the mesh: " + error(plain, exact), whole + scale),
            Tile("heat.html", 345, 280, "on the intrinsic one: " + error(heat, exact), whole + scale)]


@figure(TRIANGULATIONS, 172)
def exact_heat():
    exact, heat, _ = distances(MESHES / "triceratops.off", 1)
    scale = f"scaled('distance', 0, {max(exact)}); closer(1.06, 0, -.1);"
    return [Tile("exact.html", 225, 145, "exact", scale),
            Tile("heat.html", 225, 145, "by heat: " + error(heat, exact), scale),
            Tile(view("error.ply"), 225, 145, "their difference",
                 "viewer.set({color: 'field error', isolines: false}); show(); "
                 "closer(1.06, 0, -.1); legend('error', 'error in %', 2);")]


# ---- Convex polyhedra ----

CROSS = [1 + 0j, 2 + 0j, 2 + 1j, 3 + 1j, 3 + 2j, 2 + 2j, 2 + 3j, 2 + 4j, 1 + 4j, 1 + 3j, 1 + 2j, 2j, 1j, 1 + 1j]
SQUARES = [(0, 1, 2, 13), (2, 3, 4, 5), (13, 2, 5, 10), (12, 13, 10, 11), (10, 5, 6, 9), (9, 6, 7, 8)]
TO_CUBE = [(1, 2, 3, 2), (4, 5, 6, 5), (10, 11, 10, 9), (13, 12, 13, 0), (0, 1, 8, 7), (3, 4, 7, 6), (12, 11, 8, 9)]
TO_OTHER = [((5 + k) % 14, (6 + k) % 14, (5 - k) % 14, (4 - k) % 14) for k in range(7)]
HUES = [BLUE, ORANGE, GREEN, "#7a2fa0", "#b8860b", "#14a0b0", "#c02a6a"]


@vector_figure(TRIANGULATIONS, "A net, and two convex polyhedra to which it folds", 240)
def convex(fig):
    with open("net.off", "w") as file:
        file.write(f"OFF\n{len(CROSS)} {len(SQUARES)} 0\n")
        file.writelines(f"{p.real} {p.imag} 0\n" for p in CROSS)
        file.writelines("4 " + " ".join(map(str, square)) + "\n" for square in SQUARES)
    for glue, way, left, place in ((TO_CUBE, (.45, -1, .5), 22, 250), (TO_OTHER, (.5, -1, .45), 352, 605)):
        with open("glue.txt", "w") as file:
            file.writelines(f"{a} {b} {c} {d}\n" for a, b, c, d in glue)
        subprocess.run([PROGRAM, "convex", "net.off", "--glue", "glue.txt", "-o", "folded.off", "--quiet"],
                       check=True)
        fig.frame(left, 212, 46)
        draw_net(fig, glue)
        fig.line(3.3 + 2.5j, 3.9 + 2.5j, width=2, arrow=True)
        fig.frame(place, 97, 46)
        draw_polyhedron(fig, *read_off("folded.off"), np.array(way) / np.linalg.norm(way))


def draw_net(fig, glue):
    """Sides that are glued have one color and letter."""
    for square in SQUARES:
        fig.polygon(*(CROSS[i] for i in square), color="#b8c4d0", width=1)
    for hue, letter, sides in zip(HUES, "abcdefg", glue):
        for i, j in (sides[:2], sides[2:]):
            begin = min(i, j) if abs(i - j) == 1 else max(i, j)
            outwards = -1j * (CROSS[(begin + 1) % 14] - CROSS[begin])
            fig.line(CROSS[i], CROSS[j], color=hue, width=3)
            fig.text((CROSS[i] + CROSS[j]) / 2 + .18 * outwards, letter, hue, 14, dy=5)


def draw_polyhedron(fig, points, faces, way):
    shown, _ = seen(points, way, (0, 0, 1))
    normals = np.array([np.cross(points[b] - points[a], points[c] - points[a]) for a, b, c in faces])
    normals /= np.maximum(np.linalg.norm(normals, axis=1), 1e-12)[:, None]
    for face, normal in zip(faces, normals):
        if normal @ way > 0:
            light = .72 + .28 * normal @ np.array([.2, -.5, .85])
            fill = "#" + "".join(f"{round(min(c * light, 255)):02x}" for c in (238, 244, 250))
            fig.polygon(*(shown[i] for i in face), fill=fill, color=fill, width=.6)
    sides = {}
    for f, face in enumerate(faces):
        for k in range(3):
            sides.setdefault(frozenset((face[k], face[(k + 1) % 3])), []).append(f)
    bent = [(*e, max(normals[fs] @ way) > 1e-9) for e, fs in sides.items()
            if len(fs) == 2 and normals[fs[0]] @ normals[fs[1]] < 1 - 1e-6]
    for i, j, is_seen in sorted(bent, key=lambda edge: edge[2]):
        fig.line(shown[i], shown[j], width=2 if is_seen else 1, dash=None if is_seen else "3 4",
                 color=INK if is_seen else GREY)


def seen(points, way, up):
    """Where points are in the picture, with the middle at zero, and how far to the front."""
    right = np.cross(up, way)
    right = right / np.linalg.norm(right)
    points = points - (points.min(0) + points.max(0)) / 2
    return np.array([complex(p @ right, p @ np.cross(way, right)) for p in points]), points @ way


# ---- Maps ----

@figure(TRIANGULATIONS, 560)
def viewer_flatten():
    page = run("flatten", "nefertiti.off", "-o", "out.obj", "--boundary", "disk")
    return [Tile(page, 900, 560, is_whole=True)]


def both(page, script, zoom=1.05):
    """The surface and its image."""
    return [Tile(page, 345, 350, "", f"only(0); {script} closer(.97);"),
            Tile(page, 345, 350, "", f"only(1); {script} closer({zoom});")]


@figure(TRIANGULATIONS, 350)
def viewer_distortion():
    page = run("flatten", "elephant.off", "-o", "out.obj")
    script = "scaled('angle_distortion', 1, 1.2); viewer.set({color: 'field angle_distortion'}); style('is_seam', 2);"
    result = both(page, script)
    result[0].script += "closer(.95, 0, -.06); legend('angle_distortion', 'ratio of stretches');"
    return result


@figure(MAPS, 350)
def flatten():
    page = run("flatten", "elephant.off", "-o", "out.obj")
    return both(page, "viewer.set({squares: 128}); style('is_seam', 2);")


@figure(TRIANGULATIONS, 305)
def viewer_uniformize():
    page = run("uniformize", "knot1.off", "-o", "out.ply")
    script = "viewer.set({squares: 96}); style('is_seam', 2);"
    return [Tile(page, 250, 300, "", "only(0);" + script),
            Tile(page, 440, 300, "", "only(1); closer(1.5);" + script)]


@figure(MAPS, 350)
def viewer_hyperbolic():
    page = run("hyperbolic", "eight.off", "-o", "out.obj", "--tiles", 2)
    return both(page, "viewer.set({squares: 32, shown: {is_seam: true}}); style('is_seam', 2.2); "
                "style('outlines', 1.2, '#566473');")


PLACES = 5531, 7866, 8290, 2738, 4542, 2568, 90  # of the bear: paws, ears, feet and belly


@figure(MAPS, 262)
def sphere():
    left_paw, left_ear, _, right_paw, _, _, belly = PLACES
    run("distance", "bear.off", "-o", "distance.ply", "--source", left_paw)
    page = run("sphere", "distance.ply", "-o", "out.ply")
    script = "viewer.set({color: 'field distance'}); show();"
    numbers = " ".join(f"spot({v}, {i + 1});" for i, v in enumerate(PLACES))
    globe = (f"only(1); {script} const place = v => placeOf(viewer.views[0], v).toArray(); "
             f"const front = place({belly}).map((x, k) => x + .35 * place({right_paw})[k]);")
    return [Tile(page, 235, 235, "the surface", f"only(0); {script} look([0, .1, 1], [0, 1, 0]); {numbers}"),
            Tile(page, 220, 235, "its map to the sphere", f"{globe} look(front, place({left_ear})); {numbers}"),
            Tile(page, 220, 235, "the same from behind",
                 f"{globe} look(front.map(x => -x), place({left_ear})); {numbers}")]


@vector_figure(MAPS, "A mesh and its circle packing", 330)
def packing(fig):
    mesh = MESHES / "nefertiti.off"
    subprocess.run([PROGRAM, "pack", mesh, "-o", "packing.ply", "--quiet"], check=True)
    points, faces = read_off(mesh)
    centers = read_property("packing.ply", "x") + 1j * read_property("packing.ply", "y")
    shown, depth = seen(points, np.array([0, 0, 1.]), (0, 1, 0))
    shown /= max(abs(shown.imag))
    centers *= np.exp(-1j * np.angle(np.vdot(shown, centers)))  # upright
    heights = (shown.imag + 1) / 2
    fig.frame(160, 165, 155)
    for face in faces[np.argsort(depth[faces].mean(1))]:
        fig.polygon(*shown[face], fill=rising(heights[face].mean()), color=INK, width=.8)
    fig.frame(520, 165, 155)
    fig.circle(0j, 1, "#ffffff", INK, 1.2)
    for center, radius, height in zip(centers, read_property("packing.ply", "radius"), heights):
        fig.circle(center, radius, rising(height), INK, .7)


def rising(part):
    """The colors of the pages from low to high values, but lighter."""
    stops = np.array([(39, 48, 107), (42, 111, 158), (63, 174, 155), (165, 215, 124), (251, 242, 176)])
    color = [np.interp(4 * part, range(5), stops[:, k]) for k in range(3)]
    return "#" + "".join(f"{round(90 + .64 * c):02x}" for c in color)


# ---- Simplification ----

@figure(SIMPLIFICATION, 367)
def simplify():
    page = run("simplify", "elephant.off", "-o", "out.ply", "--ratio", .06)
    return [Tile(page, 345, 340, "2,775 vertices",
                 "viewer.set({color: 'plain'}); show('input'); style('input', .7, '#14202c');"),
            Tile(page, 345, 340, "6 % of them", "show('coarse'); style('coarse', 1.8);")]


@figure(SIMPLIFICATION, 280)
def two_ways():
    page = run("simplify", "elephant.off", "-o", "out.ply", "--vertices", 160, "--coarse", "coarse.off")
    return [Tile(view(MESHES / "elephant.off"), 225, 250, "the input", "style('edges', .6, '#14202c');"),
            Tile(page, 225, 250, "on the same surface", "style('coarse', 1.3);"),
            Tile(view("coarse.off"), 225, 250, "in space, with flat faces", "style('edges', 1.3, '#14202c');")]


def main():
    browser = Browser()
    for name in sys.argv[3:] or FIGURES:
        FIGURES[name](browser)
    browser.close()


main()
