// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Lists the named parameters of this package and of Intrinsic_triangulations; see
// `define_named_parameters.h`. The file has no include guard.

// clang-format off
#ifdef CGAL_named_parameter

#ifndef CGAL_DEFINING_TAGS // that package has those
#include <CGAL/Intrinsic_triangulations/internal/input/list_of_named_parameters.h>
#endif

CGAL_named_parameter(number_of_vertices)
CGAL_named_parameter(maximum_cost)
CGAL_named_parameter(location_map)

#endif
