// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_CERTAIN_MEASURES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_CERTAIN_MEASURES_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Triangulation_pair.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/Certain_strip.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/Development.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/Input_corners.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/flipped_length.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Edge_courses.h>
#include <CGAL/Intrinsic_triangulations/tolerances.h>

#include <CGAL/Uncertain.h>
#include <CGAL/enum.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <optional>
#include <string>
#include <utility>

namespace CGAL::Intrinsic_triangulations::internal {

// Computes lengths, angles and corners of T2. Each is laid out from the metric of T1 with as many
// digits as its rounded value needs.
template <typename Traits>
class Certain_measures
{
  typedef Triangulation_pair<Traits> Pair;
  typedef Input_metric_of<Traits> Metric;

protected:
  template <typename N>
  using Rounded = Rounded_corners<N, typename Metric::Number>;

public:
  Certain_measures(const Certain_measures&) = delete;
  Certain_measures& operator=(const Certain_measures&) = delete;

  // Returns whether the edge of `h` is a whole edge of T1.
  bool is_input_edge(Halfedge_index h) const
  {
    return m_pair.coordinates().is_shared(m_mesh.edge(h)) && !has_inserted_end(h);
  }

  // Returns the length of the edge of `h` and whether it is certainly straight, at the least cost.
  Straight_edge straight_edge(Halfedge_index h) const
  {
    if(is_input_edge(h))
      return {true, m_pair.input_length(m_pair.input_mesh().edge(input_edge_as_long(h))),
              input_length_error()};
    if(has_certain_strip(h))
      return m_strip(m_courses(h), certified_length_error());
    const auto strip = development(m_double).strip(h);
    return {certainly(straightness(strip) == POSITIVE), rounded_length(strip, m_double),
            certified_length_error()};
  }

  // Returns the length of the edge of `h`, correct to a relative error of `error`.
  // \throws Numerical_error if it is not positive and finite
  double length(Halfedge_index h, double error = certified_length_error()) const
  {
    return bounded_length(h, error).length;
  }

  // Returns the length of the edge of `h` with a bound for its error, at most `error`.
  Bounded_length bounded_length(Halfedge_index h, double error = certified_length_error()) const
  {
    if(m_pair.coordinates().is_shared(m_mesh.edge(h)))
      return {shared_length(h), is_input_edge(h) ? input_length_error() : error};
    Bounded_length result{std::numeric_limits<double>::quiet_NaN(), error};
    if(has_certain_strip(h)) {
      const Straight_edge straight = m_strip(m_courses(h), error);
      result = {straight.length, straight.error};
    }
    if(std::isnan(result.length))
      try_with_more_digits([&](auto& corners) {
        result = {rounded_length(development(corners).uncrossed_strip(h), corners, error), error};
        return !std::isnan(result.length);
      });
    if(!m_pair.traits().is_length_object()(result.length))
      throw Numerical_error("edge " + std::to_string(m_mesh.edge(h).idx()) +
                            " has no positive finite length");
    return result;
  }

  // Returns the length of the edge of `h`, which is shared. It may be too short to be positive.
  double shared_length(Halfedge_index h) const
  {
    return m_pair.part_of_input_edge(h).length(m_pair.input_length_map());
  }

  // Returns the angle at the source of `h` in its face, between 0 and pi, up to about `error`. If
  // it is near to 0 or pi, rounding can make the corner clockwise.
  double rounded_angle(Halfedge_index h, double error = certified_length_error()) const
  {
    const auto absolute_value = [](const std::complex<double>& corner) { return std::abs(corner); };
    return std::abs(std::arg(rounded_corner(h, absolute_value, error).first));
  }

  // Returns the angle at the source of the halfedge `h` of T1 in its face, between 0 and pi.
  double input_angle(Halfedge_index h) const
  {
    double angle = 0;
    try_with_more_digits([&](auto& corners) {
      const auto corner = corners.at_source(h);
      angle = std::abs(std::atan2(to_double(corner.y), to_double(corner.x)));
      return corner.radius <= corner.norm() * certified_length_error();
    });
    return angle;
  }

  // Returns (k - i) / (j - i) for the face ijk of the halfedge `h` from i to j. Its imaginary part
  // is correct up to a small relative error. It is zero if no digits prove that it is not, as for
  // a face without area.
  std::complex<double> rounded_corner(Halfedge_index h) const
  {
    const auto imaginary_part = [](const std::complex<double>& corner) { return corner.imag(); };
    const auto [corner, error] = rounded_corner(h, imaginary_part, certified_length_error());
    return {corner.real(), std::abs(corner.imag()) > error ? corner.imag() : 0};
  }

  // Returns the circumradius of the face `f`; infinite if it has no area.
  double rounded_circumradius(Face_index f) const
  {
    const Halfedge_index h = shortest_side(f);
    const std::complex<double> corner = rounded_corner(h);
    return corner.imag() > 0 ? m_pair.length(m_mesh.edge(h)) * std::abs(corner) *
                                 std::abs(corner - 1.0) / (2 * corner.imag())
                             : std::numeric_limits<double>::infinity();
  }

  // Returns the side from which a face is laid out without loss of digits.
  Halfedge_index shortest_side(Face_index f) const
  {
    const auto side = sides(f, m_mesh);
    return *std::min_element(side.begin(), side.end(), [&](Halfedge_index a, Halfedge_index b) {
      return m_pair.length(m_mesh.edge(a)) < m_pair.length(m_mesh.edge(b));
    });
  }

  // Returns the stored corners of T1 with more digits than `double` has.
  Rounded<Double_double>& extended_corners() const { return m_extended; }

protected:
  // Without `courses`, the courses of edges are computed when they are read.
  explicit Certain_measures(const Pair& pair, const Edge_courses<Traits>* courses = nullptr)
    : m_pair(pair),
      m_mesh(pair.mesh()),
      m_metric(pair.input_metric()),
      m_courses(courses != nullptr ? *courses : m_own_courses.emplace(pair)),
      m_strip(exact_input(pair)),
      m_double(exact_input(pair)),
      m_extended(exact_input(pair)),
      m_long(exact_input(pair))
  {}

  bool has_inserted_end(Halfedge_index h) const
  {
    return m_mesh.num_vertices() > m_pair.input_mesh().num_vertices() &&
           (m_pair.is_inserted(m_mesh.source(h)) || m_pair.is_inserted(m_mesh.target(h)));
  }

  template <typename Corners>
  auto development(Corners& corners) const
  {
    return Development<Traits, Corners>(m_pair, m_courses, corners);
  }

  // Calls `attempt(corners)` with corners of more and more digits until it returns true.
  template <typename Attempt>
  void try_with_more_digits(const Attempt& attempt) const
  {
    if(!attempt(m_double))
      try_with_many_digits(attempt);
  }

  // Calls `attempt(corners)` until it returns true, but never with corners of type `double`.
  template <typename Attempt>
  void try_with_many_digits(const Attempt& attempt) const
  {
    if(!attempt(m_extended))
      attempt(m_long);
  }

  template <typename Strip>
  static Uncertain<Sign> straightness(const Strip& strip)
  {
    const auto direction = conj(strip.end);
    Sign least = POSITIVE;
    bool is_known = true;
    for(const auto& side : strip.crossed)
      for(const Uncertain<Sign> sign :
          {sign_of_imaginary(direction, side.target), -sign_of_imaginary(direction, side.source)}) {
        is_known = is_known && is_certain(sign);
        if(is_certain(sign))
          least = (std::min)(least, get_certain(sign));
      }
    return is_known || least == NEGATIVE ? Uncertain<Sign>(least)
                                         : Uncertain<Sign>::indeterminate();
  }

  const Pair& m_pair;
  const Delta_complex& m_mesh;
  const Metric& m_metric;
  std::optional<Edge_courses<Traits>> m_own_courses;
  const Edge_courses<Traits>& m_courses;

private:
  // Returns a halfedge of T1 as long as the edge of `h`, which is an edge of T1. With positions,
  // all edges between the same vertices have this length. Most edges keep their indices, so a
  // search around a vertex is rarely needed.
  Halfedge_index input_edge_as_long(Halfedge_index h) const
  {
    const Delta_complex& input = m_pair.input_mesh();
    const bool joins_the_same = !m_metric.points.empty() && h.idx() < input.num_halfedges() &&
                                input.source(h) == m_mesh.source(h) &&
                                input.target(h) == m_mesh.target(h);
    return joins_the_same ? h : m_pair.input_halfedge(h);
  }

  // Returns whether an edge without inserted ends crosses triangles whose sides are known in
  // `double`.
  bool has_certain_strip(Halfedge_index h) const
  {
    return m_courses.count(h) > 0 && !has_inserted_end(h) && m_metric.squared_lengths.empty();
  }

  // Returns a corner and its error, which is at most `error` times `size(corner)` if more digits
  // can help.
  template <typename Size>
  std::pair<std::complex<double>, double> rounded_corner(Halfedge_index h, const Size& size,
                                                         double error) const
  {
    std::pair<std::complex<double>, double> result;
    try_with_more_digits([&](auto& corners) {
      const auto [j, k] = development(corners).ends(h);
      const auto product = k * conj(j), square = j * conj(j);
      const auto quotient = [&](const auto& x) {
        return to_double(decltype(square.x)(x / square.x));
      };
      result = {{quotient(product.x), quotient(product.y)}, product.radius / to_double(square.x)};
      return result.second <= size(result.first) * error;
    });
    return result;
  }

  // Returns the length of an edge laid out in a strip, or NaN if its relative error may exceed
  // `error`.
  template <typename Strip, typename Corners>
  static double rounded_length(const Strip& strip, const Corners& corners,
                               double error = certified_length_error())
  {
    const auto length = root(strip.end * conj(strip.end)) * corners.length(strip.first.halfedge);
    const double midpoint = to_double(length.x);
    return length.radius <= midpoint * error / 2 ? midpoint
                                                 : std::numeric_limits<double>::quiet_NaN();
  }

  mutable Certain_strip<typename Metric::Number> m_strip;
  mutable Rounded<double> m_double;
  mutable Rounded<Double_double> m_extended;
  mutable Rounded<Long_float> m_long;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_CERTAIN_MEASURES_H
