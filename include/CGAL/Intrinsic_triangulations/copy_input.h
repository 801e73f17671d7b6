// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_COPY_INPUT_H
#define CGAL_INTRINSIC_TRIANGULATIONS_COPY_INPUT_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>

#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>

#include <iterator>
#include <string>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// Stores the indices of the elements of a graph in the Delta-complex. They have the order of the
// ranges vertices(g), edges(g), faces(g). halfedge(e, g) is the first halfedge of its edge.
template <typename Graph>
class Input_numbering
{
  typedef boost::graph_traits<Graph> Graph_traits;

  template <typename Tag>
  using Map = typename boost::property_map<Graph, Tag>::const_type;

public:
  explicit Input_numbering(const Graph& g)
    : m_vertex(get(dynamic_vertex_property_t<Vertex_index>(), g)),
      m_halfedge(get(dynamic_halfedge_property_t<Halfedge_index>(), g)),
      m_face(get(dynamic_face_property_t<Face_index>(), g))
  {
    typedef Delta_complex::size_type size_type;
    size_type number = 0;
    for(auto v : vertices(g))
      put(m_vertex, v, Vertex_index(number++));
    number = 0;
    for(auto e : edges(g)) {
      put(m_halfedge, halfedge(e, g), Halfedge_index(number++));
      put(m_halfedge, opposite(halfedge(e, g), g), Halfedge_index(number++));
    }
    number = 0;
    for(auto f : faces(g))
      put(m_face, f, Face_index(number++));
  }

  Vertex_index vertex(typename Graph_traits::vertex_descriptor v) const { return get(m_vertex, v); }
  Halfedge_index halfedge_of(typename Graph_traits::halfedge_descriptor h) const
  {
    return get(m_halfedge, h);
  }
  Face_index face(typename Graph_traits::face_descriptor f) const
  {
    return f == Graph_traits::null_face() ? Delta_complex::null_face() : get(m_face, f);
  }

private:
  Map<dynamic_vertex_property_t<Vertex_index>> m_vertex;
  Map<dynamic_halfedge_property_t<Halfedge_index>> m_halfedge;
  Map<dynamic_face_property_t<Face_index>> m_face;
};

// Returns indices unchanged: a Surface_mesh without removed elements has these numbers already.
struct Surface_mesh_numbering
{
  Vertex_index vertex(Vertex_index v) const { return v; }
  Halfedge_index halfedge_of(Halfedge_index h) const { return h; }
  Face_index face(Face_index f) const { return f; }
};

[[noreturn]] inline void fail_at_halfedge(Halfedge_index h, const Delta_complex& mesh)
{
  if(mesh.is_border(h))
    throw Invalid_input("edge " + std::to_string(mesh.edge(h).idx()) + " has no face");
  throw Invalid_input("face " + std::to_string(mesh.face(h).idx()) + " is not a triangle");
}

// Sets the border halfedge of a vertex on the boundary. The vertices already have a halfedge each.
inline void set_border_halfedge(Halfedge_index h, Delta_complex& mesh)
{
  const Vertex_index v = mesh.target(h);
  if(mesh.halfedge(v) != h && mesh.is_border(mesh.halfedge(v)))
    throw Invalid_input("vertex " + std::to_string(v.idx()) + " has more than one vertex fan");
  mesh.set_halfedge(v, h);
}

// The loop runs over indices, because an iterator of the mesh would test at each step whether
// elements have been removed.
inline void set_border_halfedges(Delta_complex& mesh)
{
  for(Delta_complex::size_type n = 0; n < mesh.num_halfedges(); ++n) {
    const Halfedge_index h(n);
    if(!mesh.is_border(h))
      continue;
    if(mesh.is_border(mesh.opposite(h)))
      fail_at_halfedge(h, mesh);
    set_border_halfedge(h, mesh);
  }
}

// Returns whether a mesh has property maps besides the maps that each mesh has.
inline bool has_property_maps(const Delta_complex& mesh)
{
  return mesh.properties<Vertex_index>().size() > 3 ||
         mesh.properties<Halfedge_index>().size() > 1 || mesh.properties<Edge_index>().size() > 1 ||
         mesh.properties<Face_index>().size() > 2;
}

// Gives vertices on the boundary their border halfedges, and checks that faces are triangles.
inline void complete_connectivity(Delta_complex& mesh)
{
  const bool is_closed = mesh.number_of_halfedges() == 3 * mesh.number_of_faces();
  if(!is_closed)
    set_border_halfedges(mesh);
  for(Delta_complex::size_type f = 0; f < mesh.num_faces(); ++f) {
    const Halfedge_index h = mesh.halfedge(Face_index(f));
    if(mesh.next(mesh.next(mesh.next(h))) != h)
      fail_at_halfedge(h, mesh);
  }
}

template <typename Graph, typename Numbering>
void copy_connectivity(const Graph& g, const Numbering& numbering, Delta_complex& mesh)
{
  for(auto h_in : halfedges(g)) {
    const Halfedge_index h = numbering.halfedge_of(h_in);
    mesh.set_next_only(h, numbering.halfedge_of(next(h_in, g)));
    mesh.set_prev_only(h, numbering.halfedge_of(prev(h_in, g)));
    mesh.set_face(h, numbering.face(face(h_in, g)));
    mesh.set_target(h, numbering.vertex(target(h_in, g)));
  }
  for(auto v : vertices(g))
    if(halfedge(v, g) != boost::graph_traits<Graph>::null_halfedge())
      mesh.set_halfedge(numbering.vertex(v), numbering.halfedge_of(halfedge(v, g)));
  for(auto f : faces(g))
    mesh.set_halfedge(numbering.face(f), numbering.halfedge_of(halfedge(f, g)));
  complete_connectivity(mesh);
}

template <typename Graph>
struct Is_surface_mesh : std::false_type
{};
template <typename P>
struct Is_surface_mesh<Surface_mesh<P>> : std::true_type
{};

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsBlocks
/// calls `copy(numbering)` with the indices that the elements of `g` have in an
/// `Intrinsic_triangulation`: `numbering.vertex(v)`, `numbering.halfedge_of(h)` and
/// `numbering.face(f)`.
/// \tparam Graph a model of `FaceListGraph` and `HalfedgeListGraph`
template <typename Graph, typename Copy>
void with_numbering(const Graph& g, const Copy& copy)
{
  if constexpr(internal::Is_surface_mesh<Graph>::value)
    if(!g.has_garbage())
      return copy(internal::Surface_mesh_numbering());
  copy(internal::Input_numbering<Graph>(g));
}

namespace internal {

template <typename Range>
Delta_complex::size_type size_of(const Range& range)
{
  return static_cast<Delta_complex::size_type>(std::distance(range.begin(), range.end()));
}

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_COPY_INPUT_H
