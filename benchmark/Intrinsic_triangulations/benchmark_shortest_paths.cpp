// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Compares exact distances from one vertex to all, and paths to random points, with CGAL's.
// Usage: benchmark_shortest_paths [--peer PROGRAM] [mesh...]
// Queries of a peer are vertices. For each vertex, it prints the milliseconds of the distances of
// all vertices, and the greatest distance.

#include "../Peer.h"
#include "../Table.h"

#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/Shortest_paths.h>
#include <CGAL/Random.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_shortest_path.h>
#include <CGAL/Timer.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

namespace {

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
typedef CGAL::Surface_mesh_shortest_path<CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh>>
  CGAL_paths;
namespace IT = CGAL::Intrinsic_triangulations;
typedef IT::Face_location<double> Location;

template <typename Work>
double seconds(const Work& work)
{
  CGAL::Timer timer;
  timer.start();
  work();
  timer.stop();
  return timer.time();
}

std::vector<Location> random_locations(const Mesh& mesh, int n)
{
  CGAL::Random random(1);
  std::vector<Location> result;
  for(int i = 0; i < n; ++i) {
    const int f = random.get_int(0, static_cast<int>(mesh.number_of_faces()));
    const double u = random.get_double(0, 0.5), v = random.get_double(0, 0.5);
    result.push_back({IT::Face_index(static_cast<unsigned>(f)), {1 - u - v, u, v}});
  }
  return result;
}

void compare(const Table& table, const std::string& file, const Peer& peer)
{
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(file, mesh) || !CGAL::is_triangle_mesh(mesh)) {
    std::cerr << "cannot read " << file << '\n';
    return;
  }
  const IT::Intrinsic_triangulation<> triangulation(mesh);
  const auto targets = random_locations(mesh, 1000);
  const Mesh::Vertex_index source(0);

  IT::Shortest_paths ours(triangulation);
  const double our_search = seconds([&] {
    ours.add_source(source);
    ours.run();
  });
  std::size_t places = 0;
  const double our_paths = seconds([&] {
    for(const Location& q : targets)
      places += ours.path(q).places.size();
  });

  CGAL_paths theirs(mesh);
  theirs.add_source_point(source);
  const double their_search = seconds([&] { theirs.build_sequence_tree(); });
  const double their_paths = seconds([&] {
    for(const Location& q : targets) {
      std::vector<Kernel::Point_3> points;
      theirs.shortest_path_points_to_source_points(q.first, q.second, std::back_inserter(points));
    }
  });

  double difference = 0, greatest = 0;
  for(Mesh::Vertex_index v : mesh.vertices())
    if(const double d = theirs.shortest_distance_to_source_points(v).first; d > 0) {
      difference = (std::max)(difference, std::abs(ours.distance(v) - d) / d);
      greatest = (std::max)(greatest, ours.distance(v));
    }
  table.row(name_of(file), mesh.number_of_faces(), our_search, their_search, 1e3 * our_paths,
            1e3 * their_paths, places / targets.size(), difference);
  const std::vector<std::array<unsigned, 1>> queries{{source.idx()}};
  for(const auto& [milliseconds, distance] : peer.operator()<2>(file, queries))
    table.row(name_of(file) + " by the peer", mesh.number_of_faces(), milliseconds / 1e3, "", "",
              "", "", std::abs(distance - greatest) / greatest);
}

} // namespace

int main(int argc, char* argv[])
{
  std::vector<std::string> files(argv + 1, argv + argc);
  const Peer peer(files);
  if(files.empty())
    for(const char* name : {"elephant", "fandisk", "bull", "lion-head", "armadillo"})
      files.push_back(CGAL::data_file_path(std::string("meshes/") + name + ".off"));
  const Table table({"mesh", "faces", "all distances (s)", "CGAL (s)", "a path (&micro;s)",
                     "CGAL (&micro;s)", "crossings of a path", "greatest relative difference"});
  for(const std::string& file : files)
    compare(table, file, peer);
}
