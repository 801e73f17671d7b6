// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_DELTA_COMPLEX_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_DELTA_COMPLEX_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Edge_point.h>

namespace CGAL::Discrete_conformal_maps {

// Connectivity has one type with the same names in all packages.
using Intrinsic_triangulations::Delta_complex;
using Intrinsic_triangulations::Edge_index;
using Intrinsic_triangulations::Face_index;
using Intrinsic_triangulations::Halfedge_index;
using Intrinsic_triangulations::opposite;
using Intrinsic_triangulations::Vertex_index;

} // namespace CGAL::Discrete_conformal_maps

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_DELTA_COMPLEX_H
