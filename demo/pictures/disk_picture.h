// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_DISK_PICTURE_H
#define INTRINSIC_DISK_PICTURE_H

#include <CGAL/Discrete_conformal_maps/Hyperbolic_conformal_map.h>

#include <array>
#include <string>
#include <vector>

// An SVG picture of the Poincare disk for each component: the fundamental domain, and its images
// across `depth` sides, as far as they can be seen. With cones only the domain, since its images
// overlap.
std::string disk_picture(const CGAL::Discrete_conformal_maps::Hyperbolic_conformal_map& map,
                         int depth);

// Between the centers of the disks of components.
constexpr double disk_distance = 2.04;

// The circles, and what `disk_picture()` draws of each component, as chains of short segments.
std::vector<std::vector<std::array<double, 2>>>
disk_outlines(const CGAL::Discrete_conformal_maps::Hyperbolic_conformal_map& map, int depth);

#endif // INTRINSIC_DISK_PICTURE_H
