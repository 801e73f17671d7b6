// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "circles.h"
#include "finite_differences.h"

#include <CGAL/Discrete_conformal_maps/Conformal_energy.h>
#include <CGAL/Discrete_conformal_maps/Newton_minimizer.h>
#include <CGAL/Discrete_conformal_maps/uniformize_hyperbolic.h>

#include <Eigen/Eigenvalues>
#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>

namespace Test_hyperbolic_circles {

using namespace Test_circles;
using DCM::Hyperbolic_conformal_map;
using Number = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>,
                                             boost::multiprecision::et_off>;
using Numbers = Eigen::VectorXd;
template <typename FT>
using Energy = DCM::Hyperbolic_conformal_energy<FT>;

// ---- The energy ----

// Returns the angle defects of triangles of which distances of centers follow from the laws of
// cosines and of inversive distances, in the triangulation of the energy.
std::vector<Number> precise_gradient(const Energy<Number>& energy)
{
  const auto& surface = energy.surface();
  const Delta_complex& mesh = surface.mesh();
  const auto cosh_of = [&](Halfedge_index h) {
    const Number r = surface.scaled_radius(mesh.source(h)),
                 s = surface.scaled_radius(mesh.target(h)), t = surface.scaled_length(mesh.edge(h));
    const Number eta = t * t / 2 + r * s;
    return Number((1 + 4 * eta) / sqrt(Number((1 - 4 * r * r) * (1 - 4 * s * s))));
  };
  std::vector<Number> result(mesh.number_of_vertices(), 2 * boost::math::constants::pi<Number>());
  for(Halfedge_index h : mesh.halfedges()) {
    const Number b = cosh_of(h), c = cosh_of(mesh.prev(h)), a = cosh_of(mesh.next(h));
    result[mesh.source(h)] -= acos(Number((b * c - a) / sqrt(Number((b * b - 1) * (c * c - 1)))));
  }
  return result;
}

std::vector<Named_triangulation> small_surfaces()
{
  std::vector<Named_triangulation> result;
  for(const Named_triangulation& s : closed_surfaces())
    if(s.triangulation.mesh().number_of_vertices() <= 12)
      result.push_back(s);
  return result;
}

// Moves inside of the domain, in which hyperbolic tangents of halves of radii are less than one.
Numbers random_variables(const Radii& radii, double scale, unsigned int seed)
{
  Numbers result = random_numbers(radii.size(), 1, seed);
  for(std::size_t v = 0; v < radii.size(); ++v)
    if(radii[v] > 0)
      result[int(v)] = (std::min)(result[int(v)], std::log(0.8 / (scale * radii[v])));
  return result;
}

// Lengths sinh(x/2) between centers of circles need not satisfy the triangle inequality, although
// the sides x do. Sides here follow from two of them and their angle.
TEST(Hyperbolic_circles, have_centers_with_any_hyperbolic_triangle)
{
  std::size_t count = 0;
  for(const double b : {1e-3, 0.1, 1., 4., 12.})
    for(const double c : {1e-3, 0.3, 1., 5., 12.})
      for(const double angle : {1e-3, 1., 2., 3., 3.14}) {
        const Number x = b, y = c, phi = angle,
                     cosh_a = cosh(x) * cosh(y) - sinh(x) * sinh(y) * cos(phi);
        const std::array<Number, 3> l{sinh(Number(x / 2)), sinh(Number(y / 2)),
                                      sqrt(Number((cosh_a - 1) / 2))};
        const DCM::internal::Hyperbolic_triangle<Number> triangle({l[0], l[2], l[1]});
        EXPECT_NEAR(double(triangle.angle(0) - phi), 0, 1e-30) << b << ' ' << c << ' ' << angle;
        const Number cosh_b = cosh(x), cosh_c = cosh(y);
        const auto opposite = [](const Number& p, const Number& q, const Number& r) {
          return acos(Number((q * r - p) / sqrt(Number((q * q - 1) * (r * r - 1)))));
        };
        EXPECT_NEAR(double(triangle.angle(1) - opposite(cosh_c, cosh_a, cosh_b)), 0, 1e-30);
        EXPECT_NEAR(double(triangle.angle(2) - opposite(cosh_b, cosh_a, cosh_c)), 0, 1e-30);
        count += l[2] > l[0] + l[1];
      }
  EXPECT_GT(count, 30u);
}

TEST(Hyperbolic_circles, have_the_angles_and_derivatives_of_fifty_digits)
{
  for(const Named_triangulation& s : traced(small_surfaces()))
    for(const double scale : {0.01, 0.3}) {
      const Radii radii = random_radii(s.triangulation, 0.95, 3);
      auto energy = energy_of<Energy<Number>>(s.triangulation, radii, scale);
      const Numbers w = random_variables(radii, scale, 17);
      energy.evaluate(w);
      const std::vector<Number> gradient = precise_gradient(energy);
      for(std::size_t v = 0; v < radii.size(); ++v) {
        const Vertex_index vertex{Delta_complex::size_type(v)};
        if(!energy.surface().mesh().is_isolated(vertex)) {
          EXPECT_NEAR(energy.gradient()[int(v)], double(gradient[v]), 1e-12);
        }
        // These are the radii before and after scaling.
        const Number r = Number(scale) * Number(radii[v]), t = r * exp(Number(w[int(v)]));
        EXPECT_NEAR(double(energy.surface().scaled_radius(vertex) - t / (1 + t * t)), 0, 1e-40);
      }
      const Eigen::MatrixXd Hessian = energy.Hessian();
      EXPECT_LT((Hessian - Hessian.transpose()).norm(), 1e-13 * (1 + Hessian.norm()));
      EXPECT_GT(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(Hessian).eigenvalues().minCoeff(),
                0);
      energy.move_origin();
      const Eigen::MatrixXd slope =
        central_differences(energy, 1e-12, [&] { return precise_gradient(energy); });
      for(Eigen::Index i = 0; i < w.size(); ++i)
        for(Eigen::Index k = 0; k < w.size(); ++k)
          EXPECT_NEAR(slope(k, i), Hessian(k, i), 1e-10 * (1 + Hessian(i, i))) << k << ' ' << i;
    }
}

TEST(Hyperbolic_circles, end_where_a_circle_is_a_half_plane)
{
  const Triangulation t(octahedron());
  const Radii radii(6, t.length(Edge_index(0)) / 3);
  auto energy = energy_of<Energy<double>>(t, radii, 1);
  energy.evaluate(Numbers::Constant(6, -std::log(radii[0]) - 1e-3));
  EXPECT_TRUE(energy.gradient().allFinite());
  energy.evaluate(Numbers::Constant(6, -std::log(radii[0])));
  EXPECT_TRUE(energy.gradient().array().isNaN().any());
}

TEST(Hyperbolic_circles, do_not_depend_on_where_the_search_starts)
{
  for(const int genus : {2, 3})
    for(unsigned int surface = 1; surface <= 3; ++surface) {
      const Triangulation t(perturbed(plate_with_holes(genus), 0.05, surface));
      const Radii radii = random_radii(t, 1, surface);
      Numbers first;
      for(unsigned int seed = 1; seed <= 5; ++seed) {
        auto energy = energy_of<Energy<double>>(t, radii, 0.1);
        Numbers w = random_variables(radii, 0.1, seed);
        DCM::Default_minimization_visitor visitor;
        const auto result =
          DCM::Newton_minimizer(1e-11)(energy, w, DCM::Minimization_domain(), visitor);
        EXPECT_EQ(result.status, DCM::Minimization_status::converged);
        if(seed == 1)
          first = w;
        EXPECT_LT((w - first).lpNorm<Eigen::Infinity>(), 1e-9);
      }
    }
}

// ---- Maps ----

Hyperbolic_conformal_map decorated(const Triangulation& t, const Radii& radii)
{
  const std::vector<double> length = lengths_of(t);
  return DCM::uniformize_hyperbolic(t.mesh(),
                                    length_parameter(length).vertex_radius_map(as_radii(radii)));
}

double cosh_of_distance(const std::array<double, 3>& p, const std::array<double, 3>& q)
{
  return p[2] * q[2] - p[0] * q[0] - p[1] * q[1];
}

// Returns the angle at p, from positions on the hyperboloid.
double angle(const std::array<double, 3>& p, const std::array<double, 3>& q,
             const std::array<double, 3>& r)
{
  const double a = cosh_of_distance(q, r), b = cosh_of_distance(p, q), c = cosh_of_distance(p, r);
  return std::acos((b * c - a) / std::sqrt((b * b - 1) * (c * c - 1)));
}

void check_curvatures(const Hyperbolic_conformal_map& map)
{
  const Delta_complex& mesh = map.ideal().mesh();
  std::vector<double> sum(mesh.number_of_vertices(), 0);
  double area = 0;
  for(Halfedge_index h : mesh.halfedges()) {
    const auto at = [&](Halfedge_index x) { return map.hyperboloid_position(x); };
    const double a = angle(at(h), at(mesh.next(h)), at(mesh.prev(h)));
    sum[mesh.source(h)] += a;
    area += pi / 3 - a;
  }
  for(Vertex_index v : mesh.vertices())
    EXPECT_NEAR(sum[v], 2 * pi, 1e-6) << v; // positions far away have few digits
  EXPECT_NEAR(area, map.group(0).area, 1e-5);
}

// Checks that edges of the input that have not been flipped have the inversive distances of the
// input.
std::size_t check_inversive_distances(const Hyperbolic_conformal_map& map, const Radii& radii)
{
  const Delta_complex& mesh = map.ideal().mesh();
  std::size_t result = 0;
  for(Halfedge_index h : mesh.halfedges()) {
    const Edge_index e = mesh.edge(h);
    if(!map.ideal().coordinates().is_shared(e))
      continue;
    const Edge_index b = Edge_index(map.ideal().input_halfedge(h));
    const double r = radii[map.input_vertex(mesh.source(h))],
                 s = radii[map.input_vertex(mesh.target(h))];
    if(r * s == 0 || !map.Delaunay().coordinates().is_shared(b))
      continue;
    const double length = map.Delaunay().length(b),
                 before = (length * length - r * r - s * s) / (2 * r * s),
                 x = map.circle_radius(mesh.source(h)), y = map.circle_radius(mesh.target(h)),
                 distance = map.length(e),
                 after = (std::cosh(distance) - std::cosh(x) * std::cosh(y)) /
                         (std::sinh(x) * std::sinh(y));
    EXPECT_NEAR(after / before, 1, 1e-8) << e;
    EXPECT_NEAR(
      cosh_of_distance(map.hyperboloid_position(h), map.hyperboloid_position(mesh.next(h))) /
        std::cosh(distance),
      1, 1e-6);
    ++result;
  }
  return result;
}

// Checks that the map is projective on each face of the subdivision, and continuous across its
// edges.
void check_continuity(const Hyperbolic_conformal_map& map)
{
  const auto& subdivision = map.subdivision();
  const auto& mesh = subdivision.mesh();
  const auto image = [&](Halfedge_index h) {
    return Hyperbolic_conformal_map::to_disk(
      map.homogeneous_coordinates(subdivision.location(DCM::Layer::C, h)));
  };
  for(Edge_index e : mesh.edges())
    if(const Edge_index c = subdivision.parent_edge(DCM::Layer::C, e);
       !c.is_valid() || !map.is_seam(c)) {
      const Halfedge_index h = mesh.halfedge(e), o = mesh.opposite(h);
      EXPECT_LT(std::abs(image(h) - image(mesh.prev(o))), 1e-13 * std::exp(map.radius())) << e;
    }
}

TEST(Hyperbolic_circles, have_the_curvatures_and_inversive_distances)
{
  std::size_t distances = 0;
  for(const int genus : {2, 3})
    for(const double part : {0.5, 1.}) {
      const Triangulation t(plate_with_holes(genus));
      const Radii radii = random_radii(t, part, 7);
      const Hyperbolic_conformal_map map = decorated(t, radii);
      EXPECT_EQ(map.status(), DCM::Map_status::success);
      EXPECT_LT(map.max_curvature_error(), 1e-10);
      EXPECT_TRUE(map.has_radii());
      EXPECT_TRUE(map.ideal().is_valid());
      EXPECT_NEAR(map.area(), 4 * pi * (genus - 1), 1e-9); // Gauss and Bonnet
      EXPECT_GT(map.number_of_flips(DCM::Layer::C), 0u);
      check_curvatures(map);
      check_continuity(map);
      distances += check_inversive_distances(map, radii);
    }
  EXPECT_GT(distances, 100u);
}

TEST(Hyperbolic_circles, with_radii_of_zero_are_none)
{
  const Triangulation t(plate_with_holes(2));
  const std::size_t n = t.mesh().number_of_vertices();
  const Hyperbolic_conformal_map zero = decorated(t, Radii(n, 0.)),
                                 none = DCM::uniformize_hyperbolic(t.mesh(),
                                                                   length_parameter(lengths_of(t)));
  EXPECT_FALSE(zero.has_radii());
  for(Vertex_index v : t.mesh().vertices())
    EXPECT_EQ(zero.log_scale(v), none.log_scale(v));
  for(Halfedge_index h : zero.ideal().mesh().halfedges())
    EXPECT_EQ(zero.hyperboloid_position(h), none.hyperboloid_position(h));
  // Small circles make a difference of second order.
  double before = 0;
  for(const double part : {1e-2, 1e-3, 1e-4}) {
    const Hyperbolic_conformal_map map = decorated(t, random_radii(t, part, 11));
    double difference = 0;
    for(Vertex_index v : t.mesh().vertices())
      difference = (std::max)(difference, std::abs(map.log_scale(v) - none.log_scale(v)));
    if(before > 0) {
      EXPECT_NEAR(difference / before, 0.01, 0.002);
    }
    before = difference;
  }
}

TEST(Hyperbolic_circles, may_have_boundaries_cones_and_prescribed_radii)
{
  const Triangulation t(octahedron());
  const double length = t.length(Edge_index(0));
  const std::vector<double> lengths = lengths_of(t);
  const Radii radii(6, length / 2); // they touch
  const auto with = [&](const Conditions& conditions) {
    return DCM::uniformize_hyperbolic(t.mesh(),
                                      length_parameter(lengths)
                                        .vertex_condition_map(Test_surfaces::as_map(conditions))
                                        .vertex_radius_map(as_radii(radii)));
  };
  // By symmetry, equal circles touch, with eight regular triangles of angle alpha.
  const double alpha = pi / 5;
  const Hyperbolic_conformal_map map =
    with(Conditions(6, Vertex_condition::curvature(2 * pi - 4 * alpha)));
  EXPECT_EQ(map.status(), DCM::Map_status::success);
  const double side = 2 * std::acosh(1 / (2 * std::sin(alpha / 2)));
  for(Vertex_index v : t.mesh().vertices())
    EXPECT_NEAR(map.circle_radius(v), side / 2, 1e-10);
  // A prescribed factor is kept.
  Conditions conditions(6, Vertex_condition::curvature(5));
  const double u = std::log(std::tanh(0.7) / length);
  conditions[3] = Vertex_condition::log_scale(u);
  const Hyperbolic_conformal_map fixed = with(conditions);
  EXPECT_EQ(fixed.status(), DCM::Map_status::success);
  EXPECT_NEAR(fixed.log_scale(Vertex_index(3)), u, 1e-12);
  EXPECT_NEAR(fixed.circle_radius(Vertex_index(3)), 0.7, 1e-12);
  conditions[3] = Vertex_condition::log_scale(u + 1);
  EXPECT_THROW(with(conditions), IT::Invalid_input);
}

} // namespace Test_hyperbolic_circles
