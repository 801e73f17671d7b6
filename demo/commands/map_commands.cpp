// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands/map_commands.h"

#include "Program_error.h"
#include "commands/triangulation_stages.h"
#include "page/show_angles.h"
#include "reading/missed_promises.h"
#include "reading/vertex_values.h"
#include "writing/map_distortion.h"

#include <CGAL/Intrinsic_triangulations/exceptions.h>

#include <algorithm>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

namespace DCM = CGAL::Discrete_conformal_maps;

namespace {

const char* name_of(DCM::Flattening_stage stage)
{
  constexpr const char* names[] = {"cones", "optimize", "layout", "trace", "subdivide"};
  return names[static_cast<std::size_t>(stage)];
}

// Returns advice for a user of this program.
std::string advice(const std::string& command, DCM::Map_status status, bool is_exact)
{
  using Status = DCM::Map_status;
  if(is_exact && status == Status::wrong_curvature)
    return "leave out --exact, which certifies rounded lengths";
  if(status == Status::triangle_inequality || status == Status::no_minimum)
    return "try --solver newton, which flips edges";
  if(status == Status::not_circular)
    return "try `intrinsic sphere` if the surface is a disk, or else --boundary free";
  if(command == "flatten")
    return status == Status::not_converged || status == Status::wrong_curvature
             ? "try --cones greedy, or another --boundary"
             : "try --cones greedy with a --max-log-scale below 5, so that scale factors differ "
               "less, or --boundary free";
  return "try `intrinsic flatten`, which places cones";
}

// Describes the failure of a map, and possible remedies.
std::string failure(Command_run& run, const Conformal_map& map, bool lacks_layout)
{
  const bool is_by_search = map.status() == DCM::Map_status::not_converged &&
                            map.minimization().status != DCM::Minimization_status::converged;
  const char* reason =
    is_by_search ? DCM::to_string(map.minimization().status) : DCM::to_string(map.status());
  std::ostringstream text;
  text << DCM::message(map.status()) << " (" << reason << ')' << missed_promises(map.promises());
  if(!map.cause().empty())
    text << "; " << map.cause();
  if(lacks_layout)
    text << "; --keep-going has nothing to write";
  text << "; " << advice(run.statistics()["command"], map.status(), run.options().is_exact);
  return text.str();
}

} // namespace

Stages map_stages(bool has_cones)
{
  using Stage = DCM::Flattening_stage;
  Stages result;
  for(const Stage stage :
      {Stage::cones, Stage::optimize, Stage::layout, Stage::trace, Stage::subdivide})
    if(has_cones || stage != Stage::cones)
      result.emplace_back(name_of(stage));
  return result;
}

std::pair<double, std::vector<double>> built(Command_run& run, const std::string& radii)
{
  return run.timed("build", [&] {
    return std::make_pair(mollification(run), vertex_numbers("--radii", radii, run.input()));
  });
}

void Stage_visitor::start(DCM::Flattening_stage stage) { run.start_stage(name_of(stage)); }

void check_status(Command_run& run, const Conformal_map& map, bool is_laid_out)
{
  if(map.status() == DCM::Map_status::success)
    return;
  const bool is_kept = run.options().is_failure_kept;
  const std::string text = failure(run, map, is_kept && !is_laid_out);
  if(!is_kept || !is_laid_out)
    throw Map_failure(text);
  run.progress().clear();
  std::cerr << run.options().input << ": warning: " << text << '\n';
}

int exit_code(const Conformal_map& map) { return map.status() == DCM::Map_status::success ? 0 : 3; }

void describe_minimization(Statistics& statistics, const Conformal_map& map,
                           const Map_output& output)
{
  statistics["cones"] = output.cones.size();
  statistics["iterations"] = output.iterations.value_or(map.minimization().iterations);
  describe_status(statistics, map);
}

void describe_status(Statistics& statistics, const Conformal_map& map)
{
  statistics["status"] = DCM::to_string(map.status());
  Statistics& promises = statistics["promises"];
  for(const DCM::Map_promise& p : map.promises())
    promises[p.name] = {{"error", p.error}, {"bound", p.bound}, {"kept", p.is_kept()}};
  statistics["max_curvature_error"] = map.max_curvature_error();
}

void describe_crowding(Command_run& run, Statistics& statistics, const Conformal_map& map,
                       const Component_mesh* component)
{
  Statistics& crowded = statistics["crowded_faces"] = Statistics::array();
  for(const DCM::Face_index f : map.crowded_faces())
    crowded.push_back(run.input().triangle(component ? component->faces[f.idx()] : f));
  if(crowded.empty() || run.options().is_quiet)
    return;
  run.progress().clear();
  std::cerr << run.options().input
            << ": note: faces too small for coordinates in double: " << crowded.size()
            << ", first at face " << crowded.front() << '\n';
}

void describe_sizes(Statistics& statistics, const Conformal_map& map, const Map_part& part,
                    const Output_mesh& result)
{
  const Mesh& input = part.mapped_mesh();
  std::vector<double> u;
  for(const Mesh::Vertex_index v : input.vertices())
    if(!input.is_isolated(v))
      u.push_back(map.log_scale(DCM::Vertex_index(v.idx())));
  double sum = 0, square_sum = 0;
  for(const double x : u)
    sum += x;
  for(const double x : u)
    square_sum += (x - sum / double(u.size())) * (x - sum / double(u.size()));
  statistics["log_scale_min"] = *std::min_element(u.begin(), u.end());
  statistics["log_scale_max"] = *std::max_element(u.begin(), u.end());
  statistics["log_scale_square_sum"] = square_sum;
  statistics["flips"] = map.number_of_flips(DCM::Layer::B);
  statistics["ptolemy_flips"] = map.number_of_flips(DCM::Layer::C);
  describe_subdivision(statistics, result.points.size(), result.edges.size(),
                       result.polygons.size());
}

void add_description(Statistics& statistics, const Statistics& map, const Map_output& output)
{
  statistics.update(map);
  if(!output.component)
    return;
  Statistics component = *output.component;
  component.update(map);
  statistics["component_maps"] = Statistics::array();
  statistics["component_maps"].push_back(component);
}

void show(View_page& page, Command_run& run, const Map_part& part, Output_mesh mesh,
          Image_kind kind)
{
  const auto& Delaunay = part.map().Delaunay();
  mesh.point_data.push_back({"curvature", part.interpolated(curvatures(run))});
  add_distortion(mesh, kind);
  add_input_data(run.input(), mesh);
  page.add_surface("surface", mesh);
  show_angles(page, "input", run.input().mesh, edge_lengths(run));
  show_angles(page, "intrinsic", Delaunay.mesh(), Delaunay.length_map());
}
