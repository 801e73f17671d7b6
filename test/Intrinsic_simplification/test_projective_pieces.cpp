// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// These tests check the pieces on which the map between two levels is projective.

#include "../Intrinsic_triangulations/data_meshes.h"
#include "simplified_surfaces.h"

#include <CGAL/Intrinsic_simplification/Surface_subdivision.h>
#include <CGAL/Intrinsic_simplification/projective_pieces.h>

namespace Test_projective_pieces {

using namespace Test_surfaces;
using IS::Level;
using IS::Projective_piece;
using Pieces = std::vector<Projective_piece>;
using Corner = Projective_piece::Corner;

Pieces all_pieces(const Surface_map& map)
{
  Pieces result;
  IS::projective_pieces(map, std::back_inserter(result));
  return result;
}

const Coordinates& on(Level side, const Corner& c)
{
  return side == Level::fine ? c.fine : c.coarse;
}

// Returns the area of a triangle, relative to the face.
double area(const Coordinates& a, const Coordinates& b, const Coordinates& c)
{
  return (b[1] - a[1]) * (c[2] - a[2]) - (b[2] - a[2]) * (c[1] - a[1]);
}

double area(Level side, const Projective_piece& p)
{
  double sum = 0;
  for(std::size_t n = 1; n + 1 < p.corners.size(); ++n)
    sum += area(on(side, p.corners[0]), on(side, p.corners[n]), on(side, p.corners[n + 1]));
  return sum;
}

// Checks that a piece turns left at every corner, and its area is positive, on both sides. If an
// edge passes a vertex, areas are as small as rounding errors, which are greater for coordinates in
// thin faces.
void expect_convex(const Projective_piece& p, double rounding = 1e-15)
{
  const std::size_t size = p.corners.size();
  ASSERT_GE(size, 3u);
  for(const Level side : {Level::fine, Level::coarse}) {
    EXPECT_GT(area(side, p), -rounding);
    for(std::size_t n = 0; n < size; ++n)
      EXPECT_GT(area(on(side, p.corners[n]), on(side, p.corners[(n + 1) % size]),
                     on(side, p.corners[(n + 2) % size])),
                -rounding);
  }
}

// Checks that the areas of the pieces add up to the area of each face of both levels.
void expect_tiling(const Pieces& pieces, const Surface_map& map)
{
  std::vector<double> fine(map.fine().mesh().number_of_faces(), 0);
  std::vector<double> coarse(map.coarse().mesh().number_of_faces(), 0);
  for(const Projective_piece& p : pieces) {
    fine[p.fine_face] += area(Level::fine, p);
    coarse[p.coarse_face] += area(Level::coarse, p);
  }
  for(double sum : fine)
    EXPECT_NEAR(sum, 1, 1e-11);
  for(double sum : coarse)
    EXPECT_NEAR(sum, 1, 1e-11);
}

// Checks the distance of two points of a face, relative to its longest side.
void expect_near(const Coordinates& x, const Coordinates& y, const Surface_level& level,
                 Face_index f, double tolerance)
{
  std::array<double, 3> length{};
  const auto sides = IT::sides(f, level.mesh());
  for(std::size_t s = 0; s < 3; ++s)
    length[s] = level.length_map()[level.mesh().edge(sides[s])];
  EXPECT_LE(IT::vector_length(length, {x[0] - y[0], x[1] - y[1], x[2] - y[2]}),
            tolerance * *std::max_element(length.begin(), length.end()));
}

// Whether a point is in a piece, and not at its boundary.
bool is_inside(const Coordinates& b, const Projective_piece& p)
{
  const std::size_t size = p.corners.size();
  for(std::size_t n = 0; n < size; ++n)
    if(area(p.corners[n].fine, p.corners[(n + 1) % size].fine, b) < 1e-9)
      return false;
  return true;
}

// Checks that points mapped through all operations agree with the piece. Returns how many points
// were inside of a piece.
std::size_t expect_mapped(const Pieces& pieces, const Surface_map& map, double tolerance)
{
  std::size_t found = 0;
  CGAL::Random random(5);
  for(const Projective_piece& p : pieces) {
    for(const Corner& c : p.corners) {
      expect_near(p.to_coarse(c.fine), c.coarse, map.coarse(), p.coarse_face, tolerance);
      expect_same_place({p.coarse_face, c.coarse}, map.to_coarse({p.fine_face, c.fine}),
                        map.coarse().mesh());
    }
    for(int n = 0; n < 10; ++n) {
      const Coordinates b = random_coordinates(random);
      if(!is_inside(b, p))
        continue;
      ++found;
      const auto [f, expected] = map.to_coarse({p.fine_face, b});
      EXPECT_EQ(f, p.coarse_face);
      expect_near(p.to_coarse(b), expected, map.coarse(), p.coarse_face, tolerance);
      expect_near(p.to_fine(expected), b, map.fine(), p.fine_face, 1e-9);
    }
  }
  return found;
}

TEST(Projective_pieces, of_all_surfaces)
{
  std::size_t found = 0;
  for_each_simplified_surface([&](const Simplified&, const Surface_map& map) {
    const Pieces pieces = all_pieces(map);
    for(const Projective_piece& p : pieces)
      expect_convex(p);
    expect_tiling(pieces, map);
    found += expect_mapped(pieces, map, 1e-12);
  });
  EXPECT_GT(found, 1000u);
}

TEST(Projective_pieces, of_one_face)
{
  const Simplified s(Evolving_surface(random_sphere(60, 3)), 10);
  const Surface_map map(s.surface, s.fine, s.coarse);
  Pieces one_by_one;
  for(Face_index f : s.fine.mesh().faces())
    IS::projective_pieces(f, map, std::back_inserter(one_by_one));
  const Pieces at_once = all_pieces(map);
  ASSERT_EQ(one_by_one.size(), at_once.size());
  for(std::size_t n = 0; n < at_once.size(); ++n) {
    EXPECT_EQ(one_by_one[n].fine_face, at_once[n].fine_face);
    EXPECT_EQ(one_by_one[n].matrix, at_once[n].matrix);
  }
}

// A level is mapped to itself: the pieces are the faces, mapped by the identity.
TEST(Projective_pieces, of_one_level)
{
  const Evolving_surface surface(embedded_torus(5, 4));
  const Surface_level level(surface), same(surface);
  const Pieces pieces = all_pieces(Surface_map(surface, level, same));
  ASSERT_EQ(pieces.size(), 40u);
  for(const Projective_piece& p : pieces) {
    EXPECT_EQ(p.fine_face, p.coarse_face);
    EXPECT_EQ(p.matrix, (std::array<Coordinates, 3>{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}));
  }
}

// Projective maps are determined by the corners and the circumcircle, where the sum of l_ij^2 b_i
// b_j is zero. Squared lengths at the tip become a third, so its coordinate is multiplied by three.
TEST(Projective_pieces, of_a_tip)
{
  const Simplified s = without_tip();
  const Pieces pieces = all_pieces(Surface_map(s.surface, s.fine, s.coarse));
  ASSERT_EQ(pieces.size(), 4u);
  for(const Projective_piece& p : pieces) {
    EXPECT_EQ(p.corners.size(), 3u);
    bool has_tip = false;
    for(Halfedge_index h : IT::sides(p.fine_face, s.fine.mesh()))
      has_tip = has_tip || s.fine.mesh().source(h) == Vertex_index(0);
    Coordinates image = p.to_coarse({1 / 3., 1 / 3., 1 / 3.});
    std::sort(image.begin(), image.end());
    for(std::size_t c = 0; c < 3; ++c)
      EXPECT_NEAR(image[c], !has_tip ? 1 / 3. : c == 0 ? 1 / 5. : 2 / 5., 1e-14);
  }
}

// ---- Against the common subdivision ----

typedef std::pair<std::pair<Face_index, Face_index>, double> Part;

// Returns the parts sorted by parents and area, without parts that only rounding creates.
std::vector<Part> parts(std::vector<Part> all)
{
  all.erase(std::remove_if(all.begin(), all.end(), [](const Part& p) { return p.second < 1e-12; }),
            all.end());
  std::sort(all.begin(), all.end());
  return all;
}

std::vector<Part> parts(const Pieces& pieces)
{
  std::vector<Part> result;
  for(const Projective_piece& p : pieces)
    result.push_back({{p.fine_face, p.coarse_face}, area(Level::fine, p)});
  return parts(result);
}

std::vector<Part> parts(const IS::Surface_subdivision<>& subdivision)
{
  std::vector<Part> result;
  for(Face_index f : subdivision.mesh().faces()) {
    const Halfedge_index h = subdivision.mesh().halfedge(f);
    double sum = 0;
    for(Halfedge_index g = subdivision.mesh().next(h); g != h; g = subdivision.mesh().next(g))
      sum += area(subdivision.coordinates(Level::fine, h), subdivision.coordinates(Level::fine, g),
                  subdivision.coordinates(Level::fine, subdivision.mesh().next(g)));
    result.push_back(
      {{subdivision.parent_face(Level::fine, f), subdivision.parent_face(Level::coarse, f)}, sum});
  }
  return parts(result);
}

void expect_pieces_of_subdivision(const Surface_map& map)
{
  const std::vector<Part> found = parts(all_pieces(map));
  const std::vector<Part> expected = parts(IS::Surface_subdivision<>(map));
  ASSERT_EQ(found.size(), expected.size());
  for(std::size_t n = 0; n < found.size(); ++n) {
    EXPECT_EQ(found[n].first, expected[n].first);
    EXPECT_NEAR(found[n].second, expected[n].second, 1e-9);
  }
}

bool is_isometric(const Evolving_surface& s)
{
  bool result = true;
  for(std::size_t t = 0; t < s.history().size(); ++t)
    s.history()[t].visit([&](const auto& operation) {
      if constexpr(std::is_same_v<decltype(operation), const IS::Scaling&>)
        result = result && operation.number_of_corners == 0;
    });
  return result;
}

// Checks that barycentric coordinates are mapped linearly without scaling.
void expect_linear(const Pieces& pieces)
{
  for(const Projective_piece& p : pieces)
    for(std::size_t c = 0; c < 3; ++c)
      EXPECT_NEAR(p.matrix[0][c] + p.matrix[1][c] + p.matrix[2][c], 1, 1e-9);
}

TEST(Projective_pieces, after_flips_are_the_common_subdivision)
{
  for(const auto& [c, seed] : traced(complexes(), 5)) {
    Evolving_surface surface = evolving(c.mesh, seed);
    const Surface_level fine(surface);
    surface.make_Delaunay();
    const Surface_level coarse(surface);
    const Surface_map map(surface, fine, coarse);
    expect_pieces_of_subdivision(map);
    expect_linear(all_pieces(map));
  }
}

// Some vertices are flat up to rounding, which causes changes of scale.
TEST(Projective_pieces, of_flat_polygons_are_the_common_subdivision)
{
  int isometric = 0;
  for(unsigned int seed : seeds(20)) {
    const Simplified s = simplified_inside(flat_mesh(seed));
    if(!is_isometric(s.surface))
      continue;
    ++isometric;
    const Surface_map map(s.surface, s.fine, s.coarse);
    expect_pieces_of_subdivision(map);
    expect_linear(all_pieces(map));
  }
  EXPECT_GT(isometric, 5);
}

// Edges coincide, and run through vertices.
TEST(Projective_pieces, of_a_cube_are_the_common_subdivision)
{
  for(const unsigned int n : {100u, 30u, 8u}) {
    const Simplified s = simplified_by_curvature(Evolving_surface(subdivided(cube(), 3)), n);
    expect_pieces_of_subdivision(Surface_map(s.surface, s.fine, s.coarse));
  }
}

// The scale is changed first, while all edges are edges of the fine level.
TEST(Projective_pieces, after_one_removal_are_the_common_subdivision)
{
  std::size_t operations = 0;
  for(unsigned int seed = 0; seed < 10; ++seed) {
    Evolving_surface surface(random_sphere(30, seed));
    surface.make_Delaunay();
    const Surface_level fine(surface);
    simplify(surface, number_of_vertices(std::size_t(29)));
    const Surface_level coarse(surface);
    const Surface_map map(surface, fine, coarse);
    expect_pieces_of_subdivision(map);
    operations += surface.history().size();
  }
  EXPECT_GT(operations, 20u); // there are flips too
}

// ---- How many ----

// Returns the distance of two maps, at points of the first piece.
double distance(const Projective_piece& p, const Projective_piece& q)
{
  double result = 0;
  for(const Corner& c : p.corners) {
    const Coordinates x = q.to_coarse(c.fine);
    for(std::size_t r = 0; r < 3; ++r)
      result = (std::max)(result, std::abs(x[r] - c.coarse[r]));
  }
  return result;
}

// No two pieces could be one: on surfaces in general position, different pieces have different
// maps. Each polygon of the common subdivision consists of pieces.
TEST(Projective_pieces, are_as_few_as_possible)
{
  for(unsigned int seed : seeds(10)) {
    const Simplified s(Evolving_surface(random_sphere(60, seed)), 20);
    const Surface_map map(s.surface, s.fine, s.coarse);
    const Pieces pieces = all_pieces(map);
    for(std::size_t m = 0; m < pieces.size(); ++m)
      for(std::size_t n = 0; n < m; ++n)
        if(pieces[m].fine_face == pieces[n].fine_face &&
           pieces[m].coarse_face == pieces[n].coarse_face) {
          EXPECT_GT(distance(pieces[m], pieces[n]), 1e-10);
        }
    EXPECT_GT(parts(pieces).size(), parts(IS::Surface_subdivision<>(map)).size());
  }
}

// ---- Rounding ----

TEST(Projective_pieces, of_nearly_degenerate_meshes)
{
  for(const double noise : traced({1e-3, 1e-6, 1e-9, 1e-12, 1e-14, 1e-15, 1e-16, 1e-20}))
    for(const double stretch : traced({1., 1e3})) {
      const auto place = [&](double x, double y) {
        return Point(stretch * x, y, x < 3 ? 0 : x - 3);
      };
      const Simplified s(Evolving_surface(perturbed(grid(6, 5, place), noise, 1)), 4);
      const Surface_map map(s.surface, s.fine, s.coarse);
      const Pieces pieces = all_pieces(map);
      for(const Projective_piece& p : pieces)
        expect_convex(p, 1e-13);
      expect_tiling(pieces, map);
      expect_mapped(pieces, map, 1e-9);
    }
}

// Lines pass each other at the distance of rounding errors. The pieces still tile the faces, or the
// result reports that they do not.
TEST(Projective_pieces, with_vertices_as_near_as_rounding)
{
  CGAL::Random random(2);
  int failures = 0;
  for(const double distance : traced({1e-10, 1e-12, 1e-13, 1e-14, 1e-15}))
    for(unsigned int seed : seeds(5)) {
      const Mesh mesh = with_near_vertices(random_sphere(20, seed), distance, random);
      if(!all_are_apart(mesh))
        continue;
      const Simplified s(Evolving_surface(mesh), 10);
      const Surface_map map(s.surface, s.fine, s.coarse);
      try {
        expect_tiling(all_pieces(map), map);
      } catch(const IT::Numerical_error&) {
        EXPECT_LT(distance, 1e-12);
        ++failures;
      }
    }
  EXPECT_LE(failures, 3); // of 25
}

TEST(Projective_pieces, of_data_meshes)
{
  for_each_data_mesh(100000, [](const Mesh& mesh) {
    const Simplified s(Evolving_surface(mesh), mesh.number_of_vertices() / 20);
    const Surface_map map(s.surface, s.fine, s.coarse);
    const Pieces pieces = all_pieces(map);
    for(const Projective_piece& p : pieces)
      for(const Level side : {Level::fine, Level::coarse})
        EXPECT_GT(area(side, p), -1e-13);
    expect_tiling(pieces, map);
  });
}

} // namespace Test_projective_pieces
