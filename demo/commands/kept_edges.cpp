// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands/kept_edges.h"

#include <CGAL/number_type_config.h>

#include <cmath>
#include <vector>

namespace {

using Vector = Kernel::Vector_3;

// Returns the normal of the face of `h`, of any length.
Vector normal(Mesh::Halfedge_index h, const Mesh& mesh)
{
  const Point& p = mesh.point(mesh.source(h));
  const Point& q = mesh.point(mesh.target(h));
  return CGAL::cross_product(q - p, mesh.point(mesh.target(mesh.next(h))) - q);
}

// Returns the angle, or zero if a vector is zero.
double angle_in_degrees(const Vector& a, const Vector& b)
{
  const double sine = std::sqrt(CGAL::cross_product(a, b).squared_length());
  return std::atan2(sine, a * b) * 180 / CGAL_PI;
}

// Returns the numbers of the coordinates at the sources of halfedges.
std::vector<Polygons::Index> numbers_at_sources(const Corner_data& data, const Mesh& mesh)
{
  std::vector<Polygons::Index> result(mesh.number_of_halfedges());
  for(const Mesh::Face_index f : mesh.faces()) {
    const auto* number = data.polygons[f].begin();
    for(const Mesh::Halfedge_index h : mesh.halfedges_around_face(mesh.halfedge(f)))
      result[h] = *number++;
  }
  return result;
}

} // namespace

void mark_sharp_edges(const Mesh& mesh, double degrees, Edge_bool_map is_kept)
{
  for(const Mesh::Edge_index e : mesh.edges()) {
    const Mesh::Halfedge_index h = mesh.halfedge(e);
    if(!mesh.is_border(e) &&
       angle_in_degrees(normal(h, mesh), normal(mesh.opposite(h), mesh)) >= degrees)
      is_kept[e] = true;
  }
}

void mark_seams(const Mesh_data& data, const Mesh& mesh, Edge_bool_map is_kept)
{
  for(const Corner_data& texture : data.corners) {
    if(!is_texture(texture))
      continue;
    const std::vector<Polygons::Index> number = numbers_at_sources(texture, mesh);
    for(const Mesh::Edge_index e : mesh.edges()) {
      const Mesh::Halfedge_index h = mesh.halfedge(e), o = mesh.opposite(h);
      if(!mesh.is_border(e) &&
         (number[h] != number[mesh.next(o)] || number[o] != number[mesh.next(h)]))
        is_kept[e] = true;
    }
  }
}
