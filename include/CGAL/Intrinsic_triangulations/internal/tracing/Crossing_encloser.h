// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_CROSSING_ENCLOSER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_CROSSING_ENCLOSER_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Edge_point.h>
#include <CGAL/Intrinsic_triangulations/Triangulation_pair.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/Exact_decisions.h>

#include <CGAL/Interval_nt.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Computes the positions of crossings from the metric of T1, with the errors of numbers of type
// `N`.
template <typename Traits, typename N>
class Crossing_enclosure
{
  typedef Triangulation_pair<Traits> Pair;
  typedef Rounded_corners<N, typename Pair::Metric::Number> Corners;
  typedef Exact_decisions<Traits> Decisions;
  typedef Trace_point<Interval_nt<>> Enclosure;

public:
  Crossing_enclosure(const Pair& pair, const Edge_courses<Traits>& courses)
    : m_corners(exact_input(pair)), m_development(pair, courses, m_corners)
  {}

  // Returns the positions of the crossings on the halfedge `h` of T2, the first of its edge.
  std::vector<Enclosure> operator()(Halfedge_index h)
  {
    const auto from_source = m_development.strip(h);
    const auto from_target = m_development.strip(opposite(h));
    const auto direction = conj(from_source.end);
    const std::size_t n = from_source.crossed.size();
    std::vector<Enclosure> result;
    for(std::size_t m = 0; m < n; ++m)
      result.push_back(place(h, direction, from_source.crossed[m], from_target.crossed[n - 1 - m]));
    return result;
  }

private:
  // Returns the position where `h`, which has the given direction, passes a side of T1. The side is
  // seen from both ends of `h`.
  template <typename Complex, typename Side>
  static Enclosure place(Halfedge_index h, const Complex& direction, const Side& near,
                         const Side& far)
  {
    auto right = -(direction * near.source), left = direction * near.target;
    if(!is_first_halfedge(near.halfedge))
      std::swap(left, right);
    return {{first_halfedge(Edge_index(near.halfedge)), part(right, left)},
            {h, part(Decisions::height(near) * Decisions::squared_length(far),
                     Decisions::height(far) * Decisions::squared_length(near))}};
  }

  // Returns a / (a + b) for the imaginary parts of `a` and `b`, which are not negative. The
  // quotient of sums is rounded a few times.
  static Interval_nt<> part(const Ball<N>& a, const Ball<N>& b)
  {
    const N error(16 * Rounding<N>::unit());
    const N lower = quotient(least(a), greatest(b), N(0)),
            upper = quotient(greatest(a), least(b), N(1));
    return {rounded(N(lower - error * lower)).first,
            (std::min)(rounded(N(upper + error * upper)).second, 1.)};
  }

  static std::pair<double, double> rounded(const N& x)
  {
    if constexpr(std::is_same_v<N, Double_double>) {
      constexpr double infinity = std::numeric_limits<double>::infinity();
      return {std::nextafter(x.high(), -infinity), std::nextafter(x.high(), infinity)};
    } else
      return CGAL::to_interval(x);
  }

  static N quotient(const N& a, const N& b, const N& otherwise)
  {
    return a + b > N(0) ? N(a / (a + b)) : otherwise;
  }

  static N least(const Ball<N>& a) { return (std::max)(N(a.y - N(a.radius)), N(0)); }
  static N greatest(const Ball<N>& a) { return (std::max)(N(a.y + N(a.radius)), N(0)); }

  Corners m_corners;
  Development<Traits, Corners> m_development;
};

// A number of type `double` may lie between two that enclose it.
inline bool is_narrow(const Interval_nt<>& place, double width)
{
  return place.sup() - place.inf() <= width ||
         std::nextafter(std::nextafter(place.inf(), 1.), 1.) >= place.sup();
}

inline bool is_narrow(const Trace_point<Interval_nt<>>& place, double width)
{
  return is_narrow(place.on_input.t, width) && is_narrow(place.on_intrinsic.t, width);
}

// Encloses crossings of many edges, with as many digits as needed.
template <typename Traits>
class Crossing_encloser
{
  typedef Triangulation_pair<Traits> Pair;
  typedef std::vector<Trace_point<Interval_nt<>>> Enclosures;

public:
  Crossing_encloser(const Pair& pair, const Edge_courses<Traits>& courses)
    : m_pair(pair), m_courses(courses), m_in_double(pair, courses), m_extended(pair, courses)
  {}

  // Returns the positions of the crossings on the halfedge `h` of T2, the first of its edge. Each
  // is an interval of this width, or a wider one if `most_digits` do not suffice.
  Enclosures operator()(Halfedge_index h, double width)
  {
    const Enclosures result = with_few_digits(h, width);
    return are_narrow(result, width) ? result
                                     : Crossing_enclosure<Traits, Long_float>(m_pair, m_courses)(h);
  }

  // Returns enclosures of the crossings of `h` with at most 106 bits if `h` passes a face without
  // area. If `h` runs along an edge, more bits do not help.
  Enclosures with_digits_that_help(Halfedge_index h, double width)
  {
    Enclosures result = with_few_digits(h, width);
    return are_narrow(result, width) || passes_flat_face(h) ? result : (*this)(h, width);
  }

private:
  static bool are_narrow(const Enclosures& places, double width)
  {
    return std::all_of(places.begin(), places.end(),
                       [&](const auto& place) { return is_narrow(place, width); });
  }

  Enclosures with_few_digits(Halfedge_index h, double width)
  {
    if(m_courses.count(h) == 0)
      return {};
    Enclosures result = m_in_double(h);
    return are_narrow(result, width) ? result : m_extended(h);
  }

  bool passes_flat_face(Halfedge_index h) const
  {
    const Delta_complex& input = m_pair.input_mesh();
    const Edge_course course = m_courses(h);
    for(std::size_t m = 0; m < course.size(); ++m)
      for(const Halfedge_index side : {course[m], opposite(course[m])})
        if(!input.is_border(side) && area_sign(side, exact_input(m_pair)) == ZERO)
          return true;
    return false;
  }

  const Pair& m_pair;
  const Edge_courses<Traits>& m_courses;
  Crossing_enclosure<Traits, double> m_in_double;
  Crossing_enclosure<Traits, Double_double> m_extended;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TRACING_CROSSING_ENCLOSER_H
