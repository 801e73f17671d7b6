// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_MAPS_CARRY_POINT_H
#define CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_MAPS_CARRY_POINT_H

#include <CGAL/license/Intrinsic_simplification.h>

#include <CGAL/Intrinsic_simplification/internal/maps/Recorded_flip.h>
#include <CGAL/Intrinsic_simplification/internal/maps/Route.h>
#include <CGAL/Intrinsic_simplification/internal/maps/Surface_patch.h>
#include <CGAL/Intrinsic_simplification/internal/maps/Vertex_sectors.h>

#include <cstddef>

namespace CGAL::Intrinsic_simplification::internal {

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

  void pass(const Vertex_sectors& sectors)
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
  void change(const Recorded_flip& turn, bool has_p, Patch_coordinates& x)
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

} // namespace CGAL::Intrinsic_simplification::internal

#endif // CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_MAPS_CARRY_POINT_H
