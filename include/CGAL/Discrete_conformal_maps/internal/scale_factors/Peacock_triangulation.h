// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_PEACOCK_TRIANGULATION_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_PEACOCK_TRIANGULATION_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Ptolemy_surface.h>
#include <CGAL/Discrete_conformal_maps/internal/tolerances.h>
#include <CGAL/Intrinsic_triangulations/Edge_stack.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

// Represents the triangulation whose edges join a center to all other vertices by shortest
// geodesics, and to itself (Section 4.4.3). It is ideal Delaunay if only the center has a
// horocycle.
//
// The surface may have a border, whose edges are not flipped. They are geodesics, and shortest
// geodesics within the surface do not cross them.
//
// The other horocycles shrink at the same rate, and every edge is flipped when it ceases to be
// Delaunay. So intermediate edges stay short.
template <typename FT>
class Peacock_triangulation
{
public:
  // Flips to the triangulation with the center `center`.
  // \pre the triangulation is ideal Delaunay
  // \throws Flip_limit_exceeded if rounding prevents the flips from ending
  template <typename EdgeLengthMap>
  Peacock_triangulation(const Delta_complex& mesh, const EdgeLengthMap& length, Vertex_index center)
    : m_surface(mesh, length), m_center(center), m_end(mesh.num_edges())
  {
    for(Edge_index e : mesh.edges())
      enqueue(e);
    while(!m_queue.empty()) {
      const auto [end, number] = m_queue.top();
      m_queue.pop();
      if(end == m_end[number])
        flip(Halfedge_index(2 * number));
    }
  }

  const Delta_complex& mesh() const { return m_surface.mesh(); }

  std::size_t number_of_flips() const { return m_surface.flips().size(); }

  // Returns the distance of the horocycle of the center to the horocycle of each vertex, or
  // infinity for the center itself.
  std::vector<FT> distances() const
  {
    using std::log;
    std::vector<FT> shortest(mesh().num_vertices(), std::numeric_limits<FT>::infinity());
    for(Halfedge_index h : mesh().halfedges())
      if(mesh().source(h) == m_center && mesh().target(h) != m_center) {
        FT& length = shortest[mesh().target(h).idx()];
        length = (std::min)(length, m_surface.length(mesh().edge(h)));
      }
    for(FT& length : shortest)
      length = 2 * log(length);
    return shortest;
  }

private:
  typedef Delta_complex::size_type size_type;

  // Records the scale of the arcs at the center at which the edge ceases to be Delaunay (Equation
  // 4.16).
  void enqueue(Edge_index e)
  {
    const Halfedge_index h(2 * e.idx()), o = opposite(h);
    const Horocyclic_arcs<FT> arc(m_surface.diamond(h));
    FT growing(0), shrinking(0), center_size(0); // what stands against the edge
    const auto add = [&](Vertex_index v, const FT& x) {
      (v == m_center ? growing : shrinking) += x;
      if(v == m_center)
        center_size += x < 0 ? FT(-x) : x;
    };
    add(mesh().target(mesh().next(h)), arc.at_k);
    add(mesh().target(mesh().next(o)), arc.at_l);
    add(mesh().target(o), -arc.at_i);
    add(mesh().target(h), -arc.at_j);
    FT& end = m_end[e.idx()];
    end = (std::max)(FT(-shrinking / growing), m_scale);
    // Rounding does not break a tie, so that no edge is flipped endlessly.
    if(growing > tolerance::roundings_of_squares * std::numeric_limits<FT>::epsilon() * center_size)
      m_queue.emplace(end, e.idx());
    else
      end = std::numeric_limits<FT>::infinity();
  }

  void flip(Halfedge_index h)
  {
    if(flip_status(h, mesh()) != Intrinsic_triangulations::Operation_status::possible)
      return;
    m_scale = m_end[Edge_index(h).idx()];
    Intrinsic_triangulations::check_flip_limit(number_of_flips(), mesh().num_edges());
    m_surface.flip(h);
    m_end[Edge_index(h).idx()] = std::numeric_limits<FT>::infinity(); // it does not come back
    for(Edge_index e : Intrinsic_triangulations::edges_around(h, mesh()))
      enqueue(e);
  }

  Ptolemy_surface<FT> m_surface;
  Vertex_index m_center;
  FT m_scale = FT(1);    // of the arcs at the center, to the others
  std::vector<FT> m_end; // the scale up to which each edge stays
  typedef std::pair<FT, size_type> Entry;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> m_queue;
};

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_PEACOCK_TRIANGULATION_H
