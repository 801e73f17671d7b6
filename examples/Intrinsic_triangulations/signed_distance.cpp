// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Computes the signed distance to a curve through points of a mesh, on the intrinsic Delaunay
// triangulation. Also computes the distance to a point inside a face.

#include <CGAL/Intrinsic_triangulations/Correspondence.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/Shortest_paths.h>
#include <CGAL/Intrinsic_triangulations/curve_across.h>
#include <CGAL/Intrinsic_triangulations/heat_distance.h>
#include <CGAL/Intrinsic_triangulations/make_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/point_across.h>
#include <CGAL/Intrinsic_triangulations/signed_distance.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <algorithm>
#include <iostream>
#include <vector>

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
  const IT::Correspondence<> correspondence(tri);

  // Shortest paths lead from point to point on the mesh.
  const auto faces = static_cast<Mesh::size_type>(mesh.number_of_faces());
  std::vector<IT::Face_location<double>> points;
  for(Mesh::size_type k : {0u, 1u, 2u, 0u})
    points.push_back({IT::Face_index(k * faces / 3), {0.2, 0.3, 0.5}});
  IT::Surface_curve<double> curve;
  for(std::size_t i = 0; i + 1 < points.size(); ++i) {
    const auto path = IT::shortest_path(tri.input(), points[i], points[i + 1]);
    for(const auto& segment : IT::curve_through(tri.input(), path.places))
      curve.push_back(segment);
  }

  const auto surface = tri.intrinsic();
  const auto there = IT::curve_across(correspondence, IT::Side::input, curve);
  const std::vector<double> distance = IT::signed_distance(surface, there).distance;
  const auto [least, greatest] = std::minmax_element(distance.begin(), distance.end());
  std::cout << "the curve has length " << IT::curve_length(surface, there)
            << "; distances are from " << *least << " on its left to " << *greatest
            << " on its right\n";

  const auto p = IT::point_across(correspondence, IT::Side::input, points[0]);
  std::cout << "no vertex is further away from its start than "
            << IT::heat_distance(surface, p).maxCoeff() << '\n';
  return 0;
}
