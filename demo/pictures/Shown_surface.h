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

// Stores elements of a surface that are drawn over it, by their indices in the mesh.
struct Surface_marks
{
  std::string name;
  bool is_failure = true; // in red
  std::vector<std::int64_t> polygons;
  Polygons lines;
  std::vector<std::int64_t> points;

  bool empty() const { return polygons.empty() && lines.empty() && points.empty(); }
};

// States where the image of a surface is.
enum class Image_kind
{
  none,
  plane,
  disk, // Poincare's
  sphere
};

// Stores a surface to be drawn, with its image beside it. The names of attributes define layers:
// - edges with an attribute x_edge belong to triangulation x, unless it is -1;
// - polygons with x_face are parts of its faces; with red, green and blue they have this color;
// - points with a real attribute are colored by it;
// - points and edges at which is_x is 1 are marked.
struct Shown_surface
{
  std::string name;
  Output_mesh mesh;
  Image_kind kind = Image_kind::none;
  // Stores a position for each texture coordinate, or for each point if none exist.
  std::vector<std::array<double, 3>> image;
  std::vector<std::vector<std::array<double, 2>>> outlines; // beside the image
  std::vector<Surface_marks> marks;
  std::optional<Developed_faces> developed; // what a page shows in place of the mesh
};

#endif // INTRINSIC_SHOWN_SURFACE_H
