// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "equality.h"
#include "flat_changes.h"
#include "subdivision_checks.h"

#include <CGAL/Intrinsic_triangulations/Exact_Euclidean_geometry_traits.h>
#include <CGAL/Intrinsic_triangulations/flip_to.h>
#include <CGAL/Intrinsic_triangulations/function_transfer.h>
#include <CGAL/Intrinsic_triangulations/interpolation.h>
#include <CGAL/Intrinsic_triangulations/operators.h>
#include <CGAL/Intrinsic_triangulations/point_across.h>
#include <CGAL/Intrinsic_triangulations/refine.h>
#include <CGAL/Intrinsic_triangulations/trace_edge.h>

namespace Test_insertion_exact {

using namespace Test_surfaces;
using Test_flat_changes::Counts;
using Test_flat_changes::for_each_flat;

TEST(Insertion_exact, random_operations_against_brute_force)
{
  const Counts counts = for_each_flat(1000, [](Flat_insertion& flat) {
    flat.check_all();
    flat.check_courses();
  });
  for(std::size_t count : counts) {
    std::cout << count << ' ';
    EXPECT_GT(count, 200u);
  }
  std::cout << "flips, insertions into faces and on input edges, splits, removals\n";
}

TEST(Insertion_exact, removal_of_all)
{
  for_each_flat(600, [](Flat_insertion& flat) {
    const Triangulation& t = flat.triangulation();
    bool goes_on = true;
    while(goes_on) { // one that is held by constrained edges may wait for others
      goes_on = false;
      for(std::size_t v = t.input_mesh().num_vertices(); v < t.mesh().num_vertices(); ++v)
        goes_on |= flat.remove(Vertex_index(static_cast<Delta_complex::size_type>(v)));
    }
    flat.check_all();
    Triangulation rest = flat.result().triangulation;
    ASSERT_EQ(rest.number_of_inserted_vertices(), 0u);
    EXPECT_EQ(rest.mesh().number_of_edges(), rest.input_mesh().number_of_edges());
    flip_to_input(rest);
    EXPECT_TRUE(rest.is_valid(true));
    expect_equal_to_input(rest);
  });
}

// ---- Correspondence ----

void check_subdivision(const Triangulation& t)
{
  const Correspondence c(t);
  const Subdivision s(c);
  check_numbers(s, c);
  check_measures(s, t);
}

// Checks that on every vertex the sum over the other triangulation is a third of the area around
// it.
void check_mixed_mass(const Triangulation& t)
{
  const auto mixed = IT::mixed_mass_matrix(Correspondence(t));
  const Eigen::VectorXd rows = mixed * Eigen::VectorXd::Ones(mixed.cols()),
                        columns = mixed.transpose() * Eigen::VectorXd::Ones(mixed.rows());
  for(Side side : both_sides) {
    const Flat_faces faces(side, t);
    std::vector<Real> third(faces.mesh().number_of_vertices(), 0);
    for(Face_index f : faces.mesh().faces())
      for(Halfedge_index h : faces.sides(f))
        third[faces.mesh().source(h)] += faces.area(f) / 3;
    const Eigen::VectorXd& sums = side == Side::input ? columns : rows;
    for(Vertex_index v : faces.mesh().vertices())
      EXPECT_NEAR(sums[Eigen::Index(v.idx())] / double(third[v]), 1, 1e-10) << v;
  }
}

void check_points_across(const Flat_insertion::Result& r, const Flat_surface& surface)
{
  const Correspondence c(r.triangulation);
  CGAL::Random random(1);
  const double tolerance = 1e-10 * length(surface.vector[0]);
  for(int i = 0; i < 200; ++i)
    for(Side side : both_sides) {
      const Location p = random_location(c.mesh(side), random);
      const Location q = IT::point_across(c, side, p);
      const Location &on_input = side == Side::input ? p : q,
                     &on_intrinsic = side == Side::input ? q : p;
      const auto h = IT::sides(on_input.first, surface.mesh);
      // This is the position on T2 as seen from the corner of the face of T1.
      const Place offset = Real(on_input.second[1]) *
                             Place{Real(surface.vector[h[0]].x), Real(surface.vector[h[0]].y)} -
                           Real(on_input.second[2]) *
                             Place{Real(surface.vector[h[2]].x), Real(surface.vector[h[2]].y)};
      const auto x = IT::sides(on_intrinsic.first, r.triangulation.mesh());
      const Vector corner =
        r.point[r.triangulation.mesh().source(x[0])] - surface.point[surface.mesh.source(h[0])];
      const Place gap =
        Place{Real(corner.x), Real(corner.y)} - offset +
        Real(on_intrinsic.second[1]) * Place{Real(r.vector[x[0]].x), Real(r.vector[x[0]].y)} -
        Real(on_intrinsic.second[2]) * Place{Real(r.vector[x[2]].x), Real(r.vector[x[2]].y)};
      EXPECT_LT(double(Flat_insertion::reduced_norm(gap, {Real(surface.a.x), Real(surface.a.y)},
                                                    {Real(surface.b.x), Real(surface.b.y)})),
                tolerance)
        << i;
    }
}

// Checks that the curves of a correspondence equal curves that are traced one by one.
void check_traces(const Triangulation& t)
{
  const Correspondence c(t);
  for(Side side : both_sides)
    for(Halfedge_index h : c.mesh(side).halfedges()) {
      const auto many = IT::trace_edge(side, h, c);
      const auto one =
        side == Side::input ? IT::trace_input_edge(t, h) : IT::trace_intrinsic_edge(t, h);
      ASSERT_EQ(many.size(), one.size());
      const std::size_t n = many.size();
      for(std::size_t k = 0; k < n; ++k) {
        EXPECT_NEAR(on(side, many[k]).t, on(side, one[k]).t, 1e-9);
        EXPECT_EQ(on(side, many[k]).halfedge, h);
        EXPECT_EQ(on(side, one[k]).halfedge, h);
        const Edge_place &a = on(other(side), many[k]), &b = on(other(side), one[k]);
        const bool is_crossing = k > 0 && k + 1 < n && b.t > 0 && b.t < 1;
        if(is_crossing) {
          EXPECT_EQ(a.halfedge, b.halfedge);
          EXPECT_NEAR(a.t, b.t, 1e-9);
        }
      }
    }
}

// Checks that coordinates in the plane are linear on both triangulations.
void check_interpolation(const Flat_insertion::Result& r, const Flat_surface& surface)
{
  const Triangulation& t = r.triangulation;
  const Subdivision s{Correspondence(t)};
  const auto values = [](const std::vector<Vector>& points) {
    Eigen::VectorXd result(Eigen::Index(points.size()));
    for(std::size_t i = 0; i < points.size(); ++i)
      result[Eigen::Index(i)] = double(points[i].x) + 2 * double(points[i].y);
    return result;
  };
  const auto from_input = IT::interpolation_matrix(Side::input, s);
  const auto from_intrinsic = IT::interpolation_matrix(Side::intrinsic, s);
  const Eigen::VectorXd a = from_input * values(surface.point),
                        b = from_intrinsic * values(r.point);
  EXPECT_LT((a - b).cwiseAbs().maxCoeff(), 1e-10 * b.cwiseAbs().maxCoeff());
  for(const auto* matrix : {&from_input, &from_intrinsic}) {
    const Eigen::VectorXd sums = *matrix * Eigen::VectorXd::Ones(matrix->cols());
    EXPECT_LT((sums.array() - 1).abs().maxCoeff(), 1e-15);
  }
}

TEST(Insertion_exact, correspondence_on_flat_surfaces)
{
  for_each_flat(500, [](Flat_insertion& flat) {
    const Flat_insertion::Result r = flat.result();
    check_subdivision(r.triangulation);
    check_traces(r.triangulation);
    check_mixed_mass(r.triangulation);
    check_points_across(r, flat.surface());
    if(flat.surface().b.x == 0 && flat.surface().a.y == 0 &&
       flat.surface().a.x == flat.surface().b.y) // in the plane
      check_interpolation(r, flat.surface());
  });
}

TEST(Insertion_exact, correspondence_after_refinement)
{
  for(const Named_triangulation& named : traced(triangulations())) {
    Triangulation t(named.triangulation);
    IT::refine(t);
    check_subdivision(t);
    check_traces(t);
    check_mixed_mass(t);
    expect_equal(t, triangulation_of(text_of(t)));
  }
}

// ---- Faces without area ----

// Returns two faces with area, and six on a line between them.
Mesh sliding_triangles()
{
  return make_mesh(
    {{4, -2, 0}, {6, 0, 0}, {4, 0, 0}, {2, 0, 0}, {1, 0, 0}, {3, 0, 0}, {5, 0, 0}, {3, 2, 0}},
    {{0, 1, 2}, {0, 2, 3}, {3, 2, 4}, {2, 1, 6}, {2, 6, 4}, {4, 6, 5}, {5, 6, 7}, {4, 5, 7}});
}

Place in_plane(const Location& p, const Mesh& mesh, const Delta_complex& input)
{
  Place result{0, 0};
  const auto h = IT::sides(p.first, input);
  for(std::size_t k = 0; k < 3; ++k) {
    const Point& corner = mesh.point(input.source(h[k]));
    result = result + Real(p.second[k]) * Place{Real(corner.x()), Real(corner.y())};
  }
  return result;
}

// Checks that points are mapped back to themselves. A point of a face without area can return in
// another one.
void check_there_and_back(const Triangulation& t, const Mesh& mesh, int points)
{
  const Correspondence c(t);
  const Flat_faces faces(Side::intrinsic, t);
  CGAL::Random random(1);
  for(int i = 0; i < points; ++i) {
    const Location p = random_location(t.input_mesh(), random);
    const Location p_back =
      IT::point_across(c, Side::intrinsic, IT::point_across(c, Side::input, p));
    EXPECT_LT(
      double(norm(in_plane(p, mesh, t.input_mesh()) - in_plane(p_back, mesh, t.input_mesh()))),
      1e-12)
      << i;
    const Location q = random_location(t.mesh(), random);
    const Location q_back =
      IT::point_across(c, Side::input, IT::point_across(c, Side::intrinsic, q));
    EXPECT_LT(double(faces.path(q, q_back)), 1e-12) << i;
  }
}

void insert_and_flip_at_random(Triangulation& t, unsigned int seed)
{
  CGAL::Random random(seed);
  Inserter inserter(t);
  for(unsigned int i = 0; i < 1 + seed % 40; ++i) {
    inserter.insert(random_location(t.mesh(), random), 1e-6);
    if(const Halfedge_index h = random_halfedge(t.mesh(), random); t.is_flippable(h))
      inserter.flip(h);
  }
}

TEST(Insertion_exact, points_across_where_input_faces_have_no_area)
{
  const Mesh mesh = sliding_triangles();
  for(double radius : traced({10., 1., 0.3, 0.1})) {
    Triangulation t(mesh);
    IT::refine(t, IT::parameters::maximum_circumradius(radius));
    EXPECT_TRUE(t.is_valid(true));
    check_there_and_back(t, mesh, 2000);
  }
  for(unsigned int seed : seeds(100)) {
    Triangulation t(mesh);
    IT::make_Delaunay(t);
    insert_and_flip_at_random(t, seed);
    EXPECT_TRUE(t.is_valid(true));
    check_there_and_back(t, mesh, 200);
  }
}

// ---- What cannot be done changes nothing ----

template <typename Error>
void expect_refusal(const Triangulation& t, const std::function<void()>& operation)
{
  const std::vector<double> before = state(t);
  EXPECT_THROW(operation(), Error);
  EXPECT_TRUE(state(t) == before);
  EXPECT_TRUE(t.is_valid(true));
}

TEST(Insertion_exact, places_without_room_change_nothing)
{
  Triangulation t(cube());
  flip_at_random(t, 100, 1);
  Inserter inserter(t);
  const double tiny = 1e-320;
  for(Face_index f(0); f.idx() < 6; ++f) {
    expect_refusal<IT::Numerical_error>(t, [&] { inserter.insert({f, {1, tiny, tiny}}); });
    expect_refusal<IT::Numerical_error>(t, [&] { inserter.insert({f, {tiny, 1, 0}}); });
  }
  const Triangulation original(t);
  for(Edge_index e : original.mesh().edges())
    for(double place : {tiny, 1 - 1e-17 / 4 - tiny})
      if(place < 1)
        expect_refusal<IT::Numerical_error>(
          t, [&] { inserter.split_edge(t.mesh().halfedge(e), place); });
  inserter.insert({Face_index(0), {0.5, 0.25, 0.25}}); // it goes on
  EXPECT_TRUE(t.is_valid(true));
}

// Returns a triangulation whose edge 0 is a side of one or two triangles. Their apices are closer
// to its midpoint than the least length.
template <typename Traits = IT::Euclidean_geometry_traits<double>>
IT::Intrinsic_triangulation<Traits> with_near_apices(int triangles)
{
  Mesh mesh;
  const auto i = mesh.add_vertex({0, 0, 0}), j = mesh.add_vertex({1, 0, 0});
  mesh.add_face(i, j, mesh.add_vertex({0.5, 0x1p-128, 0}));
  if(triangles == 2)
    mesh.add_face(j, i, mesh.add_vertex({0.5, -0x1p-128, 0}));
  IT::Intrinsic_triangulation<Traits> result(mesh);
  result.set_constrained(Edge_index(0), true);
  return result;
}

TEST(Insertion_exact, splits_with_a_near_apex_change_nothing)
{
  for(int triangles : traced({1, 2}))
    for(Halfedge_index h : traced({Halfedge_index(0), Halfedge_index(1)})) {
      Triangulation t = with_near_apices(triangles);
      Inserter inserter(t, true);
      expect_refusal<IT::Numerical_error>(t, [&] { inserter.split_edge(h, 0.5); });
      inserter.split_edge(h, 0.25); // it goes on
      EXPECT_TRUE(t.is_valid(true));
      EXPECT_EQ(t.mesh().number_of_faces(), 2u * static_cast<unsigned int>(triangles));

      typedef IT::Exact_Euclidean_geometry_traits<> Exact;
      auto exact = with_near_apices<Exact>(triangles);
      EXPECT_THROW(IT::Vertex_inserter<Exact>(exact).split_edge(h, 0.5), IT::Numerical_error);
      EXPECT_TRUE(exact.is_valid(true));
      expect_equal(exact.mesh(), exact.input_mesh());
    }
}

// Parts of an edge can be halved until no number is between their ends.
TEST(Insertion_exact, halves_of_halves)
{
  Triangulation t(tetrahedron());
  Inserter inserter(t);
  const Halfedge_index h(0);
  const double length = t.length(t.mesh().edge(h));
  int halves = 0;
  try {
    for(; halves < 2000; ++halves) {
      inserter.split_edge(h, 0.5); // h is the second half
      ASSERT_EQ(t.length(t.mesh().edge(h)), std::ldexp(length, -halves - 1));
      ASSERT_EQ(t.start_on_outgoing(h).t, 1 - std::ldexp(1., -halves - 1));
    }
  } catch(const IT::Numerical_error&) {
  }
  EXPECT_GE(halves, 50);
  EXPECT_LE(halves, 53); // digits of double
  EXPECT_TRUE(t.is_valid(true));
}

TEST(Insertion_exact, overflow_changes_nothing)
{
  Triangulation t(octahedron());
  const std::int64_t most = (std::numeric_limits<std::int64_t>::max)() / 16;
  const Location place(Face_index(0), {0.5, 0.25, 0.25});
  for(std::size_t s = 0; s < 3; ++s) {
    IT::Face_split<std::int64_t> at{{0, 0, 0}, {0, 0, 0}};
    at.n[s] = most + 1;
    expect_refusal<IT::Overflow_error>(t, [&] { t.split_face(place, at, place); });
  }
  for(int part = 0; part < 4; ++part) {
    IT::Edge_split<std::int64_t> n{0, 0, 0, 0};
    (part == 0 ? n.im : part == 1 ? n.mj : part == 2 ? n.mk : n.ml) = most + 1;
    expect_refusal<IT::Overflow_error>(t, [&] {
      t.split_edge(Halfedge_index(0), 0.5, n, {0, 0, 0, 0}, place);
    });
  }
}

// ---- Rounding ----

// Points are at crossings, and as close to them as numbers permit: some valid triangulation
// results. Strips that start at the first crossed edge do not lose half of the digits.
TEST(Insertion_exact, points_on_curves)
{
  for(const Named_mesh& m : traced(meshes()))
    for(int ulps : traced({-1, 0, 1})) {
      Triangulation t(m.mesh);
      flip_at_random(t, 10 * m.mesh.number_of_edges(), 1);
      const Triangulation before(t);
      const Correspondence c(before);
      Inserter inserter(t);
      for(Edge_index e : before.mesh().edges()) {
        if(t.coordinates().crossings(t.mesh().halfedge(e)) == 0)
          continue;
        const Halfedge_index h(2 * e.idx());
        const auto crossings = c.number_of_crossings(Side::intrinsic, e);
        double place = c.crossing(Side::intrinsic, h, crossings / 2).here.t;
        if(ulps != 0)
          place = std::nextafter(place, ulps);
        const auto edges = t.mesh().num_edges();
        inserter.split_edge(h, place, ulps == 0 ? 1e-9 : 0);
        ASSERT_EQ(t.mesh().num_edges(), edges + 3) << e;
        ASSERT_TRUE(t.is_valid(true)) << e;
      }
      Triangulation afresh(t);
      afresh.recompute_lengths();
      for(Edge_index e : t.mesh().edges())
        EXPECT_NEAR(afresh.length(e) / t.length(e), 1, 1e-11) << e;
    }
}

// ---- Files ----

TEST(Insertion_exact, damaged_places_in_files)
{
  Triangulation t(grid(2, 2, [](double x, double y) { return Point(x, y, 0); }));
  IT::refine(t, IT::parameters::maximum_circumradius(0.4));
  const std::string text = text_of(t);
  std::vector<std::string> lines;
  std::istringstream is(text);
  for(std::string line; std::getline(is, line);)
    lines.push_back(line);
  const std::size_t n = t.number_of_inserted_vertices(), first = lines.size() - n;
  ASSERT_GT(n, 5u);
  const auto is_refused = [&](std::size_t line, const std::string& replacement) {
    std::vector<std::string> damaged(lines);
    damaged[line] = replacement;
    std::string joined;
    for(const std::string& l : damaged)
      joined += l + '\n';
    try {
      EXPECT_TRUE(triangulation_of(joined).is_valid(true)) << joined;
    } catch(const IT::File_format_error&) {
      return true;
    } catch(const IT::Invalid_input&) {
      return true;
    }
    return false;
  };
  const std::string third = " 0x1p-2 0x1p-2 0x1p-1";
  for(std::size_t i = first; i < lines.size(); ++i)
    for(const std::string& wrong :
        {std::string(), std::string("0"), "-1" + third, "-2 0" + third, "-1 1000000" + third,
         "1000000 0" + third, std::string("-1 0 0x1p-2 0x1p-2"), "-1 0" + third + " 0",
         std::string("-1 0 0x1p+0 0x1p+0 -0x1p+0"), std::string("-1 0 nan nan nan"),
         std::string("-1 0 0x0p+0 0x0p+0 0x0p+0"), std::string("-1 0 inf 0x0p+0 0x0p+0"),
         "0 0" + third})
      EXPECT_TRUE(is_refused(i, wrong)) << lines[i] << " -> " << wrong;
  EXPECT_TRUE(is_refused(first - 1, std::to_string(n - 1)));
  EXPECT_TRUE(is_refused(first - 1, std::to_string(n + 1)));
  EXPECT_TRUE(is_refused(first - 1, "-1"));
}

} // namespace Test_insertion_exact
