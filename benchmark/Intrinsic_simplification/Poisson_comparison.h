// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_SIMPLIFICATION_BENCHMARK_POISSON_COMPARISON_H
#define INTRINSIC_SIMPLIFICATION_BENCHMARK_POISSON_COMPARISON_H

#include "surfaces.h"

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/version.h>
#if CGAL_VERSION_NR >= 1060000000
#include <CGAL/AABB_traits_3.h>
#else
#include <CGAL/AABB_traits.h>
#endif
#include <CGAL/Intrinsic_simplification/Evolving_surface.h>
#include <CGAL/Intrinsic_simplification/Surface_level.h>
#include <CGAL/Intrinsic_simplification/Surface_map.h>
#include <CGAL/Intrinsic_simplification/prolongation.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/operators.h>
#include <CGAL/Intrinsic_triangulations/poisson.h>
#include <CGAL/Polygon_mesh_processing/locate.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/GarlandHeckbert_policies.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>

#include <Eigen/SparseCore>

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace IS = CGAL::Intrinsic_simplification;
namespace IT = CGAL::Intrinsic_triangulations;

typedef CGAL::AABB_face_graph_triangle_primitive<Mesh> Tree_primitive;
#if CGAL_VERSION_NR >= 1060000000
typedef CGAL::AABB_traits_3<Kernel, Tree_primitive> Tree_traits;
#else
typedef CGAL::AABB_traits<Kernel, Tree_primitive> Tree_traits;
#endif

// How well a Poisson equation on a surface is solved on a coarse one: L u = M (z - mean z), with z the third
// coordinate, L the cotan Laplacian and M the lumped mass. A prolongation P takes coarse values to fine ones; the
// coarse right-hand side is P^T M (z - mean z). Solutions have mean zero, and errors are relative, in the norm of M.
class Poisson_comparison
{
public:
  explicit Poisson_comparison(const Mesh& mesh)
    : m_fine(IS::Evolving_surface(mesh)),
      m_mass(IT::lumped_mass_matrix(m_fine.mesh(), m_fine.length_map()).diagonal()),
      m_moments(moments_of_height(mesh)),
      m_solution(solve(m_fine, m_moments))
  {}

  double error(const IS::Surface_level& coarse,
               const Eigen::SparseMatrix<double>& prolongation) const
  {
    try {
      const Eigen::VectorXd values =
        prolongation * solve(coarse, prolongation.transpose() * m_moments);
      return norm(without_mean(values) - m_solution) / norm(m_solution);
    } catch(const IT::Numerical_error&) {
      return std::numeric_limits<double>::quiet_NaN(); // a face without area
    }
  }

private:
  static Eigen::VectorXd solve(const IS::Surface_level& level, const Eigen::VectorXd& moments)
  {
    return IT::Poisson_solver<>(level.mesh(), level.length_map()).solve(moments);
  }

  Eigen::VectorXd moments_of_height(const Mesh& mesh) const
  {
    Eigen::VectorXd height(m_mass.size());
    for(Mesh::Vertex_index v : mesh.vertices())
      height[v] = mesh.point(v).z();
    return m_mass.cwiseProduct(without_mean(height));
  }

  Eigen::VectorXd without_mean(const Eigen::VectorXd& values) const
  {
    return (values.array() - m_mass.dot(values) / m_mass.sum()).matrix();
  }

  double norm(const Eigen::VectorXd& values) const
  {
    return std::sqrt(values.cwiseAbs2().dot(m_mass));
  }

  IS::Surface_level m_fine;
  Eigen::VectorXd m_mass, m_moments, m_solution;
};

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

// A simplification by the edge collapses that cost least by the quadrics of Garland and Heckbert.
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

// Takes values on a mesh to the vertices of another, at the closest points.
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

#endif // INTRINSIC_SIMPLIFICATION_BENCHMARK_POISSON_COMPARISON_H
