// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_SURFACE_OPERATION_H
#define CGAL_INTRINSIC_SIMPLIFICATION_SURFACE_OPERATION_H

#include <CGAL/license/Intrinsic_simplification.h>

#include <CGAL/Intrinsic_simplification/Intrinsic_surface.h>
#include <CGAL/Intrinsic_triangulations/Edge_point.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace CGAL::Intrinsic_simplification {

/// \ingroup PkgIntrinsicSimplificationRef
/// a corner of a face, in four bytes.
class Face_corner
{
public:
  /// makes a null corner.
  Face_corner() = default;

  /// makes the corner at the source of `h` in its face.
  Face_corner(Halfedge_index h, const Delta_complex& mesh)
    : Face_corner(mesh.face(h), Intrinsic_triangulations::side_number(h, mesh))
  {}

  /// makes the corner of `f` with the given index of its barycentric coordinate.
  /// \throws Intrinsic_triangulations::Overflow_error if there are more than \f$2^{30}\f$ faces
  Face_corner(Face_index f, std::size_t index)
    : m_code(4 * static_cast<std::uint32_t>(f) + static_cast<std::uint32_t>(index))
  {
    if(f.idx() > std::numeric_limits<std::uint32_t>::max() / 4)
      throw Intrinsic_triangulations::Overflow_error("too many faces for the history");
  }

  /// returns the face.
  Face_index face() const { return Face_index(m_code / 4); }
  /// returns the index of the corner among the barycentric coordinates of the face.
  std::size_t index() const { return m_code % 4; }

private:
  friend class Surface_operation;
  explicit Face_corner(std::uint32_t code) : m_code(code) {}

  std::uint32_t m_code = 0;
};

/// \ingroup PkgIntrinsicSimplificationRef
/// a scaling of the lengths at a vertex. At the corners of the vertex, homogeneous barycentric
/// coordinates are multiplied by a factor (Equation 5.1).
struct Scaling
{
  static constexpr int code = 0;   ///< the index of the type in files
  Vertex_index vertex;             ///< the vertex
  std::uint32_t first_corner;      ///< the first of its corners in the history
  std::uint32_t number_of_corners; ///< 0 if the vertex is already flat: then nothing changes
  double factor;                   ///< \f$e^{-u}\f$
};

/// \ingroup PkgIntrinsicSimplificationRef
/// a flip: the edge of a halfedge \f$ij\f$ becomes the other diagonal \f$lk\f$ of its two faces.
/// The faces
/// \f$ijk\f$ and \f$jil\f$ become \f$lki\f$ and \f$klj\f$, in this order of their corners.
struct Flip
{
  static constexpr int code = 1;      ///< the index of the type in files
  Halfedge_index halfedge;            ///< the halfedge \f$ij\f$, later \f$lk\f$
  std::array<Face_corner, 2> corners; ///< \f$i\f$ in \f$ijk\f$, and \f$j\f$ in \f$jil\f$
  double crossing_before;             ///< the position of the crossing on \f$ij\f$
  double crossing_after;              ///< the position of the crossing on \f$lk\f$
};

/// \ingroup PkgIntrinsicSimplificationRef
/// the removal of a vertex of degree three or its inverse, an insertion. A removal joins the three
/// faces around the vertex, or the two faces on the boundary; an insertion splits one face. The
/// corners of the whole face are the targets of the first, the second and the third outgoing
/// halfedge of the vertex.
struct Vertex_change
{
  static constexpr int code = 2; ///< the index of the type in files, and the first of four
  bool is_insertion;             ///< whether the vertex is inserted
  bool is_border;                ///< whether the vertex is on the boundary
  /// the corners of the faces at the vertex; on the boundary, the third corner is null
  std::array<Face_corner, 3> corners;
  Face_corner
    whole; ///< the corner of the whole face that is the target of the first outgoing halfedge
  /// the barycentric coordinates of the vertex in the whole face that belong to the first two
  /// targets. The second is zero on the boundary.
  std::array<double, 2> weight;
};

/// \ingroup PkgIntrinsicSimplificationRef
/// a change of a surface in 32 bytes: a `Scaling`, a `Flip` or a `Vertex_change`. It has all data
/// to map points.
class Surface_operation
{
public:
  /// makes a scaling.
  Surface_operation(const Scaling& s)
    : m_code(s.code), m_id{s.vertex, s.first_corner, s.number_of_corners}, m_x{s.factor, 0}
  {}
  /// makes a flip.
  Surface_operation(const Flip& f)
    : m_code(f.code),
      m_id{f.halfedge, f.corners[0].m_code, f.corners[1].m_code},
      m_x{f.crossing_before, f.crossing_after}
  {}
  /// makes a removal or an insertion.
  Surface_operation(const Vertex_change& c)
    : m_code(c.code + (c.is_border ? 1 : 0) + (c.is_insertion ? 2 : 0)),
      m_id{c.corners[0].m_code, c.corners[1].m_code,
           c.is_border ? c.whole.m_code : c.corners[2].m_code},
      m_x(c.weight)
  {}

  /// returns the code of the operation in files.
  int code() const { return m_code; }

  /// calls `visitor` with the operation in its own type, and returns the result.
  template <typename Visitor>
  decltype(auto) visit(Visitor&& visitor) const
  {
    switch(m_code) {
      case Scaling::code: return visitor(Scaling{Vertex_index(m_id[0]), m_id[1], m_id[2], m_x[0]});
      case Flip::code:
        return visitor(Flip{Halfedge_index(m_id[0]), {corner(1), corner(2)}, m_x[0], m_x[1]});
      case Vertex_change::code: return visitor(vertex_change(false, false));
      case Vertex_change::code + 1: return visitor(vertex_change(false, true));
      case Vertex_change::code + 2: return visitor(vertex_change(true, false));
      default: return visitor(vertex_change(true, true));
    }
  }

private:
  Face_corner corner(std::size_t n) const { return Face_corner(m_id[n]); }

  // Constant arguments avoid branches in a visitor. For an interior vertex, the whole face is the
  // first one, from its first corner.
  Vertex_change vertex_change(bool is_insertion, bool is_border) const
  {
    if(is_border)
      return {is_insertion, true, {corner(0), corner(1), Face_corner()}, corner(2), m_x};
    return {is_insertion,
            false,
            {corner(0), corner(1), corner(2)},
            Face_corner(m_id[0] - m_id[0] % 4),
            m_x};
  }

  int m_code;
  std::array<std::uint32_t, 3> m_id;
  std::array<double, 2> m_x;
};

} // namespace CGAL::Intrinsic_simplification

#endif // CGAL_INTRINSIC_SIMPLIFICATION_SURFACE_OPERATION_H
