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
#include <CGAL/Intrinsic_triangulations/internal/insertion/Developed_location.h>
#include <CGAL/Intrinsic_triangulations/internal/insertion/Rounded_insertion.h>
#include <CGAL/Intrinsic_triangulations/internal/insertion/face_splits.h>
#include <CGAL/Intrinsic_triangulations/internal/insertion/inserted_outgoing_halfedges.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Edge_courses.h>
#include <CGAL/Intrinsic_triangulations/tolerances.h>

#include <boost/config.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>

namespace CGAL::Intrinsic_triangulations::internal {

// Changes T2 with exact decisions, and with lengths that have errors of at most
// `certified_length_error()`. All functions read stored courses. None is inlined, because exact
// decisions are rare.
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

  // Checks that neither part of an edge is too short, and no new edge beside it. New edges are
  // measured only if their faces are small, because rounding could hide needles elsewhere.
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
