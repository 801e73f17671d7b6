// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// These tests prolong tangent vectors of coarse levels to fine ones.

#include "simplified_surfaces.h"

#include <CGAL/Intrinsic_simplification/prolongation.h>
#include <CGAL/Intrinsic_simplification/tangent_prolongation.h>
#include <CGAL/Intrinsic_simplification/trace.h>

namespace Test_tangent_prolongation {

using namespace Test_surfaces;
using Complex = std::complex<double>;
using Frames = IT::Tangent_frames<double>;
using Matrix = Eigen::SparseMatrix<Complex>;

Frames frames(const Surface_level& level) { return Frames(level); }

Matrix tangent_prolongation(const Surface_map& map)
{
  return IS::tangent_prolongation_matrix(map, frames(map.fine()), frames(map.coarse()));
}

// Vectors from two corners at the same vertex may cancel.
TEST(Tangent_prolongation, has_the_absolute_values_of_that_of_functions)
{
  std::size_t rows = 0;
  for_each_surface([&](const Simplified&, const Surface_map& map) {
    const Eigen::MatrixXd p = IS::prolongation_matrix(map);
    const Eigen::MatrixXd q = Eigen::MatrixXcd(tangent_prolongation(map)).cwiseAbs();
    EXPECT_LT((q - p).maxCoeff(), 1e-9);
    for(Eigen::Index row = 0; row < p.rows(); ++row)
      if((p.row(row).array() > 0).count() == 3) {
        EXPECT_LT((q.row(row) - p.row(row)).cwiseAbs().maxCoeff(), 1e-9);
        ++rows;
      }
  });
  EXPECT_GT(rows, 100u);
}

TEST(Tangent_prolongation, of_one_level_is_the_identity)
{
  for(const Named_complex& c : traced(complexes())) {
    const Evolving_surface surface = evolving(c.mesh, 0);
    const Surface_level level(surface), same(surface);
    const Matrix p = tangent_prolongation(Surface_map(surface, level, same));
    const auto n = p.rows();
    EXPECT_LT((Eigen::MatrixXcd(p) - Eigen::MatrixXcd::Identity(n, n)).cwiseAbs().maxCoeff(),
              1e-12);
  }
}

// Returns the direction of a coarse halfedge on a flat surface, from its first piece.
Complex direction(Halfedge_index h, const Surface_map& map, const Flat_surface& flat)
{
  const auto trace = IS::trace_coarse_edge(h, map);
  const auto& piece = trace.front();
  const auto sides = IT::sides(piece.face, map.fine().mesh());
  const Coordinates &p = piece.ends[0].coordinates, &q = piece.ends[1].coordinates;
  const Complex way =
    (q[1] - p[1]) * complex(flat.vector[sides[0]]) - (q[2] - p[2]) * complex(flat.vector[sides[2]]);
  return way / std::abs(way);
}

// The field is parallel on a flat torus, where all vertices but one can be removed at no cost.
TEST(Tangent_prolongation, of_a_constant_field_on_a_flat_torus_is_exact)
{
  for(unsigned int seed = 0; seed < 5; ++seed) {
    const Flat_surface flat = flat_torus(9, 8, seed);
    Evolving_surface surface(triangulation(flat));
    const Surface_level fine(surface);
    simplify(surface, number_of_vertices(std::size_t(6)));
    const Surface_level coarse(surface);
    ASSERT_EQ(coarse.mesh().number_of_vertices(), 6u);
    const Surface_map map(surface, fine, coarse);
    const Complex field(0.6, -0.8);
    Eigen::VectorXcd expected(72), values(6);
    for(Vertex_index v : fine.mesh().vertices()) {
      const Complex axis = complex(flat.vector[IT::first_outgoing_halfedge(v, fine.mesh())]);
      expected[v.idx()] = field / (axis / std::abs(axis));
    }
    for(Vertex_index v : coarse.mesh().vertices())
      values[v.idx()] = field / direction(IT::first_outgoing_halfedge(v, coarse.mesh()), map, flat);
    EXPECT_LT((tangent_prolongation(map) * values - expected).cwiseAbs().maxCoeff(), 1e-9);
  }
}

// On a sphere, fields of rotations are smooth: the result is close to the field of the same
// rotation.
TEST(Tangent_prolongation, of_a_rotation_field_on_a_sphere)
{
  const Mesh sphere = unit_sphere(16);
  const auto points = sphere.points();
  // Returns the vector in the tangent plane, relative to the first outgoing halfedge of the fine
  // mesh.
  const auto value = [&](Vertex_index v) {
    const Kernel::Vector_3 n = points[v] - CGAL::ORIGIN, field(-n.y(), n.x(), 0);
    const Halfedge_index h =
      IT::first_outgoing_halfedge(v, IT::Intrinsic_triangulation<>(sphere).mesh());
    Kernel::Vector_3 x = points[sphere.target(h)] - points[v];
    x = x - (x * n) * n;
    x = x / std::sqrt(x.squared_length());
    return Complex(field * x, field * CGAL::cross_product(n, x));
  };
  Evolving_surface surface(sphere);
  const Surface_level fine(surface);
  simplify(surface, number_of_vertices(std::size_t(300)));
  const Surface_level coarse(surface);
  const Surface_map map(surface, fine, coarse);
  // At coarse vertices, the matrix rotates the frame of the fine level to the frame of the coarse
  // level.
  const Matrix p = tangent_prolongation(map);
  Eigen::VectorXcd values(300);
  for(Vertex_index v : coarse.mesh().vertices()) {
    const Vertex_index w = fine.level_vertex(coarse.surface_vertex(v));
    values[v.idx()] = value(w) / p.coeff(static_cast<int>(w), static_cast<int>(v));
  }
  const Eigen::VectorXcd result = p * values;
  double sum = 0;
  for(Vertex_index v : fine.mesh().vertices())
    sum += std::norm(result[v.idx()] - value(v));
  // The error is of the order of the squared length of coarse edges, which is 0.05.
  EXPECT_LT(std::sqrt(sum / static_cast<double>(fine.mesh().number_of_vertices())), 0.05);
}

} // namespace Test_tangent_prolongation
