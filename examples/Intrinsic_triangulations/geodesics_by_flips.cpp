// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/Edge_paths.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/path_on_input.h>
#include <CGAL/Intrinsic_triangulations/shortest_edge_path.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cstdlib>
#include <iostream>
#include <string>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
namespace IT = CGAL::Intrinsic_triangulations;

// Shortens a path along edges to a geodesic, by flips of edges of the intrinsic triangulation.
int main(int argc, char* argv[])
{
  const std::string file = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/elephant.off");
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(file, mesh)) {
    std::cerr << "cannot read " << file << '\n';
    return EXIT_FAILURE;
  }
  IT::Intrinsic_triangulation<> triangulation(mesh);
  const IT::Vertex_index last(static_cast<unsigned>(mesh.number_of_vertices() - 1));

  IT::Edge_paths paths(triangulation);
  paths.add_path(IT::shortest_edge_path(triangulation, IT::Vertex_index(0), last));
  const double before = paths.length(0);
  const auto status = paths.shorten();
  const auto path = IT::path_on_input(triangulation, paths.halfedges(0));
  std::cout << to_string(status) << ": length " << before << " before, " << path.length << " after "
            << paths.number_of_flips() << " flips; it meets " << path.places.size() - 2
            << " edges and vertices of the input\n";
}
