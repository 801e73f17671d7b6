// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_LEVEL_CURVES_H
#define INTRINSIC_LEVEL_CURVES_H

#include "commands/triangulation_stages.h"
#include "writing/Output_mesh.h"

#include <vector>

// Returns the level curves of a function that is linear on the faces of the triangulation, as lines
// over the faces of the input. Lines and edges have the attribute "level". The last point of a
// closed line is its first.
Output_mesh level_curves(const Triangulation& triangulation, const Mesh& input,
                         const std::vector<double>& values, const std::vector<double>& levels);

#endif // INTRINSIC_LEVEL_CURVES_H
