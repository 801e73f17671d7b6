// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Maps single points of a surface to the plane: the points closest to points in space, and some
// points along a triangle. No common subdivision is computed.

#include <CGAL/Discrete_conformal_maps/flatten.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polygon_mesh_processing/locate.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <complex>
#include <iostream>

namespace DCM = CGAL::Discrete_conformal_maps;
namespace PMP = CGAL::Polygon_mesh_processing;
typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Mesh;

int main(int argc, char* argv[])
{
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : CGAL::data_file_path("meshes/nefertiti.off"),
                                  mesh))
    return 1;

  const DCM::Planar_conformal_map map = DCM::flatten(mesh);
  if(map.status() != DCM::Map_status::success) {
    std::cerr << DCM::message(map.status()) << '\n';
    return 1;
  }

  const CGAL::Bbox_3 box = PMP::bbox(mesh);
  for(int corner = 0; corner < 8; ++corner) {
    const Mesh::Point p(corner & 1 ? box.xmax() : box.xmin(), corner & 2 ? box.ymax() : box.ymin(),
                        corner & 4 ? box.zmax() : box.zmin());
    const auto location = PMP::locate(p, mesh);
    std::cout << PMP::construct_point(location, mesh) << " -> " << map(location) << '\n';
  }

  // The map is not linear on a triangle.
  const Mesh::Face_index f(0);
  const std::complex<double> a = map({f, {1, 0, 0}}), b = map({f, {0, 1, 0}}),
                             middle = map({f, {0.5, 0.5, 0}});
  std::cout << "the middle of an edge is mapped "
            << std::abs(middle - (a + b) / 2.) / std::abs(b - a)
            << " lengths of the edge from the middle of its ends\n";
}
