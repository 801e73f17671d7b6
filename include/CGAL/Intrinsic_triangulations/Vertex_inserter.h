// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_VERTEX_INSERTER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_VERTEX_INSERTER_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Edge_point.h>
#include <CGAL/Intrinsic_triangulations/Flat_face.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/corner_formulas.h>
#include <CGAL/Intrinsic_triangulations/internal/insertion/Exact_insertion.h>
#include <CGAL/Intrinsic_triangulations/internal/insertion/split_on_curve.h>
#include <CGAL/Intrinsic_triangulations/internal/refinement/Local_marks.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Edge_courses.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Face_map.h>
#include <CGAL/Intrinsic_triangulations/tolerances.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsRefinement
/// inserts vertices into a triangulation \f$T_2\f$, and removes them (Section 3.5).
///
/// The object keeps for every edge of \f$T_2\f$ the edges of \f$T_1\f$ that cross it, in order. So
/// an insertion looks only at the crossings on the face in which it takes place, however far the
/// edges of \f$T_1\f$ run. The triangulation must not be changed by others while the object is
/// used. Memory: 40 bytes for each edge, and four and more for each crossing from the fifth on an
/// edge on.
///
/// \tparam Traits_ a model of `IntrinsicGeometryTraitsWithDistance` whose number type is a floating
///   point type
template <typename Traits_ = Euclidean_geometry_traits<double>>
class Vertex_inserter
{
public:
  /// the geometry.
  typedef Traits_ Traits;
  /// the type of the triangulation.
  typedef Intrinsic_triangulation<Traits> Triangulation;
  /// the type of lengths and barycentric coordinates.
  typedef typename Traits::FT FT;
  /// the type of normal coordinates.
  typedef typename Traits::Integer Integer;

  /// prepares changes of `tri`. Complexity: linear in the elements and crossings.
  /// \param tri the triangulation
  /// \param exact_decisions whether decisions are exact, as they always are with exact traits.
  ///   `Traits` is `Euclidean_geometry_traits<double>` then, edges are straight, and lengths are
  ///   those that `make_Delaunay()` computes with exact decisions.
  explicit Vertex_inserter(Triangulation& tri,
                           bool exact_decisions = internal::Is_exact<Traits>::value)
    : m_tri(tri),
      m_courses(tri, Concurrency()),
      m_marks(tri),
      m_exact(tri, m_courses),
      m_is_exact(exact_decisions)
  {}

  Vertex_inserter(const Vertex_inserter&) = delete;
  Vertex_inserter& operator=(const Vertex_inserter&) = delete;

  /// returns the triangulation.
  const Triangulation& triangulation() const { return m_tri; }

  /// returns the courses of the halfedges of \f$T_2\f$ over \f$T_1\f$.
  const internal::Edge_courses<Traits>& courses() const { return m_courses; }

  /// returns whether decisions are exact.
  bool is_exact() const { return internal::has_exact_decisions<Traits>() && m_is_exact; }

  /// returns the operations with exact decisions; nothing useful unless `is_exact()`.
  const internal::Exact_insertion_of<Traits>& exact() const { return m_exact; }

  /// inserts a vertex at the point `p` of \f$T_2\f$: into the face, or into an edge if one
  /// coordinate is zero. Whatever the rounding, the integer coordinates are those of a point in one
  /// region between edges of \f$T_1\f$ (Section 3.5.1), and if `p` is on a shared edge, the vertex
  /// is on that edge of \f$T_1\f$. Complexity: linear in the crossings on the sides of the face.
  /// \param p a point with coordinates that are not negative and sum up to one
  /// \param closeness if the point is closer to an edge of \f$T_1\f$, it is put on that edge
  /// \returns the vertex; one that was there already if two coordinates are zero
  /// \throws Numerical_error if a new edge has no positive finite length, or with exact decisions,
  ///   if no point near by has coordinates on \f$T_1\f$ that leave its edges straight and its faces
  ///   positive; nothing has changed then.
  Vertex_index insert(const Face_location<FT>& p, const FT& closeness = FT(0))
  {
    const auto side = sides(p.first, m_tri.mesh());
    for(std::size_t s = 0; s < 3; ++s) {
      const FT &at_target = p.second[(s + 1) % 3], &at_apex = p.second[(s + 2) % 3];
      if(at_target == 0 && at_apex == 0)
        return m_tri.mesh().source(side[s]);
      // a point that is rounded is not exactly on an edge, unless that is one of T1
      if(at_apex == 0 && p.second[s] > 0 && at_target > 0 && can_be_split(side[s]) &&
         (!is_exact() || m_tri.coordinates().is_shared(m_tri.mesh().edge(side[s]))))
        return split_edge(side[s], at_target, closeness);
    }
    return split_face(p, closeness);
  }

  /// returns whether the edge of `h` can be split: not if both of its sides are in one face.
  bool can_be_split(Halfedge_index h) const
  {
    return flip_status(h, m_tri.mesh()) != Operation_status::same_face;
  }

  /// inserts a vertex into the edge of `h`, at `t` between its source and its target. `h` leads on
  /// from there. With exact decisions, the rounded place of a vertex is not on an edge that is not
  /// shared: it is inserted into the face beside it as by `insert()`, the edge is flipped if this
  /// is possible, and `h` is the flipped edge. Complexity: linear in the crossings on the sides of
  /// its faces.
  /// \param h the halfedge
  /// \param t the place
  /// \param closeness if the point is closer to a crossing, it is put there
  /// \returns the vertex
  /// \throws Numerical_error as `insert()`; nothing has changed then.
  /// \pre `can_be_split(h)` and \f$0 < t < 1\f$
  Vertex_index split_edge(Halfedge_index h, const FT& t, const FT& closeness = FT(0))
  {
    const bool is_shared = m_tri.coordinates().is_shared(m_tri.mesh().edge(h));
    if constexpr(can_be_exact)
      if(is_exact() && !is_shared)
        return insert_beside(h, t, closeness);
    const Vertex_index m =
      is_shared ? split_shared_edge(h, t) : split_crossed_edge(h, t, closeness);
    update_split(h);
    if constexpr(can_be_exact)
      if(is_exact())
        m_exact.measure(m);
    return m;
  }

  /// flips the edge of `h`, see `Intrinsic_triangulation::flip()`. Complexity: linear in the
  /// crossings.
  void flip(Halfedge_index h)
  {
    if constexpr(can_be_exact)
      if(is_exact())
        return m_exact.flip(h);
    m_tri.flip(h);
    m_courses.after_flip(h);
  }

  /// returns whether the edge `e` is Delaunay, see `Intrinsic_triangulation::is_Delaunay()`. With
  /// exact decisions this looks only at the crossings on its two faces.
  bool is_Delaunay(Edge_index e)
  {
    if constexpr(can_be_exact)
      if(is_exact())
        return m_exact.is_Delaunay(e);
    return m_tri.is_Delaunay(e);
  }

  /// removes the inserted vertex `v`: flips edges until three are left, the most convex first
  /// (Section 3.5.2), and merges the faces there. The place of the vertex stays as garbage, see
  /// `Intrinsic_triangulation::collect_garbage()`.
  /// Complexity: in practice quadratic in the degree.
  /// \param v the vertex
  /// \param after_flip a function that is called with a halfedge of every flipped edge
  /// \returns the face that takes its place; null if no more edges could be flipped, or 10,000
  ///          flips were not enough: then the vertex stays, and the triangulation is valid, but
  ///          perhaps not Delaunay
  /// \pre `triangulation().is_inserted(v)`
  template <typename After_flip>
  Face_index remove(Vertex_index v, const After_flip& after_flip);

  /// removes the inserted vertex `v` without notifying of flips.
  Face_index remove(Vertex_index v)
  {
    return remove(v, [](Halfedge_index) {});
  }

private:
  static constexpr bool can_be_exact = internal::has_exact_decisions<Traits>();
  typedef internal::Local_marks<Traits> Marks;
  typedef internal::Face_map<FT, Marks> Face_map;
  typedef internal::Barycentric_coordinates<FT> Coordinates;

  Vertex_index insert_beside(Halfedge_index h, const FT& t, const FT& closeness)
  {
    const Vertex_index m =
      m_exact.insert(face_location(Edge_point<FT>{h, t}, m_tri.mesh()), closeness);
    if(m_exact.can_be_flipped(h, false))
      flip(h);
    return m;
  }

  Vertex_index split_face(const Face_location<FT>& p, const FT& closeness)
  {
    if constexpr(can_be_exact)
      if(is_exact())
        return m_exact.insert(p, closeness);
    m_marks.set_face(p.first, m_courses);
    const Face_map face_map(m_marks, m_tri.input_mesh());
    const std::size_t number = face_map.region_of(p.second);
    const Curve_near_by near = nearest_curve(face_map, number, p);
    const Vertex_index m = near.distance < closeness ? split_face_on_curve(p, near.curve, face_map)
                                                     : split_face_in_region(p, number, face_map);
    const Halfedge_index a = first_outgoing_halfedge(m, m_tri.mesh());
    const Halfedge_index b = next_around_source(a, m_tri.mesh());
    m_courses.after_cut({a, b, next_around_source(b, m_tri.mesh())});
    return m;
  }

  Vertex_index split_face_in_region(const Face_location<FT>& p, std::size_t number,
                                    const Face_map& face_map)
  {
    const auto [input_face, map] = face_map.region_map(number);
    const auto n = face_map.regions().crossings_to_corners(number);
    return m_tri.split_face(p, {{Integer(n[0]), Integer(n[1]), Integer(n[2])}, {0, 0, 0}},
                            Face_location<FT>(input_face, map(p.second)));
  }

  struct Curve_near_by
  {
    internal::Face_regions::Curve curve;
    FT distance = std::numeric_limits<FT>::infinity();
  };

  // returns the curve on the boundary of a region that is nearest to `p`
  Curve_near_by nearest_curve(const Face_map& face_map, std::size_t number,
                              const Face_location<FT>& p) const
  {
    Curve_near_by nearest;
    const internal::Region region = face_map.regions()[number];
    for(std::size_t c = 0; c < region.size(); ++c)
      if(region[c].arc_follows) {
        const FT d = distance_from_line(face_map.coordinates(region[c]),
                                        face_map.coordinates(region.next(c)), p);
        if(d < nearest.distance)
          nearest = {face_map.regions().curve(region[c], region.next(c)), d};
      }
    return nearest;
  }

  // returns the distance of `p` from the line through the points `a` and `b` of its face
  FT distance_from_line(const Coordinates& a, const Coordinates& b,
                        const Face_location<FT>& p) const
  {
    const auto side = internal::side_lengths(m_tri.mesh().halfedge(p.first), m_tri.intrinsic());
    const FT area = quadrupled_area(side[0], side[1], side[2]) / 2;
    const FT length = m_tri.traits().compute_distance_object()(side, a, b);
    return CGAL::abs(internal::orientation(a, b, p.second)) * area / length;
  }

  // Inserts a vertex where `curve` comes closest to `p`. One outgoing halfedge of the new vertex
  // leads to the mark where the curve leaves the face, and one back.
  Vertex_index split_face_on_curve(const Face_location<FT>& p,
                                   const internal::Face_regions::Curve& curve,
                                   const Face_map& face_map)
  {
    const Coordinates end = face_map.coordinates(curve.mark),
                      begin = face_map.coordinates(curve.other);
    const FT t = foot_on_chord(begin, end, p);
    Coordinates foot;
    for(std::size_t s = 0; s < 3; ++s)
      foot[s] = begin[s] + t * (end[s] - begin[s]);
    const Edge_point<FT> across = m_marks.across(curve.mark.side, curve.mark.mark);
    const FT start = place_of_other_end(curve, across.halfedge);
    const Edge_point<FT> place{across.halfedge, start + t * (across.t - start)};
    return m_tri.split_face(
      {p.first, foot},
      internal::split_on_curve<Integer>(curve, m_tri.number_of_inserted_outgoing(across.halfedge),
                                        face_map.regions()),
      edge_location(place));
  }

  // Returns the place of the point closest to `p` on the way from `begin` to `end`. The distance is
  // that on the surface: in a thin face any other would carry what rounding puts `p` off the curve
  // to along the curve.
  FT foot_on_chord(const Coordinates& begin, const Coordinates& end,
                   const Face_location<FT>& p) const
  {
    const Flat_face<FT> face(m_tri.mesh().halfedge(p.first), m_tri);
    const auto chord = face.between(begin, end);
    const FT square = internal::dot(chord, chord);
    return square > 0 ? internal::dot(chord, face.between(begin, p.second)) / square : FT(0);
  }

  // on the halfedge `input` of T1, along which the curve leaves the face
  FT place_of_other_end(const internal::Face_regions::Curve& curve, Halfedge_index input) const
  {
    if(curve.from_apex)
      return m_tri.place_along(input, m_tri.mesh().source(m_marks.side(curve.corner)));
    return 1 - m_marks.across(curve.other.side, curve.other.mark).t;
  }

  // returns the regions of the face of `h`, with `h` as side 0
  internal::Face_regions regions_at(Halfedge_index h) const
  {
    const Delta_complex& mesh = m_tri.mesh();
    return internal::Face_regions(
      {m_courses.count(h), m_courses.count(mesh.next(h)), m_courses.count(mesh.prev(h))});
  }

  // returns the number of crossings from a point on `h` after `p` of its crossings to the opposite
  // corner
  Integer crossings_to_apex(Halfedge_index h, std::size_t p) const
  {
    if(m_tri.mesh().is_border(h))
      return Integer(0);
    const internal::Face_regions regions = regions_at(h);
    return Integer(regions.crossings_to_corners(regions.region_at_side(0, p))[2]);
  }

  Vertex_index split_shared_edge(Halfedge_index h, const FT& t)
  {
    const Halfedge_index o = m_tri.mesh().opposite(h);
    const auto forward = m_tri.number_of_inserted_outgoing(m_tri.input_halfedge(h)),
               back = 1 - forward;
    const Edge_split<Integer> n{Integer(-1), Integer(-1), crossings_to_apex(h, 0),
                                crossings_to_apex(o, 0)};
    const Edge_split<Outgoing_halfedges::size_type> r{back, forward, back, forward};
    if constexpr(can_be_exact)
      if(is_exact())
        return m_exact.split_shared_edge(h, t, n, r);
    return m_tri.split_edge(h, t, n, r, m_tri.point_on_shared(h, t));
  }

  Vertex_index split_crossed_edge(Halfedge_index h, const FT& t, const FT& closeness)
  {
    m_marks.set_face(m_tri.mesh().face(h), m_courses);
    const std::size_t s = side_number(h, m_tri.mesh()), n = m_courses.count(h);
    const FT distance = closeness / m_tri.length(m_tri.mesh().edge(h));
    std::size_t p = 0; // crossings before the point
    while(p < n && m_marks.here(s, p) < t)
      ++p;
    for(std::size_t mark : {p - 1, p})
      if(mark < n && CGAL::abs(m_marks.here(s, mark) - t) < distance)
        return split_edge_at_crossing(h, s, mark);
    return split_edge_between_crossings(h, t, s, p);
  }

  Vertex_index split_edge_between_crossings(Halfedge_index h, const FT& t, std::size_t s,
                                            std::size_t p)
  {
    const std::size_t n = m_courses.count(h);
    const Face_map face_map(m_marks, m_tri.input_mesh());
    const auto [input_face, map] = face_map.region_map(face_map.regions().region_at_side(s, p));
    return m_tri.split_edge(h, t,
                            {Integer(p), Integer(n - p), crossings_to_apex(h, p),
                             crossings_to_apex(m_tri.mesh().opposite(h), n - p)},
                            {0, 0, 0, 0},
                            Face_location<FT>(input_face, map(barycentric_coordinates(s, t))));
  }

  // How the curve at crossing `p` of side 0 of a face goes on there.
  struct Side_of_crossing
  {
    Integer to_apex; // the crossings between it and the opposite corner, -1 if it ends there
    bool is_around_target;

    Side_of_crossing(std::size_t p, const internal::Face_regions& regions)
    {
      const auto curve = regions.curve_at_side(0, p);
      to_apex = Integer(regions.crossings_to_corners(curve)[2]);
      is_around_target = curve.corner == 1;
    }
  };

  // Inserts a vertex on the edge of T1 that crosses `h` at its crossing `p`, from left to right.
  Vertex_index split_edge_at_crossing(Halfedge_index h, std::size_t s, std::size_t p)
  {
    const std::size_t n = m_courses.count(h);
    const Edge_point<FT> across = m_marks.across(s, p);
    const auto forward = m_tri.number_of_inserted_outgoing(across.halfedge), back = 1 - forward;
    const Side_of_crossing left(p, regions_at(h));
    const Side_of_crossing right(n - 1 - p, regions_at(m_tri.mesh().opposite(h)));
    return m_tri.split_edge(h, m_marks.here(s, p),
                            {Integer(p), Integer(n - 1 - p), left.to_apex, right.to_apex},
                            {forward, back, left.is_around_target ? forward : back,
                             right.is_around_target ? back : forward},
                            edge_location(across));
  }

  // after an edge has been split, of which `h` is the second part
  void update_split(Halfedge_index h)
  {
    const Delta_complex& mesh = m_tri.mesh();
    const Halfedge_index o = mesh.opposite(h), im = first_part(h, mesh);
    m_courses.after_split(im, h);
    if(!mesh.is_border(im) && !mesh.is_border(o))
      m_courses.after_cut({mesh.next(im), mesh.next(o)});
    else
      m_courses.after_cut({mesh.next(mesh.is_border(o) ? im : o)});
  }

  // ---- Removal ----

  // Returns the excess over pi of the angle at the source of `h` in the diamond around its edge.
  // Where it is not positive at either end, the edge can be flipped.
  FT angle_excess_at_source(Halfedge_index h) const
  {
    const Delta_complex& mesh = m_tri.mesh();
    return internal::angle_at_source(h, m_tri) +
           internal::angle_at_source(mesh.next(mesh.opposite(h)), m_tri) - pi<FT>();
  }

  bool can_be_flipped(Halfedge_index h) const
  {
    return flip_status(h, m_tri.mesh()) == Operation_status::possible &&
           !m_tri.is_constrained(m_tri.mesh().edge(h));
  }

  typedef std::pair<FT, Halfedge_index> Candidate; // an edge to flip, the least rank first

  Halfedge_index edge_to_flip(Vertex_index v);
  Halfedge_index best_candidate(bool is_flat_allowed);

  Triangulation& m_tri;
  internal::Edge_courses<Traits> m_courses;
  Marks m_marks;
  internal::Exact_insertion_of<Traits> m_exact;
  bool m_is_exact;
  std::vector<Candidate> m_candidates;
};

// A flip of an outgoing halfedge takes it away from `v`, and a loop counts twice. A vertex with
// less than three outgoing halfedges gets more by a flip of an edge opposite to it. Angles at `v`
// exceed pi by rounding only. A flat angle there is allowed, since the face without area is removed
// with `v`; at the other end it would stay.
template <typename Traits>
Halfedge_index Vertex_inserter<Traits>::edge_to_flip(Vertex_index v)
{
  const Delta_complex& mesh = m_tri.mesh();
  std::size_t degree = 0;
  for_each_outgoing_halfedge(v, mesh, [&](Halfedge_index) { ++degree; });
  const FT tolerance = internal::flat_angle_tolerance<FT>();
  m_candidates.clear();
  for_each_outgoing_halfedge(v, mesh, [&](Halfedge_index outgoing) {
    const Halfedge_index h = degree < 3 ? mesh.next(outgoing) : outgoing;
    if((degree < 3 && mesh.is_border(outgoing)) || !can_be_flipped(h))
      return;
    const FT at_source = angle_excess_at_source(h),
             at_target = angle_excess_at_source(mesh.opposite(h));
    const FT c = (std::max)(at_source, at_target), elsewhere = degree < 3 ? c : at_target;
    const bool is_loop = mesh.target(h) == mesh.source(h);
    const FT rank = is_loop ? c - 4 : elsewhere > -tolerance ? c + 4 : c; // loops first
    if(is_exact() || c < tolerance)
      m_candidates.push_back({rank, h});
  });
  return best_candidate(degree >= 3);
}

// With exact decisions the rank only determines the order in which candidates are looked at.
template <typename Traits>
Halfedge_index Vertex_inserter<Traits>::best_candidate([[maybe_unused]] bool is_flat_allowed)
{
  const auto by_rank = [](const Candidate& a, const Candidate& b) { return a.first < b.first; };
  auto best = m_candidates.begin();
  if constexpr(can_be_exact)
    if(is_exact()) {
      std::stable_sort(m_candidates.begin(), m_candidates.end(), by_rank);
      best = std::find_if(m_candidates.begin(), m_candidates.end(), [&](const Candidate& c) {
        return m_exact.can_be_flipped(c.second, is_flat_allowed);
      });
    }
  if(!is_exact())
    best = std::min_element(m_candidates.begin(), m_candidates.end(), by_rank);
  return best == m_candidates.end() ? Halfedge_index() : best->second;
}

template <typename Traits>
template <typename After_flip>
Face_index Vertex_inserter<Traits>::remove(Vertex_index v, const After_flip& after_flip)
{
  CGAL_precondition(m_tri.is_inserted(v));
  const Delta_complex& mesh = m_tri.mesh();
  for(std::size_t flips = 0; removal_status(v, mesh) != Operation_status::possible; ++flips) {
    const Halfedge_index h = edge_to_flip(v);
    if(!h.is_valid() || flips > (is_exact() ? 500 : 10000))
      return Delta_complex::null_face();
    flip(h);
    after_flip(h);
  }
  const Face_index f = m_tri.remove_degree_3_vertex(v);
  if constexpr(can_be_exact)
    if(is_exact())
      for(Halfedge_index h : sides(f, mesh))
        m_exact.measure_if_shared(h);
  return f;
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_VERTEX_INSERTER_H
