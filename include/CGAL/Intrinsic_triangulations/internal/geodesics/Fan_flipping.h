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

// Flips edges out of the fans beside paths, and records the flips, so that it can undo them.
template <typename Traits>
class Fan_flattener
{
  typedef Fan_flipping<Traits> Flipping;

public:
  explicit Fan_flattener(Intrinsic_triangulation<Traits>& tri) : m_mesh(tri.mesh()), m_flipping(tri)
  {}

  bool is_less_than_pi(Fan_ends ends) { return m_flipping.is_less_than_pi(ends); }

  // Returns the number of flips since the last `rewind()`.
  std::size_t number_of_flips() const { return m_flips.size(); }

  // Flips the edges inside the fan as long as one can be flipped. The face of a loop of one edge is
  // at both ends of the fan, and its apex at both ends of the arc. This face is kept unless the
  // whole angle at its apex is less than pi. Flips of its other sides could wind them around the
  // loop endlessly. Returns whether the angles between sides opposite to the apex are known to be
  // at least pi.
  bool flip_out(Fan& outgoing, bool is_one_edge)
  {
    const std::size_t limit = m_flips.size() + 16 * outgoing.size();
    flip_between(outgoing, is_one_edge ? 2 : 1, limit);
    while(is_one_edge && outgoing.size() > 4 && m_flips.size() < limit &&
          is_less_than_pi(
            {m_mesh.next(outgoing[1]), opposite(m_mesh.next(outgoing[outgoing.size() - 3]))})) {
      flip(outgoing[1], m_flipping.other_diagonal(outgoing[1]));
      find_fan({outgoing.front(), outgoing.back()}, m_mesh, outgoing);
      flip_between(outgoing, 2, limit);
    }
    return !is_one_edge && m_flips.size() < limit &&
           std::all_of(outgoing.begin() + 1, outgoing.end() - 1, [&](Halfedge_index h) {
             return flip_status(h, m_mesh) == Operation_status::possible;
           });
  }

  // Undoes all flips.
  void rewind()
  {
    for(; !m_flips.empty(); m_flips.pop_back())
      m_flipping.undo(m_flips.back());
  }

private:
  // Flips edges, and keeps `margin` outgoing halfedges at both ends. Each flip removes one outgoing
  // halfedge. A flip adds one only if a face has two corners at the apex. Then the fan is collected
  // again.
  void flip_between(Fan& outgoing, std::size_t margin, std::size_t limit)
  {
    const Vertex_index apex = m_mesh.source(outgoing.front());
    const Fan_ends ends{outgoing.front(), outgoing.back()};
    for(std::size_t i = margin; i + margin < outgoing.size() && m_flips.size() < limit;) {
      const Halfedge_index h = outgoing[i];
      const auto diagonal = m_flipping.other_diagonal(h);
      if(!m_flipping.is_flippable(h, diagonal)) {
        ++i;
        continue;
      }
      const bool is_loop = m_mesh.target(h) == apex;
      flip(h, diagonal);
      if(is_loop || m_mesh.source(h) == apex || m_mesh.target(h) == apex) {
        find_fan(ends, m_mesh, outgoing);
        i = margin;
      } else {
        outgoing.erase(outgoing.begin() + static_cast<std::ptrdiff_t>(i));
        i = (std::max)(i - 1, margin);
      }
    }
  }

  void flip(Halfedge_index h, const typename Flipping::Diagonal& diagonal)
  {
    const auto record = m_flipping.record(h);
    m_flipping.flip(h, diagonal);
    m_flips.push_back(record);
  }

  const Delta_complex& m_mesh;
  Flipping m_flipping; // decisions are remembered
  std::vector<typename Flipping::Record> m_flips;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GEODESICS_FAN_FLIPPING_H
