// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_WEIGHTED_COST_H
#define INTRINSIC_WEIGHTED_COST_H

#include <CGAL/Intrinsic_simplification/Transport_cost.h>

#include <map>
#include <string>
#include <vector>

// Stores weights by the names of parts of the cost of a removal. "curvature", "area", "area_change"
// and "boundary_change" are parts. Other names are functions at the vertices.
typedef std::map<std::string, double> Named_weights;

// Stores the components of functions at the vertices, by their names.
typedef std::map<std::string, std::vector<std::vector<double>>> Named_functions;

// Returns the weights of `default_cost()`.
Named_weights default_weights();

// Returns whether the name is "area_change" or "boundary_change". Such parts alone are not a cost.
bool is_part_of_change(const std::string& name);

// Returns whether the name is no part of the cost that is known for each surface.
bool is_name_of_function(const std::string& name);

// Returns the cost of removals from the surface. Each component of a function has an equal part of
// its weight.
// Precondition: each function with a weight has values at all vertices.
CGAL::Intrinsic_simplification::Transport_cost
weighted_cost(const CGAL::Intrinsic_simplification::Evolving_surface& surface,
              const Named_weights& weights, const Named_functions& functions);

#endif // INTRINSIC_WEIGHTED_COST_H
