// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_SVG_PICTURE_H
#define INTRINSIC_SVG_PICTURE_H

#include "Shown_surface.h"
#include "Text.h"

#include <vector>

// Adds an SVG picture of surfaces beside each other: each in a parallel projection, polygons behind
// before those in front of them, with the edges of its triangulations; then its image in the plane
// or the disk, if there is one.
void write_svg(Text& text, const std::vector<Shown_surface>& surfaces);

#endif // INTRINSIC_SVG_PICTURE_H
