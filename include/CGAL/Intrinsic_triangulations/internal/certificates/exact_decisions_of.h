// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_EXACT_DECISIONS_OF_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_EXACT_DECISIONS_OF_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/internal/certificates/Exact_decisions.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Referenced_crossings.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Traced_crossings.h>

namespace CGAL::Intrinsic_triangulations::internal {

// decisions about single edges of T2
template <typename Traits>
auto exact_decisions(const Triangulation_pair<Traits>& pair)
{
  return Exact_decisions<Traits>(pair,
                                 Referenced_crossings::found_in<Traced_crossings<Traits>>(pair));
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_EXACT_DECISIONS_OF_H
