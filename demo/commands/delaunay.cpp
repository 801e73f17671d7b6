// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands/Command_line.h"

#include "commands/Command_run.h"
#include "commands/attempts.h"
#include "commands/triangulation_stages.h"
#include "reading/vertex_values.h"

namespace {

constexpr const char* delaunay_help =
  R"(With --weights, the triangulation is weighted Delaunay. Weights are squared lengths, such as
squared radii of circles at the vertices; lines of a file are "index weight", other weights are
zero. The statistics list the vertices that others hide.

Examples:
  intrinsic delaunay bunny.obj -o subdivision.vtp --constrain-angle 40
  intrinsic delaunay bunny.obj -o subdivision.ply --picture near.svg --section 17 0.05
  intrinsic delaunay disks.ply -o subdivision.vtp --weights squared_radius)";

std::string summary_of_flips(Command_run& run)
{
  const Statistics& s = run.statistics();
  const std::size_t hidden = s.contains("hidden_vertices") ? s["hidden_vertices"].size() : 0;
  return summary_of_changes(run) + ", " +
         (hidden > 0 ? std::to_string(hidden) + " hidden vertices, " : "") + s["crossings"].dump() +
         " crossings, " + s["subdivision"]["faces"].dump() + " faces in the common subdivision";
}

// Returns the triangulation after flips, and describes it in the statistics.
Triangulation flipped_triangulation(Command_run& run, const Delaunay_options& options)
{
  const Constraints constraints{options.constrained_angle};
  if(options.weights.empty()) {
    Triangulation result = make_delaunay_triangulation(run, constraints);
    describe(run, result);
    return result;
  }
  Triangulation result = make_weighted_delaunay_triangulation(
    run, constraints, vertex_numbers("--weights", options.weights, run.input()));
  describe_edges(run.statistics(), result);
  return result;
}

int write_triangulation(Command_run& run, const Delaunay_options& options, Mesh_format format)
{
  const Triangulation triangulation = flipped_triangulation(run, options);
  run.keep_points_only();
  const Subdivision subdivision = subdivide(run, triangulation);
  run.timed("write", [&] {
    Output_mesh mesh = subdivision_mesh(subdivision);
    run.show([&](View_page& page) { show(page, run, triangulation, subdivision, mesh); });
    add_input_data(run.input(), mesh);
    run.add_output(options.output, mesh, format);
    save(run, triangulation);
  });
  run.finish(summary_of_flips(run));
  return 0;
}

int delaunay(const Common_options& common, const Delaunay_options& options)
{
  const Mesh_format format = output_format(options.output, options);
  Command_run run("delaunay", common, {options.output});
  run.plan({delaunay_stages, certificate_stages(common), subdivision_stages});
  return attempt(run, [&] { return write_triangulation(run, options, format); });
}

} // namespace

void define_delaunay(Command_line& line)
{
  const auto [command, options] = line.add_with_mesh(
    "delaunay", "Flip a mesh to its intrinsic Delaunay triangulation", delaunay, delaunay_help);
  add_subdivision_options(command, options, line.common());
  add_exact(command, line.common());
  add_read_file(command, line.common(), "--weights", options.weights,
                "Weights of vertices: a file, or a property of vertices in the mesh");
}
