// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Lays two Delaunay triangulations of one surface over each other, without and with sharp edges as
// constraints, and flips one to the other. Then refines the first one, and lays it over the second
// one with inserted vertices.

#include <CGAL/Intrinsic_triangulations/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/Correspondence.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/flip_to.h>
#include <CGAL/Intrinsic_triangulations/make_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/rebase.h>
#include <CGAL/Intrinsic_triangulations/refine.h>
#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <iostream>

namespace IT = CGAL::Intrinsic_triangulations;
typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Mesh;

int main(int argc, char* argv[])
{
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(
       argc > 1 ? argv[1] : CGAL::data_file_path("meshes/anchor_dense.off"), mesh))
    return 1;
  auto is_sharp = mesh.add_property_map<Mesh::Edge_index, bool>("e:is_sharp", false).first;
  CGAL::Polygon_mesh_processing::detect_sharp_edges(mesh, 60, is_sharp);

  IT::Intrinsic_triangulation<> free(mesh),
    constrained(mesh, CGAL::parameters::edge_is_constrained_map(is_sharp));
  IT::make_Delaunay(free);
  IT::make_Delaunay(constrained);

  const auto over = IT::rebase(free, constrained);
  std::size_t shared = 0;
  for(IT::Edge_index e : over.mesh().edges())
    if(over.coordinates().is_shared(e))
      ++shared;
  std::cout << shared << " of " << over.mesh().number_of_edges() << " edges are in both, and "
            << IT::Common_subdivision<>(IT::Correspondence<>(over)).mesh().number_of_faces()
            << " faces in their common subdivision\n";
  auto refined = free;
  std::cout << IT::flip_to(free, constrained) << " flips lead from one to the other\n";

  IT::refine(refined, IT::parameters::minimum_angle(25));
  refined.collect_garbage();
  std::cout << "refined, the first one has "
            << IT::rebase(constrained, refined).number_of_inserted_vertices()
            << " vertices more, and " << IT::flip_to(refined, constrained) << " flips lead back\n";
}
