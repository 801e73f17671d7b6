// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_OPERATORS_MESH_COMPONENTS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_OPERATORS_MESH_COMPONENTS_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Numbers the connected components of a surface; an isolated (or removed) vertex is one of its own.
class Mesh_components
{
public:
  explicit Mesh_components(const Delta_complex& mesh)
    : m_parent(mesh.num_vertices()), m_component(mesh.num_vertices())
  {
    std::iota(m_parent.begin(), m_parent.end(), std::size_t(0));
    for(Edge_index e : mesh.edges())
      join(root(mesh.vertex(e, 0).idx()), root(mesh.vertex(e, 1).idx()));
    // a root comes before all others of its component
    for(std::size_t v = 0; v < m_parent.size(); ++v)
      m_component[v] = m_parent[v] == v ? m_size++ : m_component[root(v)];
  }

  // the number of components
  std::size_t size() const { return m_size; }
  // the component of a vertex
  std::size_t operator[](std::size_t v) const { return m_component[v]; }

private:
  std::size_t root(std::size_t v)
  {
    while(m_parent[v] != v)
      v = m_parent[v] = m_parent[m_parent[v]];
    return v;
  }

  void join(std::size_t a, std::size_t b) { m_parent[(std::max)(a, b)] = (std::min)(a, b); }

  std::vector<std::size_t> m_parent;
  std::vector<std::size_t> m_component;
  std::size_t m_size = 0;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_OPERATORS_MESH_COMPONENTS_H
