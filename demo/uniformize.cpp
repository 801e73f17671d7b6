// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands.h"

#include "Program_error.h"
#include "map_commands.h"
#include "triangulation_stages.h"

#include <CGAL/Discrete_conformal_maps/uniformize.h>

#include <functional>

namespace CM = CGAL::Discrete_conformal_maps;

namespace {

CM::Uniformization uniformized(Command_run& run)
{
  const Edge_length_map length = run.timed("build", [&] { return edge_lengths(run); });
  Stage_visitor visitor{run};
  return CM::uniformize(run.input().mesh,
                        CM::parameters::edge_length_map(length).visitor(std::ref(visitor)));
}

} // namespace

int uniformize(const Common_options& common, const Hyperbolic_options& options)
{
  const Mesh_format format = format_with_texture(options.output, options.format);
  Command_run run("uniformize", common, {options.output, options.picture});
  const CM::Surface_type type = CM::surface_type(run.input().mesh);
  run.statistics()["surface_type"] = CM::to_string(type);
  if(!options.picture.empty() && type != CM::Surface_type::hyperbolic)
    throw Program_error("--svg is for hyperbolic surfaces");
  const bool is_flat = type == CM::Surface_type::torus || type == CM::Surface_type::annulus;
  run.plan({{"build"}, map_stages(is_flat)});
  const CM::Uniformization result = uniformized(run);
  if(result.hyperbolic)
    finish(run, options, format, *result.hyperbolic, {});
  else if(result.spherical)
    finish(run, Sphere_options{options.output, options.format, ""}, format, *result.spherical);
  else {
    run.statistics()["modulus"] = {result.modulus.real(), result.modulus.imag()};
    finish(run, options, format, *result.flat, result.flat->minimization().iterations, {});
  }
  return 0;
}
