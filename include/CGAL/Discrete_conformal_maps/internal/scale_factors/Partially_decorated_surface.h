// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_PARTIALLY_DECORATED_SURFACE_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_PARTIALLY_DECORATED_SURFACE_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Penner_surface.h>
#include <CGAL/Discrete_conformal_maps/internal/tolerances.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

// Represents a closed ideal polyhedron with one vertex without horocycle, in the triangulation that
// is Delaunay for given scale factors of the others (Section 4.4.1). Without that vertex, its edges
// and its faces it is a disk, the remaining surface.
template <typename FT_>
class Partially_decorated_surface
{
public:
  typedef FT_ FT;

  template <typename EdgeLengthMap>
  Partially_decorated_surface(const Delta_complex& mesh, const EdgeLengthMap& length,
                              Vertex_index at_infinity)
    : m_surface(mesh, length), m_at_infinity(at_infinity)
  {}

  const Delta_complex& mesh() const { return m_surface.mesh(); }
  Vertex_index vertex_at_infinity() const { return m_at_infinity; }
  // Returns all flips so far.
  const std::vector<Halfedge_index>& flips() const { return m_surface.flips(); }

  bool is_remaining(Edge_index e) const
  {
    return mesh().vertex(e, 0) != m_at_infinity && mesh().vertex(e, 1) != m_at_infinity;
  }
  bool is_remaining(Face_index f) const
  {
    if(!f.is_valid()) // beyond a border
      return false;
    const Halfedge_index h = mesh().halfedge(f);
    return mesh().target(mesh().next(h)) != m_at_infinity && is_remaining(Edge_index(h));
  }

  // Returns the length with a scale factor of zero at the vertex at infinity. Arcs elsewhere do not
  // depend on it.
  const FT& scaled_length(Edge_index e) const { return m_surface.scaled_length(e); }

  // Sets other scale factors, and flips to the triangulation that is Delaunay with them. The factor
  // of the vertex at infinity has no influence.
  // \throws Numerical_error if a scaled length is not a length
  void scale(std::vector<FT> u)
  {
    using std::abs;
    u[m_at_infinity.idx()] = 0;
    FT greatest(0);
    for(Vertex_index v : mesh().vertices())
      greatest = (std::max)(greatest, FT(abs(u[v.idx()])));
    m_margin =
      tolerance::roundings_of_squares * std::numeric_limits<FT>::epsilon() * (1 + greatest);
    m_surface.set_scale_factors(u);
    m_surface.flip_until([this](Halfedge_index h) { return is_Delaunay(h); });
  }

  // Sets other scale factors at some vertices, as `Penner_surface::scale_at()` does.
  void scale_at(const std::vector<Vertex_index>& vertices, const std::vector<FT>& u)
  {
    m_surface.scale_at(vertices, u, [this](Halfedge_index h) { return is_Delaunay(h); });
  }

private:
  // Evaluates Equation 4.16, in which arcs at infinity vanish. Ties are decided in favor of edges
  // to infinity: they are the limit of triangulations with a horocycle at infinity. The two
  // tolerances differ, so that no edge is flipped back.
  bool is_Delaunay(Halfedge_index h) const
  {
    const auto is_finite = [this](Vertex_index v) { return v != m_at_infinity; };
    const Halfedge_index o = opposite(h);
    const bool i = is_finite(mesh().target(o)), j = is_finite(mesh().target(h)),
               k = is_finite(mesh().target(mesh().next(h))),
               l = is_finite(mesh().target(mesh().next(o)));
    const Horocyclic_arcs<FT> arc(m_surface.scaled_diamond(h));
    const FT facing = (k ? arc.at_k : FT(0)) + (l ? arc.at_l : FT(0));
    const FT adjacent = (i ? arc.at_i : FT(0)) + (j ? arc.at_j : FT(0));
    if(i && j && k != l)
      return facing < adjacent * (1 - m_margin);
    return !(facing > adjacent * (1 + 4 * m_margin));
  }

  Penner_surface<FT> m_surface;
  Vertex_index m_at_infinity;
  FT m_margin = FT(0); // of ties: the rounding error of squared lengths
};

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_PARTIALLY_DECORATED_SURFACE_H
