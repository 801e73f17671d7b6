// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INSERTION_INSERTED_OUTGOING_HALFEDGES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INSERTION_INSERTED_OUTGOING_HALFEDGES_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Edge_point.h>
#include <CGAL/Intrinsic_triangulations/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/Triangulation_pair.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Edge_courses.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Face_regions.h>

#include <array>
#include <cstddef>

namespace CGAL::Intrinsic_triangulations::internal {

// Stores a point at which a vertex is inserted. If lengths follow from T1, the location on T2 is
// not set.
template <typename FT>
struct Point_to_insert
{
  Surface_point<FT> on_input;
  Face_location<FT> on_intrinsic;
};

// Returns the coordinates of the edges from a new vertex on `curve` to the corners of the face. Its
// outgoing halfedge number `forward` leads to the mark where the curve leaves the face. The other
// one leads back.
template <typename Integer>
Face_split<Integer> split_on_curve(const Face_regions::Curve& curve,
                                   Outgoing_halfedges::size_type forward,
                                   const Face_regions& regions)
{
  if(!curve.from_apex && curve.mark.side != curve.corner)
    forward = 1 - forward; // the curve leaves the face before the corner
  const auto back = 1 - forward;
  const auto n = regions.crossings_to_corners(curve);
  Face_split<Integer> split{{Integer(n[0]), Integer(n[1]), Integer(n[2])}, {back, back, back}};
  // The outgoing halfedge that leads forward lies between this corner and the next.
  split.r[curve.from_apex ? (curve.corner + 1) % 3 : curve.corner] = forward;
  return split;
}

// Returns the regions of the face of `h`, with `h` as side 0.
template <typename Traits>
Face_regions regions_at(Halfedge_index h, const Delta_complex& mesh,
                        const Edge_courses<Traits>& courses)
{
  return Face_regions({courses.count(h), courses.count(mesh.next(h)), courses.count(mesh.prev(h))});
}

// Returns the number of crossings from a point on `h` after `p` of its crossings to the opposite
// corner.
template <typename Traits>
typename Traits::Integer crossings_to_apex(Halfedge_index h, std::size_t p,
                                           const Delta_complex& mesh,
                                           const Edge_courses<Traits>& courses)
{
  typedef typename Traits::Integer Integer;
  if(mesh.is_border(h))
    return Integer(0);
  const Face_regions regions = regions_at(h, mesh, courses);
  return Integer(regions.crossings_to_corners(regions.region_at_side(0, p))[2]);
}

template <typename Traits>
typename Traits::FT checked_length(const Triangulation_pair<Traits>& pair,
                                   const typename Traits::FT& length)
{
  if(!pair.traits().is_length_object()(length))
    throw Numerical_error("an edge at an inserted vertex has no positive finite length");
  return length;
}

// Returns the length of an edge from a new vertex at `m` to the vertex `v`. The edge lies along
// outgoing halfedge `r` of the new vertex.
template <typename Traits>
typename Traits::FT shared_outgoing_length(const Triangulation_pair<Traits>& pair,
                                           const Edge_location<typename Traits::FT>& m,
                                           Delta_complex::size_type r, Vertex_index v)
{
  typedef typename Traits::FT FT;
  const Halfedge_index first = pair.first_inserted_outgoing(m.halfedge);
  const Halfedge_index outgoing = r == 0 ? first : opposite(first), back = opposite(outgoing);
  const FT t = m.weight[1];
  return checked_length(pair, pair.part_length({outgoing, outgoing == m.halfedge ? t : FT(1 - t)},
                                               {back, pair.place_along(back, v)}));
}

// Returns the distance of the point `p` in the face of `h` in T2 to a corner. Corner 0 is the
// source of `h`.
template <typename Traits>
typename Traits::FT distance_to_corner(const Triangulation_pair<Traits>& pair, Halfedge_index h,
                                       const std::array<typename Traits::FT, 3>& p,
                                       std::size_t corner)
{
  return checked_length(pair, pair.traits().compute_distance_object()(
                                side_lengths(h, pair.intrinsic()), p,
                                barycentric_coordinates(corner, typename Traits::FT(0))));
}

// Returns the distance of the point at `t` on `h` to the opposite corner, or 0 beyond the boundary.
template <typename Traits>
typename Traits::FT distance_to_apex(const Triangulation_pair<Traits>& pair, Halfedge_index h,
                                     const typename Traits::FT& t)
{
  return pair.mesh().is_border(h) ? typename Traits::FT(0)
                                  : distance_to_corner(pair, h, barycentric_coordinates(0, t), 2);
}

// Returns the lengths of the edges from a new vertex at `p` to the corners of its face. Edges along
// an edge of T1 start at the location `on_edge` of the vertex.
template <typename Traits>
std::array<typename Traits::FT, 3> lengths_to_corners(
  const Triangulation_pair<Traits>& pair, const Face_location<typename Traits::FT>& p,
  const Face_split<typename Traits::Integer>& at, const Edge_location<typename Traits::FT>* on_edge)
{
  const auto side = sides(p.first, pair.mesh());
  std::array<typename Traits::FT, 3> result;
  for(std::size_t s = 0; s < 3; ++s)
    result[s] = at.n[s] < 0
                  ? shared_outgoing_length(pair, *on_edge, at.r[s], pair.mesh().source(side[s]))
                  : distance_to_corner(pair, side[0], p.second, s);
  return result;
}

// Returns the lengths of the edges of a new vertex at `t` on `h`. Edges along an edge of T1 start
// at the location `on_edge` of the vertex.
template <typename Traits>
Edge_split<typename Traits::FT> lengths_of_parts(const Triangulation_pair<Traits>& pair,
                                                 Halfedge_index h, const typename Traits::FT& t,
                                                 const Edge_split<typename Traits::Integer>& n,
                                                 const Edge_split<Delta_complex::size_type>& r,
                                                 const Edge_location<typename Traits::FT>* on_edge)
{
  typedef typename Traits::FT FT;
  const Delta_complex& mesh = pair.mesh();
  const Halfedge_index o = mesh.opposite(h);
  const auto shared = [&](Delta_complex::size_type r, Vertex_index v) {
    return shared_outgoing_length(pair, *on_edge, r, v);
  };
  const auto part = [&](const FT& t) {
    return checked_length(pair, t * pair.length(mesh.edge(h)));
  };
  const auto apex = [&](Halfedge_index x) { return mesh.target(mesh.next(x)); };
  return {n.im < 0 ? shared(r.im, mesh.source(h)) : part(t),
          n.mj < 0 ? shared(r.mj, mesh.target(h)) : part(1 - t),
          n.mk < 0 ? shared(r.mk, apex(h)) : distance_to_apex(pair, h, t),
          n.ml < 0 ? shared(r.ml, apex(o)) : distance_to_apex(pair, o, FT(1 - t))};
}

// Describes the edge that replaces two edges at an inserted vertex. Both edges lie along one edge
// of T1.
struct Merged_edge
{
  Halfedge_index side; // null if there are no such two
  Delta_complex::size_type r_source, r_target;
  bool is_constrained;
};

// Returns the edge that replaces two edges at `v`.
// \pre `v` has three outgoing halfedges
template <typename Traits>
Merged_edge merged_edge(const Triangulation_pair<Traits>& pair, Vertex_index v)
{
  const Delta_complex& mesh = pair.mesh();
  const auto& coordinates = pair.coordinates();
  // `side` will lead from the target of the outgoing halfedge `x` to the target of the outgoing
  // halfedge `y`.
  const auto merge = [&](Halfedge_index x, Halfedge_index y, Halfedge_index side) -> Merged_edge {
    return {side, coordinates.roundabout(opposite(x)), coordinates.roundabout(opposite(y)),
            pair.is_constrained(Edge_index(x)) && pair.is_constrained(Edge_index(y))};
  };
  const Halfedge_index a = first_outgoing_halfedge(v, mesh);
  if(mesh.is_border(v))
    return merge(next_around_source(next_around_source(a, mesh), mesh), a, a);
  Halfedge_index x = a;
  do {
    const Halfedge_index y = next_around_source(x, mesh);
    if(coordinates.is_shared(Edge_index(x)) && coordinates.is_shared(Edge_index(y)))
      return merge(x, y, mesh.next(x));
    x = y;
  } while(x != a);
  return {};
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INSERTION_INSERTED_OUTGOING_HALFEDGES_H
