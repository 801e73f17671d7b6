// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_TRIANGULATIONS_TEST_NEAR_DEGENERATE_MESHES_H
#define INTRINSIC_TRIANGULATIONS_TEST_NEAR_DEGENERATE_MESHES_H

#include "more_generators.h"
#include "refined_meshes.h"

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>

// This file generates meshes as bad as meshes from scanners, boolean operations and CAD, with 30 to
// 900 faces. Each family is bad in its own way. All are manifold and have no edge of zero length.
namespace Test_surfaces {

// ---- Random numbers ----

template <typename Random>
double log_uniform(double least, double greatest, Random& random)
{
  return std::exp(random.get_double(std::log(least), std::log(greatest)));
}

// Returns a random number within the bounds, including both.
template <typename Random>
std::size_t random_size(int least, int greatest, Random& random)
{
  return static_cast<std::size_t>(random.get_int(least, greatest + 1));
}

template <typename Random>
bool toss(Random& random)
{
  return random.get_int(0, 2) == 1;
}

unsigned int random_seed(CGAL::Random& random);

template <typename Random>
Kernel::Vector_3 random_direction(Random& random)
{
  for(;;) {
    const Kernel::Vector_3 v(random.get_double(-1, 1), random.get_double(-1, 1),
                             random.get_double(-1, 1));
    if(const double square = v.squared_length(); square > 0.01 && square < 1)
      return v / std::sqrt(square);
  }
}

template <typename Index, typename Random>
void shuffle(std::vector<Index>& elements, Random& random)
{
  for(std::size_t i = elements.size(); i > 1; --i)
    std::swap(elements[i - 1], elements[random_size(0, static_cast<int>(i) - 1, random)]);
}

// Returns a part of the elements, in random order.
template <typename Range, typename Random>
auto random_part(const Range& range, double part, Random& random)
{
  std::vector<std::decay_t<decltype(*range.begin())>> result(range.begin(), range.end());
  shuffle(result, random);
  result.resize(static_cast<std::size_t>(std::ceil(part * static_cast<double>(result.size()))));
  return result;
}

// ---- Surfaces to spoil ----

// Returns a mesh with or without boundary, of genus 0 to 3. Half of them have many cocircular and
// coplanar vertices.
Mesh good_mesh(CGAL::Random& random);

// ---- Ways to spoil them ----

inline Point between(const Point& p, const Point& q, double t) { return p + t * (q - p); }

// Inserts a vertex on the edge of `h`.
void split_edge_at(Halfedge_index h, double t, Mesh& mesh);

// Adds vertices on edges, next to their ends, which make pairs of needles.
void add_needles(Mesh& mesh, double width, double part, CGAL::Random& random);

// Adds vertices in faces, next to the sides, which make caps.
void add_caps(Mesh& mesh, double height, double part, CGAL::Random& random);

// Adds many vertices on some edges, all joined to the opposite corners.
template <typename Random>
void add_fans(Mesh& mesh, Random& random)
{
  for(Edge_index e : random_part(mesh.edges(), 0.1, random)) {
    const std::size_t n = random_size(5, 20, random);
    for(std::size_t i = 0; i < n; ++i)
      split_edge_at(mesh.halfedge(e), 1 / static_cast<double>(n + 1 - i), mesh);
  }
}

struct Plane
{
  Point origin;
  Kernel::Vector_3 normal;

  double height(const Point& p) const { return (p - origin) * normal; }
};

// Inserts vertices at the intersections of a plane with edges, but no closer than `gap` to their
// neighbors.
template <typename Random>
void cut(Mesh& mesh, const Plane& plane, double gap, Random& random)
{
  const auto is_far = [&](const Point& p, Halfedge_index h) {
    return mesh.is_border(h) ||
           CGAL::squared_distance(p, mesh.point(mesh.target(mesh.next(h)))) >= gap * gap;
  };
  for(Halfedge_index h : random_part(mesh.halfedges(), 1, random)) {
    const Point &p = mesh.point(mesh.source(h)), &q = mesh.point(mesh.target(h));
    const double below = plane.height(p), above = plane.height(q);
    const double margin = gap / std::sqrt(CGAL::squared_distance(p, q));
    if(below >= 0 || above <= 0 || margin >= 0.5)
      continue;
    const double t = std::clamp(below / (below - above), margin, 1 - margin);
    if(is_far(between(p, q, t), h) && is_far(between(p, q, t), mesh.opposite(h)))
      split_edge_at(h, t, mesh);
  }
}

// Cuts by planes that almost pass through vertices and almost coincide.
template <typename Random>
void cut_badly(Mesh& mesh, double gap, Random& random)
{
  const Vertex_index v(static_cast<Mesh::size_type>(
    random_size(0, static_cast<int>(mesh.number_of_vertices()) - 1, random)));
  Plane plane{mesh.point(v), random_direction(random)};
  for(int i = 0; i < 2; ++i) {
    cut(mesh, plane, gap, random);
    plane.origin = plane.origin + log_uniform(gap, 1e-3, random) * plane.normal;
    plane.normal = plane.normal + log_uniform(gap, 1e-3, random) * random_direction(random);
  }
}

Mesh stretched_along_x(Mesh mesh, double factor);

// Turns the mesh, which rounds every coordinate.
template <typename Random>
Mesh turned(Mesh mesh, Random& random)
{
  const Kernel::Vector_3 x = random_direction(random);
  const Kernel::Vector_3 across = CGAL::cross_product(x, random_direction(random));
  const Kernel::Vector_3 y = across / std::sqrt(across.squared_length());
  const Kernel::Vector_3 z = CGAL::cross_product(x, y);
  for(Vertex_index v : mesh.vertices()) {
    const Point p = mesh.point(v);
    mesh.point(v) = CGAL::ORIGIN + p.x() * x + p.y() * y + p.z() * z;
  }
  return mesh;
}

// ---- Surfaces that are bad from the start ----

enum class Tube_ends
{
  open,
  capped,
  joined
};

// Returns rings of `n` points along a segment or a circle, at unit distance. The edges from ring to
// ring turn by `twist` points.
Mesh tube(std::size_t rings, std::size_t n, double radius, std::size_t twist, Tube_ends ends);

// Returns a prism over a polygon with `n` corners on an ellipse, with bottom and top cut into fans
// from a corner. It has no top if it is open.
Mesh fan_prism(std::size_t n, double flatness, double height, bool is_open);

// ---- Families ----

Mesh needles(CGAL::Random& random);

Mesh caps(CGAL::Random& random);

Mesh needles_and_caps(CGAL::Random& random);

Mesh polygon_fans(CGAL::Random& random);

Mesh edge_fans(CGAL::Random& random);

Mesh stretched_meshes(CGAL::Random& random);

Mesh thin_tubes(CGAL::Random& random);

Mesh wire_frames(CGAL::Random& random);

Mesh boolean_slivers(CGAL::Random& random);

Mesh near_coincident_vertices(CGAL::Random& random);

Mesh swept_polygons(CGAL::Random& random);

Mesh stretched_slivers(CGAL::Random& random);

struct Mesh_family
{
  const char* name;
  Mesh (*make)(CGAL::Random&);
};

constexpr std::array<Mesh_family, 12> near_degenerate_families{
  {{"needles", needles},
   {"caps", caps},
   {"needles and caps", needles_and_caps},
   {"polygon fans", polygon_fans},
   {"edge fans", edge_fans},
   {"stretched meshes", stretched_meshes},
   {"thin tubes", thin_tubes},
   {"wire frames", wire_frames},
   {"boolean slivers", boolean_slivers},
   {"near-coincident vertices", near_coincident_vertices},
   {"swept polygons", swept_polygons},
   {"stretched slivers", stretched_slivers}}};

// Returns a mesh of one family after the other, with the name of the family. Half of the meshes are
// turned in space, so that no mesh is flat, straight or symmetric to the last bit.
Named_mesh near_degenerate_mesh(unsigned int seed);

} // namespace Test_surfaces

#endif // INTRINSIC_TRIANGULATIONS_TEST_NEAR_DEGENERATE_MESHES_H
