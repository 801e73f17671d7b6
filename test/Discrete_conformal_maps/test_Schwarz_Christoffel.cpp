// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "planar_cells.h"

#include <CGAL/Discrete_conformal_maps/flatten_to_disk.h>

#include <boost/math/quadrature/tanh_sinh.hpp>
#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/jacobi_elliptic.hpp>

#include <Eigen/Dense>

// These polygons have smooth maps to the half-plane that are known by integrals. Errors of discrete
// maps decrease as the mesh is refined.
namespace Test_Schwarz_Christoffel {

using namespace Test_surfaces;

// ---- Rectangles, whose maps are elliptic functions ----

// Returns the ratio of the sides of the rectangle whose corners are the images of four points of a
// circle or a line. Their cross ratio is `ratio` = (z_2 - z_1)(z_4 - z_3) / ((z_3 - z_1)(z_4 -
// z_2)).
double rectangle_of_cross_ratio(double ratio)
{
  return boost::math::ellint_1(std::sqrt(ratio)) / boost::math::ellint_1(std::sqrt(1 - ratio));
}

double cross_ratio_of_rectangle(double sides)
{
  double low = 0, high = 1;
  for(int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (rectangle_of_cross_ratio(middle) < sides ? low : high) = middle;
  }
  return low;
}

double cross_ratio(const std::array<Complex, 4>& z)
{
  const Complex ratio = (z[1] - z[0]) * (z[3] - z[2]) / ((z[2] - z[0]) * (z[3] - z[1]));
  EXPECT_NEAR(ratio.imag(), 0, 1e-7); // on a circle
  return ratio.real();
}

std::set<Cell> block(int m, int n)
{
  std::set<Cell> result;
  for(int i = 0; i < m; ++i)
    for(int j = 0; j < n; ++j)
      result.emplace(i, j);
  return result;
}

// Returns the greatest error of a vertex on the bottom of a rectangle. Its position in the
// half-plane with corners 0, k^2, 1 and infinity is k^2 sn^2.
double error_of_bottom(int width, int n)
{
  const Planar_cells cells(block(width, 1), n, 3);
  const Planar_conformal_map map = DCM::flatten_to_disk(cells.mesh);
  EXPECT_EQ(map.status(), DCM::Map_status::success);
  const auto at = [&](int x, int y) { return image(map, cells.at({x, y})); };
  const double square = cross_ratio_of_rectangle(width), k = std::sqrt(square);
  double result = 0;
  for(int x = 1; x <= width * n; ++x) {
    const double sn = boost::math::jacobi_sn(k, boost::math::ellint_1(k) * x / (width * n)),
                 place = cross_ratio({at(0, 0), at(x, 0), at(width * n, n), at(0, n)});
    result = (std::max)(result, std::abs(place - square * sn * sn));
  }
  return result;
}

TEST(Schwarz_Christoffel, rectangles_have_the_boundary_correspondence_of_elliptic_functions)
{
  for(const int width : traced({1, 2, 3})) {
    std::vector<double> errors;
    for(const int n : {4, 8, 16})
      errors.push_back(error_of_bottom(width, n));
    expect_convergence(errors, 1.8, 0.02);
  }
}

// ---- Polygons ----

// Represents an image of the upper half-plane with the derivative t^e_0 (t - t_1)^e_1 ..., t_0 = 0
// and t_1 = 1. The last corner is the image of infinity.
class Half_plane_map
{
public:
  // The value sides[i] is the distance of the images of t_i and t_i+1, up to a common factor.
  Half_plane_map(const std::vector<double>& exponents, const std::vector<double>& sides)
    : m_exponent(exponents), m_place(exponents.size())
  {
    Eigen::VectorXd gap = Eigen::VectorXd::Zero(Eigen::Index(exponents.size()) - 2);
    for(int step = 0; step < 50; ++step) {
      const Eigen::VectorXd error = errors(gap, sides);
      if(error.lpNorm<Eigen::Infinity>() < 1e-13)
        break;
      Eigen::MatrixXd derivative(gap.size(), gap.size());
      for(Eigen::Index k = 0; k < gap.size(); ++k) {
        Eigen::VectorXd other = gap;
        other[k] += 1e-6;
        derivative.col(k) = (errors(other, sides) - error) / 1e-6;
      }
      const Eigen::VectorXd change = derivative.lu().solve(error);
      gap -= change / (std::max)(1., change.lpNorm<Eigen::Infinity>());
    }
    EXPECT_LT(errors(gap, sides).lpNorm<Eigen::Infinity>(), 1e-10);
  }

  double place(std::size_t i) const { return m_place[i]; }

private:
  // Returns the errors of logarithms of sides, relative to the first. The variables are logarithms
  // of distances on the line.
  Eigen::VectorXd errors(const Eigen::VectorXd& gap, const std::vector<double>& sides)
  {
    m_place[0] = 0;
    m_place[1] = 1;
    for(Eigen::Index k = 0; k < gap.size(); ++k)
      m_place[std::size_t(k) + 2] = m_place[std::size_t(k) + 1] + std::exp(gap[k]);
    Eigen::VectorXd result(gap.size());
    for(Eigen::Index k = 0; k < gap.size(); ++k)
      result[k] =
        std::log(side(std::size_t(k) + 1) / side(0) * sides[0] / sides[std::size_t(k) + 1]);
    return result;
  }

  double side(std::size_t i) const
  {
    const double a = m_place[i], b = m_place[i + 1];
    // The second argument is the distance from the nearer end with a sign, without cancellation.
    const auto derivative = [&](double t, double from_end) {
      double result = 1;
      for(std::size_t k = 0; k < m_place.size(); ++k) {
        double distance = std::abs(t - m_place[k]);
        if(k == i && from_end < 0)
          distance = -from_end;
        if(k == i + 1 && from_end > 0)
          distance = from_end;
        result *= std::pow(distance, m_exponent[k]);
      }
      return result;
    };
    return boost::math::quadrature::tanh_sinh<double>().integrate(derivative, a, b);
  }

  std::vector<double> m_exponent, m_place;
};

// Represents stairs with some steps of height 1, symmetric with respect to the diagonal from the
// lower left corner: a square, an L and so on.
class Stairs
{
public:
  explicit Stairs(int steps) : m_steps(steps)
  {
    std::vector<Cell> half{{0, 0}, {steps, 0}}; // from one end of the axis to the other
    Cell c(steps, 1);
    for(bool is_convex = true; c.first > c.second; is_convex = !is_convex) {
      half.push_back(c);
      is_convex ? --c.first : ++c.second;
    }
    corners = half;
    corners.push_back(c);
    for(std::size_t i = half.size() - 1; i > 0; --i)
      corners.emplace_back(half[i].second, half[i].first);
    find_places(half.size());
  }

  std::set<Cell> cells() const
  {
    std::set<Cell> result;
    for(int i = 0; i < m_steps; ++i)
      for(int j = 0; i + j < m_steps; ++j)
        result.emplace(i, j);
    return result;
  }

  std::vector<Cell> corners;
  std::vector<Complex> places; // of the corners on the unit circle

private:
  // Finds the corners on the line of the half-plane of t, with 0 and infinity on the axis. The map
  // has the derivative t^e_0 (t^2 - t_1^2)^e_1 ..., where an angle a has the exponent a / pi - 1.
  // In t^2, the first exponent is (e_0 - 1) / 2.
  void find_places(std::size_t n)
  {
    std::vector<double> exponents{-0.75, -0.5}, sides{double(m_steps)};
    while(exponents.size() < n)
      exponents.push_back(exponents.size() % 2 == 0 ? -0.5 : 0.5);
    sides.resize(n - 1, 1);
    const Half_plane_map map(exponents, sides);
    const auto on_circle = [](double t) { return Complex(t, -1) / Complex(t, 1); };
    for(std::size_t i = 0; i < n; ++i)
      places.push_back(on_circle(std::sqrt(map.place(i))));
    places.push_back(1);
    for(std::size_t i = n - 1; i > 0; --i)
      places.push_back(std::conj(places[i]));
  }

  int m_steps;
};

// Returns quadruples of corners whose cross ratios are not extreme.
std::vector<std::array<std::size_t, 4>> fours(const std::vector<Complex>& places)
{
  std::vector<std::array<std::size_t, 4>> result;
  const std::size_t n = places.size();
  for(std::size_t i = 0; i < n; ++i)
    for(std::size_t j = i + 1; j < n; ++j)
      for(std::size_t k = j + 1; k < n; ++k)
        for(std::size_t l = k + 1; l < n; ++l) {
          const double ratio = cross_ratio({places[i], places[j], places[k], places[l]});
          // The ratio of symmetric corners is one half, which is exact on any mesh.
          const bool is_trivial = std::abs(ratio - 0.5) < 1e-9;
          if((i + j + k + l) % 3 == 0 && ratio > 0.01 && ratio < 0.99 && !is_trivial)
            result.push_back({i, j, k, l});
        }
  EXPECT_FALSE(result.empty());
  return result;
}

TEST(Schwarz_Christoffel, rectangles_of_stairs_have_their_sides)
{
  for(const int steps : traced({2, 3})) {
    const Stairs stairs(steps);
    std::vector<double> errors; // the greatest for each mesh
    for(const int n : {4, 8, 16}) {
      const Planar_cells cells(stairs.cells(), n, 5);
      errors.push_back(0);
      for(const auto& four : fours(stairs.places)) {
        std::array<Complex, 4> z;
        std::vector<Vertex_index> corners;
        for(std::size_t i = 0; i < 4; ++i) {
          z[i] = stairs.places[four[i]];
          const auto& [x, y] = stairs.corners[four[i]];
          corners.push_back(cells.at_corner(x, y));
        }
        const double expected = rectangle_of_cross_ratio(cross_ratio(z)),
                     error = std::abs(ratio_of_sides(cells.mesh, corners) / expected - 1);
        errors.back() = (std::max)(errors.back(), error);
      }
    }
    expect_convergence(errors, 1.3, 0.01);
  }
}

TEST(Schwarz_Christoffel, disks_of_stairs_have_the_cross_ratios_of_corners)
{
  for(const int steps : traced({2, 3, 4})) {
    const Stairs stairs(steps);
    std::vector<double> errors;
    for(const int n : {4, 8, 16}) {
      const Planar_cells cells(stairs.cells(), n, 6);
      const Planar_conformal_map map = DCM::flatten_to_disk(cells.mesh);
      EXPECT_EQ(map.status(), DCM::Map_status::success);
      std::vector<Complex> z;
      for(const auto& [x, y] : stairs.corners)
        z.push_back(image(map, cells.at_corner(x, y)));
      errors.push_back(0);
      for(const auto& [i, j, k, l] : fours(stairs.places)) {
        const auto& p = stairs.places;
        errors.back() = (std::max)(errors.back(), std::abs(cross_ratio({z[i], z[j], z[k], z[l]}) -
                                                           cross_ratio({p[i], p[j], p[k], p[l]})));
      }
    }
    expect_convergence(errors, 1.5, 0.01);
  }
}

} // namespace Test_Schwarz_Christoffel
