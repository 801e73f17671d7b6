// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// This file generates surfaces before and after simplification, and points on them.

#ifndef INTRINSIC_SIMPLIFICATION_TEST_SIMPLIFIED_SURFACES_H
#define INTRINSIC_SIMPLIFICATION_TEST_SIMPLIFIED_SURFACES_H

#include "../Intrinsic_triangulations/hard_meshes.h"
#include "evolving_surfaces.h"

#include <CGAL/Intrinsic_simplification/Surface_level.h>
#include <CGAL/Intrinsic_simplification/Surface_map.h>
#include <CGAL/Intrinsic_simplification/Transport_cost.h>
#include <CGAL/Intrinsic_simplification/refine.h>
#include <CGAL/Intrinsic_simplification/simplify.h>

namespace Test_surfaces {

using IS::Surface_level;
using IS::Surface_map;
using IS::parameters::number_of_vertices;
using Coordinates = std::array<double, 3>;

// Stores a surface, before and after its simplification.
struct Simplified
{
  Evolving_surface surface;
  Surface_level fine;
  Surface_level coarse;

  Simplified(Evolving_surface s, std::size_t n)
    : surface(std::move(s)),
      fine(surface),
      coarse((simplify(surface, number_of_vertices(n)), surface))
  {}

  Simplified(Evolving_surface s, const Surface_level& before, const Surface_level& after)
    : surface(std::move(s)), fine(before), coarse(after)
  {}
};

// Simplifies by curvature alone, so that flat vertices are removed first.
inline Simplified simplified_by_curvature(Evolving_surface surface, std::size_t n)
{
  const Surface_level fine(surface);
  IS::Transport_cost cost(surface);
  cost.add_curvature(surface);
  simplify(surface, cost, number_of_vertices(n));
  const Surface_level coarse(surface);
  return {std::move(surface), fine, coarse};
}

// Returns two levels of a hierarchy, none of them the original surface.
inline Simplified simplified_twice()
{
  Evolving_surface surface(random_sphere(300, 7));
  simplify(surface, number_of_vertices(std::size_t(100)));
  const Surface_level fine(surface);
  simplify(surface, number_of_vertices(std::size_t(20)));
  const Surface_level coarse(surface);
  return {std::move(surface), fine, coarse};
}

// Returns a coarse level with better faces, and with vertices that the fine level does not have.
inline Simplified refined_after(Simplified s, double angle)
{
  IS::refine(s.surface, IS::parameters::minimum_angle(angle).maximum_number_of_insertions(1000));
  const Surface_level refined(s.surface);
  return {std::move(s.surface), s.fine, refined};
}

template <typename Check>
void for_each_simplified_random_surface(const Check& check)
{
  for(const auto& [c, seed] : traced(complexes(), 3)) {
    const Simplified s(evolving(c.mesh, seed), c.mesh.number_of_vertices() / (seed + 2));
    check(s, Surface_map(s.surface, s.fine, s.coarse));
  }
}

// Calls `check` for simplified surfaces, including two levels of a hierarchy.
template <typename Check>
void for_each_simplified_surface(const Check& check)
{
  const Simplified twice = simplified_twice();
  check(twice, Surface_map(twice.surface, twice.fine, twice.coarse));
  for_each_simplified_random_surface(check);
  for(const Named_mesh& m : traced(meshes())) {
    const Simplified s(Evolving_surface(m.mesh), 0);
    check(s, Surface_map(s.surface, s.fine, s.coarse));
  }
}

// Checks each surface refined, too.
template <typename Check>
auto with_refinement(const Check& check)
{
  return [&check](const Simplified& s, const Surface_map& map) {
    check(s, map);
    for(const double angle : traced({20., 30.})) {
      const Simplified r = refined_after(s, angle);
      check(r, Surface_map(r.surface, r.fine, r.coarse));
    }
  };
}

template <typename Check>
void for_each_random_surface(const Check& check)
{
  for_each_simplified_random_surface(with_refinement(check));
}

template <typename Check>
void for_each_surface(const Check& check)
{
  for_each_simplified_surface(with_refinement(check));
}

inline Location location(Halfedge_index h, double t, const Delta_complex& mesh)
{
  return IT::face_location(IT::Edge_point<double>{h, t}, mesh);
}

inline bool are_near(const Location& p, const Location& q)
{
  double distance = 0;
  for(std::size_t s = 0; s < 3; ++s)
    distance = (std::max)(distance, std::abs(p.second[s] - q.second[s]));
  return p.first == q.first && distance < 1e-9;
}

// Whether p and q are the same point of an edge, seen from its two sides.
inline bool meet_at_edge(const Location& p, const Location& q, const Delta_complex& mesh)
{
  for(Halfedge_index h : IT::sides(p.first, mesh)) {
    const Coordinates b = IT::coordinates_from(h, p, mesh);
    if(mesh.face(mesh.opposite(h)) == q.first && b[2] < 1e-9 &&
       are_near(location(mesh.opposite(h), b[0], mesh), q))
      return true;
  }
  return false;
}

inline void expect_same_place(const Location& p, const Location& q, const Delta_complex& mesh)
{
  const double most = *std::max_element(p.second.begin(), p.second.end());
  EXPECT_TRUE(are_near(p, q) || meet_at_edge(p, q, mesh) ||
              most > 1 - 1e-9); // more faces meet at a vertex
}

inline Point place(const Location& p, const Surface_level& level, const Mesh& mesh)
{
  return place_in_space(p, level.mesh(),
                        [&](Vertex_index v) { return mesh.point(level.surface_vertex(v)); });
}

// Returns a polygon in the plane.
inline Mesh flat_mesh(unsigned int seed) { return planar_mesh(random_points(60, 1000, seed)); }

inline Simplified simplified_inside(const Mesh& mesh)
{
  Evolving_surface s(mesh);
  for(Vertex_index v : mesh.vertices())
    if(mesh.is_border(v))
      s.protect(v);
  return Simplified(std::move(s), 0);
}

// Calls `check` for flat polygons. In the plane every vertex has the same position on both levels.
template <typename Check>
void for_each_flat_polygon(const Check& check)
{
  for(unsigned int seed : seeds(10)) {
    const Mesh mesh = flat_mesh(seed);
    const Simplified s = simplified_inside(mesh);
    check(mesh, s, Surface_map(s.surface, s.fine, s.coarse));
  }
}

// Returns whether two segments of the plane cross.
inline bool cross(const Point& a, const Point& b, const Point& c, const Point& d)
{
  const auto side = [](const Point& p, const Point& q, const Point& r) {
    return CGAL::orientation(Kernel::Point_2(p.x(), p.y()), Kernel::Point_2(q.x(), q.y()),
                             Kernel::Point_2(r.x(), r.y()));
  };
  return side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0;
}

// Returns a regular tetrahedron, and the surface without its first vertex.
inline Simplified without_tip()
{
  Evolving_surface s(tetrahedron());
  const Surface_level fine(s);
  Flattened_star star;
  EXPECT_EQ(s.flatten(Vertex_index(0), star), Removal_status::possible);
  EXPECT_EQ(s.remove(star), Removal_status::possible);
  const Surface_level coarse(s);
  return {std::move(s), fine, coarse};
}

// Inserts a vertex into each face next to one of its corners.
inline Mesh with_near_vertices(const Mesh& mesh, double distance, CGAL::Random& random)
{
  std::vector<Point> points(mesh.points().begin(), mesh.points().end());
  Triangles triangles;
  for(Face_index f : mesh.faces()) {
    const Halfedge_index h = mesh.halfedge(f);
    const Vertex_index a = mesh.source(h), b = mesh.target(h), c = mesh.target(mesh.next(h));
    const double x = distance * random.get_double(1, 8), y = distance * random.get_double(1, 8);
    const std::size_t near_a = points.size();
    points.push_back(mesh.point(a) + x * (mesh.point(b) - mesh.point(a)) +
                     y * (mesh.point(c) - mesh.point(a)));
    triangles.insert(triangles.end(), {{a, b, near_a}, {b, c, near_a}, {c, a, near_a}});
  }
  return make_mesh(points, triangles);
}

} // namespace Test_surfaces

#endif // INTRINSIC_SIMPLIFICATION_TEST_SIMPLIFIED_SURFACES_H
