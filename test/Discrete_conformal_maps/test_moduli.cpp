// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "planar_cells.h"

#include <CGAL/Discrete_conformal_maps/uniformize.h>

// Moduli are known in closed form: of strips and annuli, also if they wind, and of polygons with
// symmetries.
namespace Test_moduli {

using namespace Test_surfaces;

// ---- Strips ----

// Represents a rectangle of n columns of random widths, folded between them by random angles of at
// most `fold`: an isometric image.
struct Folded_strip
{
  Folded_strip(std::size_t n, std::size_t rows, double length, double fold, unsigned int seed)
  {
    CGAL::Random random(seed);
    std::vector<double> x{0}, z{0}, width;
    double direction = 0;
    for(std::size_t i = 0; i < n; ++i)
      width.push_back(random.get_double(0.5, 1));
    const double sum = std::accumulate(width.begin(), width.end(), 0.);
    for(double w : width) {
      direction += fold * random.get_double(0, 1);
      x.push_back(x.back() + length * w / sum * std::cos(direction));
      z.push_back(z.back() + length * w / sum * std::sin(direction));
    }
    mesh = grid(n, rows, [&](double i, double j) {
      return Point(x[std::size_t(i)], j / double(rows), z[std::size_t(i)]);
    });
    const auto at = [&](std::size_t i, std::size_t j) {
      return Vertex_index(Mesh::size_type(i * (rows + 1) + j));
    };
    corners = {at(0, 0), at(n, 0), at(n, rows), at(0, rows)};
  }

  Mesh mesh;
  std::vector<Vertex_index> corners;
};

TEST(Moduli, of_folded_strips_are_those_of_rectangles)
{
  for(const double length : traced({0.01, 1., 30., 1000.}))
    for(const std::size_t rows : {1u, 3u})
      for(const double fold : {0., 0.3, 3.}) {
        const Folded_strip strip(300, rows, length, fold, 5);
        EXPECT_NEAR(ratio_of_sides(strip.mesh, strip.corners) / length, 1, 1e-10);
      }
}

// Returns the modulus of the image of a rectangle of width 1, turned by an angle, under the
// exponential function. It winds around the origin.
double modulus_of_spiral(double length, double turn, std::size_t n)
{
  const std::size_t columns = std::size_t(std::lround(length * double(n)));
  const Complex direction = std::polar(1., turn);
  const Mesh mesh = grid(columns, n, [&](double i, double j) {
    const Complex z = std::exp(direction * Complex(i, j) / double(n));
    return Point(z.real(), z.imag(), 0);
  });
  const auto at = [&](std::size_t i, std::size_t j) {
    return Vertex_index(Mesh::size_type(i * (n + 1) + j));
  };
  return ratio_of_sides(mesh, {at(0, 0), at(columns, 0), at(columns, n), at(0, n)});
}

TEST(Moduli, of_spirals_converge_to_those_of_rectangles)
{
  for(const double turn : traced({0.2, 1., 1.4}))
    for(const double length : {2., 20.}) {
      std::vector<double> errors;
      for(const std::size_t n : {4u, 8u, 16u})
        errors.push_back(std::abs(modulus_of_spiral(length, turn, n) / length - 1));
      expect_convergence(errors, 3, 1e-3);
    }
}

// ---- Annuli ----

double modulus_of_annulus(const Mesh& mesh)
{
  const DCM::Uniformization result = DCM::uniformize(mesh);
  EXPECT_EQ(result.type, DCM::Surface_type::annulus);
  EXPECT_EQ(result.status(), DCM::Map_status::success);
  return result.modulus ? result.modulus->imag() : 0;
}

// Returns rings of n vertices at distances r from the axis and at heights.
Mesh rings(std::size_t n, const std::vector<std::pair<double, double>>& radius_and_height)
{
  std::vector<Point> points;
  for(const auto& [r, height] : radius_and_height)
    for(std::size_t j = 0; j < n; ++j) {
      const Complex z = std::polar(r, 2 * pi * double(j) / double(n));
      points.emplace_back(z.real(), z.imag(), height);
    }
  return make_mesh(points, lattice(radius_and_height.size() - 1, n, false, true));
}

// Rings whose distances from the apex grow by a factor have similar trapezoids between them.
// By Ptolemy's theorem, scale factors that are inverse to the distance make them equal rectangles.
// The trapezoids are so high that the double of their triangulation is Delaunay.
TEST(Moduli, of_cones_with_growing_rings_are_exact)
{
  const std::size_t n = 9, rows = 40;
  for(const double factor : traced({1.5, 2., 3.}))
    for(const double slope : {0., 0.5, 20.}) {
      std::vector<std::pair<double, double>> ring;
      for(std::size_t i = 0; i <= rows; ++i)
        ring.emplace_back(std::pow(factor, double(i)), slope * std::pow(factor, double(i)));
      const double height = (factor - 1) * std::hypot(1, slope) / std::sqrt(factor),
                   width = 2 * std::sin(pi / double(n));
      EXPECT_NEAR(modulus_of_annulus(rings(n, ring)) / (double(rows) * height),
                  1 / (double(n) * width), 1e-10);
    }
}

TEST(Moduli, of_round_annuli_converge)
{
  for(const double ratio : traced({1.5, 4., 30.})) {
    std::vector<double> errors;
    for(const std::size_t m : {6u, 12u, 24u}) {
      std::vector<std::pair<double, double>> ring; // not in proportion, and not equally far apart
      for(std::size_t i = 0; i <= m; ++i) {
        const double t = double(i) / double(m);
        ring.emplace_back(std::pow(ratio, (t + t * t) / 2), 0);
      }
      errors.push_back(
        std::abs(modulus_of_annulus(rings(4 * m, ring)) * 2 * pi / std::log(ratio) - 1));
    }
    expect_convergence(errors, 3, 1e-2);
  }
}

// ---- Symmetries ----

// Returns a square with four arms that wind around it.
std::set<Cell> pinwheel(int length)
{
  std::set<Cell> result{{0, 0}};
  std::vector<Cell> arm;
  for(int i = 1; i <= 2; ++i)
    arm.emplace_back(i, 0);
  for(int j = 1; j <= length; ++j)
    arm.emplace_back(2, j);
  for(Cell c : arm)
    for(int k = 0; k < 4; ++k) {
      result.insert(c);
      c = {-c.second, c.first};
    }
  return result;
}

// Four corners that a quarter turn permutes have the modulus of a square. The triangulation has no
// symmetry, but discrete conformal equivalence does not depend on it.
TEST(Moduli, of_surfaces_with_quarter_turns_are_one)
{
  for(const int length : traced({0, 1, 3})) {
    const int n = 3;
    const Planar_cells cells(pinwheel(length), n, 7);
    for(Vertex_index v : cells.mesh.vertices()) {
      if(!cells.mesh.is_border(v) || v.idx() % 7 != 0)
        continue;
      std::vector<Vertex_index> corners;
      for(Cell p = cells.place(v); corners.size() < 4; p = {n - p.second, p.first})
        corners.push_back(cells.at(p));
      EXPECT_NEAR(ratio_of_sides(cells.mesh, corners), 1, 1e-9) << cells.mesh.point(v);
    }
  }
}

// Two corners on an axis of symmetry and two mirror images of each other have the modulus of a
// square.
TEST(Moduli, of_surfaces_with_diagonals_are_one)
{
  for(const int steps : traced({1, 2, 5})) { // a square, an L and a staircase
    std::set<Cell> stairs;
    for(int i = 0; i < steps; ++i)
      for(int j = 0; i + j < steps; ++j)
        stairs.emplace(i, j);
    const Planar_cells cells(stairs, 4, 8);
    Cell end{0, 0}; // the other end of the diagonal
    for(Vertex_index v : cells.mesh.vertices())
      if(const Cell p = cells.place(v); p.first == p.second)
        end = (std::max)(end, p);
    for(Vertex_index v : cells.mesh.vertices()) {
      const Cell p = cells.place(v);
      if(!cells.mesh.is_border(v) || p.first <= p.second || v.idx() % 3 != 0)
        continue;
      const std::vector<Vertex_index> corners{cells.at({0, 0}), v, cells.at(end),
                                              cells.at({p.second, p.first})};
      EXPECT_NEAR(ratio_of_sides(cells.mesh, corners), 1, 1e-9) << cells.mesh.point(v);
    }
  }
}

} // namespace Test_moduli
