// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GEODESICS_FAN_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GEODESICS_FAN_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Surface_view.h>
#include <CGAL/Intrinsic_triangulations/corner_formulas.h>

#include <CGAL/Uncertain.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Returns the outgoing halfedges from `out` counterclockwise to the opposite of `in`, which ends
// where `out` starts: on the left of a path. Empty if the boundary is between them.
template <typename P>
std::vector<Halfedge_index> fan(Halfedge_index in, Halfedge_index out, const Surface_mesh<P>& mesh)
{
  std::vector<Halfedge_index> result{out};
  do {
    if(mesh.is_border(result.back()))
      return {};
    result.push_back(next_around_source(result.back(), mesh));
  } while(result.back() != mesh.opposite(in));
  return result;
}

// an angle and how far it can be off
template <typename FT>
struct Bounded_angle
{
  FT angle, error;
};

// Returns the angle at the source of `h` and a bound for its error if each length has the relative
// error `error`. A change of the opposite side changes the angle by this change over the height at
// that side times its foot, a change of another side by less. The bound is twice that, since the
// area may change, too; it is infinite if the triangle may be flat.
template <typename Surface>
Bounded_angle<Length_of<Surface>> bounded_angle(Halfedge_index h, const Surface& surface,
                                                const Length_of<Surface>& error)
{
  typedef Length_of<Surface> FT;
  const Delta_complex& mesh = surface.mesh();
  const FT a = edge_length(mesh.next(h), surface), b = edge_length(h, surface),
           c = edge_length(mesh.prev(h), surface);
  const FT area = quadrupled_area(a, b, c), change = error * (a + b + c);
  const FT slack = (std::min)({a + (b - c), a + (c - b), c + (b - a)});
  return {corner_angle(a, b, c),
          8 * change <= slack ? 4 * a * change / area : std::numeric_limits<FT>::infinity()};
}

// the sum of its angles
template <typename Surface>
Bounded_angle<Length_of<Surface>> fan_angle(const std::vector<Halfedge_index>& outgoing_halfedges,
                                            const Surface& surface, const Length_of<Surface>& error)
{
  Bounded_angle<Length_of<Surface>> sum{0, 0};
  for(std::size_t i = 0; i + 1 < outgoing_halfedges.size(); ++i) {
    const auto corner = bounded_angle(outgoing_halfedges[i], surface, error);
    sum.angle += corner.angle;
    sum.error += corner.error;
  }
  return sum;
}

// whether it is less than pi
template <typename FT>
Uncertain<bool> is_less_than_pi(const Bounded_angle<FT>& sum)
{
  return sum.angle + sum.error < pi<FT>()   ? Uncertain<bool>(true)
         : sum.angle - sum.error > pi<FT>() ? Uncertain<bool>(false)
                                            : Uncertain<bool>::indeterminate();
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GEODESICS_FAN_H
