// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_MESH_COMPONENTS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_MESH_COMPONENTS_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>

#include <boost/pending/disjoint_sets.hpp>

#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsBlocks
/// numbers the connected components of a surface in the order of their first vertices. An isolated
/// (or removed) vertex is a component of its own.
class Mesh_components
{
public:
  /// finds the components of `mesh`. Complexity: linear.
  explicit Mesh_components(const Delta_complex& mesh) : m_component(mesh.num_vertices())
  {
    constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();
    boost::disjoint_sets_with_storage<> sets(mesh.num_vertices());
    for(Edge_index e : mesh.edges())
      sets.union_set(mesh.vertex(e, 0).idx(), mesh.vertex(e, 1).idx());
    std::vector<std::size_t> number(mesh.num_vertices(), none); // of each representative
    for(std::size_t v = 0; v < number.size(); ++v) {
      std::size_t& n = number[sets.find_set(v)];
      m_component[v] = n == none ? n = m_size++ : n;
    }
  }

  /// returns the number of components.
  std::size_t size() const { return m_size; }

  /// returns the component of the vertex with index `v`.
  std::size_t operator[](std::size_t v) const { return m_component[v]; }

private:
  std::vector<std::size_t> m_component;
  std::size_t m_size = 0;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_MESH_COMPONENTS_H
