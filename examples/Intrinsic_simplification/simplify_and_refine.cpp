// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Simplifies a surface, and gives the coarse faces angles of 25 degrees. Solves a Poisson equation
// on the result, and prolongs the solution to the input.

#include <CGAL/Intrinsic_simplification/Evolving_surface.h>
#include <CGAL/Intrinsic_simplification/Surface_level.h>
#include <CGAL/Intrinsic_simplification/Surface_map.h>
#include <CGAL/Intrinsic_simplification/prolongation.h>
#include <CGAL/Intrinsic_simplification/refine.h>
#include <CGAL/Intrinsic_simplification/simplify.h>
#include <CGAL/Intrinsic_triangulations/angles.h>
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
  IS::simplify(surface, IS::parameters::number_of_vertices(mesh.number_of_vertices() / 50));
  const IS::Surface_level coarse(surface);
  const auto result = IS::refine(surface, IS::parameters::minimum_angle(25.));
  const IS::Surface_level refined(surface);
  std::cout << fine.mesh().number_of_vertices() << " -> " << coarse.mesh().number_of_vertices()
            << " -> " << refined.mesh().number_of_vertices() << " vertices, least angle "
            << IT::smallest_angle_in_degrees(coarse.mesh(), coarse.length_map()) << " -> "
            << IT::smallest_angle_in_degrees(refined.mesh(), refined.length_map()) << " degrees ("
            << IT::to_string(result.status) << ")\n";

  const IS::Surface_map map(surface, fine, refined);
  const auto p = IS::prolongation_matrix(map);
  Eigen::VectorXd height(mesh.number_of_vertices());
  for(const Mesh::Vertex_index v : mesh.vertices())
    height[v] = mesh.point(v).y();
  const Eigen::VectorXd moments = IT::lumped_mass_matrix(fine) * height;
  const Eigen::VectorXd solution = p * IT::Poisson_solver<>(refined).solve(p.transpose() * moments);
  std::cout << "the solution lies between " << solution.minCoeff() << " and " << solution.maxCoeff()
            << '\n';

  const auto on_refined = map.to_coarse({IS::Face_index(0), {0.5, 0.25, 0.25}});
  std::cout << "a point of face 0 of the input is in face " << on_refined.first
            << " of the refined surface, and back in face " << map.to_fine(on_refined).first
            << '\n';
}
