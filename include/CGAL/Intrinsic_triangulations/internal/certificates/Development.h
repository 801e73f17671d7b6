// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_DEVELOPMENT_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_DEVELOPMENT_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Edge_point.h>
#include <CGAL/Intrinsic_triangulations/Triangulation_pair.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/Input_corners.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Edge_courses.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

namespace CGAL::Intrinsic_triangulations::internal {

// Lays out triangles of T1 that edges and corners of T2 pass, around a vertex of T2 at the origin.
// The sequence of triangles is exact; `Corners` determines the numbers. Vectors from the origin
// and along sides have errors relative to their own lengths. So angles at the origin are accurate
// in the thinnest triangles.
template <typename Traits, typename Corners>
class Development
{
public:
  typedef typename Corners::Complex Complex;
  static constexpr bool is_rounded = Corners::is_rounded;

  // Represents a side of a triangle of T1, placed in the plane.
  struct Placed_side
  {
    Halfedge_index halfedge;
    Complex source, target, vector;
  };

  Development(const Triangulation_pair<Traits>& pair, const Edge_courses<Traits>& courses,
              Corners& corners)
    : m_pair(pair), m_input(pair.input_mesh()), m_courses(courses), m_corners(corners)
  {}

  template <typename Number>
  Complex number(const Number& x) const
  {
    return m_corners.number(x);
  }

  // Returns the first side of T1 clockwise from the halfedge `h` of T2, or at `h`. If the source of
  // `h` lies inside a face, returns any side of this face.
  Placed_side start(Halfedge_index h) const
  {
    const Vertex_index v = m_pair.mesh().source(h);
    const Halfedge_index outgoing = m_pair.input_outgoing_before(h);
    const Complex one = m_corners.number(1);
    if(!m_pair.is_inserted(v))
      return {outgoing, m_corners.number(0), one, one};
    if(outgoing.is_valid()) {
      const auto w = weights(outgoing, v);
      return {outgoing, -w[1], w[0], w[0] + w[1]};
    }
    // The position is computed from the nearest corner, so that the distance from it loses no
    // digits.
    const auto& p = std::get<Face_location<double>>(m_pair.inserted_vertex(v));
    const auto& b = p.second;
    const Halfedge_index side =
      sides(p.first, m_input)[std::size_t(std::max_element(b.begin(), b.end()) - b.begin())];
    const auto w = weights(side, p);
    return {side, -(scaled(w[1], side) + w[2] * at_source(side)),
            scaled(w[0], side) + w[2] * at_target(side), scaled(w[0] + w[1] + w[2], side)};
  }

  // Returns the square of the unit of positions around the source of the halfedge `h` of T2, the
  // length of the first side. Positions must be to scale.
  Complex squared_unit(Halfedge_index h) const
  {
    return m_corners.squared_length(start(h).halfedge);
  }

  typedef boost::container::small_vector<Placed_side, 4> Placed_sides;

  // Stores an edge of T2 from the origin and the sides of T1 that it crosses, each up to a positive
  // factor.
  struct Strip
  {
    Placed_side first;
    Placed_sides crossed;
    Complex end;
  };

  // Returns the strip of `h` without the sides that `h` crosses.
  Strip uncrossed_strip(Halfedge_index h) const
  {
    const Placed_side first = start(h);
    return {first, {}, end(h, first)};
  }

  Strip strip(Halfedge_index h) const { return strip(h, start(h)); }

  // Returns the strip of `h`, whose first triangle lies at `first`.
  Strip strip(Halfedge_index h, const Placed_side& first) const
  {
    Strip result{first, {}, m_corners.number(0)};
    result.end = end(h, first, &result.crossed);
    return result;
  }

  // Returns a number whose argument is the angle of T2 at the source of `h` in the face of `h`.
  Complex angle(Halfedge_index h) const
  {
    const auto [j, k] = ends(h);
    return k * conj(j);
  }

  // Returns the other two corners of the face ijk of `h`, whose source i is at the origin.
  std::pair<Complex, Complex> ends(Halfedge_index h) const
  {
    const Halfedge_index following = m_pair.mesh().opposite(m_pair.mesh().prev(h));
    const Placed_side side = start(h);
    return {end(h, side), end(following, following_side(h, side))};
  }

  // Returns the ends of `count` consecutive outgoing halfedges of T2, counterclockwise from `h`.
  // Their source is at the origin.
  boost::container::small_vector<Complex, 4> ends(Halfedge_index h, std::size_t count) const
  {
    boost::container::small_vector<Complex, 4> result;
    for(Placed_side side = start(h); result.size() < count;
        h = m_pair.mesh().opposite(m_pair.mesh().prev(h))) {
      if(!result.empty())
        side = following_side(m_pair.mesh().next(m_pair.mesh().opposite(h)), side);
      result.push_back(end(h, side));
    }
    return result;
  }

  // Returns the first side clockwise from the outgoing halfedge of T2 that follows `h`, or at it.
  // `side` is the corresponding side for `h`.
  Placed_side following_side(Halfedge_index h, Placed_side side) const
  {
    const Delta_complex& mesh = m_pair.mesh();
    const std::size_t outgoing_halfedges =
      static_cast<std::size_t>(m_pair.coordinates().curves_leaving(mesh.next(h), mesh)) +
      m_pair.coordinates().is_shared(mesh.edge(mesh.prev(h)));
    const bool is_inserted = m_pair.is_inserted(mesh.source(h));
    Halfedge_index outgoing = side.halfedge;
    for(std::size_t s = outgoing_halfedges; s > 0; --s)
      if(is_inserted)
        side = beyond(std::move(side));
      else {
        const Halfedge_index last = m_input.prev(outgoing);
        outgoing = m_input.opposite(last);
        if(s == 1 || !m_corners.is_flat(last))
          side = outgoing_in_face(side, last);
      }
    return side;
  }

  // Returns the next outgoing halfedge around the origin, counterclockwise.
  Placed_side following_outgoing(const Placed_side& side, bool is_inserted) const
  {
    return is_inserted ? beyond(side) : outgoing_in_face(side, m_input.prev(side.halfedge));
  }

  // Returns the corner of the triangle opposite to `side`.
  Complex apex(const Placed_side& side) const
  {
    const Halfedge_index h = side.halfedge;
    return is_rounded && !is_apex_near_source(h)
             ? scaled(side.target, h) - side.vector * at_target(h)
             : scaled(side.source, h) + side.vector * at_source(h);
  }

  // Returns the point of the triangle of `side` with the barycentric coordinates `w`, divided by
  // their sum. The coordinates begin with the source of `side`.
  Complex point(const Placed_side& side, const std::array<Complex, 3>& w) const
  {
    return scaled(w[0] * side.source + w[1] * side.target, side.halfedge) + w[2] * apex(side);
  }

  // Returns the triangle on the other side of `side`.
  Placed_side beyond(Placed_side side) const
  {
    return {m_input.opposite(side.halfedge), std::move(side.target), std::move(side.source),
            -std::move(side.vector)};
  }

  // Returns barycentric coordinates divided by their sum, up to a common positive factor.
  std::array<Complex, 3> weights(const std::array<double, 3>& b) const
  {
    return m_corners.weights(b);
  }

private:
  // Returns the position of the end of `h` if its first triangle lies at `side`. Appends the sides
  // of T1 that `h` crosses to `crossed`.
  Complex end(Halfedge_index h, Placed_side side, Placed_sides* crossed = nullptr) const
  {
    const Delta_complex& mesh = m_pair.mesh();
    if(m_pair.coordinates().is_shared(mesh.edge(h)))
      return end_along(side, mesh.target(h));
    const Edge_course course = m_courses(h);
    const bool ends_inside = m_pair.is_inserted(mesh.target(h));
    for(std::size_t m = 0; m < course.size(); ++m) {
      const Halfedge_index exit = course[m];
      const bool stays = m_corners.is_flat(exit) && !(ends_inside && m + 1 == course.size());
      if(stays && crossed == nullptr)
        continue;
      Placed_side passed = other_side(side, exit);
      if(crossed != nullptr)
        crossed->push_back(passed);
      if(!stays)
        side = beyond(std::move(passed));
    }
    return place(mesh.opposite(h), side);
  }

  Complex at_source(Halfedge_index h) const { return m_corners.at_source(h); }
  Complex at_target(Halfedge_index h) const { return conj(m_corners.at_target(h)); }

  // Returns the barycentric coordinates of a point, beginning with the source of `side`. Their sum
  // is exactly one.
  std::array<Complex, 3> weights(Halfedge_index side, const Face_location<double>& p) const
  {
    return weights(coordinates_from(side, p, m_input));
  }

  // Returns the coordinates of a vertex that was inserted on the edge of `side`. Only the first two
  // are not zero.
  std::array<Complex, 3> weights(Halfedge_index side, Vertex_index inserted) const
  {
    const auto& [u, v] = m_pair.on_input_edge(side, inserted).weight;
    return weights({u, v, 0});
  }

  // Returns the coordinates of the source of the halfedge `back` of T2, which leads into the
  // triangle of `side`. On an edge of T1, both coordinates are read from the input. Neither is
  // computed from the other, so that both faces of the edge agree.
  std::array<Complex, 3> weights_in_triangle(Halfedge_index side, Halfedge_index back) const
  {
    const Vertex_index v = m_pair.mesh().source(back);
    const Halfedge_index outgoing = m_pair.input_outgoing_before(back);
    if(!outgoing.is_valid())
      return weights(side, std::get<Face_location<double>>(m_pair.inserted_vertex(v)));
    const auto w = weights(outgoing, v);
    const Complex zero = m_corners.number(0);
    return outgoing == side                 ? std::array<Complex, 3>{w[0], w[1], zero}
           : outgoing == m_input.next(side) ? std::array<Complex, 3>{zero, w[0], w[1]}
                                            : std::array<Complex, 3>{w[1], zero, w[0]};
  }

  // Returns `z` in the scale of positions to which a corner of the triangle of `h` has contributed.
  Complex scaled(const Complex& z, Halfedge_index h) const { return m_corners.scaled(z, h); }

  // The third corner of a triangle is computed from the nearer end of the side.
  bool is_apex_near_source(Halfedge_index h) const
  {
    return m_pair.input_length(m_input.edge(m_input.prev(h))) <
           m_pair.input_length(m_input.edge(m_input.next(h)));
  }

  // Returns the outgoing halfedge opposite to the halfedge `last`, which ends at the origin in the
  // same face.
  Placed_side outgoing_in_face(const Placed_side& side, Halfedge_index last) const
  {
    const Complex end = side.vector * m_corners.from_source(side.halfedge, last);
    return {m_input.opposite(last), side.source, end, end};
  }

  // Returns the position of the source of `h`, a halfedge of the same face.
  Complex place_of_source(Halfedge_index h, const Placed_side& side) const
  {
    return h == side.halfedge                 ? side.source
           : h == m_input.next(side.halfedge) ? side.target
           : h == m_input.prev(side.halfedge)
             ? apex(side)
             : scaled(side.source, side.halfedge) +
                 side.vector * m_corners.from_source(side.halfedge, h);
  }

  // Returns the side `exit` of the face.
  Placed_side other_side(const Placed_side& side, Halfedge_index exit) const
  {
    const Halfedge_index h = side.halfedge;
    if(exit == h)
      return side;
    if constexpr(!is_rounded) {
      const Complex from_source = m_corners.from_source(h, exit),
                    source = scaled(side.source, h) + side.vector * from_source,
                    vector =
                      side.vector * (m_corners.from_source(h, m_input.next(exit)) - from_source);
      return {exit, source, source + vector, vector};
    } else {
      const bool is_next = exit == m_input.next(h);
      const Complex to_apex = is_next ? -(side.vector * at_target(h)) : side.vector * at_source(h);
      const Complex end = is_next ? side.target : side.source;
      const Complex corner = is_next == is_apex_near_source(h) ? apex(side) : end + to_apex;
      return is_next ? Placed_side{exit, end, corner, to_apex}
                     : Placed_side{exit, corner, end, -to_apex};
    }
  }

  // Returns the position of the vertex `v`, which lies beyond the origin on `side`.
  Complex end_along(const Placed_side& side, Vertex_index v) const
  {
    if(!m_pair.is_inserted(v))
      return side.target;
    const auto w = weights(side.halfedge, v);
    return w[0] * side.source + w[1] * side.target;
  }

  // Returns the position of the source of the halfedge `back` of T2, which leads into the triangle.
  Complex place(Halfedge_index back, const Placed_side& side) const
  {
    return m_pair.is_inserted(m_pair.mesh().source(back))
             ? point(side, weights_in_triangle(side.halfedge, back))
             : place_of_source(m_pair.input_outgoing_before(back), side);
  }

  const Triangulation_pair<Traits>& m_pair;
  const Delta_complex& m_input;
  const Edge_courses<Traits>& m_courses;
  Corners& m_corners;
};

// Returns a complex number whose argument is the sum of the angles between the outgoing halfedges.
template <typename Fan, typename Layout>
auto turn_over(const Fan& outgoing, const Layout& layout)
{
  auto product = layout.angle(outgoing[0]);
  for(std::size_t i = 1; i + 1 < outgoing.size(); ++i)
    product = product * layout.angle(outgoing[i]);
  return product;
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_DEVELOPMENT_H
