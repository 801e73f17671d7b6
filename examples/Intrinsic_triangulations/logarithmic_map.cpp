// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Finds the vertex that is farthest from the first one, and follows the geodesic in its direction
// for half of the distance.

#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/exponential_map.h>
#include <CGAL/Intrinsic_triangulations/logarithmic_map.h>
#include <CGAL/Polygon_mesh_processing/locate.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <algorithm>
#include <complex>
#include <iostream>

namespace IT = CGAL::Intrinsic_triangulations;
namespace PMP = CGAL::Polygon_mesh_processing;
typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Mesh;

int main(int argc, char* argv[])
{
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : CGAL::data_file_path("meshes/elephant.off"),
                                  mesh))
    return 1;

  const IT::Intrinsic_triangulation<> tri(mesh);
  const auto logarithms = IT::logarithmic_map(tri.input(), IT::Vertex_index(0));
  const auto farthest =
    std::max_element(logarithms.begin(), logarithms.end(), [](const auto& a, const auto& b) {
      return std::abs(a.vector) < std::abs(b.vector);
    });
  std::cout << "vertex " << farthest - logarithms.begin() << " is at the distance "
            << std::abs(farthest->vector) << ": " << to_string(farthest->status) << '\n';

  const auto walk = IT::trace_geodesic(tri.input(), IT::Vertex_index(0), 0.5 * farthest->vector);
  std::cout << "halfway a straight line is at " << PMP::construct_point(walk.end, mesh) << '\n';
}
