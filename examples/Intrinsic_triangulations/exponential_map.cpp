// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Sends geodesics from a vertex in eight directions, on the mesh and on its intrinsic Delaunay
// triangulation.

#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/exponential_map.h>
#include <CGAL/Intrinsic_triangulations/make_Delaunay.h>
#include <CGAL/Polygon_mesh_processing/locate.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <complex>
#include <iostream>
#include <iterator>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;
namespace PMP = CGAL::Polygon_mesh_processing;
typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Mesh;

int main(int argc, char* argv[])
{
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : CGAL::data_file_path("meshes/elephant.off"),
                                  mesh))
    return 1;

  IT::Intrinsic_triangulation<> tri(mesh);
  IT::make_Delaunay(tri);
  const IT::Vertex_index v(0);
  const double length = 5 * tri.input_length(IT::Edge_index(0));

  for(int k = 0; k < 8; ++k) {
    const auto vector = std::polar(length, k * CGAL_PI / 4);
    std::vector<IT::Edge_point<double>> path;
    const auto on_input =
      IT::trace_geodesic(tri.input(), v, vector, IT::At_boundary::stop, std::back_inserter(path));
    std::cout << "to " << PMP::construct_point(on_input.end, mesh) << " over " << path.size()
              << " edges of the mesh: " << to_string(on_input.status) << '\n';

    // The geodesic leads back along the same line.
    const auto back =
      IT::trace_geodesic(tri.input(), on_input.end, -on_input.length * on_input.direction);
    std::cout << "  and back to " << PMP::construct_point(back.end, mesh) << '\n';

    // The first edge around the vertex may be another one on the other side.
    const auto on_intrinsic = IT::trace_geodesic(tri.intrinsic(), v, vector);
    std::cout << "  on the other triangulation in face " << on_intrinsic.end.first << '\n';
  }
}
