// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands/Command_line.h"

#include "commands/Command_run.h"
#include "commands/attempts.h"
#include "commands/triangulation_stages.h"
#include "writing/matrix_market.h"

#include <CGAL/Intrinsic_triangulations/Precise_surface.h>
#include <CGAL/Intrinsic_triangulations/Surface_view.h>
#include <CGAL/Intrinsic_triangulations/Tufted_surface.h>
#include <CGAL/Intrinsic_triangulations/connection_laplacian.h>
#include <CGAL/Intrinsic_triangulations/operators.h>
#include <CGAL/Intrinsic_triangulations/tangent_frames.h>

#include <functional>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;

namespace {

struct Operators_options
{
  std::string prefix;
  Refinement_bounds refinement; // none without an angle
};

constexpr const char* operators_help =
  R"(Files, with v vertices and f faces of the intrinsic triangulation:
  PREFIX_laplacian.mtx             cotan Laplacian, positive semidefinite (v x v, symmetric)
  PREFIX_mass.mtx                  consistent mass (v x v, symmetric)
  PREFIX_lumped_mass.mtx           lumped mass (v x v, diagonal)
  PREFIX_connection_laplacian.mtx  connection Laplacian (v x v, complex Hermitian)
  PREFIX_gradient.mtx              values at vertices to vectors on faces (2f x v)
  PREFIX_divergence.mtx            vectors on faces to integrals at vertices (v x 2f)
Rows and columns of vertices are in the order of the input; inserted vertices follow. Each face has
two rows or columns. The file of --save has the order of faces and the frames of tangent vectors.

The triangles need not form a surface, and with --neighbors the input may be points. Then f counts
faces of the tufted cover, two for each triangle, and a further file is written:
  PREFIX_cover_vertices.mtx        values at vertices to values at vertices of the cover (c x v)
The connection Laplacian is then c x c.

Example:
  intrinsic operators bunny.obj --prefix bunny --save bunny.txt)";

// Stores the operands of matrices: functions on the input, and vectors on the triangulation.
struct Operand
{
  const Triangulation& triangulation;
  const Covered_soup* covered; // null if the input is a surface
};

// Returns a function that writes a matrix of functions, `matrix(surface)`.
template <class Matrix_of>
auto of_functions(Matrix_symmetry symmetry, Matrix_of matrix)
{
  return [=](const Operand& operand, const auto& surface) {
    typedef IT::Tufted_surface<IT::Length_of<std::decay_t<decltype(surface)>>> Tufted;
    if(const Covered_soup* covered = operand.covered)
      return matrix_market(
        IT::rounded_values(matrix(Tufted(covered->cover, surface, covered->share()))), symmetry);
    return matrix_market(IT::rounded_values(matrix(surface)), symmetry);
  };
}

template <class Surface>
std::string connection_laplacian(const Operand&, const Surface& surface)
{
  const IT::Tangent_frames<IT::Length_of<Surface>> frames(surface);
  return matrix_market(IT::rounded_values(IT::connection_laplacian(surface, frames)),
                       Matrix_symmetry::HERMITIAN);
}

// Returns the matrix that maps functions on the input to the vertices of the cover.
std::string cover_vertices(const Operand& operand)
{
  const auto n = static_cast<int>(operand.triangulation.mesh().number_of_vertices());
  std::vector<Eigen::Triplet<double>> ones;
  for(const IT::Vertex_index v : operand.triangulation.mesh().vertices()) {
    const auto i = static_cast<int>(operand.covered->cover.input_vertex(v));
    ones.emplace_back(static_cast<int>(v.idx()), i, 1);
  }
  const auto inserted = operand.triangulation.number_of_inserted_vertices();
  Eigen::SparseMatrix<double> result(
    n, static_cast<int>(operand.covered->soup.points.size() + inserted));
  result.setFromTriplets(ones.begin(), ones.end());
  return matrix_market(result, Matrix_symmetry::GENERAL);
}

template <class Surface>
struct Matrix_description
{
  std::string name;
  std::function<std::string(const Operand&, const Surface&)> text;
};

// Describes the matrices. The first one rejects triangulations on which others would not be finite.
// The last one is for covers.
template <class Surface>
std::vector<Matrix_description<Surface>> matrices()
{
  const auto symmetric = Matrix_symmetry::SYMMETRIC, general = Matrix_symmetry::GENERAL;
  return {
    {"laplacian", of_functions(symmetric, [](const auto& s) { return IT::cotan_laplacian(s); })},
    {"mass", of_functions(symmetric, [](const auto& s) { return IT::mass_matrix(s); })},
    {"lumped_mass",
     of_functions(symmetric, [](const auto& s) { return IT::lumped_mass_matrix(s); })},
    {"connection_laplacian", connection_laplacian<Surface>},
    {"gradient", of_functions(general, [](const auto& s) { return IT::gradient_matrix(s); })},
    {"divergence", of_functions(general, [](const auto& s) { return IT::divergence_matrix(s); })},
    {"cover_vertices",
     [](const Operand& operand, const Surface&) { return cover_vertices(operand); }}};
}

std::vector<std::string> paths_of(const std::string& prefix)
{
  std::vector<std::string> result;
  for(const auto& matrix : matrices<IT::Surface_view<Triangulation::Edge_length_map>>())
    result.push_back(prefix + "_" + matrix.name + ".mtx");
  return result;
}

// Writes the first matrices, as many as there are paths.
template <class Surface>
void add_matrices(Command_run& run, const Operand& operand, const Surface& surface,
                  const std::vector<std::string>& paths)
{
  const auto all = matrices<Surface>();
  for(std::size_t i = 0; i < paths.size(); ++i)
    run.add_output(paths[i], all[i].text(operand, surface));
}

int write_matrices(Command_run& run, const Operators_options& options,
                   const std::vector<std::string>& paths)
{
  Triangulation triangulation = make_delaunay_triangulation(run);
  refine_if_wanted(run, triangulation, options.refinement);
  describe(run, triangulation);
  show(run, triangulation);
  run.statistics()["matrices"] = paths;
  const std::optional<Covered_soup>& covered = run.input().covered;
  run.timed("write", [&] {
    const Operand operand{triangulation, covered ? &*covered : nullptr};
    IT::with_resolved_areas(
      triangulation, [&](const auto& surface) { add_matrices(run, operand, surface, paths); });
    save(run, triangulation);
  });
  run.finish(summary_of_changes(run) + ", " + std::to_string(paths.size()) + " matrices");
  return 0;
}

int operators(const Common_options& common, const Operators_options& options)
{
  check_insertions(options.refinement);
  std::vector<std::string> paths = paths_of(options.prefix);
  Command_run run("operators", common, paths, true);
  if(!run.input().covered)
    paths.pop_back();
  run.plan({delaunay_stages, refinement_stages(options.refinement), certificate_stages(common),
            view_stages(common)});
  return attempt(run, [&] { return write_matrices(run, options, paths); });
}

} // namespace

void define_operators(Command_line& line)
{
  const auto [command, options] =
    line.add_with_mesh("operators", "Write matrices of the intrinsic Delaunay triangulation",
                       operators, operators_help);
  command.add_option("--prefix", options.prefix, "Start of the names of the Matrix Market files")
    ->required();
  add_save(command, line.common());
  add_common_options(command, line.common());
  add_exact(command, line.common());
  add_angle(command, options.refinement);
  add_neighbors(command, line.common());
}
