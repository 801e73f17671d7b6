// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_LAYOUT_CHART_PIECES_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_LAYOUT_CHART_PIECES_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Planar_conformal_map.h>
#include <CGAL/Discrete_conformal_maps/internal/layout/Chart_packing.h>
#include <CGAL/Discrete_conformal_maps/internal/layout/Convex_polygons.h>
#include <CGAL/Discrete_conformal_maps/internal/tolerances.h>

#include <CGAL/Bbox_2.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

// Stores the image of the input in the plane as convex polygons. A face of T_3 that belongs to the
// input as a whole is one polygon. Other faces contribute the parts that belong to the input.
// Polygons whose area has vanished by rounding are omitted.
class Chart_pieces
{
public:
  struct Piece
  {
    Face_index face; // the face of T_3
    Convex_polygon polygon;
    double area;
  };

  // Stores two pieces in the order of their indices, and the area that both cover.
  struct Overlap
  {
    std::size_t first, second;
    double area;
  };

  explicit Chart_pieces(const Planar_conformal_map& map) : m_map(map)
  {
    const Delta_complex& mesh = map.ideal().mesh();
    std::vector<char> is_whole(mesh.num_faces(), 1);
    const auto& subdivision = map.subdivision();
    for(Face_index f : subdivision.mesh().faces())
      if(!map.is_original(subdivision.parent_face(Layer::A, f)))
        is_whole[subdivision.parent_face(Layer::C, f).idx()] = 0;
    for(Face_index f : mesh.faces())
      if(map.is_laid_out(f) && is_whole[f.idx()])
        add(f, whole(f));
    for(Face_index f : subdivision.mesh().faces())
      if(const Face_index on_C = subdivision.parent_face(Layer::C, f);
         !is_whole[on_C.idx()] && map.is_original(subdivision.parent_face(Layer::A, f)))
        add(on_C, part(f));
  }

  std::size_t size() const { return m_pieces.size(); }
  const Piece& operator[](std::size_t n) const { return m_pieces[n]; }

  // Returns the pairs that overlap by more than rounding error, in order. Complexity: O(n log n)
  // for n pieces, plus the number of pairs with intersecting bounding boxes.
  std::vector<Overlap> overlaps() const
  {
    typedef Box_intersection_d::Box_with_info_d<double, 2, std::size_t> Box;
    std::vector<Box> boxes;
    Bbox_2 all;
    for(std::size_t n = 0; n < size(); ++n) {
      boxes.emplace_back(bounding_box(m_pieces[n].polygon), n);
      all += boxes.back().bbox();
    }
    const double rounding = 64 * std::numeric_limits<double>::epsilon() *
                            (std::max)({std::abs(all.xmin()), std::abs(all.xmax()),
                                        std::abs(all.ymin()), std::abs(all.ymax())});
    std::vector<Overlap> result;
    box_self_intersection_d(boxes.begin(), boxes.end(), [&](const Box& a, const Box& b) {
      const std::size_t i = (std::min)(a.info(), b.info()), j = (std::max)(a.info(), b.info());
      if(m_pieces[i].face == m_pieces[j].face ||
         separates(m_pieces[i].polygon, m_pieces[j].polygon) ||
         separates(m_pieces[j].polygon, m_pieces[i].polygon))
        return;
      const double area = signed_area(intersection(m_pieces[i].polygon, m_pieces[j].polygon));
      const Bbox_2 one = a.bbox();
      const double extent = (std::max)(one.xmax() - one.xmin(), one.ymax() - one.ymin());
      if(area > (std::max)(tolerance::overlap * (std::min)(m_pieces[i].area, m_pieces[j].area),
                           rounding * extent))
        result.push_back({i, j, area});
    });
    std::sort(result.begin(), result.end(), [](const Overlap& a, const Overlap& b) {
      return std::pair(a.first, a.second) < std::pair(b.first, b.second);
    });
    return result;
  }

private:
  void add(Face_index f, Convex_polygon polygon)
  {
    const double area = signed_area(polygon);
    if(area > 0)
      m_pieces.push_back({f, std::move(polygon), area});
  }

  Convex_polygon whole(Face_index f) const
  {
    Convex_polygon result;
    for(Halfedge_index h : sides(f, m_map.ideal().mesh()))
      result.push_back(m_map.position(h));
    return result;
  }

  // Returns the part of a face. If corners coincide up to rounding, they are not in convex
  // position, so the convex hull of the corners is returned.
  Convex_polygon part(Face_index f) const
  {
    Convex_polygon result;
    const auto& mesh = m_map.subdivision().mesh();
    for(Halfedge_index h : CGAL::halfedges_around_face(mesh.halfedge(f), mesh))
      result.push_back(m_map.image(h));
    return convex_hull(std::move(result));
  }

  const Planar_conformal_map& m_map;
  std::vector<Piece> m_pieces;
};

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_LAYOUT_CHART_PIECES_H
