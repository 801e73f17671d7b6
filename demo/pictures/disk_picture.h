// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_DISK_PICTURE_H
#define INTRINSIC_DISK_PICTURE_H

#include <CGAL/Discrete_conformal_maps/Hyperbolic_conformal_map.h>

#include <array>
#include <string>
#include <vector>

// Returns an SVG picture of the Poincare disk for each component: the fundamental domain, and its
// visible images across `depth` sides. With cones, it shows only the domain, because its images
// overlap.
std::string disk_picture(const CGAL::Discrete_conformal_maps::Hyperbolic_conformal_map& map,
                         int depth);

// This is the distance between the centers of the disks of components.
constexpr double disk_distance = 2.04;

// Returns the circles, and the lines of `disk_picture()` for each component, as chains of short
// segments.
std::vector<std::vector<std::array<double, 2>>>
disk_outlines(const CGAL::Discrete_conformal_maps::Hyperbolic_conformal_map& map, int depth);

#endif // INTRINSIC_DISK_PICTURE_H
