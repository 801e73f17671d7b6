// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GEODESICS_FAN_FLIPPING_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GEODESICS_FAN_FLIPPING_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/Direct_mapped_cache.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/Input_metric.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/flipped_length.h>
#include <CGAL/Intrinsic_triangulations/internal/flipping/Exact_flipping.h>
#include <CGAL/Intrinsic_triangulations/internal/flipping/Flip_record.h>
#include <CGAL/Intrinsic_triangulations/internal/geodesics/Fan.h>
#include <CGAL/Intrinsic_triangulations/tolerances.h>

#include <CGAL/Uncertain.h>
#include <CGAL/enum.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <type_traits>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Decides about fans and flips by the stored lengths. An angle counts as at least pi if rounding
// errors prevent a decision.
template <typename Traits>
class Fan_flipping_by_lengths
{
  typedef Intrinsic_triangulation<Traits> Triangulation;
  typedef typename Traits::FT FT;

public:
  typedef Flip_record<Traits> Record;
  struct Diagonal
  {};

  explicit Fan_flipping_by_lengths(Triangulation& tri) : m_tri(tri) {}

  static FT length_error() { return rounding_unit<FT>(); }
  bool is_less_than_pi(Fan_ends ends) const
  {
    const Fan outgoing = fan(ends, m_tri.mesh());
    return !outgoing.empty() && certainly(internal::is_less_than_pi(
                                  fan_angle(outgoing, m_tri.intrinsic(), length_error())));
  }

  Diagonal other_diagonal(Halfedge_index) const { return {}; }

  // Returns whether the edge of `h`, inside of a fan with an angle of less than pi, can be flipped.
  bool is_flippable(Halfedge_index h, Diagonal) const { return m_tri.is_flippable(h); }
  void flip(Halfedge_index h, Diagonal) { m_tri.flip(h); }
  Record record(Halfedge_index h) const { return Record(h, m_tri); }
  void undo(const Record& record) { record.undo(m_tri); }

private:
  Triangulation& m_tri;
};

// Decides about fans on the surface of T1. Flips keep the errors of lengths within
// `certified_length_error()`. Lengths decide if their errors permit it. For lengths of type
// `double`, an angle that is pi to some 24 digits counts as pi.
template <typename Traits>
class Exact_fan_flipping
{
  typedef Intrinsic_triangulation<Traits> Triangulation;

public:
  typedef Flipped_diagonal Diagonal;

  struct Record
  {
    typename Exact_flipping<Traits>::Record flip;
    std::uint32_t name;
  };

  explicit Exact_fan_flipping(Triangulation& tri)
    : m_tri(tri), m_flipping(tri), m_name(tri.mesh().num_edges())
  {
    std::iota(m_name.begin(), m_name.end(), std::uint32_t(0));
    m_next_name = static_cast<std::uint32_t>(m_name.size());
    const Delta_complex& mesh = tri.mesh();
    if(!Is_exact<Traits>::value &&
       !std::all_of(mesh.edges().begin(), mesh.edges().end(),
                    [&](Edge_index e) { return tri.coordinates().is_shared(e); }))
      m_flipping.recompute_lengths();
  }

  static double length_error() { return certified_length_error(); }

  bool is_less_than_pi(Fan_ends ends)
  {
    return decide(ends, [](auto& decisions, const Fan& fan) { return decisions.fan_sign(fan); });
  }

  Diagonal other_diagonal(Halfedge_index h) const { return m_flipping.other_diagonal(h); }

  // Returns whether the edge of `h`, inside of a fan with an angle of less than pi, can be flipped.
  bool is_flippable(Halfedge_index h, const Diagonal& diagonal)
  {
    if(!m_flipping.can_be_turned(h))
      return false;
    const Uncertain<bool> is_convex = diagonal.is_convex_at_target();
    return is_certain(is_convex) ? get_certain(is_convex)
                                 : is_convex_at_source(m_tri.mesh().opposite(h));
  }

  void flip(Halfedge_index h, const Diagonal& diagonal)
  {
    m_flipping.flip(h, diagonal());
    m_name[Edge_index(h)] = m_next_name;
    m_next_name = (std::min)(m_next_name + 1, nameless);
  }

  Record record(Halfedge_index h) const { return {m_flipping.record(h), m_name[Edge_index(h)]}; }

  void undo(const Record& record)
  {
    m_flipping.undo(record.flip);
    m_name[Edge_index(record.flip.flip.halfedge())] = record.name;
  }

private:
  bool is_convex_at_source(Halfedge_index h)
  {
    const Delta_complex& mesh = m_tri.mesh();
    return decide({previous_around_source(h, mesh), next_around_source(h, mesh)},
                  [h](auto& decisions, const Fan&) { return decisions.convexity_at_source(h); });
  }

  template <typename Exact_sign>
  bool decide(Fan_ends ends, const Exact_sign& exact_sign)
  {
    const Uncertain<bool> by_sines =
      corner_sum(ends, m_tri.intrinsic(), length_error()).is_less_than_pi();
    if(is_certain(by_sines))
      return get_certain(by_sines);
    return remembered(ends, [&] {
      const Fan outgoing = fan(ends, m_tri.mesh());
      if(outgoing.empty())
        return false;
      const auto angle = fan_angle(outgoing, m_tri.intrinsic(), length_error());
      const Uncertain<bool> by_lengths = internal::is_less_than_pi(angle);
      if(is_certain(by_lengths))
        return get_certain(by_lengths);
      auto& decisions = m_flipping.decisions();
      if constexpr(Is_exact<Traits>::value)
        return exact_sign(decisions, outgoing) == POSITIVE;
      else
        return angle.error < fan_tolerance() / 4 ? decisions.is_nearly_pi_but_less(outgoing)
                                                 : decisions.is_less_than_pi(outgoing);
    });
  }

  // Returns the result of `decide()`. The edges on both sides of a fan determine its angle. So
  // ties, as on flat parts of a surface, are decided once.
  template <typename Decide>
  bool remembered(Fan_ends ends, const Decide& decide)
  {
    const auto name = [this](Halfedge_index h) {
      return std::uint64_t(m_name[Edge_index(h)]) << 1 | (is_first_halfedge(h) ? 0 : 1);
    };
    const std::uint64_t first = name(ends.first), last = name(ends.last);
    if((std::max)(first, last) >= 2 * std::uint64_t(nameless) ||
       sizeof(std::size_t) < sizeof(std::uint64_t))
      return decide();
    return m_decided(static_cast<std::size_t>(first << 32 | last), decide);
  }

  // This name stands for any edge without a name.
  static constexpr std::uint32_t nameless = std::uint32_t(1) << 31;

  Triangulation& m_tri;
  Exact_flipping<Traits> m_flipping;
  // Stores a name for each edge. It belongs to one geodesic: after a flip, the edge has another
  // name.
  std::vector<std::uint32_t> m_name;
  std::uint32_t m_next_name;
  Direct_mapped_cache<bool> m_decided;
};

template <typename Traits>
using Fan_flipping = std::conditional_t<has_exact_decisions<Traits>(), Exact_fan_flipping<Traits>,
                                        Fan_flipping_by_lengths<Traits>>;

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GEODESICS_FAN_FLIPPING_H
