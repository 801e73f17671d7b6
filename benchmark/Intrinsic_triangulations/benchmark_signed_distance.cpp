// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Distances by heat to circles on a square, signed and not, and to a point inside a face: mean
// errors in edge lengths, and CPU times beside those of the distance to a vertex. Usage:
// benchmark_signed_distance [greatest number of cells along a side]

#include "../Table.h"
#include "measure.h"

#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/heat_distance.h>
#include <CGAL/Intrinsic_triangulations/make_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/signed_heat_distance.h>
#include <CGAL/Random.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <cmath>
#include <cstdlib>
#include <vector>

namespace {

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
namespace IT = CGAL::Intrinsic_triangulations;

// n times n cells, each cut in two, inner vertices moved by up to a fifth of a cell
Mesh square(int n)
{
  Mesh mesh;
  CGAL::Random random(1);
  std::vector<Mesh::Vertex_index> v;
  for(int i = 0; i <= n; ++i)
    for(int j = 0; j <= n; ++j) {
      const double move = i > 0 && j > 0 && i < n && j < n ? 0.2 : 0;
      const double x = i + move * random.get_double(-1, 1), y = j + move * random.get_double(-1, 1);
      v.push_back(mesh.add_vertex({x / n, y / n, 0}));
    }
  const auto at = [&](int i, int j) { return v[static_cast<std::size_t>(i * (n + 1) + j)]; };
  for(int i = 0; i < n; ++i)
    for(int j = 0; j < n; ++j) {
      mesh.add_face(at(i, j), at(i + 1, j), at(i, j + 1));
      mesh.add_face(at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
    }
  return mesh;
}

// Where a function that is linear on faces is zero, with negative values on the left.
IT::Surface_curve<double> level_set(const IT::Delta_complex& mesh, const Eigen::VectorXd& value)
{
  IT::Surface_curve<double> result;
  for(IT::Face_index f : mesh.faces()) {
    const auto h = IT::sides(f, mesh);
    const auto at = [&](std::size_t k) { return value[mesh.source(h[k % 3]).idx()]; };
    for(std::size_t k = 0; k < 3; ++k)
      if((at(k) < 0) != (at(k + 1) < 0) && (at(k) < 0) != (at(k + 2) < 0)) {
        const auto p = IT::barycentric_coordinates(k, at(k) / (at(k) - at(k + 1)));
        const auto q = IT::barycentric_coordinates((k + 2) % 3, at(k + 2) / (at(k + 2) - at(k)));
        result.push_back(at(k) < 0 ? IT::Curve_segment<double>{f, p, q}
                                   : IT::Curve_segment<double>{f, q, p});
      }
  }
  return result;
}

Eigen::VectorXd distances_from(const Mesh& mesh, double x, double y)
{
  Eigen::VectorXd result(static_cast<Eigen::Index>(mesh.number_of_vertices()));
  for(Mesh::Vertex_index v : mesh.vertices())
    result[v.idx()] = std::hypot(mesh.point(v).x() - x, mesh.point(v).y() - y);
  return result;
}

void measure(const Table& table, int n)
{
  const Mesh mesh = square(n);
  IT::Intrinsic_triangulation<> tri(mesh);
  IT::make_Delaunay(tri);
  const auto surface = tri.intrinsic();
  const Eigen::VectorXd exact = distances_from(mesh, 0.52, 0.47).array() - 0.3;
  const auto curve = level_set(tri.mesh(), exact);
  const auto error = [&](const Eigen::VectorXd& d, const Eigen::VectorXd& truth) {
    return (d - truth).cwiseAbs().mean() * n;
  };
  Samples plain_build, plain, signed_build, of_curve, unsigned_curve;
  const auto heat = plain_build.time([&] { return IT::Heat_distance<>(surface); });
  plain.time([&] { return heat.distances(IT::Vertex_index(0)); });
  const auto signed_heat = signed_build.time([&] { return IT::Signed_heat_distance(surface); });
  const Eigen::VectorXd d = of_curve.time([&] { return signed_heat.distances(curve); });
  IT::Distance_sources sources(surface);
  sources.add(curve);
  const Eigen::VectorXd u = unsigned_curve.time([&] { return heat.distances(sources); });
  table.row(mesh.number_of_vertices(), error(d, exact), error(u, exact.cwiseAbs()),
            signed_build.median(), of_curve.median(), plain_build.median(), unsigned_curve.median(),
            plain.median());
}

} // namespace

int main(int argc, char* argv[])
{
  const int greatest = argc > 1 ? std::atoi(argv[1]) : 256;
  const Table table({"vertices", "error of `Signed_heat_distance`", "of `Heat_distance`",
                     "`Signed_heat_distance`: construction (ms)", "a curve (ms)",
                     "`Heat_distance`: construction (ms)", "a curve (ms)", "a vertex (ms)"},
                    0);
  for(int n = 16; n <= greatest; n *= 2)
    measure(table, n);
}
