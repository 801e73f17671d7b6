// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_FLATTENING_CONDITIONS_H
#define INTRINSIC_FLATTENING_CONDITIONS_H

#include "commands/Command_line.h"
#include "commands/options.h"
#include "reading/Input_mesh.h"
#include "reading/Polygon_soup.h"

#include <CGAL/Discrete_conformal_maps/Vertex_condition.h>

#include <optional>
#include <string>
#include <vector>

struct Flatten_options : Texture_options
{
  std::string cones; // "greedy", "exchanged", "none" or a file; empty for what suits the boundary
  std::optional<double> maximum_log_scale, maximum_area_distortion; // for cones that are placed
  std::string boundary = "free";
  std::string boundary_values;          // the file of "scale" and "curvature"
  std::string radii;                    // a property of vertices or a file; empty for no circles
  std::string solver = "newton";        // or "ceres" or "cetm"
  std::string layout = "least-squares"; // or "spectral" or "incremental"
  std::string matrix;                   // a file for the interpolation matrix
  bool has_no_overlap = false;          // charts are cut where they overlap
  bool is_in_unit_square = false;
};

using Conditions = std::vector<CGAL::Discrete_conformal_maps::Vertex_condition>;

// Returns the conditions that the options prescribe at each vertex of the mesh. They are zero on a
// boundary that gets a shape. Throws Program_error if the files are wrong.
Conditions flattening_conditions(const Flatten_options& options, const Mesh& mesh);

// Returns curvatures from a file, and zero at vertices that it does not contain.
// Throws Program_error if the file is wrong.
Conditions prescribed_curvatures(const std::string& path, const Mesh& mesh);

// Adds the option --radii.
void add_radii(CLI::App& command, Common_options& common, std::string& source);

// Returns whether the word after --boundary names a shape, whose angles the library finds.
bool is_shape(const std::string& boundary);

// Returns whether the word after --cones requests that cones are placed.
bool places_cones(const std::string& cones);

// Throws Program_error if --boundary and --boundary-values contradict each other.
void check_boundary(const Flatten_options& options);

// Throws Program_error if --radii contradicts other options.
void check_circles(const Flatten_options& options, bool is_exact);

#endif // INTRINSIC_FLATTENING_CONDITIONS_H
