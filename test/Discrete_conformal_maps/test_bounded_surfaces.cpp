// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "bounded_surfaces.h"

#include <CGAL/Discrete_conformal_maps/cross_ratios.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Flat_triangle.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Hyperbolic_triangle.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Symmetric_energy.h>
#include <CGAL/Discrete_conformal_maps/map_to_sphere.h>
#include <CGAL/Discrete_conformal_maps/uniformize_hyperbolic.h>

namespace Test_bounded_surfaces {

using namespace Test_surfaces;
using DCM::internal::Doubled_problem;

// Returns the number of surfaces, which can be increased.
unsigned int number_of_surfaces(unsigned int usual)
{
  const char* text = std::getenv("NUMBER_OF_BOUNDED_SURFACES");
  return text ? static_cast<unsigned int>(std::atoi(text)) : usual;
}

// Returns a surface of genus 0 to 5 with 1 to 20 loops, or a plate.
Bounded_surface random_surface(unsigned int seed)
{
  if(seed % 5 == 0)
    return Bounded_surface(plate_with_square_holes(seed % 4), seed);
  return Bounded_surface(surface_with_holes(seed % 6, 1 + (seed * 7) % 20, seed), seed);
}

template <typename Map>
void expect_equal_scales(const Map& map, const Map& whole, const Bounded_surface& s)
{
  ASSERT_EQ(map.status(), whole.status());
  for(Vertex_index v : s.half.vertices())
    EXPECT_NEAR(map.log_scale(v), whole.log_scale(s.whole_vertex[v]), 1e-10) << v;
}

// ---- Scale factors are those of the whole double ----

TEST(Bounded_surface, mixed_conditions)
{
  for(unsigned int seed : seeds(1, number_of_surfaces(24) + 1)) {
    const Bounded_surface s = random_surface(seed);
    const Conditions condition = mixed_conditions(s, seed % 3 == 0 ? 3 : 0.5, seed);
    const Planar_conformal_map map = flatten(s.half, s.half_length, condition);
    const Planar_conformal_map whole = flatten(s.whole, s.whole_length, s.doubled(condition));
    EXPECT_EQ(map.status(), DCM::Map_status::success);
    expect_equal_scales(map, whole, s);
    check_conditions(map, s.half, condition, 1e-10);
  }
}

TEST(Bounded_surface, balanced_curvatures)
{
  for(unsigned int seed : seeds(1, number_of_surfaces(12) + 1)) {
    const Bounded_surface s = random_surface(seed);
    const Conditions condition = balanced_curvatures(s, seed);
    const Planar_conformal_map map = flatten(s.half, s.half_length, condition);
    expect_equal_scales(map, flatten(s.whole, s.whole_length, s.doubled(condition)), s);
    check_conditions(map, s.half, condition, 1e-10);
  }
}

TEST(Bounded_surface, hyperbolic_metric_with_geodesic_boundary)
{
  for(unsigned int seed : seeds(1, number_of_surfaces(8) + 1)) {
    const Bounded_surface s(surface_with_holes(1 + seed % 2, 1 + seed % 3, seed), seed);
    const auto map = DCM::uniformize_hyperbolic(s.half, length_parameter(s.half_length));
    expect_equal_scales(map, DCM::uniformize_hyperbolic(s.whole, length_parameter(s.whole_length)),
                        s);
    EXPECT_EQ(map.Delaunay().mesh().number_of_faces(), s.whole.number_of_faces());
  }
}

// ---- Points of the boundary also lie in faces of the second copy ----

// Checks that each corner of the subdivision in the input, as a point of the input, has the image
// of a corner there.
template <typename Map, typename Image>
void check_images(const Map& map, const Image& image)
{
  ASSERT_EQ(map.status(), DCM::Map_status::success);
  const auto& subdivision = map.subdivision();
  const Delta_complex& mesh = subdivision.mesh();
  std::vector<std::vector<std::complex<double>>> images(mesh.number_of_vertices());
  double size = 0;
  for(Halfedge_index h : mesh.halfedges())
    if(map.is_original(h)) {
      images[mesh.target(h)].push_back(image(h));
      size = (std::max)(size, std::abs(image(h)));
    }
  for(Halfedge_index h : mesh.halfedges())
    if(map.is_original(h)) {
      const auto z = map(subdivision.location(Layer::A, h));
      EXPECT_TRUE(std::any_of(images[mesh.target(h)].begin(), images[mesh.target(h)].end(),
                              [&](auto w) { return std::abs(z - w) < 1e-9 * size; }))
        << h << ' ' << z;
    }
}

void check_images(const Planar_conformal_map& map)
{
  check_images(map, [&](Halfedge_index h) { return map.image(h); });
}

TEST(Bounded_surface, points_of_the_boundary_have_images)
{
  for(unsigned int seed : seeds(1, number_of_surfaces(8) + 1)) {
    const Bounded_surface s(surface_with_holes(seed % 3, 1 + seed % 2, seed), seed);
    check_images(DCM::flatten(s.half, length_parameter(s.half_length)));
    check_images(flatten(s.half, s.half_length, balanced_curvatures(s, seed)));
    if(seed % 3 > 0) {
      const auto map = DCM::uniformize_hyperbolic(s.half, length_parameter(s.half_length));
      check_images(map, [&](Halfedge_index h) {
        return map.to_disk(map.homogeneous_coordinates(map.subdivision().location(Layer::C, h)));
      });
    }
  }
}

// Returns a disk whose boundary has `n` edges, one or two, in which vertices are inserted.
Sides disk_with_few_corners(int n, std::size_t insertions, unsigned int seed)
{
  Sides faces{{1, 2, -1}};
  int edges = 2;
  if(n == 2) {
    faces = {{1, 3, -2}, {2, 4, -1}};
    edges = 4;
  }
  CGAL::Random random(seed);
  for(std::size_t i = 0; i < insertions; ++i) {
    const auto k = std::size_t(random.get_int(0, int(faces.size())));
    const auto [x, y, z] = faces[k];
    const int p = ++edges, q = ++edges,
              r = ++edges; // from the targets of x, z and y to the new one
    faces[k] = {x, p, -q};
    faces.push_back({y, r, -p});
    faces.push_back({z, q, -r});
  }
  return faces;
}

// Checks a hemisphere, whose polyhedron is determined by its center of mass.
void check_hemisphere(const Bounded_surface& s)
{
  const auto map = DCM::map_to_sphere(s.half, length_parameter(s.half_length));
  const auto whole = DCM::map_to_sphere(s.whole, length_parameter(s.whole_length));
  ASSERT_EQ(map.status(), DCM::Map_status::success);
  ASSERT_EQ(whole.status(), DCM::Map_status::success);
  EXPECT_TRUE(map.certificate().is_convex());
  EXPECT_LT(DCM::max_cross_ratio_error(map), 1e-9);
  for(Vertex_index v : s.half.vertices()) {
    EXPECT_NEAR(map.log_scale(v), whole.log_scale(s.whole_vertex[v]), 1e-8) << v;
    EXPECT_EQ(map.position(v)[2] == 0, s.is_on_boundary(v));
    EXPECT_GE(map.position(v)[2], 0);
  }
  for(Vertex_index v : map.ideal().mesh().vertices()) {
    const auto p = map.position(v), q = map.position(map.input_vertex(v));
    EXPECT_EQ(p[2], v == map.input_vertex(v) ? q[2] : -q[2]);
    EXPECT_TRUE(p[0] == q[0] && p[1] == q[1]);
  }
}

TEST(Bounded_surface, hemisphere)
{
  for(unsigned int seed : seeds(1, number_of_surfaces(12) + 1))
    check_hemisphere(Bounded_surface(
      seed % 2 == 0 ? plate_with_square_holes(0) : surface_with_holes(0, 1, seed), seed));
}

// A boundary with one or two vertices has no two other vertices to find the axis.
TEST(Bounded_surface, hemisphere_with_few_corners)
{
  for(unsigned int seed : seeds(1, number_of_surfaces(12) + 1))
    for(int n : {1, 2})
      check_hemisphere(
        Bounded_surface(disk_with_few_corners(n, 2 + seed * seed % 149, seed), seed));
}

// ---- The part of the double that there is ----

TEST(Bounded_surface, the_inside_of_a_surface_is_not_copied)
{
  const Mesh mesh = perturbed(
    grid(40, 40, [](double x, double y) { return Point(x, y, 0.1 * std::sin(x + y)); }), 0.2, 3);
  const Triangulation half(mesh);
  const std::size_t n = half.mesh().number_of_vertices();
  Doubled_problem problem(half, default_conditions(half.mesh()), DCM::Flipping::to_Delaunay);
  EXPECT_GT(problem.originals().size(), n);
  EXPECT_LT(problem.originals().size(), n + n / 2);
  EXPECT_TRUE(IT::is_valid_Delta_complex(problem.triangulation().mesh()));
  EXPECT_TRUE(IT::is_valid_Delta_complex(problem.triangulation().input_mesh()));
  problem.complete();
  EXPECT_EQ(problem.originals().size(), 2 * n - 160);
  EXPECT_FALSE(has_border(problem.triangulation().mesh()));
  EXPECT_LT(DCM::map_to_sphere(mesh).ideal().mesh().number_of_vertices(), n + n / 2);
}

// Every face of the copy of some faces has the sides of its original face.
TEST(Doubled_surface, copies_some_faces)
{
  for(unsigned int seed = 1; seed <= 20; ++seed) {
    const Bounded_surface s = random_surface(seed);
    CGAL::Random random(seed);
    std::vector<char> is_near(s.half.number_of_vertices()), has_copy(s.half.number_of_faces(), 0);
    for(Vertex_index v : s.half.vertices())
      is_near[v] = s.is_on_boundary(v) || random.get_double(0, 1) < 0.2;
    for(Halfedge_index h : s.half.halfedges())
      if(!s.half.is_border(h) && is_near[s.half.target(h)])
        has_copy[s.half.face(h)] = 1;
    const DCM::internal::Doubled_surface doubled(s.half, has_copy);
    const Delta_complex& mesh = doubled.mesh();
    EXPECT_TRUE(IT::is_valid_Delta_complex(mesh));
    const auto copied = std::size_t(std::count(has_copy.begin(), has_copy.end(), 1));
    ASSERT_EQ(mesh.number_of_faces(), s.half.number_of_faces() + copied);
    for(Vertex_index v : s.half.vertices())
      EXPECT_EQ(doubled.originals()[v], v);
    for(Edge_index e : s.half.edges()) {
      const Edge_index m = doubled.mirrored(e);
      const auto ends = [&](Edge_index x) {
        return std::minmax(doubled.originals()[mesh.vertex(x, 0)],
                           doubled.originals()[mesh.vertex(x, 1)]);
      };
      EXPECT_EQ(ends(m), ends(e));
      EXPECT_EQ(mesh.is_border(e), false);
    }
    for(Vertex_index v : mesh.vertices())
      EXPECT_TRUE(v.idx() >= s.half.number_of_vertices() || !mesh.is_border(v));
    for(Edge_index e : doubled.seams())
      EXPECT_TRUE(mesh.is_border(doubled.mirrored(e)));
  }
}

// ---- Energies ----

// Checks that the energy and its derivatives are half of those values of the whole double, with
// scale factors far from zero.
template <template <typename> class Triangle>
void check_energy(unsigned int seed)
{
  const Bounded_surface s = random_surface(seed);
  CGAL::Random random(seed);
  Conditions condition(s.half.number_of_vertices());
  Eigen::VectorXd u(Eigen::Index(condition.size()));
  for(std::size_t v = 0; v < condition.size(); ++v) {
    condition[v] = Vertex_condition::curvature(random.get_double(-1, 1));
    u[Eigen::Index(v)] = random.get_double(-2, 2);
  }
  Doubled_problem problem(triangulation(s.half, s.half_length), condition,
                          DCM::Flipping::to_Delaunay);
  auto energy =
    DCM::internal::symmetric_energy<double, Triangle<double>>(problem, problem.triangulation());
  Triangulation t = triangulation(s.whole, s.whole_length);
  IT::make_Delaunay(t);
  Eigen::VectorXd target(Eigen::Index(s.front.size())), whole_u(target.size());
  const Conditions doubled = s.doubled(condition);
  for(std::size_t v = 0; v < s.front.size(); ++v) {
    target[Eigen::Index(v)] = doubled[v].value;
    whole_u[Eigen::Index(v)] = u[Eigen::Index(s.front[v].idx())];
  }
  DCM::Conformal_energy<double, Triangle<double>> whole(t.mesh(), t.length_map(), target);
  energy.evaluate(u);
  whole.evaluate(whole_u);
  EXPECT_NEAR(energy.value(), whole.value() / 2, 1e-11 * std::abs(whole.value()));
  const Eigen::MatrixXd all(whole.Hessian()), half(energy.Hessian());
  Eigen::MatrixXd fold = Eigen::MatrixXd::Zero(target.size(), u.size());
  for(std::size_t v = 0; v < s.front.size(); ++v)
    fold(Eigen::Index(v), Eigen::Index(s.front[v].idx())) = 1;
  const Eigen::VectorXd gradient = fold.transpose() * whole.gradient() / 2;
  const Eigen::MatrixXd folded = fold.transpose() * all * fold / 2;
  EXPECT_LT((energy.gradient() - gradient).cwiseAbs().maxCoeff(), 1e-11);
  EXPECT_LT((half - folded).cwiseAbs().maxCoeff(), 1e-9 * folded.cwiseAbs().maxCoeff());
  EXPECT_EQ((half - half.transpose()).cwiseAbs().maxCoeff(), 0);
}

TEST(Symmetric_energy, is_half_of_that_of_the_double)
{
  for(unsigned int seed : traced({1u, 2u, 3u, 6u, 7u, 12u})) {
    check_energy<DCM::internal::Flat_triangle>(seed);
    check_energy<DCM::internal::Hyperbolic_triangle>(seed);
  }
}

} // namespace Test_bounded_surfaces
