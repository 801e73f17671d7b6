// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "map_commands.h"

#include "Program_error.h"

#include <algorithm>
#include <sstream>
#include <stdexcept>
#include <vector>

namespace CM = CGAL::Discrete_conformal_maps;

namespace {

const char* name_of(CM::Flattening_stage stage)
{
  switch(stage) {
    case CM::Flattening_stage::cones: return "cones";
    case CM::Flattening_stage::optimize: return "optimize";
    case CM::Flattening_stage::trace: return "trace";
    case CM::Flattening_stage::subdivide: return "subdivide";
    case CM::Flattening_stage::layout: return "layout";
  }
  return "";
}

} // namespace

Stages map_stages(bool has_cones)
{
  using Stage = CM::Flattening_stage;
  Stages result;
  for(const Stage stage :
      {Stage::cones, Stage::optimize, Stage::trace, Stage::subdivide, Stage::layout})
    if(has_cones || stage != Stage::cones)
      result.emplace_back(name_of(stage));
  return result;
}

void Stage_visitor::start(CM::Flattening_stage stage) { run.start_stage(name_of(stage)); }

Mesh_format format_with_texture(const std::string& path, const std::string& format_name)
{
  const Mesh_format format = output_format(path, format_name);
  if(!has_texture(format))
    throw Program_error(path +
                        ": this format cannot carry texture coordinates (.obj, .ply and .vtp can)");
  return format;
}

void check_status(const CM::Discrete_conformal_map& map)
{
  if(map.status() == CM::Map_status::success)
    return;
  const char* reason = map.status() == CM::Map_status::not_converged
                         ? CM::to_string(map.minimization().status)
                         : CM::to_string(map.status());
  std::ostringstream text;
  text << CM::message(map.status()) << ": " << reason << ", with an error of curvatures of "
       << map.max_curvature_error() << " radians";
  throw std::runtime_error(text.str());
}

void describe_sizes(Statistics& statistics, const CM::Discrete_conformal_map& map,
                    const Mesh& input, const Output_mesh& result)
{
  std::vector<double> u;
  for(const Mesh::Vertex_index v : input.vertices())
    if(!input.is_isolated(v))
      u.push_back(map.log_scale(CM::Vertex_index(v.idx())));
  double sum = 0, square_sum = 0;
  for(const double x : u)
    sum += x;
  for(const double x : u)
    square_sum += (x - sum / double(u.size())) * (x - sum / double(u.size()));
  statistics["log_scale_min"] = *std::min_element(u.begin(), u.end());
  statistics["log_scale_max"] = *std::max_element(u.begin(), u.end());
  statistics["log_scale_square_sum"] = square_sum;
  statistics["flips"] = map.number_of_flips(CM::Layer::B);
  statistics["ptolemy_flips"] = map.number_of_flips(CM::Layer::C);
  describe_subdivision(statistics, result.points.size(), result.edges.size(),
                       result.polygons.size());
}
