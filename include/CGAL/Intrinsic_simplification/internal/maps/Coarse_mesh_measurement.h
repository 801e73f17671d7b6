// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_MAPS_COARSE_MESH_MEASUREMENT_H
#define CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_MAPS_COARSE_MESH_MEASUREMENT_H

#include <CGAL/license/Intrinsic_simplification.h>

#include <CGAL/Intrinsic_simplification/Surface_map.h>

#include <CGAL/AABB_tree.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/version.h>
#if CGAL_VERSION_NR >= 1060000000
#include <CGAL/AABB_traits_3.h>
#include <CGAL/AABB_triangle_primitive_3.h>
#else
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_triangle_primitive.h>
#endif

#include <boost/iterator/function_output_iterator.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Intrinsic_simplification::internal {

typedef Exact_predicates_inexact_constructions_kernel Space;
typedef Surface_mesh<Space::Point_3> Space_mesh;

inline Space::Triangle_3 triangle(Face_index f, const Space_mesh& mesh)
{
  const Halfedge_index h = mesh.halfedge(f);
  return {mesh.point(mesh.source(h)), mesh.point(mesh.target(h)),
          mesh.point(mesh.target(mesh.next(h)))};
}

// Returns the faces whose corners are not collinear.
inline std::vector<Face_index> faces_with_area(const Space_mesh& mesh)
{
  std::vector<Face_index> result;
  for(Face_index f : mesh.faces())
    if(!triangle(f, mesh).is_degenerate())
      result.push_back(f);
  return result;
}

// Computes the distance of points from a mesh.
class Distance_from_mesh
{
  typedef std::vector<Space::Triangle_3> Triangles;
#if CGAL_VERSION_NR >= 1060000000
  typedef AABB_traits_3<Space, AABB_triangle_primitive_3<Space, Triangles::const_iterator>> Traits;
#else
  typedef AABB_traits<Space, AABB_triangle_primitive<Space, Triangles::const_iterator>> Traits;
#endif

public:
  Distance_from_mesh(const std::vector<Face_index>& faces, const Space_mesh& mesh)
  {
    for(Face_index f : faces)
      m_triangles.push_back(triangle(f, mesh));
    m_tree.rebuild(m_triangles.begin(), m_triangles.end());
    if(!m_triangles.empty())
      m_tree.accelerate_distance_queries();
  }

  Distance_from_mesh(const Distance_from_mesh&) = delete;
  Distance_from_mesh& operator=(const Distance_from_mesh&) = delete;

  // Returns the distance of `p`, or zero if the mesh has no area.
  double operator()(const Space::Point_3& p) const
  {
    return m_triangles.empty() ? 0 : std::sqrt(m_tree.squared_distance(p));
  }

private:
  Triangles m_triangles;
  AABB_tree<Traits> m_tree;
};

// Compares a coarse mesh in space with the fine mesh that it approximates.
class Coarse_mesh_measurement
{
public:
  Coarse_mesh_measurement(const Surface_map& map, const Space_mesh& fine, const Space_mesh& coarse)
    : m_map(map),
      m_fine(fine),
      m_coarse(coarse),
      m_fine_faces(faces_with_area(fine)),
      m_coarse_faces(faces_with_area(coarse))
  {}

  std::size_t number_of_degenerate_faces() const
  {
    return m_coarse.number_of_faces() - m_coarse_faces.size();
  }

  // Returns the greatest distance of a vertex of the fine mesh from the coarse mesh.
  double distance_to_coarse() const
  {
    const Distance_from_mesh distance(m_coarse_faces, m_coarse);
    double result = 0;
    for(Vertex_index v : m_fine.vertices())
      if(!m_fine.is_isolated(v))
        result = (std::max)(result, distance(m_fine.point(v)));
    return result;
  }

  // Returns the greatest distance of the midpoint of an edge or face of the coarse mesh from the
  // fine mesh.
  double distance_to_fine() const
  {
    const Distance_from_mesh distance(m_fine_faces, m_fine);
    double result = 0;
    for(Edge_index e : m_coarse.edges())
      result = (std::max)(result, distance(CGAL::midpoint(m_coarse.point(m_coarse.vertex(e, 0)),
                                                          m_coarse.point(m_coarse.vertex(e, 1)))));
    for(Face_index f : m_coarse_faces) {
      const Space::Triangle_3 t = triangle(f, m_coarse);
      result = (std::max)(result, distance(CGAL::centroid(t)));
    }
    return result;
  }

  // Returns the number of flipped coarse faces. Fine faces belong to the coarse face to which their
  // barycenters are mapped. A coarse face is flipped if its normal and the sum of the normals of
  // its fine faces point to different sides. A coarse face without fine faces is compared with the
  // fine face at its barycenter.
  std::size_t number_of_flipped_faces() const
  {
    std::vector<Space::Vector_3> normal(m_coarse.number_of_faces(), NULL_VECTOR);
    std::vector<char> has_normal(m_coarse.number_of_faces(), 0);
    for(Face_index f : m_fine_faces) {
      const Face_index image = m_map.to_coarse(middle(f)).first;
      normal[image.idx()] += normal_of(f, m_fine);
      has_normal[image.idx()] = 1;
    }
    std::size_t result = 0;
    for(Face_index f : m_coarse_faces) {
      if(!has_normal[f.idx()])
        normal[f.idx()] = normal_of(m_map.to_fine(middle(f)).first, m_fine);
      result += normal[f.idx()] * normal_of(f, m_coarse) < 0 ? 1 : 0;
    }
    return result;
  }

  // Returns the number of pairs of faces that intersect outside of their common vertices and edges.
  std::size_t number_of_self_intersections() const
  {
    std::size_t result = 0;
    Polygon_mesh_processing::self_intersections(
      m_coarse_faces, m_coarse,
      boost::make_function_output_iterator([&](const auto&) { ++result; }));
    return result;
  }

private:
  static Surface_map::Location middle(Face_index f) { return {f, {1. / 3, 1. / 3, 1. / 3}}; }

  // Returns the normal, whose length is twice the area.
  static Space::Vector_3 normal_of(Face_index f, const Space_mesh& mesh)
  {
    const Space::Triangle_3 t = triangle(f, mesh);
    return CGAL::cross_product(t[1] - t[0], t[2] - t[0]);
  }

  const Surface_map& m_map;
  const Space_mesh &m_fine, &m_coarse;
  std::vector<Face_index> m_fine_faces, m_coarse_faces; // those with area
};

} // namespace CGAL::Intrinsic_simplification::internal

#endif // CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_MAPS_COARSE_MESH_MEASUREMENT_H
