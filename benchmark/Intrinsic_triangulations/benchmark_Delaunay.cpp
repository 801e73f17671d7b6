// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Compares flips to Delaunay, with construction, with the intrinsic Delaunay triangulation inside
// CGAL's heat method (which has no correspondence). Arguments are meshes, by default CGAL's own.
// The two alternate, and medians are printed. malloc keeps its memory for both, so that the figures
// exclude the time of the system for new pages.

#include "../Table.h"
#include "measure.h"

#include <CGAL/Heat_method_3/internal/Intrinsic_Delaunay_triangulation_3.h>
#include <CGAL/Intrinsic_triangulations/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/make_Delaunay.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <iostream>
#include <string>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
typedef CGAL::Heat_method_3::Intrinsic_Delaunay_triangulation_3<Mesh> Heat_triangulation;
typedef IT::Common_subdivision<IT::Euclidean_geometry_traits<>, Kernel::Point_3> Subdivision;

constexpr int repetitions = 15;

void benchmark(const Table& table, const std::string& file)
{
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(file, mesh)) {
    std::cerr << file << " cannot be read\n";
    return;
  }
  Samples build, flip, trace, subdivide, heat;
  std::size_t flips = 0;
  for(int i = 0; i < repetitions; ++i) {
    {
      IT::Intrinsic_triangulation<> tri =
        build.time([&] { return IT::Intrinsic_triangulation<>(mesh); });
      flips = flip.time([&] { return IT::make_Delaunay(tri); });
      const IT::Correspondence<> correspondence =
        trace.time([&] { return IT::Correspondence<>(tri); });
      subdivide.time([&] { return Subdivision(correspondence); });
    }
    heat.time([&] { return Heat_triangulation(mesh); });
  }
  const double ours = build.median() + flip.median();
  table.row(name_of(file), mesh.number_of_vertices(), flips, ours, heat.median(),
            heat.median() / ours, trace.median() + subdivide.median());
}

int main(int argc, char** argv)
{
  keep_memory();
  std::vector<std::string> files(argv + 1, argv + argc);
  if(files.empty())
    for(const char* name :
        {"armadillo", "camel", "turbine", "ChineseDragon-10kv", "refined_elephant"})
      files.push_back(CGAL::data_file_path(std::string("meshes/") + name + ".off"));
  const Table table({"mesh", "vertices", "flips", "construction and flips (ms)", "CGAL (ms)",
                     "ratio", "correspondence and subdivision (ms)"});
  for(const std::string& file : files)
    benchmark(table, file);
}
