// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/Edge_paths.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/homology_basis.h>
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
  const auto loops = IT::homology_basis(triangulation);
  std::cout << loops.size() << " loops\n";
  for(const auto& loop : loops) {
    triangulation.reset_to_input();
    IT::Edge_paths paths(triangulation);
    paths.add_loop(loop);
    const double before = paths.length(0);
    const auto status = paths.shorten();
    std::cout << to_string(status) << ": length " << before << " before, " << paths.length(0)
              << " after " << paths.number_of_flips() << " flips\n";
  }
}
