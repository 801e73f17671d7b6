// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_WEIGHTS_EXACT_WEIGHTED_FLIPPING_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_WEIGHTS_EXACT_WEIGHTED_FLIPPING_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/Ball.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/Exact_decisions.h>
#include <CGAL/Intrinsic_triangulations/internal/flipping/Exact_flipping.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Edge_courses.h>
#include <CGAL/Intrinsic_triangulations/internal/weights/Weight_form.h>
#include <CGAL/Intrinsic_triangulations/make_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/make_weighted_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/tolerances.h>
#include <CGAL/Intrinsic_triangulations/weighted_formulas.h>

#include <CGAL/Uncertain.h>
#include <CGAL/enum.h>

#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Provides the squared radii of circles, which are exact, as weights.
template <typename RadiusMap>
struct Squared_radii
{
  const RadiusMap& radius;

  template <typename N>
  Ball<N> ball(Vertex_index v) const
  {
    const Ball<N> r{N(get(radius, v)), N(0), 0};
    return r * r;
  }
};

// Decides which edges of T2 are weighted Delaunay, for weights in balls `weights.ball<N>(v)`.
template <typename Traits, typename Weights>
class Weighted_decisions : public Exact_decisions<Traits>
{
  typedef Exact_decisions<Traits> Base;

public:
  Weighted_decisions(const Triangulation_pair<Traits>& pair, const Edge_courses<Traits>& courses,
                     const Weights& weights)
    : Base(pair, courses), m_weights(weights)
  {}

  // Returns whether the edge of `h` is weighted Delaunay. If 1024 binary digits do not distinguish
  // it from a tie, it counts as a tie.
  bool is_weighted_Delaunay(Halfedge_index h) const
  {
    Uncertain<Sign> sign = Uncertain<Sign>::indeterminate();
    Base::try_with_more_digits([&](auto& corners) {
      sign = rounded_dual_edge_sign(h, Base::m_mesh, Base::development(corners), m_weights);
      return is_certain(sign);
    });
    return !certainly(sign == NEGATIVE);
  }

private:
  const Weights& m_weights;
};

// Flips with decisions about the surface of T1, to the weighted Delaunay triangulation.
template <typename Traits, typename RadiusMap>
class Exact_weighted_flipping
{
public:
  Exact_weighted_flipping(Intrinsic_triangulation<Traits>& tri, const RadiusMap& radius)
    : m_tri(tri),
      m_flipping(tri),
      m_courses(tri),
      m_weights{radius},
      m_decisions(tri, m_courses, m_weights)
  {}

  // Decisions refer to the weights.
  Exact_weighted_flipping(const Exact_weighted_flipping&) = delete;
  Exact_weighted_flipping& operator=(const Exact_weighted_flipping&) = delete;

  bool is_certainly_Delaunay(Edge_index e) const
  {
    const Delta_complex& mesh = m_tri.mesh();
    const Halfedge_index h = mesh.halfedge(e);
    return mesh.is_border(e) ||
           m_is_good.is_certain(diamond(m_tri.length_map(), h, mesh),
                                diamond_weights(squared_radius_map(m_weights.radius), h, mesh));
  }

  bool is_Delaunay(Edge_index e)
  {
    const Halfedge_index h = m_tri.mesh().halfedge(e);
    return is_certainly_Delaunay(e) || !m_flipping.can_be_turned(h) ||
           m_decisions.is_weighted_Delaunay(h) || hides_end(h);
  }

  bool flip(Halfedge_index h)
  {
    const bool result = m_flipping.flip(h);
    m_courses.after_flip(h);
    return result;
  }

  // Returns the vertices that others hide.
  std::vector<Vertex_index> hidden_vertices() const { return m_hidden; }

private:
  // Returns whether an edge that is not weighted Delaunay has an end at which its faces are not
  // convex.
  bool hides_end(Halfedge_index h)
  {
    for(Halfedge_index end : {h, opposite(h)})
      if(m_decisions.convexity_at_source(end) != POSITIVE) {
        m_hidden.push_back(m_tri.mesh().source(end));
        return true;
      }
    return false;
  }

  Intrinsic_triangulation<Traits>& m_tri;
  Exact_flipping<Traits> m_flipping;
  Edge_courses<Traits> m_courses;
  Squared_radii<RadiusMap> m_weights;
  Weighted_decisions<Traits, Squared_radii<RadiusMap>> m_decisions;
  Is_locally_weighted_Delaunay<double> m_is_good{certified_length_error()};
  std::vector<Vertex_index> m_hidden;
};

// Flips to the weighted Delaunay triangulation of the exact surface, for circles around its
// vertices. An edge is not flipped if 1024 binary digits do not distinguish it from a tie.
// \throws Flip_limit_exceeded, Overflow_error as `make_Delaunay()` does
template <typename Traits, typename RadiusMap, typename Visitor>
Weighted_Delaunay_result<double> flip_exactly_with_circles(Intrinsic_triangulation<Traits>& tri,
                                                           const RadiusMap& radius,
                                                           Visitor& visitor)
{
  Exact_weighted_flipping<Traits, RadiusMap> flipping(tri, radius);
  const Flipping_result flips = flip_to_Delaunay(
    tri.mesh(), flipping, default_flip_limit(tri.mesh().number_of_edges()), visitor);
  check_flip_limit(!flips.is_Delaunay());
  return Weighted_Delaunay_result<double>{flips.flips, flipping.hidden_vertices(), {}};
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_WEIGHTS_EXACT_WEIGHTED_FLIPPING_H
