// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// How many steps, factorizations and fill-reducing orders flattening takes, where the time goes
// (Figure 4.24), in seconds of CPU time and in percent, how it grows (with the number of vertices
// to the power printed last), and the greatest memory; and what a certificate of the map costs
// beside it. Arguments are names of meshes, or numbers of vertices of the largest spheres and tori
// to be generated.

#include "stages.h"

#include <CGAL/Discrete_conformal_maps/certify.h>
#include <CGAL/Discrete_conformal_maps/cross_ratios.h>
#include <CGAL/Discrete_conformal_maps/flatten.h>

#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <string>
#include <vector>

void print_head()
{
  std::printf("Factorization: %s\n%-16s%8s%6s%6s%6s%7s", factorization, "mesh", "vertices", "cones",
              "steps", "fact.", "orders");
  print_stage_names();
  std::printf("%10s%10s%16s%8s\n", "curvature", "ratios", "certify", "growth");
}

double seconds_of_certificate(const DCM::Planar_conformal_map& map)
{
  const std::clock_t start = std::clock();
  DCM::certify(map);
  return double(std::clock() - start) / CLOCKS_PER_SEC;
}

// Returns the time.
double benchmark(const std::string& name, const Mesh& mesh)
{
  reset_peak_memory();
  Stopwatch watch;
  const DCM::Planar_conformal_map map =
    DCM::flatten(mesh, CGAL::parameters::visitor(std::ref(watch)));
  watch.stop();
  std::printf("%-16s%8u%6zu%6zu%6zu%7zu", name.c_str(), mesh.number_of_vertices(),
              map.cones().size(), map.minimization().iterations,
              map.factorization_counts().factorizations, map.factorization_counts().orderings);
  print(watch);
  std::printf("%10.1e%10.1e", map.max_curvature_error(), DCM::max_cross_ratio_error(map));
  const double certify = seconds_of_certificate(map);
  std::printf("%9.3f (%2.0f %%)", certify, 100 * certify / watch.total());
  return watch.total();
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
      benchmark_growth(
        "sphere", unsigned(largest), [](unsigned n) { return Sphere(n).mesh(); }, benchmark);
      benchmark_growth(
        "torus", unsigned(largest), [](unsigned n) { return torus(n); }, benchmark);
    } else
      benchmark_file(argument, benchmark);
}
