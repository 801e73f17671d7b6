// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Measures the CPU time of the stages of maps to the sphere, in seconds and in percent. Also
// measures its growth (with the number of vertices to the power printed last). Arguments are names
// of meshes, or numbers of vertices of the largest sphere to be generated.

#include "stages.h"

#include <CGAL/Discrete_conformal_maps/map_to_sphere.h>

#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

void benchmark(const std::string& name, const Mesh& mesh, Growth& growth)
{
  reset_peak_memory();
  Stopwatch watch;
  const DCM::Spherical_conformal_map map =
    DCM::map_to_sphere(mesh, CGAL::parameters::visitor(std::ref(watch)));
  watch.stop();
  std::vector<std::string> cells{name, Table::text(mesh.number_of_vertices()),
                                 Table::text(map.minimization().iterations),
                                 map.is_extended() ? "extended" : "double"};
  append(cells, watch);
  cells.push_back(growth.since_last(watch.total(), mesh.number_of_vertices()));
  Table::print(cells);
}

int main(int argc, char** argv)
{
  std::vector<std::string> arguments(argv + 1, argv + argc);
  if(arguments.empty()) {
    for(const char* name : {"bull", "camel", "armadillo"})
      arguments.push_back(CGAL::data_file_path(std::string("meshes/") + name + ".off"));
    arguments.push_back("500000");
  }
  const Table table(with_stages({"mesh", "vertices", "steps", "digits"}, {"growth"}));
  for(const std::string& argument : arguments)
    if(const int largest = std::atoi(argument.c_str()); largest > 0)
      benchmark_growth(
        "sphere", unsigned(largest), [](unsigned n) { return Sphere(n).mesh(); }, benchmark);
    else
      benchmark_file(argument, benchmark);
}
