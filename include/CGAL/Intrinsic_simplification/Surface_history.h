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

#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <vector>

namespace CGAL::Intrinsic_simplification {

/// \ingroup PkgIntrinsicSimplificationRef
/// the operations that have changed a surface, in their order (Section 5.2).
///
/// They determine for each point where it is afterwards, and where it was before. Memory: 32 bytes
/// for each operation, and 4 for each corner of a scaling.
class Surface_history
{
public:
  /// a point in time: the number of operations that have been done.
  typedef std::size_t Time;

  /// returns the number of operations.
  Time size() const { return m_operations.size(); }

  /// returns the operation with index `t`.
  const Surface_operation& operator[](Time t) const { return m_operations[t]; }

  /// returns the corners of the faces that a flip, a removal or an insertion changes.
  template <typename Operation>
  static const auto& corners(const Operation& operation)
  {
    return operation.corners;
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
  /// \param has_corners whether the scaling has an effect: with `false`, it gets no corners
  /// \param mesh the mesh
  /// \throws Intrinsic_triangulations::Overflow_error if there are more corners than can be
  ///   indexed
  void add_scaling(Vertex_index v, double factor, bool has_corners, const Delta_complex& mesh)
  {
    const std::size_t first = m_corners.size();
    if(has_corners)
      for_each_spoke(v, mesh, [&](Halfedge_index h) {
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
  /// \param s the place of the crossing on `h`
  /// \param t the place of the crossing on `h` after it has been turned
  void add_flip(Halfedge_index h, const Delta_complex& mesh, double s, double t)
  {
    m_operations.emplace_back(
      Flip{h, {Face_corner(h, mesh), Face_corner(opposite(h), mesh)}, s, t});
  }

  /// appends the removal of an interior vertex of degree three, which is about to happen.
  /// \param a its first spoke
  /// \param mesh the mesh
  /// \param w_a,w_b the barycentric coordinates of the vertex that belong to the targets of `a` and
  ///   the next spoke
  void add_removal(Halfedge_index a, const Delta_complex& mesh, double w_a, double w_b)
  {
    const Halfedge_index b = next_spoke(a, mesh), c = next_spoke(b, mesh);
    m_operations.emplace_back(
      Removal{{Face_corner(a, mesh), Face_corner(b, mesh), Face_corner(c, mesh)}, {w_a, w_b}});
  }

  /// appends the removal of a boundary vertex of degree three, which is about to happen.
  /// \param a its first spoke
  /// \param mesh the mesh
  /// \param w_a the barycentric coordinate of the vertex that belongs to the target of `a`
  void add_border_removal(Halfedge_index a, const Delta_complex& mesh, double w_a)
  {
    m_operations.emplace_back(
      Border_removal{{Face_corner(a, mesh), Face_corner(next_spoke(a, mesh), mesh)}, w_a});
  }

  /// appends the insertion of a vertex into a face, which has just happened.
  /// \param a the spoke to the first corner of the face as it was
  /// \param mesh the mesh
  /// \param w_a,w_b the barycentric coordinates of the vertex that belong to the targets of `a` and
  ///   the next spoke
  void add_insertion(Halfedge_index a, const Delta_complex& mesh, double w_a, double w_b)
  {
    const Halfedge_index b = next_spoke(a, mesh), c = next_spoke(b, mesh);
    add_insertion(
      Insertion{{Face_corner(a, mesh), Face_corner(b, mesh), Face_corner(c, mesh)}, {w_a, w_b}});
  }

  /// appends the insertion of a vertex into a boundary edge, which has just happened.
  /// \param a the first spoke of the vertex
  /// \param mesh the mesh
  /// \param whole the corner of the face as it was that is the target of `a`
  /// \param w_a the barycentric coordinate of the vertex that belongs to this corner
  void add_border_insertion(Halfedge_index a, const Delta_complex& mesh, Face_corner whole,
                            double w_a)
  {
    add_insertion(
      Border_insertion{{Face_corner(a, mesh), Face_corner(next_spoke(a, mesh), mesh)}, whole, w_a});
  }

  /// returns one more than the greatest index of a face that an insertion has made, or 0.
  std::size_t end_of_inserted_faces() const { return m_end_of_inserted_faces; }

  /// discards all operations but the first `t`.
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
  template <typename Operation>
  void add_insertion(const Operation& operation)
  {
    m_operations.emplace_back(operation);
    for(const Face_corner& c : operation.corners)
      m_end_of_inserted_faces = (std::max)(m_end_of_inserted_faces, std::size_t(c.face()) + 1);
  }

  std::vector<Surface_operation> m_operations;
  std::vector<Face_corner> m_corners; // of all scalings
  std::size_t m_end_of_inserted_faces = 0;
};

} // namespace CGAL::Intrinsic_simplification

#endif // CGAL_INTRINSIC_SIMPLIFICATION_SURFACE_HISTORY_H
