// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "generators.h"

#include <CGAL/Intrinsic_triangulations/Correspondence.h>
#include <CGAL/Intrinsic_triangulations/curve_across.h>
#include <CGAL/Intrinsic_triangulations/level_set.h>
#include <CGAL/Intrinsic_triangulations/make_Delaunay.h>

namespace Test_level_set {

using namespace Test_surfaces;
using Triangulation = IT::Intrinsic_triangulation<>;
using Curve = IT::Surface_path<double>;

std::vector<double> random_values(std::size_t n, unsigned int seed)
{
  CGAL::Random random(seed);
  std::vector<double> result(n);
  for(double& x : result)
    x = random.get_int(0, 8) / 8. + (seed % 2 == 0 ? random.get_double() : 0);
  return result;
}

double value_at(const IT::Face_location<double>& p, const std::vector<double>& values,
                const Delta_complex& mesh)
{
  const auto h = IT::sides(p.first, mesh);
  double result = 0;
  for(std::size_t c = 0; c < 3; ++c)
    result += p.second[c] * values[mesh.source(h[c])];
  return result;
}

// Checks that a curve meets every edge between a vertex above and one below exactly once. The curve
// is closed or ends at the boundary, and has greater values on its left.
void expect_level_set(const std::vector<Curve>& curves, const Delta_complex& mesh,
                      const std::vector<double>& values, double level)
{
  std::set<Edge_index> met;
  for(const Curve& curve : curves) {
    const bool is_closed = !mesh.is_border(mesh.opposite(IT::halfedge_of(curve.places.front())));
    ASSERT_GE(curve.places.size(), 2u);
    EXPECT_EQ(is_closed,
              IT::halfedge_of(curve.places.front()) == IT::halfedge_of(curve.places.back()));
    EXPECT_EQ(!is_closed, mesh.is_border(IT::halfedge_of(curve.places.back())));
    for(std::size_t i = 0; i + (is_closed ? 1 : 0) < curve.places.size(); ++i) {
      const IT::Halfedge_index h = IT::halfedge_of(curve.places[i]);
      EXPECT_TRUE(met.insert(mesh.edge(h)).second);
      EXPECT_GE(values[mesh.source(h)], level);
      EXPECT_LT(values[mesh.target(h)], level);
      EXPECT_NEAR(value_at(IT::face_location(curve.places[i], mesh), values, mesh), level, 1e-14);
    }
  }
  std::size_t mixed = 0;
  for(Edge_index e : mesh.edges())
    mixed += (values[mesh.vertex(e, 0)] >= level) != (values[mesh.vertex(e, 1)] >= level);
  EXPECT_EQ(met.size(), mixed);
}

TEST(Level_set, all_surfaces)
{
  for(const auto& [c, seed] : traced(complexes(), 10)) {
    const auto lengths = random_lengths(c.mesh, seed);
    const auto t = triangulation(c.mesh, lengths);
    const auto values = random_values(t.mesh().number_of_vertices(), seed);
    for(const double level : {-1., 0., 0.25, 0.5, 0.77, 1., 3.})
      expect_level_set(IT::level_set(t, values, level), t.mesh(), values, level);
  }
}

double length_of_gradient(const Triangulation& t, Face_index f, const std::vector<double>& values)
{
  const auto h = IT::sides(f, t.mesh());
  const double a = t.length(t.mesh().edge(h[0])), b = t.length(t.mesh().edge(h[1])),
               c = t.length(t.mesh().edge(h[2])), x = (a * a + c * c - b * b) / (2 * a),
               y = std::sqrt(c * c - x * x), p = values[t.mesh().source(h[0])],
               along = (values[t.mesh().target(h[0])] - p) / a,
               across = (values[t.mesh().target(h[1])] - p - along * x) / y;
  return std::hypot(along, across) * a * y / 2;
}

// The lengths of all level sets integrate to the length of the gradient (coarea formula). Between
// values at vertices they are linear in the level.
TEST(Level_set, lengths)
{
  for(const Named_mesh& m : traced(meshes())) {
    const Triangulation t(m.mesh);
    auto values = random_values(t.mesh().number_of_vertices(), 2);
    double expected = 0, sum = 0;
    for(Face_index f : t.mesh().faces())
      expected += length_of_gradient(t, f, values);
    auto sorted = values;
    std::sort(sorted.begin(), sorted.end());
    for(std::size_t i = 1; i < sorted.size(); ++i)
      for(const Curve& curve : IT::level_set(t, values, (sorted[i - 1] + sorted[i]) / 2))
        sum += curve.length * (sorted[i] - sorted[i - 1]);
    EXPECT_NEAR(sum, expected, 1e-12 * expected);
  }
}

// Curves on the intrinsic triangulation are mapped to the input with their lengths.
TEST(Level_set, across)
{
  for(const Named_mesh& m : traced(meshes())) {
    Triangulation t(m.mesh);
    IT::make_Delaunay(t);
    const IT::Correspondence correspondence(t);
    const auto values = random_values(t.mesh().number_of_vertices(), 4);
    for(const Curve& path : IT::level_set(t, values, 0.9)) {
      const auto curve = IT::curve_through(t, path.places);
      EXPECT_NEAR(IT::curve_length(t, curve), path.length, 1e-12 * path.length);
      const auto on_input = IT::curve_across(correspondence, IT::Side::intrinsic, curve);
      EXPECT_NEAR(IT::curve_length(t.input(), on_input), path.length, 1e-9 * path.length);
    }
  }
}

} // namespace Test_level_set
