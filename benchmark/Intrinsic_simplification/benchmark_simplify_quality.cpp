// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Measures how accurately a Poisson equation is solved on a coarse surface (see
// Poisson_comparison.h). It is simplified by edge collapses with quadrics, intrinsically with
// several weights of area beside curvature, and by the default cost. Arguments are meshes, by
// default some of CGAL's and generated ones.

#include "Poisson_comparison.h"
#include "quadric_simplification.h"
#include "surfaces.h"

#include <CGAL/Intrinsic_simplification/simplify.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace {

// These are weights of area, if curvature has weight one. The last one denotes area alone.
constexpr std::array<double, 6> weights{0, 0.3, 1, IS::default_area_weight, 5, -1};
constexpr std::array<std::size_t, 2> parts{10, 50};
typedef std::array<double, parts.size()> Errors;

IS::Transport_cost cost_with(double area_weight, const IS::Evolving_surface& surface)
{
  IS::Transport_cost cost(surface);
  if(area_weight >= 0)
    cost.add_curvature(surface);
  if(area_weight != 0)
    cost.add_area(surface, std::abs(area_weight));
  return cost;
}

template <typename Cost_of>
Errors intrinsic_errors(const Mesh& mesh, const Cost_of& cost_of,
                        const Poisson_comparison& comparison)
{
  IS::Evolving_surface surface(mesh);
  const IS::Surface_level fine(surface);
  IS::Transport_cost cost = cost_of(surface);
  Errors result;
  for(std::size_t n = 0; n < parts.size(); ++n) {
    IS::simplify(surface, cost,
                 IS::parameters::number_of_vertices(mesh.number_of_vertices() / parts[n]));
    const IS::Surface_level coarse(surface);
    result[n] =
      comparison.error(coarse, IS::prolongation_matrix(IS::Surface_map(surface, fine, coarse)));
  }
  return result;
}

Errors quadric_errors(const Mesh& mesh, const Poisson_comparison& comparison)
{
  Errors result;
  for(std::size_t n = 0; n < parts.size(); ++n) {
    const Mesh coarse = collapsed(mesh, mesh.number_of_vertices() / parts[n]);
    result[n] = comparison.error(IS::Surface_level(IS::Evolving_surface(coarse)),
                                 closest_point_matrix(coarse, mesh));
  }
  return result;
}

// Computes geometric means of the columns.
class Means
{
public:
  void add(const std::vector<double>& errors)
  {
    m_logarithms.resize(errors.size());
    for(std::size_t k = 0; k < errors.size(); ++k)
      m_logarithms[k] += std::log(errors[k]);
    ++m_size;
  }

  // Returns the means, divided by one of them.
  std::vector<std::string> ratios_to(std::size_t unit) const
  {
    std::vector<std::string> result;
    for(const double sum : m_logarithms)
      result.push_back(Table::text(std::exp((sum - m_logarithms[unit]) / double(m_size))));
    return result;
  }

private:
  std::vector<double> m_logarithms;
  std::size_t m_size = 0;
};

void benchmark(const std::string& name, const Mesh& mesh, Means& means)
{
  const Poisson_comparison comparison(mesh);
  std::vector<Errors> columns{quadric_errors(mesh, comparison)};
  for(double weight : weights)
    columns.push_back(intrinsic_errors(
      mesh, [&](const IS::Evolving_surface& s) { return cost_with(weight, s); }, comparison));
  columns.push_back(intrinsic_errors(mesh, IS::default_cost, comparison));
  for(std::size_t n = 0; n < parts.size(); ++n) {
    std::vector<double> row;
    std::vector<std::string> cells{name, Table::text(mesh.number_of_vertices()),
                                   Table::text(mesh.number_of_vertices() / parts[n])};
    for(const Errors& errors : columns) {
      row.push_back(errors[n]);
      cells.push_back(Table::text(errors[n]));
    }
    means.add(row);
    Table::print(cells);
  }
}

} // namespace

int main(int argc, char* argv[])
{
  const Table table(
    {"mesh", "vertices", "coarse", "quadrics", "0", "0.3", "1", "2", "5", "area only", "default"});
  Means means;
  const auto benchmark_mesh = [&](const std::string& name, const Mesh& mesh) {
    benchmark(name, mesh, means);
  };
  for(int i = 1; i < argc; ++i)
    benchmark_file(argv[i], benchmark_mesh);
  if(argc > 1)
    return 0;
  for(const char* name : {"elephant", "camel", "armadillo", "bunny00", "fandisk_large",
                          "ChineseDragon-10kv", "turbine", "lion", "lion-head"})
    benchmark_file(CGAL::data_file_path("meshes/" + std::string(name) + ".off"), benchmark_mesh);
  benchmark_mesh("capsule", capsule(160));
  benchmark_mesh("bumpy torus", bumpy_torus(80));
  benchmark_mesh("hills", hills(150));
  const Table summary({"meshes", "quadrics", "0", "0.3", "1", "2", "5", "area only", "default"});
  std::vector<std::string> cells = means.ratios_to(3); // the weight 1
  cells.insert(cells.begin(), "geometric mean");
  Table::print(cells);
}
