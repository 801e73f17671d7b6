// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands.h"

#include "Command_run.h"
#include "Mesh_writer.h"
#include "Program_error.h"
#include "triangulation_stages.h"

#include <CGAL/Intrinsic_triangulations/Shortest_paths.h>
#include <CGAL/Intrinsic_triangulations/Tufted_surface.h>
#include <CGAL/Intrinsic_triangulations/heat_distance.h>
#include <CGAL/Intrinsic_triangulations/interpolation.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>

namespace IT = CGAL::Intrinsic_triangulations;

namespace {

constexpr double unreachable = -1;

Mesh_format format_with_attributes(const std::string& path, const Output_options& options)
{
  const Mesh_format format = output_format(path, options);
  if(!has_attributes(format))
    throw Program_error(path + ": this format cannot carry distances (.ply and .vtp can)");
  return format;
}

std::vector<IT::Vertex_index> checked_sources(const std::vector<std::int64_t>& numbers,
                                              const std::string& path, const Input_mesh& input)
{
  const auto last = static_cast<std::int64_t>(input.number_of_vertices()) - 1;
  std::vector<IT::Vertex_index> result;
  for(const std::int64_t n : numbers) {
    if(n < 0 || n > last)
      throw Program_error(path + ": there is no vertex " + std::to_string(n) +
                          " to be a source; the vertices are 0 to " + std::to_string(last));
    result.emplace_back(static_cast<IT::Vertex_index::size_type>(n));
  }
  return result;
}

// Values below zero are errors of the method.
double presentable(double distance)
{
  return std::isfinite(distance) ? (std::max)(distance, 0.) : unreachable;
}

std::vector<double> lengths_of_shortest_paths(const Triangulation& triangulation,
                                              const std::vector<IT::Vertex_index>& sources)
{
  const auto surface = triangulation.intrinsic();
  IT::Shortest_paths paths(surface);
  for(IT::Vertex_index v : sources)
    paths.add_source(v);
  paths.run();
  std::vector<double> result;
  for(IT::Vertex_index v : surface.mesh().vertices())
    result.push_back(presentable(paths.distance(v)));
  return result;
}

// At the vertices of the input, then at inserted ones.
std::vector<double> distances(const Triangulation& triangulation,
                              const std::optional<Covered_soup>& covered,
                              const std::vector<IT::Vertex_index>& sources,
                              const Distance_options& options)
{
  if(options.is_shortest)
    return lengths_of_shortest_paths(triangulation, sources);
  const auto np = IT::parameters::time_step_factor(options.time_step_factor);
  const auto surface = triangulation.intrinsic();
  const auto values =
    covered ? IT::heat_distance(IT::Tufted_surface<>(covered->cover, surface, covered->share()),
                                sources, np)
            : IT::heat_distance(surface, sources, np);
  std::vector<double> result(values.begin(), values.end());
  std::transform(result.begin(), result.end(), result.begin(), presentable);
  return result;
}

// At the vertices of the triangulation.
std::vector<double> on_triangulation(const std::vector<double>& values,
                                     const Triangulation& triangulation,
                                     const std::optional<Covered_soup>& covered)
{
  if(!covered)
    return values;
  std::vector<double> result;
  for(const IT::Vertex_index v : triangulation.mesh().vertices())
    result.push_back(values[covered->cover.input_vertex(v)]);
  return result;
}

// A vertex is reachable or not like the ends of its edge: both have a distance, or neither.
std::vector<double> interpolated(const std::vector<double>& values, const Subdivision& subdivision,
                                 const Triangulation& triangulation)
{
  std::vector<double> result(subdivision.mesh().number_of_vertices());
  IT::interpolate(IT::Side::intrinsic, subdivision,
                  boost::make_iterator_property_map(values.begin(),
                                                    get(boost::vertex_index, triangulation.mesh())),
                  boost::make_iterator_property_map(result.begin(),
                                                    get(boost::vertex_index, subdivision.mesh())));
  return result;
}

void describe_distances(Statistics& statistics, const Distance_options& options,
                        const std::vector<double>& values)
{
  statistics["sources"] = options.sources;
  statistics["max_distance"] = *std::max_element(values.begin(), values.end());
  statistics["unreachable_vertices"] = std::count(values.begin(), values.end(), unreachable);
}

Output_mesh with_distances(Output_mesh mesh, std::vector<double> distances)
{
  mesh.point_data.push_back({"distance", std::move(distances)});
  return mesh;
}

std::string summary_of(Command_run& run)
{
  const Statistics& s = run.statistics();
  std::ostringstream text;
  text << summary_of_changes(run) << ", greatest distance " << s["max_distance"].get<double>();
  if(s["unreachable_vertices"] > 0)
    text << ", " << s["unreachable_vertices"] << " vertices out of reach (distance -1)";
  return text.str();
}

class Distance_command
{
public:
  Distance_command(const Common_options& common, const Distance_options& options)
    : m_options(options),
      m_format(format_with_attributes(options.output, options)),
      m_subdivision_format(subdivision_format(options)),
      m_run("distance", common, {options.output, options.subdivision}, !options.is_shortest)
  {
    m_run.plan({delaunay_stages,
                refinement_stages(options.minimum_angle),
                certificate_stages(common),
                {"solve"},
                is_subdivision_wanted() ? subdivision_stages : Stages{}});
  }

  void run()
  {
    const auto sources = checked_sources(m_options.sources, m_run.options().input, m_run.input());
    Triangulation triangulation = make_delaunay_triangulation(m_run);
    refine_if_wanted(m_run, triangulation, m_options.minimum_angle);
    describe(m_run, triangulation);
    const std::vector<double> values = m_run.timed(
      "solve", [&] { return distances(triangulation, m_run.input().covered, sources, m_options); });
    describe_distances(m_run.statistics(), m_options, at_input_vertices(values));
    const auto subdivision = subdivide_if_wanted(triangulation);
    m_run.timed("write", [&] { write(values, subdivision, triangulation); });
    m_run.finish(summary_of(m_run));
  }

private:
  // These come before the inserted ones.
  std::vector<double> at_input_vertices(const std::vector<double>& values)
  {
    return {values.begin(),
            values.begin() + static_cast<std::ptrdiff_t>(m_run.input().number_of_vertices())};
  }

  static std::optional<Mesh_format> subdivision_format(const Distance_options& options)
  {
    if(options.subdivision.empty())
      return std::nullopt;
    return format_with_attributes(options.subdivision, options);
  }

  bool is_subdivision_wanted()
  {
    return m_subdivision_format || !view_stages(m_run.options()).empty();
  }

  std::optional<Subdivision> subdivide_if_wanted(const Triangulation& triangulation)
  {
    if(!is_subdivision_wanted())
      return std::nullopt;
    return subdivide(m_run, triangulation);
  }

  void write(const std::vector<double>& values, const std::optional<Subdivision>& subdivision,
             const Triangulation& triangulation)
  {
    m_run.add_output(m_options.output,
                     with_distances(m_run.input_as_read(), at_input_vertices(values)), m_format);
    if(subdivision)
      write_subdivision(
        with_distances(subdivision_mesh(*subdivision),
                       interpolated(on_triangulation(values, triangulation, m_run.input().covered),
                                    *subdivision, triangulation)),
        *subdivision, triangulation);
    save(m_run, triangulation);
  }

  void write_subdivision(const Output_mesh& mesh, const Subdivision& subdivision,
                         const Triangulation& triangulation)
  {
    if(m_subdivision_format)
      m_run.add_output(m_options.subdivision, mesh, *m_subdivision_format);
    m_run.show([&](View_page& page) {
      show(page, m_run, triangulation, subdivision, mesh);
      page.add_marks({"sources", false, {}, {}, sources_on(triangulation)});
    });
  }

  // One for each umbrella of the cover.
  std::vector<std::int64_t> sources_on(const Triangulation& triangulation)
  {
    const std::optional<Covered_soup>& covered = m_run.input().covered;
    if(!covered)
      return m_options.sources;
    std::vector<std::int64_t> result;
    for(const IT::Vertex_index v : triangulation.mesh().vertices())
      if(const auto n = static_cast<std::int64_t>(covered->cover.input_vertex(v));
         std::count(m_options.sources.begin(), m_options.sources.end(), n) > 0)
        result.push_back(number_of(v));
    return result;
  }

  const Distance_options& m_options;
  Mesh_format m_format;
  std::optional<Mesh_format> m_subdivision_format; // none if it is not wanted
  Command_run m_run;
};

} // namespace

int distance(const Common_options& common, const Distance_options& options)
{
  Distance_command(common, options).run();
  return 0;
}
