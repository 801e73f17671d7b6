// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What several threads gain, by the clock: tracing and the common subdivision of a torus with a
// million faces and its intrinsic Delaunay triangulation, its certificate, a flat map, and what
// takes a half million points through a simplification. One thread and several take turns, and the
// best of each counts. The argument is the number of threads, 2 by default; a second one is the
// number of faces.

#include "surfaces.h"

#include <CGAL/Discrete_conformal_maps/Conformal_energy.h>
#include <CGAL/Discrete_conformal_maps/Triple_subdivision.h>
#include <CGAL/Intrinsic_simplification/prolongation.h>
#include <CGAL/Intrinsic_simplification/simplify.h>
#include <CGAL/Intrinsic_triangulations/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/certify_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/function_transfer.h>
#include <CGAL/Intrinsic_triangulations/make_Delaunay.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <optional>

#include <malloc.h>
#include <tbb/global_control.h>

namespace IT = CGAL::Intrinsic_triangulations;
namespace DCM = CGAL::Discrete_conformal_maps;
namespace IS = CGAL::Intrinsic_simplification;

constexpr int repetitions = 7;

template <typename Task>
double seconds(const Task& task)
{
  const auto start = std::chrono::steady_clock::now();
  task();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// `task(np)` makes an object.
template <typename Task>
void benchmark(const char* name, std::size_t threads, const Task& task)
{
  const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
  double one = std::numeric_limits<double>::infinity(), several = one;
  for(int i = 0; i < repetitions; ++i) {
    one = (std::min)(
      one, seconds([&] { task(IT::parameters::concurrency_tag(CGAL::Sequential_tag())); }));
    several = (std::min)(
      several, seconds([&] { task(IT::parameters::concurrency_tag(CGAL::Parallel_tag())); }));
  }
  std::printf("%-32s%12.1f%12.1f%8.2f\n", name, 1000 * one, 1000 * several, several / one);
  std::fflush(stdout);
}

void benchmark_triangulations(const Mesh& mesh, std::size_t threads)
{
  IT::Intrinsic_triangulation<> tri(mesh);
  IT::make_Delaunay(tri);
  benchmark("tracing", threads, [&](const auto& np) { IT::Correspondence<>(tri, np); });
  const IT::Correspondence<> correspondence(tri);
  benchmark("common subdivision", threads,
            [&](const auto& np) { IT::Common_subdivision<>(correspondence, np); });
  benchmark("both", threads, [&](const auto& np) {
    const IT::Correspondence<> c(tri, np);
    IT::Common_subdivision<>(c, np);
  });
  const IT::Common_subdivision<> subdivision(correspondence);
  benchmark("interpolation matrix", threads,
            [&](const auto& np) { IT::interpolation_matrix(IT::Side::input, subdivision, np); });
  benchmark("certificate", threads, [&](const auto& np) { IT::certify_Delaunay(tri, np); });
}

void benchmark_maps(const Mesh& mesh, std::size_t threads)
{
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
  benchmark("energy with Hessian", threads, evaluate);
  IT::Intrinsic_triangulation<IT::Ideal_geometry_traits<>> bc(ab.mesh(), length);
  for(IT::Halfedge_index h : energy.surface().flips())
    bc.flip(h);
  const IT::Correspondence<> first(ab);
  const IT::Correspondence<IT::Ideal_geometry_traits<>> second(bc);
  benchmark("subdivision of three", threads,
            [&](const auto& np) { DCM::Triple_subdivision<>(first, second, np); });
}

void benchmark_simplification(const Mesh& mesh, std::size_t threads)
{
  IS::Evolving_surface surface(mesh);
  const IS::Surface_level fine(surface);
  IS::simplify(surface,
               IS::parameters::number_of_vertices(std::size_t(mesh.number_of_vertices() / 10)));
  const IS::Surface_level coarse(surface);
  const IS::Surface_map map(surface, fine, coarse);
  benchmark("prolongation matrix", threads,
            [&](const auto& np) { IS::prolongation_matrix(map, np); });
  std::vector<IS::Surface_map::Location> points;
  for(IS::Face_index f : fine.mesh().faces())
    points.push_back({f, {0.2, 0.3, 0.5}});
  benchmark("points of all faces", threads, [&](const auto& np) { map.to_coarse(points, np); });
}

int main(int argc, char** argv)
{
  mallopt(M_TRIM_THRESHOLD, 1 << 30);
  mallopt(M_MMAP_THRESHOLD, 1 << 30);
  const std::size_t threads = argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 2;
  const double faces = argc > 2 ? std::strtod(argv[2], nullptr) : 1e6;
  const Mesh mesh = bumpy_torus(static_cast<unsigned>(std::lround(std::sqrt(faces / 6))));
  std::printf("%u faces; milliseconds, the best of %d\n", mesh.number_of_faces(), repetitions);
  std::printf("%-32s%12s%9zu thr.%8s\n", "", "sequential", threads, "ratio");
  benchmark_triangulations(mesh, threads);
  benchmark_maps(mesh, threads);
  benchmark_simplification(mesh, threads);
}
