// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands/Command_line.h"

#include "Program_error.h"
#include "commands/Command_run.h"
#include "commands/attempts.h"
#include "commands/removal_cost.h"
#include "commands/triangulation_stages.h"
#include "page/show_angles.h"
#include "writing/Fine_level.h"
#include "writing/Mesh_writer.h"
#include "writing/coarse_mesh.h"
#include "writing/matrix_market.h"

#include <CGAL/Intrinsic_simplification/Evolving_surface.h>
#include <CGAL/Intrinsic_simplification/Surface_level.h>
#include <CGAL/Intrinsic_simplification/Surface_map.h>
#include <CGAL/Intrinsic_simplification/Surface_subdivision.h>
#include <CGAL/Intrinsic_simplification/coarse_mesh.h>
#include <CGAL/Intrinsic_simplification/io.h>
#include <CGAL/Intrinsic_simplification/pinch_handles.h>
#include <CGAL/Intrinsic_simplification/prolongation.h>
#include <CGAL/Intrinsic_simplification/refine.h>
#include <CGAL/Intrinsic_simplification/simplify.h>
#include <CGAL/Intrinsic_triangulations/diagnose.h>
#include <CGAL/Intrinsic_triangulations/input_with_inserted_vertices.h>
#include <CGAL/Intrinsic_triangulations/interpolation.h>
#include <CGAL/Intrinsic_triangulations/io.h>
#include <CGAL/Intrinsic_triangulations/triangle_formulas.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <functional>
#include <iostream>
#include <limits>
#include <optional>
#include <ostream>
#include <sstream>
#include <utility>

namespace IS = CGAL::Intrinsic_simplification;
namespace IT = CGAL::Intrinsic_triangulations;

namespace {

struct Simplify_options : Output_options
{
  Simplify_options() : Output_options("ply") {}

  std::string coarse_mesh; // a file for the coarse triangulation in space
  std::string prolongation;
  // Exactly one of these values is given.
  std::optional<std::size_t> number_of_vertices;
  std::optional<double> ratio; // of the number of vertices
  std::optional<double> maximum_cost;
  std::vector<std::string> weights; // as "name=value"
  std::size_t number_of_levels = 1;
  Refinement_bounds refinement;    // of the fine triangulation; none without an angle
  double coarse_minimum_angle = 0; // of the coarse triangulation; 0 for no refinement
  double closed_length = 0;        // of boundary loops that are closed before
  double pinched_length = 0;       // of edge loops along which handles are cut before
};

constexpr const char* simplify_help =
  R"(Vertices are removed one by one, always the vertex with the least cost. The result is an
intrinsic Delaunay triangulation of a surface whose distances are close to distances on the mesh.
Vertices keep their positions. The cost of a removal is a length. It is the distance by which
curvature and area have been moved, with their weights, times their part of the whole. Changes of
area cost too, most at the boundary, so that corners of flat parts stay.

With --weight, weights that are not given are zero; the last line names all weights. Color (in .ply,
.off and .obj) and functions at the vertices (properties in .ply, by their names) can have weights.
Their Laplacians are moved too, so that more vertices stay where their gradients change.

--error is the greatest cost of a removal. If no vertex can be removed, simplification ends early,
with exit code 0 and the status "nothing_removable" in the statistics. Vertices without faces stay;
--vertices and --ratio do not count them.

With --min-angle, vertices are finally inserted into the coarse triangulation until its angles obey
the bound, except at small-angle vertices, as by `intrinsic refine`. All output is about the refined
coarse triangulation. If --max-insertions stops a refinement, a warning counts the remaining faces.

With --close-loops and --pinch-handles, the topology is simplified first. Boundary loops up to a
length are closed. Handles are cut along closed curves of edges up to a length, the shortest first,
and closed on both sides. A loop is closed by a disk of triangles around a new vertex. The rest of
the mesh does not change. Faces of disks have -1 as "input_face". In the output, the new vertex is
in the middle of the boundary of its disk; lengths of the disk differ from this picture. All lengths
are in the units of the mesh.

With --exact, the refinement before, and the intrinsic Delaunay triangulation from which vertices
are removed, are decided exactly and certified, as by `intrinsic delaunay --exact`. Removals change
the surface by rounded numbers, and are decided in floating point.

The output is the common subdivision of the mesh and the coarse triangulation. In .ply and .vtp,
faces have the properties "coarse_face" and "input_face", and a color that differs between adjacent
coarse faces. Edges in .ply have "coarse_edge" and "input_edge", or -1; .vtp has the coarse edges as
polylines. Vertices have "coarse_vertex", or -1, and "kind":
  0  input vertex
  1  crossing of a coarse edge with an edge
  2  inserted vertex
  3  bend of a coarse edge inside a face
With --refine, more edges lead to the inserted vertices, within the faces of the mesh.

The file of --coarse has the coarse triangulation as an ordinary mesh for other programs. Its
vertices are at their positions on the mesh, edges are straight, and faces are flat. In .ply and
.vtp, vertices have the property "input_vertex". It is -1 for vertices inserted because of loops or
several edges with the same ends. Vertices have the functions, colors and normals of the mesh; faces
have neither texture coordinates nor groups. The coarse triangulation is close to the mesh in its
lengths, not in space. The last line and "coarse_mesh" in the statistics have the deviation. One
number is the greatest distance of a vertex of the mesh from the coarse mesh. The other is the
greatest distance of the middle of a coarse edge or face from the mesh. They also count faces that
are flipped or have no area, and pairs of faces that intersect.

P of --prolongation has a row for each vertex of the mesh and a column for each coarse vertex. Its
rows are barycentric coordinates: not negative, with sum 1. With L levels, the L matrices P_1.mtx to
P_L.mtx each lead from one level to the level before. The vertices of a level are the remaining
vertices of the mesh, in their order. Vertices inserted by --refine follow them; they can be coarse
vertices, but have no rows in the first matrix. Vertices inserted by --min-angle are the last coarse
vertices.

--save writes all levels and the operations between them. With --refine, the mesh with the inserted
vertices comes first.

Examples:
  intrinsic simplify bunny.obj -o coarse.vtp --vertices 500 --prolongation P.mtx
  intrinsic simplify bunny.obj --coarse small.obj --vertices 500)";

// The names are in the order of `Removal_status`.
constexpr std::array<const char*, IS::number_of_removal_statuses> removal_names = {
  "possible",  "isolated",   "protected",       "border_loop",
  "self_face", "low_degree", "not_flattenable", "not_separable"};

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

// Returns one path for each level: the path itself for a single level.
std::vector<std::string> matrix_paths(const Simplify_options& options)
{
  const std::filesystem::path path = options.prolongation;
  if(path.empty() || options.number_of_levels == 1)
    return {path};
  std::vector<std::string> result;
  for(std::size_t n = 1; n <= options.number_of_levels; ++n) {
    std::filesystem::path numbered = path;
    numbered.replace_filename(path.stem().string() + '_' + std::to_string(n) +
                              path.extension().string());
    result.push_back(numbered);
  }
  return result;
}

void check_levels(const Common_options& common, const Simplify_options& options)
{
  if(options.number_of_levels == 1)
    return;
  if(options.maximum_cost)
    throw Program_error("--levels needs --vertices or --ratio");
  if(options.prolongation.empty() && common.save.empty() && common.statistics.empty())
    throw Program_error("--levels is for --prolongation, --save and --stats; add one of them");
}

std::vector<std::string> outputs_of(const Common_options& common, const Simplify_options& options)
{
  check_levels(common, options);
  if(options.output.empty() && options.coarse_mesh.empty())
    throw Program_error("--output or --coarse is required");
  if(options.refinement.maximum_number_of_insertions && options.refinement.minimum_angle == 0 &&
     options.coarse_minimum_angle == 0)
    throw Program_error("--max-insertions is for --refine and --min-angle; add one of them");
  std::vector<std::string> result = matrix_paths(options);
  result.push_back(options.output);
  result.push_back(options.coarse_mesh);
  return result;
}

// Returns the format. Only numbers in .ply are binary.
Mesh_format format_of(const std::string& path, Simplify_options options)
{
  if(std::filesystem::path(path).extension() != ".ply" && path != options.output)
    options.is_binary = false;
  return path.empty() ? Mesh_format::PLY : output_format(path, options);
}

class Simplify_command
{
public:
  Simplify_command(const Common_options& common, const Simplify_options& options)
    : m_options(options),
      m_weights(options.weights),
      m_format(format_of(options.output, options)),
      m_coarse_format(format_of(options.coarse_mesh, options)),
      m_run("simplify", common, outputs_of(common, options))
  {
    const bool is_flipped = options.refinement.minimum_angle > 0 || common.is_exact;
    m_run.plan({is_flipped ? delaunay_stages : Stages{"build"},
                refinement_stages(options.refinement),
                certificate_stages(common),
                {"simplify"},
                options.coarse_minimum_angle > 0 ? Stages{"refine_coarse"} : Stages{},
                {"map"},
                options.coarse_mesh.empty() ? Stages{} : Stages{"coarse_mesh"}});
  }

  int run()
  {
    m_triangulation.reset();
    m_levels.clear();
    m_curvature.clear();
    m_area_change.clear();
    set_functions();
    if(m_options.refinement.minimum_angle > 0)
      refine();
    Triangulation start = m_run.timed("build", [&] { return built(); });
    IS::Evolving_surface surface(start);
    m_levels.emplace_back(surface);
    if(m_run.options().is_exact)
      make_exactly_Delaunay(surface, start);
    m_run.timed("simplify", [&] { simplify(surface); });
    if(m_options.coarse_minimum_angle > 0)
      m_run.timed("refine_coarse", [&] { refine_coarse(surface); });
    describe_levels();
    auto [mesh, matrices] = m_run.timed("map", [&] {
      return std::pair(common_mesh(surface.history()), prolongations(surface.history()));
    });
    if(!m_options.coarse_mesh.empty())
      m_run.timed("coarse_mesh", [&] { add_coarse_mesh(surface); });
    m_run.timed("write", [&, &mesh = mesh, &matrices = matrices] {
      m_run.show([&, &mesh = mesh](View_page& page) { show(page, mesh); });
      add_data(mesh, std::move(m_data));
      m_run.add_output(m_options.output, mesh, m_format);
      for(std::size_t n = 0; n < matrices.size(); ++n)
        m_run.add_output(matrix_paths(m_options)[n], matrices[n]);
      save(surface.history());
    });
    warn_of_limits();
    m_run.finish(summary());
    return 0;
  }

  Command_run& command_run() { return m_run; }

private:
  void set_functions()
  {
    if(m_weights.has_functions() && !m_run.input().repairs.empty())
      throw Program_error(
        "--weight: the mesh had to be repaired, and its vertices differ from the file; "
        "give a mesh that needs no repair");
    m_weights.set_functions(m_run.options().input, m_run.input());
  }

  // Refines the input, and adds separate keys about it to the statistics.
  void refine()
  {
    m_triangulation = make_delaunay_triangulation(m_run);
    refine_if_wanted(m_run, *m_triangulation, m_options.refinement);
    m_triangulation->collect_garbage();
    m_run.statistics()["refinement_status"] = m_run.statistics()["status"];
  }

  // Returns the fine level. Its first faces are the faces of the input, or parts of them.
  Triangulation built()
  {
    if(m_triangulation)
      m_triangulation = IT::input_with_inserted_vertices(*m_triangulation);
    m_fine.emplace(m_run.input().mesh, m_triangulation ? &*m_triangulation : nullptr);
    Triangulation result = mended(m_triangulation ? *m_triangulation : make_triangulation(m_run));
    m_points = m_fine->points();
    m_weights.for_each_function([&](std::vector<double>& f) { m_fine->extend(f, 0.); });
    return result;
  }

  Triangulation mended(const Triangulation& start)
  {
    if(m_options.closed_length <= 0 && m_options.pinched_length <= 0)
      return start;
    IS::Surface_surgery surgery(start);
    Statistics& s = m_run.statistics();
    s["closed_loops"] = 0;
    s["pinched_handles"] = 0;
    if(m_options.closed_length > 0)
      s["closed_loops"] = IS::close_boundary_loops(surgery, m_options.closed_length);
    if(m_options.pinched_length > 0)
      s["pinched_handles"] = IS::pinch_handles(surgery, m_options.pinched_length);
    const IT::Topological_type before = IT::topological_type(start.mesh()),
                               after = IT::topological_type(surgery.mesh());
    s["boundary_loops_before"] = before.boundary_loops;
    s["boundary_loops_after"] = after.boundary_loops;
    s["genus_before"] = before.genus;
    s["genus_after"] = after.genus;
    s["filled_area"] = surgery.filled_area();
    m_fine->add_vertices(surgery);
    return surgery.triangulation();
  }

  void make_exactly_Delaunay(IS::Evolving_surface& surface, Triangulation& start)
  {
    m_run.timed("flip", [&] { surface.make_exactly_Delaunay(start); });
    certify(m_run, start);
  }

  std::size_t number_of_isolated_vertices()
  {
    const Mesh& mesh = m_run.input().mesh;
    return static_cast<std::size_t>(
      std::count_if(mesh.vertices().begin(), mesh.vertices().end(),
                    [&](Mesh::Vertex_index v) { return mesh.is_isolated(v); }));
  }

  // Returns how many vertices are to remain on a level, including vertices without faces. Returns
  // zero if the target is not a number.
  std::size_t target(std::size_t level)
  {
    if(m_options.maximum_cost)
      return 0;
    const std::size_t isolated = number_of_isolated_vertices();
    const double all = double(m_run.input().mesh.number_of_vertices() - isolated);
    const double first = double(m_levels[0].mesh().number_of_vertices() - isolated);
    const double last = (std::min)(first, m_options.ratio ? std::ceil(*m_options.ratio * all)
                                                          : double(*m_options.number_of_vertices));
    if(level == m_options.number_of_levels)
      return isolated + static_cast<std::size_t>(last);
    const double part = double(level) / double(m_options.number_of_levels);
    return isolated + static_cast<std::size_t>(std::ceil(first * std::pow(last / first, part)));
  }

  void simplify(IS::Evolving_surface& surface)
  {
    if(m_triangulation || m_weights.has_functions()) // thin faces are no measure
      surface.make_Delaunay();
    IS::Transport_cost cost = m_weights.cost(surface);
    IS::Simplification_result result;
    std::size_t removed = 0;
    double greatest_cost = 0;
    for(std::size_t level = 1; level <= m_options.number_of_levels; ++level) {
      result = simplified(surface, cost, target(level));
      removed += result.removed;
      greatest_cost = (std::max)(greatest_cost, result.greatest_cost);
      m_levels.emplace_back(surface);
    }
    result.removed = removed;
    result.greatest_cost = greatest_cost;
    describe_removals(result, surface);
  }

  IS::Simplification_result simplified(IS::Evolving_surface& surface, IS::Transport_cost& cost,
                                       std::size_t number_of_vertices)
  {
    Step_counter counter{m_run.progress()};
    const auto np =
      IS::parameters::number_of_vertices(number_of_vertices).visitor(std::ref(counter));
    if(m_options.maximum_cost)
      return IS::simplify(surface, cost, np.maximum_cost(*m_options.maximum_cost));
    return IS::simplify(surface, cost, np);
  }

  void describe_removals(const IS::Simplification_result& result,
                         const IS::Evolving_surface& surface)
  {
    Statistics& statistics = m_run.statistics();
    const bool is_reached = m_options.maximum_cost || surface.mesh().number_of_vertices() <=
                                                        target(m_options.number_of_levels);
    statistics["coarse_vertices"] = surface.mesh().number_of_vertices();
    statistics["coarse_faces"] = surface.mesh().number_of_faces();
    statistics["removed"] = result.removed;
    statistics["status"] = is_reached ? "reached" : "nothing_removable";
    statistics["greatest_cost"] = result.greatest_cost;
    statistics["weights"] = m_weights.values();
    for(std::size_t s = 1; s < result.skipped.size(); ++s)
      statistics["skipped"][removal_names[s]] = result.skipped[s];
    statistics["operations"] = surface.history().size();
  }

  // Refines the last level, and describes its vertices again.
  void refine_coarse(IS::Evolving_surface& surface)
  {
    Refinement_bounds bounds = m_options.refinement;
    bounds.minimum_angle = m_options.coarse_minimum_angle;
    const IT::Refinement_result result =
      IS::refine(surface, IS::parameters::minimum_angle(bounds.minimum_angle)
                            .maximum_number_of_insertions(maximum_number_of_insertions(
                              bounds, surface.mesh().number_of_faces())));
    m_levels.back() = IS::Surface_level(surface);
    Statistics& statistics = m_run.statistics();
    statistics["coarse_inserted_vertices"] = result.insertions - result.removals;
    statistics["coarse_faces_below_bound"] = result.remaining.size();
    statistics["coarse_faces_excused"] =
      std::count_if(result.remaining.begin(), result.remaining.end(), IT::is_excused);
    statistics["coarse_refinement_status"] = IT::to_string(result.status);
    statistics["coarse_vertices"] = surface.mesh().number_of_vertices();
    statistics["coarse_faces"] = surface.mesh().number_of_faces();
    statistics["operations"] = surface.history().size();
  }

  void describe_levels()
  {
    Statistics& statistics = m_run.statistics();
    const IS::Surface_level& coarse = m_levels.back();
    statistics["area_ratio"] = area(coarse) / area(m_levels[0]);
    statistics["min_angle_degrees"] =
      IT::smallest_angle_in_degrees(coarse.mesh(), coarse.length_map());
    for(std::size_t n = 1; n < m_levels.size() && m_levels.size() > 2; ++n)
      statistics["level_vertices"].push_back(m_levels[n].mesh().number_of_vertices());
  }

  Output_mesh common_mesh(const IS::Surface_history& history)
  {
    const IS::Surface_map map(history, m_levels[0], m_levels.back());
    Coarse_subdivision subdivision(map);
    set_points(subdivision);
    m_run.show([&](View_page&) {
      set_curvature(subdivision);
      set_area_change(subdivision);
    });
    const Mesh& mesh = subdivision.mesh();
    describe_subdivision(m_run.statistics(), mesh.number_of_vertices(), mesh.number_of_edges(),
                         mesh.number_of_faces());
    Output_mesh result = coarse_mesh(subdivision, *m_fine);
    if(!m_run.input().data.empty())
      m_data = data_of_coarse_mesh(fine_data(), result);
    return result;
  }

  // Returns the data of the input on the fine level.
  Triangle_data fine_data() const
  {
    const IS::Delta_complex& fine = m_levels[0].mesh();
    return m_fine->data(m_run.input(), polygons_of(fine, fine.faces()));
  }

  // Adds the coarse triangulation in space, with the indices of its vertices in the input.
  void add_coarse_mesh(const IS::Evolving_surface& surface)
  {
    Mesh mesh;
    const auto fine_vertex =
      mesh.add_property_map<Mesh::Vertex_index, IS::Vertex_index>("v:fine_vertex").first;
    const auto location =
      mesh.add_property_map<Mesh::Vertex_index, IS::Surface_map::Location>("v:location").first;
    const auto points =
      boost::make_iterator_property_map(m_points.cbegin(), get(boost::vertex_index, mesh));
    describe(IS::coarse_mesh(surface, m_levels[0], mesh,
                             IS::parameters::input_point_map(points)
                               .parent_vertex_map(fine_vertex)
                               .location_map(location)),
             mesh);
    Output_mesh result = output_mesh_with_edges(mesh, {mesh.faces().begin(), mesh.faces().end()});
    result.point_data.emplace_back("input_vertex", result.points.size(), [&](std::size_t i) {
      const IS::Vertex_index v = fine_vertex[Mesh::Vertex_index(static_cast<Mesh::size_type>(i))];
      return number_of(
        v.is_valid() && v.idx() < m_run.input().mesh.number_of_vertices() ? v : IS::Vertex_index());
    });
    result.placement = {result.points.size(),
                        [&](std::size_t i) {
                          const Mesh::Vertex_index v(static_cast<Mesh::size_type>(i));
                          return weights(fine_vertex[v], location[v]);
                        },
                        [](std::size_t, std::size_t) { return Mesh::Face_index(); }};
    add_functions(result);
    m_run.add_output(m_options.coarse_mesh, result, m_coarse_format);
  }

  // Returns the weights of vertices of the fine level for a vertex of the coarse mesh.
  Placement::Weights weights(IS::Vertex_index fine_vertex, const IS::Surface_map::Location& p) const
  {
    return fine_vertex.is_valid()
             ? Placement::Weights{1, {fine_vertex}, {1}}
             : IT::vertex_weights(IT::Surface_point<double>(p), m_levels[0].mesh());
  }

  // Adds the functions of the input to the coarse mesh. Its faces cross seams and groups.
  void add_functions(Output_mesh& mesh) const
  {
    if(m_run.input().data.functions.empty())
      return;
    Triangle_data data = fine_data();
    data.corners.clear();
    data.groups = {};
    add_data(mesh, data_of_coarse_mesh(data, mesh));
  }

  void describe(const IS::Coarse_mesh_quality& quality, const Mesh& mesh)
  {
    Statistics& statistics = m_run.statistics()["coarse_mesh"];
    statistics["vertices"] = mesh.number_of_vertices();
    statistics["faces"] = mesh.number_of_faces();
    statistics["inserted_vertices"] = quality.inserted_vertices;
    statistics["distance_to_coarse"] = quality.distance_to_coarse;
    statistics["distance_to_fine"] = quality.distance_to_fine;
    statistics["flipped_faces"] = quality.flipped_faces;
    statistics["degenerate_faces"] = quality.degenerate_faces;
    statistics["self_intersections"] = quality.self_intersections;
  }

  static void describe_coarse_mesh(const Statistics& s, std::ostream& text)
  {
    const double deviation =
      (std::max)(s["distance_to_coarse"].get<double>(), s["distance_to_fine"].get<double>());
    text << ", coarse mesh: " << s["inserted_vertices"] << " vertices inserted, deviation "
         << deviation << ", " << s["flipped_faces"] << " faces flipped, " << s["degenerate_faces"]
         << " without area, " << s["self_intersections"] << " pairs intersect";
  }

  void show(View_page& page, Output_mesh mesh)
  {
    mesh.lines = Polygons(); // they are edges, too
    mesh.line_data.clear();
    if(!m_curvature.empty())
      mesh.point_data.push_back({"curvature", m_curvature});
    mesh.polygon_data.push_back({"area_change", m_area_change});
    add_data(mesh, m_data);
    page.add_surface("surface", mesh);
    show_angles(page, "input", m_run.input().mesh, edge_lengths(m_run));
    show_angles(page, "coarse", m_levels.back().mesh(), m_levels.back().length_map());
  }

  // Sets the curvature of the input at the vertices of the subdivision, if the fine level is the
  // input.
  void set_curvature(const Coarse_subdivision& subdivision)
  {
    if(!m_fine->is_input())
      return;
    const std::vector<double> values = curvatures(m_run);
    m_curvature.resize(subdivision.mesh().number_of_vertices());
    IT::interpolate(IS::Level::fine, subdivision,
                    boost::make_iterator_property_map(values.begin(),
                                                      get(boost::vertex_index, m_levels[0].mesh())),
                    boost::make_iterator_property_map(
                      m_curvature.begin(), get(boost::vertex_index, subdivision.mesh())));
  }

  // Sets the logarithms of the quotients of areas on both levels, for polygons that have an area.
  void set_area_change(const Coarse_subdivision& subdivision)
  {
    const Mesh& mesh = subdivision.mesh();
    for(const Mesh::Face_index f : mesh.faces())
      if(mesh.degree(f) > 2) {
        const double fine = subdivision.signed_area(IS::Level::fine, f);
        const double coarse = subdivision.signed_area(IS::Level::coarse, f);
        m_area_change.push_back(fine > 0 && coarse > 0 ? std::log(coarse / fine)
                                                       : std::numeric_limits<double>::quiet_NaN());
      }
  }

  // Sets the positions of the vertices of the subdivision in space.
  void set_points(Coarse_subdivision& subdivision)
  {
    for(const Mesh::Vertex_index v : subdivision.mesh().vertices())
      subdivision.mesh().point(v) =
        subdivision.is_vertex(IS::Level::fine, v)
          ? m_points[v]
          : point_at(IT::face_location(subdivision.place(IS::Level::fine, v),
                                       subdivision.mesh(IS::Level::fine)));
  }

  Point point_at(const IT::Face_location<double>& p) const
  {
    const IS::Delta_complex& mesh = m_levels[0].mesh();
    const IT::Halfedge_index h = mesh.halfedge(p.first);
    return CGAL::barycenter(m_points[mesh.source(h)], p.second[0], m_points[mesh.target(h)],
                            p.second[1], m_points[mesh.target(mesh.next(h))], p.second[2]);
  }

  // Returns the matrices, or nothing if they are not requested.
  std::vector<std::string> prolongations(const IS::Surface_history& history)
  {
    std::vector<std::string> result;
    for(std::size_t n = 1; n < m_levels.size() && !m_options.prolongation.empty(); ++n) {
      const IS::Surface_map map(history, m_levels[n - 1], m_levels[n]);
      Eigen::SparseMatrix<double, Eigen::RowMajor> matrix = IS::prolongation_matrix(
        map, IS::parameters::concurrency_tag(CGAL::Parallel_if_available_tag()));
      if(n == 1) // without vertices that have been inserted
        matrix.conservativeResize(
          static_cast<Eigen::Index>(m_run.input().mesh.number_of_vertices()), matrix.cols());
      result.push_back(
        matrix_market(Eigen::SparseMatrix<double>(matrix), Matrix_symmetry::GENERAL, meaning(n)));
    }
    return result;
  }

  // Describes the vertices of the rows and columns of a matrix.
  std::string meaning(std::size_t level) const
  {
    const auto vertices = [&](std::size_t n) {
      if(n > 0)
        return "the vertices of level " + std::to_string(n);
      return std::string(m_triangulation ? "the vertices of the mesh, without those inserted"
                                         : "the vertices of the mesh");
    };
    return "rows: " + vertices(level - 1) + "\ncolumns: " + vertices(level);
  }

  void save(const IS::Surface_history& history)
  {
    if(m_run.options().save.empty())
      return;
    std::vector<const IS::Surface_level*> levels;
    for(const IS::Surface_level& level : m_levels)
      levels.push_back(&level);
    std::ostringstream text;
    if(m_triangulation)
      IT::write_intrinsic_triangulation(text, *m_triangulation);
    IS::write_surface_hierarchy(text, history, levels);
    m_run.add_output(m_run.options().save, text.str());
  }

  // Warns if a refinement has stopped at its greatest number of insertions.
  void warn_of_limits()
  {
    warn_of_limit("--refine", m_options.refinement.minimum_angle, "refinement_status",
                  "faces_below_bound");
    warn_of_limit("--min-angle", m_options.coarse_minimum_angle, "coarse_refinement_status",
                  "coarse_faces_below_bound");
  }

  void warn_of_limit(const char* option, double angle, const char* status, const char* faces)
  {
    const Statistics& s = m_run.statistics();
    if(m_run.options().is_quiet || !s.contains(status) ||
       s[status] != to_string(IT::Refinement_status::insertion_limit))
      return;
    m_run.progress().clear();
    std::cerr << m_run.options().input << ": warning: " << option << ' ' << angle
              << " is not reached: " << s[faces]
              << " faces have smaller angles; lower the angle, or raise --max-insertions\n";
  }

  std::string summary()
  {
    const Statistics& s = m_run.statistics();
    std::ostringstream text;
    const auto inserted = s.value("coarse_inserted_vertices", std::size_t(0));
    text << s["vertices"] << " -> " << s["coarse_vertices"].get<std::size_t>() - inserted
         << " vertices (" << s["status"].get<std::string>() << ')';
    if(s.contains("coarse_refinement_status"))
      text << " -> " << s["coarse_vertices"] << " with --min-angle ("
           << s["coarse_refinement_status"].get<std::string>() << ')';
    text << ", area times " << s["area_ratio"].get<double>() << ", smallest angle "
         << m_run.input().diagnosis.statistics().min_angle << " -> "
         << s["min_angle_degrees"].get<double>() << " degrees";
    if(!m_options.weights.empty())
      for(const auto& [name, value] : m_weights.values())
        text << ", weight " << name << '=' << value;
    if(s.contains("coarse_mesh"))
      describe_coarse_mesh(s["coarse_mesh"], text);
    return text.str();
  }

  const Simplify_options& m_options;
  Cost_weights m_weights;
  Mesh_format m_format, m_coarse_format;
  Command_run m_run;
  std::optional<Triangulation> m_triangulation; // the refined one, then the input with its vertices
  std::vector<Point> m_points;                  // of the vertices of the fine level
  std::optional<Fine_level> m_fine;             // and how it came from the input
  Mesh_data m_data;                             // of the output
  std::vector<double> m_curvature;              // at the vertices of the subdivision, for a page
  std::vector<double> m_area_change;            // of its polygons, for a page
  std::vector<IS::Surface_level> m_levels;      // from the fine one to the coarse one
};

void add_target(CLI::App& command, Simplify_options& options)
{
  CLI::App& target = *command.add_option_group("Target", "Give one of these");
  target.add_option("--vertices", options.number_of_vertices, "Number of remaining vertices")
    ->transform(integer_from(1));
  add_number(target, "--ratio", options.ratio, "Fraction of remaining vertices",
             number_from_to(1e-9, 1.));
  add_number(target, "--error", options.maximum_cost, "Greatest cost of a removal, a length",
             nonnegative_number());
  target.require_option(1);
}

void add_simplify_outputs(CLI::App& command, Simplify_options& options, Common_options& common)
{
  add_output(command, options,
             "Common subdivision with the coarse triangulation (.off, .obj, .ply, .vtp",
             "off, obj, ply or vtp");
  command.get_option("--output")->required(false); // or --coarse
  command.add_option(
    "--coarse", options.coarse_mesh,
    "The coarse triangulation as an ordinary mesh in space (.off, .obj, .ply, .vtp)");
  command.add_option("--prolongation", options.prolongation,
                     "Matrix Market file: from coarse vertices to vertices of the mesh");
  command.add_option("--save", common.save, "File for the levels and the operations between them");
}

void add_topology(CLI::App& command, Simplify_options& own)
{
  add_number(command, "--close-loops", own.closed_length,
             "First close boundary loops up to this length by disks", nonnegative_number());
  add_number(command, "--pinch-handles", own.pinched_length,
             "First cut handles along closed curves of edges up to this length, and close both "
             "sides by disks",
             nonnegative_number());
}

} // namespace

void define_simplify(Command_line& line)
{
  const auto [command, options] =
    line.add_with_mesh("simplify", "Remove vertices, with a map between both surfaces",
                       attempted<Simplify_command, Simplify_options>, simplify_help);
  add_simplify_outputs(command, options, line.common());
  add_target(command, options);
  command
    .add_option(
      "--weight", options.weights,
      "NAME=W: the weight of curvature, area, area_change, boundary_change, color or a property of "
      "vertices in the cost. Other weights are zero. Without --weight, curvature=1, area=2, "
      "area_change=6 and boundary_change=12")
    ->allow_extra_args(false);
  command
    .add_option("--levels", options.number_of_levels,
                "Number of levels, each smaller by the same factor; the last is the coarse one")
    ->transform(integer_from_to(1, 100))
    ->capture_default_str();
  add_number(command, "--refine", options.refinement.minimum_angle,
             "Refine to this angle in degrees first: coarse parts get vertices to choose from; 0, "
             "the default, inserts none",
             number_from_to(0., 30.));
  add_minimum_angle(command, options.coarse_minimum_angle,
                    "Insert vertices into the coarse triangulation until all its angles have this "
                    "many degrees, see `intrinsic refine`; 0, the default, inserts none");
  add_maximum_number_of_insertions(command, options.refinement);
  add_topology(command, options);
  add_common_options(command, line.common());
  add_exact(command, line.common(),
            "Decide exactly about the intrinsic Delaunay triangulation from which vertices are "
            "removed, and about --refine, and certify it");
}
