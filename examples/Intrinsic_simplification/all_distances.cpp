// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Computes approximate geodesic distances between all pairs of vertices: exact distances on a
// coarse surface are prolonged to the mesh.

#include <CGAL/Intrinsic_simplification/Prolonged_distances.h>
#include <CGAL/Intrinsic_simplification/prolongation.h>
#include <CGAL/Intrinsic_simplification/simplify.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <algorithm>
#include <cmath>
#include <iostream>

namespace IS = CGAL::Intrinsic_simplification;
namespace IT = CGAL::Intrinsic_triangulations;
typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Mesh;

int main(int argc, char* argv[])
{
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : CGAL::data_file_path("meshes/elephant.off"),
                                  mesh))
    return 1;

  IS::Evolving_surface surface(mesh);
  const IS::Surface_level fine(surface);
  IS::simplify(surface, IS::parameters::number_of_vertices(mesh.number_of_vertices() / 10));
  const IS::Surface_level coarse(surface);
  const IS::Surface_map map(surface, fine, coarse);
  const IS::Prolonged_distances distance(coarse, IS::prolongation_matrix(map));

  // Exact distances from one vertex, for comparison.
  const IT::Vertex_index source(0);
  IT::Shortest_paths exact(fine);
  exact.add_source(source);
  exact.run();
  double error = 0, greatest = 0;
  for(IT::Vertex_index v : fine.mesh().vertices()) {
    error = (std::max)(error, std::abs(distance(source, v) - exact.distance(v)));
    greatest = (std::max)(greatest, exact.distance(v));
  }
  std::cout << coarse.mesh().number_of_vertices() << " of " << mesh.number_of_vertices()
            << " vertices; greatest error: " << 100 * error / greatest
            << " percent of the greatest distance\n";
}
