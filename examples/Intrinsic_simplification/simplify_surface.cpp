// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Simplifies a surface to a twentieth of its vertices, and maps a point to it and back. Compares
// the solution of a Poisson equation on the coarse surface with the fine solution.

#include <CGAL/Intrinsic_simplification/Evolving_surface.h>
#include <CGAL/Intrinsic_simplification/Surface_level.h>
#include <CGAL/Intrinsic_simplification/Surface_map.h>
#include <CGAL/Intrinsic_simplification/prolongation.h>
#include <CGAL/Intrinsic_simplification/simplify.h>
#include <CGAL/Intrinsic_triangulations/operators.h>
#include <CGAL/Intrinsic_triangulations/poisson.h>
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
  if(!CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : CGAL::data_file_path("meshes/elephant.off"),
                                  mesh))
    return 1;

  IS::Evolving_surface surface(mesh);
  const IS::Surface_level fine(surface);
  const auto result =
    IS::simplify(surface, IS::parameters::number_of_vertices(mesh.number_of_vertices() / 20));
  const IS::Surface_level coarse(surface);
  const IS::Surface_map map(surface, fine, coarse);
  std::cout << result.removed << " vertices removed, " << coarse.mesh().number_of_vertices()
            << " left\n";

  // The center of the first face is mapped to the coarse surface, and back.
  const IS::Surface_map::Location there =
    map.to_coarse({IS::Face_index(0), {1. / 3, 1. / 3, 1. / 3}});
  const IS::Surface_map::Location back = map.to_fine(there);
  std::cout << "its image is in face " << there.first << ", the way back leads to face "
            << back.first << " at " << back.second[0] << ' ' << back.second[1] << ' '
            << back.second[2] << '\n';

  // The third coordinate is the right-hand side.
  Eigen::VectorXd height(mesh.number_of_vertices());
  for(Mesh::Vertex_index v : mesh.vertices())
    height[v] = mesh.point(v).z();
  const Eigen::VectorXd moments = IT::lumped_mass_matrix(fine) * height;
  const Eigen::SparseMatrix<double> prolongation = IS::prolongation_matrix(map);
  const Eigen::VectorXd exact = IT::Poisson_solver<>(fine).solve(moments);
  const Eigen::VectorXd approximate =
    prolongation * IT::Poisson_solver<>(coarse).solve(prolongation.transpose() * moments);
  std::cout << "the solution on the coarse surface differs by "
            << 100 * (approximate - exact).norm() / exact.norm() << " percent\n";
}
