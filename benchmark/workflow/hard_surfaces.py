#!/usr/bin/env python3
# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""hard_surfaces.py FOLDER [--count N] [--seed S]: writes N surfaces (100 by default) of each of ten
families, FAMILY_INDEX.off, on which conformal maps are hard to compute. All are connected, oriented
manifolds without degenerate faces, of up to 2,000 vertices. A surface depends on its family, its
index and the seed only."""

import argparse
import math
import random
from fractions import Fraction
from pathlib import Path

MOST_VERTICES = 2000
TURN = 2 * math.pi


class Mesh:
    """Positions of vertices, and triples of their indices."""

    def __init__(self, points=(), faces=()):
        self.points = [tuple(p) + (0.0,) * (3 - len(p)) for p in points]
        self.faces = list(faces)

    def moved(self, motion):
        return Mesh([motion(*p) for p in self.points], self.faces)

    def write(self, path):
        with open(path, "w", encoding="utf-8") as file:
            file.write(f"OFF\n{len(self.points)} {len(self.faces)} 0\n")
            file.writelines("%r %r %r\n" % tuple(map(float, p)) for p in self.points)
            file.writelines("3 %d %d %d\n" % tuple(f) for f in self.faces)


# ---- building blocks -----------------------------------------------------------------------------


def grid(rng, m, n, place, wrap_u=False, wrap_v=False):
    """m times n quadrilaterals, each cut along a random diagonal, with corners place(i, j)."""
    columns, rows = m + (not wrap_u), n + (not wrap_v)
    mesh = Mesh([place(i, j) for i in range(columns) for j in range(rows)])
    corner = lambda i, j: (i % columns) * rows + j % rows
    for i in range(m):
        for j in range(n):
            add_quad(rng, mesh, corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1))
    return mesh


def add_quad(rng, mesh, a, b, c, d):
    mesh.faces += [(a, b, c), (a, c, d)] if rng.random() < 0.5 else [(a, b, d), (b, c, d)]


def flat_cells(rng, cells):
    """Unit squares of the plane at integer places, each cut along a random diagonal."""
    indices, mesh = {}, Mesh()
    for i, j in sorted(cells):
        corners = (i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)
        add_quad(rng, mesh, *(indices.setdefault(p, len(indices)) for p in corners))
    return Mesh([(float(x), float(y)) for x, y in indices], mesh.faces)


def voxels(rng, cells):
    """The boundary of a union of unit cubes at integer places."""
    indices, mesh = {}, Mesh()
    for cell in sorted(cells):
        for axis in range(3):
            for side in (0, 1):
                across = list(cell)
                across[axis] += 2 * side - 1
                if tuple(across) in cells:
                    continue
                square = [(0, 0), (1, 0), (1, 1), (0, 1)] if side else [(0, 0), (0, 1), (1, 1), (1, 0)]
                corners = []
                for s, t in square:
                    p = list(cell)
                    p[axis] += side
                    p[(axis + 1) % 3] += s
                    p[(axis + 2) % 3] += t
                    corners.append(indices.setdefault(tuple(p), len(indices)))
                add_quad(rng, mesh, *corners)
    return Mesh([tuple(map(float, p)) for p in indices], mesh.faces)


def subdivided(mesh, times, place=lambda *p: p):
    """Cuts each face in four, `times` times; place() moves all vertices."""
    points, faces = list(mesh.points), list(mesh.faces)
    for _ in range(times):
        middles, finer = {}, []

        def middle(a, b):
            key = min(a, b), max(a, b)
            if key not in middles:
                middles[key] = len(points)
                points.append(tuple((x + y) / 2 for x, y in zip(points[a], points[b])))
            return middles[key]

        for a, b, c in faces:
            x, y, z = middle(a, b), middle(b, c), middle(c, a)
            finer += [(a, x, z), (b, y, x), (c, z, y), (x, y, z)]
        faces = finer
    return Mesh([place(*p) for p in points], faces)


def on_sphere(x, y, z):
    r = math.sqrt(x * x + y * y + z * z)
    return x / r, y / r, z / r


def octahedron():
    points = [(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1)]
    faces = [(x, y, z) if (x + y + z) % 2 == 0 else (x, z, y) for x in (0, 1) for y in (2, 3) for z in (4, 5)]
    return Mesh([tuple(map(float, p)) for p in points], faces)


def icosahedron():
    t = (1 + math.sqrt(5)) / 2
    points = [(-1, t, 0), (1, t, 0), (-1, -t, 0), (1, -t, 0), (0, -1, t), (0, 1, t),
              (0, -1, -t), (0, 1, -t), (t, 0, -1), (t, 0, 1), (-t, 0, -1), (-t, 0, 1)]
    faces = [(0, 11, 5), (0, 5, 1), (0, 1, 7), (0, 7, 10), (0, 10, 11), (1, 5, 9), (5, 11, 4),
             (11, 10, 2), (10, 7, 6), (7, 1, 8), (3, 9, 4), (3, 4, 2), (3, 2, 6), (3, 6, 8),
             (3, 8, 9), (4, 9, 5), (2, 4, 11), (6, 2, 10), (8, 6, 7), (9, 8, 1)]
    return Mesh(points, faces)


def sphere(rng, most_times=3):
    solid = rng.choice([icosahedron, octahedron])()
    return subdivided(solid, rng.randint(1, most_times), on_sphere)


def torus(rng, m, n, thickness):
    def place(i, j):
        s, t = TURN * i / m, TURN * j / n
        r = 1 + thickness * math.cos(t)
        return r * math.cos(s), r * math.sin(s), thickness * math.sin(t)

    return grid(rng, m, n, place, True, True)


def noisy(rng, mesh, size):
    return mesh.moved(lambda *p: tuple(x + rng.uniform(-size, size) for x in p))


def power(rng, low, high):
    """A power of ten with an exponent between both."""
    return 10 ** rng.uniform(low, high)


# ---- decisions with exact numbers ----------------------------------------------------------------


def difference(p, q):
    return [Fraction(x) - Fraction(y) for x, y in zip(p, q)]


def is_degenerate(p, q, r):
    """Returns whether a face has no area, or an edge is too short for the library."""
    sides = [math.dist(p, q), math.dist(q, r), math.dist(r, p)]
    if min(sides) > 1e-30 and sum(sides) - 2 * max(sides) > 1e-12 * max(sides):
        return False
    u, v, w = difference(q, p), difference(r, p), difference(r, q)
    if min(sum(x * x for x in e) for e in (u, v, w)) < Fraction(1, 10**74):
        return True
    return all(u[i - 1] * v[i] == u[i] * v[i - 1] for i in range(3))


def is_valid(mesh, faces):
    return not any(is_degenerate(*(mesh.points[v] for v in f)) for f in faces)


def combination(points, weights):
    """The weighted mean of points, of which each coordinate is rounded once."""
    weights = [Fraction(w) for w in weights]
    total = sum(weights)
    return tuple(float(sum(w * Fraction(p[k]) for w, p in zip(weights, points)) / total) for k in range(3))


def insert(mesh, index, point):
    """Inserts a vertex in a face, if the three faces have areas."""
    a, b, c = mesh.faces[index]
    new = len(mesh.points)
    faces = [(a, b, new), (b, c, new), (c, a, new)]
    mesh.points.append(point)
    if not is_valid(mesh, faces):
        mesh.points.pop()
        return False
    mesh.faces[index] = faces[0]
    mesh.faces += faces[1:]
    return True


def split_vertex(rng, mesh, v, point):
    """Replaces a vertex inside by an edge from it to a point, if the faces around have areas."""
    following = {f[(f.index(v) + 1) % 3]: f[(f.index(v) + 2) % 3] for f in mesh.faces if v in f}
    if set(following) != set(following.values()) or len(following) < 4:
        return False
    ring = [min(following)]
    while following[ring[-1]] != ring[0]:
        ring.append(following[ring[-1]])
    shift = rng.randrange(len(ring))
    ring = ring[shift:] + ring[:shift]
    half = rng.randint(1, len(ring) - 1)
    new = len(mesh.points)
    mesh.points.append(point)
    faces = [(new, ring[i], ring[i + 1]) for i in range(half)] + [(v, ring[0], new), (new, ring[half], v)]
    moved = {frozenset((v, ring[i], ring[i + 1])) for i in range(half)}
    if not is_valid(mesh, faces):
        mesh.points.pop()
        return False
    mesh.faces = [f for f in mesh.faces if frozenset(f) not in moved] + faces
    return True


# ---- the families --------------------------------------------------------------------------------


def strip(rng):
    rows = rng.choice([1, 1, 1, 2, 3, rng.randint(2, 8)])
    most = MOST_VERTICES // (rows + 1) - 1
    n = rng.randint(1, most)
    height = power(rng, -0.3, 0.3) if n < 600 else rng.uniform(1, 2)
    return grid(rng, n, rows, lambda i, j: (float(i), height * rows * j / rows))


def comb(rng):
    teeth, length = rng.randint(2, 30), rng.randint(1, 60)
    length = min(length, (MOST_VERTICES // 2 - 2 * teeth) // teeth - 1)
    cells = {(i, 0) for i in range(2 * teeth - 1)}
    cells |= {(2 * i, 1 + j) for i in range(teeth) for j in range(length)}
    return flat_cells(rng, cells)


def saw_teeth(rng):
    n, high = rng.randint(20, MOST_VERTICES // 2 - 1), power(rng, -3, 0.3)
    width, low = power(rng, -3, 0), rng.uniform(0.1, 0.5)
    both = rng.random() < 0.3  # teeth above and below

    def place(i, j):
        tooth = high * (i % 2)
        return width * i, (low + tooth) if j else (-low - tooth if both else 0.0)

    return grid(rng, n, 1, place)


def maze(rng):
    """Corridors of width one along a random tree of a square."""
    size = rng.randint(3, 17)
    stack, seen, cells = [(0, 0)], {(0, 0)}, {(0, 0)}
    while stack:
        i, j = stack[-1]
        free = [(i + a, j + b) for a, b in ((1, 0), (-1, 0), (0, 1), (0, -1))
                if 0 <= i + a < size and 0 <= j + b < size and (i + a, j + b) not in seen]
        if not free:
            stack.pop()
            continue
        k, l = rng.choice(free)
        seen.add((k, l))
        stack.append((k, l))
        cells |= {(i + k, j + l), (2 * k, 2 * l)}
    return flat_cells(rng, cells)


def strips(rng, index):
    return (strip, comb, saw_teeth, maze)[index % 4](rng)


def tubes(rng, index):
    """Cylinders, straight or bent, open at both ends, at one, or closed by a fan at both."""
    n = rng.randint(3, 12)
    m = rng.randint(3, (MOST_VERTICES - 2) // n - 1)
    step = power(rng, -1, 0.7)
    bend = 0 if index % 2 else rng.uniform(0, 0.3) * min(1, 1 / step)
    radius = lambda i: 1.0
    if index % 5 == 4:
        wave = rng.uniform(0.2, 0.9)
        radius = lambda i: 1 + wave * math.sin(i)
    if bend:
        # around the circle of radius 3 or more, and upwards
        turn = 3 + step / bend

    def place(i, j):
        s, r = TURN * j / n, radius(i)
        if not bend:
            return r * math.cos(s), r * math.sin(s), step * i
        across, angle = turn + r * math.cos(s), bend * i
        return across * math.cos(angle), across * math.sin(angle), r * math.sin(s) + 0.4 * angle

    mesh = grid(rng, m, n, place, False, True)
    for end in (0, m)[:index // 2 % 3]:
        ring = [end * n + j for j in range(n)]
        center = len(mesh.points)
        mesh.points.append(combination([mesh.points[v] for v in ring], [1] * n))
        for j in range(n):
            a, b = ring[j], ring[(j + 1) % n]
            mesh.faces.append((b, a, center) if end else (a, b, center))
    return mesh


def base_surface(rng, index):
    """A sphere, a square or a torus with a vertex, or the middle of an edge, in the origin."""
    kind = index % 4
    if kind in (0, 1):
        mesh = sphere(rng) if kind else subdivided(octahedron(), rng.randint(1, 3))
    elif kind == 2:
        n = rng.randint(2, 20)
        mesh = grid(rng, n, n, lambda i, j: (i / n, j / n, rng.uniform(0, 0.5) / n))
    else:
        mesh = torus(rng, rng.randint(8, 30), rng.randint(5, 16), rng.uniform(0.2, 0.8))
    face = rng.choice(mesh.faces)
    p = mesh.points[face[0]]
    if rng.random() < 0.4:
        q = mesh.points[face[1]]
        mesh = mesh.moved(lambda *x: tuple(a - (b + c) / 2 for a, b, c in zip(x, p, q)))
        # both ends of this edge are moved so that its middle is the origin exactly
        mesh.points[face[1]] = tuple(-x for x in mesh.points[face[0]])
    else:
        mesh = mesh.moved(lambda *x: tuple(a - b for a, b in zip(x, p)))
    return mesh, set(face[:2])


def needles(rng, index):
    """Vertices with weights 1 : e : e and 1 : 1 : e in a few faces, and again in their parts. The
    smallest e are near the origin, where coordinates have room for them."""
    mesh, origin = base_surface(rng, index)
    number, least = rng.randint(1, 30), rng.choice([-6, -12, -16, -28, -28])
    spots = [i for i, f in enumerate(mesh.faces) if origin <= set(f)]
    spots += [rng.randrange(len(mesh.faces)) for _ in range(rng.randint(1, 5))]
    tries = 0
    while number and tries < 500:
        tries += 1
        spot = rng.choice(spots) if rng.random() < 0.7 else rng.randrange(len(mesh.faces))
        e = power(rng, least, -2)
        weights = rng.choice([[1, e, e], [1, 1, e]])
        rng.shuffle(weights)
        if insert(mesh, spot, combination([mesh.points[v] for v in mesh.faces[spot]], weights)):
            spots += [spot, len(mesh.faces) - 2, len(mesh.faces) - 1]
            number -= 1
    return mesh


def coincident(rng, index):
    """Vertices on planes through the origin get neighbors at distances down to 1e-28 across them."""
    kind = index % 4
    if kind == 0:
        mesh = subdivided(octahedron(), rng.randint(1, 3), on_sphere)
    elif kind == 1:
        n = 2 * rng.randint(1, 10)
        mesh = grid(rng, n, n, lambda i, j: (i - n / 2, j - n / 2, 0.0))
    elif kind == 2:
        n = 2 * rng.randint(2, 10)
        height = rng.uniform(0.1, 1)
        mesh = grid(rng, n, n, lambda i, j: (i - n / 2, j - n / 2, rng.choice([0.0, rng.uniform(0, height)])))
    else:
        m, n = 4 * rng.randint(2, 6), 4 * rng.randint(1, 4)
        mesh = torus(rng, m, n, rng.uniform(0.2, 0.8))
        mesh = mesh.moved(lambda *p: tuple(x if abs(x) > 1e-12 else 0.0 for x in p))
    number, tries, least = rng.randint(1, 30), 0, rng.choice([-12, -20, -28, -28])
    while number and tries < 500:
        tries += 1
        if rng.random() < 0.3:  # again at a vertex that has such a neighbor
            v = rng.randrange(max(0, len(mesh.points) - 5), len(mesh.points))
        else:
            v = rng.randrange(len(mesh.points))
        free = [k for k in range(3) if abs(mesh.points[v][k]) < 1e-10]
        if not free:
            continue
        point, size = list(mesh.points[v]), power(rng, least, least / 2)
        for k in rng.sample(free, rng.randint(1, len(free))):
            point[k] += rng.choice([-1, 1]) * size * rng.uniform(0.5, 1)
        if rng.random() < 0.5:
            number -= split_vertex(rng, mesh, v, tuple(point))
        else:
            around = [i for i, f in enumerate(mesh.faces) if v in f]
            number -= insert(mesh, rng.choice(around), tuple(point))
    return mesh


def stretched(rng, index):
    mesh = sphere(rng)
    if rng.random() < 0.5:
        mesh = noisy(rng, mesh, power(rng, -3, -1.3))
    axis = [on_sphere(*(rng.gauss(0, 1) for _ in range(3))), (1, 0, 0)][index % 2]
    factor = power(rng, 0, 5) * (1 if rng.random() < 0.7 else 1e-5)  # longer, or flatter

    def move(*p):
        along = (factor - 1) * sum(x * y for x, y in zip(p, axis))
        return tuple(x + along * y for x, y in zip(p, axis))

    return mesh.moved(move)


def holes(rng, index):
    """A square, a sphere or a torus without some faces that do not touch."""
    kind = index % 3
    if kind == 0:
        m, n = rng.randint(5, 40), rng.randint(5, 40)
        rough = rng.choice([0, rng.uniform(0, 1)])
        mesh = grid(rng, m, n, lambda i, j: (float(i), float(j), rough * rng.random()))
    elif kind == 1:
        mesh = subdivided(icosahedron(), rng.randint(2, 3), on_sphere)
    else:
        mesh = torus(rng, rng.randint(10, 40), rng.randint(6, 30), rng.uniform(0.1, 0.9))
    edges = {}
    for f in mesh.faces:
        for k in range(3):
            edges.setdefault(frozenset((f[k], f[k - 1])), []).append(f)
    taken = {v for e, sides in edges.items() if len(sides) == 1 for v in e}
    wanted, removed = rng.randint(1, 60), set()
    for f in rng.sample(mesh.faces, len(mesh.faces)):
        if wanted and not taken & set(f):
            taken |= set(f)
            removed.add(f)
            wanted -= 1
    mesh.faces = [f for f in mesh.faces if f not in removed]
    return mesh


def genus(rng, index):
    """Plates with up to ten square holes, or frames of cubes, of genus up to ten; some are rough."""
    if index % 10 == 9:
        return torus(rng, rng.randint(4, 60), rng.randint(3, 30), rng.uniform(0.01, 0.99))
    if index % 3 < 2:
        a = rng.randint(1, 10)
        b = rng.randint(1, 10 // a)
        wide, gap, high = rng.randint(1, 3), rng.randint(1, 3), rng.randint(1, 2)
        step = wide + gap
        inside = lambda i, j: i % step >= wide and j % step >= wide
        cells = {(i, j, k) for i in range(a * step + wide) for j in range(b * step + wide)
                 for k in range(high) if not inside(i, j)}
    else:
        # edges of a block of 1 x 1 x 1 (genus 5) or 2 x 1 x 1 (genus 9) boxes
        long, sides = rng.randint(1, 2), [rng.randint(2, 5) for _ in range(3)]
        ends = [long * sides[0], sides[1], sides[2]]
        cells = {(i, j, k) for i in range(ends[0] + 1) for j in range(ends[1] + 1) for k in range(ends[2] + 1)
                 if sum(x % s == 0 for x, s in zip((i, j, k), sides)) >= 2}
    mesh = voxels(rng, cells)
    if rng.random() < 0.5:
        mesh = noisy(rng, mesh, rng.uniform(0, 0.3))
    scale = [power(rng, 0, 2) if rng.random() < 0.3 else 1.0 for _ in range(3)]
    return mesh.moved(lambda *p: tuple(x * s for x, s in zip(p, scale)))


def limbs(rng, index):
    """A sphere with prisms over some faces, up to a hundred times as long as they are thick."""
    mesh = subdivided(icosahedron(), rng.randint(0, 2), on_sphere)
    number = rng.randint(1, 8)
    for f in rng.sample(mesh.faces, number):
        corners = [mesh.points[v] for v in f]
        out = on_sphere(*(sum(x) for x in zip(*corners)))
        thick = math.dist(corners[0], corners[1])
        room = (MOST_VERTICES - len(mesh.points)) // (3 * number)
        rings = rng.randint(1, max(1, min(100, room)))
        step = thick * power(rng, -0.5, 0.5)
        taper = 1 if rng.random() < 0.5 else rng.uniform(0.8, 1)
        middle = [sum(x) / 3 for x in zip(*corners)]
        mesh.faces.remove(f)
        ring = list(f)
        for i in range(1, rings + 1):
            new = list(range(len(mesh.points), len(mesh.points) + 3))
            for p in corners:
                mesh.points.append(tuple(c + taper**i * (x - c) + step * i * o
                                         for x, c, o in zip(p, middle, out)))
            for k in range(3):
                add_quad(rng, mesh, ring[k], ring[(k + 1) % 3], new[(k + 1) % 3], new[k])
            ring = new
        mesh.faces.append(tuple(ring))
    return mesh


def spirals(rng, index):
    """A band around a point, rolled up in space, ever smaller, or in and out again in nested turns."""
    rows = rng.randint(1, 4)
    most = MOST_VERTICES // (rows + 1) - 1
    kind = index % 5
    if kind == 4:
        return flat_cells(rng, nested_turns(rng))
    n, angle = rng.randint(10, most), rng.uniform(0.05, 0.4)
    if kind == 0:  # nested turns of equal width
        wide = rng.uniform(0.2, 0.9)
        place = lambda i, j: polar(1 + i * angle / TURN + wide * j / rows, i * angle)
    elif kind == 1:  # a roll
        place = lambda i, j: polar(1 + i * angle / TURN, i * angle) + (3.0 * j,)
    elif kind == 2:  # each turn smaller than the last
        shrink = rng.uniform(0.3, 0.9)
        n = min(n, int(TURN / angle * 12 / -math.log10(shrink)))
        wide = (1 - shrink) * rng.uniform(0.2, 0.9)
        place = lambda i, j: polar(shrink ** (i * angle / TURN) * (1 - wide * j / rows), i * angle)
    else:  # a ramp that winds around an axis
        place = lambda i, j: polar(1 + 2 * j / rows, -i * angle) + (0.3 * i * angle,)
    return grid(rng, n, rows, place)


def polar(r, angle):
    return r * math.cos(angle), r * math.sin(angle)


def nested_turns(rng):
    """Squares along two square spirals that meet in the middle, with walls of one square between."""
    def arm(sign, turns):
        i = j = 0
        path, length = [(0, 0)], 2
        for k in range(turns):
            dx, dy = ((1, 0), (0, 1), (-1, 0), (0, -1))[k % 4]
            for _ in range(length):
                i, j = i + dx, j + dy
                path.append((sign * i, sign * j))
            length += 4 * (k % 2)
        return path

    turns = rng.randint(2, 20)
    one = arm(1, turns)
    return set(one) | set(arm(-1, rng.randint(0, turns)))


def polygons(rng, index):
    """Random polygons in the plane without vertices inside, or with some, flattened or not."""
    kind = index % 3
    n = rng.randint(3, 200)
    if kind == 0:  # convex: on an ellipse
        ring = [polar(1, a) for a in sorted(rng.uniform(0, TURN) for _ in range(n))]
    elif kind == 1:  # seen from the origin
        spread = rng.uniform(0.1, 0.98)
        n = max(n, 5)
        ring = [polar(1 - spread * rng.random(), TURN * (i + 0.8 * rng.random()) / n) for i in range(n)]
    else:  # x-monotone
        ring = [(float(i), rng.uniform(-10, 0)) for i in range(n)]
        ring += [(i + 0.5, rng.uniform(0.1, 10)) for i in reversed(range(n - 1))]
    factor = power(rng, -4, 0)
    mesh = Mesh([(x, factor * y) for x, y in ring])
    mesh.faces = triangulation(rng, mesh.points)
    for _ in range(rng.choice([0, 0, rng.randint(1, 100)])):
        i = rng.randrange(len(mesh.faces))
        corners = [mesh.points[v] for v in mesh.faces[i]]
        insert(mesh, i, combination(corners, [rng.random() for _ in range(3)]))
    return mesh


def orientation(p, q, r):
    """Twice the signed area; exact where its sign is in doubt."""
    left, right = (q[0] - p[0]) * (r[1] - p[1]), (q[1] - p[1]) * (r[0] - p[0])
    if abs(left - right) > 1e-14 * (abs(left) + abs(right)):
        return left - right
    u, v = difference(q, p), difference(r, p)
    return u[0] * v[1] - u[1] * v[0]


def triangulation(rng, points):
    """Cuts ears off a polygon, in random order."""
    rest, faces = list(range(len(points))), []
    # only corners that are not convex can be in an ear; they may become convex, but never the reverse
    corner = lambda k: orientation(points[k - 1], points[k], points[(k + 1) % len(points)])
    reflex = [k for k in rest if corner(k) <= 0]
    while len(rest) > 3:
        for k in rng.sample(range(len(rest)), len(rest)):
            f = rest[k - 1], rest[k], rest[(k + 1) % len(rest)]
            a, b, c = (points[v] for v in f)
            if orientation(a, b, c) <= 0:
                continue
            hit = (v for v in reflex if v not in f and orientation(a, b, points[v]) >= 0
                   and orientation(b, c, points[v]) >= 0 and orientation(c, a, points[v]) >= 0)
            if next(hit, None) is None:
                break  # an ear
        else:
            raise ValueError("this polygon intersects itself")
        faces.append(f)
        rest.pop(k)
        reflex = [v for v in reflex if v != f[1]]
    return faces + [tuple(rest)]


FAMILIES = {"strips": strips, "tubes": tubes, "needles": needles, "coincident": coincident,
            "stretched": stretched, "holes": holes, "genus": genus, "limbs": limbs,
            "spirals": spirals, "polygons": polygons}


def surface(family, index, seed):
    """A surface; where random numbers make no valid one, the next ones are taken."""
    rng = random.Random(f"{family} {index} {seed}")
    while True:
        try:
            mesh = FAMILIES[family](rng, index)
        except ValueError:
            continue
        if len(mesh.points) <= MOST_VERTICES and is_valid(mesh, mesh.faces):
            return mesh


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--count", type=int, default=100)
    parser.add_argument("--seed", type=int, default=1)
    arguments = parser.parse_args()
    arguments.folder.mkdir(parents=True, exist_ok=True)
    for family in FAMILIES:
        for i in range(arguments.count):
            surface(family, i, arguments.seed).write(arguments.folder / f"{family}_{i}.off")


if __name__ == "__main__":
    main()
