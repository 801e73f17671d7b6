// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_DELTA_COMPLEX_H
#define CGAL_INTRINSIC_TRIANGULATIONS_DELTA_COMPLEX_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/internal/validity/Delta_complex_defect.h>

#include <CGAL/Surface_mesh.h>
#include <CGAL/assertions.h>

#include <array>
#include <initializer_list>
#include <iostream>
#include <string>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsDeltaComplex
/// the point of a vertex that has no position.
struct No_point
{};

/// \ingroup PkgIntrinsicTriangulationsDeltaComplex
/// a triangulated surface, with or without boundary, in which loops and parallel edges are ordinary
/// (Section 2.3.1). It has no geometry. As everywhere in `CGAL::Surface_mesh`, `halfedge(v)` is an
/// incoming halfedge, and a border halfedge if `v` is on the boundary.
typedef CGAL::Surface_mesh<No_point> Delta_complex;

/// \ingroup PkgIntrinsicTriangulationsDeltaComplex
/// a vertex; all meshes of the package have the same index types.
typedef Delta_complex::Vertex_index Vertex_index;
/// \ingroup PkgIntrinsicTriangulationsDeltaComplex
/// a halfedge; all meshes of the package have the same index types.
typedef Delta_complex::Halfedge_index Halfedge_index;
/// \ingroup PkgIntrinsicTriangulationsDeltaComplex
/// an edge; all meshes of the package have the same index types.
typedef Delta_complex::Edge_index Edge_index;
/// \ingroup PkgIntrinsicTriangulationsDeltaComplex
/// a face; all meshes of the package have the same index types.
typedef Delta_complex::Face_index Face_index;

/// \ingroup PkgIntrinsicTriangulationsDeltaComplex
/// states whether an operation on a Delta-complex is possible, and if not, why.
enum class Operation_status
{
  possible,     ///< the operation can be performed
  border_edge,  ///< the edge has a face on one side only
  same_face,    ///< both sides of an edge at hand are in one face
  wrong_degree, ///< the vertex has not exactly three incident edges
  self_edge     ///< an edge joins the vertex to itself
};

/// \ingroup PkgIntrinsicTriangulationsDeltaComplex
/// returns a short sentence for `status`.
inline const char* to_string(Operation_status status)
{
  switch(status) {
    case Operation_status::possible: return "possible";
    case Operation_status::border_edge: return "the edge is on the boundary";
    case Operation_status::same_face: return "both sides of the edge are in one face";
    case Operation_status::wrong_degree: return "the vertex is not of degree three";
    case Operation_status::self_edge: return "an edge joins the vertex to itself";
  }
  return "unknown";
}

/// \ingroup PkgIntrinsicTriangulationsDeltaComplex
/// returns the other halfedge of the edge of `h`, in a single instruction.
inline Halfedge_index opposite(Halfedge_index h) { return Halfedge_index(h.idx() ^ 1); }

/// \ingroup PkgIntrinsicTriangulationsDeltaComplex
/// returns whether `h` is the first halfedge of its edge `e`, which is `mesh.halfedge(e, 0)` in
/// every `Surface_mesh`.
inline bool is_first_halfedge(Halfedge_index h) { return h.idx() % 2 == 0; }

/// \ingroup PkgIntrinsicTriangulationsDeltaComplex
/// returns the first halfedge of an edge. Data along the edge is stored in this direction.
inline Halfedge_index first_halfedge(Edge_index e) { return Halfedge_index(2 * e.idx()); }

/// \ingroup PkgIntrinsicTriangulationsDeltaComplex
/// returns `x` if `h` is the first halfedge of its edge, otherwise the opposite of `x`. If `x` is
/// recorded for the first halfedge of an edge, this is `x` as seen from `h`. The function is its
/// own inverse.
inline Halfedge_index oriented_like(Halfedge_index h, Halfedge_index x)
{
  return Halfedge_index(x.idx() ^ (h.idx() & 1));
}

/// \ingroup PkgIntrinsicTriangulationsDeltaComplex
/// returns the outgoing halfedge after `h` in counterclockwise order around the source of `h`.
/// \pre `h` is not a border halfedge
template <typename P>
Halfedge_index next_around_source(Halfedge_index h, const Surface_mesh<P>& mesh)
{
  return opposite(mesh.prev(h));
}

/// \ingroup PkgIntrinsicTriangulationsDeltaComplex
/// returns the outgoing halfedge before `h` in counterclockwise order around the source of `h`.
/// \pre `opposite(h)` is not a border halfedge
template <typename P>
Halfedge_index previous_around_source(Halfedge_index h, const Surface_mesh<P>& mesh)
{
  return mesh.next(opposite(h));
}

/// \ingroup PkgIntrinsicTriangulationsDeltaComplex
/// returns the first outgoing halfedge of the vertex `v` of `mesh`. At a boundary vertex it has the
/// boundary on its right, so `next_around_source()` visits all outgoing halfedges. Complexity:
/// constant.
/// \pre `v` is not isolated
template <typename P>
Halfedge_index first_outgoing_halfedge(Vertex_index v, const Surface_mesh<P>& mesh)
{
  return opposite(mesh.halfedge(v));
}

/// \ingroup PkgIntrinsicTriangulationsDeltaComplex
/// calls `visit(h)` for every outgoing halfedge of `v`, in the order of `next_around_source()`.
/// \pre `v` is not isolated
template <typename P, typename Visit>
void for_each_outgoing_halfedge(Vertex_index v, const Surface_mesh<P>& mesh, const Visit& visit)
{
  const Halfedge_index first = first_outgoing_halfedge(v, mesh);
  Halfedge_index h = first;
  do {
    visit(h);
    if(mesh.is_border(h))
      return;
    h = next_around_source(h, mesh);
  } while(h != first);
}

namespace internal {

// Returns a copy of the connectivity without property maps. All elements keep their numbers.
inline Delta_complex without_maps(const Delta_complex& mesh)
{
  Delta_complex result(mesh);
  result.remove_all_property_maps();
  return result;
}

template <typename P>
void set_triangle(Halfedge_index a, Halfedge_index b, Halfedge_index c, Face_index f,
                  Surface_mesh<P>& mesh)
{
  mesh.set_next(a, b);
  mesh.set_next(b, c);
  mesh.set_next(c, a);
  for(Halfedge_index h : {a, b, c})
    mesh.set_face(h, f);
  mesh.set_halfedge(f, a);
}

// Adds the edge from `source` to `target` and returns its halfedge with that direction.
template <typename P>
Halfedge_index add_directed_edge(Vertex_index source, Vertex_index target, Surface_mesh<P>& mesh)
{
  const Halfedge_index h = mesh.add_edge();
  mesh.set_target(h, target);
  mesh.set_target(mesh.opposite(h), source);
  return h;
}

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsDeltaComplex
/// returns whether the edge of `h` can be flipped. The edge of a degree-1 vertex cannot: its two
/// sides are in one face. Complexity: constant.
template <typename P>
Operation_status flip_status(Halfedge_index h, const Surface_mesh<P>& mesh)
{
  const Face_index f = mesh.face(h), g = mesh.face(mesh.opposite(h));
  if(f == Surface_mesh<P>::null_face() || g == Surface_mesh<P>::null_face())
    return Operation_status::border_edge;
  return f == g ? Operation_status::same_face : Operation_status::possible;
}

/// \ingroup PkgIntrinsicTriangulationsDeltaComplex
/// turns the edge \f$ij\f$ of `h` counterclockwise into the other diagonal \f$kl\f$ of its two
/// faces \f$ijk\f$ and \f$jil\f$. Afterwards `h` leads from \f$l\f$ to \f$k\f$, and \f$i\f$ is on
/// its left. Complexity: constant.
/// \pre `flip_status(h, mesh) == Operation_status::possible`
template <typename P>
void flip_edge(Halfedge_index h, Surface_mesh<P>& mesh)
{
  CGAL_precondition(flip_status(h, mesh) == Operation_status::possible);
  const Halfedge_index o = opposite(h);
  const Halfedge_index jk = mesh.next(h), ki = mesh.prev(h);
  const Halfedge_index il = mesh.next(o), lj = mesh.prev(o);
  const Vertex_index i = mesh.target(o), j = mesh.target(h);

  if(mesh.halfedge(i) == o)
    mesh.set_halfedge(i, ki);
  if(mesh.halfedge(j) == h)
    mesh.set_halfedge(j, lj);
  mesh.set_target(h, mesh.target(jk));
  mesh.set_target(o, mesh.target(il));
  internal::set_triangle(h, ki, il, mesh.face(h), mesh);
  internal::set_triangle(o, lj, jk, mesh.face(o), mesh);
}

/// \ingroup PkgIntrinsicTriangulationsDeltaComplex
/// inserts a vertex into the face of `h` and joins it to the three corners.
/// Complexity: constant.
/// \returns the halfedge from the target of `h` to the new vertex.
/// \pre `h` is not a border halfedge
template <typename P>
Halfedge_index split_face(Halfedge_index h, Surface_mesh<P>& mesh)
{
  CGAL_precondition(!mesh.is_border(h));
  const std::array<Halfedge_index, 3> side{h, mesh.next(h), mesh.prev(h)};
  const std::array<Face_index, 3> face{mesh.face(h), mesh.add_face(), mesh.add_face()};
  const Vertex_index m = mesh.add_vertex();
  std::array<Halfedge_index, 3> inward; // from the target of side[s] to m
  for(std::size_t s = 0; s < 3; ++s)
    inward[s] = internal::add_directed_edge(mesh.target(side[s]), m, mesh);
  for(std::size_t s = 0; s < 3; ++s)
    internal::set_triangle(side[s], inward[s], mesh.opposite(inward[(s + 2) % 3]), face[s], mesh);
  mesh.set_halfedge(m, inward[0]);
  return inward[0];
}

namespace internal {

// Cuts the two sides after `h` off its face, as a triangle that becomes a face of its own.
template <typename P>
void cut_ear(Halfedge_index h, Surface_mesh<P>& mesh)
{
  const Halfedge_index first = mesh.next(h), second = mesh.next(first), beyond = mesh.next(second);
  const Halfedge_index cut = add_directed_edge(mesh.target(h), mesh.target(second), mesh);
  mesh.set_next(h, cut);
  mesh.set_next(cut, beyond);
  mesh.set_face(cut, mesh.face(h));
  mesh.set_halfedge(mesh.face(h), h);
  set_triangle(first, second, mesh.opposite(cut), mesh.add_face(), mesh);
}

// Sets the halfedge of each vertex, a border halfedge if it is on the boundary. Halfedges and faces
// must be linked.
template <typename P>
void set_halfedges_of_vertices(Surface_mesh<P>& mesh)
{
  for(Halfedge_index h : mesh.halfedges())
    if(mesh.is_border(h) || mesh.is_isolated(mesh.target(h)))
      mesh.set_halfedge(mesh.target(h), h);
}

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsDeltaComplex
/// inserts a vertex into the edge of `h` and joins it to the opposite corner of each incident
/// face. If both sides are in one face, this face winds around a degree-1 vertex. Then a loop cuts
/// off this vertex, and a diagonal divides the remaining quadrangle. Complexity: constant.
/// \returns the halfedge from the source of `h` to the new vertex; `h` starts at the new vertex.
template <typename P>
Halfedge_index split_edge(Halfedge_index h, Surface_mesh<P>& mesh)
{
  const Halfedge_index o = mesh.opposite(h);
  const Halfedge_index before = mesh.prev(h), after = mesh.next(o);
  const bool in_one_face = mesh.face(h) == mesh.face(o);
  const bool winds_around_source = after == h;
  const Vertex_index i = mesh.target(o), m = mesh.add_vertex();
  const Halfedge_index first = internal::add_directed_edge(i, m, mesh);
  const Halfedge_index back = mesh.opposite(first);

  mesh.set_target(o, m);
  mesh.set_next(o, back);
  mesh.set_next(back, winds_around_source ? first : after);
  if(!winds_around_source)
    mesh.set_next(before, first);
  mesh.set_next(first, h);
  mesh.set_face(first, mesh.face(h));
  mesh.set_face(back, mesh.face(o));
  if(mesh.halfedge(i) == o)
    mesh.set_halfedge(i, back);
  mesh.set_halfedge(m, mesh.is_border(o) ? o : first);

  for(Halfedge_index x : {first, in_one_face ? first : o})
    if(!mesh.is_border(x))
      internal::cut_ear(x, mesh);
  return first;
}

/// \ingroup PkgIntrinsicTriangulationsDeltaComplex
/// returns the first part of an edge that has been split, if `h` is the second part. Complexity:
/// constant.
template <typename P>
Halfedge_index first_part(Halfedge_index h, const Surface_mesh<P>& mesh)
{
  return mesh.prev(mesh.is_border(h) ? h : mesh.opposite(mesh.prev(h)));
}

namespace internal {

// Removes the edge after `part` that divides the triangle of `whole`, and links this triangle.
template <typename P>
void join_face(Halfedge_index part, Halfedge_index whole, Surface_mesh<P>& mesh)
{
  const Halfedge_index cut = mesh.next(part), third = mesh.next(cut),
                       second = mesh.next(mesh.next(mesh.opposite(cut)));
  if(mesh.halfedge(mesh.target(cut)) == cut)
    mesh.set_halfedge(mesh.target(cut), second);
  mesh.remove_face(mesh.face(mesh.opposite(cut)));
  mesh.remove_edge(mesh.edge(cut));
  set_triangle(whole, second, third, mesh.face(part), mesh);
}

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsDeltaComplex
/// takes `split_edge()` back. Removes the source of `h` with its edges, except the edge of `h`,
/// which becomes the whole edge. Complexity: constant.
/// \pre `split_edge()` has inserted the source of `h`, no edge has been flipped since, and the
///   sides of the whole edge are not in one face
template <typename P>
void join_edge(Halfedge_index h, Surface_mesh<P>& mesh)
{
  const Halfedge_index o = mesh.opposite(h), im = first_part(h, mesh), mi = mesh.opposite(im);
  const Vertex_index m = mesh.target(im), i = mesh.target(mi);
  if(mesh.is_border(im))
    mesh.set_next(mesh.prev(im), h);
  else
    internal::join_face(im, h, mesh);
  if(mesh.is_border(o))
    mesh.set_next(o, mesh.next(mi));
  else
    internal::join_face(o, o, mesh);
  mesh.set_target(o, i);
  if(mesh.halfedge(i) == mi)
    mesh.set_halfedge(i, o);
  mesh.remove_edge(mesh.edge(im));
  mesh.remove_vertex(m);
}

/// \ingroup PkgIntrinsicTriangulationsDeltaComplex
/// returns whether `v` can be removed by `remove_degree_3_vertex()`. Complexity: constant.
template <typename P>
Operation_status removal_status(Vertex_index v, const Surface_mesh<P>& mesh)
{
  if(mesh.is_isolated(v))
    return Operation_status::wrong_degree;
  Halfedge_index h = first_outgoing_halfedge(v, mesh);
  for(int outgoing = 0; outgoing < 3; ++outgoing) {
    if(mesh.target(h) == v)
      return Operation_status::self_edge;
    const bool is_last = mesh.is_border(h);
    h = is_last ? first_outgoing_halfedge(v, mesh) : next_around_source(h, mesh);
    if((outgoing == 2) != (h == first_outgoing_halfedge(v, mesh)))
      return Operation_status::wrong_degree;
  }
  return Operation_status::possible;
}

namespace internal {

template <typename P>
void remove_vertex_with_edges(Vertex_index v,
                              std::initializer_list<Halfedge_index> outgoing_halfedges,
                              Surface_mesh<P>& mesh)
{
  for(Halfedge_index h : outgoing_halfedges)
    mesh.remove_edge(mesh.edge(h));
  mesh.remove_vertex(v);
}

// Replaces the three faces around the interior vertex `v` by one.
template <typename P>
Face_index remove_interior_vertex(Vertex_index v, Surface_mesh<P>& mesh)
{
  const Halfedge_index a = first_outgoing_halfedge(v, mesh);
  const Halfedge_index b = next_around_source(a, mesh), c = next_around_source(b, mesh);
  const Face_index f = mesh.face(a);
  for(Halfedge_index outgoing : {a, b, c})
    if(mesh.halfedge(mesh.target(outgoing)) == outgoing)
      mesh.set_halfedge(mesh.target(outgoing), mesh.prev(mesh.opposite(outgoing)));
  const Halfedge_index ab = mesh.next(a), bc = mesh.next(b), ca = mesh.next(c);
  mesh.remove_face(mesh.face(b));
  mesh.remove_face(mesh.face(c));
  set_triangle(ab, bc, ca, f, mesh);
  remove_vertex_with_edges(v, {a, b, c}, mesh);
  return f;
}

// Replaces the two faces at the boundary vertex `v` by one. The first of its two border edges is
// kept.
template <typename P>
Face_index remove_boundary_vertex(Vertex_index v, Surface_mesh<P>& mesh)
{
  const Halfedge_index a =
    first_outgoing_halfedge(v, mesh); // a's right side and c's left side are border
  const Halfedge_index b = next_around_source(a, mesh), c = next_around_source(b, mesh);
  const Halfedge_index border = mesh.opposite(a); // its target v becomes the target of c
  const Vertex_index vb = mesh.target(b), vc = mesh.target(c);
  const Face_index f = mesh.face(a);
  const Halfedge_index ab = mesh.next(a), bc = mesh.next(b), beyond = mesh.next(c);
  if(mesh.halfedge(vb) == b)
    mesh.set_halfedge(vb, ab);
  mesh.set_halfedge(vc, border);
  mesh.remove_face(mesh.face(b));
  mesh.set_target(border, vc);
  mesh.set_next(border, beyond);
  set_triangle(a, ab, bc, f, mesh);
  remove_vertex_with_edges(v, {b, c}, mesh);
  return f;
}

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsDeltaComplex
/// removes `v` with its three edges. An interior vertex leaves one face instead of three. A
/// boundary vertex leaves one face instead of two, with one border edge instead of two.
/// Complexity: constant.
/// \returns the face that remains.
/// \pre `removal_status(v, mesh) == Operation_status::possible`
template <typename P>
Face_index remove_degree_3_vertex(Vertex_index v, Surface_mesh<P>& mesh)
{
  CGAL_precondition(removal_status(v, mesh) == Operation_status::possible);
  return mesh.is_border(v) ? internal::remove_boundary_vertex(v, mesh)
                           : internal::remove_interior_vertex(v, mesh);
}

/// \ingroup PkgIntrinsicTriangulationsDeltaComplex
/// checks whether `mesh` is a triangulated surface: links in order, faces triangles, one vertex fan
/// at every vertex, border vertices with a border halfedge. Loops and parallel edges are allowed.
/// Complexity: linear.
/// \param mesh the mesh
/// \param verbose whether the first defect is written to `std::cerr`
template <typename P>
bool is_valid_Delta_complex(const Surface_mesh<P>& mesh, bool verbose = false)
{
  const std::string defect = internal::Delta_complex_defect(mesh);
  if(verbose && !defect.empty())
    std::cerr << defect << '\n';
  return defect.empty();
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_DELTA_COMPLEX_H
