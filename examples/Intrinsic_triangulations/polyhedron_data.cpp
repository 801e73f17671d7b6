// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Computes distances on the intrinsic Delaunay triangulation of a `CGAL::Polyhedron_3`, and stores
// them at its vertices. Vertices have indices from 0 in the order of `vertices(g)`.

#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/heat_distance.h>
#include <CGAL/Intrinsic_triangulations/make_Delaunay.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <boost/graph/graph_traits.hpp>

#include <iostream>
#include <unordered_map>

namespace IT = CGAL::Intrinsic_triangulations;
typedef CGAL::Polyhedron_3<CGAL::Simple_cartesian<double>> Polyhedron;
typedef boost::graph_traits<Polyhedron>::vertex_descriptor Vertex;

int main(int argc, char* argv[])
{
  Polyhedron mesh;
  if(!CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : CGAL::data_file_path("meshes/elephant.off"),
                                  mesh))
    return 1;
  IT::Intrinsic_triangulation<> tri(mesh);
  IT::make_Delaunay(tri);
  const auto distance = IT::heat_distance(tri.intrinsic(), IT::Vertex_index(0));

  std::unordered_map<Vertex, double> distance_of; // or a member of the vertices
  int index = 0;
  Vertex farthest = *vertices(mesh).first;
  for(const Vertex v : vertices(mesh)) {
    distance_of[v] = distance[index++];
    if(distance_of[v] > distance_of[farthest])
      farthest = v;
  }
  std::cout << "the farthest vertex is at " << farthest->point() << ", at a distance of "
            << distance_of[farthest] << '\n';
}
