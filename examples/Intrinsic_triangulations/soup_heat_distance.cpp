// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Computes a Laplacian and geodesic distances on triangles that are not a surface. They are a camel
// with a sail: three triangles that meet its back in an edge, without orientation.

#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/Tufted_surface.h>
#include <CGAL/Intrinsic_triangulations/heat_distance.h>
#include <CGAL/Intrinsic_triangulations/make_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/tufted_cover.h>
#include <CGAL/Simple_cartesian.h>

#include <array>
#include <iostream>
#include <utility>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;
typedef CGAL::Simple_cartesian<double>::Point_3 Point;

int main(int argc, char* argv[])
{
  std::vector<Point> points;
  std::vector<std::vector<std::size_t>> triangles;
  if(!CGAL::IO::read_polygon_soup(argc > 1 ? argv[1] : CGAL::data_file_path("meshes/camel.off"),
                                  points, triangles))
    return 1;

  const std::vector<std::size_t> back = triangles.front();
  const std::size_t mast = points.size();
  for(int i = 0; i < 3; ++i) {
    points.push_back(points[back[0]] +
                     CGAL::Vector_3<CGAL::Simple_cartesian<double>>(0.01 * i, 0.1, 0));
    triangles.push_back({back[0], back[1], points.size() - 1});
  }
  for(std::size_t t = 0; t < triangles.size(); t += 2)
    std::swap(triangles[t][1], triangles[t][2]);

  const auto cover = IT::tufted_cover(points, triangles);
  IT::Intrinsic_triangulation<> tri(cover.mesh());
  IT::make_Delaunay(tri);

  // Functions have one value at each point.
  const IT::Tufted_surface<> surface(cover, tri.intrinsic());
  const Eigen::SparseMatrix<double> laplacian = IT::cotan_laplacian(surface);
  const Eigen::VectorXd distance = IT::heat_distance(surface, std::array{IT::Vertex_index(0)});

  std::cout << triangles.size() << " triangles have a cover of " << cover.mesh().number_of_faces()
            << " faces and " << cover.mesh().number_of_vertices() << " vertices\n"
            << "the Laplacian has " << laplacian.nonZeros() << " entries for " << points.size()
            << " points\n"
            << "the top of the sail has the distance " << distance[static_cast<Eigen::Index>(mast)]
            << " from vertex 0\n";
  return 0;
}
