// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GEODESICS_PATH_SEARCH_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GEODESICS_PATH_SEARCH_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Edge_point.h>
#include <CGAL/Intrinsic_triangulations/Surface_path.h>
#include <CGAL/Intrinsic_triangulations/Surface_view.h>
#include <CGAL/Intrinsic_triangulations/internal/geodesics/Flat_face.h>
#include <CGAL/Intrinsic_triangulations/internal/geodesics/View_propagation.h>

#include <algorithm>
#include <complex>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// The sources of shortest paths, the views from them, and the shortest paths back to them.
template <typename EdgeLengthMap>
class Path_search
{
  typedef View_propagation<EdgeLengthMap> Views;
  typedef typename Views::Charts Charts;
  typedef typename Views::Index Index;
  typedef typename Views::View View;

public:
  typedef typename Views::FT FT;
  typedef typename Views::Vector Vector;
  typedef Face_location<FT> Location;
  typedef Surface_place<FT> Place;

  // The straight part at the end of a path to the point `location`, or to a vertex: through a view,
  // in whose frame `end` is this point, or else along the halfedge `last`, or through its face.
  struct Last_part
  {
    FT length = std::numeric_limits<FT>::infinity(); // of the whole path
    Index view = Views::null;
    Index origin = Views::null; // null for a source that is the vertex itself
    Halfedge_index last;
    Vector end{};
    bool is_straight = true; // the whole path
  };

  explicit Path_search(const Surface_view<EdgeLengthMap>& surface)
    : m_mesh(surface.mesh()), m_views(surface)
  {}

  void add_source(Vertex_index v) { m_views.add_source(v); }

  void add_source(const Location& p)
  {
    const Place place = surface_place(p, m_mesh);
    if(is_corner(p.second))
      return add_source(m_mesh.source(place.along));
    add_point(p);
    const Halfedge_index o = place.along.is_valid() ? m_mesh.opposite(place.along) : place.along;
    if(o.is_valid() && !m_mesh.is_border(o))
      add_point(face_location(reversed(edge_point(place.along, p, m_mesh), m_mesh), m_mesh));
    else
      m_point.push_back({Delta_complex::null_face(), p.second});
  }

  // Makes distances up to `limit()` final.
  template <typename Limit>
  void run(const Limit& limit)
  {
    m_views.run(limit);
    sort_views();
  }

  void run()
  {
    run([] { return std::numeric_limits<FT>::infinity(); });
  }

  // Makes the distance of `v` final, or of `q`.
  void run_to(Vertex_index v)
  {
    run([&] { return m_views.distance(v.idx()); });
  }
  void run_to(const Location& q)
  {
    const Flat_face<FT> face(m_mesh.halfedge(q.first), m_views.surface());
    run([&] { return by_corners(q, face).length; });
  }

  const FT& distance(Vertex_index v) const { return m_views.distance(v.idx()); }

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
    for(std::size_t i = 0; i < m_point.size(); ++i)
      if(m_point[i].first == q.first)
        improve(result, {norm_of(face.between(m_point[i].second, q.second)), Views::null,
                         Index(m_mesh.num_vertices() + i), m_mesh.halfedge(q.first)});
    for(Index c = 3 * q.first.idx(); c < 3 * q.first.idx() + 3; ++c)
      look_through(c, q, face, result);
    return result;
  }

  // Returns the number of the source of a path: that of its vertex, or one after those.
  Index source_of(Last_part part, const Location& q) const
  {
    Vertex_index v = vertex_at(q, m_mesh);
    for(; part.origin != Views::null && m_views.is_vertex(part.origin); part = to(v))
      v = Vertex_index(part.origin);
    return part.origin == Views::null
             ? v.idx()
             : part.origin - (part.origin - Index(m_mesh.num_vertices())) % 2;
  }

  // Returns the number of the source at `p` that has been added last.
  Index source_at(const Location& p) const
  {
    const Vertex_index v = vertex_at(p, m_mesh);
    return v == Delta_complex::null_vertex()
             ? static_cast<Index>(m_mesh.num_vertices() + m_point.size() - 2)
             : Index(v.idx());
  }

  // Returns a spoke of the source, or a halfedge of its face, and the direction of the path in the
  // frame of this halfedge. \pre the path has a length that is positive and finite
  std::pair<Halfedge_index, Vector> start(Last_part part, const Location& q) const
  {
    Location end = q;
    for(; !m_views.is_source(part.origin); part = to(Vertex_index(part.origin)))
      end = at_vertex(Vertex_index(part.origin));
    if(part.view == Views::null && is_along_edge(part, end))
      return {part.last, Vector(1)};
    const auto result =
      part.view == Views::null ? start_in_face(part, end) : start_through_view(part);
    return m_views.is_vertex(part.origin) ? result : in_first_face(part.origin, result);
  }

  // Adds the places of the path from its end `q` back to its source.
  void trace(Last_part part, const Location& q, std::vector<Place>& places) const
  {
    add(surface_place(q, m_mesh), places);
    for(;;) {
      Halfedge_index first = part.last;
      if(part.view != Views::null)
        first = Charts::halfedge(add_crossings(part, places), m_mesh);
      if(part.origin == Views::null)
        return;
      if(!m_views.is_vertex(part.origin))
        return add(surface_place(point(part.origin), m_mesh), places);
      add(at_spoke(first), places);
      part = to(Vertex_index(part.origin));
    }
  }

  // the place of a vertex with a halfedge that starts there
  Location at_vertex(Vertex_index v) const { return at_spoke(first_spoke(v, m_mesh)).location; }

  const Delta_complex& mesh() const { return m_mesh; }

private:
  void add_point(const Location& p)
  {
    m_views.add_source(p, static_cast<Index>(m_mesh.num_vertices() + m_point.size()));
    m_point.push_back(p);
  }

  // ---- Views by the sides that they look through ----

  void sort_views()
  {
    const auto& views = m_views.views();
    m_first.assign(3 * m_mesh.num_faces() + 1, 0);
    for(const View& view : views)
      if(view.edge != Views::null)
        ++m_first[view.edge + 1];
    for(std::size_t c = 1; c < m_first.size(); ++c)
      m_first[c] += m_first[c - 1];
    m_sorted.resize(m_first.back());
    std::vector<Index> next(m_first.begin(), m_first.end() - 1);
    for(Index i = 0; i < views.size(); ++i)
      if(views[i].edge != Views::null)
        m_sorted[next[views[i].edge]++] = i;
  }

  static void improve(Last_part& part, const Last_part& other)
  {
    const FT tolerance = rounding_unit<FT>() * other.length;
    if(other.is_straight && !part.is_straight ? other.length <= part.length + tolerance
                                              : other.length < part.length - tolerance)
      part = other;
  }

  // straight from a corner
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

  // through side `c` of the face of `q`
  void look_through(Index c, const Location& q, const Flat_face<FT>& face, Last_part& part) const
  {
    const Index edge = m_views.charts().across(c);
    if(edge == Views::null)
      return;
    const FT l = m_views.charts().length(c);
    const Vector z = l + face.to_corner(c % 3, q.second) * std::conj(face.direction(c % 3));
    for(Index i = m_first[edge]; i < m_first[edge + 1]; ++i) {
      const View& view = m_views.views()[m_sorted[i]];
      const FT length = Views::distance(view, z);
      if(length <= part.length * (1 + rounding_unit<FT>()) &&
         Views::is_seen(view, z, m_views.tolerance(view)))
        improve(part, {length, m_sorted[i], view.origin, Halfedge_index(), z,
                       m_views.is_source(view.origin)});
    }
  }

  // ---- Paths ----

  Vector apex_beyond(Index view) const
  {
    return m_views.charts().apex_beyond(m_views.charts().across(m_views.views()[view].edge));
  }

  // Calls `visit(view, z)` for the view `i` and those from which it was handed on; `z` is the end
  // of the line in its frame. Returns the first of them, and `z` in its frame.
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

  // Adds where the path crosses edges, and returns the side before the first of them in its face:
  // it starts at the origin if that is a vertex.
  Index add_crossings(const Last_part& part, std::vector<Place>& places) const
  {
    const Index o = m_views.charts().across(m_views.views()[part.view].edge);
    const Location& q = places.back().location; // which may lie on the last edge; vertices do not
    bool is_crossing = places.size() > 1 || is_at_vertex(places.back()) || q.first.idx() != o / 3 ||
                       q.second[(o + 2) % 3] != 0;
    const auto [root, z] = root_of(part.view, part.end, [&](const View& view, const Vector& end) {
      if(is_crossing)
        add(crossing(view, end), places);
      is_crossing = true;
    });
    return Charts::previous(root.edge);
  }

  // Vertices within rounding of the path count as hit.
  Place crossing(const View& view, const Vector& end) const
  {
    const Index o = m_views.charts().across(view.edge);
    const FT x = Views::crossing(view, end), l = m_views.charts().length(view.edge);
    const FT tolerance = m_views.tolerance(view);
    if(x <= tolerance || l - x <= tolerance)
      return at_spoke(Charts::halfedge(x < l - x ? Charts::next(o) : o, m_mesh));
    const Halfedge_index h = Charts::halfedge(view.edge, m_mesh);
    return {h, {m_mesh.face(h), barycentric_coordinates(view.edge % 3, FT(x / l))}};
  }

  Place at_spoke(Halfedge_index h) const { return place_on(Edge_point<FT>{h, FT(0)}, m_mesh); }

  const Location& point(Index origin) const { return m_point[origin - m_mesh.num_vertices()]; }

  // Adds a place, a vertex only once. Between two vertices the path follows an edge, the shortest
  // from one to the other.
  void add(const Place& place, std::vector<Place>& places) const
  {
    if(places.empty() || !is_at_vertex(place) || !is_at_vertex(places.back())) {
      places.push_back(place);
      return;
    }
    const Vertex_index v = m_mesh.source(place.along), next = m_mesh.source(places.back().along);
    if(v == next)
      return;
    Halfedge_index best = place.along;
    for_each_spoke(v, m_mesh, [&](Halfedge_index h) {
      if(m_mesh.target(h) == next && (m_mesh.target(best) != next || length(h) < length(best)))
        best = h;
    });
    places.push_back(at_spoke(best));
  }

  FT length(Halfedge_index h) const { return edge_length(h, m_views.surface()); }

  // ---- Directions ----

  // the direction of side `c` in the frame of another of its face
  Vector direction_from(Index frame, Index c) const
  {
    const Charts& charts = m_views.charts();
    return c == frame                 ? Vector(1)
           : c == Charts::next(frame) ? -std::conj(charts.turn(c))
                                      : -charts.turn(frame);
  }

  bool is_along_edge(const Last_part& part, const Location& end) const
  {
    return m_views.is_vertex(part.origin) && vertex_at(end, m_mesh) != Delta_complex::null_vertex();
  }

  std::pair<Halfedge_index, Vector> start_through_view(const Last_part& part) const
  {
    const auto [root, z] = root_of(part.view, part.end, [](const View&, const Vector&) {});
    const Index frame =
      m_views.is_vertex(part.origin) ? Charts::previous(root.edge) : 3 * (root.edge / 3);
    return {Charts::halfedge(frame, m_mesh),
            (z - root.position) * direction_from(frame, root.edge)};
  }

  // of a path that runs through one face only, from a corner or a source
  std::pair<Halfedge_index, Vector> start_in_face(const Last_part& part, const Location& end) const
  {
    const Vertex_index v = vertex_at(end, m_mesh);
    const bool from_vertex = m_views.is_vertex(part.origin);
    const Halfedge_index h = from_vertex ? part.last : m_mesh.halfedge(m_mesh.face(part.last));
    const Flat_face<FT> face(h, m_views.surface());
    const Location q = v == Delta_complex::null_vertex()
                         ? end
                         : face_location(Edge_point<FT>{part.last, FT(1)}, m_mesh);
    const Location p =
      from_vertex ? face_location(Edge_point<FT>{h, FT(0)}, m_mesh) : point(part.origin);
    return {h, face.between(coordinates_from(h, p, m_mesh), coordinates_from(h, q, m_mesh))};
  }

  // Takes a direction at a source on an edge, in the frame of either face, to that of the first.
  std::pair<Halfedge_index, Vector> in_first_face(Index origin,
                                                  std::pair<Halfedge_index, Vector> start) const
  {
    if((origin - m_mesh.num_vertices()) % 2 == 0)
      return start;
    const Location& p = point(origin - 1);
    const Index c = Charts::side_of(surface_place(p, m_mesh).along, m_mesh);
    const Index frame = 3 * p.first.idx(), o = m_views.charts().across(c);
    return {m_mesh.halfedge(p.first),
            -start.second * direction_from(frame, c) * std::conj(direction_from(3 * (o / 3), o))};
  }

  const Delta_complex& m_mesh;
  Views m_views;
  std::vector<Location> m_point;        // two for each source: on an edge, it is in both faces
  std::vector<Index> m_first, m_sorted; // views by sides
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GEODESICS_PATH_SEARCH_H
