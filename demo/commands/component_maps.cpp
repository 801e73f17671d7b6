// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands/component_maps.h"

#include "Program_error.h"

#include <CGAL/Intrinsic_triangulations/exceptions.h>

#include <algorithm>
#include <cstdint>

namespace IT = CGAL::Intrinsic_triangulations;

namespace {

constexpr double sphere_distance = 2.5;    // of centers
constexpr int failure_written = 3;         // the exit code of `exit_code()`
constexpr std::size_t greatest_table = 40; // in lines on the terminal

} // namespace

std::vector<double> part_of(const std::vector<double>& values, const Component_mesh& component)
{
  std::vector<double> result;
  for(const Mesh::Vertex_index v : component.vertices)
    result.push_back(values[v]);
  return result;
}

Statistics description_of_component(const Command_run& run)
{
  const Mesh& mesh = run.input().mesh;
  const std::vector<Mesh::Face_index>& kept = run.input().kept_faces;
  const auto vertices =
    std::count_if(mesh.vertices().begin(), mesh.vertices().end(),
                  [&mesh](Mesh::Vertex_index v) { return !mesh.is_isolated(v); });
  return {{"component", run.index_of_component()},
          {"vertices", vertices},
          {"faces", mesh.number_of_faces()},
          {"first_face", kept.empty() ? 0 : std::int64_t(kept.front().idx())}};
}

Component_maps::Component_maps(Command_run& run)
  : m_run(run), m_components(component_faces(run.input().mesh)), m_joined(run.input())
{
  const Common_options& options = run.options();
  if(options.is_shown())
    throw Program_error((options.view.empty() ? "--picture" : "--view") +
                        std::string(" shows one component, and the mesh has ") +
                        std::to_string(size()) + ": add --component or --largest");
}

Component_mesh Component_maps::component(std::size_t c) const
{
  return component_mesh(m_run.input().mesh, m_components[c]);
}

std::string Component_maps::name(std::size_t component) const
{
  return "component " + std::to_string(component) + ", " +
         std::to_string(m_components[component].size()) + " faces, first face " +
         std::to_string(m_components[component].front().idx());
}

void Component_maps::for_each(
  const std::function<std::string(const Component_mesh&, Statistics&)>& map)
{
  const Common_options& options = m_run.options();
  Statistics all = Statistics::array();
  for(std::size_t c = 0; c < size(); ++c) {
    const Component_mesh part = component(c);
    Statistics own{{"component", c},
                   {"vertices", part.vertices.size()},
                   {"faces", part.faces.size()},
                   {"first_face", std::int64_t(part.faces.front().idx())}};
    try {
      m_summaries.push_back(name(c) + ": " + map(part, own));
    } catch(const IT::Invalid_input& e) {
      if(!options.is_failure_kept)
        throw IT::Invalid_input(name(c) + ": " + e.what());
      leave_out(c, e, own);
    } catch(const IT::Numerical_error& e) {
      if(!options.is_failure_kept)
        throw Map_failure(name(c) + ": " + e.what());
      leave_out(c, e, own);
    }
    all.push_back(std::move(own));
  }
  m_run.statistics()["component_maps"] = std::move(all);
}

void Component_maps::leave_out(std::size_t component, const std::exception& e,
                               Statistics& statistics)
{
  statistics["left_out"] = e.what();
  m_summaries.push_back(name(component) + ": left out: " + e.what());
  m_exit_code = failure_written;
  ++m_number_left_out;
}

double Component_maps::next_center(Statistics& statistics)
{
  const double x = m_center;
  m_center += sphere_distance;
  statistics["center"] = {x, 0, 0};
  return x;
}

int Component_maps::finish(const Map_output& output)
{
  if(m_number_left_out == size())
    throw Map_failure("no component has a map; the first is " + m_summaries.front());
  m_run.timed("write", [&] {
    const Output_mesh mesh = m_joined.finish();
    describe_subdivision(m_run.statistics(), mesh.points.size(), mesh.edges.size(),
                         mesh.polygons.size());
    m_run.add_output(output.path, mesh, output.format);
  });
  std::string text = std::to_string(size()) + " components";
  const std::size_t shown = (std::min)(m_summaries.size(), greatest_table);
  for(std::size_t i = 0; i < shown; ++i)
    text += "\n  " + m_summaries[i];
  if(shown < m_summaries.size())
    text += "\n  and " + std::to_string(m_summaries.size() - shown) + " more: see --stats";
  m_run.finish(text);
  return m_exit_code;
}
