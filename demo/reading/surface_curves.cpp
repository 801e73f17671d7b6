// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "reading/surface_curves.h"

#include "Program_error.h"
#include "reading/format_readers.h"
#include "reading/surface_points.h"

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Shortest_paths.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;

namespace {

struct Polylines
{
  std::vector<Point> points;
  Polygons lines;
};

// Joins edges at points that exactly two edges share. The first edge of a polyline determines its
// direction.
class Joined_edges
{
public:
  Joined_edges(const Polygons& edges, std::size_t number_of_points)
    : m_edges(edges), m_at(number_of_points), m_is_used(edges.size(), false)
  {
    for(std::size_t e = 0; e < edges.size(); ++e)
      for(const Polygons::Index v : edges[e]) {
        Edges_at& at = m_at[v];
        at.sum ^= e;
        ++at.count;
      }
  }

  Polygons operator()()
  {
    Polygons result;
    for(std::size_t e = 0; e < m_edges.size(); ++e)
      if(!m_is_used[e]) {
        const std::vector<Polygons::Index> after = points_beyond(e, m_edges[e][1]),
                                           before = points_beyond(e, m_edges[e][0]);
        std::for_each(before.rbegin(), before.rend(), [&](auto v) { result.add_corner(v); });
        result.push_back(after);
      }
    return result;
  }

private:
  struct Edges_at
  {
    std::size_t sum = 0; // of two, the exclusive or with one gives the other
    std::size_t count = 0;
  };

  // Returns an end of an edge and the points that follow, as long as they are unique.
  std::vector<Polygons::Index> points_beyond(std::size_t e, Polygons::Index v)
  {
    std::vector<Polygons::Index> result{v};
    m_is_used[e] = true;
    for(; m_at[v].count == 2 && !m_is_used[e ^ m_at[v].sum]; result.push_back(v)) {
      e ^= m_at[v].sum;
      m_is_used[e] = true;
      v = m_edges[e][m_edges[e][0] == v ? 1 : 0];
    }
    return result;
  }

  const Polygons& m_edges;
  std::vector<Edges_at> m_at;
  std::vector<bool> m_is_used;
};

void read_points_and_lines(Scanner& in, Polygon_soup& soup, Polygons& lines)
{
  const File_format format = file_format(in);
  if(format == File_format::OBJ)
    read_obj(in, soup, &lines);
  else if(format == File_format::PLY) {
    Polygons edges;
    read_ply(in, soup, &edges);
    lines = Joined_edges(edges, soup.points.size())();
  } else if(format == File_format::VTP)
    read_vtp(in, soup, &lines);
  else if(format == File_format::XYZ) {
    read_xyz(in, soup);
    for(std::size_t i = 0; i < soup.points.size(); ++i)
      lines.add_corner(i);
    lines.close();
  } else
    in.fail_as_a_whole("curves are read from .obj, .ply, .vtp and .xyz");
}

Polylines read_polylines(const std::string& path)
{
  Scanner in(path);
  Polygon_soup soup;
  Polygons lines;
  read_points_and_lines(in, soup, lines);
  for(const Polygons::Polygon& line : lines)
    if(line.size() < 2)
      in.fail_as_a_whole("a polyline has less than two points");
  if(lines.empty())
    in.fail_as_a_whole("has no polylines (elements l of .obj, edges of .ply, Lines of .vtp)");
  return {soup.points, lines};
}

class Curves_builder
{
public:
  Curves_builder(const std::string& path, const Mesh& mesh, const Triangulation& triangulation)
    : m_path(path),
      m_mesh(mesh),
      m_finder(mesh),
      m_triangulation(triangulation),
      m_input(read_polylines(path))
  {}

  Curves_on_surface operator()()
  {
    Curves_on_surface result{{}, m_input.lines.size(), m_input.lines.number_of_corners(), 0};
    for(const Polygons::Polygon& line : m_input.lines) {
      Surface_location previous;
      for(std::size_t i = 0; i < line.size(); ++i) {
        const Surface_location p = location(line[i], result);
        if(i > 0)
          join(previous, p, line[i], result);
        previous = p;
      }
    }
    return result;
  }

private:
  [[noreturn]] void fail(Polygons::Index i, const std::string& what) const
  {
    throw Program_error(m_path + ": point " + std::to_string(i + 1) + " " + what);
  }

  Surface_location location(Polygons::Index i, Curves_on_surface& result)
  {
    const Point& p = m_input.points[i];
    if(!std::isfinite(p.x()) || !std::isfinite(p.y()) || !std::isfinite(p.z()))
      fail(i, "has a coordinate that is not finite; correct it in the file");
    const Surface_location q = m_finder(p);
    const double distance = std::sqrt(CGAL::squared_distance(p, position(q, m_mesh)));
    if(!(distance <= m_finder.tolerance()))
      fail(i, "is " + std::to_string(distance) + " away from the surface, more than " +
                std::to_string(m_finder.tolerance()) + "; move it there");
    result.greatest_distance = (std::max)(result.greatest_distance, distance);
    return q;
  }

  // Joins two points, straight within a face, otherwise along the shortest path.
  void join(const Surface_location& p, const Surface_location& q, Polygons::Index i,
            Curves_on_surface& result) const
  {
    const auto surface = m_triangulation.input();
    std::vector<IT::Surface_point<double>> points{IT::surface_point(p, surface.mesh()),
                                                  IT::surface_point(q, surface.mesh())};
    if(IT::internal::segment_between(surface, points[0], points[1]).face ==
       IT::Delta_complex::null_face()) {
      points = IT::shortest_path(surface, p, q).places;
      if(points.empty())
        fail(i, "is not connected to the one before; cut the curve between them");
    }
    const auto part = IT::curve_through(surface, points);
    result.segments.insert(result.segments.end(), part.begin(), part.end());
  }

  const std::string& m_path;
  const Mesh& m_mesh;
  Point_finder m_finder;
  const Triangulation& m_triangulation;
  Polylines m_input;
};

} // namespace

Curves_on_surface read_curves(const std::string& path, const Mesh& mesh,
                              const Triangulation& triangulation)
{
  return Curves_builder(path, mesh, triangulation)();
}
