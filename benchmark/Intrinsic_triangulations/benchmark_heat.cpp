// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Computes distances by heat on intrinsic Delaunay triangulations. Prints CPU times of the
// construction and of the distances from a vertex, medians over 41 vertices. The error is the mean
// difference from exact distances from the first vertex, in percent of the mean distance.
// Usage: benchmark_heat [--peer PROGRAM] [mesh...]
// Queries of a peer are vertices. For each vertex, it prints the milliseconds of the construction
// and of the distances, and the mean distance.

#include "../Peer.h"
#include "../Table.h"
#include "measure.h"

#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/Shortest_paths.h>
#include <CGAL/Intrinsic_triangulations/heat_distance.h>
#include <CGAL/Intrinsic_triangulations/make_Delaunay.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <string>
#include <vector>

namespace {

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
namespace IT = CGAL::Intrinsic_triangulations;

typedef std::vector<std::array<unsigned, 1>> Sources;

Sources spread_sources(const Mesh& mesh)
{
  Sources result;
  for(unsigned i = 0; i < 41; ++i)
    result.push_back({i * 37 % mesh.num_vertices()});
  return result;
}

Eigen::VectorXd exact_distances(const IT::Intrinsic_triangulation<>& tri, IT::Vertex_index source)
{
  IT::Shortest_paths paths(tri.input());
  paths.add_source(source);
  paths.run();
  Eigen::VectorXd result(static_cast<Eigen::Index>(tri.mesh().num_vertices()));
  for(IT::Vertex_index v : tri.mesh().vertices())
    result[v.idx()] = paths.distance(v);
  return result;
}

void measure(const Table& table, const std::string& file, const Peer& peer)
{
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(file, mesh)) {
    std::cerr << "cannot read " << file << '\n';
    return;
  }
  IT::Intrinsic_triangulation<> tri(mesh);
  IT::make_Delaunay(tri);
  const Sources sources = spread_sources(mesh);
  Samples building, solving;
  const auto heat = building.time([&] { return IT::Heat_distance<>(tri.intrinsic()); });
  std::vector<Eigen::VectorXd> distances;
  for(const auto& [v] : sources)
    distances.push_back(solving.time([&, v = v] { return heat.distances(IT::Vertex_index(v)); }));
  const Eigen::VectorXd exact = exact_distances(tri, IT::Vertex_index(sources[0][0]));
  table.row(name_of(file), mesh.number_of_vertices(), building.median(), solving.median(),
            100 * (distances[0] - exact).cwiseAbs().mean() / exact.mean());

  const auto answers = peer.operator()<3>(file, sources);
  if(answers.empty())
    return;
  std::vector<double> milliseconds;
  for(const auto& answer : answers)
    milliseconds.push_back(answer[1]);
  std::nth_element(milliseconds.begin(), milliseconds.begin() + 20, milliseconds.end());
  table.row(name_of(file) + " by the peer", mesh.number_of_vertices(), answers[0][0],
            milliseconds[20], "");
  std::cerr << "mean distances differ by "
            << std::abs(answers[0][2] - distances[0].mean()) / exact.mean() << '\n';
}

} // namespace

int main(int argc, char* argv[])
{
  keep_memory();
  std::vector<std::string> files(argv + 1, argv + argc);
  const Peer peer(files);
  if(files.empty())
    for(const char* name : {"armadillo", "camel", "turbine", "cheese", "fandisk"})
      files.push_back(CGAL::data_file_path(std::string("meshes/") + name + ".off"));
  const Table table({"mesh", "vertices", "construction (ms)", "a vertex (ms)", "mean error (%)"});
  for(const std::string& file : files)
    measure(table, file, peer);
}
