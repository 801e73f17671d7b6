// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_SUBDIVISION_PART_H
#define CGAL_INTRINSIC_TRIANGULATIONS_SUBDIVISION_PART_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/interpolation.h>
#include <CGAL/Intrinsic_triangulations/named_parameters.h>

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <array>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsSubdivision
/// some faces of a subdivision with their sides and corners, and the first vertices of the
/// subdivision, in the order of their indices.
///
/// The object refers to the subdivision.
///
/// \tparam Subdivision a class derived from `Subdivision_base`
template <typename Subdivision>
class Subdivision_part
{
public:
  /// the mesh of the subdivision.
  typedef typename Subdivision::Mesh Mesh;
  /// the type of numbers of elements.
  typedef typename Subdivision::size_type size_type;

  /// selects all elements. Complexity: linear.
  explicit Subdivision_part(const Subdivision& subdivision)
    : Subdivision_part(subdivision, subdivision.mesh().number_of_vertices(),
                       [](Face_index) { return true; })
  {}

  /// selects some faces. Complexity: linear.
  /// \param subdivision the subdivision
  /// \param first_vertices how many vertices are selected independently of their faces
  /// \param has_face determines whether a face is selected
  template <typename Predicate>
  Subdivision_part(const Subdivision& subdivision, size_type first_vertices,
                   const Predicate& has_face)
    : m_subdivision(&subdivision),
      m_has_face(mesh().number_of_faces(), 0),
      m_number(mesh().number_of_vertices(), none)
  {
    for(Face_index f : mesh().faces())
      if(has_face(f)) {
        m_has_face[f.idx()] = 1;
        m_faces.push_back(f);
      }
    for(Edge_index e : mesh().edges())
      if(has(mesh().halfedge(e)) || has(mesh().opposite(mesh().halfedge(e))))
        m_edges.push_back(e);
    select_vertices(first_vertices);
  }

  /// returns the subdivision.
  const Subdivision& subdivision() const { return *m_subdivision; }
  /// returns the mesh of the subdivision.
  const Mesh& mesh() const { return m_subdivision->mesh(); }

  /// returns the selected vertices.
  const std::vector<Vertex_index>& vertices() const { return m_vertices; }
  /// returns the edges of selected faces.
  const std::vector<Edge_index>& edges() const { return m_edges; }
  /// returns the selected faces.
  const std::vector<Face_index>& faces() const { return m_faces; }

  /// returns whether the face of `h` is selected.
  bool has(Halfedge_index h) const
  {
    const Face_index f = mesh().face(h);
    return f.is_valid() && m_has_face[f.idx()] != 0;
  }

  /// returns the index of `v` among the selected vertices.
  /// \pre `v` is selected
  size_type number(Vertex_index v) const { return m_number[v.idx()]; }

private:
  static constexpr size_type none = (std::numeric_limits<size_type>::max)();

  void select_vertices(size_type first_vertices)
  {
    std::vector<char> is_corner(mesh().number_of_vertices(), 0);
    for(Halfedge_index h : mesh().halfedges())
      is_corner[mesh().target(h).idx()] |= char(has(h));
    for(Vertex_index v : mesh().vertices())
      if(is_corner[v.idx()] || v.idx() < first_vertices) {
        m_number[v.idx()] = static_cast<size_type>(m_vertices.size());
        m_vertices.push_back(v);
      }
  }

  const Subdivision* m_subdivision;
  std::vector<char> m_has_face;    // of each face of the subdivision
  std::vector<size_type> m_number; // among the vertices, of each vertex of the subdivision
  std::vector<Vertex_index> m_vertices;
  std::vector<Edge_index> m_edges;
  std::vector<Face_index> m_faces;
};

/// \ingroup PkgIntrinsicTriangulationsSubdivision
/// copies a part of a subdivision to a graph, and keeps which element became which.
///
/// \tparam Subdivision a class derived from `Subdivision_base`
/// \tparam Graph a model of `MutableFaceGraph`
template <typename Subdivision, typename Graph>
class Copied_part
{
  typedef boost::graph_traits<Graph> Graph_traits;

public:
  /// the part of the subdivision.
  typedef Subdivision_part<Subdivision> Part;

  /// adds the elements of `part` to `g`. Elements that `g` has already stay. Complexity: linear.
  Copied_part(const Part& part, Graph& g)
    : m_part(part), m_graph(g), m_halfedge(part.mesh().number_of_edges())
  {
    for(std::size_t n = 0; n < part.vertices().size(); ++n)
      m_vertex.push_back(add_isolated_vertex());
    for(Edge_index e : part.edges())
      m_halfedge[e.idx()] = halfedge(add_edge(g), g);
    for(Face_index f : part.faces())
      add_polygon(f);
    for(Edge_index e : part.edges())
      for(Halfedge_index h : {mesh().halfedge(e), mesh().opposite(mesh().halfedge(e))})
        if(!part.has(h))
          link_border(h);
  }

  /// returns the copy of the vertex with index `n` in the part.
  typename Graph_traits::vertex_descriptor vertex(std::size_t n) const { return m_vertex[n]; }

  /// returns the copy of the face with index `n` in the part.
  typename Graph_traits::face_descriptor face(std::size_t n) const { return m_face[n]; }

  /// returns the copy of a halfedge of the subdivision.
  /// \pre its edge belongs to the part
  typename Graph_traits::halfedge_descriptor halfedge_of(Halfedge_index h) const
  {
    const auto first = m_halfedge[Edge_index(h).idx()];
    return is_first_halfedge(h) ? first : opposite(first, m_graph);
  }

private:
  const typename Part::Mesh& mesh() const { return m_part.mesh(); }

  auto add_isolated_vertex()
  {
    const auto v = add_vertex(m_graph);
    set_halfedge(v, Graph_traits::null_halfedge(), m_graph);
    return v;
  }

  auto vertex_at_target(Halfedge_index h) const
  {
    return m_vertex[m_part.number(mesh().target(h))];
  }

  void add_polygon(Face_index parent)
  {
    const auto f = add_face(m_graph);
    m_face.push_back(f);
    set_halfedge(f, halfedge_of(mesh().halfedge(parent)), m_graph);
    for(Halfedge_index h : CGAL::halfedges_around_face(mesh().halfedge(parent), mesh())) {
      const auto copy = halfedge_of(h), next = halfedge_of(mesh().next(h));
      set_face(copy, f, m_graph);
      set_next(copy, next, m_graph);
      set_end(h);
    }
  }

  void set_end(Halfedge_index h)
  {
    set_target(halfedge_of(h), vertex_at_target(h), m_graph);
    set_halfedge(vertex_at_target(h), halfedge_of(h), m_graph);
  }

  // Links `h` with the next halfedge of the border, which follows clockwise around the target.
  void link_border(Halfedge_index h)
  {
    Halfedge_index next = mesh().opposite(h);
    do
      next = mesh().opposite(mesh().prev(next));
    while(m_part.has(next));
    set_face(halfedge_of(h), Graph_traits::null_face(), m_graph);
    set_next(halfedge_of(h), halfedge_of(next), m_graph);
    set_end(h);
  }

  const Part& m_part;
  Graph& m_graph;
  std::vector<typename Graph_traits::vertex_descriptor> m_vertex;
  std::vector<typename Graph_traits::face_descriptor> m_face;
  std::vector<typename Graph_traits::halfedge_descriptor> m_halfedge; // first ones, of each edge
};

namespace internal {

// Selects the value type of property maps of parents: the parent in the first triangulation, or an
// array of parents in all triangulations.
template <typename Value, typename Parent>
struct Parents
{
  static Value of(const Parent& parent) { return parent(0); }
};

template <typename Index, std::size_t size, typename Parent>
struct Parents<std::array<Index, size>, Parent>
{
  static std::array<Index, size> of(const Parent& parent)
  {
    std::array<Index, size> result;
    for(std::size_t side = 0; side < size; ++side)
      result[side] = parent(side);
    return result;
  }
};

// Puts the parents `parent(element, side)` of some elements into the map that `np` has for `Tag`,
// if it has one.
template <typename Tag, typename NamedParameters, typename Elements, typename Copy,
          typename Parent_of>
void put_parents(const NamedParameters& np, const Elements& elements, const Copy& copy,
                 const Parent_of& parent_of)
{
  if constexpr(has_parameter<NamedParameters, Tag>()) {
    const auto map = CGAL::parameters::get_parameter(np, Tag());
    typedef typename boost::property_traits<std::decay_t<decltype(map)>>::value_type Value;
    for(std::size_t n = 0; n < elements.size(); ++n) {
      const auto parent = [&](std::size_t side) { return parent_of(elements[n], side); };
      put(map, copy(n), Parents<Value, decltype(parent)>::of(parent));
    }
  }
}

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsSubdivision
/// writes the parents of the elements of a copied part of a subdivision to property maps of the
/// graph. Complexity: linear.
///
/// \param part the part
/// \param copy its copy
/// \param g the graph of the copy
/// \param np the property maps, as for `common_subdivision()`
template <typename Subdivision, typename Graph, typename NamedParameters>
void write_parents(const Subdivision_part<Subdivision>& part,
                   const Copied_part<Subdivision, Graph>& copy, const Graph& g,
                   const NamedParameters& np)
{
  typedef typename Subdivision::Side Side;
  const Subdivision& subdivision = part.subdivision();
  internal::put_parents<internal_np::parent_vertex_map_t>(
    np, part.vertices(), [&](std::size_t n) { return copy.vertex(n); },
    [&](Vertex_index v, std::size_t side) {
      return subdivision.parent_vertex(static_cast<Side>(side), v);
    });
  internal::put_parents<internal_np::parent_edge_map_t>(
    np, part.edges(),
    [&](std::size_t n) { return edge(copy.halfedge_of(first_halfedge(part.edges()[n])), g); },
    [&](Edge_index e, std::size_t side) {
      return subdivision.parent_edge(static_cast<Side>(side), e);
    });
  internal::put_parents<internal_np::parent_face_map_t>(
    np, part.faces(), [&](std::size_t n) { return copy.face(n); },
    [&](Face_index f, std::size_t side) {
      return subdivision.parent_face(static_cast<Side>(side), f);
    });
}

/// \ingroup PkgIntrinsicTriangulationsSubdivision
/// writes positions of the vertices of a copied part of a subdivision. Complexity: linear.
///
/// \param part the part
/// \param copy its copy
/// \param g the graph of the copy
/// \param point a function that returns the position of a vertex of the subdivision; its second
///        argument is a position of the type that `g` has
/// \param np may have a `vertex_point_map` of `g`
template <typename Subdivision, typename Graph, typename Point_of, typename NamedParameters>
void write_points(const Subdivision_part<Subdivision>& part,
                  const Copied_part<Subdivision, Graph>& copy, Graph& g, const Point_of& point,
                  const NamedParameters& np)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  const auto map = choose_parameter(get_parameter(np, CGAL::internal_np::vertex_point),
                                    get_property_map(CGAL::vertex_point, g));
  typedef typename boost::property_traits<std::decay_t<decltype(map)>>::value_type Point;
  for(std::size_t n = 0; n < part.vertices().size(); ++n)
    put(map, copy.vertex(n), point(part.vertices()[n], Point()));
}

/// \ingroup PkgIntrinsicTriangulationsSubdivision
/// writes the positions of the vertices of a copied part of a subdivision on the first of its
/// triangulations. It does nothing unless `np` has positions of that triangulation. Complexity:
/// linear.
///
/// \param part the part
/// \param copy its copy
/// \param g the graph of the copy
/// \param weights a function that returns a vertex of the subdivision as a convex combination of
///        vertices for which `input_point_map` has positions, as `Vertex_weights`
/// \param np the property maps, as for `common_subdivision()`
/// \returns whether there are positions
template <typename Subdivision, typename Graph, typename Weights, typename NamedParameters>
bool write_input_points(const Subdivision_part<Subdivision>& part,
                        const Copied_part<Subdivision, Graph>& copy, Graph& g,
                        const Weights& weights, const NamedParameters& np)
{
  typedef internal_np::input_point_map_t Tag;
  constexpr bool has_points = internal::has_parameter<NamedParameters, Tag>();
  if constexpr(has_points) {
    const auto points = CGAL::parameters::get_parameter(np, Tag());
    const auto point = [&](Vertex_index v, const auto&) {
      const auto w = weights(v);
      return internal::linear_value(points, w.vertex, w.weight, w.size);
    };
    write_points(part, copy, g, point, np);
  }
  return has_points;
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_SUBDIVISION_PART_H
