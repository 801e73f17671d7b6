// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "reading/component_meshes.h"

#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/measure.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <unordered_map>
#include <utility>

namespace PMP = CGAL::Polygon_mesh_processing;

namespace {

typedef std::vector<Mesh::Face_index> Faces;

// Builds a mesh of faces of another mesh.
class Component_builder
{
public:
  Component_builder(const Mesh& mesh, Faces faces, std::vector<Mesh::Vertex_index> vertices)
    : m_mesh(mesh)
  {
    m_result.faces = std::move(faces);
    m_result.vertices = std::move(vertices);
  }

  Component_mesh build()
  {
    for(const Mesh::Vertex_index v : m_result.vertices)
      m_number.emplace(v, m_result.mesh.add_vertex(m_mesh.point(v)));
    for(const Mesh::Face_index f : m_result.faces)
      add_face(f);
    m_result.edges.resize(m_result.mesh.number_of_edges());
    for(std::size_t i = 0; i < m_result.faces.size(); ++i)
      note_edges(Mesh::Face_index(Mesh::size_type(i)), m_result.faces[i]);
    return std::move(m_result);
  }

private:
  void add_face(Mesh::Face_index f)
  {
    std::vector<Mesh::Vertex_index> corners;
    for(const Mesh::Vertex_index v : m_mesh.vertices_around_face(m_mesh.halfedge(f)))
      corners.push_back(m_number.at(v));
    m_result.mesh.add_face(corners);
  }

  // Records the edges of `face` and `f`, whose halfedges have corresponding targets.
  void note_edges(Mesh::Face_index face, Mesh::Face_index f)
  {
    Mesh::Halfedge_index h = m_result.mesh.halfedge(face);
    for(const Mesh::Halfedge_index other : m_mesh.halfedges_around_face(m_mesh.halfedge(f))) {
      while(m_result.mesh.target(h) != m_number.at(m_mesh.target(other)))
        h = m_result.mesh.next(h);
      m_result.edges[m_result.mesh.edge(h)] = m_mesh.edge(other);
    }
  }

  const Mesh& m_mesh;
  std::unordered_map<Mesh::Vertex_index, Mesh::Vertex_index> m_number;
  Component_mesh m_result;
};

} // namespace

std::vector<Faces> component_faces(const Mesh& mesh)
{
  std::vector<std::size_t> component(mesh.number_of_faces());
  const std::size_t n = PMP::connected_components(
    mesh, boost::make_iterator_property_map(component.begin(), get(boost::face_index, mesh)));
  std::vector<Faces> result(n);
  for(const Mesh::Face_index f : mesh.faces())
    result[component[f]].push_back(f);
  std::sort(result.begin(), result.end(),
            [](const Faces& a, const Faces& b) { return a.front() < b.front(); });
  return result;
}

Component_mesh component_mesh(const Mesh& mesh, Faces faces)
{
  std::vector<Mesh::Vertex_index> vertices;
  for(const Mesh::Face_index f : faces)
    for(const Mesh::Vertex_index v : mesh.vertices_around_face(mesh.halfedge(f)))
      vertices.push_back(v);
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return Component_builder(mesh, std::move(faces), std::move(vertices)).build();
}

Component_mesh with_all_vertices(const Mesh& mesh, Faces faces)
{
  return Component_builder(mesh, std::move(faces), {mesh.vertices().begin(), mesh.vertices().end()})
    .build();
}

std::size_t index_of_largest(const std::vector<Faces>& components, const Mesh& mesh)
{
  std::vector<double> areas;
  for(const Faces& faces : components)
    areas.push_back(PMP::area(faces, mesh));
  return std::size_t(std::max_element(areas.begin(), areas.end()) - areas.begin());
}
