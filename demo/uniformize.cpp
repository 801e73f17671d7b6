// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands.h"

#include "Program_error.h"
#include "map_commands.h"

#include <CGAL/Discrete_conformal_maps/surface_type.h>

namespace CM = CGAL::Discrete_conformal_maps;

namespace {

// What makes a surface flat that can be, or round.
Flatten_options flatten_options(const Hyperbolic_options& options, CM::Surface_type type)
{
  Flatten_options result;
  result.output = options.output;
  result.format = options.format;
  result.is_homogeneous = options.is_homogeneous;
  result.cones = "none";
  result.boundary = {type == CM::Surface_type::disk ? "disk" : "straight"};
  result.is_modulus_wanted = type != CM::Surface_type::disk;
  return result;
}

} // namespace

int uniformize(const Common_options& common, const Hyperbolic_options& options)
{
  const Mesh_format format = format_with_texture(options.output, options.format);
  Command_run run("uniformize", common, {options.output, options.picture}, 7);
  const CM::Surface_type type = CM::surface_type(run.input().mesh);
  run.statistics()["surface_type"] = CM::to_string(type);
  if(type == CM::Surface_type::hyperbolic) {
    hyperbolic(run, options, format);
    return 0;
  }
  if(type == CM::Surface_type::sphere)
    throw Program_error(common.input + ": a sphere has neither a flat nor a hyperbolic metric");
  if(!options.picture.empty())
    throw Program_error("--svg is for hyperbolic surfaces");
  flatten(run, flatten_options(options, type), format);
  return 0;
}
