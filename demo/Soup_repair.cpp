// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Soup_repair.h"

#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>

namespace PMP = CGAL::Polygon_mesh_processing;

namespace {

class Soup_repairer
{
public:
  explicit Soup_repairer(Polygon_soup& soup) : m_soup(soup)
  {
    for(const Polygons::Polygon& p : soup.polygons)
      m_polygons.emplace_back(p.begin(), p.end());
  }

  Repair_report operator()()
  {
    note("points merged with an equal one",
         PMP::merge_duplicate_points_in_polygon_soup(m_soup.points, m_polygons));
    clean();
    orient();
    m_soup.polygons = polygons();
    if(has_polygons())
      triangulate();
    return m_report;
  }

private:
  // Counts elsewhere, for visitors are copied.
  struct Reversal_counter : PMP::Default_orientation_visitor
  {
    std::size_t* count;

    explicit Reversal_counter(std::size_t& c) : count(&c) {}

    void polygon_orientation_reversed(std::size_t) { ++*count; }
  };

  void note(const char* what, std::size_t count)
  {
    if(count > 0)
      m_report.emplace_back(what, count);
  }

  Polygons polygons() const
  {
    Polygons result;
    for(const std::vector<std::size_t>& polygon : m_polygons)
      result.push_back(polygon);
    return result;
  }

  std::size_t number_of_corners() const { return polygons().number_of_corners(); }

  void clean()
  {
    note("isolated points removed",
         PMP::remove_isolated_points_in_polygon_soup(m_soup.points, m_polygons));
    const std::size_t points = m_soup.points.size();
    const std::size_t faces = m_polygons.size();
    const std::size_t corners = number_of_corners();
    PMP::repair_polygon_soup(m_soup.points, m_polygons);
    // A pinched polygon becomes several.
    const std::size_t left = m_polygons.size();
    note("degenerate or duplicate faces removed", left < faces ? faces - left : 0);
    note("faces added by splitting pinched ones", left > faces ? left - faces : 0);
    note("corners of faces simplified", left == faces ? corners - number_of_corners() : 0);
    note("points without a face left removed", points - m_soup.points.size());
  }

  void orient()
  {
    const std::size_t points = m_soup.points.size();
    std::size_t reversals = 0;
    PMP::orient_polygon_soup(m_soup.points, m_polygons,
                             CGAL::parameters::visitor(Reversal_counter(reversals)));
    note("faces reversed", reversals);
    note("points duplicated to make the surface manifold", m_soup.points.size() - points);
  }

  bool has_polygons() const
  {
    return m_soup.polygons.number_of_corners() > 3 * m_soup.polygons.size();
  }

  void triangulate()
  {
    const std::size_t faces = m_soup.polygons.size();
    Mesh mesh = mesh_of(m_soup);
    PMP::triangulate_faces(mesh);
    m_soup.polygons = polygons_of(mesh, mesh.faces());
    note("triangles added by splitting polygons", m_soup.polygons.size() - faces);
  }

  Polygon_soup& m_soup;
  std::vector<std::vector<std::size_t>> m_polygons; // as CGAL wants them
  Repair_report m_report;
};

} // namespace

Repair_report repair(Polygon_soup& soup) { return Soup_repairer(soup)(); }
