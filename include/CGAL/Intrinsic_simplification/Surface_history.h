// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_SURFACE_HISTORY_H
#define CGAL_INTRINSIC_SIMPLIFICATION_SURFACE_HISTORY_H

#include <CGAL/license/Intrinsic_simplification.h>

#include <CGAL/Intrinsic_simplification/Flattened_star.h>
#include <CGAL/Intrinsic_simplification/Intrinsic_surface.h>
#include <CGAL/Intrinsic_triangulations/Edge_point.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace Intrinsic_simplification {

/// \ingroup PkgIntrinsicSimplificationRef
/// a change of a surface, with all that is needed to carry points through it, in 32 bytes.
struct Surface_operation
{
  /// what is done.
  enum class Kind : std::uint8_t
  {
    scaling,       ///< lengths at a vertex are multiplied
    flip,          ///< an edge becomes the other diagonal of its two faces
    removal,       ///< three faces around an interior vertex become one
    border_removal ///< two faces at a boundary vertex become one
  };

  Kind kind; ///< what is done
  /// the places of corners in the barycentric coordinates of faces. Flip: of the source and the
  /// target of the halfedge, in the faces on its left and right. Removal: of the vertex in each
  /// face.
  std::array<std::uint8_t, 3> corner;
  /// scaling: the vertex, and the first and number of its corners. Flip: the halfedge, and the
  /// faces on its left and right. Removal: the faces around the vertex, of which the first stays.
  std::array<std::uint32_t, 3> id;
  /// scaling: the factor \f$e^{-u}\f$ of the barycentric coordinate. Flip of \f$ij\f$ to \f$lk\f$:
  /// the places of the crossing on \f$ij\f$ and \f$lk\f$. Removal: the first two barycentric
  /// coordinates of the vertex in the new face.
  std::array<double, 2> x;
};

/// \ingroup PkgIntrinsicSimplificationRef
/// the operations that have changed a surface, in their order (Section 5.2).
///
/// They say of each point where it is afterwards, and before. Memory: 32 bytes for each operation,
/// and 4 for each corner of a scaling.
class Surface_history
{
public:
  /// a point in time: so many operations have been done.
  typedef std::size_t Time;
  /// a corner of a face.
  struct Corner
  {
    Face_index face;    ///< the face
    std::size_t corner; ///< its place in the barycentric coordinates
  };

  /// the number of operations.
  Time size() const { return m_operations.size(); }

  /// the operation number `t`.
  const Surface_operation& operator[](Time t) const { return m_operations[t]; }

  /// the corner number `c` of a scaling.
  Corner scaled_corner(const Surface_operation& scaling, std::size_t c) const
  {
    const std::uint32_t code = m_corners[scaling.id[1] + c];
    return {Face_index(code / 4), code % 4};
  }

  /// appends the scaling of the center of `star`, without corners if the center is flat.
  /// \throws Intrinsic_triangulations::Overflow_error if there are more corners than can be
  ///   numbered
  void add_scaling(const Flattened_star& star, const Delta_complex& mesh)
  {
    add_scaling(star.center(), std::exp(-star.scale_factor()), star.scale_factor() != 0, mesh);
  }

  /// appends a scaling.
  /// \param v the vertex
  /// \param factor the factor of the barycentric coordinate
  /// \param has_corners whether the scaling shall tell the corners; it has no effect otherwise
  /// \param mesh the mesh
  /// \throws Intrinsic_triangulations::Overflow_error if there are more corners than can be
  ///   numbered
  void add_scaling(Vertex_index v, double factor, bool has_corners, const Delta_complex& mesh)
  {
    const std::size_t first = m_corners.size();
    if(has_corners)
      Intrinsic_triangulations::for_each_spoke(v, mesh, [&](Halfedge_index h) {
        if(!mesh.is_border(h))
          add_corner(h, mesh);
      });
    m_operations.push_back({Surface_operation::Kind::scaling,
                            {},
                            {v, number(first), number(m_corners.size() - first)},
                            {factor, 0}});
  }

  /// appends the flip of the edge of `h`, which is about to happen.
  /// \param h the halfedge
  /// \param mesh the mesh
  /// \param s the place of the crossing on `h`
  /// \param t the place of the crossing on `h` after it has been turned
  void add_flip(Halfedge_index h, const Delta_complex& mesh, double s, double t)
  {
    const Halfedge_index o = mesh.opposite(h);
    m_operations.push_back({Surface_operation::Kind::flip,
                            {corner_at_source(h, mesh), corner_at_source(o, mesh), 0},
                            {h, mesh.face(h), mesh.face(o)},
                            {s, t}});
  }

  /// appends the removal of an interior vertex of degree three, which is about to happen.
  /// \param a its first spoke
  /// \param mesh the mesh
  /// \param w_a,w_b the barycentric coordinates of the vertex that belong to the targets of `a` and
  ///   the next spoke
  void add_removal(Halfedge_index a, const Delta_complex& mesh, double w_a, double w_b)
  {
    using Intrinsic_triangulations::next_spoke;
    const Halfedge_index b = next_spoke(a, mesh), c = next_spoke(b, mesh);
    m_operations.push_back(
      {Surface_operation::Kind::removal,
       {corner_at_source(a, mesh), corner_at_source(b, mesh), corner_at_source(c, mesh)},
       {mesh.face(a), mesh.face(b), mesh.face(c)},
       {w_a, w_b}});
  }

  /// appends the removal of a boundary vertex of degree three, which is about to happen.
  /// \param a its first spoke
  /// \param mesh the mesh
  /// \param w_a the barycentric coordinate of the vertex that belongs to the target of `a`
  void add_border_removal(Halfedge_index a, const Delta_complex& mesh, double w_a)
  {
    const Halfedge_index b = Intrinsic_triangulations::next_spoke(a, mesh);
    m_operations.push_back({Surface_operation::Kind::border_removal,
                            {corner_at_source(a, mesh), corner_at_source(b, mesh), 0},
                            {mesh.face(a), mesh.face(b), Delta_complex::null_face()},
                            {w_a, 0}});
  }

  /// forgets all operations but the first `t`.
  void truncate(Time t)
  {
    for(; size() > t; m_operations.pop_back())
      if(m_operations.back().kind == Surface_operation::Kind::scaling)
        m_corners.resize(m_operations.back().id[1]);
  }

  /// the number of bytes in use.
  std::size_t memory() const
  {
    return m_operations.capacity() * sizeof(Surface_operation) +
           m_corners.capacity() * sizeof(std::uint32_t);
  }

private:
  static std::uint8_t corner_at_source(Halfedge_index h, const Delta_complex& mesh)
  {
    return static_cast<std::uint8_t>(Intrinsic_triangulations::side_number(h, mesh));
  }

  void add_corner(Halfedge_index h, const Delta_complex& mesh)
  {
    m_corners.push_back(
      number(4 * static_cast<std::size_t>(mesh.face(h)) + corner_at_source(h, mesh)));
  }

  static std::uint32_t number(std::size_t n)
  {
    if(n > std::numeric_limits<std::uint32_t>::max())
      throw Intrinsic_triangulations::Overflow_error("too many faces for the history");
    return static_cast<std::uint32_t>(n);
  }

  std::vector<Surface_operation> m_operations;
  std::vector<std::uint32_t>
    m_corners; // of faces to be scaled: the face times four, plus the place
};

} // namespace Intrinsic_simplification
} // namespace CGAL

#endif // CGAL_INTRINSIC_SIMPLIFICATION_SURFACE_HISTORY_H
