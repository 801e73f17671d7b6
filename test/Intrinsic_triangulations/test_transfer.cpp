// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifdef CGAL_EIGEN3_ENABLED

#include "hard_meshes.h"
#include "matrices.h"
#include "measuring.h"

#include <CGAL/Intrinsic_triangulations/function_transfer.h>

namespace Test_transfer {

using namespace Test_surfaces;
using Subdivision = IT::Common_subdivision<>;
using Matrix = Eigen::SparseMatrix<double>;
using Values = Eigen::VectorXd;

// Returns a third of the area around each vertex: the integral of its hat function.
Values integrals_of_hats(Side side, const Triangulation& t)
{
  const Flat_faces faces(side, t);
  Values result = Values::Zero(static_cast<Eigen::Index>(t.mesh().number_of_vertices()));
  for(Face_index f : faces.mesh().faces())
    for(Halfedge_index h : faces.sides(f))
      result[faces.mesh().target(h).idx()] += static_cast<double>(faces.area(f) / 3);
  return result;
}

void check_matrices(const Triangulation& t)
{
  const Correspondence c(t);
  const double area = static_cast<double>(Flat_faces(Side::input, t).area());
  const Matrix mixed = IT::mixed_mass_matrix(c);
  const Matrix transposed = mixed.transpose();
  const Values in = integrals_of_hats(Side::input, t), out = integrals_of_hats(Side::intrinsic, t);
  EXPECT_LT(largest(mixed * ones(mixed) - out), 1e-9 * area);
  EXPECT_LT(largest(transposed * ones(transposed) - in), 1e-9 * area);
  for(Side side : both_sides) {
    const Matrix mass = IT::mass_matrix(t.surface(side));
    EXPECT_NEAR(mass.sum() / area, 1, 1e-12 + (side == Side::input ? 0 : 1e-10));
    EXPECT_EQ((mass - Matrix(mass.transpose())).norm(), 0);
    EXPECT_LT(largest(mass * ones(mass) - (side == Side::input ? in : out)), 1e-14 * area);
  }
}

// Returns the integral of the product of functions on both sides, by a sum over the triangulated
// subdivision.
double integral_of_product(const Values& on_input, const Values& on_intrinsic,
                           const Correspondence& c)
{
  const Triangulation& t = c.triangulation();
  Subdivision s(c);
  s.triangulate();
  const Flat_faces faces(Side::input, t);
  const Values u = IT::interpolation_matrix(Side::input, s) * on_input;
  const Values v = IT::interpolation_matrix(Side::intrinsic, s) * on_intrinsic;
  double sum = 0;
  for(Face_index f : s.mesh().faces()) {
    std::vector<Vertex_index> corner;
    for(Halfedge_index h : halfedges_around_face(s.mesh().halfedge(f), s.mesh()))
      corner.push_back(s.mesh().target(h));
    const double a = static_cast<double>(area(layout(Side::input, f, s, faces)));
    for(std::size_t i = 0; i < 3; ++i)
      for(std::size_t j = 0; j < 3; ++j)
        sum += a / (i == j ? 6 : 12) * u[corner[i].idx()] * v[corner[j].idx()];
  }
  return sum;
}

double squared_distance(const Values& on_input, const Values& on_intrinsic, const Matrix& mass_1,
                        const Matrix& mass_2, const Matrix& mixed)
{
  return on_input.dot(mass_1 * on_input) + on_intrinsic.dot(mass_2 * on_intrinsic) -
         2 * on_intrinsic.dot(mixed * on_input);
}

void check_closest(const Triangulation& t)
{
  const Correspondence c(t);
  const Matrix m1 = IT::mass_matrix(t.input()), m2 = IT::mass_matrix(t.intrinsic());
  const Matrix mixed = IT::mixed_mass_matrix(c);
  const Values f = random_numbers(t.mesh().number_of_vertices(), 1, 1);
  const Values g = IT::transfer_function(c, Side::input, f);
  const double least = squared_distance(f, g, m1, m2, mixed);
  const double scale = f.dot(m1 * f);
  EXPECT_GT(least, -1e-10 * scale);
  EXPECT_NEAR((ones(m1).dot(m1 * f) - ones(m2).dot(m2 * g)) / scale, 0, 1e-9);
  for(unsigned int seed = 0; seed < 20; ++seed) {
    const Values other = g + 1e-3 * random_numbers(t.mesh().number_of_vertices(), 1, seed);
    EXPECT_GT(squared_distance(f, other, m1, m2, mixed), least);
  }
}

// Checks that the transfers are orthogonal projections between two spaces: each is the adjoint of
// the other, and neither makes a function larger.
void check_adjoint(const Triangulation& t)
{
  const Correspondence c(t);
  const Matrix m1 = IT::mass_matrix(t.input()), m2 = IT::mass_matrix(t.intrinsic());
  const Values f = random_numbers(t.mesh().number_of_vertices(), 1, 1);
  const Values g = random_numbers(t.mesh().number_of_vertices(), 1, 2);
  const Values f_there = IT::transfer_function(c, Side::input, f);
  const Values g_back = IT::transfer_function(c, Side::intrinsic, g);
  const double scale = std::sqrt(f.dot(m1 * f) * g.dot(m2 * g));
  EXPECT_NEAR((f_there.dot(m2 * g) - f.dot(m1 * g_back)) / scale, 0, 1e-9);
  EXPECT_LE(f_there.dot(m2 * f_there), f.dot(m1 * f) * (1 + 1e-9));
  EXPECT_LE(g_back.dot(m1 * g_back), g.dot(m2 * g) * (1 + 1e-9));
}

TEST(Transfer, interpolation_matrices)
{
  for(const Named_triangulation& t : traced(triangulations())) {
    const Correspondence c(t.triangulation);
    const Subdivision s(c);
    for(Side side : both_sides) {
      const Matrix m = IT::interpolation_matrix(side, s);
      EXPECT_EQ(m.rows(), Eigen::Index(s.mesh().number_of_vertices()));
      EXPECT_EQ(m.cols(), Eigen::Index(t.triangulation.mesh().number_of_vertices()));
      EXPECT_LT(largest(m * ones(m) - Values::Constant(m.rows(), 1)), 1e-15);
      for(int k = 0; k < m.outerSize(); ++k)
        for(Matrix::InnerIterator entry(m, k); entry; ++entry) {
          EXPECT_GE(entry.value(), 0);
          EXPECT_TRUE(entry.row() >= m.cols() ||
                      (entry.value() == 1 && entry.row() == entry.col()));
        }
    }
  }
}

TEST(Transfer, mass_matrices)
{
  for(const Named_triangulation& t : traced(triangulations()))
    check_matrices(t.triangulation);
}

// The sum over the subdivision is laid out by corners, hence only on meshes without self-edges.
TEST(Transfer, mixed_mass_matrix_is_the_integral_over_the_subdivision)
{
  for(const auto& [m, seed] : traced(meshes(), 3)) {
    Triangulation t(m.mesh);
    flip_at_random(t, 20 * m.mesh.number_of_edges(), seed);
    const Correspondence c(t);
    const std::size_t n = m.mesh.number_of_vertices();
    const Values f = random_numbers(n, 1, seed), g = random_numbers(n, 1, seed + 100);
    const double expected = integral_of_product(f, g, c);
    EXPECT_NEAR(g.dot(IT::mixed_mass_matrix(c) * f) / expected, 1, 1e-7);
  }
}

TEST(Transfer, closest_function)
{
  for(const Named_triangulation& t : traced(triangulations()))
    check_closest(t.triangulation);
}

TEST(Transfer, adjoint)
{
  for(const Named_triangulation& t : traced(triangulations()))
    check_adjoint(t.triangulation);
}

TEST(Transfer, identity_where_nothing_was_flipped)
{
  for(const Named_complex& complex : traced(complexes())) {
    const Triangulation t = triangulation(complex.mesh, random_lengths(complex.mesh, 2));
    const Correspondence c(t);
    const Values f = random_numbers(t.mesh().number_of_vertices(), 1, 2);
    for(Side side : both_sides)
      EXPECT_LT(largest(IT::transfer_function(c, side, f) - f), 1e-12);
  }
}

TEST(Transfer, linear_functions_in_the_plane_stay)
{
  for(unsigned int seed : seeds(5)) {
    Flat_triangulation flat(flat_grid(7, 6, seed));
    flat.flip_at_random(2000, seed);
    const Correspondence c(*flat);
    Values f(static_cast<Eigen::Index>(flat->mesh().number_of_vertices()));
    for(Vertex_index v : flat->mesh().vertices())
      f[v.idx()] = 3 + 0.7e-3 * static_cast<double>(flat.surface().point[v].x) -
                   0.2e-3 * static_cast<double>(flat.surface().point[v].y);
    for(Side side : both_sides)
      EXPECT_LT(largest(IT::transfer_function(c, side, f) - f), 1e-10);
  }
}

TEST(Transfer, constants_stay_everywhere)
{
  for(const Named_triangulation& t : traced(triangulations())) {
    const Correspondence c(t.triangulation);
    const Values f =
      Values::Constant(Eigen::Index(t.triangulation.mesh().number_of_vertices()), 2.5);
    for(Side side : both_sides)
      EXPECT_LT(largest(IT::transfer_function(c, side, f) - f), 1e-7);
  }
}

TEST(Transfer, isolated_vertices_keep_their_values)
{
  Mesh mesh = embedded_torus(5, 4);
  const Vertex_index alone = mesh.add_vertex(Point(9, 9, 9));
  Triangulation t(mesh);
  EXPECT_GT(IT::make_Delaunay(t), 0u);
  const Values f = random_numbers(mesh.number_of_vertices(), 1, 3);
  EXPECT_EQ(IT::transfer_function(Correspondence(t), Side::input, f)[alone.idx()], f[alone.idx()]);
}

// Areas that are rounding errors differ on both sides. Functions are bounded nevertheless, far
// below the ratio of areas, and constants are preserved.
TEST(Transfer, functions_on_hard_meshes_stay_bounded)
{
  for_each_hard_mesh([](const Mesh& mesh) {
    Triangulation t(mesh);
    IT::make_Delaunay(t);
    const Correspondence c(t);
    const auto n = t.mesh().number_of_vertices();
    for(Side side : both_sides) {
      EXPECT_LT(largest(IT::transfer_function(c, side, random_numbers(n, 1, 4))), 4);
      const Values one = Values::Constant(static_cast<Eigen::Index>(n), 1);
      EXPECT_LT(largest(IT::transfer_function(c, side, one) - one), 1e-6);
    }
  });
}

// A fan over a straight line has no area.
TEST(Transfer, vertices_without_area_get_the_value_there)
{
  Mesh mesh = embedded_torus(5, 4);
  const std::array<Vertex_index, 4> on_line{
    mesh.add_vertex(Point(9, 0, 0)), mesh.add_vertex(Point(10, 0, 0)),
    mesh.add_vertex(Point(11, 0, 0)), mesh.add_vertex(Point(13, 0, 0))};
  mesh.add_face(on_line[0], on_line[1], on_line[2]);
  mesh.add_face(on_line[0], on_line[2], on_line[3]);
  Triangulation t(mesh);
  IT::make_Delaunay(t);
  const Values f = random_numbers(mesh.number_of_vertices(), 1, 3);
  for(Side side : both_sides) {
    const Values g = IT::transfer_function(Correspondence(t), side, f);
    for(Vertex_index v : on_line)
      EXPECT_EQ(g[v.idx()], f[v.idx()]);
  }
}

} // namespace Test_transfer

#endif
