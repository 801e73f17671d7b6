// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GEODESICS_FACE_CHARTS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GEODESICS_FACE_CHARTS_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Edge_point.h>
#include <CGAL/Intrinsic_triangulations/Flat_face.h>
#include <CGAL/Intrinsic_triangulations/Surface_view.h>
#include <CGAL/Intrinsic_triangulations/internal/geodesics/View.h>
#include <CGAL/Intrinsic_triangulations/tolerances.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Stores all data needed to unfold faces, side by side in memory. Side 3f + s is side s of the face
// f, numbered as its barycentric coordinates. Border halfedges are not sides.
template <typename FT>
class Face_charts
{
public:
  typedef std::uint32_t Index;
  typedef std::complex<FT> Vector;
  static constexpr Index null = (std::numeric_limits<Index>::max)();

  // Computes the charts of all faces. Complexity: linear.
  template <typename Surface>
  explicit Face_charts(const Surface& surface) : m_chart(surface.mesh().num_faces())
  {
    const Delta_complex& mesh = surface.mesh();
    for(Face_index f : mesh.faces()) {
      const auto side = sides(f, mesh);
      const Flat_face<FT> face(side[0], surface);
      const Vector d1 = face.direction(1), d2 = face.direction(2);
      Chart& chart = m_chart[f.idx()];
      chart.turn = {-d2, -std::conj(d1), -std::conj(d2) * d1};
      for(std::size_t s = 0; s < 3; ++s) {
        const Halfedge_index o = mesh.opposite(side[s]);
        chart.length[s] = edge_length(side[s], surface);
        chart.vertex[s] = mesh.source(side[s]).idx();
        chart.across[s] = mesh.is_border(o) ? null : side_of(o, mesh);
      }
    }
  }

  std::size_t number_of_sides() const { return 3 * m_chart.size(); }

  // Returns the number of the side of the halfedge `h`, which is not a border halfedge.
  static Index side_of(Halfedge_index h, const Delta_complex& mesh)
  {
    return Index(3 * mesh.face(h).idx() + side_number(h, mesh));
  }

  static Halfedge_index halfedge(Index c, const Delta_complex& mesh)
  {
    return sides(Face_index(c / 3), mesh)[c % 3];
  }

  static Index next(Index c) { return c % 3 == 2 ? c - 2 : c + 1; }
  static Index previous(Index c) { return c % 3 == 0 ? c + 2 : c - 1; }

  // Returns the side on the other side of the edge, or null on the boundary.
  Index across(Index c) const { return m_chart[c / 3].across[c % 3]; }

  const FT& length(Index c) const { return m_chart[c / 3].length[c % 3]; }
  Index source(Index c) const { return m_chart[c / 3].vertex[c % 3]; }
  Index target(Index c) const { return source(next(c)); }

  // Returns the rotation by the angle at the source of the side.
  const Vector& turn(Index c) const { return m_chart[c / 3].turn[c % 3]; }

  // Returns whether the corners of the face are on one line, up to rounding.
  bool is_line(Face_index f) const
  {
    const auto& turn = m_chart[f.idx()].turn;
    return std::all_of(turn.begin(), turn.end(), [](const Vector& t) {
      return CGAL::abs(t.imag()) <= flat_angle_tolerance<FT>();
    });
  }

  // Returns the mean of one side length of each face, or one if no face exists.
  FT mean_length() const
  {
    FT sum(0);
    for(const Chart& chart : m_chart)
      sum += chart.length[0];
    return sum > 0 ? FT(sum / FT(m_chart.size())) : FT(1);
  }

  // Returns the position of the corner opposite to `o` in the frame of the side across. This side
  // starts at the target of `o`, the origin, and leads along the x-axis.
  Vector apex_beyond(Index o) const
  {
    const FT &after = length(next(o)), &before = length(previous(o));
    return after < before ? after * std::conj(turn(next(o))) : length(o) - before * turn(o);
  }

private:
  struct Chart
  {
    std::array<FT, 3> length;
    std::array<Vector, 3> turn;
    std::array<Index, 3> vertex, across;
  };

  std::vector<Chart> m_chart;
};

// Returns a view in the frame of the side `edge`, left or right of the opposite corner. This
// corner is at `apex`, beyond the side through which the view looks. The frame on the right starts
// at that corner.
template <typename FT>
View<FT> in_next_frame(View<FT> view, typename View<FT>::Index edge, bool is_left,
                       const std::complex<FT>& apex, const Face_charts<FT>& charts)
{
  if(is_left) {
    view.position *= charts.turn(edge);
    return view;
  }
  if(view.is_parallel)
    view.before -= dot(apex, view.position);
  else
    view.position -= apex;
  view.position *= std::conj(charts.turn(Face_charts<FT>::next(edge)));
  return view;
}

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

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GEODESICS_FACE_CHARTS_H
