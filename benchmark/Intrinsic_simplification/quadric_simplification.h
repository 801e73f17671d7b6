// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_SIMPLIFICATION_BENCHMARK_QUADRIC_SIMPLIFICATION_H
#define INTRINSIC_SIMPLIFICATION_BENCHMARK_QUADRIC_SIMPLIFICATION_H

// This file simplifies in space, for comparison with the intrinsic simplification.

#include "surfaces.h"

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Polygon_mesh_processing/locate.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/GarlandHeckbert_policies.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>
#include <CGAL/version.h>
#if CGAL_VERSION_NR >= 1060000000
#include <CGAL/AABB_traits_3.h>
#else
#include <CGAL/AABB_traits.h>
#endif

#include <Eigen/SparseCore>

#include <cstddef>
#include <vector>

typedef CGAL::AABB_face_graph_triangle_primitive<Mesh> Tree_primitive;
#if CGAL_VERSION_NR >= 1060000000
typedef CGAL::AABB_traits_3<Kernel, Tree_primitive> Tree_traits;
#else
typedef CGAL::AABB_traits<Kernel, Tree_primitive> Tree_traits;
#endif

// Stops edge collapses at a number of vertices.
struct Vertex_count_stop
{
  std::size_t number_of_vertices;

  template <typename Cost, typename Profile>
  bool operator()(const Cost&, const Profile& profile, std::size_t, std::size_t) const
  {
    return profile.surface_mesh().number_of_vertices() <= number_of_vertices;
  }
};

// Returns a simplification by the edge collapses with the least cost by the quadrics of Garland and
// Heckbert.
inline Mesh collapsed(Mesh mesh, std::size_t number_of_vertices)
{
  namespace SMS = CGAL::Surface_mesh_simplification;
  const SMS::GarlandHeckbert_plane_policies<Mesh, Kernel> policies(mesh);
  SMS::edge_collapse(
    mesh, Vertex_count_stop{number_of_vertices},
    CGAL::parameters::get_cost(policies.get_cost()).get_placement(policies.get_placement()));
  mesh.collect_garbage();
  return mesh;
}

// Returns the matrix that maps values on a mesh to the vertices of another mesh, at the closest
// points.
inline Eigen::SparseMatrix<double> closest_point_matrix(const Mesh& from, const Mesh& to)
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  CGAL::AABB_tree<Tree_traits> tree(faces(from).first, faces(from).second, from);
  std::vector<Eigen::Triplet<double>> entries;
  for(Mesh::Vertex_index v : to.vertices()) {
    const auto place = PMP::locate_with_AABB_tree(to.point(v), tree, from);
    Mesh::Halfedge_index h = from.halfedge(place.first);
    for(std::size_t n = 0; n < 3; ++n, h = from.next(h))
      entries.emplace_back(int(v), int(from.source(h)), place.second[n]);
  }
  Eigen::SparseMatrix<double> result(int(to.number_of_vertices()), int(from.number_of_vertices()));
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

#endif // INTRINSIC_SIMPLIFICATION_BENCHMARK_QUADRIC_SIMPLIFICATION_H
