// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands.h"

#include "Command_run.h"
#include "Mesh_writer.h"
#include "triangulation_stages.h"

#include <sstream>

namespace {

std::string summary_of(Command_run& run)
{
  const Statistics& s = run.statistics();
  std::ostringstream text;
  text << summary_of_changes(run) << ", " << s["faces_below_bound"] << " faces below the bound, "
       << s["faces_excused"] << " of them excused, " << s["subdivision"]["faces"]
       << " faces in the common subdivision";
  return text.str();
}

} // namespace

int refine(const Common_options& common, const Refine_options& options)
{
  const Mesh_format format = output_format(options.output, options);
  Command_run run("refine", common, {options.output});
  run.plan({delaunay_stages, {"refine"}, certificate_stages(common), subdivision_stages});
  Triangulation triangulation = make_delaunay_triangulation(run, options.constrained_angle);
  refine_triangulation(run, triangulation, options.bounds);
  describe(run, triangulation);
  const Subdivision subdivision = subdivide(run, triangulation);
  run.timed("write", [&] {
    run.add_output(options.output, subdivision_mesh(subdivision), format);
    save(run, triangulation);
  });
  run.finish(summary_of(run));
  return 0;
}
