// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_WEIGHTS_WEIGHT_BOUNDS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_WEIGHTS_WEIGHT_BOUNDS_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Triangulation_pair.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/Exact_decisions.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Edge_courses.h>
#include <CGAL/Intrinsic_triangulations/internal/weights/Weight_form.h>

#include <CGAL/Uncertain.h>
#include <CGAL/enum.h>

#include <algorithm>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Finds the bounds of the weight of a vertex by geodesics through it. Constrained edges and the
// boundary stop geodesics.
template <typename Traits>
class Weight_bounds
{
  typedef Triangulation_pair<Traits> Pair;

public:
  Weight_bounds(const Pair& pair, const Edge_courses<Traits>& courses)
    : m_pair(pair), m_mesh(pair.mesh()), m_decisions(pair, courses)
  {
    m_decisions.allow_roots();
  }

  // Returns the bounds by geodesics from neighbors of `v`. One of them is the greatest bound by any
  // geodesic in the faces at `v`.
  std::vector<Weight_bound> operator()(Vertex_index v)
  {
    std::vector<Weight_bound> result;
    const Weight_bound narrow = bound_of_cone(v);
    for_each_outgoing_halfedge(v, m_mesh, [&](Halfedge_index h) {
      const Weight_bound bound =
        narrow.halfedge.is_valid() ? Weight_bound{h, 0, narrow.is_certain} : bound_of_geodesic(h);
      if(bound.halfedge.is_valid())
        result.push_back(bound);
    });
    return result;
  }

  // Returns whether the geodesic of a bound ends in the last face of its fan, at the greatest cost.
  bool is_certain(const Weight_bound& bound)
  {
    m_decisions.allow_roots(Exact_decisions<Traits>::many_roots);
    const Uncertain<Sign> rest = sign_of_rest(bound.fan(m_mesh));
    m_decisions.allow_roots();
    return bound.faces > 0 ? certainly(rest != POSITIVE) : certainly(rest != NEGATIVE);
  }

  // Returns whether all faces of the fan of a bound certainly have positive area.
  bool has_area(const Weight_bound& bound)
  {
    const std::vector<Halfedge_index> outgoing = bound.fan(m_mesh);
    try {
      return std::all_of(outgoing.begin(), outgoing.end() - 1, [this](Halfedge_index h) {
        return m_decisions.orientation(h) == POSITIVE;
      });
    } catch(const Numerical_error&) {
      return false;
    }
  }

private:
  // Returns a bound if all angles at `v` add up to at most pi, and nothing stops geodesics.
  // Otherwise, returns a bound without a halfedge.
  Weight_bound bound_of_cone(Vertex_index v)
  {
    std::vector<Halfedge_index> fan{first_outgoing_halfedge(v, m_mesh)};
    do {
      if(is_closed(fan.back()))
        return {};
      fan.push_back(next_around_source(fan.back(), m_mesh));
    } while(fan.back() != fan.front());
    const Uncertain<Sign> rest = sign_of_rest(fan);
    return certainly(rest == NEGATIVE) ? Weight_bound{}
                                       : Weight_bound{fan.front(), 0, CGAL::is_certain(rest)};
  }

  // Returns the bound by a geodesic from the end of `h` through its source. It has no halfedge if
  // the geodesic is stopped.
  Weight_bound bound_of_geodesic(Halfedge_index h)
  {
    std::vector<Halfedge_index> fan{h};
    do {
      if(m_mesh.is_border(fan.back()) || (fan.size() > 1 && is_closed(fan.back())))
        return {};
      fan.push_back(next_around_source(fan.back(), m_mesh));
      if(const Uncertain<Sign> rest = sign_of_rest(fan); !certainly(rest == POSITIVE))
        return fan.size() > 2 ? Weight_bound{h, fan.size() - 1, CGAL::is_certain(rest)}
                              : Weight_bound{};
    } while(fan.back() != h);
    return {};
  }

  // Returns the sign of pi minus the angles of a fan.
  Uncertain<Sign> sign_of_rest(const std::vector<Halfedge_index>& fan)
  {
    try {
      return m_decisions.fan_sign(fan);
    } catch(const Numerical_error&) {
      return Uncertain<Sign>::indeterminate();
    }
  }

  // Returns whether geodesics cannot cross the edge of `h`.
  bool is_closed(Halfedge_index h) const
  {
    const Edge_index e = m_mesh.edge(h);
    return m_mesh.is_border(e) || m_pair.is_constrained(e);
  }

  const Pair& m_pair;
  const Delta_complex& m_mesh;
  Exact_decisions<Traits> m_decisions;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_WEIGHTS_WEIGHT_BOUNDS_H
