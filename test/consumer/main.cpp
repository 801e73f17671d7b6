// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/Correspondence.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/make_Delaunay.h>

#ifdef CGAL_INTRINSIC_TRIANGULATIONS_USE_CHOLMOD
#include <CGAL/Discrete_conformal_maps/flatten.h>
#endif

#ifdef WITH_CERES
#include <CGAL/Discrete_conformal_maps/Ceres_minimizer.h>
#include <CGAL/Discrete_conformal_maps/flatten.h>
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

// Returns whether the mesh is flattened. Without a component, the functions that need it are not
// called.
bool is_flattened([[maybe_unused]] const Mesh& mesh)
{
#if defined(CGAL_INTRINSIC_TRIANGULATIONS_USE_CHOLMOD) || defined(WITH_CERES)
  namespace DCM = CGAL::Discrete_conformal_maps;
#endif
#ifdef CGAL_INTRINSIC_TRIANGULATIONS_USE_CHOLMOD
  if(DCM::flatten(mesh).status() != DCM::Map_status::success)
    return false;
#endif
#ifdef WITH_CERES
  if(DCM::flatten(mesh, DCM::parameters::minimizer(DCM::Ceres_minimizer())).status() !=
     DCM::Map_status::success)
    return false;
#endif
  return true;
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
                    correspondence.number_of_crossings() == 1 && is_flattened(mesh);
  return good ? EXIT_SUCCESS : EXIT_FAILURE;
}
