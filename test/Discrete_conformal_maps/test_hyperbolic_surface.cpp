// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "flat_maps.h"

#include <CGAL/Discrete_conformal_maps/triangulation_on_hyperbolic_surface.h>
#include <CGAL/Discrete_conformal_maps/uniformize_hyperbolic.h>

#if __has_include(<CGAL/Triangulation_on_hyperbolic_surface_2.h>)
#include <CGAL/Exact_rational.h>
#include <CGAL/Hyperbolic_Delaunay_triangulation_traits_2.h>
#include <CGAL/Hyperbolic_surface_traits_2.h>
#include <CGAL/Simple_cartesian.h>
#endif

namespace Test_hyperbolic_surface {

using namespace Test_surfaces;

#if __has_include(<CGAL/Triangulation_on_hyperbolic_surface_2.h>)

template <typename FT>
using Traits = CGAL::Hyperbolic_surface_traits_2<
  CGAL::Hyperbolic_Delaunay_triangulation_traits_2<CGAL::Simple_cartesian<FT>>>;
template <typename FT>
using On_surface = CGAL::Triangulation_on_hyperbolic_surface_2<Traits<FT>>;

template <typename Point>
std::complex<double> complex_of(const Point& p)
{
  return {CGAL::to_double(p.x()), CGAL::to_double(p.y())};
}

// Returns the cross ratio of positions in the disk, with the face beyond `h` moved beside its face.
std::complex<double> cross_ratio(Halfedge_index h, const DCM::Hyperbolic_conformal_map& map)
{
  const Delta_complex& mesh = map.ideal().mesh();
  const auto a = map.position(mesh.next(h)), b = map.position(mesh.prev(h)), c = map.position(h),
             d = map.gluing(h)(map.position(mesh.prev(mesh.opposite(h))));
  return (d - b) * (c - a) / ((d - a) * (c - b));
}

// Returns the angle at p between geodesics to q and r, which are rays if p is moved to the origin.
double angle(std::complex<double> p, std::complex<double> q, std::complex<double> r)
{
  const auto moved = [&](std::complex<double> z) { return (z - p) / (1. - std::conj(p) * z); };
  return std::arg(moved(r) / moved(q));
}

template <typename FT>
void check(const DCM::Hyperbolic_conformal_map& map, double tolerance)
{
  On_surface<FT> t = DCM::triangulation_on_hyperbolic_surface<Traits<FT>>(map);
  const Delta_complex& mesh = map.ideal().mesh();
  ASSERT_TRUE(t.is_valid());
  EXPECT_TRUE(t.has_anchor());
  EXPECT_EQ(t.combinatorial_map().number_of_darts(), mesh.number_of_halfedges());
  std::size_t vertices = 0, edges = 0;
  std::vector<std::array<double, 2>> found, expected;
  for(auto v = t.vertices_range().begin(); v != t.vertices_range().end(); ++v)
    ++vertices;
  for(auto e = t.edges_range().begin(); e != t.edges_range().end(); ++e) {
    const auto x = t.get_cross_ratio(e);
    EXPECT_LT(CGAL::to_double(x.imag()), 1e-9); // Delaunay
    found.push_back({CGAL::to_double(x.real()), CGAL::to_double(x.imag())});
    ++edges;
  }
  EXPECT_EQ(vertices, mesh.number_of_vertices());
  EXPECT_EQ(edges, mesh.number_of_edges());
  for(Edge_index e : mesh.edges()) {
    const std::complex<double> x = cross_ratio(mesh.halfedge(e), map);
    expected.push_back({x.real(), x.imag()});
  }
  std::sort(found.begin(), found.end());
  std::sort(expected.begin(), expected.end());
  for(std::size_t i = 0; i < found.size(); ++i)
    EXPECT_NEAR(found[i][0], expected[i][0], tolerance * (1 + std::abs(expected[i][0])));
  // Positions follow from cross ratios, and areas add up by Gauss and Bonnet.
  double area = 0;
  const auto lifted = t.lift(false);
  EXPECT_EQ(lifted.size(), mesh.number_of_faces());
  for(const auto& [dart, p, q, r] : lifted) {
    const std::complex<double> a = complex_of(p), b = complex_of(q), c = complex_of(r);
    area += pi - angle(a, b, c) - angle(b, c, a) - angle(c, a, b);
    EXPECT_GT(angle(a, b, c), 0);
  }
  EXPECT_NEAR(area, map.group(0).area, tolerance * double(lifted.size()));
}

TEST(Hyperbolic_surface, of_CGAL_has_the_cross_ratios_and_area)
{
  for(const int genus : {2, 3}) {
    const DCM::Hyperbolic_conformal_map map = DCM::uniformize_hyperbolic(plate_with_holes(genus));
    ASSERT_EQ(map.status(), DCM::Map_status::success);
    check<double>(map, 1e-5);
    check<CGAL::Exact_rational>(map, 1e-5);
  }
}

TEST(Hyperbolic_surface, of_CGAL_can_be_flipped_back)
{
  typedef CGAL::Exact_rational FT;
  const DCM::Hyperbolic_conformal_map map = DCM::uniformize_hyperbolic(plate_with_holes(2));
  On_surface<FT> t = DCM::triangulation_on_hyperbolic_surface<Traits<FT>>(map);
  t.make_Delaunay(); // rounded ties
  EXPECT_TRUE(t.is_Delaunay());
}

// A surface with boundary is doubled, and a surface with cones is rejected.
TEST(Hyperbolic_surface, of_CGAL_has_no_boundary_and_no_cones)
{
  const DCM::Hyperbolic_conformal_map doubled =
    DCM::uniformize_hyperbolic(punctured(plate_with_holes(2), {3}));
  const auto t = DCM::triangulation_on_hyperbolic_surface<Traits<double>>(doubled);
  EXPECT_TRUE(t.is_valid());
  EXPECT_EQ(t.lift(false).size(), doubled.ideal().mesh().number_of_faces());
  const Mesh mesh = octahedron();
  const Conditions cones(6, Vertex_condition::curvature(5));
  const DCM::Hyperbolic_conformal_map map =
    DCM::uniformize_hyperbolic(mesh, DCM::parameters::vertex_condition_map(as_map(cones)));
  EXPECT_THROW(DCM::triangulation_on_hyperbolic_surface<Traits<double>>(map), IT::Invalid_input);
}

#else

TEST(Hyperbolic_surface, of_CGAL) { GTEST_SKIP() << "this version of CGAL has no such surfaces"; }

#endif

} // namespace Test_hyperbolic_surface
