// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Lists the named parameters of this package, and the parameters of CGAL that it reads; see
// `define_named_parameters.h`. The file has no include guard.

// clang-format off
#ifdef CGAL_named_parameter

#ifndef CGAL_DEFINING_TAGS // CGAL has those
CGAL_named_parameter(vertex_point_map)
CGAL_named_parameter(edge_is_constrained_map)
CGAL_named_parameter(geom_traits)
CGAL_named_parameter(number_of_iterations)
CGAL_named_parameter(visitor)
#endif

CGAL_named_parameter(edge_length_map)
CGAL_named_parameter(squared_edge_length_map)
CGAL_named_parameter(mollification)
CGAL_named_parameter(exact_decisions)
CGAL_named_parameter(concurrency_tag)
CGAL_named_parameter(time_step_factor)
CGAL_named_parameter(distance_method)
CGAL_named_parameter(minimum_angle)
CGAL_named_parameter(maximum_circumradius)
CGAL_named_parameter(simplicial)
CGAL_named_parameter(face_predicate)
CGAL_named_parameter(maximum_number_of_insertions)
CGAL_named_parameter(input_point_map)
CGAL_named_parameter(parent_vertex_map)
CGAL_named_parameter(parent_edge_map)
CGAL_named_parameter(parent_face_map)
CGAL_named_parameter(curvature_tolerance)

#endif
