// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_COMMON_SUBDIVISION_H
#define CGAL_INTRINSIC_TRIANGULATIONS_COMMON_SUBDIVISION_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Correspondence.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Face_regions.h>

#include <array>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsSubdivision
/// the polygon mesh into which the edges of \f$T_1\f$ and \f$T_2\f$ together cut the surface
/// (Section 3.3). Its faces are convex polygons with three to six corners, each part of one face of
/// \f$T_1\f$ and one face of \f$T_2\f$.
///
/// Vertices 0 to \f$|V| - 1\f$ are those of \f$T_2\f$, with their numbers, among them those of
/// \f$T_1\f$; vertex \f$|V| + c\f$ is crossing \f$c\f$ of the correspondence. The connectivity is
/// exact; the places of crossings are rounded, and in order along every edge.
///
/// \tparam Traits_ a model of `IntrinsicGeometryTraits`
/// \tparam Point the point type of the mesh
template <typename Traits_ = Euclidean_geometry_traits<double>, typename Point = No_point>
class Common_subdivision
{
public:
  /// the geometry.
  typedef Traits_ Traits;
  /// the type of lengths and barycentric coordinates.
  typedef typename Traits::FT FT;
  /// the type of the mesh.
  typedef Surface_mesh<Point> Mesh;
  /// the type of numbers of elements.
  typedef Delta_complex::size_type size_type;

  /// builds the subdivision. Complexity: linear in the vertices, edges and crossings.
  explicit Common_subdivision(const Correspondence<Traits>& correspondence)
    : m_number_of_input_vertices(correspondence.mesh(Side::input).number_of_vertices()),
      m_number_of_intrinsic_vertices(correspondence.mesh(Side::intrinsic).number_of_vertices())
  {
    Builder(correspondence, *this).build();
  }

  /// copies everything. Complexity: linear.
  Common_subdivision(const Common_subdivision& other)
    : m_number_of_input_vertices(other.m_number_of_input_vertices),
      m_number_of_intrinsic_vertices(other.m_number_of_intrinsic_vertices),
      m_mesh(other.m_mesh)
  {
    attach();
  }

  /// takes everything from `other`. Complexity: constant.
  Common_subdivision(Common_subdivision&& other) = default;
  /// takes everything from `other`. Complexity: constant.
  Common_subdivision& operator=(Common_subdivision&& other) = default;
  /// copies everything. Complexity: linear.
  Common_subdivision& operator=(const Common_subdivision& other)
  {
    return *this = Common_subdivision(other);
  }

  /// the mesh.
  const Mesh& mesh() const { return m_mesh; }

  /// the mesh, for more properties and for points; its connectivity must stay.
  Mesh& mesh() { return m_mesh; }

  /// whether `v` is a vertex of \f$T_1\f$, hence of \f$T_2\f$.
  bool is_input_vertex(Vertex_index v) const { return v.idx() < m_number_of_input_vertices; }

  /// whether `v` is a vertex of \f$T_2\f$, not a crossing.
  bool is_intrinsic_vertex(Vertex_index v) const
  {
    return v.idx() < m_number_of_intrinsic_vertices;
  }

  /// the number of vertices of \f$T_1\f$.
  size_type number_of_input_vertices() const { return m_number_of_input_vertices; }

  /// the number of vertices of \f$T_2\f$.
  size_type number_of_intrinsic_vertices() const { return m_number_of_intrinsic_vertices; }

  /// the place of `v` on edges of both triangulations. Both halfedges are null if `v` is an
  /// isolated vertex; that of \f$T_1\f$ is null if `v` has been inserted inside a face of \f$T_1\f$
  /// (see `Intrinsic_triangulation::inserted_vertex()`).
  const Trace_point<FT>& place(Vertex_index v) const { return m_place[v]; }

  /// the place of `v` on one of them.
  const Edge_point<FT>& place(Side side, Vertex_index v) const
  {
    return side == Side::input ? m_place[v].on_input : m_place[v].on_intrinsic;
  }

  /// the face of `side` of which `f` is a part.
  Face_index parent_face(Side side, Face_index f) const { return m_parent_face[index(side)][f]; }

  /// the edge of `side` of which `e` is a part, or a null edge.
  Edge_index parent_edge(Side side, Edge_index e) const { return m_parent_edge[index(side)][e]; }

  /// cuts every polygon into triangles; the parts keep the parents. Complexity: linear.
  void triangulate()
  {
    const size_type polygons = m_mesh.number_of_faces();
    for(size_type i = 0; i < polygons; ++i)
      triangulate(Face_index(i));
  }

private:
  typedef typename Mesh::template Property_map<Face_index, Face_index> Parent_face_map;
  typedef typename Mesh::template Property_map<Edge_index, Edge_index> Parent_edge_map;

  static std::size_t index(Side side) { return side == Side::input ? 0 : 1; }

  void triangulate(Face_index f)
  {
    const Halfedge_index h = m_mesh.halfedge(f);
    while(m_mesh.next(m_mesh.next(m_mesh.next(h))) != h) {
      internal::cut_ear(h, m_mesh);
      const Face_index ear(static_cast<size_type>(m_mesh.number_of_faces() - 1));
      for(Parent_face_map& parent : m_parent_face)
        parent[ear] = parent[f];
    }
  }

  // (re)binds the property maps to the mesh
  void attach()
  {
    m_place = m_mesh.template add_property_map<Vertex_index, Trace_point<FT>>("v:place").first;
    m_parent_face = {add_face_map("f:input_face"), add_face_map("f:intrinsic_face")};
    m_parent_edge = {add_edge_map("e:input_edge"), add_edge_map("e:intrinsic_edge")};
  }

  Parent_face_map add_face_map(const char* name)
  {
    return m_mesh.template add_property_map<Face_index, Face_index>(name).first;
  }

  Parent_edge_map add_edge_map(const char* name)
  {
    return m_mesh.template add_property_map<Edge_index, Edge_index>(name).first;
  }

  class Builder;

  size_type m_number_of_input_vertices;
  size_type m_number_of_intrinsic_vertices;
  Mesh m_mesh;
  typename Mesh::template Property_map<Vertex_index, Trace_point<FT>> m_place;
  std::array<Parent_face_map, 2> m_parent_face;
  std::array<Parent_edge_map, 2> m_parent_edge;
};

// Cuts each face of T2 into its regions. An edge of T2 with n crossings becomes n + 1 edges, its
// "pieces"; so does a part of an edge of T1, unless it is shared. Those of T1 come first.
template <typename Traits, typename Point>
class Common_subdivision<Traits, Point>::Builder
{
public:
  Builder(const Correspondence<Traits>& correspondence, Common_subdivision& result)
    : m_correspondence(correspondence),
      m_intrinsic(correspondence.mesh(Side::intrinsic)),
      m_input(correspondence.mesh(Side::input)),
      m_result(result),
      m_mesh(result.m_mesh)
  {}

  void build()
  {
    number_pieces();
    m_mesh.resize(m_result.m_number_of_intrinsic_vertices + m_correspondence.number_of_crossings(),
                  m_number_of_pieces, count_regions());
    m_result.attach();
    set_parent_edges();
    set_places();
    for(Face_index f : m_intrinsic.faces())
      add_regions(f);
    link_border();
    link_vertices();
  }

private:
  typedef std::array<Halfedge_index, 3> Sides;

  void number_pieces()
  {
    m_number_of_pieces = m_correspondence.number_of_input_pieces();
    m_first_piece.resize(m_intrinsic.num_edges());
    for(Edge_index e : m_intrinsic.edges()) {
      m_first_piece[e] = m_number_of_pieces;
      m_number_of_pieces += m_correspondence.number_of_crossings(Side::intrinsic, e) + 1;
    }
  }

  // piece `p` of the halfedge `h` of T2, counted from its source
  Halfedge_index intrinsic_piece(Halfedge_index h, size_type p) const
  {
    const Edge_index e(h);
    if(h.idx() % 2 == 0)
      return Halfedge_index(2 * (m_first_piece[e] + p));
    const size_type n = m_correspondence.number_of_crossings(Side::intrinsic, e);
    return Halfedge_index(2 * (m_first_piece[e] + n - p) + 1);
  }

  internal::Face_regions regions(const Sides& side) const
  {
    std::array<std::size_t, 3> crossings;
    for(std::size_t s = 0; s < 3; ++s)
      crossings[s] = m_correspondence.number_of_crossings(Side::intrinsic, Edge_index(side[s]));
    return internal::Face_regions(crossings);
  }

  size_type count_regions() const
  {
    size_type count = 0;
    for(Face_index f : m_intrinsic.faces())
      count += static_cast<size_type>(regions(sides(f, m_intrinsic)).size());
    return count;
  }

  void set_parent_edges()
  {
    auto& parent = m_result.m_parent_edge;
    for(Edge_index e : m_input.edges())
      for(size_type i = 0; i < m_correspondence.number_of_parts(e); ++i) {
        const auto& part = m_correspondence.part(e, i);
        for(size_type p = 0; !part.is_shared && p <= part.count; ++p)
          parent[index(Side::input)][Edge_index(part.first_piece + p)] = e;
      }
    for(Edge_index e : m_intrinsic.edges()) {
      const Halfedge_index h(2 * e.idx());
      for(size_type p = 0; p <= m_correspondence.number_of_crossings(Side::intrinsic, e); ++p)
        parent[index(Side::intrinsic)][m_mesh.edge(intrinsic_piece(h, p))] = e;
      if(m_correspondence.is_shared(Side::intrinsic, e))
        parent[index(Side::input)][m_mesh.edge(intrinsic_piece(h, 0))] =
          m_input.edge(m_correspondence.spoke_before(Side::intrinsic, h));
    }
  }

  void set_places()
  {
    const auto& tri = m_correspondence.triangulation();
    for(Vertex_index v : m_intrinsic.vertices())
      if(!m_intrinsic.is_isolated(v)) {
        const Halfedge_index spoke = first_spoke(v, m_intrinsic);
        m_result.m_place[v] = {tri.start_on_spoke(spoke), {spoke, FT(0)}};
      }
    for(size_type c = 0; c < m_correspondence.number_of_crossings(); ++c)
      m_result.m_place[crossing_vertex(c)] = m_correspondence.crossing(c);
  }

  Vertex_index crossing_vertex(size_type id) const
  {
    return Vertex_index(m_result.m_number_of_intrinsic_vertices + id);
  }

  typename Correspondence<Traits>::Crossing crossing(const internal::Region_corner& corner,
                                                     const Sides& side) const
  {
    return m_correspondence.crossing(Side::intrinsic, side[corner.side],
                                     static_cast<size_type>(corner.mark));
  }

  Vertex_index vertex(const internal::Region_corner& corner, const Sides& side) const
  {
    return corner.is_vertex() ? m_intrinsic.source(side[corner.side])
                              : crossing_vertex(crossing(corner, side).id);
  }

  void add_regions(Face_index parent)
  {
    const Sides side = sides(parent, m_intrinsic);
    const internal::Face_regions face_regions = regions(side);
    for(std::size_t m = 0; m < face_regions.size(); ++m) {
      const Face_index f(m_number_of_faces++);
      m_result.m_parent_face[index(Side::intrinsic)][f] = parent;
      add_region(f, face_regions[m], side);
    }
  }

  void add_region(Face_index f, const internal::Region& region, const Sides& side)
  {
    Face_index input_face = m_correspondence.triangulation().input_location(side[0]).first;
    std::array<Halfedge_index, 6> halfedge;
    for(std::size_t c = 0; c < region.size(); ++c)
      if(region[c].arc_follows) {
        const Halfedge_index arc = input_arc(region[c], region.next(c), side, halfedge[c]);
        input_face = m_input.face(arc);
      } else
        halfedge[c] =
          intrinsic_piece(side[region[c].side],
                          static_cast<size_type>(region[c].is_vertex() ? 0 : region[c].mark + 1));
    for(std::size_t c = 0; c < region.size(); ++c) {
      m_mesh.set_next(halfedge[c], halfedge[c + 1 == region.size() ? 0 : c + 1]);
      m_mesh.set_face(halfedge[c], f);
      m_mesh.set_target(halfedge[c], vertex(region.next(c), side));
    }
    m_mesh.set_halfedge(f, halfedge[0]);
    m_result.m_parent_face[index(Side::input)][f] = input_face;
  }

  // The halfedge of T1 along the curve from one corner of a region to another, and its piece there.
  Halfedge_index input_arc(const internal::Region_corner& from, const internal::Region_corner& to,
                           const Sides& side, Halfedge_index& piece_of_arc) const
  {
    const auto c = crossing(to.is_vertex() ? from : to, side);
    const Halfedge_index outward = c.across.halfedge;
    const size_type before = m_correspondence.piece_before(c.id);
    piece_of_arc = Halfedge_index(outward.idx() % 2 == 0 ? 2 * before : 2 * (before + 1) + 1);
    if(!to.is_vertex())
      return outward;
    piece_of_arc = m_mesh.opposite(piece_of_arc);
    return m_input.opposite(outward);
  }

  // edges on the boundary are shared, hence one piece each
  void link_border()
  {
    for(Halfedge_index h : m_intrinsic.halfedges())
      if(m_intrinsic.is_border(h)) {
        const Halfedge_index x = intrinsic_piece(h, 0);
        m_mesh.set_next(x, intrinsic_piece(m_intrinsic.next(h), 0));
        m_mesh.set_target(x, m_intrinsic.target(h));
      }
  }

  void link_vertices()
  {
    for(Halfedge_index h : m_mesh.halfedges())
      if(m_mesh.is_border(h) || m_mesh.is_isolated(m_mesh.target(h)))
        m_mesh.set_halfedge(m_mesh.target(h), h);
  }

  const Correspondence<Traits>& m_correspondence;
  const Delta_complex& m_intrinsic;
  const Delta_complex& m_input;
  Common_subdivision& m_result;
  Mesh& m_mesh;
  std::vector<size_type> m_first_piece; // of each edge of T2
  size_type m_number_of_pieces = 0;
  size_type m_number_of_faces = 0;
};

} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_COMMON_SUBDIVISION_H
