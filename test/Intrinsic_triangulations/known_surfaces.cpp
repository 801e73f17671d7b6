// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "known_surfaces.h"

namespace Test_surfaces {

Complex random_vector(double length, CGAL::Random& random)
{
  return std::polar(length * random.get_double(0.01, 1), random.get_double(-pi, pi));
}

std::vector<Cone> cones()
{
  return {Cone({0.3}),
          Cone({1.1, 0.4}),
          Cone({1, 0.2, 0.7}),
          Cone({2, 1.5, 2, 0.7}),
          Cone({2.5, 2.5, 2.5, 1}),
          Cone({1e-9, 1, 1e-9, 2, 0.01})};
}

std::array<Point, 3> corners(Face_index f, const Mesh& mesh)
{
  const Halfedge_index h = mesh.halfedge(f);
  return {mesh.point(mesh.source(h)), mesh.point(mesh.target(h)),
          mesh.point(mesh.target(mesh.next(h)))};
}

Location locate(const Point& p, const Mesh& mesh)
{
  for(Face_index f : mesh.faces()) {
    const auto [a, b, c] = corners(f, mesh);
    const Kernel::Vector_3 n = CGAL::cross_product(b - a, c - a);
    const auto part = [&](const Point& q, const Point& r) {
      return CGAL::cross_product(q - p, r - p) * n / n.squared_length();
    };
    const std::array<double, 3> w{part(b, c), part(c, a), part(a, b)};
    if(std::abs((p - a) * n) < 1e-12 && *std::min_element(w.begin(), w.end()) >= 0)
      return {f, w};
  }
  throw std::logic_error("the point is not on the surface");
}

void check_all(void (&check)(Side, const Triangulation&))
{
  for(const Named_triangulation& t : triangulations())
    for(Side side : both_sides) {
      SCOPED_TRACE(t.name + (side == Side::input ? ", T1" : ", T2"));
      check(side, t.triangulation);
    }
}

} // namespace Test_surfaces
