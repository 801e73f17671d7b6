// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Compares Laplacian, mass and distances by the tufted cover with the ordinary operators, from
// triangles to the result. Arguments are meshes, by default CGAL's own. The cover belongs to the
// triangles of the mesh without their orientation, and with a fin at every hundredth edge. The
// ordinary operators need a mesh first, with or without the time to make it.
//
// Without arguments, the same comparison follows for 100 soups with as many faces as their original
// meshes. An eighth of the faces are fins at edges with three to seven faces, lie on other faces,
// touch only a vertex, or form Moebius bands. Faces have random orientations.

#include "../../test/Intrinsic_triangulations/soups.h"
#include "../Table.h"
#include "measure.h"

#include <CGAL/Intrinsic_triangulations/Tufted_surface.h>
#include <CGAL/Intrinsic_triangulations/heat_distance.h>
#include <CGAL/Intrinsic_triangulations/make_Delaunay.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Random.h>

#include <algorithm>
#include <array>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

using namespace Test_surfaces;
typedef Eigen::SparseMatrix<double> Matrix;

constexpr int repetitions = 7;

Soup with_fins(const Mesh& mesh)
{
  CGAL::Random random(1);
  Soup result{soup_of(mesh).points, {}};
  const Triangles triangles = soup_of(mesh).triangles;
  for(std::size_t f = 0; f < triangles.size(); ++f) {
    const auto [a, b, c] = triangles[f];
    result.triangles.push_back({a, b, c});
    if(f % 150 != 0)
      continue;
    const auto& p = result.points;
    result.points.push_back(CGAL::midpoint(p[a], p[b]) + CGAL::normal(p[a], p[b], p[c]) / 10);
    result.triangles.push_back({a, b, result.points.size() - 1});
  }
  flip_orientations(result, random);
  return result;
}

// Stores the times to compute operators, and a distance from them.
struct Times
{
  Samples operators, distance;

  template <typename Make_surface>
  void take(const Make_surface& make_surface)
  {
    const auto surface = operators.time([&] {
      auto result = make_surface();
      const Matrix laplacian = IT::cotan_laplacian(result), mass = IT::mass_matrix(result);
      return result;
    });
    distance.time([&] { return IT::heat_distance(surface, std::array{Vertex_index(0)}); });
  }

  double all() const { return operators.least() + distance.least(); }
};

// Stores a triangulation and a view of it.
struct Ordinary_surface
{
  IT::Intrinsic_triangulation<> tri;
  const IT::Delta_complex& mesh() const { return tri.mesh(); }
  auto length_map() const { return tri.length_map(); }
};

struct Comparison
{
  Times ordinary, tufted;
  Samples mesh_alone;

  void take(const Mesh& mesh, const Soup& oriented, const Soup& soup)
  {
    mesh_alone.time([&] {
      Mesh result;
      CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(oriented.points,
                                                                  oriented.triangles, result);
      return result;
    });
    ordinary.take([&] {
      Ordinary_surface result{IT::Intrinsic_triangulation<>(mesh)};
      IT::make_Delaunay(result.tri);
      return result;
    });
    tufted.take([&] {
      const auto made = IT::tufted_cover(soup.points, soup.triangles);
      IT::Intrinsic_triangulation<> tri(made.mesh());
      IT::make_Delaunay(tri);
      return IT::Tufted_surface<>(made, tri.intrinsic());
    });
  }

  // Returns ratios of times from a mesh, and from the triangles of which it is made first.
  std::array<double, 4> ratios() const
  {
    const double made = mesh_alone.least();
    return {tufted.operators.least() / ordinary.operators.least(),
            tufted.operators.least() / (made + ordinary.operators.least()),
            tufted.all() / ordinary.all(), tufted.all() / (made + ordinary.all())};
  }
};

Mesh mesh_of(const std::string& file)
{
  Mesh result;
  if(!CGAL::IO::read_polygon_mesh(file, result))
    std::cerr << file << " cannot be read\n";
  return result;
}

std::string data_file(const std::string& name)
{
  return CGAL::data_file_path("meshes/" + name + ".off");
}

void benchmark_mesh(const Table& table, const std::string& file)
{
  const Mesh mesh = mesh_of(file);
  const Soup soup = with_fins(mesh), oriented = soup_of(mesh);
  Comparison times;
  for(int i = 0; i < repetitions; ++i)
    times.take(mesh, oriented, soup);
  const auto& [ordinary, tufted, mesh_alone] = times;
  const auto ratios = times.ratios();
  table.row(name_of(file), soup.triangles.size(), ordinary.operators.least(),
            tufted.operators.least(), ratios[0], ratios[1], ordinary.all(), tufted.all(), ratios[2],
            ratios[3]);
}

// Stores ratios of the times of soups to the times of their meshes, in the order of
// `Comparison::ratios()`.
struct Ratios
{
  std::array<std::vector<double>, 4> values;

  void add(const std::array<double, 4>& ratios)
  {
    for(std::size_t r = 0; r < 4; ++r)
      values[r].push_back(ratios[r]);
  }

  void add(const Ratios& other)
  {
    for(std::size_t r = 0; r < 4; ++r)
      values[r].insert(values[r].end(), other.values[r].begin(), other.values[r].end());
  }

  void print(const std::string& name)
  {
    std::vector<std::string> cells{name, Table::text(values[0].size())};
    for(auto& ratios : values) {
      std::sort(ratios.begin(), ratios.end());
      cells.push_back(Table::text(ratios[ratios.size() / 2]));
      cells.push_back(Table::text(ratios.back()));
    }
    Table::print(cells);
  }
};

Ratios benchmark_soups(const std::string& name)
{
  const Mesh mesh = mesh_of(data_file(name));
  const Soup oriented = soup_of(mesh);
  Ratios result;
  for(unsigned int seed = 0; seed < 5; ++seed) {
    const Soup soup = spoiled(mesh, seed);
    Comparison times;
    for(int i = 0; i < repetitions; ++i)
      times.take(mesh, oriented, soup);
    result.add(times.ratios());
  }
  result.print(name);
  return result;
}

void benchmark_all_soups()
{
  const Table table({"mesh", "soups", "operators", "at most", "with the mesh made first", "at most",
                     "with a distance", "at most", "with the mesh made first", "at most"});
  Ratios all;
  for(const char* name : {"anchor_dense", "blobby",   "bones",       "cow",
                          "dino",         "elephant", "elk",         "femur",
                          "hand",         "head",     "holes",       "homer",
                          "knot1",        "mushroom", "retinal",     "elephant-with-holes",
                          "rotor_small",  "spool",    "three_peaks", "triceratops"})
    all.add(benchmark_soups(name));
  all.print("all");
}

int main(int argc, char** argv)
{
  keep_memory();
  std::vector<std::string> files(argv + 1, argv + argc);
  if(files.empty())
    for(const char* name : {"armadillo", "camel", "refined_elephant"})
      files.push_back(data_file(name));
  const Table table({"mesh", "faces", "operators, mesh (ms)", "soup (ms)", "ratio",
                     "with the mesh made first", "with a distance, mesh (ms)", "soup (ms)", "ratio",
                     "with the mesh made first"});
  for(const std::string& file : files)
    benchmark_mesh(table, file);
  if(argc == 1)
    benchmark_all_soups();
}
