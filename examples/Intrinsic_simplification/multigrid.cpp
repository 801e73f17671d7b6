// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Computes the flow of heat on a surface in growing steps. Each step has a new matrix, but all
// share one hierarchy.

#include <CGAL/Intrinsic_simplification/Evolving_surface.h>
#include <CGAL/Intrinsic_simplification/Multigrid_solver.h>
#include <CGAL/Intrinsic_simplification/Surface_level.h>
#include <CGAL/Intrinsic_simplification/prolongation_hierarchy.h>
#include <CGAL/Intrinsic_triangulations/operators.h>
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
  const auto prolongations = IS::prolongation_hierarchy(surface);
  const Eigen::SparseMatrix<double> laplacian = IT::cotan_laplacian(fine);
  const Eigen::SparseMatrix<double> mass = IT::lumped_mass_matrix(fine);
  std::cout << prolongations.size() << " coarse levels\n";

  // The first vertex has one unit of heat.
  Eigen::VectorXd heat = Eigen::VectorXd::Zero(mass.cols());
  heat[0] = 1 / mass.coeff(0, 0);
  for(double time = 1e-4; time < 1; time *= 10) {
    const IS::Multigrid_solver solver(mass + time * laplacian, mass.diagonal(), prolongations);
    const IS::Multigrid_result result = solver.solve(mass * heat);
    std::cout << "after a step of " << time << ": " << to_string(result.status) << " in "
              << result.iterations << " iterations, the greatest heat is "
              << result.solution.maxCoeff() << '\n';
    heat = result.solution;
  }
}
