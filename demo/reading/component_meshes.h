// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_COMPONENT_MESHES_H
#define INTRINSIC_COMPONENT_MESHES_H

#include "reading/Polygon_soup.h"

#include <cstddef>
#include <vector>

// Stores some faces of a mesh as a separate mesh, and the corresponding elements of the original
// mesh.
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

// Returns the faces of each connected component, in the order of their first faces. Vertices
// without faces are in none.
std::vector<std::vector<Mesh::Face_index>> component_faces(const Mesh& mesh);

// Builds the mesh of some faces. Vertices have the order of `mesh`. Complexity: linear in the
// faces.
Component_mesh component_mesh(const Mesh& mesh, std::vector<Mesh::Face_index> faces);

// Builds the mesh of some faces like `component_mesh()`, but all vertices keep their indices, some
// without faces.
Component_mesh with_all_vertices(const Mesh& mesh, std::vector<Mesh::Face_index> faces);

// Returns the first component with the greatest area.
std::size_t index_of_largest(const std::vector<std::vector<Mesh::Face_index>>& components,
                             const Mesh& mesh);

#endif // INTRINSIC_COMPONENT_MESHES_H
