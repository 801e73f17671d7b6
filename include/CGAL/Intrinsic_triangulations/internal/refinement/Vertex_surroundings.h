// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_REFINEMENT_VERTEX_SURROUNDINGS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_REFINEMENT_VERTEX_SURROUNDINGS_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Edge_point.h>
#include <CGAL/Intrinsic_triangulations/Surface_view.h>
#include <CGAL/Intrinsic_triangulations/corner_formulas.h>
#include <CGAL/Intrinsic_triangulations/exponential_map.h>
#include <CGAL/Intrinsic_triangulations/internal/geodesics/Vertex_angles.h>

#include <algorithm>
#include <complex>
#include <cstddef>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Describes the neighbors and corners of an interior vertex.
template <typename EdgeLengthMap>
class Vertex_surroundings
{
  typedef typename boost::property_traits<EdgeLengthMap>::value_type FT;

public:
  Vertex_surroundings(Vertex_index v, const Surface_view<EdgeLengthMap>& surface)
    : m_surface(surface)
  {
    for_each_outgoing_halfedge(v, surface.mesh(),
                               [&](Halfedge_index h) { m_outgoing_halfedges.push_back(h); });
  }

  // Returns whether the vertex has fewer than three neighbors, and inserting the circumcenters of
  // its faces leaves fewer than three again. This happens on a pointed cone: the circumcenters hide
  // all neighbors.
  bool is_pointed_without_neighbors() const
  {
    FT sum(0);
    for(Halfedge_index h : m_outgoing_halfedges)
      sum += angle_at_source(h, m_surface);
    return sum < pi<FT>() && number_of_neighbors() < 3;
  }

  FT shortest_outgoing() const
  {
    FT least = edge_length(m_outgoing_halfedges[0], m_surface);
    for(Halfedge_index h : m_outgoing_halfedges)
      least = (std::min)(least, edge_length(h, m_surface));
    return least;
  }

  // Returns the point at this distance in a direction given by `part`. The direction is this
  // fraction of the angle around the vertex, counterclockwise from `outgoing`.
  Face_location<FT> place(Halfedge_index outgoing, const FT& part, const FT& distance) const
  {
    const FT angle = Vertex_angles<FT>(outgoing, m_surface).normalized(FT(0)) + 2 * pi<FT>() * part;
    return trace_geodesic(m_surface, m_surface.mesh().source(outgoing), std::polar(distance, angle))
      .end;
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

  Surface_view<EdgeLengthMap> m_surface;
  std::vector<Halfedge_index> m_outgoing_halfedges;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_REFINEMENT_VERTEX_SURROUNDINGS_H
