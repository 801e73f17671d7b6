// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CURVE_ACROSS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CURVE_ACROSS_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Correspondence.h>
#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Edge_point.h>
#include <CGAL/Intrinsic_triangulations/Surface_curve.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Correspondence_marks.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Face_map.h>
#include <CGAL/Intrinsic_triangulations/tolerances.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// The part of a segment in a region of a face, and the map from there to a face of the other
// triangulation.
template <typename FT>
struct Segment_part
{
  std::size_t segment;
  FT begin, end; // parameters along the segment
  Face_index face;
  Polygon_map<FT> map;

  // in the order along each segment; where parts overlap, the longest first
  friend bool operator<(const Segment_part& a, const Segment_part& b)
  {
    return std::tie(a.segment, a.begin, b.end) < std::tie(b.segment, b.begin, a.end);
  }
};

// The parameters between which a segment is in a convex polygon. Points on its sides up to rounding
// are inside.
template <typename FT>
std::pair<FT, FT> clipped(const Curve_segment<FT>& segment, const Polygon_map<FT>& polygon)
{
  std::pair<FT, FT> range(0, 1);
  for(std::size_t c = 0; c < polygon.size(); ++c) {
    const auto &a = polygon.corner(c), &b = polygon.corner((c + 1) % polygon.size());
    const auto inside = [&](const std::array<FT, 3>& p) {
      const FT area = orientation(a, b, p);
      return CGAL::abs(area) <= rounding_unit<FT>() ? FT(0) : area;
    };
    const FT p = inside(segment.source), q = inside(segment.target);
    if(p < 0 && q <= 0)
      return {1, 0};
    if(p < 0)
      range.first = (std::max)(range.first, FT(p / (p - q)));
    else if(q < 0)
      range.second = (std::min)(range.second, FT(p / (p - q)));
  }
  return range;
}

// Cuts the segments of a curve at the edges of the other triangulation.
template <typename Traits>
class Curve_cutter
{
  typedef typename Traits::FT FT;
  typedef Correspondence_marks<Traits> Marks;

public:
  Curve_cutter(const Correspondence<Traits>& correspondence, Side side,
               const Surface_curve<FT>& curve)
    : m_correspondence(correspondence),
      m_side(side),
      m_curve(curve),
      m_segments(correspondence.mesh(side).num_faces())
  {
    for(std::size_t i = 0; i < curve.size(); ++i)
      m_segments[curve[i].face.idx()].push_back(i);
  }

  Surface_curve<FT> operator()()
  {
    for(Face_index f : m_correspondence.mesh(Side::intrinsic).faces())
      if(m_side == Side::input || !m_segments[f.idx()].empty())
        cut_at(f);
    std::sort(m_parts.begin(), m_parts.end());
    Surface_curve<FT> result;
    FT end(0); // of the parts of a segment so far
    for(std::size_t i = 0; i < m_parts.size(); ++i) {
      if(i == 0 || m_parts[i].segment != m_parts[i - 1].segment)
        end = FT(0);
      add(m_parts[i], end, result);
    }
    return result;
  }

private:
  // The regions of a face of T2 are the regions of all faces of T1.
  void cut_at(Face_index f)
  {
    const Marks marks(Side::intrinsic, f, m_correspondence);
    const Face_map<FT, Marks> face_map(marks, m_correspondence.mesh(Side::input));
    for(std::size_t m = 0; m < face_map.regions().size(); ++m) {
      const auto region = face_map.region_map(m);
      if(m_side == Side::intrinsic)
        cut_at(f, region.first, region.second);
      else if(!m_segments[region.first.idx()].empty())
        cut_at(region.first, f, region.second.inverse());
    }
  }

  void cut_at(Face_index from, Face_index to, const Polygon_map<FT>& map)
  {
    for(const std::size_t i : m_segments[from.idx()])
      if(const auto [begin, end] = clipped(m_curve[i], map); begin <= end)
        m_parts.push_back({i, begin, end, to, map});
  }

  // Adds what is not there yet: sides of regions belong to two of them.
  void add(const Segment_part<FT>& part, FT& end, Surface_curve<FT>& result) const
  {
    const FT begin = (std::max)(part.begin, end);
    if(!(part.end > begin + rounding_unit<FT>()))
      return;
    const auto &p = m_curve[part.segment].source, &q = m_curve[part.segment].target;
    const auto at = [&](const FT& t) {
      return part.map(
        {(1 - t) * p[0] + t * q[0], (1 - t) * p[1] + t * q[1], (1 - t) * p[2] + t * q[2]});
    };
    result.push_back({part.face, at(begin), at(part.end)});
    end = part.end;
  }

  const Correspondence<Traits>& m_correspondence;
  Side m_side;
  const Surface_curve<FT>& m_curve;
  std::vector<std::vector<std::size_t>> m_segments; // of the curve in each face
  std::vector<Segment_part<FT>> m_parts;
};

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsCorrespondence
/// finds a curve of one triangulation on the other: its segments are cut at the edges of that.
/// Their order and directions stay. Parts of a length within rounding are left out.
/// \param correspondence the crossings of both
/// \param side the triangulation whose faces `curve` refers to
/// \param curve segments with barycentric coordinates that are not negative and sum up to one
template <typename Traits>
Surface_curve<typename Traits::FT> curve_across(const Correspondence<Traits>& correspondence,
                                                Side side,
                                                const Surface_curve<typename Traits::FT>& curve)
{
  return internal::Curve_cutter<Traits>(correspondence, side, curve)();
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CURVE_ACROSS_H
