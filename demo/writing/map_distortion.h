// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_MAP_DISTORTION_H
#define INTRINSIC_MAP_DISTORTION_H

#include "pictures/Shown_surface.h"
#include "writing/Output_mesh.h"

// Adds the distortion of a map on the polygons of the common subdivision of its triangulations, on
// which it is projective. It is measured at the center of the greatest triangle of each polygon:
// - "angle_distortion": the quotient of the greatest and the least stretch, 1 where it is
//   conformal;
// - "area_distortion": the logarithm of the stretch of areas, if the total areas are made equal.
// For a map to the plane, it also adds
// - "linear_angle_distortion": the quotient if texture coordinates are interpolated linearly;
// - "interpolation_error": the greatest distance between linear and projective interpolation on a
//   side of the polygon, relative to that side.
// Values are NaN if a polygon or its image has no area. The map is given by the texture, in
// homogeneous coordinates, in the plane or in the Klein disk with its metric. For the sphere, it is
// given by the point attributes "homogeneous_x", "_y", "_z" and "_w".
void add_distortion(Output_mesh& mesh, Image_kind kind);

#endif // INTRINSIC_MAP_DISTORTION_H
