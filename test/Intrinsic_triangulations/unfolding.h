// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_TRIANGULATIONS_TEST_UNFOLDING_H
#define INTRINSIC_TRIANGULATIONS_TEST_UNFOLDING_H

#include "measuring.h"

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>

// This file computes distances by brute force: straight lines from every vertex over all sequences
// of faces. Only invisible or too distant faces are pruned.
namespace Test_surfaces {

// Unfolds with numbers of more digits, also on meshes at the limits of `double`.
template <typename Number = long double>
class Unfolding
{
public:
  // Computes distances between the vertices and `points`, in this order. All edges are made longer
  // by one length, the least for which no face is flat.
  template <typename Surface>
  explicit Unfolding(const Surface& surface, const std::vector<Location>& points = {})
    : m_mesh(surface.mesh()),
      m_length(m_mesh.num_edges()),
      m_apex(m_mesh.num_halfedges()),
      m_in_face(m_mesh.num_faces()),
      m_seats(m_mesh.num_vertices())
  {
    set_lengths(surface);
    for(Halfedge_index h : inner_halfedges()) {
      m_apex[h.idx()] = apex(length(h), length(m_mesh.next(h)), length(m_mesh.prev(h)));
      m_seats[m_mesh.source(h).idx()].push_back({m_mesh.source(h).idx(), h, {1, 0, 0}});
    }
    for(const Location& p : points)
      add(p);
  }

  // Returns the distances from one of them, or nothing if this takes more than `bound` faces.
  std::optional<std::vector<double>>
  distances(std::size_t from, std::size_t bound = (std::numeric_limits<std::size_t>::max)())
  {
    m_faces_left = bound;
    m_distance.assign(m_seats.size(), infinity());
    m_distance[from] = 0;
    go_within_faces();
    std::vector<bool> is_done(m_seats.size(), false);
    for(std::size_t i = from; i < m_seats.size(); i = nearest(is_done)) {
      is_done[i] = true;
      if((i == from || i < m_mesh.num_vertices()) && !look_around(i))
        return std::nullopt;
    }
    std::vector<double> result;
    for(const Number& d : m_distance)
      result.push_back(static_cast<double>(d));
    return result;
  }

private:
  struct Place
  {
    Number x, y;

    friend Place operator+(const Place& p, const Place& q) { return {p.x + q.x, p.y + q.y}; }
    friend Place operator-(const Place& p, const Place& q) { return {p.x - q.x, p.y - q.y}; }
    friend Place operator*(const Number& s, const Place& p) { return {s * p.x, s * p.y}; }
    friend Number det(const Place& p, const Place& q) { return p.x * q.y - p.y * q.x; }
    friend Number norm(const Place& p)
    {
      using std::sqrt;
      return sqrt(p.x * p.x + p.y * p.y);
    }
  };
  typedef std::array<Place, 3> Triangle;

  // Represents a vertex or a point in a face, with weights of its corners, beginning with the
  // corner of `h`.
  struct Seat
  {
    std::size_t index;
    Halfedge_index h;
    std::array<Number, 3> weight;
  };

  // Represents the visible part through the halfedge from `a` on the left to `b`, between two
  // directions.
  struct Sight
  {
    Halfedge_index h;
    Place a, b, right, left;
  };

  static Number infinity() { return Number(std::numeric_limits<double>::infinity()); }

  const Number& length(Halfedge_index h) const { return m_length[Edge_index(h).idx()]; }

  std::vector<Halfedge_index> inner_halfedges() const
  {
    std::vector<Halfedge_index> result;
    for(Halfedge_index h : m_mesh.halfedges())
      if(!m_mesh.is_border(h))
        result.push_back(h);
    return result;
  }

  template <typename Surface>
  void set_lengths(const Surface& surface)
  {
    Number longest = 0, excess = 0;
    for(Edge_index e : m_mesh.edges()) {
      m_length[e.idx()] = surface.length_map()[e];
      longest = (std::max)(longest, m_length[e.idx()]);
    }
    for(Halfedge_index h : inner_halfedges())
      excess =
        (std::max)(excess, Number(length(h) - length(m_mesh.next(h)) - length(m_mesh.prev(h))));
    for(Number& l : m_length)
      l += excess + 1e-24 * longest;
  }

  // Returns the corner opposite to side `c`, which is on the x-axis.
  static Place apex(const Number& c, const Number& a, const Number& b)
  {
    using std::sqrt;
    const Number x = (c * c + (b - a) * (b + a)) / (2 * c);
    return {x, sqrt((std::max)(Number(0), Number((b - x) * (b + x))))};
  }

  // ---- Vertices and points ----

  void add(const Seat& point)
  {
    m_seats[point.index].push_back(point);
    m_in_face[m_mesh.face(point.h).idx()].push_back(point);
  }

  // Adds a point; a point on a side is added in both its faces.
  void add(const Location& p)
  {
    const Halfedge_index h = m_mesh.halfedge(p.first);
    m_seats.emplace_back();
    add({m_seats.size() - 1, h, {p.second[0], p.second[1], p.second[2]}});
    std::size_t k = 0;
    for(Halfedge_index side : {h, m_mesh.next(h), m_mesh.prev(h)}) {
      if(const auto o = m_mesh.opposite(side); p.second[(k + 2) % 3] == 0 && !m_mesh.is_border(o))
        add({m_seats.size() - 1, o, {p.second[(k + 1) % 3], p.second[k], 0}});
      ++k;
    }
  }

  // Returns the corners of a face, beginning with the corner of `h`.
  Triangle layout(Halfedge_index h) const
  {
    return {Place{0, 0}, Place{length(h), 0}, m_apex[h.idx()]};
  }

  // Returns the position in a face with known corners, beginning with the corner of `h`.
  Place place(const Seat& seat, Halfedge_index h, const Triangle& corner) const
  {
    const std::size_t k = seat.h == h ? 0 : m_mesh.next(h) == seat.h ? 1 : 2;
    return seat.weight[0] * corner[k] + seat.weight[1] * corner[(k + 1) % 3] +
           seat.weight[2] * corner[(k + 2) % 3];
  }

  bool improve(std::size_t i, const Number& distance)
  {
    const bool is_better = distance < m_distance[i];
    if(is_better)
      m_distance[i] = distance;
    return is_better;
  }

  // Adds lines within faces, which are bounds for others.
  void go_within_faces()
  {
    for(bool is_better = true; is_better;) {
      is_better = false;
      for(const auto& seats : m_seats)
        for(const Seat& p : seats)
          is_better |= go_within_face(p);
    }
  }

  bool go_within_face(const Seat& p)
  {
    const Triangle corner = layout(p.h);
    const Place start = place(p, p.h, corner);
    bool is_better = false;
    const auto go_to = [&](std::size_t i, const Place& end) {
      is_better |= improve(i, m_distance[p.index] + norm(end - start));
    };
    go_to(m_mesh.source(p.h).idx(), corner[0]);
    go_to(m_mesh.target(p.h).idx(), corner[1]);
    go_to(m_mesh.target(m_mesh.next(p.h)).idx(), corner[2]);
    for(const Seat& q : m_in_face[m_mesh.face(p.h).idx()])
      go_to(q.index, place(q, p.h, corner));
    return is_better;
  }

  // Returns the nearest seat that is not done and in reach.
  std::size_t nearest(const std::vector<bool>& is_done) const
  {
    std::size_t result = m_seats.size();
    for(std::size_t i = 0; i < m_seats.size(); ++i)
      if(!is_done[i] && m_distance[i] < (result < m_seats.size() ? m_distance[result] : infinity()))
        result = i;
    return result;
  }

  // ---- Lines ----

  bool look_around(std::size_t from)
  {
    m_before = m_distance[from];
    m_bound = 0;
    for(const Number& d : m_distance)
      if(d < infinity())
        m_bound = (std::max)(m_bound, d);
    for(const Seat& p : m_seats[from]) {
      go_within_face(p);
      for(Halfedge_index h : {p.h, m_mesh.next(p.h), m_mesh.prev(p.h)}) {
        const Triangle corner = layout(h);
        const Place origin = place(p, h, corner), a = corner[0] - origin, b = corner[1] - origin;
        if(det(a, b) > 0 && !unfold({m_mesh.opposite(h), b, a, a, b}))
          return false;
      }
    }
    return true;
  }

  bool unfold(const Sight& first)
  {
    std::vector<Sight> waiting{first};
    while(!waiting.empty() && m_faces_left > 0) {
      const auto [h, a, b, right, left] = waiting.back();
      waiting.pop_back();
      if(m_mesh.is_border(h) || m_before + nearest(a, b, right, left) > m_bound)
        continue;
      --m_faces_left;
      const Place x = (1 / length(h)) * (b - a), y{-x.y, x.x};
      const Place c = a + m_apex[h.idx()].x * x + m_apex[h.idx()].y * y;
      const Number from_right = det(right, c), to_left = det(c, left);
      if(from_right >= 0 && to_left >= 0)
        improve(m_mesh.target(m_mesh.next(h)).idx(), m_before + norm(c));
      for(const Seat& q : m_in_face[m_mesh.face(h).idx()])
        if(const Place p = place(q, h, {a, b, c}); det(right, p) >= 0 && det(p, left) >= 0)
          improve(q.index, m_before + norm(p));
      const Place end = to_left > 0 ? c : left, begin = from_right > 0 ? c : right;
      if(det(right, end) > 0)
        waiting.push_back({m_mesh.opposite(m_mesh.next(h)), c, b, right, end});
      if(det(begin, left) > 0)
        waiting.push_back({m_mesh.opposite(m_mesh.prev(h)), a, c, begin, left});
    }
    return waiting.empty();
  }

  // Returns a bound for the distance of the visible part of a segment.
  static Number nearest(const Place& a, const Place& b, const Place& right, const Place& left)
  {
    const Place s = b - a;
    const auto at = [&](const Place& d) -> Place {
      return a + std::clamp<Number>(det(a, d) / det(d, s), 0, 1) * s;
    };
    const Place p = at(right), q = at(left) - p;
    const Number square = q.x * q.x + q.y * q.y;
    return norm(
      p +
      (square > 0 ? std::clamp<Number>(-(p.x * q.x + p.y * q.y) / square, 0, 1) : Number(0)) * q);
  }

  const Delta_complex& m_mesh;
  std::vector<Number> m_length;
  std::vector<Place> m_apex;                // by halfedges
  std::vector<std::vector<Seat>> m_in_face; // points by faces
  std::vector<std::vector<Seat>> m_seats;   // by vertices and points
  std::vector<Number> m_distance;
  Number m_before, m_bound;
  std::size_t m_faces_left = 0;
};

} // namespace Test_surfaces

#endif // INTRINSIC_TRIANGULATIONS_TEST_UNFOLDING_H
