// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Computes curves of equal distance from a vertex on the intrinsic Delaunay triangulation, and maps
// them to the mesh.

#include <CGAL/Intrinsic_triangulations/Correspondence.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/curve_across.h>
#include <CGAL/Intrinsic_triangulations/heat_distance.h>
#include <CGAL/Intrinsic_triangulations/level_set.h>
#include <CGAL/Intrinsic_triangulations/make_Delaunay.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <iostream>

namespace IT = CGAL::Intrinsic_triangulations;
typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Mesh;

int main(int argc, char* argv[])
{
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : CGAL::data_file_path("meshes/camel.off"),
                                  mesh))
    return 1;

  IT::Intrinsic_triangulation<> tri(mesh);
  IT::make_Delaunay(tri);
  const IT::Correspondence<> correspondence(tri);
  const Eigen::VectorXd distance = IT::heat_distance(tri.intrinsic(), IT::Vertex_index(0));
  for(const double part : {0.25, 0.5, 0.75})
    for(const IT::Surface_path<double>& curve :
        IT::level_set(tri.intrinsic(), distance, part * distance.maxCoeff()))
      std::cout << "at " << part << " of the greatest distance: length " << curve.length << ", "
                << IT::curve_across(correspondence, IT::Side::intrinsic, curve).places.size()
                << " points on the mesh\n";
}
