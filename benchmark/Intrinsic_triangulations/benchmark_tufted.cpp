// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Laplacian, mass and distances by the tufted cover beside those of the ordinary way, from triangles
// to the result, on meshes named as arguments or on CGAL's own. The cover is that of the triangles
// of the mesh without their orientation, and with a fin at every hundredth edge; the ordinary way
// has a mesh first, with or without the time to make it.

#include "measure.h"

#include <CGAL/Intrinsic_triangulations/Tufted_surface.h>
#include <CGAL/Intrinsic_triangulations/heat_distance.h>
#include <CGAL/Intrinsic_triangulations/make_Delaunay.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Random.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <array>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;

typedef CGAL::Simple_cartesian<double>::Point_3 Point;
typedef CGAL::Surface_mesh<Point> Mesh;
typedef Eigen::SparseMatrix<double> Matrix;
typedef std::array<std::uint32_t, 3> Triangle;

constexpr int repetitions = 7;

struct Soup
{
  explicit Soup(const Mesh& mesh) : points(mesh.points().begin(), mesh.points().end())
  {
    CGAL::Random random(1);
    for(const Mesh::Face_index f : mesh.faces()) {
      const Mesh::Halfedge_index h = mesh.halfedge(f);
      Triangle t{mesh.source(h), mesh.target(h), mesh.target(mesh.next(h))};
      if(random.get_bool())
        std::swap(t[1], t[2]);
      triangles.push_back(t);
      if(f.idx() % 150 == 0) {
        points.push_back(CGAL::midpoint(points[t[0]], points[t[1]]) +
                         CGAL::normal(points[t[0]], points[t[1]], points[t[2]]) / 10);
        triangles.push_back({t[0], t[1], static_cast<std::uint32_t>(points.size() - 1)});
      }
    }
  }

  std::vector<Point> points;
  std::vector<Triangle> triangles;
};

// The times of the ways to operators, and from there to a distance.
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
    distance.time([&] { return IT::heat_distance(surface, std::array{IT::Vertex_index(0)}); });
  }

  double all() const { return operators.median() + distance.median(); }
};

// A triangulation and a view of it.
struct Ordinary_surface
{
  IT::Intrinsic_triangulation<> tri;
  const IT::Delta_complex& mesh() const { return tri.mesh(); }
  auto length_map() const { return tri.length_map(); }
};

void benchmark(const std::string& file)
{
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(file, mesh)) {
    std::printf("%s: cannot be read\n", file.c_str());
    return;
  }
  const Soup soup(mesh);
  std::vector<Triangle> oriented;
  for(const Mesh::Face_index f : mesh.faces()) {
    const Mesh::Halfedge_index h = mesh.halfedge(f);
    oriented.push_back({mesh.source(h), mesh.target(h), mesh.target(mesh.next(h))});
  }
  Times ordinary, tufted;
  Samples cover_alone, mesh_alone;
  for(int i = 0; i < repetitions; ++i) {
    mesh_alone.time([&] {
      Mesh result;
      CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(soup.points, oriented, result);
      return result;
    });
    ordinary.take([&] {
      Ordinary_surface result{IT::Intrinsic_triangulation<>(mesh)};
      IT::make_Delaunay(result.tri);
      return result;
    });
    tufted.take([&] {
      const auto cover =
        cover_alone.time([&] { return IT::tufted_cover(soup.points, soup.triangles); });
      IT::Intrinsic_triangulation<> tri(cover.mesh());
      IT::make_Delaunay(tri);
      return IT::Tufted_surface<>(cover, tri.intrinsic());
    });
  }
  const double made = mesh_alone.median();
  const double operators = tufted.operators.median(), distance = tufted.all();
  const std::string name = file.substr(file.find_last_of('/') + 1);
  std::printf("%-22s%8zu%7.1f%7.1f%10.1f%8.1f%6.2f%6.2f%10.1f%8.1f%6.2f%6.2f\n", name.c_str(),
              soup.triangles.size(), made, cover_alone.median(), ordinary.operators.median(),
              operators, operators / ordinary.operators.median(),
              operators / (ordinary.operators.median() + made), ordinary.all(), distance,
              distance / ordinary.all(), distance / (ordinary.all() + made));
}

int main(int argc, char** argv)
{
  keep_memory();
  std::vector<std::string> files(argv + 1, argv + argc);
  if(files.empty())
    for(const char* name : {"armadillo", "camel", "refined_elephant"})
      files.push_back(CGAL::data_file_path(std::string("meshes/") + name + ".off"));
  std::printf("milliseconds, medians of %d; ratios without and with the time to make the mesh\n",
              repetitions);
  std::printf("%-22s%8s%7s%7s%10s%8s%12s%10s%8s%12s\n", "mesh", "faces", "mesh", "cover",
              "operators", "tufted", "ratios", "distance", "tufted", "ratios");
  for(const std::string& file : files)
    benchmark(file);
}
