// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Computes the geodesic distance to a vertex by the heat method, on a mesh and on its intrinsic
// Delaunay triangulation. The latter is more accurate, and is a function on the vertices of the
// mesh too.

#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/heat_distance.h>
#include <CGAL/Intrinsic_triangulations/make_Delaunay.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <fstream>
#include <iostream>

namespace IT = CGAL::Intrinsic_triangulations;
typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Mesh;

int main(int argc, char* argv[])
{
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : CGAL::data_file_path("meshes/camel.off"),
                                  mesh))
    return 1;

  IT::Intrinsic_triangulation<> tri(mesh);
  IT::make_Delaunay(tri);

  const IT::Vertex_index source(0);
  const Eigen::VectorXd on_mesh = IT::heat_distance(tri.input(), source);

  // The solver is prepared once, and can be used any number of times.
  const IT::Heat_distance<> distance(tri.intrinsic());
  const Eigen::VectorXd on_Delaunay = distance.distances(source);

  std::cout << "the greatest distance from vertex 0 is " << on_mesh.maxCoeff()
            << " by the mesh itself, " << on_Delaunay.maxCoeff()
            << " by its Delaunay triangulation\n";

  auto property = mesh.add_property_map<Mesh::Vertex_index, double>("v:distance", 0).first;
  for(Mesh::Vertex_index v : mesh.vertices())
    property[v] = on_Delaunay[static_cast<Eigen::Index>(v.idx())];
  std::ofstream out("heat_distance.ply");
  return CGAL::IO::write_PLY(out, mesh) ? 0 : 1;
}
