// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "reading/Soup_repair.h"

#include "reading/close_points.h"
#include "reading/polygons_with_holes.h"

#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

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
    const std::size_t equal =
      PMP::merge_duplicate_points_in_polygon_soup(m_soup.points, m_polygons) - welded;
    note("points merged with an equal one", equal);
    const std::size_t place = m_report.size() - 1;
    clean();
    const std::size_t kept = orient(equal);
    m_report[place].second -= kept;
    if(!m_soup.data.empty())
      carry_data();
    m_soup.polygons = polygons();
    m_report.erase(std::remove_if(m_report.begin(), m_report.end(),
                                  [](const auto& done) { return done.second == 0; }),
                   m_report.end());
    return m_report;
  }

private:
  // Follows reversals by CGAL, which expects points as plain numbers. The data are stored
  // elsewhere, because visitors are copied.
  struct Reversal_follower : PMP::Default_orientation_visitor
  {
    std::vector<char>* is_reversed;

    explicit Reversal_follower(std::vector<char>& r) : is_reversed(&r) {}

    void polygon_orientation_reversed(std::size_t i) { (*is_reversed)[i] ^= 1; }
  };

  void note(const char* what, std::size_t count) { m_report.emplace_back(what, count); }

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
    split_keyholes();
    note("isolated points removed",
         PMP::remove_isolated_points_in_polygon_soup(m_soup.points, m_polygons));
    const std::size_t points = m_soup.points.size();
    const std::size_t faces = m_polygons.size();
    const std::size_t corners = number_of_corners();
    PMP::repair_polygon_soup(m_soup.points, m_polygons,
                             CGAL::parameters::require_same_orientation(true));
    remove_opposite_faces();
    // A pinched polygon becomes several.
    const std::size_t left = m_polygons.size();
    note("degenerate or duplicate faces removed", left < faces ? faces - left : 0);
    note("faces added by splitting pinched ones", left > faces ? left - faces : 0);
    note("corners of faces simplified", left == faces ? corners - number_of_corners() : 0);
    note("points without a face left removed", points - m_soup.points.size());
  }

  // Replaces polygons with holes by triangles. Otherwise they would be split where they are
  // pinched, into an outer part and the reversed holes.
  void split_keyholes()
  {
    std::vector<std::vector<Corner>> result;
    std::size_t count = 0;
    for(std::vector<Corner>& polygon : m_polygons) {
      const std::vector<std::size_t> vertices(polygon.begin(), polygon.end());
      std::vector<std::array<std::size_t, 3>> triangles;
      if(std::set<std::size_t>(vertices.begin(), vertices.end()).size() < vertices.size())
        triangles = triangles_of_keyhole(vertices, points_of(vertices));
      for(const auto& [a, b, c] : triangles)
        result.push_back({polygon[a], polygon[b], polygon[c]});
      if(triangles.empty())
        result.push_back(std::move(polygon));
      else
        ++count;
    }
    m_polygons = std::move(result);
    note("polygons with holes split into triangles", count);
  }

  std::vector<Point> points_of(const std::vector<std::size_t>& vertices) const
  {
    std::vector<Point> result;
    for(const std::size_t v : vertices)
      result.push_back(m_soup.points[v]);
    return result;
  }

  typedef std::vector<std::size_t> Cycle;

  // Returns the points of a polygon, from the least one on, toward its lesser neighbor.
  static Cycle undirected_cycle(const std::vector<Corner>& polygon)
  {
    Cycle result(polygon.begin(), polygon.end());
    std::rotate(result.begin(), std::min_element(result.begin(), result.end()), result.end());
    if(result.size() > 1 && result.back() < result[1])
      std::reverse(result.begin() + 1, result.end());
    return result;
  }

  // Removes the later one of two faces with the same points. They stay if no other face has any of
  // their sides: such faces are the two sides of a polygon, a closed surface.
  void remove_opposite_faces()
  {
    std::vector<std::pair<Cycle, std::size_t>> faces;
    for(std::size_t i = 0; i < m_polygons.size(); ++i)
      faces.emplace_back(undirected_cycle(m_polygons[i]), i);
    std::sort(faces.begin(), faces.end());
    std::vector<std::size_t> twins;
    for(std::size_t i = 0; i + 1 < faces.size(); ++i)
      if(faces[i].first == faces[i + 1].first)
        twins.push_back(faces[i + 1].second);
    if(twins.empty())
      return;
    const auto count = faces_at_sides();
    for(const std::size_t i : twins)
      if(has_other_faces(m_polygons[i], count))
        m_polygons[i].clear();
    m_polygons.erase(std::remove_if(m_polygons.begin(), m_polygons.end(),
                                    [](const auto& polygon) { return polygon.empty(); }),
                     m_polygons.end());
  }

  // Calls `f(side)` with the ends of each side, the lesser first.
  template <class Polygon, class Function>
  static void for_each_side(const Polygon& polygon, const Function& f)
  {
    for(std::size_t c = 0; c < polygon.size(); ++c)
      f(std::minmax({std::size_t(polygon[c]), std::size_t(polygon[(c + 1) % polygon.size()])}));
  }

  typedef std::map<std::pair<std::size_t, std::size_t>, std::size_t> Side_counts;

  Side_counts faces_at_sides() const
  {
    Side_counts result;
    for(const auto& polygon : m_polygons)
      for_each_side(polygon, [&](const auto& side) { ++result[side]; });
    return result;
  }

  static bool has_other_faces(const std::vector<Corner>& polygon, const Side_counts& count)
  {
    bool result = false;
    for_each_side(polygon, [&](const auto& side) { result |= count.at(side) > 2; });
    return result;
  }

  // Orients faces and duplicates points. Returns how many of `equal` merged points are apart again.
  std::size_t orient(std::size_t equal)
  {
    const std::size_t points = m_soup.points.size();
    std::vector<char> is_reversed(m_polygons.size(), 0);
    std::vector<Cycle> polygons;
    for(const std::vector<Corner>& polygon : m_polygons)
      polygons.emplace_back(polygon.begin(), polygon.end());
    PMP::orient_polygon_soup(m_soup.points, polygons,
                             CGAL::parameters::visitor(Reversal_follower(is_reversed)));
    choose_sides(polygons, is_reversed);
    const auto reversals =
      static_cast<std::size_t>(std::count(is_reversed.begin(), is_reversed.end(), 1));
    for(std::size_t i = 0; i < is_reversed.size(); ++i)
      if(is_reversed[i]) {
        std::reverse(m_polygons[i].begin(), m_polygons[i].end());
        m_soup.is_reversed.resize(m_polygons.size());
        m_soup.is_reversed[i].flip();
      }
    const std::size_t apart =
      equal == 0 ? 0 : (std::min)(equal, points_apart_again(polygons, points));
    for(std::size_t i = 0; i < polygons.size(); ++i)
      std::copy(polygons[i].begin(), polygons[i].end(), m_polygons[i].begin());
    note("faces reversed", reversals);
    note("points duplicated to make the surface manifold", m_soup.points.size() - points - apart);
    return apart;
  }

  // Counts what decides about the orientation of a component.
  struct Side_choice
  {
    std::ptrdiff_t excess = 0;         // of reversed polygons
    std::ptrdiff_t boundary_edges = 0; // the sides with one polygon
    double volume = 0;                 // six times the enclosed volume

    bool is_wrong() const { return excess > 0 || (excess == 0 && !boundary_edges && volume < 0); }
  };

  // Reverses components of which more than half has been reversed, so that few faces are. If half
  // of a closed component has been reversed, its normals point outward.
  void choose_sides(std::vector<Cycle>& polygons, std::vector<char>& is_reversed) const
  {
    boost::disjoint_sets_with_storage<> components(polygons.size());
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> polygon_at;
    std::vector<std::ptrdiff_t> boundary_edges(polygons.size(), 0);
    for(std::size_t i = 0; i < polygons.size(); ++i)
      for_each_side(polygons[i], [&](const auto& side) {
        const auto [found, is_new] = polygon_at.emplace(side, i);
        components.union_set(i, found->second);
        boundary_edges[i] += is_new ? 1 : -1;
      });
    std::vector<Side_choice> choices(polygons.size());
    for(std::size_t i = 0; i < polygons.size(); ++i) {
      const std::size_t c = components.find_set(i);
      choices[c].excess += is_reversed[i] ? 1 : -1;
      choices[c].boundary_edges += boundary_edges[i];
      choices[c].volume += volume_below(polygons[i], m_soup.points[polygons[c].front()]);
    }
    for(std::size_t i = 0; i < polygons.size(); ++i)
      if(choices[components.find_set(i)].is_wrong()) {
        std::reverse(polygons[i].begin(), polygons[i].end());
        is_reversed[i] ^= 1;
      }
  }

  // Returns six times the volume of the pyramid from the polygon to `apex`; negative if the normal
  // points to the apex.
  double volume_below(const Cycle& polygon, const Point& apex) const
  {
    double result = 0;
    const auto to = [&](std::size_t c) { return m_soup.points[polygon[c]] - apex; };
    for(std::size_t c = 1; c + 1 < polygon.size(); ++c)
      result += CGAL::determinant(to(0), to(c), to(c + 1));
    return result;
  }

  // Returns how many points of the input that are one of the first `n` points were merged, but are
  // several points of `polygons`.
  std::size_t points_apart_again(const std::vector<Cycle>& polygons, std::size_t n) const
  {
    std::vector<std::set<std::size_t>> before(n), after(n);
    for(std::size_t i = 0; i < polygons.size(); ++i)
      for(std::size_t c = 0; c < polygons[i].size(); ++c) {
        const Corner& corner = m_polygons[i][c];
        before[corner].insert(m_soup.polygons.corners()[corner.origin()]);
        after[corner].insert(polygons[i][c]);
      }
    std::size_t result = 0;
    for(std::size_t v = 0; v < n; ++v)
      result += (std::max)((std::min)(before[v].size(), after[v].size()), std::size_t(1)) - 1;
    return result;
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
