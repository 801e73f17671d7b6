// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// How well a Poisson equation is solved on a coarse surface (see Poisson_comparison.h): simplified
// by edge collapses with quadrics, and intrinsically with several weights of area beside curvature,
// and by the default cost. Of the meshes on the command line, or of some of CGAL's and generated
// ones.

#include "Poisson_comparison.h"
#include "quadric_simplification.h"
#include "surfaces.h"

#include <CGAL/Intrinsic_simplification/simplify.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <string>
#include <vector>

namespace {

// Of area, where curvature has weight one; the last stands for area alone.
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

void benchmark(const std::string& name, const Mesh& mesh)
{
  const Poisson_comparison comparison(mesh);
  std::vector<Errors> columns{quadric_errors(mesh, comparison)};
  for(double weight : weights)
    columns.push_back(intrinsic_errors(
      mesh, [&](const IS::Evolving_surface& s) { return cost_with(weight, s); }, comparison));
  columns.push_back(intrinsic_errors(mesh, IS::default_cost, comparison));
  for(std::size_t n = 0; n < parts.size(); ++n) {
    std::printf("%-22s%9u%9zu", name.c_str(), mesh.number_of_vertices(),
                mesh.number_of_vertices() / parts[n]);
    for(const Errors& errors : columns)
      std::printf("%10.5f", errors[n]);
    std::printf("\n");
  }
}

} // namespace

int main(int argc, char* argv[])
{
  std::printf("%-22s%9s%9s%10s", "mesh", "vertices", "coarse", "quadrics");
  for(double weight : weights)
    weight < 0 ? std::printf("%10s", "area only") : std::printf("%10g", weight);
  std::printf("%10s\n", "default");
  if(argc > 1) {
    for(const char* path : std::vector<const char*>(argv + 1, argv + argc))
      benchmark_file(path, benchmark);
    return 0;
  }
  for(const char* name : {"elephant", "camel", "armadillo", "bunny00", "fandisk_large",
                          "ChineseDragon-10kv", "turbine", "lion", "lion-head"})
    benchmark_file(CGAL::data_file_path("meshes/" + std::string(name) + ".off"), benchmark);
  benchmark("capsule", capsule(160));
  benchmark("bumpy torus", bumpy_torus(80));
  benchmark("hills", hills(150));
}
