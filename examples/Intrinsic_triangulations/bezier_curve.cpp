// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Computes a Bezier curve on a surface by de Casteljau's algorithm. The midpoint of two points is
// the midpoint of the shortest geodesic between them.

#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/exponential_map.h>
#include <CGAL/Intrinsic_triangulations/logarithmic_map.h>
#include <CGAL/Polygon_mesh_processing/locate.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <array>
#include <iostream>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;
namespace PMP = CGAL::Polygon_mesh_processing;
typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Mesh;
typedef IT::Face_location<double> Place;
typedef std::array<Place, 4> Control_points;

Place midpoint(const IT::Intrinsic_triangulation<>& tri, const Place& p, const Place& q)
{
  const auto logarithm = IT::logarithmic_map(tri.input(), p, q);
  return IT::trace_geodesic(tri.input(), p, logarithm.vector / 2.).end;
}

// Adds 2^depth points after the first control point.
void subdivide(const IT::Intrinsic_triangulation<>& tri, const Control_points& c, int depth,
               std::vector<Place>& curve)
{
  if(depth == 0) {
    curve.push_back(c[3]);
    return;
  }
  const auto mid = [&](const Place& p, const Place& q) { return midpoint(tri, p, q); };
  const Place a = mid(c[0], c[1]), b = mid(c[1], c[2]), d = mid(c[2], c[3]);
  const Place ab = mid(a, b), bd = mid(b, d), middle = mid(ab, bd);
  subdivide(tri, {c[0], a, ab, middle}, depth - 1, curve);
  subdivide(tri, {middle, bd, d, c[3]}, depth - 1, curve);
}

int main(int argc, char* argv[])
{
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : CGAL::data_file_path("meshes/sphere.off"),
                                  mesh))
    return 1;
  const IT::Intrinsic_triangulation<> tri(mesh);
  const auto center = [](unsigned f) { return Place(IT::Face_index(f), {1. / 3, 1. / 3, 1. / 3}); };
  std::vector<Place> curve{center(0)};
  subdivide(tri, {center(0), center(100), center(200), center(300)}, 3, curve);
  for(const Place& p : curve)
    std::cout << PMP::construct_point(p, mesh) << '\n';
}
