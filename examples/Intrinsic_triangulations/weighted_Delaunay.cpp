// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Computes a weighted Delaunay triangulation, the vertices that others hide, and a proof.

#include <CGAL/Intrinsic_triangulations/certify_weighted_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/make_weighted_Delaunay.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <boost/property_map/function_property_map.hpp>

#include <iostream>
#include <string>

namespace IT = CGAL::Intrinsic_triangulations;

typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Mesh;

int main(int argc, char* argv[])
{
  const std::string file = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/cow.off");
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(file, mesh)) {
    std::cerr << file << " cannot be read\n";
    return 1;
  }
  // Every tenth vertex has a circle of radius 0.02.
  const auto weight = boost::make_function_property_map<IT::Vertex_index>(
    [](IT::Vertex_index v) { return v.idx() % 10 == 0 ? 0.02 * 0.02 : 0; });

  IT::Intrinsic_triangulation<> tri(mesh);
  const auto result = IT::make_weighted_Delaunay(tri, weight);
  const IT::Weighted_Delaunay_certificate certificate =
    IT::certify_weighted_Delaunay(tri, weight, result.hidden_vertices);
  std::cout << result.flips << " flips, " << result.hidden_vertices.size() << " hidden vertices, "
            << (certificate.is_weighted_Delaunay() ? "certified" : "not certified") << '\n';
}
