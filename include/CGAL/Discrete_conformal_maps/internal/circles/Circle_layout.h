// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_CIRCLES_CIRCLE_LAYOUT_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_CIRCLES_CIRCLE_LAYOUT_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Circle_packing.h>
#include <CGAL/Discrete_conformal_maps/Delta_complex.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <queue>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

// Computes the positions of circles with given radii that touch along the edges of a triangulated
// disk. The layout starts at the origin with the face of the smallest circles, because `double`
// has the most digits near the origin. Directions of edges are rotated from face to face,
// independently of positions.
class Circle_layout
{
public:
  Circle_layout(const Delta_complex& mesh, const std::vector<double>& radius)
    : m_mesh(mesh),
      m_radius(radius),
      m_circles(radius.size()),
      m_is_placed(radius.size(), false),
      m_is_done(mesh.num_faces(), false)
  {
    const Halfedge_index h = smallest_side();
    place(mesh.source(h), {0, 0});
    place(mesh.target(h), {radius[mesh.source(h)] + radius[mesh.target(h)], 0});
    m_next.push({h, {1, 0}});
    m_next.push({mesh.opposite(h), {-1, 0}});
    for(; !m_next.empty(); m_next.pop())
      lay_out(m_next.front());
  }

  const std::vector<Planar_circle>& circles() const { return m_circles; }

  // Returns whether a face is reversed, and rounding of its corners does not explain it.
  bool has_reversed_faces() const
  {
    return std::any_of(m_mesh.faces().begin(), m_mesh.faces().end(), [this](Face_index f) {
      const auto [a, b, c] = corners(m_mesh.halfedge(f));
      const std::complex<double> p = m_circles[a].center, ab = m_circles[b].center - p,
                                 ac = m_circles[c].center - p;
      const double rounding = std::abs(p) + std::abs(ab) + std::abs(ac);
      return (std::conj(ab) * ac).imag() < -1e-15 * rounding * (std::abs(ab) + std::abs(ac));
    });
  }

private:
  // Stores a halfedge with its direction. The positions of its ends are known.
  struct Directed
  {
    Halfedge_index halfedge;
    std::complex<double> direction;
  };

  std::array<Vertex_index, 3> corners(Halfedge_index h) const
  {
    return {m_mesh.source(h), m_mesh.target(h), m_mesh.target(m_mesh.next(h))};
  }

  Halfedge_index smallest_side() const
  {
    const auto size = [this](Face_index f) {
      const auto [a, b, c] = corners(m_mesh.halfedge(f));
      return (std::max)({m_radius[a], m_radius[b], m_radius[c]});
    };
    return m_mesh.halfedge(
      *std::min_element(m_mesh.faces().begin(), m_mesh.faces().end(),
                        [&](Face_index f, Face_index g) { return size(f) < size(g); }));
  }

  void place(Vertex_index v, const std::complex<double>& center)
  {
    m_circles[v] = {center, m_radius[v]};
    m_is_placed[v] = true;
  }

  // Returns the direction of the angle at the first of three circles that touch.
  std::complex<double> angle(Vertex_index a, Vertex_index b, Vertex_index c) const
  {
    const double sum = m_radius[a] + m_radius[b] + m_radius[c];
    const std::complex<double> half(std::sqrt(m_radius[a] / m_radius[b]),
                                    std::sqrt(m_radius[c] / sum));
    return half * half / std::norm(half);
  }

  // Computes the position of the third corner of a face, unless another face has determined it.
  void lay_out(const Directed& side)
  {
    const Halfedge_index h = side.halfedge;
    if(m_mesh.is_border(h) || m_is_done[m_mesh.face(h)])
      return;
    m_is_done[m_mesh.face(h)] = true;
    const auto [a, b, c] = corners(h);
    const std::complex<double> ac = side.direction * angle(a, b, c),
                               bc = -side.direction * std::conj(angle(b, a, c));
    if(!m_is_placed[c])
      place(c, m_circles[a].center + (m_radius[a] + m_radius[c]) * ac);
    m_next.push({m_mesh.opposite(m_mesh.next(h)), -bc});
    m_next.push({m_mesh.opposite(m_mesh.prev(h)), ac});
  }

  const Delta_complex& m_mesh;
  const std::vector<double>& m_radius;
  std::vector<Planar_circle> m_circles;
  std::vector<bool> m_is_placed, m_is_done;
  std::queue<Directed> m_next;
};

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_CIRCLES_CIRCLE_LAYOUT_H
