// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Simplifies meshes, by default CGAL's, and tori with bumps of growing size to 1 % of the vertices.
// If the time is linear in the removed vertices, a column is constant. Then the largest torus is
// simplified to various resolutions (Figure 5.11).

#include "../Intrinsic_triangulations/measure.h"
#include "surfaces.h"

#include <CGAL/Intrinsic_simplification/Evolving_surface.h>
#include <CGAL/Intrinsic_simplification/Surface_level.h>
#include <CGAL/Intrinsic_simplification/Surface_map.h>
#include <CGAL/Intrinsic_simplification/prolongation.h>
#include <CGAL/Intrinsic_simplification/simplify.h>

#include <string>
#include <vector>

namespace IS = CGAL::Intrinsic_simplification;

struct Costs
{
  double removed, operations, bytes;
  Samples simplify, map; // in milliseconds
};

Costs costs(const Mesh& mesh, std::size_t vertices)
{
  Costs result;
  IS::Evolving_surface surface(mesh);
  const IS::Surface_level fine(surface);
  result.removed = double(
    result.simplify
      .time([&] { return IS::simplify(surface, IS::parameters::number_of_vertices(vertices)); })
      .removed);
  const IS::Surface_level coarse(surface);
  result.map.time([&] { return IS::prolongation_matrix(IS::Surface_map(surface, fine, coarse)); });
  result.operations = double(surface.history().size());
  result.bytes = double(surface.history().memory());
  return result;
}

void benchmark(const Table& table, const std::string& name, const Mesh& mesh)
{
  const Costs c = costs(mesh, mesh.number_of_vertices() / 100);
  table.row(name, mesh.number_of_vertices(), 1000 * c.simplify.median() / c.removed,
            1000 * c.map.median() / c.removed, c.operations / c.removed, c.bytes / c.removed);
}

void benchmark_resolutions(const Mesh& mesh)
{
  const Table table({"coarse vertices", "simplify (s)", "map (s)"}, 0);
  for(const std::size_t part : {2U, 10U, 100U, 1000U, 10000U}) {
    const Costs c = costs(mesh, mesh.number_of_vertices() / part);
    table.row(mesh.number_of_vertices() / part, c.simplify.median() / 1000, c.map.median() / 1000);
  }
}

int main(int argc, char* argv[])
{
  keep_memory();
  std::vector<std::string> files(argv + 1, argv + argc);
  if(files.empty())
    for(const char* name : {"elephant", "camel", "armadillo", "turbine", "refined_elephant"})
      files.push_back(CGAL::data_file_path("meshes/" + std::string(name) + ".off"));
  const Table table(
    {"mesh", "vertices", "simplify (&micro;s)", "map (&micro;s)", "operations", "bytes"});
  for(const std::string& file : files)
    benchmark_file(
      file, [&](const std::string& name, const Mesh& mesh) { benchmark(table, name, mesh); });
  for(unsigned n : {64U, 128U, 256U, 500U})
    benchmark(table, "bumpy torus", bumpy_torus(n));
  benchmark_resolutions(bumpy_torus(500));
}
