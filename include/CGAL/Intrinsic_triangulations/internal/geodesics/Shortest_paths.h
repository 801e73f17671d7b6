// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GEODESICS_SHORTEST_PATHS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GEODESICS_SHORTEST_PATHS_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Edge_point.h>
#include <CGAL/Intrinsic_triangulations/Surface_view.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/internal/geodesics/Flat_face.h>
#include <CGAL/Intrinsic_triangulations/internal/geodesics/Vertex_angles.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <complex>
#include <cstddef>
#include <limits>
#include <queue>
#include <type_traits>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Shortest paths from one point to all vertices, or to one more point: faces are unfolded along the
// views from the source, nearest first; a view that cannot contain a shortest path is given up (Xin
// and Wang). Shortest paths bend at vertices only, where the surface has more than half a turn on
// either side: there a new view opens in all directions.
template <typename EdgeLengthMap>
class Shortest_paths
{
public:
  typedef typename boost::property_traits<EdgeLengthMap>::value_type FT;
  typedef typename Flat_face<FT>::Vector Vector;
  static_assert(std::is_floating_point<FT>::value, "directions are angles");

  // The shortest path known so far. It starts along `direction`, of any length, in the frame of
  // `frame`: a spoke of the source if that is a vertex, otherwise the first halfedge of its face.
  struct Path
  {
    FT length = std::numeric_limits<FT>::infinity();
    bool is_straight = true;
    Halfedge_index frame;
    Vector direction;
  };

  // `target` is one more point, which is no vertex; without it its face is null.
  Shortest_paths(const Surface_view<EdgeLengthMap>& surface, const Face_location<FT>& target = {})
    : m_surface(surface),
      m_mesh(surface.mesh()),
      m_target(target),
      m_path(surface.mesh().num_vertices())
  {}

  void start_at(Vertex_index v)
  {
    m_path[v.idx()].length = FT(0);
    m_source = v;
    open_views(v, Delta_complex::null_vertex());
  }

  void start_at(const Face_location<FT>& p)
  {
    const Halfedge_index h = m_mesh.halfedge(p.first);
    const Face face(h, m_surface);
    const Origin origin{FT(0), Delta_complex::null_vertex(), h, Vector(1)};
    for(std::size_t s = 0; s < 3; ++s) {
      const Vertex_index corner = m_mesh.source(sides(p.first, m_mesh)[s]);
      reach(corner, path_from(origin, face.to_corner(s, p.second)));
      open_view(h, face, s, p.second, origin);
    }
    look_for_target(h, face, p.second, origin);
  }

  // to all vertices
  void run()
  {
    run([] { return std::numeric_limits<FT>::infinity(); });
  }

  // Returns the path to a vertex, after run().
  const Path& operator[](Vertex_index v) const { return m_path[v.idx()]; }

  // to the vertex `v` alone
  Path path_to(Vertex_index v)
  {
    run([&] { return m_path[v.idx()].length; });
    return m_path[v.idx()];
  }

  // Returns the path to the point given at construction alone.
  Path path_to_target()
  {
    run([&] { return m_path_to_target.length; });
    return m_path_to_target;
  }

private:
  typedef Flat_face<FT> Face;
  typedef typename Face::Place Place;

  // Where a view comes from: the source, or a bend after a path of length `before`.
  struct Origin
  {
    FT before;
    Vertex_index bend;    // null if there is none
    Halfedge_index frame; // as in a path; only without a bend
    Vector axis;          // the x-axis of the view in that frame
  };

  // What the origin sees through a part of an edge; the face of the halfedge `edge`, whose frame
  // this is, is on the side of the origin.
  struct View
  {
    FT least; // the length of the shortest path that ends here
    Halfedge_index edge;
    Vector position; // of the origin
    FT begin, end;
    Origin origin;

    friend bool operator<(const View& v, const View& w) { return v.least > w.least; }
  };

  // A vertex where a shortest path may bend.
  struct Bend
  {
    FT length; // of the path to it
    Vertex_index vertex;

    friend bool operator<(const Bend& b, const Bend& c) { return b.length > c.length; }
  };

  FT length(Halfedge_index h) const { return edge_length(h, m_surface); }

  // ---- Paths ----

  // Replaces `path` by `other` if that is better, and returns whether it was: of two paths that are
  // equal up to rounding the straight one is better.
  static bool improve(Path& path, const Path& other)
  {
    const FT tolerance = rounding_unit<FT>() * other.length;
    const bool is_better = other.is_straight && !path.is_straight
                             ? other.length <= path.length + tolerance
                             : other.length < path.length - tolerance;
    if(is_better)
      path = other;
    return is_better;
  }

  void reach(Vertex_index v, const Path& path)
  {
    if(improve(m_path[v.idx()], path) && v != m_source)
      m_bends.push({path.length, v});
  }

  // Returns whether shortest paths bend at `v`. The shadow of a vertex that is not counted is no
  // wider than the tolerance of what is seen.
  bool can_bend(Vertex_index v) const
  {
    const Vertex_angles<FT> angles(first_spoke(v, m_mesh), m_surface);
    return angles.sum() - (angles.is_border() ? 1 : 2) * pi<FT>() > rounding_unit<FT>();
  }

  // `vector` leads from the origin to the end of the path, in a frame with the axis of the origin.
  Path path_from(const Origin& origin, const Vector& vector) const
  {
    const FT whole = origin.before + std::abs(vector);
    if(origin.bend == Delta_complex::null_vertex())
      return {whole, true, origin.frame, origin.axis * vector};
    const Path& first = m_path[origin.bend.idx()];
    return {whole, false, first.frame, first.direction};
  }

  // ---- Opening views ----

  // All around `v`; `bend` is `v` or, if this is the source, null. Where paths cannot bend, ways
  // along edges are bounds for others, and stand in for views that rounding has closed.
  void open_views(Vertex_index v, Vertex_index bend)
  {
    const bool is_open = v == m_source || can_bend(v);
    const Halfedge_index first = first_spoke(v, m_mesh);
    Halfedge_index h = first;
    for(;;) {
      const Origin origin{m_path[v.idx()].length, bend, h, Vector(1)};
      reach(m_mesh.target(h), path_from(origin, Vector(length(h))));
      if(m_mesh.is_border(h))
        return;
      const Face face(h, m_surface);
      if(is_open)
        open_view(h, face, 1, {FT(1), FT(0), FT(0)}, origin);
      look_for_target(h, face, {FT(1), FT(0), FT(0)}, origin);
      h = next_spoke(h, m_mesh);
      if(h == first)
        return;
    }
  }

  Place target_in(Halfedge_index h) const { return coordinates_from(h, m_target, m_mesh); }

  // In the face of `h`, from the point `p` of this face.
  void look_for_target(Halfedge_index h, const Face& face, const Place& p, const Origin& origin)
  {
    if(m_mesh.face(h) == m_target.first)
      improve(m_path_to_target, path_from(origin, face.between(p, target_in(h))));
  }

  // Through side `s` of the face of `h`, from the point `p` of this face.
  void open_view(Halfedge_index h, const Face& face, std::size_t s, const Place& p,
                 const Origin& origin)
  {
    const Halfedge_index edge = s == 0 ? h : s == 1 ? m_mesh.next(h) : m_mesh.prev(h);
    push(edge, -face.to_corner(s, p), face.direction(s), FT(0), length(edge), origin);
  }

  // `position` of the origin from the source of `edge`, whose direction is `axis`.
  void push(Halfedge_index edge, const Vector& position, const Vector& axis, const FT& begin,
            const FT& end, const Origin& origin)
  {
    const Vector p = position * std::conj(axis);
    View view{FT(0), edge, Vector(p.real(), (std::max)(p.imag(), FT(0))),
              begin, end,  {origin.before, origin.bend, origin.frame, origin.axis * axis}};
    view.least = distance(view, std::clamp(view.position.real(), begin, end));
    if(!is_useless(view))
      m_views.push(view);
  }

  // returns the distance of the source from the point of the edge at `x`, through the origin
  static FT distance(const View& view, const FT& x)
  {
    return view.origin.before + std::abs(view.position - x);
  }

  // Returns whether all paths through the view are longer than those by one of the ends of the
  // edge.
  bool is_useless(const View& view) const
  {
    const FT by_source = m_path[m_mesh.source(view.edge).idx()].length + view.end;
    const FT by_target =
      m_path[m_mesh.target(view.edge).idx()].length + (length(view.edge) - view.begin);
    const FT longer = 1 + rounding_unit<FT>();
    return by_source * longer < distance(view, view.end) ||
           by_target * longer < distance(view, view.begin);
  }

  // ---- Following views ----

  // More steps than surfaces need: on embedded ones views are at most quadratic in the size, and a
  // hundred million are for few faces that paths wind around. Rounding could make it more.
  std::size_t greatest_number_of_steps() const
  {
    const std::size_t n = m_mesh.number_of_halfedges();
    return 100000000 + n * n;
  }

  template <typename Limit>
  void run(const Limit& limit)
  {
    const FT infinity = std::numeric_limits<FT>::infinity();
    for(std::size_t steps = 0; !m_views.empty() || !m_bends.empty(); ++steps) {
      if(steps > greatest_number_of_steps())
        throw Numerical_error("the search for shortest paths does not end");
      const FT view = m_views.empty() ? infinity : m_views.top().least;
      const FT bend = m_bends.empty() ? infinity : m_bends.top().length;
      if((std::min)(view, bend) > limit() * (1 + rounding_unit<FT>()))
        return;
      if(bend <= view)
        open_bend();
      else
        follow_view();
    }
  }

  // Paths may have become shorter since the bend was noted.
  void open_bend()
  {
    const Bend bend = m_bends.top();
    m_bends.pop();
    if(m_path[bend.vertex.idx()].length == bend.length)
      open_views(bend.vertex, bend.vertex);
  }

  void follow_view()
  {
    const View view = m_views.top();
    m_views.pop();
    if(!is_useless(view) && !m_mesh.is_border(m_mesh.opposite(view.edge)))
      unfold(view);
  }

  // Returns where the line from the origin to the point `z` beyond the edge crosses the edge.
  static FT crossing(const View& view, const Vector& z)
  {
    const Vector& p = view.position;
    const FT height = p.imag() - z.imag();
    return height > 0 ? p.real() + (z.real() - p.real()) * (p.imag() / height) : z.real();
  }

  // Returns the place between `a` and `b` where the ray through the point of the edge at `x` meets
  // that side of the next face; 0 at `a`.
  static FT hit(const View& view, const FT& x, const Vector& a, const Vector& b)
  {
    const Vector d = x - view.position;
    const FT to_a = (std::max)(-cross(d, a - view.position), FT(0));
    const FT to_b = (std::max)(cross(d, b - view.position), FT(0));
    return to_a + to_b > 0 ? to_a / (to_a + to_b) : FT(0);
  }

  // Looks into the face beyond the edge.
  void unfold(const View& view)
  {
    const Halfedge_index o = m_mesh.opposite(view.edge);
    const Face face(o, m_surface);
    const Vector target(length(view.edge)), apex = target + face.side(2);
    const FT tolerance = face.tolerance() + rounding_unit<FT>() * std::abs(view.position);
    const auto is_seen = [&](const Vector& z) {
      const FT x = crossing(view, z);
      return view.begin - tolerance <= x && x <= view.end + tolerance;
    };
    if(is_seen(apex))
      reach(m_mesh.target(m_mesh.next(o)), path_from(view.origin, apex - view.position));
    if(m_mesh.face(o) == m_target.first) {
      const Vector q = target - face.between({FT(1), FT(0), FT(0)}, target_in(o));
      if(is_seen(q))
        improve(m_path_to_target, path_from(view.origin, q - view.position));
    }
    split(view, face, apex, tolerance);
  }

  // Hands the view on to the two sides beyond the edge, left and right of the apex.
  void split(const View& view, const Face& face, const Vector& apex, const FT& tolerance)
  {
    const Halfedge_index o = m_mesh.opposite(view.edge);
    const Vector source(0), target(length(view.edge));
    const FT middle = crossing(view, apex);
    const auto hand_on = [&](Halfedge_index edge, const Vector& a, const FT& from, const FT& to,
                             const Vector& axis) {
      const FT l = length(edge);
      if((to - from) * l > tolerance)
        push(edge, a - view.position, axis, from * l, to * l, turned(view.origin));
    };
    if(view.begin < middle)
      hand_on(m_mesh.next(o), source, hit(view, view.begin, source, apex),
              middle < view.end ? FT(1) : hit(view, view.end, source, apex), face.direction(1));
    if(middle < view.end)
      hand_on(m_mesh.prev(o), apex,
              view.begin < middle ? FT(0) : hit(view, view.begin, apex, target),
              hit(view, view.end, apex, target), face.direction(2));
  }

  // as seen from the opposite halfedge
  static Origin turned(const Origin& origin)
  {
    return {origin.before, origin.bend, origin.frame, -origin.axis};
  }

  Surface_view<EdgeLengthMap> m_surface;
  const Delta_complex& m_mesh;
  Vertex_index m_source;      // null if the source is no vertex
  Face_location<FT> m_target; // in a null face if there is none
  std::vector<Path> m_path;   // to each vertex
  Path m_path_to_target;
  std::priority_queue<Bend> m_bends; // from which no views have been opened
  std::priority_queue<View> m_views;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GEODESICS_SHORTEST_PATHS_H
