// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands/commands.h"

#include "commands/Command_run.h"
#include "commands/component_maps.h"
#include "commands/map_commands.h"
#include "commands/triangulation_stages.h"
#include "writing/Mesh_writer.h"
#include "writing/sphere_mesh.h"

#include <CGAL/Discrete_conformal_maps/cross_ratios.h>
#include <CGAL/Discrete_conformal_maps/map_to_sphere.h>

#include <cstddef>
#include <functional>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace DCM = CGAL::Discrete_conformal_maps;

namespace {

DCM::Spherical_conformal_map mapped(Command_run& run, const Mesh& mesh, double epsilon)
{
  Stage_visitor visitor{run};
  return DCM::map_to_sphere(mesh,
                            DCM::parameters::concurrency_tag(CGAL::Parallel_if_available_tag())
                              .mollification(epsilon)
                              .visitor(std::ref(visitor)));
}

void describe(Statistics& statistics, const DCM::Spherical_conformal_map& map)
{
  statistics["disk"] = map.is_disk();
  if(map.is_flat())
    statistics["flat"] = true;
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

std::string summary_of(const DCM::Spherical_conformal_map&, const Statistics& s)
{
  std::ostringstream text;
  text << (s["disk"] ? s.contains("flat") ? "inscribed polygon" : "hemisphere" : "sphere")
       << (s["disk"] || !s.contains("flat") ? "" : " that is a flat polygon, seen from both sides")
       << (s["convex"] ? ", convex" : "") << ", log scale factors "
       << s["log_scale_min"].get<double>() << " to " << s["log_scale_max"].get<double>() << ", "
       << s["flips"] << " + " << s["ptolemy_flips"] << " flips, " << s["lost_in_output"]
       << " triangles lost by rounding, " << s["subdivision"]["faces"]
       << " faces in the common subdivision";
  return text.str();
}

Output_mesh described_mesh(Statistics& statistics, const DCM::Spherical_conformal_map& map,
                           const Map_front& front)
{
  describe(statistics, map);
  Output_mesh result = sphere_mesh(map, front);
  describe_sizes(statistics, map, front.input(), result);
  return result;
}

namespace {

// The surface is that of the input, with the sphere as its picture.
void show_on_sphere(View_page& page, Command_run& run, const DCM::Spherical_conformal_map& map,
                    const Map_front& front, const Output_mesh& on_sphere)
{
  Output_mesh mesh = on_sphere;
  std::vector<std::array<double, 3>> positions;
  for(const Point& p : on_sphere.points)
    positions.push_back({p.x(), p.y(), p.z()});
  mesh.points = front.input_points();
  std::vector<double> scales;
  for(const Mesh::Vertex_index v : run.input().mesh.vertices())
    scales.push_back(map.log_scale(DCM::Vertex_index(v.idx())));
  for(Attribute& a : mesh.point_data)
    if(a.name == "log_scale")
      a.values = front.interpolated(scales);
  show(page, run, map, front, mesh, Image_kind::sphere);
  page.set_image(Image_kind::sphere, std::move(positions));
}

} // namespace

int finish(Command_run& run, const Sphere_options& options, Mesh_format format,
           const DCM::Spherical_conformal_map& map)
{
  check_status(run, map, map.is_laid_out());
  run.timed("write", [&] {
    const Map_front front(map, run.input().mesh);
    Output_mesh result = described_mesh(run.statistics(), map, front);
    run.show([&](View_page& page) { show_on_sphere(page, run, map, front, result); });
    add_input_data(run.input(), front, result);
    run.add_output(options.output, result, format);
    if(!options.precise.empty())
      run.add_output(options.precise, precise_positions(map, run.input().mesh));
  });
  run.finish(summary_of(map, run.statistics()));
  return exit_code(map);
}

namespace {

// Positions are those on each sphere, with its center in the origin.
int map_components(Command_run& run, const Sphere_options& options, Mesh_format format,
                   double epsilon)
{
  Component_maps maps(run);
  std::map<std::size_t, std::string> positions; // of each vertex of the input
  maps.for_each([&](const Component_mesh& component, Statistics& statistics) {
    const DCM::Spherical_conformal_map map = mapped(run, component.mesh, epsilon);
    const std::string summary = maps.add(component, statistics, map);
    if(!options.precise.empty())
      for(const Mesh::Vertex_index v : component.mesh.vertices())
        positions[component.vertices[v]] = precise_position(map, v);
    return summary;
  });
  if(!options.precise.empty()) {
    std::string text;
    for(const auto& [v, position] : positions)
      text += std::to_string(v) + ' ' + position;
    run.add_output(options.precise, text);
  }
  return maps.finish(options.output, format);
}

} // namespace

int sphere(const Common_options& common, const Sphere_options& options)
{
  const Mesh_format format = output_format(options.output, options);
  Command_run run("sphere", common, {options.output, options.precise});
  run.plan({{"build"}, map_stages(false)});
  const double epsilon = run.timed("build", [&] { return mollification(run); });
  if(component_faces(run.input().mesh).size() > 1)
    return map_components(run, options, format, epsilon);
  return finish(run, options, format, mapped(run, run.input().mesh, epsilon));
}
