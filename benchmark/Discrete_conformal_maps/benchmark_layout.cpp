// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Measures the cost of each planar layout, in seconds of CPU time, and its errors. These are the
// greatest error of length cross ratios, and triangles of T_3 that are reversed or have no area.
// Arguments are names of meshes.

#include "../Table.h"

#include <CGAL/Discrete_conformal_maps/cross_ratios.h>
#include <CGAL/Discrete_conformal_maps/flatten.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <complex>
#include <cstddef>
#include <ctime>
#include <functional>
#include <iostream>
#include <string>
#include <vector>

namespace DCM = CGAL::Discrete_conformal_maps;
typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Mesh;

// Measures the time of the last stage, which is the layout.
struct Layout_clock : DCM::Default_flattening_visitor
{
  std::clock_t since = 0;

  void start(DCM::Flattening_stage) { since = std::clock(); }
};

std::size_t collapsed(const DCM::Planar_conformal_map& map)
{
  const auto& mesh = map.ideal().mesh();
  std::size_t result = 0;
  for(const auto f : mesh.faces()) {
    const auto h = mesh.halfedge(f);
    const std::complex<double> p = map.position(h), q = map.position(mesh.next(h)),
                               r = map.position(mesh.prev(h));
    result += map.is_laid_out(f) && (std::conj(q - p) * (r - p)).imag() <= 0;
  }
  return result;
}

void benchmark(const std::string& file)
{
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(file, mesh)) {
    std::cerr << file << " cannot be read\n";
    return;
  }
  std::vector<std::string> cells{name_of(file), Table::text(mesh.number_of_vertices())};
  for(const DCM::Layout layout :
      {DCM::Layout::least_squares, DCM::Layout::spectral, DCM::Layout::incremental}) {
    Layout_clock clock;
    const auto map = DCM::flatten(mesh, DCM::parameters::layout(layout).visitor(std::ref(clock)));
    const double seconds = double(std::clock() - clock.since) / CLOCKS_PER_SEC;
    cells.push_back(Table::text(seconds));
    cells.push_back(Table::text(DCM::max_cross_ratio_error(map)));
    cells.push_back(Table::text(collapsed(map)));
  }
  Table::print(cells);
}

int main(int argc, char** argv)
{
  std::vector<std::string> files(argv + 1, argv + argc);
  if(files.empty())
    for(const char* name : {"cow", "camel", "nefertiti", "fandisk", "bunny00", "armadillo"})
      files.push_back(CGAL::data_file_path(std::string("meshes/") + name + ".off"));
  const Table table({"mesh", "vertices", "least squares: s", "error", "reversed", "spectral: s",
                     "error", "reversed", "incremental: s", "error", "reversed"});
  for(const std::string& file : files)
    benchmark(file);
}
