// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_INPUT_ROUNDING_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_INPUT_ROUNDING_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Delta_complex.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Flat_triangle.h>
#include <CGAL/Discrete_conformal_maps/internal/tolerances.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/Precise_lengths.h>
#include <CGAL/Intrinsic_triangulations/make_Delaunay.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

// Returns whether the input is a surface without regard to rounding: positions always are, lengths
// only with the triangle inequality.
inline bool has_exact_metric(const Intrinsic_triangulations::Intrinsic_triangulation<>& half)
{
  const auto input = Intrinsic_triangulations::internal::exact_input(half);
  const auto faces = half.mesh().faces();
  return !half.input_metric().points.empty() ||
         std::all_of(faces.begin(), faces.end(), [&](Face_index f) {
           return Intrinsic_triangulations::internal::area_sign(half.mesh().halfedge(f), input) !=
                  NEGATIVE;
         });
}

// Returns whether rounding of lengths may change an angle of the input by more than the allowed
// error of curvatures.
inline bool has_unknown_angles(const Intrinsic_triangulations::Intrinsic_triangulation<>& half)
{
  const auto faces = half.mesh().faces();
  return std::any_of(faces.begin(), faces.end(), [&half](Face_index f) {
    const auto side = sides(f, half.mesh());
    const auto length = [&](std::size_t s) { return half.length(Edge_index(side[s])); };
    return !(Flat_triangle<double>({length(0), length(1), length(2)}).angle_error() <=
             tolerance::known_input_angle);
  });
}

// States the computations on the exact surface, with more digits than `double` has. They are
// nothing, or the errors of the map, or the flips to T_2 and its lengths. The last value adds the
// flips to T_3, for the rounded numbers of the map.
enum class Exactness
{
  none,
  errors,
  lengths,
  decisions
};

// Flips to Delaunay by exact decisions, and returns the number of flips.
template <typename Visitor>
std::size_t flip_exactly(Intrinsic_triangulations::Intrinsic_triangulation<>& t, Visitor& visitor)
{
  using namespace Intrinsic_triangulations;
  return Intrinsic_triangulations::internal::flip_exactly(
           t, default_flip_limit(t.mesh().num_edges()), visitor, Concurrency())
    .flips;
}

// Returns the lengths of a triangulation on the exact surface of the input.
// \throws Numerical_error if 1024 bits are too few
template <typename FT>
std::vector<FT> exact_lengths(const Intrinsic_triangulations::Intrinsic_triangulation<>& t)
{
  typedef Intrinsic_triangulations::Intrinsic_triangulation<>::Traits Traits;
  Intrinsic_triangulations::Precise_lengths<Traits, FT> length(t);
  std::vector<FT> result;
  for(Edge_index e : t.mesh().edges())
    result.push_back(length(t.mesh().halfedge(e)));
  return result;
}

// Returns the least and the greatest length of an edge.
inline std::pair<double, double>
range_of_lengths(const Intrinsic_triangulations::Intrinsic_triangulation<>& t)
{
  double shortest = std::numeric_limits<double>::infinity(), longest = 0;
  for(Edge_index e : t.mesh().edges()) {
    shortest = (std::min)(shortest, t.length(e));
    longest = (std::max)(longest, t.length(e));
  }
  return {shortest, longest};
}

// Returns the greatest change of an angle at the shortest edge by rounding of the longest edge.
template <typename FT>
double rounding_at_short_edges(const Intrinsic_triangulations::Intrinsic_triangulation<>& t)
{
  const auto [shortest, longest] = range_of_lengths(t);
  return static_cast<double>(std::numeric_limits<FT>::epsilon()) * (longest / shortest);
}

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_INPUT_ROUNDING_H
