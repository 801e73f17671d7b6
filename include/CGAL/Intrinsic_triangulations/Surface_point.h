// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_SURFACE_POINT_H
#define CGAL_INTRINSIC_TRIANGULATIONS_SURFACE_POINT_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Edge_point.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/tolerances.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsCorrespondence
/// a vertex of a triangulation, as the source of a halfedge. On a path, the path continues along
/// the halfedge or on its left.
struct Vertex_location
{
  Halfedge_index halfedge; ///< the halfedge; null if the vertex is isolated
};

/// \ingroup PkgIntrinsicTriangulationsCorrespondence
/// a point between the ends of an edge, with weights that sum up to one. Two weights lose no digits
/// near either end.
template <typename FT>
struct Edge_location
{
  Halfedge_index halfedge;  ///< a halfedge of the edge
  std::array<FT, 2> weight; ///< the weights of its source and of its target
};

/// \ingroup PkgIntrinsicTriangulationsCorrespondence
/// a point of a triangulation: a vertex, a point of an edge, or a point of a face. The type states
/// which of them it is, not its coordinates.
template <typename FT>
using Surface_point = std::variant<Vertex_location, Edge_location<FT>, Face_location<FT>>;

/// \ingroup PkgIntrinsicTriangulationsCorrespondence
/// returns whether `p` is a vertex.
template <typename FT>
bool is_at_vertex(const Surface_point<FT>& p)
{
  return std::holds_alternative<Vertex_location>(p);
}

/// \ingroup PkgIntrinsicTriangulationsCorrespondence
/// returns the point of an edge that `p` is; null if it is another point.
template <typename FT>
const Edge_location<FT>* on_edge(const Surface_point<FT>& p)
{
  return std::get_if<Edge_location<FT>>(&p);
}

/// \ingroup PkgIntrinsicTriangulationsCorrespondence
/// returns the halfedge that starts at the vertex `p`, or on which `p` lies; null inside a face.
template <typename FT>
Halfedge_index halfedge_of(const Surface_point<FT>& p)
{
  if(const auto* v = std::get_if<Vertex_location>(&p))
    return v->halfedge;
  return on_edge(p) ? on_edge(p)->halfedge : Halfedge_index();
}

/// \ingroup PkgIntrinsicTriangulationsCorrespondence
/// returns the point of an edge as it is seen from the other side.
template <typename FT>
Edge_location<FT> reversed(const Edge_location<FT>& p)
{
  return {opposite(p.halfedge), {p.weight[1], p.weight[0]}};
}

/// \ingroup PkgIntrinsicTriangulationsCorrespondence
/// returns the point of an edge with its coordinate, the weight of the target.
template <typename FT>
Edge_point<FT> edge_point(const Edge_location<FT>& p)
{
  return {p.halfedge, p.weight[1]};
}

/// \ingroup PkgIntrinsicTriangulationsCorrespondence
/// returns the point of an edge with both weights.
template <typename FT>
Edge_location<FT> edge_location(const Edge_point<FT>& p)
{
  return {p.halfedge, {1 - p.t, p.t}};
}

/// \ingroup PkgIntrinsicTriangulationsCorrespondence
/// returns a point of an edge in the face of its halfedge, or of the opposite one on the boundary.
/// Complexity: constant.
/// \param p a point of an edge
/// \param mesh the triangulation
template <typename FT, typename P>
Face_location<FT> face_location(const Edge_location<FT>& p, const Surface_mesh<P>& mesh)
{
  if(mesh.is_border(p.halfedge))
    return face_location(reversed(p), mesh);
  const std::size_t s = side_number(p.halfedge, mesh);
  std::array<FT, 3> b{FT(0), FT(0), FT(0)};
  b[s] = p.weight[0];
  b[(s + 1) % 3] = p.weight[1];
  return {mesh.face(p.halfedge), b};
}

/// \ingroup PkgIntrinsicTriangulationsCorrespondence
/// returns `p` in its face, in the face of its halfedge, or in the face of the opposite halfedge
/// on the boundary. The face is null if `p` is an isolated vertex. Complexity: constant.
///
/// Functions that take a point of a triangulation call it, so they accept a `Surface_point`, too.
/// \param p a point
/// \param mesh the triangulation
template <typename FT, typename P>
Face_location<FT> face_location(const Surface_point<FT>& p, const Surface_mesh<P>& mesh)
{
  if(const auto* in_face = std::get_if<Face_location<FT>>(&p))
    return *in_face;
  if(on_edge(p))
    return face_location(*on_edge(p), mesh);
  const Halfedge_index h = halfedge_of(p);
  return h.is_valid() ? face_location(Edge_location<FT>{h, {FT(1), FT(0)}}, mesh)
                      : Face_location<FT>();
}

/// \ingroup PkgIntrinsicTriangulationsCorrespondence
/// returns `p`. Complexity: constant.
/// \param p a point of a face
/// \param mesh the triangulation
template <typename FT, typename P>
const Face_location<FT>& face_location(const Face_location<FT>& p,
                                       [[maybe_unused]] const Surface_mesh<P>& mesh)
{
  return p;
}

/// \ingroup PkgIntrinsicTriangulationsCorrespondence
/// returns the vertex or the point of an edge that a point of a face is if coordinates are zero,
/// otherwise this point. Complexity: constant.
/// \param p a point of a face
/// \param mesh the triangulation
template <typename FT, typename P>
Surface_point<FT> surface_point(const Face_location<FT>& p, const Surface_mesh<P>& mesh)
{
  const auto& b = p.second;
  for(std::size_t s = 0; s < 3; ++s)
    if(const std::size_t t = (s + 1) % 3; b[(s + 2) % 3] == 0 && b[s] != 0) {
      const Halfedge_index h = sides(p.first, mesh)[s];
      if(b[t] == 0)
        return Vertex_location{h};
      return Edge_location<FT>{h, {b[s], b[t]}};
    }
  return p;
}

/// \ingroup PkgIntrinsicTriangulationsCorrespondence
/// returns `p`. Complexity: constant.
/// \param p a point
/// \param mesh the triangulation
template <typename FT, typename P>
const Surface_point<FT>& surface_point(const Surface_point<FT>& p,
                                       [[maybe_unused]] const Surface_mesh<P>& mesh)
{
  return p;
}

/// \ingroup PkgIntrinsicTriangulationsCorrespondence
/// calls `visit` with the location of a point in each corner around it, or in each face.
/// Complexity: the number of these locations.
/// \param p a point
/// \param mesh the triangulation
/// \param visit a function that takes a `Face_location`
template <typename FT, typename Visit>
void for_each_location(const Surface_point<FT>& p, const Delta_complex& mesh, const Visit& visit)
{
  const auto visit_on = [&](const Edge_location<FT>& q) {
    if(!mesh.is_border(q.halfedge))
      visit(face_location(q, mesh));
  };
  if(is_at_vertex(p))
    for_each_outgoing_halfedge(mesh.source(halfedge_of(p)), mesh, [&](Halfedge_index h) {
      visit_on({h, {FT(1), FT(0)}});
    });
  else if(on_edge(p)) {
    visit_on(*on_edge(p));
    visit_on(reversed(*on_edge(p)));
  } else
    visit(std::get<Face_location<FT>>(p));
}

namespace internal {

// \throws Invalid_input if `mesh` has no vertex `v`
inline void check_point(Vertex_index v, const Delta_complex& mesh)
{
  if(!mesh.has_valid_index(v) || mesh.is_removed(v))
    throw Invalid_input("there is no vertex " + std::to_string(v.idx()) + " among " +
                        std::to_string(mesh.number_of_vertices()));
}

// \throws Invalid_input if `mesh` has no face of `p`, or if coordinates are negative or do not sum
//   up to one
template <typename FT>
void check_point(const Face_location<FT>& p, const Delta_complex& mesh)
{
  if(!mesh.has_valid_index(p.first) || mesh.is_removed(p.first))
    throw Invalid_input("there is no face " + std::to_string(p.first.idx()) + " among " +
                        std::to_string(mesh.number_of_faces()));
  const auto& [x, y, z] = p.second;
  const FT beyond = x + y + z - 1, tolerance = coordinates_tolerance<FT>();
  if(!(x >= 0 && y >= 0 && z >= 0 && beyond <= tolerance && -beyond <= tolerance))
    throw Invalid_input("barycentric coordinates of a point of face " +
                        std::to_string(p.first.idx()) + " are negative or their sum is not one");
}

// Excludes types that are not points, such as named parameters, from overload resolution.
template <typename Point>
using If_point =
  decltype(face_location(std::declval<const Point&>(), std::declval<const Delta_complex&>()));

// Returns a vertex, or another point, as a point of a face. If the vertex is isolated, it is null.
template <typename FT, typename Point>
Face_location<FT> location_of(const Point& p, const Delta_complex& mesh)
{
  if constexpr(std::is_same<Point, Vertex_index>::value) {
    if(mesh.is_isolated(p))
      return Face_location<FT>();
    const Vertex_location at_vertex{first_outgoing_halfedge(p, mesh)};
    return face_location(Surface_point<FT>(at_vertex), mesh);
  } else
    return face_location(p, mesh);
}

// Calls `use` with a source: a vertex, or a point as a location in a face.
template <typename Source, typename Use>
auto use_source(const Source& source, [[maybe_unused]] const Delta_complex& mesh, const Use& use)
{
  if constexpr(std::is_same<Source, Vertex_index>::value)
    return use(source);
  else
    return use(face_location(source, mesh));
}

template <typename FT, typename Use>
auto use_source(const Surface_point<FT>& source, const Delta_complex& mesh, const Use& use)
{
  return is_at_vertex(source) ? use(mesh.source(halfedge_of(source)))
                              : use(face_location(source, mesh));
}

// Returns the vertex at `p`, or null if `p` is not a vertex.
template <typename FT>
Vertex_index vertex_at(const Face_location<FT>& p, const Delta_complex& mesh)
{
  const Surface_point<FT> point = surface_point(p, mesh);
  return is_at_vertex(point) ? mesh.source(halfedge_of(point)) : Delta_complex::null_vertex();
}

// Returns the point of an edge where a path crosses it. Rounding does not move it to an end, where
// the path would pass a vertex.
template <typename FT>
Surface_point<FT> crossing_on(const Edge_point<FT>& p)
{
  const FT least = rounding_unit<FT>() / 16;
  return edge_location(
    Edge_point<FT>{p.halfedge, (std::min)((std::max)(p.t, least), FT(1 - least))});
}

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_SURFACE_POINT_H
