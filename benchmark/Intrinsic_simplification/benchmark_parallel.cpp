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
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <limits>
#include <vector>

#include <malloc.h>
#include <tbb/global_control.h>

namespace IT = CGAL::Intrinsic_triangulations;
namespace DCM = CGAL::Discrete_conformal_maps;
namespace IS = CGAL::Intrinsic_simplification;

constexpr int repetitions = 7;

double milliseconds(clockid_t clock)
{
  timespec t;
  clock_gettime(clock, &t);
  return 1e3 * double(t.tv_sec) + 1e-6 * double(t.tv_nsec);
}

// The least times of a task: by the clock, and the CPU time of the thread with most of it, which is
// what the clock would show on an idle machine.
struct Least_times
{
  double clock = std::numeric_limits<double>::infinity(), busiest = clock;

  template <typename Task>
  void measure(std::size_t threads, const Task& task)
  {
    const double start = milliseconds(CLOCK_MONOTONIC),
                 all = milliseconds(CLOCK_PROCESS_CPUTIME_ID),
                 first = milliseconds(CLOCK_THREAD_CPUTIME_ID);
    task();
    const double of_first = milliseconds(CLOCK_THREAD_CPUTIME_ID) - first,
                 of_others = milliseconds(CLOCK_PROCESS_CPUTIME_ID) - all - of_first;
    clock = (std::min)(clock, milliseconds(CLOCK_MONOTONIC) - start);
    const auto others = double((std::max)(threads, std::size_t(2)) - 1);
    busiest = (std::min)(busiest, (std::max)(of_first, of_others / others));
  }
};

// `task(np)` makes an object.
template <typename Task>
void benchmark(const char* name, std::size_t threads, const Task& task)
{
  const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
  const auto sequential = IT::parameters::concurrency_tag(CGAL::Sequential_tag());
  const auto parallel = IT::parameters::concurrency_tag(CGAL::Parallel_tag());
  Least_times one, several;
  for(int i = 0; i < repetitions; ++i) {
    one.measure(1, [&] { task(sequential); });
    several.measure(threads, [&] { task(parallel); });
  }
  std::printf("%-28s%11.1f%11.1f%8.2f%11.1f%11.1f%8.2f\n", name, one.clock, several.clock,
              several.clock / one.clock, one.busiest, several.busiest,
              several.busiest / one.busiest);
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
  std::printf("%-28s%30s%30s\n", "", "by the clock", "CPU time of the busiest thread");
  std::printf("%-28s%11s%6zu thr.%8s%11s%6zu thr.%8s\n", "", "1 thread", threads, "ratio",
              "1 thread", threads, "ratio");
  benchmark_triangulations(mesh, threads);
  benchmark_maps(mesh, threads);
  benchmark_simplification(mesh, threads);
}
