// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "map_commands.h"

#include "Program_error.h"

#include <sstream>
#include <stdexcept>

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

void Stage_visitor::start(CM::Flattening_stage stage) { run.start_stage(name_of(stage)); }

Mesh_format format_with_texture(const std::string& path, const std::string& format_name)
{
  const Mesh_format format = output_format(path, format_name);
  if(!has_texture(format))
    throw Program_error(path +
                        ": this format cannot carry texture coordinates (.obj, .ply and .vtp can)");
  return format;
}

void check_convergence(const CM::Discrete_conformal_map& map)
{
  const CM::Minimization_status status = map.minimization().status;
  if(status == CM::Minimization_status::converged)
    return;
  std::ostringstream text;
  text << "the minimization has not converged: " << CM::to_string(status)
       << ", with an error of curvatures of " << map.max_curvature_error() << " radians";
  throw std::runtime_error(text.str());
}
