// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_FLAT_POLYGONS_H
#define INTRINSIC_FLAT_POLYGONS_H

#include "reading/Polygon_soup.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_face_base_2.h>
#include <CGAL/Triangulation_data_structure_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <vector>

using Flat_point = Kernel::Point_2;
using Flat_points = std::vector<Flat_point>;
using Corners = std::array<std::size_t, 3>; // of a triangle, among those of its polygon
using Flat_triangulation = CGAL::Constrained_Delaunay_triangulation_2<
  Kernel, CGAL::Triangulation_data_structure_2<
            CGAL::Triangulation_vertex_base_with_info_2<std::size_t, Kernel>,
            CGAL::Constrained_triangulation_face_base_2<Kernel>>>;

// Returns the axes. The axis along which the polygon has the largest projection comes first.
inline std::array<int, 3> axes_by_area(const std::vector<Point>& points)
{
  std::array<double, 3> area{};
  for(std::size_t i = 1; i + 1 < points.size(); ++i)
    for(int x = 0; x < 3; ++x) {
      const auto v = points[i] - points[0], w = points[i + 1] - points[0];
      area[static_cast<std::size_t>(x)] += CGAL::cross_product(v, w)[x];
    }
  std::array<int, 3> result{0, 1, 2};
  std::stable_sort(result.begin(), result.end(), [&](int x, int y) {
    return std::abs(area[static_cast<std::size_t>(x)]) >
           std::abs(area[static_cast<std::size_t>(y)]);
  });
  return result;
}

// Returns the faces that an odd number of constraints separates from infinity, such as the faces
// inside a simple polygon.
inline std::vector<Corners> inner_faces(const Flat_triangulation& triangulation)
{
  std::map<Flat_triangulation::Face_handle, bool> is_inside{{triangulation.infinite_face(), false}};
  std::vector<Flat_triangulation::Face_handle> stack{triangulation.infinite_face()};
  while(!stack.empty()) {
    const auto f = stack.back();
    stack.pop_back();
    for(int i = 0; i < 3; ++i)
      if(is_inside.emplace(f->neighbor(i), is_inside.at(f) != f->is_constrained(i)).second)
        stack.push_back(f->neighbor(i));
  }
  std::vector<Corners> result;
  for(const auto f : triangulation.finite_face_handles())
    if(is_inside.at(f))
      result.push_back({f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info()});
  return result;
}

#endif // INTRINSIC_FLAT_POLYGONS_H
