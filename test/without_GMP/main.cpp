// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "all_headers.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <random>
#include <vector>

#if defined(CGAL_USE_GMP) || defined(CGAL_USE_MPFR) || defined(__GMP_H__)
#error "CGAL is to be without GMP and MPFR here"
#endif

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Triangulation = IT::Intrinsic_triangulation<IT::Exact_Euclidean_geometry_traits<>>;

// A tube of n by n (an even number) quadrangles, with columns that come as close as rounding
// allows: `width` to the power of n.
Mesh tube(std::size_t n, double width)
{
  Mesh mesh;
  std::vector<Mesh::Vertex_index> v;
  for(std::size_t i = 0; i <= n; ++i)
    for(std::size_t j = 0; j < n; ++j) {
      const double angle = 6 * std::pow(width, double(j)), x = double(i) + (j % 2 == 0 ? 0 : 0.3);
      v.push_back(mesh.add_vertex(Point(std::cos(angle), std::sin(angle), x)));
    }
  for(std::size_t i = 0; i < n; ++i)
    for(std::size_t j = 0; j < n; ++j) {
      const std::size_t k = i * n + j, l = i * n + (j + 1) % n;
      mesh.add_face(v[k], v[l], v[l + n]);
      mesh.add_face(v[k], v[l + n], v[k + n]);
    }
  return mesh;
}

// Rectangles, each of them a tie, in a plane.
Mesh rectangles(std::size_t n, double width)
{
  Mesh mesh;
  std::vector<Mesh::Vertex_index> v;
  for(std::size_t i = 0; i <= n; ++i)
    for(std::size_t j = 0; j <= n; ++j) {
      const double x = width * double(i), y = double(j);
      v.push_back(mesh.add_vertex(Point(2 * x - y, 2 * x + 2 * y, x - 2 * y)));
    }
  for(std::size_t i = 0; i < n; ++i)
    for(std::size_t j = 0; j < n; ++j) {
      const std::size_t k = i * (n + 1) + j;
      mesh.add_face(v[k], v[k + n + 1], v[k + n + 2]);
      mesh.add_face(v[k], v[k + n + 2], v[k + 1]);
    }
  return mesh;
}

void shuffle(Triangulation& t)
{
  std::mt19937 random(1);
  for(std::size_t i = 0; i < t.mesh().number_of_edges(); ++i) {
    const auto h = t.mesh().halfedge(
      IT::Edge_index(static_cast<unsigned int>(random() % t.mesh().number_of_edges())));
    if(t.is_flippable(h))
      t.flip(h);
  }
}

bool expect(bool condition, const char* what)
{
  if(!condition)
    std::cerr << "failed: " << what << '\n';
  return condition;
}

bool is_good(const Mesh& mesh, std::size_t ties, const char* name)
{
  std::cout << name << std::endl;
  Triangulation t(mesh);
  shuffle(t);
  IT::make_Delaunay(t);
  const IT::Delaunay_certificate certificate = IT::certify_Delaunay(t);
  bool result = expect(certificate.is_Delaunay(), "Delaunay triangulation") &&
                expect(certificate.ties.size() == ties, "number of ties");
  const IT::Correspondence correspondence(t);
  for(unsigned int id = 0; id < correspondence.number_of_crossings(); ++id) {
    const auto place = IT::enclose_crossing(correspondence, id).on_input.t;
    result = expect(place.sup() - place.inf() <= 0x1p-50, "width of a place") && result;
  }
  return result;
}

bool is_refined(const Mesh& mesh)
{
  Triangulation t(mesh);
  const IT::Refinement_result refined = IT::refine(t);
  return expect(refined.status == IT::Refinement_status::bounds_met, "refinement") &&
         expect(IT::certify_Delaunay(t).is_Delaunay(), "refined triangulation");
}

} // namespace

int main()
{
  const bool result = is_good(rectangles(3, 1), 9, "squares") && is_good(tube(4, 0.5), 0, "tube") &&
                      is_good(tube(4, 1e-4), 0, "thin tube") && is_refined(rectangles(1, 9));
  return result ? EXIT_SUCCESS : EXIT_FAILURE;
}
