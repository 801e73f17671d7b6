// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Closes boundary loops and cuts handles up to a length, given relative to the diagonal of the
// bounding box. Prints genus and boundary loops before and after, the area of the disks relative to
// the surface, and the time. Usage: benchmark_topology MESH PART...

#include "../Intrinsic_triangulations/measure.h"
#include "surfaces.h"

#include <CGAL/Intrinsic_simplification/Surface_surgery.h>
#include <CGAL/Intrinsic_simplification/pinch_handles.h>
#include <CGAL/Intrinsic_triangulations/topological_type.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polygon_mesh_processing/measure.h>

#include <cmath>
#include <cstdlib>

namespace IS = CGAL::Intrinsic_simplification;
namespace IT = CGAL::Intrinsic_triangulations;

namespace {

void benchmark(const Table& table, const Mesh& mesh, double part)
{
  const auto box = CGAL::Polygon_mesh_processing::bbox(mesh);
  const double length = part * std::hypot(box.x_span(), std::hypot(box.y_span(), box.z_span()));
  const IS::Surface_surgery::Triangulation input(mesh);
  const IT::Topological_type before = IT::topological_type(input.mesh());
  IS::Surface_surgery surface(input);
  Samples samples;
  samples.time(
    [&] { return IS::close_boundary_loops(surface, length) + IS::pinch_handles(surface, length); });
  const IT::Topological_type after = IT::topological_type(surface.mesh());
  table.row(part, before.genus, after.genus, before.boundary_loops, after.boundary_loops,
            surface.filled_area() / CGAL::Polygon_mesh_processing::area(mesh),
            samples.median() / 1000);
}

} // namespace

int main(int argc, char* argv[])
{
  if(argc < 3)
    return 1;
  Mesh mesh;
  if(!CGAL::Polygon_mesh_processing::IO::read_polygon_mesh(argv[1], mesh))
    return 1;
  const Table table(
    {"bound", "genus", "after", "boundary loops", "after", "area of disks", "seconds"}, 0);
  for(int i = 2; i < argc; ++i)
    benchmark(table, mesh, std::atof(argv[i]));
}
