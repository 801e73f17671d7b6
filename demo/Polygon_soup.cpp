// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Polygon_soup.h"

#include <CGAL/boost/graph/Euler_operations.h>

Mesh mesh_of(const Polygon_soup& soup)
{
  Mesh mesh;
  for(const Point& p : soup.points)
    mesh.add_vertex(p);
  std::vector<std::vector<Mesh::Vertex_index>> faces;
  faces.reserve(soup.polygons.size());
  for(const std::vector<std::size_t>& polygon : soup.polygons) {
    faces.emplace_back();
    for(const std::size_t i : polygon)
      faces.back().emplace_back(static_cast<Mesh::size_type>(i));
  }
  CGAL::Euler::add_faces(faces, mesh);
  return mesh;
}
