// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "flat_maps.h"

#include <CGAL/Discrete_conformal_maps/cross_ratios.h>
#include <CGAL/Discrete_conformal_maps/flatten_to_disk.h>
#include <CGAL/Discrete_conformal_maps/flatten_to_rectangle.h>
#include <CGAL/Discrete_conformal_maps/map_to_sphere.h>

// A map is a success if and only if it satisfies its promises, measured here in other ways.
namespace Test_map_status {

using namespace Test_surfaces;
using DCM::Map_status;
using Squares = std::set<std::pair<int, int>>;

// ---- Flat surfaces that are hard to map ----

// Cuts each square of a grid into k * k, and these by random diagonals.
Mesh mesh_of(const Squares& squares, int k, CGAL::Random& random)
{
  Mesh mesh;
  std::map<std::pair<int, int>, Vertex_index> vertex;
  const auto at = [&](int i, int j) {
    const auto [found, is_new] = vertex.insert({{i, j}, Vertex_index()});
    if(is_new)
      found->second = mesh.add_vertex({double(i) / k, double(j) / k, 0});
    return found->second;
  };
  for(const auto& [a, b] : squares)
    for(int i = a * k; i < (a + 1) * k; ++i)
      for(int j = b * k; j < (b + 1) * k; ++j) {
        std::array<Vertex_index, 4> q{at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)};
        if(random.get_bool())
          std::rotate(q.begin(), q.begin() + 1, q.end());
        mesh.add_face(q[0], q[1], q[2]);
        mesh.add_face(q[0], q[2], q[3]);
      }
  return mesh;
}

Squares strip(int length)
{
  Squares result;
  for(int i = 0; i < length; ++i)
    result.insert({i, 0});
  return result;
}

Squares comb(int teeth, int length)
{
  Squares result = strip(2 * teeth - 1);
  for(int i = 0; i < teeth; ++i)
    for(int j = 1; j <= length; ++j)
      result.insert({2 * i, j});
  return result;
}

// Returns rows of squares, joined alternately at their ends.
Squares serpentine(int length, int rows)
{
  Squares result;
  for(int j = 0; j < rows; ++j) {
    for(int i = 0; i < length; ++i)
      result.insert({i, 2 * j});
    if(j + 1 < rows)
      result.insert({j % 2 == 0 ? length - 1 : 0, 2 * j + 1});
  }
  return result;
}

// Returns the corridors of a maze: squares of a random tree.
Squares maze(int size, CGAL::Random& random)
{
  constexpr std::array<std::pair<int, int>, 4> step{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
  Squares result{{0, 0}};
  std::vector<std::pair<int, int>> way{{0, 0}};
  while(!way.empty()) {
    const auto [x, y] = way.back();
    std::vector<std::pair<int, int>> free;
    for(const auto& [dx, dy] : step)
      if(const int i = x + 2 * dx, j = y + 2 * dy;
         i >= 0 && j >= 0 && i < 2 * size && j < 2 * size && !result.count({i, j}))
        free.push_back({dx, dy});
    if(free.empty()) {
      way.pop_back();
      continue;
    }
    const auto [dx, dy] = free[std::size_t(random.get_int(0, int(free.size())))];
    result.insert({x + dx, y + dy});
    way.push_back({x + 2 * dx, y + 2 * dy});
    result.insert(way.back());
  }
  return result;
}

struct Case
{
  std::string name;
  Mesh mesh;
};

std::vector<Case> hard_disks(unsigned int seed)
{
  CGAL::Random random(seed);
  const auto draw = [&](int from, int to) { return random.get_int(from, to); };
  std::vector<Case> result;
  const auto add = [&](const char* name, const Squares& squares, int k) {
    result.push_back(
      {name + std::string(" of seed ") + std::to_string(seed), mesh_of(squares, k, random)});
  };
  add("short strip", strip(draw(2, 12)), 2);
  add("long strip", strip(draw(100, 300)), draw(1, 3));
  add("comb", comb(draw(2, 8), draw(1, 10)), draw(1, 3));
  add("serpentine", serpentine(draw(3, 9), draw(2, 9)), draw(1, 3));
  add("maze", maze(draw(2, 7), random), draw(1, 3));
  return result;
}

// ---- Independent measures ----

// Returns the angle from half of it, which keeps its digits.
double angle_opposite(double a, double b, double c)
{
  const double s = (a + b + c) / 2, rest = (std::max)(s - a, 0.);
  return 2 * std::atan2(std::sqrt((std::max)((s - b) * (s - c), 0.)), std::sqrt(s * rest));
}

// Returns the sums of angles in the scaled lengths, on the double.
std::vector<double> angle_sums(const Planar_conformal_map& map)
{
  const Delta_complex& flat = mesh_C(map);
  const std::vector<double> length = scaled_lengths(map);
  std::vector<double> result(flat.number_of_vertices(), 0);
  for(Halfedge_index h : flat.halfedges())
    if(!flat.is_border(h))
      result[flat.source(h)] += angle_opposite(
        length[flat.edge(flat.next(h))], length[flat.edge(h)], length[flat.edge(flat.prev(h))]);
  return result;
}

double curvature_inside(const Planar_conformal_map& map, const Mesh& mesh)
{
  const std::vector<double> angle = angle_sums(map);
  double result = 0;
  for(Vertex_index v : mesh.vertices())
    if(!mesh.is_border(v))
      result = (std::max)(result, std::abs(angle[v] - 2 * pi));
  return result;
}

using Points = std::vector<std::complex<double>>;

// Returns the images of the vertices on the boundary.
Points boundary_image(const Planar_conformal_map& map)
{
  const auto& s = map.subdivision();
  Points result;
  for(Halfedge_index h : s.mesh().halfedges())
    if(map.is_original(h) && !map.is_original(s.mesh().opposite(h)) &&
       s.parent_vertex(Layer::A, s.mesh().target(h)).is_valid()) {
      const auto z = map.homogeneous_coordinates(s.location(Layer::C, h));
      result.push_back(std::complex<double>(z[0], z[1]) / z[2]);
    }
  return result;
}

// Returns the greatest distance of a point from the nearest side of the box around all points,
// relative to its diagonal. Charts are turned such that their smallest boxes are parallel to the
// axes.
double distance_from_box(const Points& points)
{
  std::complex<double> low = points[0], high = points[0];
  for(const auto& z : points) {
    low = {(std::min)(low.real(), z.real()), (std::min)(low.imag(), z.imag())};
    high = {(std::max)(high.real(), z.real()), (std::max)(high.imag(), z.imag())};
  }
  double result = 0;
  for(const auto& z : points)
    result = (std::max)(result, (std::min)({z.real() - low.real(), high.real() - z.real(),
                                            z.imag() - low.imag(), high.imag() - z.imag()}));
  return result / std::abs(high - low);
}

// Returns the greatest difference of a distance from the center of the circle through three points
// that are far from each other, relative to its radius.
double distance_from_circle(const Points& points)
{
  const auto farthest = [&](const auto& distance) {
    return *std::max_element(points.begin(), points.end(), [&](const auto& z, const auto& w) {
      return distance(z) < distance(w);
    });
  };
  const auto a = points[0], b = farthest([&](const auto&z) { return std::abs(z - a); }) - a,
             c = farthest([&](const auto&z) { return std::abs(((z - a) * std::conj(b)).imag()); }) -
                 a;
  const std::complex<double> i(0, 1);
  const auto center =
    a - i * (std::norm(b) * c - std::norm(c) * b) / (2 * (std::conj(b) * c).imag());
  double result = 0;
  for(const auto& z : points)
    result = (std::max)(result, std::abs(std::abs(z - center) / std::abs(a - center) - 1));
  return result;
}

// Checks that a failure has a broken promise.
void check_status(const DCM::Discrete_conformal_map& map)
{
  const auto& promises = map.promises();
  ASSERT_FALSE(promises.empty());
  const bool is_kept = std::all_of(promises.begin(), promises.end(),
                                   [](const DCM::Map_promise& p) { return p.error <= p.bound; });
  EXPECT_EQ(map.status() == Map_status::success, is_kept) << DCM::to_string(map.status());
}

void check_flat(const Planar_conformal_map& map, const Mesh& mesh)
{
  check_status(map);
  if(map.status() != Map_status::success)
    return;
  EXPECT_LE(map.max_curvature_error(), 1e-10);
  EXPECT_LT(curvature_inside(map, mesh), 1e-9);
  EXPECT_LE(DCM::max_cross_ratio_error(map), 1e-8);
}

// ---- Tests ----

class Hard_disks : public testing::TestWithParam<unsigned int>
{};

TEST_P(Hard_disks, status_and_errors_agree_on_rectangles)
{
  int successes = 0;
  for(const auto& [name, mesh] : traced(hard_disks(GetParam()))) {
    const Planar_conformal_map map = DCM::flatten_to_rectangle(mesh, DCM::rectangle_corners(mesh));
    check_flat(map, mesh);
    if(map.status() == Map_status::success) {
      EXPECT_LT(distance_from_box(boundary_image(map)), 1e-7);
      ++successes;
    }
  }
  EXPECT_GT(successes, 0);
}

TEST_P(Hard_disks, status_and_errors_agree_on_disks)
{
  int successes = 0;
  for(const auto& [name, mesh] : traced(hard_disks(GetParam()))) {
    const Planar_conformal_map map =
      DCM::flatten_to_disk(mesh, CGAL::parameters::number_of_iterations(20));
    check_flat(map, mesh);
    if(map.status() == Map_status::success) {
      EXPECT_LT(distance_from_circle(boundary_image(map)), 1e-7);
      ++successes;
    }
  }
  EXPECT_GT(successes, 0);
}

INSTANTIATE_TEST_SUITE_P(Seeds, Hard_disks, testing::Range(0u, 4u));

// Exterior angles of zero are kept: cones that a bound of scale factors needs are inside.
TEST(Map_status, cones_leave_straight_boundaries_alone)
{
  for(unsigned int seed = 0; seed < 4; ++seed) {
    CGAL::Random random(seed);
    const Mesh mesh = mesh_of(comb(3, 2), 3, random);
    const Conditions straight(mesh.number_of_vertices());
    const Planar_conformal_map map = DCM::flatten(
      mesh, DCM::parameters::vertex_condition_map(as_map(straight)).maximum_log_scale(2.));
    EXPECT_EQ(map.status(), Map_status::success);
    EXPECT_GE(map.cones().size(), 2u); // less than a full turn each, together a full turn
    for(Vertex_index v : map.cones())
      EXPECT_FALSE(mesh.is_border(v));
    const std::vector<double> angle = angle_sums(map);
    for(Vertex_index v : mesh.vertices())
      if(mesh.is_border(v)) {
        EXPECT_NEAR(angle[v], 2 * pi, 1e-9); // on the double
      }
  }
}

// Two triangles are a polygon in a great circle, seen from both sides, and the status names it.
TEST(Map_status, flat_polygons_are_no_hemispheres)
{
  CGAL::Random random(1);
  const DCM::Spherical_conformal_map map = DCM::map_to_sphere(mesh_of(strip(1), 1, random));
  check_status(map);
  EXPECT_EQ(map.status(), Map_status::success);
  EXPECT_TRUE(map.is_flat());
}

// Lengths that are out of range cause no exceptions.
TEST(Map_status, numerical_errors_are_statuses)
{
  const Mesh mesh = tetrahedron();
  const Conditions condition(mesh.number_of_vertices(), Vertex_condition::log_scale(4000));
  const Planar_conformal_map map =
    DCM::flatten(mesh, DCM::parameters::vertex_condition_map(as_map(condition)));
  check_status(map);
  EXPECT_NE(map.status(), Map_status::success);
  EXPECT_FALSE(map.is_laid_out());
}

TEST(Map_status, every_failure_has_a_name_and_advice)
{
  std::set<std::string> names;
  for(int i = 0; i <= static_cast<int>(Map_status::not_glued); ++i) {
    const auto status = static_cast<Map_status>(i);
    EXPECT_TRUE(names.insert(DCM::to_string(status)).second);
    EXPECT_STRNE(DCM::to_string(status), "unknown");
    EXPECT_EQ(std::string(DCM::advice(status)).empty(), status == Map_status::success);
  }
}

// The first broken promise determines the status, unless scale factors have not been found.
TEST(Map_status, follows_from_promises_alone)
{
  using DCM::internal::status_of;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const DCM::Map_promise kept{"curvature", 0, 1e-10, Map_status::wrong_curvature},
    missed{"curvature", 1, 1e-10, Map_status::wrong_curvature},
    unknown{"cross_ratio", nan, 1e-8, Map_status::not_conformal};
  EXPECT_EQ(status_of({kept}, Map_status::not_converged), Map_status::success);
  EXPECT_EQ(status_of({missed}, Map_status::success), Map_status::wrong_curvature);
  EXPECT_EQ(status_of({missed, unknown}, Map_status::not_converged), Map_status::not_converged);
  EXPECT_EQ(status_of({kept, unknown}, Map_status::not_converged), Map_status::not_conformal);
}

// A success has no greater error of curvatures than promised, whatever the search has reported.
TEST(Map_status, curvature_errors_of_successes_are_measured)
{
  using DCM::internal::curvature_error_of;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto curvature = [](double error) {
    return DCM::Map_promise{"curvature", error, 1e-10, Map_status::wrong_curvature};
  };
  const DCM::Map_promise wrong{"cross_ratio", 1, 1e-8, Map_status::not_conformal};
  for(const double search : {1.2, nan})
    EXPECT_EQ(curvature_error_of({curvature(1e-12), curvature(1e-11)}, search), 1e-11);
  EXPECT_EQ(curvature_error_of({curvature(1e-12), wrong}, 1.2), 1.2);
  EXPECT_EQ(curvature_error_of({curvature(2)}, 1.2), 2);
  EXPECT_TRUE(std::isnan(curvature_error_of({curvature(nan)}, 1.2)));
}

} // namespace Test_map_status
