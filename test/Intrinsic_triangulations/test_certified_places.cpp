// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "exact_flips.h"
#include "measuring.h"

#include <CGAL/Intrinsic_triangulations/certify_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/element_across.h>
#include <CGAL/Intrinsic_triangulations/enclose_crossing.h>
#include <CGAL/Intrinsic_triangulations/point_across.h>
#include <CGAL/Intrinsic_triangulations/refine.h>

#include <variant>

namespace Test_certified_places {

using namespace Test_surfaces;
using Rational = CGAL::Exact_rational;
using Exact_correspondence = IT::Correspondence<Exact_triangulation::Traits>;
using Exact_kernel = CGAL::Simple_cartesian<Rational>;
using Exact_point = Exact_kernel::Point_2;
using Interval = CGAL::Interval_nt<>;
using IT::Surface_element;

// ---- Planar meshes with whole coordinates ----

Mesh sheared(Mesh mesh, double shear)
{
  for(Vertex_index v : mesh.vertices()) {
    const Point p = mesh.point(v);
    mesh.point(v) = Point(p.x() + shear * p.y(), p.y(), 0);
  }
  return mesh;
}

// Stores the positions of the vertices of T2 of a planar mesh, in rational numbers.
struct Plane
{
  const Exact_triangulation& t;
  std::vector<Exact_point> point;

  Plane(const Exact_triangulation& t, const Mesh& mesh) : t(t)
  {
    for(const Point& p : mesh.points())
      point.emplace_back(p.x(), p.y());
    for(const auto& m : t.inserted_vertices())
      point.push_back(at(Side::input, IT::face_location(m, t.input_mesh())));
  }

  const Delta_complex& mesh(Side side) const { return t.surface(side).mesh(); }

  const Exact_point& source(Side side, Halfedge_index h) const
  {
    return point[mesh(side).source(h)];
  }

  // Returns the point with these coordinates, divided by their sum.
  Exact_point at(Side side, const Location& p) const
  {
    const auto h = IT::sides(p.first, mesh(side));
    Rational x(0), y(0), sum(0);
    for(std::size_t s = 0; s < 3; ++s) {
      const Rational w(p.second[s]);
      x += w * source(side, h[s]).x();
      y += w * source(side, h[s]).y();
      sum += w;
    }
    return {x / sum, y / sum};
  }

  // Returns the position at which the line of one halfedge crosses another, from its source (0) to
  // its target (1).
  Rational crossing(Side side, Halfedge_index h, Halfedge_index line) const
  {
    const Side across = other(side);
    const Exact_point &p = source(side, h), &q = source(side, IT::opposite(h));
    const Exact_point &a = source(across, line), &b = source(across, IT::opposite(line));
    const auto height = [&](const Exact_point& r) { return CGAL::determinant(b - a, r - a); };
    return height(p) / (height(p) - height(q));
  }

  // Returns the vertex, edge or face that contains `p`, by a test of all of them.
  Surface_element element(Side side, const Exact_point& p) const
  {
    for(Vertex_index v : mesh(side).vertices())
      if(point[v] == p)
        return v;
    for(Edge_index e : mesh(side).edges()) {
      const Halfedge_index h = mesh(side).halfedge(e);
      if(CGAL::are_strictly_ordered_along_line(source(side, h), p, source(side, IT::opposite(h))))
        return e;
    }
    for(Face_index f : mesh(side).faces()) {
      const auto h = IT::sides(f, mesh(side));
      bool is_inside = true;
      for(std::size_t s = 0; s < 3; ++s)
        is_inside =
          is_inside && CGAL::left_turn(source(side, h[s]), source(side, h[(s + 1) % 3]), p);
      if(is_inside)
        return f;
    }
    ADD_FAILURE() << "outside";
    return Face_index();
  }
};

void expect_encloses(const Interval& interval, const Rational& place, double width)
{
  EXPECT_LE(Rational(interval.inf()), place);
  EXPECT_GE(Rational(interval.sup()), place);
  EXPECT_TRUE(interval.sup() - interval.inf() <= width ||
              std::nextafter(std::nextafter(interval.inf(), 1), 1) >= interval.sup());
}

// ---- Crossings ----

void check_crossings(const Exact_triangulation& t, const Mesh& mesh)
{
  const Plane plane(t, mesh);
  const Exact_correspondence c(t);
  for(unsigned int id = 0; id < c.number_of_crossings(); ++id) {
    const auto rounded = c.crossing(id);
    const Halfedge_index input = rounded.on_input.halfedge,
                         intrinsic = rounded.on_intrinsic.halfedge;
    for(double width : {1., 0x1p-40, 0x1p-50, 0.}) {
      const auto place = IT::enclose_crossing(c, id, width);
      EXPECT_EQ(place.on_input.halfedge, input);
      EXPECT_EQ(place.on_intrinsic.halfedge, intrinsic);
      expect_encloses(place.on_input.t, plane.crossing(Side::input, input, intrinsic), width);
      expect_encloses(place.on_intrinsic.t, plane.crossing(Side::intrinsic, intrinsic, input),
                      width);
    }
  }
}

TEST(Certified_places, crossings_on_planar_meshes)
{
  std::size_t crossings = 0;
  for(unsigned int seed : seeds(12)) {
    Portable_random random(seed);
    const Mesh mesh = sheared(planar_mesh(random_points(12 + seed, 1000, seed)),
                              seed % 2 == 0 ? 0 : std::ldexp(1., 2 * static_cast<int>(seed)));
    Exact_triangulation t(mesh);
    shuffle(t, 100, random);
    check_crossings(t, mesh);
    IT::make_Delaunay(t);
    check_crossings(t, mesh);
    crossings += Exact_correspondence(t).number_of_crossings();
  }
  EXPECT_GT(crossings, 100u);
}

// A position next to the end of an edge needs as many digits as its exponent: in this case more
// than 512.
TEST(Certified_places, crossings_close_to_a_vertex)
{
  for(const int exponent : traced({100, 500, 650, 900})) {
    const double place = std::ldexp(1., -exponent);
    Mesh mesh;
    for(const Point& p :
        {Point(0, 0, 0), Point(1, 0, 0), Point(0, 0.25, 0), Point(2 * place, -0.25, 0)})
      mesh.add_vertex(p);
    mesh.add_face(Vertex_index(0), Vertex_index(1), Vertex_index(2));
    mesh.add_face(Vertex_index(1), Vertex_index(0), Vertex_index(3));
    Exact_triangulation t(mesh);
    t.flip(t.mesh().halfedge(IT::Vertex_index(0), IT::Vertex_index(1)));
    const auto crossing = IT::enclose_crossing(Exact_correspondence(t), 0, 0);
    const bool is_first = t.input_mesh().source(crossing.on_input.halfedge) == IT::Vertex_index(0);
    const Interval t_from_0 = is_first ? crossing.on_input.t : Interval(1) - crossing.on_input.t;
    EXPECT_LE(t_from_0.inf(), place);
    EXPECT_GE(t_from_0.sup(), place);
    EXPECT_LE(t_from_0.sup() - t_from_0.inf(), is_first ? place * 0x1p-50 : 0x1p-50);
  }
}

// With squared lengths alone, each triangle has a separate root.
TEST(Certified_places, crossings_on_abstract_surfaces)
{
  for(unsigned int seed : seeds(6)) {
    Portable_random random(seed);
    Mesh mesh = planar_mesh(random_points(14, 300, seed));
    auto square = mesh.add_property_map<Edge_index, Rational>("e:square").first;
    for(Edge_index e : mesh.edges())
      square[e] =
        CGAL::squared_distance(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1)));
    Exact_triangulation t(mesh, IT::parameters::squared_edge_length_map(square));
    shuffle(t, 60, random);
    check_crossings(t, mesh);
  }
}

// ---- Rounded places ----

// Faces are so thin that lengths of type `double` hardly determine their height, so the positions
// are computed from coordinates.
TEST(Certified_places, rounded_places_in_thin_faces)
{
  std::size_t crossings = 0;
  for(unsigned int seed : seeds(10)) {
    Mesh mesh = planar_mesh(random_points(20 + seed, 1000, seed));
    for(Vertex_index v : mesh.vertices())
      mesh.point(v) = Point(mesh.point(v).x(),
                            std::ldexp(mesh.point(v).y(), -10 - 3 * static_cast<int>(seed)), 0);
    Exact_triangulation t(mesh);
    IT::make_Delaunay(t);
    const Plane plane(t, mesh);
    const Exact_correspondence c(t);
    crossings += c.number_of_crossings();
    for(unsigned int id = 0; id < c.number_of_crossings(); ++id) {
      const auto rounded = c.crossing(id);
      const Halfedge_index input = rounded.on_input.halfedge,
                           intrinsic = rounded.on_intrinsic.halfedge;
      const auto error = [&](double place, const Rational& exact) {
        return std::abs(CGAL::to_double(Rational(Rational(place) - exact)));
      };
      EXPECT_LT(error(rounded.on_input.t, plane.crossing(Side::input, input, intrinsic)), 1e-9);
      EXPECT_LT(error(rounded.on_intrinsic.t, plane.crossing(Side::intrinsic, intrinsic, input)),
                1e-9);
    }
  }
  EXPECT_GT(crossings, 100u);
}

// Checks the distance of rounded positions from the intervals, relative to the longest edge.
// Surfaces are stretched tori, and meshes at the limits of `double`, with lengths of type `double`.
void check_rounded_places(const Mesh& mesh)
{
  Triangulation t(mesh);
  IT::make_Delaunay(t, IT::parameters::exact_decisions(true));
  const IT::Correspondence<> c(t);
  double longest = 0;
  for(Edge_index e : t.input_mesh().edges())
    longest = (std::max)(longest, t.input_length(e));
  const auto distance = [](double place, const Interval& exact) {
    return (std::max)({0., exact.inf() - place, place - exact.sup()});
  };
  EXPECT_LT(IT::certify_places(c).greatest_error, 1e-8);
  for(Edge_index e : t.mesh().edges()) {
    const auto exact = IT::enclose_crossings(c, e);
    ASSERT_EQ(exact.size(), c.number_of_crossings(Side::intrinsic, e));
    for(unsigned int p = 0; p < exact.size(); ++p) {
      const auto rounded = c.crossing(c.crossings_on_intrinsic().before(e) + p);
      const double on_input = t.input_length(Edge_index(rounded.on_input.halfedge));
      EXPECT_LT(distance(rounded.on_input.t, exact[p].on_input.t) * on_input, 1e-8 * longest) << e;
      EXPECT_LT(distance(rounded.on_intrinsic.t, exact[p].on_intrinsic.t) * t.length(e),
                1e-8 * longest)
        << e;
    }
  }
}

TEST(Certified_places, rounded_places_on_hard_meshes)
{
  for(std::uint64_t seed : seeds(24))
    check_rounded_places(hard_mesh(seed).mesh);
  for(unsigned int seed : seeds(4)) {
    Mesh mesh = perturbed(embedded_torus(12, 9), 0.2, seed);
    for(Vertex_index v : mesh.vertices()) {
      const Point p = mesh.point(v);
      mesh.point(v) = Point(p.x(), p.y() * std::pow(10, -5. - seed), p.z() * std::pow(10, -9.));
    }
    check_rounded_places(mesh);
  }
}

// ---- Hard meshes ----

// For almost degenerate faces, intervals are as narrow as requested, and ordered like the integers.
TEST(Certified_places, crossings_on_hard_meshes_are_in_order)
{
  for(std::uint64_t seed : seeds(24)) {
    Exact_triangulation t(hard_mesh(seed).mesh);
    IT::make_Delaunay(t);
    const Exact_correspondence c(t);
    for(Edge_index e : t.mesh().edges()) {
      double least = 0;
      for(unsigned int p = 0; p < c.number_of_crossings(Side::intrinsic, e); ++p) {
        const unsigned int id = c.crossings_on_intrinsic().before(e) + p;
        const Interval place = IT::enclose_crossing(c, id).on_intrinsic.t;
        EXPECT_GE(place.sup(), least) << e;
        least = (std::max)(least, place.inf());
      }
    }
  }
}

// ---- Points ----

// Returns a location with small weights, some of them zero, so that many points lie on edges of the
// other side.
Location random_place(const Delta_complex& mesh, Portable_random& random)
{
  Location p{
    Face_index(static_cast<unsigned>(random.get_int(0, static_cast<int>(mesh.number_of_faces())))),
    {0, 0, 0}};
  while(p.second[0] + p.second[1] + p.second[2] == 0)
    for(double& x : p.second)
      x = random.get_int(0, 4);
  return p;
}

// Returns how many were vertices, edges and faces.
std::array<std::size_t, 3> check_elements(const Exact_triangulation& t, const Mesh& mesh,
                                          Portable_random& random)
{
  const Plane plane(t, mesh);
  const Exact_correspondence c(t);
  std::array<std::size_t, 3> count{};
  for(Side side : both_sides)
    for(int i = 0; i < 100; ++i) {
      const Location p = random_place(t.surface(side).mesh(), random);
      const Surface_element found = IT::element_across(c, side, p);
      EXPECT_EQ(found, plane.element(other(side), plane.at(side, p)));
      ++count[found.index()];
    }
  return count;
}

TEST(Certified_places, elements_on_planar_meshes)
{
  std::array<std::size_t, 3> sum{};
  for(unsigned int seed : seeds(20)) {
    Portable_random random(seed);
    const Mesh mesh =
      sheared(planar_mesh(random_points(5 + seed, 12 + static_cast<int>(seed), seed)), seed % 5);
    Exact_triangulation t(mesh);
    shuffle(t, 10 * seed, random);
    const auto count = check_elements(t, mesh, random);
    for(std::size_t k = 0; k < 3; ++k)
      sum[k] += count[k];
  }
  for(std::size_t n : sum)
    EXPECT_GT(n, 200u);
}

TEST(Certified_places, elements_with_inserted_vertices)
{
  std::array<std::size_t, 3> sum{};
  for(unsigned int seed : seeds(10)) {
    Portable_random random(seed);
    const Mesh mesh = sheared(planar_mesh(random_points(6 + seed, 20, seed)), seed % 3);
    Exact_triangulation t(mesh);
    IT::refine(t, IT::parameters::maximum_number_of_insertions(20));
    ASSERT_TRUE(IT::certify_Delaunay(t).is_geodesic());
    const auto count = check_elements(t, mesh, random);
    for(std::size_t k = 0; k < 3; ++k)
      sum[k] += count[k];
    // The inserted vertices themselves are tested, too.
    const Exact_correspondence c(t);
    for(Vertex_index v : t.mesh().vertices())
      if(t.is_inserted(v)) {
        EXPECT_EQ(IT::element_across(c, Side::input,
                                     IT::face_location(t.inserted_vertex(v), t.input_mesh())),
                  Surface_element(v));
      }
  }
  for(std::size_t n : sum)
    EXPECT_GT(n, 50u);
}

// The point computed in `double` lies in the exact face, if rounding permits a decision.
TEST(Certified_places, elements_agree_with_points_across)
{
  Portable_random random(1);
  for(int mesh = 0; mesh < 20; ++mesh) {
    Exact_triangulation t(hard_base(random));
    IT::make_Delaunay(t);
    const Exact_correspondence c(t);
    for(Side side : both_sides)
      for(int i = 0; i < 50; ++i) {
        Location p = random_place(t.surface(side).mesh(), random);
        const double sum = p.second[0] + p.second[1] + p.second[2];
        for(double& x : p.second)
          x /= sum;
        const Location across = IT::point_across(c, side, p);
        const auto& b = across.second;
        if((std::min)({b[0], b[1], b[2]}) > 1e-9) {
          EXPECT_EQ(IT::element_across(c, side, p), Surface_element(across.first));
        }
      }
  }
}

} // namespace Test_certified_places
