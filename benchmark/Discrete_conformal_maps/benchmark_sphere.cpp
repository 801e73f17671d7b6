// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Where the time of maps to the sphere goes, in seconds of CPU time and in percent, and how it
// grows (with the number of vertices to the power printed last). Arguments are names of meshes, or
// numbers of vertices of the largest sphere to be generated.

#include "stages.h"

#include <CGAL/Discrete_conformal_maps/cross_ratios.h>
#include <CGAL/Discrete_conformal_maps/map_to_sphere.h>

#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

void print_head()
{
  std::printf("Factorization: %s\n%-16s%8s%6s%9s", factorization, "mesh", "vertices", "steps",
              "digits");
  print_stage_names();
  std::printf("%10s%7s%8s\n", "ratios", "convex", "growth");
}

// Returns the time.
double benchmark(const std::string& name, const Mesh& mesh)
{
  reset_peak_memory();
  Stopwatch watch;
  const DCM::Spherical_conformal_map map =
    DCM::map_to_sphere(mesh, CGAL::parameters::visitor(std::ref(watch)));
  watch.stop();
  std::printf("%-16s%8u%6zu%9s", name.c_str(), mesh.number_of_vertices(),
              map.minimization().iterations, map.is_extended() ? "extended" : "double");
  print(watch);
  std::printf("%10.1e%7s", DCM::max_cross_ratio_error(map),
              map.certificate().is_convex() ? "yes" : "no");
  return watch.total();
}

int main(int argc, char** argv)
{
  std::vector<std::string> arguments(argv + 1, argv + argc);
  if(arguments.empty()) {
    for(const char* name : {"bull", "camel", "armadillo"})
      arguments.push_back(CGAL::data_file_path(std::string("meshes/") + name + ".off"));
    arguments.push_back("500000");
  }
  print_head();
  for(const std::string& argument : arguments)
    if(const int largest = std::atoi(argument.c_str()); largest > 0)
      benchmark_growth(
        "sphere", unsigned(largest), [](unsigned n) { return Sphere(n).mesh(); }, benchmark);
    else
      benchmark_file(argument, benchmark);
}
