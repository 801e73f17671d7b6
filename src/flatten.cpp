// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#define CGAL_INTRINSIC_TRIANGULATIONS_COMPILED extern
#include <CGAL/Intrinsic_triangulations/make_Delaunay.h>
#undef CGAL_INTRINSIC_TRIANGULATIONS_COMPILED

#define CGAL_INTRINSIC_TRIANGULATIONS_COMPILED
#include <CGAL/Discrete_conformal_maps/flatten.h>
