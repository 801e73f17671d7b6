// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_MAP_DISTORTION_H
#define INTRINSIC_MAP_DISTORTION_H

#include "pictures/Shown_surface.h"
#include "writing/Output_mesh.h"

// Adds how far a map is from an isometry to the polygons of the common subdivision of its
// triangulations, on each of which it is projective, at the middle of the greatest triangle of
// each:
// - "angle_distortion": the quotient of the greatest and the least stretch, 1 where it is
//   conformal;
// - "area_distortion": the logarithm of the stretch of areas, if the whole areas are made equal;
// and of a map to the plane
// - "linear_angle_distortion": the quotient if texture coordinates are interpolated linearly;
// - "interpolation_error": the greatest distance between linear and projective interpolation on a
//   side of the polygon, as a part of that side. NaN where a polygon or its image has no area. The
//   map is that of the texture, in homogeneous coordinates, in the plane or in Klein's disk with
//   its metric; or to the sphere, by the point attributes "homogeneous_x", "_y", "_z" and "_w".
void add_distortion(Output_mesh& mesh, Image_kind kind);

#endif // INTRINSIC_MAP_DISTORTION_H
