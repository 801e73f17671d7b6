// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands/Command_line.h"

#include "commands/Command_run.h"
#include "commands/attempts.h"
#include "commands/component_maps.h"
#include "commands/flattening_conditions.h"
#include "commands/map_commands.h"
#include "commands/triangulation_stages.h"
#include "writing/Mesh_writer.h"
#include "writing/flat_triangles.h"

#include <CGAL/Discrete_conformal_maps/cross_ratios.h>
#include <CGAL/Discrete_conformal_maps/map_to_sphere.h>

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <cstddef>
#include <limits>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace DCM = CGAL::Discrete_conformal_maps;

namespace {

struct Sphere_options : Output_options
{
  Sphere_options() : Output_options("ply") {}

  std::string precise; // positions in all digits; empty if not wanted
  std::string radii;   // a property of vertices or a file; empty for no circles
};

constexpr const char* sphere_help =
  R"(Each component must be a sphere or a disk. The image of a sphere is a convex polyhedron
with vertices on the unit sphere, discretely conformal to the mesh. Its center of mass, weighted by
areas of the mesh, is the center of the sphere. The image of a disk is one half of such a
polyhedron, with the boundary on the equator. Convexity is decided exactly. A disk without vertices
inside becomes a convex polygon in the equator, in the plane z = 0: "flat" in the statistics.

The output is the common subdivision of the mesh, its intrinsic Delaunay triangulation and the
polyhedron, projected to the sphere. Vertices have these properties in .ply and .vtp:
  input_vertex                          input vertex, or -1
  log_scale                             logarithmic scale factor
  input_x, input_y, input_z             position on the mesh
  homogeneous_x, ..._y, ..._z, ..._w    homogeneous coordinates on the polyhedron, linear on faces
Faces, and edges in .ply, have the input, intrinsic and sphere face or edge that contains them. A
disk has its image in the unit disk as texture coordinates.

Long limbs have small images. Rounding of the output can flip triangles, or make edges concave:
lost_in_output in the statistics counts such triangles. --precise writes the positions of the input
vertices with 31 digits, so that close vertices remain distinct. These positions of the computed map
are on the unit sphere up to 1e-31. They differ from positions of the exact map by rounding errors:
lengths of edges, and often scale factors, have the digits of `double` only.

Vertices without faces have the position (0, 0, 1), or (1, 0, 0) beside a disk, with homogeneous
coordinates zero. If the image is not convex, it is written only with --keep-going.

Several components are mapped one by one. Their spheres stand beside each other along the x axis,
with the "center" in "component_maps" of the statistics. Positions of --precise are relative to it.
Vertices without faces do not move. --component K and --largest select one component.

With --radii, circles around the vertices are mapped to circles on the sphere. Their angles are
"radius" in .ply and .vtp. The center of mass of their centers is the center of the sphere.

Example:
  intrinsic sphere cow.off -o sphere.ply --stats sphere.json --precise sphere.txt)";

// Returns a line "x y z", with all digits of the map, for a vertex of the input.
std::string precise_position(const Spherical_map& map, Mesh::Vertex_index v)
{
  // More digits are computed than are written, so that all written digits are correct.
  typedef boost::multiprecision::cpp_bin_float_50 Number;
  std::ostringstream text;
  text.precision(std::numeric_limits<Spherical_map::Double_double>::digits10);
  const auto p = map.position_in<Number>(DCM::Vertex_index(v.idx()));
  text << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
  return text.str();
}

Spherical_map mapped(Command_run& run, const Mesh& mesh, double epsilon,
                     const std::vector<double>& radii)
{
  Stage_visitor visitor{run};
  return DCM::map_to_sphere(mesh, map_parameters(mesh, epsilon, radii, visitor));
}

void describe(Statistics& statistics, const Spherical_map& map)
{
  statistics["disk"] = map.is_disk();
  statistics["flat"] = map.is_flat();
  statistics["iterations"] = map.minimization().iterations;
  describe_status(statistics, map);
  statistics["extended_precision"] = map.is_extended();
  statistics["max_cross_ratio_error"] = DCM::max_cross_ratio_error(map);
  statistics["convex"] = map.certificate().is_convex();
  statistics["concave_edges"] = map.certificate().concave_edges;
  statistics["flipped_triangles"] = map.certificate().flipped_triangles;
  statistics["lost_in_output"] = map.lost_in_output();
  statistics["max_inscribed_error"] = map.max_inscribed_error();
  statistics["bound_violations"] = map.bound_violations();
}

} // namespace

std::string summary_of(const Spherical_map&, const Statistics& s)
{
  std::ostringstream text;
  text << (s["disk"] ? s["flat"] ? "inscribed polygon" : "hemisphere" : "sphere")
       << (s["disk"] || !s["flat"] ? "" : " that is a flat polygon, seen from both sides")
       << (s["convex"] ? ", convex" : "") << ", log scale factors "
       << s["log_scale_min"].get<double>() << " to " << s["log_scale_max"].get<double>() << ", "
       << s["flips"] << " + " << s["ptolemy_flips"] << " flips, " << s["lost_in_output"]
       << " triangles lost by rounding, ";
  if(s["flipped_in_output"] > 0)
    text << s["flipped_in_output"] << " triangles flipped" << first_flipped_face(s) << ", ";
  text << s["subdivision"]["faces"] << " faces in the common subdivision";
  return text.str();
}

Output_mesh described_mesh(Statistics& statistics, const Spherical_map& map, const Map_part& part,
                           const Map_output&)
{
  describe(statistics, map);
  Output_mesh result = sphere_mesh(map, part);
  if(map.has_radii())
    add_radii(result, part, [&map](auto v) { return map.circle_radius(v); });
  describe_triangles_on_sphere(statistics, result, map.is_flat());
  describe_sizes(statistics, map, part, result);
  return result;
}

// Shows the surface of the input, with the sphere as its image.
void show(View_page& page, Command_run& run, const Spherical_map& map, const Map_part& part,
          const Output_mesh& on_sphere, const Map_output&)
{
  Output_mesh mesh = on_sphere;
  std::vector<std::array<double, 3>> positions;
  for(const Point& p : on_sphere.points)
    positions.push_back({p.x(), p.y(), p.z()});
  mesh.points = part.input_points();
  std::vector<double> scales;
  for(const Mesh::Vertex_index v : run.input().mesh.vertices())
    scales.push_back(map.log_scale(DCM::Vertex_index(v.idx())));
  for(Attribute& a : mesh.point_data)
    if(a.name == "log_scale")
      a = {a.name, part.interpolated(scales)};
  show(page, run, part, mesh, Image_kind::sphere);
  page.set_image(Image_kind::sphere, std::move(positions));
}

void add_files(Command_run& run, const Spherical_map& map, const Map_output& output)
{
  if(output.precise.empty())
    return;
  std::string lines;
  for(const Mesh::Vertex_index v : run.input().mesh.vertices())
    lines += std::to_string(v.idx()) + ' ' + precise_position(map, v);
  run.add_output(output.precise, lines);
}

namespace {

// Maps the components. Positions are relative to the center of each sphere.
int map_components(Command_run& run, const Map_output& output, double epsilon,
                   const std::vector<double>& radii)
{
  Component_maps maps(run);
  std::map<std::size_t, std::string> positions; // of each vertex of the input
  maps.for_each([&](const Component_mesh& component, Statistics& statistics) {
    const Spherical_map map = mapped(run, component.mesh, epsilon, part_of(radii, component));
    const std::string summary = maps.add(component, statistics, map, output);
    if(!output.precise.empty())
      for(const Mesh::Vertex_index v : component.mesh.vertices())
        positions[component.vertices[v]] = precise_position(map, v);
    return summary;
  });
  if(!output.precise.empty()) {
    std::string text;
    for(const auto& [v, position] : positions)
      text += std::to_string(v) + ' ' + position;
    run.add_output(output.precise, text);
  }
  return maps.finish(output);
}

int sphere(const Common_options& common, const Sphere_options& options)
{
  const Mesh_format format = output_format(options.output, options);
  Command_run run("sphere", common, {options.output, options.precise});
  run.plan({{"build"}, map_stages(false)});
  Map_output output{options.output, format};
  output.precise = options.precise;
  return attempt(run, [&] {
    const auto [epsilon, radii] = built(run, options.radii);
    if(component_faces(run.input().mesh).size() > 1)
      return map_components(run, output, epsilon, radii);
    output.component = description_of_component(run);
    return finish(run, output, mapped(run, run.input().mesh, epsilon, radii));
  });
}

} // namespace

void define_sphere(Command_line& line)
{
  const auto [command, options] = line.add_with_mesh(
    "sphere", "Map a sphere or a disk to the unit sphere, conformally", sphere, sphere_help);
  add_output(command, options, "Common subdivision on the sphere (.off, .obj, .ply, .vtp",
             "off, obj, ply or vtp");
  command.add_option(
    "--precise", options.precise,
    "Text file for the positions of the input vertices with 31 digits: index x y z");
  add_radii(command, line.common(), options.radii);
  add_keep_going(command, line.common());
  add_components(command, line.common());
  add_common_options(command, line.common());
}
