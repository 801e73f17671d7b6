// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_MAPS_CURVE_TRACER_H
#define CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_MAPS_CURVE_TRACER_H

#include <CGAL/license/Intrinsic_simplification.h>

#include <CGAL/Intrinsic_simplification/Surface_map.h>
#include <CGAL/Intrinsic_simplification/internal/maps/Route.h>
#include <CGAL/Intrinsic_simplification/internal/maps/Surface_patch.h>
#include <CGAL/Intrinsic_triangulations/Decimal_float.h>
#include <CGAL/Intrinsic_triangulations/Double_double.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <vector>

namespace CGAL::Intrinsic_simplification::internal {

// Represents a straight piece of a curve in a face.
template <typename FT>
struct Traced_segment
{
  Face_index face;
  Curve_point<3, FT> from, to;
};

typedef Traced_segment<double> Curve_segment;

// States how edges are traced: with numbers of type `double` through all vertices within rounding,
// without moving edges to vertices, or with more digits. Each takes longer than the one before.
enum class Tracing_mode
{
  through_near_vertices,
  in_double,
  in_double_double,
  in_60_digits
};

// Calls f(x), where `x` is of the type of number of this mode.
template <typename Function>
auto with_number(Tracing_mode mode, const Function& f)
{
  switch(mode) {
    case Tracing_mode::in_double_double: return f(Intrinsic_triangulations::Double_double());
    case Tracing_mode::in_60_digits: return f(Intrinsic_triangulations::Decimal_float<60>());
    default: return f(0.);
  }
}

// Returns the part of a homogeneous coordinate at which an edge runs through a vertex.
inline double rounding(Tracing_mode mode)
{
  return mode == Tracing_mode::in_double
           ? (std::numeric_limits<double>::min)()
           : with_number(mode, [](auto number) { return rounding<decltype(number)>(); });
}

// Rounds a point to `double`.
template <typename FT>
Face_point rounded(const Curve_point<3, FT>& p)
{
  Face_point result{{}, p.corners, {}, p.node};
  const FT sum = p.weight[0] + p.weight[1] + p.weight[2], all = p.along[0] + p.along[1];
  for(std::size_t c = 0; c < 3; ++c)
    result.weight[c] = static_cast<double>(FT(p.weight[c] / sum));
  for(std::size_t c = 0; c < 2; ++c)
    result.along[c] = static_cast<double>(FT(p.along[c] / all));
  return result;
}

template <typename FT>
Curve_segment rounded(const Traced_segment<FT>& s)
{
  return {s.face, rounded(s.from), rounded(s.to)};
}
inline const Curve_segment& rounded(const Curve_segment& s) { return s; }

// Maps an edge of one level through the operations to the other level. In homogeneous coordinates
// every operation is linear on each face, so each segment is mapped alone. A new edge cuts it, and
// the next operation on its face determines the next step. Segments that meet on an edge agree
// bitwise at the meeting point. The two coordinates of a point on an edge change only by operations
// that involve the faces on both sides.
//
// An operation is one-to-one, but its numbers are rounded to `double`. So an edge that is straight
// before two operations can have a bend after them. In `double` such bends are ignored, and edges
// can cross each other where vertices are closer than rounding. With more digits they are kept
// until the end, and edges do not cross each other.
template <typename FT>
class Curve_tracer
{
  typedef Traced_segment<FT> Segment;
  typedef Curve_point<3, FT> Point;
  typedef internal::Recorded_flip<FT> Recorded_flip;
  typedef internal::Vertex_sectors<FT> Vertex_sectors;
  typedef typename Vertex_sectors::Point Patch_point;

public:
  // The mode has numbers of type `FT`.
  Curve_tracer(const Surface_map& map, bool forward,
               Tracing_mode mode = Tracing_mode::through_near_vertices)
    : m_route(map.route(forward)),
      m_rounding(internal::rounding(mode)),
      m_least_part(mode == Tracing_mode::through_near_vertices ? 0 : rounding_unit())
  {}

  // Traces the edge of `h`, a halfedge of the level where the curve starts, from its source to its
  // target. Faces have the indices of the evolving surface.
  const std::vector<Segment>& trace(Halfedge_index h)
  {
    carry_edge(h);
    join_straight_pieces();
    return m_result;
  }

  // Traces the edge of `h`, and moves points of the curve within rounding of a vertex to this
  // vertex.
  const std::vector<Segment>& trace_through_near_vertices(Halfedge_index h)
  {
    carry_edge(h);
    for(Segment& s : m_result) {
      move_to_near_corner(s.from);
      move_to_near_corner(s.to);
    }
    join_straight_pieces();
    return m_result;
  }

private:
  // Stores a segment with the time of its next operation: its start in forward direction, its end
  // in backward direction.
  struct Timed_segment
  {
    Segment segment;
    Route::Time time;
  };

  // Maps the edge of `h` in steps. If operations cut the curve many times, pieces accumulate in a
  // face. So each step has about as many operations as pieces, and straight pieces are joined
  // between steps.
  void carry_edge(Halfedge_index h)
  {
    m_is_bend.assign(2, 0);
    m_carried.assign(1, timed(whole_edge(h), m_route.start().time()));
    Route::Time step = m_route.length();
    for(Route::Time now = earliest(); now != m_route.end().time(); now = earliest()) {
      const std::size_t most = at_once + m_carried.size();
      const std::size_t met = carry_pieces(m_route.after(now, step), most);
      limit_work(met);
      if(is_rounded)
        join_inside_faces();
      if(met == most)
        step = (std::max)(step / 4, Route::Time(1));
      else if(met < most / 4)
        step *= 2;
    }
    m_result.clear();
    for(const Timed_segment& s : m_carried)
      m_result.push_back(s.segment);
  }

  // Without joints, pieces can accumulate. Then tracing would take minutes.
  void limit_work(std::size_t operations)
  {
    m_operations += operations;
    if(!is_rounded && m_operations > greatest_number_of_operations)
      throw Intrinsic_triangulations::Numerical_error(
        "edges of the coarse level change too often to be traced with more digits");
  }

  // Returns the time of the next operation.
  Route::Time earliest() const
  {
    Route::Time result = m_route.end().time();
    for(const Timed_segment& s : m_carried)
      if(m_route.is_at(result, s.time))
        result = s.time;
    return result;
  }

  // Maps the pieces one by one to the time `to`, or until `most` operations have been applied.
  // Returns the number of these operations.
  std::size_t carry_pieces(Route::Time to, std::size_t most)
  {
    m_stack.assign(m_carried.rbegin(), m_carried.rend());
    m_carried.clear();
    std::size_t met = 0;
    while(!m_stack.empty()) {
      const Timed_segment s = m_stack.back();
      m_stack.pop_back();
      if(met == most || m_route.is_at(s.time, to)) {
        m_carried.push_back(s);
      } else {
        ++met;
        carry(s);
      }
    }
    return met;
  }

  // An edge and its reverse start in the same face.
  Segment whole_edge(Halfedge_index h) const
  {
    const Surface_level& level = m_route.start();
    const Delta_complex& mesh = level.mesh();
    Halfedge_index inner = mesh.halfedge(mesh.edge(h), 0);
    if(mesh.is_border(inner))
      inner = opposite(inner);
    const std::size_t s = Intrinsic_triangulations::side_number(inner, mesh);
    const std::size_t from = inner == h ? s : (s + 1) % 3, to = inner == h ? (s + 1) % 3 : s;
    return {level.surface_face(mesh.face(inner)), corner_point(from, 0), corner_point(to, 1)};
  }

  static Point corner_point(std::size_t corner, std::size_t end)
  {
    Point result{{}, bit(corner), {}, end};
    result.weight[corner] = FT(1);
    result.along[end] = FT(1);
    return result;
  }

  Timed_segment timed(const Segment& s, Route::Time now) const
  {
    return {s, m_route.next(s.face, now)};
  }

  // Pushes the parts of the segment after its next operation on the stack, the first one on top.
  void carry(const Timed_segment& s)
  {
    m_parts.clear();
    const Route::Time now =
      m_route.pass(s.time, [&](const auto& operation) { pass(operation, s.segment); });
    for(std::size_t n = m_parts.size(); n-- > 0;)
      m_stack.push_back(timed(m_parts[n], now));
  }

  void add_part(const Patch_face& face, const Patch_point& from, const Patch_point& to)
  {
    m_parts.push_back({face.face, face.in_face(from), face.in_face(to)});
  }

  void number(Patch_point& p)
  {
    p.node = m_is_bend.size();
    m_is_bend.push_back(0);
  }

  // Applies a scaling. A curve bends on an edge if the changes on its two sides differ.
  void pass(const Scaling& scaling, Segment s)
  {
    const Coordinates factor = m_route.factors(scaling, s.face);
    for(Point* p : {&s.from, &s.to}) {
      if(is_pair(p->corners))
        m_is_bend[p->node] = 1;
      for(std::size_t c = 0; c < 3; ++c)
        p->weight[c] *= FT(factor[c]);
    }
    m_parts.push_back(s);
  }

  void pass(const Flip& flip, const Segment& s)
  {
    const Recorded_flip turn(flip, m_route.is_forward(), m_least_part);
    const Patch_face face = turn.before(turn.has_r(s.face));
    const Patch_point from = face.in_patch(s.from), to = face.in_patch(s.to);
    const int from_side = turn.side(from), to_side = turn.side(to);
    if(from_side * to_side >= 0)
      return add_part(turn.after(from_side + to_side >= 0), turn.turned(from), turn.turned(to));
    Patch_point x = turn.crossing(from, to);
    number(x);
    add_part(turn.after(from_side > 0), turn.turned(from), x);
    add_part(turn.after(to_side > 0), x, turn.turned(to));
  }

  void pass(const Vertex_change& change, const Segment& s)
  {
    const Vertex_sectors sectors(change, m_least_part);
    if(m_route.is_forward() == sectors.is_insertion())
      return insert_vertex(sectors, s);
    const Patch_face face = sectors[sectors.sector_of(s.face)];
    add_part(sectors.whole(), sectors.in_whole(face.in_patch(s.from)),
             sectors.in_whole(face.in_patch(s.to)));
  }

  void insert_vertex(const Vertex_sectors& sectors, const Segment& s)
  {
    const Patch_point x = sectors.whole().in_patch(s.from), y = sectors.whole().in_patch(s.to);
    const auto from = sectors.in_sectors(x), to = sectors.in_sectors(y);
    if(to.is_in(from.first))
      return add_part(sectors[from.first], from.point, to.point);
    if(to.is_in(from.last))
      return add_part(sectors[from.last], from.point, to.point);
    // The vertex has one outgoing halfedge in one direction around it. The crossing with its line
    // determines the direction.
    const bool one_ahead = sectors.is_border() ? from.last == 0 : (from.last + 1) % 3 == to.first;
    const std::size_t outgoing = one_ahead ? (from.last + 1) % 3 : from.first;
    using std::abs;
    auto [point, excess] = sectors.on_line(outgoing, x, y);
    if(sectors.is_border() ? Vertex_sectors::is_on_border_side(x, y) : abs(excess) <= m_rounding)
      return pass_through_vertex(sectors, from, point, to);
    const bool is_ahead = one_ahead == (excess > 0 || sectors.is_border());
    pass_outgoing_halfedges(sectors, is_ahead, {x, y}, from, to);
  }

  void pass_through_vertex(const Vertex_sectors& sectors,
                           const typename Vertex_sectors::Sector_point& from, Patch_point at_vertex,
                           const typename Vertex_sectors::Sector_point& to)
  {
    at_vertex.weight = {FT(0), FT(0), FT(0), at_vertex.weight[Vertex_sectors::m]};
    at_vertex.corners = bit(Vertex_sectors::m);
    number(at_vertex);
    add_part(sectors[from.last], from.point, at_vertex);
    add_part(sectors[to.first], at_vertex, to.point);
  }

  // Crosses the outgoing halfedges counterclockwise around the vertex if `is_ahead`, otherwise
  // clockwise.
  void pass_outgoing_halfedges(const Vertex_sectors& sectors, bool is_ahead,
                               const std::array<Patch_point, 2>& ends,
                               const typename Vertex_sectors::Sector_point& from,
                               const typename Vertex_sectors::Sector_point& to)
  {
    Patch_point last = from.point;
    std::size_t n = is_ahead ? from.last : from.first;
    while(!to.is_in(n)) {
      Patch_point x = sectors.on_line(is_ahead ? (n + 1) % 3 : n, ends[0], ends[1]).point;
      number(x);
      add_part(sectors[n], last, x);
      last = x;
      n = (n + (is_ahead ? 1 : 2)) % 3;
    }
    add_part(sectors[n], last, to.point);
  }

  // Moves a point between the ends that is at a corner, within rounding, to this corner. The curve
  // then runs through the vertex.
  static void move_to_near_corner(Point& p)
  {
    if(p.node < 2)
      return;
    const auto most = std::max_element(p.weight.begin(), p.weight.end());
    for(auto w = p.weight.begin(); w != p.weight.end(); ++w)
      if(w != most && *w > rounding<FT>() * *most)
        return;
    p.corners = bit(static_cast<std::size_t>(most - p.weight.begin()));
    for(auto w = p.weight.begin(); w != p.weight.end(); ++w)
      if(w != most)
        *w = FT(0);
  }

  // Returns whether the curve continues straight beyond `p`, which was on an edge before.
  bool is_straight_inside(const Point& p) const
  {
    return p.corners == inside && !m_is_bend[p.node];
  }

  // Pieces with the same next operation are in one face at the same time.
  void join_inside_faces()
  {
    std::size_t size = 0;
    for(const Timed_segment& s : m_carried)
      if(size > 0 && is_straight_inside(m_carried[size - 1].segment.to) &&
         m_carried[size - 1].time == s.time)
        m_carried[size - 1].segment.to = s.segment.to;
      else
        m_carried[size++] = s;
    m_carried.resize(size);
  }

  // Joins straight pieces inside faces. Also joins pieces if the curve reaches a side and continues
  // in its face, along the boundary. A piece from a side back to the same side, or from a corner to
  // itself, exists only because of rounding.
  void join_straight_pieces()
  {
    std::size_t size = 0;
    bool is_joint = false;
    for(std::size_t n = 0; n < m_result.size(); ++n) {
      if(is_joint)
        m_result[size - 1].to = m_result[n].to;
      else
        m_result[size++] = m_result[n];
      const Segment& last = m_result[size - 1];
      const bool is_end = n + 1 == m_result.size();
      is_joint = is_straight_inside(last.to) || (!is_end && stays_in_face(last, m_result[n + 1]));
      if(is_rounded && !is_joint && leads_back(last) && !(is_end && size == 1)) {
        --size;
        is_joint = is_pair(last.to.corners);
      }
    }
    m_result.resize(size);
    // Pieces omitted at a vertex were as short as rounding errors.
    m_result.front().from.along = {FT(1), FT(0), FT(0)};
    m_result.back().to.along = {FT(0), FT(1), FT(0)};
    for(std::size_t n = 1; n < size; ++n)
      m_result[n].from.along = m_result[n - 1].to.along;
  }

  // Returns whether the curve reaches a side and does not cross it.
  static bool stays_in_face(const Segment& s, const Segment& next)
  {
    return is_pair(s.to.corners) && next.face == s.face && next.from.corners == s.to.corners;
  }

  // The ends of the curve have the nodes 0 and 1.
  static bool leads_back(const Segment& s)
  {
    return s.from.corners == s.to.corners && s.to.corners != inside && s.from.node + s.to.node > 1;
  }

  static constexpr bool is_rounded = std::is_same_v<FT, double>;
  static constexpr Corner_set inside = 7;
  static constexpr std::size_t at_once = 16; // operations in a step, beside one for each piece
  // Some ten seconds.
  static constexpr std::size_t greatest_number_of_operations =
    std::is_same_v<FT, Intrinsic_triangulations::Double_double> ? 50000000 : 10000000;

  Route m_route;
  double m_rounding;
  double m_least_part;          // replaces a part of an edge or face that rounding has made zero
  std::size_t m_operations = 0; // on pieces
  std::vector<char> m_is_bend;  // of each point
  std::vector<Timed_segment> m_carried, m_stack;
  std::vector<Segment> m_parts; // of the segment that is being carried
  std::vector<Segment> m_result;
};

} // namespace CGAL::Intrinsic_simplification::internal

#endif // CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_MAPS_CURVE_TRACER_H
