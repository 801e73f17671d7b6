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

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace CGAL::Intrinsic_triangulations::internal {

// Stores outgoing halfedges of a vertex, counterclockwise.
typedef boost::container::small_vector<Halfedge_index, 16> Fan;

// Stores both ends of a fan, counterclockwise. They are the same if the fan is a full turn.
struct Fan_ends
{
  Halfedge_index first, last;
};

// Sets `result` to the outgoing halfedges between two ends. It is empty if the boundary is between
// them.
template <typename P>
void find_fan(Fan_ends ends, const Surface_mesh<P>& mesh, Fan& result)
{
  result.clear();
  for(Halfedge_index h = ends.first;; h = next_around_source(h, mesh)) {
    result.push_back(h);
    if(h == ends.last && result.size() > 1)
      return;
    if(mesh.is_border(h))
      return result.clear();
  }
}

template <typename P>
Fan fan(Fan_ends ends, const Surface_mesh<P>& mesh)
{
  Fan result;
  find_fan(ends, mesh, result);
  return result;
}

// Stores an angle and a bound for its error.
template <typename FT>
struct Bounded_angle
{
  FT angle, error;
};

// Represents the corner of a triangle between the sides `b` and `c`. Each length has the relative
// error `error`.
template <typename FT>
struct Uncertain_corner
{
  FT a, b, c, error;

  template <typename Surface>
  Uncertain_corner(Halfedge_index h, const Surface& surface, const FT& error)
    : a(edge_length(surface.mesh().next(h), surface)),
      b(edge_length(h, surface)),
      c(edge_length(surface.mesh().prev(h), surface)),
      error(error)
  {}

  // Returns a bound for the error of the angle. If the opposite side changes by d, the angle
  // changes by d divided by the height over that side. A change of another side has a smaller
  // effect. The bound is twice as large, because the area may change, too. It is infinite if the
  // triangle may be flat.
  FT angle_error(const FT& quadrupled_area) const
  {
    const FT change = error * (a + b + c);
    const FT slack = (std::min)({a + (b - c), a + (c - b), c + (b - a)});
    return 8 * change <= slack ? 4 * a * change / quadrupled_area
                               : std::numeric_limits<FT>::infinity();
  }

  Bounded_angle<FT> angle() const
  {
    return {corner_angle(a, b, c), angle_error(quadrupled_area(a, b, c))};
  }
};

// Stores the sum of the angles of corners as a complex number of about length one.
template <typename FT>
class Corner_sum
{
public:
  void add(const Uncertain_corner<FT>& corner)
  {
    const auto& [a, b, c, error] = corner;
    const FT area = quadrupled_area(a, b, c), inverse = 1 / (2 * b * c);
    const FT cosine = doubled_corner_product(a, b, c) * inverse, sine = area * inverse;
    m_error += corner.angle_error(area);
    const FT x = m_x * cosine - m_y * sine;
    m_y = m_x * sine + m_y * cosine;
    m_x = x;
  }

  // Adds the outside of the surface, which is at least pi.
  void add_boundary()
  {
    m_y = -1;
    m_error = 0;
  }

  // Returns whether the sum is less than pi, if the error of its sine permits a decision.
  // \pre the sum of all corners except for the last one is certainly less than pi
  Uncertain<bool> is_less_than_pi() const
  {
    const FT bound = m_error + m_error / 4; // with the rounding of products
    return m_y > bound    ? Uncertain<bool>(true)
           : m_y < -bound ? Uncertain<bool>(false)
                          : Uncertain<bool>::indeterminate();
  }

  // Returns the sum, if it is less than pi.
  FT angle() const
  {
    using std::atan2;
    return atan2(m_y, m_x);
  }

private:
  FT m_x = 1, m_y = 0, m_error = 0;
};

// Returns the sum of the angles of a fan. It stops at the first corner after which the sum is not
// certainly less than pi. The sine of the sum decides whether it is less than pi. This needs no
// inverse tangents, which would dominate the time of paths.
template <typename Surface>
Corner_sum<Length_of<Surface>> corner_sum(Fan_ends ends, const Surface& surface,
                                          const Length_of<Surface>& error)
{
  typedef Length_of<Surface> FT;
  Corner_sum<FT> sum;
  Halfedge_index h = ends.first;
  do {
    if(surface.mesh().is_border(h))
      sum.add_boundary();
    else
      sum.add(Uncertain_corner<FT>(h, surface, error));
    h = next_around_source(h, surface.mesh());
  } while(h != ends.last && certainly(sum.is_less_than_pi()));
  return sum;
}

// Returns the sum of the angles of a fan.
template <typename Surface>
Bounded_angle<Length_of<Surface>> fan_angle(const Fan& outgoing_halfedges, const Surface& surface,
                                            const Length_of<Surface>& error)
{
  typedef Length_of<Surface> FT;
  Bounded_angle<FT> sum{0, 0};
  for(std::size_t i = 0; i + 1 < outgoing_halfedges.size(); ++i) {
    const auto corner = Uncertain_corner<FT>(outgoing_halfedges[i], surface, error).angle();
    sum.angle += corner.angle;
    sum.error += corner.error;
  }
  return sum;
}

// Returns whether the sum is less than pi.
template <typename FT>
Uncertain<bool> is_less_than_pi(const Bounded_angle<FT>& sum)
{
  return sum.angle + sum.error < pi<FT>()   ? Uncertain<bool>(true)
         : sum.angle - sum.error > pi<FT>() ? Uncertain<bool>(false)
                                            : Uncertain<bool>::indeterminate();
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GEODESICS_FAN_H
