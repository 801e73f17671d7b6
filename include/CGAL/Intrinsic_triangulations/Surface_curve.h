// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_SURFACE_CURVE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_SURFACE_CURVE_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Edge_point.h>
#include <CGAL/Intrinsic_triangulations/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/Surface_view.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/triangle_formulas.h>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsPaths
/// a straight segment in a face, from one point to another.
template <typename FT>
struct Curve_segment
{
  Face_index face;          ///< the face
  std::array<FT, 3> source; ///< the barycentric coordinates of its start, as in `Face_location`
  std::array<FT, 3> target; ///< the barycentric coordinates of its end
};

/// \ingroup PkgIntrinsicTriangulationsPaths
/// a set of segments: one curve or several, closed or not, with or without gaps and crossings. The
/// order of the segments does not matter. Their directions matter to functions that distinguish
/// sides.
template <typename FT>
using Surface_curve = std::vector<Curve_segment<FT>>;

namespace internal {

// \throws Invalid_input if an end of `segment` is no point of a face of `mesh`
template <typename FT>
void check_ends(const Curve_segment<FT>& segment, const Delta_complex& mesh)
{
  check_point(Face_location<FT>(segment.face, segment.source), mesh);
  check_point(Face_location<FT>(segment.face, segment.target), mesh);
}

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsPaths
/// returns a curve with its coordinates converted to numbers of type `To`.
template <typename To, typename FT>
Surface_curve<To> converted_curve(const Surface_curve<FT>& curve)
{
  const auto place = [](const std::array<FT, 3>& p) {
    return std::array<To, 3>{To(p[0]), To(p[1]), To(p[2])};
  };
  Surface_curve<To> result;
  for(const Curve_segment<FT>& s : curve)
    result.push_back({s.face, place(s.source), place(s.target)});
  return result;
}

namespace internal {

template <typename FT>
FT segment_length(const std::array<FT, 3>& side, const Curve_segment<FT>& segment)
{
  const auto &p = segment.source, &q = segment.target;
  return vector_length<FT>(side, {FT(q[0] - p[0]), FT(q[1] - p[1]), FT(q[2] - p[2])});
}

template <typename Surface, typename FT>
FT segment_length(const Surface& surface, const Curve_segment<FT>& segment)
{
  const auto h = sides(segment.face, surface.mesh());
  return segment_length<FT>(
    {edge_length(h[0], surface), edge_length(h[1], surface), edge_length(h[2], surface)}, segment);
}

// Returns the shortest segment from `p` to `q` in a face of both, or a segment without face if no
// such face exists.
template <typename Surface, typename FT>
Curve_segment<FT> segment_between(const Surface& surface, const Surface_point<FT>& p,
                                  const Surface_point<FT>& q)
{
  Curve_segment<FT> best{Delta_complex::null_face(), {}, {}};
  FT least(0);
  for_each_location(p, surface.mesh(), [&](const Face_location<FT>& from) {
    for_each_location(q, surface.mesh(), [&](const Face_location<FT>& to) {
      if(from.first != to.first)
        return;
      const Curve_segment<FT> segment{from.first, from.second, to.second};
      const FT length = segment_length(surface, segment);
      if(best.face == Delta_complex::null_face() || length < least) {
        best = segment;
        least = length;
      }
    });
  });
  return best;
}

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsPaths
/// returns the length of a curve. Complexity: linear.
/// \param surface a model of `IntrinsicSurface` with floating point lengths
/// \param curve segments on it
template <typename Surface>
Length_of<Surface> curve_length(const Surface& surface,
                                const Surface_curve<Length_of<Surface>>& curve)
{
  Length_of<Surface> sum(0);
  for(const auto& segment : curve)
    sum += internal::segment_length(surface, segment);
  return sum;
}

/// \ingroup PkgIntrinsicTriangulationsPaths
/// makes a curve through points. Consecutive points must share a face. Between them the curve is
/// straight. If several faces are possible, it takes the shortest segment. Complexity: linear, and
/// quadratic in the degree of a vertex that is one of the points.
/// \param surface a model of `IntrinsicSurface` with floating point lengths
/// \param points a range of `Face_location` or `Surface_point`, such as the positions of a
///   `Surface_path`; to close the curve, the last is the first
/// \throws Invalid_input if a point shares no face with the next one
template <typename Surface, typename PointRange>
Surface_curve<Length_of<Surface>> curve_through(const Surface& surface, const PointRange& points)
{
  typedef Length_of<Surface> FT;
  Surface_curve<FT> result;
  Surface_point<FT> previous;
  std::size_t i = 0;
  for(const auto& p : points) {
    const Surface_point<FT> next = surface_point(p, surface.mesh());
    if(i++ > 0)
      result.push_back(internal::segment_between(surface, previous, next));
    if(i > 1 && result.back().face == Delta_complex::null_face())
      throw Invalid_input("points " + std::to_string(i - 2) + " and " + std::to_string(i - 1) +
                          " of the curve share no face");
    previous = next;
  }
  return result;
}

/// \ingroup PkgIntrinsicTriangulationsPaths
/// makes a curve of edges. Complexity: linear.
/// \param surface a model of `IntrinsicSurface`
/// \param halfedges a range of halfedges, which give the directions
template <typename Surface, typename HalfedgeRange>
Surface_curve<Length_of<Surface>> curve_along_edges(const Surface& surface,
                                                    const HalfedgeRange& halfedges)
{
  typedef Length_of<Surface> FT;
  const Delta_complex& mesh = surface.mesh();
  Surface_curve<FT> result;
  for(const Halfedge_index h : halfedges) {
    const bool is_border = mesh.is_border(h);
    const Halfedge_index inner = is_border ? mesh.opposite(h) : h;
    const auto at = [&](int t) {
      return face_location(Edge_point<FT>{inner, FT(is_border ? 1 - t : t)}, mesh).second;
    };
    result.push_back({mesh.face(inner), at(0), at(1)});
  }
  return result;
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_SURFACE_CURVE_H
