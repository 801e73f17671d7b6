// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "page/View_page.h"

#include <CGAL/Intrinsic_triangulations/corner_formulas.h>
#include <CGAL/Intrinsic_triangulations/diagnose.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;

namespace {

// Returns the polygons with the same numbers. A polygon that cannot be drawn has no corners.
Polygons drawable(const Polygon_soup& soup)
{
  Polygons result;
  for(const Polygons::Polygon& p : soup.polygons) {
    const bool is_drawable = std::all_of(p.begin(), p.end(), [&](Polygons::Index i) {
      return i < soup.points.size() && std::isfinite(soup.points[i].x()) &&
             std::isfinite(soup.points[i].y()) && std::isfinite(soup.points[i].z());
    });
    if(is_drawable)
      result.push_back(p);
    else
      result.close();
  }
  return result;
}

// Returns the angles of the triangles.
std::vector<double> angles(const Output_mesh& mesh)
{
  std::vector<double> result;
  const auto length = [&](Polygons::Index i, Polygons::Index j) {
    return std::sqrt(CGAL::squared_distance(mesh.points[i], mesh.points[j]));
  };
  for(const Polygons::Polygon& p : mesh.polygons)
    for(std::size_t k = 0; k < 3 && p.size() == 3; ++k) {
      const Polygons::Index a = p[k], b = p[(k + 1) % 3], c = p[(k + 2) % 3];
      result.push_back(180 / IT::pi<double>() *
                       IT::corner_angle(length(b, c), length(c, a), length(a, b)));
    }
  return result;
}

// Returns the elements with a defect, if they can be drawn.
Surface_marks marks(const IT::Input_diagnosis& diagnosis, const IT::Defect_description& d,
                    const Output_mesh& mesh)
{
  Surface_marks result{d.name, d.is_fatal, {}, {}, {}};
  for(const IT::Input_diagnosis::Occurrence& o : diagnosis.occurrences(d.kind)) {
    const auto [v, w] = o.vertices;
    if(d.element == IT::Defect_element::EDGE && std::max(v, w) < mesh.points.size())
      result.lines.push_back(o.vertices);
    else if(d.element == IT::Defect_element::FACE)
      result.polygons.push_back(std::int64_t(o.face));
    else if(v < mesh.points.size())
      result.points.push_back(std::int64_t(v));
  }
  return result;
}

} // namespace

void show(View_page& page, const std::string& name, const Polygon_soup& soup)
{
  Output_mesh mesh;
  mesh.points = soup.points;
  mesh.polygons = drawable(soup);
  mesh.edges = edges_of(mesh.polygons);
  mesh.texture = texture_on(mesh.polygons, soup.data.corners);
  add_data(mesh, {soup.data.functions, {}, {}});
  page.add_surface(name, mesh);
  const IT::Input_diagnosis diagnosis = IT::diagnose_polygon_soup(
    soup.points, soup.polygons, (std::numeric_limits<std::size_t>::max)());
  for(const IT::Defect_description& d : IT::defect_descriptions)
    if(d.kind != IT::Defect_kind::SEVERAL_COMPONENTS)
      page.add_marks(marks(diagnosis, d, mesh));
  page.add_angles(name, angles(mesh));
}
