// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Cuts the handles of a surface, closes its boundary loops, simplifies the result, and maps its
// points to the input.

#include <CGAL/Intrinsic_simplification/Evolving_surface.h>
#include <CGAL/Intrinsic_simplification/Surface_surgery.h>
#include <CGAL/Intrinsic_simplification/pinch_handles.h>
#include <CGAL/Intrinsic_simplification/simplify.h>
#include <CGAL/Intrinsic_triangulations/topological_type.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <iostream>

namespace IS = CGAL::Intrinsic_simplification;
namespace IT = CGAL::Intrinsic_triangulations;
typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Mesh;

int main(int argc, char* argv[])
{
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(
       argc > 1 ? argv[1] : CGAL::data_file_path("meshes/elephant-with-holes.off"), mesh))
    return 1;
  IS::Surface_surgery surgery{IS::Surface_surgery::Triangulation(mesh)};
  const IT::Topological_type before = IT::topological_type(surgery.mesh());
  IS::close_boundary_loops(surgery, 0.5);
  IS::pinch_handles(surgery, 0.5);
  const IT::Topological_type after = IT::topological_type(surgery.mesh());
  std::cout << before.boundary_loops << " boundary loops and " << before.genus
            << " handles before, " << after.boundary_loops << " and " << after.genus << " after\n";

  std::size_t in_disks = 0;
  for(IS::Face_index f : surgery.mesh().faces())
    in_disks += !surgery.preimage({f, {0.5, 0.25, 0.25}});
  std::cout << in_disks << " of " << surgery.mesh().number_of_faces()
            << " faces come from nowhere\n";

  IS::Evolving_surface surface(surgery.triangulation());
  IS::simplify(surface, IS::parameters::number_of_vertices(20));
  std::cout << surface.mesh().number_of_vertices() << " vertices are left\n";
}
