// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Prints the number of greedy and exchanged cones for bounds of the distortion of areas. Columns
// are steps of the minimization and the greatest distortion of an area. Arguments are names of
// meshes.

#include "stages.h"

#include <CGAL/Discrete_conformal_maps/flatten.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace {

double greatest_distortion(const DCM::Planar_conformal_map& map, const Mesh& mesh)
{
  double result = 0;
  for(Mesh::Vertex_index v : mesh.vertices())
    result = (std::max)(result, std::abs(map.log_scale(v)));
  return std::exp(2 * result);
}

void append(std::vector<std::string>& cells, const Mesh& mesh, double distortion, DCM::Cones cones)
{
  const DCM::Planar_conformal_map map =
    DCM::flatten(mesh, DCM::parameters::maximum_area_distortion(distortion).cones(cones));
  cells.push_back(Table::text(map.cones().size()));
  cells.push_back(Table::text(map.minimization().iterations));
  cells.push_back(Table::text(greatest_distortion(map, mesh)));
}

void benchmark(const std::string& name, const Mesh& mesh)
{
  for(const int distortion : {22026, 100, 16, 4}) {
    std::vector<std::string> cells{name, Table::text(distortion)};
    for(const DCM::Cones cones : {DCM::Cones::greedy, DCM::Cones::exchanged})
      append(cells, mesh, distortion, cones);
    Table::print(cells);
  }
}

} // namespace

int main(int argc, char** argv)
{
  std::vector<std::string> arguments(argv + 1, argv + argc);
  if(arguments.empty())
    for(const char* name : {"elephant", "bull", "cow", "triceratops", "fandisk", "camel"})
      arguments.push_back(CGAL::data_file_path(std::string("meshes/") + name + ".off"));
  const Table table(
    {"mesh", "D", "greedy cones", "steps", "greatest", "exchanged cones", "steps", "greatest"});
  for(const std::string& argument : arguments)
    benchmark_file(argument, [](const std::string& name, const Mesh& mesh, const Growth&) {
      benchmark(name, mesh);
    });
}
