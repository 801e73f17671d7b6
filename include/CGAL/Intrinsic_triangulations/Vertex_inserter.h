// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_VERTEX_INSERTER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_VERTEX_INSERTER_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Edge_point.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/internal/insertion/Exact_insertion.h>
#include <CGAL/Intrinsic_triangulations/internal/insertion/Rounded_insertion.h>
#include <CGAL/Intrinsic_triangulations/internal/insertion/inserted_outgoing_halfedges.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Edge_courses.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Face_regions.h>
#include <CGAL/Intrinsic_triangulations/tolerances.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsRefinement
/// inserts vertices into a triangulation \f$T_2\f$, and removes them (Section 3.5).
///
/// The object keeps for every edge of \f$T_2\f$ the edges of \f$T_1\f$ that cross it, in order. So
/// an insertion looks only at the crossings on one face. The triangulation must not be changed by
/// others while the object is used. Memory: 4 bytes for each edge, and four to eight for each
/// crossing.
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
  ///   Then `Traits` is `Euclidean_geometry_traits<double>`, edges are straight, and lengths come
  ///   from `make_Delaunay()` with exact decisions
  explicit Vertex_inserter(Triangulation& tri,
                           bool exact_decisions = internal::Is_exact<Traits>::value)
    : m_tri(tri),
      m_courses(tri, Concurrency()),
      m_rounded(tri, m_courses),
      m_exact(tri, m_courses),
      m_is_exact(exact_decisions)
  {}

  Vertex_inserter(const Vertex_inserter&) = delete;
  Vertex_inserter& operator=(const Vertex_inserter&) = delete;

  /// returns the triangulation.
  const Triangulation& triangulation() const { return m_tri; }

  /// returns the course of the halfedge `h` of \f$T_2\f$ over \f$T_1\f$. Complexity: linear in
  /// the crossings.
  Edge_course course(Halfedge_index h) const { return m_courses(h); }

  /// \cond SKIP_IN_MANUAL
  // Returns the courses of all halfedges, for functions that read courses of both triangulations.
  const internal::Edge_courses<Traits>& courses() const { return m_courses; }
  /// \endcond

  /// returns whether decisions are exact.
  bool is_exact() const { return internal::has_exact_decisions<Traits>() && m_is_exact; }

  /// returns the operations with exact decisions; unspecified unless `is_exact()`.
  const internal::Exact_insertion_of<Traits>& exact() const { return m_exact; }

  /// inserts a vertex at the point `p` of \f$T_2\f$: into the face, or into an edge if one
  /// coordinate is zero. Integer coordinates stay valid with any rounding (Section 3.5.1). If `p`
  /// is on a shared edge, the vertex is on that edge of \f$T_1\f$. Complexity: linear in the
  /// crossings on the sides of the face.
  /// \param p a point with coordinates that are not negative and sum up to one
  /// \param closeness if the point is closer to an edge of \f$T_1\f$, the vertex lies on that edge
  /// \returns the vertex; the existing vertex if two coordinates are zero
  /// \throws Invalid_input if `p` is no point of a face
  /// \throws Numerical_error if a new edge has no positive finite length. With exact decisions it
  ///   is also thrown if no near point has coordinates on \f$T_1\f$ that leave its edges straight
  ///   and its faces positive
  /// \throws Overflow_error if a normal coordinate is out of range
  ///
  /// After an exception nothing has changed.
  Vertex_index insert(const Face_location<FT>& p, const FT& closeness = FT(0))
  {
    internal::check_point(p, m_tri.mesh());
    const Surface_point<FT> point = surface_point(p, m_tri.mesh());
    const Halfedge_index h = halfedge_of(point);
    if(is_at_vertex(point))
      return m_tri.mesh().source(h);
    // A rounded point is not exactly on an edge, unless the edge lies on an edge of T1.
    const auto* e = on_edge(point);
    if(e && e->weight[0] > 0 && e->weight[1] > 0 && can_be_split(h) &&
       (!is_exact() || m_tri.coordinates().is_shared(Edge_index(h))))
      return split_edge(h, e->weight[1], closeness);
    return with_decisions([&](auto& d) { return d.insert_near(p, closeness, inserted_by(d)); });
  }

  /// inserts a vertex at a point of any kind of \f$T_2\f$, as at a point of a face.
  Vertex_index insert(const Surface_point<FT>& p, const FT& closeness = FT(0))
  {
    return insert(face_location(p, m_tri.mesh()), closeness);
  }

  /// returns whether the edge of `h` can be split: not if both of its sides are in one face.
  bool can_be_split(Halfedge_index h) const
  {
    return flip_status(h, m_tri.mesh()) != Operation_status::same_face;
  }

  /// inserts a vertex into the edge of `h`, at `t` between its source and its target. `h` starts at
  /// the new vertex. With exact decisions, a vertex on an edge that is not shared is inserted into
  /// the adjacent face that contains its rounded position. The edge is then flipped if this is
  /// possible, and `h` is the flipped edge. Complexity: linear in the crossings on the sides of its
  /// faces.
  /// \param h the halfedge
  /// \param t the position
  /// \param closeness if the distance of the point to a crossing is smaller, the vertex is
  ///   inserted at the crossing
  /// \returns the vertex
  /// \throws Numerical_error, Overflow_error as `insert()`; nothing has changed then.
  /// \pre `can_be_split(h)` and \f$0 < t < 1\f$
  Vertex_index split_edge(Halfedge_index h, const FT& t, const FT& closeness = FT(0))
  {
    return with_decisions([&](auto& d) {
      return m_tri.coordinates().is_shared(m_tri.mesh().edge(h))
               ? split_shared_edge(h, t, d)
               : d.split_crossed_edge(h, t, closeness, inserted_by(d));
    });
  }

  /// flips the edge of `h`, see `Intrinsic_triangulation::flip()`. Complexity: linear in the
  /// crossings on its two faces.
  void flip(Halfedge_index h)
  {
    with_decisions([&](auto& d) { d.flip(h); });
  }

  /// returns whether the edge `e` is Delaunay, see `Intrinsic_triangulation::is_Delaunay()`. With
  /// exact decisions this looks only at the crossings on its two faces.
  bool is_Delaunay(Edge_index e)
  {
    return with_decisions([&](auto& d) { return d.is_Delaunay(e); });
  }

  /// removes the inserted vertex `v`. It flips edges until three are left, the most convex first
  /// (Section 3.5.2), and merges the three faces. The position of the vertex stays as garbage, see
  /// `Intrinsic_triangulation::collect_garbage()`. Complexity: in practice quadratic in the
  /// degree.
  /// \param v the vertex
  /// \param after_flip a function that is called with a halfedge of every flipped edge
  /// \returns the face that remains. It is null if no further edge could be flipped, or 10,000
  ///   flips (500 with exact decisions) did not suffice. Then the vertex stays, and the
  ///   triangulation is valid, but perhaps not Delaunay
  /// \pre `triangulation().is_inserted(v)`
  template <typename After_flip>
  Face_index remove(Vertex_index v, const After_flip& after_flip);

  /// removes the inserted vertex `v` without notifying of flips.
  Face_index remove(Vertex_index v)
  {
    return remove(v, [](Halfedge_index) {});
  }

private:
  // Returns the result of `f` for the changes of T2 with the requested decisions.
  template <typename Function>
  auto with_decisions(const Function& f)
  {
    if constexpr(internal::has_exact_decisions<Traits>())
      if(m_is_exact)
        return f(m_exact);
    return f(m_rounded);
  }

  template <typename Decisions>
  auto inserted_by(Decisions& decisions)
  {
    return [&](const auto& at, const FT& closeness) { return insert(at, closeness, decisions); };
  }

  // Inserts a vertex at the location `at` in a face, or on the nearest edge of T1 at its region.
  // The edge is chosen if it is not farther away than `closeness`. Returns null if both are
  // impossible.
  template <typename Location, typename Decisions>
  Vertex_index insert(const Location& at, const FT& closeness, Decisions& decisions)
  {
    const internal::Face_regions& regions = at.regions();
    const internal::Region region = regions[at.region()];
    Vertex_index m;
    if(const std::size_t c = nearest_curve(region, at, closeness); c < region.size())
      if(const auto p = at.on_curve(region[c], region.next(c))) {
        const auto curve = regions.curve(region[c], region.next(c));
        const auto forward = m_tri.number_of_inserted_outgoing(at.outward(curve.mark));
        m = split_face(at.first_side(), internal::split_on_curve<Integer>(curve, forward, regions),
                       *p, decisions);
      }
    if(const auto p = m.is_valid() ? std::nullopt : at.inside()) {
      const auto n = regions.crossings_to_corners(at.region());
      m = split_face(at.first_side(), {{Integer(n[0]), Integer(n[1]), Integer(n[2])}, {0, 0, 0}},
                     *p, decisions);
    }
    return m;
  }

  // Returns the corner of a region that is followed by the curve nearest to the location in it.
  // Returns the number of corners if no curve is nearer than `closeness`.
  template <typename Location>
  static std::size_t nearest_curve(const internal::Region& region, const Location& at,
                                   const FT& closeness)
  {
    std::size_t result = region.size();
    FT least = closeness;
    for(std::size_t c = 0; c < region.size(); ++c)
      if(region[c].arc_follows)
        if(const FT distance = at.distance(region[c], region.next(c)); distance < least) {
          least = distance;
          result = c;
        }
    return result;
  }

  // Splits the face of `first`; the coordinates in `at` begin with its source.
  template <typename Decisions>
  Vertex_index split_face(Halfedge_index first, const Face_split<Integer>& at,
                          const internal::Point_to_insert<FT>& p, Decisions& decisions)
  {
    Face_split<Integer> turned;
    for(std::size_t c = 0, s = side_number(first, m_tri.mesh()); c < 3; ++c, s = (s + 1) % 3) {
      turned.n[s] = at.n[c];
      turned.r[s] = at.r[c];
    }
    return decisions.split_face(m_tri.mesh().face(first), turned, p);
  }

  template <typename Decisions>
  Vertex_index split_shared_edge(Halfedge_index h, const FT& t, Decisions& decisions)
  {
    const auto forward = m_tri.number_of_inserted_outgoing(m_tri.input_halfedge(h)),
               back = 1 - forward;
    const auto to_apex = [&](Halfedge_index x) {
      return internal::crossings_to_apex(x, 0, m_tri.mesh(), m_courses);
    };
    return decisions.split_shared_edge(h, t,
                                       {Integer(-1), Integer(-1), to_apex(h), to_apex(opposite(h))},
                                       {back, forward, back, forward});
  }

  // ---- Removal ----

  template <typename Decisions>
  Halfedge_index edge_to_flip(Vertex_index v, Decisions& decisions);

  Triangulation& m_tri;
  internal::Edge_courses<Traits> m_courses;
  internal::Rounded_insertion<Traits> m_rounded;
  internal::Exact_insertion_of<Traits> m_exact;
  bool m_is_exact;
  std::vector<std::pair<FT, Halfedge_index>> m_candidates; // edges to flip, the least rank first
};

// Returns the edge to flip, which removes an outgoing halfedge from `v`. A loop counts twice. A
// vertex with fewer than three outgoing halfedges gets more by a flip of an edge opposite to it. A
// flat angle at `v` is allowed, because the face without area is removed with `v`; at the other end
// it would remain. The rank is rounded, and determines the order in which edges are tested.
template <typename Traits>
template <typename Decisions>
Halfedge_index Vertex_inserter<Traits>::edge_to_flip(Vertex_index v, Decisions& decisions)
{
  const Delta_complex& mesh = m_tri.mesh();
  std::size_t degree = 0;
  for_each_outgoing_halfedge(v, mesh, [&](Halfedge_index) { ++degree; });
  m_candidates.clear();
  for_each_outgoing_halfedge(v, mesh, [&](Halfedge_index outgoing) {
    const Halfedge_index h = degree < 3 ? mesh.next(outgoing) : outgoing;
    if((degree < 3 && mesh.is_border(outgoing)) ||
       flip_status(h, mesh) != Operation_status::possible || m_tri.is_constrained(mesh.edge(h)))
      return;
    const FT at_source = internal::angle_excess(h, m_tri),
             at_target = internal::angle_excess(opposite(h), m_tri);
    const FT c = (std::max)(at_source, at_target), elsewhere = degree < 3 ? c : at_target;
    const bool is_loop = mesh.target(h) == mesh.source(h), // loops first
      is_flat = elsewhere > -internal::flat_angle_tolerance<FT>();
    m_candidates.push_back({is_loop ? c - 4 : is_flat ? c + 4 : c, h});
  });
  std::stable_sort(m_candidates.begin(), m_candidates.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  for(const auto& candidate : m_candidates)
    if(decisions.can_be_flipped(candidate.second, degree >= 3))
      return candidate.second;
  return Halfedge_index();
}

template <typename Traits>
template <typename After_flip>
Face_index Vertex_inserter<Traits>::remove(Vertex_index v, const After_flip& after_flip)
{
  CGAL_precondition(m_tri.is_inserted(v));
  return with_decisions([&](auto& decisions) {
    const std::size_t most_flips = is_exact() ? 500 : 10000;
    for(std::size_t flips = 0; removal_status(v, m_tri.mesh()) != Operation_status::possible;
        ++flips) {
      const Halfedge_index h = edge_to_flip(v, decisions);
      if(!h.is_valid() || flips > most_flips)
        return Delta_complex::null_face();
      decisions.flip(h);
      after_flip(h);
    }
    const Face_index f = m_tri.remove_degree_3_vertex(v);
    decisions.after_removal(f);
    return f;
  });
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_VERTEX_INSERTER_H
