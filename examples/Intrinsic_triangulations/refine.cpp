// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Inserts vertices until no angle is below 25 degrees, prints the position of the first one on the
// mesh, and writes the common subdivision.

#include <CGAL/Intrinsic_triangulations/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/interpolation.h>
#include <CGAL/Intrinsic_triangulations/refine.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <fstream>
#include <iostream>

namespace IT = CGAL::Intrinsic_triangulations;
typedef CGAL::Simple_cartesian<double>::Point_3 Point;
typedef CGAL::Surface_mesh<Point> Mesh;

int main(int argc, char* argv[])
{
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : CGAL::data_file_path("meshes/blade.off"),
                                  mesh))
    return 1;

  IT::Intrinsic_triangulation<> tri(mesh);
  const IT::Refinement_result result = IT::refine(tri, IT::parameters::minimum_angle(25));
  std::cout << tri.number_of_inserted_vertices() << " vertices inserted, "
            << IT::to_string(result.status) << '\n';
  for(const IT::Remaining_face& f : result.remaining)
    std::cout << f.face << " is below the bound: " << IT::to_string(f.reason) << '\n';

  // The vertices of the mesh keep their indices, and inserted ones come after them.
  if(tri.number_of_inserted_vertices() > 0) {
    const IT::Vertex_index first(tri.input_mesh().number_of_vertices());
    const auto [face, coordinates] =
      IT::face_location(tri.inserted_vertex(first), tri.input_mesh());
    std::cout << "the first lies in " << face << " of the mesh, at " << coordinates[0] << ", "
              << coordinates[1] << ", " << coordinates[2] << '\n';
  }

  const IT::Correspondence<> correspondence(tri);
  IT::Common_subdivision<IT::Euclidean_geometry_traits<double>, Point> subdivision(correspondence);
  IT::interpolate(IT::Side::input, subdivision, mesh.points(), subdivision.mesh().points());
  std::ofstream out("refined.ply");
  return CGAL::IO::write_PLY(out, subdivision.mesh()) ? 0 : 1;
}
