// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The projective pieces of the map to a coarse level with a tenth and with a hundredth of the
// vertices: how many there are for each face of the mesh, and seconds for all of them. Of the
// meshes on the command line or of CGAL's.

#include "../Intrinsic_triangulations/measure.h"
#include "surfaces.h"

#include <CGAL/Intrinsic_simplification/Evolving_surface.h>
#include <CGAL/Intrinsic_simplification/Surface_level.h>
#include <CGAL/Intrinsic_simplification/Surface_map.h>
#include <CGAL/Intrinsic_simplification/projective_pieces.h>
#include <CGAL/Intrinsic_simplification/simplify.h>

#include <cstdio>
#include <iterator>
#include <string>
#include <vector>

namespace IS = CGAL::Intrinsic_simplification;

void benchmark(const std::string& path)
{
  const Mesh mesh = read_surface(path);
  if(mesh.number_of_vertices() == 0) {
    std::printf("%s: no triangle mesh\n", path.c_str());
    return;
  }
  std::printf("%-20s%10u", name_of(path).c_str(), mesh.number_of_faces());
  IS::Evolving_surface surface(mesh);
  const IS::Surface_level fine(surface);
  for(const std::size_t part : {10U, 100U}) {
    IS::simplify(surface, IS::parameters::number_of_vertices(mesh.number_of_vertices() / part));
    const IS::Surface_level coarse(surface);
    const IS::Surface_map map(surface, fine, coarse);
    std::vector<IS::Projective_piece> pieces;
    Samples seconds;
    seconds.time([&] { return IS::projective_pieces(map, std::back_inserter(pieces)); });
    std::printf("%12.1f%10.2f", double(pieces.size()) / mesh.number_of_faces(),
                seconds.median() / 1000);
  }
  std::printf("\n");
}

int main(int argc, char* argv[])
{
  std::vector<std::string> files(argv + 1, argv + argc);
  if(files.empty())
    for(const char* name : {"elephant", "camel", "armadillo", "bunny00"})
      files.push_back(CGAL::data_file_path("meshes/" + std::string(name) + ".off"));
  std::printf("%-20s%10s%12s%10s%12s%10s\n", "mesh", "faces", "at 10 %", "seconds", "at 1 %",
              "seconds");
  for(const std::string& file : files)
    benchmark(file);
}
