// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/Shortest_paths.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <string>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
namespace IT = CGAL::Intrinsic_triangulations;

// Computes the distances of a mesh from two points, and the path to the farthest vertex.
int main(int argc, char* argv[])
{
  const std::string file = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/elephant.off");
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(file, mesh)) {
    std::cerr << "cannot read " << file << '\n';
    return EXIT_FAILURE;
  }
  const IT::Intrinsic_triangulation<> triangulation(mesh);

  IT::Shortest_paths paths(triangulation);
  paths.add_source(IT::Vertex_index(0));
  paths.add_source(IT::Face_location<double>{IT::Face_index(99), {0.2, 0.3, 0.5}});
  paths.run();

  IT::Vertex_index farthest(0);
  for(IT::Vertex_index v : mesh.vertices())
    if(paths.distance(v) > paths.distance(farthest))
      farthest = v;
  const auto path = paths.path(farthest);
  std::cout << "vertex " << farthest << " is " << path.length << " away from source "
            << paths.source(farthest) << "; the path to it meets " << path.places.size() - 2
            << " edges and vertices\n";
}
