// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifdef CGAL_EIGEN3_ENABLED

#include "measuring.h"
#include "refined_meshes.h"

#include <CGAL/Intrinsic_triangulations/heat_distance.h>
#include <CGAL/Intrinsic_triangulations/interpolation.h>
#include <CGAL/Intrinsic_triangulations/refine.h>
#include <CGAL/Intrinsic_triangulations/vector_heat.h>

namespace Test_heat {

using namespace Test_surfaces;
using Values = Eigen::VectorXd;
using Field = Eigen::VectorXcd;
using Complex = std::complex<double>;

Vertex_index vertex(std::size_t i)
{
  return Vertex_index(static_cast<Delta_complex::size_type>(i));
}

// ---- Distances ----

// Returns the mean error over the mean distance.
double error(const Values& computed, const Values& exact)
{
  return (computed - exact).cwiseAbs().sum() / exact.sum();
}

Values exact_distances(const Mesh& mesh, const std::function<double(const Point&)>& distance)
{
  Values result(static_cast<Eigen::Index>(mesh.number_of_vertices()));
  for(Vertex_index v : mesh.vertices())
    result[v.idx()] = distance(mesh.point(v));
  return result;
}

double straight(const Point& p, const Point& q) { return std::sqrt(CGAL::squared_distance(p, q)); }

// Returns the distance on the unit sphere.
double along_great_circle(const Point& p, const Point& q)
{
  return 2 * std::asin((std::min)(1., straight(p, q) / 2));
}

// Returns the distances to the nearest lifts.
Values torus_distances(const Flat_surface& torus, Vertex_index source)
{
  Values result(static_cast<Eigen::Index>(torus.point.size()));
  for(Vertex_index v : torus.mesh.vertices())
    result[v.idx()] = shortest_lift(torus.point[v] - torus.point[source], torus);
  return result;
}

void expect_decreasing(const std::vector<double>& errors)
{
  for(std::size_t k = 1; k < errors.size(); ++k)
    EXPECT_LT(errors[k], 0.8 * errors[k - 1]);
}

// Returns the intrinsic triangulation of `t` as the input of another one.
Triangulation as_input(const Triangulation& t)
{
  return Triangulation(t.mesh(), IT::parameters::edge_length_map(t.length_map()));
}

// Returns the mesh with some edges flipped: the same surface and vertices, but slivers.
Triangulation bad_triangulation(const Mesh& mesh)
{
  Triangulation t(mesh);
  flip_at_random(t, std::size_t(40) * mesh.number_of_edges(), 1);
  return as_input(t);
}

double smallest_angle(const Triangulation& t)
{
  const Flat_faces faces(Side::intrinsic, t);
  Real least = 4;
  for(Halfedge_index h : t.mesh().halfedges())
    if(!t.mesh().is_border(h))
      least = (std::min)(least, faces.angle(h));
  return static_cast<double>(least) * 180 / pi;
}

// Returns a long strip of squares.
Mesh strip(std::size_t n)
{
  return grid(n, 1, [](double x, double y) { return Point(x, y, 0); });
}

// Represents a cone of angle 2 pi sin(slope) with n vertices on each ring; vertex 0 is the tip.
struct Round_cone
{
  std::size_t rings, n;
  double angle;

  std::size_t number(std::size_t ring, std::size_t i) const { return 1 + (ring - 1) * n + i % n; }
  double direction(std::size_t i) const // in the cone cut opposite to i = 0 and laid flat
  {
    const double turn = static_cast<double>(i) / static_cast<double>(n);
    return angle * (turn > 0.5 ? turn - 1 : turn);
  }

  Mesh mesh() const
  {
    const double flare = angle / (2 * pi), rise = std::sqrt(1 - flare * flare);
    std::vector<Point> points{{0, 0, 0}};
    Triangles triangles;
    for(std::size_t r = 1; r <= rings; ++r)
      for(std::size_t i = 0; i < n; ++i) {
        const double radius = static_cast<double>(r) / static_cast<double>(rings);
        const double turn = 2 * pi * static_cast<double>(i) / static_cast<double>(n);
        points.emplace_back(flare * radius * std::cos(turn), flare * radius * std::sin(turn),
                            rise * radius);
      }
    for(std::size_t i = 0; i < n; ++i) {
      triangles.push_back({0, number(1, i), number(1, i + 1)});
      for(std::size_t r = 1; r < rings; ++r) {
        triangles.push_back({number(r, i), number(r + 1, i), number(r + 1, i + 1)});
        triangles.push_back({number(r, i), number(r + 1, i + 1), number(r, i + 1)});
      }
    }
    return make_mesh(points, triangles);
  }
};

// Stores a triangulation in the plane with a set of sources and the distances from it.
struct Known_distances
{
  std::string name;
  Triangulation t;
  std::vector<Vertex_index> sources;
  Values exact;
  double bound; // of the mean error, in mean edge lengths
};

double mean_length(const Triangulation& t)
{
  double sum = 0;
  for(Edge_index e : t.mesh().edges())
    sum += t.length(e);
  return sum / static_cast<double>(t.mesh().number_of_edges());
}

// Returns the positions of the vertices of T2, from the positions of the input.
std::vector<Point> positions(const Triangulation& t, const Mesh& mesh)
{
  std::vector<Point> result(mesh.points().begin(), mesh.points().end());
  for(Vertex_index v : t.mesh().vertices())
    if(t.is_inserted(v))
      result.push_back(place_in_space(IT::face_location(t.inserted_vertex(v), t.input_mesh()),
                                      t.input_mesh(), mesh));
  return result;
}

// Returns the distances; sources are the vertices with exact distance zero.
template <typename Distance>
Known_distances known_distances(const std::string& name, const Triangulation& t, const Mesh& mesh,
                                double bound, const Distance& distance)
{
  const std::vector<Point> place = positions(t, mesh);
  Known_distances result{name, t, {}, Values(static_cast<Eigen::Index>(place.size())), bound};
  for(Vertex_index v : t.mesh().vertices()) {
    const double d = distance(place[v.idx()]);
    result.exact[v.idx()] = d < 1e-9 ? 0 : d;
    if(d < 1e-9)
      result.sources.push_back(v);
  }
  return result;
}

double from_center(const Point& p) { return std::hypot(p.x(), p.y()); }
double from_edges_of_unit_square(const Point& p)
{
  return (std::min)({p.x(), 1 - p.x(), p.y(), 1 - p.y()});
}

Mesh flat_disk() { return Round_cone{20, 126, 2 * pi}.mesh(); }

// Returns a square from -1 to 1, with 41 straight rows.
Mesh rows()
{
  return grid(40, 40, [](double x, double y) { return Point(x / 20 - 1, y / 20 - 1, 0); });
}

std::vector<Known_distances> known_distances()
{
  const Mesh square = rows(), disk = flat_disk(), coarse = unit_square(2, 1);
  const Triangulation on_square(square);
  Triangulation on_disk(disk), refined(coarse);
  IT::make_Delaunay(on_disk);
  IT::refine(refined, IT::parameters::maximum_circumradius(0.02));
  const Point a(-0.5, 0, 0), b(0.5, 0.3, 0);
  return {
    known_distances("one point", on_square, square, 0.3, from_center),
    known_distances("two points", on_square, square, 0.25,
                    [&](const Point& p) { return (std::min)(straight(p, a), straight(p, b)); }),
    known_distances("line from edge to edge", on_square, square, 0.035,
                    [](const Point& p) { return std::abs(p.x()); }),
    known_distances(
      "segment", on_square, square, 0.55,
      [](const Point& p) { return std::hypot(p.x(), (std::max)(0., std::abs(p.y()) - 0.5)); }),
    known_distances("region", on_square, square, 0.4,
                    [](const Point& p) { return (std::max)(0., from_center(p) - 0.4); }),
    known_distances("boundary of a disk", on_disk, disk, 0.01,
                    [](const Point& p) { return 1 - from_center(p); }),
    known_distances("circle", on_disk, disk, 0.01,
                    [](const Point& p) { return std::abs(0.5 - from_center(p)); }),
    known_distances("boundary of a refined square", refined, coarse, 0.2,
                    from_edges_of_unit_square)};
}

// ---- Vectors ----

double angle_between(const Complex& x, const Complex& y) { return std::abs(std::arg(x / y)); }

// Returns the direction of a tangent vector at `v` of a unit sphere, in space.
Kernel::Vector_3 in_space(const Mesh& mesh, const IT::Tangent_frames<>& frames, Vertex_index v,
                          const Complex& x)
{
  const Halfedge_index h = IT::first_outgoing_halfedge(v, mesh);
  const Kernel::Vector_3 normal = mesh.point(v) - CGAL::ORIGIN;
  Kernel::Vector_3 u = mesh.point(mesh.target(h)) - mesh.point(v);
  u = u - (u * normal) * normal;
  u = u / std::sqrt(u.squared_length());
  const Complex turned = x * std::polar(1., -frames.angle(h));
  return turned.real() * u + turned.imag() * CGAL::cross_product(normal, u);
}

// Returns `x` transported from `p` to `q` along the great circle, by the rotation that maps p to q.
Kernel::Vector_3 carried(const Kernel::Vector_3& x, const Kernel::Vector_3& p,
                         const Kernel::Vector_3& q)
{
  const Kernel::Vector_3 axis = CGAL::cross_product(p, q);
  const double cosine = p * q;
  return cosine * x + CGAL::cross_product(axis, x) + (axis * x) / (1 + cosine) * axis;
}

TEST(Heat_distance, plane)
{
  std::vector<double> errors;
  for(std::size_t n : {16u, 32u, 64u}) {
    const Mesh mesh = unit_square(n, 1);
    const Vertex_index source = vertex(n / 2 * (n + 1) + n / 2);
    const Values exact =
      exact_distances(mesh, [&](const Point& p) { return straight(p, mesh.point(source)); });
    errors.push_back(error(IT::heat_distance(Triangulation(mesh).input(), source), exact));
  }
  expect_decreasing(errors);
  EXPECT_LT(errors.back(), 0.015);
}

TEST(Heat_distance, sphere)
{
  std::vector<double> errors;
  for(std::size_t n : {8u, 16u, 32u}) {
    const Mesh mesh = unit_sphere(n);
    const Vertex_index source = vertex(3);
    const Values exact = exact_distances(
      mesh, [&](const Point& p) { return along_great_circle(p, mesh.point(source)); });
    errors.push_back(error(IT::heat_distance(Triangulation(mesh).input(), source), exact));
  }
  expect_decreasing(errors);
  EXPECT_LT(errors.back(), 0.01);
}

TEST(Heat_distance, flat_torus)
{
  std::vector<double> errors;
  for(int n : {12, 24, 48}) {
    const Flat_surface torus = flat_torus(n, n, 2);
    Triangulation t = triangulation(torus);
    IT::make_Delaunay(t);
    errors.push_back(
      error(IT::heat_distance(t.intrinsic(), vertex(7)), torus_distances(torus, vertex(7))));
  }
  expect_decreasing(errors);
  EXPECT_LT(errors.back(), 0.02);
}

// Delaunay flips find the good triangulation again, so that distances are the same.
TEST(Heat_distance, bad_triangulation_of_a_good_shape)
{
  for(const Mesh& mesh :
      {unit_sphere(16), unit_square(24, 3), perturbed(embedded_torus(24, 16), 0.05, 1)}) {
    Triangulation good(mesh), bad = bad_triangulation(mesh);
    IT::make_Delaunay(good);
    const double angle = smallest_angle(bad);
    EXPECT_LT(angle, 2);
    IT::make_Delaunay(bad);
    const Values expected = IT::heat_distance(good.intrinsic(), vertex(5));
    const Values on_input = IT::heat_distance(bad.input(), vertex(5));
    const Values computed = IT::heat_distance(bad.intrinsic(), vertex(5));
    EXPECT_LT((computed - expected).cwiseAbs().maxCoeff(), 1e-9 * expected.maxCoeff());
    EXPECT_GT(error(on_input, expected), 0.1);
  }
}

// Slivers sweep over random points, and distances are compared with the plane. With random points
// and a hull as boundary, flips leave errors of some percent.
TEST(Heat_distance, swept_triangles)
{
  const Mesh mesh = planar_mesh(random_points(3000, 100000, 8));
  Triangulation t(mesh);
  EXPECT_LT(smallest_angle(t), 1e-4);
  IT::make_Delaunay(t);
  const Values exact =
    exact_distances(mesh, [&](const Point& p) { return straight(p, mesh.point(vertex(1500))); });
  EXPECT_GT(error(IT::heat_distance(t.input(), vertex(1500)), exact), 0.2);
  EXPECT_LT(error(IT::heat_distance(t.intrinsic(), vertex(1500)), exact), 0.05);
}

TEST(Heat_distance, sources_and_components)
{
  Mesh mesh = embedded_torus(12, 8);
  const std::size_t alone = mesh.add_vertex(Point(9, 9, 9)).idx();
  const std::size_t lonely = mesh.add_vertex(Point(8, 8, 8)).idx();
  CGAL::copy_face_graph(tetrahedron(), mesh);
  const IT::Heat_distance<> distance(Triangulation(mesh).input());
  const Values a = distance.distances(vertex(3)), b = distance.distances(vertex(60));
  const Values both = distance.distances(std::vector{vertex(3), vertex(60), vertex(alone)});
  const auto torus = static_cast<Eigen::Index>(alone);
  EXPECT_EQ(a[3], 0);
  EXPECT_GE(a.head(torus).minCoeff(), 0);
  EXPECT_TRUE((a.tail(a.size() - torus).array() == std::numeric_limits<double>::infinity()).all());
  EXPECT_EQ(both[torus], 0);
  EXPECT_EQ(both[static_cast<Eigen::Index>(lonely)], std::numeric_limits<double>::infinity());
  const Values nearest = a.head(torus).cwiseMin(b.head(torus));
  EXPECT_LT(error(both.head(torus), nearest), 0.1);
  EXPECT_TRUE((distance.distances(std::vector<Vertex_index>()).array() > 1e300).all());
}

// No constant subtracted from the solution of the Poisson equation satisfies the bounds: neither
// the least nor the mean of the values at the sources.
TEST(Heat_distance, many_sources_in_closed_form)
{
  for(const Known_distances& known : traced(known_distances())) {
    const Values computed = IT::heat_distance(known.t.intrinsic(), known.sources);
    for(Vertex_index source : known.sources)
      EXPECT_EQ(computed[source.idx()], 0);
    EXPECT_LT((computed - known.exact).cwiseAbs().mean(), known.bound * mean_length(known.t));
  }
}

TEST(Heat_distance, time_step)
{
  const Mesh mesh = unit_square(10, 1);
  const Triangulation t(mesh);
  const Values one = IT::heat_distance(t.input(), vertex(0));
  const Values same = IT::heat_distance(t.input(), vertex(0), IT::parameters::time_step_factor(1));
  const Values smooth =
    IT::heat_distance(t.input(), vertex(0), IT::parameters::time_step_factor(100.));
  EXPECT_EQ(one, same);
  EXPECT_GT((one - smooth).cwiseAbs().maxCoeff(), 1e-3);
  for(double factor : {0., -1., 2e13, 1e300, std::numeric_limits<double>::infinity(), std::nan("")})
    EXPECT_THROW(IT::Heat_distance<>(t.input(), IT::parameters::time_step_factor(factor)),
                 IT::Invalid_input);
}

TEST(Heat_distance, unit_of_length)
{
  const Mesh mesh = unit_sphere(5);
  const Triangulation t(mesh);
  const Values expected = IT::heat_distance(t.input(), vertex(0));
  for(double factor : {1e-30, 1e30}) {
    const auto length = boost::make_function_property_map<Edge_index>(
      [&](Edge_index e) { return factor * t.input_length(e); });
    const Values computed =
      IT::heat_distance(IT::Surface_view(t.input_mesh(), length), vertex(0)) / factor;
    EXPECT_LT((computed - expected).cwiseAbs().maxCoeff(), 1e-10);
  }
}

// All corners of the face opposite to the source have equal heat, up to rounding.
TEST(Heat_distance, is_symmetric_on_tetrahedra)
{
  for(const double scale : {1., 1.7, 0.3, 3., 1e3}) {
    Mesh mesh = tetrahedron();
    const double regular[4][3] = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
    for(std::size_t v = 0; v < 4; ++v)
      mesh.point(Vertex_index(unsigned(v))) =
        Point(scale * regular[v][0], scale * regular[v][1], scale * regular[v][2]);
    const auto distance = IT::heat_distance(Triangulation(mesh), Vertex_index(0));
    for(Eigen::Index v = 2; v < 4; ++v)
      EXPECT_NEAR(distance[v], distance[1], 1e-12 * scale);
  }
}

TEST(Heat_distance, far_away)
{
  const Triangulation t(strip(1200)), longer(strip(3000));
  const Values distance = IT::heat_distance(t.input(), vertex(0));
  EXPECT_NEAR(distance[2400] / 1200, 1, 0.01);
  EXPECT_THROW(IT::heat_distance(longer.input(), vertex(0)), IT::Underflow_error);
  const Values with_more_time =
    IT::heat_distance(longer.input(), vertex(0), IT::parameters::time_step_factor(9));
  EXPECT_NEAR(with_more_time[6000] / 3000, 1, 0.01);
}

TEST(Heat_distance, all_complexes)
{
  for(const Named_triangulation& t : traced(triangulations())) {
    const Values distance = IT::heat_distance(t.triangulation.intrinsic(), vertex(0));
    EXPECT_TRUE(distance.allFinite());
    EXPECT_EQ(distance[0], 0);
  }
}

TEST(Heat_distance, empty_surface)
{
  EXPECT_EQ(IT::heat_distance(Triangulation().input(), std::vector<Vertex_index>()).size(), 0);
}

TEST(Heat_distance, on_the_common_subdivision)
{
  const Mesh mesh = perturbed(embedded_torus(10, 8), 0.3, 1);
  Triangulation t(mesh);
  IT::make_Delaunay(t);
  const Values distance = IT::heat_distance(t.intrinsic(), vertex(0));
  const IT::Common_subdivision<> subdivision{Correspondence(t)};
  const auto value = boost::make_function_property_map<Vertex_index>(
    [&](Vertex_index v) { return distance[v.idx()]; });
  std::vector<double> there(subdivision.mesh().number_of_vertices());
  IT::interpolate(Side::intrinsic, subdivision, value,
                  boost::make_iterator_property_map(there.begin(), boost::identity_property_map()));
  for(Vertex_index v : mesh.vertices())
    EXPECT_EQ(there[v.idx()], distance[v.idx()]);
  EXPECT_LE(*std::max_element(there.begin(), there.end()), distance.maxCoeff());
}

// ---- Vector heat ----

TEST(Vector_heat, flat_torus)
{
  for(const auto& [m, n] : {std::pair(1, 1), std::pair(2, 1), std::pair(9, 7)}) {
    const Flat_surface torus = flat_torus(m, n, 4);
    Triangulation t = triangulation(torus);
    const IT::Vector_heat<> heat(t.input());
    const Field field = heat.transport(vertex(0), Complex(2, 1));
    for(Halfedge_index h : torus.mesh.halfedges()) {
      const Complex there = heat.frames().transport(h) * field[torus.mesh.source(h).idx()];
      EXPECT_NEAR(std::abs(there - field[torus.mesh.target(h).idx()]), 0, 1e-10);
    }
    EXPECT_NEAR(std::abs(field[0] - Complex(2, 1)), 0, 1e-10);
  }
}

// Vectors that are transported around the tip on its two sides differ by its angle defect.
TEST(Vector_heat, holonomy_around_a_cone)
{
  for(double angle : {1.5 * pi, pi}) {
    const Round_cone cone{40, 60, angle};
    const Mesh mesh = cone.mesh();
    const IT::Vector_heat<> heat(Triangulation(mesh).input());
    EXPECT_NEAR(heat.frames().angle_defect(vertex(0)), 2 * pi - angle, 0.01);
    const auto outward = [&](std::size_t ring, std::size_t i) {
      const Halfedge_index h =
        mesh.halfedge(vertex(cone.number(ring, i)), vertex(cone.number(ring + 1, i)));
      return std::polar(1., heat.frames().angle(h));
    };
    const std::size_t ring = 20;
    const Field field = heat.transport(vertex(cone.number(ring, 0)), outward(ring, 0));
    // Vertices on the cut, where the vectors from both sides meet, are excluded.
    for(std::size_t i = 0; i < cone.n; ++i)
      if(std::abs(cone.direction(i)) < 0.4 * angle) {
        const Complex expected = outward(ring, i) * std::polar(1., -cone.direction(i));
        EXPECT_LT(angle_between(field[static_cast<Eigen::Index>(cone.number(ring, i))], expected),
                  0.05)
          << "angle " << angle << ", vertex " << i;
      }
    const Complex left =
      field[static_cast<Eigen::Index>(cone.number(ring, 24))] / outward(ring, 24);
    const Complex right =
      field[static_cast<Eigen::Index>(cone.number(ring, 36))] / outward(ring, 36);
    const double between = angle * 12 / 60; // from ray 24 on to ray 36
    EXPECT_LT(
      angle_between(left / right * std::polar(1., -between), std::polar(1., 2 * pi - angle)), 0.1);
  }
}

// Vectors that drift with the edges of the mesh do so less if heat has more time.
TEST(Vector_heat, sphere)
{
  for(const auto& [factor, bound] : {std::pair(1., 0.06), std::pair(16., 0.005)})
    for(std::size_t n : {8u, 16u, 32u}) {
      const Mesh mesh = unit_sphere(n);
      const IT::Vector_heat<> heat(Triangulation(mesh).input(),
                                   IT::parameters::time_step_factor(factor));
      const Vertex_index source = vertex(0);
      const Field field = heat.transport(source, Complex(1, 0));
      const auto direction = in_space(mesh, heat.frames(), source, field[0]);
      for(Vertex_index v : mesh.vertices()) {
        const auto p = mesh.point(source) - CGAL::ORIGIN, q = mesh.point(v) - CGAL::ORIGIN;
        if(p * q > -0.7) {
          const auto error =
            in_space(mesh, heat.frames(), v, field[v.idx()]) - carried(direction, p, q);
          EXPECT_LT(std::sqrt(error.squared_length()), bound) << "factor " << factor;
        }
      }
    }
}

TEST(Vector_heat, sources)
{
  Mesh mesh = unit_sphere(8);
  const auto n = static_cast<Eigen::Index>(mesh.number_of_vertices());
  mesh.add_vertex(Point(9, 9, 9));
  const IT::Vector_heat<> heat(Triangulation(mesh).input());
  const Field x = heat.transport(vertex(3), Complex(0, 1));
  EXPECT_EQ(x.size(), n + 1);
  EXPECT_EQ(x[n], Complex(0));
  EXPECT_LT((x.head(n).cwiseAbs() - Values::Ones(n)).cwiseAbs().maxCoeff(), 1e-9);
  const Field y = heat.transport(vertex(3), Complex(-3e30, 4e30));
  EXPECT_LT((y - Complex(4e30, 3e30) * x).cwiseAbs().maxCoeff(), 1e21);
  EXPECT_EQ(heat.transport(vertex(3), Complex(0)), Field::Zero(n + 1));
  EXPECT_EQ(heat.transport(std::vector<IT::Vector_heat<>::Source>()), Field::Zero(n + 1));
  const Field two = heat.transport(
    std::vector<IT::Vector_heat<>::Source>{{vertex(0), Complex(1)}, {vertex(200), Complex(0, 5)}});
  EXPECT_NEAR(std::abs(two[0]), 1, 0.01);
  EXPECT_NEAR(std::abs(two[200]), 5, 0.05);
  EXPECT_LT(angle_between(two[200], Complex(0, 1)), 0.01);
}

TEST(Vector_heat, all_complexes)
{
  for(const Named_triangulation& t : traced(triangulations())) {
    const IT::Vector_heat<> heat(t.triangulation.intrinsic());
    const Field field = heat.transport(vertex(0), Complex(1));
    EXPECT_TRUE(field.allFinite());
    EXPECT_LT((field.cwiseAbs() - Values::Ones(field.size())).cwiseAbs().maxCoeff(), 1e-6);
  }
}

} // namespace Test_heat

#endif
