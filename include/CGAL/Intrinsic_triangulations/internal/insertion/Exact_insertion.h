// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INSERTION_EXACT_INSERTION_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INSERTION_EXACT_INSERTION_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Edge_point.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/Triangulation_pair.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/Development.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/Exact_decisions.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/Input_corners.h>
#include <CGAL/Intrinsic_triangulations/internal/insertion/Rounded_insertion.h>
#include <CGAL/Intrinsic_triangulations/internal/insertion/inserted_outgoing_halfedges.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Edge_courses.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Face_regions.h>
#include <CGAL/Intrinsic_triangulations/tolerances.h>
#include <CGAL/Intrinsic_triangulations/triangle_formulas.h>

#include <boost/config.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string>

namespace CGAL::Intrinsic_triangulations::internal {

// Lays out a point of a face ijk of T2 in the plane, with i at the origin. The edges of T1 that
// cross ij and ik are laid out along these edges. So the relative error of a position is the
// relative error of its vector from i, for any thin face and regions. Errors are not tracked.
template <typename Traits>
class Developed_location
{
  typedef Triangulation_pair<Traits> Pair;
  typedef Double_double N;
  typedef Rounded_corners<N, typename Pair::Metric::Number> Corners;
  typedef Development<Traits, Corners> Layout;
  typedef typename Layout::Placed_side Placed_side;
  typedef typename Layout::Complex Complex;
  typedef Point_to_insert<double> Point;

public:
  // The point has the weights `b` of i, j and k; `h` leads from i to j.
  Developed_location(const Pair& pair, const Edge_courses<Traits>& courses, Corners& corners,
                     Halfedge_index h, const std::array<double, 3>& b)
    : m_pair(pair),
      m_input(pair.input_mesh()),
      m_courses(courses),
      m_side{h, pair.mesh().next(h), pair.mesh().prev(h)},
      m_layout(pair, courses, corners),
      m_is_inserted(pair.is_inserted(pair.mesh().source(h))),
      m_regions(regions_at(h, pair.mesh(), courses)),
      m_ij(m_layout.strip(h)),
      m_ik(m_layout.strip(opposite(pair.mesh().prev(h)), m_layout.following_side(h, m_ij.first)))
  {
    const Complex p = number(b[1]) * m_ij.end + number(b[2]) * m_ik.end;
    m_region = region_of(p);
    set_position(p, triangle(m_region), to_double(corners.length(m_ij.first.halfedge).x));
  }

  // Returns the side from which regions are counted.
  Halfedge_index first_side() const { return m_side[0]; }
  // Returns the halfedge of T1 that leaves the face at a mark.
  Halfedge_index outward(const Region_corner& mark) const
  {
    return opposite(m_courses(m_side[mark.side])[mark.mark]);
  }
  const Face_regions& regions() const { return m_regions; }
  std::size_t region() const { return m_region; }

  // Returns the distance of the point from the curve between two corners of its region.
  double distance(const Region_corner& from, const Region_corner& to) const
  {
    return m_distance[side_along(from, to)];
  }

  // Returns the point in its region, or nothing if rounding has moved it out.
  std::optional<Point> inside() const
  {
    if(!(m_weight[0] > 0 && m_weight[1] > 0 && m_weight[2] > 0))
      return {};
    const std::size_t first = side_number(m_triangle, m_input);
    std::array<double, 3> b;
    for(std::size_t c = 0; c < 3; ++c)
      b[(first + c) % 3] = m_weight[c];
    return Point{Face_location<double>(m_input.face(m_triangle), b), {}};
  }

  // Returns the foot of the height over the curve, or nothing if it is beyond the ends of the
  // curve.
  std::optional<Point> on_curve(const Region_corner& from, const Region_corner& to) const
  {
    const std::size_t s = side_along(from, to);
    const std::array<Halfedge_index, 3> sides{m_triangle, m_input.next(m_triangle),
                                              m_input.prev(m_triangle)};
    const auto length = [&](std::size_t k) {
      return m_pair.input_length(m_input.edge(sides[(s + k) % 3]));
    };
    const double base = length(0);
    const double foot = doubled_corner_product(length(1), base, length(2)) / (2 * base * base);
    const double above = m_weight[(s + 2) % 3];
    const double at_source = m_weight[s] + above * (1 - foot),
                 at_target = m_weight[(s + 1) % 3] + above * foot;
    if(!(at_source > 0 && at_target > 0))
      return {};
    const double sum = at_source + at_target;
    return Point{Edge_location<double>{sides[s], {at_source / sum, at_target / sum}}, {}};
  }

private:
  static Complex number(double x) { return {N(x), N(0), 0}; }
  static N cross(const Complex& a, const Complex& b) { return a.x * b.y - a.y * b.x; }

  // Returns whether `p` and the origin are on one side of an edge of T1.
  static bool is_before(const Complex& p, const Placed_side& side)
  {
    return cross(side.vector, p - side.source) > 0;
  }

  // Returns the side of the triangle of T1 that lies along the curve from one corner of the region
  // to the next.
  std::size_t side_along(const Region_corner& from, const Region_corner& to) const
  {
    const Region_corner mark = m_regions.curve(from, to).mark;
    const Halfedge_index out = outward(mark);
    const bool leads_to_mark = !to.is_vertex() && to.side == mark.side && to.mark == mark.mark;
    return side_number(leads_to_mark ? out : opposite(out), m_triangle, m_input);
  }

  std::size_t region_of(const Complex& p) const
  {
    const auto &ij = m_ij.crossed, &ik = m_ik.crossed;
    const std::size_t n = m_regions.leaving(), around_i = m_regions.around(0);
    return m_regions.find(
      [&](std::size_t s, std::size_t j) {
        return s == 0   ? is_before(p, ij[j])
               : s == 1 ? !is_before(p, ij[ij.size() - 1 - j])
                        : !is_before(p, ik[ik.size() - 1 - j]);
      },
      [&](std::size_t j) {
        return m_regions.apex() == 0   ? cross(outgoing(j + 1).target, p) <= 0
               : m_regions.apex() == 1 ? !is_before(p, ik[around_i + n - 1 - j])
                                       : is_before(p, ij[around_i + j]);
      });
  }

  // Returns the outgoing halfedge of T1 with number `s`, counted from ij.
  Placed_side outgoing(std::size_t s) const
  {
    Placed_side side = m_ij.first;
    for(; s > 0; --s)
      side = m_layout.following_outgoing(side, m_is_inserted);
    return side;
  }

  // Sets the coordinates of the point `p` in the triangle of `side`, and its distances from the
  // sides. `unit` is the length of a vector of length 1.
  void set_position(const Complex& p, const Placed_side& side, double unit)
  {
    m_triangle = side.halfedge;
    const std::array<Complex, 3> corner{side.source, side.target, m_layout.apex(side)};
    double sum = 0;
    for(std::size_t c = 0; c < 3; ++c) {
      const Complex &from = corner[c], &to = corner[(c + 1) % 3];
      const double area = to_double(cross(to - from, p - from));
      sum += m_weight[(c + 2) % 3] = area;
      m_distance[c] = unit * area / (to - from).norm();
    }
    for(double& w : m_weight)
      w /= sum;
  }

  // Returns the triangle of T1 in which a region lies.
  Placed_side triangle(std::size_t region) const
  {
    const std::size_t around_i = m_regions.around(0), around_j = m_regions.around(1);
    if(region < around_i)
      return triangle_after(m_ij, region);
    if(region < around_i + around_j)
      return triangle_after(m_ij, m_ij.crossed.size() - (region - around_i));
    if(region < m_regions.first_of_rest())
      return triangle_after(m_ik, m_ik.crossed.size() - (region - around_i - around_j));
    const std::size_t j = region - m_regions.first_of_rest();
    if(m_regions.leaving() == 0 || m_regions.apex() == 2)
      return triangle_after(m_ij, around_i + j);
    if(m_regions.apex() == 1)
      return triangle_after(m_ik, around_i + m_regions.leaving() - j);
    return outgoing(j);
  }

  Placed_side triangle_after(const typename Layout::Strip& strip, std::size_t crossings) const
  {
    return crossings == 0 ? strip.first : m_layout.beyond(strip.crossed[crossings - 1]);
  }

  const Pair& m_pair;
  const Delta_complex& m_input;
  const Edge_courses<Traits>& m_courses;
  std::array<Halfedge_index, 3> m_side;
  Layout m_layout;
  bool m_is_inserted;
  Face_regions m_regions;
  typename Layout::Strip m_ij, m_ik;
  std::size_t m_region;
  Halfedge_index m_triangle; // a side of the triangle of T1 in which the point lies
  std::array<double, 3> m_weight, m_distance; // of its corners and from its sides, from there on
};

// Changes T2 with exact decisions, and with lengths that have errors of at most
// `certified_length_error()`. All functions read stored courses. No function is inlined, because
// exact decisions are rare.
template <typename Traits>
class Exact_insertion
{
  typedef Intrinsic_triangulation<Traits> Triangulation;
  typedef typename Traits::Integer Integer;

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

  // Returns whether the union of the faces of `h` is strictly convex at its ends, or flat at the
  // source if this is allowed.
  BOOST_NOINLINE bool can_be_flipped(Halfedge_index h, bool is_flat_allowed)
  {
    return m_decisions.convexity_at_source(h) >= (is_flat_allowed ? ZERO : POSITIVE) &&
           m_decisions.convexity_at_source(m_mesh.opposite(h)) == POSITIVE;
  }

  BOOST_NOINLINE void flip(Halfedge_index h)
  {
    const auto length = [&] {
      m_courses.after_flip(h);
      return m_decisions.length(h);
    };
    change_or_undo([&] { m_tri.turn(h, length); }, [&] { m_courses.after_flip(h); });
  }

  BOOST_NOINLINE Vertex_index split_shared_edge(Halfedge_index h, double t,
                                                const Edge_split<Integer>& n,
                                                const Edge_split<Outgoing_halfedges::size_type>& r)
  {
    check_lengths_of_parts(h, t);
    const auto q = m_tri.part_of_input_edge(h).point(t, m_tri.input_mesh());
    const auto undo = m_tri.undo_of_split(h); // the courses of shared edges are empty
    const Vertex_index m = m_tri.insert_into_edge(h, n, r, q, {});
    m_courses.after_split(h);
    return m_tri.measured(m, m_decisions, undo);
  }

  // Splits an edge that is not shared. The rounded position of a vertex is not on such an edge. So
  // the vertex is inserted into the face beside it, and the edge is flipped if this is possible.
  template <typename Insert>
  BOOST_NOINLINE Vertex_index split_crossed_edge(Halfedge_index h, double t, double closeness,
                                                 const Insert& insert)
  {
    const Vertex_index m =
      insert_near(face_location(Edge_point<double>{h, t}, m_mesh), closeness, insert);
    try {
      if(can_be_flipped(h, false))
        flip(h);
    } catch(const Error&) { // its length, or its normal coordinate, is out of range: it stays
    }
    return m;
  }

  // Returns the vertex that `insert(location, closeness)` inserts at the point `p` of a face of T2.
  // Rounded to coordinates on T1, the point may lie outside of its region. Then points farther
  // inside the face are tried.
  // \throws Numerical_error if the face is so small that this does not help; T2 is unchanged
  template <typename Insert>
  BOOST_NOINLINE Vertex_index insert_near(const Face_location<double>& p, double closeness,
                                          const Insert& insert)
  {
    for(double inwards : inward_moves) {
      std::array<double, 3> b = p.second;
      for(double& x : b)
        x += inwards * (1. / 3 - x);
      // The face is laid out from the corner with the largest coordinate.
      const Halfedge_index h =
        sides(p.first,
              m_mesh)[static_cast<std::size_t>(std::max_element(b.begin(), b.end()) - b.begin())];
      const Developed_location<Traits> at(
        m_tri, m_courses, m_decisions.extended_corners(), h,
        coordinates_from(h, Face_location<double>(p.first, b), m_mesh));
      const Vertex_index m = insert(at, inwards > greatest_move_on_edge() ? 0 : closeness);
      if(m.is_valid())
        return m;
    }
    throw Numerical_error("rounded coordinates leave no position in face " +
                          std::to_string(p.first.idx()));
  }

  // Splits a face. Returns null and changes nothing if the new edges would not be straight, or a
  // face would not be positive.
  // \throws Numerical_error if this, or a length, cannot be decided; T2 is unchanged
  BOOST_NOINLINE Vertex_index split_face(Face_index f, const Face_split<Integer>& at,
                                         const Point_to_insert<double>& p)
  {
    const Halfedge_index first = m_mesh.halfedge(f);
    const Vertex_index m = m_tri.insert_into_face(f, at, p.on_input, {});
    m_courses.after_insertion(m);
    const auto undo = [&] { m_tri.take_back(m, first); };
    bool is_valid = false;
    change_or_undo([&] { is_valid = is_geodesic(m); }, undo);
    if(is_valid)
      return m_tri.measured(m, m_decisions, undo);
    undo();
    return {};
  }

  // Computes the lengths of the shared edges of a face that has replaced a vertex.
  BOOST_NOINLINE void after_removal(Face_index f)
  {
    for(Halfedge_index h : sides(f, m_mesh))
      if(m_tri.coordinates().is_shared(m_mesh.edge(h)))
        m_tri.m_length[m_mesh.edge(h)] = m_decisions.length(h);
  }

private:
  // Returns whether the edges at `m` are straight and its faces have positive area.
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

  // Checks that both parts of an edge, and the new edges beside it, are not too short. New edges
  // are measured only if their faces are small, because only then rounding can hide needles.
  // \throws Numerical_error if an edge is too short
  void check_lengths_of_parts(Halfedge_index h, double t) const
  {
    constexpr double small = 0x1p-100; // the least length is 2^-127
    const double length = m_tri.length(m_mesh.edge(h));
    checked_length(m_tri, t * length);
    checked_length(m_tri, (1 - t) * length);
    const auto check_apex = [&](Halfedge_index side, double along) {
      if(!m_mesh.is_border(side)) {
        const auto lengths = side_lengths(side, m_tri);
        if(*std::max_element(lengths.begin(), lengths.end()) < small)
          distance_to_apex(m_tri, side, along);
      }
    };
    check_apex(h, t);
    check_apex(m_mesh.opposite(h), 1 - t);
  }

  Triangulation& m_tri;
  const Delta_complex& m_mesh;
  Edge_courses<Traits>& m_courses;
  Decisions m_decisions;
};

// Names the changes with exact decisions, or the changes with rounded decisions if decisions cannot
// be exact.
template <typename Traits>
using Exact_insertion_of = std::conditional_t<has_exact_decisions<Traits>(),
                                              Exact_insertion<Traits>, Rounded_insertion<Traits>>;

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INSERTION_EXACT_INSERTION_H
