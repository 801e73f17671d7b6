// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GEODESICS_VIEW_PROPAGATION_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GEODESICS_VIEW_PROPAGATION_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Edge_point.h>
#include <CGAL/Intrinsic_triangulations/Flat_face.h>
#include <CGAL/Intrinsic_triangulations/Surface_view.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/internal/geodesics/Face_charts.h>
#include <CGAL/Intrinsic_triangulations/internal/geodesics/Segment_origin.h>
#include <CGAL/Intrinsic_triangulations/internal/geodesics/Vertex_angles.h>
#include <CGAL/Intrinsic_triangulations/internal/geodesics/Waiting_views.h>
#include <CGAL/Intrinsic_triangulations/tolerances.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <complex>
#include <cstddef>
#include <deque>
#include <limits>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Computes shortest paths from some points to all others. Faces are unfolded along the views from
// the sources, nearest first. Parts of views that cannot contain a shortest path are cut off (after
// Xin and Wang). Shortest paths bend only at vertices, if the surface has more than pi on either
// side. New views start behind a bend.
template <typename EdgeLengthMap>
class View_propagation
{
public:
  typedef typename boost::property_traits<EdgeLengthMap>::value_type FT;
  typedef Face_charts<FT> Charts;
  typedef typename Charts::Index Index;
  typedef typename Charts::Vector Vector;
  typedef typename Flat_face<FT>::Place Place;
  static_assert(std::is_floating_point<FT>::value, "directions are angles");
  static constexpr Index null = Charts::null;

  typedef internal::View<FT> View;
  typedef Segment_origin<FT> Origin;

  // Describes how the shortest path known so far reaches a vertex. It comes through a view, or from
  // the origin along the halfedge `last`, which ends at the vertex. It may also come through a face
  // whose side `last` ends at the vertex.
  struct Arrival
  {
    Index view = null;
    Index origin = null; // null for a source
    Halfedge_index last;
    bool is_straight = true;
  };

  // Processed views are kept only for paths. Distances need the last view of each vertex.
  explicit View_propagation(const Surface_view<EdgeLengthMap>& surface, bool are_views_kept = true)
    : m_surface(surface),
      m_mesh(surface.mesh()),
      m_charts(surface),
      m_number_of_vertices(static_cast<Index>(surface.mesh().num_vertices())),
      m_distance(m_number_of_vertices, std::numeric_limits<FT>::infinity()),
      m_arrival(m_number_of_vertices),
      m_opened(m_number_of_vertices, std::numeric_limits<FT>::infinity()),
      m_next(m_charts.mean_length() / 4), // many views for each bucket, and few that come late
      m_bends(m_charts.mean_length() / 4),
      m_delay(m_charts.mean_length()),
      m_waiting(m_charts.number_of_sides()),
      m_are_views_kept(are_views_kept),
      m_last_view(are_views_kept ? 0 : m_number_of_vertices)
  {}

  void add_source(Vertex_index v)
  {
    m_distance[v.idx()] = FT(0);
    m_arrival[v.idx()] = Arrival();
    if(!m_mesh.is_isolated(v))
      m_bends.push(m_delay, v.idx());
  }

  // Adds a point that is not a vertex, in one of its faces, or the interior of a segment. Returns
  // its number as an origin.
  Index add_source(const Origin& source)
  {
    const Index origin = add_origin(source);
    const Flat_face<FT> face = flat_face(source.segment.face);
    for(std::size_t s = 0; s < 3; ++s)
      if(const Index c = Index(3 * source.segment.face.idx() + s); !source.is_point())
        push(source.view(face, s, m_charts.length(c), c, origin));
      else if(source.segment.source[(s + 2) % 3] != 0)
        open_view(face, s, source.segment.source, c, FT(0), origin);
    return origin;
  }

  // Adds a point where segments end, in one of its faces. Paths start within `sector`.
  Index add_source(const Origin& source, const Sector_in_face<FT>& sector)
  {
    const Index origin = add_origin(source);
    open_views(sector, origin);
    return origin;
  }

  // Adds a vertex where segments end. Paths start in the directions of `sectors`.
  void add_source(Vertex_index v, const std::vector<Sector_in_face<FT>>& sectors)
  {
    m_distance[v.idx()] = m_opened[v.idx()] = FT(0);
    m_arrival[v.idx()] = Arrival();
    for_each_outgoing_halfedge(v, m_mesh, [&](Halfedge_index h) {
      reach(m_mesh.target(h).idx(), edge_length(h, m_surface), {null, Index(v.idx()), h, true});
    });
    for(const auto& sector : sectors)
      open_views(sector, v.idx());
  }

  // Continues until no path shorter than `limit()` can be missing, and returns true, or until
  // `most_steps` views are processed. If the visitor throws, `run()` can be called again.
  template <typename Limit, typename Visitor>
  bool run(const Limit& limit, std::size_t most_steps, Visitor& visitor)
  {
    for(std::size_t steps = 0, more = 0;; steps += more, m_steps += more) {
      check_bound(m_steps);
      const FT length = final_length();
      if(length == std::numeric_limits<FT>::infinity() ||
         length > limit() * (1 + rounding_unit<FT>()))
        return true;
      if(steps >= most_steps)
        return false;
      more = 1;
      if(m_next.least_key() <= m_bends.least_key())
        more = look_through(m_next.pop());
      else
        open_bend(m_bends.pop());
      visitor.after_windows(more);
    }
  }

  // Returns the length up to which distances are final, or infinity at the end.
  FT final_length() { return (std::min)(m_next.least_key(), FT(m_bends.least_key() - m_delay)); }

  const Surface_view<EdgeLengthMap>& surface() const { return m_surface; }
  const Charts& charts() const { return m_charts; }
  const FT& distance(Index v) const { return m_distance[v]; }
  const Arrival& arrival(Index v) const { return m_arrival[v]; }
  const std::deque<View>& views() const { return m_views; }
  const Origin& origin(Index origin) const { return m_origins[origin - m_number_of_vertices]; }
  std::size_t number_of_origins() const { return m_number_of_vertices + m_origins.size(); }
  bool is_vertex(Index origin) const { return origin < m_number_of_vertices; }
  bool is_source(Index origin) const
  {
    return !is_vertex(origin) || m_arrival[origin].origin == null;
  }

private:
  // Surfaces need up to a hundred views for each halfedge. Few faces with edge lengths in the ratio
  // 1 to ten million need twenty million. Rounding could increase this.
  std::size_t greatest_number_of_views() const
  {
    const std::size_t bound = (std::size_t(1) << 25) + 1024 * m_charts.number_of_sides();
    return (std::min)(bound, std::size_t(null));
  }

  void check_bound(std::size_t views) const
  {
    if(views > greatest_number_of_views())
      throw Numerical_error("the search for shortest paths does not end within " +
                            std::to_string(greatest_number_of_views()) + " views");
  }

  // ---- Sources in faces ----

  Flat_face<FT> flat_face(Face_index f) const { return {m_mesh.halfedge(f), m_surface}; }

  // Adds an origin, from which the corners of its face are reached.
  Index add_origin(const Origin& origin)
  {
    const auto number = static_cast<Index>(number_of_origins());
    m_origins.push_back(origin);
    const Curve_segment<FT>& segment = origin.segment;
    const Flat_face<FT> face = flat_face(segment.face);
    for(std::size_t s = 0; s < 3; ++s) {
      const Index c = Index(3 * segment.face.idx() + s);
      reach(
        m_charts.source(c),
        distance_from_segment(face.to_corner(s, segment.source), face.to_corner(s, segment.target)),
        {null, number, Charts::halfedge(Charts::previous(c), m_mesh), true});
    }
    return number;
  }

  // ---- Vertices ----

  // Stores the path if it is better than the path known so far, and returns whether it is. A
  // straight path is better than another one that is equal up to rounding.
  bool reach(Index v, const FT& length, const Arrival& arrival)
  {
    const FT tolerance = rounding_unit<FT>() * length;
    const bool is_better = arrival.is_straight && !m_arrival[v].is_straight
                             ? length <= m_distance[v] + tolerance
                             : length < m_distance[v] - tolerance;
    if(!is_better)
      return false;
    m_distance[v] = length;
    m_arrival[v] = arrival;
    m_bends.push(length + m_delay, v);
    return true;
  }

  // Returns the angle at `v`, from its first outgoing halfedge, at which the shortest path arrives,
  // through a view or along an edge.
  FT angle_of_arrival(Vertex_index v) const
  {
    const Arrival& arrival = m_arrival[v.idx()];
    Halfedge_index outgoing = m_mesh.opposite(arrival.last);
    FT offset(0);
    if(arrival.view == null && !is_vertex(arrival.origin)) {
      outgoing = m_mesh.next(arrival.last);
      offset = angle_in_face(arrival.origin, outgoing);
    } else if(arrival.view != null) {
      const View& view = m_are_views_kept ? m_views[arrival.view] : m_last_view[v.idx()];
      const Index o = m_charts.across(view.edge);
      const Vector apex = m_charts.apex_beyond(o);
      outgoing = Charts::halfedge(Charts::previous(o), m_mesh);
      const Vector back = view.is_parallel ? view.position : view.position - apex;
      offset = std::arg(back * std::conj(m_charts.length(o) - apex));
    }
    FT angle(0);
    for(Halfedge_index h = first_outgoing_halfedge(v, m_mesh); h != outgoing;
        h = next_around_source(h, m_mesh))
      angle += std::arg(m_charts.turn(Charts::side_of(h, m_mesh)));
    return angle + offset;
  }

  // Returns the angle from the halfedge `h` to the path from its source to an origin in its face.
  FT angle_in_face(Index number, Halfedge_index h) const
  {
    const Flat_face<FT> face = flat_face(m_mesh.face(h));
    const std::size_t s = side_number(h, m_mesh);
    const auto corner = barycentric_coordinates(s, FT(0));
    return std::arg(face.between(corner, origin(number).nearest(face, corner).second) *
                    std::conj(face.direction(s)));
  }

  // Opens the views at a bend. Paths may have become shorter since the bend was recorded.
  void open_bend(Index v)
  {
    if(m_opened[v] != m_distance[v])
      open_views(Vertex_index(v));
    m_opened[v] = m_distance[v];
  }

  // Returns the error of the direction in which the path arrives at `v`. In a face without area, no
  // ray of a source passes beside a corner.
  FT error_of_arrival(Vertex_index v) const
  {
    const Index origin = m_arrival[v.idx()].origin;
    if(m_arrival[v.idx()].view == null && !is_vertex(origin) &&
       m_charts.is_line(this->origin(origin).segment.face))
      return flat_angle_tolerance<FT>();
    const FT before = is_vertex(origin) ? m_distance[origin] : FT(0);
    return direction_error(v, (std::max)(FT(0), FT(m_distance[v.idx()] - before)), m_surface);
  }

  // Opens the views at `v`. Paths along edges bound other paths, and replace views that rounding
  // has closed.
  void open_views(Vertex_index v)
  {
    const bool is_source = m_arrival[v.idx()].origin == null;
    const FT before = m_distance[v.idx()];
    const FT error = is_source ? FT(0) : error_of_arrival(v);
    const bool is_all_seen = is_source || error >= 1;
    for_each_outgoing_halfedge(v, m_mesh, [&](Halfedge_index h) {
      reach(m_mesh.target(h).idx(), before + edge_length(h, m_surface),
            {null, Index(v.idx()), h, is_source});
    });
    const Vertex_angles<FT> angles(first_outgoing_halfedge(v, m_mesh), m_surface);
    if(is_all_seen || !is_shadow_empty(angles, error))
      open_views(
        v, before,
        Outgoing_sector<FT>(angles, is_all_seen, is_all_seen ? FT(0) : angle_of_arrival(v)));
  }

  void open_views(Vertex_index v, const FT& before, const Outgoing_sector<FT>& sector)
  {
    FT angle(0);
    for_each_outgoing_halfedge(v, m_mesh, [&](Halfedge_index h) {
      if(m_mesh.is_border(h))
        return;
      const FT next = angle + std::arg(m_charts.turn(Charts::side_of(h, m_mesh)));
      if(sector.meets(angle, next))
        open_view(Flat_face<FT>(h, m_surface), 1, {FT(1), FT(0), FT(0)},
                  Charts::side_of(m_mesh.next(h), m_mesh), before, Index(v.idx()));
      angle = next;
    });
  }

  // ---- Views ----

  // Opens the view through side `s` of a face, which is `edge`, from its point `p`.
  void open_view(const Flat_face<FT>& face, std::size_t s, const Place& p, Index edge,
                 const FT& before, Index origin)
  {
    push({position_from(face, s, p), FT(0), m_charts.length(edge), before, edge, origin, null,
          false, is_vertex(origin) ? Entry::corner : Entry::inside});
  }

  // Returns the position of a point of a face in the frame of side `s`.
  static Vector position_from(const Flat_face<FT>& face, std::size_t s, const Place& p)
  {
    return -face.to_corner(s, p) * std::conj(face.direction(s));
  }

  // Opens the views through the sides that are visible in some directions.
  void open_views(const Sector_in_face<FT>& sector, Index origin)
  {
    const Flat_face<FT> face = flat_face(sector.at.first);
    for(std::size_t s = 0; s < 3; ++s)
      if(sector.at.second[(s + 2) % 3] != 0) {
        const Index c = Index(3 * sector.at.first.idx() + s);
        if(const auto [from, to] = sector.part_of_side(face, s, m_charts.length(c)); from < to)
          push({position_from(face, s, sector.at.second), from, to, FT(0), c, origin, null, false,
                is_vertex(origin) ? Entry::corner : Entry::inside});
      }
  }

  // Adds a view to the waiting views of its side, unless it is empty.
  void push(View view)
  {
    view.position.imag((std::max)(view.position.imag(), FT(0)));
    if(view.begin <= view.end && m_charts.across(view.edge) != null && cut_off(view)) {
      m_handed_on.assign(1, view);
      wait(view.edge);
    }
  }

  bool cut_off(View& view) const
  {
    return view.cut_off(m_distance[m_charts.source(view.edge)],
                        m_distance[m_charts.target(view.edge)], m_charts.length(view.edge));
  }

  // Adds the propagated views to the waiting views of the side `c`.
  void wait(Index c)
  {
    if(m_handed_on.empty())
      return;
    FT least = std::numeric_limits<FT>::infinity();
    for(const View& view : m_handed_on)
      least = (std::min)(least, view.least_length());
    m_waiting.add(c, m_charts.length(c), m_handed_on);
    m_next.push(least, c);
  }

  // Takes the waiting views of `c` whose origin has not been reached on a shorter path.
  void take_waiting(Index c)
  {
    m_waiting.take(c, m_present);
    const auto is_outdated = [&](const View& view) {
      return is_vertex(view.origin) && m_distance[view.origin] < view.before;
    };
    m_present.erase(std::remove_if(m_present.begin(), m_present.end(), is_outdated),
                    m_present.end());
  }

  // Propagates all waiting views through the side `c`, and returns their number.
  std::size_t look_through(Index c)
  {
    take_waiting(c);
    if(m_present.empty())
      return 0;
    const Index first = keep_present();
    const Face_beyond<FT> face(c, m_charts);
    for(Index i = 0; i < m_present.size(); ++i)
      if(m_present[i].sees(face.apex(), face.tolerance(m_present[i])))
        reach(face.vertex_at_apex(), m_present[i], face.apex(), first + i);
    hand_on(face, true, first);
    hand_on(face, false, first);
    return m_present.size();
  }

  // Returns the number of the first present view. Numbers are not used if no views are kept.
  Index keep_present()
  {
    const auto number = static_cast<Index>(m_views.size());
    if(m_are_views_kept)
      m_views.insert(m_views.end(), m_present.begin(), m_present.end());
    return number;
  }

  void reach(Index v, const View& view, const Vector& apex, Index number)
  {
    if(reach(v, view.length_to(apex),
             {number, view.origin, Halfedge_index(), is_source(view.origin)}) &&
       !m_are_views_kept)
      m_last_view[v] = view;
  }

  // Propagates the present views to a side beyond.
  void hand_on(const Face_beyond<FT>& face, bool is_left, Index first)
  {
    const Index edge = is_left ? face.left() : face.right();
    if(m_charts.across(edge) == null)
      return;
    const auto order = [&](const View& a, const View& b) {
      return face.order(m_present[a.parent - first], m_present[b.parent - first]);
    };
    m_handed_on.clear();
    for(Index i = 0; i < m_present.size(); ++i) {
      View next = face.next(m_present[i], is_left);
      next.parent = first + i;
      if(next.begin <= next.end && cut_off(next))
        append(next, order, m_charts.length(edge), m_handed_on);
    }
    wait(edge);
  }

  Surface_view<EdgeLengthMap> m_surface;
  const Delta_complex& m_mesh;
  Charts m_charts;
  Index m_number_of_vertices;
  std::vector<Origin> m_origins;  // after the vertices
  std::vector<FT> m_distance;     // of each vertex
  std::vector<Arrival> m_arrival; // at each vertex
  std::vector<FT> m_opened;       // the distance at which views were opened at each vertex
  std::deque<View> m_views;       // the propagated views, if they are kept

  Bucket_queue<FT, Index> m_next;  // sides at which views wait
  Bucket_queue<FT, Index> m_bends; // vertices from which views have to be opened
  FT m_delay;                      // of bends, since shorter paths to their vertices may follow
  Waiting_views<FT> m_waiting;
  std::vector<View> m_present, m_handed_on; // views that are looked through, and the next ones
  std::size_t m_steps = 0;

  bool m_are_views_kept;
  std::vector<View> m_last_view; // through which the shortest path comes to each vertex
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GEODESICS_VIEW_PROPAGATION_H
