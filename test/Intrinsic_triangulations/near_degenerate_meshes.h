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

inline unsigned int random_seed(CGAL::Random& random)
{
  return static_cast<unsigned int>(random.get_int(0, 1 << 30));
}

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
inline Mesh good_mesh(CGAL::Random& random)
{
  const auto in_plane = [](double x, double y) { return Point(x, y, 0); };
  const auto size = [&](int least, int greatest) { return random_size(least, greatest, random); };
  Mesh mesh;
  switch(random.get_int(0, 5)) {
    case 0: mesh = unit_sphere(size(2, 4)); break;
    case 1: mesh = embedded_torus(size(4, 8), size(4, 7)); break;
    case 2: mesh = frame(size(1, 3), 1); break;
    case 3: mesh = grid(size(5, 8), size(4, 7), in_plane); break;
    default: mesh = bipyramid(size(20, 50), random.get_double(0.1, 2)); break;
  }
  if(toss(random))
    mesh = perturbed(mesh, 0.02, random_seed(random));
  if(CGAL::is_closed(mesh) && random.get_int(0, 3) == 0)
    mesh = punctured(mesh, {random_size(0, static_cast<int>(mesh.number_of_faces()) - 1, random)});
  return mesh;
}

// ---- Ways to spoil them ----

inline Point between(const Point& p, const Point& q, double t) { return p + t * (q - p); }

// Inserts a vertex on the edge of `h`.
inline void split_edge_at(Halfedge_index h, double t, Mesh& mesh)
{
  const Point p = between(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)), t);
  mesh.point(mesh.target(IT::split_edge(h, mesh))) = p;
}

// Adds vertices on edges, next to their ends, which make pairs of needles.
inline void add_needles(Mesh& mesh, double width, double part, CGAL::Random& random)
{
  for(Halfedge_index h : random_part(mesh.halfedges(), part, random))
    split_edge_at(h, log_uniform(width, 1e-1, random), mesh);
}

// Adds vertices in faces, next to the sides, which make caps.
inline void add_caps(Mesh& mesh, double height, double part, CGAL::Random& random)
{
  for(Face_index f : random_part(mesh.faces(), part, random)) {
    const Halfedge_index h = mesh.halfedge(f);
    const Point on_side =
      between(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)), random.get_double(0.1, 0.9));
    const Point p =
      between(on_side, mesh.point(mesh.target(mesh.next(h))), log_uniform(height, 1e-1, random));
    mesh.point(mesh.target(IT::split_face(h, mesh))) = p;
  }
}

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

inline Mesh stretched_along_x(Mesh mesh, double factor)
{
  for(Vertex_index v : mesh.vertices())
    mesh.point(v) = Point(factor * mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z());
  return mesh;
}

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
inline Mesh tube(std::size_t rings, std::size_t n, double radius, std::size_t twist, Tube_ends ends)
{
  const double turn = 2 * std::acos(-1.), whole = static_cast<double>(rings);
  const bool is_joined = ends == Tube_ends::joined;
  std::vector<Point> points;
  Triangles triangles;
  for(std::size_t i = 0; i < rings; ++i)
    for(std::size_t j = 0; j < n; ++j) {
      const double s = turn * static_cast<double>(i) / whole;
      const double t = turn * static_cast<double>(j) / static_cast<double>(n);
      const double out = whole / turn + radius * std::cos(t), up = radius * std::sin(t);
      points.push_back(is_joined ? Point(out * std::cos(s), out * std::sin(s), up)
                                 : Point(radius * std::cos(t), -static_cast<double>(i), up));
      const std::size_t next = (i + 1) % rings, j_next = j + twist;
      const std::size_t k = i * n + j, l = next * n + j_next % n;
      const std::size_t k_up = i * n + (j + 1) % n, l_up = next * n + (j_next + 1) % n;
      if(next != 0 || is_joined) {
        triangles.push_back({k, l, l_up});
        triangles.push_back({k, l_up, k_up});
      }
    }
  if(ends == Tube_ends::capped) {
    points.emplace_back(0, radius, 0);
    points.emplace_back(0, 1 - whole - radius, 0);
    for(std::size_t j = 0; j < n; ++j) {
      const std::size_t j_next = (j + 1) % n, last = (rings - 1) * n;
      triangles.push_back({j, j_next, rings * n});
      triangles.push_back({last + j_next, last + j, rings * n + 1});
    }
  }
  return make_mesh(points, triangles);
}

// Returns a prism over a polygon with `n` corners on an ellipse, with bottom and top cut into fans
// from a corner. It has no top if it is open.
inline Mesh fan_prism(std::size_t n, double flatness, double height, bool is_open)
{
  std::vector<Point> points;
  for(int level = 0; level < 2; ++level)
    for(std::size_t i = 0; i < n; ++i) {
      const double angle = 2 * std::acos(-1.) * static_cast<double>(i) / static_cast<double>(n);
      points.emplace_back(std::cos(angle), flatness * std::sin(angle), level * height);
    }
  Triangles triangles;
  for(std::size_t i = 0; i < n; ++i) {
    const std::size_t next = (i + 1) % n;
    triangles.push_back({i, next, n + next});
    triangles.push_back({i, n + next, n + i});
    if(i == 0 || next == 0)
      continue;
    triangles.push_back({0, next, i});
    if(!is_open)
      triangles.push_back({n, n + i, n + next});
  }
  return make_mesh(points, triangles);
}

// ---- Families ----

inline Mesh needles(CGAL::Random& random)
{
  Mesh mesh = good_mesh(random);
  add_needles(mesh, 1e-9, random.get_double(0.05, 0.3), random);
  return mesh;
}

inline Mesh caps(CGAL::Random& random)
{
  Mesh mesh = good_mesh(random);
  add_caps(mesh, 1e-9, random.get_double(0.1, 1), random);
  return mesh;
}

inline Mesh needles_and_caps(CGAL::Random& random)
{
  Mesh mesh = good_mesh(random);
  add_needles(mesh, 1e-5, 0.1, random);
  add_caps(mesh, 1e-4, 0.3, random);
  return mesh;
}

inline Mesh polygon_fans(CGAL::Random& random)
{
  const std::size_t n = random_size(12, 150, random);
  const double flatness = log_uniform(1e-4, 1, random), height = log_uniform(1e-3, 10, random);
  return fan_prism(n, flatness, height, toss(random));
}

inline Mesh edge_fans(CGAL::Random& random)
{
  Mesh mesh = good_mesh(random);
  add_fans(mesh, random);
  return mesh;
}

inline Mesh stretched_meshes(CGAL::Random& random)
{
  return stretched_along_x(turned(good_mesh(random), random), log_uniform(10, 1e5, random));
}

inline Mesh thin_tubes(CGAL::Random& random)
{
  const std::size_t n = random_size(3, 8, random), twist = random_size(0, 5, random);
  const auto ends = static_cast<Tube_ends>(random.get_int(0, 3));
  return tube(random_size(9, 30, random), n, log_uniform(1e-6, 1e-1, random), twist, ends);
}

inline Mesh wire_frames(CGAL::Random& random)
{
  return frame(random_size(1, 6, random), log_uniform(1e-6, 1e-1, random));
}

inline Mesh boolean_slivers(CGAL::Random& random)
{
  Mesh mesh = good_mesh(random);
  for(int i = 0; i < 2; ++i)
    cut_badly(mesh, 1e-9, random);
  return mesh;
}

inline Mesh near_coincident_vertices(CGAL::Random& random)
{
  return with_near_coincident_vertices(good_mesh(random), log_uniform(1e-9, 1e-2, random),
                                       random_seed(random));
}

inline Mesh swept_polygons(CGAL::Random& random)
{
  return planar_mesh(random_points(random_size(30, 300, random), 1 << 18, random_seed(random)));
}

inline Mesh stretched_slivers(CGAL::Random& random)
{
  Mesh mesh = turned(good_mesh(random), random);
  cut_badly(mesh, 1e-6, random);
  return stretched_along_x(mesh, log_uniform(10, 1e4, random));
}

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
inline Named_mesh near_degenerate_mesh(unsigned int seed)
{
  CGAL::Random random(seed);
  const Mesh_family& family = near_degenerate_families[seed % near_degenerate_families.size()];
  Mesh mesh = family.make(random);
  return {family.name, toss(random) ? turned(std::move(mesh), random) : std::move(mesh)};
}

} // namespace Test_surfaces

#endif // INTRINSIC_TRIANGULATIONS_TEST_NEAR_DEGENERATE_MESHES_H
