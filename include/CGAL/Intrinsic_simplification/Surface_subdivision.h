// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_SURFACE_SUBDIVISION_H
#define CGAL_INTRINSIC_SIMPLIFICATION_SURFACE_SUBDIVISION_H

#include <CGAL/license/Intrinsic_simplification.h>

#include <CGAL/Intrinsic_simplification/Surface_level.h>
#include <CGAL/Intrinsic_simplification/Surface_map.h>
#include <CGAL/Intrinsic_simplification/internal/maps/Marked_fine_edges.h>
#include <CGAL/Intrinsic_simplification/internal/maps/Vertex_rotation.h>
#include <CGAL/Intrinsic_simplification/internal/maps/largest_ear.h>
#include <CGAL/Intrinsic_simplification/internal/maps/vertex_places.h>
#include <CGAL/Intrinsic_triangulations/Edge_point.h>
#include <CGAL/Intrinsic_triangulations/Flat_face.h>
#include <CGAL/Intrinsic_triangulations/Subdivision_base.h>
#include <CGAL/Intrinsic_triangulations/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/internal/validity/Delta_complex_defect.h>

#include <CGAL/Iterator_range.h>

#include <array>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_simplification {

/// \ingroup PkgIntrinsicSimplificationRef
/// names one of the two levels of a map.
enum class Level
{
  fine,  ///< the level on which the map starts
  coarse ///< the level on which it ends
};

/// \ingroup PkgIntrinsicSimplificationRef
/// the polygon mesh into which the edges of the fine and the coarse level together cut the surface.
/// Each face is part of one face of both levels.
///
/// The vertices come in this order:
/// - vertices of the fine level, with their indices;
/// - vertices that only the coarse level has, in their order;
/// - points at which edges of the coarse level cross edges of the fine level or bend on its
///   surface;
/// - on request, points at which edges of the fine level bend on the coarse surface.
///
/// So the polygons have straight sides on the fine surface. With the last vertices, they have
/// straight sides on the coarse surface too. They need not be convex.
///
/// The map from a polygon on one level to the polygon on the other is continuous and one-to-one. In
/// general it consists of several projective pieces, one for each sequence of faces that contained
/// a point. Without scaling, it is an isometry.
///
/// The connectivity is always a subdivision of both levels. The crossing curves determine the order
/// of crossings on an edge of the fine level, not the rounded positions. Positions are rounded, and
/// in order along every edge. An edge of the coarse level runs through each vertex that it passes
/// within rounding. It runs along an edge of the fine level if it runs through both ends. Where
/// vertices are closer than rounding, such edges may cross each other. Then no edge is moved to a
/// vertex, or edges are traced with 32 digits, and at last with 60. Between other edges that nearly
/// coincide, polygons can have areas as small as rounding, of either sign (see `signed_area()`).
/// They may have only two sides.
///
/// The object refers to the levels of the map, and is valid during their lifetime.
///
/// \tparam Point the point type of the mesh
template <typename Point = Intrinsic_triangulations::No_point>
class Surface_subdivision
  : public Intrinsic_triangulations::Subdivision_base<Surface_subdivision<Point>, Level, 2, double,
                                                      Point>
{
  typedef Intrinsic_triangulations::Subdivision_base<Surface_subdivision, Level, 2, double, Point>
    Base;
  friend Base;

public:
  /// the type of indices of elements.
  typedef typename Base::size_type size_type;

  /// the bends that become vertices.
  enum class Bends
  {
    of_coarse_edges, ///< bends of edges of the coarse level on the fine surface
    of_all_edges     ///< also bends of edges of the fine level on the coarse surface
  };

  /// builds the subdivision. Complexity: the time to trace the edges, and to sort the crossings on
  /// every edge.
  /// \throws Intrinsic_triangulations::Numerical_error if edges of the coarse level cross each
  ///   other by rounding, and change too often to be traced with more digits. This needs vertices
  ///   as close to each other as rounding
  explicit Surface_subdivision(const Surface_map& map, Bends bends = Bends::of_coarse_edges)
    : Surface_subdivision(Empty(), map)
  {
    using internal::Tracing_mode;
    if(!succeeds(map, bends, Tracing_mode::through_near_vertices) &&
       !succeeds(map, bends, Tracing_mode::in_double) &&
       !succeeds(map, bends, Tracing_mode::in_double_double))
      build(map, bends, Tracing_mode::in_60_digits);
  }

  /// returns one of the levels.
  const Surface_level& level(Level side) const { return *m_levels[Base::index(side)]; }

  /// returns the vertex of `side` that corresponds to `v`, or null. Complexity: logarithmic for the
  /// coarse level.
  Vertex_index parent_vertex(Level side, Vertex_index v) const
  {
    const Vertex_index fine = Base::parent_vertex(Level::fine, v);
    if(side == Level::fine)
      return fine;
    if(fine.is_valid())
      return level(Level::coarse).level_vertex(level(Level::fine).surface_vertex(fine));
    const size_type n = v.idx() - this->mesh(Level::fine).number_of_vertices();
    return n < m_new_vertices.size() ? m_new_vertices[n] : Vertex_index();
  }

  /// returns the position of `v`.
  const Intrinsic_triangulations::Surface_point<double>& place(Level side, Vertex_index v) const
  {
    return m_place[Base::index(side)][v.idx()];
  }

  /// returns the barycentric coordinates of the target of `h` in the parent of its face.
  /// Complexity: constant, or linear in the degree of the target.
  /// \pre `h` is not a border halfedge
  std::array<double, 3> coordinates(Level side, Halfedge_index h) const
  {
    const Vertex_index v = this->mesh().target(h);
    if(side == Level::fine || !has_places_on_edges(v))
      return Base::coordinates(side, h);
    const Halfedge_index outgoing = this->parted_outgoing(side, h);
    const Halfedge_index parent = this->parent_halfedge(side, outgoing);
    const auto found = m_places_on_edges.find({v, Edge_index(outgoing)});
    const auto p = found != m_places_on_edges.end()
                     ? Intrinsic_triangulations::edge_point(parent, found->second)
                     : Intrinsic_triangulations::Edge_point<double>{parent, 0};
    return Intrinsic_triangulations::face_location(p, this->mesh(side)).second;
  }

  /// returns the parts of the edge `e` of the coarse level as halfedges, in order from the source
  /// of its first halfedge to the target. Complexity: constant.
  Iterator_range<std::vector<Halfedge_index>::const_iterator>
  parts_of_coarse_edge(Edge_index e) const
  {
    const auto begin = m_coarse_parts.begin() + m_first_coarse_part[e.idx()];
    return {begin, m_coarse_parts.begin() + m_first_coarse_part[e.idx() + 1]};
  }

  /// returns the area of `f` on one of the surfaces, from the positions of its vertices.
  /// Complexity: linear in its vertices.
  double signed_area(Level side, Face_index f) const
  {
    const Halfedge_index first = this->mesh().halfedge(f);
    const std::array<double, 3> a = this->coordinates(side, first);
    double sum = 0;
    std::array<double, 3> b = this->coordinates(side, this->mesh().next(first));
    for(Halfedge_index h = this->mesh().next(this->mesh().next(first)); h != first;
        h = this->mesh().next(h)) {
      const std::array<double, 3> c = this->coordinates(side, h);
      sum += internal::relative_area(a, b, c);
      b = c;
    }
    return sum *
           Intrinsic_triangulations::Face_metric<double>(this->parent_face(side, f), level(side))
             .area();
  }

private:
  struct Empty
  {};

  Surface_subdivision(Empty, const Surface_map& map)
    : Base({&map.fine().mesh(), &map.coarse().mesh()}), m_levels{&map.fine(), &map.coarse()}
  {}

  void build(const Surface_map& map, Bends bends, internal::Tracing_mode mode)
  {
    const internal::Marked_fine_edges edges(map, bends == Bends::of_all_edges, mode);
    Builder(edges, *this).build();
  }

  // Returns whether no edges cross each other in this mode. Otherwise the
  // subdivision is empty again.
  bool succeeds(const Surface_map& map, Bends bends, internal::Tracing_mode mode)
  {
    try {
      build(map, bends, mode);
      return true;
    } catch(const Intrinsic_triangulations::Numerical_error&) {
      *this = Surface_subdivision(Empty(), map);
      return false;
    }
  }

  // Stores a vertex inside an edge of the coarse level, and a part of this edge that ends at the
  // vertex.
  typedef std::pair<Vertex_index, Edge_index> End_of_part;

  bool has_places_on_edges(Vertex_index v) const
  {
    const auto first = m_places_on_edges.lower_bound({v, Edge_index(0)});
    return first != m_places_on_edges.end() && first->first.first == v;
  }

  // ---- Triangulation ----

  // Returns the halfedge before the largest ear on the fine surface.
  Halfedge_index before_ear(Halfedge_index first) const
  {
    std::vector<Halfedge_index> sides;
    std::vector<std::array<double, 3>> corners; // at their targets
    for(Halfedge_index h : CGAL::halfedges_around_face(first, this->mesh())) {
      sides.push_back(h);
      corners.push_back(this->coordinates(Level::fine, h));
    }
    return sides[internal::largest_ear(corners)];
  }

  class Builder;

  std::array<const Surface_level*, 2> m_levels;
  std::vector<Vertex_index> m_new_vertices; // vertices of the coarse level only
  std::array<std::vector<Intrinsic_triangulations::Surface_point<double>>, 2> m_place;
  // Stores positions on the first halfedge of the edge, for vertices with more than m_place.
  std::map<End_of_part, double> m_places_on_edges;
  std::vector<Halfedge_index> m_coarse_parts;      // of all edges of the coarse level
  std::vector<std::ptrdiff_t> m_first_coarse_part; // of each edge, and the end
};

// Lays out the edges. Marks cut edges of the fine level. Edges of the coarse level are chains of
// pieces in fine faces. The cyclic order of edges around each vertex then determines the faces.
template <typename Point>
class Surface_subdivision<Point>::Builder
{
public:
  Builder(const internal::Marked_fine_edges& edges, Surface_subdivision& result)
    : m_edges(edges),
      m_rotation(edges),
      m_fine(result.mesh(Level::fine)),
      m_coarse(result.mesh(Level::coarse)),
      m_result(result),
      m_mesh(result.mesh())
  {}

  void build()
  {
    m_result.m_new_vertices = m_edges.new_vertices();
    do {
      make_edges();
      link_vertices();
    } while(m_rotation.merge_bigons(m_mesh));
    collect_coarse_parts();
    make_faces();
    check_connectivity();
    set_coarse_parents();
    set_places();
    set_places_on_edges();
  }

private:
  void make_edges()
  {
    m_result.resize_mesh(m_edges.number_of_vertices(), m_rotation.number_of_edges(), 0);
    m_result.resize_parents(m_rotation.number_of_edges(), 0);
    for(Edge_index e : m_fine.edges()) {
      const Halfedge_index h = Intrinsic_triangulations::first_halfedge(e);
      for(size_type p = 0; p < m_edges.kept().number_of_pieces(e); ++p)
        m_result.set_parent(Level::fine, m_edges.kept().piece(h, p), h);
    }
    for(Edge_index e : m_coarse.edges())
      for(size_type p = m_edges.first_piece(e); p < m_edges.end_of_pieces(e); ++p)
        m_result.set_parent(Level::coarse, m_rotation.coarse_piece(p),
                            Intrinsic_triangulations::first_halfedge(e));
  }

  void link_vertices()
  {
    std::vector<Halfedge_index> out;
    for(Vertex_index v : m_mesh.vertices()) {
      m_rotation.collect_outgoing_halfedges(v, out);
      for(std::size_t n = 0; n < out.size(); ++n) {
        const Halfedge_index in = m_mesh.opposite(out[n]);
        m_mesh.set_next(in, out[n == 0 ? out.size() - 1 : n - 1]);
        m_mesh.set_target(in, v);
        m_mesh.set_halfedge(v, in);
      }
    }
    for(Halfedge_index h : m_mesh.halfedges())
      if(!m_mesh.next(h).is_valid())
        fail();
  }

  void collect_coarse_parts()
  {
    std::vector<Halfedge_index>& parts = m_result.m_coarse_parts;
    for(Edge_index e : m_coarse.edges()) {
      m_result.m_first_coarse_part.push_back(static_cast<std::ptrdiff_t>(parts.size()));
      for(size_type p = m_edges.first_piece(e); p < m_edges.end_of_pieces(e); ++p)
        parts.push_back(m_rotation.coarse_piece(p));
    }
    m_result.m_first_coarse_part.push_back(static_cast<std::ptrdiff_t>(parts.size()));
  }

  // Returns the face of the fine level on the left of `h`, or null beyond the boundary.
  Face_index fine_face(Halfedge_index h) const
  {
    const Halfedge_index parent = m_result.parent_halfedge(Level::fine, h);
    return parent.is_valid() ? m_fine.face(parent) : m_rotation.piece_of_chord(h).segment.face;
  }

  void make_faces()
  {
    for(Halfedge_index h : m_mesh.halfedges())
      if(m_mesh.is_border(h) && fine_face(h).is_valid())
        m_result.add_face(h, {fine_face(h), Face_index()});
    for(Halfedge_index h : m_mesh.halfedges())
      if(m_mesh.is_border(h))
        m_mesh.set_halfedge(m_mesh.target(h), h);
  }

  // Checks the topology: edges that cross each other incorrectly would create handles.
  void check_connectivity() const
  {
    using Intrinsic_triangulations::internal::Euler_characteristic;
    if(Euler_characteristic(m_mesh) != Euler_characteristic(m_fine))
      fail();
  }

  [[noreturn]] static void fail()
  {
    throw Intrinsic_triangulations::Numerical_error(
      "by rounding, edges of the coarse level cross each other");
  }

  // The boundary is the same on both levels.
  Face_index face_across(Halfedge_index h) const
  {
    if(m_mesh.is_border(m_mesh.opposite(h)))
      fail();
    return m_mesh.face(m_mesh.opposite(h));
  }

  // Sets the parent faces. A face beside an edge of the coarse level gets its parent from this
  // edge, and passes it on across other edges.
  void set_coarse_parents()
  {
    std::vector<Face_index> waiting;
    const auto set = [&](Face_index f, Face_index coarse_face) {
      const Face_index parent = m_result.parent_face(Level::coarse, f);
      if(parent == coarse_face)
        return;
      if(parent.is_valid())
        fail();
      m_result.set_parent(Level::coarse, f, coarse_face);
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
          set(face_across(h), m_result.parent_face(Level::coarse, f));
    }
  }

  void set_places()
  {
    for(Vertex_index v : m_mesh.vertices()) {
      m_result.m_place[0].push_back(internal::fine_place(v, m_edges));
      m_result.m_place[1].push_back(internal::coarse_place(v, m_edges));
      auto* inside = std::get_if<Surface_map::Location>(&m_result.m_place[1].back());
      if(inside && !m_mesh.is_isolated(v))
        move_into_parent(v, *inside);
    }
  }

  // Moves a point into its coarse face, which its surroundings determine. Rounding may have moved
  // it to the other side of an edge.
  void move_into_parent(Vertex_index v, Surface_map::Location& p) const
  {
    const Halfedge_index in = m_mesh.halfedge(v);
    const Face_index f = m_result.parent_face(
      Level::coarse, m_mesh.face(m_mesh.is_border(in) ? m_mesh.opposite(in) : in));
    if(p.first != f)
      p = internal::moved_into(f, p, m_coarse);
    if(!p.first.is_valid())
      fail();
  }

  // Several edges of the coarse level can run through a vertex within rounding. One edge can run
  // through a vertex of its own level.
  void set_places_on_edges()
  {
    std::vector<char> has_more_places(m_mesh.number_of_vertices(), 0);
    m_edges.for_each_vertex_on_edge([&](Vertex_index v, size_type p) {
      if(m_edges.piece_before(v) != p || m_result.is_vertex(Level::coarse, v))
        has_more_places[v] = 1;
    });
    m_edges.for_each_vertex_on_edge([&](Vertex_index v, size_type p) {
      if(!has_more_places[v])
        return;
      const double t = internal::place_of_end(m_edges.pieces()[p]);
      for(const Halfedge_index part : {m_rotation.coarse_piece(p), m_rotation.coarse_piece(p + 1)})
        m_result.m_places_on_edges.emplace(End_of_part(v, Edge_index(part)), t);
    });
  }

  const internal::Marked_fine_edges& m_edges;
  internal::Vertex_rotation m_rotation;
  const Delta_complex &m_fine, &m_coarse;
  Surface_subdivision& m_result;
  typename Base::Mesh& m_mesh;
};

} // namespace CGAL::Intrinsic_simplification

#endif // CGAL_INTRINSIC_SIMPLIFICATION_SURFACE_SUBDIVISION_H
