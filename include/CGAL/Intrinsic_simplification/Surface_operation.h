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
  /// makes no corner.
  Face_corner() = default;

  /// makes the corner at the source of `h` in its face.
  Face_corner(Halfedge_index h, const Delta_complex& mesh)
    : Face_corner(mesh.face(h), Intrinsic_triangulations::side_number(h, mesh))
  {}

  /// makes the corner of `f` with this index among the barycentric coordinates.
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
/// the lengths at a vertex are multiplied: at the corners of the vertex, homogeneous barycentric
/// coordinates are multiplied by a factor (Equation 5.1).
struct Scaling
{
  static constexpr int code = 0;   ///< the index of the type in files
  Vertex_index vertex;             ///< the vertex
  std::uint32_t first_corner;      ///< the first of its corners in the history
  std::uint32_t number_of_corners; ///< 0 if the vertex is flat already: then nothing changes
  double factor;                   ///< \f$e^{-u}\f$
};

/// \ingroup PkgIntrinsicSimplificationRef
/// the edge of a halfedge \f$ij\f$ becomes the other diagonal \f$lk\f$ of its two faces. The faces
/// \f$ijk\f$ and \f$jil\f$ become \f$lki\f$ and \f$klj\f$, in this order of their corners.
struct Flip
{
  static constexpr int code = 1;      ///< the index of the type in files
  Halfedge_index halfedge;            ///< the halfedge \f$ij\f$, later \f$lk\f$
  std::array<Face_corner, 2> corners; ///< \f$i\f$ in \f$ijk\f$, and \f$j\f$ in \f$jil\f$
  double crossing_before;             ///< the place of the crossing on \f$ij\f$
  double crossing_after;              ///< the place of the crossing on \f$lk\f$
};

/// \ingroup PkgIntrinsicSimplificationRef
/// the three faces around an interior vertex become one, the first of them. Its corners are the
/// targets of the first, the second and the third spoke.
struct Removal
{
  static constexpr int code = 2;      ///< the index of the type in files
  std::array<Face_corner, 3> corners; ///< the corners of the faces at the vertex
  std::array<double, 2> weight;       ///< its first two barycentric coordinates in the new face
};

/// \ingroup PkgIntrinsicSimplificationRef
/// the two faces at a boundary vertex become one, the first of them. Its corners are the targets of
/// the third, the first and the second spoke.
struct Border_removal
{
  static constexpr int code = 3;      ///< the index of the type in files
  std::array<Face_corner, 2> corners; ///< the corners of the faces at the vertex
  double weight; ///< the barycentric coordinate of the vertex that belongs to the first spoke
};

/// \ingroup PkgIntrinsicSimplificationRef
/// the inverse of a `Removal`: a face becomes three around a new vertex. The corners of the face
/// are the targets of the first, the second and the third spoke.
struct Insertion
{
  static constexpr int code = 4;      ///< the index of the type in files
  std::array<Face_corner, 3> corners; ///< the corners of the new faces at the vertex
  std::array<double, 2> weight;       ///< its first two barycentric coordinates in the face
};

/// \ingroup PkgIntrinsicSimplificationRef
/// the inverse of a `Border_removal`: a face becomes two at a new boundary vertex.
struct Border_insertion
{
  static constexpr int code = 5;      ///< the index of the type in files
  std::array<Face_corner, 2> corners; ///< the corners of the new faces at the vertex
  Face_corner whole; ///< the corner of the face that is the target of the first spoke
  double weight;     ///< the barycentric coordinate of the vertex that belongs to this corner
};

/// \ingroup PkgIntrinsicSimplificationRef
/// a change of a surface, with all that is needed to carry points through it, in 32 bytes: a
/// `Scaling`, a `Flip`, a `Removal`, a `Border_removal`, an `Insertion` or a `Border_insertion`.
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
  /// makes a removal.
  Surface_operation(const Removal& r)
    : m_code(r.code),
      m_id{r.corners[0].m_code, r.corners[1].m_code, r.corners[2].m_code},
      m_x(r.weight)
  {}
  /// makes a removal at the boundary.
  Surface_operation(const Border_removal& r)
    : m_code(r.code), m_id{r.corners[0].m_code, r.corners[1].m_code, 0}, m_x{r.weight, 0}
  {}

  /// makes an insertion.
  Surface_operation(const Insertion& i)
    : m_code(i.code),
      m_id{i.corners[0].m_code, i.corners[1].m_code, i.corners[2].m_code},
      m_x(i.weight)
  {}
  /// makes an insertion at the boundary.
  Surface_operation(const Border_insertion& i)
    : m_code(i.code),
      m_id{i.corners[0].m_code, i.corners[1].m_code, i.whole.m_code},
      m_x{i.weight, 0}
  {}

  /// calls `visitor` with the operation as what it is, and returns what that returns.
  template <typename Visitor>
  decltype(auto) visit(Visitor&& visitor) const
  {
    const auto corner = [this](std::size_t n) { return Face_corner(m_id[n]); };
    switch(m_code) {
      case Scaling::code: return visitor(Scaling{Vertex_index(m_id[0]), m_id[1], m_id[2], m_x[0]});
      case Flip::code:
        return visitor(Flip{Halfedge_index(m_id[0]), {corner(1), corner(2)}, m_x[0], m_x[1]});
      case Removal::code: return visitor(Removal{{corner(0), corner(1), corner(2)}, m_x});
      case Border_removal::code: return visitor(Border_removal{{corner(0), corner(1)}, m_x[0]});
      case Insertion::code: return visitor(Insertion{{corner(0), corner(1), corner(2)}, m_x});
      default: return visitor(Border_insertion{{corner(0), corner(1)}, corner(2), m_x[0]});
    }
  }

private:
  int m_code;
  std::array<std::uint32_t, 3> m_id;
  std::array<double, 2> m_x;
};

} // namespace CGAL::Intrinsic_simplification

#endif // CGAL_INTRINSIC_SIMPLIFICATION_SURFACE_OPERATION_H
