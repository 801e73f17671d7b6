// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The rectangle of a chart is compared with the rectangles along all lines through two of its
// points, one of them the smallest.

#include "../Intrinsic_triangulations/testing.h"

#include <CGAL/Discrete_conformal_maps/internal/layout/Chart_packing.h>

namespace Test_chart_packing {

namespace DCM = CGAL::Discrete_conformal_maps;
using Complex = std::complex<double>;

// Returns two opposite corners of the smallest box that contains the points.
template <typename Motion>
std::pair<Complex, Complex> box(const std::vector<Complex>& points, const Motion& motion)
{
  const double infinity = std::numeric_limits<double>::infinity();
  Complex low(infinity, infinity), high = -low;
  for(const Complex& p : points) {
    const Complex z = motion(p);
    low = {(std::min)(low.real(), z.real()), (std::min)(low.imag(), z.imag())};
    high = {(std::max)(high.real(), z.real()), (std::max)(high.imag(), z.imag())};
  }
  return {low, high};
}

double smallest_area(const std::vector<Complex>& points)
{
  double result = std::numeric_limits<double>::infinity();
  for(const Complex& p : points)
    for(const Complex& q : points)
      if(p != q) {
        const Complex turn = std::conj(q - p) / std::abs(q - p);
        const auto [low, high] = box(points, [&](const Complex& z) { return turn * z; });
        result = (std::min)(result, (high.real() - low.real()) * (high.imag() - low.imag()));
      }
  return result;
}

DCM::internal::Hull_points chart_of(const std::vector<Complex>& points)
{
  DCM::internal::Hull_points result;
  for(const Complex& p : points)
    result.add(p);
  return result;
}

TEST(Chart_packing, lays_a_chart_on_the_longer_side_of_its_smallest_rectangle)
{
  CGAL::Random random(1);
  for(int trial = 0; trial < 2000; ++trial) {
    // Points are on a grid, in a disk, or in a narrow strip.
    std::vector<Complex> points;
    const int number = random.get_int(3, 14);
    for(int i = 0; i < number; ++i)
      if(trial % 3 == 0)
        points.emplace_back(random.get_int(0, 4), random.get_int(0, 4));
      else
        points.emplace_back(random.get_double(-1, 1),
                            random.get_double(-1, 1) * (trial % 3 == 1 ? 1 : 1e-6));
    const DCM::internal::Chart_packing packing({chart_of(points)});
    const auto [low, high] = box(points, packing.motion(0));
    EXPECT_NEAR(std::abs(packing.motion(0).turn), 1, 1e-15);
    EXPECT_NEAR(std::abs(low), 0, 1e-14);
    EXPECT_GE(high.real(), high.imag() - 1e-14);
    if(const double area = smallest_area(points); area > 1e-9) {
      EXPECT_NEAR(high.real() * high.imag() / area, 1, 1e-9);
    }
  }
}

// Most points are dropped, but no corner of the hull: no direction has a point farther away.
TEST(Chart_packing, keeps_the_hull_of_many_points)
{
  CGAL::Random random(2);
  for(int trial = 0; trial < 12; ++trial) {
    std::vector<Complex> points;
    for(int i = 0; i < 20000; ++i) // in a disk, in a square, on a segment, or all in one place
      points.push_back(trial % 4 == 0 ? std::polar(random.get_double(0, 1), random.get_double(0, 7))
                       : trial % 4 == 1
                         ? Complex(random.get_double(-1, 1), random.get_double(-1, 1))
                       : trial % 4 == 2 ? Complex(random.get_double(-1, 1), 0)
                                        : Complex(1, 2));
    const std::vector<Complex> kept = chart_of(points).points();
    EXPECT_LT(kept.size(), points.size() / 4);
    for(int k = 0; k < 100; ++k) {
      const Complex turn = std::polar(1., random.get_double(0, 7));
      const auto motion = [&](const Complex& z) { return turn * z; };
      const auto [low, high] = box(points, motion);
      EXPECT_NEAR(std::abs(box(kept, motion).first - low), 0, 1e-15);
      EXPECT_NEAR(std::abs(box(kept, motion).second - high), 0, 1e-15);
    }
  }
}

// All points are on the hull, so none may be lost.
TEST(Chart_packing, keeps_all_points_in_convex_position)
{
  std::vector<Complex> points;
  for(int i = 0; i < 5000; ++i)
    points.emplace_back(i, double(i) * i);
  EXPECT_EQ(chart_of(points).points().size(), points.size());
}

} // namespace Test_chart_packing
