// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GEODESICS_FAN_FLIPPING_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GEODESICS_FAN_FLIPPING_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/Input_metric.h>
#include <CGAL/Intrinsic_triangulations/internal/flipping/Exact_flipping.h>
#include <CGAL/Intrinsic_triangulations/internal/geodesics/Fan.h>
#include <CGAL/Intrinsic_triangulations/tolerances.h>

#include <CGAL/enum.h>

#include <algorithm>
#include <type_traits>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Decisions about fans, and flips, by the stored lengths. What rounding leaves in doubt is not less
// than pi.
template <typename Traits>
class Fan_flipping_by_lengths
{
  typedef Intrinsic_triangulation<Traits> Triangulation;
  typedef typename Traits::FT FT;
  typedef std::vector<Halfedge_index> Fan;

public:
  explicit Fan_flipping_by_lengths(Triangulation& tri) : m_tri(tri) {}

  static FT length_error() { return rounding_unit<FT>(); }
  bool is_less_than_pi(const Fan& outgoing) const
  {
    return certainly(
      internal::is_less_than_pi(fan_angle(outgoing, m_tri.intrinsic(), length_error())));
  }
  bool is_flippable(Halfedge_index h) const { return m_tri.is_flippable(h); }
  void flip(Halfedge_index h) { m_tri.flip(h); }

private:
  Triangulation& m_tri;
};

// Decisions about fans on the surface of T1, and flips that keep the lengths within
// `certified_length_error()`. Where the lengths leave no doubt, they decide; for lengths of type
// `double`, an angle that is pi to some 24 digits is pi.
template <typename Traits>
class Exact_fan_flipping
{
  typedef Intrinsic_triangulation<Traits> Triangulation;
  typedef std::vector<Halfedge_index> Fan;

public:
  explicit Exact_fan_flipping(Triangulation& tri) : m_tri(tri), m_flipping(tri)
  {
    const Delta_complex& mesh = tri.mesh();
    if(!Is_exact<Traits>::value &&
       !std::all_of(mesh.edges().begin(), mesh.edges().end(),
                    [&](Edge_index e) { return tri.coordinates().is_shared(e); }))
      m_flipping.recompute_lengths();
  }

  static double length_error() { return certified_length_error(); }

  bool is_less_than_pi(const Fan& outgoing)
  {
    return decide(outgoing, [&](auto& decisions) { return decisions.fan_sign(outgoing); });
  }

  bool is_flippable(Halfedge_index h)
  {
    return m_flipping.can_be_turned(h) && is_convex_at_source(h) &&
           is_convex_at_source(m_tri.mesh().opposite(h));
  }

  void flip(Halfedge_index h) { m_flipping.flip(h); }

private:
  bool is_convex_at_source(Halfedge_index h)
  {
    const Delta_complex& mesh = m_tri.mesh();
    return decide({previous_around_source(h, mesh), h, next_around_source(h, mesh)},
                  [&](auto& decisions) { return decisions.convexity_at_source(h); });
  }

  template <typename Exact_sign>
  bool decide(const Fan& outgoing, const Exact_sign& exact_sign)
  {
    const Uncertain<bool> by_lengths =
      internal::is_less_than_pi(fan_angle(outgoing, m_tri.intrinsic(), length_error()));
    if(is_certain(by_lengths))
      return get_certain(by_lengths);
    if constexpr(Is_exact<Traits>::value)
      return exact_sign(m_flipping.decisions()) == POSITIVE;
    else
      return m_flipping.decisions().is_less_than_pi(outgoing);
  }

  Triangulation& m_tri;
  Exact_flipping<Traits> m_flipping;
};

template <typename Traits>
using Fan_flipping = std::conditional_t<has_exact_decisions<Traits>(), Exact_fan_flipping<Traits>,
                                        Fan_flipping_by_lengths<Traits>>;

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GEODESICS_FAN_FLIPPING_H
