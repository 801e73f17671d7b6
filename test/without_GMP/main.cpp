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

// Returns a tube of n by n (an even number) quadrangles, with columns that come as close as
// rounding allows: `width` to the power of n.
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

// Returns rectangles in a plane, each of them a tie.
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

// Returns whether the place of a crossing next to the end of an edge, which takes more than 512
// bits, is enclosed by neighboring numbers.
bool is_enclosed_near_a_vertex()
{
  const double place = std::ldexp(1., -650);
  Mesh mesh;
  const auto i = mesh.add_vertex(Point(0, 0, 0)), j = mesh.add_vertex(Point(1, 0, 0)),
             k = mesh.add_vertex(Point(0, 0.25, 0)),
             l = mesh.add_vertex(Point(2 * place, -0.25, 0));
  mesh.add_face(i, j, k);
  mesh.add_face(j, i, l);
  Triangulation t(mesh);
  t.flip(t.mesh().halfedge(IT::Vertex_index(0), IT::Vertex_index(1)));
  const auto enclosed = IT::enclose_crossing(IT::Correspondence(t), 0, 0).on_input.t;
  return expect(enclosed.inf() <= place && place <= enclosed.sup() &&
                  enclosed.sup() - enclosed.inf() <= place * 0x1p-50,
                "place of a crossing near a vertex");
}

// Returns a strip folded along parallel lines into panels, whose widths are roots. Four vertices at
// two heights on its ends are cocircular. Two of eight roots are products of others.
Mesh folded_strip()
{
  const std::array<std::array<double, 2>, 8> step{
    {{1, 1}, {2, 1}, {3, 1}, {3, -2}, {5, 1}, {4, 1}, {5, -2}, {6, 1}}};
  Mesh mesh;
  const auto add_column = [&](double x, double z, const std::vector<double>& heights) {
    std::vector<Mesh::Vertex_index> column;
    for(double y : heights)
      column.push_back(mesh.add_vertex(Point(x, y, z)));
    return column;
  };
  double x = 0, z = 0;
  auto last = add_column(x, z, {-999, 0, 57, 999});
  for(const auto& s : step) {
    x += s[0];
    z += s[1];
    const bool is_end = &s == &step.back();
    const auto column = add_column(
      x, z, is_end ? std::vector<double>{-999, 0, 57, 999} : std::vector<double>{-999, 999});
    for(std::size_t i = 0; i + 1 < last.size(); ++i)
      mesh.add_face(last[i], column[0], last[i + 1]);
    for(std::size_t i = 0; i + 1 < column.size(); ++i)
      mesh.add_face(last.back(), column[i], column[i + 1]);
    last = column;
  }
  return mesh;
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
                      is_good(tube(4, 1e-4), 0, "thin tube") &&
                      is_good(folded_strip(), 1, "folded strip") && is_enclosed_near_a_vertex() &&
                      is_refined(rectangles(1, 9));
  return result ? EXIT_SUCCESS : EXIT_FAILURE;
}
