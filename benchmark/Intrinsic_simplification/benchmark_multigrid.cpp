// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Solves a Poisson problem by multigrid on a hierarchy of surfaces, and by Eigen's Cholesky
// factorization. Prints CPU seconds, and bytes of matrix entries. Arguments are meshes, by default
// some of CGAL's and tori of growing size.

#include "../Intrinsic_triangulations/measure.h"
#include "surfaces.h"

#include <CGAL/Intrinsic_simplification/Multigrid_solver.h>
#include <CGAL/Intrinsic_simplification/prolongation_hierarchy.h>
#include <CGAL/Intrinsic_triangulations/operators.h>

#include <Eigen/SparseCholesky>

#include <cmath>
#include <cstdio>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace IS = CGAL::Intrinsic_simplification;
namespace IT = CGAL::Intrinsic_triangulations;

typedef Eigen::SparseMatrix<double> Matrix;
typedef Eigen::VectorXd Vector;

namespace {

struct Problem
{
  Matrix laplacian;
  Vector masses, right_side; // the third coordinate, minus its mean

  Problem(const IS::Surface_level& level, const Mesh& mesh)
    : laplacian(IT::cotan_laplacian(level)),
      masses(IT::lumped_mass_matrix(level).diagonal()),
      right_side(masses.size())
  {
    for(Vertex v : mesh.vertices())
      right_side[v] = masses[v] * mesh.point(v).z();
    right_side -= masses * (right_side.sum() / masses.sum());
  }

  double energy(const Vector& x) const { return std::sqrt(x.dot(laplacian * x)); }
};

struct Seconds
{
  Samples prepare, solve;
};

// Returns the solution with mean zero, and the bytes of the factor.
std::pair<Vector, double> solve_directly(const Problem& problem, Seconds& seconds)
{
  Matrix pinned = problem.laplacian;
  pinned.coeffRef(0, 0) += 1;
  const auto factorization =
    seconds.prepare.time([&] { return std::make_unique<Eigen::SimplicialLDLT<Matrix>>(pinned); });
  Vector x = seconds.solve.time([&] { return Vector(factorization->solve(problem.right_side)); });
  x.array() -= problem.masses.dot(x) / problem.masses.sum();
  return {x, 12. * double(factorization->matrixL().nestedExpression().nonZeros())};
}

void benchmark(const Table& table, const std::string& name, const Mesh& mesh)
{
  IS::Evolving_surface surface(mesh);
  const Problem problem(IS::Surface_level(surface), mesh);
  Samples hierarchy;
  const auto prolongations = hierarchy.time([&] { return IS::prolongation_hierarchy(surface); });
  Seconds multigrid, direct;
  const auto solver = multigrid.prepare.time([&] {
    return std::make_unique<IS::Multigrid_solver>(problem.laplacian, problem.masses, prolongations);
  });
  const IS::Multigrid_result result =
    multigrid.solve.time([&] { return solver->solve(problem.right_side); });
  const auto [exact, bytes] = solve_directly(problem, direct);
  table.row(name, mesh.number_of_vertices(), hierarchy.median() / 1000,
            multigrid.prepare.median() / 1000, multigrid.solve.median() / 1000, result.iterations,
            problem.energy(result.solution - exact) / problem.energy(exact),
            12e-6 * double(solver->number_of_entries()), direct.prepare.median() / 1000,
            direct.solve.median() / 1000, 1e-6 * bytes);
}

} // namespace

int main(int argc, char* argv[])
{
  keep_memory();
  const Table table({"mesh", "vertices", "hierarchy (s)", "prepare (s)", "solve (s)", "steps",
                     "difference", "MB", "LDLT: prepare (s)", "solve (s)", "MB"});
  const auto benchmark_mesh = [&](const std::string& name, const Mesh& mesh) {
    benchmark(table, name, mesh);
  };
  if(argc > 1) {
    for(const char* path : std::vector<const char*>(argv + 1, argv + argc))
      benchmark_file(path, benchmark_mesh);
    return 0;
  }
  for(const char* name : {"elephant", "camel", "armadillo", "bunny00", "refined_elephant"})
    benchmark_file(CGAL::data_file_path("meshes/" + std::string(name) + ".off"), benchmark_mesh);
  benchmark(table, "hills", hills(300));
  for(unsigned n : {64U, 128U, 256U, 500U})
    benchmark(table, "bumpy torus", bumpy_torus(n));
}
