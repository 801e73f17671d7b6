// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Draws the edges of a coarse surface on the input: traces one of them, and writes the common
// subdivision of both levels. Each of its faces has its coarse face.

#include <CGAL/Intrinsic_simplification/Evolving_surface.h>
#include <CGAL/Intrinsic_simplification/Surface_level.h>
#include <CGAL/Intrinsic_simplification/Surface_map.h>
#include <CGAL/Intrinsic_simplification/Surface_subdivision.h>
#include <CGAL/Intrinsic_simplification/simplify.h>
#include <CGAL/Intrinsic_simplification/trace.h>
#include <CGAL/Polygon_mesh_processing/locate.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/PLY.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <fstream>
#include <iostream>

namespace IS = CGAL::Intrinsic_simplification;
namespace IT = CGAL::Intrinsic_triangulations;
namespace PMP = CGAL::Polygon_mesh_processing;
typedef CGAL::Simple_cartesian<double>::Point_3 Point;
typedef CGAL::Surface_mesh<Point> Mesh;

int main(int argc, char* argv[])
{
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : CGAL::data_file_path("meshes/elephant.off"),
                                  mesh))
    return 1;

  IS::Evolving_surface surface(mesh);
  const IS::Surface_level fine(surface);
  IS::simplify(surface, IS::parameters::number_of_vertices(mesh.number_of_vertices() / 20));
  const IS::Surface_level coarse(surface);
  const IS::Surface_map map(surface, fine, coarse);

  const auto position = [&](const auto& piece, std::size_t end) {
    return PMP::construct_point(std::make_pair(piece.face, piece.ends[end].coordinates), mesh);
  };
  const auto trace = IS::trace_coarse_edge(coarse.mesh().halfedge(IS::Edge_index(0)), map);
  std::cout << "the first edge of the coarse surface has " << trace.size()
            << " pieces; it leads from " << position(trace.front(), 0) << " to "
            << position(trace.back(), 1) << '\n';

  IS::Surface_subdivision<Point> subdivision(map);
  Mesh& polygons = subdivision.mesh();
  for(Mesh::Vertex_index v : polygons.vertices())
    polygons.point(v) = PMP::construct_point(
      IT::face_location(subdivision.place(IS::Level::fine, v), subdivision.mesh(IS::Level::fine)),
      mesh);
  auto coarse_face = polygons.add_property_map<Mesh::Face_index, int>("f:coarse_face", 0).first;
  for(Mesh::Face_index f : polygons.faces())
    coarse_face[f] = static_cast<int>(subdivision.parent_face(IS::Level::coarse, f));
  std::ofstream file("subdivision.ply");
  CGAL::IO::write_PLY(file, polygons);
  std::cout << polygons.number_of_faces() << " polygons are in subdivision.ply\n";
}
