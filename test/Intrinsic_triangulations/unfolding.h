// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_TRIANGULATIONS_TEST_UNFOLDING_H
#define INTRINSIC_TRIANGULATIONS_TEST_UNFOLDING_H

#include "measuring.h"

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

// Distances by brute force: straight lines over all sequences of faces, nothing pruned but what is
// out of sight or too far, and all ways from vertex to vertex along them.
namespace Test_surfaces {

class Unfolding
{
public:
  // between the vertices and `points`, in this order
  Unfolding(const Flat_faces& faces, const std::vector<Location>& points)
    : m_faces(faces), m_mesh(faces.mesh()), m_size(m_mesh.number_of_vertices() + points.size())
  {
    for(Vertex_index v : m_mesh.vertices())
      m_corners.push_back(corners(v));
    for(const Location& p : points)
      m_corners.push_back(on_both_sides(p));
    m_distance.assign(m_size, std::vector<Real>(m_size, std::numeric_limits<Real>::infinity()));
    for(std::size_t i = 0; i < m_size; ++i)
      m_distance[i][i] = 0;
    // ways along edges and within faces bound the lines
    for(int pass = 0; pass < 2; ++pass) {
      for(std::size_t i = 0; i < m_size; ++i)
        look_around(i, pass == 1);
      add_up();
    }
  }

  double operator()(std::size_t i, std::size_t j) const
  {
    return static_cast<double>(m_distance[i][j]);
  }

private:
  std::vector<Location> corners(Vertex_index v) const
  {
    std::vector<Location> result;
    for(Halfedge_index h : m_mesh.halfedges())
      if(!m_mesh.is_border(h) && m_mesh.source(h) == v)
        result.push_back(m_faces.on(h, 0));
    return result;
  }

  std::vector<Location> on_both_sides(const Location& p) const
  {
    std::vector<Location> result{p};
    for(std::size_t s = 0; s < 3; ++s)
      if(const Halfedge_index o = m_mesh.opposite(m_faces.sides(p.first)[s]);
         p.second[(s + 2) % 3] == 0 && !m_mesh.is_border(o))
        result.push_back(m_faces.on(o, p.second[s]));
    return result;
  }

  void look_around(std::size_t from, bool beyond)
  {
    m_from = from;
    m_bound = 0;
    for(std::size_t j = 0; j < m_size; ++j)
      if(m_distance[from][j] < std::numeric_limits<Real>::infinity())
        m_bound = (std::max)(m_bound, m_distance[from][j]);
    for(const Location& p : m_corners[from])
      for(Halfedge_index h : m_faces.sides(p.first)) {
        const Place origin = m_faces.place(h, p);
        const auto corner = m_faces.layout(h);
        const Place a = corner[0] - origin, b = corner[1] - origin, apex = corner[2] - origin;
        note(h, a, b, apex, [](const Place&) { return true; });
        if(beyond && det(a, b) > 0)
          unfold(m_mesh.opposite(h), b, a, a, b);
      }
  }

  // Notes the distances of the points of a face that are seen.
  template <typename Is_seen>
  void note(Halfedge_index h, const Place& a, const Place& b, const Place& c,
            const Is_seen& is_seen)
  {
    for(std::size_t j = 0; j < m_size; ++j)
      for(const Location& q : m_corners[j])
        if(q.first == m_mesh.face(h)) {
          const auto w = IT::coordinates_from(h, q, m_mesh);
          const Place place = Real(w[0]) * a + Real(w[1]) * b + Real(w[2]) * c;
          if(is_seen(place)) {
            m_distance[m_from][j] = (std::min)(m_distance[m_from][j], norm(place));
            m_distance[j][m_from] = m_distance[m_from][j];
          }
        }
  }

  // The face of `h`, from `a` on the left to `b`, seen from 0 between the directions `right` and
  // `left`.
  void unfold(Halfedge_index h, const Place& a, const Place& b, const Place& right,
              const Place& left)
  {
    if(m_mesh.is_border(h) || nearest(a, b, right, left) > m_bound)
      return;
    const auto corner = m_faces.layout(h);
    const Real l = m_faces.length(h);
    const Place x = (1 / l) * (b - a), y{-x.y, x.x};
    const Place c = a + corner[2].x * x + corner[2].y * y;
    const Real e = 1e-15L;
    note(h, a, b, c, [&](const Place& q) {
      return det(right, q) >= -e * norm(right) * norm(q) &&
             det(q, left) >= -e * norm(left) * norm(q);
    });
    if(const Place end = det(c, left) > 0 ? c : left; det(right, end) > 0)
      unfold(m_mesh.opposite(m_mesh.next(h)), c, b, right, end);
    if(const Place end = det(right, c) > 0 ? c : right; det(end, left) > 0)
      unfold(m_mesh.opposite(m_mesh.prev(h)), a, c, end, left);
  }

  // a bound for the distance of what is seen of a segment
  static Real nearest(const Place& a, const Place& b, const Place& right, const Place& left)
  {
    const auto at = [&](const Place& d) {
      const Place s = b - a;
      const Real t = std::clamp(det(a, d) / det(d, s), Real(0), Real(1));
      return a + t * s;
    };
    const Place p = at(right), q = at(left), s = q - p;
    const Real square = s.x * s.x + s.y * s.y;
    const Real t =
      square > 0 ? std::clamp(-(p.x * s.x + p.y * s.y) / square, Real(0), Real(1)) : Real(0);
    return norm(p + t * s);
  }

  void add_up()
  {
    for(std::size_t k = 0; k < m_mesh.number_of_vertices(); ++k)
      for(std::size_t i = 0; i < m_size; ++i)
        for(std::size_t j = 0; j < m_size; ++j)
          m_distance[i][j] = (std::min)(m_distance[i][j], m_distance[i][k] + m_distance[k][j]);
  }

  const Flat_faces& m_faces;
  const Delta_complex& m_mesh;
  std::size_t m_size, m_from = 0;
  Real m_bound = 0;
  std::vector<std::vector<Location>> m_corners;
  std::vector<std::vector<Real>> m_distance;
};

} // namespace Test_surfaces

#endif // INTRINSIC_TRIANGULATIONS_TEST_UNFOLDING_H
