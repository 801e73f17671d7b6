// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Program_error.h"
#include "commands/Command_line.h"
#include "commands/Command_run.h"
#include "commands/attempts.h"
#include "commands/triangulation_stages.h"
#include "reading/surface_points.h"
#include "writing/Mesh_writer.h"

#include <CGAL/Intrinsic_triangulations/Edge_paths.h>
#include <CGAL/Intrinsic_triangulations/Shortest_paths.h>
#include <CGAL/Intrinsic_triangulations/exponential_map.h>
#include <CGAL/Intrinsic_triangulations/geodesic_homology_basis.h>
#include <CGAL/Intrinsic_triangulations/make_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/path_on_input.h>
#include <CGAL/Intrinsic_triangulations/shortest_edge_path.h>
#include <CGAL/Intrinsic_triangulations/tangent_vectors.h>

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

struct Path_options : Output_options
{
  Path_options() : Output_options("obj") {}

  // These are points as `surface_point()` reads them.
  std::string from;             // empty for a homology basis
  std::string to;               // empty for a loop or a straightest path, too
  std::vector<std::string> via; // vertices where the path goes along edges before it is shortened
  bool is_loop = false;
  bool is_flipped = false;        // a geodesic near the path along edges, not the shortest
  bool is_homology_basis = false; // geodesic loops around all handles and holes
  std::optional<std::pair<double, double>> straightest; // degrees and length
};

constexpr const char* path_help =
  R"(From --from to --to, the path is shortest, up to rounding. With --flips, the shortest path
along edges through all --via is shortened to a geodesic in its homotopy class; with --loop, a loop.
With --homology, every closed curve is homologous to a combination of the loops. The statistics and
the last line on standard error have the status:
  shortest             no path is shorter
  geodesic             no small change shortens it
  blocked              it crosses itself, and is geodesic elsewhere
  contracted           it contracts to a point: its length is zero, and no line is written
  straightest          it has the requested length
  stopped_at_boundary  it ends at the boundary
The statistics have all points of the path and, after flips, its edges in the intrinsic
triangulation that --save writes.

Examples:
  intrinsic path bunny.obj --from 17 --to 1000:0.2,0.3,0.5 -o path.vtp
  intrinsic path bunny.obj --from 17 --via 99 --via 612 --loop -o loop.obj --stats loop.json
  intrinsic path bunny.obj --from 0.1,0.2,0 --straightest 30 0.25 -o ray.ply
  intrinsic path eight.off --homology -o loops.vtp --view loops.html)";

constexpr const char* no_path_advice = "; choose points of one connected component";

using Path = IT::Surface_path<double>;
using Place = IT::Surface_point<double>;
using Halfedge = IT::Halfedge_index;
using Halfedges = std::vector<Halfedge>;
using Edge_paths = IT::Edge_paths<Triangulation::Traits>;

// All crossings are kept, also for the statistics.
constexpr std::size_t greatest_number_of_crossings = 1000000;

// Describes a position of a path in JSON: at a vertex, on an edge with its ends, or in a face.
Statistics description(const Place& p, const Input_mesh& input)
{
  Statistics result;
  const Mesh& mesh = input.mesh;
  const Halfedge h = IT::halfedge_of(p);
  if(IT::is_at_vertex(p))
    result["vertex"] = mesh.source(h).idx();
  else if(h.is_valid())
    result["edge"] = {mesh.source(h).idx(), mesh.target(h).idx()};
  const auto [face, coordinates] = input.as_read(IT::face_location(p, mesh));
  result["face"] = face.idx();
  result["barycentric"] = coordinates;
  return result;
}

// Moves a position to a vertex from which it differs only by rounding.
void snap_to_vertex(Place& p, const Mesh& mesh)
{
  Surface_location location = IT::face_location(p, mesh);
  auto& weights = location.second;
  const auto greatest = std::max_element(weights.begin(), weights.end());
  if(*greatest < 1 && 1 - *greatest <= IT::rounding_unit<double>()) {
    weights = {0, 0, 0};
    *greatest = 1;
    p = IT::surface_point(location, mesh);
  }
}

// Stores a line on the input, and its data for the statistics.
struct Found_path
{
  Path path;
  Statistics description;
};

std::size_t number_of_crossings(const Path& path) { return path.places.size() - 2; }

const char* name_of(IT::Shortening_status status)
{
  return status == IT::Shortening_status::geodesic ? "geodesic" : "blocked";
}

Found_path found_path(Path path, const std::string& status, const Input_mesh& input)
{
  if(path.places.size() == 1) // a line has two ends, even if they are one point
    path.places.push_back(path.places.front());
  std::for_each(path.places.begin() + 1, path.places.end() - 1,
                [&](Place& p) { snap_to_vertex(p, input.mesh); });
  Statistics s{{"status", status}, {"length", path.length}};
  s["crossings"] = number_of_crossings(path);
  s["places"] = Statistics::array();
  for(const Place& p : path.places)
    s["places"].push_back(description(p, input));
  return {std::move(path), std::move(s)};
}

Found_path contracted_path()
{
  return {
    Path{0, {}},
    {{"status", "contracted"}, {"length", 0.}, {"crossings", 0}, {"places", Statistics::array()}}};
}

class Path_command
{
public:
  Path_command(const Common_options& common, const Path_options& options)
    : m_options(options),
      m_format(output_format(options.output, options, Carried::LINES)),
      m_run("path", common, {options.output})
  {
    check_options();
    m_run.plan({{"build", "search"}});
  }

  int run()
  {
    m_points.clear();
    read_points();
    Triangulation triangulation = m_run.timed("build", [&] { return make_triangulation(m_run); });
    const std::vector<Found_path> paths =
      m_run.timed("search", [&] { return search(triangulation); });
    describe(paths);
    m_run.timed("write", [&] {
      const Output_mesh lines = polylines(paths);
      m_run.add_output(m_options.output, lines, m_format);
      m_run.show([&](View_page& page) { show(page, lines); });
      save(m_run, triangulation);
    });
    m_run.finish(summary(paths));
    return 0;
  }

  Command_run& command_run() { return m_run; }

private:
  bool uses_flips() const { return m_options.is_flipped || m_options.is_loop; }

  void check_options() const
  {
    if(m_options.is_homology_basis) {
      check_alone();
      return;
    }
    if(m_options.from.empty())
      throw Program_error("--from is missing; say where the path starts, or ask for --homology");
    if(m_options.straightest) {
      if(m_options.straightest->second < 0)
        throw Program_error("--straightest: the length is negative; turn the angle by half of the "
                            "angle around the start");
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

  // Checks that the option is alone. Loops of a homology basis have no start, and each has its own
  // triangulation.
  void check_alone() const
  {
    if(!m_options.from.empty() || !m_options.to.empty() || !m_options.via.empty() || uses_flips() ||
       m_options.straightest)
      throw Program_error("--homology finds all loops by itself; leave out the other options of "
                          "paths");
    if(!m_run.options().save.empty())
      throw Program_error("--save keeps one triangulation, and each loop of --homology has its "
                          "own; shorten one loop, by --loop");
  }

  void read_points()
  {
    if(m_options.is_homology_basis)
      return;
    const Input_mesh& input = m_run.input();
    m_points.push_back(surface_point(m_options.from, input));
    for(const std::string& text : m_options.via)
      m_points.push_back(surface_point(text, input));
    if(!m_options.to.empty())
      m_points.push_back(surface_point(m_options.to, input));
  }

  std::vector<Found_path> search(Triangulation& triangulation)
  {
    if(m_options.is_homology_basis)
      return homology_loops(triangulation);
    if(m_options.straightest)
      return {straightest_path(triangulation)};
    return {uses_flips() ? flipped_path(triangulation) : shortest_path(triangulation)};
  }

  Found_path shortest_path(const Triangulation& triangulation) const
  {
    Path path = IT::shortest_path(triangulation.input(), m_points.front(), m_points.back());
    if(path.places.empty())
      throw Program_error("there is no path from " + m_options.from + " to " + m_options.to +
                          no_path_advice);
    return found_path(std::move(path), "shortest", m_run.input());
  }

  // Returns a path from vertex to vertex along edges, shortened by flips.
  Found_path flipped_path(Triangulation& triangulation)
  {
    Halfedges path = path_along_edges(triangulation);
    Edge_paths paths(triangulation);
    Found_path result = shortened(path, triangulation, paths);
    Statistics& edges = result.description["intrinsic_edges"] = Statistics::array();
    for(Halfedge h : path)
      edges.push_back({{"edge", Mesh::Edge_index(h).idx()},
                       {"source", triangulation.mesh().source(h).idx()},
                       {"target", triangulation.mesh().target(h).idx()}});
    return result;
  }

  // Returns the geodesics of a basis, from loops along edges of a Delaunay triangulation.
  std::vector<Found_path> homology_loops(Triangulation& triangulation) const
  {
    IT::make_Delaunay(triangulation);
    std::vector<Found_path> result;
    for(auto& loop : IT::geodesic_homology_basis(triangulation)) {
      result.push_back(found_path(std::move(loop.path), name_of(loop.status), m_run.input()));
      result.back().description["length_along_edges"] = loop.length_along_edges;
    }
    return result;
  }

  // Shortens a path along edges, whose halfedges become halfedges after flips. It is empty, and has
  // no places, if it contracts to a point.
  Found_path shortened(Halfedges& path, const Triangulation& triangulation, Edge_paths& paths) const
  {
    m_options.is_loop ? paths.add_loop(path) : paths.add_path(path);
    const double before = paths.length(0);
    const IT::Shortening_status status = paths.shorten();
    path = paths.halfedges(0);
    Found_path result = path.empty() ? contracted_path()
                                     : found_path(IT::path_on_input(triangulation, path),
                                                  name_of(status), m_run.input());
    result.description["length_along_edges"] = before;
    return result;
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

  // Returns the start, which is in the first of its faces if it is a vertex.
  Surface_location start_of_straightest(const IT::Delta_complex& mesh) const
  {
    Surface_location result = m_points.front();
    const Place p = IT::surface_point(result, mesh);
    if(!IT::is_at_vertex(p) || m_options.from.find(':') != std::string::npos)
      return result;
    IT::for_each_outgoing_halfedge(mesh.source(IT::halfedge_of(p)), mesh, [&](Halfedge h) {
      if(!mesh.is_border(h) && mesh.face(h) <= result.first)
        result = IT::face_location(IT::Edge_point<double>{h, 0}, mesh);
    });
    return result;
  }

  // Calls trace(start, vector). The angle is measured from the first side of the face, or at a
  // vertex from the side that leaves it, along all faces of the vertex.
  template <typename Trace>
  IT::Geodesic<double> from_start(const Surface_location& start, const Triangulation& triangulation,
                                  const Trace& trace) const
  {
    const auto [degrees, length] = *m_options.straightest;
    const double angle = degrees * (IT::pi<double>() / 180);
    const IT::Delta_complex& mesh = triangulation.input_mesh();
    const Place p = IT::surface_point(start, mesh);
    if(!IT::is_at_vertex(p)) {
      const IT::Flat_face<double> face(mesh.halfedge(start.first), triangulation.input());
      return trace(start, face.direction(0) * std::polar(length, angle));
    }
    const Halfedge side = IT::halfedge_of(p);
    return trace(mesh.source(side), vector_from(side, angle, start, triangulation));
  }

  // Returns the tangent vector at the source of `side` with this angle from it.
  std::complex<double> vector_from(Halfedge side, double angle, const Surface_location& start,
                                   const Triangulation& triangulation) const
  {
    try {
      return IT::tangent_vector_at_angle(triangulation.input(), side, angle,
                                         m_options.straightest->second);
    } catch(const IT::Invalid_input&) {
      leads_out(start);
    }
  }

  Found_path straightest_path(const Triangulation& triangulation) const
  {
    const auto input = triangulation.input();
    const IT::Delta_complex& mesh = input.mesh();
    std::vector<IT::Edge_point<double>> crossings;
    const auto add = [&](const IT::Edge_point<double>& p) {
      if(crossings.size() == greatest_number_of_crossings)
        throw Program_error("a straightest path of this length crosses more than " +
                            std::to_string(greatest_number_of_crossings) + " edges; shorten it");
      crossings.push_back(p);
    };
    const Surface_location start = start_of_straightest(mesh);
    const auto end =
      from_start(start, triangulation, [&](const auto& from, const std::complex<double>& vector) {
        return IT::trace_geodesic(input, from, vector, IT::At_boundary::stop,
                                  boost::make_function_output_iterator(add));
      });
    if(end.status == IT::Geodesic_status::stopped_at_boundary)
      check_length(end.length, start, triangulation);
    Path path{end.length, {IT::surface_point(start, mesh)}};
    for(const auto& p : crossings)
      path.places.push_back(IT::surface_point(IT::face_location(p, mesh), mesh));
    path.places.push_back(IT::surface_point(end.end, mesh));
    return found_path(std::move(path),
                      end.status == IT::Geodesic_status::reached ? "straightest"
                                                                 : "stopped_at_boundary",
                      m_run.input());
  }

  // Checks the length. A line that stops at its start, up to rounding, has no length.
  void check_length(double length, const Surface_location& start,
                    const Triangulation& triangulation) const
  {
    const auto h = triangulation.input_mesh().halfedge(start.first);
    if(length <= IT::Flat_face<double>(h, triangulation.input()).tolerance())
      leads_out(start);
  }

  [[noreturn]] void leads_out(const Surface_location& start) const
  {
    throw Program_error("'" + m_options.from +
                        "' is on the boundary, and this direction leads "
                        "out of the surface; angles are counterclockwise "
                        "from a side of face " +
                        std::to_string(start.first.idx()) + ", choose another");
  }

  // ---- Output ----

  Output_mesh polylines(const std::vector<Found_path>& paths)
  {
    Output_mesh result;
    for(const Found_path& found : paths) {
      if(found.path.places.empty())
        continue;
      const auto first = static_cast<Polygons::Index>(result.points.size());
      for(const Place& p : found.path.places)
        result.points.push_back(
          position(IT::face_location(p, m_run.input().mesh), m_run.input().mesh));
      const auto end = static_cast<Polygons::Index>(result.points.size());
      for(Polygons::Index i = first; i < end; ++i) {
        result.lines.add_corner(i);
        if(i > first)
          result.edges.push_back({i - 1, i});
      }
      result.lines.close();
    }
    return result;
  }

  // Shows the surface, with the points of the lines after its own points.
  void show(View_page& page, const Output_mesh& lines)
  {
    Output_mesh surface = output_mesh(m_run.input().mesh);
    add_data(surface, m_run.input().data);
    const auto first = static_cast<Polygons::Index>(surface.points.size());
    surface.points.insert(surface.points.end(), lines.points.begin(), lines.points.end());
    Surface_marks marks{"path", false, {}, {}, {}};
    for(const Polygons::Polygon line : lines.lines) {
      for(Polygons::Index p : line)
        marks.lines.add_corner(first + p);
      marks.lines.close();
    }
    page.add_surface("surface", std::move(surface));
    page.add_marks(std::move(marks));
  }

  void describe(const std::vector<Found_path>& paths)
  {
    Statistics& s = m_run.statistics();
    if(!m_options.is_homology_basis) {
      s.update(paths.front().description);
      return;
    }
    s["loops"] = Statistics::array();
    for(const Found_path& found : paths)
      s["loops"].push_back(found.description);
  }

  std::string summary(const std::vector<Found_path>& paths) const
  {
    std::ostringstream text;
    if(m_options.is_homology_basis) {
      const auto geodesics = std::count_if(paths.begin(), paths.end(), [](const auto& p) {
        return p.description["status"] == "geodesic";
      });
      text << paths.size() << " loops, " << geodesics << " of them geodesics";
      return text.str();
    }
    const Path& path = paths.front().path;
    if(path.places.empty())
      return "no line: the path contracts to a point; lead it around a handle, a hole or a "
             "vertex of negative curvature with --via";
    text << paths.front().description["status"].get<std::string>() << " path of length "
         << path.length << " over " << number_of_crossings(path) << " edges and vertices";
    return text.str();
  }

  const Path_options& m_options;
  Mesh_format m_format;
  Command_run m_run;
  std::vector<Surface_location> m_points; // that the path passes
};

void add_path_points(CLI::App& command, Path_options& options)
{
  command.add_option("--from", options.from,
                     "Start: a vertex, FACE:a,b,c (barycentric), or x,y,z (nearest)");
  command.add_option("--to", options.to, "End, in the same forms");
  command.add_option("--via", options.via, "Vertex that the path passes before it is shortened")
    ->allow_extra_args(false);
  command.add_flag("--flips", options.is_flipped,
                   "Shorten a path along edges to a geodesic nearby, by flips");
  command.add_flag("--loop", options.is_loop,
                   "Shorten the loop from --from through all --via, by flips");
  add_number(command, "--straightest", options.straightest,
             "Go straight instead, by this angle in degrees and this length. The angle is "
             "counterclockwise from the first side of the face at --from. At a vertex it is "
             "counterclockwise from the side that leaves it in its first face, along all its faces",
             finite_number());
  command.add_flag("--homology", options.is_homology_basis,
                   "Shortest geodesic loops around all handles and holes, by flips");
}

} // namespace

void define_path(Command_line& line)
{
  const auto [command, options] = line.add_with_mesh(
    "path", "Find shortest paths and geodesics", attempted<Path_command, Path_options>, path_help);
  add_path_points(command, options);
  add_output(command, options, "The path as a line (.obj, .ply, .vtp", "obj, ply or vtp");
  add_save(command, line.common());
  add_common_options(command, line.common());
}
