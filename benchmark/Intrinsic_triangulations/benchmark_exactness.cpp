// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Measures the cost of exactness: construction and flips in `double` and with exact decisions,
// which alternate, and the certificate of the former. It also measures the certificate of a
// weighted Delaunay triangulation. Arguments are meshes. By default, they are CGAL's own and a grid
// of 100,000 squares in a rotated plane, each of them a tie. Times are medians.

#include "../Table.h"
#include "measure.h"

#include <CGAL/Intrinsic_triangulations/Exact_Euclidean_geometry_traits.h>
#include <CGAL/Intrinsic_triangulations/certify_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/certify_weighted_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/make_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/make_weighted_Delaunay.h>
#include <CGAL/Random.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <iostream>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;

typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Mesh;

constexpr int repetitions = 15;

// Returns squares with integer coordinates in a plane that is rotated by a quaternion of integers.
Mesh make_grid(int m, int n)
{
  Mesh mesh;
  std::vector<Mesh::Vertex_index> v;
  for(int j = 0; j <= n; ++j)
    for(int i = 0; i <= m; ++i)
      v.push_back(mesh.add_vertex({4. * j - 20 * i, 20. * i - 10 * j, 10. * i + 28 * j}));
  for(int j = 0; j < n; ++j)
    for(int i = 0; i < m; ++i) {
      const auto corner = [&](int di, int dj) {
        return v[static_cast<std::size_t>((j + dj) * (m + 1) + i + di)];
      };
      mesh.add_face(corner(0, 0), corner(1, 0), corner(1, 1));
      mesh.add_face(corner(0, 0), corner(1, 1), corner(0, 1));
    }
  return mesh;
}

template <typename Traits>
IT::Intrinsic_triangulation<Traits> Delaunay(const Mesh& mesh)
{
  IT::Intrinsic_triangulation<Traits> tri(mesh);
  IT::make_Delaunay(tri);
  return tri;
}

// Returns random weights between the squares of the shortest edges at vertices and their negatives.
std::vector<double> random_weights(const Mesh& mesh)
{
  CGAL::Random random(1);
  std::vector<double> result(mesh.number_of_vertices(), std::numeric_limits<double>::infinity());
  for(auto e : mesh.edges())
    for(unsigned int i : {0, 1}) {
      double& least = result[mesh.vertex(e, i).idx()];
      least = (std::min)(least, CGAL::squared_distance(mesh.point(mesh.vertex(e, 0)),
                                                       mesh.point(mesh.vertex(e, 1))));
    }
  for(double& weight : result)
    weight *= random.get_double(-1, 1);
  return result;
}

// Returns the milliseconds of the certificate of a weighted Delaunay triangulation.
double time_of_weighted_certificate(const Mesh& mesh)
{
  const std::vector<double> weights = random_weights(mesh);
  const auto weight = boost::make_function_property_map<IT::Vertex_index>(
    [&](IT::Vertex_index v) { return weights[v.idx()]; });
  IT::Intrinsic_triangulation<> tri(mesh);
  const auto hidden = IT::make_weighted_Delaunay(tri, weight).hidden_vertices;
  Samples certify;
  for(int i = 0; i < repetitions; ++i)
    if(!certify.time([&] { return IT::certify_weighted_Delaunay(tri, weight, hidden); })
          .is_weighted_Delaunay())
      throw std::runtime_error("a weighted Delaunay triangulation is not certified");
  return certify.median();
}

void benchmark(const Table& table, const std::string& name, const Mesh& mesh)
{
  Samples rounded, exact, certify;
  IT::Delaunay_certificate certificate;
  for(int i = 0; i < repetitions; ++i) {
    const auto tri = rounded.time([&] { return Delaunay<IT::Euclidean_geometry_traits<>>(mesh); });
    certificate = certify.time([&] { return IT::certify_Delaunay(tri); });
    exact.time([&] { return Delaunay<IT::Exact_Euclidean_geometry_traits<>>(mesh); });
  }
  table.row(name, mesh.number_of_edges(), rounded.median(), exact.median(),
            exact.median() / rounded.median(), certify.median(), time_of_weighted_certificate(mesh),
            certificate.ties.size(), certificate.non_Delaunay_edges.size());
}

int main(int argc, char** argv)
{
  keep_memory();
  std::vector<std::string> files(argv + 1, argv + argc);
  if(files.empty())
    for(const char* name : {"armadillo", "camel", "turbine", "ChineseDragon-10kv",
                            "refined_elephant", "fandisk", "anchor"})
      files.push_back(CGAL::data_file_path(std::string("meshes/") + name + ".off"));
  const Table table({"mesh", "edges", "`double` (ms)", "exact (ms)", "ratio", "certificate (ms)",
                     "certificate with weights (ms)", "ties", "not Delaunay with `double`"});
  for(const std::string& file : files) {
    Mesh mesh;
    if(CGAL::IO::read_polygon_mesh(file, mesh))
      benchmark(table, name_of(file), mesh);
    else
      std::cerr << file << " cannot be read\n";
  }
  if(argc == 1)
    benchmark(table, "grid", make_grid(400, 250));
}
