// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../Intrinsic_triangulations/hard_meshes.h"
#include "../Intrinsic_triangulations/near_degenerate_meshes.h"
#include "flat_maps.h"

#include <CGAL/Discrete_conformal_maps/Newton_minimizer.h>
#include <CGAL/Discrete_conformal_maps/uniformize_hyperbolic.h>
#include <CGAL/Intrinsic_triangulations/topological_type.h>
#include <Eigen/LU>

namespace Test_uniformize_hyperbolic {

using namespace Test_surfaces;
using DCM::Disk_motion;
using DCM::Hyperbolic_conformal_map;

// ---- Surfaces that are hyperbolic ----

struct Polar_point
{
  double distance, angle;
};

// Returns sinh(x/2) for the distance x, by the law of cosines.
double half_sinh(const Polar_point& p, const Polar_point& q)
{
  const double radial = std::sinh((p.distance - q.distance) / 2),
               around = std::sin((p.angle - q.angle) / 2);
  return std::sqrt(radial * radial +
                   std::sinh(p.distance) * std::sinh(q.distance) * around * around);
}

// Stores a triangulation with sinh(x/2) for the hyperbolic lengths x of its edges.
struct Hyperbolic_surface
{
  Delta_complex mesh;
  std::vector<double> length;
};

// Returns the angle at the source of `h` by the law of half angles.
double angle_at_source(const Hyperbolic_surface& s, Halfedge_index h)
{
  const auto length = [&](Halfedge_index x) { return 2 * std::asinh(s.length[s.mesh.edge(x)]); };
  const double a = length(s.mesh.next(h)), b = length(h), c = length(s.mesh.prev(h)),
               half = (a + b + c) / 2;
  return 2 * std::atan(std::sqrt(std::sinh(half - b) * std::sinh(half - c) /
                                 (std::sinh(half) * std::sinh(half - a))));
}

// Flips in the hyperbolic plane; the condition for lengths is the same as that of an ideal
// polyhedron.
void make_Delaunay(Hyperbolic_surface& s)
{
  const IT::Ideal_geometry_traits<double> traits;
  const auto length =
    boost::make_function_property_map<Edge_index>([&](Edge_index e) { return s.length[e]; });
  for(bool is_changed = true; is_changed;) {
    is_changed = false;
    for(Edge_index e : s.mesh.edges()) {
      const Halfedge_index h = s.mesh.halfedge(e), o = s.mesh.opposite(h);
      if(traits.is_locally_Delaunay_object()(IT::diamond(length, h, s.mesh)))
        continue;
      const double angle = angle_at_source(s, h) + angle_at_source(s, s.mesh.next(o)),
                   a = s.length[s.mesh.edge(s.mesh.prev(h))],
                   b = s.length[s.mesh.edge(s.mesh.next(o))];
      ASSERT_EQ(flip_status(h, s.mesh), IT::Operation_status::possible);
      flip_edge(h, s.mesh);
      s.length[e] = half_sinh({2 * std::asinh(a), 0}, {2 * std::asinh(b), angle});
      is_changed = true;
    }
  }
}

// Returns the regular polygon with 4 g sides and angles pi / 2g, opposite sides glued (the Bolza
// surface for g = 2). Vertices are the center, the corners, which are one vertex, and a point in
// each sector.
Hyperbolic_surface regular_surface(int g, unsigned int seed)
{
  const int n = 4 * g;
  const double turn = 2 * pi / n, cot = 1 / std::tan(turn / 2), radius = std::acosh(cot * cot),
               inner_radius = std::acosh(cot);
  CGAL::Random random(seed);
  Sides faces;
  std::vector<double> length(std::size_t(5 * n + n / 2));
  // Edges lead from the center to corner k, from the center to inner point k, from corners k and k
  // + 1 to it, and along sides.
  const auto outgoing = [&](int k) { return 1 + k % n; };
  for(int k = 0; k < n; ++k) {
    const Polar_point middle{0, 0}, corner{radius, turn * k}, next{radius, turn * (k + 1)},
      inner{inner_radius * random.get_double(0.2, 0.9), turn * (k + random.get_double(0.4, 0.6))};
    const int to_inner = 1 + n + k, from_corner = 1 + 2 * n + k, from_next = 1 + 3 * n + k,
              side = k < n / 2 ? 1 + 4 * n + k : -(1 + 4 * n + k - n / 2);
    faces.push_back({outgoing(k), from_corner, -to_inner});
    faces.push_back({side, from_next, -from_corner});
    faces.push_back({-outgoing(k + 1), to_inner, -from_next});
    const auto set = [&](int edge, const Polar_point& p, const Polar_point& q) {
      length[std::size_t(std::abs(edge) - 1)] = half_sinh(p, q);
    };
    set(outgoing(k), middle, corner);
    set(to_inner, middle, inner);
    set(from_corner, corner, inner);
    set(from_next, next, inner);
    set(side, corner, next);
  }
  length.resize(std::size_t(4 * n + n / 2));
  Hyperbolic_surface result{glue(faces), length};
  make_Delaunay(result);
  return result;
}

// Returns the ideal polyhedron of a surface with another decoration, in its Delaunay triangulation.
Hyperbolic_surface scaled(const Hyperbolic_surface& s, const std::vector<double>& u)
{
  DCM::Penner_surface<double> surface(s.mesh, boost::make_function_property_map<Edge_index>(
                                                [&](Edge_index e) { return s.length[e]; }));
  surface.scale(u);
  Hyperbolic_surface result{surface.mesh(), {}};
  for(Edge_index e : result.mesh.edges())
    result.length.push_back(surface.scaled_length(e));
  return result;
}

Hyperbolic_conformal_map uniformize(const Hyperbolic_surface& s)
{
  return DCM::uniformize_hyperbolic(s.mesh, length_parameter(s.length));
}

Hyperbolic_conformal_map uniformize(const Delta_complex& mesh, const std::vector<double>& length,
                                    const Conditions& condition)
{
  return DCM::uniformize_hyperbolic(
    mesh, length_parameter(length).vertex_condition_map(as_map(condition)));
}

// ---- What every map must obey ----

double distance(const std::array<double, 3>& p, const std::array<double, 3>& q)
{
  const double x = p[0] - q[0], y = p[1] - q[1], t = p[2] - q[2];
  return 2 * std::asinh(std::sqrt((std::max)(x * x + y * y - t * t, 0.)) / 2);
}

// Returns the angle by the law of cosines.
double angle_at_source(const Hyperbolic_conformal_map& map, Halfedge_index h)
{
  const Delta_complex& mesh = map.ideal().mesh();
  const double a = map.length(mesh.edge(mesh.next(h))), b = map.length(mesh.edge(h)),
               c = map.length(mesh.edge(mesh.prev(h)));
  return std::acos(std::clamp(
    (std::cosh(b) * std::cosh(c) - std::cosh(a)) / (std::sinh(b) * std::sinh(c)), -1., 1.));
}

void check_curvatures(const Hyperbolic_conformal_map& map)
{
  const Delta_complex& mesh = map.ideal().mesh();
  std::vector<double> sum(mesh.number_of_vertices(), 0);
  for(Halfedge_index h : mesh.halfedges())
    sum[mesh.source(h)] += angle_at_source(map, h);
  for(Vertex_index v : mesh.vertices())
    if(!mesh.is_isolated(v)) {
      EXPECT_NEAR(sum[v], 2 * pi, 1e-8)
        << v; // the formula loses half of the digits for short edges
    }
}

// Checks that distances in the plane are lengths, faces are counterclockwise, and motions glue
// them.
void check_layout(const Hyperbolic_conformal_map& map)
{
  const Delta_complex& mesh = map.ideal().mesh();
  // An error of the last digit of a coordinate moves a point by up to exp(radius) units.
  const double tolerance = 1e-13 * std::exp(map.radius());
  for(Halfedge_index h : mesh.halfedges()) {
    const Halfedge_index o = mesh.opposite(h);
    EXPECT_NEAR(distance(map.hyperboloid_position(h), map.hyperboloid_position(mesh.next(h))),
                map.length(mesh.edge(h)), tolerance)
      << h;
    const auto beyond = map.gluing(h);
    EXPECT_LT(std::abs(beyond(map.position(o)) - map.position(mesh.next(h))), tolerance) << h;
    EXPECT_LT(std::abs(beyond(map.position(mesh.next(o))) - map.position(h)), tolerance) << h;
  }
  for(Face_index f : mesh.faces()) {
    Eigen::Matrix3d corners;
    int row = 0;
    for(Halfedge_index h : IT::sides(f, mesh)) {
      for(int i = 0; i < 3; ++i)
        corners(row, i) = map.hyperboloid_position(h)[std::size_t(i)];
      ++row;
    }
    EXPECT_GT(corners.determinant(), 0) << f;
  }
}

void check_group(const DCM::Fuchsian_group& group, std::size_t genus)
{
  EXPECT_EQ(group.genus, genus);
  EXPECT_NEAR(group.area, 4 * pi * (double(genus) - 1), 1e-9);
  EXPECT_EQ(group.generators.size(), 2 * genus);
  EXPECT_LT(group.precise_generators.empty() ? group.relation_error : group.precise_relation_error,
            1e-8);
  std::vector<int> count(2 * (2 * genus), 0);
  for(const auto& letter : group.relation)
    ++count[2 * letter.generator + letter.is_inverse];
  EXPECT_EQ(count, std::vector<int>(2 * (2 * genus), 1));
  for(const Disk_motion<>& motion : group.generators)
    EXPECT_GT(std::abs(motion.a().real()), 1); // hyperbolic: no fixed point inside
}

// Returns the error of the product of rounded motions.
double rounded_relation_error(const DCM::Fuchsian_group& group)
{
  Disk_motion<> product;
  for(const auto& letter : group.relation) {
    const Disk_motion<>& motion = group.generators[letter.generator];
    product = product * (letter.is_inverse ? motion.inverse() : motion);
  }
  return product.distance_to_identity();
}

void check_map(const Hyperbolic_conformal_map& map, std::size_t genus)
{
  EXPECT_EQ(map.status(), DCM::Map_status::success);
  EXPECT_EQ(map.minimization().status, DCM::Minimization_status::converged);
  EXPECT_LT(map.max_curvature_error(), 1e-10);
  EXPECT_LE(map.max_gluing_error(), 1e-9);
  check_curvatures(map);
  check_layout(map);
  ASSERT_EQ(map.number_of_components(), 1u);
  check_group(map.group(0), genus);
}

// Checks that a point of the disk and its images across the seams are one point of the surface: the
// map is continuous.
void check_subdivision(const Hyperbolic_conformal_map& map)
{
  const auto& subdivision = map.subdivision();
  const auto& mesh = subdivision.mesh();
  const double tolerance = 1e-13 * std::exp(map.radius());
  const auto image = [&](Halfedge_index h) {
    return Hyperbolic_conformal_map::to_disk(
      map.homogeneous_coordinates(subdivision.location(DCM::Layer::C, h)));
  };
  for(Edge_index e : mesh.edges()) {
    const Edge_index c = subdivision.parent_edge(DCM::Layer::C, e);
    if(c.is_valid() && map.is_seam(c))
      continue;
    const Halfedge_index h = mesh.halfedge(e), o = mesh.opposite(h);
    EXPECT_LT(std::abs(image(h) - image(mesh.prev(o))), tolerance) << e;
    EXPECT_LT(std::abs(image(o) - image(mesh.prev(h))), tolerance) << e;
  }
}

std::vector<double> sorted_lengths(const Hyperbolic_conformal_map& map)
{
  std::vector<double> result;
  for(Edge_index e : map.ideal().mesh().edges())
    result.push_back(map.length(e));
  std::sort(result.begin(), result.end());
  return result;
}

// ---- Covers ----

// Returns four vertices of the plate with two holes, around one of the bars beside the first hole.
std::vector<Vertex_index> loop_around_bar()
{
  const Mesh plate = straight_plate_with_holes(2);
  std::vector<Vertex_index> result;
  for(const Point& p : {Point(1, 0, 0), Point(1, 0, 1), Point(1, 1, 1), Point(1, 1, 0)})
    for(Vertex_index v : plate.vertices())
      if(plate.point(v) == p)
        result.push_back(v);
  return result;
}

// Returns the halfedge of the base below a halfedge of a cover.
Halfedge_index below(Halfedge_index h, unsigned int sheets)
{
  return Halfedge_index(2 * (h.idx() / 2 / sheets) + h.idx() % 2);
}

// Cuts the surface along the loop. Across the cut, each copy meets the next one.
Hyperbolic_surface cyclic_cover(const Triangulation& base, const std::vector<Vertex_index>& loop,
                                unsigned int sheets)
{
  const Delta_complex& mesh = base.mesh();
  const auto follows_loop = [&](Halfedge_index h) {
    for(std::size_t i = 0; i < loop.size(); ++i)
      if(mesh.source(h) == loop[i] && mesh.target(h) == loop[(i + 1) % loop.size()])
        return true;
    return false;
  };
  Sides faces;
  std::vector<double> length;
  for(Edge_index e : mesh.edges())
    length.insert(length.end(), sheets, base.length(e));
  for(Face_index f : mesh.faces())
    for(unsigned int sheet = 0; sheet < sheets; ++sheet) {
      faces.emplace_back();
      std::size_t side = 0;
      for(Halfedge_index h : CGAL::halfedges_around_face(mesh.halfedge(f), mesh)) {
        const unsigned int copy =
          follows_loop(mesh.opposite(h)) ? (sheet + sheets - 1) % sheets : sheet;
        const int label = int(h.idx() / 2 * sheets + copy) + 1;
        faces.back()[side++] = h.idx() % 2 == 0 ? label : -label;
      }
    }
  return {glue(faces), length};
}

// ---- Known surfaces ----

TEST(Uniformize_hyperbolic, regular_surfaces_come_back)
{
  for(const int g : traced({2, 3, 4, 5, 6, 7, 8, 70})) {
    const Hyperbolic_surface regular = regular_surface(g, 5);
    const std::size_t n = regular.mesh.number_of_vertices();
    EXPECT_EQ(n, std::size_t(2 + 4 * g));
    const std::vector<double> u = random_values(n, 1, 7);
    const Hyperbolic_conformal_map map = uniformize(scaled(regular, u));
    for(std::size_t v = 0; v < n; ++v)
      EXPECT_NEAR(map.log_scale(Vertex_index(unsigned(v))), -u[v], 1e-10) << v;
    check_map(map, std::size_t(g));
    check_subdivision(map);
  }
}

// For a closed geodesic of length x on the Bolza surface, cosh(x/2) is m + n sqrt(2) with integers.
// Here m is odd and as close to n sqrt(2) as possible (Aurich, Bogomolny, Steiner 1991).
TEST(Uniformize_hyperbolic, generators_of_the_Bolza_surface_have_its_lengths)
{
  const Hyperbolic_surface regular = regular_surface(2, 5);
  const auto u = random_values(regular.mesh.number_of_vertices(), 1, 11);
  const Hyperbolic_conformal_map map = uniformize(scaled(regular, u));
  for(const Disk_motion<>& motion : map.group(0).generators) {
    const double cosh = std::abs(motion.a().real());
    bool is_known = false;
    for(int n = 1; n < 100; ++n) {
      const double m = 2 * std::floor(n * std::sqrt(2.) / 2) + 1;
      is_known |= std::abs(cosh - m - n * std::sqrt(2.)) < 1e-8;
    }
    EXPECT_TRUE(is_known) << cosh;
  }
  EXPECT_LT(rounded_relation_error(map.group(0)), 1e-8);
}

// A point of the hyperboloid is inside the disk, however far it is from the origin.
TEST(Uniformize_hyperbolic, images_are_inside_the_disk)
{
  for(double distance = 0; distance < 300; distance += 0.3)
    for(double angle = 0; angle < 6.3; angle += 0.1) {
      const double s = std::sinh(distance);
      const std::complex<double> z = Hyperbolic_conformal_map::to_disk(
        {s * std::cos(angle), s * std::sin(angle), std::cosh(distance)});
      EXPECT_LT(std::abs(z), 1) << distance << ' ' << angle;
      EXPECT_NEAR(std::abs(z), std::tanh(distance / 2), 1e-7) << distance << ' ' << angle;
    }
}

// The surface has a closed and a bounded component, and the area is half of the area of the double.
TEST(Uniformize_hyperbolic, areas_of_components_are_their_own)
{
  Mesh mesh = punctured(plate_with_holes(2), {3});
  mesh += plate_with_holes(3);
  const Hyperbolic_conformal_map map = DCM::uniformize_hyperbolic(mesh);
  ASSERT_EQ(map.number_of_components(), 2u);
  for(std::size_t c = 0; c < 2; ++c) {
    const IT::Topological_type& type = map.topology(c);
    EXPECT_EQ(type.genus, c + 2);
    EXPECT_EQ(type.boundary_loops, 1 - c);
    EXPECT_NEAR(map.area(c), 2 * pi * (2. * double(type.genus) - 2 + double(type.boundary_loops)),
                1e-9);
  }
  EXPECT_NEAR(map.area(), map.area(0) + map.area(1), 1e-12);
  EXPECT_NEAR(map.group(0).area, 2 * map.area(0), 1e-9);
}

// Statements about the group are true for its stored generators.
TEST(Uniformize_hyperbolic, errors_of_relations_are_those_of_the_generators)
{
  const DCM::Fuchsian_group group = DCM::uniformize_hyperbolic(plate_with_holes(16)).group(0);
  ASSERT_EQ(group.precise_generators.size(), group.generators.size());
  const double precise = DCM::relation_error(group, group.precise_generators);
  EXPECT_LE(precise, 1e-9);
  EXPECT_EQ(precise, group.precise_relation_error);
  EXPECT_GT(group.relation_error, precise);
  for(std::size_t i = 0; i < group.generators.size(); ++i)
    for(std::size_t k = 0; k < 4; ++k)
      EXPECT_NEAR(group.generators[i].entries()[k],
                  static_cast<double>(group.precise_generators[i].entries()[k]),
                  1e-15 * std::abs(group.generators[i].entries()[k]));
}

// With four cones with angles of pi / 2, the faces are regular triangles with angles of pi / 6.
// They satisfy 2 cosh(x/2) sin(pi/12) = 1.
TEST(Uniformize_hyperbolic, tetrahedron_with_cones)
{
  const Triangulation t(tetrahedron());
  const Hyperbolic_conformal_map map =
    uniformize(t.mesh(), lengths_of(t), Conditions(4, Vertex_condition::curvature(1.5 * pi)));
  EXPECT_LT(map.max_curvature_error(), 1e-10);
  EXPECT_NEAR(map.area(), 2 * pi, 1e-10);
  for(Edge_index e : map.ideal().mesh().edges())
    EXPECT_NEAR(2 * std::cosh(map.length(e) / 2) * std::sin(pi / 12), 1, 1e-12);
  EXPECT_TRUE(map.group(0).relation.empty());
  check_layout(map);
}

// ---- Surfaces in space ----

TEST(Uniformize_hyperbolic, plates_with_holes)
{
  for(int g = 2; g <= 8; ++g) {
    SCOPED_TRACE(g);
    const Hyperbolic_conformal_map map = DCM::uniformize_hyperbolic(plate_with_holes(g));
    check_map(map, std::size_t(g));
    check_subdivision(map);
  }
}

// Vertices that are mirror images have equal scale factors, whatever the diagonals of the squares
// are.
TEST(Uniformize_hyperbolic, symmetric_surfaces_get_symmetric_metrics)
{
  for(int g = 2; g <= 4; ++g) {
    const Mesh mesh = straight_plate_with_holes(g);
    const Hyperbolic_conformal_map map = DCM::uniformize_hyperbolic(mesh);
    std::map<std::array<double, 3>, double> scale;
    const std::array<double, 3> size{2. * g + 1, 3, 1};
    for(Vertex_index v : mesh.vertices()) {
      const Point& p = mesh.point(v);
      scale[{p[0], p[1], p[2]}] = map.log_scale(v);
    }
    for(const auto& [p, u] : scale)
      for(std::size_t axis = 0; axis < 3; ++axis) {
        std::array<double, 3> mirrored = p;
        mirrored[axis] = size[axis] - p[axis];
        ASSERT_EQ(scale.count(mirrored), 1u);
        EXPECT_NEAR(scale[mirrored], u, 1e-12);
      }
  }
}

// In a row of handles, errors grow exponentially with the distance from the center. So 115 digits
// suffice for a hundred of them, but not for two hundred.
TEST(Uniformize_hyperbolic, the_status_says_what_has_failed)
{
  EXPECT_EQ(DCM::uniformize_hyperbolic(plate_with_holes(20)).status(), DCM::Map_status::success);
  EXPECT_EQ(DCM::uniformize_hyperbolic(straight_plate_with_holes(100)).status(),
            DCM::Map_status::success);
  const Hyperbolic_conformal_map large = DCM::uniformize_hyperbolic(straight_plate_with_holes(200));
  EXPECT_EQ(large.minimization().status, DCM::Minimization_status::converged);
  EXPECT_GT(large.max_gluing_error(), 1e-9);
  EXPECT_EQ(large.status(), DCM::Map_status::not_glued);
  const Hyperbolic_conformal_map stopped = DCM::uniformize_hyperbolic(
    plate_with_holes(2), DCM::parameters::minimizer(DCM::Newton_minimizer(1e-13, 1)));
  EXPECT_EQ(stopped.minimization().status, DCM::Minimization_status::iteration_limit);
  EXPECT_EQ(stopped.status(), DCM::Map_status::not_converged);
}

// A triangulation that is Delaunay with rounded scale factors is not Delaunay with more digits. The
// faces of these surfaces close up only if edges are flipped again.
TEST(Uniformize_hyperbolic, near_degenerate_surfaces_close_up)
{
  for(const unsigned int seed : traced({970007u, 970015u, 970051u})) {
    const Mesh mesh = near_degenerate_mesh(seed).mesh;
    const Hyperbolic_conformal_map map = DCM::uniformize_hyperbolic(mesh);
    EXPECT_EQ(map.status(), DCM::Map_status::success);
    EXPECT_LE(map.max_gluing_error(), 1e-9);
    ASSERT_EQ(map.number_of_components(), 1u);
    const auto euler = static_cast<long>(mesh.number_of_vertices() + mesh.number_of_faces()) -
                       static_cast<long>(mesh.number_of_edges());
    check_group(map.group(0), static_cast<std::size_t>(1 - euler / 2));
  }
}

// Steps in `double` would change the differences of scale factors at needles by too much.
TEST(Uniformize_hyperbolic, needles_close_up)
{
  std::size_t count = 0;
  for(std::uint64_t seed = 0; seed < 6 * hard_families.size(); ++seed) {
    const Mesh mesh = hard_mesh(seed).mesh;
    const IT::Topological_type type = IT::topological_type(Triangulation(mesh).mesh());
    if(type.components != 1 || 2 * type.genus + type.boundary_loops < 3)
      continue;
    SCOPED_TRACE(seed);
    ++count;
    const Hyperbolic_conformal_map map = DCM::uniformize_hyperbolic(mesh);
    EXPECT_EQ(map.status(), DCM::Map_status::success);
    EXPECT_LE(map.max_gluing_error(), 1e-9);
    check_group(map.group(0),
                type.boundary_loops > 0 ? 2 * type.genus + type.boundary_loops - 1 : type.genus);
  }
  EXPECT_GT(count, 10u);
}

// The same surface has any triangulation with the same vertices, from few flips to a thorough mix.
// The edges of the result are the edges of the hyperbolic Delaunay triangulation, in any order.
TEST(Uniformize_hyperbolic, does_not_depend_on_the_triangulation)
{
  for(int g = 2; g <= 4; ++g) {
    const Triangulation t(plate_with_holes(g));
    const Hyperbolic_conformal_map map = uniformize({t.mesh(), lengths_of(t)});
    for(const std::size_t flips : {1u, 30u, 300u, 3000u}) {
      SCOPED_TRACE(std::to_string(g) + ' ' + std::to_string(flips));
      Triangulation flipped = t;
      flip_at_random(flipped, flips, 3);
      const Hyperbolic_conformal_map other = uniformize({flipped.mesh(), lengths_of(flipped)});
      for(Vertex_index v : t.mesh().vertices())
        EXPECT_NEAR(map.log_scale(v), other.log_scale(v), 1e-9);
      const std::vector<double> one = sorted_lengths(map), two = sorted_lengths(other);
      ASSERT_EQ(one.size(), two.size());
      for(std::size_t i = 0; i < one.size(); ++i)
        EXPECT_NEAR(one[i], two[i], 1e-9);
    }
  }
}

// The metric of a surface, lifted to a covering surface, is discretely conformal on it and unique.
TEST(Uniformize_hyperbolic, covers_get_the_lifted_metric)
{
  const Triangulation base(plate_with_holes(2));
  const Hyperbolic_conformal_map map = uniformize({base.mesh(), lengths_of(base)});
  for(const unsigned int sheets : traced({2u, 3u})) {
    const Hyperbolic_surface cover = cyclic_cover(base, loop_around_bar(), sheets);
    ASSERT_EQ(cover.mesh.number_of_vertices(), sheets * base.mesh().number_of_vertices());
    const Hyperbolic_conformal_map lifted = uniformize(cover);
    check_map(lifted, sheets + 1); // the Euler characteristic is -2 per sheet
    for(Halfedge_index h : cover.mesh.halfedges())
      EXPECT_NEAR(lifted.log_scale(cover.mesh.source(h)),
                  map.log_scale(base.mesh().source(below(h, sheets))), 1e-9);
  }
}

// One common variable of all vertices compensates the size.
TEST(Uniformize_hyperbolic, does_not_depend_on_the_size)
{
  const Triangulation t(plate_with_holes(2));
  std::vector<double> length = lengths_of(t);
  const Hyperbolic_conformal_map map = uniformize({t.mesh(), length});
  for(const double size : {1e-20, 1e20}) {
    std::vector<double> other = length;
    for(double& x : other)
      x *= size;
    const Hyperbolic_conformal_map same = uniformize({t.mesh(), other});
    for(Vertex_index v : t.mesh().vertices())
      EXPECT_NEAR(same.log_scale(v) + std::log(size), map.log_scale(v), 1e-10);
  }
}

TEST(Uniformize_hyperbolic, components_of_their_own)
{
  Mesh mesh = plate_with_holes(2);
  mesh.add_vertex(Point(9, 9, 9));
  mesh += plate_with_holes(3);
  const Hyperbolic_conformal_map map = DCM::uniformize_hyperbolic(mesh);
  ASSERT_EQ(map.number_of_components(), 2u);
  check_group(map.group(0), 2);
  check_group(map.group(1), 3);
  check_layout(map);
}

// The surface is a plate with two holes without two of its faces, so the double has genus five.
TEST(Uniformize_hyperbolic, boundaries_are_geodesics)
{
  const Mesh mesh = punctured(plate_with_holes(2), {3, 40});
  const Hyperbolic_conformal_map map = DCM::uniformize_hyperbolic(mesh);
  check_map(map, 5);
  EXPECT_EQ(map.topology(0).genus, 2u);
  EXPECT_EQ(map.topology(0).boundary_loops, 2u);
  EXPECT_NEAR(map.area(0), 8 * pi, 1e-9); // 2 pi (2 genus - 2 + boundaries)
  EXPECT_NEAR(map.area(), 8 * pi, 1e-9);
  for(Vertex_index v : map.ideal().mesh().vertices())
    EXPECT_NEAR(map.log_scale(v), map.log_scale(map.input_vertex(v)), 1e-10);
}

// ---- Points ----

// The barycenter of three corners of a face of the subdivision is found on T_1 and then by the map,
// and by averaging the homogeneous coordinates of the corners.
TEST(Uniformize_hyperbolic, maps_points_as_the_subdivision_does)
{
  const Mesh input = plate_with_holes(2);
  const Hyperbolic_conformal_map map = DCM::uniformize_hyperbolic(input);
  const auto& subdivision = map.subdivision();
  for(Face_index f : subdivision.mesh().faces()) {
    Location middle{subdivision.parent_face(DCM::Layer::A, f), {0, 0, 0}};
    std::array<double, 3> sum{0, 0, 0};
    Halfedge_index h = subdivision.mesh().halfedge(f);
    for(int i = 0; i < 3; ++i, h = subdivision.mesh().next(h)) {
      const Location p =
        on_face(map, middle.first,
                IT::face_location(subdivision.place(DCM::Layer::A, subdivision.mesh().target(h)),
                                  subdivision.mesh(DCM::Layer::A)));
      const auto z = map.homogeneous_coordinates(subdivision.location(DCM::Layer::C, h));
      for(std::size_t k = 0; k < 3; ++k) {
        middle.second[k] += p.second[k] / 3;
        sum[k] += z[k];
      }
    }
    EXPECT_LT(std::abs(Hyperbolic_conformal_map::to_disk(sum) - map(middle)), 1e-10) << f;
  }
}

// ---- Errors ----

TEST(Uniformize_hyperbolic, refuses_what_cannot_be)
{
  EXPECT_THROW(DCM::uniformize_hyperbolic(tetrahedron()), IT::Invalid_input);
  EXPECT_THROW(DCM::uniformize_hyperbolic(embedded_torus(5, 4)), IT::Invalid_input);
  const Triangulation t(tetrahedron());
  EXPECT_THROW(uniformize(t.mesh(), lengths_of(t), Conditions(4, Vertex_condition::curvature(pi))),
               IT::Invalid_input);
  EXPECT_THROW(
    uniformize(t.mesh(), lengths_of(t), Conditions(4, Vertex_condition::curvature(2 * pi))),
    IT::Invalid_input);
}

TEST(Uniformize_hyperbolic, gives_the_same_bits_twice)
{
  const Mesh mesh = plate_with_holes(3);
  const Hyperbolic_conformal_map one = DCM::uniformize_hyperbolic(mesh),
                                 other = DCM::uniformize_hyperbolic(mesh);
  for(Halfedge_index h : one.ideal().mesh().halfedges())
    EXPECT_EQ(one.hyperboloid_position(h), other.hyperboloid_position(h));
}

TEST(Uniformize_hyperbolic, empty_mesh_gives_an_empty_map)
{
  const Hyperbolic_conformal_map map = DCM::uniformize_hyperbolic(Mesh());
  EXPECT_EQ(map.number_of_components(), 0u);
  EXPECT_EQ(map.area(), 0);
}

} // namespace Test_uniformize_hyperbolic
