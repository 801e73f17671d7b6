// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Lists the defects of a triangle soup with their elements, and shows the error of a constructor
// for a mesh with a defect.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/diagnose.h>
#include <CGAL/Surface_mesh.h>

#include <array>
#include <cstddef>
#include <iostream>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;
typedef CGAL::Exact_predicates_inexact_constructions_kernel::Point_3 Point;
typedef CGAL::Surface_mesh<Point> Mesh;

int main()
{
  // Three triangles share one edge, and one triangle has two corners at one point.
  const std::vector<Point> points{{0, 0, 0},  {1, 0, 0}, {0, 1, 0},
                                  {0, -1, 0}, {0, 0, 1}, {1, 0, 0}};
  const std::vector<std::array<std::size_t, 3>> triangles{
    {0, 1, 2}, {1, 0, 3}, {0, 1, 4}, {1, 5, 2}};
  const IT::Input_diagnosis diagnosis = IT::diagnose_polygon_soup(points, triangles);
  for(const IT::Defect_description& d : IT::defect_descriptions)
    if(diagnosis.count(d.kind) > 0)
      std::cout << (d.is_fatal ? "error: " : "note: ") << diagnosis.message(d.kind) << '\n';

  Mesh mesh;
  const auto a = mesh.add_vertex(Point(0, 0, 0)), b = mesh.add_vertex(Point(1, 0, 0)),
             c = mesh.add_vertex(Point(0, 0, 0));
  mesh.add_face(a, b, c);
  try {
    IT::Intrinsic_triangulation<> tri(mesh);
  } catch(const IT::Invalid_input& error) {
    std::cout << "the constructor: " << error.what() << '\n';
  }
}
