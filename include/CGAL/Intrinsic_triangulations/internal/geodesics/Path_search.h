// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GEODESICS_PATH_SEARCH_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GEODESICS_PATH_SEARCH_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Edge_point.h>
#include <CGAL/Intrinsic_triangulations/Flat_face.h>
#include <CGAL/Intrinsic_triangulations/Surface_curve.h>
#include <CGAL/Intrinsic_triangulations/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/Surface_view.h>
#include <CGAL/Intrinsic_triangulations/internal/geodesics/Curve_ends.h>
#include <CGAL/Intrinsic_triangulations/internal/geodesics/View_propagation.h>

#include <algorithm>
#include <complex>
#include <cstddef>
#include <limits>
#include <numeric>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Stores the sources of shortest paths, the views from them, and the shortest paths back to them.
template <typename EdgeLengthMap>
class Path_search
{
protected:
  typedef View_propagation<EdgeLengthMap> Views;
  typedef typename Views::Charts Charts;
  typedef typename Views::Index Index;
  typedef typename Views::View View;

public:
  typedef typename Views::FT FT;
  typedef typename Views::Vector Vector;
  typedef Face_location<FT> Location;
  typedef Surface_point<FT> Place;

  // Describes the straight part at the end of a path to the point `location`, or to a vertex. It
  // leads through a view, in whose frame `end` is this point. Otherwise it leads along the halfedge
  // `last`, or through its face.
  struct Last_part
  {
    FT length = std::numeric_limits<FT>::infinity(); // of the whole path
    Index view = Views::null;
    Index origin = Views::null; // null for a source that is the vertex itself
    Halfedge_index last;
    Vector end{};
    bool is_straight = true; // the whole path
  };

  // Without paths, only distances of vertices are stored, and memory is linear.
  explicit Path_search(const Surface_view<EdgeLengthMap>& surface, bool are_paths_wanted = true)
    : m_mesh(surface.mesh()),
      m_views(surface, are_paths_wanted),
      m_are_paths_wanted(are_paths_wanted)
  {}

  // Adds a source and returns its number.
  std::size_t add_source(Vertex_index v)
  {
    add_vertex(v);
    return m_number_of_sources++;
  }

  std::size_t add_source(const Location& p)
  {
    add_point(p);
    return m_number_of_sources++;
  }

  // A segment as short as rounding errors counts as a point. Ends are added first, because they
  // open fewer views.
  std::size_t add_source(const Surface_curve<FT>& curve)
  {
    Surface_curve<FT> segments;
    for(const Curve_segment<FT>& s : curve)
      if(is_point(s))
        add_point({s.face, s.source});
      else
        segments.push_back(s);
    Curve_ends<Surface_view<EdgeLengthMap>>(m_views.surface(), segments)
      .for_each_point([&](const Location& p, const auto& sectors) { add_end(p, sectors); });
    for(const Curve_segment<FT>& s : segments)
      m_views.add_source({s, m_number_of_sources, Index(m_views.number_of_origins())});
    return m_number_of_sources++;
  }

  static constexpr std::size_t unlimited_steps = (std::numeric_limits<std::size_t>::max)();

  // Makes distances up to `limit()` final. Returns false if this needs more than `most_steps`
  // views, and true otherwise.
  template <typename Limit, typename Visitor>
  bool run(const Limit& limit, std::size_t most_steps, Visitor& visitor)
  {
    const bool is_done = m_views.run(limit, most_steps, visitor);
    if(m_are_paths_wanted) {
      sort_views();
      sort_origins();
    }
    return is_done;
  }

  template <typename Visitor>
  bool run(std::size_t most_steps, Visitor& visitor)
  {
    return run(unlimited, most_steps, visitor);
  }

  // Makes the distance of `q` final.
  template <typename Visitor>
  void run_to(const Location& q, Visitor& visitor)
  {
    const Vertex_index v = vertex_at(q, m_mesh);
    if(v != Delta_complex::null_vertex()) {
      run([&] { return m_views.distance(v.idx()); }, unlimited_steps, visitor);
      return;
    }
    const Flat_face<FT> face(m_mesh.halfedge(q.first), m_views.surface());
    run([&] { return by_corners(q, face).length; }, unlimited_steps, visitor);
  }

  // Returns the length up to which distances are final, or infinity at the end.
  FT final_length() { return m_views.final_length(); }

  const FT& distance(Vertex_index v) const { return m_views.distance(v.idx()); }

  // Returns the last part of the path to `v`.
  // \pre run()
  Last_part to(Vertex_index v) const
  {
    const auto& arrival = m_views.arrival(v.idx());
    const Vector apex = arrival.view == Views::null ? Vector(0) : apex_beyond(arrival.view);
    return {distance(v), arrival.view, arrival.origin, arrival.last, apex, arrival.is_straight};
  }

  Last_part to(const Location& q) const
  {
    const Vertex_index v = vertex_at(q, m_mesh);
    if(v != Delta_complex::null_vertex())
      return to(v);
    const Flat_face<FT> face(m_mesh.halfedge(q.first), m_views.surface());
    Last_part result = by_corners(q, face);
    const auto [first, last] =
      std::equal_range(m_origins.begin(), m_origins.end(), q.first, In_order_of_faces{*this});
    for(auto i = first; i != last; ++i) {
      const auto nearest = m_views.origin(*i).nearest(face, q.second).second;
      improve(result, {norm_of(face.between(nearest, q.second)), Views::null, *i,
                       m_mesh.halfedge(q.first)});
    }
    for(Index c = 3 * q.first.idx(); c < 3 * q.first.idx() + 3; ++c)
      look_through(c, q, face, result);
    return result;
  }

  // Returns the number of the source of a path that ends with `part`, which is at `v` or in a face.
  std::size_t source_of(Last_part part, Vertex_index v) const
  {
    for(; part.origin != Views::null && m_views.is_vertex(part.origin); part = to(v))
      v = Vertex_index(part.origin);
    return part.origin == Views::null ? m_vertex.at(v.idx()) : m_views.origin(part.origin).number;
  }

  // Adds the positions of the path from its end `q` back to its source.
  void trace(Last_part part, const Location& q, std::vector<Place>& places) const
  {
    add(surface_point(q, m_mesh), places);
    for(bool is_at_end = true;; is_at_end = false) {
      const bool is_in_face = part.origin != Views::null && !m_views.is_vertex(part.origin);
      Halfedge_index first = part.last;
      if(part.view != Views::null) {
        const auto [root, z] = add_crossings(part, places);
        if(is_in_face)
          return add(start_of(root, z), places);
        first = Charts::halfedge(Charts::previous(root.edge), m_mesh);
      } else if(is_in_face)
        return add(start_in_face_of(part, is_at_end ? q : at_source(opposite(first))), places);
      if(part.origin == Views::null)
        return;
      add(Vertex_location{first}, places);
      part = to(Vertex_index(part.origin));
    }
  }

  // Returns the position of a vertex with a halfedge that starts at it.
  Location at_vertex(Vertex_index v) const { return at_source(first_outgoing_halfedge(v, m_mesh)); }

  const Delta_complex& mesh() const { return m_mesh; }

protected:
  typedef typename Views::Origin Origin;

  static FT unlimited() { return std::numeric_limits<FT>::infinity(); }

  // ---- Sources ----

  Origin origin(const Location& p) const { return origin(p, Index(m_views.number_of_origins())); }
  Origin origin(const Location& p, Index first) const
  {
    return {{p.first, p.second, p.second}, m_number_of_sources, first};
  }

  void add_vertex(Vertex_index v)
  {
    m_views.add_source(v);
    m_vertex.emplace(v.idx(), m_number_of_sources);
  }

  // Adds a source at a point. A point on an edge is added in both faces.
  void add_point(const Location& p)
  {
    const Place place = surface_point(p, m_mesh);
    if(is_at_vertex(place))
      return add_vertex(m_mesh.source(halfedge_of(place)));
    const Index first = m_views.add_source(origin(p));
    if(const auto* q = on_edge(place); q && !m_mesh.is_border(opposite(q->halfedge)))
      m_views.add_source(origin(face_location(reversed(*q), m_mesh), first));
  }

  bool is_point(const Curve_segment<FT>& s) const
  {
    const Flat_face<FT> face(m_mesh.halfedge(s.face), m_views.surface());
    return norm_of(face.between(s.source, s.target)) <= face.tolerance();
  }

  void add_end(const Location& p, const std::vector<Sector_in_face<FT>>& sectors)
  {
    if(const Vertex_index v = vertex_at(p, m_mesh); v != Delta_complex::null_vertex()) {
      m_views.add_source(v, sectors);
      m_vertex.emplace(v.idx(), m_number_of_sources);
      return;
    }
    const Index first = Index(m_views.number_of_origins());
    for(const auto& sector : sectors)
      m_views.add_source(origin(sector.at, first), sector);
  }

  // ---- Views by the sides that they look through ----

  void sort_views()
  {
    const auto& views = m_views.views();
    m_first.assign(3 * m_mesh.num_faces() + 1, 0);
    for(const View& view : views)
      ++m_first[view.edge + 1];
    for(std::size_t c = 1; c < m_first.size(); ++c)
      m_first[c] += m_first[c - 1];
    m_sorted.resize(m_first.back());
    std::vector<Index> next(m_first.begin(), m_first.end() - 1);
    for(Index i = 0; i < views.size(); ++i)
      m_sorted[next[views[i].edge]++] = i;
  }

  struct In_order_of_faces
  {
    const Path_search& search;

    bool operator()(Index i, Face_index f) const { return face(i) < f; }
    bool operator()(Face_index f, Index i) const { return f < face(i); }
    bool operator()(Index i, Index j) const { return face(i) < face(j); }
    Face_index face(Index i) const { return search.m_views.origin(i).segment.face; }
  };

  void sort_origins()
  {
    m_origins.resize(m_views.number_of_origins() - m_mesh.num_vertices());
    std::iota(m_origins.begin(), m_origins.end(), Index(m_mesh.num_vertices()));
    std::stable_sort(m_origins.begin(), m_origins.end(), In_order_of_faces{*this});
  }

  static void improve(Last_part& part, const Last_part& other)
  {
    const FT tolerance = rounding_unit<FT>() * other.length;
    if(other.is_straight && !part.is_straight ? other.length <= part.length + tolerance
                                              : other.length < part.length - tolerance)
      part = other;
  }

  // Returns the last part of the path to `q` that leads straight from a corner.
  Last_part by_corners(const Location& q, const Flat_face<FT>& face) const
  {
    Last_part result;
    for(std::size_t k = 0; k < 3; ++k) {
      const Halfedge_index h = sides(q.first, m_mesh)[k];
      const Vertex_index v = m_mesh.source(h);
      improve(result, {distance(v) + norm_of(face.to_corner(k, q.second)), Views::null, v.idx(), h,
                       Vector(0), m_views.is_source(v.idx())});
    }
    return result;
  }

  // Replaces `part` by a shorter last part through side `c` of the face of `q`.
  void look_through(Index c, const Location& q, const Flat_face<FT>& face, Last_part& part) const
  {
    const Index edge = m_views.charts().across(c);
    if(edge == Views::null)
      return;
    const FT l = m_views.charts().length(c);
    const Vector z = l + face.to_corner(c % 3, q.second) * std::conj(face.direction(c % 3));
    for(Index i = m_first[edge]; i < m_first[edge + 1]; ++i) {
      const View& view = m_views.views()[m_sorted[i]];
      const FT length = view.length_to(z);
      if(length <= part.length * (1 + rounding_unit<FT>()) && view.sees(z, tolerance(view)))
        improve(part, {length, m_sorted[i], view.origin, Halfedge_index(), z,
                       m_views.is_source(view.origin)});
    }
  }

  // ---- Paths ----

  Vector apex_beyond(Index view) const { return face_beyond(m_views.views()[view]).apex(); }

  FT tolerance(const View& view) const { return face_beyond(view).tolerance(view); }

  Face_beyond<FT> face_beyond(const View& view) const { return {view.edge, m_views.charts()}; }

  // Calls `visit(view, z)` for the view `i` and its predecessors. `z` is the end of the line in the
  // frame of `view`. Returns the first view, and `z` in its frame.
  template <typename Visit>
  std::pair<View, Vector> root_of(Index i, Vector z, const Visit& visit) const
  {
    const auto& views = m_views.views();
    const Charts& charts = m_views.charts();
    for(;; i = views[i].parent) {
      visit(views[i], z);
      if(views[i].parent == Views::null)
        return {views[i], z};
      const Index o = charts.across(views[views[i].parent].edge), left = charts.next(o);
      z = views[i].edge == left ? z * std::conj(charts.turn(left))
                                : charts.apex_beyond(o) + z * charts.turn(o);
    }
  }

  // Adds the positions where the path crosses edges. Returns the view opened at its origin, and the
  // end of the line in its frame.
  std::pair<View, Vector> add_crossings(const Last_part& part, std::vector<Place>& places) const
  {
    const Index o = m_views.charts().across(m_views.views()[part.view].edge);
    // The end may lie on the last edge; vertices do not.
    bool is_crossing = places.size() > 1 || !on_edge(places.back()) ||
                       halfedge_of(places.back()) != Charts::halfedge(o, m_mesh);
    return root_of(part.view, part.end, [&](const View& view, const Vector& end) {
      if(is_crossing && !is_along_origin(view))
        add(crossing(view, end), places);
      is_crossing = true;
    });
  }

  // Returns whether the view looks through the side on which its own segment lies.
  bool is_along_origin(const View& view) const
  {
    if(!view.is_parallel || view.parent != Views::null)
      return false;
    const Curve_segment<FT>& s = m_views.origin(view.origin).segment;
    const std::size_t opposite_corner = (view.edge + 2) % 3;
    return s.source[opposite_corner] == 0 && s.target[opposite_corner] == 0;
  }

  // Returns the start of a line to `z` that is seen in a view opened at a point or a segment. It
  // lies in the face through which the line leaves.
  Place start_of(const View& root, const Vector& z) const
  {
    const Origin& origin = m_views.origin(root.origin);
    if(!root.is_parallel)
      return surface_point(origin.source(), m_mesh);
    const Flat_face<FT> face(m_mesh.halfedge(origin.segment.face), m_views.surface());
    const Location foot = origin.foot(face, root.edge % 3, z);
    if(!is_along_origin(root))
      return surface_point(foot, m_mesh);
    const Halfedge_index h = Charts::halfedge(root.edge, m_mesh);
    return surface_point(face_location(reversed(edge_point(h, foot, m_mesh), m_mesh), m_mesh),
                         m_mesh);
  }

  // Returns the start of a path that ends at `q` in the same face, or at a vertex.
  Place start_in_face_of(const Last_part& part, const Location& q) const
  {
    const Location end = vertex_at(q, m_mesh) == Delta_complex::null_vertex()
                           ? q
                           : face_location(Edge_point<FT>{part.last, FT(1)}, m_mesh);
    const Flat_face<FT> face(m_mesh.halfedge(end.first), m_views.surface());
    return surface_point(m_views.origin(part.origin).nearest(face, end.second), m_mesh);
  }

  // Returns the position at which the line crosses the edge of a view. Vertices within rounding of
  // the path count as hit. An end that rounding moves across the edge is moved back. Otherwise, the
  // position would not be between the ends of a line along the edge.
  Place crossing(const View& view, const Vector& end) const
  {
    const Index o = m_views.charts().across(view.edge);
    const FT x = view.crossing({end.real(), (std::min)(end.imag(), FT(0))});
    const FT l = m_views.charts().length(view.edge);
    const FT rounding = tolerance(view);
    if(x <= rounding || l - x <= rounding)
      return Vertex_location{Charts::halfedge(x < l - x ? Charts::next(o) : o, m_mesh)};
    const Halfedge_index h = Charts::halfedge(view.edge, m_mesh);
    return edge_location(Edge_point<FT>{h, x / l});
  }

  Location at_source(Halfedge_index h) const
  {
    return face_location(Place(Vertex_location{h}), m_mesh);
  }

  // Adds a position, but each vertex only once. Between two vertices the path follows an edge, the
  // shortest from one to the other.
  void add(const Place& place, std::vector<Place>& places) const
  {
    if(places.empty() || !is_at_vertex(place) || !is_at_vertex(places.back())) {
      places.push_back(place);
      return;
    }
    const Vertex_index v = m_mesh.source(halfedge_of(place)),
                       next = m_mesh.source(halfedge_of(places.back()));
    if(v == next)
      return;
    Halfedge_index best = halfedge_of(place);
    for_each_outgoing_halfedge(v, m_mesh, [&](Halfedge_index h) {
      if(m_mesh.target(h) == next && (m_mesh.target(best) != next || length(h) < length(best)))
        best = h;
    });
    places.push_back(Vertex_location{best});
  }

  FT length(Halfedge_index h) const { return edge_length(h, m_views.surface()); }

  const Delta_complex& m_mesh;
  Views m_views;
  bool m_are_paths_wanted;
  std::size_t m_number_of_sources = 0;
  std::unordered_map<Index, std::size_t> m_vertex; // the sources that are vertices
  std::vector<Index> m_first, m_sorted;            // views by sides
  std::vector<Index> m_origins;                    // other sources by faces
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GEODESICS_PATH_SEARCH_H
