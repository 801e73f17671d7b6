// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_CIRCLE_PICTURE_H
#define INTRINSIC_CIRCLE_PICTURE_H

#include "writing/Text.h"

#include <CGAL/Discrete_conformal_maps/Circle_packing.h>

#include <string>

// Adds a picture of the circles of a packing: of a disk with the unit circle, of a sphere within a
// square whose sides are three times as long as the diameter of the unit circle. It is PNG if the
// path ends with .png, else SVG.
void write_circle_picture(Text& text, const CGAL::Discrete_conformal_maps::Circle_packing& packing,
                          const std::string& path);

#endif // INTRINSIC_CIRCLE_PICTURE_H
