// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "flat_maps.h"

#include <CGAL/Intrinsic_triangulations/operators.h>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>

namespace Test_flatten {

using namespace Test_surfaces;
namespace np = DCM::parameters;

// ---- Comparing ----

void expect_scales(const Planar_conformal_map& map, const std::vector<double>& expected,
                   double tolerance)
{
  for(std::size_t v = 0; v < expected.size(); ++v)
    EXPECT_NEAR(log_scale(map, v), expected[v], tolerance) << v;
}

// Checks that scale factors are opposite up to a constant.
void expect_opposite_scales(const Planar_conformal_map& map, const std::vector<double>& u0,
                            double tolerance)
{
  for(std::size_t v = 0; v < u0.size(); ++v)
    EXPECT_NEAR(log_scale(map, v) + u0[v], log_scale(map, 0) + u0[0], tolerance) << v;
}

// Checks that the message of the exception contains the text.
void expect_invalid(const std::function<void()>& task, const std::string& text)
{
  try {
    task();
    ADD_FAILURE() << "accepted, where '" << text << "' is expected";
  } catch(const IT::Invalid_input& error) {
    EXPECT_NE(std::string(error.what()).find(text), std::string::npos) << error.what();
  }
}

// ---- Surfaces ----

struct Metric
{
  Delta_complex mesh;
  std::vector<double> length;
};

// Returns the discretely conformal metric with scale factors `u`, in the triangulation that is
// Delaunay with them.
Metric scaled(Triangulation t, const std::vector<double>& u)
{
  IT::make_Delaunay(t);
  DCM::Penner_surface<> surface(t.mesh(), t.length_map());
  surface.scale(u);
  Metric result{surface.mesh(), {}};
  for(Edge_index e : surface.mesh().edges())
    result.length.push_back(surface.scaled_length(e));
  return result;
}

// Returns surfaces with more than one vertex, and some of higher genus.
std::vector<Named_triangulation> more_closed_surfaces()
{
  std::vector<Named_triangulation> result;
  for(const Named_triangulation& s : closed_surfaces())
    if(s.triangulation.mesh().number_of_vertices() > 1)
      result.push_back(s);
  for(int genus : {0, 2, 3, 4})
    result.push_back({"genus " + std::to_string(genus), Triangulation(plate_with_holes(genus))});
  return result;
}

std::vector<Named_triangulation> surfaces_with_border()
{
  std::vector<Named_triangulation> result;
  for(const Named_complex& c : complexes())
    if(has_border(c.mesh))
      result.push_back({c.name, triangulation(c.mesh, random_lengths(c.mesh, 11))});
  return result;
}

std::vector<Named_surface> flat_disks()
{
  return {{"grid", flat_grid(6, 5, 2)},
          {"polygon", flat_polygon(random_points(25, 1000, 5))},
          {"larger polygon", flat_polygon(random_points(300, 10000, 6))}};
}

Mesh rough_disk(std::size_t n)
{
  const auto hill = [&](double x, double y) {
    return Point(x, y, 2 * std::sin(x / double(n) * 4) * std::cos(y / double(n) * 5));
  };
  return perturbed(grid(n, n, hill), 0.3, 14);
}

// Returns the vertices of the only boundary loop, in its order.
std::vector<Vertex_index> boundary(const Delta_complex& mesh)
{
  std::vector<Vertex_index> result;
  for(Halfedge_index h : mesh.halfedges())
    if(mesh.is_border(h)) {
      for(Halfedge_index x : CGAL::halfedges_around_face(h, mesh))
        result.push_back(mesh.target(x));
      break;
    }
  return result;
}

// ---- Flat surfaces ----

TEST(Flatten, flat_torus_stays)
{
  for(unsigned int seed : {1u, 2u, 3u}) {
    const Flat_surface torus = flat_torus(4, 3, seed);
    const Planar_conformal_map map = flatten(torus.mesh, torus.lengths());
    EXPECT_TRUE(map.cones().empty());
    EXPECT_EQ(map.minimization().status, DCM::Minimization_status::converged);
    expect_scales(map, std::vector<double>(torus.mesh.number_of_vertices(), 0), 1e-12);
  }
}

TEST(Flatten, flat_surfaces_with_fixed_boundary_stay)
{
  auto surfaces = flat_disks();
  surfaces.push_back({"annulus with two vertices", flat_cylinder(1, 0)});
  surfaces.push_back({"annulus", flat_cylinder(4, 0)});
  surfaces.push_back({"sheared annulus", flat_cylinder(3, 2)});
  for(const Named_surface& s : traced(surfaces)) {
    const Planar_conformal_map map = flatten(s.surface.mesh, s.surface.lengths());
    EXPECT_TRUE(map.cones().empty());
    expect_scales(map, std::vector<double>(mesh_C(map).number_of_vertices(), 0), 1e-11);
    check_conditions(map, s.surface.mesh, default_conditions(s.surface.mesh), 1e-11);
  }
}

TEST(Flatten, flat_surface_with_scaled_boundary_is_scaled)
{
  for(const double u : {-30., -0.7, 1.3, 30.})
    for(const Named_surface& s : traced(flat_disks())) {
      Conditions condition = default_conditions(s.surface.mesh);
      for(Vertex_index v : s.surface.mesh.vertices())
        if(s.surface.mesh.is_border(v))
          condition[v] = Vertex_condition::log_scale(u);
      const Planar_conformal_map map = flatten(s.surface.mesh, s.surface.lengths(), condition);
      expect_scales(map, std::vector<double>(condition.size(), u), 1e-11);
    }
}

// ---- Surfaces with known scale factors ----

TEST(Flatten, surface_with_its_own_curvatures_stays)
{
  for(const Named_triangulation& s : traced(more_closed_surfaces())) {
    const Conditions condition = as_curvatures(curvatures(s.triangulation));
    const Planar_conformal_map map = flatten(s.triangulation, condition);
    EXPECT_TRUE(map.cones().empty());
    expect_scales(map, std::vector<double>(condition.size(), 0), 1e-11);
    check_conditions(map, s.triangulation.mesh(), condition, 1e-11);
  }
}

// The double of a surface with its own exterior angles is the double of the surface.
TEST(Flatten, surface_with_its_own_exterior_angles_stays)
{
  for(const Named_triangulation& s : traced(surfaces_with_border())) {
    const Conditions condition = as_curvatures(curvatures(s.triangulation));
    const Planar_conformal_map map = flatten(s.triangulation, condition);
    expect_scales(map, std::vector<double>(mesh_C(map).number_of_vertices(), 0), 1e-11);
    check_conditions(map, s.triangulation.mesh(), condition, 1e-11);
  }
}

TEST(Flatten, cube_has_eight_cones)
{
  const Triangulation t(cube());
  const Conditions condition(8, Vertex_condition::curvature(pi / 2));
  expect_scales(flatten(t, condition), std::vector<double>(8, 0), 1e-14);
}

// Curvatures determine the metric up to a factor.
TEST(Flatten, takes_scaling_back)
{
  for(const Named_triangulation& s : traced(more_closed_surfaces()))
    for(const double bound : traced({0.2, 4.})) {
      const auto u0 = random_values(s.triangulation.mesh().number_of_vertices(), bound, 13);
      const Metric m = scaled(s.triangulation, u0);
      const Conditions condition = as_curvatures(curvatures(s.triangulation));
      const Planar_conformal_map map = flatten(m.mesh, m.length, condition);
      expect_opposite_scales(map, u0, 1e-10);
      check_conditions(map, s.triangulation.mesh(), condition, 1e-11);
    }
}

TEST(Flatten, takes_scaling_of_a_flat_torus_back)
{
  const Flat_surface torus = flat_torus(6, 5, 4);
  const auto u0 = random_values(torus.mesh.number_of_vertices(), 1.5, 15);
  const Metric m = scaled(triangulation(torus), u0);
  const Planar_conformal_map map = flatten(m.mesh, m.length);
  EXPECT_TRUE(map.cones().empty());
  expect_opposite_scales(map, u0, 1e-10);
}

// Some vertices have scale factors, others have curvatures.
TEST(Flatten, takes_mixed_conditions)
{
  for(const Named_triangulation& s : traced(more_closed_surfaces())) {
    const auto u0 = random_values(s.triangulation.mesh().number_of_vertices(), 1, 13);
    const Metric m = scaled(s.triangulation, u0);
    Conditions condition = as_curvatures(curvatures(s.triangulation));
    std::vector<double> expected;
    for(std::size_t v = 0; v < u0.size(); ++v) {
      expected.push_back(0.25 - u0[v]);
      if(v % 3 == 1)
        condition[v] = Vertex_condition::log_scale(expected[v]);
    }
    expect_scales(flatten(m.mesh, m.length, condition), expected, 1e-10);
  }
}

// The surface consists of two pyramids over a regular polygon, whose faces become isosceles
// triangles with given angles.
TEST(Flatten, bipyramid_has_a_closed_form)
{
  for(const std::size_t n : {4u, 5u, 12u})
    for(const double height : {0., 0.5, 2.})
      for(const double at_apex : {-3., 0., 1., 3., 6.}) {
        const double angle = (2 * pi - at_apex) / double(n);
        if(angle > pi / 2) // the edges of the ring are not Delaunay
          continue;
        SCOPED_TRACE(std::to_string(n) + ' ' + std::to_string(height) + ' ' +
                     std::to_string(at_apex));
        const double on_ring = (4 * pi - 2 * at_apex) / double(n);
        Conditions condition(n, Vertex_condition::curvature(on_ring));
        condition.resize(n + 2, Vertex_condition::curvature(at_apex));
        const Triangulation t(bipyramid(n, height));
        const Planar_conformal_map map = flatten(t, condition);
        const double ring = 2 * std::sin(pi / double(n)), outgoing = std::hypot(1, height);
        EXPECT_NEAR(log_scale(map, 0) - log_scale(map, n),
                    2 * std::log(2 * std::sin(angle / 2) * outgoing / ring), 1e-12);
        for(std::size_t v = 0; v < n; ++v)
          EXPECT_NEAR(log_scale(map, v), log_scale(map, 0), 1e-12);
        EXPECT_NEAR(log_scale(map, n), log_scale(map, n + 1), 1e-12);
      }
}

// ---- Two triangulations of one surface ----

TEST(Flatten, does_not_depend_on_the_triangulation)
{
  for(const Named_triangulation& s : traced(more_closed_surfaces())) {
    Triangulation other = s.triangulation;
    flip_at_random(other, 20 * other.mesh().number_of_edges(), 3);
    Conditions condition = as_curvatures(curvatures(s.triangulation));
    const auto values = random_values(condition.size(), 0.2, 7);
    for(std::size_t v = 0; v < condition.size(); ++v)
      if(v % 2 == 0)
        condition[v] = Vertex_condition::log_scale(5 * values[v]);
      else
        condition[v].value += values[v];
    const Planar_conformal_map one = flatten(s.triangulation, condition),
                               two = flatten(other, condition);
    for(std::size_t v = 0; v < condition.size(); ++v)
      EXPECT_NEAR(log_scale(one, v), log_scale(two, v), 1e-9) << v;
    check_conditions(one, s.triangulation.mesh(), condition, 1e-11);
  }
}

// ---- Cones ----

TEST(Flatten, places_cones_where_they_are_needed)
{
  for(const Named_triangulation& s : traced(more_closed_surfaces()))
    for(const double bound : traced({0.5, 5.})) {
      const Delta_complex& mesh = s.triangulation.mesh();
      const std::vector<double> length = lengths_of(s.triangulation);
      const Planar_conformal_map map =
        DCM::flatten(mesh, length_parameter(length).maximum_log_scale(bound));
      Conditions condition(mesh.number_of_vertices());
      for(Vertex_index v : map.cones())
        condition[v] = Vertex_condition::log_scale(0);
      check_conditions(map, mesh, condition, 1e-11);
      for(Vertex_index v : mesh.vertices())
        EXPECT_LE(std::abs(map.log_scale(v)), bound);
    }
}

// Returns a grid with hills so steep that a linear estimate of scale factors is much too great.
Mesh hilly_disk(unsigned int seed, double height)
{
  CGAL::Random random(seed);
  return grid(7, 6, [&](double x, double y) { return Point(x, y, random.get_double(0, height)); });
}

TEST(Flatten, places_no_cones_on_components_within_the_bound)
{
  const double bound = 5;
  std::size_t within_bound = 0;
  for(const double height : {1., 3., 6.})
    for(unsigned int seed = 0; seed < 10; ++seed) {
      SCOPED_TRACE(std::to_string(height) + ", seed " + std::to_string(seed));
      Mesh mesh = hilly_disk(seed, height);
      const Planar_conformal_map without = DCM::flatten(mesh, np::cones(DCM::Cones::none));
      ASSERT_EQ(without.status(), DCM::Map_status::success);
      double greatest = 0;
      for(Vertex_index v : mesh.vertices())
        if(!mesh.is_border(v))
          greatest = (std::max)(greatest, std::abs(without.log_scale(v)));
      const Planar_conformal_map map = DCM::flatten(mesh);
      EXPECT_EQ(map.status(), DCM::Map_status::success);
      EXPECT_EQ(map.cones().empty(), greatest <= bound);
      if(greatest > bound)
        continue;
      ++within_bound;
      for(Vertex_index v : mesh.vertices())
        EXPECT_NEAR(map.log_scale(v), without.log_scale(v), 1e-8);
      // A sphere beside it needs cones.
      const std::size_t n = mesh.number_of_vertices();
      mesh += random_sphere(30, seed);
      const Planar_conformal_map both = DCM::flatten(mesh);
      EXPECT_FALSE(both.cones().empty());
      for(Vertex_index v : both.cones())
        EXPECT_GE(v.idx(), n);
    }
  EXPECT_GT(within_bound, 15u);
}

// The image of a torus keeps the area, and its scale factors keep the bound then.
TEST(Flatten, places_no_cones_on_tori_within_the_bound)
{
  const Mesh mesh = perturbed(embedded_torus(12, 8), 0.05, 1);
  double greatest = 0;
  const Planar_conformal_map without = DCM::flatten(mesh, np::cones(DCM::Cones::none));
  for(Vertex_index v : mesh.vertices())
    greatest = (std::max)(greatest, std::abs(without.log_scale(v)));
  EXPECT_TRUE(DCM::flatten(mesh, np::maximum_log_scale(1.01 * greatest)).cones().empty());
  EXPECT_FALSE(DCM::flatten(mesh, np::maximum_log_scale(0.99 * greatest)).cones().empty());
}

TEST(Flatten, the_only_vertex_can_be_a_cone)
{
  const Delta_complex octagon = double_torus();
  ASSERT_EQ(octagon.number_of_vertices(), 1u);
  const std::vector<double> length(octagon.number_of_edges(), 1.);
  const Planar_conformal_map map = DCM::flatten(octagon, length_parameter(length));
  EXPECT_EQ(map.status(), DCM::Map_status::success);
  EXPECT_EQ(map.cones(), std::vector<Vertex_index>{Vertex_index(0)});
}

// Runs Newton's method to the minimum before each cone.
struct Newton_to_the_minimum
{
  template <typename Energy, typename Visitor>
  DCM::Minimization_result operator()(Energy& energy, Eigen::VectorXd& x,
                                      const DCM::Minimization_domain& domain,
                                      Visitor&& visitor) const
  {
    return DCM::Newton_minimizer()(energy, x, domain, visitor);
  }
};

// Computes greedy cones of a linear estimate on a closed connected surface, with a dense matrix for
// each.
class Estimated_cones
{
public:
  Estimated_cones(Triangulation t, double bound) : m_bound(bound)
  {
    IT::make_Delaunay(t);
    m_matrix = IT::cotan_laplacian(t);
    const std::vector<double> angle = angle_sums(t.mesh(), t.length_map());
    m_defect = 2 * std::acos(-1.) - Eigen::Map<const Eigen::ArrayXd>(angle.data(), size());
    const long characteristic = std::lround(m_defect.sum() / (2 * std::acos(-1.)));
    m_needed = characteristic > 0 ? std::size_t(characteristic) + 1 : characteristic < 0 ? 1 : 0;
    add_first();
    while(!cones.empty()) {
      Eigen::Index worst;
      const double greatest = estimate().cwiseAbs().maxCoeff(&worst);
      if(greatest <= bound && cones.size() >= m_needed)
        return;
      add(worst);
    }
  }

  std::vector<Vertex_index> cones;

private:
  Eigen::Index size() const { return m_matrix.cols(); }
  void add(Eigen::Index v) { cones.push_back(Vertex_index(Delta_complex::size_type(v))); }

  void add_first()
  {
    Eigen::VectorXd u = -m_matrix.completeOrthogonalDecomposition().solve(
      Eigen::VectorXd(m_defect.array() - m_defect.mean()));
    u.array() -= u.mean();
    Eigen::Index worst;
    if(u.cwiseAbs().maxCoeff(&worst) > m_bound || m_needed > 0)
      add(worst);
  }

  Eigen::VectorXd estimate() const
  {
    Eigen::MatrixXd matrix = m_matrix;
    Eigen::VectorXd right_side = -m_defect;
    for(Vertex_index c : cones) {
      matrix.row(Eigen::Index(c.idx())).setZero();
      matrix(Eigen::Index(c.idx()), Eigen::Index(c.idx())) = 1;
      right_side[Eigen::Index(c.idx())] = 0;
    }
    return matrix.partialPivLu().solve(right_side);
  }

  double m_bound;
  Eigen::MatrixXd m_matrix;
  Eigen::VectorXd m_defect;
  std::size_t m_needed = 0;
};

// Returns a sphere with three long limbs.
Mesh sphere_with_limbs(std::size_t size, unsigned int seed)
{
  Mesh result = random_sphere(size, seed);
  CGAL::Random random(seed);
  std::array<double, 3> at{};
  for(int limb = 0; limb < 3; ++limb) {
    for(double& x : at)
      x = random.get_double(-1, 1);
    const double norm = std::hypot(at[0], at[1], at[2]);
    for(Mesh::Vertex_index v : result.vertices()) {
      auto& p = result.point(v);
      const double height = (p.x() * at[0] + p.y() * at[1] + p.z() * at[2]) / norm;
      if(height > 0.8)
        p = CGAL::ORIGIN + (1 + 20 * (height - 0.8)) * (p - CGAL::ORIGIN);
    }
  }
  return result;
}

// Rounding does not decide the order of cones.
TEST(Flatten, places_the_cones_of_a_linear_estimate_first)
{
  for(unsigned int seed : seeds(10))
    for(const double bound : {0.5, 1., 5.}) {
      const Mesh mesh = sphere_with_limbs(150, seed);
      const std::vector<Vertex_index> expected = Estimated_cones(Triangulation(mesh), bound).cones,
                                      cones =
                                        DCM::flatten(mesh, np::maximum_log_scale(bound)).cones();
      ASSERT_LE(expected.size(), cones.size());
      EXPECT_TRUE(std::equal(expected.begin(), expected.end(), cones.begin()));
    }
}

// Returns the distance from zero of the scale factor of a cone, without it and the later ones.
// Without earlier cones, returns the range of all scale factors.
double extent_without(const Triangulation& t, const std::vector<Vertex_index>& cones, std::size_t k)
{
  Conditions condition(t.mesh().number_of_vertices());
  for(std::size_t i = 0; i < k; ++i)
    condition[cones[i]] = Vertex_condition::log_scale(0);
  const Planar_conformal_map map = flatten(t, condition);
  if(k > 0)
    return std::abs(map.log_scale(cones[k]));
  double result = 0;
  for(Vertex_index v : t.mesh().vertices())
    result = (std::max)(result, std::abs(map.log_scale(v) - map.log_scale(cones[0])));
  return result;
}

// All cones except for the cones of the estimate are out of bounds at the minimum of the energy
// without them.
TEST(Flatten, adds_cones_before_the_minimum_that_are_needed_there)
{
  std::vector<Triangulation> surfaces;
  for(const Named_triangulation& s : more_closed_surfaces())
    surfaces.push_back(s.triangulation);
  for(unsigned int seed = 0; seed < 20; ++seed)
    surfaces.push_back(Triangulation(random_sphere(200, seed)));
  std::size_t added = 0, steps = 0, steps_to_minima = 0;
  for(const Triangulation& t : surfaces)
    for(const double bound : {0.25, 0.5, 1., 2.}) {
      const std::vector<double> length = lengths_of(t);
      const auto parameters = length_parameter(length).maximum_log_scale(bound);
      const Planar_conformal_map map = DCM::flatten(t.mesh(), parameters);
      for(std::size_t k = Estimated_cones(t, bound).cones.size(); k < map.cones().size();
          ++k, ++added)
        EXPECT_GT(extent_without(t, map.cones(), k), bound);
      steps += map.minimization().iterations;
      steps_to_minima += DCM::flatten(t.mesh(), parameters.minimizer(Newton_to_the_minimum()))
                           .minimization()
                           .iterations;
    }
  EXPECT_GT(added, 50u);
  EXPECT_LT(steps, steps_to_minima);
}

// A start near cones, and factorizations that are used again, change no significant digit. The
// minimum equals the minimum of Newton's method alone, which starts from zero.
TEST(Flatten, finds_the_minimum_in_few_steps_from_a_start_near_cones)
{
  std::size_t steps = 0, steps_from_zero = 0, cones = 0;
  for(unsigned int seed : seeds(12))
    for(const double bound : {1., 3.}) {
      const Mesh mesh = sphere_with_limbs(400, seed);
      const Planar_conformal_map map = DCM::flatten(mesh, np::maximum_log_scale(bound));
      EXPECT_EQ(map.status(), DCM::Map_status::success);
      Conditions condition(mesh.number_of_vertices());
      for(Vertex_index v : map.cones())
        condition[v] = Vertex_condition::log_scale(0);
      const Planar_conformal_map other = flatten(Triangulation(mesh), condition);
      std::vector<double> u;
      for(std::size_t v = 0; v < mesh.number_of_vertices(); ++v)
        u.push_back(log_scale(other, v));
      expect_scales(map, u, 1e-9);
      steps += map.minimization().iterations;
      steps_from_zero += other.minimization().iterations;
      cones += map.cones().size();
    }
  EXPECT_GT(cones, 100u);
  EXPECT_LT(3 * steps, 2 * steps_from_zero);
}

// The map does not depend on the start, even if lengths are beyond the range of any type there.
TEST(Flatten, starts_anywhere)
{
  const Mesh mesh = random_sphere(40, 3);
  const Planar_conformal_map map = DCM::flatten(mesh);
  ASSERT_EQ(map.status(), DCM::Map_status::success);
  Conditions condition(mesh.number_of_vertices());
  for(Vertex_index v : map.cones())
    condition[v] = Vertex_condition::log_scale(0);
  std::vector<double> u;
  for(std::size_t v = 0; v < mesh.number_of_vertices(); ++v)
    u.push_back(log_scale(map, v));
  for(const double size : {2., 100., 1e5, 1e300}) {
    const auto start = boost::make_function_property_map<Vertex_index>(
      [size](Vertex_index v) { return size * std::sin(double(v.idx())); });
    const Planar_conformal_map other =
      DCM::flatten(mesh, np::vertex_condition_map(as_map(condition)).initial_log_scale_map(start));
    EXPECT_EQ(other.status(), DCM::Map_status::success) << size;
    expect_scales(other, u, 1e-9);
  }
}

TEST(Flatten, flattens_every_component)
{
  const Mesh mesh = five_components();
  const Planar_conformal_map map = DCM::flatten(mesh);
  const Triangulation t(mesh);
  Conditions condition = default_conditions(t.mesh());
  for(Vertex_index v : map.cones())
    condition[v] = Vertex_condition::log_scale(0);
  check_conditions(map, t.mesh(), condition, 1e-12);
  const IT::Mesh_components component(t.mesh());
  std::vector<int> cones(component.size(), 0);
  for(Vertex_index v : map.cones())
    ++cones[component[v]];
  EXPECT_GE(cones[component[0]], 3); // a sphere: each cone has less than 2 pi of 4 pi
  EXPECT_GE(cones[component[20]], 3);
  EXPECT_EQ(cones[component[24]], 0); // a point
}

// ---- Boundaries ----

TEST(Flatten, boundary_has_the_prescribed_scale)
{
  const Triangulation t(rough_disk(9));
  Conditions condition = default_conditions(t.mesh());
  const auto u = random_values(condition.size(), 1, 17);
  for(std::size_t v = 0; v < u.size(); ++v)
    if(condition[v].quantity == Vertex_condition::Quantity::log_scale)
      condition[v].value = u[v];
  const Planar_conformal_map map = flatten(t, condition);
  check_conditions(map, t.mesh(), condition, 1e-12);
  check_layout(map);
}

// Checks that the image is a polygon with these exterior angles.
void check_polygon(const Triangulation& t, const Conditions& condition)
{
  const Planar_conformal_map map = flatten(t, condition);
  check_conditions(map, t.mesh(), condition, 1e-12);
  check_layout(map);
  EXPECT_TRUE(has_no_seam(map));
  const std::vector<Vertex_index> loop = boundary(t.mesh()); // clockwise
  const auto place = [&](std::size_t i) { return map(corner(mesh_A(map), loop[i % loop.size()])); };
  for(std::size_t i = 0; i < loop.size(); ++i) {
    const Complex in = place(i + 1) - place(i), out = place(i + 2) - place(i + 1);
    EXPECT_NEAR(std::arg(in / out), condition[loop[(i + 1) % loop.size()]].value, 1e-9) << i;
  }
}

TEST(Flatten, boundary_has_the_prescribed_angles)
{
  const Triangulation t(rough_disk(8));
  const std::vector<Vertex_index> loop = boundary(t.mesh());
  ASSERT_EQ(loop.size(), 32u);
  for(const std::size_t corners : traced({3u, 4u, 5u, 32u})) {
    Conditions condition(t.mesh().number_of_vertices());
    for(std::size_t k = 0; k < corners; ++k)
      condition[loop[k * 32 / corners]] = Vertex_condition::curvature(2 * pi / double(corners));
    check_polygon(t, condition);
  }
  SCOPED_TRACE("random angles");
  Conditions condition(t.mesh().number_of_vertices());
  const auto angle = random_values(32, 0.8, 19);
  double sum = 0;
  for(double a : angle)
    sum += a;
  for(std::size_t k = 0; k < 32; ++k)
    condition[loop[k]] = Vertex_condition::curvature(angle[k] + (2 * pi - sum) / 32);
  check_polygon(t, condition);
}

TEST(Flatten, annulus_without_curvature_is_a_cylinder)
{
  const Flat_surface annulus = flat_cylinder(4, 1);
  const Conditions condition(annulus.mesh.number_of_vertices());
  const Planar_conformal_map map = flatten(annulus.mesh, annulus.lengths(), condition);
  expect_scales(map, std::vector<double>(condition.size(), 0), 1e-11);
}

// ---- What cannot be ----

TEST(Flatten, refuses_curvatures_against_Gauss_Bonnet)
{
  const Triangulation sphere(cube()), torus(embedded_torus(5, 4)), disk(rough_disk(4));
  const auto prescribe = [](const Triangulation& t, double sum) {
    const std::size_t n = t.mesh().number_of_vertices();
    return [&t, c = Conditions(n, Vertex_condition::curvature(sum / double(n)))] { flatten(t, c); };
  };
  expect_invalid(prescribe(sphere, 0), "12.5664 radians less");
  expect_invalid(prescribe(sphere, 4 * pi + 1e-3), "0.001 radians more");
  expect_invalid(prescribe(torus, -0.25), "0.25 radians less");
  EXPECT_NO_THROW(prescribe(torus, 0)());
  EXPECT_NO_THROW(prescribe(sphere, 4 * pi)());
  const Conditions flat(25, Vertex_condition::curvature(0));
  expect_invalid([&] { flatten(disk, flat); }, "6.28319 radians less");
}

TEST(Flatten, refuses_too_few_cones)
{
  const Triangulation sphere(random_sphere(20, 1));
  Conditions condition(20);
  condition[3] = condition[7] = Vertex_condition::log_scale(0);
  expect_invalid([&] { flatten(sphere, condition); }, "Gauss-Bonnet");
  condition[11] = Vertex_condition::log_scale(0);
  EXPECT_NO_THROW(flatten(sphere, condition));
}

TEST(Flatten, refuses_vertices_without_an_angle)
{
  const Triangulation sphere(random_sphere(20, 1)), disk(rough_disk(4));
  Conditions condition(20, Vertex_condition::log_scale(0));
  condition[5] = Vertex_condition::curvature(2 * pi);
  expect_invalid([&] { flatten(sphere, condition); }, "vertex 5");
  condition[5] = Vertex_condition::curvature(7);
  expect_invalid([&] { flatten(sphere, condition); }, "vertex 5");
  condition[5] = Vertex_condition::curvature(std::nan(""));
  expect_invalid([&] { flatten(sphere, condition); }, "vertex 5");
  condition[5] = Vertex_condition::log_scale(std::numeric_limits<double>::infinity());
  expect_invalid([&] { flatten(sphere, condition); }, "vertex 5");
  condition[5] = Vertex_condition::curvature(6);
  EXPECT_NO_THROW(flatten(sphere, condition));
  Conditions on_disk = default_conditions(disk.mesh());
  on_disk[4] = Vertex_condition::curvature(pi);
  expect_invalid([&] { flatten(disk, on_disk); }, "vertex 4");
  on_disk[4] = Vertex_condition::curvature(3);
  EXPECT_NO_THROW(flatten(disk, on_disk));
}

// ---- Parameters ----

struct Recording_visitor : DCM::Default_flattening_visitor
{
  std::vector<DCM::Flattening_stage> stages;
  std::size_t steps = 0;
  void start(DCM::Flattening_stage stage) { stages.push_back(stage); }
  void after_iteration(std::size_t iteration, double norm, double)
  {
    EXPECT_GT(iteration, 0u);
    EXPECT_GE(norm, 0);
    ++steps;
  }
};

TEST(Flatten, visitor_sees_all_stages_and_steps)
{
  using Stage = DCM::Flattening_stage;
  Recording_visitor visitor;
  const Planar_conformal_map map =
    DCM::flatten(random_sphere(40, 1), CGAL::parameters::visitor(std::ref(visitor)));
  EXPECT_EQ(visitor.stages, (std::vector<Stage>{Stage::cones, Stage::optimize, Stage::layout,
                                                Stage::trace, Stage::subdivide}));
  EXPECT_EQ(visitor.steps, map.minimization().iterations);
  EXPECT_GT(visitor.steps, 0u);
}

// The layout requires the part of T_3 that belongs to a surface with boundary.
TEST(Flatten, bounded_surfaces_are_subdivided_before_the_layout)
{
  using Stage = DCM::Flattening_stage;
  Recording_visitor visitor;
  DCM::flatten(rough_disk(6), CGAL::parameters::visitor(std::ref(visitor)));
  EXPECT_EQ(visitor.stages, (std::vector<Stage>{Stage::cones, Stage::optimize, Stage::trace,
                                                Stage::subdivide, Stage::layout}));
}

// All stages share an order: they compute one factorization for the cones, one for each step, and
// one for the layout.
TEST(Flatten, takes_few_factorizations_and_orders)
{
  for(unsigned int seed = 1; seed <= 5; ++seed)
    for(const Mesh& mesh : {random_sphere(400, seed), embedded_torus(20, 15)}) {
      const Planar_conformal_map map = DCM::flatten(mesh);
      const DCM::Factorization_counts& all = map.factorization_counts();
      const DCM::Minimization_result& steps = map.minimization();
      EXPECT_EQ(all.factorizations, steps.factorizations + 2) << seed;
      EXPECT_LE(2 * all.factorizations, 3 * (steps.iterations + 2)) << seed;
      EXPECT_GE(all.orderings, 1u);
      EXPECT_LT(all.orderings, all.symbolic_analyses) << seed;
    }
}

struct Stopping_visitor : DCM::Default_flattening_visitor
{
  DCM::Flattening_stage last;
  bool stops_at_step;
  void start(DCM::Flattening_stage stage)
  {
    if(stage == last && !stops_at_step)
      throw std::runtime_error("stopped");
  }
  void after_iteration(std::size_t, double, double)
  {
    if(stops_at_step)
      throw std::runtime_error("stopped");
  }
};

TEST(Flatten, exceptions_of_visitors_leave)
{
  using Stage = DCM::Flattening_stage;
  const Mesh mesh = random_sphere(40, 1);
  const auto stop = [&](Stage stage, bool at_step) {
    Stopping_visitor visitor{{}, stage, at_step};
    EXPECT_THROW(DCM::flatten(mesh, CGAL::parameters::visitor(std::ref(visitor))),
                 std::runtime_error);
  };
  for(const Stage stage :
      {Stage::cones, Stage::optimize, Stage::layout, Stage::trace, Stage::subdivide})
    stop(stage, false);
  stop(Stage::layout, true);
}

// Implements gradient descent, a model of ConvexMinimizer that is independent of Newton's method.
struct Gradient_descent
{
  template <typename Energy, typename Visitor>
  DCM::Minimization_result operator()(Energy& energy, Eigen::VectorXd& x,
                                      const DCM::Minimization_domain& domain,
                                      Visitor&& visitor) const
  {
    DCM::Minimization_result result;
    for(;;) {
      energy.evaluate(x);
      Eigen::VectorXd gradient = energy.gradient();
      for(Eigen::Index i = 0; i < x.size(); ++i)
        gradient[i] = domain.is_fixed[std::size_t(i)] ? 0 : gradient[i];
      result.gradient_norm = gradient.cwiseAbs().maxCoeff();
      if(result.gradient_norm < 1e-12)
        break;
      x -= 0.1 * gradient;
      visitor.after_iteration(++result.iterations, result.gradient_norm, 0.1);
    }
    result.status = DCM::Minimization_status::converged;
    return result;
  }
};

TEST(Flatten, takes_another_minimizer)
{
  const Triangulation t(random_sphere(12, 1));
  Conditions condition(12);
  condition[0] = condition[4] = condition[8] = Vertex_condition::log_scale(0.1);
  const std::vector<double> length = lengths_of(t);
  const auto with = [&](const auto& minimizer) {
    return DCM::flatten(
      t.mesh(),
      length_parameter(length).vertex_condition_map(as_map(condition)).minimizer(minimizer));
  };
  const Planar_conformal_map one = with(Gradient_descent()), two = with(DCM::Newton_minimizer());
  for(std::size_t v = 0; v < 12; ++v)
    EXPECT_NEAR(log_scale(one, v), log_scale(two, v), 1e-10) << v;
  EXPECT_GT(one.minimization().iterations, two.minimization().iterations);
  EXPECT_EQ(with(DCM::Newton_minimizer(1e-13, 1)).minimization().status,
            DCM::Minimization_status::iteration_limit);
}

TEST(Flatten, gives_the_same_bits_twice)
{
  const Mesh mesh = plate_with_holes(2);
  const Planar_conformal_map one = DCM::flatten(mesh), two = DCM::flatten(mesh);
  for(Vertex_index v : mesh_C(one).vertices())
    EXPECT_EQ(one.log_scale(v), two.log_scale(v));
  for(Halfedge_index h : mesh_C(one).halfedges())
    EXPECT_EQ(one.position(h), two.position(h));
}

TEST(Flatten, layers_are_surfaces)
{
  const Planar_conformal_map map = DCM::flatten(plate_with_holes(2));
  const auto area = [&](DCM::Layer layer) { return IT::mass_matrix(map.surface(layer)).sum(); };
  EXPECT_NEAR(area(DCM::Layer::A), area(DCM::Layer::B), 1e-12 * area(DCM::Layer::A));
  EXPECT_EQ(&map.surface(DCM::Layer::A).mesh(), &map.Delaunay().input_mesh());
  EXPECT_EQ(&map.surface(DCM::Layer::B).mesh(), &map.Delaunay().mesh());
  EXPECT_EQ(&map.surface(DCM::Layer::C).mesh(), &map.ideal().mesh());
}

TEST(Flatten, empty_mesh_gives_an_empty_map)
{
  EXPECT_EQ(mesh_C(DCM::flatten(Mesh())).number_of_faces(), 0u);
}

} // namespace Test_flatten
