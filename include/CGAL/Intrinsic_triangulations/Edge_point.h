// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_EDGE_POINT_H
#define CGAL_INTRINSIC_TRIANGULATIONS_EDGE_POINT_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>

#include <array>
#include <cstddef>
#include <utility>
#include <variant>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsCorrespondence
/// a point on an edge of a triangulation: \f$(1-t)\f$ times the source plus \f$t\f$ times the
/// target of a halfedge. The ends of the edge are `t == 0` and `t == 1`, exactly.
template <typename FT>
struct Edge_point
{
  Halfedge_index halfedge; ///< a halfedge of the edge
  FT t;                    ///< the barycentric coordinate on it
};

/// \ingroup PkgIntrinsicTriangulationsCorrespondence
/// returns the point that is at `t` on the first halfedge of the edge of `h`, as a point on `h`.
template <typename FT>
Edge_point<FT> edge_point(Halfedge_index h, const FT& t)
{
  return {h, is_first_halfedge(h) ? t : FT(1 - t)};
}

/// \ingroup PkgIntrinsicTriangulationsCorrespondence
/// returns the position of `p` on the first halfedge of its edge.
template <typename FT>
FT place_on_first_halfedge(const Edge_point<FT>& p)
{
  return is_first_halfedge(p.halfedge) ? p.t : FT(1 - p.t);
}

/// \ingroup PkgIntrinsicTriangulationsCorrespondence
/// returns a point as it is seen from the other side of its edge.
template <typename FT>
Edge_point<FT> reversed(const Edge_point<FT>& p, const Delta_complex& mesh)
{
  return {mesh.opposite(p.halfedge), 1 - p.t};
}

namespace internal {

// Returns reversed(p), also for a point on no edge, whose halfedge is null.
template <typename FT>
Edge_point<FT> reversed_if_valid(const Edge_point<FT>& p, const Delta_complex& mesh)
{
  return p.halfedge.is_valid() ? reversed(p, mesh) : p;
}

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsCorrespondence
/// a point in a face, with barycentric coordinates that sum up to one, as in
/// `CGAL::Polygon_mesh_processing::Face_location`. They belong to the source of `halfedge(f)`, its
/// target, and the target of the next halfedge. A point on an edge or at a vertex has coordinates
/// that are exactly zero.
///
/// This order differs from two others:
/// - `CGAL::vertices_around_face()` starts at the target of `halfedge(f)`. Its vertices belong to
///   the coordinates 1, 2, 0.
/// - `CGAL::Euler::add_face()` and `CGAL::Surface_mesh::add_face()` let `halfedge(f)` lead from
///   the last given vertex to the first. Their vertices also belong to the coordinates 1, 2, 0.
///
/// `set_halfedge(f, h)` on the input makes the source of `h` the first corner.
/// `coordinates_from()` returns the coordinates that begin with the source of a given halfedge.
template <typename FT>
using Face_location = std::pair<Face_index, std::array<FT, 3>>;

/// \ingroup PkgIntrinsicTriangulationsCorrespondence
/// the vertex at which a point lies, or the edge or the face inside which it lies.
typedef std::variant<Vertex_index, Edge_index, Face_index> Surface_element;

/// \ingroup PkgIntrinsicTriangulationsCorrespondence
/// a point where an edge of \f$T_1\f$ and an edge of \f$T_2\f$ meet: its position on both.
template <typename FT>
struct Trace_point
{
  Edge_point<FT> on_input;     ///< the position on \f$T_1\f$
  Edge_point<FT> on_intrinsic; ///< the position on \f$T_2\f$
};

/// \ingroup PkgIntrinsicTriangulationsCorrespondence
/// names one of the two triangulations of a surface.
enum class Side
{
  input,    ///< \f$T_1\f$
  intrinsic ///< \f$T_2\f$
};

namespace internal {

inline Side other(Side side) { return side == Side::input ? Side::intrinsic : Side::input; }

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsCorrespondence
/// returns the halfedges of a face in the order of its barycentric coordinates: side \f$s\f$ leads
/// from corner \f$s\f$ to corner \f$s+1\f$.
template <typename P>
std::array<Halfedge_index, 3> sides(Face_index f, const Surface_mesh<P>& mesh)
{
  const Halfedge_index h = mesh.halfedge(f);
  return {h, mesh.next(h), mesh.prev(h)};
}

/// \ingroup PkgIntrinsicTriangulationsCorrespondence
/// returns the barycentric coordinates of the point at `t` along side `s` of a face.
template <typename FT>
std::array<FT, 3> barycentric_coordinates(std::size_t s, const FT& t)
{
  std::array<FT, 3> b{FT(0), FT(0), FT(0)};
  b[s] = 1 - t;
  b[(s + 1) % 3] = t;
  return b;
}

/// \ingroup PkgIntrinsicTriangulationsCorrespondence
/// returns the index of the side `h` in its face, counted from the side `first`.
template <typename P>
std::size_t side_number(Halfedge_index h, Halfedge_index first, const Surface_mesh<P>& mesh)
{
  return h == first ? 0 : h == mesh.next(first) ? 1 : 2;
}

/// \ingroup PkgIntrinsicTriangulationsCorrespondence
/// returns the index of the side `h` in its face.
template <typename P>
std::size_t side_number(Halfedge_index h, const Surface_mesh<P>& mesh)
{
  return side_number(h, mesh.halfedge(mesh.face(h)), mesh);
}

/// \ingroup PkgIntrinsicTriangulationsCorrespondence
/// returns the position of `p` in the face of its halfedge. Complexity: constant.
/// \param p a point of an edge
/// \param mesh the triangulation
template <typename FT>
Face_location<FT> face_location(const Edge_point<FT>& p, const Delta_complex& mesh)
{
  return {mesh.face(p.halfedge), barycentric_coordinates(side_number(p.halfedge, mesh), p.t)};
}

/// \ingroup PkgIntrinsicTriangulationsCorrespondence
/// returns the position on `h` of a point that lies on this side of its face.
template <typename FT>
Edge_point<FT> edge_point(Halfedge_index h, const Face_location<FT>& p, const Delta_complex& mesh)
{
  return {h, p.second[(side_number(h, mesh) + 1) % 3]};
}

/// \ingroup PkgIntrinsicTriangulationsCorrespondence
/// returns the barycentric coordinates of a point in the face of `h`, beginning with the
/// coordinate of the source of `h`.
template <typename FT>
std::array<FT, 3> coordinates_from(Halfedge_index h, const Face_location<FT>& p,
                                   const Delta_complex& mesh)
{
  const std::size_t s = side_number(h, mesh);
  return {p.second[s], p.second[(s + 1) % 3], p.second[(s + 2) % 3]};
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_EDGE_POINT_H
