// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_MAP_NAMES_H
#define INTRINSIC_MAP_NAMES_H

#include <CGAL/Discrete_conformal_maps/Cones.h>
#include <CGAL/Discrete_conformal_maps/Layout.h>

#include <string>

// The names of choices for a map to the plane have been checked.

inline CGAL::Discrete_conformal_maps::Layout layout_named(const std::string& name)
{
  using CGAL::Discrete_conformal_maps::Layout;
  return name == "spectral"      ? Layout::spectral
         : name == "incremental" ? Layout::incremental
                                 : Layout::least_squares;
}

inline CGAL::Discrete_conformal_maps::Cones cones_named(const std::string& name)
{
  using CGAL::Discrete_conformal_maps::Cones;
  return name == "greedy" ? Cones::greedy : name == "exchanged" ? Cones::exchanged : Cones::none;
}

#endif // INTRINSIC_MAP_NAMES_H
