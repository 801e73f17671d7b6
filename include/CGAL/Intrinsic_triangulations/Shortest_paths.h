// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_SHORTEST_PATHS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_SHORTEST_PATHS_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Default_window_visitor.h>
#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Edge_point.h>
#include <CGAL/Intrinsic_triangulations/Surface_curve.h>
#include <CGAL/Intrinsic_triangulations/Surface_path.h>
#include <CGAL/Intrinsic_triangulations/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/Surface_view.h>
#include <CGAL/Intrinsic_triangulations/internal/geodesics/Path_search.h>
#include <CGAL/Intrinsic_triangulations/named_parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <limits>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsPaths
/// computes exact shortest paths and distances from some points of a surface to all its points.
///
/// Faces are unfolded along windows, from edge lengths alone: parts of edges that are seen from a
/// source along straight lines \cgalCite{CH90} \cgalCite{XW09}. Windows of one edge are propagated
/// together \cgalCite{QHYYZ16}. New windows open behind vertices at which paths can bend: with an
/// angle sum of more than \f$2\pi\f$, or on the boundary more than \f$\pi\f$. Distances are
/// accurate to rounding for every face passed.
///
/// Add the sources, then call `run()`; distances and paths to any point follow without further
/// search. Sources can be added later, and `run()` called again, which continues the search.
///
/// Flat faces, faces without area, and ties between paths are no errors. Of several shortest paths,
/// equal up to rounding, any is returned.
///
/// \tparam Surface a model of `IntrinsicSurface` with floating point lengths; loops, parallel edges
///         and faces that meet themselves are allowed. It must not change as long as the object is
///         used.
template <typename Surface>
class Shortest_paths
{
public:
  /// the number type of lengths.
  typedef Length_of<Surface> FT;

  /// prepares the search. Complexity: linear.
  explicit Shortest_paths(const Surface& surface) : m_search(internal::view_of(surface)) {}

  /// \name Sources
  /// @{

  /// adds a vertex as a source and returns the index of this source.
  /// \throws Invalid_input if the surface has no such vertex
  std::size_t add_source(Vertex_index v)
  {
    internal::check_point(v, mesh());
    return add(v);
  }

  /// adds a point on an edge as a source and returns the index of this source.
  std::size_t add_source(const Edge_point<FT>& p) { return add_source(location(p)); }

  /// adds a point of any kind as a source and returns the index of this source.
  /// \pre `p` is not an isolated vertex
  std::size_t add_source(const Surface_point<FT>& p) { return add_source(location(p)); }

  /// adds a point of a face, also on its boundary, as a source and returns the index of this
  /// source.
  /// \throws Invalid_input if the coordinates of `p` are negative or do not sum up to one
  std::size_t add_source(const Face_location<FT>& p)
  {
    internal::check_point(p, mesh());
    return add(p);
  }

  /// adds all points of a segment as one source and returns its index.
  /// \throws Invalid_input if the coordinates of an end are negative or do not sum up to one
  std::size_t add_source(const Curve_segment<FT>& segment)
  {
    return add_source(Surface_curve<FT>{segment});
  }

  /// adds all points of a curve as one source and returns its index. Segments that share an end
  /// need fewer windows if they are added as one curve. Complexity: \f$O(n \log n)\f$ for \f$n\f$
  /// segments.
  /// \throws Invalid_input if the coordinates of an end are negative or do not sum up to one
  std::size_t add_source(const Surface_curve<FT>& curve)
  {
    for(const Curve_segment<FT>& segment : curve)
      internal::check_ends(segment, mesh());
    return add(curve);
  }

  /// computes the data for distances and paths. Complexity: \f$O(k)\f$ for \f$k\f$ windows. At most
  /// \f$O(n^2)\f$ windows lie between saddle vertices on embedded surfaces with \f$n\f$ faces; in
  /// practice some dozens for each face are needed.
  /// \param np
  /// \cgalNamedParamsBegin
  ///   \cgalParamNBegin{visitor}
  ///     \cgalParamDescription{follows the search, and can stop it by an exception; `run()` can be
  ///       called again then}
  ///     \cgalParamType{a model of `WindowVisitor`; it is copied unless `std::ref()` refers to it}
  ///     \cgalParamDefault{`Default_window_visitor`}
  ///   \cgalParamNEnd
  /// \cgalNamedParamsEnd
  /// \throws Numerical_error if more than \f$2^{25}\f$ windows, plus 1024 for each side of a face,
  ///   are needed, as on extreme needles
  template <typename NamedParameters = CGAL::parameters::Default_named_parameters>
  void run(const NamedParameters& np = CGAL::parameters::default_values())
  {
    Default_window_visitor silent;
    auto&& visitor = internal::visitor_of(np, silent);
    m_search.run(Search::unlimited_steps, visitor);
    m_is_run = true;
  }

  /// @}
  /// \name Distances
  /// After `run()`.
  /// @{

  /// returns the distance of a vertex from the nearest source; infinite if there is no path.
  /// Complexity: constant.
  FT distance(Vertex_index v) const
  {
    CGAL_precondition(m_is_run);
    return m_search.distance(v);
  }

  /// returns the distance of a point on an edge. Complexity: as for a point of a face.
  FT distance(const Edge_point<FT>& p) const { return distance(location(p)); }

  /// returns the distance of a point of any kind. Complexity: as for a point of a face.
  /// \pre `p` is not an isolated vertex
  FT distance(const Surface_point<FT>& p) const { return distance(location(p)); }

  /// returns the distance of a point of a face. Complexity: linear in the windows of this face.
  FT distance(const Face_location<FT>& p) const
  {
    CGAL_precondition(m_is_run);
    return m_search.to(p).length;
  }

  /// @}
  /// \name Paths
  /// After `run()`.
  /// @{

  /// returns the shortest path from the nearest source to a vertex. It has no points if the vertex
  /// is isolated.
  Surface_path<FT> path(Vertex_index v) const
  {
    CGAL_precondition(m_is_run);
    if(mesh().is_isolated(v))
      return {distance(v), {}};
    return path(m_search.to(v), m_search.at_vertex(v));
  }

  /// returns the shortest path from the nearest source to a point on an edge.
  Surface_path<FT> path(const Edge_point<FT>& p) const { return path(location(p)); }

  /// returns the shortest path from the nearest source to a point of any kind.
  /// \pre `p` is not an isolated vertex
  Surface_path<FT> path(const Surface_point<FT>& p) const { return path(location(p)); }

  /// returns the shortest path from the nearest source to a point of a face.
  ///
  /// The points come in the order from the source to `p`, both included. If the path crosses an
  /// edge, it leaves a face through the halfedge. From a vertex, the path continues along the
  /// halfedge, or through the face on its left. A vertex counts as hit if the path passes it
  /// within rounding. The result has no points if no path exists.
  ///
  /// Complexity: linear in the edges crossed, and in the windows of the face of `p`.
  Surface_path<FT> path(const Face_location<FT>& p) const
  {
    CGAL_precondition(m_is_run);
    return path(m_search.to(p), p);
  }

  /// returns the index of the nearest source of a point of a face. \pre there is a path
  std::size_t source(const Face_location<FT>& p) const
  {
    return source(m_search.to(p), internal::vertex_at(p, mesh()));
  }
  /// returns the index of the nearest source of a point on an edge. \pre there is a path
  std::size_t source(const Edge_point<FT>& p) const { return source(location(p)); }
  /// returns the index of the nearest source of a point. \pre there is a path
  std::size_t source(const Surface_point<FT>& p) const { return source(location(p)); }
  /// returns the index of the nearest source of a vertex. \pre there is a path
  std::size_t source(Vertex_index v) const { return source(m_search.to(v), v); }

  /// @}

private:
  typedef internal::Path_search<Length_map_of<Surface>> Search;
  typedef typename Search::Last_part Last_part;

  const Delta_complex& mesh() const { return m_search.mesh(); }

  template <typename Source>
  std::size_t add(const Source& source)
  {
    m_is_run = false;
    return m_search.add_source(source);
  }

  Face_location<FT> location(const Edge_point<FT>& p) const { return location(edge_location(p)); }
  Face_location<FT> location(const Surface_point<FT>& p) const { return face_location(p, mesh()); }

  Surface_path<FT> path(const Last_part& part, const Face_location<FT>& p) const
  {
    Surface_path<FT> result{part.length, {}};
    if(part.length < std::numeric_limits<FT>::infinity())
      m_search.trace(part, p, result.places);
    std::reverse(result.places.begin(), result.places.end());
    return result;
  }

  std::size_t source(const Last_part& part, Vertex_index v) const
  {
    CGAL_precondition(m_is_run && part.length < std::numeric_limits<FT>::infinity());
    return m_search.source_of(part, v);
  }

  Search m_search;
  bool m_is_run = false;
};

/// \ingroup PkgIntrinsicTriangulationsPaths
/// returns the shortest path from one point of a surface to another (see `Shortest_paths`). It has
/// no points if no path exists, or from an isolated vertex. The search stops at the distance of
/// `target`. Complexity: linear, plus `Shortest_paths::run()` up to that distance.
/// \param surface a model of `IntrinsicSurface` with floating point lengths
/// \param source, target points with coordinates that are not negative and sum up to one, each a
///        vertex, a `Face_location`, an `Edge_location` or a `Surface_point`
/// \param np the visitor, as for `Shortest_paths::run()`
/// \throws Numerical_error as `Shortest_paths::run()`
template <typename Surface, typename Source = Face_location<Length_of<Surface>>,
          typename Target = Face_location<Length_of<Surface>>,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
Surface_path<Length_of<Surface>>
shortest_path(const Surface& surface, const Source& source, const Target& target,
              const NamedParameters& np = CGAL::parameters::default_values())
{
  typedef Length_of<Surface> FT;
  Default_window_visitor silent;
  auto&& visitor = internal::visitor_of(np, silent);
  const auto begin = internal::location_of<FT>(source, surface.mesh()),
             end = internal::location_of<FT>(target, surface.mesh());
  Surface_path<FT> result{std::numeric_limits<FT>::infinity(), {}};
  if(!begin.first.is_valid() || !end.first.is_valid())
    return result;
  internal::Path_search search(internal::view_of(surface));
  search.add_source(begin);
  search.run_to(end, visitor);
  const auto part = search.to(end);
  result.length = part.length;
  if(part.length < std::numeric_limits<FT>::infinity())
    search.trace(part, end, result.places);
  std::reverse(result.places.begin(), result.places.end());
  return result;
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_SHORTEST_PATHS_H
