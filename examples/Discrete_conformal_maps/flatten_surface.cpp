// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Maps a surface to the plane, and writes it with texture coordinates.

#include <CGAL/Discrete_conformal_maps/common_subdivision_mesh.h>
#include <CGAL/Discrete_conformal_maps/flatten.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <fstream>
#include <iostream>
#include <string>

namespace DCM = CGAL::Discrete_conformal_maps;
typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
typedef Mesh::Property_map<Mesh::Halfedge_index, Kernel::Point_2> Texture;

void write_obj(std::ostream& out, const Mesh& mesh, const Texture& uv)
{
  for(const auto& p : mesh.points())
    out << "v " << p << '\n';
  std::size_t corners = 0;
  for(auto f : mesh.faces()) {
    std::string face = "f";
    for(auto h : halfedges_around_face(mesh.halfedge(f), mesh)) {
      out << "vt " << uv[h] << '\n';
      face += ' ' + std::to_string(mesh.target(h) + 1) + '/' + std::to_string(++corners);
    }
    out << face << '\n';
  }
}

int main(int argc, char* argv[])
{
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : CGAL::data_file_path("meshes/cow.off"),
                                  mesh))
    return 1;

  const DCM::Planar_conformal_map map = DCM::flatten(mesh);
  if(map.status() != DCM::Map_status::success) {
    std::cerr << DCM::message(map.status()) << '\n';
    return 1;
  }

  std::cout << map.cones().size() << " cones; " << map.minimization().iterations
            << " steps of Newton's method; no other vertex has a curvature above "
            << map.max_curvature_error() << '\n';

  // This is the mesh, cut such that the map is projective on each face.
  Mesh flat;
  const Texture uv = flat.add_property_map<Mesh::Halfedge_index, Kernel::Point_2>("h:uv").first;
  DCM::common_subdivision(
    map, flat, DCM::parameters::input_point_map(mesh.points()).texture_coordinates_map(uv));
  std::ofstream out("flat.obj");
  write_obj(out, flat, uv);
  return out ? 0 : 1;
}
