// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/Correspondence.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/make_Delaunay.h>

#ifdef CGAL_INTRINSIC_TRIANGULATIONS_USE_CHOLMOD
#include <CGAL/Intrinsic_triangulations/Factorization.h>
#endif

#ifdef WITH_MAPS
#include <CGAL/Discrete_conformal_maps/flatten.h>
#endif

#ifdef WITH_CERES
#include <CGAL/Discrete_conformal_maps/Ceres_minimizer.h>
#endif

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <cstdlib>
#include <iostream>

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;

// Returns a thin quadrilateral cut along its long diagonal: one flip makes it Delaunay.
Mesh thin_quadrilateral()
{
  Mesh mesh;
  const auto a = mesh.add_vertex(Point(-2, 0, 0));
  const auto b = mesh.add_vertex(Point(0, -1, 0));
  const auto c = mesh.add_vertex(Point(2, 0, 0));
  const auto d = mesh.add_vertex(Point(0, 1, 0));
  mesh.add_face(a, b, c);
  mesh.add_face(a, c, d);
  return mesh;
}

// Returns whether 4 x = 2 is solved.
bool is_solved()
{
#ifdef CGAL_INTRINSIC_TRIANGULATIONS_USE_CHOLMOD
  Eigen::SparseMatrix<double> matrix(1, 1);
  matrix.insert(0, 0) = 4;
  const CGAL::Intrinsic_triangulations::Factorization<double> four(matrix, "matrix");
  return four.solve(Eigen::VectorXd::Constant(1, 2))[0] == 0.5;
#else
  return true;
#endif
}

#ifdef WITH_MAPS
// Returns whether the mesh is flattened under these named parameters.
template <typename NamedParameters>
bool is_flattened(const Mesh& mesh, const NamedParameters& np)
{
  namespace DCM = CGAL::Discrete_conformal_maps;
  return DCM::flatten(mesh, np).status() == DCM::Map_status::success;
}
#endif

// Returns whether all minimizers that are there flatten the mesh.
bool is_flattened([[maybe_unused]] const Mesh& mesh)
{
  bool good = true;
#ifdef WITH_MAPS
  good = is_flattened(mesh, CGAL::parameters::default_values());
#endif
#ifdef WITH_CERES
  namespace DCM = CGAL::Discrete_conformal_maps;
  good = is_flattened(mesh, DCM::parameters::minimizer(DCM::Ceres_minimizer())) && good;
#endif
  return good;
}

int main()
{
  const Mesh mesh = thin_quadrilateral();
  CGAL::Intrinsic_triangulations::Intrinsic_triangulation<> tri(mesh);
  const auto flips = CGAL::Intrinsic_triangulations::make_Delaunay(tri);
  std::cout << flips << " flip\n";
  const CGAL::Intrinsic_triangulations::Correspondence<> correspondence(
    tri,
    CGAL::Intrinsic_triangulations::parameters::concurrency_tag(CGAL::Parallel_if_available_tag()));
  const bool good = flips == 1 && CGAL::Intrinsic_triangulations::is_Delaunay(tri) &&
                    correspondence.number_of_crossings() == 1 && is_solved() && is_flattened(mesh);
  return good ? EXIT_SUCCESS : EXIT_FAILURE;
}
