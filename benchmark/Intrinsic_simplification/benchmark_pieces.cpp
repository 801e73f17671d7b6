// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Computes the projective pieces of the map to a coarse level with 10 % and with 1 % of the
// vertices. Prints their number for each face of the mesh, and seconds for all of them. Arguments
// are meshes, by default CGAL's.

#include "../Intrinsic_triangulations/measure.h"
#include "surfaces.h"

#include <CGAL/Intrinsic_simplification/Evolving_surface.h>
#include <CGAL/Intrinsic_simplification/Surface_level.h>
#include <CGAL/Intrinsic_simplification/Surface_map.h>
#include <CGAL/Intrinsic_simplification/projective_pieces.h>
#include <CGAL/Intrinsic_simplification/simplify.h>

#include <iterator>
#include <string>
#include <vector>

namespace IS = CGAL::Intrinsic_simplification;

void benchmark(const std::string& name, const Mesh& mesh)
{
  std::vector<std::string> cells{name, Table::text(mesh.number_of_faces())};
  IS::Evolving_surface surface(mesh);
  const IS::Surface_level fine(surface);
  for(const std::size_t part : {10U, 100U}) {
    IS::simplify(surface, IS::parameters::number_of_vertices(mesh.number_of_vertices() / part));
    const IS::Surface_level coarse(surface);
    const IS::Surface_map map(surface, fine, coarse);
    std::vector<IS::Projective_piece> pieces;
    Samples seconds;
    seconds.time([&] { return IS::projective_pieces(map, std::back_inserter(pieces)); });
    cells.push_back(Table::text(double(pieces.size()) / mesh.number_of_faces()));
    cells.push_back(Table::text(seconds.median() / 1000));
  }
  Table::print(cells);
}

int main(int argc, char* argv[])
{
  std::vector<std::string> files(argv + 1, argv + argc);
  if(files.empty())
    for(const char* name : {"elephant", "camel", "armadillo", "bunny00"})
      files.push_back(CGAL::data_file_path("meshes/" + std::string(name) + ".off"));
  const Table table({"mesh", "faces", "pieces per face at 10 %", "seconds", "at 1 %", "seconds"});
  for(const std::string& file : files)
    benchmark_file(file, benchmark);
}
