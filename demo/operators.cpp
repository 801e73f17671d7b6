// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands.h"

#include "Command_run.h"
#include "matrix_market.h"
#include "triangulation_stages.h"

#include <CGAL/Intrinsic_triangulations/connection_laplacian.h>
#include <CGAL/Intrinsic_triangulations/operators.h>
#include <CGAL/Intrinsic_triangulations/tangent_frames.h>

#include <array>

namespace IT = CGAL::Intrinsic_triangulations;

namespace {

std::string laplacian(const Triangulation& tri)
{
  return matrix_market(IT::cotan_laplacian(tri.intrinsic()), Matrix_symmetry::SYMMETRIC);
}

std::string mass(const Triangulation& tri)
{
  return matrix_market(IT::mass_matrix(tri.intrinsic()), Matrix_symmetry::SYMMETRIC);
}

std::string lumped_mass(const Triangulation& tri)
{
  return matrix_market(IT::lumped_mass_matrix(tri.intrinsic()), Matrix_symmetry::SYMMETRIC);
}

std::string connection_laplacian(const Triangulation& tri)
{
  const IT::Tangent_frames<double> frames(tri.intrinsic());
  return matrix_market(IT::connection_laplacian(tri.intrinsic(), frames),
                       Matrix_symmetry::HERMITIAN);
}

std::string gradient(const Triangulation& tri)
{
  return matrix_market(IT::gradient_matrix(tri.intrinsic()), Matrix_symmetry::GENERAL);
}

std::string divergence(const Triangulation& tri)
{
  return matrix_market(IT::divergence_matrix(tri.intrinsic()), Matrix_symmetry::GENERAL);
}

struct Matrix_description
{
  std::string_view name;
  std::string (*text)(const Triangulation&);
};

// The first one refuses triangulations on which others would not be finite.
constexpr std::array<Matrix_description, 6> matrices = {
  {{"laplacian", laplacian},
   {"mass", mass},
   {"lumped_mass", lumped_mass},
   {"connection_laplacian", connection_laplacian},
   {"gradient", gradient},
   {"divergence", divergence}}};

std::vector<std::string> paths_of(const std::string& prefix)
{
  std::vector<std::string> result;
  for(const Matrix_description& matrix : matrices)
    result.push_back(prefix + "_" + std::string(matrix.name) + ".mtx");
  return result;
}

} // namespace

int operators(const Common_options& common, const Operators_options& options)
{
  const std::vector<std::string> paths = paths_of(options.prefix);
  Command_run run("operators", common, paths);
  run.plan({delaunay_stages, refinement_stages(options.minimum_angle), certificate_stages(common),
            view_stages(common)});
  Triangulation triangulation = make_delaunay_triangulation(run);
  refine_if_wanted(run, triangulation, options.minimum_angle);
  describe(run, triangulation);
  show(run, triangulation);
  run.statistics()["matrices"] = paths;
  run.timed("write", [&] {
    for(std::size_t i = 0; i < matrices.size(); ++i)
      run.add_output(paths[i], matrices[i].text(triangulation));
    save(run, triangulation);
  });
  run.finish(summary_of_changes(run) + ", " + std::to_string(paths.size()) + " matrices");
  return 0;
}
