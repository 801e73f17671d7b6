// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DISCRETE_CONFORMAL_MAPS_BENCHMARK_RANDOM_SPHERES_H
#define DISCRETE_CONFORMAL_MAPS_BENCHMARK_RANDOM_SPHERES_H

// Generates random triangulations of the sphere. Only the connectivity of their meshes counts.

#include <CGAL/Random.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>

#include <array>
#include <cstddef>

typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Mesh;

inline constexpr std::array<const char*, 3> random_sphere_names{
  "vertices put into random faces", "a fifth of its edges flipped", "flips of random edges"};

template <typename Random>
Mesh::Halfedge_index random_halfedge(const Mesh& mesh, Random& random)
{
  return Mesh::Halfedge_index(
    static_cast<Mesh::size_type>(random.get_int(0, static_cast<int>(mesh.number_of_halfedges()))));
}

// Tries `tries` times to flip a random edge, and keeps the triangulation simplicial.
inline void flip_edges(Mesh& mesh, std::size_t tries, CGAL::Random& random)
{
  for(std::size_t i = 0; i < tries; ++i) {
    const Mesh::Halfedge_index h = random_halfedge(mesh, random);
    const auto a = mesh.target(mesh.next(h)), b = mesh.target(mesh.next(mesh.opposite(h)));
    if(a != b && !mesh.halfedge(a, b).is_valid())
      CGAL::Euler::flip_edge(h, mesh);
  }
}

// Starts with a tetrahedron, and inserts vertices into random faces: circles shrink fast. Then
// flips no edge, tries a fifth of the edges, or ten times all edges.
inline Mesh random_sphere(std::size_t kind, std::size_t n, CGAL::Random& random)
{
  Mesh mesh;
  CGAL::make_tetrahedron(CGAL::Simple_cartesian<double>::Point_3(0, 0, 0), {1, 0, 0}, {0, 1, 0},
                         {0, 0, 1}, mesh);
  while(mesh.number_of_vertices() < n)
    CGAL::Euler::add_center_vertex(random_halfedge(mesh, random), mesh);
  const std::size_t edges = mesh.number_of_edges();
  flip_edges(mesh, kind == 0 ? 0 : kind == 1 ? edges / 5 : 10 * edges, random);
  return mesh;
}

#endif // DISCRETE_CONFORMAL_MAPS_BENCHMARK_RANDOM_SPHERES_H
