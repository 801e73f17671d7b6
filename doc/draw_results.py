# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Draws the figures of the manuals that show results: draw_results.py PROGRAM MESHES [NAME...] runs the
program on meshes that CGAL ships, in the current directory, and writes PNG files into the folders fig
beside it: all, or those that are named."""

import subprocess
import sys
from pathlib import Path

import numpy as np

from draw_figures import BLUE, GREEN, INK, ORANGE, Figure
from figure_shots import Browser, Tile, compose
from plain_heat import heat_distance, read_off, read_property, write_ply

HERE = Path(__file__).resolve().parent
PROGRAM, MESHES = sys.argv[1], Path(sys.argv[2])
TRIANGULATIONS, MAPS, SIMPLIFICATION = (
    "Intrinsic_triangulations", "Discrete_conformal_maps", "Intrinsic_simplification")
EDGES = "style('input', 1.2, '#14202c'); style('intrinsic', 1.2, '#c8501e');"


KEY = "key(['#14202c', 'edges of the input'], ['#c8501e', 'intrinsic edges']);"
SPOTS = 5531, 7866, 8290, 2738, 4542, 2568, 90  # of the bear: paws, ears, feet and belly
browser = Browser()


def draw(package, name, width, height, tiles):
    compose(browser, HERE / package / "fig" / f"{name}.png", width, height, tiles)


def run(command, mesh, *words, page="page.html"):
    """Runs the program with a page, whose name it returns."""
    path = mesh if Path(mesh).exists() else MESHES / mesh
    subprocess.run([PROGRAM, command, path, "--quiet", "--view", page, *map(str, words)], check=True)
    return page


def delaunay():
    page = run("refine", "pinion_small.off", "-o", "out.ply", "--min-angle", 25)
    script = "show('{}'); " + EDGES + " closer(1.06); creases(35, 2, '#14202c');"
    draw(TRIANGULATIONS, "delaunay", 700, 355, [
        Tile(page, 340, 330, "the input", script.replace("{}", "input")),
        Tile(page, 340, 330, "an intrinsic triangulation of the same surface",
             script.replace("{}", "intrinsic"))])


def viewer_delaunay():
    page = run("delaunay", "cow.off", "-o", "out.ply")
    draw(TRIANGULATIONS, "viewer_delaunay", 700, 420, [
        Tile(page, 700, 420, "", EDGES + KEY + "closer(1.9, .12, .0);")])


def viewer_refine():
    page = run("refine", "joint.off", "-o", "out.ply")
    draw(TRIANGULATIONS, "viewer_refine", 560, 440, [Tile(page, 560, 440, "", EDGES + KEY)])


def viewer_distance():
    page = run("distance", "elephant.off", "-o", "out.ply", "--source", 0)
    draw(TRIANGULATIONS, "viewer_distance", 460, 440, [
        Tile(page, 460, 440, "", "closer(.94, 0, -.06); legend('distance', 'distance');")])


def viewer_distortion():
    page = run("flatten", "elephant.off", "-o", "out.obj")
    script = "only({}); viewer.set({color: 'field angle_distortion'}); style('is_seam', 2);"
    draw(TRIANGULATIONS, "viewer_distortion", 700, 350, [
        Tile(page, 340, 340, "", script.replace("{}", "0", 1) + "legend('angle_distortion', 'quotient of stretches');"),
        Tile(page, 350, 340, "", script.replace("{}", "1", 1) + "closer(1.05);")])


def viewer_path():
    page = run("path", "elephant.off", "-o", "out.obj", "--from", 691, "--to", 2552)
    draw(TRIANGULATIONS, "viewer_path", 460, 440, [Tile(page, 460, 440)])


def viewer_transfer():
    page = run("transfer", "cow.off", "-o", "out.txt", "--data", "values.txt", "--min-angle", 25)
    draw(TRIANGULATIONS, "viewer_transfer", 600, 400, [Tile(page, 600, 400, "", "legend('transferred_function', 'function');")])


def viewer_operators():
    page = run("operators", "eight.off", "--prefix", "out")
    draw(TRIANGULATIONS, "viewer_operators", 600, 360, [
        Tile(page, 600, 360, "", "viewer.set({color: 'field curvature', isolines: false}); show('intrinsic'); "
             "style('intrinsic', .8, '#14202c'); legend('curvature', 'Gaussian curvature');")])


def viewer_uniformize():
    page = run("uniformize", "knot1.off", "-o", "out.ply")
    script = "viewer.set({squares: 96}); style('is_seam', 2);"
    draw(TRIANGULATIONS, "viewer_uniformize", 700, 305, [
        Tile(page, 250, 300, "", "only(0);" + script), Tile(page, 440, 300, "", "only(1); closer(1.06);" + script)])


def flatten():
    page = run("flatten", "elephant.off", "-o", "out.obj")
    script = "viewer.set({squares: 128}); style('is_seam', 2);"
    draw(MAPS, "flatten", 700, 350, [
        Tile(page, 340, 340, "", "only(0);" + script), Tile(page, 350, 340, "", "only(1); closer(1.05);" + script)])


def viewer_hyperbolic():
    page = run("hyperbolic", "eight.off", "-o", "out.obj", "--tiles", 2)
    script = "viewer.set({shown: {is_seam: true}}); style('is_seam', 2.2);"
    draw(MAPS, "viewer_hyperbolic", 700, 350, [
        Tile(page, 345, 340, "", "only(0);" + script), Tile(page, 345, 340, "", "only(1); closer(1.05);" + script)])


def simplify():
    page = run("simplify", "elephant.off", "-o", "out.ply", "--ratio", .06)
    draw(SIMPLIFICATION, "simplify", 460, 440, [Tile(page, 460, 440, "", "style('coarse', 1.8);")])


def distances(mesh, source):
    """Exact, by heat on an intrinsic triangulation, and by heat on the mesh as it is."""
    run("distance", mesh, "-o", "exact.ply", "--source", source, "--method", "exact", page="exact.html")
    run("distance", mesh, "-o", "heat.ply", "--source", source, "--method", "heat", page="heat.html")
    points, faces = read_off(mesh)
    exact, heat = (read_property(f"{name}.ply", "distance") for name in ("exact", "heat"))
    plain = heat_distance(points, faces, source)
    write_ply("plain.ply", points, faces, plain, "distance")
    subprocess.run([PROGRAM, "view", "plain.ply", "-o", "plain.html"], check=True)
    write_ply("error.ply", points, faces, 100 * abs(heat - exact) / max(exact), "error")
    subprocess.run([PROGRAM, "view", "error.ply", "-o", "error.html"], check=True)
    return exact, heat, plain


def error(values, exact):
    return f"mean error {100 * np.mean(abs(values - exact)) / np.mean(exact):.2g} %"


def isolines():
    exact, heat, plain = distances(MESHES / "camel.off", 0)
    camera = f"scaled('distance', 0, {max(exact)}); look([1, .2, .35], [0, 1, 0]);"
    near = "viewer.set({color: 'plain'}); look([1, .2, .35], [0, 1, 0]); closer(8, -.03, -.3);"
    draw(TRIANGULATIONS, "isolines", 700, 610, [
        Tile("plain.html", 345, 280, "the mesh", near + "show('edges'); style('edges', 1, '#14202c');"),
        Tile("heat.html", 345, 280, "its intrinsic Delaunay triangulation", near + "show('intrinsic'); style('intrinsic', 1.1);"),
        Tile("plain.html", 345, 280, "by heat on the mesh, " + error(plain, exact), camera + "show();"),
        Tile("heat.html", 345, 280, "on the intrinsic triangulation, " + error(heat, exact), camera + "show();")])


def exact_heat():
    mesh = MESHES / "triceratops.off"
    exact, heat, plain = distances(mesh, 1)
    camera = f"scaled('distance', 0, {max(exact)});"
    draw(TRIANGULATIONS, "exact_heat", 700, 195, [
        Tile("exact.html", 225, 170, "exact", camera),
        Tile("heat.html", 225, 170, "by heat: " + error(heat, exact), camera),
        Tile("error.html", 225, 170, "the difference", "viewer.set({color: 'field error', isolines: false}); show(); legend('error', 'error in %', 2);")])


def two_ways():
    run("simplify", "elephant.off", "-o", "out.ply", "--vertices", 160, "--coarse", "coarse.off")
    subprocess.run([PROGRAM, "view", "coarse.off", "-o", "coarse.html"], check=True)
    subprocess.run([PROGRAM, "view", MESHES / "elephant.off", "-o", "input.html"], check=True)
    draw(SIMPLIFICATION, "two_ways", 700, 280, [
        Tile("input.html", 225, 250, "the input", "style('edges', .6, '#14202c');"),
        Tile("page.html", 225, 250, "intrinsic: on the same surface", "style('coarse', 1.3);"),
        Tile("coarse.html", 225, 250, "in space: flat faces", "style('edges', 1.3, '#14202c');")])


def sphere():
    left_paw, left_ear, right_ear, right_paw, right_foot, left_foot, belly = SPOTS
    run("distance", "bear.off", "-o", "distance.ply", "--source", left_paw)
    page = run("sphere", "distance.ply", "-o", "out.ply")
    script = "viewer.set({color: 'field distance'}); show(); "
    spots = " ".join(f"spot({v}, {i + 1});" for i, v in enumerate(SPOTS))
    globe = f"only(1); {script} const place = v => placeOf(viewer.views[0], v).toArray(); "
    draw(MAPS, "sphere", 700, 260, [
        Tile(page, 235, 235, "the surface", f"only(0); {script} look([0, .1, 1], [0, 1, 0]); {spots}"),
        Tile(page, 220, 235, "its map to the sphere", f"{globe} look(place({belly}), place({left_ear})); {spots}"),
        Tile(page, 220, 235, "the same from behind",
             f"{globe} look(place({belly}).map(x => -x), place({left_ear})); {spots}")])


def camera_of(points, way, up):
    """Where points are seen, and how far to the front."""
    way = np.array(way, float) / np.linalg.norm(way)
    right = np.cross(up, way) / np.linalg.norm(np.cross(up, way))
    points = points - (points.min(0) + points.max(0)) / 2
    return [complex(p @ right, p @ np.cross(way, right)) for p in points], points @ way


CROSS = [1 + 0j, 2 + 0j, 2 + 1j, 3 + 1j, 3 + 2j, 2 + 2j, 2 + 3j, 2 + 4j, 1 + 4j, 1 + 3j, 1 + 2j, 2j, 1j, 1 + 1j]
SQUARES = [(0, 1, 2, 13), (2, 3, 4, 5), (13, 2, 5, 10), (12, 13, 10, 11), (10, 5, 6, 9), (9, 6, 7, 8)]
TO_CUBE = [(1, 2, 3, 2), (4, 5, 6, 5), (10, 11, 10, 9), (13, 12, 13, 0), (0, 1, 8, 7), (3, 4, 7, 6), (12, 11, 8, 9)]
TO_OTHER = [((5 + k) % 14, (6 + k) % 14, (5 - k) % 14, (4 - k) % 14) for k in range(7)]
HUES = [BLUE, ORANGE, GREEN, "#7a2fa0", "#b8860b", "#14a0b0", "#c02a6a"]


def convex():
    """One net, and the polyhedra to which it folds if sides are glued in two ways."""
    figure = Figure("Intrinsic_triangulations/fig/convex.svg", "A net and two of its convex polyhedra", 700, 240)
    write_net("net.off")
    for row, (glue, way) in enumerate(((TO_CUBE, (.45, -1, .5)), (TO_OTHER, (.5, -1, .45)))):
        with open("glue.txt", "w") as file:
            file.writelines(f"{a} {b} {c} {d}\n" for a, b, c, d in glue)
        subprocess.run([PROGRAM, "convex", "net.off", "--glue", "glue.txt", "-o", "folded.off", "--quiet"], check=True)
        figure.frame((22, 352)[row], 212, 46)
        for square in SQUARES:
            figure.polygon(*(CROSS[i] for i in square), color="#b8c4d0", width=1)
        for number, sides in enumerate(glue):
            for i, j in (sides[:2], sides[2:]):
                figure.line(CROSS[i], CROSS[j], color=HUES[number], width=3)
                middle = (CROSS[i] + CROSS[j]) / 2
                figure.text(middle + .17 * outside(i, j), "abcdefg"[number], HUES[number], 14, dy=5)
        figure.frame((250, 598)[row], 140, 46)
        draw_polyhedron(figure, "folded.off", way)
    figure.write()


def outside(i, j):
    low = min(i, j) if abs(i - j) == 1 else max(i, j)
    return -1j * (CROSS[(low + 1) % 14] - CROSS[low])


def write_net(path):
    with open(path, "w") as file:
        file.write(f"OFF\n{len(CROSS)} {len(SQUARES)} 0\n")
        file.writelines(f"{p.real} {p.imag} 0\n" for p in CROSS)
        file.writelines("4 " + " ".join(map(str, square)) + "\n" for square in SQUARES)


def draw_polyhedron(figure, path, way):
    points, faces = read_off(path)
    shown, depth = camera_of(points, way, (0, 0, 1))
    normals = np.array([np.cross(points[b] - points[a], points[c] - points[a]) for a, b, c in faces])
    normals /= np.maximum(np.linalg.norm(normals, axis=1), 1e-12)[:, None]
    way = np.array(way) / np.linalg.norm(way)
    sides = {}
    for f, face in enumerate(faces):
        for k in range(3):
            sides.setdefault(frozenset((face[k], face[(k + 1) % 3])), []).append(f)
    edges = [(tuple(e), fs) for e, fs in sides.items() if len(fs) == 2 and normals[fs[0]] @ normals[fs[1]] < 1 - 1e-6]
    for f, face in enumerate(faces):
        if normals[f] @ way > 0:
            light = .72 + .28 * normals[f] @ np.array([.2, -.5, .85]) / 1.01
            fill = "#" + "".join(f"{round(max(min(c * light, 255), 0)):02x}" for c in (238, 244, 250))
            figure.polygon(*(shown[i] for i in face), fill=fill, color=fill, width=.6)
    for hidden in (True, False):
        for (i, j), fs in edges:
            if (max(normals[fs] @ way) <= 1e-9) == hidden:
                figure.line(shown[i], shown[j], width=1 if hidden else 2, dash="3 4" if hidden else None,
                            color="#8a8a8a" if hidden else INK)


def packing():
    """A mesh, and circles that touch as its vertices are joined."""
    subprocess.run([PROGRAM, "pack", MESHES / "nefertiti.off", "-o", "packing.ply", "--quiet"], check=True)
    points, faces = read_off(MESHES / "nefertiti.off")
    centers = np.stack([read_property("packing.ply", name) for name in "xyz"], 1)
    radii = read_property("packing.ply", "radius")
    figure = Figure("Discrete_conformal_maps/fig/packing.svg", "A mesh and its circle packing", 700, 340)
    shown, depth = camera_of(points, (0, 0, 1), (0, 1, 0))
    size = max(abs(p.imag) for p in shown)
    disk = centers[:, 0] + 1j * centers[:, 1]
    disk *= np.exp(-1j * np.angle(np.vdot(shown, disk)))  # upright
    heights = np.array([p.imag / size / 2 + .5 for p in shown])
    figure.frame(150, 165, 155 / size)
    for a, b, c in faces[np.argsort(depth[faces].mean(1))]:
        figure.polygon(shown[a], shown[b], shown[c], fill=rising(heights[[a, b, c]].mean()), color=INK, width=.8)
    figure.frame(520, 165, 155)
    figure.circle(0j, 1, "#ffffff", INK, 1.2)
    for p, r, height in zip(disk, radii, heights):
        figure.circle(p, r, rising(height), INK, .7)
    figure.write()


def rising(part):
    """The colors of the pages, from low to high, but lighter."""
    stops = np.array([(39, 48, 107), (42, 111, 158), (63, 174, 155), (165, 215, 124), (251, 242, 176)])
    color = [np.interp(4 * part, range(5), stops[:, k]) for k in range(3)]
    return "#" + "".join(f"{round(90 + .64 * c):02x}" for c in color)


FIGURES = {f.__name__: f for f in (
    delaunay, viewer_delaunay, viewer_refine, viewer_distance, viewer_distortion, viewer_path, viewer_transfer,
    viewer_operators, viewer_uniformize, flatten, viewer_hyperbolic, simplify, isolines, exact_heat, two_ways, sphere,
    convex, packing)}
for name in sys.argv[3:] or FIGURES:
    FIGURES[name]()
browser.close()
