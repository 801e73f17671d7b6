// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Prints every digit of the results of functions of the compiled library. It is compiled with the
// library and without.

#include <CGAL/Discrete_conformal_maps/flatten.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Intrinsic_simplification/Evolving_surface.h>
#include <CGAL/Intrinsic_simplification/simplify.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/make_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/refine.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <cmath>
#include <cstddef>
#include <iostream>
#include <random>
#include <vector>

namespace DCM = CGAL::Discrete_conformal_maps;
namespace IS = CGAL::Intrinsic_simplification;
namespace IT = CGAL::Intrinsic_triangulations;

// Returns a torus, or a part of it with boundary, of triangles of all shapes.
template <typename Point>
CGAL::Surface_mesh<Point> torus(std::size_t n, bool is_closed)
{
  CGAL::Surface_mesh<Point> mesh;
  std::mt19937 random(5);
  const auto noise = [&] { return std::ldexp(static_cast<double>(random()), -33); };
  std::vector<typename CGAL::Surface_mesh<Point>::Vertex_index> vertex;
  for(std::size_t i = 0; i < n * n; ++i) {
    const double a = 6.283185307179586 * (double(i / n) + noise()) / double(n),
                 b = 6.283185307179586 * (double(i % n) + noise()) / double(n);
    const double radius = 3 + std::cos(b);
    vertex.push_back(
      mesh.add_vertex(Point(radius * std::cos(a), radius * std::sin(a), std::sin(b))));
  }
  const std::size_t end = is_closed ? n : n - 1;
  for(std::size_t i = 0; i < end; ++i)
    for(std::size_t j = 0; j < end; ++j) {
      const auto at = [&](std::size_t k, std::size_t l) { return vertex[k % n * n + l % n]; };
      mesh.add_face(at(i, j), at(i + 1, j), at(i + 1, j + 1));
      mesh.add_face(at(i, j), at(i + 1, j + 1), at(i, j + 1));
    }
  return mesh;
}

template <typename Surface>
void print_lengths(const Surface& surface)
{
  for(IT::Edge_index e : surface.mesh().edges())
    std::cout << surface.length(e) << ' ';
  std::cout << '\n';
}

template <typename Mesh>
void print_results(const Mesh& mesh)
{
  IT::Intrinsic_triangulation<> tri(mesh), exact(mesh);
  std::cout << IT::make_Delaunay(tri) << ' '
            << IT::make_Delaunay(exact, IT::parameters::exact_decisions(true)) << '\n';
  print_lengths(tri);
  print_lengths(exact);
  std::cout << IT::refine(tri).insertions << ' '
            << IT::refine(exact, IT::parameters::exact_decisions(true)).insertions << '\n';
  print_lengths(tri);
  print_lengths(exact);

  IS::Evolving_surface surface(mesh);
  const auto simplified =
    IS::simplify(surface, IS::parameters::number_of_vertices(mesh.number_of_vertices() / 5));
  std::cout << simplified.removed << ' ' << simplified.greatest_cost << '\n';
  print_lengths(surface.surface());

  const auto map = DCM::flatten(mesh);
  std::cout << static_cast<int>(map.status()) << '\n';
  for(IT::Halfedge_index h : map.ideal().mesh().halfedges())
    if(!map.ideal().mesh().is_border(h))
      std::cout << map.position(h) << ' ';
  std::cout << '\n';
}

int main()
{
  std::cout << std::hexfloat;
  print_results(torus<CGAL::Simple_cartesian<double>::Point_3>(24, true));
  print_results(torus<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3>(24, false));
}
