// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands/Command_line.h"

#include "Program_error.h"
#include "commands/attempts.h"
#include "commands/component_maps.h"
#include "commands/flattening_conditions.h"
#include "commands/map_commands.h"
#include "commands/triangulation_stages.h"

#include <CGAL/Discrete_conformal_maps/uniformize.h>

#include <algorithm>
#include <complex>
#include <cstddef>
#include <string>
#include <variant>
#include <vector>

namespace DCM = CGAL::Discrete_conformal_maps;

namespace {

constexpr const char* uniformize_help =
  R"(Each component, by its topology, becomes
  a sphere      round, as with `intrinsic sphere`
  a disk        a hemisphere, as with `intrinsic sphere`; its texture is the image in the unit disk
  a torus       flat, as with `intrinsic flatten --cones none`
  an annulus    with two boundaries and no handles: a flat cylinder with straight boundaries
  hyperbolic    with more handles or boundaries, as with `intrinsic hyperbolic`
--svg and --tiles are for hyperbolic surfaces, --homogeneous for hyperbolic and flat surfaces.

The statistics have the keys of these commands, and "modulus" as real and imaginary part. For a
torus, it is the quotient tau of the generators of its lattice, in the fundamental domain of the
modular group. For an annulus, its imaginary part is the height over the circumference.

Several components are mapped one by one and written into one mesh, in which the vertices of the
input keep their indices. Textures stand beside each other. Unit spheres stand in a row, to the
right of the mesh if it has other components. "component_maps" in the statistics has the keys of
each component, its number, sizes and first face, and the center of a sphere beside others. If a
component has no map, nothing is written, or, with --keep-going, only the others. --component K and
--largest select one component; --view, --picture and --svg show only one.

Example:
  intrinsic uniformize torus.obj -o flat.obj --stats torus.json)";

DCM::Uniformization uniformized(Command_run& run, const Mesh& mesh, double epsilon,
                                const std::vector<double>& radii)
{
  Stage_visitor visitor{run};
  return DCM::uniformize(mesh, map_parameters(mesh, epsilon, radii, visitor));
}

bool is_flat(DCM::Surface_type type)
{
  return type == DCM::Surface_type::torus || type == DCM::Surface_type::annulus;
}

bool is_spherical(DCM::Surface_type type)
{
  return type == DCM::Surface_type::sphere || type == DCM::Surface_type::disk;
}

Statistics description(const std::complex<double>& modulus)
{
  return {modulus.real(), modulus.imag()};
}

// Maps a component, and returns its summary.
std::string add(Component_maps& maps, const Component_mesh& component, Statistics& statistics,
                const DCM::Uniformization& result, const Map_output& output)
{
  const std::string type = DCM::to_string(result.type);
  statistics["surface_type"] = type;
  if(result.modulus)
    statistics["modulus"] = description(*result.modulus);
  const std::string summary = std::visit(
    [&](const auto& map) { return maps.add(component, statistics, map, output); }, result.map);
  return result.spherical() ? summary : type + ": " + summary;
}

double right_end(const Mesh& mesh)
{
  double result = 0;
  for(const Mesh::Vertex_index v : mesh.vertices())
    result = (std::max)(result, mesh.point(v).x());
  return result;
}

// Maps the components. Spheres are placed beside the mesh, if other components exist.
int map_components(Command_run& run, const Hyperbolic_options& options, Mesh_format format)
{
  if(!options.picture.empty())
    throw Program_error("--svg is for one hyperbolic surface: add --component or --largest");
  Component_maps maps(run);
  bool has_flat_ones = false, has_other_ones = false;
  for(std::size_t c = 0; c < maps.size(); ++c) {
    const DCM::Surface_type type = DCM::surface_type(maps.component(c).mesh);
    has_flat_ones |= is_flat(type);
    has_other_ones |= !is_spherical(type);
  }
  if(options.is_homogeneous && !has_other_ones)
    throw Program_error("--homogeneous is for flat and hyperbolic surfaces, and all components are "
                        "spheres or disks: leave it out");
  if(has_other_ones)
    maps.set_first_center(right_end(run.input().mesh) + 1.5);
  run.plan({{"build"}, map_stages(has_flat_ones)});
  const auto [epsilon, radii] = built(run, options.radii);
  maps.for_each([&, epsilon = epsilon, &radii = radii](const Component_mesh& component,
                                                       Statistics& statistics) {
    return add(maps, component, statistics,
               uniformized(run, component.mesh, epsilon, part_of(radii, component)),
               map_output(options, format));
  });
  return maps.finish(map_output(options, format));
}

// Throws Program_error if an option does not fit a surface of this type.
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

int map_surface(Command_run& run, const Hyperbolic_options& options, Mesh_format format)
{
  const DCM::Surface_type type = DCM::surface_type(run.input().mesh);
  run.statistics()["surface_type"] = DCM::to_string(type);
  check_options(options, type);
  run.plan({{"build"}, map_stages(is_flat(type))});
  const auto [epsilon, radii] = built(run, options.radii);
  const DCM::Uniformization result = uniformized(run, run.input().mesh, epsilon, radii);
  Map_output output = map_output(options, format);
  Statistics& component = output.component.emplace(description_of_component(run));
  component["surface_type"] = DCM::to_string(type);
  if(result.modulus)
    component["modulus"] = run.statistics()["modulus"] = description(*result.modulus);
  return std::visit([&](const auto& map) { return finish(run, output, map); }, result.map);
}

int uniformize(const Common_options& common, const Hyperbolic_options& options)
{
  check_tiling(common, options);
  const Mesh_format format = output_format(options.output, options, Carried::TEXTURE);
  Command_run run("uniformize", common, {options.output, options.picture});
  return attempt(run, [&] {
    return component_faces(run.input().mesh).size() > 1 ? map_components(run, options, format)
                                                        : map_surface(run, options, format);
  });
}

} // namespace

void define_uniformize(Command_line& line)
{
  const auto [command, options] = line.add_with_mesh(
    "uniformize", "Compute the conformal metric of constant curvature that suits the topology",
    uniformize, uniformize_help);
  add_texture_output(command, options);
  add_radii(command, line.common(), options.radii);
  add_tiling(command, options);
  add_keep_going(command, line.common());
  add_components(command, line.common());
  add_common_options(command, line.common());
}
