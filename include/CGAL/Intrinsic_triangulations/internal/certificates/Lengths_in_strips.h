// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_LENGTHS_IN_STRIPS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_LENGTHS_IN_STRIPS_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Triangulation_pair.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/Exact_decisions.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/flipped_length.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Edge_courses.h>
#include <CGAL/Intrinsic_triangulations/tolerances.h>
#include <CGAL/Intrinsic_triangulations/triangle_formulas.h>

#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Computes the length of each edge of T2 in the strip of triangles of T1 that the edge crosses.
template <typename Traits>
class Lengths_in_strips
{
  typedef Triangulation_pair<Traits> Pair;
  typedef typename Traits::FT FT;

public:
  explicit Lengths_in_strips(const Pair& pair) : m_pair(pair), m_courses(pair, Concurrency()) {}

  // Returns the length of the edge of `h`.
  // \throws Numerical_error if it is not positive and finite
  FT operator()(Halfedge_index h)
  {
    const FT length = rounded_length(h);
    if(!m_pair.traits().is_length_object()(length))
      throw Numerical_error("the strip of edge " + std::to_string(m_pair.mesh().edge(h).idx()) +
                            " has no positive finite length");
    return length;
  }

  // Returns the length of the edge of `h`, computed in floating point, and whether it is certainly
  // straight. The length may have a relative error of `tolerance`.
  Straight_edge straight_edge(Halfedge_index h, double tolerance)
  {
    const double length = rounded_length(h);
    return {m_pair.traits().is_length_object()(length) && is_certain(h, length, tolerance), length,
            tolerance};
  }

  // Returns whether the edge of `h`, whose length has just been computed, is certainly straight.
  // Also, the relative error of `length` must be at most `tolerance`, for any rounding.
  bool is_certain(Halfedge_index h, double length, double tolerance)
  {
    const Delta_complex &mesh = m_pair.mesh(), &input = m_pair.input_mesh();
    const bool is_shared = m_pair.coordinates().is_shared(mesh.edge(h));
    if(is_shared && !m_pair.is_inserted(mesh.source(h)) && !m_pair.is_inserted(mesh.target(h)))
      return true;
    if(is_shared)
      return length * tolerance >=
             m_pair.input_length(input.edge(m_pair.input_outgoing_before(h))) *
               rounding_unit<double>();
    if(!is_inside(mesh.source(h)) || !is_inside(mesh.target(h)))
      return false;
    const Edge_course course = m_courses(h);
    if(course.empty()) {
      const auto [a, b, c] = side_lengths(input.halfedge(m_face), m_pair.input());
      return (a + b + c) * angle_error(m_face) <= tolerance * length;
    }
    double error = angle_error(input.face(course[0]));
    for(std::size_t m = 0; m < course.size(); ++m)
      error += angle_error(input.face(opposite(course[m])));
    return m_strip.is_certain(error, tolerance);
  }

  // Returns the courses of the edges whose lengths have been computed.
  Edge_courses<Traits> courses() && { return std::move(m_courses); }

private:
  FT rounded_length(Halfedge_index h)
  {
    return m_pair.coordinates().is_shared(m_pair.mesh().edge(h)) ? m_pair.shared_length(h)
           : m_courses.count(h) == 0                             ? length_in_face(h)
                                     : m_pair.lay_out(m_strip, h, m_courses(h));
  }

  // Returns whether the vertex `v` of T2 is not on the boundary of the triangle of T1 that contains
  // it.
  bool is_inside(Vertex_index v) const
  {
    if(!m_pair.is_inserted(v))
      return true;
    const auto* inside = std::get_if<Face_location<FT>>(&m_pair.inserted_vertex(v));
    return !inside || (inside->second[0] > 0 && inside->second[1] > 0 && inside->second[2] > 0);
  }

  // Returns a bound for the errors of the angles and sides of a triangle of T1, from its lengths
  // and the formulas. The error of an angle with opposite side a is a (a + b + c) / (2 area) times
  // the error of a length. If rounding can change the area by more than a small part, the bound is
  // infinite.
  float angle_error(Face_index f)
  {
    if(m_angle_error.empty())
      m_angle_error.resize(m_pair.input_mesh().num_faces(), 0);
    float& error = m_angle_error[f];
    if(error == 0) {
      const auto [a, b, c] = side_lengths(m_pair.input_mesh().halfedge(f), m_pair.input());
      const double perimeter = a + b + c;
      const double bound =
        4 * input_length_error() * perimeter * perimeter / quadrupled_area(a, b, c);
      error = bound < known_angle_error() ? static_cast<float>(bound)
                                          : std::numeric_limits<float>::infinity();
    }
    return error;
  }

  // Returns the length of the edge of `h` inside a face of T1. Returns 0, which is not a length, if
  // no vertices can be inserted.
  FT length_in_face([[maybe_unused]] Halfedge_index h)
  {
    if constexpr(Has_distance<Traits>::value) {
      const Face_location<FT> start = m_pair.input_location(h);
      m_face = start.first;
      return m_pair.distance(start, m_pair.input_location(m_pair.mesh().opposite(h)));
    } else
      return FT(0);
  }

  const Pair& m_pair;
  Edge_courses<Traits> m_courses;
  typename Traits::Geodesic_strip m_strip;
  Face_index m_face;                // the face of the last edge without crossings
  std::vector<float> m_angle_error; // of faces of T1; 0 if it has not been computed
};

// Calls `use(length)` with a function that returns the lengths of edges. They are exact up to
// rounding for exact traits.
template <typename Traits, typename Use>
void with_lengths_in_strips(const Triangulation_pair<Traits>& pair, const Use& use)
{
  if constexpr(Is_exact<Traits>::value) {
    const Edge_courses<Traits> courses(pair, Concurrency());
    const Exact_decisions<Traits> decisions(pair, courses);
    use([&](Halfedge_index h) { return decisions.length(h); });
  } else
    use(Lengths_in_strips<Traits>(pair));
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_LENGTHS_IN_STRIPS_H
