// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../Intrinsic_triangulations/near_degenerate_meshes.h"
#include "flat_maps.h"

#include <CGAL/Random.h>
#include <CGAL/subdivision_method_3.h>
#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <cstddef>
#include <exception>
#include <vector>

namespace {

using namespace Test_surfaces;

Mesh smooth_surface(int genus)
{
  Mesh result = plate_with_holes(genus);
  CGAL::Subdivision_method_3::Loop_subdivision(
    result, CGAL::parameters::number_of_iterations(genus < 2 ? 3 : 2));
  return result;
}

// Angle defects in multiples of pi / 2, from -3 pi to 3 pi / 2, on a closed surface.
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

  // Gives what is missing to random vertices.
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

  Conditions conditions() const
  {
    Conditions result;
    for(int defect : m_defect)
      result.push_back(Vertex_condition::curvature(defect * pi / 2));
    return result;
  }

private:
  std::vector<int> m_defect;
  int m_left; // what is to be added, by Gauss-Bonnet
};

// Cones at few vertices, at many, or at a vertex and its neighbors.
Conditions hard_cones(const Mesh& mesh, unsigned int seed)
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
  return cones.conditions();
}

class Hard_cones : public testing::TestWithParam<int>
{};

} // namespace

TEST_P(Hard_cones, are_reached)
{
  const Mesh mesh = smooth_surface(GetParam());
  const Triangulation t(mesh);
  for(unsigned int seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE(seed);
    const Conditions condition = hard_cones(mesh, seed);
    const Planar_conformal_map map = flatten(t, condition);
    EXPECT_EQ(map.minimization().status, DC::Minimization_status::converged);
    EXPECT_LT(map.max_curvature_error(), 1e-10);
    EXPECT_LT(map.minimization().gradient_error, 1e-10);
  }
}

INSTANTIATE_TEST_SUITE_P(Genus, Hard_cones, testing::Range(0, 5));

// Flat with greedy cones, or a status that says what is missing.
TEST(Near_degenerate_meshes, are_flattened_or_say_why)
{
  std::size_t flat = 0;
  const unsigned int n = 120;
  for(unsigned int seed = 0; seed < n; ++seed) {
    const Named_mesh input = near_degenerate_mesh(seed);
    SCOPED_TRACE(input.name + std::to_string(seed));
    const Planar_conformal_map map = DC::flatten(input.mesh);
    if(map.minimization().status == DC::Minimization_status::converged &&
       map.max_curvature_error() < 1e-10)
      ++flat;
    else
      ADD_FAILURE() << to_string(map.minimization().status) << ' ' << map.max_curvature_error();
  }
  EXPECT_EQ(flat, n);
}
