// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Measures Delaunay refinement on meshes named as arguments, by default CGAL's own. Compares it
// with CGAL's planar mesher, which has no correspondence, on one domain. Measures the growth of the
// time for an insertion with the size of the mesh, the degree of vertices and the length of input
// edges.

#include "../Table.h"
#include "measure.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_mesh_face_base_2.h>
#include <CGAL/Delaunay_mesh_size_criteria_2.h>
#include <CGAL/Delaunay_mesh_vertex_base_2.h>
#include <CGAL/Delaunay_mesher_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/refine.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <cmath>
#include <cstddef>
#include <iostream>
#include <string>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
typedef IT::Intrinsic_triangulation<> Triangulation;

constexpr int repetitions = 5;

struct Times
{
  double all; // in milliseconds, with flips to Delaunay
  IT::Refinement_result result;
};

// Refines with the bounds `np`.
template <typename NamedParameters>
Times refine(const Mesh& mesh, const NamedParameters& np)
{
  Samples all;
  Times times{};
  for(int i = 0; i < repetitions; ++i) {
    Triangulation tri(mesh);
    times.result = all.time([&] { return IT::refine(tri, np); });
  }
  times.all = all.median();
  return times;
}

const std::vector<std::string> headings{"surface",
                                        "vertices",
                                        "inserted",
                                        "removed again",
                                        "flips",
                                        "time (ms)",
                                        "for each insertion (&micro;s)"};

void print(const Table& table, const std::string& name, const Mesh& mesh, const Times& t)
{
  table.row(name, mesh.number_of_vertices(), t.result.insertions, t.result.removals, t.result.flips,
            t.all, 1e3 * t.all / double(t.result.insertions));
}

void benchmark(const Table& table, const std::string& file)
{
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(file, mesh)) {
    std::cerr << file << " cannot be read\n";
    return;
  }
  print(table, name_of(file), mesh, refine(mesh, IT::parameters::minimum_angle(25.)));
}

// ---- The planar mesher ----

namespace Plane {

typedef CGAL::Exact_predicates_inexact_constructions_kernel K;
typedef CGAL::Triangulation_data_structure_2<CGAL::Delaunay_mesh_vertex_base_2<K>,
                                             CGAL::Delaunay_mesh_face_base_2<K>>
  Data_structure;
typedef CGAL::Constrained_Delaunay_triangulation_2<K, Data_structure> Triangulation;
typedef CGAL::Delaunay_mesh_size_criteria_2<Triangulation> Criteria;

// Meshes the unit square with edges of at most `size`; returns the number of vertices.
std::size_t mesh_square(double size)
{
  Triangulation t;
  const std::vector<Triangulation::Vertex_handle> corner{t.insert({0, 0}), t.insert({1, 0}),
                                                         t.insert({1, 1}), t.insert({0, 1})};
  for(std::size_t i = 0; i < 4; ++i)
    t.insert_constraint(corner[i], corner[(i + 1) % 4]);
  const double sine = std::sin(25 * CGAL_PI / 180);
  CGAL::Delaunay_mesher_2<Triangulation, Criteria> mesher(t, Criteria(sine * sine, size));
  mesher.refine_mesh();
  return t.number_of_vertices();
}

} // namespace Plane

template <typename Place>
Mesh grid(unsigned int m, unsigned int n, const Place& place)
{
  Mesh mesh;
  for(unsigned int y = 0; y <= n; ++y)
    for(unsigned int x = 0; x <= m; ++x)
      mesh.add_vertex(place(x, y));
  const auto v = [m](unsigned int x, unsigned int y) {
    return Mesh::Vertex_index(y * (m + 1) + x);
  };
  for(unsigned int y = 0; y < n; ++y)
    for(unsigned int x = 0; x < m; ++x) {
      mesh.add_face(v(x, y), v(x + 1, y), v(x + 1, y + 1));
      mesh.add_face(v(x, y), v(x + 1, y + 1), v(x, y + 1));
    }
  return mesh;
}

Mesh square()
{
  return grid(1, 1, [](unsigned int x, unsigned int y) { return Kernel::Point_3(x, y, 0); });
}

void compare_with_plane()
{
  const Table table({"vertices", "for each (&micro;s)", "`Delaunay_mesher_2`: vertices",
                     "for each (&micro;s)", "ratio"},
                    0);
  for(double size : {0.02, 0.01, 0.005}) {
    Samples ours, theirs;
    std::size_t count = 0, their_count = 0;
    for(int i = 0; i < repetitions; ++i) {
      Triangulation tri(square());
      ours.time(
        [&] { return IT::refine(tri, IT::parameters::maximum_circumradius(size / std::sqrt(3))); });
      count = tri.mesh().number_of_vertices();
      their_count = theirs.time([&] { return Plane::mesh_square(size); });
    }
    const double us = 1e3 * ours.median() / double(count),
                 their_us = 1e3 * theirs.median() / double(their_count);
    table.row(count, us, their_count, their_us, their_us / us);
  }
}

// ---- Growth ----

// Returns a grid with a band of 20 columns that is squeezed into needles. The other columns need no
// refinement.
Mesh banded_grid(unsigned int n)
{
  return grid(n, n, [n](unsigned int x, unsigned int y) {
    const unsigned int begin = n / 2, end = begin + 20;
    const double inside = x < begin ? 0 : x < end ? double(x - begin) : double(end - begin);
    return Kernel::Point_3(double(x) - 0.95 * inside, y, 0);
  });
}

Kernel::Point_3 on_circle(unsigned int i, unsigned int n)
{
  const double angle = 2 * CGAL_PI * i / n;
  return {std::cos(angle), std::sin(angle), 0};
}

// Returns a polygon with `n` needles around its center, or around a corner.
Mesh fan(unsigned int n, bool around_center)
{
  Mesh mesh;
  std::vector<Mesh::Vertex_index> v;
  for(unsigned int i = 0; i < n; ++i)
    v.push_back(mesh.add_vertex(on_circle(i, n)));
  if(around_center) {
    const Mesh::Vertex_index center = mesh.add_vertex(Kernel::Point_3(0, 0, 0));
    for(unsigned int i = 0; i < n; ++i)
      mesh.add_face(center, v[i], v[(i + 1) % n]);
  } else
    for(unsigned int i = 1; i + 1 < n; ++i)
      mesh.add_face(v[0], v[i], v[i + 1]);
  return mesh;
}

void growth()
{
  const auto angle = IT::parameters::minimum_angle(25.);
  const Table table(headings);
  for(unsigned int n : {70u, 220u, 707u}) {
    const Mesh mesh = banded_grid(n);
    print(table, "square with a band of needles", mesh, refine(mesh, angle));
  }
  for(bool around_center : {true, false})
    for(unsigned int n : {125u, 500u, 2000u}) {
      const Mesh mesh = fan(n, around_center);
      print(table, around_center ? "needles around the center" : "needles around a corner", mesh,
            refine(mesh, angle));
    }
  for(double radius : {0.02, 0.005, 0.00125})
    print(table, "square of two faces", square(),
          refine(square(), IT::parameters::maximum_circumradius(radius)));
}

int main(int argc, char** argv)
{
  keep_memory();
  std::vector<std::string> files(argv + 1, argv + argc);
  if(files.empty())
    for(const char* name : {"cheese", "blade", "armadillo"})
      files.push_back(CGAL::data_file_path(std::string("meshes/") + name + ".off"));
  const Table table(headings);
  for(const std::string& file : files)
    benchmark(table, file);
  compare_with_plane();
  growth();
}
