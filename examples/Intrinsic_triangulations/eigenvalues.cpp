// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Computes the first eigenvalues of the Laplacian on the intrinsic Delaunay triangulation of a
// sphere. The eigenvalues of the unit sphere are 0, 2 (three times), and 6 (five times).

#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/make_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/operators.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <Eigen/Dense>

#include <iostream>

namespace IT = CGAL::Intrinsic_triangulations;
typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Mesh;

int main(int argc, char* argv[])
{
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : CGAL::data_file_path("meshes/sphere.off"),
                                  mesh))
    return 1;

  IT::Intrinsic_triangulation<> tri(mesh);
  IT::make_Delaunay(tri);

  // A dense solver suffices for some hundred vertices. For more, use a sparse one, such as Spectra.
  const Eigen::MatrixXd stiffness = IT::cotan_laplacian(tri.intrinsic()),
                        mass = IT::mass_matrix(tri.intrinsic());
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> solver(stiffness, mass,
                                                                         Eigen::EigenvaluesOnly);
  if(solver.info() != Eigen::Success)
    return 1;
  const double squared_radius = mass.sum() / (4 * CGAL_PI);
  for(int i = 1; i < 9; ++i)
    std::cout << solver.eigenvalues()[i] * squared_radius << (i < 8 ? ' ' : '\n');
}
