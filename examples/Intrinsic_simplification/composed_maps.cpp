// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Maps points through three surfaces: a mesh, its Delaunay refinement, and a simplification of the
// refinement.

#include <CGAL/Intrinsic_simplification/Composed_map.h>
#include <CGAL/Intrinsic_simplification/Correspondence_map.h>
#include <CGAL/Intrinsic_simplification/Evolving_surface.h>
#include <CGAL/Intrinsic_simplification/Surface_level.h>
#include <CGAL/Intrinsic_simplification/Surface_map.h>
#include <CGAL/Intrinsic_simplification/prolongation.h>
#include <CGAL/Intrinsic_simplification/simplify.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/refine.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <iostream>

namespace IS = CGAL::Intrinsic_simplification;
namespace IT = CGAL::Intrinsic_triangulations;
typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Mesh;

int main(int argc, char* argv[])
{
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : CGAL::data_file_path("meshes/fandisk.off"),
                                  mesh))
    return 1;
  IT::Intrinsic_triangulation<> tri(mesh);
  IT::refine(tri);
  tri.collect_garbage();

  IS::Evolving_surface surface(tri);
  const IS::Surface_level fine(surface);
  IS::simplify(surface, IS::parameters::number_of_vertices(200));
  const IS::Surface_level coarse(surface);

  const IS::Correspondence_map to_refined(tri);               // by integer coordinates
  const IS::Surface_map to_simplified(surface, fine, coarse); // by the history of operations
  const IS::Composed_map map(to_refined, to_simplified);

  const auto there = map.to_coarse({IS::Face_index(5), {.2, .3, .5}});
  const auto back = map.to_fine(there);
  std::cout << "a point of face 5 is in face " << there.first
            << " of the coarse surface; back: face " << back.first << ", " << back.second[0] << ' '
            << back.second[1] << ' ' << back.second[2] << '\n';
  const auto p = IS::prolongation_matrix(map);
  std::cout << "functions on " << p.cols() << " vertices become functions on " << p.rows() << '\n';
}
