// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_CHARTS_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_CHARTS_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Planar_conformal_map.h>
#include <CGAL/Discrete_conformal_maps/internal/layout/Chart_packing.h>
#include <CGAL/Discrete_conformal_maps/internal/layout/Chart_pieces.h>
#include <CGAL/Discrete_conformal_maps/internal/layout/Convex_polygons.h>
#include <CGAL/Discrete_conformal_maps/internal/layout/Multiply_covered_area.h>
#include <CGAL/Discrete_conformal_maps/internal/tolerances.h>

#include <algorithm>
#include <complex>
#include <cstddef>
#include <deque>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace CGAL::Discrete_conformal_maps {

/// \ingroup PkgDiscreteConformalMapsFlat
/// two charts that overlap in the plane.
struct Overlapping_charts
{
  std::size_t first;  ///< the index of one chart
  std::size_t second; ///< the index of the other; the same if a chart overlaps itself
  double area;        ///< the sum of the areas that a face of one and a face of the other cover
};

/// \ingroup PkgDiscreteConformalMapsFlat
/// the overlaps of the image of a surface in the plane.
struct Chart_overlap
{
  std::size_t number_of_charts = 0;       ///< the number of charts
  double area = 0;                        ///< the area of the plane that is covered more than once
  std::vector<Overlapping_charts> charts; ///< the pairs of charts that overlap, in order
};

namespace internal {

// Grows charts face by face, across edges that are not seams, such that no chart has two faces that
// are kept apart. Charts are numbered in the order of their first faces.
class Chart_growth
{
public:
  typedef std::vector<std::pair<Face_index, Face_index>> Pairs;

  explicit Chart_growth(const Planar_conformal_map& map, const Pairs& apart = {})
    : m_map(map), m_partners(mesh().num_faces()), m_chart(mesh().num_faces(), none)
  {
    for(const auto& [f, g] : apart) {
      m_partners[f.idx()].push_back(g);
      m_partners[g.idx()].push_back(f);
    }
    for(Face_index f : mesh().faces())
      if(map.is_laid_out(f) && m_chart[f.idx()] == none) {
        grow(f);
        ++m_size;
      }
  }

  // Returns the number of charts.
  std::size_t size() const { return m_size; }

  // Returns the charts of the faces of T_3.
  const std::vector<std::size_t>& charts() const { return m_chart; }
  std::size_t chart(Face_index f) const { return m_chart[f.idx()]; }

private:
  static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();

  const Delta_complex& mesh() const { return m_map.ideal().mesh(); }

  // Grows a chart from `root` to all sides at once.
  void grow(Face_index root)
  {
    std::deque<Face_index> waiting{root};
    while(!waiting.empty()) {
      const Face_index f = waiting.front();
      waiting.pop_front();
      if(!can_be_added(f))
        continue;
      m_chart[f.idx()] = m_size;
      for(Halfedge_index h : sides(f, mesh()))
        if(!m_map.is_seam(Edge_index(h)))
          waiting.push_back(mesh().face(mesh().opposite(h)));
    }
  }

  bool can_be_added(Face_index f) const
  {
    const std::vector<Face_index>& partners = m_partners[f.idx()];
    return m_chart[f.idx()] == none &&
           std::none_of(partners.begin(), partners.end(),
                        [&](Face_index g) { return m_chart[g.idx()] == m_size; });
  }

  const Planar_conformal_map& m_map;
  std::vector<std::vector<Face_index>> m_partners; // faces that must not be in the chart of each
  std::vector<std::size_t> m_chart;                // of each face of T_3
  std::size_t m_size = 0;
};

} // namespace internal

/// \ingroup PkgDiscreteConformalMapsFlat
/// returns the index of the chart of each face of \f$T_3\f$ of `map` that is laid out. Faces that
/// are adjacent in the plane are in one chart. Complexity: linear.
inline std::vector<std::size_t> charts_of_faces(const Planar_conformal_map& map)
{
  return internal::Chart_growth(map).charts();
}

/// \ingroup PkgDiscreteConformalMapsFlat
/// determines the overlaps of the image of the input in the plane. Intersections of faces are
/// computed in floating point. An intersection of less than \f$10^{-9}\f$ of the smaller face
/// counts as rounding.
///
/// Complexity: \f$O((n + k) \log n)\f$ for \f$n\f$ faces, and \f$k\f$ pairs of faces whose bounding
/// boxes intersect.
/// \pre `map.is_laid_out()`
inline Chart_overlap find_overlap(const Planar_conformal_map& map)
{
  const internal::Chart_pieces pieces(map);
  const std::vector<internal::Chart_pieces::Overlap> overlaps = pieces.overlaps();
  const internal::Chart_growth charts(map);
  const std::vector<std::size_t>& chart = charts.charts();
  Chart_overlap result;
  result.number_of_charts = charts.size();
  std::map<std::pair<std::size_t, std::size_t>, double> area;
  std::vector<internal::Multiply_covered_area::Pair> pairs;
  for(const auto& o : overlaps) {
    pairs.emplace_back(o.first, o.second);
    const auto [first, second] =
      std::minmax(chart[pieces[o.first].face.idx()], chart[pieces[o.second].face.idx()]);
    area[{first, second}] += o.area;
  }
  for(const auto& [pair, sum] : area)
    result.charts.push_back({pair.first, pair.second, sum});
  std::vector<internal::Convex_polygon> polygons;
  for(std::size_t n = 0; n < pieces.size(); ++n)
    polygons.push_back(pieces[n].polygon);
  result.area = internal::Multiply_covered_area(polygons, pairs)();
  return result;
}

/// \ingroup PkgDiscreteConformalMapsFlat
/// moves the charts of a map beside each other. Each lies in the smallest rectangle that contains
/// it, and these rectangles do not overlap. `flatten()` packs components in this way. Complexity:
/// \f$O(n \log n)\f$.
/// \pre `map.is_laid_out()`
inline void pack_charts(Planar_conformal_map& map)
{
  const internal::Chart_pieces pieces(map);
  const std::vector<std::size_t> chart = charts_of_faces(map);
  std::vector<internal::Hull_points> points;
  for(std::size_t n = 0; n < pieces.size(); ++n) {
    const std::size_t c = chart[pieces[n].face.idx()];
    points.resize((std::max)(points.size(), c + 1));
    for(const std::complex<double>& z : pieces[n].polygon)
      points[c].add(z);
  }
  const internal::Chart_packing packing(points);
  const Delta_complex& mesh = map.ideal().mesh();
  map.transform([&](Halfedge_index h, const std::complex<double>& z) {
    const std::size_t c = chart[mesh.face(h).idx()];
    return c < points.size() ? packing.motion(c)(z) : z;
  });
}

/// \ingroup PkgDiscreteConformalMapsFlat
/// cuts a map such that no chart overlaps itself, and packs the charts. Faces are added to a chart,
/// across edges that are no seams, unless they overlap one of its faces. The edges between charts
/// become seams. A map without overlap does not change. Complexity: as for `find_overlap()`.
/// \returns the number of charts
/// \pre `map.is_laid_out()`
inline std::size_t cut_overlaps(Planar_conformal_map& map)
{
  const internal::Chart_pieces pieces(map);
  const std::vector<internal::Chart_pieces::Overlap> overlaps = pieces.overlaps();
  internal::Chart_growth::Pairs faces;
  for(const auto& o : overlaps)
    faces.emplace_back(pieces[o.first].face, pieces[o.second].face);
  const internal::Chart_growth charts(map, faces);
  if(faces.empty())
    return charts.size();
  const Delta_complex& mesh = map.ideal().mesh();
  map.add_seams([&](Edge_index e) {
    const Halfedge_index h = mesh.halfedge(e);
    return charts.chart(mesh.face(h)) != charts.chart(mesh.face(mesh.opposite(h)));
  });
  pack_charts(map);
  return charts.size();
}

/// \ingroup PkgDiscreteConformalMapsFlat
/// moves and scales the image of a map such that it lies in the unit square. Up to rounding it
/// touches the lower, left, and one other side. Scale factors do not change. Complexity: linear.
/// \returns the factor
/// \pre `map.is_laid_out()`
inline double fit_into_unit_square(Planar_conformal_map& map)
{
  const internal::Chart_pieces pieces(map);
  Bbox_2 box;
  for(std::size_t n = 0; n < pieces.size(); ++n)
    box += internal::bounding_box(pieces[n].polygon);
  const double size = (std::max)(box.xmax() - box.xmin(), box.ymax() - box.ymin());
  if(!(size > 0))
    return 1;
  // Rounding of images must not move them out of the square.
  const double margin = internal::tolerance::margin_of_square * size,
               factor = 1 / (size + 2 * margin);
  const std::complex<double> corner(box.xmin() - margin, box.ymin() - margin);
  map.transform([&](Halfedge_index, const std::complex<double>& z) { return z - corner; });
  map.scale(factor);
  return factor;
}

} // namespace CGAL::Discrete_conformal_maps

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_CHARTS_H
