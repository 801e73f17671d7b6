// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_REFINEMENT_DIJKSTRA_BALL_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_REFINEMENT_DIJKSTRA_BALL_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Surface_view.h>

#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Finds vertices whose distance along edges is at most a radius. A call costs no more than its
// ball. It ends because lengths are positive: a vertex enters the queue again only with a smaller
// distance, and there are finitely many within the radius.
template <typename EdgeLengthMap>
class Dijkstra_ball
{
  typedef typename boost::property_traits<EdgeLengthMap>::value_type FT;
  typedef std::pair<FT, Vertex_index> Entry;

  // a label of an earlier call has another `round`
  struct Label
  {
    std::size_t round = 0;
    FT distance{};
  };

public:
  Dijkstra_ball(const Surface_view<EdgeLengthMap>& surface)
    : m_surface(surface), m_mesh(surface.mesh())
  {}

  // Returns the vertices of the ball in the order of their distances, `center` the first of them.
  const std::vector<Vertex_index>& vertices(Vertex_index center, const FT& radius)
  {
    ++m_round;
    m_label.resize(m_mesh.num_vertices());
    m_vertices.clear();
    push(center, FT(0));
    while(!m_queue.empty()) {
      const auto [distance, v] = m_queue.top();
      m_queue.pop();
      if(distance > m_label[v.idx()].distance)
        continue;
      m_vertices.push_back(v);
      for_each_spoke(v, m_mesh, [&, d = distance](Halfedge_index h) {
        const FT reached = d + edge_length(h, m_surface);
        if(reached <= radius)
          push(m_mesh.target(h), reached);
      });
    }
    return m_vertices;
  }

private:
  void push(Vertex_index v, const FT& distance)
  {
    Label& label = m_label[v.idx()];
    if(label.round == m_round && label.distance <= distance)
      return;
    label = {m_round, distance};
    m_queue.push({distance, v});
  }

  Surface_view<EdgeLengthMap> m_surface;
  const Delta_complex& m_mesh;
  std::size_t m_round = 0;
  std::vector<Label> m_label;
  std::vector<Vertex_index> m_vertices;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> m_queue;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_REFINEMENT_DIJKSTRA_BALL_H
