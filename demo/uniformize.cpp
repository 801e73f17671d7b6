// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands.h"

#include "Program_error.h"
#include "map_commands.h"
#include "triangulation_stages.h"

#include <CGAL/Discrete_conformal_maps/uniformize.h>

#include <functional>

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

} // namespace

int uniformize(const Common_options& common, const Hyperbolic_options& options)
{
  const Mesh_format format = format_with_texture(options);
  Command_run run("uniformize", common, {options.output, options.picture});
  const DCM::Surface_type type = DCM::surface_type(run.input().mesh);
  run.statistics()["surface_type"] = DCM::to_string(type);
  if(!options.picture.empty() && type != DCM::Surface_type::hyperbolic)
    throw Program_error("--svg is for hyperbolic surfaces; --picture shows this one");
  const bool is_flat = type == DCM::Surface_type::torus || type == DCM::Surface_type::annulus;
  run.plan({{"build"}, map_stages(is_flat)});
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
