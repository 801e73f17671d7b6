// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_SHOWN_SURFACE_H
#define INTRINSIC_SHOWN_SURFACE_H

#include "pictures/Developed_faces.h"
#include "writing/Output_mesh.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

// Elements of a surface that are drawn over it. Indices are those of the mesh.
struct Surface_marks
{
  std::string name;
  bool is_failure = true; // in red
  std::vector<std::int64_t> polygons;
  Polygons lines;
  std::vector<std::int64_t> points;

  bool empty() const { return polygons.empty() && lines.empty() && points.empty(); }
};

// Where the image of a surface is.
enum class Image_kind
{
  none,
  plane,
  disk, // Poincare's
  sphere
};

// A surface to be drawn, with its image beside it. Layers come from attributes, by their names:
// - edges with an attribute x_edge are those of triangulation x, unless it is -1;
// - polygons with x_face are parts of its faces; with red, green and blue they have this color;
// - points with a real attribute are colored by it;
// - points and edges at which is_x is 1 are marked.
struct Shown_surface
{
  std::string name;
  Output_mesh mesh;
  Image_kind kind = Image_kind::none;
  // for each texture coordinate, or point if there are none
  std::vector<std::array<double, 3>> image;
  std::vector<std::vector<std::array<double, 2>>> outlines; // beside the image
  std::vector<Surface_marks> marks;
  std::optional<Developed_faces> developed; // what a page shows in place of the mesh
};

#endif // INTRINSIC_SHOWN_SURFACE_H
