// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_SURFACE_CURVES_H
#define INTRINSIC_SURFACE_CURVES_H

#include "commands/triangulation_stages.h"

#include <CGAL/Intrinsic_triangulations/Surface_curve.h>

#include <cstddef>
#include <string>

// Stores polylines of a file on the input of a triangulation.
struct Curves_on_surface
{
  CGAL::Intrinsic_triangulations::Surface_curve<double> segments;
  std::size_t number_of_polylines;
  std::size_t number_of_points;
  double greatest_distance; // of a point from the surface
};

// Reads polylines: elements "l" of .obj, edges of .ply joined where two meet, Lines of .vtp, or the
// points of .xyz in their order. Moves their points to the surface and joins them by shortest
// paths. Throws Program_error if the file has none, a point is too far away, or two are not
// connected.
Curves_on_surface read_curves(const std::string& path, const Mesh& mesh,
                              const Triangulation& triangulation);

#endif // INTRINSIC_SURFACE_CURVES_H
