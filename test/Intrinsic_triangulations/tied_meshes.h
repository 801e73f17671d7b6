// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_TRIANGULATIONS_TEST_TIED_MESHES_H
#define INTRINSIC_TRIANGULATIONS_TEST_TIED_MESHES_H

#include "hard_meshes.h"

// This file generates surfaces with exact ties: neighbors that are cocircular in exact arithmetic.
// All coordinates are integers or integers times a power of two, so that nothing has been rounded.
// The generated meshes are Delaunay.
//
// The cells of the Delaunay tessellation do not depend on how they are triangulated. A cell with k
// corners has k - 3 diagonals, and each of them is a tie. So the number of ties of a Delaunay
// triangulation is the sum of k - 3 over all cells, whichever ties were kept.
namespace Test_surfaces {

struct Tied_mesh
{
  std::string name;
  Mesh mesh;
  std::size_t ties;
};

// ---- Exact rotations ----

using Integer_vector = std::array<std::int64_t, 3>;

std::int64_t dot(const Integer_vector& v, const Integer_vector& w);

// Returns three perpendicular integer vectors of one integer length: the columns of the rotation by
// the quaternion a + bi + cj + dk, times its norm.
std::array<Integer_vector, 3> integer_axes(const std::array<std::int64_t, 4>& q);

std::array<Integer_vector, 3> random_axes(int size, Portable_random& random);

Point at(const std::array<Integer_vector, 3>& axes, const Integer_vector& place);

// Returns the mesh on the lattice of the axes, with integer coordinates.
Mesh on_lattice(Mesh mesh, const std::array<Integer_vector, 3>& axes);

// ---- Cocircular points ----

// Returns the points with integer coordinates on the circle around the origin, counterclockwise.
// The radius 1105 has 108 of them.
std::vector<Vector> points_on_circle(std::int64_t radius);

// Returns the points that are closest to a regular polygon with n corners.
// \pre `n` is at most 24
std::vector<Vector> almost_regular_polygon(std::size_t n);

// ---- Triangulations of polygons ----

void add_fan(std::size_t first, std::size_t n, Triangles& triangles);

void append(Triangles& triangles, const Triangles& more);

// ---- Families ----

// Returns a grid with a tie in each square. The angles opposite to the sides of the squares are 45
// degrees each.
Tied_mesh tied_grid(std::size_t m, std::size_t n, Portable_random& random);

// Returns one rectangle with coordinates of up to 30 bits, whose squared sides have up to 60.
Tied_mesh exact_rectangle(Portable_random& random);

// Returns a box of whole numbers of unit squares, with a tie in each. Other angles are angles of a
// grid, because the sides of squares on its edges also have the angles of two squares.
Tied_mesh tied_box(const std::array<int, 3>& size, Portable_random& random);

// Returns a polygon with n cocircular corners, cut into a fan: n - 3 ties.
Tied_mesh tied_fan(std::size_t n, Portable_random& random);

// Returns a prism with n sides. It has n - 3 ties in each base, cut into a fan below and at random
// above, and one in each side, which is a rectangle. The other angles are less than 90 degrees: for
// n > 4 a corner sees a side of the base under half of less than 120 degrees.
Tied_mesh tied_prism(std::size_t n, std::int64_t height, Portable_random& random);

// Returns a pyramid over a polygon, with n - 3 ties in the base. The angles at the foot of a side
// are less than 90 degrees, so that no sum of two is flat. For n > 4, the angle at the apex is
// below 120 degrees, and the angle in the base is below 60, so that their sum is not flat, either.
Tied_mesh tied_pyramid(std::size_t n, std::int64_t height, Portable_random& random);

// Returns a surface with a mirror plane: rungs that it cuts in half, n quadrangles between them and
// a triangle at each end of the quadrangles. Quadrangles are isosceles trapezoids, hence
// cocircular: n ties. Their sides are 16 to 24 long and the legs at least 18, up to the unit, so
// that no angle opposite to a side is 90 degrees. The triangles beside have different shapes on
// both sides, and their angle opposite to the leg is acute.
Tied_mesh mirrored_strip(std::size_t n, Portable_random& random);

// Returns a mesh of one family after the other.
Tied_mesh tied_mesh(std::uint64_t seed);

} // namespace Test_surfaces

#endif // INTRINSIC_TRIANGULATIONS_TEST_TIED_MESHES_H
