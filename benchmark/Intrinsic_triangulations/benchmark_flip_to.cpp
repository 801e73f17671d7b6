// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Compares the number of flips that follow integer coordinates alone with the number of crossings
// (Figure 3.8). Flips lead from a random triangulation T2 to the input T1, and from T2 to another
// one T3. Arguments are meshes, by default CGAL's own. The last columns contain the exponents of
// the growth of flips with crossings from line to line.

#include "../Table.h"

#include <CGAL/Intrinsic_triangulations/flip_to.h>
#include <CGAL/Intrinsic_triangulations/rebase.h>
#include <CGAL/Random.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;

typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Mesh;
typedef IT::Intrinsic_triangulation<> Triangulation;

namespace {

// Returns whether rounding of the sides could violate the triangle inequality.
bool is_almost_flat(IT::Face_index f, const Triangulation& tri)
{
  const auto side = IT::sides(f, tri.mesh());
  const auto length = [&](std::size_t s) { return tri.length(tri.mesh().edge(side[s])); };
  const double a = length(0), b = length(1), c = length(2), longest = (std::max)({a, b, c});
  return a + b + c - 2 * longest <= 1e-9 * longest;
}

// Flips at random. Almost flat faces are flipped back, because they could not be the input of a
// triangulation.
void flip_at_random(Triangulation& tri, std::size_t flips, CGAL::Random& random)
{
  const int size = static_cast<int>(tri.mesh().number_of_halfedges());
  while(flips > 0) {
    const IT::Halfedge_index h(static_cast<unsigned>(random.get_int(0, size)));
    if(!tri.is_flippable(h))
      continue;
    tri.flip(h);
    const IT::Delta_complex& mesh = tri.mesh();
    if(is_almost_flat(mesh.face(h), tri) || is_almost_flat(mesh.face(mesh.opposite(h)), tri))
      tri.flip(h);
    else
      --flips;
  }
}

double number_of_crossings(const Triangulation& tri)
{
  double sum = 0;
  for(IT::Edge_index e : tri.mesh().edges())
    sum += double(tri.coordinates().crossings(tri.mesh().halfedge(e)));
  return sum;
}

struct Flips
{
  double crossings, flips;
};

// Returns the exponent with which the second number grows with the first since `before`.
double exponent(const Flips& before, const Flips& now)
{
  return std::log(now.flips / before.flips) / std::log(now.crossings / before.crossings);
}

Flips flips_to_input(Triangulation tri)
{
  const double crossings = number_of_crossings(tri);
  return {crossings, double(IT::flip_to_input(tri))};
}

Flips flips_to(Triangulation tri, const Triangulation& target)
{
  const double crossings = number_of_crossings(IT::rebase(target, tri));
  return {crossings, double(IT::flip_to(tri, target))};
}

void benchmark(const Table& table, const std::string& name, const Mesh& mesh)
{
  CGAL::Random random(1);
  Triangulation t2(mesh), t3(mesh);
  Flips before1{}, before2{};
  const std::size_t step = mesh.number_of_edges() / 2;
  for(std::size_t done = step; done <= 8 * step; done *= 2) {
    for(Triangulation* t : {&t2, &t3})
      flip_at_random(*t, done == step ? step : done / 2, random);
    const Flips to_input = flips_to_input(t2), between = flips_to(t2, t3);
    const bool is_first = done == step;
    table.row(name, done, to_input.crossings, to_input.flips, between.crossings, between.flips,
              is_first ? "" : Table::text(exponent(before1, to_input)),
              is_first ? "" : Table::text(exponent(before2, between)));
    before1 = to_input;
    before2 = between;
  }
}

} // namespace

int main(int argc, char* argv[])
{
  std::vector<std::string> files(argv + 1, argv + argc);
  if(files.empty())
    for(const char* name : {"fandisk", "armadillo"})
      files.push_back(CGAL::data_file_path("meshes/" + std::string(name) + ".off"));
  const Table table({"mesh", "random flips", "crossings of T1, T2", "flips", "crossings of T2, T3",
                     "flips", "exponent, T1", "exponent, T3"});
  for(const std::string& file : files) {
    Mesh mesh;
    if(!CGAL::IO::read_polygon_mesh(file, mesh))
      return 1;
    benchmark(table, name_of(file), mesh);
  }
}
