// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands/Command_line.h"

#include "Program_error.h"
#include "commands/Command_run.h"
#include "commands/number_ranges.h"
#include "commands/triangulation_stages.h"
#include "reading/glued_sides.h"
#include "writing/Mesh_writer.h"
#include "writing/subdivision_mesh.h"

#include <CGAL/Intrinsic_triangulations/convex_polyhedron.h>
#include <CGAL/Intrinsic_triangulations/glue_boundary.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;

namespace {

struct Convex_options : Output_options
{
  Convex_options() : Output_options("off") {}

  std::string sides;              // a file of glued sides; empty if the mesh is closed
  std::string subdivision;        // empty if not wanted
  std::optional<double> flatness; // the curvature up to which vertices are flat
};

constexpr const char* convex_help =
  R"(The mesh must be a sphere without vertices of negative curvature; it need not be convex.
Exactly one convex polyhedron has its surface. It may be a polygon with two sides: "flat" in the
statistics.

The output has the vertices of the mesh, in their order. Vertices without curvature lie on faces and
edges of the polyhedron. Convexity is decided exactly for the written positions, without flat
vertices. "kind" in the statistics is "convex", "polygon", or "convex_before_rounding" if only
rounding makes edges concave. --subdivision writes the common subdivision of the mesh and the
polyhedron, on the polyhedron. Its vertices have their positions on the mesh in .ply and .vtp
(input_x, input_y, input_z). Its edges and faces have the edge or face of both that contains them.

With --glue, the mesh is a net: one or more polygons whose sides are glued. Each line of the file
has four vertices, a b c d. It glues the side from a to b to the side from c to d, a to c and b to
d. Words after # are comments.

Glued vertices become one vertex. "vertex_map" in the statistics has its index, for each vertex of
the net.

Examples:
  intrinsic convex dented.off -o convex.off
  intrinsic convex cross.off --glue cross.txt -o folded.off --stats folded.json)";

Output_mesh described_mesh(const IT::Convex_polyhedron& polyhedron)
{
  Output_mesh result = output_mesh(polyhedron.mesh());
  std::vector<std::int64_t> is_flat(result.points.size(), 0);
  for(const IT::Vertex_index v : polyhedron.flat_vertices())
    is_flat[v.idx()] = 1;
  result.point_data.push_back({"is_flat", is_flat});
  return result;
}

void describe(Statistics& statistics, const IT::Convex_polyhedron& polyhedron)
{
  const IT::Polyhedron_certificate& certificate = polyhedron.certificate();
  statistics["polyhedron"] = {{"vertices", polyhedron.points().size()},
                              {"faces", polyhedron.triangulation().mesh().number_of_faces()}};
  statistics["flat_vertices"] = polyhedron.flat_vertices().size();
  statistics["kind"] = IT::to_string(polyhedron.kind());
  statistics["flat"] = polyhedron.is_flat();
  statistics["convex"] = certificate.is_convex();
  statistics["convex_edges"] = certificate.convex_edges;
  statistics["flat_edges"] = certificate.flat_edges;
  statistics["concave_edges"] = certificate.concave_edges;
  statistics["max_edge_error"] = polyhedron.max_edge_error();
  statistics["last_curvature"] = polyhedron.last_curvature();
  statistics["iterations"] = polyhedron.newton_steps();
}

std::string summary(const IT::Convex_polyhedron& polyhedron)
{
  std::ostringstream text;
  const std::size_t flat = polyhedron.flat_vertices().size(), all = polyhedron.points().size();
  text << (polyhedron.is_flat() ? "polygon with two sides, " : "convex polyhedron, ") << all - flat
       << " vertices";
  if(flat > 0)
    text << " and " << flat << " on faces and edges";
  text << ", edges equal to " << polyhedron.max_edge_error();
  if(polyhedron.kind() == IT::Polyhedron_kind::convex_before_rounding)
    text << ", convex before rounding, which makes " << polyhedron.certificate().concave_edges
         << " edges concave";
  return text.str();
}

template <class Surface, class Parameters>
IT::Convex_polyhedron polyhedron_of(const Surface& surface, const Parameters& np,
                                    std::optional<double> flatness)
{
  return flatness ? IT::convex_polyhedron(surface, np.curvature_tolerance(*flatness))
                  : IT::convex_polyhedron(surface, np);
}

// Returns the surface of a net whose sides are glued.
IT::Glued_surface glued(Command_run& run, const std::string& path)
{
  const Mesh& mesh = run.input().mesh;
  const Edge_length_map length = edge_lengths(run);
  const auto sides = read_glued_sides(path, mesh, length);
  double difference = 0;
  for(const auto& [h, o] : sides)
    difference = (std::max)(difference, std::abs(length[mesh.edge(h)] - length[mesh.edge(o)]));
  run.statistics()["max_side_difference"] = difference;
  IT::Glued_surface result = IT::glue_boundary(mesh, length, sides);
  std::vector<std::int64_t> numbers;
  for(const IT::Vertex_index v : result.vertices)
    numbers.push_back(number_of(v));
  run.statistics()["vertex_map"] = numbers;
  return result;
}

// Returns the surface of the net, or nothing if the mesh is closed.
std::optional<IT::Glued_surface> net_of(Command_run& run, const Convex_options& options)
{
  if(!options.sides.empty())
    return glued(run, options.sides);
  if(!CGAL::is_closed(run.input().mesh))
    throw Program_error(run.options().input +
                        ": has a boundary; if it is a net, --glue names the sides to glue");
  return std::nullopt;
}

// Returns the common subdivision on the polyhedron, with the positions of its vertices on the
// input.
Output_mesh subdivision_on(const IT::Convex_polyhedron& polyhedron, const Subdivision& subdivision)
{
  Output_mesh result = subdivision_mesh(subdivision);
  result.keep();
  std::array<std::vector<double>, 3> position;
  const char* names[] = {"input_x", "input_y", "input_z"};
  for(int x = 0; x < 3; ++x) {
    std::vector<double> values, before;
    for(const Point& p : polyhedron.points())
      values.push_back(p[x]);
    for(const Point& p : result.points)
      before.push_back(p[x]);
    position[static_cast<std::size_t>(x)] = interpolated(IT::Side::intrinsic, values, subdivision);
    result.point_data.push_back({names[x], before});
  }
  for(std::size_t i = 0; i < result.points.size(); ++i)
    result.points[i] = Point(position[0][i], position[1][i], position[2][i]);
  return result;
}

int convex(const Common_options& common, const Convex_options& options)
{
  const Mesh_format format = output_format(options.output, options);
  if(!options.sides.empty() && !options.subdivision.empty())
    throw Program_error("--subdivision: a net has no positions in space; leave out --glue");
  const std::optional<Mesh_format> subdivision_format =
    options.subdivision.empty()
      ? std::nullopt
      : std::optional<Mesh_format>(output_format(options.subdivision, options));
  Command_run run("convex", common, {options.output, options.subdivision});
  run.refuse_isolated_vertices();
  run.plan({{"build", "fold"}, subdivision_format ? subdivision_stages : Stages{}});
  std::optional<IT::Glued_surface> net = run.timed("build", [&] { return net_of(run, options); });
  const IT::Convex_polyhedron polyhedron = run.timed("fold", [&] {
    if(net)
      return polyhedron_of(
        net->mesh, IT::parameters::edge_length_map(IT::stored_length_map<double>(net->mesh)),
        options.flatness);
    return polyhedron_of(run.input().mesh, IT::parameters::mollification(mollification(run)),
                         options.flatness);
  });
  describe(run.statistics(), polyhedron);
  if(subdivision_format) {
    const Subdivision subdivision = subdivide(run, polyhedron.triangulation());
    run.add_output(options.subdivision, subdivision_on(polyhedron, subdivision),
                   *subdivision_format);
  }
  run.timed("write", [&] {
    run.add_output(options.output, described_mesh(polyhedron), format);
    save(run, polyhedron.triangulation());
  });
  run.finish(summary(polyhedron));
  return 0;
}

} // namespace

void define_convex(Command_line& line)
{
  const auto [command, options] = line.add_with_mesh(
    "convex", "Find the convex polyhedron with the surface of a mesh, or fold a net to it", convex,
    convex_help);
  add_output(command, options, "The polyhedron (.off, .obj, .ply, .vtp", "off, obj, ply or vtp");
  add_read_file(command, line.common(), "--glue", options.sides,
                "Text file of the sides of a net that are glued");
  command.add_option("--subdivision", options.subdivision,
                     "File for the common subdivision on the polyhedron");
  command
    .add_option("--flat", options.flatness,
                "Curvature in radians up to which vertices count as flat; by default the rounding "
                "error")
    ->transform(number_from_to(0., 1.));
  add_save(command, line.common());
  add_statistics(command, line.common());
  add_mollification(command, line.common());
  add_repair(command, line.common());
}
