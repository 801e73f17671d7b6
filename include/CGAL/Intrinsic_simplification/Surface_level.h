// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_SURFACE_LEVEL_H
#define CGAL_INTRINSIC_SIMPLIFICATION_SURFACE_LEVEL_H

#include <CGAL/license/Intrinsic_simplification.h>

#include <CGAL/Intrinsic_simplification/Evolving_surface.h>
#include <CGAL/Intrinsic_simplification/Surface_history.h>
#include <CGAL/Intrinsic_triangulations/copy_input.h>

#include <algorithm>
#include <vector>

namespace CGAL::Intrinsic_simplification {

/// \ingroup PkgIntrinsicSimplificationRef
/// a copy of an evolving surface at one time. Indices of its elements have no gaps, and have the
/// order of the evolving surface. Several levels make a hierarchy.
/// \cgalModels `IntrinsicSurface`
class Surface_level
{
public:
  /// the type of the map of edge lengths.
  typedef Intrinsic_surface::Length_map Length_map;

  /// copies the current state. Complexity: linear in the greatest index of an element.
  explicit Surface_level(const Evolving_surface& surface)
    : Surface_level(surface, surface.history().size())
  {}

  /// copies a surface. Complexity: linear in the greatest index of an element.
  /// \param surface a model of `IntrinsicSurface`; removed elements leave gaps in the indices
  /// \param time the number of operations before it
  template <typename Surface>
  Surface_level(const Surface& surface, Surface_history::Time time) : m_time(time)
  {
    namespace IT = Intrinsic_triangulations;
    const Delta_complex& mesh = surface.mesh();
    m_mesh.resize(mesh.number_of_vertices(), mesh.number_of_edges(), mesh.number_of_faces());
    IT::with_numbering(mesh, [&](const auto& numbering) {
      IT::internal::copy_connectivity(mesh, numbering, m_mesh);
    });
    m_surface_vertex.assign(mesh.vertices().begin(), mesh.vertices().end());
    m_surface_face.assign(mesh.faces().begin(), mesh.faces().end());
    for(Edge_index e : mesh.edges())
      m_length.push_back(get(surface.length_map(), e));
  }

  /// returns the number of operations before this level.
  Surface_history::Time time() const { return m_time; }

  /// returns the connectivity.
  const Delta_complex& mesh() const { return m_mesh; }

  /// returns the lengths of the edges.
  Length_map length_map() const { return Length_map(m_length.data()); }

  /// returns an intrinsic triangulation with \f$T_1 = T_2\f$. Complexity: linear.
  Evolving_surface::Triangulation triangulation() const
  {
    return Evolving_surface::Triangulation(
      m_mesh, Intrinsic_triangulations::parameters::edge_length_map(length_map()));
  }

  /// returns the index of the vertex `v` of this level in the evolving surface, and in the input.
  Vertex_index surface_vertex(Vertex_index v) const { return m_surface_vertex[v]; }

  /// returns the index of the face `f` of this level in the evolving surface.
  Face_index surface_face(Face_index f) const { return m_surface_face[f]; }

  /// returns one more than the greatest index of a face in the evolving surface at this time and
  /// later.
  Delta_complex::size_type number_of_surface_faces() const
  {
    return m_surface_face.empty() ? 0 : m_surface_face.back().idx() + 1;
  }

  /// returns the index in this level of the vertex `v` of the evolving surface; null if it has been
  /// removed before. Complexity: logarithmic.
  Vertex_index level_vertex(Vertex_index v) const { return find(m_surface_vertex, v); }

  /// returns the index in this level of the face `f` of the evolving surface; null if it has been
  /// removed before. Complexity: logarithmic.
  Face_index level_face(Face_index f) const { return find(m_surface_face, f); }

private:
  template <typename Index>
  static Index find(const std::vector<Index>& numbers, Index i)
  {
    const auto place = std::lower_bound(numbers.begin(), numbers.end(), i);
    return place != numbers.end() && *place == i
             ? Index(static_cast<typename Index::size_type>(place - numbers.begin()))
             : Index();
  }

  Surface_history::Time m_time;
  Delta_complex m_mesh;
  std::vector<double> m_length;
  std::vector<Vertex_index> m_surface_vertex; // ascending
  std::vector<Face_index> m_surface_face;     // ascending
};

} // namespace CGAL::Intrinsic_simplification

#endif // CGAL_INTRINSIC_SIMPLIFICATION_SURFACE_LEVEL_H
