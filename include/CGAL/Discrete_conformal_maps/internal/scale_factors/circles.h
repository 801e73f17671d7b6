// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_CIRCLES_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_CIRCLES_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/make_weighted_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/tolerances.h>

#include <CGAL/Named_function_parameters.h>

#include <boost/property_map/function_property_map.hpp>

#include <cmath>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

typedef Intrinsic_triangulations::Intrinsic_triangulation<> Surface_with_circles;

// \throws Invalid_input if a radius is negative, infinite or NaN
inline void check_radii(const std::vector<double>& radii)
{
  for(std::size_t v = 0; v < radii.size(); ++v)
    if(!(radii[v] >= 0 && std::isfinite(radii[v])))
      throw Intrinsic_triangulations::Invalid_input(
        "the radius at vertex " + std::to_string(v) + " is not a number that is zero or positive");
}

// Checks that circles at the ends of each edge do not meet, except that two of positive radius may
// touch, up to rounding of the length. `original` maps vertices to those with radii.
// \throws Invalid_input if they do
template <typename Original>
void check_circles(const Surface_with_circles& t, const Original& original,
                   const std::vector<double>& radii)
{
  for(Edge_index e : t.mesh().edges()) {
    const Vertex_index v = original(t.mesh().vertex(e, 0)), w = original(t.mesh().vertex(e, 1));
    const double r = radii[v.idx()], s = radii[w.idx()], rest = t.length(e) - (r + s);
    const bool may_touch = r > 0 && s > 0;
    const double rounding =
      may_touch ? Intrinsic_triangulations::rounding_unit<double>() * t.length(e) : 0.;
    if(rest < -rounding || (rest == 0 && !may_touch))
      throw Intrinsic_triangulations::Invalid_input(
        v == w ? "the circle at vertex " + std::to_string(v.idx()) + " meets itself"
               : "the circles at vertices " + std::to_string(v.idx()) + " and " +
                   std::to_string(w.idx()) + " meet");
  }
}

// Flips to the weighted Delaunay triangulation, with squared radii as weights. Returns the number
// of flips.
// \throws Invalid_input if a circle is hidden by others
template <typename Original, typename Visitor>
std::size_t flip_with_circles(Surface_with_circles& t, const Original& original,
                              const std::vector<double>& radii, Visitor& visitor)
{
  const auto weight = boost::make_function_property_map<Vertex_index>([&](Vertex_index v) {
    const double r = radii[original(v).idx()];
    return r * r;
  });
  const auto result = Intrinsic_triangulations::make_weighted_Delaunay(
    t, weight, CGAL::parameters::visitor(std::ref(visitor)));
  if(!result.hidden_vertices.empty())
    throw Intrinsic_triangulations::Invalid_input(
      "the circle at vertex " +
      std::to_string(original(result.hidden_vertices.front()).idx()) +
      " is hidden by circles that it meets");
  return result.flips;
}

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_CIRCLES_H
