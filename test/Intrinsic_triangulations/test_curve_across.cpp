// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "data_meshes.h"
#include "flat_changes.h"
#include "known_surfaces.h"
#include "path_checks.h"
#include "random_changes.h"

#include <CGAL/Intrinsic_triangulations/Shortest_paths.h>
#include <CGAL/Intrinsic_triangulations/curve_across.h>
#include <CGAL/Intrinsic_triangulations/path_on_input.h>
#include <CGAL/Intrinsic_triangulations/point_across.h>
#include <CGAL/Intrinsic_triangulations/refine.h>

namespace Test_curve_across {

using namespace Test_surfaces;
using Test_flat_changes::for_each_flat;
using View = decltype(std::declval<Triangulation>().input());
using Paths = IT::Shortest_paths<View>;

std::size_t pieces = 0; // of all images

// Returns the point of a path at a length from its start.
Location at_length(Real s, const Path& path, const Flat_faces& faces)
{
  for(std::size_t k = 0; k + 1 < path.places.size(); ++k) {
    const Piece_of_path piece = piece_of_path(path, k, faces);
    const Real length = Test_surfaces::length(piece, faces);
    if(s > length && k + 2 < path.places.size()) {
      s -= length;
      continue;
    }
    const double t = length > 0 ? static_cast<double>((std::min)(Real(1), s / length)) : 0;
    Location result = piece.from;
    for(std::size_t i = 0; i < 3; ++i)
      result.second[i] = (1 - t) * piece.from.second[i] + t * piece.to.second[i];
    return result;
  }
  return IT::face_location(path.places.front(), faces.mesh());
}

// Whether there is a path. If so, its pieces add up on its own triangulation.
bool is_path(const Path& path, const Flat_faces& faces)
{
  if(path.places.empty())
    return false;
  expect_valid(path, faces, 1e-10 * static_cast<double>(faces.longest_edge()));
  return true;
}

// Checks that the image of a path is connected, has the same length, and has the same positions.
Path check_image(const Triangulation& t, Side side, const Path& path, const Correspondence& c)
{
  const Flat_faces here(side, t), there(other(side), t);
  const double tolerance = 1e-9 * static_cast<double>(there.longest_edge());
  const Path image = IT::curve_across(c, side, path);
  pieces += image.places.size();
  EXPECT_EQ(image.length, path.length);
  EXPECT_FALSE(image.places.empty());
  expect_valid(image, there, tolerance);
  Real s = 0;
  for(std::size_t k = 0; k < image.places.size(); ++k) {
    const Location truth = IT::point_across(c, side, at_length(s, path, here));
    EXPECT_LT(
      static_cast<double>(there.path(truth, IT::face_location(image.places[k], there.mesh()))),
      tolerance)
      << k << " of " << image.places.size() << " " << along(image.places[k]);
    if(k + 1 < image.places.size())
      s += length(piece_of_path(image, k, there), there);
  }
  return image;
}

// Returns the halfedges through which a path leaves faces, except for positions at inserted
// vertices.
std::vector<Halfedge_index> crossed(const Path& path, const Flat_faces& faces)
{
  std::vector<Halfedge_index> result;
  for(std::size_t k = 1; k + 1 < path.places.size(); ++k) {
    const Path_place& p = path.places[k];
    if(IT::on_edge(p) && !is_inserted_on_edge(p, faces))
      result.push_back(along(p));
  }
  return result;
}

// Checks that a generic path is mapped back through the same edges.
void check_there_and_back(const Triangulation& t, Side side, const Path& path,
                          const Correspondence& c, bool is_generic)
{
  const Path image = check_image(t, side, path, c);
  SCOPED_TRACE("back");
  const Path back = check_image(t, other(side), image, c);
  if(is_generic) {
    EXPECT_EQ(crossed(back, Flat_faces(side, t)), crossed(path, Flat_faces(side, t)));
  }
}

// Returns points of all kinds: one of five is random, the others may lie on edges.
std::vector<Location> points_of(Side side, const Correspondence& c, std::size_t n,
                                CGAL::Random& random)
{
  const Delta_complex &mesh = c.mesh(side), &other_mesh = c.mesh(other(side));
  const auto halfedge = [&](const Delta_complex& of) {
    for(;;) {
      const Halfedge_index h = random_halfedge(of, random);
      if(!of.is_border(h))
        return h;
    }
  };
  const auto across = [&](const Location& p) { return IT::point_across(c, other(side), p); };
  std::vector<Location> result;
  while(result.size() < n) {
    result.push_back(random_location(mesh, random));
    result.push_back(IT::face_location(Edge_place{halfedge(mesh), 0}, mesh));
    result.push_back(IT::face_location(Edge_place{halfedge(mesh), random.get_double()}, mesh));
    result.push_back(across(IT::face_location(Edge_place{halfedge(other_mesh), 0}, other_mesh)));
    result.push_back(
      across(IT::face_location(Edge_place{halfedge(other_mesh), random.get_double()}, other_mesh)));
  }
  return result;
}

void check_paths(const Triangulation& t, unsigned int seed, std::size_t n = 10)
{
  const Correspondence c(t);
  CGAL::Random random(seed);
  for(const Side side : both_sides) {
    SCOPED_TRACE(side == Side::input ? "from T1" : "from T2");
    const auto sources = points_of(side, c, 5, random);
    for(std::size_t i = 0; i < sources.size(); ++i) {
      Paths paths(t.surface(side));
      paths.add_source(sources[i]);
      paths.run();
      const auto targets = points_of(side, c, n, random);
      for(std::size_t j = 0; j < targets.size(); ++j)
        if(const Path path = paths.path(targets[j]); is_path(path, Flat_faces(side, t)))
          check_there_and_back(t, side, path, c, i % 5 == 0 && j % 5 == 0);
    }
  }
}

// ---- In the plane ----

// Stores a triangulation of a flat surface with exact positions.
struct Plane
{
  const Flat_faces& faces;
  const std::vector<Vector>& point;
  const std::vector<Vector>& vector;

  Place operator()(const Location& p) const
  {
    const auto h = faces.sides(p.first);
    const auto place = [](const Vector& v) { return Place{Real(v.x), Real(v.y)}; };
    return place(point[faces.mesh().source(h[0])]) + Real(p.second[1]) * place(vector[h[0]]) -
           Real(p.second[2]) * place(vector[h[2]]);
  }
};

// Checks that a path has the same positions in the plane on both triangulations.
void check_in_plane(const Path& path, const Path& image, const Plane& plane, const Plane& other,
                    const Flat_surface& surface)
{
  const auto place = [](const Vector& v) { return Place{Real(v.x), Real(v.y)}; };
  Real s = 0;
  for(std::size_t k = 0; k + 1 < image.places.size(); ++k) {
    const Piece_of_path piece = piece_of_path(image, k, other.faces);
    const Place gap = plane(at_length(s, path, plane.faces)) - other(piece.from);
    EXPECT_LT(
      static_cast<double>(Flat_insertion::reduced_norm(gap, place(surface.a), place(surface.b))),
      1e-9 * length(surface.vector[0]))
      << k << " of " << image.places.size();
    s += length(piece, other.faces);
  }
}

void check_flat(const Flat_insertion::Result& r, const Flat_surface& surface)
{
  const Triangulation& t = r.triangulation;
  const Correspondence c(t);
  CGAL::Random random(1);
  const std::array<Flat_faces, 2> faces{Flat_faces(Side::input, t), Flat_faces(Side::intrinsic, t)};
  const std::array<Plane, 2> planes{Plane{faces[0], surface.point, surface.vector},
                                    Plane{faces[1], r.point, r.vector}};
  for(const Side side : both_sides) {
    Paths paths(t.surface(side));
    paths.add_source(random_location(c.mesh(side), random));
    paths.run();
    const auto here = static_cast<std::size_t>(side);
    for(const Location& q : points_of(side, c, 5, random)) {
      const Path path = paths.path(q);
      if(!is_path(path, faces[here]))
        continue;
      const Path image = check_image(t, side, path, c);
      check_in_plane(path, image, planes[here], planes[1 - here], surface);
    }
  }
}

TEST(Curve_across, in_the_plane)
{
  for_each_flat(100, [](const Flat_insertion& flat) { check_flat(flat.result(), flat.surface()); });
  EXPECT_GT(pieces, 30000u);
}

// ---- On all surfaces ----

TEST(Curve_across, without_inserted_vertices)
{
  for(const Named_mesh& m : traced(meshes())) {
    Triangulation t(m.mesh);
    check_paths(t, 1);
    flip_at_random(t, 2 * t.mesh().number_of_edges(), 2);
    check_paths(t, 2);
    IT::make_Delaunay(t);
    check_paths(t, 3);
  }
}

TEST(Curve_across, after_random_insertions)
{
  for_each_triangulation(
    [](const Triangulation& t, unsigned int seed) { check_paths(changed(t, seed, 60), seed); });
  EXPECT_GT(pieces, 30000u);
}

// The triangulation is far from Delaunay, so edges of T2 are long.
TEST(Curve_across, after_random_insertions_and_flips)
{
  for_each_triangulation([](const Triangulation& t, unsigned int seed) {
    Triangulation x = changed(t, seed, 100);
    flip_at_random(x, 3 * x.mesh().number_of_edges(), seed);
    x.recompute_lengths();
    check_paths(x, seed);
  });
}

TEST(Curve_across, after_refinement)
{
  for(const Named_mesh& m : traced(meshes())) {
    Triangulation t(m.mesh);
    IT::refine(t, IT::parameters::minimum_angle(25));
    check_paths(t, 1);
  }
}

bool has_areas(const Triangulation& t)
{
  const Flat_faces faces(Side::input, t);
  const auto range = faces.mesh().faces();
  return std::all_of(range.begin(), range.end(),
                     [&](Face_index f) { return faces.area(f) > 1e-9 * faces.area(); });
}

TEST(Curve_across, on_data_meshes)
{
  for(const std::string& file : data_meshes(60000)) {
    SCOPED_TRACE(file);
    const Mesh mesh = read_mesh(file);
    if(!CGAL::is_triangle_mesh(mesh) || mesh.is_empty())
      continue;
    try {
      Triangulation t(mesh);
      if(!has_areas(t))
        continue;
      IT::refine(t, IT::parameters::minimum_angle(25));
      t.recompute_lengths();
      check_paths(t, 1, 5);
    } catch(const IT::Invalid_input&) { // the mesh is no surface
    }
  }
}

// ---- Places ----

// If a path passes inserted vertices, it passes them on both triangulations, and back.
TEST(Curve_across, through_inserted_vertices)
{
  std::size_t passed = 0;
  for(const Named_mesh& m : traced(meshes())) {
    Triangulation t(m.mesh);
    IT::refine(t, IT::parameters::minimum_angle(25));
    const Correspondence c(t);
    for(Halfedge_index h : t.mesh().halfedges())
      if(t.is_inserted(t.mesh().source(h)) && t.is_inserted(t.mesh().target(h))) {
        const Path edge = IT::path_on_input(t, {h});
        const Path path = IT::curve_across(c, Side::input, edge);
        expect_valid(path, Flat_faces(Side::intrinsic, t), 1e-9);
        ASSERT_TRUE(is_vertex(path.places.front()) && is_vertex(path.places.back()));
        EXPECT_EQ(t.mesh().source(along(path.places.front())), t.mesh().source(h));
        EXPECT_EQ(t.mesh().source(along(path.places.back())), t.mesh().target(h));
        const Path back = IT::curve_across(c, Side::intrinsic, path);
        const auto expect_same = [&](const Path_place& p, const Path_place& q) {
          EXPECT_EQ(IT::face_location(p, t.input_mesh()), IT::face_location(q, t.input_mesh()));
        };
        expect_same(back.places.front(), edge.places.front());
        expect_same(back.places.back(), edge.places.back());
        ++passed;
      }
  }
  EXPECT_GT(passed, 30u);
}

// One path is a point, and another one leads along an edge of T1 that consists of several edges of
// T2.
TEST(Curve_across, points_and_parts_of_edges)
{
  for_each_triangulation([](const Triangulation& input, unsigned int seed) {
    const Triangulation t = changed(input, seed, 60);
    const Correspondence c(t);
    for(Halfedge_index h : t.input_mesh().halfedges()) {
      const Delta_complex& mesh = t.input_mesh();
      const Path edge{t.input_length(mesh.edge(h)),
                      {IT::Vertex_location{h}, IT::Vertex_location{mesh.opposite(h)}}};
      check_image(t, Side::input, edge, c);
    }
    CGAL::Random random(seed);
    for(const Side side : both_sides)
      for(const Location& p : points_of(side, c, 20, random)) {
        const Path point{0, {IT::surface_point(p, c.mesh(side))}};
        const Path image = check_image(t, side, point, c);
        EXPECT_EQ(image.places.size(), 1u);
      }
  });
}

TEST(Curve_across, gap_in_a_path)
{
  Triangulation t(octahedron());
  const Correspondence c(t);
  const std::array<double, 3> center{0.25, 0.25, 0.5};
  const Path path{1, {Location(Face_index(0), center), Location(Face_index(1), center)}};
  for(const Side side : both_sides)
    EXPECT_THROW(IT::curve_across(c, side, path), IT::Invalid_input);
}

} // namespace Test_curve_across
