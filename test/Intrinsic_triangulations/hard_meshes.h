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
bool is_free(const Point& p, const Mesh& mesh);

bool all_are_apart(const Mesh& mesh);

// Inserts a vertex on the edge of `h` if its position is free. Returns the halfedge from the source
// of `h` to it.
Halfedge_index split_edge_apart(Halfedge_index h, double t, Mesh& mesh);

// Inserts a vertex at `p` into the face of `h` if its position is free.
void split_face_apart(Halfedge_index h, const Point& p, Mesh& mesh);

const Point& apex(Halfedge_index h, const Mesh& mesh);

// Rotates and rounds the mesh, unless vertices then coincide.
Mesh turned_apart(const Mesh& mesh, Portable_random& random);

Mesh stretched_apart(const Mesh& mesh, double factor);

// ---- Surfaces to spoil ----

// Returns a mesh with or without boundary, of genus 0, 1 or 2.
Mesh hard_base(Portable_random& random);

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

std::vector<std::size_t> consecutive(std::size_t first, std::size_t n);

// Returns a convex polygon with `n` points on each of its sides, cut into triangles at random, or a
// prism over it. If three corners are on a side, a triangle has no area.
Mesh sliced_polygon(std::size_t sides, std::size_t n, double height, Portable_random& random);

// Returns rows of points at steps between 1e-14 and 1, every second column shifted by `tooth`. The
// last column is joined to the first if it is closed.
Mesh saw_teeth(std::size_t columns, std::size_t rows, double tooth, bool is_closed,
               Portable_random& random);

// ---- Ways to spoil them ----

void add_extreme_needles(Mesh& mesh, double part, Portable_random& random);

// Returns a side of the face that is not on the boundary, on which a vertex must not lie.
Halfedge_index inner_side(Face_index f, const Mesh& mesh);

void add_extreme_caps(Mesh& mesh, double part, Portable_random& random);

// Adds vertices in faces, as near to a corner as rounding allows.
void add_near_vertices(Mesh& mesh, double part, Portable_random& random);

// Moves vertices next to a neighbor, with all their faces.
void collapse_almost(Mesh& mesh, double part, Portable_random& random);

// Adds vertices in the middle of a side of their face. The face has zero area if coordinates need
// no rounding.
void add_flat_faces(Mesh& mesh, double part, Portable_random& random);

// Adds vertices on an edge that converge to its source.
void add_cascades(Mesh& mesh, double part, Portable_random& random);

// ---- Families ----

Mesh spoilt(void (*spoil)(Mesh&, double, Portable_random&), double least_part, double greatest_part,
            Portable_random& random);

Mesh extreme_needles(Portable_random& random);

Mesh extreme_caps(Portable_random& random);

Mesh near_vertices(Portable_random& random);

Mesh almost_collapsed(Portable_random& random);

Mesh flat_faces(Portable_random& random);

inline Mesh cascades(Portable_random& random) { return spoilt(add_cascades, 0.01, 0.03, random); }

// Returns a mesh with bad faces that are changed again.
Mesh spoilt_twice(Portable_random& random);

Mesh sliced_polygons(Portable_random& random);

Mesh saw_tooth_strips(Portable_random& random);

Mesh stretched_and_spoilt(Portable_random& random);

// Returns a mesh cut by parallel planes with distances down to 1e-15.
Mesh close_cuts(Portable_random& random);

Mesh spoilt_frames(Portable_random& random);

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
Named_mesh hard_mesh(std::uint64_t seed);

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
