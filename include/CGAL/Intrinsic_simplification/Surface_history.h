// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_SURFACE_HISTORY_H
#define CGAL_INTRINSIC_SIMPLIFICATION_SURFACE_HISTORY_H

#include <CGAL/license/Intrinsic_simplification.h>

#include <CGAL/Intrinsic_simplification/Intrinsic_surface.h>
#include <CGAL/Intrinsic_simplification/Surface_operation.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>

#include <CGAL/Iterator_range.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <vector>

namespace CGAL::Intrinsic_simplification {

/// \ingroup PkgIntrinsicSimplificationRef
/// the operations that have changed a surface, in their order (Section 5.2).
///
/// They determine the position of each point after and before them. Memory: 32 bytes for each
/// operation, and 4 for each corner of a scaling.
class Surface_history
{
public:
  /// a point in time: the number of operations done so far.
  typedef std::size_t Time;

  /// returns the number of operations.
  Time size() const { return m_operations.size(); }

  /// returns the operation with index `t`.
  const Surface_operation& operator[](Time t) const { return m_operations[t]; }

  /// returns the corners of the faces that a flip changes.
  static const auto& corners(const Flip& flip) { return flip.corners; }

  /// returns the corners of the faces around a vertex that is removed or inserted.
  static Iterator_range<const Face_corner*> corners(const Vertex_change& change)
  {
    return {change.corners.data(), change.corners.data() + (change.is_border ? 2 : 3)};
  }

  /// returns the corners of a scaling of this history.
  Iterator_range<const Face_corner*> corners(const Scaling& scaling) const
  {
    const Face_corner* first = m_corners.data() + scaling.first_corner;
    return {first, first + scaling.number_of_corners};
  }

  /// appends a scaling.
  /// \param v the vertex
  /// \param factor the factor of the barycentric coordinate
  /// \param has_corners whether the scaling has an effect; with `false`, it has no corners
  /// \param mesh the mesh
  /// \throws Intrinsic_triangulations::Overflow_error if there are more corners than can be
  ///   indexed
  void add_scaling(Vertex_index v, double factor, bool has_corners, const Delta_complex& mesh)
  {
    const std::size_t first = m_corners.size();
    if(has_corners)
      for_each_outgoing_halfedge(v, mesh, [&](Halfedge_index h) {
        if(!mesh.is_border(h))
          m_corners.emplace_back(h, mesh);
      });
    if(m_corners.size() > std::numeric_limits<std::uint32_t>::max())
      throw Intrinsic_triangulations::Overflow_error("too many corners for the history");
    m_operations.emplace_back(Scaling{v, static_cast<std::uint32_t>(first),
                                      static_cast<std::uint32_t>(m_corners.size() - first),
                                      factor});
  }

  /// appends the flip of the edge of `h`, which is about to happen.
  /// \param h the halfedge
  /// \param mesh the mesh
  /// \param s the position of the crossing on `h`
  /// \param t the position of the crossing on `h` after it has been turned
  void add_flip(Halfedge_index h, const Delta_complex& mesh, double s, double t)
  {
    m_operations.emplace_back(
      Flip{h, {Face_corner(h, mesh), Face_corner(opposite(h), mesh)}, s, t});
  }

  /// appends the removal of a vertex of degree three, which is about to happen.
  /// \param a its first outgoing halfedge
  /// \param mesh the mesh
  /// \param w_a,w_b the barycentric coordinates of the vertex that belong to the targets of `a` and
  ///   the next outgoing halfedge; the latter is zero on the boundary
  void add_removal(Halfedge_index a, const Delta_complex& mesh, double w_a, double w_b)
  {
    const std::size_t first = mesh.is_border(opposite(a)) ? 1 : 0;
    add_vertex_change(false, a, mesh, Face_corner(mesh.face(a), first), w_a, w_b);
  }

  /// appends the insertion of a vertex of degree three, which has just happened.
  /// \param a its first outgoing halfedge; for an interior vertex, the outgoing halfedge to the
  ///   first corner of the former face
  /// \param mesh the mesh
  /// \param whole the corner of the former face that is the target of `a`
  /// \param w_a,w_b the barycentric coordinates of the vertex that belong to the targets of `a` and
  ///   the next outgoing halfedge; the latter is zero on the boundary
  void add_insertion(Halfedge_index a, const Delta_complex& mesh, Face_corner whole, double w_a,
                     double w_b)
  {
    add_vertex_change(true, a, mesh, whole, w_a, w_b);
  }

  /// returns one more than the greatest index of a face from an insertion, or 0.
  std::size_t end_of_inserted_faces() const { return m_end_of_inserted_faces; }

  /// discards all operations except the first `t`.
  void truncate(Time t)
  {
    for(; size() > t; m_operations.pop_back())
      m_operations.back().visit([this](const auto& o) {
        if constexpr(std::is_same_v<decltype(o), const Scaling&>)
          m_corners.resize(o.first_corner);
      });
  }

  /// returns the number of bytes in use.
  std::size_t memory() const
  {
    return m_operations.capacity() * sizeof(Surface_operation) +
           m_corners.capacity() * sizeof(Face_corner);
  }

private:
  void add_vertex_change(bool is_insertion, Halfedge_index a, const Delta_complex& mesh,
                         Face_corner whole, double w_a, double w_b)
  {
    const bool is_border = mesh.is_border(opposite(a));
    const Halfedge_index b = next_around_source(a, mesh);
    const Face_corner third =
      is_border ? Face_corner() : Face_corner(next_around_source(b, mesh), mesh);
    const Vertex_change change{is_insertion,
                               is_border,
                               {Face_corner(a, mesh), Face_corner(b, mesh), third},
                               whole,
                               {w_a, w_b}};
    m_operations.emplace_back(change);
    if(is_insertion)
      for(const Face_corner& c : corners(change))
        m_end_of_inserted_faces = (std::max)(m_end_of_inserted_faces, std::size_t(c.face()) + 1);
  }

  std::vector<Surface_operation> m_operations;
  std::vector<Face_corner> m_corners; // of all scalings
  std::size_t m_end_of_inserted_faces = 0;
};

} // namespace CGAL::Intrinsic_simplification

#endif // CGAL_INTRINSIC_SIMPLIFICATION_SURFACE_HISTORY_H
