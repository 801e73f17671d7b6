// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_IDEAL_DEVELOPMENT_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_IDEAL_DEVELOPMENT_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Ideal_strip.h>
#include <CGAL/Intrinsic_triangulations/Surface_view.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Edge_courses.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/lay_out_strip.h>

#include <CGAL/Interval_nt.h>
#include <boost/property_map/function_property_map.hpp>

#include <cstddef>

namespace CGAL::Intrinsic_triangulations::internal {

// Intervals that are only used where a Protect_FPU_rounding<true> lives.
typedef Interval_nt<false> Filter_interval;

// Edges of T2, each derived afresh from the lengths of T1 in the strip of ideal triangles that it
// passes, in numbers of type `FT`. The lengths of T1 are taken as exact.
template <typename FT, typename Triangulation>
class Ideal_development
{
public:
  typedef Edge_courses<typename Triangulation::Traits> Courses;

  Ideal_development(const Triangulation& tri, const Courses& courses)
    : m_tri(tri), m_courses(courses)
  {}

  FT length(Edge_index e)
  {
    return m_tri.coordinates().is_shared(e) ? FT(m_tri.shared_length(first_halfedge(e)))
                                            : strip(e).length();
  }

  // The strip of the first halfedge of `e`. \pre `e` is not shared
  const Ideal_strip<FT>& strip(Edge_index e)
  {
    const auto length = boost::make_function_property_map<Edge_index>(
      [this](Edge_index x) { return FT(m_tri.input_length(x)); });
    lay_out_strip(m_strip, Surface_view(m_tri.input_mesh(), length), m_courses(first_halfedge(e)));
    return m_strip;
  }

private:
  const Triangulation& m_tri;
  const Courses& m_courses;
  Ideal_strip<FT> m_strip;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_IDEAL_DEVELOPMENT_H
