// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INSERTION_PART_OF_INPUT_EDGE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INSERTION_PART_OF_INPUT_EDGE_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>

#include <array>
#include <cmath>

namespace CGAL::Intrinsic_triangulations::internal {

// Returns ad - bc with a relative error of two roundings.
inline double difference_of_products(double a, double d, double b, double c)
{
  const double bc = b * c;
  return std::fma(a, d, -bc) + std::fma(-b, c, bc);
}

// Represents a part of an edge of T1 between two points on it. Each point is given by its weights
// at the source and at the target of a halfedge. A part near an end of the edge loses no digits.
struct Part_of_input_edge
{
  typedef std::array<double, 2> Weights;

  Halfedge_index along;
  Weights start, end;

  // Returns the length of the part. The result is bitwise equal from both sides.
  template <typename LengthMap>
  double length(const LengthMap& length_map) const
  {
    const double whole = length_map[Edge_index(along)];
    if(start[1] == 0 && end[0] == 0)
      return whole;
    return is_first_halfedge(along) ? part(start, end) * whole
                                    : part({end[1], end[0]}, {start[1], start[0]}) * whole;
  }

  // Returns the point at the fraction `t` of the part.
  Edge_location<double> point(double t, const Delta_complex& input) const
  {
    const double at_start = (1 - t) / (start[0] + start[1]), at_end = t / (end[0] + end[1]);
    const Edge_location<double> p{
      along, {at_start * start[0] + at_end * end[0], at_start * start[1] + at_end * end[1]}};
    if(!(part(start, p.weight) > 0 && part(p.weight, end) > 0))
      throw Numerical_error("no position is left on an edge");
    return input.is_border(along) ? reversed(p) : p;
  }

private:
  static double part(const Weights& a, const Weights& b)
  {
    return difference_of_products(a[0], b[1], a[1], b[0]) / ((a[0] + a[1]) * (b[0] + b[1]));
  }
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INSERTION_PART_OF_INPUT_EDGE_H
