// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_CONES_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_CONES_H

#include <CGAL/license/Discrete_conformal_maps.h>

namespace CGAL::Discrete_conformal_maps {

/// \ingroup PkgDiscreteConformalMapsFlat
/// selects whether cones are placed automatically, in addition to prescribed cones. Placed cones
/// are inner vertices with the logarithmic scale factor zero.
enum class Cones
{
  automatic, ///< cones are placed if nothing is prescribed, or a `maximum_log_scale` or
             ///< `maximum_area_distortion` is given. `flatten_to_disk()` and
             ///< `flatten_to_rectangle()` place cones only if such a bound is given
  greedy,    ///< cones are placed one by one, until scale factors are within the bound
  exchanged, ///< greedy cones are then dropped and moved while estimated scale factors stay within
             ///< the bound, on components with at most 200 cones. Often fewer cones remain, and the
             ///< search takes longer
  none       ///< no cones are placed
};

} // namespace CGAL::Discrete_conformal_maps

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_CONES_H
