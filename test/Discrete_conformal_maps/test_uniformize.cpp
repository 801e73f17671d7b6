// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "flat_maps.h"

#include <CGAL/Discrete_conformal_maps/uniformize.h>

namespace Test_uniformize {

using namespace Test_surfaces;
using DCM::Surface_type;

// Returns the modulus in the standard fundamental domain of the modular group.
Complex reduced(Complex tau)
{
  for(;;) {
    tau -= std::round(tau.real());
    if(std::norm(tau) >= 1)
      return tau;
    tau = -1. / tau;
  }
}

Complex modulus(const Flat_surface& s)
{
  const Complex a(double(s.a.x), double(s.a.y)), b(double(s.b.x), double(s.b.y));
  return reduced(b / a);
}

DCM::Uniformization uniformize(const Delta_complex& mesh, const std::vector<double>& length)
{
  return DCM::uniformize(mesh, length_parameter(length));
}

TEST(Surface_type, is_that_of_known_surfaces)
{
  EXPECT_EQ(DCM::surface_type(tetrahedron()), Surface_type::sphere);
  EXPECT_EQ(DCM::surface_type(punctured(cube(), {0})), Surface_type::disk);
  EXPECT_EQ(DCM::surface_type(punctured(random_sphere(40, 1), {0, 30})), Surface_type::annulus);
  EXPECT_EQ(DCM::surface_type(embedded_torus(5, 4)), Surface_type::torus);
  EXPECT_EQ(DCM::surface_type(punctured(embedded_torus(5, 4), {0})), Surface_type::hyperbolic);
  EXPECT_EQ(DCM::surface_type(plate_with_holes(2)), Surface_type::hyperbolic);
  Mesh two = tetrahedron();
  two.add_vertex(Point(0, 0, 0));
  EXPECT_EQ(DCM::surface_type(two), Surface_type::sphere);
  two += tetrahedron();
  EXPECT_THROW(DCM::surface_type(two), IT::Invalid_input);
  EXPECT_THROW(DCM::surface_type(Mesh()), IT::Invalid_input);
}

// Other decorations of the same ideal polyhedron yield the same modulus.
TEST(Uniformize, flat_tori_have_their_modulus)
{
  for(const auto& [m, n] : {std::pair(4, 3), {7, 2}, {2, 9}}) {
    const Flat_surface torus = flat_torus(m, n, 5);
    Triangulation t = triangulation(torus);
    IT::make_Delaunay(t);
    for(const double bound : {0., 1.}) {
      CGAL::Random random(7);
      DCM::Penner_surface<double> surface(t.mesh(), t.length_map());
      std::vector<double> u(t.mesh().number_of_vertices()), length;
      for(double& x : u)
        x = bound * random.get_double(-1, 1);
      surface.scale(u);
      for(Edge_index e : surface.mesh().edges())
        length.push_back(surface.scaled_length(e));
      const DCM::Uniformization result = uniformize(surface.mesh(), length);
      EXPECT_EQ(result.type, Surface_type::torus);
      EXPECT_EQ(result.status(), DCM::Map_status::success);
      EXPECT_FALSE(result.hyperbolic());
      ASSERT_TRUE(result.modulus);
      EXPECT_LT(std::abs(*result.modulus - modulus(torus)), 1e-10) << m << ' ' << n << ' ' << bound;
    }
  }
}

// Scale factors are small: all triangles stay acute enough for the triangulation to be Delaunay.
TEST(Uniformize, cylinders_have_their_modulus)
{
  for(const int twists : {0, 3}) {
    const int n = 6, height = 700;
    Triangulation t = triangulation(flat_cylinder(n, twists, height));
    IT::make_Delaunay(t);
    CGAL::Random random(7);
    std::vector<double> u(t.mesh().number_of_vertices()), length;
    for(double& x : u)
      x = 0.02 * random.get_double(-1, 1);
    for(Edge_index e : t.mesh().edges())
      length.push_back(t.length(e) *
                       std::exp((u[t.mesh().vertex(e, 0)] + u[t.mesh().vertex(e, 1)]) / 2));
    const DCM::Uniformization result = uniformize(t.mesh(), length);
    EXPECT_EQ(result.type, Surface_type::annulus);
    ASSERT_TRUE(result.modulus);
    EXPECT_EQ(result.modulus->real(), 0);
    EXPECT_NEAR(result.modulus->imag(), height / (1000. * n), 1e-10);
  }
}

// Conformally, a torus with circles of radius 1 around one of radius 3 is flat with a quotient of
// sides sqrt(3^2 - 1). Squares of a coarse mesh approximate it.
TEST(Uniformize, tori_of_revolution_have_almost_their_modulus)
{
  const DCM::Uniformization result = DCM::uniformize(embedded_torus(120, 60));
  ASSERT_TRUE(result.modulus);
  EXPECT_NEAR(result.modulus->imag(), std::sqrt(8.), 0.01);
  EXPECT_NEAR(result.modulus->real(), 0, 1e-9);
}

TEST(Uniformize, others_become_hyperbolic)
{
  const DCM::Uniformization result = DCM::uniformize(plate_with_holes(2));
  EXPECT_EQ(result.type, Surface_type::hyperbolic);
  EXPECT_FALSE(result.flat());
  ASSERT_TRUE(result.hyperbolic());
  EXPECT_EQ(result.hyperbolic()->group(0).genus, 2u);
  EXPECT_EQ(result.status(), DCM::Map_status::success);
  EXPECT_TRUE(DCM::uniformize(punctured(embedded_torus(5, 4), {0})).hyperbolic());
  EXPECT_EQ(DCM::uniformize(straight_plate_with_holes(200)).status(), DCM::Map_status::not_glued);
}

TEST(Uniformize, simply_connected_surfaces_become_round)
{
  const DCM::Uniformization sphere = DCM::uniformize(tetrahedron());
  EXPECT_EQ(sphere.type, Surface_type::sphere);
  ASSERT_TRUE(sphere.spherical());
  EXPECT_EQ(sphere.status(), DCM::Map_status::success);
  EXPECT_TRUE(sphere.spherical()->certificate().is_convex());
  const DCM::Uniformization disk = DCM::uniformize(punctured(cube(), {0}));
  EXPECT_EQ(disk.type, Surface_type::disk);
  ASSERT_TRUE(disk.spherical());
  EXPECT_TRUE(disk.spherical()->is_disk());
}

} // namespace Test_uniformize
