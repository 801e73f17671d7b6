// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Measures steps and CPU time of maps to the plane and to the sphere with circles at the vertices,
// compared with the same maps without circles. Radii are random, up to half the distance to the
// nearest vertex. Also measures circle packings. Arguments are names of closed meshes.

#include "stages.h"

#include <CGAL/Discrete_conformal_maps/flatten.h>
#include <CGAL/Discrete_conformal_maps/map_to_sphere.h>
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

// Returns the steps and seconds of a map without circles and with them. `map(np)` returns the map
// with these named parameters.
template <typename Function>
std::vector<std::string> comparison(const std::vector<double>& radii, const Function& map)
{
  const auto radius = boost::make_function_property_map<Mesh::Vertex_index>(
    [&](Mesh::Vertex_index v) { return radii[v.idx()]; });
  decltype(map(CGAL::parameters::default_values())) without, with;
  const double before = seconds([&] { without = map(CGAL::parameters::default_values()); }),
               after = seconds([&] { with = map(DCM::parameters::vertex_radius_map(radius)); });
  return {Table::text(without.minimization().iterations), Table::text(before),
          Table::text(with.minimization().iterations), Table::text(after),
          Table::text(after / before)};
}

// Returns the steps, seconds and error of the packing.
std::vector<std::string> packing(const Mesh& mesh)
{
  DCM::Circle_packing result;
  const double packed = seconds([&] { result = DCM::pack_circles(mesh); });
  return {Table::text(result.minimization().iterations), Table::text(packed),
          Table::text(result.max_tangency_error())};
}

void print_row(const std::string& name, const Mesh& mesh, const std::string& target,
               const std::vector<std::string>& compared, const std::vector<std::string>& packed)
{
  std::vector<std::string> cells{name, Table::text(mesh.number_of_vertices()), target};
  cells.insert(cells.end(), compared.begin(), compared.end());
  cells.insert(cells.end(), packed.begin(), packed.end());
  Table::print(cells);
}

void benchmark(const std::string& name, const Mesh& mesh)
{
  const std::vector<double> radii = random_radii(mesh);
  print_row(name, mesh, "plane",
            comparison(radii, [&](const auto& np) { return DCM::flatten(mesh, np); }),
            {"", "", ""});
  try {
    const auto compared =
      comparison(radii, [&](const auto& np) { return DCM::map_to_sphere(mesh, np); });
    print_row(name, mesh, "sphere", compared, packing(mesh));
  } catch(const IT::Invalid_input&) { // neither a sphere nor a disk
  }
}

int main(int argc, char** argv)
{
  std::vector<std::string> arguments(argv + 1, argv + argc);
  if(arguments.empty())
    for(const char* name : {"cow", "camel", "dino", "elephant", "bunny00", "armadillo"})
      arguments.push_back(CGAL::data_file_path(std::string("meshes/") + name + ".off"));
  const Table table({"mesh", "vertices", "target", "steps", "seconds", "with circles: steps",
                     "seconds", "ratio", "packing: steps", "seconds", "error"});
  for(const std::string& argument : arguments)
    benchmark_file(argument, [](const std::string& name, const Mesh& mesh, const Growth&) {
      benchmark(name, mesh);
    });
}
