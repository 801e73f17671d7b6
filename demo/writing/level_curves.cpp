// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "writing/level_curves.h"

#include "reading/surface_points.h"

#include <CGAL/Intrinsic_triangulations/Correspondence.h>
#include <CGAL/Intrinsic_triangulations/curve_across.h>
#include <CGAL/Intrinsic_triangulations/level_set.h>

namespace IT = CGAL::Intrinsic_triangulations;

namespace {

void add_line(const IT::Surface_curve<double>& curve, bool is_closed, const Mesh& input,
              Output_mesh& result)
{
  if(curve.empty())
    return;
  const auto first = static_cast<Polygons::Index>(result.points.size());
  result.points.push_back(position({curve.front().face, curve.front().source}, input));
  result.lines.add_corner(first);
  for(std::size_t i = 0; i < curve.size(); ++i) {
    const auto before = static_cast<Polygons::Index>(first + i);
    const bool is_end = is_closed && i + 1 == curve.size();
    if(!is_end)
      result.points.push_back(position({curve[i].face, curve[i].target}, input));
    result.edges.push_back({before, is_end ? first : before + 1});
    result.lines.add_corner(is_end ? first : before + 1);
  }
  result.lines.close();
}

} // namespace

Output_mesh level_curves(const Triangulation& triangulation, const Mesh& input,
                         const std::vector<double>& values, const std::vector<double>& levels)
{
  const IT::Correspondence correspondence(triangulation);
  const auto surface = triangulation.intrinsic();
  Output_mesh result;
  std::vector<double> of_lines, of_edges;
  for(const double level : levels)
    for(const auto& path : IT::level_set(surface, values, level)) {
      const auto curve = IT::curve_across(correspondence, IT::Side::intrinsic,
                                          IT::curve_through(surface, path.places));
      add_line(curve, IT::halfedge_of(path.places.front()) == IT::halfedge_of(path.places.back()),
               input, result);
      of_lines.resize(result.lines.size(), level);
      of_edges.resize(result.edges.size(), level);
    }
  result.line_data.push_back({"level", std::move(of_lines)});
  result.edge_data.push_back({"level", std::move(of_edges)});
  return result;
}
