// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifdef CGAL_EIGEN3_ENABLED

#include "soups.h"

#include <CGAL/Intrinsic_triangulations/Tufted_surface.h>
#include <CGAL/Intrinsic_triangulations/heat_distance.h>
#include <CGAL/Intrinsic_triangulations/local_triangulations.h>
#include <CGAL/Intrinsic_triangulations/make_Delaunay.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <Eigen/Eigenvalues>

namespace Test_local_triangulations {

using namespace Test_surfaces;
using Matrix = Eigen::SparseMatrix<double>;
using Values = Eigen::VectorXd;

IT::Tufted_surface<> surface_of(const std::vector<Point>& points, const Triangles& triangles,
                                double share, bool is_flipped = true)
{
  const auto cover = IT::tufted_cover(points, triangles);
  IT::Intrinsic_triangulation<> t(cover.mesh());
  if(is_flipped)
    IT::make_Delaunay(t);
  return IT::Tufted_surface<>(cover, t.intrinsic(), share);
}

IT::Tufted_surface<> surface_of_cloud(const std::vector<Point>& points, std::size_t neighbors)
{
  return surface_of(points, IT::local_triangulations(points, neighbors), 1. / 6);
}

// Returns points of the unit square, in a plane in space. The point with index i, j has the number
// n * i + j.
std::vector<Point> plane(std::size_t n, CGAL::Random& random)
{
  std::vector<Point> points;
  for(std::size_t i = 0; i < n; ++i)
    for(std::size_t j = 0; j < n; ++j) {
      const double x = (double(i) + random.get_double(-0.3, 0.3)) / double(n - 1);
      const double y = (double(j) + random.get_double(-0.3, 0.3)) / double(n - 1);
      points.emplace_back(x, y, 0);
    }
  return points;
}

std::vector<Point> sphere(std::size_t n)
{
  std::vector<Point> points;
  for(std::size_t i = 0; i < n; ++i) {
    const double z = 1 - (2 * double(i) + 1) / double(n), r = std::sqrt(1 - z * z);
    const double angle = double(i) * pi * (3 - std::sqrt(5.));
    points.emplace_back(r * std::cos(angle), r * std::sin(angle), z);
  }
  return points;
}

// In the plane, rows of inner points are rows of the Delaunay triangulation, and each triangle
// occurs three times. Flips would separate them, because obtuse triangles lie on each other like
// the sides of a pillow.
TEST(Local_triangulations, agree_in_the_plane)
{
  CGAL::Random random(1);
  const std::size_t n = 15;
  const std::vector<Point> points = plane(n, random);
  typedef CGAL::Exact_predicates_inexact_constructions_kernel K;
  typedef CGAL::Delaunay_triangulation_2<
    K, CGAL::Triangulation_data_structure_2<
         CGAL::Triangulation_vertex_base_with_info_2<std::size_t, K>>>
    Delaunay;
  Delaunay delaunay;
  for(std::size_t i = 0; i < points.size(); ++i)
    delaunay.insert(K::Point_2(points[i].x(), points[i].y()))->info() = i;
  Triangles expected;
  for(const auto f : delaunay.finite_face_handles())
    expected.push_back({f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info()});
  const auto cloud = surface_of(points, IT::local_triangulations(points, 30), 1. / 6, false);
  const auto truth = surface_of(points, expected, 0.5, false);
  const Matrix error = IT::cotan_laplacian(cloud) - IT::cotan_laplacian(truth);
  const Matrix mass = IT::mass_matrix(cloud) - IT::mass_matrix(truth);
  for(std::size_t i = 3; i < n - 3; ++i)
    for(std::size_t j = 3; j < n - 3; ++j) {
      const auto column = static_cast<int>(n * i + j);
      EXPECT_LT(Values(error.col(column)).cwiseAbs().maxCoeff(), 1e-11);
      EXPECT_LT(Values(mass.col(column)).cwiseAbs().maxCoeff(), 1e-14);
    }
}

TEST(Local_triangulations, of_a_sphere_have_its_area_and_distances)
{
  const std::vector<Point> points = sphere(1000);
  const auto surface = surface_of_cloud(points, 20);
  EXPECT_NEAR(IT::lumped_mass_matrix(surface).diagonal().sum(), 4 * pi, 0.1);
  const Values distance = IT::heat_distance(surface, std::array{Vertex_index(0)});
  double error = 0, sum = 0;
  for(std::size_t v = 0; v < points.size(); ++v) {
    const double exact =
      2 * std::asin((std::min)(1., std::sqrt(CGAL::squared_distance(points[0], points[v])) / 2));
    error += std::abs(distance[static_cast<Eigen::Index>(v)] - exact);
    sum += exact;
  }
  EXPECT_LT(error, 0.03 * sum);
}

// The first eigenvalues of the sphere are 2, three times, and 6.
TEST(Local_triangulations, have_a_definite_Laplacian)
{
  CGAL::Random random(2);
  std::vector<Point> points = sphere(300);
  for(Point& p : points) // noise
    p = Point(p.x() + random.get_double(-0.02, 0.02), p.y() + random.get_double(-0.02, 0.02),
              p.z() + random.get_double(-0.02, 0.02));
  const auto surface = surface_of_cloud(points, 15);
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> eigen(
    Eigen::MatrixXd(IT::cotan_laplacian(surface)), Eigen::MatrixXd(IT::mass_matrix(surface)),
    Eigen::EigenvaluesOnly);
  EXPECT_NEAR(eigen.eigenvalues()[0], 0, 1e-10);
  for(int i = 1; i < 4; ++i)
    EXPECT_NEAR(eigen.eigenvalues()[i], 2, 0.2);
  EXPECT_NEAR(eigen.eigenvalues()[4], 6, 0.6);
}

TEST(Local_triangulations, take_equal_and_collinear_points)
{
  EXPECT_TRUE(IT::local_triangulations(std::vector<Point>{}, 5).empty());
  EXPECT_TRUE(IT::local_triangulations(std::vector<Point>{{1, 2, 3}}, 5).empty());
  EXPECT_TRUE(IT::local_triangulations(std::vector<Point>(9, Point(1, 2, 3)), 5).empty());
  EXPECT_TRUE(
    IT::local_triangulations(std::vector<Point>{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, 5).empty());
  // The result is one triangle, seen from each corner.
  EXPECT_EQ(IT::local_triangulations(std::vector<Point>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, 5).size(),
            3u);
  std::vector<Point> points = sphere(100);
  points.push_back(points[7]);
  points.push_back(points[7]);
  for(const auto& [a, b, c] : IT::local_triangulations(points, 12)) {
    EXPECT_NE(points[a], points[b]);
    EXPECT_NE(points[b], points[c]);
    EXPECT_NE(points[c], points[a]);
  }
}

TEST(Local_triangulations, take_any_scale)
{
  for(const double scale : {1e-300, 1e-160, 1e160, 1e300}) {
    std::vector<Point> points = sphere(50), scaled;
    for(const Point& p : points)
      scaled.emplace_back(scale * p.x(), scale * p.y(), scale * p.z());
    const auto triangles = IT::local_triangulations(scaled, 10);
    EXPECT_GT(triangles.size(), 150u);
  }
  const double infinite = std::numeric_limits<double>::infinity(), great = 1.7e308;
  EXPECT_THROW(IT::local_triangulations(std::vector<Point>{{0, 0, 0}, {1, infinite, 0}}, 5),
               IT::Invalid_input);
  EXPECT_THROW(
    IT::local_triangulations(std::vector<Point>{{-great, 0, 0}, {great, 0, 0}, {0, great, 0}}, 5),
    IT::Invalid_input);
}

} // namespace Test_local_triangulations

#endif // CGAL_EIGEN3_ENABLED
