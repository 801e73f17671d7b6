// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../Intrinsic_triangulations/known_surfaces.h"
#include "finite_differences.h"

#include <CGAL/Discrete_conformal_maps/Penner_surface.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Peacock_triangulation.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Spherical_energy.h>

#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>

namespace Test_spherical_energy {

using namespace Test_surfaces;
namespace DCM = CGAL::Discrete_conformal_maps;
using Quad = boost::multiprecision::number<boost::multiprecision::cpp_bin_float_quad::backend_type,
                                           boost::multiprecision::et_off>;
using Numbers = Eigen::VectorXd;
using Energy = DCM::internal::Spherical_energy<Quad>;
using Peacock = DCM::internal::Peacock_triangulation<double>;

// Returns intrinsic Delaunay triangulations.
std::vector<Triangulation> spheres()
{
  std::vector<Triangulation> result;
  for(const Mesh& m : {tetrahedron(), octahedron(), cube(), random_sphere(8, 1),
                       random_sphere(20, 2), perturbed(random_sphere(20, 3), 0.3, 4),
                       perturbed(bipyramid(7, 0), 0.2, 2), bipyramid(9, 3)}) {
    result.emplace_back(m);
    IT::make_Delaunay(result.back());
  }
  return result;
}

// Calls f(triangulation, energy, vertex at infinity, point) at points far enough apart for many
// flips.
template <typename Function>
void for_each_point(const Function& f)
{
  for(const Triangulation& t : spheres())
    for(const double bound : {0.5, 3.}) {
      const Vertex_index v(
        static_cast<Delta_complex::size_type>(t.mesh().number_of_vertices() / 2));
      Energy energy(t.mesh(), t.length_map(), v);
      const Numbers u = random_numbers(t.mesh().number_of_vertices(), bound, 17);
      energy.evaluate(u);
      f(t, energy, v, u);
    }
}

void move_origin(Energy& energy) { energy.set_origin(std::vector<Quad>(energy.scale_factors())); }

// Returns the gradient as a function of u, not of the nearest number of type `double`.
std::vector<Quad> precise_gradient(const Energy& energy)
{
  const Delta_complex& mesh = energy.surface().mesh();
  const Quad pi = boost::math::constants::pi<Quad>();
  std::vector<Quad> result(mesh.number_of_vertices(), 2 * pi);
  for(Halfedge_index h : mesh.halfedges()) {
    if(energy.surface().is_remaining(mesh.face(h)))
      result[mesh.source(h)] += pi - energy.angle(h);
    if(energy.surface().is_remaining(mesh.edge(h)))
      result[mesh.source(h)] -= pi;
  }
  result[energy.surface().vertex_at_infinity()] = 0;
  return result;
}

// Computes the shortest lengths from a vertex to all others of geodesics that cross at most `depth`
// edges, from one triangle to the next.
class Geodesics
{
public:
  Geodesics(const Triangulation& t, Vertex_index from, int depth)
    : m_t(t), m_shortest(t.mesh().number_of_vertices(), std::numeric_limits<double>::infinity())
  {
    for(Halfedge_index h : t.mesh().halfedges())
      if(t.mesh().source(h) == from) {
        note(t.mesh().target(h), length(h));
        const Halfedge_index across = t.mesh().next(h);
        extend(across, length(h), length(t.mesh().prev(h)), depth);
      }
  }

  double operator[](std::size_t v) const { return m_shortest[v]; }

private:
  double length(Halfedge_index h) const { return m_t.length(m_t.mesh().edge(h)); }
  void note(Vertex_index v, double x) { m_shortest[v] = (std::min)(m_shortest[v], x); }

  // Extends geodesics. The ends of the edge of `h` are at distances `a` and `b`.
  void extend(Halfedge_index h, double a, double b, int depth)
  {
    if(depth == 0)
      return;
    const Delta_complex& mesh = m_t.mesh();
    const Halfedge_index o = mesh.opposite(h), near_a = mesh.next(o), near_b = mesh.prev(o);
    const double c = (a * length(near_b) + b * length(near_a)) / length(h);
    note(mesh.target(near_a), c);
    extend(near_a, a, c, depth - 1);
    extend(near_b, c, b, depth - 1);
  }

  const Triangulation& m_t;
  std::vector<double> m_shortest;
};

// ---- The peacock triangulation ----

TEST(Peacock_triangulation, joins_all_vertices_to_the_center)
{
  for(const Triangulation& t : spheres())
    for(Vertex_index center : t.mesh().vertices()) {
      const Peacock peacock(t.mesh(), t.length_map(), center);
      const Delta_complex& mesh = peacock.mesh();
      EXPECT_TRUE(IT::is_valid_Delta_complex(mesh));
      std::vector<int> outgoing_halfedges(mesh.number_of_vertices(), 0);
      for(Edge_index e : mesh.edges()) {
        const Vertex_index v = mesh.vertex(e, 0), w = mesh.vertex(e, 1);
        EXPECT_TRUE(v == center || w == center);
        ++outgoing_halfedges[v == center ? w : v];
      }
      for(Vertex_index v : mesh.vertices())
        EXPECT_GE(outgoing_halfedges[v], v == center ? 0 : 1);
    }
}

TEST(Peacock_triangulation, distances_are_those_of_shortest_geodesics)
{
  for(const Triangulation& t : spheres())
    for(Vertex_index center : t.mesh().vertices()) {
      if(center.idx() % 3 != 0)
        continue;
      const auto distance = Peacock(t.mesh(), t.length_map(), center).distances();
      const Geodesics expected(t, center, 12);
      for(Vertex_index v : t.mesh().vertices())
        if(v != center) {
          EXPECT_NEAR(distance[v], 2 * std::log(expected[v]), 1e-12);
        }
    }
}

// Limbs are a hundred times as long as wide. Some edges would have lengths beyond the range of
// numbers if they were flipped in any order.
TEST(Peacock_triangulation, long_surfaces)
{
  const Triangulation t = [] {
    Triangulation result(bipyramid(12, 300));
    IT::make_Delaunay(result);
    return result;
  }();
  const auto distance = Peacock(t.mesh(), t.length_map(), Vertex_index(12)).distances();
  for(Vertex_index v : t.mesh().vertices())
    EXPECT_EQ(std::isfinite(distance[v]), v != Vertex_index(12));
}

// ---- The energy ----

TEST(Spherical_energy, gradient_is_the_derivative_of_the_value)
{
  for_each_point([](const Triangulation&, Energy energy, Vertex_index, const Numbers& u) {
    const Numbers gradient = energy.gradient();
    move_origin(energy);
    const Eigen::MatrixXd slope =
      central_differences(energy, 1e-9, [&] { return std::array{energy.value()}; });
    for(Eigen::Index i = 0; i < u.size(); ++i)
      EXPECT_NEAR(slope(0, i), gradient[i], 1e-13) << i;
  });
}

TEST(Spherical_energy, Hessian_is_the_derivative_of_the_gradient)
{
  for_each_point([](const Triangulation&, Energy energy, Vertex_index, const Numbers& u) {
    const Eigen::MatrixXd Hessian = energy.Hessian();
    EXPECT_LT((Hessian - Hessian.transpose()).norm(), 1e-15 * (1 + Hessian.norm()));
    move_origin(energy);
    const Eigen::MatrixXd slope =
      central_differences(energy, 1e-14, [&] { return precise_gradient(energy); });
    for(Eigen::Index i = 0; i < u.size(); ++i)
      for(Eigen::Index k = 0; k < u.size(); ++k)
        EXPECT_NEAR(slope(k, i), Hessian(k, i), 1e-11 * (1 + Hessian(i, i))) << k << ' ' << i;
  });
}

// The remaining surface is a disk, to which Gauss and Bonnet applies.
TEST(Spherical_energy, gradient_sums_to_a_turn)
{
  for_each_point([](const Triangulation&, const Energy& energy, Vertex_index v, const Numbers&) {
    EXPECT_NEAR(energy.gradient().sum(), 2 * pi, 1e-12);
    EXPECT_EQ(energy.gradient()[int(v)], 0);
  });
}

TEST(Spherical_energy, is_convex_and_continuous_along_segments)
{
  std::size_t flips = 0;
  for(const Triangulation& t : spheres()) {
    DCM::internal::Spherical_energy<double> energy(t.mesh(), t.length_map(), Vertex_index(0));
    const Numbers from = random_numbers(energy.size(), 3, 23),
                  way = random_numbers(energy.size(), 3, 29) - from;
    double slope = -std::numeric_limits<double>::infinity(), integral = 0;
    energy.evaluate(from);
    const double first = energy.value();
    const int steps = 6400;
    for(int i = 0; i <= steps; ++i) {
      energy.evaluate(from + (double(i) / steps) * way);
      const double next = energy.gradient().dot(way);
      EXPECT_GE(next, slope - energy.gradient_error() * way.lpNorm<1>()) << i;
      slope = next;
      integral += next * (i == 0 || i == steps ? 0.5 : 1.) / steps;
    }
    // Slopes behave like roots if edges turn to infinity, so the trapezoid rule has an error of
    // order h^1.5.
    EXPECT_NEAR(energy.value() - first, integral, 1e-3);
    flips += energy.surface().flips().size();
  }
  EXPECT_GT(flips, 100u);
}

// The scale factor at infinity is infinite, whatever value is given.
TEST(Spherical_energy, vertex_at_infinity_has_no_influence)
{
  for_each_point([](const Triangulation&, Energy energy, Vertex_index v, Numbers u) {
    const Numbers gradient = energy.gradient();
    const Quad value = energy.value();
    u[int(v)] += 5;
    energy.evaluate(u);
    EXPECT_EQ(energy.gradient(), gradient);
    EXPECT_EQ(energy.value(), value);
  });
}

TEST(Ptolemy_surface, flips_can_be_replayed)
{
  for(const Triangulation& t : spheres()) {
    const auto surface = flipped_at_random<Quad>(t);
    DCM::internal::Ptolemy_surface<Quad> other(t.mesh(), t.length_map());
    other.replay(surface.flips());
    EXPECT_EQ(other.flips(), surface.flips());
    for(Edge_index e : t.mesh().edges())
      EXPECT_EQ(other.length(e), surface.length(e));
  }
}

TEST(Ptolemy_surface, flips_have_a_limit)
{
  const std::size_t limit = IT::default_flip_limit(30);
  EXPECT_NO_THROW(IT::check_flip_limit(limit - 1, 30));
  EXPECT_THROW(IT::check_flip_limit(limit, 30), IT::Flip_limit_exceeded);
}

TEST(Spherical_energy, does_not_depend_on_the_triangulation)
{
  for(const Triangulation& t : spheres()) {
    const auto surface = flipped_at_random<Quad>(t);
    const Delta_complex& mesh = surface.mesh();
    const auto map = boost::make_function_property_map<Edge_index>(
      [&](Edge_index e) { return surface.length(e); });
    const Numbers u = random_numbers(mesh.number_of_vertices(), 2, 37);
    Energy one(t.mesh(), t.length_map(), Vertex_index(1)), other(mesh, map, Vertex_index(1));
    one.evaluate(u);
    other.evaluate(u);
    EXPECT_LT((one.gradient() - other.gradient()).norm(), 1e-14 * double(u.size()));
    EXPECT_LT(abs(one.value() - other.value()), 1e-26 * double(u.size()));
  }
}

// The result is the limit of finite horocycles: at infinity the scale factor is great enough.
TEST(Spherical_energy, triangulation_is_the_limit_of_those_with_a_horocycle)
{
  for_each_point(
    [](const Triangulation& t, const Energy& energy, Vertex_index v, const Numbers& u) {
      std::vector<Quad> far(energy.scale_factors());
      far[v] = 60;
      DCM::Penner_surface<Quad> surface(t.mesh(), t.length_map());
      surface.scale(far);
      std::vector<double> remaining, expected;
      for(Edge_index e : surface.mesh().edges())
        if(surface.mesh().vertex(e, 0) != v && surface.mesh().vertex(e, 1) != v)
          expected.push_back(double(surface.scaled_length(e)));
      for(Edge_index e : energy.surface().mesh().edges())
        if(energy.surface().is_remaining(e))
          remaining.push_back(double(energy.surface().scaled_length(e)));
      std::sort(remaining.begin(), remaining.end());
      std::sort(expected.begin(), expected.end());
      ASSERT_EQ(remaining.size(), expected.size());
      for(std::size_t i = 0; i < remaining.size(); ++i)
        EXPECT_NEAR(remaining[i], expected[i], 1e-14 * expected[i]);
      EXPECT_EQ(u.size(), Eigen::Index(far.size()));
    });
}

} // namespace Test_spherical_energy
