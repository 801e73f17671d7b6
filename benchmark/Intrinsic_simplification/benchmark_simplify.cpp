// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Simplification to a hundredth of the vertices: of the meshes on the command line or of CGAL's, and of tori with
// bumps of growing size. Time linear in the removed vertices shows as a column that stays the same.

#include "../Intrinsic_triangulations/measure.h"
#include "surfaces.h"

#include <CGAL/Intrinsic_simplification/Evolving_surface.h>
#include <CGAL/Intrinsic_simplification/Surface_level.h>
#include <CGAL/Intrinsic_simplification/Surface_map.h>
#include <CGAL/Intrinsic_simplification/prolongation.h>
#include <CGAL/Intrinsic_simplification/simplify.h>

#include <cstdio>
#include <string>
#include <vector>

namespace IS = CGAL::Intrinsic_simplification;

void benchmark(const std::string& name, const Mesh& mesh)
{
  Samples simplify, map;
  IS::Evolving_surface surface(mesh);
  const IS::Surface_level fine(surface);
  const auto removed = double(simplify
                                .time([&] {
                                  return IS::simplify(surface, IS::parameters::number_of_vertices(
                                                                 mesh.number_of_vertices() / 100));
                                })
                                .removed);
  const IS::Surface_level coarse(surface);
  map.time([&] { return IS::prolongation_matrix(IS::Surface_map(surface, fine, coarse)); });
  std::printf("%-20s%10u%10.0f%12.2f%12.2f%12.2f%12.0f\n", name.c_str(), mesh.number_of_vertices(),
              removed, 1000 * simplify.median() / removed,
              double(surface.history().size()) / removed, 1000 * map.median() / removed,
              double(surface.history().memory()) / removed);
}

void benchmark_file(const std::string& path)
{
  const Mesh mesh = read_surface(path);
  if(mesh.number_of_vertices() == 0)
    std::printf("%s: no triangle mesh\n", path.c_str());
  else
    benchmark(name_of(path), mesh);
}

int main(int argc, char* argv[])
{
  keep_memory();
  std::printf("%-20s%10s%10s%12s%12s%12s%12s\n", "mesh", "vertices", "removed", "us each",
              "operations", "us map", "log bytes");
  if(argc > 1)
    for(const char* path : std::vector<const char*>(argv + 1, argv + argc))
      benchmark_file(path);
  else
    for(const char* name : {"elephant", "camel", "armadillo", "turbine", "refined_elephant"})
      benchmark_file(CGAL::data_file_path("meshes/" + std::string(name) + ".off"));
  for(unsigned n : {64U, 128U, 256U, 500U})
    benchmark("bumpy torus", bumpy_torus(n));
}
