// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands/Command_line.h"

#include "Program_error.h"
#include "commands/Command_run.h"
#include "commands/attempts.h"
#include "commands/triangulation_stages.h"
#include "writing/Mesh_writer.h"

#include <CGAL/Intrinsic_triangulations/diagnose.h>
#include <CGAL/Intrinsic_triangulations/extrinsic_mesh.h>
#include <CGAL/Intrinsic_triangulations/is_simplicial.h>

#include <CGAL/Polygon_mesh_processing/measure.h>

#include <cstddef>
#include <sstream>
#include <string>

namespace IT = CGAL::Intrinsic_triangulations;

namespace {

struct Refine_options : Subdivision_options
{
  Refine_options() { bounds.minimum_angle = 25; }

  Refinement_bounds bounds;
};

constexpr const char* refine_help =
  R"(The result is Delaunay, and is written with exit code 0 for every status. With --simplicial,
nothing is written, with exit code 2, if loops or edges with the same ends remain. The statistics
and the last line on standard error have the status:
  bounds_met              every face obeys the bounds
  bounds_met_but_excused  small-angle vertices excuse all faces that violate the bound on angles
  insertion_limit         --max-insertions was reached, and some faces violate the bounds. Lower
                          --min-angle, or raise --max-insertions
  no_room                 rounding prevents vertices that the bounds need. Lower --min-angle, or
                          accept the faces

Refinement to at most 30 degrees is proven to terminate in exact arithmetic, on closed meshes
without small-angle vertices and constrained edges. With boundary this is an open question;
25 degrees were reached on all meshes of CGAL. Beyond 30 degrees it need not terminate, so the
default of --max-insertions is smaller.

If rounded lengths do not suffice, refinement restarts with exact decisions. The last line and
"exact_decisions" in the statistics report this. With --exact, decisions are exact from the
beginning, and the result is certified. The statistics then have these keys:
  certified  whether the triangulation is geodesic and exactly Delaunay
  ties       number of edges whose flip is Delaunay too
  undecided  number of edges and vertices whose decision involves more than twelve independent
             square roots
  decisions  number of decisions at each stage
  non_delaunay_edges  number of edges that are not Delaunay
A result that is not certified is written too; the last line reports it.

Vertices of the output have the property "kind" in .ply and .vtp. It is 0 for an input vertex, 1 for
a crossing of an input edge with an intrinsic edge, and 2 for an inserted vertex.

With --simplicial, the output is an ordinary mesh for other programs. Its vertices lie on the
surface, and its edges are straight in space. The property "length" of an edge is its length on the
surface. Seams of a texture stay edges, unless the output is .off. Flat faces have other areas and
angles than faces on the surface: the last line and "flat_faces" in the statistics state them.

Examples:
  intrinsic refine scan.ply -o mesh.ply --simplicial
  intrinsic refine scan.ply -o refined.vtp --min-angle 25 --stats refined.json)";

std::string summary_of_refinement(Command_run& run)
{
  const Statistics& s = run.statistics();
  std::ostringstream text;
  text << summary_of_changes(run) << ", " << s["faces_below_bound"] << " faces below the bound, "
       << s["faces_excused"] << " of them excused, " << s["subdivision"]["faces"]
       << " faces in the common subdivision";
  if(s.contains("flat_faces"))
    text << ", written as " << s["flat_faces"]["faces"] << " flat faces with area times "
         << s["flat_faces"]["area_ratio"].get<double>() << " and smallest angle "
         << s["flat_faces"]["min_angle_degrees"].get<double>() << " degrees";
  return text.str();
}

Surface_marks
faces_below_bounds(const CGAL::Intrinsic_triangulations::Refinement_result& refinement,
                   const Output_mesh& mesh)
{
  std::vector<std::int64_t> faces;
  for(const auto& remaining : refinement.remaining)
    faces.push_back(number_of(remaining.face));
  return {"faces below the bounds", true, parts_of(faces, "intrinsic_face", mesh), {}, {}};
}

// Returns the data of corners from the input face at each corner, counterclockwise. No face crosses
// a seam.
Placement placement_of(const Triangulation& triangulation)
{
  typedef Mesh::size_type Size;
  const IT::Delta_complex& own = triangulation.mesh();
  const auto weights = [&](std::size_t i) -> Placement::Weights {
    const IT::Vertex_index v(static_cast<Size>(i));
    if(!triangulation.is_inserted(v))
      return {1, {v}, {1}};
    return IT::vertex_weights(triangulation.inserted_vertex(v), triangulation.input_mesh());
  };
  const auto face = [&](std::size_t i, std::size_t k) {
    const auto side = IT::sides(IT::Face_index(static_cast<Size>(i)), own);
    return triangulation.input_location(side[k]).first;
  };
  return {own.number_of_vertices(), weights, face};
}

// Describes faces that are flat in space. Their edges are chords of intrinsic edges, so areas and
// angles differ. `area` is the area of the surface.
void describe_flat_faces(Command_run& run, const Mesh& mesh, double area)
{
  const auto flat = IT::diagnose(mesh).statistics();
  run.statistics()["flat_faces"] = {
    {"vertices", flat.vertices},
    {"edges", flat.edges},
    {"faces", flat.faces},
    {"min_angle_degrees", flat.min_angle},
    {"area_ratio", CGAL::Polygon_mesh_processing::area(mesh) / area}};
}

// Returns the faces of the triangulation itself, flat in space.
Output_mesh own_faces(const Triangulation& triangulation, const Mesh& mesh, const Input_mesh& input)
{
  Output_mesh result = output_mesh_with_edges(mesh, {mesh.faces().begin(), mesh.faces().end()});
  result.point_data.emplace_back("kind", result.points.size(), [&](std::size_t i) {
    const IT::Vertex_index v(static_cast<Mesh::size_type>(i));
    return std::int64_t(triangulation.is_inserted(v) ? Vertex_kind::inserted : Vertex_kind::input);
  });
  result.edge_data.emplace_back("length", result.edges.size(), [&](std::size_t i) {
    return triangulation.length(IT::Edge_index(static_cast<Mesh::size_type>(i)));
  });
  result.placement = placement_of(triangulation);
  add_input_data(input, result);
  return result;
}

void check_simplicial(const Triangulation& triangulation, std::size_t insertions)
{
  const IT::Delta_complex& mesh = triangulation.mesh();
  for(const IT::Face_index f : mesh.faces())
    if(!IT::is_simplicial(f, mesh))
      throw Program_error("the triangulation is not simplicial after the greatest allowed number "
                          "of insertions, " +
                          std::to_string(insertions) + "; allow more by --max-insertions");
}

int write_refinement(Command_run& run, const Refine_options& options, Mesh_format format)
{
  const bool have_seams = options.bounds.is_simplicial && has_texture(format);
  Triangulation triangulation =
    make_delaunay_triangulation(run, {options.constrained_angle, have_seams});
  const double area = CGAL::Polygon_mesh_processing::area(run.input().mesh);
  run.keep_points_only();
  const auto refinement = refine_triangulation(run, triangulation, options.bounds);
  if(options.bounds.is_simplicial && refinement.status == IT::Refinement_status::insertion_limit)
    check_simplicial(triangulation, refinement.insertions);
  describe(run, triangulation);
  const Subdivision subdivision = subdivide(run, triangulation);
  run.timed("write", [&] {
    Output_mesh mesh = subdivision_mesh(subdivision);
    run.show([&](View_page& page) {
      show(page, run, triangulation, subdivision, mesh);
      page.add_marks(faces_below_bounds(refinement, mesh));
    });
    if(options.bounds.is_simplicial) {
      const Mesh flat = IT::extrinsic_mesh(triangulation, run.input().mesh.points());
      describe_flat_faces(run, flat, area);
      mesh = own_faces(triangulation, flat, run.input());
    } else
      add_input_data(run.input(), mesh);
    run.add_output(options.output, mesh, format);
    save(run, triangulation);
  });
  run.finish(summary_of_refinement(run));
  return 0;
}

void add_bounds(CLI::App& command, Refinement_bounds& bounds)
{
  add_minimum_angle(command, bounds.minimum_angle,
                    "Least angle of the faces in degrees, 0 for no bound")
    ->capture_default_str();
  add_number(command, "--max-circumradius", bounds.maximum_circumradius,
             "Greatest circumradius of the faces; no bound if not given", positive_number());
  add_maximum_number_of_insertions(command, bounds, ". With --max-circumradius, it is 10,000,000");
}

int refine(const Common_options& common, const Refine_options& options)
{
  check_insertions(options.bounds);
  const Mesh_format format = output_format(options.output, options);
  Command_run run("refine", common, {options.output});
  run.plan({delaunay_stages, {"refine"}, certificate_stages(common), subdivision_stages});
  return attempt(run, [&] { return write_refinement(run, options, format); });
}

} // namespace

void define_refine(Command_line& line)
{
  const auto [command, options] =
    line.add_with_mesh("refine", "Insert vertices until all faces obey bounds on angles and sizes",
                       refine, refine_help);
  add_subdivision_options(command, options, line.common());
  add_bounds(command, options.bounds);
  command.add_flag(
    "--simplicial", options.bounds.is_simplicial,
    "Insert vertices until no edge is a loop and no two have the same ends. Write the "
    "triangulation itself, with faces flat in space, instead of the subdivision");
  add_exact(command, line.common(),
            "Decide exactly about edges and inserted vertices, and certify the triangulation");
}
