// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_CONE_CHOICE_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_CONE_CHOICE_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Cones.h>
#include <CGAL/Discrete_conformal_maps/named_parameters.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL::Discrete_conformal_maps::internal {

// States how cones are placed.
struct Cone_choice
{
  double maximum_log_scale; // infinity for no cones
  bool is_exchanged;        // whether cones are dropped and moved
};

// Returns the logarithmic scale factor of vertices whose areas grow by a factor.
inline double log_scale_of(double area_distortion)
{
  if(!(area_distortion > 1))
    throw Intrinsic_triangulations::Invalid_input(
      "the maximum area distortion is not greater than 1");
  return std::log(area_distortion) / 2;
}

// Returns how cones are chosen. `is_free` states whether nothing is prescribed.
// \throws Invalid_input if the greatest distortion of areas is not greater than 1
template <typename NamedParameters>
Cone_choice cone_choice(bool is_free, const NamedParameters& np)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  using Intrinsic_triangulations::internal::has_parameter;
  constexpr bool has_log_scale = has_parameter<NamedParameters, internal_np::maximum_log_scale_t>(),
                 has_distortion =
                   has_parameter<NamedParameters, internal_np::maximum_area_distortion_t>();
  const Cones cones = choose_parameter(get_parameter(np, internal_np::cones), Cones::automatic);
  double bound = std::numeric_limits<double>::infinity();
  if constexpr(has_distortion)
    bound = log_scale_of(double(get_parameter(np, internal_np::maximum_area_distortion)));
  if constexpr(has_log_scale || !has_distortion)
    bound = (std::min)(
      bound, double(choose_parameter(get_parameter(np, internal_np::maximum_log_scale), 5.)));
  const bool is_bounded =
    cones == Cones::greedy || cones == Cones::exchanged ||
    (cones == Cones::automatic && (is_free || has_log_scale || has_distortion));
  return {is_bounded ? bound : std::numeric_limits<double>::infinity(), cones == Cones::exchanged};
}

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_CONE_CHOICE_H
