// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_SURFACE_SUBDIVISION_H
#define CGAL_INTRINSIC_SIMPLIFICATION_SURFACE_SUBDIVISION_H

#include <CGAL/license/Intrinsic_simplification.h>

#include <CGAL/Intrinsic_simplification/Subdivision_place.h>
#include <CGAL/Intrinsic_simplification/Surface_level.h>
#include <CGAL/Intrinsic_simplification/Surface_map.h>
#include <CGAL/Intrinsic_simplification/internal/maps/Subdivision_marks.h>
#include <CGAL/Intrinsic_triangulations/Edge_point.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/triangle_formulas.h>

#include <CGAL/Iterator_range.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Intrinsic_simplification {

/// \ingroup PkgIntrinsicSimplificationRef
/// names one of the two levels of a map.
enum class Level
{
  fine,  ///< where the map starts
  coarse ///< where it ends
};

/// \ingroup PkgIntrinsicSimplificationRef
/// the polygon mesh into which the edges of the fine and the coarse level together cut the surface.
/// Each face is part of one face of both levels.
///
/// The vertices are those of the fine level, with their numbers; then the points where edges of the
/// coarse level cross those of the fine level or bend on its surface; then, if they are wanted,
/// those where edges of the fine level bend on the coarse surface. So the polygons have straight
/// sides on the fine surface, and with the last on the coarse surface too. They need not be convex.
///
/// The map from a polygon on one level to the polygon on the other is continuous and one-to-one. It
/// is made of projective pieces that are smaller in general, one for each sequence of faces through
/// which points have gone; where nothing has been scaled it is an isometry.
///
/// The connectivity is that of a subdivision of both levels, always: in which order edges of the
/// coarse level cross an edge of the fine level is told by how these curves separate on their ways,
/// not by the places of the crossings. Those are rounded, and in order along every edge. An edge of
/// the coarse level that comes to a vertex within rounding runs through it, and along an edge of
/// the fine level if it comes to both ends. Where edges nearly coincide otherwise, polygons can
/// have an area as small as rounding, of either sign, and may have two sides only: `signed_area()`
/// tells.
///
/// \tparam Point the point type of the mesh
template <typename Point = Intrinsic_triangulations::No_point>
class Surface_subdivision
{
public:
  /// the type of the mesh.
  typedef Surface_mesh<Point> Mesh;
  /// the type of numbers of elements.
  typedef Delta_complex::size_type size_type;

  /// says at which bends there are vertices.
  enum class Bends
  {
    of_coarse_edges, ///< those of edges of the coarse level on the fine surface
    of_all_edges     ///< those of edges of the fine level on the coarse surface too
  };

  /// builds the subdivision; it refers to the levels of `map`. Complexity: that of tracing the
  /// edges, and the time to sort the crossings on every edge.
  /// \throws Intrinsic_triangulations::Numerical_error if two edges of the coarse level have
  ///   crossed each other by rounding, or if a vertex is not in or next to the coarse face that the
  ///   edges around it tell. On which side of a removed vertex or of a bend an edge passes is
  ///   decided by a rounded number, for each edge by itself; so this needs vertices that are as
  ///   near to each other as rounding.
  explicit Surface_subdivision(const Surface_map& map, Bends bends = Bends::of_coarse_edges)
    : m_levels{&map.fine(), &map.coarse()}
  {
    Builder(map, *this).build(bends == Bends::of_all_edges);
  }

  /// the mesh.
  const Mesh& mesh() const { return m_mesh; }

  /// the mesh, for properties and for points; its connectivity must stay.
  Mesh& mesh() { return m_mesh; }

  /// one of the levels.
  const Surface_level& level(Level side) const { return *m_levels[index(side)]; }

  /// whether `v` is a vertex of the fine level.
  bool is_fine_vertex(Vertex_index v) const
  {
    return v.idx() < level(Level::fine).mesh().number_of_vertices();
  }

  /// whether `v` is a vertex of the coarse level.
  bool is_coarse_vertex(Vertex_index v) const { return coarse_vertex(v).is_valid(); }

  /// the number of `v` in the coarse level; null if it is no vertex there. Complexity: logarithmic.
  Vertex_index coarse_vertex(Vertex_index v) const
  {
    return is_fine_vertex(v)
             ? level(Level::coarse).level_vertex(level(Level::fine).surface_vertex(v))
             : Vertex_index();
  }

  /// the place of `v`; that of an isolated vertex has no face.
  const Subdivision_place& place(Level side, Vertex_index v) const
  {
    return m_place[index(side)][v.idx()];
  }

  /// the face of `side` of which `f` is a part.
  Face_index parent_face(Level side, Face_index f) const
  {
    return m_parent_face[index(side)][f.idx()];
  }

  /// the halfedge of `side` of which `h` is a part, or null.
  Halfedge_index parent_halfedge(Level side, Halfedge_index h) const
  {
    const Halfedge_index parent = m_parent_halfedge[index(side)][h.idx() / 2];
    return parent.is_valid() && h.idx() % 2 == 1 ? level(side).mesh().opposite(parent) : parent;
  }

  /// the halfedges that are the parts of the edge `e` of the coarse level, each beginning where the
  /// one before ends, from the source of its first halfedge to the target. Complexity: constant.
  Iterator_range<std::vector<Halfedge_index>::const_iterator>
  parts_of_coarse_edge(Edge_index e) const
  {
    const auto begin = m_coarse_parts.begin();
    return {begin + m_first_coarse_part[e.idx()], begin + m_first_coarse_part[e.idx() + 1]};
  }

  /// the barycentric coordinates of the target of `h` in the parent of its face. Complexity:
  /// constant, or linear in the degree of the target if it is a vertex of `side`.
  /// \pre `h` is no border halfedge
  std::array<double, 3> coordinates(Level side, Halfedge_index h) const
  {
    const Vertex_index v = m_mesh.target(h);
    const Subdivision_place& p = place(side, v);
    if(!p.along.is_valid())
      return p.location.second;
    const bool is_vertex = side == Level::fine ? is_fine_vertex(v) : is_coarse_vertex(v);
    if(!is_vertex && parent_halfedge(side, h).is_valid())
      return on_side(side, parent_halfedge(side, h), v);
    const Halfedge_index spoke = parent_of_spoke(side, h);
    return is_vertex ? at_source(side, spoke) : on_side(side, spoke, v);
  }

  /// the area of `f` on one of the surfaces, from the places of its vertices. Complexity: linear in
  /// its vertices.
  double signed_area(Level side, Face_index f) const
  {
    const Halfedge_index first = m_mesh.halfedge(f);
    const std::array<double, 3> a = coordinates(side, first);
    double sum = 0;
    std::array<double, 3> b = coordinates(side, m_mesh.next(first));
    for(Halfedge_index h = m_mesh.next(m_mesh.next(first)); h != first; h = m_mesh.next(h)) {
      const std::array<double, 3> c = coordinates(side, h);
      sum += (b[1] - a[1]) * (c[2] - a[2]) - (b[2] - a[2]) * (c[1] - a[1]);
      b = c;
    }
    return sum * area(side, parent_face(side, f));
  }

private:
  static std::size_t index(Level side) { return side == Level::fine ? 0 : 1; }

  // the halfedge of `side` that is next clockwise from the face of `h` around its target
  Halfedge_index parent_of_spoke(Level side, Halfedge_index h) const
  {
    do
      h = m_mesh.opposite(m_mesh.next(h));
    while(!parent_halfedge(side, h).is_valid());
    return parent_halfedge(side, m_mesh.opposite(h));
  }

  // the place of `v` on a side of a face
  std::array<double, 3> on_side(Level side, Halfedge_index h, Vertex_index v) const
  {
    namespace IT = Intrinsic_triangulations;
    const Subdivision_place& p = place(side, v);
    const Delta_complex& mesh = level(side).mesh();
    const IT::Edge_point<double> on_edge = IT::edge_point(p.along, p.location, mesh);
    return IT::face_location(h == p.along ? on_edge : IT::reversed(on_edge, mesh), mesh).second;
  }

  std::array<double, 3> at_source(Level side, Halfedge_index h) const
  {
    std::array<double, 3> result{};
    result[Intrinsic_triangulations::side_number(h, level(side).mesh())] = 1;
    return result;
  }

  double area(Level side, Face_index f) const
  {
    const Delta_complex& mesh = level(side).mesh();
    const auto length = level(side).length_map();
    const Halfedge_index h = mesh.halfedge(f);
    return Intrinsic_triangulations::quadrupled_area(length[mesh.edge(h)],
                                                     length[mesh.edge(mesh.next(h))],
                                                     length[mesh.edge(mesh.prev(h))]) /
           4;
  }

  class Builder;

  std::array<const Surface_level*, 2> m_levels;
  Mesh m_mesh;
  std::array<std::vector<Subdivision_place>, 2> m_place;
  std::array<std::vector<Face_index>, 2> m_parent_face;
  std::array<std::vector<Halfedge_index>, 2> m_parent_halfedge; // of each first halfedge
  std::vector<Halfedge_index> m_coarse_parts;                   // of all edges of the coarse level
  std::vector<std::ptrdiff_t> m_first_coarse_part;              // of each edge, and the end
};

// Lays out the edges: those of the fine level are cut by marks, those of the coarse level are
// chains of pieces in fine faces. The edges around each vertex, in their order, then give the
// faces.
template <typename Point>
class Surface_subdivision<Point>::Builder
{
public:
  Builder(const Surface_map& map, Surface_subdivision& result)
    : m_map(map),
      m_fine(map.fine().mesh()),
      m_coarse(map.coarse().mesh()),
      m_marks(map),
      m_result(result),
      m_mesh(result.m_mesh)
  {}

  void build(bool with_fine_bends)
  {
    m_marks.trace_coarse_edges();
    if(with_fine_bends)
      m_marks.trace_fine_edges();
    m_marks.sort();
    do {
      make_edges();
      link_vertices();
    } while(m_marks.merge_bigons(m_mesh));
    collect_coarse_parts();
    make_faces();
    check_connectivity();
    set_coarse_parents();
    set_places();
  }

private:
  typedef internal::Subdivision_marks Marks;

  void make_edges()
  {
    m_mesh = Mesh();
    m_mesh.resize(m_marks.number_of_vertices(), m_marks.number_of_edges(), 0);
    m_result.m_parent_halfedge = {std::vector<Halfedge_index>(m_mesh.number_of_edges()),
                                  std::vector<Halfedge_index>(m_mesh.number_of_edges())};
    for(Edge_index e : m_fine.edges())
      for(size_type p = 0; p < m_marks.number_of_pieces(e); ++p)
        parent(Level::fine, m_marks.fine_piece(m_fine.halfedge(e, 0), p)) = m_fine.halfedge(e, 0);
    for(Edge_index e : m_coarse.edges())
      for(size_type p = m_marks.first_piece(e); p < m_marks.end_of_pieces(e); ++p) {
        const Halfedge_index h = m_marks.coarse_piece(p);
        parent(Level::coarse, h) = m_coarse.halfedge(e, h.idx() % 2);
      }
  }

  // of the first halfedge of the edge of `h`
  Halfedge_index& parent(Level side, Halfedge_index h)
  {
    return m_result.m_parent_halfedge[index(side)][h.idx() / 2];
  }

  void link_vertices()
  {
    std::vector<Halfedge_index> out;
    for(Vertex_index v : m_mesh.vertices()) {
      m_marks.collect_spokes(v, out);
      for(std::size_t n = 0; n < out.size(); ++n) {
        const Halfedge_index in = m_mesh.opposite(out[n]);
        m_mesh.set_next(in, out[n == 0 ? out.size() - 1 : n - 1]);
        m_mesh.set_target(in, v);
        m_mesh.set_halfedge(v, in);
      }
    }
  }

  void collect_coarse_parts()
  {
    std::vector<Halfedge_index>& parts = m_result.m_coarse_parts;
    for(Edge_index e : m_coarse.edges()) {
      m_result.m_first_coarse_part.push_back(static_cast<std::ptrdiff_t>(parts.size()));
      for(size_type p = m_marks.first_piece(e); p < m_marks.end_of_pieces(e); ++p)
        parts.push_back(m_marks.coarse_piece(p));
    }
    m_result.m_first_coarse_part.push_back(static_cast<std::ptrdiff_t>(parts.size()));
  }

  bool is_on_border(Halfedge_index h) const
  {
    const Halfedge_index parent = m_result.parent_halfedge(Level::fine, h);
    return parent.is_valid() && m_fine.is_border(parent);
  }

  void make_faces()
  {
    for(Halfedge_index h : m_mesh.halfedges())
      if(m_mesh.is_border(h) && !is_on_border(h)) {
        const Face_index f = m_mesh.add_face();
        m_mesh.set_halfedge(f, h);
        m_result.m_parent_face[0].push_back(
          m_marks.fine_face(h, m_result.parent_halfedge(Level::fine, h)));
        Halfedge_index side = h;
        do
          m_mesh.set_face(side, f);
        while((side = m_mesh.next(side)) != h);
      }
    for(Halfedge_index h : m_mesh.halfedges())
      if(m_mesh.is_border(h))
        m_mesh.set_halfedge(m_mesh.target(h), h);
  }

  // Edges that cross each other where they should not would make handles.
  void check_connectivity() const
  {
    const auto characteristic = [](const auto& mesh) {
      return std::ptrdiff_t(mesh.number_of_vertices()) - std::ptrdiff_t(mesh.number_of_edges()) +
             std::ptrdiff_t(mesh.number_of_faces());
    };
    if(characteristic(m_mesh) != characteristic(m_fine))
      fail();
  }

  [[noreturn]] static void fail()
  {
    throw Intrinsic_triangulations::Numerical_error(
      "edges of the coarse level have crossed each other by rounding");
  }

  // the boundary is the same on both levels
  Face_index face_across(Halfedge_index h) const
  {
    if(m_mesh.is_border(m_mesh.opposite(h)))
      fail();
    return m_mesh.face(m_mesh.opposite(h));
  }

  // A face beside an edge of the coarse level has its parent from there, and hands it on across
  // other edges.
  void set_coarse_parents()
  {
    std::vector<Face_index>& parents = m_result.m_parent_face[1];
    parents.assign(m_mesh.number_of_faces(), Face_index());
    std::vector<Face_index> waiting;
    const auto set = [&](Face_index f, Face_index coarse_face) {
      if(parents[f] == coarse_face)
        return;
      if(parents[f].is_valid())
        fail();
      parents[f] = coarse_face;
      waiting.push_back(f);
    };
    for(Halfedge_index h : m_mesh.halfedges()) {
      const Halfedge_index parent = m_result.parent_halfedge(Level::coarse, h);
      if(parent.is_valid() && !m_mesh.is_border(h))
        set(m_mesh.face(h), m_coarse.face(parent));
    }
    while(!waiting.empty()) {
      const Face_index f = waiting.back();
      waiting.pop_back();
      for(Halfedge_index h : CGAL::halfedges_around_face(m_mesh.halfedge(f), m_mesh))
        if(!m_result.parent_halfedge(Level::coarse, h).is_valid())
          set(face_across(h), parents[f]);
    }
  }

  void set_places()
  {
    for(Vertex_index v : m_mesh.vertices()) {
      m_result.m_place[0].push_back(m_marks.fine_place(v));
      m_result.m_place[1].push_back(m_marks.coarse_place(v));
      if(!m_mesh.is_isolated(v) && !m_result.m_place[1].back().along.is_valid())
        move_into_parent(v, m_result.m_place[1].back().location);
    }
  }

  // A point inside a coarse face, by what is around it, may have come to the other side of an edge
  // by rounding.
  void move_into_parent(Vertex_index v, Surface_map::Location& p) const
  {
    const Halfedge_index in = m_mesh.halfedge(v);
    const Face_index f =
      m_result.m_parent_face[1][m_mesh.face(m_mesh.is_border(in) ? m_mesh.opposite(in) : in)];
    if(p.first != f)
      p = internal::moved_into(f, p, m_coarse);
    if(!p.first.is_valid())
      fail();
  }

  const Surface_map& m_map;
  const Delta_complex &m_fine, &m_coarse;
  Marks m_marks;
  Surface_subdivision& m_result;
  Mesh& m_mesh;
};

} // namespace Intrinsic_simplification
} // namespace CGAL

#endif // CGAL_INTRINSIC_SIMPLIFICATION_SURFACE_SUBDIVISION_H
