// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// These tests prolong geodesic distances of a coarse level to the fine level.

#include "simplified_surfaces.h"

#include <CGAL/Intrinsic_simplification/Prolonged_distances.h>

namespace Test_prolonged_distances {

using namespace Test_surfaces;
using IS::Prolonged_distances;

struct Coarsened : Simplified
{
  Surface_map map;
  Eigen::SparseMatrix<double, Eigen::RowMajor> prolongation;

  Coarsened(const Mesh& mesh, std::size_t vertices)
    : Simplified(Evolving_surface(mesh), vertices),
      map(surface, fine, coarse),
      prolongation(IS::prolongation_matrix(map))
  {}
};

double distance(Vertex_index v, Vertex_index w, const Mesh& mesh)
{
  return std::sqrt(CGAL::squared_distance(mesh.point(v), mesh.point(w)));
}

// The plane is not distorted. Distances change by no more than a point is moved, and interpolation
// uses values at corners of the same face.
TEST(Prolonged_distances, on_a_square)
{
  const Mesh mesh = subdivided(square(), 4);
  const Coarsened c(mesh, 60);
  const Prolonged_distances distances(c.coarse, c.prolongation);
  double edge = 0;
  for(Edge_index e : c.coarse.mesh().edges())
    edge = (std::max)(edge, c.coarse.length_map()[e]);
  for(Vertex_index v : mesh.vertices()) {
    const Eigen::VectorXd from_source = IS::prolonged_distances_from(v, c.map, c.prolongation);
    for(Vertex_index w : mesh.vertices()) {
      EXPECT_NEAR(from_source[w], distance(v, w, mesh), edge);
      EXPECT_NEAR(distances(v, w), distance(v, w, mesh), 2 * edge);
    }
  }
  // Vertices of both levels are exact.
  for(Vertex_index v : c.coarse.mesh().vertices())
    for(Vertex_index w : c.coarse.mesh().vertices()) {
      const Vertex_index i = c.coarse.surface_vertex(v), j = c.coarse.surface_vertex(w);
      EXPECT_NEAR(distances.coarse_distances().coeff(v, w), distance(i, j, mesh), 1e-12);
      EXPECT_NEAR(distances(i, j), distance(i, j, mesh), 1e-12);
    }
}

// Three kinds of queries yield the same distances.
TEST(Prolonged_distances, are_the_product_of_matrices)
{
  const Mesh mesh = random_sphere(150, 1);
  const Coarsened c(mesh, 30);
  const Prolonged_distances distances(c.coarse, c.prolongation);
  const Eigen::MatrixXd& d = distances.coarse_distances();
  EXPECT_LE((d - d.transpose()).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_EQ(d.diagonal().cwiseAbs().maxCoeff(), 0);
  const Eigen::MatrixXd p(c.prolongation), product = p * d * p.transpose();
  EXPECT_LE((distances.matrix() - product).cwiseAbs().maxCoeff(), 1e-12);
  for(Vertex_index v : mesh.vertices()) {
    EXPECT_LE((distances.from(v) - product.col(v)).cwiseAbs().maxCoeff(), 1e-12);
    for(Vertex_index w : mesh.vertices())
      EXPECT_NEAR(distances(v, w), product.coeff(v, w), 1e-12);
  }
}

// Paths between the vertices of a cube are an edge, the diagonal of a side, and a path across two
// sides.
TEST(Prolonged_distances, corners_of_a_cube)
{
  Mesh mesh = subdivided(cube(), 2);
  const double side = distance(Vertex_index(0), Vertex_index(1), cube());
  Evolving_surface surface(mesh);
  IS::Transport_cost cost(surface);
  cost.add_curvature(surface);
  IS::simplify(surface, cost, IS::parameters::maximum_cost(1e-12));
  const Surface_level coarse(surface);
  ASSERT_EQ(coarse.mesh().number_of_vertices(), 8u);
  Eigen::SparseMatrix<double, Eigen::RowMajor> identity(8, 8);
  identity.setIdentity();
  const Prolonged_distances distances(coarse, identity);
  for(Vertex_index v : coarse.mesh().vertices())
    for(Vertex_index w : coarse.mesh().vertices()) {
      const double straight = distance(v, w, mesh) / side;
      const double around = straight > 1.5 ? std::sqrt(5) : straight;
      EXPECT_NEAR(distances(v, w), side * around, 1e-12);
    }
}

TEST(Prolonged_distances, other_components_are_out_of_reach)
{
  Mesh mesh = random_sphere(60, 1);
  mesh += random_sphere(60, 2);
  const Coarsened c(mesh, 40);
  const Prolonged_distances distances(c.coarse, c.prolongation);
  const Eigen::VectorXd from = distances.from(Vertex_index(0));
  const Eigen::VectorXd from_source =
    IS::prolonged_distances_from(Vertex_index(0), c.map, c.prolongation);
  for(Vertex_index v : mesh.vertices()) {
    const bool is_other = v.idx() >= 60;
    EXPECT_EQ(std::isinf(from[v]), is_other);
    EXPECT_EQ(std::isinf(from_source[v]), is_other);
    EXPECT_EQ(std::isinf(distances(Vertex_index(0), v)), is_other);
  }
}

} // namespace Test_prolonged_distances
