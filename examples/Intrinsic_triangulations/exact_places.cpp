// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Computes exactly the crossings of the edges of two triangulations of a thin kite, and the
// positions of points of one on the other.

#include <CGAL/Intrinsic_triangulations/Exact_Euclidean_geometry_traits.h>
#include <CGAL/Intrinsic_triangulations/element_across.h>
#include <CGAL/Intrinsic_triangulations/enclose_crossing.h>
#include <CGAL/Intrinsic_triangulations/make_Delaunay.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <iostream>
#include <variant>

namespace IT = CGAL::Intrinsic_triangulations;

typedef CGAL::Simple_cartesian<double>::Point_3 Point;
typedef IT::Exact_Euclidean_geometry_traits<> Traits;

int main()
{
  CGAL::Surface_mesh<Point> mesh;
  const auto a = mesh.add_vertex(Point(-1, 0, 0)), b = mesh.add_vertex(Point(0, -1e-9, 0));
  const auto c = mesh.add_vertex(Point(2, 0, 0)), d = mesh.add_vertex(Point(0, 1e-9, 0));
  mesh.add_face(a, b, c);
  mesh.add_face(a, c, d);

  IT::Intrinsic_triangulation<Traits> tri(mesh);
  IT::make_Delaunay(tri); // the diagonal from b to d
  const IT::Correspondence<Traits> correspondence(tri);

  const auto place = IT::enclose_crossing(correspondence, 0);
  std::cout.precision(17);
  std::cout << "The diagonals cross at " << place.on_input.t << " of the long one\n";

  // Barycentric coordinates in the first face of the input are divided by their sum.
  for(const auto& p : {std::array{2., 0., 1.}, std::array{3., 1., 1.}}) {
    const IT::Surface_element element =
      IT::element_across(correspondence, IT::Side::input, {IT::Face_index(0), p});
    std::cout << (std::holds_alternative<IT::Edge_index>(element) ? "on an edge\n" : "in a face\n");
  }
}
