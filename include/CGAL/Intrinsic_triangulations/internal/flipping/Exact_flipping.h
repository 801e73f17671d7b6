// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FLIPPING_EXACT_FLIPPING_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FLIPPING_EXACT_FLIPPING_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Edge_stack.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/Certifier.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/Exact_decisions.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/flipped_length.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Edge_courses.h>
#include <CGAL/Intrinsic_triangulations/tolerances.h>

#include <CGAL/Uncertain.h>

#include <boost/config.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Stores the part of T2 that a flip of the edge of `h` changes, in the state before the flip. Later
// flips are undone in reverse order. Then every index and every number is bitwise restored.
template <typename Traits>
class Flip_record
{
  typedef Intrinsic_triangulation<Traits> Triangulation;

public:
  Flip_record(Halfedge_index h, const Triangulation& tri)
    : m_h(h),
      m_n(tri.coordinates().normal_coordinate(Edge_index(h))),
      m_r{tri.coordinates().roundabout(h), tri.coordinates().roundabout(opposite(h))},
      m_length(tri.length(Edge_index(h))),
      m_of_vertex{tri.mesh().halfedge(tri.mesh().source(h)),
                  tri.mesh().halfedge(tri.mesh().target(h))},
      m_of_face{tri.mesh().halfedge(tri.mesh().face(h)),
                tri.mesh().halfedge(tri.mesh().face(opposite(h)))}
  {}

  Halfedge_index halfedge() const { return m_h; }

  // Undoes the flip. Complexity: constant.
  void undo(Triangulation& tri) const
  {
    Delta_complex& mesh = tri.m_mesh;
    const Halfedge_index o = opposite(m_h);
    flip_back(m_h, mesh);
    mesh.set_halfedge(mesh.source(m_h), m_of_vertex[0]);
    mesh.set_halfedge(mesh.target(m_h), m_of_vertex[1]);
    mesh.set_halfedge(mesh.face(m_h), m_of_face[0]);
    mesh.set_halfedge(mesh.face(o), m_of_face[1]);
    tri.m_coordinates.set(Edge_index(m_h), m_n);
    tri.m_coordinates.set(m_h, m_r[0]);
    tri.m_coordinates.set(o, m_r[1]);
    tri.m_length[Edge_index(m_h)] = m_length;
  }

private:
  // Turns the edge of `h` clockwise, but does not set the halfedges of vertices.
  static void flip_back(Halfedge_index h, Delta_complex& mesh)
  {
    const Halfedge_index o = opposite(h);
    const Halfedge_index ki = mesh.next(h), il = mesh.prev(h), lj = mesh.next(o), jk = mesh.prev(o);
    mesh.set_target(h, mesh.target(lj));
    mesh.set_target(o, mesh.target(ki));
    set_triangle(h, jk, ki, mesh.face(h), mesh);
    set_triangle(o, il, lj, mesh.face(o), mesh);
  }

  Halfedge_index m_h;
  typename Traits::Integer m_n;
  std::array<Delta_complex::size_type, 2> m_r;
  typename Traits::FT m_length;
  std::array<Halfedge_index, 2> m_of_vertex, m_of_face; // of both ends and both sides
};

// Flips with decisions about the surface of T1. Each length has an error bound. The bound of a
// flipped edge follows from its diamond as long as bounds suffice, otherwise from its strip. If the
// bounds around an edge are known, its Delaunay test is exact. If all edges were straight, an edge
// flipped after this test is straight. If strips get too long, a length is known without error
// bound. Then the stored lengths decide, until `find_lengths()` verifies them.
template <typename Traits>
class Exact_flipping
{
  typedef Intrinsic_triangulation<Traits> Triangulation;
  typedef Exact_decisions<Traits> Decisions;

public:
  // Marks lengths of edges that are not in T1 as unknown, unless `Traits` is exact. `effort` limits
  // the number of steps in strips. Without a limit no length becomes unknown. Lengths from strips
  // have a relative error of at most `kept_error`.
  explicit Exact_flipping(Triangulation& tri,
                          double effort = std::numeric_limits<double>::infinity(),
                          double kept_error = certified_length_error())
    : m_tri(tri),
      m_mesh(tri.mesh()),
      m_courses(tri),
      m_decisions(tri, m_courses),
      m_error(m_mesh.num_edges(), input_error),
      m_effort(effort),
      m_kept_error(Is_exact<Traits>::value ? certified_length_error() : kept_error)
  {
    bool are_shared = tri.number_of_inserted_vertices() == 0;
    for(Delta_complex::size_type i = 0; i < m_error.size(); ++i)
      are_shared &= tri.coordinates().is_shared(Edge_index(i));
    if(!are_shared)
      for(Edge_index e : m_mesh.edges())
        if(!m_decisions.is_input_edge(m_mesh.halfedge(e)))
          set_error(e, Is_exact<Traits>::value ? certified_error : unknown_error);
  }

  bool has_unknown_lengths() const { return m_has_unknown_lengths; }

  bool is_certainly_Delaunay(Edge_index e) const
  {
    return By_lengths{tolerance()}.is_certain(
      diamond(m_tri.length_map(), m_mesh.halfedge(e), m_mesh));
  }

  bool is_Delaunay(Edge_index e)
  {
    const Halfedge_index h = m_mesh.halfedge(e);
    const Diamond<double> lengths = diamond(m_tri.length_map(), h, m_mesh);
    if(By_lengths{tolerance()}.is_certain(lengths) || !m_tri.can_be_turned(h))
      return true;
    if(m_has_unknown_lengths && greatest_error_around(h) == unknown_error)
      return By_lengths()(lengths);
    return By_lengths{tolerance()}(lengths) && is_exactly_Delaunay(h);
  }

  bool can_be_turned(Halfedge_index h) const { return m_tri.can_be_turned(h); }

  Decisions& decisions() { return m_decisions; }

  Flipped_diagonal other_diagonal(Halfedge_index h) const
  {
    return {diamond(m_tri.length_map(), h, m_mesh), errors_around(h)};
  }

  // Flips the edge of `h`. Returns whether this was possible. It always is if all lengths are
  // known.
  bool flip(Halfedge_index h) { return flip(h, other_diagonal(h)()); }

  // Flips the edge of `h`, whose length becomes `flipped` unless its error is too large.
  bool flip(Halfedge_index h, Bounded_length flipped)
  {
    const float error = greatest_error_around(h);
    if(error == input_error)
      if(const double in_plane = length_in_plane(h, flipped.length); in_plane > 0)
        flipped = {in_plane, double(input_error)};
    if(error == unknown_error && !m_tri.traits().is_length_object()(flipped.length))
      return false;
    turn(h, [&] {
      if(m_tri.coordinates().is_shared(m_mesh.edge(h)))
        flipped = m_decisions.bounded_length(h);
      else if(!(flipped.error <= m_kept_error))
        flipped = length_in_strip(h, flipped.length);
      set_error(m_mesh.edge(h), static_cast<float>(flipped.error));
      return flipped.length;
    });
    return true;
  }

  // Stores the data that a flip of an edge changes.
  struct Record
  {
    Flip_record<Traits> flip;
    typename Edge_courses<Traits>::Storage course;
    float error;
    std::size_t number_of_doubtful;
  };

  // Returns the data that a flip of the edge of `h` will change.
  Record record(Halfedge_index h) const
  {
    const Edge_index e(h);
    return {Flip_record<Traits>(h, m_tri), m_courses.storage(e), m_error[e], m_doubtful.size()};
  }

  void undo(const Record& record)
  {
    const Edge_index e(record.flip.halfedge());
    record.flip.undo(m_tri);
    m_courses.after_undo(e, record.course);
    m_error[e] = record.error;
    m_doubtful.resize(record.number_of_doubtful);
  }

  // Returns whether edges have more crossings than `find_lengths()` may lay out.
  bool has_too_many_crossings() const
  {
    double crossings = 0;
    for(Edge_index e : m_mesh.edges())
      crossings += count(e);
    return crossings > (is_limited() ? greatest_number_of_crossings(m_mesh.number_of_edges())
                                     : greatest_number_of_crossings());
  }

  // Computes the unknown lengths, and returns whether their edges are straight. If an edge is not
  // straight, nothing changes.
  BOOST_NOINLINE bool find_lengths()
  {
    std::vector<std::pair<Edge_index, double>> found;
    for(Edge_index e : m_mesh.edges())
      if(m_error[e.idx()] == unknown_error)
        found.emplace_back(e, 0);
    if(!are_straight(found))
      return false;
    for(const auto& [e, length] : found) {
      m_tri.m_length[e] = length;
      m_error[e.idx()] = static_cast<float>(m_kept_error);
    }
    m_has_unknown_lengths = false;
    return true;
  }

  // Recomputes the lengths that make an edge seem not to be Delaunay, so that stored lengths agree
  // with exact decisions. Each length is recomputed once, which bounds the time.
  void sharpen_lengths()
  {
    m_is_sharp.assign(m_mesh.num_edges(), false);
    for(bool has_changed = true; has_changed;) {
      has_changed = false;
      for(Edge_index e : m_doubtful)
        if(const Halfedge_index h = m_mesh.halfedge(e);
           !By_lengths()(diamond(m_tri.length_map(), h, m_mesh))) {
          has_changed |= has_sharpened_length(e);
          for(Edge_index side : edges_around(h, m_mesh))
            has_changed |= has_sharpened_length(side);
        }
    }
  }

  // Recomputes all lengths, with a relative error of at most `error`.
  void recompute_lengths(double error = certified_length_error())
  {
    const auto length = [&](Halfedge_index h) { return m_decisions.length(h, error); };
    m_tri.set_lengths(length);
    std::replace(m_error.begin(), m_error.end(), unknown_error, certified_error);
    m_has_unknown_lengths = false;
  }

private:
  // Flips the edge of `h`, and updates its course before the call of `length()`. The course is
  // updated even if `length()` throws.
  template <typename Length>
  void turn(Halfedge_index h, const Length& length)
  {
    const auto measure = [&] {
      m_courses.after_flip(h);
      return length();
    };
    change_or_undo([&] { m_tri.turn(h, measure); }, [&] { m_courses.after_flip(h); });
  }

  typedef typename Euclidean_geometry_traits<double>::Is_locally_Delaunay By_lengths;

  // Returns the greatest relative error of lengths that decide.
  double tolerance() const
  {
    return Is_exact<Traits>::value ? certified_length_error()
                                   : (std::max)(m_kept_error, flipping_length_error());
  }

  // An edge with the least error is an edge of T1 or a straight line in space.
  static constexpr float input_error = static_cast<float>(input_length_error()),
                         certified_error = static_cast<float>(certified_length_error()),
                         unknown_error = std::numeric_limits<float>::infinity();

  void set_error(Edge_index e, float error)
  {
    m_error[e.idx()] = error;
    m_has_unknown_lengths = m_has_unknown_lengths || error == unknown_error;
  }

  Diamond<double> errors_around(Halfedge_index h) const
  {
    return diamond_of([this](Halfedge_index x) { return double(m_error[Edge_index(x).idx()]); }, h,
                      m_mesh);
  }

  float greatest_error_around(Halfedge_index h) const
  {
    float error = m_error[m_mesh.edge(h).idx()];
    for(Edge_index e : edges_around(h, m_mesh))
      error = (std::max)(error, m_error[e.idx()]);
    return error;
  }

  bool is_limited() const { return m_effort < std::numeric_limits<double>::infinity(); }

  BOOST_NOINLINE bool is_exactly_Delaunay(Halfedge_index h)
  {
    if(!can_afford(h))
      return By_lengths()(diamond(m_tri.length_map(), h, m_mesh));
    m_doubtful.push_back(m_mesh.edge(h));
    return m_decisions.is_exactly_Delaunay(h, greatest_error_around(h) == input_error);
  }

  double count(Edge_index e) const
  {
    return static_cast<double>(m_tri.coordinates().crossings(m_mesh.halfedge(e)));
  }

  // Returns whether the strip of `e` can be laid out. As long as courses are not stored, each
  // crossing is found by following an edge of T1 over others.
  bool can_afford(Edge_index e)
  {
    const bool could_afford = m_effort >= 0;
    m_effort -= count(e) * count(e);
    if(could_afford && m_effort < 0)
      m_courses.discard();
    return m_effort >= 0;
  }

  // Returns whether the diamond of `h` can be laid out. If not, its decisions are not certain.
  bool can_afford(Halfedge_index h)
  {
    bool result = can_afford(m_mesh.edge(h));
    for(Edge_index e : edges_around(h, m_mesh))
      result = can_afford(e) && result;
    if(!result)
      set_error(m_mesh.edge(h), unknown_error);
    return result;
  }

  BOOST_NOINLINE Bounded_length length_in_strip(Halfedge_index h, double by_diamond)
  {
    if(!can_afford(m_mesh.edge(h)))
      return {by_diamond, double(unknown_error)};
    m_doubtful.push_back(m_mesh.edge(h));
    return m_decisions.bounded_length(h);
  }

  // Returns the length of the other diagonal if the faces at the edge of `h`, whose sides are
  // straight in space, are coplanar. Returns 0 otherwise. In a plane, its ends have the same
  // distance in space as on the surface. The function avoids products that could underflow.
  double length_in_plane(Halfedge_index h, double flipped_length)
  {
    const auto& points = m_tri.input_metric().points;
    if(points.empty())
      return 0;
    const auto u = vector_between<double>(points[m_mesh.target(m_mesh.next(h))],
                                          points[m_mesh.target(m_mesh.next(m_mesh.opposite(h)))]);
    const double distance = std::sqrt(dot(u, u));
    const bool is_in_plane = !m_tri.coordinates().is_shared(m_mesh.edge(h)) ||
                             (std::abs(distance - flipped_length) < plane_tolerance() * distance &&
                              m_decisions.is_flat(m_tri.input_halfedge(h)));
    return is_in_plane && distance > 1e-100 ? distance : 0;
  }

  // Sets the lengths of edges, and returns whether these edges are straight.
  bool are_straight(std::vector<std::pair<Edge_index, double>>& edges)
  {
    const Edge_courses<Traits> courses(m_tri, Concurrency());
    Certifier<Traits> certifier(m_tri, courses, Concurrency());
    auto decisions = certifier.decisions();
    return std::all_of(edges.begin(), edges.end(), [&](auto& edge) {
      const Straight_edge straight = decisions.straight_edge(m_mesh.halfedge(edge.first));
      edge.second = straight.is_certain && !std::isnan(straight.length)
                      ? straight.length
                      : certifier.straight_length(edge.first, decisions);
      return edge.second > 0;
    });
  }

  bool has_sharpened_length(Edge_index e)
  {
    if(m_tri.coordinates().is_shared(e) || std::exchange(m_is_sharp[e.idx()], true))
      return false;
    const double before = m_tri.length(e);
    m_tri.m_length[e] = m_decisions.length(m_mesh.halfedge(e), rounding_unit<double>() / 2);
    return m_tri.length(e) != before;
  }

  Triangulation& m_tri;
  const Delta_complex& m_mesh;
  Edge_courses<Traits> m_courses;
  Decisions m_decisions;
  std::vector<float> m_error; // relative error bounds of the lengths
  double m_effort;
  double m_kept_error;
  bool m_has_unknown_lengths = false;
  std::vector<Edge_index> m_doubtful; // edges that stored lengths may not decide about rightly
  std::vector<char> m_is_sharp;       // whose lengths have been computed anew for these
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FLIPPING_EXACT_FLIPPING_H
