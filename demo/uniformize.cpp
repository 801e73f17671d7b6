// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands.h"

#include "Program_error.h"
#include "map_commands.h"
#include "triangulation_stages.h"

#include <CGAL/Discrete_conformal_maps/uniformize.h>

#include <functional>
#include <string>

namespace DCM = CGAL::Discrete_conformal_maps;

namespace {

DCM::Uniformization uniformized(Command_run& run)
{
  const double epsilon = run.timed("build", [&] { return mollification(run); });
  Stage_visitor visitor{run};
  return DCM::uniformize(run.input().mesh,
                         DCM::parameters::concurrency_tag(CGAL::Parallel_if_available_tag())
                           .mollification(epsilon)
                           .visitor(std::ref(visitor)));
}

bool is_flat(DCM::Surface_type type)
{
  return type == DCM::Surface_type::torus || type == DCM::Surface_type::annulus;
}

// Throws Program_error if an option is not for a surface of this type.
void check_options(const Hyperbolic_options& options, DCM::Surface_type type)
{
  const auto refuse = [&](const std::string& option, const char* kind) {
    throw Program_error(option + " is for " + kind + "; this surface is of type " +
                        DCM::to_string(type) + ": leave it out");
  };
  if(type == DCM::Surface_type::hyperbolic)
    return;
  if(!options.picture.empty())
    refuse("--svg", "hyperbolic surfaces");
  if(options.depth)
    refuse("--tiles", "hyperbolic surfaces");
  if(options.is_homogeneous && !is_flat(type))
    refuse("--homogeneous", "flat and hyperbolic surfaces");
}

} // namespace

int uniformize(const Common_options& common, const Hyperbolic_options& options)
{
  check_tiling(common, options);
  const Mesh_format format = format_with_texture(options);
  Command_run run("uniformize", common, {options.output, options.picture});
  const DCM::Surface_type type = DCM::surface_type(run.input().mesh);
  run.statistics()["surface_type"] = DCM::to_string(type);
  check_options(options, type);
  run.plan({{"build"}, map_stages(is_flat(type))});
  const DCM::Uniformization result = uniformized(run);
  if(result.hyperbolic)
    return finish(run, options, format, *result.hyperbolic, {});
  if(result.spherical) {
    Sphere_options sphere;
    sphere.output = options.output;
    return finish(run, sphere, format, *result.spherical);
  }
  if(result.modulus)
    run.statistics()["modulus"] = {result.modulus->real(), result.modulus->imag()};
  return finish(run, options, format, *result.flat, result.flat->minimization().iterations, {});
}
