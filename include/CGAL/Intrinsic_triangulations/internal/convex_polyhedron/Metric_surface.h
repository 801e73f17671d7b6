// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CONVEX_POLYHEDRON_METRIC_SURFACE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CONVEX_POLYHEDRON_METRIC_SURFACE_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Double_double.h>
#include <CGAL/Intrinsic_triangulations/Euclidean_geometry_traits.h>
#include <CGAL/Intrinsic_triangulations/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/Surface_view.h>
#include <CGAL/Intrinsic_triangulations/internal/convex_polyhedron/Angle_sum.h>
#include <CGAL/Intrinsic_triangulations/internal/convex_polyhedron/Resting_points.h>
#include <CGAL/Intrinsic_triangulations/triangle_formulas.h>
#include <CGAL/Intrinsic_triangulations/weighted_formulas.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Represents a closed surface that can be flipped, with twice the digits of `double`, and points in
// its faces that keep their positions.
class Metric_surface
{
public:
  typedef Double_double Number;
  typedef Delta_complex::Property_map<Edge_index, Number> Length_map;

  // `mesh` has lengths, see `stored_length_map()`, and no removed elements.
  explicit Metric_surface(const Delta_complex& mesh, Resting_points points = {})
    : m_mesh(mesh), m_length(stored_length_map<Number>(m_mesh)), m_points(std::move(points))
  {}
  Metric_surface(const Metric_surface& other) : Metric_surface(other.m_mesh, other.m_points) {}
  Metric_surface& operator=(const Metric_surface& other)
  {
    m_mesh = other.m_mesh;
    m_length = stored_length_map<Number>(m_mesh);
    m_points = other.m_points;
    return *this;
  }

  const Delta_complex& mesh() const { return m_mesh; }
  const Length_map& length_map() const { return m_length; }
  const Resting_points& points() const { return m_points; }
  const Number& length(Halfedge_index h) const { return m_length[m_mesh.edge(h)]; }
  Diamond<Number> diamond_at(Halfedge_index h) const { return diamond(m_length, h, m_mesh); }

  // Returns whether the edge of `h` can be flipped.
  bool is_flippable(Halfedge_index h) const
  {
    return flip_status(h, m_mesh) == Operation_status::possible &&
           cotangents_at_source(diamond_at(h)) > 0 &&
           cotangents_at_source(diamond_at(opposite(h))) > 0;
  }

  // Flips the edge of `h`.
  void flip(Halfedge_index h)
  {
    m_points.before_flip(h, diamond_at(h), m_mesh);
    const Number length = flipped_length(h);
    flip_edge(h, m_mesh);
    m_length[m_mesh.edge(h)] = length;
  }

  // Removes a flat vertex, which then rests in a face. Returns whether edges could be flipped such
  // that it has only three.
  bool remove_flat_vertex(Vertex_index v)
  {
    while(removal_status(v, m_mesh) != Operation_status::possible) {
      Halfedge_index h = most_convex_at(v);
      if(!h.is_valid())
        h = too_long_at(v);
      if(!h.is_valid())
        return false;
      flip(h);
    }
    remove_degree_3(v);
    return true;
  }

  // Numbers the remaining elements consecutively. Returns the old numbers of vertices.
  std::vector<Vertex_index> collect_garbage()
  {
    auto old = m_mesh.add_property_map<Vertex_index, Vertex_index>("v:old").first;
    auto points =
      m_mesh.add_property_map<Face_index, std::vector<Resting_points::Point>>("f:points").first;
    for(Vertex_index v : m_mesh.vertices())
      old[v] = v;
    for(Face_index f : m_mesh.faces())
      points[f] = m_points.in_face(f);
    m_mesh.collect_garbage();
    std::vector<Vertex_index> result;
    for(Vertex_index v : m_mesh.vertices())
      result.push_back(old[v]);
    m_points = {};
    for(Face_index f : m_mesh.faces())
      for(const Resting_points::Point& p : points[f])
        m_points.add(f, p);
    m_mesh.remove_property_map(old);
    m_mesh.remove_property_map(points);
    return result;
  }

  // Returns the curvatures of the vertices.
  std::vector<double> curvatures() const
  {
    std::vector<Angle_sum> angles(m_mesh.num_vertices());
    for(Halfedge_index h : m_mesh.halfedges()) {
      const Number a = length(m_mesh.next(h)), b = length(m_mesh.prev(h)), c = length(h);
      angles[m_mesh.source(h).idx()].add(doubled_corner_product(a, b, c), quadrupled_area(a, b, c));
    }
    std::vector<double> result;
    for(const Angle_sum& angle : angles)
      result.push_back(-angle.minus(1, 0));
    return result;
  }

private:
  // Rounding can cause this sine if a flat vertex lies on a straight line between neighbors.
  static constexpr double straight_tolerance = 1e-6;

  Number flipped_length(Halfedge_index h) const
  {
    return Euclidean_geometry_traits<Number>::Compute_flipped_length()(diamond_at(h));
  }

  // Returns the edge from `v` whose flip leaves the largest angles. It is an edge whose flip lowers
  // the degree of `v`; null if none of these can be flipped.
  Halfedge_index most_convex_at(Vertex_index v) const
  {
    Halfedge_index result;
    double greatest = 0;
    for_each_outgoing_halfedge(v, m_mesh, [&](Halfedge_index h) {
      if(flip_status(h, m_mesh) != Operation_status::possible || degree_change(h) >= 0)
        return;
      if(const double sine = least_sine(h); sine > greatest) {
        greatest = sine;
        result = h;
      }
    });
    return result;
  }

  // Returns the least sine of the angles that a flip of the edge of `h` leaves at its ends, zero if
  // it cannot be flipped. The triangle that the flip leaves at the source may have no area, because
  // the removal of the source deletes it. The other triangle stays.
  double least_sine(Halfedge_index h) const
  {
    const double at_source = sine_at_source(h);
    return at_source > -straight_tolerance
             ? (std::min)((std::max)(at_source, straight_tolerance), sine_at_source(opposite(h)))
             : 0;
  }

  // Returns an edge from `v` that a flip shortens, and that leaves the degree of `v`, or null. If
  // edges from `v` to itself cannot be flipped, such flips change their diamonds. They end, because
  // a surface has a finite number of straight edges up to any length.
  Halfedge_index too_long_at(Vertex_index v) const
  {
    Halfedge_index result;
    for_each_outgoing_halfedge(v, m_mesh, [&](Halfedge_index h) {
      if(is_flippable(h) && degree_change(h) == 0 && flipped_length(h) < length(h))
        result = h;
    });
    return result;
  }

  // Returns by how much a flip of the edge of `h` increases the degree of its source.
  int degree_change(Halfedge_index h) const
  {
    const Vertex_index v = m_mesh.source(h);
    const auto ends_at_v = [v](Vertex_index a, Vertex_index b) { return (a == v) + (b == v); };
    return ends_at_v(m_mesh.target(m_mesh.next(h)), m_mesh.target(m_mesh.next(opposite(h)))) -
           ends_at_v(v, m_mesh.target(h));
  }

  // Returns the sine of the angle of both faces of `h` at its source.
  double sine_at_source(Halfedge_index h) const
  {
    const Diamond<Number> d = diamond_at(h);
    return (cotangents_at_source(d) / (4 * d.ij * d.ij * d.ki * d.il)).high();
  }

  void remove_degree_3(Vertex_index v)
  {
    std::array<Halfedge_index, 3> outgoing;
    std::array<Number, 3> outgoing_length, side;
    Halfedge_index h = first_outgoing_halfedge(v, m_mesh);
    for(std::size_t s = 0; s < 3; ++s, h = next_around_source(h, m_mesh)) {
      outgoing[s] = h;
      outgoing_length[s] = length(h);
      side[s] = length(m_mesh.next(h));
    }
    const Halfedge_index first_side = m_mesh.next(outgoing[0]);
    const auto points = m_points.before_removal(v.idx(), outgoing, outgoing_length, side, m_mesh);
    const Face_index f = remove_degree_3_vertex(v, m_mesh);
    CGAL_assertion(m_mesh.halfedge(f) == first_side);
    m_mesh.set_halfedge(f, first_side);
    for(const Resting_points::Point& p : points)
      m_points.add(f, p);
  }

  Delta_complex m_mesh;
  Length_map m_length;
  Resting_points m_points;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CONVEX_POLYHEDRON_METRIC_SURFACE_H
