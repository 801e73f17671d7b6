// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../Intrinsic_triangulations/more_generators.h"
#include "circles.h"
#include "finite_differences.h"

#include <CGAL/Discrete_conformal_maps/certify.h>
#include <CGAL/Discrete_conformal_maps/charts.h>
#include <CGAL/Discrete_conformal_maps/cross_ratios.h>
#include <CGAL/Discrete_conformal_maps/flatten_to_disk.h>
#include <CGAL/Discrete_conformal_maps/flatten_to_rectangle.h>
#include <CGAL/Intrinsic_triangulations/weighted_laplacian.h>

#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>

namespace Test_decorated_maps {

using namespace Test_circles;
using Quad = boost::multiprecision::number<boost::multiprecision::cpp_bin_float_quad::backend_type,
                                           boost::multiprecision::et_off>;
using Numbers = Eigen::VectorXd;

// ---- The energy ----

std::vector<Quad> precise_gradient(const DCM::Conformal_energy<Quad>& energy)
{
  const Delta_complex& mesh = energy.surface().mesh();
  std::vector<Quad> result(mesh.number_of_vertices(), 2 * boost::math::constants::pi<Quad>());
  for(Vertex_index v : mesh.vertices())
    if(mesh.is_isolated(v))
      result[v] = 0;
  for(Halfedge_index h : mesh.halfedges())
    result[mesh.source(h)] -= energy.angle(h);
  return result;
}

TEST(Decorated_energy, Hessian_is_the_derivative_of_the_gradient)
{
  for(const Named_triangulation& s : traced(closed_surfaces()))
    for(const double bound : {0., 2.}) {
      if(s.triangulation.mesh().number_of_vertices() > 12)
        continue;
      auto energy = energy_of<DCM::Conformal_energy<Quad>>(s.triangulation,
                                                           random_radii(s.triangulation, 0.9, 3));
      const Numbers u = random_numbers(energy.size(), bound, 17);
      energy.evaluate(u);
      const Eigen::MatrixXd Hessian = energy.Hessian();
      EXPECT_LT((Hessian - Hessian.transpose()).norm(), 1e-13 * (1 + Hessian.norm()));
      EXPECT_LT((Hessian * Numbers::Ones(u.size())).norm(), 1e-13 * (1 + Hessian.norm()));
      energy.move_origin();
      const Eigen::MatrixXd slope =
        central_differences(energy, 1e-12, [&] { return precise_gradient(energy); });
      for(Eigen::Index i = 0; i < u.size(); ++i)
        for(Eigen::Index k = 0; k < u.size(); ++k)
          EXPECT_NEAR(slope(k, i), Hessian(k, i), 1e-10 * (1 + Hessian(i, i))) << k << ' ' << i;
    }
}

TEST(Decorated_energy, scaled_triangles_are_weighted_Delaunay)
{
  for(const Named_triangulation& s : traced(closed_surfaces())) {
    auto energy = energy_of<DCM::Conformal_energy<double>>(s.triangulation,
                                                           random_radii(s.triangulation, 1, 5));
    energy.evaluate(random_numbers(energy.size(), 2, 19));
    EXPECT_EQ(energy.number_of_flat_faces(), 0u);
    // The Hessian is the Laplacian of the scaled surface, by independent formulas.
    const auto& surface = energy.surface();
    std::vector<double> length;
    for(Edge_index e : surface.mesh().edges())
      length.push_back(surface.scaled_decorated_length(surface.mesh().halfedge(e)).length());
    const Triangulation scaled = triangulation(surface.mesh(), length);
    const auto weight = boost::make_function_property_map<Vertex_index>(
      [&](Vertex_index v) { return surface.scaled_radius(v) * surface.scaled_radius(v); });
    for(Edge_index e : scaled.mesh().edges())
      EXPECT_GE(IT::dual_edge_length(e, scaled.intrinsic(), weight), -1e-10 * scaled.length(e));
    const Eigen::MatrixXd laplacian = IT::weighted_laplacian(scaled.intrinsic(), weight),
                          Hessian = energy.Hessian();
    EXPECT_LT((laplacian - Hessian).norm(), 1e-9 * (1 + Hessian.norm()));
  }
}

// ---- Maps ----

Planar_conformal_map decorated(const Triangulation& t, const Radii& radii)
{
  const std::vector<double> length = lengths_of(t);
  return DCM::flatten(t.mesh(), length_parameter(length).vertex_radius_map(as_radii(radii)));
}

std::vector<Named_triangulation> all_surfaces()
{
  std::vector<Named_triangulation> result;
  for(const Named_mesh& m : meshes())
    result.push_back({m.name, Triangulation(m.mesh)});
  result.push_back({"random sphere", Triangulation(random_sphere(300, 4))});
  return result;
}

// Checks the curvatures of the image, by the cosine law from distances of centers in the plane.
void check_curvatures(const Planar_conformal_map& map)
{
  const Delta_complex& mesh = mesh_C(map);
  const Used_faces is_used = used_faces(map);
  std::vector<double> angle(mesh.number_of_vertices(), 0);
  std::vector<char> is_whole(mesh.number_of_vertices(), 1);
  for(Halfedge_index h : mesh.halfedges())
    if(is_used[mesh.face(h)]) {
      const auto z = map.position(h);
      angle[mesh.source(h)] +=
        std::arg((map.position(mesh.prev(h)) - z) / (map.position(mesh.next(h)) - z));
    } else
      is_whole[mesh.source(h)] = 0;
  const std::set<Vertex_index> cones(map.cones().begin(), map.cones().end());
  for(Vertex_index v : mesh.vertices())
    if(is_whole[v] && !mesh.is_isolated(v) && map.input_vertex(v) == v &&
       !map.Delaunay().input_mesh().is_border(v) && cones.count(v) == 0) {
      EXPECT_NEAR(angle[v], 2 * pi, 1e-9) << v;
    }
}

// Checks that edges of the input that have not been flipped have the inversive distances of the
// input.
std::size_t check_inversive_distances(const Planar_conformal_map& map, const Radii& radii)
{
  const Delta_complex& mesh = mesh_C(map);
  std::size_t result = 0;
  for(Halfedge_index h : mesh.halfedges()) {
    const Edge_index e = mesh.edge(h);
    if(!map.is_laid_out(mesh.face(h)) || !map.ideal().coordinates().is_shared(e))
      continue;
    const Edge_index b = Edge_index(map.ideal().input_halfedge(h));
    if(!map.Delaunay().coordinates().is_shared(b))
      continue;
    const double r = radii[map.input_vertex(mesh.source(h))],
                 s = radii[map.input_vertex(mesh.target(h))];
    if(r * s == 0)
      continue;
    const double length = map.Delaunay().length(b),
                 before = (length * length - r * r - s * s) / (2 * r * s),
                 x = map.scaled_radius(mesh.source(h)), y = map.scaled_radius(mesh.target(h)),
                 square = std::norm(map.position(mesh.next(h)) - map.position(h));
    EXPECT_NEAR((square - x * x - y * y) / (2 * x * y) / before, 1, 1e-8) << e;
    ++result;
  }
  return result;
}

TEST(Decorated_maps, have_the_curvatures_and_inversive_distances)
{
  std::size_t distances = 0;
  for(const Named_triangulation& s : traced(all_surfaces()))
    // Circles inside must not cross the boundary.
    for(const double part :
        has_border(s.triangulation.mesh()) ? std::array{0.1, 0.2} : std::array{0.5, 1.}) {
      const Radii radii = random_radii(s.triangulation, part, 7);
      const Planar_conformal_map map = decorated(s.triangulation, radii);
      EXPECT_EQ(map.status(), DCM::Map_status::success);
      EXPECT_LT(map.max_curvature_error(), 1e-10);
      EXPECT_LT(DCM::max_cross_ratio_error(map), 1e-8);
      EXPECT_TRUE(map.ideal().is_valid());
      EXPECT_EQ(map.has_radii(), *std::max_element(radii.begin(), radii.end()) > 0);
      check_curvatures(map);
      distances += check_inversive_distances(map, radii);
    }
  EXPECT_GT(distances, 1000u);
}

// Checks that five random starts lead to the same scale factors as no start. The curvatures at the
// first vertices are `cones`, and zero at the others; boundaries are not scaled.
void check_uniqueness(const Triangulation& t, const std::vector<double>& cones, unsigned int seed)
{
  const Radii radii = random_radii(t, has_border(t.mesh()) ? 0.2 : 1, seed);
  const std::vector<double> length = lengths_of(t);
  Conditions conditions = default_conditions(t.mesh());
  for(std::size_t v = 0; v < cones.size(); ++v)
    conditions[v] = Vertex_condition::curvature(cones[v]);
  const auto from = [&](const Numbers& start) {
    return DCM::flatten(t.mesh(),
                        length_parameter(length)
                          .vertex_radius_map(as_radii(radii))
                          .vertex_condition_map(as_map(conditions))
                          .initial_log_scale_map(boost::make_function_property_map<Vertex_index>(
                            [&](Vertex_index v) { return start[int(v)]; })));
  };
  const Planar_conformal_map first = from(Numbers::Zero(Eigen::Index(radii.size())));
  ASSERT_EQ(first.status(), DCM::Map_status::success);
  for(unsigned int i = 1; i <= 5; ++i) {
    const Planar_conformal_map map = from(random_numbers(radii.size(), 2, 5 * seed + i));
    ASSERT_EQ(map.status(), DCM::Map_status::success);
    for(std::size_t v = 0; v < radii.size(); ++v)
      EXPECT_NEAR(log_scale(map, v), log_scale(first, v), 1e-9);
  }
}

TEST(Decorated_maps, do_not_depend_on_where_the_search_starts)
{
  const auto flat = [](double x, double y) { return Point(x, y, 0); };
  for(unsigned int seed = 1; seed <= 3; ++seed) {
    check_uniqueness(Triangulation(perturbed(embedded_torus(12, 9), 0.2, seed)), {}, seed);
    check_uniqueness(Triangulation(perturbed(embedded_torus(7, 5), 0.2, seed)), {1, -1}, seed);
    check_uniqueness(Triangulation(random_sphere(100, seed)), {4, 3, 3, 4 * pi - 10}, seed);
    check_uniqueness(Triangulation(straight_plate_with_holes(2)), {-2 * pi, -2 * pi}, seed);
    check_uniqueness(Triangulation(perturbed(grid(8, 7, flat), 0.02, seed)), {}, seed);
  }
}

TEST(Decorated_maps, with_radii_of_zero_are_those_without)
{
  for(const Named_triangulation& s : traced(all_surfaces())) {
    const Planar_conformal_map zero =
      decorated(s.triangulation, Radii(s.triangulation.mesh().number_of_vertices(), 0.));
    const Planar_conformal_map none = flatten(s.triangulation.mesh(), lengths_of(s.triangulation));
    EXPECT_FALSE(zero.has_radii());
    ASSERT_EQ(mesh_C(zero).number_of_halfedges(), mesh_C(none).number_of_halfedges());
    for(std::size_t v = 0; v < mesh_C(zero).number_of_vertices(); ++v)
      EXPECT_EQ(log_scale(zero, v), log_scale(none, v));
    for(Halfedge_index h : mesh_C(zero).halfedges())
      EXPECT_EQ(zero.position(h), none.position(h));
  }
}

TEST(Decorated_maps, with_small_radii_are_close_to_those_without)
{
  const Triangulation t(perturbed(embedded_torus(12, 9), 0.2, 3));
  const Planar_conformal_map none = flatten(t.mesh(), lengths_of(t));
  double before = 0;
  for(const double part : {1e-2, 1e-3, 1e-4}) {
    const Planar_conformal_map map = decorated(t, random_radii(t, part, 11));
    double difference = 0;
    for(std::size_t v = 0; v < mesh_C(map).number_of_vertices(); ++v)
      difference = (std::max)(difference, std::abs(log_scale(map, v) - log_scale(none, v)));
    if(before > 0) {
      EXPECT_NEAR(difference / before, 0.01, 0.002); // of second order
    }
    before = difference;
  }
}

TEST(Decorated_maps, keep_points_on_their_faces)
{
  // The map is projective on each face of the subdivision, and continuous across its edges.
  const Mesh mesh = perturbed(embedded_torus(8, 7), 0.3, 5);
  const Triangulation t(mesh);
  const Planar_conformal_map map = decorated(t, random_radii(t, 1, 13));
  ASSERT_EQ(map.status(), DCM::Map_status::success);
  EXPECT_GT(map.number_of_flips(Layer::C), 0u);
  const auto& s = map.subdivision();
  std::size_t compared = 0;
  for(Halfedge_index h : s.mesh().halfedges()) {
    const Halfedge_index o = s.mesh().opposite(h);
    const Edge_index on_C = s.parent_edge(Layer::C, s.mesh().edge(h));
    if(on_C.is_valid() && map.is_seam(on_C))
      continue;
    const auto z = map.image(h), w = map.image(s.mesh().prev(o));
    EXPECT_LT(std::abs(z - w), 1e-9 * size_of(map));
    ++compared;
  }
  EXPECT_GT(compared, 100u);
}

TEST(Decorated_maps, keep_inversive_distances_when_the_image_is_scaled)
{
  const Triangulation t(perturbed(embedded_torus(8, 7), 0.3, 5));
  Planar_conformal_map map = decorated(t, random_radii(t, 1, 13));
  ASSERT_EQ(map.status(), DCM::Map_status::success);
  std::vector<double> before;
  for(Vertex_index v : t.mesh().vertices())
    before.push_back(map.scaled_radius(v));
  const double factor = DCM::fit_into_unit_square(map);
  EXPECT_NE(factor, 1);
  for(Vertex_index v : t.mesh().vertices())
    EXPECT_DOUBLE_EQ(map.scaled_radius(v), factor * before[v]);
  EXPECT_LT(DCM::max_cross_ratio_error(map), 1e-8);
}

TEST(Decorated_maps, have_rectangles)
{
  const Triangulation t(grid(6, 4, [](double x, double y) { return Point(x, y, x * y / 20); }));
  const std::vector<double> length = lengths_of(t);
  const Radii radii = random_radii(t, 0.5, 3);
  const auto np = length_parameter(length).vertex_radius_map(as_radii(radii));
  const Planar_conformal_map map =
    DCM::flatten_to_rectangle(t.mesh(), DCM::rectangle_corners(t.mesh(), np), np);
  EXPECT_EQ(map.status(), DCM::Map_status::success);
  EXPECT_TRUE(map.has_radii());
  EXPECT_GT(check_inversive_distances(map, radii), 10u);
  EXPECT_THROW(DCM::flatten_to_disk(t.mesh(), np), IT::Invalid_input);
}

// ---- What is refused ----

std::string error_of(const Triangulation& t, const Radii& radii)
{
  try {
    decorated(t, radii);
  } catch(const IT::Invalid_input& e) {
    return e.what();
  }
  return "";
}

TEST(Decorated_maps, name_circles_that_meet)
{
  const Triangulation t(octahedron());
  const double length = t.length(Edge_index(0));
  Radii radii(6, length / 2);
  EXPECT_EQ(error_of(t, radii), ""); // they touch
  radii[2] *= 1.01;
  EXPECT_NE(error_of(t, radii).find("vertices"), std::string::npos);
  EXPECT_NE(error_of(t, radii).find("2"), std::string::npos);
  radii = Radii(6, 0);
  radii[4] = length; // others are on the circle
  EXPECT_NE(error_of(t, radii).find("meet"), std::string::npos);
  radii[4] = 1e3;
  EXPECT_NE(error_of(t, radii), "");
  radii[4] = -1;
  EXPECT_NE(error_of(t, radii).find("vertex 4"), std::string::npos);
  radii[4] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(error_of(t, radii).find("vertex 4"), std::string::npos);
}

// Returns the radius one at the ends of an edge of `glue()`.
Radii radii_at_ends(const Triangulation& t, int side)
{
  Radii result(t.mesh().number_of_vertices(), 0);
  result[t.mesh().source(halfedge_of(side)).idx()] = 1;
  result[t.mesh().target(halfedge_of(side)).idx()] = 1;
  return result;
}

// Flattens with this curvature at the target of side 1 of `glue()`.
Planar_conformal_map decorated_with_curvature(double curvature, const Triangulation& t,
                                              const Radii& radii)
{
  const std::vector<double> length = lengths_of(t);
  Conditions condition = default_conditions(t.mesh());
  condition[t.mesh().target(halfedge_of(1))] = DCM::Vertex_condition::curvature(curvature);
  return DCM::flatten(t.mesh(), length_parameter(length)
                                  .vertex_radius_map(as_radii(radii))
                                  .vertex_condition_map(as_map(condition)));
}

// A disk in the plane does not touch itself, and two disks touch once. Around a cone they can.
TEST(Decorated_maps, name_circles_that_touch_around_a_disk)
{
  // The loop 2 bounds a cone, and lies in a disk with three vertices on its boundary.
  const Triangulation once =
    triangulation(glue({{1, -1, 2}, {6, -3, -2}, {3, 7, -4}, {4, 8, -5}, {5, 9, -6}}),
                  {4, 2, 4, 4, 4, 4, 4, 4, 4});
  // The edges 3 and 4 bound a disk with one vertex inside.
  const Triangulation twice = triangulation(
    glue(
      {{1, 2, 3}, {-1, 4, -2}, {-3, 5, -6}, {-4, 7, -8}, {6, 9, -7}, {8, 10, -11}, {11, 12, -5}}),
    {3, 3, 2, 2, 4, 4, 4, 4, 4, 4, 4, 4});
  const Radii loop = radii_at_ends(once, 2), pair = radii_at_ends(twice, 3);
  EXPECT_THROW(decorated_with_curvature(0, once, loop), IT::Invalid_input);
  EXPECT_THROW(decorated_with_curvature(0, twice, pair), IT::Invalid_input);
  EXPECT_EQ(decorated_with_curvature(4, once, loop).status(), DCM::Map_status::success);
  EXPECT_EQ(decorated_with_curvature(1, twice, pair).status(), DCM::Map_status::success);
}

// Flips round the lengths of edges several times. The exact surface decides whether circles meet.
TEST(Decorated_maps, accept_circles_that_touch_up_to_rounding_of_flips)
{
  const int n = 10;
  std::vector<Point> points;
  for(int i = 0; i < n; ++i)
    points.emplace_back(i, -0.001 * i * (n - 1 - i), 0);
  for(int i = n - 1; i >= 0; --i)
    points.emplace_back(i + 0.03 * (i % 3), 0.3 + 0.001 * i * (n - 1 - i), 0);
  Triangles fan;
  for(std::size_t k = 1; k + 1 < points.size(); ++k)
    fan.push_back({0, k, k + 1});
  Radii radii; // half of the distances to the nearest vertices
  for(const Point& p : points) {
    double least = std::numeric_limits<double>::infinity();
    for(const Point& q : points)
      if(p != q)
        least = (std::min)(least, std::sqrt(CGAL::squared_distance(p, q)));
    radii.push_back(least / 2);
  }
  EXPECT_EQ(
    DCM::flatten(make_mesh(points, fan), DCM::parameters::vertex_radius_map(as_radii(radii)))
      .status(),
    DCM::Map_status::success);
}

TEST(Decorated_maps, name_circles_that_cross_the_boundary)
{
  const Triangulation t(
    make_mesh({{0, 0, 0}, {10, 0, 0}, {5, 10, 0}, {5, 0.5, 0}}, {{0, 1, 3}, {1, 2, 3}, {2, 0, 3}}));
  EXPECT_EQ(error_of(t, {1, 1, 1, 0.49}), "");
  EXPECT_EQ(error_of(t, {1, 1, 1, 0.51}), "the circle at vertex 3 crosses the boundary");
}

TEST(Decorated_maps, have_no_exact_decisions)
{
  const Triangulation t(octahedron());
  const std::vector<double> length = lengths_of(t);
  const Radii radii(6, length[0] / 3);
  EXPECT_THROW(
    DCM::flatten(t.mesh(),
                 length_parameter(length).vertex_radius_map(as_radii(radii)).exact_decisions(true)),
    IT::Invalid_input);
  EXPECT_THROW(DCM::certify(decorated(t, radii)), IT::Invalid_input);
}

} // namespace Test_decorated_maps
