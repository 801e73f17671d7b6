// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Computes distances from two points in space: from the nearest points of the mesh, which lie in
// faces.

#include <CGAL/Intrinsic_triangulations/geodesic_distances.h>
#include <CGAL/Polygon_mesh_processing/locate.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <algorithm>
#include <iostream>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;
namespace PMP = CGAL::Polygon_mesh_processing;
typedef CGAL::Simple_cartesian<double>::Point_3 Point;
typedef CGAL::Surface_mesh<Point> Mesh;

int main(int argc, char* argv[])
{
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : CGAL::data_file_path("meshes/camel.off"),
                                  mesh))
    return 1;

  std::vector<IT::Face_location<double>> sources;
  for(const Point& p : {Point(0, 0, 0.5), Point(0, 0.5, 0)})
    sources.push_back(PMP::locate(p, mesh));

  const IT::Geodesic_distances<double> result = IT::geodesic_distances(mesh, sources);
  const auto farthest = std::max_element(result.distance.begin(), result.distance.end());
  std::cout << "vertex " << farthest - result.distance.begin() << " is the farthest one, at "
            << *farthest << '\n';
}
