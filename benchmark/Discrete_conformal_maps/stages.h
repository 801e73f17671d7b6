// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DISCRETE_CONFORMAL_MAPS_BENCHMARK_STAGES_H
#define DISCRETE_CONFORMAL_MAPS_BENCHMARK_STAGES_H

// What the stages of a map cost.

#include "surfaces.h"

#include <CGAL/Discrete_conformal_maps/Flattening_visitor.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <numeric>
#include <string>

#include <malloc.h>

namespace DCM = CGAL::Discrete_conformal_maps;

#ifdef CGAL_INTRINSIC_TRIANGULATIONS_USE_CHOLMOD
inline constexpr const char* factorization = "CHOLMOD";
inline constexpr const char* largest_surface = "1000000";
#else
inline constexpr const char* factorization = "Eigen";
inline constexpr const char* largest_surface = "100000";
#endif

// ---- Times ----

// The first stage is before those of `flatten()`: the intrinsic Delaunay triangulation.
inline constexpr std::array<const char*, 6> stage_names{"Delaunay", "cones", "optimize",
                                                        "layout",   "trace", "subdiv"};

// Seconds of CPU time.
struct Stopwatch : DCM::Default_flattening_visitor
{
  std::array<double, stage_names.size()> seconds{};
  std::size_t stage = 0;
  std::clock_t since = std::clock();

  void start(DCM::Flattening_stage next)
  {
    stop();
    stage = 1 + static_cast<std::size_t>(next);
  }
  void stop()
  {
    const std::clock_t now = std::clock();
    seconds[stage] += double(now - since) / CLOCKS_PER_SEC;
    since = now;
  }
  double total() const { return std::accumulate(seconds.begin(), seconds.end(), 0.); }
};

// ---- Memory ----

// Forgets how much the process has taken so far.
inline void reset_peak_memory()
{
  malloc_trim(0);
  std::ofstream("/proc/self/clear_refs") << 5;
}

// in megabytes
inline double peak_memory()
{
  std::ifstream status("/proc/self/status");
  for(std::string word; status >> word;)
    if(word == "VmHWM:") {
      double kilobytes = 0;
      status >> kilobytes;
      return kilobytes / 1024;
    }
  return 0;
}

// ---- Table ----

inline void print_stage_names()
{
  for(const char* name : stage_names)
    std::printf("%13s", name);
  std::printf("%9s%7s", "total", "MB");
}

inline void print(const Stopwatch& watch)
{
  for(const double seconds : watch.seconds)
    std::printf("%8.3f %3.0f%%", seconds, 100 * seconds / watch.total());
  std::printf("%9.3f%7.0f", watch.total(), peak_memory());
}

inline void end_line()
{
  std::printf("\n");
  std::fflush(stdout);
}

// Ever larger surfaces; `benchmark` prints a line and returns the time.
template <typename Make, typename Benchmark>
void benchmark_growth(const char* name, unsigned largest, const Make& make,
                      const Benchmark& benchmark)
{
  double last_time = 0, last_size = 0;
  for(unsigned n = largest / 64; n <= largest; n *= 4) {
    const Mesh mesh = make(n);
    const double time = benchmark(name, mesh), size = mesh.number_of_vertices();
    if(last_time > 0)
      std::printf("%8.2f", std::log(time / last_time) / std::log(size / last_size));
    end_line();
    last_time = time;
    last_size = size;
  }
}

template <typename Benchmark>
void benchmark_file(const std::string& file, const Benchmark& benchmark)
{
  Mesh mesh;
  if(CGAL::IO::read_polygon_mesh(file, mesh))
    benchmark(file.substr(file.find_last_of('/') + 1), mesh);
  else
    std::printf("%s: cannot be read", file.c_str());
  end_line();
}

#endif // DISCRETE_CONFORMAL_MAPS_BENCHMARK_STAGES_H
