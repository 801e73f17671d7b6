// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Geodesics by flips: shortest paths along edges between random vertices, and the loops of a basis
// of homology.
// Usage: benchmark_edge_paths [--paths N] [mesh...]

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
#include <cstddef>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <string>
#include <vector>

namespace {

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
namespace IT = CGAL::Intrinsic_triangulations;
typedef IT::Intrinsic_triangulation<> Triangulation;
typedef std::vector<IT::Halfedge_index> Halfedges;

struct Result
{
  std::size_t paths = 0, geodesic = 0, longer = 0, flips = 0;
  double seconds = 0, slowest = 0;
};

void shorten(const Halfedges& start, bool is_loop, Triangulation& t, Result& result)
{
  CGAL::Timer timer;
  IT::Edge_paths paths(t);
  is_loop ? paths.add_loop(start) : paths.add_path(start);
  const double before = paths.length(0);
  timer.start();
  const auto status = paths.shorten();
  timer.stop();
  ++result.paths;
  result.geodesic += status == IT::Shortening_status::geodesic;
  result.longer += paths.length(0) > before * (1 + 1e-14);
  result.flips += paths.number_of_flips();
  result.seconds += timer.time();
  result.slowest = (std::max)(result.slowest, timer.time());
}

Result random_paths(const Triangulation& input, int n)
{
  CGAL::Random random(1);
  const auto any = [&] {
    return IT::Vertex_index(static_cast<unsigned>(
      random.get_int(0, static_cast<int>(input.mesh().number_of_vertices()))));
  };
  Result result;
  Triangulation t = input;
  for(int i = 0; i < n; ++i) {
    const Halfedges start = IT::shortest_edge_path(input, any(), any());
    if(result.flips > 0 && i > 0)
      t.reset_to_input();
    shorten(start, false, t, result);
  }
  return result;
}

void print(const Result& r)
{
  std::cout << std::setw(8) << r.paths << std::setw(10) << r.geodesic << std::setw(8) << r.longer
            << std::setw(10) << r.flips / (std::max)(r.paths, std::size_t(1)) << std::setw(10)
            << 1e3 * r.seconds / static_cast<double>((std::max)(r.paths, std::size_t(1)))
            << std::setw(10) << 1e3 * r.slowest;
}

Result homology_loops(const Triangulation& input)
{
  Result result;
  Triangulation t = input;
  for(const Halfedges& loop : IT::homology_basis(input)) {
    t.reset_to_input();
    shorten(loop, true, t, result);
  }
  return result;
}

void measure(const std::string& file, int n)
{
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(file, mesh) || !CGAL::is_triangle_mesh(mesh) ||
     mesh.number_of_faces() == 0)
    return;
  std::cout << std::setw(28) << std::filesystem::path(file).stem().string() << std::setw(9)
            << mesh.number_of_faces() << std::flush;
  try {
    const Triangulation input(mesh);
    print(random_paths(input, n));
    print(homology_loops(input));
  } catch(const std::exception& error) {
    std::cout << "  " << error.what();
  }
  std::cout << std::endl;
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
  if(files.empty()) {
    for(const auto& file : std::filesystem::directory_iterator(CGAL::data_file_path("meshes")))
      if(file.path().extension() == ".off")
        files.push_back(file.path().string());
    std::sort(files.begin(), files.end());
  }
  std::cout << std::setprecision(3) << std::setw(28) << "mesh" << std::setw(9) << "faces";
  for(const char* kind : {"paths", "loops"})
    std::cout << std::setw(8) << kind << std::setw(10) << "geodesic" << std::setw(8) << "longer"
              << std::setw(10) << "flips" << std::setw(10) << "[ms]" << std::setw(10) << "slowest";
  std::cout << std::endl;
  for(const std::string& file : files)
    measure(file, n);
}
