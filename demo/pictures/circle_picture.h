// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_CIRCLE_PICTURE_H
#define INTRINSIC_CIRCLE_PICTURE_H

#include "writing/Text.h"

#include <CGAL/Discrete_conformal_maps/Circle_packing.h>

#include <string>

// Adds a picture of the circles of a packing, with the unit disk and its circle, or the disk with
// three times its radius. It is PNG if the path ends with .png, else SVG.
void write_circle_picture(Text& text, const CGAL::Discrete_conformal_maps::Circle_packing& packing,
                          const std::string& path);

#endif // INTRINSIC_CIRCLE_PICTURE_H
