// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_LENGTHS_IN_STRIPS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_LENGTHS_IN_STRIPS_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Triangulation_pair.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/Exact_decisions.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Edge_courses.h>

#include <string>

namespace CGAL::Intrinsic_triangulations::internal {

// Returns the length of the edge of `h`, computed in the strip of triangles of T1 that the edge
// crosses, from the lengths of T1.
// \throws Numerical_error if it is not positive and finite
template <typename Traits>
typename Traits::FT length_in_strip(const Triangulation_pair<Traits>& pair, Halfedge_index h,
                                    const Edge_courses<Traits>& courses,
                                    typename Traits::Geodesic_strip& strip)
{
  typename Traits::FT length(0);
  if(pair.coordinates().is_shared(pair.mesh().edge(h)))
    length = pair.shared_length(h);
  else if(courses.count(h) > 0)
    length = pair.lay_out(strip, h, courses(h));
  else if constexpr(Has_distance<Traits>::value)
    length = pair.distance(pair.input_location(h), pair.input_location(pair.mesh().opposite(h)));
  if(!pair.traits().is_length_object()(length))
    throw Numerical_error("the strip of edge " + std::to_string(pair.mesh().edge(h).idx()) +
                          " has no positive finite length");
  return length;
}

// Calls `use(length)` with a function that returns the lengths of edges. They are exact up to
// rounding for exact traits.
template <typename Traits, typename Use>
void with_lengths_in_strips(const Triangulation_pair<Traits>& pair, const Use& use)
{
  const Edge_courses<Traits> courses(pair, Concurrency());
  if constexpr(Is_exact<Traits>::value) {
    const Exact_decisions<Traits> decisions(pair, courses);
    use([&](Halfedge_index h) { return decisions.length(h); });
  } else {
    typename Traits::Geodesic_strip strip;
    use([&](Halfedge_index h) { return length_in_strip(pair, h, courses, strip); });
  }
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_LENGTHS_IN_STRIPS_H
