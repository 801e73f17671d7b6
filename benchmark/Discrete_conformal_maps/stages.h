// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DISCRETE_CONFORMAL_MAPS_BENCHMARK_STAGES_H
#define DISCRETE_CONFORMAL_MAPS_BENCHMARK_STAGES_H

// This file measures the cost of the stages of a map.

#include "../Table.h"
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
#include <utility>
#include <vector>

#include <malloc.h>

namespace DCM = CGAL::Discrete_conformal_maps;

#ifdef CGAL_INTRINSIC_TRIANGULATIONS_USE_CHOLMOD
inline constexpr const char* largest_surface = "1000000";
#else
inline constexpr const char* largest_surface = "100000";
#endif

// ---- Times ----

// The first stage precedes the stages of `flatten()`: the intrinsic Delaunay triangulation.
inline constexpr std::array<const char*, 6> stage_names{"Delaunay", "cones", "optimize",
                                                        "layout",   "trace", "subdivide"};

// Measures seconds of CPU time.
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

// Resets the greatest memory of the process.
inline void reset_peak_memory()
{
  malloc_trim(0);
  std::ofstream("/proc/self/clear_refs") << 5;
}

// Returns the greatest memory in megabytes.
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

// Returns headings: some, stages, total and memory, others.
inline std::vector<std::string> with_stages(std::vector<std::string> headings,
                                            const std::vector<std::string>& others)
{
  headings.insert(headings.end(), stage_names.begin(), stage_names.end());
  headings.insert(headings.end(), {"total", "MB"});
  headings.insert(headings.end(), others.begin(), others.end());
  return headings;
}

// Appends seconds and percent of each stage, the total and the memory.
inline void append(std::vector<std::string>& cells, const Stopwatch& watch)
{
  for(const double seconds : watch.seconds)
    cells.push_back(seconds > 0
                      ? Table::text(seconds) + " (" +
                          std::to_string(std::lround(100 * seconds / watch.total())) + " %)"
                      : "");
  cells.push_back(Table::text(watch.total()));
  cells.push_back(Table::text(std::lround(peak_memory())));
}

// Computes the exponent with which the time grows with the size.
class Growth
{
public:
  // Returns the exponent since the last call, or nothing at the first one.
  std::string since_last(double time, std::size_t size)
  {
    const double last_time = std::exchange(m_time, time),
                 last_size = std::exchange(m_size, double(size));
    return last_time > 0
             ? Table::text(std::log(time / last_time) / std::log(double(size) / last_size))
             : "";
  }

private:
  double m_time = 0, m_size = 0;
};

// Runs `benchmark`, which prints a row, for ever larger surfaces.
template <typename Make, typename Benchmark>
void benchmark_growth(const char* name, unsigned largest, const Make& make,
                      const Benchmark& benchmark)
{
  Growth growth;
  for(unsigned n = largest / 64; n <= largest; n *= 4)
    benchmark(name, make(n), growth);
}

template <typename Benchmark>
void benchmark_file(const std::string& file, const Benchmark& benchmark)
{
  Mesh mesh;
  Growth growth;
  if(CGAL::IO::read_polygon_mesh(file, mesh))
    benchmark(name_of(file), mesh, growth);
  else
    std::fprintf(stderr, "%s cannot be read\n", file.c_str());
}

#endif // DISCRETE_CONFORMAL_MAPS_BENCHMARK_STAGES_H
