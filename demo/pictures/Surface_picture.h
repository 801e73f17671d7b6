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

// The part of a surface in a ball, which is seen along the normal in the middle.
struct Picture_section
{
  Point center;
  double radius;
};

// Adds a picture of surfaces beside each other: each in a parallel projection, polygons behind
// before those in front of them, with the edges of its triangulations, and over them lines that are
// marked where no polygon is in front; then its image in the plane or the disk, if there is one. It
// is PNG if the path ends with .png, else SVG. Of a section there are only the polygons that meet
// it, in a square of its size.
void write_picture(Text& text, const std::vector<Shown_surface>& surfaces, const std::string& path,
                   const std::optional<Picture_section>& section);

#endif // INTRINSIC_SURFACE_PICTURE_H
