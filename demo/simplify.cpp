// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands.h"

#include "Command_run.h"
#include "Mesh_writer.h"
#include "Program_error.h"
#include "matrix_market.h"
#include "triangulation_stages.h"

#include <CGAL/Intrinsic_simplification/Evolving_surface.h>
#include <CGAL/Intrinsic_simplification/Surface_level.h>
#include <CGAL/Intrinsic_simplification/Surface_map.h>
#include <CGAL/Intrinsic_simplification/Transport_cost.h>
#include <CGAL/Intrinsic_simplification/prolongation.h>
#include <CGAL/Intrinsic_simplification/simplify.h>
#include <CGAL/Intrinsic_triangulations/diagnose.h>
#include <CGAL/Intrinsic_triangulations/triangle_formulas.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <sstream>
#include <utility>

namespace IS = CGAL::Intrinsic_simplification;
namespace IT = CGAL::Intrinsic_triangulations;

namespace {

Mesh_format format_with_faces(const std::string& path, const std::string& format_name)
{
  const Mesh_format format = output_format(path, format_name);
  if(!has_attributes(format))
    throw Program_error(path + ": this format cannot carry coarse faces (.ply and .vtp can)");
  return format;
}

struct Weights
{
  double curvature = 1;
  double area = IS::default_area_weight;
};

// The number after the equals sign.
double weight_value(const std::string& text, const std::string& value)
{
  char* end = nullptr;
  const double result = std::strtod(value.c_str(), &end);
  if(value.empty() || *end != '\0' || !std::isfinite(result) || result < 0)
    throw Program_error("--weight " + text + ": a weight is a number that is not negative");
  return result;
}

Weights parsed_weights(const std::vector<std::string>& texts)
{
  Weights result;
  for(const std::string& text : texts) {
    const std::size_t length = text.find('=');
    const std::string name = text.substr(0, length);
    if(length == std::string::npos || (name != "curvature" && name != "area"))
      throw Program_error("--weight " + text + ": neither curvature=W nor area=W");
    (name == "area" ? result.area : result.curvature) = weight_value(text, text.substr(length + 1));
  }
  if(result.curvature == 0 && result.area == 0)
    throw Program_error("--weight: not all weights can be zero");
  return result;
}

const char* name_of(IS::Removal_status status)
{
  switch(status) {
    case IS::Removal_status::possible: return "possible";
    case IS::Removal_status::isolated: return "isolated";
    case IS::Removal_status::protected_vertex: return "protected";
    case IS::Removal_status::border_loop: return "border_loop";
    case IS::Removal_status::self_face: return "self_face";
    case IS::Removal_status::low_degree: return "low_degree";
    case IS::Removal_status::not_flattenable: return "not_flattenable";
    case IS::Removal_status::not_separable: return "not_separable";
  }
  return "";
}

double area(const IS::Surface_level& level)
{
  const auto length = level.length_map();
  double sum = 0;
  for(const IT::Face_index f : level.mesh().faces()) {
    const IT::Halfedge_index h = level.mesh().halfedge(f);
    sum += IT::quadrupled_area(length[level.mesh().edge(h)],
                               length[level.mesh().edge(level.mesh().next(h))],
                               length[level.mesh().edge(level.mesh().prev(h))]);
  }
  return sum / 4;
}

// Shows the removals while they are made.
struct Removal_counter : IS::Default_simplification_visitor
{
  explicit Removal_counter(Progress_bar& bar) : progress(bar) {}

  void after_removal(IS::Vertex_index) { progress.step(); }

  Progress_bar& progress;
};

class Simplify_command
{
public:
  Simplify_command(const Common_options& common, const Simplify_options& options)
    : m_options(options),
      m_weights(parsed_weights(options.weights)),
      m_format(format_with_faces(options.output, options.format)),
      m_run("simplify", common, {options.output, options.prolongation}, 4)
  {}

  void run()
  {
    IS::Evolving_surface surface = m_run.timed("build", [&] { return built(); });
    const IS::Surface_level fine(surface);
    const IS::Simplification_result result =
      m_run.timed("simplify", [&] { return simplified(surface); });
    const IS::Surface_level coarse(surface);
    describe_removals(result, surface);
    describe_level(fine, coarse);
    write(IS::Surface_map(surface, fine, coarse));
    m_run.finish(summary());
  }

private:
  IS::Evolving_surface built()
  {
    return IS::Evolving_surface(m_run.input().mesh,
                                IT::parameters::edge_length_map(edge_lengths(m_run)));
  }

  // How many vertices are to be left, those without faces included; zero if something else is the target.
  std::size_t target()
  {
    if(m_options.maximum_cost)
      return 0;
    const Mesh& mesh = m_run.input().mesh;
    const auto isolated = static_cast<std::size_t>(
      std::count_if(mesh.vertices().begin(), mesh.vertices().end(),
                    [&](Mesh::Vertex_index v) { return mesh.is_isolated(v); }));
    const double others = double(mesh.number_of_vertices() - isolated);
    return isolated + (m_options.ratio
                         ? static_cast<std::size_t>(std::ceil(*m_options.ratio * others))
                         : *m_options.number_of_vertices);
  }

  IS::Simplification_result simplified(IS::Evolving_surface& surface)
  {
    IS::Transport_cost cost(surface);
    if(m_weights.curvature > 0)
      cost.add_curvature(surface, m_weights.curvature);
    if(m_weights.area > 0)
      cost.add_area(surface, m_weights.area);
    Removal_counter counter(m_run.progress());
    const auto np =
      IS::parameters::number_of_vertices(target(), CGAL::parameters::visitor(std::ref(counter)));
    if(m_options.maximum_cost)
      return IS::simplify(surface, cost, IS::parameters::maximum_cost(*m_options.maximum_cost, np));
    return IS::simplify(surface, cost, np);
  }

  void describe_removals(const IS::Simplification_result& result,
                         const IS::Evolving_surface& surface)
  {
    Statistics& statistics = m_run.statistics();
    const bool is_reached =
      m_options.maximum_cost || surface.mesh().number_of_vertices() <= target();
    statistics["coarse_vertices"] = surface.mesh().number_of_vertices();
    statistics["coarse_faces"] = surface.mesh().number_of_faces();
    statistics["removed"] = result.removed;
    statistics["status"] = is_reached ? "reached" : "nothing_removable";
    statistics["greatest_cost"] = result.greatest_cost;
    for(std::size_t s = 1; s < result.skipped.size(); ++s)
      statistics["skipped"][name_of(static_cast<IS::Removal_status>(s))] = result.skipped[s];
    statistics["operations"] = surface.history().size();
  }

  void describe_level(const IS::Surface_level& fine, const IS::Surface_level& coarse)
  {
    const auto lengths = IT::parameters::edge_length_map(coarse.length_map());
    m_run.statistics()["area_ratio"] = area(coarse) / area(fine);
    m_run.statistics()["min_angle_degrees"] =
      IT::diagnose(coarse.mesh(), lengths).statistics().min_angle;
  }

  void write(const IS::Surface_map& map)
  {
    const auto [mesh, prolongation] = m_run.timed(
      "map", [&] { return std::pair(coarse_faces_on_input(map), prolongation_text(map)); });
    m_run.timed("write", [&, &mesh = mesh, &prolongation = prolongation] {
      m_run.add_output(m_options.output, text_of(mesh, m_format));
      m_run.add_output(m_options.prolongation, prolongation);
    });
  }

  Output_mesh coarse_faces_on_input(const IS::Surface_map& map)
  {
    const Mesh& mesh = m_run.input().mesh;
    Output_mesh result = output_mesh(mesh);
    result.point_data = {attribute("coarse_vertex", mesh.vertices(), [&](Mesh::Vertex_index v) {
      return number_of(map.coarse().level_vertex(IS::Vertex_index(v.idx())));
    })};
    result.polygon_data = {attribute("coarse_face", mesh.faces(), [&](Mesh::Face_index f) {
      constexpr std::array<double, 3> centroid{1. / 3, 1. / 3, 1. / 3};
      return number_of(map.to_coarse({IS::Face_index(f.idx()), centroid}).first);
    })};
    return result;
  }

  // Empty if it is not wanted.
  std::string prolongation_text(const IS::Surface_map& map) const
  {
    if(m_options.prolongation.empty())
      return "";
    return matrix_market(IS::prolongation_matrix(map), Matrix_symmetry::GENERAL);
  }

  std::string summary()
  {
    const Statistics& s = m_run.statistics();
    std::ostringstream text;
    text << s["vertices"] << " -> " << s["coarse_vertices"] << " vertices ("
         << s["status"].get<std::string>() << "), area times " << s["area_ratio"].get<double>()
         << ", smallest angle " << m_run.input().diagnosis.statistics().min_angle << " -> "
         << s["min_angle_degrees"].get<double>() << " degrees";
    return text.str();
  }

  const Simplify_options& m_options;
  Weights m_weights;
  Mesh_format m_format;
  Command_run m_run;
};

} // namespace

int simplify(const Common_options& common, const Simplify_options& options)
{
  Simplify_command(common, options).run();
  return 0;
}
