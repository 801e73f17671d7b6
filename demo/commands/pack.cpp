// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands/Command_line.h"

#include "commands/Command_run.h"
#include "pictures/Canvas.h"
#include "pictures/circle_picture.h"
#include "writing/Mesh_writer.h"

#include <CGAL/Discrete_conformal_maps/pack_circles.h>

#include <sstream>
#include <string>
#include <vector>

namespace DCM = CGAL::Discrete_conformal_maps;

namespace {

struct Pack_options : Output_options
{
  Pack_options() : Output_options("ply") {}

  std::string picture; // empty if not wanted
};

constexpr const char* pack_help =
  R"(The mesh must be a sphere or a disk in which vertices determine edges and faces. Only its
connectivity counts. The circles of two vertices touch if an edge joins them. Circles of a sphere
are on the unit sphere. Circles of a disk are in the unit disk, and circles of its boundary touch
the unit circle.

The output is the mesh with its vertices at the centers of their circles. .ply and .vtp have the
radii; on the sphere, the radius is the angle between the center and the circle. --circles draws the
circles in the plane, circles of a sphere by stereographic projection. The picture of a sphere ends
at three times the radius of the equator, beyond which projected circles are huge.

Example:
  intrinsic pack bunny.obj -o packing.ply --circles packing.svg --stats packing.json)";

Point center(const DCM::Circle_packing& packing, DCM::Vertex_index v)
{
  if(packing.is_disk()) {
    const auto& c = packing.circle(v).center;
    return Point(c.real(), c.imag(), 0);
  }
  const auto [x, y, z] = packing.spherical_circle(v).center;
  return Point(x, y, z);
}

Output_mesh described_mesh(const Mesh& mesh, const DCM::Circle_packing& packing)
{
  Output_mesh result = output_mesh(mesh);
  std::vector<double> radii;
  for(const Mesh::Vertex_index v : mesh.vertices()) {
    const DCM::Vertex_index w(v.idx());
    result.points[v.idx()] = center(packing, w);
    radii.push_back(packing.is_disk() ? packing.circle(w).radius
                                      : packing.spherical_circle(w).angle);
  }
  result.point_data.push_back({"radius", radii});
  return result;
}

int pack(const Common_options& common, const Pack_options& options)
{
  const Mesh_format format = output_format(options.output, options);
  check_picture_available("--circles", options.picture);
  Common_options combinatorial = common;
  combinatorial.are_positions_used = false;
  Command_run run("pack", combinatorial, {options.output, options.picture});
  run.refuse_isolated_vertices();
  run.plan({{"pack"}});
  const DCM::Circle_packing packing =
    run.timed("pack", [&] { return DCM::pack_circles(run.input().mesh); });
  Statistics& statistics = run.statistics();
  statistics["disk"] = packing.is_disk();
  statistics["status"] = to_string(packing.status());
  statistics["max_tangency_error"] = packing.max_tangency_error();
  statistics["iterations"] = packing.minimization().iterations;
  if(packing.status() != DCM::Map_status::success)
    throw CGAL::Intrinsic_triangulations::Numerical_error(std::string("circles do not touch: ") +
                                                          message(packing.status()));
  run.timed("write", [&] {
    run.add_output(options.output, described_mesh(run.input().mesh, packing), format);
    run.add_output(options.picture,
                   [&](Text& text) { write_circle_picture(text, packing, options.picture); });
  });
  std::ostringstream text;
  text << packing.size() << " circles " << (packing.is_disk() ? "in the disk" : "on the sphere")
       << ", which touch within " << packing.max_tangency_error();
  run.finish(text.str());
  return 0;
}

} // namespace

void define_pack(Command_line& line)
{
  const auto [command, options] = line.add_with_mesh(
    "pack", "Pack circles that touch if an edge of the mesh joins their vertices", pack, pack_help);
  add_output(command, options, "The mesh of the centers (.off, .obj, .ply, .vtp",
             "off, obj, ply or vtp");
  command.add_option("--circles", options.picture,
                     "SVG or PNG picture of the circles in the plane");
  add_statistics(command, line.common());
  add_repair(command, line.common());
}
