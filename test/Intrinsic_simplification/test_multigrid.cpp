// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Multigrid is compared with a direct solution.

#include "../Intrinsic_triangulations/matrices.h"
#include "evolving_surfaces.h"

#include <CGAL/Intrinsic_simplification/Multigrid_solver.h>
#include <CGAL/Intrinsic_simplification/prolongation_hierarchy.h>
#include <CGAL/Intrinsic_triangulations/operators.h>

#include <Eigen/Dense>
#include <Eigen/SparseCholesky>

namespace Test_multigrid {

using namespace Test_surfaces;
using IS::Multigrid_result;
using IS::Multigrid_solver;
using IS::Multigrid_status;

typedef Eigen::SparseMatrix<double> Matrix;
typedef Eigen::VectorXd Vector;

struct System
{
  Matrix laplacian, mass;
  std::vector<Matrix> prolongations;

  explicit System(const Mesh& mesh, std::size_t coarsest = 50)
  {
    Evolving_surface surface(mesh);
    const IS::Surface_level fine(surface);
    laplacian = IT::cotan_laplacian(fine);
    mass = IT::lumped_mass_matrix(fine);
    prolongations = IS::prolongation_hierarchy(surface, coarsest);
  }

  Vector masses() const { return mass.diagonal(); }
  Matrix screened(double alpha) const { return laplacian + alpha * mass; }
  Multigrid_solver solver(double alpha) const
  {
    return Multigrid_solver(screened(alpha), masses(), prolongations);
  }
};

// Returns a torus whose tube has n vertices around it.
Mesh torus(std::size_t n) { return perturbed(embedded_torus(3 * n, n), 0.3 / double(n), 1); }

// Returns a square with hills and a boundary.
Mesh hills(std::size_t n)
{
  return grid(n, n, [n](double i, double j) {
    const double x = i / double(n), y = j / double(n);
    return Point(x, y, 0.1 * std::sin(9 * x + 2 * y) * std::cos(7 * y));
  });
}

double energy(const Vector& x, const Matrix& a) { return std::sqrt(x.dot(a * x)); }

// Checks the solution. The condition of the matrices is below 1e5, so a direct solution is exact to
// 1e-10. The estimated error is a mean of the true one with weights that differ by at most the
// factor 2 for such cycles.
void expect_solution(const Multigrid_result& result, const Vector& exact, const Matrix& a)
{
  EXPECT_EQ(result.status, Multigrid_status::converged);
  EXPECT_LE(result.error, 1e-10);
  EXPECT_LE(energy(result.solution - exact, a), 3e-10 * energy(exact, a));
}

TEST(Multigrid, agrees_with_a_direct_solution)
{
  for(const Mesh& mesh : {random_sphere(800, 1), torus(20), hills(30)})
    for(const double alpha : {1e-3, 1., 1000.}) {
      const System system(mesh);
      EXPECT_GE(system.prolongations.size(), 2u);
      const Matrix a = system.screened(alpha);
      const Vector b = random_numbers(std::size_t(a.cols()), 1, 1);
      expect_solution(system.solver(alpha).solve(b), Eigen::SimplicialLDLT<Matrix>(a).solve(b), a);
    }
}

// For pure Neumann problems, the solution has mean zero, for the right-hand side without its mean.
TEST(Multigrid, constants_are_taken_out)
{
  for(const Mesh& mesh : {random_sphere(800, 1), torus(20), hills(30)}) {
    const System system(mesh);
    const Vector m = system.masses();
    const Vector b = random_numbers(std::size_t(m.size()), 1, 2) + Vector::Constant(m.size(), 0.5);
    const Multigrid_result result = system.solver(0).solve(b);
    EXPECT_NEAR(m.dot(result.solution), 0, 1e-12 * m.sum() * result.solution.norm());
    // The rank-one term fixes the mean and changes nothing else.
    const Eigen::MatrixXd pinned = Eigen::MatrixXd(system.laplacian) + m * m.transpose();
    const Vector compatible = b - m * (b.sum() / m.sum());
    expect_solution(result, pinned.ldlt().solve(compatible), system.laplacian);
  }
}

// The surface has three components, one of them a single vertex.
TEST(Multigrid, each_component_has_its_own_constants)
{
  Mesh mesh = random_sphere(300, 1);
  mesh += random_sphere(400, 2);
  mesh.add_vertex(Point(0, 0, 0));
  const System system(mesh);
  const Vector m = system.masses(), b = random_numbers(std::size_t(m.size()), 1, 3);
  const Multigrid_result result = system.solver(0).solve(b);
  EXPECT_EQ(result.status, Multigrid_status::converged);
  Vector rest = b - system.laplacian * result.solution;
  for(const auto& [first, size] : {std::pair(0, 300), std::pair(300, 400)}) {
    const Vector part = m.segment(first, size);
    EXPECT_NEAR(part.dot(result.solution.segment(first, size)), 0, 1e-12 * part.sum());
    rest.segment(first, size) -= part * (b.segment(first, size).sum() / part.sum());
  }
  EXPECT_LE(rest.head(700).norm(), 1e-8 * b.norm());
  EXPECT_EQ(result.solution[700], 0);
}

// Iterations do not grow with the number of unknowns.
TEST(Multigrid, iterations_are_bounded)
{
  for(const std::size_t n : {20u, 40u, 80u, 128u}) {
    const System system(torus(n), 500);
    const Multigrid_result result =
      system.solver(0).solve(random_numbers(std::size_t(system.laplacian.cols()), 1, 4));
    EXPECT_EQ(result.status, Multigrid_status::converged);
    EXPECT_LE(result.iterations, 16u) << n;
  }
}

// The cycle is symmetric and positive definite, as conjugate gradients require.
TEST(Multigrid, cycle_is_symmetric)
{
  const System system(hills(20), 20);
  const Matrix a = system.screened(1);
  const IS::internal::Multigrid_cycle cycle(a, IS::internal::Matrix_components(a),
                                            system.prolongations);
  Eigen::MatrixXd inverse(a.cols(), a.cols());
  for(Eigen::Index j = 0; j < a.cols(); ++j)
    inverse.col(j) = cycle(Vector::Unit(a.cols(), j));
  EXPECT_LE((inverse - inverse.transpose()).norm(), 1e-12 * inverse.norm());
  const Eigen::MatrixXd symmetric = (inverse + inverse.transpose()) / 2;
  EXPECT_GT(symmetric.selfadjointView<Eigen::Lower>().eigenvalues().minCoeff(), 0);
  // A cycle reduces every error: the eigenvalues of its product with the matrix are between 0 and
  // 1.
  const Vector eigenvalues = (symmetric * a).eigenvalues().real();
  EXPECT_GT(eigenvalues.minCoeff(), 0.25);
  EXPECT_LE(eigenvalues.maxCoeff(), 1 + 1e-10);
}

TEST(Multigrid, without_levels_it_is_direct)
{
  const System system(random_sphere(40, 1), 50);
  EXPECT_TRUE(system.prolongations.empty());
  const Multigrid_result result =
    system.solver(0).solve(random_numbers(std::size_t(system.laplacian.cols()), 1, 5));
  EXPECT_EQ(result.status, Multigrid_status::converged);
  EXPECT_EQ(result.iterations, 1u);
}

TEST(Multigrid, failure_has_a_name)
{
  const System system(torus(20));
  const Multigrid_solver solver = system.solver(0);
  Vector b = random_numbers(std::size_t(system.laplacian.cols()), 1, 6);
  const Multigrid_result few = solver.solve(b, 1e-10, 3);
  EXPECT_EQ(few.status, Multigrid_status::iteration_limit);
  EXPECT_EQ(few.iterations, 3u);
  EXPECT_GT(few.error, 1e-10);
  const Multigrid_result exact = solver.solve(b, 1e-30);
  EXPECT_EQ(exact.status, Multigrid_status::no_progress);
  EXPECT_LE(exact.error, 1e-13);
  EXPECT_EQ(solver.solve(Vector::Zero(b.size())).status, Multigrid_status::converged);
  b[0] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(solver.solve(b).status, Multigrid_status::no_progress);
  for(int status = 0; status < 3; ++status)
    EXPECT_STRNE(IS::to_string(static_cast<Multigrid_status>(status)), "unknown");
}

// Rows sum up to one, and the vertices of a level keep their values.
TEST(Multigrid, hierarchy_of_prolongations)
{
  const System system(torus(40), 100);
  Eigen::Index size = system.laplacian.cols();
  for(const Matrix& p : system.prolongations) {
    EXPECT_EQ(p.rows(), size);
    size = p.cols();
    EXPECT_EQ(size, p.rows() / 4);
    EXPECT_LE((p * Vector::Ones(size) - Vector::Ones(p.rows())).cwiseAbs().maxCoeff(), 1e-14);
  }
  EXPECT_LE(size, 100);
}

} // namespace Test_multigrid
