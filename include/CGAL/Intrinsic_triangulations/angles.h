// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_ANGLES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_ANGLES_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/corner_formulas.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsRef
/// computes the angles of the faces of a triangulation from its edge lengths. Complexity: linear.
///
/// \param g a triangulation, a model of `FaceListGraph`
/// \param length a readable property map from the edges of `g` to floating point numbers
/// \param angle a writable property map from the halfedges of `g`: the angle at the target of each,
///        in its face; border halfedges get none
template <typename Graph, typename LengthMap, typename AngleMap>
void compute_angles(const Graph& g, LengthMap length, AngleMap angle)
{
  const auto side = [&](auto h) { return get(length, edge(h, g)); };
  for(auto f : faces(g))
    for(auto h : CGAL::halfedges_around_face(halfedge(f, g), g))
      put(angle, h, corner_angle(side(prev(h, g)), side(h), side(next(h, g))));
}

/// \ingroup PkgIntrinsicTriangulationsRef
/// returns the smallest angle of the faces of a triangulation, in degrees; infinity if there are no
/// faces. Angles in a face with a side that is not positive and finite do not count. Complexity:
/// linear.
///
/// \param g a triangulation, a model of `FaceListGraph`
/// \param length a readable property map from the edges of `g` to numbers convertible to `double`
template <typename Graph, typename LengthMap>
double smallest_angle_in_degrees(const Graph& g, LengthMap length)
{
  double result = std::numeric_limits<double>::infinity();
  for(auto f : faces(g)) {
    const auto h = halfedge(f, g);
    const auto side = [&](auto x) { return static_cast<double>(get(length, edge(x, g))); };
    const std::array<double, 3> sides{side(h), side(next(h, g)), side(prev(h, g))};
    if(std::all_of(sides.begin(), sides.end(), [](double l) { return std::isfinite(l) && l > 0; }))
      result = (std::min)(result, internal::smallest_angle(sides));
  }
  return result;
}

/// \ingroup PkgIntrinsicTriangulationsRef
/// computes the curvature of the vertices of a triangulation. At an interior vertex it is
/// \f$2\pi\f$ minus its angle sum. On the boundary it is \f$\pi\f$ minus the angle sum. At a vertex
/// without faces it is zero. By the theorem of Gauss and Bonnet, the sum is \f$2\pi\f$ times the
/// Euler characteristic, without isolated vertices. Complexity: linear.
///
/// \param g a triangulation, a model of `FaceListGraph` and `VertexListGraph`
/// \param length a readable property map from the edges of `g` to floating point numbers
/// \param curvature a read/write property map from the vertices of `g` to these numbers
template <typename Graph, typename LengthMap, typename CurvatureMap>
void compute_curvatures(const Graph& g, LengthMap length, CurvatureMap curvature)
{
  typedef typename boost::property_traits<CurvatureMap>::value_type FT;
  const auto side = [&](auto h) { return get(length, edge(h, g)); };
  for(auto v : vertices(g))
    put(curvature, v, FT(0));
  for(auto h : halfedges(g))
    put(curvature, target(h, g), 2 * pi<FT>());
  for(auto h : halfedges(g))
    if(is_border(h, g))
      put(curvature, target(h, g), pi<FT>());
  for(auto f : faces(g))
    for(auto h : CGAL::halfedges_around_face(halfedge(f, g), g)) {
      const auto v = target(h, g);
      put(curvature, v,
          get(curvature, v) - corner_angle(side(prev(h, g)), side(h), side(next(h, g))));
    }
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_ANGLES_H
