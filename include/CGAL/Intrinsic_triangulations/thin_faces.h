// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_THIN_FACES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_THIN_FACES_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Surface_view.h>
#include <CGAL/Intrinsic_triangulations/tolerances.h>
#include <CGAL/Intrinsic_triangulations/triangle_formulas.h>

#include <algorithm>
#include <type_traits>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// Returns whether `predicate(f)` holds for a face, or false if lengths are not of type `double`.
template <typename Surface, typename Predicate>
bool has_face([[maybe_unused]] const Surface& surface, [[maybe_unused]] const Predicate& predicate)
{
  if constexpr(std::is_same_v<Length_of<Surface>, double>) {
    const auto faces = surface.mesh().faces();
    return std::any_of(faces.begin(), faces.end(), predicate);
  }
  return false;
}

// Returns whether the lengths of a face determine its angles well enough for flips.
template <typename Surface>
bool has_resolved_angles(Face_index f, const Surface& surface)
{
  const auto [a, b, c] = side_lengths(surface.mesh().halfedge(f), surface);
  const double scaled = (a + b + c) * (a + b + c) * resolved_angle_ratio();
  return squared_quadrupled_area(a, b, c) >= scaled * scaled;
}

// Returns whether the lengths of a face determine its area to eight digits.
template <typename Surface>
bool has_resolved_area(Face_index f, const Surface& surface)
{
  const auto [a, b, c] = side_lengths(surface.mesh().halfedge(f), surface);
  const double slack = (std::min)({b + c - a, c + a - b, a + b - c});
  return slack >= resolved_area_slack() * (a + b + c);
}

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsOperators
/// returns whether a face is so thin that its edge lengths, rounded to `double`, do not determine
/// its angles. Then four times its area is less than \f$2^{-24}\f$ squared perimeters. Rounding of
/// the lengths changes an angle by the roundoff, divided by this quotient. Decisions about such a
/// surface must be derived from the exact metric. The result is `false` if lengths are not of type
/// `double`. Complexity: linear.
/// \param surface a model of `IntrinsicSurface`
template <typename Surface>
bool has_unresolved_angles(const Surface& surface)
{
  return internal::has_face(
    surface, [&](Face_index f) { return !internal::has_resolved_angles(f, surface); });
}

/// \ingroup PkgIntrinsicTriangulationsOperators
/// returns whether a face is so thin that its edge lengths in `double` do not determine its area
/// and its cotangents to eight digits. Then its longest side is shorter than both others together
/// by less than \f$2^{-22}\f$ perimeters. Operators of such a surface must be computed with more
/// digits, see `Precise_surface`. The result is `false` if lengths are not of type `double`.
/// Complexity: linear.
/// \param surface a model of `IntrinsicSurface`
template <typename Surface>
bool has_unresolved_areas(const Surface& surface)
{
  return internal::has_face(surface,
                            [&](Face_index f) { return !internal::has_resolved_area(f, surface); });
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_THIN_FACES_H
