// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "reading/Soup_repair.h"

#include "reading/close_points.h"

#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>

#include <algorithm>
#include <cstdint>
#include <numeric>

namespace PMP = CGAL::Polygon_mesh_processing;

namespace {

// Represents a corner of a polygon, which keeps its origin when CGAL renumbers its point.
class Corner
{
public:
  Corner() = default;
  Corner(Polygons::Index point, std::size_t origin)
    : m_point(point), m_origin(static_cast<Polygons::Index>(origin))
  {}

  Corner& operator=(std::size_t point)
  {
    m_point = static_cast<Polygons::Index>(point);
    return *this;
  }
  operator std::size_t() const { return m_point; }

  Polygons::Index origin() const { return m_origin; } // among those of all polygons of the input

  friend std::size_t hash_value(const Corner& c) { return c.m_point; }

private:
  Polygons::Index m_point = 0, m_origin = 0;
};

class Soup_repairer
{
public:
  explicit Soup_repairer(Polygon_soup& soup) : m_soup(soup)
  {
    std::size_t corner = 0;
    for(const Polygons::Polygon& p : soup.polygons) {
      m_polygons.emplace_back();
      for(const Polygons::Index v : p)
        m_polygons.back().emplace_back(v, corner++);
    }
  }

  Repair_report operator()(double distance)
  {
    const std::size_t welded = distance > 0 ? weld(m_soup.points, distance) : 0;
    note("points merged with one nearby", welded);
    note("points merged with an equal one",
         PMP::merge_duplicate_points_in_polygon_soup(m_soup.points, m_polygons) - welded);
    clean();
    orient();
    if(!m_soup.data.empty())
      carry_data();
    m_soup.polygons = polygons();
    return m_report;
  }

private:
  // Follows reversals by CGAL, which expects points as plain numbers. The data are stored
  // elsewhere, because visitors are copied.
  struct Reversal_follower : PMP::Default_orientation_visitor
  {
    Soup_repairer* repairer;
    std::size_t* count;

    Reversal_follower(Soup_repairer& r, std::size_t& c) : repairer(&r), count(&c) {}

    void polygon_orientation_reversed(std::size_t i)
    {
      ++*count;
      auto& polygon = repairer->m_polygons[i];
      std::reverse(polygon.begin(), polygon.end());
      repairer->m_soup.is_reversed.resize(repairer->m_polygons.size());
      repairer->m_soup.is_reversed[i].flip();
    }
  };

  void note(const char* what, std::size_t count)
  {
    if(count > 0)
      m_report.emplace_back(what, count);
  }

  Polygons polygons() const
  {
    Polygons result;
    for(const std::vector<Corner>& polygon : m_polygons)
      result.push_back(polygon);
    return result;
  }

  std::size_t number_of_corners() const
  {
    return std::accumulate(m_polygons.begin(), m_polygons.end(), std::size_t(0),
                           [](std::size_t n, const auto& polygon) { return n + polygon.size(); });
  }

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
    std::vector<std::vector<std::size_t>> polygons;
    for(const std::vector<Corner>& polygon : m_polygons)
      polygons.emplace_back(polygon.begin(), polygon.end());
    PMP::orient_polygon_soup(m_soup.points, polygons,
                             CGAL::parameters::visitor(Reversal_follower(*this, reversals)));
    for(std::size_t i = 0; i < polygons.size(); ++i)
      std::copy(polygons[i].begin(), polygons[i].end(), m_polygons[i].begin());
    note("faces reversed", reversals);
    note("points duplicated to make the surface manifold", m_soup.points.size() - points);
  }

  // Moves the data. Corners keep their data. A point gets the data of the first of its corners in
  // the input.
  void carry_data()
  {
    std::vector<Polygons::Index> origin(m_soup.points.size(), Polygons::none);
    for(const std::vector<Corner>& polygon : m_polygons)
      for(const Corner& c : polygon)
        origin[c] = (std::min)(origin[c], m_soup.polygons.corners()[c.origin()]);
    for(Point_function& f : m_soup.data.functions) {
      std::vector<double> values;
      for(const Polygons::Index v : origin)
        values.push_back(f.values[v]);
      f.values = std::move(values);
    }
    for(Corner_data& data : m_soup.data.corners) {
      Polygons numbers;
      for(const std::vector<Corner>& polygon : m_polygons) {
        for(const Corner& c : polygon)
          numbers.add_corner(data.polygons.corners()[c.origin()]);
        numbers.close();
      }
      data.polygons = std::move(numbers);
    }
    m_soup.data.groups.carry(m_polygons.size(), [&](std::size_t i) { return old_polygon(i); });
  }

  // Returns the polygon that contained the first corner of polygon `i`.
  std::int64_t old_polygon(std::size_t i) const
  {
    return m_soup.polygons.polygon_of_corner(m_polygons[i][0].origin());
  }

  Polygon_soup& m_soup;
  std::vector<std::vector<Corner>> m_polygons; // as CGAL wants them
  Repair_report m_report;
};

} // namespace

Repair_report repair(Polygon_soup& soup, double distance) { return Soup_repairer(soup)(distance); }
