// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Texture coordinates are rounded such that no triangle is reversed.

#include "../Intrinsic_triangulations/hard_meshes.h"
#include "flat_maps.h"

#include <CGAL/Discrete_conformal_maps/common_subdivision_mesh.h>
#include <CGAL/Discrete_conformal_maps/flatten_to_disk.h>
#include <CGAL/Discrete_conformal_maps/flatten_to_rectangle.h>
#include <CGAL/Discrete_conformal_maps/internal/layout/Orientation_repair.h>
#include <CGAL/Discrete_conformal_maps/map_to_sphere.h>

#include <CGAL/Exact_rational.h>

namespace Test_texture_points {

using namespace Test_surfaces;
using DCM::internal::Number_lists;
typedef CGAL::Exact_rational Exact;
typedef std::array<double, 2> Point_2;
typedef std::array<double, 3> Point_3;

// ---- Exact orientations ----

Exact exact_determinant(const Point_2& p, const Point_2& q, const Point_2& r)
{
  return (Exact(q[0]) - p[0]) * (Exact(r[1]) - p[1]) - (Exact(q[1]) - p[1]) * (Exact(r[0]) - p[0]);
}

Exact exact_determinant(const Point_3& p, const Point_3& q, const Point_3& r)
{
  const auto minor = [&](std::size_t i, std::size_t j) -> Exact {
    return Exact(q[i]) * r[j] - Exact(q[j]) * r[i];
  };
  return p[0] * minor(1, 2) + p[1] * minor(2, 0) + p[2] * minor(0, 1);
}

// Returns the polygons that have three corners, in order, that turn right.
template <typename Point>
std::vector<std::size_t> reversed(const std::vector<Point>& points, const Number_lists& polygons)
{
  std::vector<std::size_t> result;
  for(std::size_t i = 0; i < polygons.size(); ++i) {
    bool is_reversed = false;
    for(std::size_t a = 0; a < polygons.size(i); ++a)
      for(std::size_t b = 0; b < a; ++b)
        for(std::size_t c = 0; c < b; ++c)
          is_reversed =
            is_reversed || exact_determinant(points[polygons(i, c)], points[polygons(i, b)],
                                             points[polygons(i, a)]) < 0;
    if(is_reversed)
      result.push_back(i);
  }
  return result;
}

double unit(const Point_2& p)
{
  return std::ldexp(1., std::ilogb((std::max)(std::abs(p[0]), std::abs(p[1]))) - 52);
}

// ---- Drawings ----

// Stores triangles of points with exact coordinates, all of which turn left.
struct Drawing
{
  std::vector<std::array<Exact, 2>> points;
  Triangles triangles;
};

// Returns a triangulated polygon with vertices whose distances from the corners or sides of a face
// are 10^-1 to 10^-20. Faces may get several, which are then nested.
Drawing needles(int seed, bool are_nested)
{
  Portable_random random(std::uint64_t(seed) + 1);
  Drawing result;
  const std::vector<Vector> corners = random_points(12, 1000, static_cast<unsigned int>(seed) + 1);
  for(const Vector& p : corners)
    result.points.push_back({Exact(3 * p.x + p.y) / 7, Exact(5 * p.y - p.x + 2000) / 11});
  result.triangles = swept_triangles(corners);
  const std::size_t number_of_faces = result.triangles.size();
  for(std::size_t n = 0; n < (are_nested ? 60 : number_of_faces); ++n) {
    const auto face = are_nested ? std::size_t(random.get_int(0, int(result.triangles.size()))) : n;
    const auto [a, b, c] = result.triangles[face];
    std::array<Exact, 3> weight;
    for(Exact& w : weight)
      w = std::pow(10, -random.get_double(0, random.get_int(0, 2) == 0 ? 1 : 20));
    const Exact sum = weight[0] + weight[1] + weight[2];
    std::array<Exact, 2> p;
    for(std::size_t i = 0; i < 2; ++i)
      p[i] = (weight[0] * result.points[a][i] + weight[1] * result.points[b][i] +
              weight[2] * result.points[c][i]) /
             sum;
    const std::size_t v = result.points.size();
    result.points.push_back(p);
    result.triangles[face] = {a, b, v};
    result.triangles.push_back({b, c, v});
    result.triangles.push_back({c, a, v});
  }
  return result;
}

Number_lists corners(const Drawing& drawing)
{
  Number_lists result;
  for(const auto& [a, b, c] : drawing.triangles) {
    for(const std::size_t v : {a, b, c})
      result.add(v);
    result.close();
  }
  return result;
}

// Returns the points with errors of up to `noise` units.
std::vector<Point_2> rounded(const Drawing& drawing, int noise, Portable_random& random)
{
  std::vector<Point_2> result;
  for(const auto& p : drawing.points) {
    const Point_2 nearest{CGAL::to_double(p[0]), CGAL::to_double(p[1])};
    const auto error = [&] { return random.get_int(-noise, noise + 1) * unit(nearest); };
    result.push_back({nearest[0] + error(), nearest[1] + error()});
  }
  return result;
}

std::array<double, 4> bounding_box(const std::vector<Point_2>& points)
{
  std::array<double, 4> result{points[0][0], points[0][0], points[0][1], points[0][1]};
  for(const Point_2& p : points)
    for(std::size_t i = 0; i < 2; ++i) {
      result[2 * i] = (std::min)(result[2 * i], p[i]);
      result[2 * i + 1] = (std::max)(result[2 * i + 1], p[i]);
    }
  return result;
}

// Returns how many polygons were reversed, and how many are.
std::array<std::size_t, 2> expect_repaired(const Drawing& drawing, int seed)
{
  Portable_random random{std::uint64_t(seed)};
  const Number_lists polygons = corners(drawing);
  const std::vector<Point_2> start = rounded(drawing, 1, random);
  std::vector<Point_2> points = start;
  DCM::internal::Orientation_repair<2> repair(points, polygons);
  const std::vector<std::size_t> left = repair.run();
  EXPECT_EQ(left, reversed(points, polygons)) << seed;
  EXPECT_EQ(bounding_box(points), bounding_box(start)) << seed;
  for(std::size_t i = 0; i < points.size(); ++i)
    for(std::size_t c = 0; c < 2; ++c)
      EXPECT_LE(std::abs(points[i][c] - start[i][c]), repair.maximum_move * unit(start[i]));
  const std::size_t before = reversed(start, polygons).size();
  if(before == 0) {
    EXPECT_EQ(points, start);
  }
  return {before, left.size()};
}

TEST(Orientation_repair, mends_rounded_needles)
{
  std::size_t before = 0, after = 0;
  for(int seed = 0; seed < 60; ++seed) {
    const auto [b, a] = expect_repaired(needles(seed, false), seed);
    before += b;
    after += a;
  }
  EXPECT_GT(before, 100u);
  EXPECT_EQ(after, 0u);
}

// For needles inside needles, possibly no move improves all.
TEST(Orientation_repair, mends_most_nested_needles)
{
  std::size_t before = 0, after = 0;
  for(int seed = 0; seed < 30; ++seed) {
    const auto [b, a] = expect_repaired(needles(seed, true), seed);
    before += b;
    after += a;
  }
  EXPECT_GT(before, 300u);
  EXPECT_LT(3 * after, before);
}

TEST(Orientation_repair, mends_vectors_around_the_origin)
{
  std::size_t before = 0;
  for(int seed = 0; seed < 30; ++seed) {
    Portable_random random{std::uint64_t(seed)};
    const Drawing drawing = needles(seed, false);
    const Number_lists polygons = corners(drawing);
    std::vector<Point_3> points;
    for(const Point_2& p : rounded(drawing, 1, random)) {
      const double w = random.get_double(0.5, 2);
      points.push_back({p[0] * w, p[1] * w, w});
    }
    before += reversed(points, polygons).size();
    DCM::internal::Orientation_repair<3> repair(points, polygons);
    EXPECT_TRUE(repair.run().empty()) << seed;
    EXPECT_TRUE(reversed(points, polygons).empty()) << seed;
  }
  EXPECT_GT(before, 40u);
}

// Polygons that cannot be repaired are unchanged, and are found.
TEST(Orientation_repair, returns_what_remains)
{
  const std::vector<Point_2> start{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  std::vector<Point_2> points = start;
  Number_lists polygons;
  for(const std::size_t v : {0, 1, 2, 0, 3, 2}) {
    polygons.add(v);
    if(v == 2)
      polygons.close();
  }
  EXPECT_EQ(DCM::internal::Orientation_repair<2>(points, polygons).run(),
            std::vector<std::size_t>{1});
  EXPECT_EQ(points, start);
}

// ---- Maps ----

template <typename Index>
Number_lists corners(const DCM::Input_part& part, const Index& index)
{
  Number_lists result;
  for(Face_index f : part.faces()) {
    for(Halfedge_index h : CGAL::halfedges_around_face(part.mesh().halfedge(f), part.mesh()))
      result.add(index(h));
    result.close();
  }
  return result;
}

// Returns meshes whose maps have triangles that rounding can reverse.
std::vector<Mesh> spoilt_meshes()
{
  std::vector<Mesh> result;
  for(unsigned int seed = 0; seed < 5; ++seed) {
    Portable_random random(seed);
    result.push_back(grid(
      8, 8, [&](double x, double y) { return Point(x / 8, y / 8, random.get_double(0, 0.4)); }));
    Mesh mesh = grid(6, 6, [](double x, double y) { return Point(x, y, std::sin(x + y * y)); });
    add_extreme_needles(mesh, 0.05, random);
    add_near_vertices(mesh, 0.1, random);
    result.push_back(mesh);
  }
  return result;
}

// Returns how many faces were reversed before.
std::size_t expect_no_reversed_faces(const Planar_conformal_map& map, const std::string& name)
{
  const DCM::Input_part part(map);
  const DCM::Texture_corners texture(map, part);
  const Number_lists polygons = corners(part, [&](Halfedge_index h) { return texture.index(h); });
  std::vector<Point_2> plain;
  for(std::size_t n = 0; n < texture.size(); ++n) {
    const std::complex<double> z = map.image(texture.halfedge(n));
    plain.push_back({z.real(), z.imag()});
  }
  const auto rounded = DCM::texture_points(map, part, texture);
  const auto numbers = [&](const std::vector<Face_index>& faces) {
    std::vector<std::size_t> result;
    for(Face_index f : faces)
      result.push_back(
        std::size_t(std::find(part.faces().begin(), part.faces().end(), f) - part.faces().begin()));
    return result;
  };
  EXPECT_EQ(reversed(rounded.points, polygons), numbers(rounded.reversed_faces)) << name;
  const std::size_t before = reversed(plain, polygons).size();
  if(before == 0) {
    EXPECT_EQ(rounded.points, plain) << name;
  }
  const auto homogeneous = DCM::homogeneous_texture_points(map, part, texture);
  EXPECT_EQ(reversed(homogeneous.points, polygons), numbers(homogeneous.reversed_faces)) << name;
  if(map.status() == DCM::Map_status::success) {
    EXPECT_TRUE(rounded.reversed_faces.empty()) << name;
    EXPECT_TRUE(homogeneous.reversed_faces.empty()) << name;
  }
  return before;
}

TEST(Texture_points, reverse_no_face_of_a_map)
{
  std::size_t before = 0, n = 0;
  for(const Mesh& mesh : spoilt_meshes()) {
    const std::string name = "mesh " + std::to_string(n++);
    for(const Planar_conformal_map& map :
        {DCM::flatten(mesh), DCM::flatten_to_disk(mesh),
         DCM::flatten_to_rectangle(mesh, DCM::rectangle_corners(mesh))})
      if(map.is_laid_out())
        before += expect_no_reversed_faces(map, name);
  }
  EXPECT_GT(before, 5u);
}

TEST(Texture_points, reverse_no_face_of_an_ordinary_map)
{
  for(const Named_mesh& m : meshes()) {
    const Planar_conformal_map map = DCM::flatten(m.mesh);
    EXPECT_EQ(map.status(), DCM::Map_status::success) << m.name;
    expect_no_reversed_faces(map, m.name);
  }
}

// The mesh of the common subdivision has them at its corners.
TEST(Texture_points, are_texture_coordinates_of_the_subdivision)
{
  for(const Mesh& mesh : spoilt_meshes()) {
    const Planar_conformal_map map = DCM::flatten(mesh);
    if(map.status() != DCM::Map_status::success)
      continue;
    Mesh flat;
    const auto uv = flat.add_property_map<Halfedge_index, Point_2>("h:uv").first;
    DCM::common_subdivision(
      map, flat, DCM::parameters::input_point_map(mesh.points()).texture_coordinates_map(uv));
    std::vector<Point_2> points(flat.number_of_halfedges());
    Number_lists polygons;
    for(Face_index f : flat.faces()) {
      for(Halfedge_index h : halfedges_around_face(flat.halfedge(f), flat)) {
        points[h] = uv[h];
        polygons.add(h);
      }
      polygons.close();
    }
    EXPECT_TRUE(reversed(points, polygons).empty());
  }
}

TEST(Texture_points, reverse_no_face_on_the_sphere)
{
  for(unsigned int seed = 0; seed < 5; ++seed) {
    Portable_random random(seed);
    Mesh mesh = random_sphere(60, seed + 1);
    for(Point& p : mesh.points())
      p = Point(p.x() * std::pow(10, seed / 2.), p.y(), p.z());
    add_near_vertices(mesh, 0.05, random);
    const auto map = DCM::map_to_sphere(mesh);
    if(!map.is_laid_out() || map.is_flat())
      continue;
    const DCM::Input_part part(map);
    const Number_lists polygons =
      corners(part, [&](Halfedge_index h) { return part.number(part.mesh().target(h)); });
    const auto rounded = DCM::sphere_points(map, part, DCM::homogeneous_coordinates(map, part));
    EXPECT_TRUE(rounded.reversed_faces.empty()) << seed;
    EXPECT_TRUE(reversed(rounded.points, polygons).empty()) << seed;
    for(const Point_3& p : rounded.points)
      EXPECT_NEAR(std::hypot(p[0], p[1], p[2]), 1, 1e-14) << seed;
  }
}

} // namespace Test_texture_points
