// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_LAYOUT_UNFOLDED_SPHERE_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_LAYOUT_UNFOLDED_SPHERE_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Delta_complex.h>
#include <CGAL/Discrete_conformal_maps/Map_promise.h>
#include <CGAL/Discrete_conformal_maps/Minimization.h>
#include <CGAL/Discrete_conformal_maps/Spherical_conformal_map.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Doubled_problem.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/number_conversion.h>
#include <CGAL/Discrete_conformal_maps/internal/tolerances.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

// Returns the greatest distance from the equator of a vertex on the boundary, and of other vertices
// below it.
inline double hemisphere_error(const Spherical_layout& layout, const Doubled_problem& problem)
{
  double result = 0;
  for(Vertex_index v : problem.surface().vertices()) {
    const double z = layout.position[v.idx()][2];
    result = greater_error(result, problem.is_on_boundary(v) ? std::abs(z) : -z);
  }
  return result;
}

// Stores the logarithmic scale factor of a vertex in the plane.
struct Scale_in_plane
{
  Double_double value;
  bool is_at_bound;
};

// Stores a sphere, or the double of a disk, unfolded into the plane from one of its vertices.
struct Unfolded_sphere
{
  Spherical_layout layout;
  std::vector<double> log_scale;        // of the polyhedron, at the vertices of the surface itself
  std::vector<Scale_in_plane> in_plane; // for the same vertices, or empty
  std::vector<Halfedge_index> flips;    // the flips from T_2 to T_3
  Minimization_result minimization;
  double angle_error = std::numeric_limits<double>::infinity(); // the error in the flat plane
  double cross_ratio_error = std::numeric_limits<double>::infinity();
  std::string cause; // the message of the error that has ended the search for a good result

  bool is_certified() const
  {
    return layout.exists && layout.certificate.is_convex() && layout.bound_violations == 0;
  }

  // Returns whether the result is good with this bound on the error of cross ratios.
  bool is_good(double greatest_error) const
  {
    return is_certified() && cross_ratio_error <= greatest_error;
  }

  // Returns the logarithmic scale factor of a vertex of the surface itself with all digits. The
  // result is rounded to `double` if positions exceed their range.
  Double_double precise_log_scale(Vertex_index v) const
  {
    const double rounded = log_scale[v.idx()], shift = log_scale[layout.at_infinity.idx()];
    if(v == layout.at_infinity || rounded == 0 || in_plane.empty())
      return rounded;
    const auto& [x, y] = layout.in_plane[v.idx()];
    const Double_double ln_four = 2 * Intrinsic_triangulations::internal::ln_two(),
                        result =
                          ln_four + in_plane[v.idx()].value - shift - log(1 + (x * x + y * y));
    return std::abs(result.high() - rounded) < tolerance::bound ? result : Double_double(rounded);
  }

  // Compares results. Certified results come first, and then results with smaller errors.
  bool operator<(const Unfolded_sphere& other) const
  {
    return is_certified() != other.is_certified() ? is_certified()
                                                  : cross_ratio_error < other.cross_ratio_error;
  }
};

// Returns positions in the plane as a map stores them. If the square of a position exceeds the
// range of `double`, the position cannot be distinguished from infinity.
template <typename FT>
std::vector<std::array<Double_double, 2>>
in_range_of_squares(const std::vector<std::array<FT, 2>>& position)
{
  const FT limit = tolerance::greatest_position;
  const auto clamped = [&](const FT& x) {
    return converted<Double_double>(x > limit ? limit : x < -limit ? FT(-limit) : x);
  };
  std::vector<std::array<Double_double, 2>> result;
  for(const auto& p : position)
    result.push_back({clamped(p[0]), clamped(p[1])});
  return result;
}

template <typename Number>
double log_of_one_plus(const Number& x)
{
  return x < 1e30 ? std::log1p(static_cast<double>(x)) : static_cast<double>(log(x));
}

// Returns the logarithmic scale factors of lengths on the sphere. A factor has two parts. The
// first part comes from the plane: `u`, with the scaling by `plane_scale` that leads to
// `position`. The second part comes from the stereographic projection. At infinity, only the
// second part exists, because neighbors have the distance one in horocycles. Isolated vertices of
// `surface` get zero.
template <typename FT>
std::vector<double> spherical_log_scales(const std::vector<double>& u, const FT& plane_scale,
                                         const std::vector<std::array<FT, 2>>& position,
                                         Vertex_index at_infinity, const Delta_complex& surface)
{
  typedef std::conditional_t<std::is_same<FT, Decimal_1500>::value, Wide_number<double>,
                             Double_double>
    Number;
  const double shift = static_cast<double>(log(converted<Number>(plane_scale)));
  std::vector<double> result;
  for(std::size_t v = 0; v < u.size(); ++v) {
    const Number x = converted<Number>(position[v][0]), y = converted<Number>(position[v][1]);
    result.push_back(std::log(2.) + u[v] - shift - log_of_one_plus(x * x + y * y));
  }
  result[at_infinity.idx()] = std::log(2.) + shift;
  for(Vertex_index v : surface.vertices())
    if(surface.is_isolated(v))
      result[v.idx()] = 0;
  return result;
}

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_LAYOUT_UNFOLDED_SPHERE_H
