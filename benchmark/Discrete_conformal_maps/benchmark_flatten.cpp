// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Where the time of flattening goes (Figure 4.24), in seconds of CPU time and in percent, how it grows (with
// the number of vertices to the power printed last), and the greatest memory. Arguments are names of meshes,
// or numbers of vertices of the largest spheres and tori to be generated.

#include "surfaces.h"

#include <CGAL/Discrete_conformal_maps/cross_ratios.h>
#include <CGAL/Discrete_conformal_maps/flatten.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <functional>
#include <numeric>
#include <string>
#include <vector>

#include <malloc.h>

namespace DCM = CGAL::Discrete_conformal_maps;

#ifdef CGAL_DISCRETE_CONFORMAL_MAPS_USE_CHOLMOD
constexpr const char* factorization = "CHOLMOD";
constexpr const char* largest_surface = "1000000";
#else
constexpr const char* factorization = "Eigen";
constexpr const char* largest_surface = "100000";
#endif

// ---- Times ----

// The first stage is before those of `flatten()`: the intrinsic Delaunay triangulation.
constexpr std::array<const char*, 6> stage_names{"Delaunay", "cones",  "optimize",
                                                 "trace",    "subdiv", "layout"};

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
void reset_peak_memory()
{
  malloc_trim(0);
  std::ofstream("/proc/self/clear_refs") << 5;
}

// in megabytes
double peak_memory()
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

void print_head()
{
  std::printf("Factorization: %s\n%-16s%8s%6s%6s", factorization, "mesh", "vertices", "cones",
              "steps");
  for(const char* name : stage_names)
    std::printf("%13s", name);
  std::printf("%9s%7s%10s%10s%8s\n", "total", "MB", "curvature", "ratios", "growth");
}

// Returns the time.
double benchmark(const std::string& name, const Mesh& mesh)
{
  reset_peak_memory();
  Stopwatch watch;
  const DCM::Planar_conformal_map map =
    DCM::flatten(mesh, CGAL::parameters::visitor(std::ref(watch)));
  watch.stop();
  std::printf("%-16s%8u%6zu%6zu", name.c_str(), mesh.number_of_vertices(), map.cones().size(),
              map.minimization().iterations);
  for(const double seconds : watch.seconds)
    std::printf("%8.3f %3.0f%%", seconds, 100 * seconds / watch.total());
  std::printf("%9.3f%7.0f%10.1e%10.1e", watch.total(), peak_memory(), map.max_curvature_error(),
              DCM::max_cross_ratio_error(map));
  return watch.total();
}

// Ever larger surfaces.
template <typename Make>
void benchmark_growth(const char* name, unsigned largest, const Make& make)
{
  double last_time = 0, last_size = 0;
  for(unsigned n = largest / 64; n <= largest; n *= 4) {
    const Mesh mesh = make(n);
    const double time = benchmark(name, mesh), size = mesh.number_of_vertices();
    if(last_time > 0)
      std::printf("%8.2f", std::log(time / last_time) / std::log(size / last_size));
    std::printf("\n");
    std::fflush(stdout);
    last_time = time;
    last_size = size;
  }
}

void benchmark_file(const std::string& file)
{
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(file, mesh)) {
    std::printf("%s: cannot be read\n", file.c_str());
    return;
  }
  benchmark(file.substr(file.find_last_of('/') + 1), mesh);
  std::printf("\n");
  std::fflush(stdout);
}

int main(int argc, char** argv)
{
  std::vector<std::string> arguments(argv + 1, argv + argc);
  if(arguments.empty()) {
    for(const char* name : {"cow", "camel", "nefertiti", "bunny00", "armadillo"})
      arguments.push_back(CGAL::data_file_path(std::string("meshes/") + name + ".off"));
    arguments.push_back(largest_surface);
  }
  print_head();
  for(const std::string& argument : arguments)
    if(const int largest = std::atoi(argument.c_str()); largest > 0) {
      benchmark_growth("sphere", unsigned(largest), [](unsigned n) { return Sphere(n).mesh(); });
      benchmark_growth("torus", unsigned(largest), [](unsigned n) { return torus(n); });
    } else
      benchmark_file(argument);
}
