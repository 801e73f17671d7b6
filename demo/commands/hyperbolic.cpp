// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands/Command_line.h"

#include "Program_error.h"
#include "commands/Command_run.h"
#include "commands/attempts.h"
#include "commands/flattening_conditions.h"
#include "commands/map_commands.h"
#include "commands/triangulation_stages.h"
#include "pictures/disk_picture.h"
#include "reading/vertex_values.h"
#include "writing/Mesh_writer.h"
#include "writing/flat_triangles.h"

#include <CGAL/Discrete_conformal_maps/uniformize_hyperbolic.h>

#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <cstdint>
#include <sstream>
#include <vector>

namespace DCM = CGAL::Discrete_conformal_maps;

namespace {

constexpr const char* hyperbolic_help =
  R"(Every component must have genus two or more, or sufficiently many boundaries or cones; use
`intrinsic uniformize` for others. --component K and --largest select one component. Boundaries
become geodesics. The double of a surface with boundary is laid out; the output is the part of the
mesh.

The output has the format of `intrinsic flatten`, with positions in the Poincare disk. With
--homogeneous they are x t, y t, t in Klein's disk, in which the map is exact. With --radii, circles
are mapped to circles, and "radius" in .ply and .vtp is hyperbolic.

Keys of the statistics:
  area              2 pi (2 genus - 2 + boundaries) without cones
  groups            for each component its genus, boundaries and area, and these keys of its domain,
                    or of the domain of its double:
    generators      motions z -> (a z + b) / (conj(b) z + conj(a)) that glue the sides, as real and
                    imaginary parts of a and b
    relation        order in which their product is the identity, counted from 1, negative for
                    inverses, and its error as written
    precise_...     the same with all known digits, if the layout needed more than 16
  max_gluing_error  greatest error at the corners of the domain
  radius            greatest distance from the center. In double precision, positions at a
                    distance d have errors of about 1e-16 exp(d)

Example:
  intrinsic hyperbolic pretzel.obj -o disk.obj --svg tiling.svg --tiles 4 --stats pretzel.json)";

Cones cones_of(const Conditions& conditions, const Mesh& mesh)
{
  Cones result;
  for(const Mesh::Vertex_index v : mesh.vertices())
    if(conditions[v].value != 0)
      result.push_back(v);
  return result;
}

Hyperbolic_map uniformized(Command_run& run, double epsilon, const Conditions& conditions,
                           const std::vector<double>& radii)
{
  const Mesh& mesh = run.input().mesh;
  Stage_visitor visitor{run};
  const auto condition =
    boost::make_iterator_property_map(conditions.begin(), get(boost::vertex_index, mesh));
  return DCM::uniformize_hyperbolic(
    mesh, map_parameters(mesh, epsilon, radii, visitor).vertex_condition_map(condition));
}

// Returns entries with more digits than numbers of JSON have.
Statistics decimal_entries(const DCM::Disk_motion<DCM::Fuchsian_group::Precise_number>& motion,
                           int digits)
{
  Statistics result = Statistics::array();
  for(const auto& x : motion.entries())
    result.push_back(x.str(digits));
  return result;
}

void describe_precise_generators(Statistics& statistics, const DCM::Fuchsian_group& group)
{
  if(group.precise_generators.empty())
    return;
  statistics["precise_relation_error"] = group.precise_relation_error;
  statistics["precise_generators"] = Statistics::array();
  for(const auto& motion : group.precise_generators)
    statistics["precise_generators"].push_back(decimal_entries(motion, group.known_digits));
}

// Describes generators as real and imaginary parts of a and b, and the relation as numbers of
// generators. These start at 1, and are negative for inverse generators.
void describe_group(Statistics& statistics, const DCM::Fuchsian_group& group)
{
  if(!group.relation.empty())
    statistics["relation_error"] = group.relation_error;
  statistics["generators"] = Statistics::array();
  for(const DCM::Disk_motion<>& motion : group.generators)
    statistics["generators"].push_back(motion.entries());
  statistics["relation"] = Statistics::array();
  for(const auto& letter : group.relation) {
    const auto number = static_cast<std::int64_t>(letter.generator) + 1;
    statistics["relation"].push_back(letter.is_inverse ? -number : number);
  }
  describe_precise_generators(statistics, group);
}

// Describes the component itself, and the group. With boundary, this is the group of the double.
Statistics description(const Hyperbolic_map& map, std::size_t component)
{
  const auto& type = map.topology(component);
  Statistics result{
    {"genus", type.genus}, {"boundary_loops", type.boundary_loops}, {"area", map.area(component)}};
  if(type.boundary_loops > 0)
    result["genus_of_double"] = map.group(component).genus;
  describe_group(result, map.group(component));
  return result;
}

} // namespace

std::string summary_of(const Hyperbolic_map&, const Statistics& s)
{
  std::ostringstream text;
  text << "area " << s["area"].get<double>() << ", log scale factors "
       << s["log_scale_min"].get<double>() << " to " << s["log_scale_max"].get<double>() << ", "
       << s["flips"] << " + " << s["ptolemy_flips"] << " flips, curvature error "
       << s["max_curvature_error"].get<double>() << ", gluing error "
       << s["max_gluing_error"].get<double>();
  const Statistics& groups = s["groups"];
  for(std::size_t c = 0; groups.size() > 1 && c < groups.size(); ++c)
    text << "\n  component " << c << ": genus " << groups[c]["genus"] << ", area "
         << groups[c]["area"].get<double>();
  return text.str();
}

// Returns the mesh. Edges are straight in the Klein disk.
Output_mesh described_mesh(Statistics& statistics, const Hyperbolic_map& map, const Map_part& part,
                           const Map_output& output)
{
  describe_minimization(statistics, map, output);
  statistics["max_gluing_error"] = map.max_gluing_error();
  statistics["area"] = map.area();
  statistics["radius"] = map.radius();
  const Output_mesh straight = flat_mesh(map, part, output.cones, true);
  describe_triangles(statistics, straight);
  describe_sizes(statistics, map, part, straight);
  statistics["groups"] = Statistics::array();
  for(std::size_t c = 0; c < map.number_of_components(); ++c)
    statistics["groups"].push_back(description(map, c));
  Output_mesh result = flat_mesh(map, part, output.cones, output.is_homogeneous);
  if(map.has_radii())
    add_radii(result, part, [&map](auto v) { return map.circle_radius(v); });
  return result;
}

namespace {

// Returns the positions. Each component is in its own disk.
std::vector<std::array<double, 3>> positions_in_disks(const Hyperbolic_map& map,
                                                      const Output_mesh& mesh)
{
  std::vector<std::array<double, 3>> result = mesh.texture.coordinates;
  const Attribute& faces = *find_attribute(mesh.polygon_data, "flat_face");
  for(std::size_t i = 0; i < mesh.texture.polygons.size(); ++i) {
    const DCM::Face_index f(static_cast<Mesh::size_type>(faces.integer(i)));
    for(const Polygons::Index c : mesh.texture.polygons[i])
      result[c] = {mesh.texture.coordinates[c][0] + disk_distance * double(map.component(f)),
                   mesh.texture.coordinates[c][1], 0};
  }
  return result;
}

} // namespace

// Shows the map. Texture coordinates are coordinates of the Klein disk, where the map is
// projective. The picture is in the Poincare disk.
void show(View_page& page, Command_run& run, const Hyperbolic_map& map, const Map_part& part,
          const Output_mesh&, const Map_output& output)
{
  const Output_mesh straight = flat_mesh(map, part, output.cones, true);
  show(page, run, part, straight, Image_kind::disk);
  page.set_image(Image_kind::disk,
                 positions_in_disks(map, flat_mesh(map, part, output.cones, false)));
  page.set_outlines(disk_outlines(map, output.depth));
  page.add_marks({"flipped triangles", true, flipped_polygons(straight), {}, {}});
}

void add_files(Command_run& run, const Hyperbolic_map& map, const Map_output& output)
{
  if(!output.picture.empty())
    run.add_output(output.picture, disk_picture(map, output.depth));
}

Map_output map_output(const Hyperbolic_options& options, Mesh_format format, const Cones& cones)
{
  Map_output result{options.output, format, options.is_homogeneous, cones};
  result.picture = options.picture;
  result.depth = options.depth.value_or(result.depth);
  return result;
}

void check_tiling(const Common_options& common, const Hyperbolic_options& options)
{
  if(options.depth && options.picture.empty() && common.view.empty())
    throw Program_error("--tiles is for --svg and --view; leave it out, or add one of them");
}

void add_tiling(CLI::App& command, Hyperbolic_options& options)
{
  command.add_option("--svg", options.picture, "Picture of the domain and its images in the disk");
  command
    .add_option(
      "--tiles", options.depth,
      "Maximum number of sides between the domain and an image in the picture; 3 by default")
    ->transform(integer_from_to(0, 100));
}

namespace {

int hyperbolic(const Common_options& common, const Hyperbolic_options& options)
{
  check_tiling(common, options);
  const Mesh_format format = output_format(options.output, options, Carried::TEXTURE);
  Command_run run("hyperbolic", common, {options.output, options.picture});
  run.plan({{"build"}, map_stages(false)});
  return attempt(run, [&] {
    const Mesh& mesh = run.input().mesh;
    double epsilon = 0;
    std::vector<double> radii;
    const Conditions conditions = run.timed("build", [&] {
      epsilon = mollification(run);
      radii = vertex_numbers("--radii", options.radii, run.input());
      return options.cones.empty() ? Conditions(mesh.number_of_vertices())
                                   : prescribed_curvatures(options.cones, mesh);
    });
    const Cones cones = cones_of(conditions, mesh);
    if(options.depth && !cones.empty())
      throw Program_error("--tiles: a surface with cones has no tiling; leave it out");
    return finish(run, map_output(options, format, cones),
                  uniformized(run, epsilon, conditions, radii));
  });
}

} // namespace

void define_hyperbolic(Command_line& line)
{
  const auto [command, options] = line.add_with_mesh(
    "hyperbolic", "Compute the conformal metric of curvature -1, in the Poincare disk", hyperbolic,
    hyperbolic_help);
  add_texture_output(command, options);
  add_read_file(command, line.common(), "--cones", options.cones,
                "File of angle defects; zero everywhere if not given");
  add_radii(command, line.common(), options.radii);
  add_tiling(command, options);
  add_keep_going(command, line.common());
  add_components(command, line.common());
  add_common_options(command, line.common());
}
