// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Maps a surface to the plane.

#include <CGAL/Discrete_conformal_maps/flatten.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <iostream>

typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Mesh;

int main()
{
  Mesh mesh;
  const auto map = CGAL::Discrete_conformal_maps::flatten(mesh);
  std::cout << static_cast<int>(map.status()) << '\n';
}
