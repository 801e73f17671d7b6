// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Writes an intrinsic Delaunay triangulation to a file, reads it again, and flips it back to the
// input.

#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/flip_to.h>
#include <CGAL/Intrinsic_triangulations/io.h>
#include <CGAL/Intrinsic_triangulations/make_Delaunay.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <fstream>
#include <iostream>

namespace IT = CGAL::Intrinsic_triangulations;
typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Mesh;

int main(int argc, char* argv[])
{
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : CGAL::data_file_path("meshes/cow.off"),
                                  mesh))
    return 1;

  IT::Intrinsic_triangulation<> tri(mesh);
  IT::make_Delaunay(tri);
  {
    std::ofstream out("delaunay.intrinsic");
    if(!IT::write_intrinsic_triangulation(out, tri))
      return 1;
  }

  std::ifstream in("delaunay.intrinsic");
  auto loaded = IT::read_intrinsic_triangulation(in);
  std::size_t different_lengths = 0;
  for(IT::Edge_index e : tri.mesh().edges())
    different_lengths += tri.length(e) != loaded.length(e) ? 1 : 0;
  std::cout << different_lengths << " lengths differ\n"
            << IT::flip_to_input(loaded) << " flips lead back to the mesh\n";
}
