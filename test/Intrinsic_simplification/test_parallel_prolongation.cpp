// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../Intrinsic_triangulations/refined_meshes.h"

#include <CGAL/Intrinsic_simplification/prolongation.h>
#include <CGAL/Intrinsic_simplification/simplify.h>

#include "../Intrinsic_triangulations/results.h" // after Eigen

namespace Test_parallel_prolongation {

using namespace Test_surfaces;
namespace IS = CGAL::Intrinsic_simplification;
using Location = IS::Surface_map::Location;

// Returns three points of each face.
std::vector<Location> points(const IS::Surface_level& level)
{
  std::vector<Location> result;
  for(Face_index f : level.mesh().faces())
    for(double t : {0., 0.3, 0.9})
      result.push_back({f, {t, (1 - t) / 4, 3 * (1 - t) / 4}});
  return result;
}

TEST(Parallel, maps_between_levels)
{
  for(const Mesh& mesh : {large_torus(), large_square()}) {
    IS::Evolving_surface surface(mesh);
    const IS::Surface_level fine(surface);
    IS::simplify(surface, IS::parameters::number_of_vertices(mesh.number_of_vertices() / 4));
    const IS::Surface_level coarse(surface);
    const IS::Surface_map map(surface, fine, coarse);
    const std::vector<Location> on_fine = points(fine), on_coarse = points(coarse);
    expect_same_results([&](auto tag) {
      const auto np = IS::parameters::concurrency_tag(tag);
      Results results;
      results.add_matrix(IS::prolongation_matrix(map, np));
      results.add_locations(map.to_coarse(on_fine, np));
      results.add_locations(map.to_fine(on_coarse, np));
      return results;
    });
    const std::vector<Location> images = map.to_coarse(on_fine);
    for(std::size_t i = 0; i < on_fine.size(); ++i)
      EXPECT_EQ(images[i], map.to_coarse(on_fine[i]));
  }
}

// Rows are the positions of fine vertices, whatever else is computed at the same time.
TEST(Parallel, prolongation_has_the_places_of_vertices)
{
  const Mesh mesh = perturbed(embedded_torus(40, 40), 0.05, 5);
  IS::Evolving_surface surface(mesh);
  const IS::Surface_level fine(surface);
  IS::simplify(surface, IS::parameters::number_of_vertices(200u));
  const IS::Surface_level coarse(surface);
  const IS::Surface_map map(surface, fine, coarse);
  const Eigen::SparseMatrix<double> matrix =
    IS::prolongation_matrix(map, IS::parameters::concurrency_tag(CGAL::Parallel_tag()));
  for(IS::Vertex_index v : fine.mesh().vertices()) {
    const Location p = IS::image_of_vertex(v, map);
    Eigen::VectorXd expected = Eigen::VectorXd::Zero(matrix.cols());
    const auto sides = IT::sides(p.first, coarse.mesh());
    for(std::size_t s = 0; s < 3; ++s)
      expected[coarse.mesh().source(sides[s])] += p.second[s];
    EXPECT_EQ(Eigen::VectorXd(matrix.row(v)), expected);
  }
}

} // namespace Test_parallel_prolongation
