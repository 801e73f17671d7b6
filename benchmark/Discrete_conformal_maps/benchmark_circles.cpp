// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Measures steps and CPU time of flattening with circles at the vertices, compared with flattening
// without circles. Radii are random, up to half the distance to the nearest vertex. Also measures
// circle packings. Arguments are names of closed meshes.

#include "stages.h"

#include <CGAL/Discrete_conformal_maps/flatten.h>
#include <CGAL/Discrete_conformal_maps/pack_circles.h>
#include <CGAL/Intrinsic_triangulations/make_Delaunay.h>

#include <algorithm>
#include <ctime>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;

// Returns the CPU time of `f()` in seconds, the least of five times.
template <typename Function>
double seconds(const Function& f)
{
  double result = std::numeric_limits<double>::infinity();
  for(int i = 0; i < 5; ++i) {
    const std::clock_t start = std::clock();
    f();
    result = (std::min)(result, double(std::clock() - start) / CLOCKS_PER_SEC);
  }
  return result;
}

std::vector<double> random_radii(const Mesh& mesh)
{
  IT::Intrinsic_triangulation<> t(mesh);
  IT::make_Delaunay(t);
  std::mt19937 random(1);
  std::vector<double> result;
  for(const IT::Vertex_index v : t.mesh().vertices()) {
    double least = std::numeric_limits<double>::infinity();
    IT::for_each_outgoing_halfedge(v, t.mesh(), [&](IT::Halfedge_index h) {
      least = (std::min)(least, t.length(t.mesh().edge(h)));
    });
    result.push_back(std::uniform_real_distribution<double>(0, 1)(random) * least / 2);
  }
  return result;
}

void benchmark(const std::string& name, const Mesh& mesh)
{
  const std::vector<double> radii = random_radii(mesh);
  const auto radius = boost::make_function_property_map<Mesh::Vertex_index>(
    [&](Mesh::Vertex_index v) { return radii[v.idx()]; });
  DCM::Planar_conformal_map without, with;
  const double before = seconds([&] { without = DCM::flatten(mesh); });
  const double after =
    seconds([&] { with = DCM::flatten(mesh, DCM::parameters::vertex_radius_map(radius)); });
  std::vector<std::string> cells{name,
                                 Table::text(mesh.number_of_vertices()),
                                 Table::text(without.minimization().iterations),
                                 Table::text(before),
                                 Table::text(with.minimization().iterations),
                                 Table::text(after),
                                 Table::text(after / before),
                                 "",
                                 "",
                                 ""};
  try {
    DCM::Circle_packing packing;
    const double packed = seconds([&] { packing = DCM::pack_circles(mesh); });
    cells[7] = Table::text(packing.minimization().iterations);
    cells[8] = Table::text(packed);
    cells[9] = Table::text(packing.max_tangency_error());
  } catch(const IT::Invalid_input&) { // neither a sphere nor a disk
  }
  Table::print(cells);
}

int main(int argc, char** argv)
{
  std::vector<std::string> arguments(argv + 1, argv + argc);
  if(arguments.empty())
    for(const char* name : {"cow", "camel", "dino", "elephant", "bunny00", "armadillo"})
      arguments.push_back(CGAL::data_file_path(std::string("meshes/") + name + ".off"));
  const Table table({"mesh", "vertices", "steps", "seconds", "with circles: steps", "seconds",
                     "ratio", "packing: steps", "seconds", "error"});
  for(const std::string& argument : arguments)
    benchmark_file(argument, [](const std::string& name, const Mesh& mesh, const Growth&) {
      benchmark(name, mesh);
    });
}
