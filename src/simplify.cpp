// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>

#define CGAL_INTRINSIC_TRIANGULATIONS_COMPILED extern
#include <CGAL/Intrinsic_triangulations/make_Delaunay.h>
#undef CGAL_INTRINSIC_TRIANGULATIONS_COMPILED

#define CGAL_INTRINSIC_TRIANGULATIONS_COMPILED
#include <CGAL/Intrinsic_simplification/simplify.h>
