// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Makes a closed surface without handles a tetrahedron with equal faces: four cones of curvature
// pi, flat everywhere else.

#include <CGAL/Discrete_conformal_maps/flatten.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <algorithm>
#include <iostream>

namespace DCM = CGAL::Discrete_conformal_maps;
typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Mesh;

int main(int argc, char* argv[])
{
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : CGAL::data_file_path("meshes/hand.off"),
                                  mesh))
    return 1;

  // Other vertices have the condition of curvature zero.
  auto condition =
    mesh.add_property_map<Mesh::Vertex_index, DCM::Vertex_condition>("v:condition").first;
  for(unsigned i = 0; i < 4; ++i)
    condition[Mesh::Vertex_index(i * mesh.number_of_vertices() / 4)] =
      DCM::Vertex_condition::curvature(CGAL_PI);

  const DCM::Planar_conformal_map map =
    DCM::flatten(mesh, DCM::parameters::vertex_condition_map(condition));
  if(map.status() != DCM::Map_status::success) {
    std::cerr << DCM::message(map.status()) << '\n';
    return 1;
  }

  double least = 0, greatest = 0;
  for(Mesh::Vertex_index v : mesh.vertices()) {
    least = (std::min)(least, map.log_scale(v));
    greatest = (std::max)(greatest, map.log_scale(v));
  }
  std::cout << "logarithmic scale factors from " << least << " to " << greatest
            << "; curvatures are as prescribed up to " << map.max_curvature_error() << '\n';
}
