// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../Intrinsic_triangulations/hard_meshes.h"
#include "flat_maps.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <CGAL/Discrete_conformal_maps/cross_ratios.h>
#include <CGAL/Discrete_conformal_maps/flatten_to_disk.h>
#include <CGAL/Discrete_conformal_maps/flatten_to_rectangle.h>
#include <CGAL/Discrete_conformal_maps/internal/minimization/Grouped_energy.h>
#include <CGAL/Discrete_conformal_maps/internal/minimization/Laplacian_elimination.h>
#include <CGAL/Discrete_conformal_maps/internal/minimization/Variable_groups.h>
#include <CGAL/Discrete_conformal_maps/internal/minimization/root_of_increasing.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Spherical_scale_factors.h>
#include <CGAL/Discrete_conformal_maps/map_to_sphere.h>
#include <CGAL/Intrinsic_triangulations/certify_Delaunay.h>

#include <functional>

// Maps of surfaces with needles and caps as thin as rounding of positions allows.
namespace Test_needles {

using namespace Test_surfaces;
using DCM::Map_status;

// ---- Surfaces ----

Mesh unit_square(std::size_t n)
{
  return grid(n, n, [n](double x, double y) { return Point(x / double(n), y / double(n), 0); });
}

// Returns a terrain over a square around the origin.
Mesh terrain(std::size_t n, Portable_random& random)
{
  const double half = double(n) / 2;
  return grid(
    n, n, [&](double x, double y) { return Point(x - half, y - half, random.get_double(0, 0.5)); });
}

// Inserts a vertex in a face at another one.
void insert_beside(Vertex_index v, const Point& p, Mesh& mesh, Portable_random& random)
{
  Halfedge_index h = mesh.halfedge(v);
  for(int turns = random.get_int(0, 6); turns > 0 || mesh.is_border(h); --turns)
    h = mesh.opposite(mesh.next(h));
  mesh.point(mesh.target(CGAL::Euler::add_center_vertex(h, mesh))) = p;
}

// Adds vertices near vertices with x = 0, at a distance of about d along x, which coordinates can
// represent.
Mesh with_near_vertices(Mesh mesh, double d, Portable_random& random)
{
  std::vector<Vertex_index> places;
  for(Vertex_index v : mesh.vertices())
    if(mesh.point(v).x() == 0)
      places.push_back(v);
  for(Vertex_index v : places) {
    const Point p = mesh.point(v), near(d * random.get_double(0.5, 1), p.y(), p.z());
    insert_beside(v, near, mesh, random);
  }
  return mesh;
}

// Returns a convex surface with a vertex in the origin.
Mesh sphere_at_origin(std::size_t n, Portable_random& random)
{
  Mesh mesh = random_sphere(n, std::uint32_t(random.get_int(0, 1000)));
  const Point center = mesh.point(Vertex_index(0));
  for(Vertex_index v : mesh.vertices())
    mesh.point(v) = CGAL::ORIGIN + (mesh.point(v) - center);
  return mesh;
}

// Adds vertices at distances of about d, 10 d and 100 d from the vertex in the origin.
Mesh with_vertices_at_origin(Mesh mesh, double d, Portable_random& random)
{
  for(const double distance : {100 * d, 10 * d, d}) {
    const auto coordinate = [&] { return distance * random.get_double(-1, 1); };
    const double x = coordinate(), y = coordinate(), z = coordinate();
    insert_beside(Vertex_index(0), Point(x, y, z), mesh, random);
  }
  return mesh;
}

bool are_collinear(const Point& p, const Point& q, const Point& r)
{
  typedef CGAL::Exact_predicates_inexact_constructions_kernel::Point_3 Exact_point;
  const auto exact = [](const Point& x) { return Exact_point(x.x(), x.y(), x.z()); };
  return CGAL::collinear(exact(p), exact(q), exact(r));
}

// Returns whether a point in the plane z = 0 is inside a face there: if it is not, the three parts
// of the face would overlap. Faces elsewhere have any point above them.
bool can_be_inserted(const Point& x, const Point& p, const Point& q, const Point& r)
{
  if(p.z() != 0 || q.z() != 0 || r.z() != 0)
    return true;
  typedef CGAL::Exact_predicates_inexact_constructions_kernel::Point_2 Exact_point;
  const auto exact = [](const Point& a) { return Exact_point(a.x(), a.y()); };
  const auto side = [&](const Point& a, const Point& b, const Point& c) {
    return CGAL::orientation(exact(a), exact(b), exact(c));
  };
  return side(p, q, x) == side(p, q, r) && side(q, r, x) == side(p, q, r) &&
         side(r, p, x) == side(p, q, r);
}

// Splits a face at a point with barycentric coordinates 1 : e : e or 1 : 1 : e, up to rounding, and
// one of the new faces again. Stops where rounding gives a corner or a point outside.
void add_nested_needles(Mesh& mesh, double e, std::size_t depth, Portable_random& random)
{
  Face_index f(Mesh::size_type(random.get_int(0, int(mesh.number_of_faces()))));
  for(std::size_t i = 0; i < depth; ++i) {
    Halfedge_index h = mesh.halfedge(f);
    for(int turns = random.get_int(0, 3); turns > 0; --turns)
      h = mesh.next(h);
    const Point &p = mesh.point(mesh.source(h)), &q = mesh.point(mesh.target(h)),
                &r = apex(h, mesh);
    const double second = random.get_int(0, 2) ? 1 : e, sum = 1 + second + e;
    const auto coordinate = [&](int c) { return (p[c] + second * q[c] + e * r[c]) / sum; };
    const Point inside(coordinate(0), coordinate(1), coordinate(2));
    if(!is_free(inside, mesh) || are_collinear(p, q, inside) || are_collinear(q, r, inside) ||
       are_collinear(r, p, inside) || !can_be_inserted(inside, p, q, r))
      return;
    const Vertex_index v = mesh.target(CGAL::Euler::add_center_vertex(h, mesh));
    mesh.point(v) = inside;
    f = mesh.face(mesh.halfedge(v));
  }
}

Mesh with_needles(Mesh mesh, double e, std::size_t count, std::uint64_t seed)
{
  Portable_random random(seed);
  for(std::size_t i = 0; i < count; ++i)
    add_nested_needles(mesh, e, 3, random);
  return mesh;
}

const double widths[] = {1e-2, 1e-5, 1e-8, 1e-11, 1e-13, 1e-15};

// ---- Checks ----

void check_success(const Planar_conformal_map& map)
{
  EXPECT_EQ(map.status(), Map_status::success) << map.cause();
  for(const DCM::Map_promise& p : map.promises())
    EXPECT_TRUE(p.is_kept()) << p.name << ' ' << p.error;
  EXPECT_LT(DCM::max_cross_ratio_error(map), 1e-8);
  EXPECT_LT(map.max_curvature_error(), 1e-10);
}

// Checks that a flat surface keeps its scale, and edges have the distances of their ends. Around a
// corner, over the other side of the double, an edge can be longer.
void check_isometry(const Planar_conformal_map& map, const Mesh& mesh)
{
  for(Vertex_index v : mesh.vertices())
    EXPECT_NEAR(map.log_scale(v), 0, 1e-9);
  const Delta_complex& ideal = map.ideal().mesh();
  std::size_t number_of_equal = 0;
  for(Edge_index side : ideal.edges()) {
    const Vertex_index v = ideal.vertex(side, 0), w = ideal.vertex(side, 1);
    if(map.input_vertex(v) != v || map.input_vertex(w) != w ||
       !map.is_laid_out(ideal.face(ideal.halfedge(side))))
      continue;
    const auto difference = mesh.point(w) - mesh.point(v);
    const double distance = std::hypot(difference.x(), difference.y()),
                 length =
                   std::exp((map.log_scale(v) + map.log_scale(w)) / 2) * map.ideal().length(side);
    EXPECT_GE(length, distance * (1 - 1e-9));
    number_of_equal += length <= distance * (1 + 1e-9);
  }
  EXPECT_GE(number_of_equal, mesh.number_of_vertices());
}

// A square is a rectangle already: sides keep their lengths, however short they are.
TEST(Needles, square_keeps_its_lengths)
{
  for(const double e : {1e-2, 1e-5, 1e-8, 1e-11, 1e-13, 1e-14, 1e-15, 1e-16, 1e-18, 1e-20})
    for(std::uint64_t seed : {5, 6, 7}) {
      SCOPED_TRACE(testing::Message() << e << ' ' << seed);
      const Mesh mesh = with_needles(unit_square(3), e, 4, seed);
      const Planar_conformal_map map =
        DCM::flatten_to_rectangle(mesh, DCM::rectangle_corners(mesh));
      check_success(map);
      check_isometry(map, mesh);
    }
}

// With rounded lengths, rounding dominates the angles at a vertex so close to a side, and yet the
// scaled surface can be flat.
TEST(Needles, flat_square_keeps_its_lengths)
{
  for(const double e : {1e-14, 1e-15, 1e-16, 1e-18, 1e-20})
    for(std::uint64_t seed : {1, 2, 3, 4}) {
      SCOPED_TRACE(testing::Message() << e << ' ' << seed);
      Mesh mesh = unit_square(1);
      Portable_random random(seed);
      add_nested_needles(mesh, e, 1, random);
      const Planar_conformal_map map = DCM::flatten(mesh, DCM::parameters::cones(DCM::Cones::none));
      check_success(map);
      check_isometry(map, mesh);
    }
}

TEST(Needles, have_disks)
{
  for(const double e : widths)
    for(std::uint64_t seed : {1, 2}) {
      SCOPED_TRACE(e);
      check_success(DCM::flatten_to_disk(with_needles(unit_square(3), e, 3, seed)));
    }
}

// The angles of a circle follow from lengths in the plane. They have to be lengths of the surface
// whose angles have been measured, with all its digits.
TEST(Needles, on_terrains_have_disks)
{
  for(const double e : widths)
    for(std::uint64_t seed : {1, 7, 13, 14}) {
      SCOPED_TRACE(testing::Message() << e << ' ' << seed);
      Portable_random random(seed);
      check_success(DCM::flatten_to_disk(with_needles(terrain(2, random), e, 8, seed)));
    }
}

// Rounded lengths do not determine the angles between such near vertices.
TEST(Needles, near_vertices_have_maps)
{
  for(const double d : {1e-8, 1e-12, 1e-17, 1e-22, 1e-28})
    for(std::uint64_t seed : {1, 2, 3}) {
      SCOPED_TRACE(d);
      Portable_random random(seed);
      const Mesh mesh = with_near_vertices(terrain(4, random), d, random);
      EXPECT_EQ(mesh.number_of_vertices(), 30u);
      check_success(DCM::flatten(mesh));
      check_success(DCM::flatten_to_rectangle(mesh, DCM::rectangle_corners(mesh)));
    }
}

// If several vertices are close to each other, their angles depend on scale factors like roots.
TEST(Needles, clusters_have_maps)
{
  for(const double d : {1e-12, 1e-20, 1e-28})
    for(std::uint64_t seed : {1, 2}) {
      SCOPED_TRACE(testing::Message() << d << ' ' << seed);
      Portable_random random(seed);
      Mesh mesh = terrain(4, random);
      for(const double part : {1., 0.1, 0.01})
        mesh = with_near_vertices(mesh, part * d, random);
      check_success(DCM::flatten(mesh));
      check_success(DCM::flatten_to_rectangle(mesh, DCM::rectangle_corners(mesh)));
      check_success(DCM::flatten(with_vertices_at_origin(sphere_at_origin(40, random), d, random)));
    }
}

// Returns parts of half the distance to the nearest vertex in space. On the surface, it is no
// less. Beside the boundary there are no circles.
std::vector<double> short_radii(const Mesh& mesh, Portable_random& random)
{
  std::vector<double> result;
  for(Vertex_index v : mesh.vertices()) {
    double least = std::numeric_limits<double>::infinity();
    for(Vertex_index w : mesh.vertices())
      if(const auto d = mesh.point(w) - mesh.point(v); v != w)
        least = (std::min)(least, std::hypot(d.x(), d.y(), d.z()));
    bool is_inside = true;
    for(Vertex_index w : CGAL::vertices_around_target(mesh.halfedge(v), mesh))
      is_inside = is_inside && !mesh.is_border(w);
    result.push_back(is_inside ? least / 2 * random.get_double(0, 0.99) : 0);
  }
  return result;
}

// Circles around near vertices are as small as their distances.
TEST(Needles, may_have_circles)
{
  for(const double d : {1e-8, 1e-17, 1e-28})
    for(std::uint64_t seed : {1, 2}) {
      SCOPED_TRACE(testing::Message() << d << ' ' << seed);
      Portable_random random(seed);
      const Mesh square = with_near_vertices(terrain(4, random), d, random),
                 sphere = with_vertices_at_origin(sphere_at_origin(40, random), d, random);
      for(const Mesh* mesh : {&square, &sphere}) {
        const std::vector<double> radii = short_radii(*mesh, random);
        const auto radius = boost::make_function_property_map<Vertex_index>(
          [&](Vertex_index v) { return radii[v.idx()]; });
        const Planar_conformal_map map =
          DCM::flatten(*mesh, DCM::parameters::vertex_radius_map(radius));
        EXPECT_TRUE(map.has_radii());
        check_success(map);
      }
    }
}

// Scale factors do not depend on the start of the search, from five starts.
TEST(Needles, with_circles_have_one_map)
{
  for(const double d : {1e-8, 1e-17}) {
    Portable_random random(3);
    const Mesh sphere = with_vertices_at_origin(sphere_at_origin(40, random), d, random);
    const std::vector<double> radii = short_radii(sphere, random);
    Conditions conditions(radii.size()); // four cones
    for(std::size_t v : {5u, 10u, 15u, 20u})
      conditions[v] = Vertex_condition::curvature(pi);
    const auto map_from = [&](double spread) {
      std::vector<double> start;
      for(std::size_t v = 0; v < radii.size(); ++v)
        start.push_back(spread * random.get_double(-1, 1));
      const auto values_of = [](const std::vector<double>& values) {
        return boost::make_function_property_map<Vertex_index>(
          [&values](Vertex_index v) { return values[v.idx()]; });
      };
      return DCM::flatten(sphere, DCM::parameters::vertex_radius_map(values_of(radii))
                                    .initial_log_scale_map(values_of(start))
                                    .vertex_condition_map(Test_surfaces::as_map(conditions)));
    };
    const Planar_conformal_map first = map_from(0);
    check_success(first);
    for(int i = 0; i < 5; ++i) {
      const Planar_conformal_map map = map_from(2);
      check_success(map);
      for(Vertex_index v : sphere.vertices())
        EXPECT_NEAR(map.log_scale(v) - map.log_scale(Vertex_index(0)),
                    first.log_scale(v) - first.log_scale(Vertex_index(0)), 1e-8);
    }
  }
}

// A cone can be placed at one of several near vertices.
TEST(Needles, may_have_cones)
{
  for(const double e : {1e-8, 1e-13, 1e-18})
    for(std::uint64_t seed : {1, 2, 3}) {
      SCOPED_TRACE(testing::Message() << e << ' ' << seed);
      Mesh mesh = random_sphere(60, 3);
      for(Vertex_index v : mesh.vertices())
        if(const Point& p = mesh.point(v); p.z() > 0.7)
          mesh.point(v) = Point(p.x(), p.y(), 3 * p.z());
      mesh = with_needles(mesh, e, 6, seed);
      const Planar_conformal_map map = DCM::flatten(mesh, DCM::parameters::maximum_log_scale(0.6));
      check_success(map);
      for(Vertex_index v : mesh.vertices())
        EXPECT_LE(std::abs(map.log_scale(v)), 0.6);
    }
}

// Checks that the cross ratios of distances on two spheres are equal, between some vertices.
void check_same_sphere(const DCM::Spherical_conformal_map& map,
                       const DCM::Spherical_conformal_map& other,
                       const std::vector<Vertex_index>& vertices)
{
  const auto distance = [](const DCM::Spherical_conformal_map& m, Vertex_index v, Vertex_index w) {
    const auto &p = m.position(v), &q = m.position(w);
    return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
  };
  for(std::size_t i = 0; i + 3 < vertices.size(); ++i) {
    const Vertex_index p = vertices[i], q = vertices[i + 1], r = vertices[i + 2],
                       t = vertices[i + 3];
    const auto cross_ratio = [&](const DCM::Spherical_conformal_map& m) {
      return distance(m, p, q) / distance(m, q, r) * distance(m, r, t) / distance(m, t, p);
    };
    EXPECT_NEAR(cross_ratio(map) / cross_ratio(other), 1, 1e-6);
  }
}

// Maps to the sphere, and expects near vertices to make no difference to the others.
void check_sphere(const Mesh& mesh, const Mesh& without_near_vertices,
                  const std::function<bool(Vertex_index)>& is_far)
{
  const DCM::Spherical_conformal_map map = DCM::map_to_sphere(mesh),
                                     other = DCM::map_to_sphere(without_near_vertices);
  EXPECT_EQ(map.status(), Map_status::success) << map.cause();
  for(const DCM::Map_promise& p : map.promises())
    EXPECT_TRUE(p.is_kept()) << p.name << ' ' << p.error;
  EXPECT_LT(DCM::max_cross_ratio_error(map), 1e-8);
  std::vector<Vertex_index> vertices;
  for(Vertex_index v : without_near_vertices.vertices())
    if(is_far(v))
      vertices.push_back(v);
  check_same_sphere(map, other, vertices);
}

TEST(Needles, near_vertices_have_spheres)
{
  for(const double d : {1e-10, 1e-12, 1e-17, 1e-22, 1e-28})
    for(std::uint64_t seed : {1, 2, 3}) {
      SCOPED_TRACE(testing::Message() << d << ' ' << seed);
      Portable_random random(seed);
      const Mesh sphere = sphere_at_origin(40, random);
      check_sphere(with_vertices_at_origin(sphere, d, random), sphere,
                   [](Vertex_index v) { return v.idx() > 0; });
    }
}

// The derivatives of an energy of groups are sums over their members.
TEST(Needles, groups_have_an_energy)
{
  Portable_random random(4);
  DCM::internal::Doubled_problem problem(Triangulation(random_sphere(30, 1)),
                                         std::vector<DCM::Vertex_condition>(30),
                                         DCM::Flipping::to_Delaunay);
  const Vertex_index at_infinity(0);
  auto energy = DCM::internal::spherical_energy<IT::Double_double>(problem, at_infinity);
  std::vector<std::size_t> group{0};
  while(group.size() < 30)
    group.push_back(group.size() < 10 ? group.size() : std::size_t(random.get_int(1, 10)));
  energy.evaluate(Eigen::VectorXd::Zero(30));
  DCM::internal::Grouped_energy grouped(energy, group, 10);
  const auto gradient_at = [&](const std::vector<IT::Double_double>& move) {
    grouped.set_origin(move);
    grouped.evaluate(Eigen::VectorXd::Zero(10));
    return grouped.gradient();
  };
  std::vector<IT::Double_double> move(10, IT::Double_double(0));
  const Eigen::VectorXd before = gradient_at(move);
  const Eigen::MatrixXd Hessian = grouped.Hessian();
  for(std::size_t g = 1; g < 10; ++g) {
    const double step = 1e-6;
    move[g] = step;
    EXPECT_NEAR(grouped.derivative_at({g}, {move[g]}), gradient_at(move)[Eigen::Index(g)], 1e-14);
    const Eigen::VectorXd above = grouped.gradient();
    move[g] = -step;
    const Eigen::VectorXd quotient = (above - gradient_at(move)) / (2 * step);
    EXPECT_LT((quotient - Hessian.col(Eigen::Index(g))).tail(9).norm(), 1e-5);
    move[g] = 0;
    double sum = 0;
    gradient_at(move);
    for(std::size_t v = 0; v < 30; ++v)
      sum += group[v] == g ? energy.gradient()[Eigen::Index(v)] : 0;
    EXPECT_NEAR(before[Eigen::Index(g)], sum, 1e-14);
  }
}

// Clusters of clusters of near vertices do not move other vertices.
TEST(Needles, clusters_have_spheres)
{
  for(std::uint64_t seed : {1, 2, 3}) {
    SCOPED_TRACE(testing::Message() << seed);
    Portable_random random(seed);
    const Mesh sphere = sphere_at_origin(250, random);
    Mesh mesh = sphere;
    for(const double d : {1e-16, 1e-19, 1e-22, 1e-25, 1e-28})
      mesh = with_vertices_at_origin(mesh, d, random);
    check_sphere(mesh, sphere, [](Vertex_index v) { return v.idx() > 0; });
  }
}

TEST(Needles, near_vertices_have_hemispheres)
{
  for(const double d : {1e-12, 1e-17, 1e-22, 1e-28})
    for(std::uint64_t seed : {1, 2}) {
      SCOPED_TRACE(testing::Message() << d << ' ' << seed);
      Portable_random random(seed);
      const Mesh square = terrain(4, random);
      check_sphere(with_near_vertices(square, d, random), square,
                   [&](Vertex_index v) { return square.point(v).x() != 0; });
    }
}

// The intrinsic Delaunay triangulation is certified.
TEST(Needles, triangulation_is_exact)
{
  for(const double e : widths) {
    SCOPED_TRACE(e);
    const Mesh mesh = with_needles(random_sphere(60, 3), e, 4, 7);
    const Planar_conformal_map map = DCM::flatten(mesh, DCM::parameters::exact_decisions(true));
    EXPECT_TRUE(IT::certify_Delaunay(map.Delaunay()).is_Delaunay());
  }
}

// Conductances are in series: from a fixed end, potentials are sums of resistances.
TEST(Laplacian_elimination, chain_of_any_weights)
{
  const std::vector<double> weight{1, 1e20, 1e-20, 1e15, 3, 1e-3};
  const auto n = Eigen::Index(weight.size());
  std::vector<Eigen::Triplet<double>> entries;
  for(Eigen::Index i = 0; i < n; ++i) {
    const double w = weight[std::size_t(i)];
    entries.insert(entries.end(), {{int(i), int(i), w},
                                   {int(i + 1), int(i + 1), w},
                                   {int(i), int(i + 1), -w},
                                   {int(i + 1), int(i), -w}});
  }
  Eigen::SparseMatrix<double> matrix(n + 1, n + 1);
  matrix.setFromTriplets(entries.begin(), entries.end());
  const DCM::internal::Laplacian_elimination<double>::Order order{3, 6, 1, 5, 2, 4}; // without 0
  EXPECT_TRUE(DCM::internal::Laplacian_elimination<double>::is_needed(matrix, order));
  DCM::internal::Laplacian_elimination<double> elimination;
  ASSERT_TRUE(elimination.factorize(matrix, Eigen::VectorXd::Zero(n + 1), order));
  Eigen::VectorXd current = Eigen::VectorXd::Zero(n + 1);
  current[n] = 1;
  const std::vector<double> potential = elimination.solve(current);
  double expected = 0;
  for(Eigen::Index i = 0; i < n; ++i) {
    expected += 1 / weight[std::size_t(i)];
    EXPECT_NEAR(potential[std::size_t(i + 1)] / expected, 1, 1e-14);
  }
}

// Steps have the width 10^-20 at any position, so slopes near them do not determine the other
// steps.
TEST(Root_of_increasing, steep_steps)
{
  typedef DCM::internal::Decimal_115 Number;
  for(const double root : {0., 1e-12, -0.3, 1e5}) {
    const auto function = [&](const Number& x) {
      const auto step = [](const Number& y) {
        return static_cast<double>(y / (1 + Number(y < 0 ? -y : y)));
      };
      const Number y = x - root;
      return step(y * 1e20) + 2 + step((y + 1) * 1e20) - step((1 - y) * 1e20) - 2 + 1e-3 * step(y);
    };
    const Number x = DCM::internal::root_of_increasing<Number>(function, 1, 1e-6);
    EXPECT_LE(std::abs(function(x)), 1e-6);
  }
}

// Variables form pairs of pairs.
TEST(Variable_groups, nested)
{
  const double tie[] = {1e8, 1e4, 1e8, 1, 1e8, 1e4, 1e8}; // between variables v and v + 1
  std::vector<Eigen::Triplet<double>> entries;
  for(int v = 0; v < 7; ++v)
    entries.insert(
      entries.end(),
      {{v, v, tie[v]}, {v + 1, v + 1, tie[v]}, {v, v + 1, -tie[v]}, {v + 1, v, -tie[v]}});
  Eigen::SparseMatrix<double> matrix(8, 8);
  matrix.setFromTriplets(entries.begin(), entries.end());
  std::vector<char> is_fixed(8, 0);
  is_fixed[7] = 1;
  std::vector<DCM::internal::Variable_groups::Group> groups =
    DCM::internal::Variable_groups(matrix, is_fixed).groups();
  std::size_t before = 8;
  for(auto& group : groups) {
    EXPECT_LE(group.size(), before);
    before = group.size();
    std::sort(group.begin(), group.end());
  }
  std::sort(groups.begin(), groups.end());
  const std::vector<DCM::internal::Variable_groups::Group> expected{
    {0}, {0, 1}, {0, 1, 2, 3}, {1}, {2}, {2, 3}, {3}, {4}, {4, 5}, {5}, {6}};
  EXPECT_EQ(groups, expected);
}

} // namespace Test_needles
