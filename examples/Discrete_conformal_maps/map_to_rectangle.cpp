// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Maps a disk to a rectangle: four vertices of the boundary get right angles, the rest of it
// becomes straight.

#include <CGAL/Discrete_conformal_maps/flatten.h>
#include <CGAL/Polygon_mesh_processing/locate.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <complex>
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

  std::vector<Mesh::Vertex_index> boundary;
  for(auto h : halfedges_around_face(PMP::longest_border(mesh).first, mesh))
    boundary.push_back(mesh.target(h));

  // zero where nothing else is said
  auto condition =
    mesh.add_property_map<Mesh::Vertex_index, DCM::Vertex_condition>("v:condition").first;
  std::vector<Mesh::Vertex_index> corners;
  for(std::size_t i = 0; i < 4; ++i) {
    corners.push_back(boundary[i * boundary.size() / 4]);
    condition[corners[i]] = DCM::Vertex_condition::curvature(CGAL_PI / 2);
  }

  const DCM::Planar_conformal_map map =
    DCM::flatten(mesh, DCM::parameters::vertex_condition_map(condition));

  std::vector<std::complex<double>> place;
  for(Mesh::Vertex_index v : corners)
    place.push_back(map(PMP::locate_vertex<double>(v, mesh)));
  std::cout << "a rectangle with sides of " << std::abs(place[1] - place[0]) << " and "
            << std::abs(place[2] - place[1]) << "; the opposite ones have "
            << std::abs(place[3] - place[2]) << " and " << std::abs(place[0] - place[3]) << '\n';
}
