// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_SURFACE_MAP_H
#define CGAL_INTRINSIC_SIMPLIFICATION_SURFACE_MAP_H

#include <CGAL/license/Intrinsic_simplification.h>

#include <CGAL/Intrinsic_simplification/Evolving_surface.h>
#include <CGAL/Intrinsic_simplification/Surface_history.h>
#include <CGAL/Intrinsic_simplification/Surface_level.h>
#include <CGAL/Intrinsic_simplification/internal/maps/Route.h>
#include <CGAL/Intrinsic_simplification/internal/maps/Surface_patch.h>
#include <CGAL/Intrinsic_triangulations/Edge_point.h>
#include <CGAL/Intrinsic_triangulations/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/for_each_in_chunks.h>

#include <CGAL/assertions.h>

#include <cstddef>
#include <vector>

namespace CGAL::Intrinsic_simplification {

namespace internal {

// Maps a point in a face of the evolving surface through the operations on its face. Coordinates
// are homogeneous. The direction is a constant, and faces of a patch are named by constants, so
// that no index is computed.
template <bool is_forward>
class Carried_point
{
public:
  Carried_point(const Route& route, const Location& p) : m_route(route), m_point(p) {}

  const Location& location() const { return m_point; }

  void pass(const Scaling& scaling)
  {
    const Coordinates factor = m_route.factors(scaling, m_point.first);
    for(std::size_t c = 0; c < 3; ++c)
      m_point.second[c] *= factor[c];
  }

  void pass(const Flip& flip)
  {
    const Recorded_flip turn(flip, is_forward);
    Patch_coordinates x = turn.has_r(m_point.first) ? turn.before(true).in_patch(m_point.second)
                                                    : turn.before(false).in_patch(m_point.second);
    if(turn.is_beside_p(x))
      change(turn, true, x);
    else
      change(turn, false, x);
  }

  void pass(const Vertex_sectors<>& sectors)
  {
    if(is_forward != sectors.is_insertion()) {
      const Coordinates& b = m_point.second;
      const std::size_t n = sectors.sector_of(m_point.first);
      Patch_coordinates x = n == 0   ? sectors[0].in_patch(b)
                            : n == 1 ? sectors[1].in_patch(b)
                                     : sectors[2].in_patch(b);
      sectors.merge(x);
      move_to(sectors.whole(), x);
    } else {
      Patch_coordinates x = sectors.whole().in_patch(m_point.second);
      const std::size_t used_up = sectors.split(x);
      move_to(sectors[(used_up + 1) % 3], x);
    }
  }

private:
  void change(const Recorded_flip<>& turn, bool has_p, Patch_coordinates& x)
  {
    turn.change_inside(x, has_p);
    move_to(turn.after(has_p), x);
  }

  void move_to(const Patch_face& face, const Patch_coordinates& x)
  {
    m_point = {face.face, face.in_face(x)};
  }

  const Route& m_route;
  Location m_point;
};

// Maps a point of the level where `route` starts to the level where it ends.
template <bool is_forward>
Location carry_point(Location p, const Route& route)
{
  p.first = route.start().surface_face(p.first);
  Carried_point<is_forward> carried(route, p);
  const auto next = [&](Route::Time now) { return route.next(carried.location().first, now); };
  for(Route::Time t = next(route.start().time()); t != route.end().time();)
    t = next(route.pass(t, [&](const auto& operation) { carried.pass(operation); }));
  p = {route.end().level_face(carried.location().first), carried.location().second};
  normalize(p.second);
  return p;
}
template <typename FT = double>
class Curve_tracer;
class Face_cutter;
} // namespace internal

/// \ingroup PkgIntrinsicSimplificationRef
/// the bijective map between two levels of an evolving surface (Section 5.2.1).
///
/// A point is carried through the operations that change its face; each face has a list of them.
/// The map is continuous, and projective on pieces. A vertex of both levels is mapped exactly to
/// itself, and a point of a boundary to a point of the boundary.
///
/// The object refers to the history and to both levels. Memory: 4 bytes for each face and operation
/// on it.
class Surface_map
{
public:
  /// a face and barycentric coordinates that sum up to one.
  typedef Intrinsic_triangulations::Face_location<double> Location;

  /// prepares the map. Complexity: linear in the faces of the fine level and the operations.
  /// \throws Intrinsic_triangulations::Overflow_error if there are more operations than can be
  ///   indexed
  /// \pre both levels are of the surface with this history, and `coarse` is not earlier than `fine`
  Surface_map(const Surface_history& history, const Surface_level& fine,
              const Surface_level& coarse)
    : m_history(history),
      m_fine(fine),
      m_coarse(coarse),
      m_operations(history, fine.time(), coarse.time(), fine.number_of_surface_faces())
  {
    CGAL_precondition(fine.time() <= coarse.time());
  }

  /// prepares the map between levels of `surface`, and refers to its history.
  Surface_map(const Evolving_surface& surface, const Surface_level& fine,
              const Surface_level& coarse)
    : Surface_map(surface.history(), fine, coarse)
  {}

  /// returns the fine level.
  const Surface_level& fine() const { return m_fine; }
  /// returns the coarse level.
  const Surface_level& coarse() const { return m_coarse; }

  /// returns the vertex of the coarse level that corresponds to the vertex `v` of the fine level;
  /// null if it has been removed. Complexity: logarithmic.
  Vertex_index coarse_vertex(Vertex_index v) const
  {
    return m_coarse.level_vertex(m_fine.surface_vertex(v));
  }

  /// returns the operations.
  const Surface_history& history() const { return m_history; }

  /// maps a point of the fine surface to the coarse surface: a `Location`, or a `Surface_point` of
  /// `Intrinsic_triangulations`. Complexity: linear in the operations that move the point, times
  /// the logarithm of the number of operations on a face.
  template <typename Point = Location>
  Location to_coarse(const Point& p) const
  {
    return internal::carry_point<true>(Intrinsic_triangulations::face_location(p, m_fine.mesh()),
                                       route(true));
  }

  /// maps a point of the coarse surface to the fine surface. Complexity: see `to_coarse()`.
  template <typename Point = Location>
  Location to_fine(const Point& p) const
  {
    return internal::carry_point<false>(Intrinsic_triangulations::face_location(p, m_coarse.mesh()),
                                        route(false));
  }

  /// maps points of the fine surface to the coarse surface.
  /// \tparam NamedParameters a sequence of named parameters
  /// \param points the points
  /// \param np
  /// \cgalNamedParamsBegin
  ///   \cgalParamNBegin{concurrency_tag}
  ///     \cgalParamDescription{whether several threads are used; see \ref is_parallel}
  ///     \cgalParamType{`CGAL::Sequential_tag`, `CGAL::Parallel_tag` or
  ///                    `CGAL::Parallel_if_available_tag`}
  ///     \cgalParamDefault{`CGAL::Sequential_tag`}
  ///   \cgalParamNEnd
  /// \cgalNamedParamsEnd
  template <typename NamedParameters = CGAL::parameters::Default_named_parameters>
  std::vector<Location>
  to_coarse(const std::vector<Location>& points,
            const NamedParameters& np = CGAL::parameters::default_values()) const
  {
    return images(points, np, [this](const Location& p) { return to_coarse(p); });
  }

  /// maps points of the coarse surface to the fine surface.
  /// \tparam NamedParameters a sequence of named parameters
  /// \param points the points
  /// \param np as for `to_coarse()`
  template <typename NamedParameters = CGAL::parameters::Default_named_parameters>
  std::vector<Location>
  to_fine(const std::vector<Location>& points,
          const NamedParameters& np = CGAL::parameters::default_values()) const
  {
    return images(points, np, [this](const Location& p) { return to_fine(p); });
  }

private:
  template <typename FT>
  friend class internal::Curve_tracer;
  friend class internal::Face_cutter;

  template <typename NamedParameters, typename Map>
  static std::vector<Location> images(const std::vector<Location>& points,
                                      const NamedParameters& np, const Map& map)
  {
    std::vector<Location> result(points.size());
    Intrinsic_triangulations::for_each_chunk(Intrinsic_triangulations::concurrency_of(np),
                                             points.size(),
                                             [&](std::size_t begin, std::size_t end) {
                                               for(std::size_t i = begin; i < end; ++i)
                                                 result[i] = map(points[i]);
                                             });
    return result;
  }

  internal::Route route(bool to_coarse) const
  {
    return to_coarse ? internal::Route(m_history, m_operations, m_fine, m_coarse)
                     : internal::Route(m_history, m_operations, m_coarse, m_fine);
  }

  const Surface_history& m_history;
  const Surface_level &m_fine, &m_coarse;
  internal::Operations_by_face m_operations;
};

/// \ingroup PkgIntrinsicSimplificationRef
/// returns the position of the vertex `v` of the fine surface on the coarse surface. Complexity:
/// the complexity of `map.to_coarse()`.
/// \tparam Map `Surface_map`, `Correspondence_map` or `Composed_map`
/// \pre `v` is not isolated
template <typename Map>
Surface_map::Location image_of_vertex(Vertex_index v, const Map& map)
{
  const Delta_complex& mesh = map.fine().mesh();
  return map.to_coarse(Intrinsic_triangulations::face_location(
    Intrinsic_triangulations::Edge_point<double>{first_outgoing_halfedge(v, mesh), 0}, mesh));
}

/// \ingroup PkgIntrinsicSimplificationRef
/// returns the position of the vertex `v` of the coarse surface on the fine surface. Complexity:
/// the complexity of `map.to_fine()`.
/// \tparam Map `Surface_map`, `Correspondence_map` or `Composed_map`
/// \pre `v` is not isolated
template <typename Map>
Surface_map::Location preimage_of_vertex(Vertex_index v, const Map& map)
{
  const Delta_complex& mesh = map.coarse().mesh();
  return map.to_fine(Intrinsic_triangulations::face_location(
    Intrinsic_triangulations::Edge_point<double>{first_outgoing_halfedge(v, mesh), 0}, mesh));
}

} // namespace CGAL::Intrinsic_simplification

#endif // CGAL_INTRINSIC_SIMPLIFICATION_SURFACE_MAP_H
