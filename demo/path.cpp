// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Command_run.h"
#include "Mesh_writer.h"
#include "Program_error.h"
#include "commands.h"
#include "surface_points.h"
#include "triangulation_stages.h"

#include <CGAL/Intrinsic_triangulations/Edge_paths.h>
#include <CGAL/Intrinsic_triangulations/Shortest_paths.h>
#include <CGAL/Intrinsic_triangulations/exponential_map.h>
#include <CGAL/Intrinsic_triangulations/path_on_input.h>
#include <CGAL/Intrinsic_triangulations/shortest_edge_path.h>

#include <boost/iterator/function_output_iterator.hpp>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;

namespace {

constexpr const char* no_path_advice = "; choose points of one connected component";

using Path = IT::Surface_path<double>;
using Place = IT::Surface_place<double>;
using Halfedges = std::vector<IT::Halfedge_index>;

// All are kept, for the statistics too.
constexpr std::size_t greatest_number_of_crossings = 1000000;

bool is_vertex(const Place& p)
{
  return p.along.is_valid() &&
         std::count(p.location.second.begin(), p.location.second.end(), 0.) == 2;
}

// A place of a path in JSON: at a vertex, on an edge with its ends, or in a face.
Statistics description(const Place& p, const IT::Delta_complex& mesh)
{
  Statistics result;
  if(is_vertex(p))
    result["vertex"] = mesh.source(p.along).idx();
  else if(p.along.is_valid())
    result["edge"] = {mesh.source(p.along).idx(), mesh.target(p.along).idx()};
  result["face"] = p.location.first.idx();
  result["barycentric"] = p.location.second;
  return result;
}

class Path_command
{
public:
  Path_command(const Common_options& common, const Path_options& options)
    : m_options(options),
      m_format(output_format(options.output, options)),
      m_run("path", common, {options.output})
  {
    check_options();
    m_run.plan({{"build", "search"}});
  }

  void run()
  {
    const Mesh& mesh = m_run.input().mesh;
    m_points.push_back(surface_point(m_options.from, mesh));
    for(const std::string& text : m_options.via)
      m_points.push_back(surface_point(text, mesh));
    if(!m_options.to.empty())
      m_points.push_back(surface_point(m_options.to, mesh));
    Triangulation triangulation = m_run.timed("build", [&] { return make_triangulation(m_run); });
    const Path path = m_run.timed("search", [&] { return search(triangulation); });
    describe_path(path, triangulation);
    m_run.timed("write", [&] {
      const Output_mesh line = polyline(path);
      m_run.add_output(m_options.output, line, m_format);
      m_run.show([&](View_page& page) { show(page, line); });
      save(m_run, triangulation);
    });
    m_run.finish(summary(path));
  }

private:
  bool uses_flips() const { return m_options.is_flipped || m_options.is_loop; }

  void check_options() const
  {
    if(m_format == Mesh_format::OFF)
      throw Program_error(m_options.output +
                          ": this format has no lines (.obj, .ply and .vtp have)");
    if(m_options.straightest) {
      const auto [degrees, length] = *m_options.straightest;
      if(!std::isfinite(degrees) || !std::isfinite(length) || length < 0)
        throw Program_error("--straightest takes a finite angle and a finite length, not negative");
      if(!m_options.to.empty() || !m_options.via.empty() || uses_flips())
        throw Program_error(
          "--straightest starts at --from, and takes no other points; leave them out");
      return;
    }
    if(m_options.is_loop == !m_options.to.empty())
      throw Program_error(m_options.is_loop
                            ? "a loop goes back to --from and has no --to; leave out one of them"
                            : "--to or --loop is missing; say where the path ends");
    if(!m_options.via.empty() && !uses_flips())
      throw Program_error("--via is for --flips and --loop; add one of them");
  }

  Path search(Triangulation& triangulation)
  {
    if(m_options.straightest)
      return straightest_path(triangulation);
    return uses_flips() ? flipped_path(triangulation) : shortest_path(triangulation);
  }

  Path shortest_path(const Triangulation& triangulation)
  {
    Path path = IT::shortest_path(triangulation.input(), m_points.front(), m_points.back());
    if(path.places.empty())
      throw Program_error("there is no path from " + m_options.from + " to " + m_options.to +
                          no_path_advice);
    if(path.places.size() == 1) // a line has two ends, even if they are one point
      path.places.push_back(path.places.front());
    m_status = "shortest";
    return path;
  }

  // From vertex to vertex along edges, then by flips.
  Path flipped_path(Triangulation& triangulation)
  {
    const Halfedges start = path_along_edges(triangulation);
    IT::Edge_paths paths(triangulation);
    m_options.is_loop ? paths.add_loop(start) : paths.add_path(start);
    m_run.statistics()["length_along_edges"] = paths.length(0);
    m_status = paths.shorten() == IT::Shortening_status::geodesic ? "geodesic" : "blocked";
    m_halfedges = paths.halfedges(0);
    if(m_halfedges.empty())
      throw Program_error(
        "the path contracts to a point; lead it around a handle, a hole or a vertex of "
        "negative curvature with --via");
    return IT::path_on_input(triangulation, m_halfedges);
  }

  Halfedges path_along_edges(const Triangulation& triangulation)
  {
    std::vector<std::string> texts{m_options.from};
    texts.insert(texts.end(), m_options.via.begin(), m_options.via.end());
    texts.push_back(m_options.is_loop ? m_options.from : m_options.to);
    std::vector<IT::Vertex_index> vertices;
    for(std::size_t i = 0; i < texts.size(); ++i)
      vertices.push_back(vertex_at(m_points[i % m_points.size()], texts[i], m_run.input().mesh));
    Halfedges result;
    for(std::size_t i = 0; i + 1 < vertices.size(); ++i) {
      const Halfedges part =
        IT::shortest_edge_path(triangulation.input(), vertices[i], vertices[i + 1]);
      if(part.empty() && vertices[i] != vertices[i + 1])
        throw Program_error("there is no path from " + texts[i] + " to " + texts[i + 1] +
                            no_path_advice);
      result.insert(result.end(), part.begin(), part.end());
    }
    return result;
  }

  Path straightest_path(const Triangulation& triangulation)
  {
    const auto [degrees, length] = *m_options.straightest;
    const auto input = triangulation.input();
    const IT::Delta_complex& mesh = input.mesh();
    std::vector<IT::Edge_point<double>> crossings;
    const auto add = [&](const IT::Edge_point<double>& p) {
      if(crossings.size() == greatest_number_of_crossings)
        throw Program_error("a straightest path of this length crosses more than " +
                            std::to_string(greatest_number_of_crossings) + " edges; shorten it");
      crossings.push_back(p);
    };
    const auto end =
      IT::trace_geodesic(input, m_points.front(),
                         std::polar(length, std::remainder(degrees, 360.) * std::acos(-1.) / 180),
                         IT::At_boundary::stop, boost::make_function_output_iterator(add));
    Path path{end.length, {{IT::Halfedge_index(), m_points.front()}}};
    for(const auto& p : crossings)
      path.places.push_back({p.halfedge, IT::face_location(p, mesh)});
    path.places.push_back({IT::Halfedge_index(), end.end});
    m_status = end.status == IT::Geodesic_status::reached ? "straightest" : "stopped_at_boundary";
    return path;
  }

  // ---- Output ----

  Output_mesh polyline(const Path& path)
  {
    Output_mesh result;
    for(const Place& p : path.places)
      result.points.push_back(position(p.location, m_run.input().mesh));
    const auto n = static_cast<Polygons::Index>(result.points.size());
    for(Polygons::Index i = 0; i < n; ++i) {
      result.lines.add_corner(i);
      if(i > 0)
        result.edges.push_back({i - 1, i});
    }
    result.lines.close();
    return result;
  }

  // The surface, with the points of the line after its own.
  void show(View_page& page, const Output_mesh& line)
  {
    Output_mesh surface = output_mesh(m_run.input().mesh);
    add_data(surface, m_run.input().data);
    const auto first = static_cast<Polygons::Index>(surface.points.size());
    surface.points.insert(surface.points.end(), line.points.begin(), line.points.end());
    Surface_marks marks{"path", false, {}, {}, {}};
    for(Polygons::Index i = 0; i < line.points.size(); ++i)
      marks.lines.add_corner(first + i);
    marks.lines.close();
    page.add_surface("surface", std::move(surface));
    page.add_marks(std::move(marks));
  }

  void describe_path(const Path& path, const Triangulation& triangulation)
  {
    Statistics& s = m_run.statistics();
    s["status"] = m_status;
    s["length"] = path.length;
    s["crossings"] = path.places.size() - 2;
    s["places"] = Statistics::array();
    for(const Place& p : path.places)
      s["places"].push_back(description(p, triangulation.input_mesh()));
    if(!m_halfedges.empty())
      s["intrinsic_edges"] = Statistics::array();
    for(IT::Halfedge_index h : m_halfedges)
      s["intrinsic_edges"].push_back({{"edge", Mesh::Edge_index(h).idx()},
                                      {"source", triangulation.mesh().source(h).idx()},
                                      {"target", triangulation.mesh().target(h).idx()}});
  }

  std::string summary(const Path& path) const
  {
    std::ostringstream text;
    text << m_status << " path of length " << path.length << " over " << path.places.size() - 2
         << " edges and vertices";
    return text.str();
  }

  const Path_options& m_options;
  Mesh_format m_format;
  Command_run m_run;
  std::vector<Surface_location> m_points;
  std::string m_status;
  Halfedges m_halfedges; // of the intrinsic triangulation, after flips
};

} // namespace

int path(const Common_options& common, const Path_options& options)
{
  Path_command(common, options).run();
  return 0;
}
