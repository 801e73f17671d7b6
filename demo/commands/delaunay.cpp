// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands/Command_line.h"

#include "commands/Command_run.h"
#include "commands/attempts.h"
#include "commands/triangulation_stages.h"

namespace {

constexpr const char* delaunay_help =
  "Example:\n  intrinsic delaunay bunny.obj -o subdivision.vtp --constrain-angle 40";

std::string summary_of_flips(Command_run& run)
{
  const Statistics& s = run.statistics();
  return summary_of_changes(run) + ", " + s["crossings"].dump() + " crossings, " +
         s["subdivision"]["faces"].dump() + " faces in the common subdivision";
}

int write_triangulation(Command_run& run, const Subdivision_options& options, Mesh_format format)
{
  const Triangulation triangulation = make_delaunay_triangulation(run, {options.constrained_angle});
  run.keep_points_only();
  describe(run, triangulation);
  const Subdivision subdivision = subdivide(run, triangulation);
  run.timed("write", [&] {
    Output_mesh mesh = subdivision_mesh(subdivision);
    run.show([&](View_page& page) {
      show(page, run, triangulation, subdivision, mesh);
      develop_if_large(page, run, triangulation, subdivision);
    });
    add_input_data(run.input(), mesh);
    run.add_output(options.output, mesh, format);
    save(run, triangulation);
  });
  run.finish(summary_of_flips(run));
  return 0;
}

int delaunay(const Common_options& common, const Subdivision_options& options)
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
}
