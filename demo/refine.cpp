// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands.h"

#include "Command_run.h"
#include "Mesh_writer.h"
#include "triangulation_stages.h"

#include <CGAL/Intrinsic_triangulations/extrinsic_mesh.h>

#include <sstream>

namespace IT = CGAL::Intrinsic_triangulations;

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

Surface_marks
faces_below_bounds(const CGAL::Intrinsic_triangulations::Refinement_result& refinement,
                   const Output_mesh& mesh)
{
  std::vector<std::int64_t> faces;
  for(const auto& remaining : refinement.remaining)
    faces.push_back(number_of(remaining.face));
  return {"faces below the bounds", true, parts_of(faces, "intrinsic_face", mesh), {}, {}};
}

// The faces of the triangulation itself, flat in space.
Output_mesh own_faces(const Triangulation& triangulation, const Mesh& input)
{
  const Mesh mesh = IT::extrinsic_mesh(triangulation, input.points());
  Output_mesh result = output_mesh_with_edges(mesh, {mesh.faces().begin(), mesh.faces().end()});
  const auto kind = [&](IT::Vertex_index v) {
    return static_cast<std::int64_t>(triangulation.is_inserted(v) ? Vertex_kind::inserted
                                                                  : Vertex_kind::input);
  };
  result.point_data = {attribute("kind", mesh.vertices(), kind)};
  result.edge_data = {
    attribute("length", mesh.edges(), [&](IT::Edge_index e) { return triangulation.length(e); })};
  return result;
}

} // namespace

int refine(const Common_options& common, const Refine_options& options)
{
  const Mesh_format format = output_format(options.output, options);
  Command_run run("refine", common, {options.output});
  run.plan({delaunay_stages, {"refine"}, certificate_stages(common), subdivision_stages});
  Triangulation triangulation = make_delaunay_triangulation(run, options.constrained_angle);
  run.keep_points_only();
  const auto refinement = refine_triangulation(run, triangulation, options.bounds);
  describe(run, triangulation);
  const Subdivision subdivision = subdivide(run, triangulation);
  run.timed("write", [&] {
    const Output_mesh mesh = subdivision_mesh(subdivision);
    run.add_output(options.output,
                   options.bounds.is_simplicial ? own_faces(triangulation, run.input().mesh) : mesh,
                   format);
    run.show([&](View_page& page) {
      show(page, run, triangulation, subdivision, mesh);
      develop_if_large(page, run, triangulation, subdivision);
      page.add_marks(faces_below_bounds(refinement, mesh));
    });
    save(run, triangulation);
  });
  run.finish(summary_of(run));
  return 0;
}
