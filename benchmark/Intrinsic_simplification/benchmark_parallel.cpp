// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Measures the wall-clock gain of several threads. The first tasks are the trace and the common
// subdivision of a torus with a million faces and its intrinsic Delaunay triangulation. The next
// ones are its certificate, distances and paths on a smaller torus, and a flat map. The last task
// maps half a million points through a simplification. One thread and several threads alternate,
// and the best time of each counts. Distances and paths must have the same bytes with both. The
// first argument is the number of threads, 2 by default; the second one is the number of faces.

#include "surfaces.h"

#include <CGAL/Discrete_conformal_maps/Conformal_energy.h>
#include <CGAL/Discrete_conformal_maps/Triple_subdivision.h>
#include <CGAL/Intrinsic_simplification/prolongation.h>
#include <CGAL/Intrinsic_simplification/simplify.h>
#include <CGAL/Intrinsic_triangulations/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/Flipped_paths.h>
#include <CGAL/Intrinsic_triangulations/certify_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/distances_from_each.h>
#include <CGAL/Intrinsic_triangulations/function_transfer.h>
#include <CGAL/Intrinsic_triangulations/make_Delaunay.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <malloc.h>
#include <tbb/global_control.h>

namespace IT = CGAL::Intrinsic_triangulations;
namespace DCM = CGAL::Discrete_conformal_maps;
namespace IS = CGAL::Intrinsic_simplification;

constexpr int repetitions = 7;

// Returns milliseconds of a task by the clock.
template <typename Task>
double measure(const Task& task)
{
  const auto start = std::chrono::steady_clock::now();
  task();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
    .count();
}

const std::vector<std::string> headings{"", "one thread (ms)", "several threads (ms)", "ratio"};

// Measures `task(np)`, which makes an object.
template <typename Task>
void benchmark(const Table& table, const char* name, std::size_t threads, const Task& task)
{
  const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
  const auto sequential = IT::parameters::concurrency_tag(CGAL::Sequential_tag());
  const auto parallel = IT::parameters::concurrency_tag(CGAL::Parallel_tag());
  double one = std::numeric_limits<double>::infinity(), several = one;
  for(int i = 0; i < repetitions; ++i) {
    one = (std::min)(one, measure([&] { task(sequential); }));
    several = (std::min)(several, measure([&] { task(parallel); }));
  }
  table.row(name, one, several, several / one);
}

// Measures `task(np)`, and checks that `numbers(result)` has the same bytes with several threads.
template <typename Task, typename Numbers>
void benchmark_equal(const Table& table, const char* name, std::size_t threads, const Task& task,
                     const Numbers& numbers)
{
  const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
  const std::vector<double> one = numbers(
                              task(IT::parameters::concurrency_tag(CGAL::Sequential_tag()))),
                            several =
                              numbers(task(IT::parameters::concurrency_tag(CGAL::Parallel_tag())));
  if(one.size() != several.size() ||
     std::memcmp(one.data(), several.data(), one.size() * sizeof(double)) != 0)
    throw std::runtime_error(std::string(name) + " depends on the number of threads");
  benchmark(table, name, threads, task);
}

std::vector<double> numbers_of(const std::vector<IT::Flipped_path<double>>& paths,
                               const IT::Delta_complex& mesh)
{
  std::vector<double> result;
  for(const auto& p : paths) {
    result.insert(result.end(), {double(p.number_of_flips), p.path.length});
    for(const auto& place : p.path.places) {
      const auto [f, weights] = IT::face_location(place, mesh);
      result.push_back(f.idx());
      result.insert(result.end(), weights.begin(), weights.end());
    }
  }
  return result;
}

// Measures distances from eight vertices and 400 paths on a torus with about 50,000 faces.
void benchmark_paths(const Table& table, std::size_t threads)
{
  const IT::Intrinsic_triangulation<> tri(bumpy_torus(91));
  const auto vertex = [n = tri.mesh().number_of_vertices()](unsigned i) {
    return IT::Vertex_index(static_cast<unsigned>(i * 7919ul % n)); // by a prime
  };
  std::vector<IT::Vertex_index> sources;
  for(unsigned i = 0; i < 8; ++i)
    sources.push_back(vertex(i));
  benchmark_equal(
    table, "`distances_from_each()`, 8 vertices, 50,000 faces", threads,
    [&](const auto& np) { return IT::distances_from_each(tri.input(), sources, np); },
    [](const auto& matrix) {
      return std::vector<double>(matrix.data(), matrix.data() + matrix.size());
    });
  std::vector<std::pair<IT::Vertex_index, IT::Vertex_index>> pairs;
  for(unsigned i = 0; i < 400; ++i)
    pairs.emplace_back(vertex(2 * i), vertex(2 * i + 1));
  benchmark_equal(
    table, "`flipped_paths()`, 400 pairs, 50,000 faces", threads,
    [&](const auto& np) { return IT::flipped_paths(tri, pairs, np); },
    [&](const auto& paths) { return numbers_of(paths, tri.input_mesh()); });
}

void benchmark_triangulations(const Mesh& mesh, std::size_t threads)
{
  const Table table(headings);
  IT::Intrinsic_triangulation<> tri(mesh);
  IT::make_Delaunay(tri);
  benchmark(table, "`Correspondence`", threads,
            [&](const auto& np) { IT::Correspondence<>(tri, np); });
  const IT::Correspondence<> correspondence(tri);
  benchmark(table, "`Common_subdivision`", threads,
            [&](const auto& np) { IT::Common_subdivision<>(correspondence, np); });
  const IT::Common_subdivision<> subdivision(correspondence);
  benchmark(table, "`interpolation_matrix()`", threads,
            [&](const auto& np) { IT::interpolation_matrix(IT::Side::input, subdivision, np); });
  benchmark(table, "`certify_Delaunay()`", threads,
            [&](const auto& np) { IT::certify_Delaunay(tri, np); });
  benchmark_paths(table, threads);
}

void benchmark_maps(const Mesh& mesh, std::size_t threads)
{
  const Table table(headings);
  IT::Intrinsic_triangulation<> ab(mesh);
  IT::make_Delaunay(ab);
  const auto length = IT::parameters::edge_length_map(ab.length_map());
  const auto n = static_cast<Eigen::Index>(mesh.number_of_vertices());
  Eigen::VectorXd u(n);
  for(Eigen::Index v = 0; v < n; ++v)
    u[v] = std::sin(0.001 * double(v)) / 4;
  DCM::Conformal_energy<> energy(ab.mesh(), ab.length_map(), Eigen::VectorXd::Zero(n));
  const auto evaluate = [&](const auto& np) {
    energy.set_concurrency(CGAL::parameters::get_parameter(np, IT::internal_np::concurrency_tag));
    energy.evaluate(u);
    energy.Hessian();
  };
  benchmark(table, "`Conformal_energy`, with the Hessian", threads, evaluate);
  IT::Intrinsic_triangulation<IT::Ideal_geometry_traits<>> bc(ab.mesh(), length);
  for(IT::Halfedge_index h : energy.surface().flips())
    bc.flip(h);
  const IT::Correspondence<> first(ab);
  const IT::Correspondence<IT::Ideal_geometry_traits<>> second(bc);
  benchmark(table, "`Triple_subdivision`", threads,
            [&](const auto& np) { DCM::Triple_subdivision<>(first, second, np); });
}

void benchmark_simplification(const Mesh& mesh, std::size_t threads)
{
  const Table table(headings);
  IS::Evolving_surface surface(mesh);
  const IS::Surface_level fine(surface);
  IS::simplify(surface,
               IS::parameters::number_of_vertices(std::size_t(mesh.number_of_vertices() / 10)));
  const IS::Surface_level coarse(surface);
  const IS::Surface_map map(surface, fine, coarse);
  benchmark(table, "`prolongation_matrix()`", threads,
            [&](const auto& np) { IS::prolongation_matrix(map, np); });
  std::vector<IS::Surface_map::Location> points;
  for(IS::Face_index f : fine.mesh().faces())
    points.push_back({f, {0.2, 0.3, 0.5}});
  benchmark(table, "`Surface_map::to_coarse()`, a point of each face", threads,
            [&](const auto& np) { map.to_coarse(points, np); });
}

int main(int argc, char** argv)
{
  mallopt(M_TRIM_THRESHOLD, 1 << 30);
  mallopt(M_MMAP_THRESHOLD, 1 << 30);
  const std::size_t threads = argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 2;
  const double faces = argc > 2 ? std::strtod(argv[2], nullptr) : 1e6;
  const Mesh mesh = bumpy_torus(static_cast<unsigned>(std::lround(std::sqrt(faces / 6))));
  benchmark_triangulations(mesh, threads);
  benchmark_maps(mesh, threads);
  benchmark_simplification(mesh, threads);
}
