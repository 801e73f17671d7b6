// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Simplifies a surface.

#include <CGAL/Intrinsic_simplification/Evolving_surface.h>
#include <CGAL/Intrinsic_simplification/simplify.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <iostream>

typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Mesh;

int main()
{
  Mesh mesh;
  namespace IS = CGAL::Intrinsic_simplification;
  IS::Evolving_surface surface(mesh);
  std::cout << IS::simplify(surface, IS::parameters::number_of_vertices(100)).removed << '\n';
}
