// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Builds the common subdivision of a mesh and its intrinsic Delaunay triangulation, gives it
// positions and writes it to a file.

#include <CGAL/Intrinsic_triangulations/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/Correspondence.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/interpolation.h>
#include <CGAL/Intrinsic_triangulations/make_Delaunay.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <algorithm>
#include <iostream>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;
typedef CGAL::Simple_cartesian<double>::Point_3 Point;
typedef CGAL::Surface_mesh<Point> Mesh;
typedef IT::Intrinsic_triangulation<> Triangulation;

int main(int argc, char* argv[])
{
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : CGAL::data_file_path("meshes/cow.off"),
                                  mesh))
    return 1;

  Triangulation tri(mesh);
  IT::make_Delaunay(tri);

  const IT::Correspondence<> correspondence(tri);
  IT::Common_subdivision<Triangulation::Traits, Point> subdivision(correspondence);
  IT::interpolate(IT::Side::input, subdivision, mesh.points(), subdivision.mesh().points());

  // This finds the face of the Delaunay triangulation that is cut into most parts.
  std::vector<int> parts(tri.mesh().number_of_faces(), 0);
  for(IT::Face_index f : subdivision.mesh().faces())
    ++parts[subdivision.parent_face(IT::Side::intrinsic, f)];
  const auto most = std::max_element(parts.begin(), parts.end());

  std::cout << mesh.number_of_faces() << " faces, cut into " << subdivision.mesh().number_of_faces()
            << " polygons\n"
            << "face " << most - parts.begin() << " of the Delaunay triangulation is cut into "
            << *most << '\n';
  return CGAL::IO::write_polygon_mesh("common_subdivision.ply", subdivision.mesh()) ? 0 : 1;
}
