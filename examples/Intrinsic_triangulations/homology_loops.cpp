// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/geodesic_homology_basis.h>
#include <CGAL/Intrinsic_triangulations/make_Delaunay.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cstdlib>
#include <iostream>
#include <string>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
namespace IT = CGAL::Intrinsic_triangulations;

// Finds two closed geodesics for each handle, around it and through its hole. They come from loops
// along edges that generate all others; flips shorten each of them.
int main(int argc, char* argv[])
{
  const std::string file = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/eight.off");
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(file, mesh)) {
    std::cerr << "cannot read " << file << '\n';
    return EXIT_FAILURE;
  }
  IT::Intrinsic_triangulation<> triangulation(mesh);
  IT::make_Delaunay(triangulation); // edges of good triangles lead to short loops
  for(const auto& loop : IT::geodesic_homology_basis(triangulation))
    std::cout << to_string(loop.status) << ": length " << loop.length_along_edges << " before, "
              << loop.path.length << " after " << loop.number_of_flips << " flips\n";
}
