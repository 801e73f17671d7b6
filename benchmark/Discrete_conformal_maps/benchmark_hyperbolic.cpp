// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Measures the CPU time of the stages of hyperbolic metrics, in seconds and in percent. Also
// measures its growth (with the number of vertices to the power printed last). Compares it with
// flat metrics with greedy cones. Arguments are names of meshes, or numbers of vertices of the
// largest surface of genus two to be generated.

#include "stages.h"

#include <CGAL/Discrete_conformal_maps/flatten.h>
#include <CGAL/Discrete_conformal_maps/uniformize_hyperbolic.h>

#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

template <typename Map>
void print(const std::string& metric, const Mesh& mesh, const Map& map, const Stopwatch& watch,
           const std::string& growth)
{
  std::vector<std::string> cells{metric, Table::text(mesh.number_of_vertices()),
                                 Table::text(map.minimization().iterations)};
  append(cells, watch);
  cells.push_back(growth);
  Table::print(cells);
}

void benchmark(const std::string&, const Mesh& mesh, Growth& growth)
{
  reset_peak_memory();
  Stopwatch flat_watch;
  const auto flat = DCM::flatten(mesh, CGAL::parameters::visitor(std::ref(flat_watch)));
  flat_watch.stop();
  print("flat", mesh, flat, flat_watch, "");
  reset_peak_memory();
  Stopwatch watch;
  const auto map = DCM::uniformize_hyperbolic(mesh, CGAL::parameters::visitor(std::ref(watch)));
  watch.stop();
  print("hyperbolic", mesh, map, watch,
        growth.since_last(watch.total(), mesh.number_of_vertices()));
}

int main(int argc, char** argv)
{
  std::vector<std::string> arguments(argv + 1, argv + argc);
  if(arguments.empty())
    arguments = {"200000"};
  const Table table(with_stages({"metric", "vertices", "steps"}, {"growth"}));
  for(const std::string& argument : arguments)
    if(const int largest = std::atoi(argument.c_str()); largest > 0)
      benchmark_growth(
        "genus 2", unsigned(largest), [](unsigned n) { return Plate(n).mesh(); }, benchmark);
    else
      benchmark_file(argument, benchmark);
}
