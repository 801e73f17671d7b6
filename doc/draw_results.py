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
    mesh = MESHES / "../../../../demo/data/slivers.off"
    mesh = HERE / "../demo/data/slivers.off"
    exact, heat, plain = distances(mesh, 5)
    camera = f"scaled('distance', 0, {max(exact)}); look([0, -.75, 1], [0, 0, 1]);"
    draw(TRIANGULATIONS, "isolines", 700, 640, [
        Tile("plain.html", 345, 280, "the mesh", "viewer.set({color: 'plain'}); show('edges'); style('edges', .9, '#14202c');" + camera),
        Tile("heat.html", 345, 280, "its intrinsic Delaunay triangulation", "viewer.set({color: 'plain'}); show('intrinsic'); style('intrinsic', .9);" + camera),
        Tile("plain.html", 345, 280, "heat on the mesh: " + error(plain, exact), camera + "show();"),
        Tile("heat.html", 345, 280, "heat on the intrinsic triangulation: " + error(heat, exact), camera + "show();")])


def exact_heat():
    mesh = MESHES / "triceratops.off"
    exact, heat, plain = distances(mesh, 1)
    camera = f"scaled('distance', 0, {max(exact)});"
    draw(TRIANGULATIONS, "exact_heat", 700, 250, [
        Tile("exact.html", 225, 220, "exact", camera),
        Tile("heat.html", 225, 220, "by heat: " + error(heat, exact), camera),
        Tile("error.html", 225, 220, "the difference", "viewer.set({color: 'field error', isolines: false}); show(); legend('error', '% of the greatest distance');")])


def two_ways():
    run("simplify", "elephant.off", "-o", "out.ply", "--vertices", 160, "--coarse", "coarse.off")
    subprocess.run([PROGRAM, "view", "coarse.off", "-o", "coarse.html"], check=True)
    subprocess.run([PROGRAM, "view", MESHES / "elephant.off", "-o", "input.html"], check=True)
    draw(SIMPLIFICATION, "two_ways", 700, 300, [
        Tile("input.html", 225, 250, "the input", "style('edges', .6, '#14202c');"),
        Tile("page.html", 225, 250, "intrinsic: edges bend, the shape is kept", "style('coarse', 1.3);"),
        Tile("coarse.html", 225, 250, "in space: edges straight, faces flat", "style('edges', 1.3, '#14202c');")])


FIGURES = {f.__name__: f for f in (
    delaunay, viewer_delaunay, viewer_refine, viewer_distance, viewer_distortion, viewer_path, viewer_transfer,
    viewer_operators, viewer_uniformize, flatten, viewer_hyperbolic, simplify, isolines, exact_heat, two_ways)}
for name in sys.argv[3:] or FIGURES:
    FIGURES[name]()
browser.close()
