// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_EXACT_DECISIONS_OF_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_EXACT_DECISIONS_OF_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/internal/certificates/Exact_decisions.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Edge_courses.h>

namespace CGAL::Intrinsic_triangulations::internal {

// A base class, which is constructed before the decisions that refer to the courses.
template <typename Traits>
struct Courses_on_demand
{
  Edge_courses<Traits> courses;
};

// Decisions about a triangulation pair, with courses that are computed when they are read.
template <typename Traits>
class Decisions_on_demand : private Courses_on_demand<Traits>, public Exact_decisions<Traits>
{
public:
  explicit Decisions_on_demand(const Triangulation_pair<Traits>& pair)
    : Courses_on_demand<Traits>{Edge_courses<Traits>(pair)},
      Exact_decisions<Traits>(pair, this->courses)
  {}

  Decisions_on_demand(const Decisions_on_demand&) = delete;
  Decisions_on_demand& operator=(const Decisions_on_demand&) = delete;
};

template <typename Traits>
auto exact_decisions(const Triangulation_pair<Traits>& pair)
{
  return Decisions_on_demand<Traits>(pair);
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_EXACT_DECISIONS_OF_H
