// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Output_mesh.h"

Output_mesh output_mesh(const Mesh& mesh)
{
  Output_mesh result;
  for(const Mesh::Vertex_index v : mesh.vertices())
    result.points.push_back(mesh.point(v));
  for(const Mesh::Face_index f : mesh.faces()) {
    result.polygons.emplace_back();
    for(const Mesh::Vertex_index v : mesh.vertices_around_face(mesh.halfedge(f)))
      result.polygons.back().push_back(v);
  }
  return result;
}
