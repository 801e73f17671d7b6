// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_MAP_COMMANDS_H
#define INTRINSIC_MAP_COMMANDS_H

#include "Command_run.h"
#include "Mesh_writer.h"
#include "Output_mesh.h"
#include "Statistics.h"
#include "commands.h"

#include <CGAL/Discrete_conformal_maps/Discrete_conformal_map.h>
#include <CGAL/Discrete_conformal_maps/Flattening_visitor.h>

#include <cstddef>
#include <string>

// What commands that map surfaces have in common.

// Tells and times the stages.
struct Stage_visitor
{
  Command_run& run;

  void start(CGAL::Discrete_conformal_maps::Flattening_stage stage);
  void after_iteration(std::size_t, double, double) { run.progress().long_step(); }
};

// Throws Program_error if the format has no texture coordinates.
Mesh_format format_with_texture(const std::string& path, const std::string& format_name);

// Throws std::runtime_error, with the errors that are left, if a map is no success.
void check_status(const CGAL::Discrete_conformal_maps::Discrete_conformal_map& map);

// Adds the range of the logarithmic scale factors, which vertices without faces have not, the
// numbers of flips and the size of the output.
void describe_sizes(Statistics& statistics,
                    const CGAL::Discrete_conformal_maps::Discrete_conformal_map& map,
                    const Mesh& input, const Output_mesh& result);

// The commands, after the input has been read; `format` is that of the output.
void flatten(Command_run& run, const Flatten_options& options, Mesh_format format);
void hyperbolic(Command_run& run, const Hyperbolic_options& options, Mesh_format format);
void sphere(Command_run& run, const Sphere_options& options, Mesh_format format);

#endif // INTRINSIC_MAP_COMMANDS_H
