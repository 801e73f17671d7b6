// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_MAPS_SURFACE_PATCH_H
#define CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_MAPS_SURFACE_PATCH_H

#include <CGAL/license/Intrinsic_simplification.h>

#include <CGAL/Intrinsic_simplification/Surface_operation.h>
#include <CGAL/Intrinsic_simplification/internal/tolerances.h>
#include <CGAL/Intrinsic_triangulations/Edge_point.h>

#include <array>
#include <cstddef>

namespace CGAL::Intrinsic_simplification::internal {

// The faces that an operation changes, before and after it, are a patch with four corners. An
// operation is linear in homogeneous coordinates of the patch. A point has only coordinates. A
// point of a curve or polygon also stores its edge or corner combinatorially.

typedef std::array<double, 3> Coordinates;       // in a face
typedef std::array<double, 4> Patch_coordinates; // in a patch
typedef Intrinsic_triangulations::Face_location<double> Location;

inline void normalize(Coordinates& b)
{
  const double sum = b[0] + b[1] + b[2];
  for(double& x : b)
    x /= sum;
}

// Stores corners of a face or patch, as bits.
typedef unsigned int Corner_set;

constexpr Corner_set bit(std::size_t corner) { return 1u << corner; }

inline bool is_subset(Corner_set part, Corner_set whole) { return (part & ~whole) == 0; }

// Returns whether the set has one corner.
inline bool is_single(Corner_set corners) { return (corners & (corners - 1)) == 0; }

// Returns whether the set has two corners.
inline bool is_pair(Corner_set corners)
{
  return !is_single(corners) && is_single(corners & (corners - 1));
}

// Represents a point of a curve or polygon, seen from a face of `n` corners with homogeneous
// coordinates. The set of its corners determines whether it is at a corner, on a side or inside.
// Rounding never does.
template <std::size_t n>
struct Curve_point
{
  std::array<double, n> weight;
  Corner_set corners;
  Coordinates along; // on the edge that is traced, or in the face that is cut; homogeneous
  std::size_t node;  // the index of the point
};

typedef Curve_point<3> Face_point;
typedef Curve_point<4> Patch_point;

// Represents a face of a patch.
struct Patch_face
{
  Face_index face;
  std::size_t base; // the index of the first of the corners in the face
  std::array<std::size_t, 3> corner;

  Patch_face(const Face_corner& first, const std::array<std::size_t, 3>& corners)
    : face(first.face()), base(first.index()), corner(corners)
  {}

  std::size_t in_face(std::size_t n) const { return (base + n) % 3; }

  Corner_set corners() const { return bit(corner[0]) | bit(corner[1]) | bit(corner[2]); }

  Patch_coordinates in_patch(const Coordinates& b) const
  {
    Patch_coordinates result{};
    for(std::size_t n = 0; n < 3; ++n)
      result[corner[n]] = b[in_face(n)];
    return result;
  }

  Coordinates in_face(const Patch_coordinates& x) const
  {
    Coordinates result{};
    for(std::size_t n = 0; n < 3; ++n)
      result[in_face(n)] = x[corner[n]];
    return result;
  }

  Patch_point in_patch(const Face_point& p) const
  {
    Patch_point result{in_patch(p.weight), 0, p.along, p.node};
    for(std::size_t n = 0; n < 3; ++n)
      if(p.corners & bit(in_face(n)))
        result.corners |= bit(corner[n]);
    return result;
  }

  Face_point in_face(const Patch_point& p) const
  {
    Face_point result{in_face(p.weight), 0, p.along, p.node};
    for(std::size_t n = 0; n < 3; ++n)
      if(p.corners & bit(corner[n]))
        result.corners |= bit(in_face(n));
    return result;
  }
};

// Returns the zero of a linear function between p and q, given the absolute values of the function
// at p and q.
inline Patch_point between(const Patch_point& p, const Patch_point& q, double at_p, double at_q)
{
  const double sum = at_p + at_q;
  const double a = sum > 0 ? at_q / sum : 0.5, b = sum > 0 ? at_p / sum : 0.5;
  Patch_point result{};
  for(std::size_t c = 0; c < 4; ++c)
    result.weight[c] = a * p.weight[c] + b * q.weight[c];
  for(std::size_t c = 0; c < 3; ++c)
    result.along[c] = a * p.along[c] + b * q.along[c];
  return result;
}

} // namespace CGAL::Intrinsic_simplification::internal

#endif // CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_MAPS_SURFACE_PATCH_H
