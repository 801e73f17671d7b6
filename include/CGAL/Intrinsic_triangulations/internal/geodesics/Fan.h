// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GEODESICS_FAN_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GEODESICS_FAN_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/corner_formulas.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/exact_decisions_of.h>
#include <CGAL/Intrinsic_triangulations/internal/geodesics/Flat_face.h>
#include <CGAL/Intrinsic_triangulations/tolerances.h>

#include <cstddef>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Returns the spokes from `out` counterclockwise to the opposite of `in`, which ends where `out`
// starts: on the left of a path. Empty if the boundary is between them.
template <typename P>
std::vector<Halfedge_index> fan(Halfedge_index in, Halfedge_index out, const Surface_mesh<P>& mesh)
{
  std::vector<Halfedge_index> result{out};
  do {
    if(mesh.is_border(result.back()))
      return {};
    result.push_back(next_spoke(result.back(), mesh));
  } while(result.back() != mesh.opposite(in));
  return result;
}

// returns the sum of its angles
template <typename Surface>
Length_of<Surface> fan_angle(const std::vector<Halfedge_index>& spokes, const Surface& surface)
{
  Length_of<Surface> sum(0);
  for(std::size_t i = 0; i + 1 < spokes.size(); ++i)
    sum += angle_at_source(spokes[i], surface);
  return sum;
}

// Returns whether the sum of the angles of a fan is less than pi: exactly for exact traits,
// otherwise by more than corners are uncertain.
template <typename Traits>
bool is_less_than_pi(const std::vector<Halfedge_index>& spokes,
                     const Intrinsic_triangulation<Traits>& tri)
{
  typedef typename Traits::FT FT;
  const FT rest = pi<FT>() - fan_angle(spokes, tri.intrinsic());
  if constexpr(Is_exact<Traits>::value) {
    auto decisions = exact_decisions(tri);
    return decisions.fan_sign(spokes) == POSITIVE;
  }
  return rest > flat_angle_tolerance<FT>();
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GEODESICS_FAN_H
