// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Refines a triangulation that keeps the sharp edges of a mesh: vertices are inserted on them, and
// no edge crosses them.

#include <CGAL/Intrinsic_triangulations/refine.h>
#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <iostream>

namespace IT = CGAL::Intrinsic_triangulations;
namespace PMP = CGAL::Polygon_mesh_processing;
typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Mesh;

int main(int argc, char* argv[])
{
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : CGAL::data_file_path("meshes/fandisk.off"),
                                  mesh))
    return 1;

  const auto is_sharp = mesh.add_property_map<Mesh::Edge_index, bool>("e:is_sharp", false).first;
  PMP::detect_sharp_edges(mesh, 60, is_sharp);

  IT::Intrinsic_triangulation<> tri(mesh, IT::parameters::edge_is_constrained_map(is_sharp));
  const IT::Refinement_result result = IT::refine(tri, IT::parameters::minimum_angle(25));
  std::cout << tri.number_of_inserted_vertices() << " vertices inserted, "
            << IT::to_string(result.status) << '\n';

  double before = 0, after = 0;
  for(Mesh::Edge_index e : mesh.edges())
    if(is_sharp[e])
      before += tri.input_length(IT::Edge_index(e.idx()));
  for(IT::Edge_index e : tri.mesh().edges())
    if(tri.is_constrained(e))
      after += tri.length(e);
  std::cout << "length of sharp edges: " << before << " before, " << after << " after\n";
  return result.status == IT::Refinement_status::insertion_limit ? 1 : 0;
}
