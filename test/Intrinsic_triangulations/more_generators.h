// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_TRIANGULATIONS_TEST_MORE_GENERATORS_H
#define INTRINSIC_TRIANGULATIONS_TEST_MORE_GENERATORS_H

#include "generators.h"

#include <CGAL/Intrinsic_triangulations/make_Delaunay.h>

// This file generates pairs of triangulations: surfaces with some flips.
namespace Test_surfaces {

using Triangulation = IT::Intrinsic_triangulation<>;

// ---- Lengths, and random flips ----

double longest_input_edge(const Triangulation& t);

std::vector<double> sorted_lengths(const Triangulation& t);

// Returns the difference of the sum of the two angles at the edge of `h` from pi, at the worse end.
double convexity(const Triangulation& t, Halfedge_index h);

// Flips that keep edges short and triangles fat enough for nine digits to remain.
void flip_at_random(Triangulation& t, std::size_t attempts, unsigned int seed,
                    const std::function<void(Halfedge_index)>& after_flip = {});

// Returns a mesh whose edges have been flipped at random, but no edge that crosses fifty others.
Triangulation with_random_flips(const Mesh& mesh, CGAL::Random& random);

// ---- Near-degenerate meshes ----

// Returns a mesh in which every third vertex is moved next to a neighbor.
Mesh with_near_coincident_vertices(Mesh mesh, double distance, unsigned int seed);

// ---- Flat surfaces ----

// Returns m times n squares of width 1000, each cut in two, with corners moved at random.
Flat_surface flat_grid(std::size_t m, std::size_t n, unsigned int seed);

// Stores T2 over a flat T1, with the exact vectors of its halfedges.
class Flat_triangulation : public IT::Default_flip_visitor
{
public:
  explicit Flat_triangulation(const Flat_surface& surface)
    : m_surface(surface), m_triangulation(triangulation(surface)), m_vector(surface.vector)
  {}

  const Flat_surface& surface() const { return m_surface; }
  const Triangulation& operator*() const { return m_triangulation; }
  const Triangulation* operator->() const { return &m_triangulation; }
  const Vector& input_vector(Halfedge_index h) const { return m_surface.vector[h]; }
  const Vector& vector(Halfedge_index h) const { return m_vector[h]; }

  void flip_at_random(std::size_t attempts, unsigned int seed)
  {
    Test_surfaces::flip_at_random(m_triangulation, attempts, seed,
                                  [this](Halfedge_index h) { after_flip(h); });
  }
  std::size_t make_Delaunay()
  {
    return IT::make_Delaunay(m_triangulation, CGAL::parameters::visitor(std::ref(*this)));
  }

  // The other sides of the triangle determine the new one.
  void after_flip(Halfedge_index h)
  {
    const Delta_complex& mesh = m_triangulation.mesh();
    m_vector[h] = -(m_vector[mesh.next(h)] + m_vector[mesh.prev(h)]);
    m_vector[mesh.opposite(h)] = -m_vector[h];
  }

private:
  Flat_surface m_surface;
  Triangulation m_triangulation;
  std::vector<Vector> m_vector;
};

struct Named_surface
{
  std::string name;
  Flat_surface surface;
};

// Returns surfaces whose faces are fat enough for twelve digits.
std::vector<Named_surface> flat_surfaces();

// ---- Collections ----

struct Named_triangulation
{
  std::string name;
  Triangulation triangulation;
};

// Adds a surface unchanged, Delaunay, and after random flips.
void add_flipped(const std::string& name, const Triangulation& t,
                 std::vector<Named_triangulation>& result);

// Returns surfaces without boundary that are not Delaunay.
std::vector<Named_triangulation> closed_surfaces();

std::vector<Named_triangulation> triangulations();

} // namespace Test_surfaces

#endif // INTRINSIC_TRIANGULATIONS_TEST_MORE_GENERATORS_H
