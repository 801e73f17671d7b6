// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GEODESICS_FACE_BEYOND_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GEODESICS_FACE_BEYOND_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Flat_face.h>
#include <CGAL/Intrinsic_triangulations/internal/geodesics/Face_charts.h>
#include <CGAL/Intrinsic_triangulations/internal/geodesics/View.h>
#include <CGAL/Intrinsic_triangulations/tolerances.h>

#include <algorithm>
#include <complex>
#include <utility>

namespace CGAL::Intrinsic_triangulations::internal {

// Unfolds the face behind a side through which views look, in the frame of this side. Views
// continue to its two other sides, left and right of the corner `apex()`.
template <typename FT>
class Face_beyond
{
public:
  typedef Face_charts<FT> Charts;
  typedef typename Charts::Index Index;
  typedef typename Charts::Vector Vector;
  typedef internal::View<FT> View;

  // Unfolds the face behind the side `c`.
  // \pre the side `c` is not on the boundary
  Face_beyond(Index c, const Charts& charts)
    : m_charts(charts),
      m_side(charts.across(c)),
      m_apex(charts.apex_beyond(m_side)),
      m_rounding(rounding_unit<FT>() *
                 (charts.length(m_side) + charts.length(left()) + charts.length(right())))
  {}

  Index side() const { return m_side; }
  Index left() const { return Charts::next(m_side); }
  Index right() const { return Charts::previous(m_side); }
  const Vector& apex() const { return m_apex; }
  Index vertex_at_apex() const { return m_charts.source(right()); }

  // Returns the greatest error of lengths that rounding explains.
  FT tolerance(const View& view) const { return m_rounding + rounding_unit<FT>() * view.scale(); }

  // Compares the directions from which rays come. The result is negative if rays of `a` come from
  // the left of all rays of `b`, and positive if they come from the right. It is zero if they
  // overlap.
  int order(const View& a, const View& b) const
  {
    return a.end <= b.begin + m_rounding ? -1 : b.end <= a.begin + m_rounding ? 1 : 0;
  }

  // Returns the view through the side on the left or right. Its part is empty if the visible part
  // of this side is not longer than rounding errors.
  View next(const View& view, bool is_left) const
  {
    View result = view;
    const Index edge = is_left ? left() : right();
    const auto [from, to] = is_left ? part_on_left(view) : part_on_right(view);
    result.begin = from * m_charts.length(edge);
    result.end = to * m_charts.length(edge);
    if(!(result.end - result.begin > tolerance(view))) {
      result.close();
      return result;
    }
    result = in_next_frame(result, edge, is_left, m_apex, m_charts);
    result.position.imag((std::max)(result.position.imag(), FT(0)));
    result.edge = edge;
    result.entry = is_left ? Entry::before : Entry::after;
    return result;
  }

private:
  // Returns the visible part of a side, as fractions of its length.
  std::pair<FT, FT> part_on_left(const View& view) const
  {
    const FT middle = view.crossing(m_apex);
    if(!(view.begin < middle))
      return {FT(0), FT(0)};
    return {view.hit(view.begin, m_apex), middle < view.end ? FT(1) : view.hit(view.end, m_apex)};
  }
  std::pair<FT, FT> part_on_right(const View& view) const
  {
    const FT middle = view.crossing(m_apex), &l = m_charts.length(m_side);
    if(!(middle < view.end))
      return {FT(0), FT(0)};
    return {view.begin < middle ? FT(0) : view.hit_beyond(view.begin, m_apex, l),
            view.hit_beyond(view.end, m_apex, l)};
  }

  const Charts& m_charts;
  Index m_side;
  Vector m_apex;
  FT m_rounding; // of lengths in this face
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GEODESICS_FACE_BEYOND_H
