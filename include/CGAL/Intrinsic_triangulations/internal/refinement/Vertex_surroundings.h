// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_REFINEMENT_VERTEX_SURROUNDINGS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_REFINEMENT_VERTEX_SURROUNDINGS_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Surface_view.h>
#include <CGAL/Intrinsic_triangulations/corner_formulas.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Describes the neighbors and corners of an interior vertex. `Layout` lays out the faces.
template <typename EdgeLengthMap, typename Layout>
class Vertex_surroundings
{
  typedef typename boost::property_traits<EdgeLengthMap>::value_type FT;
  typedef std::complex<FT> Vector;

public:
  Vertex_surroundings(Vertex_index v, const Surface_view<EdgeLengthMap>& surface,
                      const Layout& layout)
    : m_surface(surface), m_layout(layout)
  {
    for_each_outgoing_halfedge(v, surface.mesh(),
                               [&](Halfedge_index h) { m_outgoing_halfedges.push_back(h); });
  }

  // Returns whether the vertex has fewer than three neighbors, and inserting the circumcenters of
  // its faces leaves fewer than three again. This happens on a pointed cone: the circumcenters hide
  // all neighbors.
  bool is_pointed_without_neighbors() const
  {
    return number_of_neighbors() < 3 && angle_sum() < pi<FT>();
  }

  FT shortest_outgoing() const
  {
    FT least = edge_length(m_outgoing_halfedges[0], m_surface);
    for(Halfedge_index h : m_outgoing_halfedges)
      least = (std::min)(least, edge_length(h, m_surface));
    return least;
  }

  // Returns a direction as a halfedge and the angle from it within its face. The direction is this
  // fraction of the angle around the vertex, counterclockwise from `outgoing`.
  std::pair<Halfedge_index, FT> direction(Halfedge_index outgoing, const FT& part) const
  {
    FT rest = part * angle_sum(), angle = this->angle(outgoing);
    for(std::size_t face = 1; rest > angle && face < m_outgoing_halfedges.size(); ++face) {
      rest -= angle;
      outgoing = next_around_source(outgoing, m_surface.mesh());
      angle = this->angle(outgoing);
    }
    return {outgoing, (std::min)(rest, angle)};
  }

  // Returns the outgoing halfedge to `v`, or null if `v` is not a neighbor.
  Halfedge_index outgoing_to(Vertex_index v) const
  {
    for(Halfedge_index h : m_outgoing_halfedges)
      if(m_surface.mesh().target(h) == v)
        return h;
    return Delta_complex::null_halfedge();
  }

private:
  std::size_t number_of_neighbors() const
  {
    std::vector<Vertex_index> neighbors;
    for(Halfedge_index h : m_outgoing_halfedges)
      neighbors.push_back(m_surface.mesh().target(h));
    std::sort(neighbors.begin(), neighbors.end());
    return std::size_t(std::unique(neighbors.begin(), neighbors.end()) - neighbors.begin());
  }

  FT angle_sum() const
  {
    FT sum(0);
    for(Halfedge_index h : m_outgoing_halfedges)
      sum += angle(h);
    return sum;
  }

  // Returns the angle at the source of `h` in its face.
  FT angle(Halfedge_index h) const
  {
    using std::atan2;
    const Vector apex = m_layout.apex(h, Vector(0), Vector(edge_length(h, m_surface)));
    return atan2(apex.imag(), apex.real());
  }

  Surface_view<EdgeLengthMap> m_surface;
  const Layout& m_layout;
  std::vector<Halfedge_index> m_outgoing_halfedges;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_REFINEMENT_VERTEX_SURROUNDINGS_H
