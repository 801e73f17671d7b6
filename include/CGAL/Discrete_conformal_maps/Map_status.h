// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_MAP_STATUS_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_MAP_STATUS_H

#include <CGAL/license/Discrete_conformal_maps.h>

namespace CGAL::Discrete_conformal_maps {

/// \ingroup PkgDiscreteConformalMapsMaps
/// how the computation of a discrete conformal map has ended. `triangle_inequality` and
/// `no_minimum` occur in fixed triangulations only, and what concerns the layout only in the
/// geometry that is named.
enum class Map_status
{
  success,             ///< the map has what is prescribed
  not_converged,       ///< the minimization has not converged: see its own status
  triangle_inequality, ///< in some faces the scaled lengths do not obey the triangle inequality, so
                       ///< nothing is laid out
  no_minimum, ///< no scale factors give this triangulation the prescribed angles: some vertices
              ///< together need more than the faces around them have, or less than the faces
              ///< between them
  layout_collapsed, ///< the scale factors are as prescribed, but in the plane some faces are turned
                    ///< over or have no area: they are smaller than rounding there
  not_convex, ///< the image on the sphere is not a convex polyhedron, or breaks a bound of Section
              ///< 4.4.3
  not_conformal, ///< a length cross ratio on the sphere is not that of the input, by more than
                 ///< \f$10^{-8}\f$: numbers have too few digits
  not_glued ///< in the hyperbolic plane, faces do not close up around a vertex: a product of gluing
            ///< motions differs from the identity by more than \f$10^{-9}\f$
};

namespace internal {

struct Status_text
{
  const char *name, *message;
};

inline Status_text text_of(Map_status status)
{
  switch(status) {
    case Map_status::success: return {"success", "the map has what is prescribed"};
    case Map_status::not_converged: return {"not_converged", "the minimization has not converged"};
    case Map_status::triangle_inequality:
      return {"triangle_inequality", "the scale factors of the triangulation of the mesh violate "
                                     "the triangle inequality"};
    case Map_status::no_minimum:
      return {"no_minimum", "the triangulation of the mesh has no such scale factors"};
    case Map_status::layout_collapsed:
      return {"layout_collapsed", "some faces are smaller than rounding in the plane"};
    case Map_status::not_convex: return {"not_convex", "the image is not convex"};
    case Map_status::not_conformal:
      return {"not_conformal", "length cross ratios on the sphere are not those of the mesh"};
    case Map_status::not_glued:
      return {"not_glued", "the faces do not close up in the hyperbolic plane"};
  }
  return {"unknown", "unknown"};
}

} // namespace internal

/// \ingroup PkgDiscreteConformalMapsMaps
/// returns the name of `status`.
inline const char* to_string(Map_status status) { return internal::text_of(status).name; }

/// \ingroup PkgDiscreteConformalMapsMaps
/// returns what `status` means, as part of a sentence for users.
inline const char* message(Map_status status) { return internal::text_of(status).message; }

} // namespace CGAL::Discrete_conformal_maps

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_MAP_STATUS_H
