// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CONVEX_POLYHEDRON_PYRAMID_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CONVEX_POLYHEDRON_PYRAMID_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Double_double.h>
#include <CGAL/Intrinsic_triangulations/internal/convex_polyhedron/Angle_sum.h>
#include <CGAL/Intrinsic_triangulations/triangle_formulas.h>
#include <CGAL/Intrinsic_triangulations/weighted_formulas.h>

#include <array>
#include <cstddef>

namespace CGAL::Intrinsic_triangulations::internal {

// Represents a pyramid over a triangle, given by the sides of the triangle and the distances of the
// apex from its corners. Side s leads from corner s to the next. Its foot, below the apex, is the
// power center of the triangle for the squared distances as weights. The same number may be
// subtracted from all weights.
class Pyramid
{
  typedef Double_double Number;
  typedef std::array<Number, 3> Numbers;

public:
  Pyramid(const Numbers& side, const Numbers& radius, const Numbers& weight)
    : m_side(side),
      m_radius(radius),
      m_weight(weight),
      m_quadrupled_area(quadrupled_area(side[0], side[1], side[2]))
  {
    for(std::size_t s = 0; s < 3; ++s)
      m_foot_height[s] = computed_foot_height(s);
    m_squared_height = squared_distance_from_side(0) - m_foot_height[0] * m_foot_height[0];
    m_height = m_squared_height > 0 ? sqrt(m_squared_height) : Number(0);
  }

  // Returns whether such a pyramid exists.
  bool exists() const { return m_quadrupled_area > 0 && m_squared_height > 0; }

  const Number& height() const { return m_height; }
  // Returns the height of the foot over side s, negative if the base is on its other side.
  const Number& foot_height(std::size_t s) const { return m_foot_height[s]; }

  // Adds the angle between the two lateral faces at corner c to `sum`, and its excess over the
  // angle of the base to `excess`.
  void add_lateral_angle(std::size_t c, Angle_sum& sum, Angle_sum& excess) const
  {
    const std::size_t p = (c + 2) % 3; // the side that ends there
    const Number r = m_radius[c], along = product_with_side(c),
                 back = (m_weight[c] - m_weight[p] + m_side[p] * m_side[p]) / 2,
                 sides = doubled_corner_product(m_side[(c + 1) % 3], m_side[c], m_side[p]) / 2,
                 area = m_quadrupled_area / 2, x = r * r * sides - along * back,
                 y = r * m_height * area;
    sum.add(x, y);
    excess.add(x * sides + y * area, y * sides - x * area);
  }

  // Returns by how much the curvature at the source of side s grows with the radius of its target,
  // as a contribution of this pyramid.
  Number derivative(std::size_t s) const
  {
    return m_foot_height[s] / m_height * m_radius[s] * m_radius[(s + 1) % 3] /
           (m_side[s] * squared_distance_from_side(s));
  }

  // Returns the cosine of the angle at the apex between the ends of side s.
  Number cosine_at_apex(std::size_t s) const
  {
    const Number a = m_radius[s], b = m_radius[(s + 1) % 3],
                 difference = (m_weight[s] - m_weight[(s + 1) % 3]) / (a + b);
    return 1 - (m_side[s] - difference) * (m_side[s] + difference) / (2 * a * b);
  }

private:
  // Returns the squared distance of the apex from the line of side s.
  Number squared_distance_from_side(std::size_t s) const
  {
    const Number foot = product_with_side(s) / m_side[s];
    return (m_radius[s] - foot) * (m_radius[s] + foot);
  }

  // Returns the scalar product of side s and the edge from its source to the apex.
  Number product_with_side(std::size_t s) const
  {
    return (m_weight[s] - m_weight[(s + 1) % 3] + m_side[s] * m_side[s]) / 2;
  }

  Number computed_foot_height(std::size_t s) const
  {
    const std::size_t j = (s + 1) % 3, k = (s + 2) % 3;
    return Weighted_triangle<Number>(m_side[s], m_side[j], m_side[k], m_weight[s], m_weight[j],
                                     m_weight[k])
             .scaled_height() *
           m_side[s] / (2 * m_quadrupled_area);
  }

  Numbers m_side, m_radius, m_weight, m_foot_height; // of the foot over sides
  Number m_quadrupled_area, m_squared_height, m_height;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CONVEX_POLYHEDRON_PYRAMID_H
