// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INSERTION_ROUNDED_INSERTION_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INSERTION_ROUNDED_INSERTION_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Edge_point.h>
#include <CGAL/Intrinsic_triangulations/Flat_face.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/corner_formulas.h>
#include <CGAL/Intrinsic_triangulations/internal/insertion/inserted_outgoing_halfedges.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Edge_courses.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Face_map.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Face_marks.h>
#include <CGAL/Intrinsic_triangulations/tolerances.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cstddef>
#include <optional>

namespace CGAL::Intrinsic_triangulations::internal {

// Locates a point of a face of T2 among the edges of T1 that cross it, by their rounded marks.
template <typename Traits>
class Rounded_location
{
  typedef Intrinsic_triangulation<Traits> Triangulation;
  typedef typename Traits::FT FT;
  typedef Face_marks<Traits> Marks;
  typedef Face_regions::Curve Curve;
  typedef Barycentric_coordinates<FT> Coordinates;
  typedef Point_to_insert<FT> Point;

public:
  Rounded_location(const Triangulation& tri, const Marks& marks, const Face_location<FT>& p)
    : m_tri(tri),
      m_marks(marks),
      m_p(p),
      m_map(marks, tri.input_mesh()),
      m_region(m_map.region_of(p.second))
  {}

  // Returns the side from which regions are counted.
  Halfedge_index first_side() const { return m_marks.side(0); }
  // Returns the halfedge of T1 that leaves the face at a mark.
  Halfedge_index outward(const Region_corner& mark) const
  {
    return m_marks.across(mark.side, mark.mark).halfedge;
  }
  const Face_regions& regions() const { return m_map.regions(); }
  std::size_t region() const { return m_region; }

  // Returns the distance of the point from the curve between two corners of its region.
  FT distance(const Region_corner& from, const Region_corner& to) const
  {
    const Coordinates a = m_map.coordinates(from), b = m_map.coordinates(to);
    const auto side = side_lengths(first_side(), m_tri.intrinsic());
    const FT area = quadrupled_area(side[0], side[1], side[2]) / 2;
    const FT length = m_tri.traits().compute_distance_object()(side, a, b);
    return CGAL::abs(orientation(a, b, m_p.second)) * area / length;
  }

  std::optional<Point> inside() const
  {
    const auto [f, map] = m_map.region_map(m_region);
    return Point{Face_location<FT>(f, map(m_p.second)), m_p};
  }

  // Returns the nearest point of the curve, for the distance on the surface. In a thin face, any
  // other distance would turn rounding errors across the curve into errors along it.
  std::optional<Point> on_curve(const Region_corner& from, const Region_corner& to) const
  {
    const Curve curve = regions().curve(from, to);
    const Coordinates begin = m_map.coordinates(curve.other), end = m_map.coordinates(curve.mark);
    const Flat_face<FT> face(first_side(), m_tri);
    const auto chord = face.between(begin, end);
    const FT square = dot(chord, chord);
    const FT t = square > 0 ? dot(chord, face.between(begin, m_p.second)) / square : FT(0);
    Coordinates foot;
    for(std::size_t s = 0; s < 3; ++s)
      foot[s] = begin[s] + t * (end[s] - begin[s]);
    const Edge_point<FT> across = m_marks.across(curve.mark.side, curve.mark.mark);
    const FT start = other_end(curve, across.halfedge);
    return Point{edge_location(Edge_point<FT>{across.halfedge, start + t * (across.t - start)}),
                 {m_p.first, foot}};
  }

private:
  // Returns the position at which a curve starts on the halfedge of T1 along which it leaves the
  // face.
  FT other_end(const Curve& curve, Halfedge_index input) const
  {
    return curve.from_apex
             ? m_tri.place_along(input, m_tri.mesh().source(m_marks.side(curve.corner)))
             : 1 - m_marks.across(curve.other.side, curve.other.mark).t;
  }

  const Triangulation& m_tri;
  const Marks& m_marks;
  Face_location<FT> m_p;
  Face_map<FT, Marks> m_map;
  std::size_t m_region;
};

// Returns the excess over pi of the angle at the source of `h` in the diamond around its edge. If
// it is not positive at either end, the edge can be flipped.
template <typename Traits>
typename Traits::FT angle_excess(Halfedge_index h, const Intrinsic_triangulation<Traits>& tri)
{
  return angle_at_source(h, tri) + angle_at_source(tri.mesh().next(opposite(h)), tri) -
         pi<typename Traits::FT>();
}

// Changes T2 with rounded decisions.
template <typename Traits>
class Rounded_insertion
{
  typedef Intrinsic_triangulation<Traits> Triangulation;
  typedef typename Traits::FT FT;
  typedef typename Traits::Integer Integer;
  typedef Outgoing_halfedges::size_type size_type;

public:
  Rounded_insertion(Triangulation& tri, Edge_courses<Traits>& courses)
    : m_tri(tri), m_courses(courses), m_marks(tri)
  {}

  bool is_Delaunay(Edge_index e) const { return m_tri.is_Delaunay(e); }

  void flip(Halfedge_index h)
  {
    m_tri.flip(h);
    m_courses.after_flip(h);
  }

  // Returns whether the angles of the diamond of `h` at its ends exceed pi by rounding only. A
  // flat angle is allowed at the ends.
  bool can_be_flipped(Halfedge_index h, bool) const
  {
    return (std::max)(angle_excess(h, m_tri), angle_excess(opposite(h), m_tri)) <
           flat_angle_tolerance<FT>();
  }

  // Returns the vertex that `insert(location, closeness)` inserts at the point `p` of a face of T2.
  template <typename Insert>
  Vertex_index insert_near(const Face_location<FT>& p, const FT& closeness, const Insert& insert)
  {
    m_marks.set_face(p.first, m_courses);
    return insert(Rounded_location<Traits>(m_tri, m_marks, p), closeness);
  }

  Vertex_index split_face(Face_index, const Face_split<Integer>& at, const Point_to_insert<FT>& p)
  {
    const Vertex_index m = m_tri.split_face(p.on_intrinsic, at, p.on_input);
    m_courses.after_insertion(m);
    return m;
  }

  Vertex_index split_shared_edge(Halfedge_index h, const FT& t, const Edge_split<Integer>& n,
                                 const Edge_split<size_type>& r)
  {
    return split_edge(h, t, n, r, m_tri.point_on_shared(h, t));
  }

  // Inserts a vertex into an edge that is not shared, or at a crossing within the distance
  // `closeness`.
  template <typename Insert>
  Vertex_index split_crossed_edge(Halfedge_index h, const FT& t, const FT& closeness, const Insert&)
  {
    m_marks.set_face(m_tri.mesh().face(h), m_courses);
    const std::size_t s = side_number(h, m_tri.mesh()), n = m_courses.count(h);
    const FT distance = closeness / m_tri.length(m_tri.mesh().edge(h));
    std::size_t p = 0; // crossings before the point
    while(p < n && m_marks.here(s, p) < t)
      ++p;
    for(std::size_t mark : {p - 1, p})
      if(mark < n && CGAL::abs(m_marks.here(s, mark) - t) < distance)
        return split_at_crossing(h, s, mark);
    const Face_map<FT, Face_marks<Traits>> face_map(m_marks, m_tri.input_mesh());
    const auto [f, map] = face_map.region_map(face_map.regions().region_at_side(s, p));
    return split_edge(h, t,
                      {Integer(p), Integer(n - p), to_apex(h, p), to_apex(opposite(h), n - p)},
                      {0, 0, 0, 0}, Face_location<FT>(f, map(barycentric_coordinates(s, t))));
  }

  void after_removal(Face_index) {}

private:
  Integer to_apex(Halfedge_index h, std::size_t p) const
  {
    return crossings_to_apex(h, p, m_tri.mesh(), m_courses);
  }

  // Inserts a vertex on the edge of T1 that crosses `h` at its crossing `p`, from left to right.
  Vertex_index split_at_crossing(Halfedge_index h, std::size_t s, std::size_t p)
  {
    const std::size_t n = m_courses.count(h);
    const Edge_point<FT> across = m_marks.across(s, p);
    const auto forward = m_tri.number_of_inserted_outgoing(across.halfedge), back = 1 - forward;
    const auto split = [&](Halfedge_index x, std::size_t crossing, auto r) {
      const Face_regions regions = regions_at(x, m_tri.mesh(), m_courses);
      return split_on_curve<Integer>(regions.curve_at_side(0, crossing), r, regions);
    };
    const Face_split<Integer> left = split(h, p, forward),
                              right = split(opposite(h), n - 1 - p, back);
    return split_edge(h, m_marks.here(s, p),
                      {Integer(p), Integer(n - 1 - p), left.n[2], right.n[2]},
                      {forward, back, left.r[2], right.r[2]}, edge_location(across));
  }

  Vertex_index split_edge(Halfedge_index h, const FT& t, const Edge_split<Integer>& n,
                          const Edge_split<size_type>& r, const Surface_point<FT>& q)
  {
    const Vertex_index m = m_tri.split_edge(h, t, n, r, q);
    m_courses.after_split(h);
    return m;
  }

  Triangulation& m_tri;
  Edge_courses<Traits>& m_courses;
  Face_marks<Traits> m_marks;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INSERTION_ROUNDED_INSERTION_H
