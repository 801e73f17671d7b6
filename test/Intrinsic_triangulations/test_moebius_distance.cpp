// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "testing.h"

#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/make_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/signed_heat_distance.h>
#include <CGAL/Intrinsic_triangulations/tufted_cover.h>

// These tests compute the signed distance on a one-sided band by its cover.

namespace Test_moebius_distance {

namespace IT = CGAL::Intrinsic_triangulations;
using Test_surfaces::traced;
typedef std::array<double, 2> Place;
typedef IT::Surface_curve<double> Curve;

double orientation(const std::array<Place, 3>& p)
{
  return (p[1][0] - p[0][0]) * (p[2][1] - p[0][1]) - (p[2][0] - p[0][0]) * (p[1][1] - p[0][1]);
}

// Represents a flat Moebius band of length 3 and width 2, whose triangles are oriented at random.
class Band
{
public:
  Band(std::size_t n, unsigned int seed) : m_columns(3 * n / 2), m_rows(n), m_random(seed)
  {
    for(std::size_t i = 0; i < m_columns; ++i)
      for(std::size_t j = 0; j <= m_rows; ++j) {
        const bool is_border = j == 0 || j == m_rows;
        m_places.push_back(
          {edge() * (double(i) + shift()), edge() * (double(j) + (is_border ? 0 : shift())) - 1});
      }
    for(std::size_t i = 0; i < m_columns; ++i)
      for(std::size_t j = 0; j < m_rows; ++j) {
        add({i, j}, {i + 1, j}, {i + 1, j + 1});
        add({i, j}, {i + 1, j + 1}, {i, j + 1});
      }
  }

  double edge() const { return 2 / double(m_rows); }
  std::size_t number_of_vertices() const { return m_places.size(); }
  const std::vector<std::array<std::size_t, 3>>& triangles() const { return m_triangles; }
  const std::array<Place, 3>& places(std::size_t t) const { return m_corners[t]; }
  double height(std::size_t v) const { return std::abs(m_places[v][1]); }

  std::vector<std::array<double, 3>> lengths() const
  {
    std::vector<std::array<double, 3>> result;
    for(const auto& p : m_corners) {
      const auto length = [&](std::size_t i) {
        const Place &a = p[i], &b = p[(i + 1) % 3];
        // The length is bitwise equal for both triangles at an edge, also beyond the seam.
        return double(float(std::hypot(a[0] - b[0], a[1] - b[1])));
      };
      result.push_back({length(0), length(1), length(2)});
    }
    return result;
  }

private:
  typedef std::pair<std::size_t, std::size_t> Node;

  double shift() { return m_random.get_double(-0.25, 0.25); }

  std::size_t vertex(const Node& x) const
  {
    return x.first == m_columns ? m_rows - x.second : x.first * (m_rows + 1) + x.second;
  }

  Place place(const Node& x) const
  {
    const Place& p = m_places[vertex(x)];
    return x.first == m_columns ? Place{p[0] + 3, -p[1]} : p;
  }

  void add(const Node& a, Node b, Node c)
  {
    if(m_random.get_bool())
      std::swap(b, c);
    m_triangles.push_back({vertex(a), vertex(b), vertex(c)});
    m_corners.push_back({place(a), place(b), place(c)});
  }

  std::size_t m_columns, m_rows;
  CGAL::Random m_random;
  std::vector<Place> m_places;
  std::vector<std::array<std::size_t, 3>> m_triangles;
  std::vector<std::array<Place, 3>> m_corners;
};

// Returns the part in a triangle of the line at height `y`, from the left to the right or back, as
// weights of its corners.
bool crossing(const std::array<Place, 3>& p, double y, bool is_to_the_right,
              std::array<std::array<double, 3>, 2>& ends)
{
  std::vector<std::pair<double, std::array<double, 3>>> points;
  for(std::size_t i = 0; i < 3; ++i) {
    const std::size_t k = (i + 1) % 3;
    if((p[i][1] < y) == (p[k][1] < y))
      continue;
    const double t = (y - p[i][1]) / (p[k][1] - p[i][1]);
    std::array<double, 3> weights{};
    weights[i] = 1 - t;
    weights[k] = t;
    points.push_back({(1 - t) * p[i][0] + t * p[k][0], weights});
  }
  if(points.empty())
    return false;
  if((points[0].first < points[1].first) != is_to_the_right)
    std::swap(points[0], points[1]);
  ends = {points[0].second, points[1].second};
  return true;
}

// Returns the line at a distance from the center line, which leads around twice, on both sides of
// the band. The center line is on its left.
template <typename Cover>
Curve line(const Band& band, const Cover& cover, const IT::Delta_complex& mesh, double distance)
{
  Curve result;
  for(IT::Face_index f : mesh.faces())
    for(const double y : {distance, -distance}) {
      const auto& places = band.places(cover.input_face(f));
      const bool is_turned = (orientation(places) < 0) != cover.is_back(f);
      std::array<std::array<double, 3>, 2> ends;
      if(!crossing(places, y, (y < 0) != is_turned, ends))
        continue;
      std::array<std::array<double, 3>, 2> on_cover;
      const auto side = IT::sides(f, mesh);
      for(std::size_t k = 0; k < 3; ++k) {
        const std::size_t i = cover.input_side(side[k]).second,
                          corner = cover.is_back(f) ? (i + 1) % 3 : i;
        for(std::size_t e = 0; e < 2; ++e)
          on_cover[e][k] = ends[e][corner];
      }
      result.push_back({f, on_cover[0], on_cover[1]});
    }
  return result;
}

TEST(Signed_heat_distance, moebius_band)
{
  constexpr double distance = 0.37;
  for(const unsigned int seed : traced({1u, 2u, 3u}))
    for(const std::size_t n : traced({16u, 32u, 64u})) {
      const Band band(n, seed);
      const auto cover = IT::tufted_cover(band.number_of_vertices(), band.triangles());
      const auto lengths = band.lengths();
      const IT::Intrinsic_triangulation<> t(
        cover.mesh(), IT::parameters::edge_length_map(cover.edge_length_map(lengths)));
      const Curve curve = line(band, cover, t.mesh(), distance);
      EXPECT_NEAR(IT::curve_length(t.input(), curve), 2 * 6, 1e-5);
      const auto computed = IT::signed_heat_distance(t.input(), curve);
      double sum = 0, greatest = 0;
      for(IT::Vertex_index v : t.mesh().vertices()) {
        const double error =
          std::abs(computed[v.idx()] - (band.height(cover.input_vertex(v)) - distance));
        sum += error;
        greatest = (std::max)(greatest, error);
      }
      EXPECT_LT(sum / double(t.mesh().number_of_vertices()), 0.1 * band.edge());
      EXPECT_LT(greatest, band.edge());
    }
}

} // namespace Test_moebius_distance
