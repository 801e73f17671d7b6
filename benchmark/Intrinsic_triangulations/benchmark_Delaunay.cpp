// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Flipping to Delaunay, with construction, against the intrinsic Delaunay triangulation inside
// CGAL's heat method (which has no correspondence), on meshes named as arguments or on CGAL's own.
// The two take turns; medians are printed. malloc keeps its memory for both, so that the system's
// clearing of new pages is not part of the figures.

#include "measure.h"

#include <CGAL/Heat_method_3/internal/Intrinsic_Delaunay_triangulation_3.h>
#include <CGAL/Intrinsic_triangulations/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/make_Delaunay.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <cstdio>
#include <string>
#include <vector>

#include <malloc.h>

namespace IT = CGAL::Intrinsic_triangulations;

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
typedef CGAL::Heat_method_3::Intrinsic_Delaunay_triangulation_3<Mesh> Heat_triangulation;
typedef IT::Common_subdivision<IT::Euclidean_geometry_traits<>, Kernel::Point_3> Subdivision;

constexpr int repetitions = 15;

void benchmark(const std::string& file)
{
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(file, mesh)) {
    std::printf("%s: cannot be read\n", file.c_str());
    return;
  }
  Samples build, flip, trace, subdivide, heat;
  std::size_t flips = 0, bytes = 0;
  for(int i = 0; i < repetitions; ++i) {
    {
      const std::size_t before = bytes_in_use();
      IT::Intrinsic_triangulation<> tri =
        build.time([&] { return IT::Intrinsic_triangulation<>(mesh); });
      bytes = bytes_in_use() - before;
      flips = flip.time([&] { return IT::make_Delaunay(tri); });
      const IT::Correspondence<> correspondence =
        trace.time([&] { return IT::Correspondence<>(tri); });
      subdivide.time([&] { return Subdivision(correspondence); });
    }
    heat.time([&] { return Heat_triangulation(mesh); });
  }
  const std::string name = file.substr(file.find_last_of('/') + 1);
  std::printf("%-24s%9u%9zu%9.2f%9.2f%9.2f%8.2f%9.2f%9.2f%8zu\n", name.c_str(),
              mesh.number_of_vertices(), flips, build.median(), flip.median(), heat.median(),
              heat.median() / (build.median() + flip.median()), trace.median(), subdivide.median(),
              bytes / mesh.number_of_edges());
}

int main(int argc, char** argv)
{
  keep_memory();
  std::vector<std::string> files(argv + 1, argv + argc);
  if(files.empty())
    for(const char* name :
        {"armadillo", "camel", "turbine", "ChineseDragon-10kv", "refined_elephant"})
      files.push_back(CGAL::data_file_path(std::string("meshes/") + name + ".off"));
  std::printf("milliseconds, medians of %d\n", repetitions);
  std::printf("%-24s%9s%9s%9s%9s%9s%8s%9s%9s%8s\n", "mesh", "vertices", "flips", "build", "flip",
              "heat", "ratio", "trace", "subdiv.", "B/edge");
  for(const std::string& file : files)
    benchmark(file);
}
