// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_LENGTHS_IN_STRIPS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_LENGTHS_IN_STRIPS_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Triangulation_pair.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/Exact_decisions.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Input_crossings.h>

#include <cstddef>
#include <string>

namespace CGAL::Intrinsic_triangulations::internal {

// The length of each edge of T2 in the strip of triangles of T1 that it passes, computed afresh.
template <typename Traits>
class Lengths_in_strips
{
  typedef Triangulation_pair<Traits> Pair;
  typedef typename Traits::FT FT;

public:
  explicit Lengths_in_strips(const Pair& pair)
    : m_pair(pair), m_crossings(pair.coordinates(), pair.mesh(), pair.spokes())
  {}

  // \throws Numerical_error if it is not positive and finite
  FT operator()(Halfedge_index h)
  {
    const FT length = m_pair.coordinates().is_shared(m_pair.mesh().edge(h))
                        ? m_pair.shared_length(h)
                      : m_crossings.count(h) == 0 ? length_in_face(h)
                                                  : length_in_strip(h);
    if(!m_pair.traits().is_length_object()(length))
      throw Numerical_error("the strip of edge " + std::to_string(m_pair.mesh().edge(h).idx()) +
                            " has no positive finite length");
    return length;
  }

private:
  // 0, which is no length, if no vertices can be inserted
  FT length_in_face([[maybe_unused]] Halfedge_index h) const
  {
    if constexpr(Has_distance<Traits>::value)
      return m_pair.distance(m_pair.input_location(h),
                             m_pair.input_location(m_pair.mesh().opposite(h)));
    else
      return FT(0);
  }

  FT length_in_strip(Halfedge_index h)
  {
    const auto exit = [&](std::size_t m) { return opposite(m_crossings(h, m)); };
    return m_pair.lay_out(m_strip, h, exit, m_crossings.count(h));
  }

  const Pair& m_pair;
  Input_crossings m_crossings;
  typename Traits::Geodesic_strip m_strip;
};

// calls `use(length)` with a function that returns them, exact up to rounding for exact traits
template <typename Traits, typename Use>
void with_lengths_in_strips(const Triangulation_pair<Traits>& pair, const Use& use)
{
  if constexpr(Is_exact<Traits>::value) {
    const Exact_decisions<Traits, Input_crossings> decisions(
      pair, Input_crossings(pair.coordinates(), pair.mesh(), pair.spokes()));
    use([&](Halfedge_index h) { return decisions.length(h); });
  } else
    use(Lengths_in_strips<Traits>(pair));
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_LENGTHS_IN_STRIPS_H
