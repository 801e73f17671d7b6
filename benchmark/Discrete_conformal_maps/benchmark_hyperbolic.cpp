// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Where the time of hyperbolic metrics goes, in seconds of CPU time and in percent, how it grows
// (with the number of vertices to the power printed last), and beside it the same for flat metrics
// with greedy cones. Arguments are names of meshes, or numbers of vertices of the largest surface
// of genus two to be generated.

#include "stages.h"

#include <CGAL/Discrete_conformal_maps/flatten.h>
#include <CGAL/Discrete_conformal_maps/uniformize_hyperbolic.h>

#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

void print_head()
{
  std::printf("Factorization: %s\n%-28s%8s%6s", factorization, "mesh", "vertices", "steps");
  print_stage_names();
  std::printf("%10s%8s\n", "curvature", "growth");
}

template <typename Map>
void print(const std::string& name, const Mesh& mesh, const Map& map, const Stopwatch& watch)
{
  std::printf("%-28s%8u%6zu", name.c_str(), mesh.number_of_vertices(),
              map.minimization().iterations);
  print(watch);
  std::printf("%10.1e", map.max_curvature_error());
}

// Returns the time of the hyperbolic metric.
double benchmark(const std::string& name, const Mesh& mesh)
{
  reset_peak_memory();
  Stopwatch flat_watch;
  const auto flat = DCM::flatten(mesh, CGAL::parameters::visitor(std::ref(flat_watch)));
  flat_watch.stop();
  print(name + ", flat", mesh, flat, flat_watch);
  end_line();
  reset_peak_memory();
  Stopwatch watch;
  const auto map = DCM::uniformize_hyperbolic(mesh, CGAL::parameters::visitor(std::ref(watch)));
  watch.stop();
  print(name + ", hyperbolic", mesh, map, watch);
  return watch.total();
}

int main(int argc, char** argv)
{
  std::vector<std::string> arguments(argv + 1, argv + argc);
  if(arguments.empty())
    arguments = {"200000"};
  print_head();
  for(const std::string& argument : arguments)
    if(const int largest = std::atoi(argument.c_str()); largest > 0)
      benchmark_growth(
        "genus 2", unsigned(largest), [](unsigned n) { return Plate(n).mesh(); }, benchmark);
    else
      benchmark_file(argument, benchmark);
}
