// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Maps a surface to the plane, and writes it with texture coordinates.

#include <CGAL/Discrete_conformal_maps/flatten.h>
#include <CGAL/Polygon_mesh_processing/locate.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <fstream>
#include <iostream>
#include <string>

namespace DCM = CGAL::Discrete_conformal_maps;
namespace PMP = CGAL::Polygon_mesh_processing;
typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Mesh;

// The polygons of the common subdivision in space, their corners with places in the plane.
void write_obj(std::ostream& out, const DCM::Planar_conformal_map& map, const Mesh& mesh)
{
  const auto& s = map.subdivision();
  for(auto v : s.mesh().vertices())
    if(const auto p = s.place(DCM::Layer::A, v).location; map.is_front(p.first))
      out << "v " << PMP::construct_point(p, mesh) << '\n';
    else
      out << "v 0 0 0\n"; // on the second copy of a surface with boundary
  std::size_t corners = 0;
  for(auto f : s.mesh().faces()) {
    if(!map.is_front(s.parent_face(DCM::Layer::A, f)))
      continue;
    std::string face = "f";
    for(auto h : halfedges_around_face(s.mesh().halfedge(f), s.mesh())) {
      const auto z = map.homogeneous_coordinates(s.location(DCM::Layer::C, h));
      out << "vt " << z[0] / z[2] << ' ' << z[1] / z[2] << '\n';
      face += ' ' + std::to_string(s.mesh().target(h) + 1) + '/' + std::to_string(++corners);
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

  std::cout << map.cones().size() << " cones; " << map.minimization().iterations
            << " steps of Newton's method; no other vertex has a curvature above "
            << map.max_curvature_error() << '\n';
  std::ofstream out("flat.obj");
  write_obj(out, map, mesh);
  return out ? 0 : 1;
}
