// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Measures steps, factorizations and fill-reducing orders of flattening, and the CPU time of its
// stages (Figure 4.24), in seconds and in percent. Also measures the growth of time (with the
// number of vertices to the power printed last) and the greatest memory. Also measures the seconds
// of a certificate of the map. Arguments are names of meshes, or numbers of vertices of the largest
// spheres and tori to be generated.

#include "stages.h"

#include <CGAL/Discrete_conformal_maps/certify.h>
#include <CGAL/Discrete_conformal_maps/flatten.h>

#include <cstdlib>
#include <ctime>
#include <functional>
#include <string>
#include <vector>

double seconds_of_certificate(const DCM::Planar_conformal_map& map)
{
  const std::clock_t start = std::clock();
  DCM::certify(map);
  return double(std::clock() - start) / CLOCKS_PER_SEC;
}

void benchmark(const std::string& name, const Mesh& mesh, Growth& growth)
{
  reset_peak_memory();
  Stopwatch watch;
  const DCM::Planar_conformal_map map =
    DCM::flatten(mesh, CGAL::parameters::visitor(std::ref(watch)));
  watch.stop();
  std::vector<std::string> cells{name,
                                 Table::text(mesh.number_of_vertices()),
                                 Table::text(map.cones().size()),
                                 Table::text(map.minimization().iterations),
                                 Table::text(map.factorization_counts().factorizations),
                                 Table::text(map.factorization_counts().orderings)};
  append(cells, watch);
  cells.push_back(growth.since_last(watch.total(), mesh.number_of_vertices()));
  cells.push_back(Table::text(seconds_of_certificate(map)));
  Table::print(cells);
}

int main(int argc, char** argv)
{
  std::vector<std::string> arguments(argv + 1, argv + argc);
  if(arguments.empty()) {
    for(const char* name : {"cow", "camel", "nefertiti", "bunny00", "armadillo"})
      arguments.push_back(CGAL::data_file_path(std::string("meshes/") + name + ".off"));
    arguments.push_back(largest_surface);
  }
  const Table table(with_stages({"mesh", "vertices", "cones", "steps", "factorizations", "orders"},
                                {"growth", "certificate"}));
  for(const std::string& argument : arguments)
    if(const int largest = std::atoi(argument.c_str()); largest > 0) {
      benchmark_growth(
        "sphere", unsigned(largest), [](unsigned n) { return Sphere(n).mesh(); }, benchmark);
      benchmark_growth(
        "torus", unsigned(largest), [](unsigned n) { return torus(n); }, benchmark);
    } else
      benchmark_file(argument, benchmark);
}
