// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Packs circles on the sphere that touch if an edge of a mesh joins their vertices, and draws them
// in the plane.

#include <CGAL/Discrete_conformal_maps/pack_circles.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <algorithm>
#include <fstream>
#include <iostream>

namespace DCM = CGAL::Discrete_conformal_maps;
typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Mesh;

int main(int argc, char* argv[])
{
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : CGAL::data_file_path("meshes/cow.off"),
                                  mesh))
    return 1;

  const DCM::Circle_packing packing = DCM::pack_circles(mesh);
  if(packing.status() != DCM::Map_status::success) {
    std::cerr << DCM::message(packing.status()) << '\n';
    return 1;
  }
  double least = CGAL_PI, greatest = 0;
  for(Mesh::Vertex_index v : mesh.vertices()) {
    const double angle = packing.spherical_circle(v).angle;
    least = (std::min)(least, angle);
    greatest = (std::max)(greatest, angle);
  }
  std::cout << packing.size() << " circles on the " << (packing.is_disk() ? "hemisphere" : "sphere")
            << ", from " << least << " to " << greatest << " radians\n"
            << "circles touch within 1e-10: " << std::boolalpha
            << (packing.max_tangency_error() < 1e-10) << '\n';

  std::ofstream picture("packing.svg");
  picture << R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="-2 -2 4 4">)"
          << R"(<g fill="none" stroke="black" stroke-width="0.002">)";
  for(Mesh::Vertex_index v : mesh.vertices()) {
    const auto& [center, radius] = packing.circle(v);
    picture << R"(<circle cx=")" << center.real() << R"(" cy=")" << -center.imag() << R"(" r=")"
            << radius << R"("/>)";
  }
  picture << "</g></svg>\n";
}
