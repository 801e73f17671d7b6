// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Lists the pieces on which the map to a coarse surface is projective, and maps a point by the
// matrix of one piece.

#include <CGAL/Intrinsic_simplification/Evolving_surface.h>
#include <CGAL/Intrinsic_simplification/Surface_level.h>
#include <CGAL/Intrinsic_simplification/Surface_map.h>
#include <CGAL/Intrinsic_simplification/projective_pieces.h>
#include <CGAL/Intrinsic_simplification/simplify.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <array>
#include <cstddef>
#include <iostream>
#include <iterator>
#include <vector>

namespace IS = CGAL::Intrinsic_simplification;
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

  std::vector<IS::Projective_piece> pieces;
  IS::projective_pieces(map, std::back_inserter(pieces));
  std::cout << mesh.number_of_faces() << " faces have " << pieces.size() << " pieces\n";

  // The matrix maps the center of a piece.
  const IS::Projective_piece& piece = pieces.front();
  std::array<double, 3> middle{};
  for(const auto& corner : piece.corners)
    for(std::size_t c = 0; c < 3; ++c)
      middle[c] += corner.fine[c];
  const std::array<double, 3> image = piece.to_coarse(middle);
  std::cout << "the first, with " << piece.corners.size() << " corners, is in face "
            << piece.coarse_face << " of the coarse surface, around (" << image[0] << ", "
            << image[1] << ", " << image[2] << ")\n";
}
