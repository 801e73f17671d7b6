// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_TRIANGULATIONS_TEST_HARD_MESHES_H
#define INTRINSIC_TRIANGULATIONS_TEST_HARD_MESHES_H

#include "near_degenerate_meshes.h"

// This file generates meshes at the limits of `double`: needles and caps down to 1e-16 of an edge,
// vertices within rounding of others, and faces of zero area. They have 20 to 3000 faces, are
// manifold and oriented, and no two vertices coincide, so that none have distance zero on the
// surface. None has a long and narrow channel, on which large angles would need as many faces as
// its length exceeds its width. Teeth are less than a row, and struts and stretched surfaces are
// not thinner than 1/100, except if they are flattened.
namespace Test_surfaces {

// Generates numbers that depend on the seed alone, not on the standard library.
class Portable_random
{
public:
  explicit Portable_random(std::uint64_t seed) : m_bits(seed) {}

  // Returns a number in [least, bound).
  double get_double(double least, double bound)
  {
    return least + (bound - least) * std::ldexp(static_cast<double>(m_bits() >> 11), -53);
  }
  int get_int(int least, int bound)
  {
    return least + static_cast<int>(m_bits() % static_cast<std::uint64_t>(bound - least));
  }

private:
  std::mt19937_64 m_bits;
};

// ---- Vertices that are apart ----

// Whether no vertex is closer to `p` than rounding of a coordinate of one.
inline bool is_free(const Point& p, const Mesh& mesh)
{
  return std::none_of(mesh.points().begin(), mesh.points().end(),
                      [&](const Point& q) { return CGAL::squared_distance(p, q) <= 1e-34; });
}

inline bool all_are_apart(const Mesh& mesh)
{
  return std::set<Point>(mesh.points().begin(), mesh.points().end()).size() ==
         mesh.number_of_vertices();
}

// Inserts a vertex on the edge of `h` if its position is free. Returns the halfedge from the source
// of `h` to it.
inline Halfedge_index split_edge_apart(Halfedge_index h, double t, Mesh& mesh)
{
  const Point p = between(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)), t);
  if(!is_free(p, mesh))
    return Mesh::null_halfedge();
  const Halfedge_index result = IT::split_edge(h, mesh);
  mesh.point(mesh.target(result)) = p;
  return result;
}

// Inserts a vertex at `p` into the face of `h` if its position is free.
inline void split_face_apart(Halfedge_index h, const Point& p, Mesh& mesh)
{
  if(is_free(p, mesh))
    mesh.point(mesh.target(IT::split_face(h, mesh))) = p;
}

inline const Point& apex(Halfedge_index h, const Mesh& mesh)
{
  return mesh.point(mesh.target(mesh.next(h)));
}

// Rotates and rounds the mesh, unless vertices then coincide.
inline Mesh turned_apart(const Mesh& mesh, Portable_random& random)
{
  const Mesh result = turned(mesh, random);
  return all_are_apart(result) ? result : mesh;
}

inline Mesh stretched_apart(const Mesh& mesh, double factor)
{
  const Mesh result = stretched_along_x(mesh, factor);
  return all_are_apart(result) ? result : mesh;
}

// ---- Surfaces to spoil ----

// Returns a mesh with or without boundary, of genus 0, 1 or 2.
inline Mesh hard_base(Portable_random& random)
{
  const auto size = [&](double least, double greatest) {
    return static_cast<std::size_t>(log_uniform(least, greatest, random));
  };
  const auto in_plane = [](double x, double y) { return Point(x, y, 0); };
  const double height = random.get_double(0.1, 2), radius = random.get_double(0.3, 3);
  Mesh mesh;
  switch(random.get_int(0, 6)) {
    case 0: mesh = unit_sphere(size(2, 12)); break;
    case 1: mesh = embedded_torus(size(4, 30), size(4, 16)); break;
    case 2: mesh = frame(2, 1); break;
    case 3: mesh = grid(size(4, 24), size(4, 20), in_plane); break;
    case 4: mesh = tube(size(4, 20), size(3, 12), radius, 0, Tube_ends::open); break;
    default: mesh = bipyramid(size(16, 100), height); break;
  }
  if(toss(random))
    mesh = turned_apart(mesh, random);
  const auto last = static_cast<int>(mesh.number_of_faces()) - 1;
  if(CGAL::is_closed(mesh) && random.get_int(0, 3) == 0)
    mesh = punctured(mesh, {random_size(0, last, random)});
  return mesh;
}

// Cuts off ears at random; `ring` contains the corners counterclockwise.
template <typename Random>
Triangles random_ears(std::vector<std::size_t> ring, Random& random)
{
  Triangles triangles;
  while(ring.size() > 2) {
    const std::size_t n = ring.size(), m = random_size(0, static_cast<int>(n) - 1, random);
    triangles.push_back({ring[(m + n - 1) % n], ring[m], ring[(m + 1) % n]});
    ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(m));
  }
  return triangles;
}

inline std::vector<std::size_t> consecutive(std::size_t first, std::size_t n)
{
  std::vector<std::size_t> result(n);
  for(std::size_t i = 0; i < n; ++i)
    result[i] = first + i;
  return result;
}

// Returns a convex polygon with `n` points on each of its sides, cut into triangles at random, or a
// prism over it. If three corners are on a side, a triangle has no area.
inline Mesh sliced_polygon(std::size_t sides, std::size_t n, double height, Portable_random& random)
{
  const double turn = 2 * std::acos(-1.) / static_cast<double>(sides);
  const auto corner = [&](std::size_t k) {
    const double angle = turn * static_cast<double>(k);
    return Point(std::cos(angle), std::sin(angle), 0);
  };
  std::vector<Point> points;
  for(std::size_t k = 0; k < sides; ++k) {
    points.push_back(corner(k));
    double t = 0;
    for(std::size_t i = 1; i < n; ++i)
      points.push_back(
        between(corner(k), corner(k + 1), t += log_uniform(1e-15, 0.9, random) * (1 - t)));
  }
  points.erase(std::unique(points.begin(), points.end(),
                           [](const Point& p, const Point& q) { return p == q; }),
               points.end());
  const std::size_t ring = points.size();
  Triangles triangles = random_ears(consecutive(0, ring), random);
  if(height > 0) {
    for(std::size_t i = 0, flat = triangles.size(); i < flat; ++i)
      triangles.push_back({ring + triangles[i][0], ring + triangles[i][2], ring + triangles[i][1]});
    for(std::size_t i = 0; i < ring; ++i) {
      const std::size_t next = (i + 1) % ring;
      points.push_back(points[i] - Kernel::Vector_3(0, 0, height));
      triangles.push_back({i, ring + i, ring + next});
      triangles.push_back({i, ring + next, next});
    }
  }
  return make_mesh(points, triangles);
}

// Returns rows of points at steps between 1e-14 and 1, every second column shifted by `tooth`. The
// last column is joined to the first if it is closed.
inline Mesh saw_teeth(std::size_t columns, std::size_t rows, double tooth, bool is_closed,
                      Portable_random& random)
{
  std::vector<Point> points;
  double x = 0;
  for(std::size_t i = 0; i < columns; ++i) {
    for(std::size_t j = 0; j <= rows; ++j)
      points.emplace_back(x, static_cast<double>(j) + (i % 2 == 1 ? tooth : 0), 0);
    x += log_uniform(1e-14, 1, random);
  }
  return make_mesh(points, lattice(is_closed ? columns : columns - 1, rows, is_closed));
}

// ---- Ways to spoil them ----

inline void add_extreme_needles(Mesh& mesh, double part, Portable_random& random)
{
  for(Halfedge_index h : random_part(mesh.halfedges(), part, random))
    split_edge_apart(h, log_uniform(1e-16, 1e-1, random), mesh);
}

// Returns a side of the face that is not on the boundary, on which a vertex must not lie.
inline Halfedge_index inner_side(Face_index f, const Mesh& mesh)
{
  const Halfedge_index h = mesh.halfedge(f);
  return !mesh.is_border(mesh.edge(h))              ? h
         : !mesh.is_border(mesh.edge(mesh.next(h))) ? mesh.next(h)
                                                    : mesh.prev(h);
}

inline void add_extreme_caps(Mesh& mesh, double part, Portable_random& random)
{
  for(Face_index f : random_part(mesh.faces(), part, random)) {
    const Halfedge_index h = inner_side(f, mesh);
    const Point on_side =
      between(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)), random.get_double(0.1, 0.9));
    split_face_apart(h, between(on_side, apex(h, mesh), log_uniform(1e-16, 1e-1, random)), mesh);
  }
}

// Adds vertices in faces, as near to a corner as rounding allows.
inline void add_near_vertices(Mesh& mesh, double part, Portable_random& random)
{
  for(Face_index f : random_part(mesh.faces(), part, random)) {
    const Halfedge_index h = mesh.halfedge(f);
    const Point opposite =
      between(mesh.point(mesh.target(h)), apex(h, mesh), random.get_double(0.1, 0.9));
    split_face_apart(
      h, between(mesh.point(mesh.source(h)), opposite, log_uniform(1e-16, 1e-11, random)), mesh);
  }
}

// Moves vertices next to a neighbor, with all their faces.
inline void collapse_almost(Mesh& mesh, double part, Portable_random& random)
{
  for(Vertex_index v : random_part(mesh.vertices(), part, random)) {
    const Point& neighbor = mesh.point(mesh.source(mesh.halfedge(v)));
    const Point p = neighbor + log_uniform(1e-16, 1e-11, random) * random_direction(random);
    if(is_free(p, mesh))
      mesh.point(v) = p;
  }
}

// Adds vertices in the middle of a side of their face. The face has zero area if coordinates need
// no rounding.
inline void add_flat_faces(Mesh& mesh, double part, Portable_random& random)
{
  for(Face_index f : random_part(mesh.faces(), part, random)) {
    const Halfedge_index h = inner_side(f, mesh);
    split_face_apart(h, between(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)), 0.5), mesh);
  }
}

// Adds vertices on an edge that converge to its source.
inline void add_cascades(Mesh& mesh, double part, Portable_random& random)
{
  for(Halfedge_index h : random_part(mesh.halfedges(), part, random)) {
    const double ratio = log_uniform(1e-5, 0.5, random);
    Halfedge_index first = h;
    for(int i = 0; i < 12 && first.is_valid(); ++i)
      first = split_edge_apart(first, ratio, mesh);
  }
}

// ---- Families ----

inline Mesh spoilt(void (*spoil)(Mesh&, double, Portable_random&), double least_part,
                   double greatest_part, Portable_random& random)
{
  Mesh mesh = hard_base(random);
  spoil(mesh, random.get_double(least_part, greatest_part), random);
  return mesh;
}

inline Mesh extreme_needles(Portable_random& random)
{
  return spoilt(add_extreme_needles, 0.02, 0.2, random);
}

inline Mesh extreme_caps(Portable_random& random)
{
  return spoilt(add_extreme_caps, 0.05, 0.8, random);
}

inline Mesh near_vertices(Portable_random& random)
{
  return spoilt(add_near_vertices, 0.05, 0.5, random);
}

inline Mesh almost_collapsed(Portable_random& random)
{
  return spoilt(collapse_almost, 0.05, 0.4, random);
}

inline Mesh flat_faces(Portable_random& random)
{
  Mesh mesh = hard_base(random);
  for(int i = 0; i < 3; ++i)
    add_flat_faces(mesh, 0.2, random);
  return mesh;
}

inline Mesh cascades(Portable_random& random) { return spoilt(add_cascades, 0.01, 0.03, random); }

// Returns a mesh with bad faces that are changed again.
inline Mesh spoilt_twice(Portable_random& random)
{
  Mesh mesh = hard_base(random);
  for(int i = 0; i < 2; ++i) {
    add_extreme_needles(mesh, 0.04, random);
    add_extreme_caps(mesh, 0.1, random);
    add_near_vertices(mesh, 0.05, random);
  }
  return mesh;
}

inline Mesh sliced_polygons(Portable_random& random)
{
  const std::size_t sides = random_size(3, 9, random), n = random_size(8, 40, random);
  const Mesh mesh =
    sliced_polygon(sides, n, toss(random) ? log_uniform(1e-3, 10, random) : 0, random);
  return stretched_apart(mesh, log_uniform(1, 1e2, random));
}

inline Mesh saw_tooth_strips(Portable_random& random)
{
  const std::size_t columns = random_size(6, 60, random), rows = random_size(2, 10, random);
  return saw_teeth(columns, rows, log_uniform(1e-3, 0.9, random), toss(random), random);
}

inline Mesh stretched_and_spoilt(Portable_random& random)
{
  Mesh mesh =
    stretched_apart(turned_apart(hard_base(random), random), log_uniform(1e-5, 1e2, random));
  add_extreme_needles(mesh, 0.04, random);
  add_extreme_caps(mesh, 0.1, random);
  return mesh;
}

// Returns a mesh cut by parallel planes with distances down to 1e-15.
inline Mesh close_cuts(Portable_random& random)
{
  Mesh mesh = hard_base(random);
  cut_badly(mesh, 1e-15, random);
  return mesh;
}

inline Mesh spoilt_frames(Portable_random& random)
{
  Mesh mesh = frame(random_size(2, 4, random), log_uniform(1e-2, 1, random));
  add_extreme_needles(mesh, 0.1, random);
  add_near_vertices(mesh, 0.2, random);
  return mesh;
}

struct Hard_family
{
  const char* name;
  Mesh (*make)(Portable_random&);
};

constexpr std::array<Hard_family, 12> hard_families{{{"extreme needles", extreme_needles},
                                                     {"extreme caps", extreme_caps},
                                                     {"near vertices", near_vertices},
                                                     {"almost collapsed", almost_collapsed},
                                                     {"flat faces", flat_faces},
                                                     {"cascades", cascades},
                                                     {"spoilt twice", spoilt_twice},
                                                     {"sliced polygons", sliced_polygons},
                                                     {"saw-tooth strips", saw_tooth_strips},
                                                     {"stretched and spoilt", stretched_and_spoilt},
                                                     {"close cuts", close_cuts},
                                                     {"spoilt frames", spoilt_frames}}};

// Returns a mesh of one family after the other, with the name of the family. Half of the meshes are
// turned in space, if all neighbors remain apart.
inline Named_mesh hard_mesh(std::uint64_t seed)
{
  Portable_random random(seed);
  const Hard_family& family = hard_families[seed % hard_families.size()];
  const Mesh mesh = family.make(random);
  return {family.name, toss(random) ? turned_apart(mesh, random) : mesh};
}

// Calls `check(mesh)` for hard meshes of every family; those with seeds of 960,000 and more have
// vertices nearer to each other than the rounding of the lengths around them, where an edge turns
// by any angle.
template <typename Check>
void for_each_hard_mesh(const Check& check)
{
  std::vector<std::uint64_t> seeds{960011, 960023, 960028, 960032, 960033,
                                   960044, 960045, 960056, 960057};
  for(std::uint64_t seed = 0; seed < 2 * hard_families.size(); ++seed)
    seeds.push_back(seed);
  for(std::uint64_t seed : seeds) {
    SCOPED_TRACE(seed);
    check(hard_mesh(seed).mesh);
  }
}

} // namespace Test_surfaces

#endif // INTRINSIC_TRIANGULATIONS_TEST_HARD_MESHES_H
