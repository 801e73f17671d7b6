// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_TUFTED_COVER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_TUFTED_COVER_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/internal/covers/Soup_sides.h>

#include <CGAL/number_utils.h>

#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

template <typename P>
class Cover_builder;

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsCovers
/// the tufted cover of a soup of triangles \cgalCite{SC20}, made by `tufted_cover()`. It is a
/// closed oriented triangulated surface with two faces for each triangle, its front and its back.
///
/// Any number of triangles can meet at an edge and any number of fans at a vertex, and orientations
/// need not agree. Around each edge, facing sides of consecutive triangles are glued. So the cover
/// of an oriented manifold mesh consists of two copies of it, which are glued along the boundary. A
/// vertex of the soup has a vertex of the cover for each vertex fan of glued faces around it, none
/// if it is isolated. Loops and parallel edges occur.
///
/// Triangle \f$t\f$ has the faces \f$2t\f$, which is oriented as the triangle, and \f$2t+1\f$. Edge
/// \f$3t+i\f$ is a copy of the side from corner \f$i\f$ of triangle \f$t\f$ to the next corner.
///
/// \tparam P the type of points of the soup, or `No_point`
template <typename P>
class Tufted_cover
{
public:
  /// the type of the mesh.
  typedef Surface_mesh<P> Mesh;

  /// returns the surface, to be read by `Intrinsic_triangulation`. It is a valid Delta-complex; its
  /// vertices have the points of the soup, if there are any.
  const Mesh& mesh() const { return m_mesh; }

  /// returns the number of vertices of the soup.
  std::size_t number_of_input_vertices() const { return m_number_of_input_vertices; }

  /// returns the index of the vertex of the soup that belongs to the vertex `v` of the cover.
  /// Vertices that have been inserted into a triangulation of the cover come after the vertices of
  /// the soup, in their order.
  std::size_t input_vertex(Vertex_index v) const
  {
    const std::size_t i = v.idx(), n = m_input_vertex.size();
    return i < n ? m_input_vertex[i] : m_number_of_input_vertices + (i - n);
  }

  /// returns the index of the triangle whose front or back is the face `f` of `mesh()`.
  static std::size_t input_face(Face_index f) { return f.idx() / 2; }

  /// returns whether the face `f` of `mesh()` is a back, which is oriented against its triangle.
  static bool is_back(Face_index f) { return f.idx() % 2 == 1; }

  /// returns the triangle and its side that the halfedge `h` of `mesh()` copies. Side \f$i\f$
  /// joins corner \f$i\f$ to the next.
  std::pair<std::size_t, std::size_t> input_side(Halfedge_index h) const
  {
    const Face_index f = m_mesh.face(h);
    const std::size_t steps = side_number(h, m_mesh);
    return {input_face(f), is_back(f) ? (3 - steps) % 3 : steps};
  }

  /// returns a property map of the lengths of the edges of `mesh()`, for the named parameter
  /// `edge_length_map` of `Intrinsic_triangulation`. Complexity: linear.
  /// \param lengths for each triangle the lengths of its sides, in their order; the map refers to
  ///   it
  /// \throws Invalid_input if triangles at an edge differ in its length
  template <typename Lengths>
  auto edge_length_map(const Lengths& lengths) const
  {
    for(Edge_index e : m_mesh.edges()) {
      const auto [t, i] = input_side(first_halfedge(e));
      const auto [u, j] = input_side(opposite(first_halfedge(e)));
      if(lengths[t][i] != lengths[u][j])
        throw Invalid_input("faces " + std::to_string(t) + " and " + std::to_string(u) +
                            " differ in the length of an edge");
    }
    return boost::make_function_property_map<Edge_index>(
      [&lengths](Edge_index e) { return lengths[e.idx() / 3][e.idx() % 3]; });
  }

private:
  friend class internal::Cover_builder<P>;

  Tufted_cover() = default;

  Mesh m_mesh;
  std::size_t m_number_of_input_vertices = 0;
  std::vector<std::size_t> m_input_vertex;
};

namespace internal {

// Links the copies of triangles. Side s has copy 2 s in the front of its triangle and copy 2 s + 1
// in the back.
template <typename P>
class Cover_builder
{
  typedef Soup_sides::Index Index;

public:
  // `order` sorts the sides of an edge that has more than two.
  template <typename Order>
  Cover_builder(const Soup_sides& sides, const Order& order)
    : m_sides(sides),
      m_before(sides.sides_before(order)),
      m_copies(2 * sides.number_of_sides(), Copy{0, no_vertex})
  {
    glue();
  }

  // `point(v)` is the point of vertex `v` of the soup.
  template <typename Vertex_point>
  Tufted_cover<P> operator()(std::size_t number_of_vertices, const Vertex_point& point)
  {
    m_cover.m_number_of_input_vertices = number_of_vertices;
    const std::vector<Index> incoming = find_vertices(number_of_vertices);
    Surface_mesh<P>& mesh = m_cover.m_mesh;
    mesh.resize(static_cast<Index>(incoming.size()), static_cast<Index>(m_before.size()),
                static_cast<Index>(2 * m_sides.number_of_triangles()));
    for(Index c = 0; c < m_copies.size(); c += 6) {
      add_face(Face_index(c / 3), {c, c + 2, c + 4});
      add_face(Face_index(c / 3 + 1), {c + 1, c + 5, c + 3});
    }
    for(Index v = 0; v < incoming.size(); ++v) {
      mesh.set_halfedge(Vertex_index(v), halfedge(incoming[v]));
      mesh.point(Vertex_index(v)) = point(m_cover.m_input_vertex[v]);
    }
    return std::move(m_cover);
  }

private:
  static constexpr Index no_vertex = (std::numeric_limits<Index>::max)();

  struct Copy
  {
    Index opposite; // the copy to which it is glued
    Index target;
  };

  // Returns whether a copy leads to the greater vertex.
  bool ascends(Index c) const { return m_sides.ascends(c / 2) != (c % 2 == 1); }

  // Returns the next copy in its face.
  static Index next(Index c)
  {
    constexpr std::array<Index, 6> step{2, 4, 2, Index(-2), Index(-4), Index(-2)};
    return c + step[c % 6]; // modulo the range of the type
  }

  // Returns the halfedge of a copy. It is branch-free, because orientations of soups cannot be
  // predicted.
  Halfedge_index halfedge(Index c) const
  {
    return Halfedge_index(std::array{2 * m_before[c / 2] + 1, c - c % 2}[ascends(c)]);
  }

  // Glues the copy of a side that leads to the smaller vertex to the other copy of the previous
  // side.
  void glue()
  {
    for(Index side = 0; side < m_before.size(); ++side) {
      const Index down = 2 * side + (m_sides.ascends(side) ? 1 : 0);
      const Index up = 2 * m_before[side] + (m_sides.ascends(m_before[side]) ? 0 : 1);
      m_copies[down].opposite = up;
      m_copies[up].opposite = down;
    }
  }

  // Returns for each vertex of the cover a copy that leads to it.
  std::vector<Index> find_vertices(std::size_t number_of_input_vertices)
  {
    std::vector<Index> incoming;
    incoming.reserve(2 * number_of_input_vertices);
    m_cover.m_input_vertex.reserve(2 * number_of_input_vertices);
    for(std::size_t t = 0; t < m_sides.number_of_triangles(); ++t)
      for(std::size_t i = 0; i < 3; ++i) {
        const auto c = static_cast<Index>(6 * t + 2 * i);
        for(const Index x : {i == 0 ? c + 4 : c - 2, c + 1})
          if(m_copies[x].target == no_vertex) {
            set_target_of_fan(x, static_cast<Index>(incoming.size()));
            incoming.push_back(x);
            m_cover.m_input_vertex.push_back(m_sides.corner(t, i));
          }
      }
    return incoming;
  }

  void set_target_of_fan(Index first, Index v)
  {
    Index c = first;
    do {
      m_copies[c].target = v;
      c = m_copies[next(c)].opposite;
    } while(c != first);
  }

  void add_face(Face_index f, const std::array<Index, 3>& copies)
  {
    Surface_mesh<P>& mesh = m_cover.m_mesh;
    const std::array<Halfedge_index, 3> h{halfedge(copies[0]), halfedge(copies[1]),
                                          halfedge(copies[2])};
    set_triangle(h[0], h[1], h[2], f, mesh);
    for(std::size_t i = 0; i < 3; ++i)
      mesh.set_target(h[i], Vertex_index(m_copies[copies[i]].target));
  }

  const Soup_sides& m_sides;
  std::vector<Index> m_before; // of each side, the one before it around its edge
  std::vector<Copy> m_copies;
  Tufted_cover<P> m_cover;
};

// Sorts the sides of an edge by the angles of their triangles, seen along the edge from its greater
// vertex to the smaller.
template <typename Points>
void sort_by_angle(const Points& points, const Soup_sides& sides, Soup_sides::Bundle& bundle)
{
  typedef std::decay_t<decltype(points[0])> Point;
  typedef Wing_order<Point> Order;
  const Soup_sides::Index s = bundle.front();
  Order order(points[(std::min)(sides.source(s), sides.target(s))],
              points[(std::max)(sides.source(s), sides.target(s))]);
  const auto apex = [&](Soup_sides::Index side) { return points[sides.apex(side)]; };
  const auto reference = std::find_if(bundle.begin(), bundle.end(), [&](Soup_sides::Index side) {
    return order.has_plane(apex(side));
  });
  if(reference == bundle.end())
    return;
  order.set_reference(apex(*reference));
  std::vector<typename Order::Wing> wings;
  for(const Soup_sides::Index side : bundle)
    wings.push_back(order.wing(apex(side), side));
  std::sort(wings.begin(), wings.end(), order);
  for(std::size_t i = 0; i < bundle.size(); ++i)
    bundle[i] = static_cast<Soup_sides::Index>(wings[i].index);
}

// Checks that coordinates are finite, because comparisons of angles need numbers.
template <typename Points>
void check_finite(const Points& points)
{
  for(std::size_t v = 0; v < points.size(); ++v)
    if(!CGAL::is_finite(points[v].x()) || !CGAL::is_finite(points[v].y()) ||
       !CGAL::is_finite(points[v].z()))
      throw Invalid_input("a coordinate of vertex " + std::to_string(v) +
                          " is infinite or not a number");
}

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsCovers
/// computes the tufted cover of triangles with positions. Around an edge, triangles follow each
/// other by their angles, which are compared exactly. Triangles with one angle are stacked by
/// their indices, in the direction of a normal of their plane. The first nonzero component of this
/// normal is positive. Triangles without a plane come last. Complexity: linear, plus sorting the
/// triangles at each edge that has more than two.
/// \param points a random access range of points of a kernel. Predicates are exact for
///   floating-point coordinates; for other coordinates, the kernel has the predicates
/// \param triangles a range of ranges of three integers, the indices of points
/// \throws Invalid_input if a face is not a triangle, names a vertex twice, or names one that does
///   not exist, or a coordinate is not finite
/// \throws std::length_error if there are more faces than indices of halfedges allow
template <typename PointRange, typename TriangleRange>
auto tufted_cover(const PointRange& points, const TriangleRange& triangles)
  -> std::enable_if_t<!std::is_integral_v<PointRange>,
                      Tufted_cover<std::decay_t<decltype(points[0])>>>
{
  typedef std::decay_t<decltype(points[0])> Point;
  internal::check_finite(points);
  const internal::Soup_sides sides(points.size(), triangles);
  const auto order = [&](internal::Soup_sides::Bundle& bundle) {
    internal::sort_by_angle(points, sides, bundle);
  };
  return internal::Cover_builder<Point>(sides, order)(points.size(),
                                                      [&](std::size_t v) { return points[v]; });
}

/// \ingroup PkgIntrinsicTriangulationsCovers
/// computes the tufted cover of triangles without positions. `Tufted_cover::edge_length_map()` maps
/// lengths to it. Around an edge, triangles follow each other by their indices. If an edge has more
/// than two triangles, the order determines the surface. Complexity: linear.
/// \param number_of_vertices the number of vertices, isolated ones included
/// \param triangles a range of ranges of three integers, the indices of vertices
/// \throws Invalid_input if a face is not a triangle, names a vertex twice, or names one that does
///   not exist
/// \throws std::length_error if there are more faces than indices of halfedges allow
template <typename TriangleRange>
Tufted_cover<No_point> tufted_cover(std::size_t number_of_vertices, const TriangleRange& triangles)
{
  const internal::Soup_sides sides(number_of_vertices, triangles);
  return internal::Cover_builder<No_point>(sides, [](const auto&) {})(
    number_of_vertices, [](std::size_t) { return No_point(); });
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_TUFTED_COVER_H
