// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Flips that follow integer coordinates alone against crossings (Figure 3.8): from a random
// triangulation T2 to the input T1, and from T2 to another one T3; then from T2 refined to angles
// of 25 degrees to T3 refined to 28. On meshes named as arguments, or on CGAL's own. The last
// columns have the exponents of the growth of flips with crossings from line to line.

#include "measure.h"

#include <CGAL/Intrinsic_triangulations/flip_to.h>
#include <CGAL/Intrinsic_triangulations/make_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/rebase.h>
#include <CGAL/Intrinsic_triangulations/refine.h>
#include <CGAL/Random.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;

typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Mesh;
typedef IT::Intrinsic_triangulation<> Triangulation;

namespace {

void flip_at_random(Triangulation& tri, std::size_t flips, CGAL::Random& random)
{
  const int size = static_cast<int>(tri.mesh().number_of_halfedges());
  while(flips > 0) {
    const IT::Halfedge_index h(static_cast<unsigned>(random.get_int(0, size)));
    if(tri.is_flippable(h)) {
      tri.flip(h);
      --flips;
    }
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

// how the second number grows with the first since `before`
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

void benchmark(const std::string& name, const Mesh& mesh)
{
  std::printf("%s, %u edges\n%12s%12s%12s%12s%12s%12s%8s%8s\n", name.c_str(),
              mesh.number_of_edges(), "random", "crossings", "flips", "crossings", "flips", "ms",
              "", "");
  CGAL::Random random(1);
  Triangulation t2(mesh), t3(mesh);
  Flips before1{}, before2{};
  const std::size_t step = mesh.number_of_edges() / 2;
  for(std::size_t done = step; done <= 8 * step; done *= 2) {
    for(Triangulation* t : {&t2, &t3})
      flip_at_random(*t, done == step ? step : done / 2, random);
    const Flips to_input = flips_to_input(t2);
    Samples samples;
    const Flips between = samples.time([&] { return flips_to(t2, t3); });
    std::printf("%12zu%12.0f%12.0f%12.0f%12.0f%12.1f", done, to_input.crossings, to_input.flips,
                between.crossings, between.flips, samples.median());
    if(done > step)
      std::printf("%8.2f%8.2f", exponent(before1, to_input), exponent(before2, between));
    std::printf("\n");
    before1 = to_input;
    before2 = between;
  }
}

Triangulation refined(const Mesh& mesh, double angle)
{
  Triangulation tri(mesh);
  IT::make_Delaunay(tri);
  IT::refine(tri, IT::parameters::minimum_angle(angle));
  tri.collect_garbage();
  return tri;
}

void benchmark_refined(const Mesh& mesh)
{
  const Triangulation t2 = refined(mesh, 25), t3 = refined(mesh, 28);
  Samples samples;
  const Flips between = samples.time([&] { return flips_to(t2, t3); });
  std::printf("refined, with %u and %u vertices: %.0f crossings, %.0f flips, %.1f ms\n",
              t2.mesh().number_of_vertices(), t3.mesh().number_of_vertices(), between.crossings,
              between.flips, samples.median());
}

} // namespace

int main(int argc, char* argv[])
{
  std::vector<std::string> files(argv + 1, argv + argc);
  if(files.empty())
    for(const char* name : {"elephant", "fandisk", "armadillo"})
      files.push_back(CGAL::data_file_path("meshes/" + std::string(name) + ".off"));
  for(const std::string& file : files) {
    Mesh mesh;
    if(!CGAL::IO::read_polygon_mesh(file, mesh))
      return 1;
    benchmark(file, mesh);
    benchmark_refined(mesh);
  }
}
