// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DISCRETE_CONFORMAL_MAPS_TEST_HARD_CONES_H
#define DISCRETE_CONFORMAL_MAPS_TEST_HARD_CONES_H

#include "../Intrinsic_triangulations/near_degenerate_meshes.h"

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

// Cones that are hard to get: with angle defects from -3 pi to 3 pi / 2, on surfaces of genus 0 to 4.
namespace Test_surfaces {

struct Hard_cones
{
  std::string name;
  Mesh mesh;
  std::vector<double> defect; // of each vertex; their sum obeys Gauss-Bonnet
};

// The vertices in the order of their distance in edges.
inline std::vector<std::size_t> vertices_around(Vertex_index center, const Mesh& mesh)
{
  std::vector<std::size_t> result{center};
  std::vector<bool> is_met(mesh.number_of_vertices(), false);
  is_met[center] = true;
  for(std::size_t i = 0; i < result.size(); ++i)
    for(Vertex_index w : mesh.vertices_around_target(
          mesh.halfedge(Vertex_index(static_cast<Mesh::size_type>(result[i])))))
      if(!is_met[w]) {
        is_met[w] = true;
        result.push_back(w);
      }
  return result;
}

// Multiples of a quarter turn from -6 to 3 at these vertices, with this sum.
inline std::vector<int> quarter_turns(std::size_t n, const std::vector<std::size_t>& cones, int sum,
                                      CGAL::Random& random)
{
  constexpr int least = -6, greatest = 3;
  std::vector<int> result(n, 0);
  const auto random_cone = [&]() -> int& {
    return result[cones[random_size(0, static_cast<int>(cones.size()) - 1, random)]];
  };
  const auto move = [&](int& turns, int by) {
    const bool is_allowed = least <= turns + by && turns + by <= greatest;
    turns += is_allowed ? by : 0;
    return is_allowed;
  };
  while(sum != 0)
    if(const int by = sum > 0 ? 1 : -1; move(random_cone(), by))
      sum -= by;
  for(std::size_t i = 0; i < 20 * cones.size(); ++i) {
    int &one = random_cone(), &other = random_cone();
    if(&one != &other && move(one, 1) && !move(other, -1))
      --one;
  }
  return result;
}

// Cycles through genera and three choices of cones: a few anywhere, a few beside each other, many.
inline Hard_cones hard_cones(unsigned int seed)
{
  CGAL::Random random(seed);
  const std::size_t genus = seed % 5, choice = seed / 5 % 3;
  const Mesh smooth = genus == 0 ? unit_sphere(4) : frame(genus, 1);
  Hard_cones result{"genus " + std::to_string(genus), perturbed(smooth, 0.05, seed), {}};
  const std::size_t n = result.mesh.number_of_vertices();
  const int sum = 8 - 8 * static_cast<int>(genus);
  const Vertex_index center(
    static_cast<Mesh::size_type>(random_size(0, static_cast<int>(n) - 1, random)));
  std::vector<std::size_t> cones = vertices_around(center, result.mesh);
  if(choice != 1)
    shuffle(cones, random);
  cones.resize(choice == 2 ? n / 2 : random_size(5, 9, random));
  for(int turns : quarter_turns(n, cones, sum, random))
    result.defect.push_back(turns * std::acos(0.));
  return result;
}

} // namespace Test_surfaces

#endif // DISCRETE_CONFORMAL_MAPS_TEST_HARD_CONES_H
