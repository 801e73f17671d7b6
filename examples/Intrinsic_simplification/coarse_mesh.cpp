// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Simplifies a surface to a hundred vertices, writes the coarse triangulation as an ordinary mesh
// in space, and prints the differences from the input.

#include <CGAL/Intrinsic_simplification/Evolving_surface.h>
#include <CGAL/Intrinsic_simplification/Surface_level.h>
#include <CGAL/Intrinsic_simplification/coarse_mesh.h>
#include <CGAL/Intrinsic_simplification/simplify.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <iostream>

namespace IS = CGAL::Intrinsic_simplification;
typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Mesh;

int main(int argc, char* argv[])
{
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : CGAL::data_file_path("meshes/elephant.off"),
                                  mesh))
    return 1;

  IS::Evolving_surface surface(mesh);
  const IS::Surface_level fine(surface);
  IS::simplify(surface, IS::parameters::number_of_vertices(100));

  Mesh coarse;
  const IS::Coarse_mesh_quality quality =
    IS::coarse_mesh(surface, fine, coarse, IS::parameters::input_point_map(mesh.points()));
  std::cout << surface.mesh().number_of_vertices() << " vertices and " << quality.inserted_vertices
            << " more to make it simplicial\n"
            << "the mesh is up to " << quality.deviation() << " away from the surface; "
            << quality.flipped_faces << " faces are flipped, " << quality.self_intersections
            << " pairs of faces intersect\n";
  return CGAL::IO::write_polygon_mesh("coarse.off", coarse) ? 0 : 1;
}
