// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The transport cost is compared with transports computed directly.

#include "evolving_surfaces.h"

#include <CGAL/Intrinsic_simplification/Transport_cost.h>

namespace Test_transport_cost {

using namespace Test_surfaces;
using IS::Transport_cost;

double positive(double x) { return (std::max)(x, 0.); }

// ---- One removal on a curved surface ----

struct Transport
{
  std::map<Vertex_index, double> share; // of each neighbor
  double cost = 0;                      // of moving a unit
};

// Returns the lengths after the center of `star` has been flattened.
auto flattened(const Evolving_surface& s, const Flattened_star& star)
{
  return [&](Edge_index e) {
    for(std::size_t n = 0; n < star.size(); ++n)
      if(s.mesh().edge(star[n].halfedge) == e)
        return star.flat_length(n);
    return s.surface().length(e);
  };
}

// Returns the change of the curvature of each vertex by flattening the center.
std::vector<double> curvature_changes(const Evolving_surface& s, const Flattened_star& star)
{
  std::vector<double> change = angle_sums(s.mesh(), flattened(s, star));
  const std::vector<double> before = angle_sums(s.mesh(), lengths_of(s));
  for(std::size_t v = 0; v < change.size(); ++v)
    change[v] = std::abs(change[v] - before[v]);
  return change;
}

Transport transport(const Evolving_surface& s, const Flattened_star& star)
{
  const std::vector<double> change = curvature_changes(s, star);
  double sum = 0;
  for(std::size_t n = 0; n < star.size(); ++n)
    sum += change[star[n].neighbor];
  Transport result;
  for(std::size_t n = 0; n < star.size(); ++n) {
    result.share[star[n].neighbor] = change[star[n].neighbor] / sum;
    result.cost += change[star[n].neighbor] / sum * star[n].length;
  }
  return result;
}

bool has_repeated_neighbors(const Flattened_star& star)
{
  for(std::size_t n = 0; n < star.size(); ++n)
    if(star[n].first_with_neighbor != n || star[n].neighbor == star.center())
      return true;
  return false;
}

TEST(Transport_cost, first_removal_is_a_transport_of_curvature)
{
  int checked = 0;
  for(const Named_mesh& m : traced(meshes())) {
    const Evolving_surface s(m.mesh);
    const std::vector<double> curvature = curvatures(s);
    double sum = 0;
    for(double k : curvature)
      sum += std::abs(k);
    Flattened_star star;
    for(Vertex_index v : s.mesh().vertices()) {
      if(s.flatten(v, star) != Removal_status::possible || has_repeated_neighbors(star) ||
         std::abs(curvature[v]) < 1e-3)
        continue;
      Transport_cost cost(s);
      cost.add_curvature(s);
      const Transport expected = transport(s, star);
      EXPECT_NEAR(cost(star), std::abs(curvature[v]) / sum * expected.cost, angle_tolerance);
      cost.after_removal(star);
      EXPECT_NEAR(cost.total(), std::abs(curvature[v]) / sum * expected.cost, angle_tolerance);
      if(cost.number_of_masses() == 2)
        for(const auto& [j, share] : expected.share)
          for(const int sign : {1, -1}) {
            const double mass =
              positive(sign * curvature[j]) + share * positive(sign * curvature[v]);
            EXPECT_NEAR(cost.mass(j, sign < 0 ? 1 : 0), mass / sum, angle_tolerance);
          }
      ++checked;
    }
  }
  EXPECT_GT(checked, 100);
}

TEST(Transport_cost, weights_and_units)
{
  const Evolving_surface s(random_sphere(40, 1));
  std::vector<double> value(40);
  for(std::size_t v = 0; v < 40; ++v)
    value[v] = std::sin(static_cast<double>(v));
  Flattened_star star;
  ASSERT_EQ(s.flatten(Vertex_index(7), star), Removal_status::possible);
  const auto cost_of = [&](const auto& add) {
    Transport_cost cost(s);
    add(cost);
    return cost(star);
  };
  const double curvature = cost_of([&](Transport_cost& c) { c.add_curvature(s); });
  const double area = cost_of([&](Transport_cost& c) { c.add_area(s); });
  const double quantity = cost_of([&](Transport_cost& c) { c.add_quantity(value); });
  const double change = cost_of([&](Transport_cost& c) { c.add_area_change(s); });
  EXPECT_GT(area, 0);
  EXPECT_GT(change, 0);
  const auto add_all = [&](Transport_cost& c) {
    c.add_curvature(s, 0.5);
    c.add_area(s, 3);
    for(double& x : value)
      x *= 1e6; // its unit does not matter
    c.add_quantity(value, 2);
    c.add_area_change(s, 5);
  };
  EXPECT_NEAR(cost_of(add_all), 0.5 * curvature + 3 * area + 2 * quantity + 5 * change, 1e-14);
}

// ---- Functions ----

// Returns the integrals of products of the gradient with the gradients of the hat functions.
std::vector<double> flux_by_gradients(const Mesh& mesh, const std::vector<double>& value)
{
  std::vector<double> result(mesh.number_of_vertices(), 0);
  for(Face_index f : mesh.faces()) {
    std::array<Vertex_index, 3> v;
    std::copy_n(mesh.vertices_around_face(mesh.halfedge(f)).begin(), 3, v.begin());
    const auto side = [&](std::size_t k) { // across from corner k
      return mesh.point(v[(k + 2) % 3]) - mesh.point(v[(k + 1) % 3]);
    };
    const auto normal = CGAL::cross_product(side(0), side(1)); // twice the area long
    const auto gradient = [&](std::size_t k) {
      return CGAL::cross_product(normal, side(k)) / normal.squared_length();
    };
    auto sum = value[v[0]] * gradient(0);
    for(std::size_t k : {1u, 2u})
      sum += value[v[k]] * gradient(k);
    for(std::size_t k = 0; k < 3; ++k)
      result[v[k]] += sum * gradient(k) * std::sqrt(normal.squared_length()) / 2;
  }
  return result;
}

TEST(Transport_cost, masses_of_a_function_are_its_laplacian)
{
  for(unsigned int seed : seeds(5)) {
    const Mesh mesh = random_sphere(50, seed);
    std::vector<double> value;
    CGAL::Random random(seed);
    for(std::size_t v = 0; v < 50; ++v)
      value.push_back(random.get_double(-3, 5));
    const std::vector<double> flux = flux_by_gradients(mesh, value);
    double sum = 0;
    for(double x : flux)
      sum += std::abs(x);
    const Evolving_surface s(mesh);
    Transport_cost cost(s);
    cost.add_function(s, value, 3);
    ASSERT_EQ(cost.number_of_masses(), 2u);
    const double sign = (cost.mass(Vertex_index(0), 0) > 0) == (flux[0] > 0) ? 1 : -1;
    for(Vertex_index v : mesh.vertices()) // random triangles are not much narrower than a hundredth
      EXPECT_NEAR(cost.mass(v, 0) - cost.mass(v, 1), sign * 3 * flux[v] / sum, 1e-11);
  }
}

TEST(Transport_cost, a_constant_function_has_no_mass)
{
  const Evolving_surface s(random_sphere(40, 1));
  Transport_cost cost(s);
  cost.add_function(s, std::vector<double>(40, 7.5));
  EXPECT_EQ(cost.number_of_masses(), 0u);
}

TEST(Transport_cost, values_that_are_not_finite)
{
  const Evolving_surface s(random_sphere(40, 1));
  for(const double x :
      {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
    Transport_cost cost(s);
    std::vector<double> value(40, 7.5);
    value[11] = x;
    EXPECT_THROW(cost.add_function(s, value), IT::Invalid_input);
    EXPECT_THROW(cost.add_quantity(value), IT::Invalid_input);
    EXPECT_EQ(cost.number_of_masses(), 0u);
  }
}

// On a square of four by four cells a linear function flows in on one side and out on the other.
TEST(Transport_cost, a_linear_function_has_mass_at_the_boundary_only)
{
  const Mesh mesh = grid(4, 4, [](double x, double y) { return Point(x, y, 0); });
  std::vector<double> value;
  for(const Point& p : mesh.points())
    value.push_back(1 - 2 * p.x());
  const Evolving_surface s(mesh);
  Transport_cost cost(s);
  cost.add_function(s, value);
  for(Vertex_index v : s.mesh().vertices()) {
    const unsigned int i = v / 5, j = v % 5;
    const double share = i % 4 == 0 ? (j % 4 == 0 ? 1. / 16 : 1. / 8) : 0;
    EXPECT_NEAR(cost.mass(v, 0) + cost.mass(v, 1), share, 1e-15);
    EXPECT_NEAR(std::abs(cost.mass(v, 0) - cost.mass(v, 1)), share, 1e-15);
  }
}

TEST(Transport_cost, mass_is_kept)
{
  Evolving_surface s(perturbed(embedded_torus(6, 5), 0.4, 3));
  s.make_Delaunay();
  Transport_cost cost(s);
  cost.add_curvature(s, 2);
  cost.add_area(s);
  Flattened_star star;
  for(unsigned int v = 0; v < 30; ++v)
    if(s.flatten(Vertex_index(v), star) == Removal_status::possible &&
       s.remove(star) == Removal_status::possible)
      cost.after_removal(star);
  EXPECT_LT(s.mesh().number_of_vertices(), 10u);
  double curvature = 0, area = 0;
  for(Vertex_index v : s.mesh().vertices()) {
    curvature += cost.mass(v, 0) + cost.mass(v, 1);
    area += cost.mass(v, 2);
  }
  EXPECT_NEAR(curvature, 2, 1e-12);
  EXPECT_NEAR(area, 1, 1e-12);
}

TEST(Transport_cost, change_of_area)
{
  for(const Named_mesh& m : traced(meshes())) {
    const Evolving_surface s(m.mesh);
    Transport_cost cost(s);
    cost.add_area_change(s, 3);
    EXPECT_EQ(cost.number_of_masses(), 0u);
    const double area = area_of(s);
    Flattened_star star;
    for(Vertex_index v : s.mesh().vertices()) {
      if(s.flatten(v, star) != Removal_status::possible || has_repeated_neighbors(star))
        continue;
      const double change = std::abs(area_of(s.mesh(), flattened(s, star)) - area);
      // The brute-force method does not know shares if nothing changes.
      const double length = change < 1e-6 * area ? 1 : transport(s, star).cost;
      EXPECT_NEAR(cost(star), 3 * change / area * length, angle_tolerance);
    }
  }
}

TEST(Transport_cost, of_a_flat_surface_without_data_is_zero)
{
  const Evolving_surface s(triangulation(flat_torus(4, 5, 1)));
  Transport_cost cost(s);
  cost.add_curvature(s);
  EXPECT_EQ(cost.number_of_masses(), 0u);
  Flattened_star star;
  ASSERT_EQ(s.flatten(Vertex_index(0), star), Removal_status::possible);
  EXPECT_EQ(cost(star), 0);
}

// ---- Many removals on a flat torus, where vectors are vectors of the plane ----

using Complex = std::complex<double>;

class Flat_transport
{
public:
  Flat_transport(const Flat_surface& torus, std::vector<double> mass)
    : m_torus(torus), m_mass(std::move(mass)), m_moment(m_mass.size())
  {}

  // Returns the vector of an edge. Among the vectors between lifts of its ends, it has the length
  // of the edge.
  Complex vector(const Evolving_surface& s, Halfedge_index h) const
  {
    const Vector from = m_torus.point[s.mesh().source(h)], to = m_torus.point[s.mesh().target(h)];
    Complex best;
    double closest = 1e9;
    for(int a = -6; a <= 6; ++a)
      for(int b = -6; b <= 6; ++b) {
        const Complex z = complex(to - from + a * m_torus.a + b * m_torus.b);
        if(const double error = std::abs(std::abs(z) - s.surface().length(h)); error < closest) {
          closest = error;
          best = z;
        }
      }
    EXPECT_LT(closest, 1e-8);
    return best;
  }

  std::map<Vertex_index, Complex> moments(const Evolving_surface& s, Vertex_index i) const
  {
    const std::vector<Halfedge_index> outgoing_halfedges = outgoing_halfedges_to_others(s, i);
    std::map<Vertex_index, Complex> result;
    for(Halfedge_index h : outgoing_halfedges)
      result[s.mesh().target(h)] = m_moment[s.mesh().target(h)];
    for(Halfedge_index h : outgoing_halfedges) // what comes from i comes from its center
      result[s.mesh().target(h)] +=
        (m_moment[i] - m_mass[i] * vector(s, h)) / static_cast<double>(outgoing_halfedges.size());
    return result;
  }

  double cost(const Evolving_surface& s, Vertex_index i) const
  {
    double sum = 0;
    for(const auto& [j, moment] : moments(s, i))
      sum += std::abs(moment);
    return sum;
  }

  void remove(const Evolving_surface& s, Vertex_index i)
  {
    for(const auto& [j, moment] : moments(s, i))
      m_moment[j] = moment;
    const std::vector<Halfedge_index> outgoing_halfedges = outgoing_halfedges_to_others(s, i);
    for(Halfedge_index h : outgoing_halfedges)
      m_mass[s.mesh().target(h)] += m_mass[i] / static_cast<double>(outgoing_halfedges.size());
  }

private:
  static std::vector<Halfedge_index> outgoing_halfedges_to_others(const Evolving_surface& s,
                                                                  Vertex_index i)
  {
    std::vector<Halfedge_index> result;
    for(Halfedge_index h : s.mesh().halfedges())
      if(s.mesh().source(h) == i && s.mesh().target(h) != i)
        result.push_back(h);
    return result;
  }

  const Flat_surface& m_torus;
  std::vector<double> m_mass;
  std::vector<Complex> m_moment;
};

// Returns masses whose sum is one.
std::vector<double> random_masses(std::size_t n, unsigned int seed)
{
  CGAL::Random random(seed);
  std::vector<double> mass(n);
  double sum = 0;
  for(double& m : mass)
    sum += m = random.get_double();
  for(double& m : mass)
    m /= sum;
  return mass;
}

TEST(Transport_cost, on_a_flat_torus_vectors_lead_to_centers_of_mass)
{
  for(unsigned int seed : seeds(10)) {
    const Flat_surface torus = flat_torus(5, 4, seed);
    Evolving_surface s(triangulation(torus));
    s.make_Delaunay();
    const std::vector<double> mass = random_masses(20, seed);
    Transport_cost cost(s);
    cost.add_quantity(mass);
    Flat_transport expected(torus, mass);
    Flattened_star star;
    for(unsigned int i = 0; i < 20; ++i) {
      const Vertex_index v((7 * i) % 20);
      if(s.flatten(v, star) != Removal_status::possible)
        continue;
      // Vectors are as long as edges, and directions have been computed hundreds of times.
      EXPECT_NEAR(cost(star), expected.cost(s, v), 1e-8) << "after " << i << " removals";
      Evolving_surface before = s;
      if(s.remove(star) != Removal_status::possible)
        continue;
      expected.remove(before, v);
      cost.after_removal(star);
    }
    EXPECT_EQ(s.mesh().number_of_vertices(), 1u);
  }
}

} // namespace Test_transport_cost
