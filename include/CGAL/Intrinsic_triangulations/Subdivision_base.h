// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_SUBDIVISION_BASE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_SUBDIVISION_BASE_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Edge_point.h>
#include <CGAL/Intrinsic_triangulations/Surface_point.h>

#include <CGAL/Surface_mesh.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsSubdivision
/// a point of a triangulation as a convex combination of one vertex, of the ends of an edge, or of
/// the corners of a face.
template <typename FT>
struct Vertex_weights
{
  std::size_t size;                   ///< the number of vertices
  std::array<Vertex_index, 3> vertex; ///< the vertices
  std::array<FT, 3> weight;           ///< their weights, which sum up to one
};

/// \ingroup PkgIntrinsicTriangulationsSubdivision
/// returns a point as a convex combination of one vertex, of the ends of its edge, or of the
/// corners of its face. Complexity: constant.
template <typename FT>
Vertex_weights<FT> vertex_weights(const Surface_point<FT>& p, const Delta_complex& mesh)
{
  const Halfedge_index along = halfedge_of(p);
  if(is_at_vertex(p))
    return {1, {mesh.source(along)}, {FT(1)}};
  if(const auto* e = on_edge(p))
    return {2, {mesh.source(along), mesh.target(along)}, {1 - e->weight[1], e->weight[1]}};
  const auto& [f, b] = std::get<Face_location<FT>>(p);
  const auto h = sides(f, mesh);
  return {3, {mesh.source(h[0]), mesh.source(h[1]), mesh.source(h[2])}, b};
}

/// \ingroup PkgIntrinsicTriangulationsSubdivision
/// the base of all subdivisions: the polygon mesh into which the edges of two or more
/// triangulations cut a surface. Every face is part of one face of each triangulation.
///
/// A subdivision refers to the triangulations, and its queries are valid until these change.
///
/// \tparam Derived the subdivision
/// \tparam Side_ the enumeration that names the triangulations
/// \tparam number_of_sides the number of triangulations
/// \tparam FT_ the type of barycentric coordinates
/// \tparam Point the point type of the mesh
template <typename Derived, typename Side_, std::size_t number_of_sides, typename FT_,
          typename Point>
class Subdivision_base
{
public:
  /// names one of the triangulations.
  typedef Side_ Side;
  /// the type of barycentric coordinates.
  typedef FT_ FT;
  /// the type of the mesh.
  typedef Surface_mesh<Point> Mesh;
  /// the type of numbers of elements.
  typedef Delta_complex::size_type size_type;

  /// returns the mesh.
  const Mesh& mesh() const { return m_mesh; }

  /// returns the mesh, for properties and for points; its connectivity must stay.
  Mesh& mesh() { return m_mesh; }

  /// returns the connectivity of `side`.
  const Delta_complex& mesh(Side side) const { return *m_side[index(side)]; }

  /// returns the vertex of `side` that equals `v`; null if `side` has no such vertex.
  Vertex_index parent_vertex(Side side, Vertex_index v) const
  {
    return v.idx() < mesh(side).number_of_vertices() ? v : Vertex_index();
  }

  /// returns whether `v` is a vertex of `side`.
  bool is_vertex(Side side, Vertex_index v) const
  {
    return derived().parent_vertex(side, v).is_valid();
  }

  /// returns the face of `side` that contains `f`.
  Face_index parent_face(Side side, Face_index f) const
  {
    return m_parent_face[index(side)][f.idx()];
  }

  /// returns the halfedge of `side` that contains `h`; null if `side` has no such halfedge.
  Halfedge_index parent_halfedge(Side side, Halfedge_index h) const
  {
    const Halfedge_index parent = m_parent_halfedge[index(side)][Edge_index(h).idx()];
    return parent.is_valid() ? oriented_like(h, parent) : parent;
  }

  /// returns the edge of `side` that contains `e`; null if `side` has no such edge.
  Edge_index parent_edge(Side side, Edge_index e) const
  {
    const Halfedge_index parent = m_parent_halfedge[index(side)][e.idx()];
    return parent.is_valid() ? Edge_index(parent) : Edge_index();
  }

  /// returns the barycentric coordinates of the target of `h` in the parent of its face.
  /// Complexity: constant, or linear in the degree of the target.
  /// \pre `h` is not a border halfedge
  std::array<FT, 3> coordinates(Side side, Halfedge_index h) const
  {
    const Vertex_index v = m_mesh.target(h);
    const Surface_point<FT> p = derived().place(side, v);
    if(const auto* inside = std::get_if<Face_location<FT>>(&p))
      return inside->second;
    const bool is_on_parent = on_edge(p) && parent_halfedge(side, h).is_valid();
    const Halfedge_index along = parent_halfedge(side, is_on_parent ? h : parted_outgoing(side, h));
    if(is_at_vertex(p))
      return barycentric_coordinates(side_number(along, mesh(side)), FT(0));
    const Edge_point<FT> q = edge_point(*on_edge(p));
    return face_location(along == q.halfedge ? q : reversed(q, mesh(side)), mesh(side)).second;
  }

  /// returns the position of the target of `h` in the parent of its face, with `coordinates(side,
  /// h)`. The face is null if `h` is a border halfedge.
  Face_location<FT> location(Side side, Halfedge_index h) const
  {
    if(m_mesh.is_border(h))
      return {Face_index(), {}};
    return {parent_face(side, m_mesh.face(h)), derived().coordinates(side, h)};
  }

  /// returns `v` as a convex combination of vertices of `side`. Complexity: constant.
  Vertex_weights<FT> weights(Side side, Vertex_index v) const
  {
    const Vertex_index parent = derived().parent_vertex(side, v);
    if(parent.is_valid())
      return {1, {parent}, {FT(1)}};
    return vertex_weights(derived().place(side, v), mesh(side));
  }

  /// cuts every polygon into triangles; the parts keep the parents. Complexity: linear if polygons
  /// are convex.
  void triangulate()
  {
    const size_type polygons = m_mesh.number_of_faces();
    for(size_type i = 0; i < polygons; ++i) {
      const Face_index f(i);
      while(has_more_than_three_sides(f))
        cut_ear(derived().before_ear(m_mesh.halfedge(f)));
    }
  }

  /// \cond SKIP_IN_MANUAL
protected:
  explicit Subdivision_base(const std::array<const Delta_complex*, number_of_sides>& sides)
    : m_side(sides)
  {}

  static constexpr std::size_t index(Side side) { return static_cast<std::size_t>(side); }

  Vertex_weights<FT> corner_weights(Side side, const Face_location<FT>& p) const
  {
    return vertex_weights(Surface_point<FT>(p), mesh(side));
  }

  // ---- Refined by subdivisions whose polygons are not convex, or that have data at corners ----

  Halfedge_index before_ear(Halfedge_index h) const { return h; }
  void copy_corner(Halfedge_index /*from*/, Halfedge_index /*to*/) {}

  // ---- For builders ----

  void resize_mesh(size_type vertices, size_type edges, size_type faces)
  {
    m_mesh.resize(vertices, edges, faces);
  }

  void reserve_parents(size_type edges, size_type faces)
  {
    for(auto& parents : m_parent_halfedge)
      parents.reserve(edges);
    for(auto& parents : m_parent_face)
      parents.reserve(faces);
  }

  void resize_parents(size_type edges, size_type faces)
  {
    for(auto& parents : m_parent_halfedge)
      parents.assign(edges, Halfedge_index());
    for(auto& parents : m_parent_face)
      parents.assign(faces, Face_index());
  }

  Halfedge_index add_edge()
  {
    for(auto& parents : m_parent_halfedge)
      parents.emplace_back();
    return m_mesh.add_edge();
  }

  // Adds a face whose sides are linked already.
  Face_index add_face(Halfedge_index first, const std::array<Face_index, number_of_sides>& parents)
  {
    const Face_index f = m_mesh.add_face();
    for(auto& p : m_parent_face)
      p.emplace_back();
    set_face(f, first, parents);
    return f;
  }

  // Sets the data of a face whose sides are linked already.
  void set_face(Face_index f, Halfedge_index first,
                const std::array<Face_index, number_of_sides>& parents)
  {
    m_mesh.set_halfedge(f, first);
    for(std::size_t side = 0; side < number_of_sides; ++side)
      m_parent_face[side][f.idx()] = parents[side];
    Halfedge_index h = first;
    do {
      m_mesh.set_face(h, f);
      h = m_mesh.next(h);
    } while(h != first);
  }

  void set_parent(Side side, Halfedge_index h, Halfedge_index parent)
  {
    m_parent_halfedge[index(side)][Edge_index(h).idx()] = oriented_like(h, parent);
  }
  void set_parent(Side side, Face_index f, Face_index parent)
  {
    m_parent_face[index(side)][f.idx()] = parent;
  }

  // Returns the first halfedge on an edge of `side`, clockwise around the target of `h` from the
  // face of `h`.
  Halfedge_index parted_outgoing(Side side, Halfedge_index h) const
  {
    do
      h = opposite(m_mesh.next(h));
    while(!parent_halfedge(side, h).is_valid());
    return opposite(h);
  }
  /// \endcond

private:
  const Derived& derived() const { return static_cast<const Derived&>(*this); }
  Derived& derived() { return static_cast<Derived&>(*this); }

  bool has_more_than_three_sides(Face_index f) const
  {
    const Halfedge_index h = m_mesh.halfedge(f), third = m_mesh.next(m_mesh.next(h));
    return third != h && m_mesh.next(third) != h;
  }

  // Cuts the two sides after `h` off its face.
  void cut_ear(Halfedge_index h)
  {
    const Face_index f = m_mesh.face(h);
    const Halfedge_index second = m_mesh.next(m_mesh.next(h));
    internal::cut_ear(h, m_mesh);
    for(auto& parents : m_parent_halfedge)
      parents.emplace_back();
    for(auto& parents : m_parent_face)
      parents.push_back(parents[f.idx()]);
    derived().copy_corner(second, m_mesh.next(h));
    derived().copy_corner(h, opposite(m_mesh.next(h)));
  }

  std::array<const Delta_complex*, number_of_sides> m_side;
  Mesh m_mesh;
  std::array<std::vector<Face_index>, number_of_sides> m_parent_face;
  std::array<std::vector<Halfedge_index>, number_of_sides> m_parent_halfedge; // of first halfedges
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_SUBDIVISION_BASE_H
