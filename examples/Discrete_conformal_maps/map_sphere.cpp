// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Maps a mesh to the sphere, and counts its vertices in the upper half.
#include <CGAL/Discrete_conformal_maps/cross_ratios.h>
#include <CGAL/Discrete_conformal_maps/map_to_sphere.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <iostream>
#include <string>

typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Mesh;
namespace DCM = CGAL::Discrete_conformal_maps;

int main(int argc, char** argv)
{
  const std::string file = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/cow.off");
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(file, mesh)) {
    std::cerr << "cannot read " << file << '\n';
    return 1;
  }
  const DCM::Spherical_conformal_map map = DCM::map_to_sphere(mesh);
  if(map.status() != DCM::Map_status::success) {
    std::cerr << DCM::message(map.status()) << '\n';
    return 1;
  }
  std::cout << "cross ratios are right up to " << DCM::max_cross_ratio_error(map) << '\n'
            << map.lost_in_output() << " triangles are too small for double\n";

  std::size_t above = 0;
  for(const Mesh::Vertex_index v : mesh.vertices())
    above += map.position(DCM::Vertex_index(v.idx()))[2] > 0;
  std::cout << above << " of " << mesh.number_of_vertices() << " vertices are in the upper half\n";
  return 0;
}
