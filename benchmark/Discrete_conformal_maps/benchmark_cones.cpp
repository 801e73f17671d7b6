// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Prints the number of greedy and exchanged cones for bounds of the distortion of areas. Columns
// are steps of the minimization, the greatest distortion of an area, the root mean square of
// logarithmic scale factors (weighted by area), and seconds of CPU time. Arguments are names of
// meshes.

#include "stages.h"

#include <CGAL/Discrete_conformal_maps/flatten.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>

#include <functional>
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

double root_mean_square(const DCM::Planar_conformal_map& map, const Mesh& mesh)
{
  double sum = 0, total = 0;
  for(Mesh::Face_index f : mesh.faces()) {
    std::vector<Mesh::Vertex_index> corners;
    for(Mesh::Vertex_index v : mesh.vertices_around_face(mesh.halfedge(f)))
      corners.push_back(v);
    const double area = std::sqrt(
      CGAL::squared_area(mesh.point(corners[0]), mesh.point(corners[1]), mesh.point(corners[2])));
    for(Mesh::Vertex_index v : corners)
      sum += area / 3 * map.log_scale(v) * map.log_scale(v);
    total += area;
  }
  return std::sqrt(sum / total);
}

void benchmark(const std::string& name, const Mesh& mesh, double distortion, DCM::Cones cones)
{
  Stopwatch watch;
  const DCM::Planar_conformal_map map = DCM::flatten(
    mesh,
    DCM::parameters::maximum_area_distortion(distortion).cones(cones).visitor(std::ref(watch)));
  watch.stop();
  std::printf("%-20s%10.0f  %-10s%6zu%6zu%10.1f%8.3f%9.3f\n", name.c_str(), distortion,
              cones == DCM::Cones::greedy ? "greedy" : "exchanged", map.cones().size(),
              map.minimization().iterations, greatest_distortion(map, mesh),
              root_mean_square(map, mesh), watch.total());
}

void benchmark(const std::string& name, const Mesh& mesh)
{
  for(const double distortion : {22026., 100., 16., 4.})
    for(const DCM::Cones cones : {DCM::Cones::greedy, DCM::Cones::exchanged})
      benchmark(name, mesh, distortion, cones);
}

} // namespace

int main(int argc, char** argv)
{
  std::vector<std::string> arguments(argv + 1, argv + argc);
  if(arguments.empty())
    for(const char* name : {"elephant", "bull", "cow", "triceratops", "fandisk", "camel"})
      arguments.push_back(CGAL::data_file_path(std::string("meshes/") + name + ".off"));
  std::printf("%-20s%10s  %-10s%6s%6s%10s%8s%9s\n", "mesh", "bound", "cones", "cones", "steps",
              "greatest", "rms", "seconds");
  for(const std::string& argument : arguments)
    benchmark_file(argument,
                   [](const std::string& name, const Mesh& mesh) { return benchmark(name, mesh); });
}
