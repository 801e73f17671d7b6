// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DISCRETE_CONFORMAL_MAPS_TEST_HARD_CONES_H
#define DISCRETE_CONFORMAL_MAPS_TEST_HARD_CONES_H

#include "../Intrinsic_triangulations/near_degenerate_meshes.h"

// This file generates cones that are hard to reach, and coarse surfaces for them.
namespace Test_surfaces {

// Returns a surface with fewer than 100 vertices.
inline Mesh coarse_surface(std::size_t genus, unsigned int seed)
{
  return perturbed(genus == 0 ? unit_sphere(4) : frame(genus, 1), 0.05, seed);
}

// Represents angle defects in multiples of pi / 2, from -3 pi to 3 pi / 2, on a closed surface.
class Quarter_turns
{
public:
  explicit Quarter_turns(const Mesh& mesh)
    : m_defect(mesh.number_of_vertices(), 0),
      m_left(4 * (int(mesh.number_of_vertices()) - int(mesh.number_of_edges()) +
                  int(mesh.number_of_faces())))
  {}

  void set(std::size_t v, int defect)
  {
    m_left += m_defect[v] - defect;
    m_defect[v] = defect;
  }

  // Distributes the missing curvature over random vertices.
  void fill_up(CGAL::Random& random)
  {
    while(m_left != 0) {
      const std::size_t v = random_vertex(random);
      set(v, std::clamp(m_defect[v] + m_left, -6, 3));
    }
  }

  std::size_t random_vertex(CGAL::Random& random) const
  {
    return std::size_t(random.get_int(0, int(m_defect.size())));
  }

  std::vector<double> defects() const
  {
    std::vector<double> result;
    for(int defect : m_defect)
      result.push_back(defect * std::acos(0.));
    return result;
  }

private:
  std::vector<int> m_defect;
  int m_left; // what is to be added, by Gauss-Bonnet
};

// Returns angle defects with cones at few vertices, at many, or at a vertex and its neighbors.
inline std::vector<double> hard_cones(const Mesh& mesh, unsigned int seed)
{
  CGAL::Random random(seed);
  Quarter_turns cones(mesh);
  const std::size_t n = mesh.number_of_vertices();
  std::vector<std::size_t> place;
  if(seed % 3 == 2)
    for(Mesh::Vertex_index v : mesh.vertices_around_target(
          mesh.halfedge(Mesh::Vertex_index(unsigned(random.get_int(0, int(n)))))))
      place.push_back(v);
  else
    for(std::size_t i = 0; i < (seed % 3 == 0 ? 5 : n / 4); ++i)
      place.push_back(cones.random_vertex(random));
  for(std::size_t v : place)
    cones.set(v, random.get_int(-6, 4));
  cones.fill_up(random);
  return cones.defects();
}

} // namespace Test_surfaces

#endif // DISCRETE_CONFORMAL_MAPS_TEST_HARD_CONES_H
