// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Measures the distortion of coarse surfaces with few vertices (Figures 5.5 and 5.6). They are
// simplified by edge collapses with quadrics, where fine vertices are mapped to the closest points.
// They are also simplified intrinsically, where the map is known on projective pieces. The first
// column is the difference of areas in percent. The next columns are means over the fine surface of
// two logarithms: the scaling of area, and the ratio of the singular values of the differential.
// With quadrics, fine faces whose image has less than a millionth of their area do not count. The
// percentage of their area is in the column "lost". The last column checks the integrals: the
// relative error of the area of the coarse surface. Arguments are meshes, by default CGAL's bunny
// and generated developable surfaces.

#include "quadric_simplification.h"
#include "surfaces.h"

#include <CGAL/Intrinsic_simplification/Evolving_surface.h>
#include <CGAL/Intrinsic_simplification/Surface_level.h>
#include <CGAL/Intrinsic_simplification/Surface_map.h>
#include <CGAL/Intrinsic_simplification/projective_pieces.h>
#include <CGAL/Intrinsic_simplification/simplify.h>
#include <CGAL/Polygon_mesh_processing/measure.h>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <iterator>
#include <string>
#include <vector>

namespace IS = CGAL::Intrinsic_simplification;
namespace IT = CGAL::Intrinsic_triangulations;

namespace {

typedef Eigen::Matrix<double, 2, 3> Triangle; // corners in the plane

Triangle laid_out(double ab, double bc, double ca)
{
  const double x = (ab * ab + ca * ca - bc * bc) / (2 * ab);
  Triangle result;
  result << 0, ab, x, 0, 0, std::sqrt((std::max)(0., ca * ca - x * x));
  return result;
}

double area(const Triangle& t) { return t(0, 1) * t(1, 2) / 2; }

// Returns the derivatives of barycentric coordinates with respect to a point.
Eigen::Matrix<double, 3, 2> gradients(const Triangle& t)
{
  Eigen::Matrix3d place;
  place << t, 1, 1, 1;
  return place.inverse().leftCols<2>();
}

// Stores integrals over the fine surface.
struct Distortion
{
  double area = 0, image = 0, scaling = 0, anisotropy = 0, lost = 0;

  void add(double weight, const Eigen::Matrix2d& differential)
  {
    const Eigen::Vector2d sigma = Eigen::JacobiSVD<Eigen::Matrix2d>(differential).singularValues();
    image += weight * sigma[0] * sigma[1];
    if(!(sigma[0] * sigma[1] > 1e-6)) {
      lost += weight;
      return;
    }
    area += weight;
    scaling += weight * std::abs(std::log(sigma[0] * sigma[1]));
    anisotropy += weight * std::log(sigma[0] / sigma[1]);
  }
};

// ---- Intrinsic ----

Triangle face(Mesh::Face_index f, const IS::Surface_level& level)
{
  const auto side = IT::sides(f, level.mesh());
  const auto length = [&](std::size_t s) {
    return get(level.length_map(), level.mesh().edge(side[s]));
  };
  return laid_out(length(0), length(1), length(2));
}

// Returns the differential of the map at a point.
Eigen::Matrix2d differential(const IS::Projective_piece& piece, const Eigen::Vector3d& b,
                             const Triangle& fine, const Triangle& coarse)
{
  Eigen::Matrix3d m;
  for(int r = 0; r < 3; ++r)
    for(int c = 0; c < 3; ++c)
      m(r, c) = piece.matrix[std::size_t(r)][std::size_t(c)];
  const Eigen::Vector3d image = m * b;
  const double sum = image.sum();
  return coarse * (m / sum - image * m.colwise().sum() / (sum * sum)) * gradients(fine);
}

// Adds a piece as a fan of triangles. The midpoints of their sides are the points of the integral.
void add(const IS::Projective_piece& piece, const Triangle& fine, const Triangle& coarse,
         Distortion& sum)
{
  const auto corner = [&](std::size_t i) -> Eigen::Vector3d {
    return Eigen::Map<const Eigen::Vector3d>(piece.corners[i].fine.data());
  };
  for(std::size_t i = 1; i + 1 < piece.corners.size(); ++i) {
    Eigen::Matrix3d part;
    part << corner(0), corner(i), corner(i + 1);
    const double weight = std::abs(part.determinant()) * area(fine) / 3;
    for(int c = 0; c < 3; ++c)
      sum.add(weight, differential(piece, (part.col(c) + part.col((c + 1) % 3)) / 2, fine, coarse));
  }
}

Distortion intrinsic_distortion(const IS::Surface_map& map)
{
  std::vector<IS::Projective_piece> pieces;
  IS::projective_pieces(map, std::back_inserter(pieces));
  Distortion result;
  for(const IS::Projective_piece& p : pieces)
    add(p, face(p.fine_face, map.fine()), face(p.coarse_face, map.coarse()), result);
  return result;
}

double area(const IS::Surface_level& level)
{
  double sum = 0;
  for(Mesh::Face_index f : level.mesh().faces())
    sum += area(face(f, level));
  return sum;
}

// ---- Quadrics ----

Triangle face(const std::array<Eigen::Vector3d, 3>& p)
{
  return laid_out((p[1] - p[0]).norm(), (p[2] - p[1]).norm(), (p[0] - p[2]).norm());
}

Eigen::MatrixXd points(const Mesh& mesh)
{
  Eigen::MatrixXd result(Eigen::Index(mesh.number_of_vertices()), 3);
  for(Vertex v : mesh.vertices())
    result.row(Eigen::Index(v)) << mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z();
  return result;
}

Distortion extrinsic_distortion(const Mesh& fine, const Mesh& coarse)
{
  const Eigen::MatrixXd place = points(fine),
                        image = closest_point_matrix(coarse, fine) * points(coarse);
  Distortion result;
  for(Mesh::Face_index f : fine.faces()) {
    std::array<Eigen::Vector3d, 3> from, to;
    std::size_t c = 0;
    for(Vertex v : fine.vertices_around_face(fine.halfedge(f))) {
      from[c] = place.row(Eigen::Index(v));
      to[c++] = image.row(Eigen::Index(v));
    }
    const Triangle t = face(from);
    const bool is_point = to[0] == to[1];
    result.add(area(t), is_point ? Eigen::Matrix2d(Eigen::Matrix2d::Zero())
                                 : Eigen::Matrix2d(face(to) * gradients(t)));
  }
  return result;
}

// ---- Table ----

void append(std::vector<std::string>& cells, double area_before, double area_after,
            const Distortion& d)
{
  for(const double x :
      {100 * (area_after / area_before - 1), d.scaling / d.area, d.anisotropy / d.area})
    cells.push_back(Table::text(x));
}

void benchmark(const std::string& name, const Mesh& mesh, std::size_t number_of_vertices)
{
  IS::Evolving_surface surface(mesh);
  const IS::Surface_level fine(surface);
  IS::simplify(surface, IS::parameters::number_of_vertices(number_of_vertices));
  const IS::Surface_level coarse(surface);
  const Distortion ours = intrinsic_distortion(IS::Surface_map(surface, fine, coarse));
  const Mesh quadrics = collapsed(mesh, number_of_vertices);
  const Distortion theirs = extrinsic_distortion(mesh, quadrics);
  std::vector<std::string> cells{name, Table::text(mesh.number_of_vertices()),
                                 Table::text(number_of_vertices)};
  append(cells, area(fine), CGAL::Polygon_mesh_processing::area(quadrics), theirs);
  cells.push_back(Table::text(100 * theirs.lost / (theirs.lost + theirs.area)));
  append(cells, area(fine), area(coarse), ours);
  cells.push_back(Table::text(std::abs(ours.image / area(coarse) - 1)));
  Table::print(cells);
}

// The next functions return sheets that are bent along parallel lines, or along the rays of a cone.
Mesh wave(unsigned n)
{
  return grid(n, n, [n](unsigned i, unsigned j) {
    const double x = double(i) / n, y = double(j) / n;
    return Point(x, y + 0.3 * x, 0.05 * std::sin(50 * x));
  });
}

Mesh folded_cone(unsigned n)
{
  return grid(n, n, [n](unsigned i, unsigned j) {
    const double angle = 3 * double(i) / n, r = 0.2 + double(j) / n;
    return Point(r * std::cos(angle), r * std::sin(angle), 0.1 * r * std::sin(16 * angle));
  });
}

} // namespace

int main(int argc, char* argv[])
{
  const Table table({"mesh", "vertices", "coarse", "quadrics: area (%)", "scaling", "anisotropy",
                     "lost (%)", "intrinsic: area (%)", "scaling", "anisotropy", "check"});
  for(const std::size_t coarse : {2000U, 200U}) {
    for(int i = 1; i < argc; ++i)
      benchmark(name_of(argv[i]), read_surface(argv[i]), coarse);
    if(argc > 1)
      continue;
    benchmark("bunny00", read_surface(CGAL::data_file_path("meshes/bunny00.off")), coarse);
    benchmark("folds", wave(160), coarse);
    benchmark("folded cone", folded_cone(160), coarse);
  }
}
