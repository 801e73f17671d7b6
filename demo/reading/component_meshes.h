// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_COMPONENT_MESHES_H
#define INTRINSIC_COMPONENT_MESHES_H

#include "reading/Polygon_soup.h"

#include <cstddef>
#include <vector>

// Some faces of a mesh as a mesh of its own, and the elements of the first that its elements are.
struct Component_mesh
{
  Mesh mesh;
  std::vector<Mesh::Vertex_index> vertices;
  std::vector<Mesh::Edge_index> edges;
  std::vector<Mesh::Face_index> faces;

  Mesh::Vertex_index parent(Mesh::Vertex_index v) const { return vertices[v]; }
  Mesh::Edge_index parent(Mesh::Edge_index e) const { return edges[e]; }
  Mesh::Face_index parent(Mesh::Face_index f) const { return faces[f]; }
};

// The faces of each connected component, in the order of their first faces; vertices without faces
// are in none.
std::vector<std::vector<Mesh::Face_index>> component_faces(const Mesh& mesh);

// Their vertices come in the order that they have in `mesh`. Complexity: linear in the faces.
Component_mesh component_mesh(const Mesh& mesh, std::vector<Mesh::Face_index> faces);

// As `component_mesh()`, but all vertices stay with their indices, some without faces.
Component_mesh with_all_vertices(const Mesh& mesh, std::vector<Mesh::Face_index> faces);

// The first of those with the greatest area.
std::size_t index_of_largest(const std::vector<std::vector<Mesh::Face_index>>& components,
                             const Mesh& mesh);

#endif // INTRINSIC_COMPONENT_MESHES_H
