// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Lists the named parameters of this package and of Intrinsic_triangulations; see
// `define_named_parameters.h`. The file has no include guard.

// clang-format off
#ifdef CGAL_named_parameter

#ifndef CGAL_DEFINING_TAGS // Intrinsic_triangulations defines these parameters
#include <CGAL/Intrinsic_triangulations/internal/input/list_of_named_parameters.h>
#endif

CGAL_named_parameter(vertex_condition_map)
CGAL_named_parameter(cones)
CGAL_named_parameter(maximum_log_scale)
CGAL_named_parameter(maximum_area_distortion)
CGAL_named_parameter(minimizer)
CGAL_named_parameter(flipping)
CGAL_named_parameter(initial_log_scale_map)
CGAL_named_parameter(layout)
CGAL_named_parameter(vertex_radius_map)
CGAL_named_parameter(texture_coordinates_map)
CGAL_named_parameter(homogeneous_texture_coordinates_map)

#endif
