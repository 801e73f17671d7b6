// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_DEVELOP_FACES_H
#define INTRINSIC_DEVELOP_FACES_H

#include "pictures/Developed_faces.h"

#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>

#include <cstddef>
#include <optional>
#include <vector>

using Triangulation = CGAL::Intrinsic_triangulations::Intrinsic_triangulation<>;

// The greatest number of polygons of a common subdivision in a page. The page develops the faces of
// larger triangulations.
constexpr std::size_t most_polygons = 200000;

// Returns the developed faces, with functions on the input and on the triangulation. Returns
// nothing if a face of the input has so many crossings that single precision is insufficient.
// Precondition: lengths of the input are distances of the points of its vertices.
std::optional<Developed_faces> develop_faces(const Triangulation& triangulation,
                                             std::vector<Point> points,
                                             const std::vector<Attribute>& input_data,
                                             std::vector<Attribute> vertex_data);

#endif // INTRINSIC_DEVELOP_FACES_H
