// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Simplifies surfaces to 1 % of their vertices, and then refines them to angles of 25 degrees.
// Prints the least angles, and the faces below the bound that a small-angle vertex excuses, or not.
// Also prints the distances of points of the refined surface after a map to the input and back.
// Errors of a Poisson equation (see Poisson_comparison.h) and of distances from a vertex are given
// without and with refinement. Arguments are meshes, by default all meshes of CGAL that are
// surfaces.

#include "Poisson_comparison.h"
#include "surfaces.h"

#include <CGAL/Intrinsic_simplification/Prolonged_distances.h>
#include <CGAL/Intrinsic_simplification/Surface_subdivision.h>
#include <CGAL/Intrinsic_simplification/refine.h>
#include <CGAL/Intrinsic_simplification/simplify.h>
#include <CGAL/Intrinsic_triangulations/diagnose.h>
#include <CGAL/Random.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace {

typedef IS::Surface_map::Location Location;

double least_angle(const IS::Surface_level& level)
{
  return IT::diagnose(level.mesh(), IT::parameters::edge_length_map(level.length_map()))
    .statistics()
    .min_angle;
}

// Returns the distance of points, by their coordinates. Points on an edge or a vertex that faces
// share are equal.
double difference(const Location& p, const Location& q, const IS::Delta_complex& mesh)
{
  std::map<IT::Vertex_index, double> sum;
  const auto p_sides = IT::sides(p.first, mesh), q_sides = IT::sides(q.first, mesh);
  for(std::size_t s = 0; s < 3; ++s) {
    sum[mesh.source(p_sides[s])] += p.second[s];
    sum[mesh.source(q_sides[s])] -= q.second[s];
  }
  double result = 0;
  for(const auto& [v, x] : sum)
    result = (std::max)(result, std::abs(x));
  return result;
}

double error_there_and_back(const IS::Surface_map& map)
{
  const IS::Delta_complex& mesh = map.coarse().mesh();
  CGAL::Random random(1);
  double result = 0;
  for(const IT::Face_index f : mesh.faces())
    for(int n = 0; n < 4; ++n) {
      const double x = random.get_double(), y = random.get_double(0, 1 - x);
      const Location p{f, {x, y, 1 - x - y}};
      result = (std::max)(result, difference(p, map.to_coarse(map.to_fine(p)), mesh));
    }
  return result;
}

// Returns the error of distances from three sources, in percent.
double distance_error(const IS::Surface_map& map, const Eigen::SparseMatrix<double>& prolongation)
{
  const unsigned n = map.fine().mesh().number_of_vertices();
  double error = 0, sum = 0;
  for(unsigned k = 0; k < 3; ++k) {
    const IT::Vertex_index source(k * n / 3);
    const Eigen::VectorXd exact = IS::internal::geodesic_distances(source, map.fine());
    const Eigen::VectorXd near = IS::prolonged_distances_from(source, map, prolongation);
    for(Eigen::Index v = 0; v < exact.size(); ++v)
      if(std::isfinite(exact[v]) && std::isfinite(near[v])) {
        error += std::abs(exact[v] - near[v]);
        sum += exact[v];
      }
  }
  return 100 * error / sum;
}

struct Errors
{
  double poisson, distance;
};

Errors errors(const IS::Surface_map& map, const Poisson_comparison& comparison)
{
  const Eigen::SparseMatrix<double> p = IS::prolongation_matrix(map);
  return {100 * comparison.error(map.coarse(), p), distance_error(map, p)};
}

void benchmark(const Table& table, const std::string& name, const Mesh& mesh)
{
  IS::Evolving_surface surface(mesh);
  const IS::Surface_level fine(surface);
  IS::simplify(surface, IS::parameters::number_of_vertices(
                          std::size_t(std::ceil(mesh.number_of_vertices() / 100.))));
  const IS::Surface_level coarse(surface);
  const IT::Refinement_result result = IS::refine(surface);
  const IS::Surface_level refined(surface);
  const auto excused = static_cast<std::size_t>(
    std::count_if(result.remaining.begin(), result.remaining.end(), IT::is_excused));
  const IS::Surface_map to_coarse(surface, fine, coarse), to_refined(surface, fine, refined);
  const Poisson_comparison comparison(mesh);
  const Errors before = errors(to_coarse, comparison), after = errors(to_refined, comparison);
  table.row(name, mesh.number_of_vertices(), coarse.mesh().number_of_vertices(),
            refined.mesh().number_of_vertices(), least_angle(coarse), least_angle(refined), excused,
            result.remaining.size() - excused, error_there_and_back(to_refined), before.poisson,
            after.poisson, before.distance, after.distance);
}

void benchmark_file(const Table& table, const std::string& path)
{
  try {
    const Mesh mesh = read_surface(path);
    if(mesh.number_of_vertices() > 0)
      benchmark(table, name_of(path), mesh);
  } catch(const std::exception& e) {
    std::fprintf(stderr, "%s: %s\n", path.c_str(), e.what());
  }
}

std::vector<std::string> data_files()
{
  std::vector<std::string> result;
  for(const auto& file : std::filesystem::directory_iterator(
        std::filesystem::path(CGAL::data_file_path("meshes/elephant.off")).parent_path()))
    result.push_back(file.path().string());
  std::sort(result.begin(), result.end());
  return result;
}

} // namespace

int main(int argc, char* argv[])
{
  const Table table({"mesh", "vertices", "coarse", "refined", "angle", "refined", "excused", "not",
                     "round trip", "Poisson", "refined", "distances", "refined"});
  for(const std::string& path :
      argc > 1 ? std::vector<std::string>(argv + 1, argv + argc) : data_files())
    benchmark_file(table, path);
}
