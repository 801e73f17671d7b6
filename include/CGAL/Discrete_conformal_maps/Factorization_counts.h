// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_FACTORIZATION_COUNTS_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_FACTORIZATION_COUNTS_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <cstddef>

namespace CGAL::Discrete_conformal_maps {

/// \ingroup PkgDiscreteConformalMapsMinimizers
/// counts the steps that solve sparse linear systems.
struct Factorization_counts
{
  std::size_t factorizations = 0;    ///< the number of numeric factorizations
  std::size_t symbolic_analyses = 0; ///< the number of symbolic analyses
  std::size_t orderings = 0;         ///< the number of fill-reducing orders

  /// adds the numbers of `other`.
  Factorization_counts& operator+=(const Factorization_counts& other)
  {
    factorizations += other.factorizations;
    symbolic_analyses += other.symbolic_analyses;
    orderings += other.orderings;
    return *this;
  }
};

} // namespace CGAL::Discrete_conformal_maps

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_FACTORIZATION_COUNTS_H
