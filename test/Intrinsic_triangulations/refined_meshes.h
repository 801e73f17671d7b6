// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_TRIANGULATIONS_TEST_REFINED_MESHES_H
#define INTRINSIC_TRIANGULATIONS_TEST_REFINED_MESHES_H

#include "generators.h"

// This file generates meshes of one shape with any number of faces.
namespace Test_surfaces {

// Returns a unit square whose inner vertices are moved by up to a fifth of a cell.
inline Mesh unit_square(std::size_t n, unsigned int seed)
{
  CGAL::Random random(seed);
  const double h = 1 / static_cast<double>(n);
  return grid(n, n, [&](double x, double y) {
    const bool inside = x > 0 && y > 0 && x < static_cast<double>(n) && y < static_cast<double>(n);
    const double move = inside ? 0.2 : 0;
    return Point(h * (x + move * random.get_double(-1, 1)),
                 h * (y + move * random.get_double(-1, 1)), 0);
  });
}

// Stores a mesh with flat faces cut into smaller ones, and the positions of its vertices on the
// coarse mesh.
struct Fine_mesh
{
  Mesh mesh;
  std::vector<IT::Face_location<double>> on_coarse;
};

// Cuts each face into n^2. Vertices move by up to `move` edges along sides and within faces. No two
// edges of the coarse mesh have the same ends.
inline Fine_mesh fine_mesh(const Mesh& coarse, std::size_t n, double move = 0,
                           unsigned int seed = 1)
{
  CGAL::Random random(seed);
  std::map<std::map<std::size_t, std::size_t>, std::size_t> numbers; // by weights of corners
  std::vector<Point> points;
  Fine_mesh result;
  Triangles triangles;
  for(Face_index f : coarse.faces()) {
    const Halfedge_index side = coarse.halfedge(f);
    const std::array corner{coarse.source(side), coarse.target(side),
                            coarse.target(coarse.next(side))};
    const auto add = [&](const std::array<std::size_t, 3>& weight) {
      std::array<double, 3> w;
      double sum = 0;
      Kernel::Vector_3 p(0, 0, 0);
      for(std::size_t k = 0; k < 3; ++k) {
        const bool is_free = weight[k] > 0 && weight[k] < n;
        w[k] = double(weight[k]) + (is_free ? move * random.get_double(-1, 1) : 0.);
        sum += w[k];
        p = p + w[k] * (coarse.point(corner[k]) - CGAL::ORIGIN);
      }
      points.push_back(CGAL::ORIGIN + (1 / sum) * p);
      result.on_coarse.push_back({f, {w[0] / sum, w[1] / sum, w[2] / sum}});
    };
    const auto number = [&](std::size_t i, std::size_t j) {
      const std::array weight{n - i - j, i, j};
      std::map<std::size_t, std::size_t> key;
      for(std::size_t k = 0; k < 3; ++k)
        if(weight[k] > 0)
          key[corner[k].idx()] = weight[k];
      const auto [entry, is_new] = numbers.emplace(key, points.size());
      if(is_new)
        add(weight);
      return entry->second;
    };
    for(std::size_t i = 0; i < n; ++i)
      for(std::size_t j = 0; i + j < n; ++j) {
        triangles.push_back({number(i, j), number(i + 1, j), number(i, j + 1)});
        if(i + j + 1 < n)
          triangles.push_back({number(i + 1, j), number(i + 1, j + 1), number(i, j + 1)});
      }
  }
  result.mesh = make_mesh(points, triangles);
  return result;
}

// Returns the octahedron with each edge divided into n edges, on the unit sphere.
inline Mesh unit_sphere(std::size_t n)
{
  Mesh mesh = fine_mesh(octahedron(), n).mesh;
  for(Vertex_index v : mesh.vertices()) {
    const Kernel::Vector_3 p = mesh.point(v) - CGAL::ORIGIN;
    mesh.point(v) = CGAL::ORIGIN + p / std::sqrt(p.squared_length());
  }
  return mesh;
}

// Returns a torus large enough for several threads.
inline Mesh large_torus() { return perturbed(embedded_torus(60, 50), 0.05, 3); }

// Returns a large square with boundary loops.
inline Mesh large_square() { return punctured(unit_square(55, 4), {1000, 3000, 5000}); }

} // namespace Test_surfaces

#endif // INTRINSIC_TRIANGULATIONS_TEST_REFINED_MESHES_H
