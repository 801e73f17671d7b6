// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_TRIANGULATIONS_TEST_PRECISE_UNFOLDING_H
#define INTRINSIC_TRIANGULATIONS_TEST_PRECISE_UNFOLDING_H

#include "generators.h"

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Surface_view.h>
#include <CGAL/Intrinsic_triangulations/operators.h>
#include <boost/multiprecision/cpp_bin_float.hpp>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

// Distances from a vertex by brute force in 34 digits, on meshes that `double` can hardly hold:
// straight lines from every vertex over all sequences of faces, nothing pruned but what is out of
// sight or too far.
namespace Test_surfaces {

class Precise_unfolding
{
public:
  typedef boost::multiprecision::cpp_bin_float_quad Number;

  // All edges are made longer by one length, the least for which no face is flat.
  template <typename Surface>
  explicit Precise_unfolding(const Surface& surface)
    : m_mesh(surface.mesh()), m_length(m_mesh.num_edges()), m_apex(m_mesh.num_halfedges())
  {
    Number longest = 0, excess = 0;
    for(Edge_index e : m_mesh.edges()) {
      m_length[e.idx()] = surface.length_map()[e];
      longest = (std::max)(longest, length(m_mesh.halfedge(e)));
    }
    for(Halfedge_index h : inner_halfedges())
      excess =
        (std::max)(excess, Number(length(h) - length(m_mesh.next(h)) - length(m_mesh.prev(h))));
    for(Number& l : m_length)
      l += excess + 1e-24 * longest;
    for(Halfedge_index h : inner_halfedges())
      m_apex[h.idx()] = apex(length(h), length(m_mesh.next(h)), length(m_mesh.prev(h)));
  }

  // of all vertices from `v`; none if that takes more than `bound` faces
  std::optional<std::vector<double>> distances(Vertex_index v, std::size_t bound)
  {
    m_faces_left = bound;
    along_edges(v);
    std::vector<bool> is_done(m_mesh.num_vertices(), false);
    for(std::size_t i = 0; i < is_done.size(); ++i) {
      std::size_t nearest = is_done.size();
      for(std::size_t j = 0; j < is_done.size(); ++j)
        if(!is_done[j] && (nearest == is_done.size() || m_distance[j] < m_distance[nearest]))
          nearest = j;
      is_done[nearest] = true;
      if(!look_around(Vertex_index(static_cast<unsigned>(nearest))))
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
    friend Number norm(const Place& p) { return sqrt(p.x * p.x + p.y * p.y); }
  };

  // What is seen through the halfedge from `a` on the left to `b`, between two directions.
  struct Sight
  {
    Halfedge_index h;
    Place a, b, right, left;
  };

  const Number& length(Halfedge_index h) const { return m_length[Edge_index(h).idx()]; }

  std::vector<Halfedge_index> inner_halfedges() const
  {
    std::vector<Halfedge_index> result;
    for(Halfedge_index h : m_mesh.halfedges())
      if(!m_mesh.is_border(h))
        result.push_back(h);
    return result;
  }

  // the corner opposite to side `c`, which is on the x-axis
  static Place apex(const Number& c, const Number& a, const Number& b)
  {
    const Number x = (c * c + (b - a) * (b + a)) / (2 * c);
    return {x, sqrt((std::max)(Number(0), Number((b - x) * (b + x))))};
  }

  // Ways along edges are bounds.
  void along_edges(Vertex_index v)
  {
    const double infinite = std::numeric_limits<double>::infinity();
    m_distance.assign(m_mesh.num_vertices(), infinite);
    m_distance[v.idx()] = 0;
    for(bool is_better = true; is_better;) {
      is_better = false;
      for(Halfedge_index h : m_mesh.halfedges())
        is_better |= improve(m_mesh.target(h), m_distance[m_mesh.source(h).idx()] + length(h));
    }
  }

  bool improve(Vertex_index v, const Number& distance)
  {
    const bool is_better = distance < m_distance[v.idx()];
    if(is_better)
      m_distance[v.idx()] = distance;
    return is_better;
  }

  bool look_around(Vertex_index v)
  {
    m_before = m_distance[v.idx()];
    m_bound = *std::max_element(m_distance.begin(), m_distance.end());
    for(Halfedge_index h : inner_halfedges()) {
      improve(m_mesh.target(h), m_distance[m_mesh.source(h).idx()] + length(h));
      improve(m_mesh.source(h), m_distance[m_mesh.target(h).idx()] + length(h));
      if(m_mesh.target(m_mesh.next(h)) != v)
        continue;
      const Place a = Place{0, 0} - m_apex[h.idx()], b = Place{length(h), 0} - m_apex[h.idx()];
      if(!unfold({m_mesh.opposite(h), b, a, a, b}))
        return false;
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
        improve(m_mesh.target(m_mesh.next(h)), m_before + norm(c));
      const Place end = to_left > 0 ? c : left, begin = from_right > 0 ? c : right;
      if(det(right, end) > 0)
        waiting.push_back({m_mesh.opposite(m_mesh.next(h)), c, b, right, end});
      if(det(begin, left) > 0)
        waiting.push_back({m_mesh.opposite(m_mesh.prev(h)), a, c, begin, left});
    }
    return waiting.empty();
  }

  // a bound for the distance of what is seen of a segment
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
  std::vector<Place> m_apex; // by halfedges
  std::vector<Number> m_distance;
  Number m_before, m_bound;
  std::size_t m_faces_left = 0;
};

} // namespace Test_surfaces

#endif // INTRINSIC_TRIANGULATIONS_TEST_PRECISE_UNFOLDING_H
