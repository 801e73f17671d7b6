// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_FLATTENING_STATUS_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_FLATTENING_STATUS_H

#include <CGAL/license/Discrete_conformal_maps.h>

namespace CGAL {
namespace Discrete_conformal_maps {

/// \ingroup PkgDiscreteConformalMapsFlat
/// how `flatten()` has ended. `triangle_inequality` and `no_minimum` occur in fixed triangulations
/// only.
enum class Flattening_status
{
  success,       ///< the map has what is prescribed
  not_converged, ///< the minimization has not converged: its own status says why
  triangle_inequality, ///< in some faces the scaled lengths do not obey the triangle inequality, so nothing is
                       ///< laid out
  no_minimum, ///< no scale factors give this triangulation the prescribed angles: some vertices together
              ///< need more than the faces around them have, or less than the faces between them
  layout_collapsed ///< the scale factors are as prescribed, but in the plane some faces are turned over or have no
                   ///< area: they are smaller than rounding there
};

/// \ingroup PkgDiscreteConformalMapsFlat
/// returns the name of `status`.
inline const char* to_string(Flattening_status status)
{
  switch(status) {
    case Flattening_status::success: return "success";
    case Flattening_status::not_converged: return "not_converged";
    case Flattening_status::triangle_inequality: return "triangle_inequality";
    case Flattening_status::no_minimum: return "no_minimum";
    case Flattening_status::layout_collapsed: return "layout_collapsed";
  }
  return "unknown";
}

} // namespace Discrete_conformal_maps
} // namespace CGAL

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_FLATTENING_STATUS_H
