// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Refines a triangulation.

#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/refine.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <iostream>

typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Mesh;

int main()
{
  Mesh mesh;
  CGAL::Intrinsic_triangulations::Intrinsic_triangulation<> tri(mesh);
  std::cout << CGAL::Intrinsic_triangulations::refine(tri).insertions << '\n';
}
