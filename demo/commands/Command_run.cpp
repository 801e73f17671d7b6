// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands/Command_run.h"

#include "Program_error.h"
#include "pictures/Canvas.h"
#include "reading/Scanner.h"
#include "reading/component_meshes.h"
#include "reading/surface_points.h"

#include <algorithm>
#include <iostream>
#include <stdexcept>
#include <utility>

namespace {

std::vector<std::string> all_outputs(std::vector<std::string> outputs,
                                     const Common_options& options)
{
  outputs.push_back(options.save);
  outputs.push_back(options.statistics);
  outputs.push_back(options.view);
  outputs.push_back(options.picture);
  return outputs;
}

} // namespace

Command_run::Command_run(const std::string& command, const Common_options& options,
                         std::vector<std::string> outputs, bool are_soups_allowed)
  : m_command(command),
    m_options(options),
    m_output(options.read_files, all_outputs(std::move(outputs), options)),
    m_progress(options.is_quiet)
{
  m_options.are_soups_allowed = are_soups_allowed;
  View_page::check_available("--view", options.view);
  check_picture_available("--picture", options.picture);
  read(options.is_quiet);
  if(!options.section.first.empty())
    choose_section();
  restart(options.mollification);
}

// Reads without a progress bar, because repairs and notes are printed meanwhile.
void Command_run::read(bool is_quiet)
{
  m_stage = "read";
  m_watch = Stopwatch();
  m_input = read_input(m_options, is_quiet);
  end_stage();
  describe_input();
  if(m_options.component || m_options.is_largest_chosen)
    keep_chosen_component();
  m_statistics_of_input = m_statistics;
}

void Command_run::describe_input()
{
  m_statistics = common_statistics(m_command, m_options.input, m_input.diagnosis);
  for(const auto& [what, count] : m_input.repairs)
    m_statistics["repairs"][what] = count;
  if(!m_input.parents.empty())
    m_statistics["polygons"] = m_input.parents.back() + 1;
  if(m_input.cracks.coincident > 0)
    m_statistics["coincident_points"] = m_input.cracks.coincident;
  if(m_input.cracks.close > 0)
    m_statistics["close_points"] = m_input.cracks.close;
  if(m_input.covered)
    describe_cover();
}

void Command_run::restart(double epsilon)
{
  end_stage();
  m_options.mollification = epsilon;
  m_output.clear();
  m_progress.clear();
  m_seconds = {{"read", m_seconds["read"]}};
  if(m_input.mesh.number_of_faces() == 0) // they have been freed
    read(true);
  m_statistics = m_statistics_of_input;
  m_page.reset();
  if(m_options.is_shown())
    m_page.emplace();
}

void Command_run::start_stage(const std::string& name)
{
  end_stage();
  m_progress.start_stage(name);
  m_stage = name;
  m_watch = Stopwatch();
}

void Command_run::end_stage()
{
  if(m_stage.empty())
    return;
  Statistics& seconds = m_seconds[m_stage];
  seconds = (seconds.is_null() ? 0 : seconds.get<double>()) + m_watch.seconds();
  m_stage.clear();
}

// Keeps all vertices, with their indices.
void Command_run::keep_chosen_component()
{
  const auto components = component_faces(m_input.mesh);
  const std::size_t chosen = m_component =
    m_options.component ? *m_options.component : index_of_largest(components, m_input.mesh);
  if(chosen >= components.size())
    throw Program_error("--component " + std::to_string(chosen) +
                        ": the components of the mesh are 0 to " +
                        std::to_string(components.size() - 1));
  m_statistics["component"] = {{"index", chosen},
                               {"of", components.size()},
                               {"first_face", std::int64_t(components[chosen].front().idx())},
                               {"faces", components[chosen].size()}};
  Component_mesh kept = with_all_vertices(m_input.mesh, components[chosen]);
  m_input.mesh = std::move(kept.mesh);
  m_input.kept_faces = std::move(kept.faces);
  m_input.kept_edges = std::move(kept.edges);
}

void Command_run::choose_section()
{
  const auto& [text, radius_text] = m_options.section;
  const double radius = finite_number(radius_text).value_or(0);
  if(radius <= 0)
    throw Program_error("--section: the radius must be a finite number above zero");
  if(m_input.covered && text.find(',') == std::string::npos)
    throw Program_error("--section: on triangles that are not a surface, the point must have the "
                        "form x,y,z");
  m_section = {position(surface_point(text, m_input), m_input.mesh), radius};
}

void Command_run::describe_cover()
{
  namespace IT = CGAL::Intrinsic_triangulations;
  m_statistics["tufted"] = true;
  if(m_input.covered->is_cloud)
    m_statistics["neighbors"] = m_options.number_of_neighbors;
  m_statistics["non_manifold_edges"] = m_input.diagnosis.count(IT::Defect_kind::NON_MANIFOLD_EDGE);
  m_statistics["non_manifold_vertices"] =
    m_input.diagnosis.count(IT::Defect_kind::NON_MANIFOLD_VERTEX);
  m_statistics["inconsistently_oriented_edges"] =
    m_input.diagnosis.count(IT::Defect_kind::INCONSISTENT_ORIENTATION);
  m_statistics["cover"] = {{"vertices", m_input.mesh.number_of_vertices()},
                           {"edges", m_input.mesh.number_of_edges()},
                           {"faces", m_input.mesh.number_of_faces()}};
}

void Command_run::refuse_isolated_vertices() const
{
  for(const Mesh::Vertex_index v : m_input.mesh.vertices())
    if(m_input.mesh.is_isolated(v))
      throw Program_error(m_options.input + ": vertex " + std::to_string(v.idx()) +
                          " has no face; --repair removes such vertices");
}

void Command_run::keep_points_only()
{
  if(m_page)
    return;
  Mesh points;
  points.resize(m_input.mesh.number_of_vertices(), 0, 0);
  std::copy(m_input.mesh.points().begin(), m_input.mesh.points().end(), points.points().begin());
  m_input.mesh = std::move(points);
}

Output_mesh Command_run::input_as_read() const
{
  Output_mesh result =
    m_input.covered ? output_mesh(m_input.covered->soup) : output_mesh(m_input.mesh);
  if(m_input.covered && m_input.covered->is_cloud)
    result.polygons = Polygons();
  else if(!m_input.parents.empty())
    result.polygon_data.push_back({"input_polygon", m_input.parents});
  return result;
}

Output_mesh Command_run::with_input_faces(Output_mesh mesh) const
{
  if(!m_input.kept_edges.empty())
    for(Attribute& a : mesh.edge_data)
      if(a.name == "input_edge")
        for(double& e : a.kept())
          e = e < 0 ? e : m_input.kept_edges[static_cast<std::size_t>(e)];
  const auto is_input_face = [](const Attribute& a) { return a.name == "input_face"; };
  auto& data = mesh.polygon_data;
  const auto found = std::find_if(data.begin(), data.end(), is_input_face);
  if(found == data.end())
    return mesh;
  std::vector<std::int64_t> is_back, polygons;
  for(double& value : found->kept()) {
    auto f = static_cast<std::int64_t>(value);
    if(!m_input.kept_faces.empty() && f >= 0)
      f = number_of(m_input.kept_faces[static_cast<std::size_t>(f)]);
    if(m_input.covered) {
      is_back.push_back(f % 2);
      f /= 2;
    }
    if(!m_input.parents.empty())
      polygons.push_back(f < 0 ? f : m_input.parents[static_cast<std::size_t>(f)]);
    value = static_cast<double>(f);
  }
  if(m_input.covered)
    data.push_back({"is_back", is_back});
  if(!m_input.parents.empty())
    data.push_back({"input_polygon", polygons});
  return mesh;
}

void Command_run::plan(const std::vector<Stages>& parts)
{
  Stages all;
  for(const Stages& part : parts)
    all.insert(all.end(), part.begin(), part.end());
  all.push_back("write");
  m_progress.set_stages(std::move(all));
}

// Writes the page without data that differ between runs.
void Command_run::write_page()
{
  show([&](View_page& page) {
    page.set_statistics(m_statistics);
    m_output.add(m_options.view, [&](Text& text) { page.write_html(text); });
    m_output.add(m_options.picture,
                 [&](Text& text) { page.write_picture(text, m_options.picture, m_section); });
  });
}

namespace {

// Returns a message if a result is not certified although --exact requires it.
std::string certificate_summary(const Statistics& s)
{
  if(!s.contains("certified") || s["certified"] == true)
    return "";
  std::string result = ", not certified";
  if(const auto edges = s.value("non_delaunay_edges", std::size_t(0)); edges > 0)
    result += "; edges that are not Delaunay: " + std::to_string(edges);
  const auto undecided =
    s.value("undecided", std::size_t(0)) + s.value("undecided_crossings", std::size_t(0));
  if(undecided > 0)
    result += "; undecided because of too many square roots: " + std::to_string(undecided);
  return result;
}

} // namespace

void Command_run::finish(const std::string& summary)
{
  for(const std::string& stage : m_progress.stages())
    if(!m_seconds.contains(stage))
      throw std::logic_error("the stage '" + stage + "' has not come");
  write_page();
  m_statistics["seconds"] = m_seconds;
  m_statistics["peak_memory_bytes"] = peak_memory_in_bytes();
  add_output(m_options.statistics, text_of(m_statistics));
  m_progress.clear();
  m_output.commit();
  if(!m_options.is_quiet)
    std::cerr << m_options.input << ": " << summary << certificate_summary(m_statistics) << '\n';
}
