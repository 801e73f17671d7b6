// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Maps whose scale factors, or pictures, are beyond the range of `double`.

#include "planar_cells.h"

#include <CGAL/Discrete_conformal_maps/cross_ratios.h>
#include <CGAL/Discrete_conformal_maps/flatten_to_disk.h>
#include <CGAL/Discrete_conformal_maps/internal/minimization/Difference_bounded_newton.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Flat_triangle.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Search_work.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Symmetric_energy.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/number_types.h>
#include <CGAL/Discrete_conformal_maps/internal/verification/exact_promises.h>
#include <CGAL/Discrete_conformal_maps/map_to_sphere.h>
#include <CGAL/Discrete_conformal_maps/texture_points.h>
#include <CGAL/Discrete_conformal_maps/uniformize_hyperbolic.h>

#include "../Intrinsic_triangulations/generators.h"
#include "../Intrinsic_triangulations/near_degenerate_meshes.h"
#include "../Intrinsic_triangulations/refined_meshes.h"

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/point_generators_3.h>

namespace Test_crowding {

using namespace Test_surfaces;
using DCM::Spherical_conformal_map;

// Returns unit squares in a row, each cut along a diagonal.
Mesh strip(std::size_t n)
{
  return grid(n, 1, [](double x, double y) { return Point(x, y, 0); });
}

// Returns `n` by `m` squares along a spiral.
Mesh spiral(std::size_t n, std::size_t m)
{
  return grid(n, m, [m](double x, double y) {
    const double angle = 0.2 * x, r = 1 + 0.12 * angle + 0.3 * y / double(m);
    return Point(r * std::cos(angle), r * std::sin(angle), 0);
  });
}

Mesh stretched(Mesh mesh, double factor)
{
  for(Mesh::Vertex_index v : mesh.vertices()) {
    const Point p = mesh.point(v);
    mesh.point(v) = Point(factor * p.x(), p.y(), p.z());
  }
  return mesh;
}

// Adds a prism on a face, away from the origin. Its `rings` rings have the distances of `step`
// times the first side of the face. Each is `taper` times as thick as the previous one.
void add_limb(Mesh& mesh, Mesh::Face_index f, std::size_t rings, double step, double taper)
{
  std::vector<Mesh::Vertex_index> ring;
  std::array<Point, 3> corner;
  for(Mesh::Vertex_index v : mesh.vertices_around_face(mesh.halfedge(f))) {
    corner[ring.size()] = mesh.point(v);
    ring.push_back(v);
  }
  CGAL::Euler::remove_face(mesh.halfedge(f), mesh);
  const Point middle = CGAL::centroid(corner[0], corner[1], corner[2]);
  const auto out = middle - Point(0, 0, 0);
  const auto up =
    out * (step * std::sqrt(CGAL::squared_distance(corner[0], corner[1]) / out.squared_length()));
  for(std::size_t i = 1; i <= rings; ++i) {
    std::vector<Mesh::Vertex_index> next;
    for(const Point& p : corner)
      next.push_back(mesh.add_vertex(middle + std::pow(taper, i) * (p - middle) + double(i) * up));
    for(std::size_t k = 0; k < 3; ++k) {
      mesh.add_face(ring[k], ring[(k + 1) % 3], next[(k + 1) % 3]);
      mesh.add_face(ring[k], next[(k + 1) % 3], next[k]);
    }
    ring = next;
  }
  mesh.add_face(ring);
}

Mesh octahedron_with_limbs(std::size_t number, std::size_t rings, double step, double taper)
{
  Mesh mesh = octahedron();
  const std::vector<Mesh::Face_index> faces(mesh.faces().begin(), mesh.faces().end());
  for(std::size_t n = 0; n < number; ++n)
    add_limb(mesh, faces[2 * n], rings, step, taper);
  mesh.collect_garbage();
  return mesh;
}

// Whether faces that are not crowded have corners that are apart on the sphere.
void check_crowded_faces(const Spherical_conformal_map& map, const Mesh& mesh)
{
  const std::vector<Face_index>& crowded = map.crowded_faces();
  EXPECT_TRUE(std::is_sorted(crowded.begin(), crowded.end()));
  EXPECT_EQ(std::adjacent_find(crowded.begin(), crowded.end()), crowded.end());
  for(Mesh::Face_index f : mesh.faces()) {
    std::set<std::array<double, 3>> corners;
    for(Mesh::Vertex_index v : mesh.vertices_around_face(mesh.halfedge(f)))
      corners.insert(map.position(Vertex_index(v.idx())));
    if(!std::binary_search(crowded.begin(), crowded.end(), Face_index(f.idx()))) {
      EXPECT_EQ(corners.size(), 3u) << f;
    }
  }
}

// Checks a row of squares. Each is the image of the previous one under x -> q x, between the lines
// from the origin. Its cross ratio (q - 1)^2 / (4 q) is one, so q is 3 + 2 sqrt 2. The vertical
// edge at q^k has length one, and the chord 4 q^k / (1 + q^2k) on the sphere.
void check_strip(std::size_t n)
{
  const Mesh mesh = strip(n);
  const Spherical_conformal_map map = DCM::map_to_sphere(mesh);
  EXPECT_EQ(map.status(), DCM::Map_status::success) << map.cause();
  EXPECT_TRUE(map.certificate().is_convex());
  const double log_q = std::log(3 + 2 * std::sqrt(2.));
  for(Mesh::Vertex_index v : mesh.vertices()) {
    const double k = std::abs(mesh.point(v).x() - double(n) / 2),
                 log_cosh = k * log_q + std::log1p(std::exp(-2 * k * log_q)) - std::log(2.);
    EXPECT_NEAR(map.log_scale(Vertex_index(v.idx())), std::log(2.) - log_cosh, 1e-9 * (1 + k)) << v;
  }
  check_crowded_faces(map, mesh);
}

TEST(Crowding, short_strip)
{
  check_strip(8);
  EXPECT_TRUE(DCM::map_to_sphere(strip(8)).crowded_faces().empty());
}

TEST(Crowding, strip_beyond_the_digits_of_double)
{
  check_strip(60);
  EXPECT_FALSE(DCM::map_to_sphere(strip(60)).crowded_faces().empty());
}

TEST(Crowding, strip_beyond_the_range_of_double) { check_strip(1000); }

TEST(Crowding, stretched_spheres)
{
  for(const double factor : {100., 3000., 1e5}) {
    SCOPED_TRACE(factor);
    const Mesh mesh = stretched(unit_sphere(10), factor);
    const Spherical_conformal_map map = DCM::map_to_sphere(mesh);
    EXPECT_EQ(map.status(), DCM::Map_status::success) << map.cause();
    EXPECT_TRUE(map.certificate().is_convex());
    EXPECT_LE(map.max_curvature_error(), 1e-10);
    EXPECT_LE(DCM::max_cross_ratio_error(map), 1e-8);
    check_crowded_faces(map, mesh);
  }
}

// Rounding ends Newton's method with bounds far from the minimum. It also decides how much work the
// next searches need, so that one of the surfaces may exceed the limit.
TEST(Crowding, spheres_stretched_along_random_axes)
{
  std::size_t found = 0;
  for(unsigned int seed = 0; seed < 12; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    CGAL::Random random(seed);
    const Point axis = *CGAL::Random_points_on_sphere_3<Point>(1, random);
    Mesh mesh = unit_sphere(2);
    for(Mesh::Vertex_index v : mesh.vertices()) {
      const auto p = mesh.point(v) - CGAL::ORIGIN, a = axis - CGAL::ORIGIN;
      mesh.point(v) = CGAL::ORIGIN + (p + (1e5 - 1) * (p * a) * a);
    }
    const Spherical_conformal_map map = DCM::map_to_sphere(mesh);
    if(map.status() != DCM::Map_status::success)
      continue;
    ++found;
    EXPECT_TRUE(map.certificate().is_convex());
    EXPECT_LE(map.max_curvature_error(), 1e-10);
    EXPECT_LE(DCM::max_cross_ratio_error(map), 1e-8);
  }
  EXPECT_GE(found, 11u);
}

// Newton's method with bounds does not converge if it starts from equal scale factors.
TEST(Crowding, limbs)
{
  for(const auto& [number, rings, step, taper] :
      {std::tuple(1u, 60u, 1., 1.), std::tuple(4u, 60u, 3., 1.), std::tuple(4u, 40u, 1., 0.9),
       std::tuple(3u, 30u, 1., 0.6), std::tuple(2u, 20u, 3., 0.5)}) {
    SCOPED_TRACE(testing::Message() << number << " limbs of " << rings << " rings, " << taper);
    const Mesh mesh = octahedron_with_limbs(number, rings, step, taper);
    const Spherical_conformal_map map = DCM::map_to_sphere(mesh);
    EXPECT_EQ(map.status(), DCM::Map_status::success) << map.cause();
    EXPECT_TRUE(map.certificate().is_convex());
    EXPECT_LE(map.minimization().iterations, 100u);
    EXPECT_LE(map.max_curvature_error(), 1e-10);
    EXPECT_LE(DCM::max_cross_ratio_error(map), 1e-8);
    check_crowded_faces(map, mesh);
  }
}

// ---- Disks ----

// Whether a disk is a success with a bounded number of steps.
void check_disk(const Planar_conformal_map& map, const Mesh& mesh)
{
  ASSERT_EQ(map.status(), DCM::Map_status::success) << map.cause();
  EXPECT_LE(map.max_curvature_error(), 1e-10);
  EXPECT_LE(DCM::max_cross_ratio_error(map), 1e-8);
  EXPECT_LE(map.minimization().iterations, 200u);
  for(Mesh::Vertex_index v : mesh.vertices())
    EXPECT_TRUE(std::isfinite(map.log_scale(Vertex_index(v.idx())))) << v;
}

// Checks a disk whose boundary is the equator of the sphere above. Lengths are the lengths on the
// sphere, up to a factor.
void check_strip_in_disk(std::size_t n)
{
  const Mesh mesh = strip(n);
  const Planar_conformal_map map = DCM::flatten_to_disk(mesh);
  check_disk(map, mesh);
  const double log_q = std::log(3 + 2 * std::sqrt(2.));
  const auto difference = [&](Mesh::Vertex_index v) {
    const double k = std::abs(mesh.point(v).x() - double(n) / 2);
    return map.log_scale(Vertex_index(v.idx())) + k * log_q + std::log1p(std::exp(-2 * k * log_q));
  };
  for(Mesh::Vertex_index v : mesh.vertices())
    EXPECT_NEAR(difference(v), difference(*mesh.vertices().begin()), 1e-9 * double(n)) << v;
  EXPECT_FALSE(map.crowded_faces().empty());
}

TEST(Crowding, strips_in_disks)
{
  for(const std::size_t n : traced({60u, 300u, 1000u}))
    check_strip_in_disk(n);
}

// Returns the cells of a comb: `teeth` corridors of this length, at the distance of a cell.
std::set<Cell> comb(int teeth, int length)
{
  std::set<Cell> result;
  for(int i = 0; i < 2 * teeth - 1; ++i)
    for(int j = 0; j < (i % 2 == 0 ? length : 1); ++j)
      result.insert({i, j});
  return result;
}

// Returns the cells of a corridor that turns at random, and never meets itself.
std::set<Cell> staircase(std::size_t n, unsigned int seed)
{
  CGAL::Random random(seed);
  std::set<Cell> result{{0, 0}};
  for(Cell cell{0, 0}; result.size() < n; result.insert(cell))
    ++(random.get_bool() ? cell.first : cell.second);
  return result;
}

TEST(Crowding, combs_and_staircases_in_disks)
{
  for(const unsigned int seed : traced({1u, 2u, 3u}))
    for(const std::set<Cell>& cells :
        {comb(int(2 * seed), 50 - int(10 * seed)), staircase(100 * seed, seed)}) {
      const Mesh mesh = Planar_cells(cells, 1, seed).mesh;
      const Planar_conformal_map map = DCM::flatten_to_disk(mesh);
      check_disk(map, mesh);
      EXPECT_FALSE(map.crowded_faces().empty());
    }
}

TEST(Crowding, saw_teeth_in_disks)
{
  for(const unsigned int seed : traced({1u, 2u, 3u})) {
    CGAL::Random random(seed);
    const double width = std::pow(10, random.get_double(-2, 0)), high = random.get_double(0.1, 2);
    const Mesh mesh = grid(100 * seed, 1, [&](double x, double y) {
      return Point(width * x, y * (0.3 + high * double(int(x) % 2)), 0);
    });
    check_disk(DCM::flatten_to_disk(mesh), mesh);
  }
}

// The disk has vertices inside, and its double has many ties.
TEST(Crowding, spiral_on_the_hemisphere)
{
  const Spherical_conformal_map map = DCM::map_to_sphere(spiral(200, 3));
  EXPECT_EQ(map.status(), DCM::Map_status::success) << map.cause();
  EXPECT_TRUE(map.certificate().is_convex());
  EXPECT_FALSE(map.crowded_faces().empty());
}

// Curvatures are curvatures of a flat polygon even if faces have the size 1e-80.
TEST(Crowding, spiral_in_a_disk)
{
  const Mesh mesh = spiral(150, 3);
  const Planar_conformal_map map = DCM::flatten_to_disk(mesh);
  ASSERT_EQ(map.status(), DCM::Map_status::success) << map.cause();
  EXPECT_FALSE(map.crowded_faces().empty());
  EXPECT_LE(DCM::max_cross_ratio_error(map), 1e-8);
  const Delta_complex& C = mesh_C(map);
  const std::vector<double> angle = angle_sums(C, scaled_lengths(map));
  double turns = 0;
  for(Mesh::Vertex_index v : mesh.vertices())
    if(!mesh.is_border(v)) {
      EXPECT_NEAR(angle[v.idx()], 2 * pi, 1e-8) << v;
    } else
      turns += pi - angle[v.idx()] / 2;
  EXPECT_NEAR(turns, 2 * pi, 1e-8);
}

// A map that was computed with lengths of the exact surface needs them for its layout.
TEST(Crowding, exact_promises_keep_lengths_of_the_exact_surface)
{
  const Mesh mesh = strip(5);
  const double angle = 2 * pi / double(mesh.number_of_vertices());
  for(bool is_precise : {false, true}) {
    DCM::internal::Doubled_problem problem(
      IT::Intrinsic_triangulation<>(mesh),
      std::vector<DCM::Vertex_condition>(mesh.number_of_vertices(),
                                         DCM::Vertex_condition::curvature(angle)),
      DCM::Flipping::to_Delaunay, DCM::internal::Exactness::errors);
    if(is_precise) {
      ASSERT_TRUE(problem.make_precise());
    }
    const auto promises =
      DCM::internal::exact_promises(problem, [] { return DCM::internal::Scale_errors(); });
    EXPECT_EQ(promises.size(), 2u);
    EXPECT_EQ(problem.has_precise_lengths(), is_precise);
  }
}

// Faces that are not crowded are accurate in a rectangle.
TEST(Crowding, spiral_in_a_rectangle)
{
  const Mesh mesh = spiral(150, 3);
  const Planar_conformal_map map = DCM::flatten_to_rectangle(mesh, DCM::rectangle_corners(mesh));
  EXPECT_EQ(map.status(), DCM::Map_status::success);
  EXPECT_TRUE(map.crowded_faces().empty());
  check_layout(map);
}

double range_of_log_scales(const Mesh& mesh, const Planar_conformal_map& map)
{
  double least = map.log_scale(Mesh::Vertex_index(0)), greatest = least;
  for(Mesh::Vertex_index v : mesh.vertices()) {
    least = (std::min)(least, map.log_scale(v));
    greatest = (std::max)(greatest, map.log_scale(v));
  }
  return greatest - least;
}

// Squares around a tube become rings of trapezoids with a common center. Their sides have the
// scaled lengths if radii shrink by q = 1 - sqrt(q) from ring to ring, whatever the width of the
// squares. Before it is scaled to the area of the tube, the area of the disk is beyond the range of
// `double`.
TEST(Crowding, closed_tubes_in_disks)
{
  const double shrinking = std::log((3 - std::sqrt(5.)) / 2);
  std::vector<double> range;
  for(std::size_t rings : {400u, 700u}) {
    Mesh mesh = tube(rings, 7, 1, 0, Tube_ends::capped);
    CGAL::Euler::remove_face(mesh.halfedge(*mesh.faces().begin()), mesh);
    const Planar_conformal_map map = DCM::flatten_to_disk(mesh);
    ASSERT_EQ(map.status(), DCM::Map_status::success) << rings << ' ' << map.cause();
    EXPECT_LE(DCM::max_cross_ratio_error(map), 1e-8) << rings;
    range.push_back(range_of_log_scales(mesh, map));
  }
  EXPECT_NEAR(range[0] - range[1], 300 * shrinking, 1e-8);
}

// Faces far from the center of a hyperbolic layout have no area in the Klein disk with coordinates
// of type `double`. Only such faces may be reversed.
TEST(Crowding, long_surfaces_in_the_Klein_disk)
{
  std::size_t crowded = 0;
  for(std::size_t genus : {2u, 12u, 24u, 36u}) {
    const Mesh mesh = perturbed(frame(genus, 0.2), 0.05, 1);
    const auto map = DCM::uniformize_hyperbolic(mesh);
    ASSERT_EQ(map.status(), DCM::Map_status::success) << genus << ' ' << map.cause();
    const std::vector<Face_index>& faces = map.crowded_faces();
    crowded += faces.size();
    EXPECT_EQ(faces.empty(), map.radius() < 17) << genus << ' ' << map.radius();
    const DCM::Input_part part(map);
    const DCM::Texture_corners corners(map, part);
    for(Face_index f : DCM::homogeneous_texture_points(map, part, corners).reversed_faces)
      EXPECT_TRUE(
        std::binary_search(faces.begin(), faces.end(), part.subdivision().parent_face(Layer::A, f)))
        << genus << ' ' << f;
  }
  EXPECT_GT(crowded, 0u);
}

// A flat rectangle, whose corners have right angles, is its own image. Searches from any scale
// factors end where all are equal. Angles of very low faces jump on the way.
void lead_back_to_a_flat_rectangle(double height)
{
  typedef DCM::internal::Wide_number<DCM::internal::Double_double> FT;
  const std::size_t n = 12, m = 3;
  const Mesh mesh = grid(n, m, [height](double x, double y) { return Point(x, height * y, 0); });
  std::vector<DCM::Vertex_condition> conditions(mesh.number_of_vertices());
  for(Mesh::Vertex_index v : mesh.vertices()) {
    const Point p = mesh.point(v);
    if((p.x() == 0 || p.x() == double(n)) && (p.y() == 0 || p.y() == height * double(m)))
      conditions[v.idx()] = DCM::Vertex_condition::curvature(pi / 2);
  }
  DCM::internal::Doubled_problem problem(
    CGAL::Intrinsic_triangulations::Intrinsic_triangulation<>(mesh), conditions,
    DCM::Flipping::to_Delaunay);
  problem.complete();
  auto energy = DCM::internal::symmetric_energy<FT, DCM::internal::Flat_triangle<FT>>(
    problem, problem.triangulation());
  CGAL::Random random(1);
  std::vector<FT> start;
  for(std::size_t v = 0; v < problem.size(); ++v)
    start.push_back(FT(random.get_double(-8, 8)));
  energy.set_origin(start);
  energy.evaluate(Eigen::VectorXd::Zero(Eigen::Index(problem.size())));
  DCM::Default_flattening_visitor silent;
  const auto run = [&](double work) {
    energy.limit_work(work);
    return DCM::internal::Difference_bounded_newton<decltype(energy)>(energy, problem.domain(true))
      .run(1e-13, 300, silent);
  };
  // Every search may measure each face some times.
  while(!energy.has_worked_enough()) {
    problem.work().add<FT>(1000);
    energy.limit_work(0);
  }
  EXPECT_EQ(run(0).status, DCM::Minimization_status::iteration_limit);
  EXPECT_EQ(run(1e6).status, DCM::Minimization_status::converged);
  const std::vector<FT> u = energy.scale_factors();
  for(const FT& x : u)
    EXPECT_NEAR(static_cast<double>(FT(x - u.front())), 0, 1e-9);
}

TEST(Bounded_differences, lead_back_to_a_flat_rectangle) { lead_back_to_a_flat_rectangle(1); }

TEST(Bounded_differences, lead_back_past_jumps_of_angles) { lead_back_to_a_flat_rectangle(1e-5); }

// Searches in more digits leave less work for others, and none can do more than the rest.
TEST(Search_work, has_one_limit_for_all_searches)
{
  typedef DCM::internal::Double_double Double_double;
  typedef DCM::internal::Decimal_115 Decimal_115;
  DCM::internal::Search_work work;
  const double whole = work.left(), end = work.end_of_part();
  const std::size_t face = 1000;
  EXPECT_GT(end, 0);
  EXPECT_LT(end, whole);
  work.add<double>(face);
  const double rounded = whole - work.left();
  work.add<Double_double>(face);
  EXPECT_LT(rounded, double(face));
  EXPECT_EQ(work.left(), whole - rounded - double(face));
  work.add<Decimal_115>(face);
  EXPECT_LT(work.left() + 6 * double(face), whole - rounded - double(face));
  EXPECT_GT(work.end_of_part(), end);
  work.add<Double_double>(std::size_t(end));
  EXPECT_EQ(work.left(end), 0);
  EXPECT_GT(work.left(), 0);
  work.add<Double_double>(std::size_t(whole));
  EXPECT_EQ(work.left(), 0);
}

} // namespace Test_crowding
