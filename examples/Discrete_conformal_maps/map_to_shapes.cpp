// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Maps a disk to a rectangle and to a round disk.

#include <CGAL/Discrete_conformal_maps/flatten_to_disk.h>
#include <CGAL/Discrete_conformal_maps/flatten_to_rectangle.h>
#include <CGAL/Polygon_mesh_processing/locate.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <complex>
#include <cstddef>
#include <iostream>
#include <vector>

namespace DCM = CGAL::Discrete_conformal_maps;
namespace PMP = CGAL::Polygon_mesh_processing;
typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Mesh;

int main(int argc, char* argv[])
{
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : CGAL::data_file_path("meshes/nefertiti.off"),
                                  mesh))
    return 1;

  const std::vector<Mesh::Vertex_index> corners = DCM::rectangle_corners(mesh);
  const DCM::Planar_conformal_map rectangle = DCM::flatten_to_rectangle(mesh, corners);
  if(rectangle.status() != DCM::Map_status::success) {
    std::cerr << DCM::message(rectangle.status()) << '\n';
    return 1;
  }
  const auto place = [&](std::size_t i) {
    return rectangle(PMP::locate_vertex<double>(corners[i], mesh));
  };
  std::cout << "a rectangle with sides of " << std::abs(place(1) - place(0)) << " and "
            << std::abs(place(2) - place(1)) << "; the opposite ones have "
            << std::abs(place(3) - place(2)) << " and " << std::abs(place(0) - place(3)) << '\n';

  const DCM::Planar_conformal_map disk = DCM::flatten_to_disk(mesh);
  if(disk.status() != DCM::Map_status::success) {
    std::cerr << DCM::message(disk.status()) << '\n';
    return 1;
  }
  const std::complex<double> z = disk(PMP::locate_vertex<double>(corners[0], mesh)),
                             w = disk(PMP::locate_vertex<double>(corners[2], mesh));
  std::cout << "in a disk, opposite corners are " << std::abs(w - z) << " apart\n";
}
