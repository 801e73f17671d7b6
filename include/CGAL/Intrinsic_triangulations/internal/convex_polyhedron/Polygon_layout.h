// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CONVEX_POLYHEDRON_POLYGON_LAYOUT_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CONVEX_POLYHEDRON_POLYGON_LAYOUT_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Double_double.h>
#include <CGAL/Intrinsic_triangulations/Shortest_paths.h>
#include <CGAL/Intrinsic_triangulations/Surface_view.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/internal/convex_polyhedron/Metric_surface.h>
#include <CGAL/Intrinsic_triangulations/internal/convex_polyhedron/Precise_vector.h>
#include <CGAL/Intrinsic_triangulations/internal/convex_polyhedron/Pyramid_surface.h>
#include <CGAL/Intrinsic_triangulations/internal/convex_polyhedron/Radii.h>
#include <CGAL/Intrinsic_triangulations/named_parameters.h>
#include <CGAL/Intrinsic_triangulations/triangle_formulas.h>

#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Lays out a surface as a polygon with two sides in the plane z = 0.
//
// Folding a convex polygon flat lengthens no path. So the distance between two corners on the
// surface is their distance in the plane, and the distances from three corners determine all
// positions. Positions in a thin polygon have few digits. The digits suffice to find a
// triangulation without edges across the rim. The faces on its upper side then determine positions
// by their lengths.
class Polygon_layout
{
  typedef Double_double Number;

public:
  // If the weights are the squared distances from a point, all triangulations of both sides are
  // weighted Delaunay. Weights that are reduced by this fraction select one of them. The fraction
  // exceeds rounding, and is so small that thin polygons get no edges across the rim.
  static constexpr double less_weight = 0x1p-46;

  // \throws Numerical_error if the surface is too thin for the search for distances
  explicit Polygon_layout(const Metric_surface& surface)
    : m_surface(surface), m_positions(positions_by_distances())
  {
    for(int round = 0; round < rounds; ++round)
      m_exists = m_exists && triangulate() && lay_out();
  }

  // Returns whether all vertices lie on the upper side. This does not prove that the surface is a
  // polygon.
  bool exists() const { return m_exists; }
  // Returns the surface with a triangulation whose edges include the sides of the polygon.
  const Metric_surface& surface() const { return m_surface; }
  const std::vector<Precise_vector>& positions() const { return m_positions; }

private:
  // The second triangulation is computed from positions with all digits.
  static constexpr int rounds = 2;
  // Stops the search for distances on very thin surfaces.
  struct Window_limit
  {
    std::size_t rest;

    void after_windows(std::size_t number)
    {
      if(number > rest)
        throw Numerical_error("paths wind too often around the surface");
      rest -= number;
    }
  };

  const Delta_complex& mesh() const { return m_surface.mesh(); }

  std::vector<double> distances(std::size_t source) const
  {
    const auto length = boost::make_function_property_map<Edge_index>(
      [this](Edge_index e) { return m_surface.length_map()[e].high(); });
    Shortest_paths paths(Surface_view(mesh(), length));
    paths.add_source(Vertex_index(static_cast<Vertex_index::size_type>(source)));
    paths.run(
      parameters::visitor(Window_limit{(std::size_t(1) << 20) + 1024 * mesh().num_faces()}));
    std::vector<double> result;
    for(Vertex_index v : mesh().vertices())
      result.push_back(paths.distance(v));
    return result;
  }

  static std::size_t greatest(const std::vector<double>& values)
  {
    return static_cast<std::size_t>(std::max_element(values.begin(), values.end()) -
                                    values.begin());
  }

  // Returns positions such that two distant vertices lie on the x-axis. The vertex farthest from
  // the axis determines the signs of ordinates.
  std::vector<Precise_vector> positions_by_distances() const
  {
    const std::size_t a = greatest(distances(0));
    const std::vector<double> from_a = distances(a), from_b = distances(greatest(from_a));
    const double base = *std::max_element(from_a.begin(), from_a.end());
    std::vector<double> x, y;
    for(std::size_t v = 0; v < from_a.size(); ++v) {
      const double p = from_a[v], q = from_b[v];
      x.push_back((base + (p - q) * (p + q) / base) / 2);
      y.push_back(std::sqrt((std::max)(0., squared_quadrupled_area(base, p, q))) / (2 * base));
    }
    const std::size_t c = greatest(y);
    const std::vector<double> from_c = distances(c);
    std::vector<Precise_vector> result;
    for(std::size_t v = 0; v < x.size(); ++v) {
      const double above = std::hypot(x[v] - x[c], y[v] - y[c]),
                   below = std::hypot(x[v] - x[c], y[v] + y[c]);
      const bool is_above = std::abs(from_c[v] - above) <= std::abs(from_c[v] - below);
      result.push_back({x[v], is_above ? y[v] : -y[v], 0});
    }
    return result;
  }

  bool triangulate()
  {
    Precise_vector center{0, 0, 0};
    for(const Precise_vector& p : m_positions)
      center = center + p;
    center = Number(1 / static_cast<double>(m_positions.size())) * center;
    std::vector<Number> squares;
    for(const Precise_vector& p : m_positions)
      squares.push_back((1 - less_weight) * ((p - center) * (p - center)));
    return make_convex(m_surface, Radii(squares), 100 * std::size_t(mesh().num_edges()));
  }

  Number doubled_area(Face_index f) const
  {
    const auto h = sides(f, mesh());
    const auto at = [&](std::size_t k) { return m_positions[mesh().source(h[k]).idx()]; };
    return cross(at(1) - at(0), at(2) - at(0)).z;
  }

  // Lays out the faces of the upper side one after the other. Returns whether they contain all
  // vertices.
  bool lay_out()
  {
    const auto faces = mesh().faces();
    const Face_index first =
      *std::max_element(faces.begin(), faces.end(), [this](Face_index f, Face_index g) {
        return doubled_area(f) < doubled_area(g);
      });
    std::vector<bool> is_above(mesh().num_faces());
    for(Face_index f : faces)
      is_above[f.idx()] = doubled_area(f) > 0;
    std::vector<bool> is_placed(mesh().num_vertices(), false);
    const Halfedge_index h = mesh().halfedge(first);
    m_positions[mesh().source(h).idx()] = {0, 0, 0};
    m_positions[mesh().target(h).idx()] = {m_surface.length(h), 0, 0};
    is_placed[mesh().source(h).idx()] = is_placed[mesh().target(h).idx()] = true;
    std::vector<Halfedge_index> open{h};
    is_above[first.idx()] = false;
    for(std::size_t i = 0; i < open.size(); ++i) {
      place(open[i]);
      is_placed[mesh().target(mesh().next(open[i])).idx()] = true;
      for(Halfedge_index side : sides(mesh().face(open[i]), mesh()))
        if(const Halfedge_index o = opposite(side); is_above[mesh().face(o).idx()]) {
          is_above[mesh().face(o).idx()] = false;
          open.push_back(o);
        }
    }
    return std::find(is_placed.begin(), is_placed.end(), false) == is_placed.end();
  }

  // Positions the corner opposite to `h` on the left of `h`.
  void place(Halfedge_index h)
  {
    const Number a = m_surface.length(h), b = m_surface.length(mesh().next(h)),
                 c = m_surface.length(mesh().prev(h));
    const Precise_vector p = m_positions[mesh().source(h).idx()],
                         along = (1 / a) * (m_positions[mesh().target(h).idx()] - p);
    const Precise_vector across{Number(-1) * along.y, along.x, 0};
    m_positions[mesh().target(mesh().next(h)).idx()] =
      p + doubled_corner_product(b, a, c) / (2 * a) * along +
      quadrupled_area(a, b, c) / (2 * a) * across;
  }

  Metric_surface m_surface;
  std::vector<Precise_vector> m_positions;
  bool m_exists = true;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CONVEX_POLYHEDRON_POLYGON_LAYOUT_H
