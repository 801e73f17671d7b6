// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Computes distances by heat to circles on a square, signed and unsigned. Prints mean errors in
// edge lengths, and CPU times compared with the times of the distance to a vertex. If p is the
// order of convergence, the error for half the edge length is 2^p times less. Then computes signed
// distances to plane sections of meshes, with mean and greatest errors in percent of the greatest
// exact distance.
// Usage: benchmark_signed_distance [--peer PROGRAM] [CELLS] [MESH...], with the greatest number of
// cells along a side of the square.
// Queries of a peer are sections: the axis across them, and the exact signed distances of the
// vertices. For each section, it prints the mean and the greatest error.

#include "../Peer.h"
#include "../Table.h"
#include "measure.h"

#include <CGAL/Intrinsic_triangulations/Correspondence.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/Shortest_paths.h>
#include <CGAL/Intrinsic_triangulations/curve_across.h>
#include <CGAL/Intrinsic_triangulations/heat_distance.h>
#include <CGAL/Intrinsic_triangulations/level_set.h>
#include <CGAL/Intrinsic_triangulations/make_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/signed_heat_distance.h>
#include <CGAL/Random.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace {

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
namespace IT = CGAL::Intrinsic_triangulations;

// Returns n times n cells, each cut in two, with inner vertices moved by up to a fifth of a cell.
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

// Returns the zeros of a function that is linear on faces, with negative values on the left.
template <typename Surface>
IT::Surface_curve<double> zeros(const Surface& surface, const Eigen::VectorXd& value)
{
  IT::Surface_curve<double> result;
  for(const auto& path : IT::level_set(surface, Eigen::VectorXd(-value), 0.)) {
    const auto part = IT::curve_through(surface, path.places);
    result.insert(result.end(), part.begin(), part.end());
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

// Computes the order of convergence, from the mean errors of this mesh and of the previous one.
class Order
{
public:
  std::string operator()(double error)
  {
    const double before = std::exchange(m_error, error);
    return before > 0 ? Table::text(std::log2(before / error)) : "";
  }

private:
  double m_error = 0;
};

void measure(const Table& table, int n, Order& order, Order& order_of_greater_time)
{
  const Mesh mesh = square(n);
  IT::Intrinsic_triangulation<> tri(mesh);
  IT::make_Delaunay(tri);
  const auto surface = tri.intrinsic();
  const Eigen::VectorXd exact = distances_from(mesh, 0.52, 0.47).array() - 0.3;
  const auto curve = zeros(surface, exact);
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
  const double factor = n / 16.; // the time is proportional to the edge length
  const IT::Signed_heat_distance greater_time(surface, IT::parameters::time_step_factor(factor));
  const double of_default = error(d, exact),
               of_greater_time = error(greater_time.distances(curve), exact);
  table.row(mesh.number_of_vertices(), of_default, order(of_default / n), of_greater_time,
            order_of_greater_time(of_greater_time / n), error(u, exact.cwiseAbs()),
            signed_build.median(), of_curve.median(), plain_build.median(), unsigned_curve.median(),
            plain.median());
}

// Returns the height over a plane that halves the bounding box.
Eigen::VectorXd heights(const Mesh& mesh, int axis)
{
  Eigen::VectorXd result(static_cast<Eigen::Index>(mesh.number_of_vertices()));
  for(Mesh::Vertex_index v : mesh.vertices())
    result[v.idx()] = mesh.point(v)[axis];
  return result.array() - (result.minCoeff() + result.maxCoeff()) / 2;
}

// Returns exact distances to the curve of zero height, with the sign of the height.
Eigen::VectorXd exact_distances(const IT::Intrinsic_triangulation<>& tri,
                                const IT::Surface_curve<double>& curve,
                                const Eigen::VectorXd& height)
{
  IT::Shortest_paths paths(tri.input());
  paths.add_source(curve);
  paths.run();
  Eigen::VectorXd result = height;
  for(Eigen::Index v = 0; v < result.size(); ++v)
    result[v] = std::copysign(paths.distance(IT::Vertex_index(Mesh::size_type(v))), height[v]);
  return result;
}

void measure(const Table& table, const std::string& file, const Peer& peer)
{
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(file, mesh))
    return;
  const IT::Intrinsic_triangulation<> input(mesh);
  IT::Intrinsic_triangulation<> tri = input;
  IT::make_Delaunay(tri);
  const IT::Correspondence correspondence(tri);
  const IT::Signed_heat_distance heat(tri.intrinsic());
  std::vector<std::vector<double>> queries;
  for(int axis = 0; axis < 3; ++axis) {
    const Eigen::VectorXd height = heights(mesh, axis);
    const auto curve = zeros(input.input(), height);
    const Eigen::VectorXd exact = exact_distances(input, curve, height);
    const Eigen::VectorXd error =
      heat.distances(IT::curve_across(correspondence, IT::Side::input, curve)) - exact;
    const double greatest = exact.cwiseAbs().maxCoeff();
    table.row(name_of(file), std::string(1, "xyz"[axis]), 100 * error.cwiseAbs().mean() / greatest,
              100 * error.cwiseAbs().maxCoeff() / greatest);
    queries.emplace_back(1, axis);
    queries.back().insert(queries.back().end(), exact.begin(), exact.end());
  }
  std::size_t axis = 0;
  for(const auto& [mean, greatest] : peer.operator()<2>(file, queries))
    table.row(name_of(file) + " by the peer", std::string(1, "xyz"[axis++]), mean, greatest);
}

} // namespace

int main(int argc, char* argv[])
{
  std::vector<std::string> arguments(argv + 1, argv + argc);
  const Peer peer(arguments);
  const int greatest = arguments.empty() ? 256 : std::stoi(arguments[0]);
  const Table table({"vertices", "error of `Signed_heat_distance`", "order",
                     "error with a factor of 1/(16 <i>h</i>)", "order", "error of `Heat_distance`",
                     "`Signed_heat_distance`: construction (ms)", "a curve (ms)",
                     "`Heat_distance`: construction (ms)", "a curve (ms)", "a vertex (ms)"},
                    0);
  Order order, order_of_greater_time;
  for(int n = 16; n <= greatest; n *= 2)
    measure(table, n, order, order_of_greater_time);
  const Table of_sections({"mesh", "section across", "mean error (%)", "greatest error (%)"}, 2);
  for(std::size_t i = 1; i < arguments.size(); ++i)
    measure(of_sections, arguments[i], peer);
}
