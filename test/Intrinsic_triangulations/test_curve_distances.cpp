// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "hard_meshes.h"
#include "known_surfaces.h"
#include "path_checks.h"

#include <CGAL/Intrinsic_triangulations/Shortest_paths.h>
#include <CGAL/Intrinsic_triangulations/Surface_curve.h>

// These tests check distances from curves.
namespace Test_curve_distances {

using namespace Test_surfaces;
using View = decltype(std::declval<Triangulation>().input());
using Paths = IT::Shortest_paths<View>;
using Segment = IT::Curve_segment<double>;
using Curve = IT::Surface_curve<double>;

Location point_on(const Segment& s, double t)
{
  Location result{s.face, {}};
  for(std::size_t k = 0; k < 3; ++k)
    result.second[k] = (1 - t) * s.source[k] + t * s.target[k];
  return result;
}

Paths paths_from(const View& surface, const Curve& curve)
{
  Paths result(surface);
  EXPECT_EQ(result.add_source(curve), 0u);
  result.run();
  return result;
}

// ---- The least of the distances to all points ----

// Returns the least distance. Distances from points are tested elsewhere, so a minimum over the
// curve is independent truth. It is searched by samples, and by sections between the neighbors of
// each sample that is lower than both.
double least_distance(const Paths& from_point, const Segment& s)
{
  constexpr int samples = 64;
  const auto at = [&](double t) { return from_point.distance(point_on(s, t)); };
  std::vector<double> value;
  for(int i = 0; i <= samples; ++i)
    value.push_back(at(double(i) / samples));
  double result = *std::min_element(value.begin(), value.end());
  for(int i = 0; i <= samples; ++i) {
    const auto k = static_cast<std::size_t>(i);
    if((i > 0 && value[k - 1] < value[k]) || (i < samples && value[k + 1] < value[k]))
      continue;
    double low = (std::max)(0., (i - 1.) / samples), high = (std::min)(1., (i + 1.) / samples);
    for(int step = 0; step < 60; ++step) {
      const double third = (high - low) / 3;
      (at(low + third) < at(high - third) ? high : low) +=
        at(low + third) < at(high - third) ? -third : third;
    }
    result = (std::min)(result, at((low + high) / 2));
  }
  return result;
}

Segment random_segment(const Delta_complex& mesh, int kind, CGAL::Random& random)
{
  const Location p = random_location(mesh, random);
  Segment result{p.first, p.second, random_location(mesh, random).second};
  const auto side = static_cast<std::size_t>(random.get_int(0, 3));
  if(kind % 4 == 1)
    result.source = IT::barycentric_coordinates(side, random.get_double());
  if(kind % 4 == 2) // from a corner to a side
    result = {p.first, IT::barycentric_coordinates(side, 0.),
              IT::barycentric_coordinates((side + 1) % 3, random.get_double())};
  if(kind % 4 == 3) // along a side
    result = {p.first, IT::barycentric_coordinates(side, 0.2),
              IT::barycentric_coordinates(side, kind % 8 == 3 ? 0.9 : 1.)};
  return result;
}

void check_by_minima(Side side, const Triangulation& t, unsigned int seed)
{
  const Flat_faces faces(side, t);
  const auto surface = t.surface(side);
  CGAL::Random random(seed);
  Curve curve;
  for(int i = 0; i < 3; ++i)
    curve.push_back(random_segment(faces.mesh(), static_cast<int>(seed) + i, random));
  const Paths paths = paths_from(surface, curve);
  const double tolerance = 1e-11 * static_cast<double>(faces.longest_edge());
  const auto check = [&](const auto& q) {
    Paths from_q(surface);
    from_q.add_source(q);
    from_q.run();
    double truth = std::numeric_limits<double>::infinity();
    for(const Segment& s : curve)
      truth = (std::min)(truth, least_distance(from_q, s));
    EXPECT_NEAR(paths.distance(q), truth, tolerance);
    const Path path = paths.path(q);
    ASSERT_FALSE(path.places.empty());
    expect_valid(path, faces, tolerance);
    EXPECT_NEAR(paths.distance(IT::face_location(path.places.front(), faces.mesh())), 0, tolerance);
    EXPECT_EQ(paths.source(q), 0u);
  };
  for(Vertex_index v : faces.mesh().vertices())
    check(v);
  for(int i = 0; i < 3; ++i)
    check(random_location(faces.mesh(), random));
}

TEST(Curve_distances, are_least_distances)
{
  for(const auto& [m, seed] : traced(small_meshes(), 8)) {
    Triangulation t(m.mesh);
    check_by_minima(Side::input, t, seed);
    flip_at_random(t, 10, seed);
    check_by_minima(Side::intrinsic, t, seed);
  }
}

TEST(Curve_distances, are_least_distances_on_Delta_complexes)
{
  for(const auto& [name, mesh] : traced(glued_complexes()))
    for(unsigned int seed : seeds(8))
      check_by_minima(Side::input, triangulation(mesh, random_lengths(mesh, seed)), seed);
}

// ---- Closed forms ----

// Returns the polyline through some points of a flat convex surface.
Curve polyline(const Triangulation& t, const Mesh& mesh, const std::vector<Point>& points)
{
  Curve result;
  for(std::size_t i = 0; i + 1 < points.size(); ++i) {
    const auto path =
      IT::shortest_path(t.input(), locate(points[i], mesh), locate(points[i + 1], mesh));
    const Curve part = IT::curve_through(t.input(), path.places);
    result.insert(result.end(), part.begin(), part.end());
  }
  return result;
}

double distance_from_segment(const Complex& p, const Complex& a, const Complex& b)
{
  const Complex d = b - a;
  const double s = d == 0. ? 0 : std::real((p - a) * std::conj(d)) / std::norm(d);
  return std::abs(p - a - std::clamp(s, 0., 1.) * d);
}

void check_in_plane(const std::vector<Point>& points, std::size_t n)
{
  const Mesh mesh = unit_square(n, 3);
  const Triangulation t(mesh);
  const Paths paths = paths_from(t.input(), polyline(t, mesh, points));
  const auto complex = [](const Point& p) { return Complex(p.x(), p.y()); };
  for(Vertex_index v : mesh.vertices()) {
    double truth = 2;
    for(std::size_t i = 0; i + 1 < points.size(); ++i)
      truth = (std::min)(truth, distance_from_segment(complex(mesh.point(v)), complex(points[i]),
                                                      complex(points[i + 1])));
    EXPECT_NEAR(paths.distance(v), truth, 1e-13) << v;
  }
}

TEST(Curve_distances, lines_and_polygons_in_the_plane)
{
  check_in_plane({Point(0.12, 0.23, 0), Point(0.81, 0.74, 0)}, 30);
  check_in_plane({Point(0, 0.5, 0), Point(1, 0.5, 0)}, 30);
  check_in_plane({Point(0.1, 0.2, 0), Point(0.8, 0.7, 0), Point(0.3, 0.9, 0), Point(0.3, 0.1, 0)},
                 30);
  std::vector<Point> circle;
  for(int k = 0; k <= 200; ++k)
    circle.emplace_back(0.5 + 0.3 * std::cos(k * pi / 100), 0.45 + 0.3 * std::sin(k * pi / 100), 0);
  check_in_plane(circle, 20);
}

// A segment starts so near to sides of its face that positions on them tell no directions. From the
// start, a right angle leads to a vertex, between the parallel rays and the rays from the start.
TEST(Curve_distances, at_right_angles_from_starts_near_sides)
{
  CGAL::Random random(1);
  const Mesh mesh = unit_square(6, 7);
  const Triangulation t(mesh);
  const auto position = [&](Vertex_index v) {
    return Complex(mesh.point(v).x(), mesh.point(v).y());
  };
  int checked = 0;
  for(int i = 0; i < 400; ++i) {
    const Face_index f = random_index<Face_index>(mesh.num_faces(), random);
    std::array<Complex, 3> corner;
    for(std::size_t k = 0; k < 3; ++k)
      corner[k] = position(t.input_mesh().source(IT::sides(f, t.input_mesh())[k]));
    const bool is_near_corner = i % 2 == 1;
    const double small = std::pow(10, random.get_double(-13, -1)),
                 along = is_near_corner ? 1 - small : random.get_double(0.1, 0.8),
                 height = is_near_corner ? small * random.get_double() : small;
    const auto s = static_cast<std::size_t>(random.get_int(0, 3));
    Segment segment{f, {}, {}};
    segment.source[s] = along;
    segment.source[(s + 1) % 3] = 1 - along - height;
    segment.source[(s + 2) % 3] = height;
    const auto at = [&](const std::array<double, 3>& b) {
      return b[0] * corner[0] + b[1] * corner[1] + b[2] * corner[2];
    };
    const Complex start = at(segment.source), side = corner[(s + 1) % 3] - corner[s];
    const auto v = random_index<Vertex_index>(mesh.num_vertices(), random);
    Complex d = (position(v) - start) * Complex(0, 1) / std::abs(position(v) - start);
    if(std::imag(d * std::conj(side)) < 0)
      d = -d;
    const Point end(start.real() + 1e-3 * d.real(), start.imag() + 1e-3 * d.imag(), 0);
    if((std::min)(end.x(), end.y()) < 0 || (std::max)(end.x(), end.y()) > 1)
      continue;
    if(const auto [face, place] = locate(end, mesh); face == f) {
      segment.target = place;
      ++checked;
      const Paths paths = paths_from(t.input(), {segment});
      for(Vertex_index w : mesh.vertices())
        EXPECT_NEAR(paths.distance(w), distance_from_segment(position(w), start, at(place)), 1e-13);
    }
  }
  EXPECT_GT(checked, 100);
}

// All rays of a source in a face without area run along its sides. Points count as segments, too.
TEST(Curve_distances, from_faces_without_area)
{
  Mesh mesh = grid(6, 6, [](double x, double y) { return Point(x / 8, y / 8, 0); });
  Portable_random choice(2);
  add_flat_faces(mesh, 0.6, choice);
  const Triangulation t(mesh);
  CGAL::Random random(3);
  const auto random_place = [&] {
    const double a = random.get_double(), b = random.get_double();
    return std::array<double, 3>{1 - (std::max)(a, b), (std::min)(a, b), std::abs(a - b)};
  };
  int checked = 0;
  for(Face_index f : mesh.faces()) {
    const auto side = IT::sides(f, t.input_mesh());
    const auto at = [&](const std::array<double, 3>& b) {
      Complex result(0);
      for(std::size_t k = 0; k < 3; ++k) {
        const Point& p = mesh.point(t.input_mesh().source(side[k]));
        result += b[k] * Complex(p.x(), p.y());
      }
      return result;
    };
    if(std::imag((at({0, 1, 0}) - at({1, 0, 0})) * std::conj(at({0, 0, 1}) - at({1, 0, 0}))) != 0)
      continue;
    Segment s{f, random_place(), random_place()};
    if(checked++ % 2 == 0)
      s.target = s.source;
    const Paths paths = paths_from(t.input(), {s});
    for(Vertex_index v : mesh.vertices())
      EXPECT_NEAR(paths.distance(v),
                  distance_from_segment(Complex(mesh.point(v).x(), mesh.point(v).y()), at(s.source),
                                        at(s.target)),
                  1e-14);
  }
  EXPECT_GT(checked, 10);
}

// Paths cross an edge between their ends, also if both ends are on the edge up to rounding.
TEST(Curve_distances, paths_along_edges_within_rounding)
{
  CGAL::Random random(4);
  const Mesh mesh = unit_square(6, 7);
  const Triangulation t(mesh);
  const Delta_complex& faces = t.input_mesh();
  const auto near = [&](Halfedge_index h, double along) {
    const double height = std::pow(10, random.get_double(-20, -14));
    const std::size_t s = IT::side_number(h, faces);
    Location result{faces.face(h), {}};
    result.second[s] = 1 - along;
    result.second[(s + 1) % 3] = along - height;
    result.second[(s + 2) % 3] = height;
    return result;
  };
  for(Edge_index e : faces.edges()) {
    const Halfedge_index h = faces.halfedge(e), o = faces.opposite(h);
    if(faces.is_border(h) || faces.is_border(o))
      continue;
    const double a = random.get_double(0.1, 0.9), b = random.get_double(0.1, 0.9);
    const double truth = std::abs(a - b) * get(t.input().length_map(), e);
    const Path path = IT::shortest_path(t.input(), near(h, a), near(o, 1 - b));
    EXPECT_NEAR(path.length, truth, 1e-13);
    EXPECT_NEAR(IT::curve_length(t.input(), IT::curve_through(t.input(), path.places)), truth,
                1e-13);
  }
}

// The distance of a polygon from the true circle is its sagitta.
TEST(Curve_distances, fine_circle_in_a_face)
{
  const Mesh mesh = make_mesh({Point(0, 0, 0), Point(4, 0, 0), Point(0, 4, 0)}, {{0, 1, 2}});
  const Triangulation t(mesh);
  const int n = 200000;
  const auto at = [&](int k) {
    const double angle = 2 * pi * (k % n) / n;
    return locate(Point(1 + 0.5 * std::cos(angle), 1 + 0.5 * std::sin(angle), 0), mesh).second;
  };
  Curve circle;
  for(int k = 0; k < n; ++k)
    circle.push_back({Face_index(0), at(k), at(k + 1)});
  const Paths paths = paths_from(t.input(), circle);
  EXPECT_NEAR(paths.distance(Vertex_index(0)), std::sqrt(2.) - 0.5, 1e-10);
  EXPECT_NEAR(paths.distance(Vertex_index(1)), std::sqrt(10.) - 0.5, 1e-10);
  EXPECT_NEAR(paths.distance(locate(Point(1, 1, 0), mesh)), 0.5, 1e-10);
}

// The sources are all boundary edges of a square. On an even grid, many rays run along edges.
TEST(Curve_distances, boundary_of_a_square)
{
  const Mesh even = grid(20, 20, [](double x, double y) { return Point(x / 20, y / 20, 0); });
  for(const Mesh& mesh : {even, unit_square(20, 5)}) {
    const Triangulation t(mesh);
    std::vector<Halfedge_index> border;
    for(Halfedge_index h : t.input_mesh().halfedges())
      if(t.input_mesh().is_border(h))
        border.push_back(h);
    const Paths paths = paths_from(t.input(), IT::curve_along_edges(t.input(), border));
    for(Vertex_index v : mesh.vertices()) {
      const Point p = mesh.point(v);
      EXPECT_NEAR(paths.distance(v), (std::min)({p.x(), 1 - p.x(), p.y(), 1 - p.y()}), 1e-14) << v;
    }
  }
}

// A line winds around a cylinder, and is compared with the line in the plane modulo the girth.
TEST(Curve_distances, geodesics_on_cylinders)
{
  for(int twists = 0; twists < 3; ++twists) {
    const Flat_surface surface = flat_cylinder(5, twists);
    Flat_triangulation flat(surface);
    const Flat_places places(Side::input, flat);
    CGAL::Random random(3);
    const double girth = static_cast<double>(surface.a.x);
    for(int i = 0; i < 20; ++i) {
      const Location p = random_location(flat->input_mesh(), random);
      const Path path =
        IT::shortest_path(flat->input(), p, random_location(flat->input_mesh(), random));
      const Paths paths = paths_from(flat->input(), IT::curve_through(flat->input(), path.places));
      const Complex start = places.place(p),
                    way = places.place(IT::face_location(path.places.back(), flat->input_mesh())) -
                          start;
      const Complex end = start + Complex(std::remainder(way.real(), girth), way.imag());
      for(int k = 0; k < 20; ++k) {
        const Location q = random_location(flat->input_mesh(), random);
        double truth = std::numeric_limits<double>::infinity();
        for(int turn = -3; turn <= 3; ++turn)
          truth =
            (std::min)(truth, distance_from_segment(places.place(q) + turn * girth, start, end));
        EXPECT_NEAR(paths.distance(q), truth, 1e-14 * girth);
        expect_valid(paths.path(q), places.faces(), 1e-14 * girth);
      }
    }
  }
}

// ---- Hard surfaces ----

// Checks that distances lie between the distances from points on the curve, and these minus the
// length between two of the points.
void check_by_points(const Named_mesh& m, unsigned int seed)
{
  const Triangulation t(m.mesh);
  CGAL::Random random(seed);
  const Path path = IT::shortest_path(t.input(), random_location(t.input_mesh(), random),
                                      random_location(t.input_mesh(), random));
  if(path.places.size() < 2)
    return;
  const Curve curve = IT::curve_through(t.input(), path.places);
  const Paths paths = paths_from(t.input(), curve);
  Paths from_points(t.input());
  double spacing = 0;
  for(const Segment& s : curve) {
    for(const double x : {0., 0.25, 0.5, 0.75, 1.})
      from_points.add_source(point_on(s, x));
    spacing = (std::max)(spacing, IT::internal::segment_length(t.input(), s) / 4);
  }
  from_points.run();
  double farthest = 0;
  for(Vertex_index v : m.mesh.vertices())
    if(from_points.distance(v) < std::numeric_limits<double>::infinity())
      farthest = (std::max)(farthest, from_points.distance(v));
  const double tolerance = 1e-7 * (farthest + path.length);
  for(Vertex_index v : m.mesh.vertices()) {
    if(paths.distance(v) == from_points.distance(v))
      continue; // out of reach too
    EXPECT_LE(paths.distance(v), from_points.distance(v) + tolerance) << v;
    EXPECT_GE(paths.distance(v), from_points.distance(v) - spacing / 2 - tolerance) << v;
  }
}

TEST(Curve_distances, on_hard_meshes)
{
  for(unsigned int seed = 0; seed < 80; ++seed) {
    const Named_mesh m = seed < 50 ? hard_mesh(seed) : near_degenerate_mesh(seed);
    SCOPED_TRACE(m.name + ", seed " + std::to_string(seed));
    if(m.mesh.number_of_faces() < 1500)
      check_by_points(m, seed);
  }
}

TEST(Curve_distances, empty_curves_and_points_as_segments)
{
  const Triangulation t(tetrahedron());
  Paths paths(t.input());
  EXPECT_EQ(paths.add_source(Curve()), 0u);
  paths.run();
  EXPECT_EQ(paths.distance(Vertex_index(0)), std::numeric_limits<double>::infinity());
  const Location p{Face_index(1), {0.2, 0.3, 0.5}};
  EXPECT_EQ(paths.add_source(Segment{p.first, p.second, p.second}), 1u);
  paths.run();
  EXPECT_EQ(paths.source(Vertex_index(2)), 1u);
  Paths from_point(t.input());
  from_point.add_source(p);
  from_point.run();
  for(Vertex_index v : t.input_mesh().vertices())
    EXPECT_EQ(paths.distance(v), from_point.distance(v));
}

} // namespace Test_curve_distances
