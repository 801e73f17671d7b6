// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INSERTION_EXACT_INSERTION_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INSERTION_EXACT_INSERTION_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Edge_point.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/Exact_decisions.h>
#include <CGAL/Intrinsic_triangulations/internal/insertion/Developed_face.h>
#include <CGAL/Intrinsic_triangulations/internal/insertion/split_on_curve.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Edge_courses.h>
#include <CGAL/Intrinsic_triangulations/tolerances.h>

#include <boost/config.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace CGAL::Intrinsic_triangulations::internal {

// Changes of T2 with exact decisions, and with lengths that stay within `certified_length_error()`.
// All of them read stored courses. None is inlined where decisions are rarely exact.
template <typename Traits>
class Exact_insertion
{
  typedef Intrinsic_triangulation<Traits> Triangulation;
  typedef typename Traits::Integer Integer;
  typedef Face_regions::Curve Curve;

public:
  typedef Exact_decisions<Traits> Decisions;

  Exact_insertion(Triangulation& tri, Edge_courses<Traits>& courses)
    : m_tri(tri), m_mesh(tri.mesh()), m_courses(courses), m_decisions(tri, courses)
  {}

  Decisions& decisions() { return m_decisions; }
  const Decisions& decisions() const { return m_decisions; }

  BOOST_NOINLINE bool is_Delaunay(Edge_index e)
  {
    const Halfedge_index h = m_mesh.halfedge(e);
    return !m_tri.can_be_turned(h) || m_decisions.is_Delaunay(h);
  }

  // returns whether the union of the faces of `h` is strictly convex at its ends, or flat at the
  // source if this is allowed
  BOOST_NOINLINE bool can_be_flipped(Halfedge_index h, bool is_flat_allowed)
  {
    return m_decisions.convexity_at_source(h) >= (is_flat_allowed ? ZERO : POSITIVE) &&
           m_decisions.convexity_at_source(m_mesh.opposite(h)) == POSITIVE;
  }

  BOOST_NOINLINE void flip(Halfedge_index h)
  {
    try {
      m_tri.turn(h, [&] {
        m_courses.after_flip(h);
        return m_decisions.length(h);
      });
    } catch(...) { // the edge has been flipped back
      m_courses.after_flip(h);
      throw;
    }
  }

  // Inserts a vertex at the part `t` of the shared edge of `h`, without the lengths of its edges.
  BOOST_NOINLINE Vertex_index split_shared_edge(Halfedge_index h, double t,
                                                const Edge_split<Integer>& n,
                                                const Edge_split<Outgoing_halfedges::size_type>& r)
  {
    return m_tri.split_edge(h, n, r, m_tri.part_of_input_edge(h).point(t, m_tri.input_mesh()), {});
  }

  // computes the lengths of the edges at the inserted vertex `m`
  BOOST_NOINLINE void measure(Vertex_index m) { m_tri.measured(m, m_decisions); }

  // computes the length of the edge of `h` if it is shared
  BOOST_NOINLINE void measure_if_shared(Halfedge_index h)
  {
    if(m_tri.coordinates().is_shared(m_mesh.edge(h)))
      m_tri.m_length[m_mesh.edge(h)] = m_decisions.length(h);
  }

  // Inserts a vertex at the point with coordinates `p`, or on an edge of T1 that is not farther
  // away than `closeness`. Rounded to coordinates on T1, the point may lie outside of its region;
  // then points farther inside the face are tried.
  // \throws Numerical_error if the face is so small that this does not help; nothing has changed
  BOOST_NOINLINE Vertex_index insert(const Face_location<double>& p, double closeness)
  {
    for(double inwards : inward_moves) {
      Face_location<double> moved = p;
      for(double& x : moved.second)
        x += inwards * (1. / 3 - x);
      const Vertex_index m =
        try_to_insert(moved, inwards > greatest_move_on_edge() ? 0 : closeness);
      if(m.is_valid())
        return m;
    }
    throw Numerical_error("rounded coordinates leave no place in face " +
                          std::to_string(p.first.idx()));
  }

private:
  typedef Developed_face<Traits> Face;

  // An edge of T1 on the boundary of a region, by its halfedge that leaves the face, and by the
  // number of that side of the triangle of T1.
  struct Curve_near_by
  {
    Curve curve;
    Halfedge_index input;
    std::size_t side = 0;
    double distance = std::numeric_limits<double>::infinity();
  };

  Vertex_index try_to_insert(const Face_location<double>& p, double closeness)
  {
    // from the corner with the largest coordinate
    const std::size_t s = static_cast<std::size_t>(
      std::max_element(p.second.begin(), p.second.end()) - p.second.begin());
    const Halfedge_index h = sides(p.first, m_mesh)[s];
    const Face face(m_tri, m_courses, m_decisions.extended_corners(), h);
    const auto point = face.point(p.second[(s + 1) % 3], p.second[(s + 2) % 3]);
    const std::size_t region = face.region_of(point);
    const typename Face::Place place = face.place(point, region);
    const Curve_near_by near = nearest_curve(h, face.regions(), region, place);
    const Vertex_index m =
      near.distance < closeness ? insert_on_curve(h, face.regions(), near, place) : Vertex_index();
    return m.is_valid() ? m : insert_in_region(h, face.regions(), region, place);
  }

  Curve_near_by nearest_curve(Halfedge_index h, const Face_regions& regions, std::size_t number,
                              const typename Face::Place& place) const
  {
    const Delta_complex& input = m_tri.input_mesh();
    const std::array<Halfedge_index, 3> side{h, m_mesh.next(h), m_mesh.prev(h)};
    const Region region = regions[number];
    Curve_near_by result;
    for(std::size_t c = 0; c < region.size(); ++c)
      if(region[c].arc_follows) {
        const Region_corner& next = region.next(c);
        const Curve curve = regions.curve(region[c], next);
        const Halfedge_index out = opposite(m_courses(side[curve.mark.side])[curve.mark.mark]);
        const bool leads_to_mark =
          !next.is_vertex() && next.side == curve.mark.side && next.mark == curve.mark.mark;
        const Halfedge_index along = leads_to_mark ? out : input.opposite(out);
        const std::size_t s = side_number(along, place.side, input);
        if(place.distance[s] < result.distance)
          result = {curve, out, s, place.distance[s]};
      }
    return result;
  }

  Vertex_index insert_in_region(Halfedge_index h, const Face_regions& regions, std::size_t region,
                                const typename Face::Place& place)
  {
    if(!(place.weight[0] > 0 && place.weight[1] > 0 && place.weight[2] > 0))
      return {};
    const Delta_complex& input = m_tri.input_mesh();
    const Face_index f = input.face(place.side);
    const std::size_t first = side_number(place.side, input);
    std::array<double, 3> b;
    for(std::size_t c = 0; c < 3; ++c)
      b[(first + c) % 3] = place.weight[c];
    const auto n = regions.crossings_to_corners(region);
    return insert(h, {{Integer(n[0]), Integer(n[1]), Integer(n[2])}, {0, 0, 0}},
                  Face_location<double>(f, b));
  }

  // at the foot of the height over the edge of T1
  Vertex_index insert_on_curve(Halfedge_index h, const Face_regions& regions,
                               const Curve_near_by& near, const typename Face::Place& place)
  {
    const Delta_complex& input = m_tri.input_mesh();
    const auto length = [&](Halfedge_index x) { return m_tri.input_length(input.edge(x)); };
    const std::array<Halfedge_index, 3> sides{place.side, input.next(place.side),
                                              input.prev(place.side)};
    const std::size_t s = near.side;
    const Halfedge_index along = sides[s];
    const double base = length(along), left = length(input.next(along)),
                 right = length(input.prev(along));
    const double foot = doubled_corner_product(left, base, right) / (2 * base * base);
    const double above = place.weight[(s + 2) % 3];
    const double at_source = place.weight[s] + above * (1 - foot),
                 at_target = place.weight[(s + 1) % 3] + above * foot;
    if(!(at_source > 0 && at_target > 0))
      return {};
    const double sum = at_source + at_target;
    return insert(
      h,
      split_on_curve<Integer>(near.curve, m_tri.number_of_inserted_outgoing(near.input), regions),
      Edge_location<double>{along, {at_source / sum, at_target / sum}});
  }

  // Splits the face of `h`; the numbers in `at` begin with the source of `h`. Returns null, and
  // nothing has changed, if the new edges would not be straight, or a face not positive.
  Vertex_index insert(Halfedge_index h, const Face_split<Integer>& at,
                      const Surface_point<double>& q)
  {
    const Face_index f = m_mesh.face(h);
    const std::size_t s = side_number(h, m_mesh);
    const Halfedge_index first = m_mesh.halfedge(f);
    Face_split<Integer> turned;
    for(std::size_t c = 0; c < 3; ++c) {
      turned.n[(s + c) % 3] = at.n[c];
      turned.r[(s + c) % 3] = at.r[c];
    }
    const Vertex_index m = m_tri.split_face(f, turned, q, {});
    const Halfedge_index a = first_outgoing_halfedge(m, m_mesh), b = next_around_source(a, m_mesh);
    m_courses.after_cut({a, b, next_around_source(b, m_mesh)});
    if(is_geodesic(m))
      return m_tri.measured(m, m_decisions);
    // so that `f` is the face that stays, with its first halfedge
    m_tri.m_mesh.set_halfedge(m, m_mesh.opposite(m_mesh.prev(first)));
    m_tri.remove_degree_3_vertex(m);
    return {};
  }

  // whether the edges at `m` are straight and its faces have positive area
  bool is_geodesic(Vertex_index m)
  {
    bool result = true;
    for_each_outgoing_halfedge(m, m_mesh, [&](Halfedge_index h) {
      result = result && m_decisions.orientation(h) == POSITIVE && is_straight(h);
    });
    return result;
  }

  bool is_straight(Halfedge_index h)
  {
    return m_tri.coordinates().is_shared(m_mesh.edge(h)) ? m_decisions.shared_length(h) > 0
                                                         : m_decisions.is_straight(h);
  }

  Triangulation& m_tri;
  const Delta_complex& m_mesh;
  Edge_courses<Traits>& m_courses;
  Decisions m_decisions;
};

// Nothing, where decisions cannot be exact.
struct No_exact_insertion
{
  template <typename Triangulation, typename Courses>
  No_exact_insertion(const Triangulation&, const Courses&)
  {}
};

template <typename Traits>
using Exact_insertion_of =
  std::conditional_t<has_exact_decisions<Traits>(), Exact_insertion<Traits>, No_exact_insertion>;

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INSERTION_EXACT_INSERTION_H
