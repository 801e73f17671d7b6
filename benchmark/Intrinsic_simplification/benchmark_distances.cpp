// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Measures geodesic distances on coarse surfaces, prolonged: error against speed-up. They are
// compared with the heat method on the fine surface, and with exact distances after edge collapses
// with quadrics (Figures 5.8 and 5.9). All pairs are measured, too (Figure 5.10). Arguments are
// connected meshes, by default some of CGAL's. Errors are means over five sources, relative to the
// mean distance. The truth are exact distances on the fine surface. Times are for one source,
// without simplification.

#include "../Intrinsic_triangulations/measure.h"
#include "quadric_simplification.h"
#include "surfaces.h"

#include <CGAL/Intrinsic_simplification/Prolonged_distances.h>
#include <CGAL/Intrinsic_simplification/simplify.h>
#include <CGAL/Intrinsic_triangulations/heat_distance.h>

#include <cstddef>
#include <cstdio>
#include <string>
#include <vector>

namespace IS = CGAL::Intrinsic_simplification;
namespace IT = CGAL::Intrinsic_triangulations;

typedef Eigen::VectorXd Vector;
typedef Eigen::SparseMatrix<double, Eigen::RowMajor> Matrix;

namespace {

// Stores exact distances from some vertices, and their cost.
class Truth
{
public:
  explicit Truth(const IS::Surface_level& fine) : m_fine(fine)
  {
    const std::size_t n = fine.mesh().number_of_vertices();
    for(std::size_t k = 0; k < 5; ++k) {
      m_sources.emplace_back(IT::Vertex_index(static_cast<unsigned>(k * n / 5 + n / 10)));
      m_exact.push_back(
        m_samples.time([&] { return IS::internal::geodesic_distances(m_sources[k], m_fine); }));
    }
  }

  const IS::Surface_level& fine() const { return m_fine; }
  double milliseconds() const { return m_samples.median(); }

  // Returns the error in percent.
  template <typename Distances>
  double error(const Distances& distances, Samples& samples) const
  {
    double difference = 0, sum = 0;
    for(std::size_t k = 0; k < m_sources.size(); ++k) {
      const Vector d = samples.time([&] { return Vector(distances(m_sources[k])); });
      difference += (d - m_exact[k]).cwiseAbs().sum();
      sum += m_exact[k].sum();
    }
    return 100 * difference / sum;
  }

private:
  const IS::Surface_level& m_fine;
  std::vector<IT::Vertex_index> m_sources;
  std::vector<Vector> m_exact;
  Samples m_samples;
};

double quadric_error(const Mesh& mesh, std::size_t vertices, const Truth& truth)
{
  const Mesh coarse = collapsed(mesh, vertices);
  const IS::Surface_level level{IS::Evolving_surface(coarse)};
  const Matrix p = closest_point_matrix(coarse, mesh);
  Samples samples;
  return truth.error(
    [&](IT::Vertex_index v) {
      Vector sum = Vector::Zero(p.cols());
      for(Matrix::InnerIterator a(p, v); a; ++a)
        sum += a.value() * IS::internal::geodesic_distances(
                             IT::Vertex_index(static_cast<unsigned>(a.index())), level);
      return Vector(p * sum);
    },
    samples);
}

void benchmark_heat(const Table& table, const std::string& name, const Truth& truth)
{
  const auto vertices = truth.fine().mesh().number_of_vertices();
  Samples samples;
  const IT::Heat_distance<> heat(truth.fine());
  const double error = truth.error([&](IT::Vertex_index v) { return heat.distances(v); }, samples);
  table.row(name, vertices, "heat method", truth.milliseconds() / samples.median(), error, "");
}

void benchmark_level(const Table& table, const std::string& name, const Mesh& mesh,
                     const IS::Surface_map& map, const Truth& truth)
{
  const Matrix p = IS::prolongation_matrix(map);
  Samples samples;
  const double error = truth.error(
    [&](IT::Vertex_index v) { return IS::prolonged_distances_from(v, map, p); }, samples);
  const std::size_t vertices = map.coarse().mesh().number_of_vertices();
  table.row(name, mesh.number_of_vertices(), vertices, truth.milliseconds() / samples.median(),
            error, quadric_error(mesh, vertices, truth));
}

// Prints error against speed-up.
void benchmark_sources(const Table& table, const std::string& name, const Mesh& mesh)
{
  IS::Evolving_surface surface(mesh);
  const IS::Surface_level fine(surface);
  const Truth truth(fine);
  benchmark_heat(table, name, truth);
  IS::Transport_cost cost = IS::default_cost(surface);
  for(const std::size_t part : {5U, 20U, 50U, 200U}) {
    IS::simplify(surface, cost,
                 IS::parameters::number_of_vertices(mesh.number_of_vertices() / part));
    const IS::Surface_level coarse(surface);
    benchmark_level(table, name, mesh, IS::Surface_map(surface, fine, coarse), truth);
  }
}

IS::Prolonged_distances all_pairs(const Mesh& mesh, std::size_t vertices)
{
  IS::Evolving_surface surface(mesh);
  const IS::Surface_level fine(surface);
  IS::simplify(surface, IS::parameters::number_of_vertices(vertices));
  const IS::Surface_level coarse(surface);
  return {coarse, IS::prolongation_matrix(IS::Surface_map(surface, fine, coarse))};
}

// Measures all pairs, including simplification. The time of exact distances of all pairs is
// extrapolated.
void benchmark_all_pairs(const Table& table, const std::string& name, const Mesh& mesh)
{
  if(mesh.number_of_vertices() > 10000) // eight bytes for each pair
    return;
  const IS::Surface_level fine{IS::Evolving_surface(mesh)};
  const Truth truth(fine);
  const double exact = truth.milliseconds() * mesh.number_of_vertices();
  for(const std::size_t part : {5U, 20U, 50U}) {
    Samples samples, row;
    const auto distances =
      samples.time([&] { return all_pairs(mesh, mesh.number_of_vertices() / part); });
    Samples product;
    product.time([&] { return distances.matrix().sum(); });
    const double error = truth.error([&](IT::Vertex_index v) { return distances.from(v); }, row);
    const double all = samples.median() + product.median();
    table.row(name, mesh.number_of_vertices(), mesh.number_of_vertices() / part, all / 1000,
              exact / all, error);
  }
}

// Calls `benchmark(table, name, mesh)` for each file.
template <typename Benchmark>
void benchmark_files(const std::vector<std::string>& files, const Table& table,
                     const Benchmark& benchmark)
{
  for(const std::string& file : files)
    benchmark_file(
      file, [&](const std::string& name, const Mesh& mesh) { benchmark(table, name, mesh); });
}

} // namespace

int main(int argc, char* argv[])
{
  keep_memory();
  std::vector<std::string> files(argv + 1, argv + argc);
  if(files.empty())
    for(const char* name : {"fandisk", "bull", "armadillo", "refined_elephant"})
      files.push_back(CGAL::data_file_path("meshes/" + std::string(name) + ".off"));
  benchmark_files(files,
                  Table({"mesh", "vertices", "coarse", "speed-up", "error (%)", "quadrics (%)"}),
                  benchmark_sources);
  benchmark_files(files, Table({"mesh", "vertices", "coarse", "seconds", "speed-up", "error (%)"}),
                  benchmark_all_pairs);
}
