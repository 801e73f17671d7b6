// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Computes geodesics by flips: shortest paths along edges between random vertices, and the loops of
// a basis of homology. Prints CPU times per path: the search along edges, the shortening with the
// flips undone, and the longest path.
// Usage: benchmark_edge_paths [--paths N] [--peer PROGRAM] [mesh...]
// Queries of a peer are pairs of vertices. For each pair, it prints the milliseconds of the search
// and of shortening, and the length.

#include "../Peer.h"
#include "../Table.h"

#include <CGAL/Intrinsic_triangulations/Edge_paths.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/homology_basis.h>
#include <CGAL/Intrinsic_triangulations/shortest_edge_path.h>
#include <CGAL/Random.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Timer.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

namespace {

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
namespace IT = CGAL::Intrinsic_triangulations;
typedef IT::Intrinsic_triangulation<> Triangulation;
typedef std::vector<IT::Halfedge_index> Halfedges;

typedef std::vector<std::pair<IT::Vertex_index, IT::Vertex_index>> Pairs;

struct Result
{
  std::size_t paths = 0, geodesic = 0, longer = 0, flips = 0;
  double search = 0, seconds = 0, slowest = 0, length = 0;

  void operator+=(const Result& r)
  {
    paths += r.paths, geodesic += r.geodesic, longer += r.longer, flips += r.flips;
    search += r.search, seconds += r.seconds, slowest = (std::max)(slowest, r.slowest);
  }
};

void shorten(const Halfedges& start, bool is_loop, IT::Edge_paths<Triangulation::Traits>& paths,
             Result& result)
{
  CGAL::Timer timer;
  timer.start();
  is_loop ? paths.add_loop(start) : paths.add_path(start);
  const double before = paths.length(0);
  const auto status = paths.shorten();
  const double after = paths.length(0);
  result.flips += paths.number_of_flips();
  paths.rewind();
  timer.stop();
  ++result.paths;
  result.geodesic += status == IT::Shortening_status::geodesic;
  result.longer += after > before * (1 + 1e-14);
  result.length += after;
  result.seconds += timer.time();
  result.slowest = (std::max)(result.slowest, timer.time());
}

Pairs random_pairs(const IT::Delta_complex& mesh, int n)
{
  CGAL::Random random(1);
  const auto any = [&] {
    return IT::Vertex_index(
      static_cast<unsigned>(random.get_int(0, static_cast<int>(mesh.number_of_vertices()))));
  };
  Pairs result;
  for(int i = 0; i < n; ++i) {
    const IT::Vertex_index v = any();
    result.emplace_back(v, any());
  }
  return result;
}

Result shortened_paths(const Triangulation& input, const Pairs& pairs)
{
  Result result;
  Triangulation t = input;
  IT::Edge_paths<Triangulation::Traits> paths(t);
  IT::Shortest_edge_paths<Triangulation> search(input);
  for(const auto& [v, w] : pairs) {
    CGAL::Timer timer;
    timer.start();
    const Halfedges start = search.path(v, w);
    timer.stop();
    result.search += timer.time();
    shorten(start, false, paths, result);
  }
  return result;
}

// Returns the measurements of another program on these pairs.
Result peer_paths(const Peer& peer, const std::string& file, const Pairs& pairs)
{
  std::vector<std::array<std::size_t, 2>> queries;
  for(const auto& [v, w] : pairs)
    queries.push_back({v.idx(), w.idx()});
  Result result;
  for(const auto& [search, shortening, length] : peer.operator()<3>(file, queries)) {
    ++result.paths;
    result.search += search / 1e3;
    result.seconds += shortening / 1e3;
    result.slowest = (std::max)(result.slowest, shortening / 1e3);
    result.length += length;
  }
  return result;
}

double milliseconds_per_path(double seconds, const Result& r)
{
  return 1e3 * seconds / static_cast<double>((std::max)(r.paths, std::size_t(1)));
}

void print(const Table& table, const std::string& name, const char* kind, const Result& r)
{
  if(r.paths > 0)
    table.row(name, kind, r.paths, r.geodesic, r.longer, r.flips / r.paths,
              milliseconds_per_path(r.search, r), milliseconds_per_path(r.seconds, r),
              1e3 * r.slowest);
}

// Prints the figures that differ for the peer; results of both must agree.
void print_peer(const Table& table, const std::string& name, const Result& peer, const Result& ours)
{
  if(peer.paths == 0)
    return;
  table.row(name, "paths of the peer", peer.paths, "", "", "",
            milliseconds_per_path(peer.search, peer), milliseconds_per_path(peer.seconds, peer),
            1e3 * peer.slowest);
  if(const double change = std::abs(peer.length - ours.length); change > 1e-9 * ours.length)
    std::cerr << name << ": lengths differ by " << change / ours.length << '\n';
}

Result homology_loops(const Triangulation& input)
{
  Result result;
  Triangulation t = input;
  IT::Edge_paths<Triangulation::Traits> paths(t);
  for(const Halfedges& loop : IT::homology_basis(input))
    shorten(loop, true, paths, result);
  return result;
}

struct Results
{
  std::size_t meshes = 0;
  Result paths, loops;
};

void measure(const Table& table, const std::string& file, int n, const Peer& peer, Results& all)
{
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(file, mesh) || !CGAL::is_triangle_mesh(mesh) ||
     mesh.number_of_faces() == 0)
    return;
  try {
    const Triangulation input(mesh);
    const Pairs pairs = random_pairs(input.mesh(), n);
    const Result paths = shortened_paths(input, pairs), loops = homology_loops(input);
    print(table, name_of(file), "paths", paths);
    print_peer(table, name_of(file), peer_paths(peer, file, pairs), paths);
    print(table, name_of(file), "loops", loops);
    ++all.meshes;
    all.paths += paths;
    all.loops += loops;
  } catch(const std::exception& error) {
    std::cerr << file << ": " << error.what() << '\n';
  }
}

} // namespace

int main(int argc, char* argv[])
{
  std::vector<std::string> files(argv + 1, argv + argc);
  int n = 1000;
  if(files.size() >= 2 && files[0] == "--paths") {
    n = std::atoi(files[1].c_str());
    files.erase(files.begin(), files.begin() + 2);
  }
  const Peer peer(files);
  if(files.empty()) {
    for(const auto& file : std::filesystem::directory_iterator(CGAL::data_file_path("meshes")))
      if(file.path().extension() == ".off")
        files.push_back(file.path().string());
    std::sort(files.begin(), files.end());
  }
  const Table table({"mesh", "curves", "number", "geodesics", "longer than the start",
                     "flips for each", "search (ms)", "shortening (ms)", "at most (ms)"},
                    2);
  Results all;
  for(const std::string& file : files)
    measure(table, file, n, peer, all);
  const std::string name = "all " + std::to_string(all.meshes) + " meshes";
  print(table, name, "paths", all.paths);
  print(table, name, "loops", all.loops);
}
