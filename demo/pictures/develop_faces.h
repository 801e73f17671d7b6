// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_DEVELOP_FACES_H
#define INTRINSIC_DEVELOP_FACES_H

#include "commands/triangulation_stages.h"
#include "pictures/Developed_faces.h"

#include <optional>

// Returns the developed faces. Returns nothing if a face of the input has so many crossings that
// single precision is insufficient.
std::optional<Developed_faces> develop_faces(const Triangulation& triangulation, const Mesh& input);

#endif // INTRINSIC_DEVELOP_FACES_H
