// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_LEVEL_SET_H
#define CGAL_INTRINSIC_TRIANGULATIONS_LEVEL_SET_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Edge_point.h>
#include <CGAL/Intrinsic_triangulations/Surface_curve.h>
#include <CGAL/Intrinsic_triangulations/Surface_path.h>
#include <CGAL/Intrinsic_triangulations/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/Surface_view.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/internal/validity/check_finite.h>

#include <CGAL/number_utils.h>

#include <cstddef>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// Follows the curves of a level set from face to face. Each vertex is above the level or not, so
// that a curve enters and leaves a face through one edge each.
template <typename Surface, typename Values>
class Level_set_follower
{
  typedef Length_of<Surface> FT;
  typedef Surface_path<FT> Curve;
  typedef std::decay_t<decltype(std::declval<const Values&>().size())> Index;

public:
  Level_set_follower(const Surface& surface, const Values& values, const FT& level)
    : m_surface(surface),
      m_mesh(surface.mesh()),
      m_values(values),
      m_level(level),
      m_is_done(m_mesh.number_of_faces(), 0)
  {}

  // Returns the curves. Curves from boundary to boundary come before closed curves.
  std::vector<Curve> operator()()
  {
    std::vector<Curve> result;
    for(Halfedge_index h : m_mesh.halfedges())
      if(m_mesh.is_border(m_mesh.opposite(h)) && enters(h))
        result.push_back(curve_from(h));
    for(Halfedge_index h : m_mesh.halfedges())
      if(!m_mesh.is_border(h) && enters(h) && !is_done(h))
        result.push_back(curve_from(h));
    return result;
  }

private:
  char& is_done(Halfedge_index h) { return m_is_done[m_mesh.face(h).idx()]; }

  FT value(Vertex_index v) const { return FT(m_values[static_cast<Index>(v.idx())]); }
  bool is_above(Vertex_index v) const { return value(v) >= m_level; }

  // Returns whether a curve enters the face of `h` through `h`, with vertices above on its left.
  bool enters(Halfedge_index h) const
  {
    return is_above(m_mesh.source(h)) && !is_above(m_mesh.target(h));
  }

  // Returns the point of the level on a halfedge, whichever end is above.
  Edge_point<FT> point(Halfedge_index h) const
  {
    const FT p = value(m_mesh.source(h)), q = value(m_mesh.target(h));
    return {h, FT((p - m_level) / (p - q))};
  }

  Curve curve_from(Halfedge_index h)
  {
    Curve result{FT(0), {edge_location(point(h))}};
    while(!m_mesh.is_border(h) && !is_done(h)) {
      is_done(h) = 1;
      const Halfedge_index next = m_mesh.next(h),
                           out = is_above(m_mesh.target(next)) ? next : m_mesh.prev(h);
      result.length += segment_length(
        m_surface, Curve_segment<FT>{m_mesh.face(h), face_location(point(h), m_mesh).second,
                                     face_location(point(out), m_mesh).second});
      h = m_mesh.opposite(out);
      result.places.push_back(edge_location(point(h)));
    }
    return result;
  }

  const Surface& m_surface;
  const Delta_complex& m_mesh;
  const Values& m_values;
  FT m_level;
  std::vector<char> m_is_done; // of each face
};

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsPaths
/// computes the curves on which a function that is linear on faces has a given value.
///
/// Vertices whose value is the level count as above it. The curves cross edges, are straight on
/// faces, and separate the vertices above from the vertices below. Comparisons alone decide which
/// edges they cross. They are simple and disjoint, except at edges without length.
///
/// \param surface a model of `IntrinsicSurface` with floating point lengths, \f$T_1\f$ or
///        \f$T_2\f$; `curve_across()` finds each curve on the other triangulation
/// \param values the finite values at the vertices, by their indices: a vector of Eigen or of the
///        standard library, such as distances. Distances are infinite on components without a
///        source; replace them by a number below all levels
/// \param level the value, which is finite
/// \returns the curves, each with its length and the points on edges that it runs through, and with
///          greater values on its left. Curves from boundary to boundary come first; a closed
///          curve ends where it starts.
///
/// Complexity: linear.
/// \throws Invalid_input if a value or the level is infinite or NaN, or if the number of values is
///         not the number of vertices
template <typename Surface, typename Values>
std::vector<Surface_path<Length_of<Surface>>>
level_set(const Surface& surface, const Values& values, const Length_of<Surface>& level)
{
  internal::check_all_finite(values, "the value");
  if(std::size_t(values.size()) != surface.mesh().num_vertices())
    throw Invalid_input("there are " + std::to_string(values.size()) + " values for " +
                        std::to_string(surface.mesh().num_vertices()) + " vertices");
  if(!CGAL::is_finite(level))
    throw Invalid_input("the level is infinite or NaN");
  return internal::Level_set_follower<Surface, Values>(surface, values, level)();
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_LEVEL_SET_H
