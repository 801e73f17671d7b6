// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_SURFACE_PICTURE_H
#define INTRINSIC_SURFACE_PICTURE_H

#include "pictures/Shown_surface.h"
#include "writing/Text.h"

#include <optional>
#include <string>
#include <vector>

// Stores the part of a surface in a ball, seen along the normal at the center.
struct Picture_section
{
  Point center;
  double radius;
};

// Adds a picture of surfaces side by side. Each is shown in a parallel projection, with polygons
// from back to front and the edges of its triangulations. Marked lines are drawn over it if no
// polygon hides them. Then its image in the plane or the disk follows, if it has one. The picture
// is PNG if the path ends with .png, else SVG. A section shows only the polygons that meet it, in a
// square of its size.
void write_picture(Text& text, const std::vector<Shown_surface>& surfaces, const std::string& path,
                   const std::optional<Picture_section>& section);

#endif // INTRINSIC_SURFACE_PICTURE_H
