// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_PLANAR_LAYOUTS_NAMED_LAYOUT_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_PLANAR_LAYOUTS_NAMED_LAYOUT_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Layout.h>
#include <CGAL/Discrete_conformal_maps/internal/minimization/Shared_order.h>
#include <CGAL/Discrete_conformal_maps/internal/planar_layouts/Least_squares_layout.h>
#include <CGAL/Discrete_conformal_maps/internal/planar_layouts/Spectral_layout.h>
#include <CGAL/Discrete_conformal_maps/internal/planar_layouts/Unfolded_faces.h>

namespace CGAL::Discrete_conformal_maps::internal {

// Calls the layout that `kind` names.
struct Named_layout
{
  template <typename FT>
  void operator()(Unfolded_faces<FT>& faces, const Shared_order& order) const
  {
    switch(kind) {
      case Layout::least_squares: return Least_squares_layout()(faces, order);
      case Layout::spectral: return Spectral_layout()(faces, order);
      case Layout::incremental: return Incremental_layout()(faces, order);
    }
  }

  Layout kind;
};

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_PLANAR_LAYOUTS_NAMED_LAYOUT_H
