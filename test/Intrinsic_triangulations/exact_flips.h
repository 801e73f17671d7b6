// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_TRIANGULATIONS_TEST_EXACT_FLIPS_H
#define INTRINSIC_TRIANGULATIONS_TEST_EXACT_FLIPS_H

#include "hard_meshes.h"

#include <CGAL/Exact_rational.h>
#include <CGAL/Intrinsic_triangulations/Exact_Euclidean_geometry_traits.h>

// Flips with exact decisions, and of flat surfaces with the exact vectors of their edges.
namespace Test_surfaces {

using Exact_triangulation = IT::Intrinsic_triangulation<IT::Exact_Euclidean_geometry_traits<>>;

template <typename R>
int side_of_circle(const std::array<R, 2>& a, const std::array<R, 2>& b, const std::array<R, 2>& c)
{
  const auto square = [](const std::array<R, 2>& v) { return R(v[0] * v[0] + v[1] * v[1]); };
  const R determinant = a[0] * (b[1] * square(c) - c[1] * square(b)) -
                        a[1] * (b[0] * square(c) - c[0] * square(b)) +
                        square(a) * (b[0] * c[1] - b[1] * c[0]);
  return determinant > 0 ? 1 : determinant < 0 ? -1 : 0;
}

// Keeps the vectors of the edges of a flat surface while they are flipped. The third side of a
// triangle is minus the sum of the others.
struct Vector_keeper : IT::Default_flip_visitor
{
  const Delta_complex& mesh;
  std::vector<Vector> vector;

  Vector_keeper(const Delta_complex& mesh, std::vector<Vector> vector)
    : mesh(mesh), vector(std::move(vector))
  {}

  void after_flip(Halfedge_index h)
  {
    const Vector sum = vector[mesh.next(h)] + vector[mesh.prev(h)];
    vector[h] = {-sum.x, -sum.y};
    vector[mesh.opposite(h)] = sum;
  }

  // Returns the side of the circle through the face of `h` on which the apex beyond lies; positive
  // inside.
  int side_of_circle(Halfedge_index h) const
  {
    const auto exact = [](const Vector& v) {
      return std::array<CGAL::Exact_rational, 2>{CGAL::Exact_rational(double(v.x)),
                                                 CGAL::Exact_rational(double(v.y))};
    };
    const Vector ij = vector[h], ik = ij + vector[mesh.next(h)],
                 il = vector[mesh.next(mesh.opposite(h))];
    // Vectors are relative to l.
    const Vector i{-il.x, -il.y}, j = ij + i, k = ik + i;
    return Test_surfaces::side_of_circle(exact(i), exact(j), exact(k));
  }
};

// Flips at random what stays convex; `after_flip(h)` is called for each flip.
template <typename Triangulation, typename After_flip>
void shuffle(Triangulation& t, std::size_t flips, Portable_random& random,
             const After_flip& after_flip)
{
  const int edges = static_cast<int>(t.mesh().number_of_edges());
  for(std::size_t flip = 0; flip < flips; ++flip) {
    const Halfedge_index h =
      t.mesh().halfedge(Edge_index(static_cast<unsigned>(random.get_int(0, edges))));
    if(t.is_flippable(h)) {
      t.flip(h);
      after_flip(h);
    }
  }
}

template <typename Triangulation>
void shuffle(Triangulation& t, std::size_t flips, Portable_random& random)
{
  shuffle(t, flips, random, [](Halfedge_index) {});
}

// Returns the triangulation with all coordinates divided by a number.
inline Exact_triangulation with_squared_lengths(const Flat_surface& surface, int divisor = 1)
{
  Delta_complex mesh = surface.mesh;
  auto square = mesh.add_property_map<Edge_index, CGAL::Exact_rational>("e:square").first;
  for(Edge_index e : mesh.edges()) {
    const Vector v = surface.vector[mesh.halfedge(e)];
    square[e] = CGAL::Exact_rational(double(dot(v, v))) / (divisor * divisor);
  }
  return Exact_triangulation(mesh, IT::parameters::squared_edge_length_map(square));
}

} // namespace Test_surfaces

#endif // INTRINSIC_TRIANGULATIONS_TEST_EXACT_FLIPS_H
