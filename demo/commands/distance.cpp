// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands/Command_line.h"

#include "Program_error.h"
#include "commands/Command_run.h"
#include "commands/attempts.h"
#include "commands/triangulation_stages.h"
#include "reading/surface_curves.h"
#include "reading/surface_points.h"
#include "writing/Mesh_writer.h"
#include "writing/level_curves.h"

#include <CGAL/Intrinsic_triangulations/Correspondence.h>
#include <CGAL/Intrinsic_triangulations/Distance_sources.h>
#include <CGAL/Intrinsic_triangulations/Precise_surface.h>
#include <CGAL/Intrinsic_triangulations/Surface_view.h>
#include <CGAL/Intrinsic_triangulations/Tufted_surface.h>
#include <CGAL/Intrinsic_triangulations/curve_across.h>
#include <CGAL/Intrinsic_triangulations/geodesic_distances.h>
#include <CGAL/Intrinsic_triangulations/interpolation.h>
#include <CGAL/Intrinsic_triangulations/point_across.h>
#include <CGAL/Intrinsic_triangulations/signed_distance.h>

#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <iomanip>
#include <iostream>
#include <optional>
#include <sstream>
#include <string>
#include <system_error>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;

namespace {

struct Distance_options : Output_options
{
  Distance_options() : Output_options("ply") {}

  std::string subdivision;
  std::vector<std::string> sources; // points as `surface_point()` reads them
  std::string curve;                // a file; empty for none
  std::string level_sets;           // a file; empty if they are not wanted
  std::vector<double> levels;       // none for a choice
  bool is_signed = false;
  std::optional<double> time_step_factor;
  Refinement_bounds refinement; // none without an angle
  std::string method = "auto";  // or "exact", "heat"
};

constexpr const char* distance_help =
  R"(Distances are exact on surfaces of up to 65,000 vertices with one source, or more with several.
Exact distances are lengths of shortest paths, up to rounding. At the limit, they take about two
seconds. Otherwise the heat method approximates distances. Heat is also used with --method heat, and
for triangles that are not a surface. With --signed, it is used for a curve that does not separate
the surface.

The error of heat is about two percent on average on evenly distributed vertices, and greater on
coarse or uneven meshes. The last line and the statistics name the method. With heat they have an
estimate of the error, from exact distances to the nearest vertices. A warning is printed if a tenth
of these vertices have errors of more than 10 %. The distance of a vertex that no source reaches
is -1.

A file of --curve is written by `intrinsic path`, or has polylines of another program. These are
elements l of .obj, edges of .ply, Lines of .vtp with ascii numbers, or the points of .xyz. Points
are moved to the surface and joined by shortest paths. With --signed, distances are negative on the
left of the curve: inside a loop that runs counterclockwise. Heat bridges gaps, and single segments
of the wrong direction.

The triangles need not form a surface: edges may have three or more faces, vertices may have several
fans, and orientations may differ. Distances are then computed on a tufted cover. With --neighbors,
points without faces are triangulated with their neighbors.

Examples:
  intrinsic distance bunny.obj --source 17 --source 99 -o distance.ply
  intrinsic distance bunny.obj --curve loop.obj --signed -o distance.vtp)";

constexpr double unreachable = -1;
constexpr std::size_t most_vertices = 100000; // of a triangulation on which errors are computed

// What distances are measured from, on one of the triangulations.
struct Sources
{
  std::vector<std::int64_t> vertices;
  std::vector<Surface_location> points;
  IT::Surface_curve<double> curve;

  static IT::Vertex_index vertex(std::int64_t number)
  {
    return IT::Vertex_index(static_cast<IT::Vertex_index::size_type>(number));
  }
};

std::int64_t checked_vertex(const std::string& text, const std::string& path,
                            const Input_mesh& input)
{
  const auto last = static_cast<std::int64_t>(input.number_of_vertices()) - 1;
  std::int64_t n = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), n);
  if(error == std::errc::invalid_argument || end != text.data() + text.size())
    throw Program_error(
      "'" + text +
      "' is not a point of the mesh: give a vertex, FACE:a,b,c or x,y,z, such as 7, "
      "12:0.5,0.2,0.3 or 1,0,2.5");
  if(error != std::errc() || n < 0 || n > last)
    throw Program_error(path + ": there is no vertex " + text +
                        " to be a source; the vertices are 0 to " + std::to_string(last));
  return n;
}

// Returns the sources on the input.
Sources parsed_sources(const Distance_options& options, const std::string& path,
                       const Input_mesh& input)
{
  Sources result;
  for(const std::string& text : options.sources)
    if(text.find_first_of(":,") == std::string::npos)
      result.vertices.push_back(checked_vertex(text, path, input));
    else if(input.covered && text.find(':') != std::string::npos)
      throw Program_error("'" + text +
                          "' is not a point of the mesh: on triangles that are not a surface, "
                          "give a vertex or x,y,z");
    else
      result.points.push_back(surface_point(text, input));
  return result;
}

// Returns the sources on the triangulation T2.
Sources sources_across(Sources sources, const Triangulation& triangulation)
{
  if(sources.points.empty() && sources.curve.empty())
    return sources;
  const IT::Correspondence correspondence(triangulation);
  for(Surface_location& p : sources.points)
    p = IT::point_across(correspondence, IT::Side::input, p);
  sources.curve = IT::curve_across(correspondence, IT::Side::input, sources.curve);
  return sources;
}

std::vector<double> presentable(std::vector<double> distances)
{
  std::replace_if(
    distances.begin(), distances.end(), [](double d) { return !std::isfinite(d); }, unreachable);
  return distances;
}

template <class Surface>
IT::Distance_sources<Surface> sources_on(const Surface& surface, const Sources& sources)
{
  IT::Distance_sources<Surface> result(surface);
  for(const std::int64_t v : sources.vertices)
    result.add(Sources::vertex(v));
  result.add(sources.points);
  result.add(sources.curve);
  return result;
}

// Returns the positions of vertices of the input, or of the soup if it has a cover, and then of
// inserted vertices.
std::vector<Point> positions(const Triangulation& triangulation, const Input_mesh& input)
{
  const auto& points = input.mesh.points();
  std::vector<Point> result =
    input.covered ? input.covered->soup.points : std::vector<Point>(points.begin(), points.end());
  for(const auto& place : triangulation.inserted_vertices())
    result.push_back(position(IT::face_location(place, triangulation.input_mesh()), input.mesh));
  return result;
}

using Distances = IT::Geodesic_distances<double>;

// Returns the method. A time for heat selects heat.
IT::Distance_method library_method(const Distance_options& options)
{
  if(options.method == "exact")
    return IT::Distance_method::exact;
  return options.method == "heat" || options.time_step_factor ? IT::Distance_method::heat
                                                              : IT::Distance_method::automatic;
}

// Returns distances as numbers of type `double`.
Distances rounded(Distances distances) { return distances; }

template <class FT>
Distances rounded(const IT::Geodesic_distances<FT>& distances)
{
  Distances result{{},
                   distances.method,
                   CGAL::to_double(distances.time_step_factor),
                   std::nullopt,
                   distances.number_of_raised_vertices};
  for(const FT& d : distances.distance)
    result.distance.push_back(CGAL::to_double(d));
  return result;
}

// Returns the distances at the vertices of the input, then at inserted vertices.
template <class Surface, class All_sources>
IT::Geodesic_distances<IT::Length_of<Surface>>
distances_on(const Surface& surface, const All_sources& sources, const Distance_options& options,
             const std::vector<Point>& points)
{
  const auto point = boost::make_function_property_map<IT::Vertex_index>(
    [&](IT::Vertex_index v) { return points[v.idx()]; });
  const auto parameters =
    IT::parameters::vertex_point_map(point).distance_method(library_method(options));
  IT::Distance_sources<Surface> all(surface);
  all.add(sources);
  return options.time_step_factor
           ? IT::geodesic_distances(surface, all,
                                    parameters.time_step_factor(*options.time_step_factor))
           : IT::geodesic_distances(surface, all, parameters);
}

// Returns signed distances.
Distances signed_distances(const Triangulation& triangulation, const Sources& sources,
                           const Distance_options& options)
{
  const auto parameters = IT::parameters::distance_method(library_method(options));
  Distances result = options.time_step_factor
                       ? IT::signed_distance(triangulation, sources.curve,
                                             parameters.time_step_factor(*options.time_step_factor))
                       : IT::signed_distance(triangulation, sources.curve, parameters);
  for(std::size_t v = 0; v < result.distance.size(); ++v)
    if(!std::isfinite(result.distance[v]))
      throw Program_error("vertex " + std::to_string(v) +
                          " has no signed distance: no part of the curve is on its component "
                          "(add a part on it; --repair removes isolated vertices)");
  return result;
}

Distances distances(const Triangulation& triangulation, const Input_mesh& input,
                    const Sources& sources, const Distance_options& options)
{
  if(options.is_signed)
    return signed_distances(triangulation, sources, options);
  const std::vector<Point> points = positions(triangulation, input);
  if(!input.covered)
    return distances_on(triangulation, sources_on(triangulation, sources), options, points);
  const auto tufted = [&](const auto& surface) {
    typedef IT::Length_of<std::decay_t<decltype(surface)>> FT;
    return IT::Tufted_surface<FT>(input.covered->cover, surface, input.covered->share());
  };
  const auto rounded_surface = tufted(triangulation);
  const auto all = sources_on(rounded_surface, sources);
  return IT::with_resolved_areas(triangulation, [&](const auto& surface) {
    return rounded(distances_on(tufted(surface), all, options, points));
  });
}

void describe_method(Statistics& statistics, const Distances& distances)
{
  const bool is_exact = distances.method == IT::Distance_method::exact;
  statistics["method"] = is_exact ? "exact" : "heat";
  if(is_exact)
    return;
  statistics["time_step_factor"] = distances.time_step_factor;
  if(const auto& error = distances.error)
    statistics["relative_error"] = {{"vertices", error->number_of_vertices},
                                    {"greatest_distance", error->greatest_distance},
                                    {"mean", error->mean},
                                    {"ninety_percent", error->ninety_percent},
                                    {"greatest", error->greatest}};
  statistics["raised_vertices"] = distances.number_of_raised_vertices;
}

// Returns the values at the vertices of the triangulation.
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

// Describes the sources. A vertex is described by its index.
Statistics description(const Sources& sources, const Input_mesh& input)
{
  Statistics result = Statistics::array();
  for(const std::int64_t v : sources.vertices)
    result.push_back(v);
  for(const Surface_location& p : sources.points) {
    const auto [face, coordinates] = input.as_read(p);
    result.push_back({{"face", face.idx()}, {"barycentric", coordinates}});
  }
  return result;
}

void describe_distances(Command_run& run, const Distance_options& options, const Sources& sources,
                        const std::vector<double>& values)
{
  Statistics& statistics = run.statistics();
  statistics["sources"] = description(sources, run.input());
  if(options.is_signed)
    statistics["min_distance"] = *std::min_element(values.begin(), values.end());
  statistics["max_distance"] = *std::max_element(values.begin(), values.end());
  statistics["unreachable_vertices"] =
    options.is_signed ? 0 : std::count(values.begin(), values.end(), unreachable);
}

Output_mesh with_distances(Output_mesh mesh, std::vector<double> distances)
{
  mesh.point_data.push_back({"distance", std::move(distances)});
  return mesh;
}

// Returns the subdivision with functions on the triangulation. Vertices on an edge are reachable if
// its ends are: both ends have a distance, or neither.
Output_mesh with_functions(const std::vector<Attribute>& functions, const Subdivision& subdivision)
{
  Output_mesh result = subdivision_mesh(subdivision);
  for(const Attribute& f : functions)
    result.point_data.push_back({f.name, interpolated(IT::Side::intrinsic, f.kept(), subdivision)});
  return result;
}

std::string percentage(const Statistics& share)
{
  std::ostringstream text;
  text << std::setprecision(2) << 100 * share.get<double>() << " %";
  return text.str();
}

std::string summary_of_method(const Statistics& s)
{
  if(s["method"] == "exact")
    return "(exact)";
  std::string result = "(by heat, ";
  if(!s.contains("relative_error"))
    return result + "with an unknown error)";
  const Statistics& error = s["relative_error"];
  result += "errors " + percentage(error["mean"]) + " on average, up to " +
            percentage(error["ninety_percent"]) + " at nine of ten and " +
            percentage(error["greatest"]) + " at all of " +
            std::to_string(error["vertices"].get<std::size_t>()) + " vertices";
  if(s["raised_vertices"] > 0)
    result += "; " + std::to_string(s["raised_vertices"].get<std::size_t>()) +
              " values raised to the distance in space";
  return result + ")";
}

std::string summary_of_distances(Command_run& run)
{
  const Statistics& s = run.statistics();
  std::ostringstream text;
  text << summary_of_changes(run) << ", greatest distance " << s["max_distance"].get<double>();
  if(s.contains("min_distance"))
    text << ", least " << s["min_distance"].get<double>();
  if(s["unreachable_vertices"] > 0)
    text << ", " << s["unreachable_vertices"] << " vertices out of reach (distance -1)";
  text << ' ' << summary_of_method(s);
  return text.str();
}

constexpr double greatest_silent_error = 0.1;

void warn_of_errors(const Statistics& s, const Common_options& common,
                    const Distance_options& options)
{
  if(common.is_quiet || !s.contains("relative_error") ||
     !(s["relative_error"]["ninety_percent"] > greatest_silent_error))
    return;
  std::cerr << common.input << ": warning: a tenth of the distances by heat are wrong by "
            << percentage(s["relative_error"]["ninety_percent"]) << " or more; "
            << (options.is_signed ? "a closed curve has exact distances"
                                  : "--method exact has none of these errors")
            << '\n';
}

class Distance_command
{
public:
  Distance_command(const Common_options& common, const Distance_options& options)
    : m_options(options),
      m_format(output_format(options.output, options, Carried::DISTANCES)),
      m_subdivision_format(format_of(options.subdivision, options, Carried::DISTANCES)),
      m_level_format(format_of(options.level_sets, options, Carried::LINES)),
      m_run("distance", common, {options.output, options.subdivision, options.level_sets},
            options.method != "exact" && options.curve.empty())
  {
    check_options();
    m_run.plan({delaunay_stages,
                refinement_stages(options.refinement),
                certificate_stages(common),
                {"solve"},
                is_subdivision_wanted() ? subdivision_stages : Stages{}});
  }

  int run()
  {
    m_sources = parsed_sources(m_options, m_run.options().input, m_run.input());
    Triangulation triangulation = make_delaunay_triangulation(m_run);
    refine_if_wanted(m_run, triangulation, m_options.refinement);
    describe(m_run, triangulation);
    const Distances found = m_run.timed("solve", [&] {
      read_curve_if_wanted(triangulation);
      return distances(triangulation, m_run.input(), sources_across(m_sources, triangulation),
                       m_options);
    });
    m_method = found.method;
    describe_method(m_run.statistics(), found);
    const std::vector<double> values = presentable(found.distance);
    describe_distances(m_run, m_options, m_sources, at_input_vertices(values));
    const auto subdivision = subdivide_if_wanted(triangulation);
    m_run.timed("write", [&] { write(values, subdivision, triangulation); });
    m_run.finish(summary_of_distances(m_run));
    warn_of_errors(m_run.statistics(), m_run.options(), m_options);
    if(!m_run.options().is_quiet)
      warn_of_empty_levels(values);
    return 0;
  }

  Command_run& command_run() { return m_run; }

private:
  void check_options()
  {
    const bool has_curve = !m_options.curve.empty();
    check_insertions(m_options.refinement);
    if(m_options.is_signed && !has_curve)
      throw Program_error("--signed needs a --curve; give one");
    if(m_options.sources.empty() && !has_curve)
      throw Program_error("--source or --curve is missing; say where distances are zero");
    if(m_options.is_signed && !m_options.sources.empty())
      throw Program_error("--signed is for a --curve alone, without --source");
    if(m_options.time_step_factor && m_options.method == "exact")
      throw Program_error("--time-step is for heat; leave out --method exact and --exact-distance");
    if(!m_options.levels.empty() && !m_level_format)
      throw Program_error("--level is for --level-sets; name a file for the curves");
    if(m_level_format && m_run.input().covered)
      throw Program_error(m_run.options().input +
                          ": --level-sets needs a surface; --repair may make it one");
  }

  void read_curve_if_wanted(const Triangulation& triangulation)
  {
    if(m_options.curve.empty())
      return;
    Curves_on_surface curves = read_curves(m_options.curve, m_run.input().mesh, triangulation);
    Statistics& s = m_run.statistics()["curve"];
    s["polylines"] = curves.number_of_polylines;
    s["points"] = curves.number_of_points;
    s["segments"] = curves.segments.size();
    s["length"] = IT::curve_length(triangulation.input(), curves.segments);
    s["greatest_distance_from_surface"] = curves.greatest_distance;
    m_sources.curve = std::move(curves.segments);
  }

  // Returns the values at vertices of the input, which come before inserted vertices.
  std::vector<double> at_input_vertices(const std::vector<double>& values)
  {
    return {values.begin(),
            values.begin() + static_cast<std::ptrdiff_t>(m_run.input().number_of_vertices())};
  }

  // Returns the format, or nothing if the file is not requested.
  static std::optional<Mesh_format> format_of(const std::string& path,
                                              const Distance_options& options, Carried what)
  {
    return path.empty() ? std::nullopt : std::optional(output_format(path, options, what));
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
    Output_mesh result = with_distances(m_run.input_as_read(), at_input_vertices(values));
    add_data(result, m_run.input().data);
    m_run.add_output(m_options.output, result, m_format);
    if(subdivision)
      write_subdivision(values, *subdivision, triangulation);
    if(m_level_format)
      m_run.add_output(m_options.level_sets,
                       level_curves(triangulation, m_run.input().mesh, values, levels(values)),
                       *m_level_format);
    save(m_run, triangulation);
  }

  std::pair<double, double> range(const std::vector<double>& values) const
  {
    return {m_options.is_signed ? *std::min_element(values.begin(), values.end()) : 0,
            *std::max_element(values.begin(), values.end())};
  }

  void warn_of_empty_levels(const std::vector<double>& values) const
  {
    const auto [least, greatest] = range(values);
    for(const double level : m_options.levels)
      if(!(least < level && level <= greatest))
        std::cerr << m_run.options().input << ": warning: level " << level
                  << " has no curve; distances are from " << least << " to " << greatest << '\n';
  }

  // Returns the levels, or ten levels with equal differences if none are given.
  std::vector<double> levels(const std::vector<double>& values) const
  {
    if(!m_options.levels.empty())
      return m_options.levels;
    const auto [least, greatest] = range(values);
    std::vector<double> result;
    for(int i = 0; i < 10; ++i)
      result.push_back(least + (greatest - least) * (i + 0.5) / 10);
    return result;
  }

  void write_subdivision(const std::vector<double>& values, const Subdivision& subdivision,
                         const Triangulation& triangulation)
  {
    std::vector<Attribute> functions{
      {"distance", on_triangulation(values, triangulation, m_run.input().covered)}};
    Output_mesh mesh = with_functions(functions, subdivision);
    m_run.show([&](View_page& page) {
      if(are_errors_known(triangulation))
        functions.push_back({"distance_error", errors(values, triangulation)});
      show_sources(page, functions, subdivision, triangulation);
    });
    if(!m_subdivision_format)
      return;
    add_input_data(m_run.input(), mesh);
    m_run.add_output(m_options.subdivision, mesh, *m_subdivision_format);
  }

  // Returns whether errors are known. Shortest paths may take too long.
  bool are_errors_known(const Triangulation& triangulation)
  {
    return m_method == IT::Distance_method::heat && !m_options.is_signed &&
           !m_run.input().covered && triangulation.mesh().number_of_vertices() <= most_vertices;
  }

  // Returns the errors of the heat method, at the vertices of the triangulation.
  std::vector<double> errors(std::vector<double> values, const Triangulation& triangulation) const
  {
    const auto surface = triangulation.intrinsic();
    const std::vector<double> lengths = presentable(
      IT::geodesic_distances(surface, sources_on(surface, sources_across(m_sources, triangulation)),
                             IT::parameters::distance_method(IT::Distance_method::exact))
        .distance);
    for(std::size_t v = 0; v < values.size(); ++v)
      values[v] -= lengths[v];
    return values;
  }

  // Shows the sources. Points and curves come after the points of the subdivision.
  void show_sources(View_page& page, const std::vector<Attribute>& functions,
                    const Subdivision& subdivision, const Triangulation& triangulation)
  {
    Output_mesh mesh = with_functions(functions, subdivision);
    Surface_marks marks{"sources", false, {}, {}, vertex_sources_on(triangulation)};
    const auto add_point = [&](const Surface_location& p) {
      mesh.points.push_back(position(p, m_run.input().mesh));
      return static_cast<std::int64_t>(mesh.points.size()) - 1;
    };
    for(const Surface_location& p : m_sources.points)
      marks.points.push_back(add_point(p));
    for(const auto& segment : m_sources.curve) {
      marks.lines.add_corner(static_cast<std::size_t>(add_point({segment.face, segment.source})));
      marks.lines.add_corner(static_cast<std::size_t>(add_point({segment.face, segment.target})));
      marks.lines.close();
    }
    show(page, m_run, triangulation, subdivision, mesh, functions);
    page.add_marks(std::move(marks));
  }

  // Returns the sources that are vertices, one for each vertex fan of the cover.
  std::vector<std::int64_t> vertex_sources_on(const Triangulation& triangulation)
  {
    const std::optional<Covered_soup>& covered = m_run.input().covered;
    if(!covered)
      return m_sources.vertices;
    std::vector<std::int64_t> result;
    for(const IT::Vertex_index v : triangulation.mesh().vertices())
      if(const auto n = static_cast<std::int64_t>(covered->cover.input_vertex(v));
         std::count(m_sources.vertices.begin(), m_sources.vertices.end(), n) > 0)
        result.push_back(number_of(v));
    return result;
  }

  const Distance_options& m_options;
  Mesh_format m_format;
  std::optional<Mesh_format> m_subdivision_format, m_level_format; // none if they are not wanted
  Command_run m_run;
  Sources m_sources; // on the input
  IT::Distance_method m_method = IT::Distance_method::automatic;
};

void add_distance_outputs(CLI::App& command, Distance_options& options)
{
  add_output(command, options, "The mesh with the vertex property \"distance\" (.ply, .vtp",
             "ply or vtp");
  command.add_option("--subdivision", options.subdivision,
                     "Common subdivision of the mesh and its intrinsic triangulation, "
                     "with the same property");
  command.add_option("--level-sets", options.level_sets,
                     "Curves of equal distance (.obj, .ply or .vtp)");
  command
    .add_option("--level", options.levels,
                "A value of the distance for --level-sets; ten values if none is given")
    ->allow_extra_args(false)
    ->transform(finite_number());
}

void add_distance_method(CLI::App& command, Distance_options& options)
{
  CLI::Option* const method =
    command
      .add_option(
        "--method", options.method,
        "exact (lengths of shortest paths, up to rounding), heat (the heat method, with "
        "an estimate of its error), or auto. Method auto is exact up to 65,000 vertices with "
        "one source, without --time-step")
      ->check(CLI::IsMember({"exact", "heat", "auto"}))
      ->capture_default_str();
  command
    .add_flag_callback(
      "--exact-distance", [&options] { options.method = "exact"; }, "A synonym of --method exact")
    ->excludes(method);
}

} // namespace

void define_distance(Command_line& line)
{
  const auto [command, options] =
    line.add_with_mesh("distance", "Compute geodesic distances, exactly or by heat",
                       attempted<Distance_command, Distance_options>, distance_help);
  command
    .add_option("--source", options.sources,
                "Point to which distances are measured, with several to the nearest: a vertex "
                "counted from 0, FACE:a,b,c (barycentric), or x,y,z (nearest)")
    ->allow_extra_args(false);
  add_read_file(command, line.common(), "--curve", options.curve,
                "File of polylines (.obj, .ply or .vtp, or .xyz for one) to which distances are "
                "measured");
  command.add_flag("--signed", options.is_signed,
                   "Compute signed distances to --curve: negative on its left");
  add_distance_outputs(command, options);
  add_save(command, line.common());
  add_common_options(command, line.common());
  add_exact(command, line.common());
  add_number(
    command, "--time-step", options.time_step_factor,
    "Time for which heat flows, in squared mean edge lengths, with --method heat unless another "
    "is given. By default 1, or 0.7 with a sign, times 16 until heat reaches everything",
    positive_number());
  add_angle(command, options.refinement);
  add_direct(command, line.common());
  add_distance_method(command, options);
  add_neighbors(command, line.common());
}
