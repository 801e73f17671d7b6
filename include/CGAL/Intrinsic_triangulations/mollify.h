// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_MOLLIFY_H
#define CGAL_INTRINSIC_TRIANGULATIONS_MOLLIFY_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/boost/graph/helpers.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsRef
/// adds one small number to all edge lengths (Section 3.7). Then every triangle inequality has a
/// slack of at least `epsilon` times the mean length. Lengths do not change if this already holds.
/// Edges of zero length become positive. Complexity: linear.
///
/// \param g a model of `FaceListGraph` and `HalfedgeListGraph` with triangular faces
/// \param length a readable and writable property map from the edges of `g` to a floating point
///   type
/// \param epsilon the slack, relative to the mean edge length
/// \returns the length that was added to every edge
template <typename Graph, typename LengthMap>
typename boost::property_traits<LengthMap>::value_type
mollify(const Graph& g, LengthMap length,
        const typename boost::property_traits<LengthMap>::value_type& epsilon)
{
  typedef typename boost::property_traits<LengthMap>::value_type FT;
  FT sum(0);
  std::size_t count = 0;
  for(auto e : edges(g)) {
    sum += get(length, e);
    ++count;
  }
  FT added(0);
  const auto length_of = [&](auto h) { return get(length, edge(h, g)); };
  for(auto h : halfedges(g))
    if(!is_border(h, g)) {
      const FT slack = length_of(next(h, g)) + length_of(prev(h, g)) - length_of(h);
      added = (std::max)(added, FT(epsilon * sum / FT(count) - slack));
    }
  if(added > 0)
    for(auto e : edges(g))
      put(length, e, get(length, e) + added);
  return added;
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_MOLLIFY_H
