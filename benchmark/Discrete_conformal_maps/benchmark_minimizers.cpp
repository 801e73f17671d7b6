// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Compares Newton's method and the L-BFGS method of the Ceres Solver on the same energies. Prints
// steps, evaluations, factorizations, seconds of CPU time for the minimization, and differences of
// scale factors. Arguments are names of meshes, or numbers of vertices of spheres to be generated.

#include "stages.h"

#include <CGAL/Discrete_conformal_maps/Ceres_minimizer.h>
#include <CGAL/Discrete_conformal_maps/Newton_minimizer.h>
#include <CGAL/Discrete_conformal_maps/flatten.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

namespace {

struct Run
{
  DCM::Planar_conformal_map map;
  double seconds;
};

template <typename Minimizer>
Run flatten(const Mesh& mesh, const Minimizer& minimizer)
{
  Stopwatch watch;
  DCM::Planar_conformal_map map =
    DCM::flatten(mesh, DCM::parameters::minimizer(minimizer).visitor(std::ref(watch)));
  watch.stop();
  return {std::move(map), watch.seconds[2]};
}

void benchmark(const Table& table, const std::string& name, const Mesh& mesh)
{
  const Run newton = flatten(mesh, DCM::Newton_minimizer());
  const Run ceres = flatten(mesh, DCM::Ceres_minimizer());
  double difference = 0;
  for(Mesh::Vertex_index v : mesh.vertices())
    difference = (std::max)(difference, std::abs(newton.map.log_scale(v) - ceres.map.log_scale(v)));
  const DCM::Minimization_result &first = newton.map.minimization(),
                                 &second = ceres.map.minimization();
  table.row(name, mesh.number_of_vertices(), first.iterations, first.factorizations, newton.seconds,
            second.iterations, second.evaluations, second.factorizations, ceres.seconds,
            difference);
}

} // namespace

int main(int argc, char** argv)
{
  std::vector<std::string> arguments(argv + 1, argv + argc);
  if(arguments.empty())
    for(const char* name : {"cow", "elephant", "bull", "camel", "armadillo"})
      arguments.push_back(CGAL::data_file_path(std::string("meshes/") + name + ".off"));
  const Table table({"mesh", "vertices", "Newton: steps", "factorizations", "seconds",
                     "Ceres: steps", "evaluations", "factorizations", "seconds", "difference"});
  for(const std::string& argument : arguments)
    if(const int vertices = std::atoi(argument.c_str()); vertices > 0)
      benchmark(table, "sphere", Sphere(unsigned(vertices)).mesh());
    else
      benchmark_file(argument, [&](const std::string& name, const Mesh& mesh, const Growth&) {
        benchmark(table, name, mesh);
      });
}
