// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_EXACT_DECISIONS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_EXACT_DECISIONS_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Edge_stack.h>
#include <CGAL/Intrinsic_triangulations/Euclidean_geometry_traits.h>
#include <CGAL/Intrinsic_triangulations/Triangulation_pair.h>
#include <CGAL/Intrinsic_triangulations/corner_formulas.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/Certain_measures.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/Development.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/Input_corners.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/exact_squares.h>
#include <CGAL/Intrinsic_triangulations/tolerances.h>

#include <CGAL/Uncertain.h>
#include <CGAL/enum.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>

namespace CGAL::Intrinsic_triangulations::internal {

// Counts the decisions that were made at each stage.
struct Decision_count
{
  std::size_t floating_point = 0, multiprecision = 0, exact = 0;
};

// Decides predicates of T2 from the metric of T1. Decisions use floating point with error bounds,
// then more and more digits, and finally exact numbers.
template <typename Traits>
class Exact_decisions : public Certain_measures<Traits>
{
  typedef Certain_measures<Traits> Base;
  typedef Triangulation_pair<Traits> Pair;
  typedef Input_metric_of<Traits> Metric;
  typedef typename Metric::Number Number;
  typedef Ring_of<Number> K;
  template <typename N>
  using Rounded = typename Base::template Rounded<N>;
  using Base::has_inserted_end;
  using Base::m_courses;
  using Base::m_metric;
  using Base::m_pair;
  using Base::straightness;

protected:
  using Base::development;
  using Base::m_mesh;
  using Base::try_with_more_digits;

public:
  // Up to `few_roots` independent square roots are faster than many digits. `many_roots` is the
  // maximum. Each further root triples the cost.
  static constexpr std::size_t few_roots = 2, many_roots = 12;
  // Exact numbers of strips with more vectors take seconds. Exact traits take any time.
  static constexpr std::size_t most_vectors =
    Is_exact<Traits>::value ? (std::numeric_limits<std::size_t>::max)() : 4000;

  using Base::is_input_edge;
  using Base::rounded_angle;

  // The courses of edges are computed when a decision first needs them.
  explicit Exact_decisions(const Pair& pair)
    : Base(pair), m_is_flat(m_metric.points, pair.input_mesh())
  {}

  Exact_decisions(const Pair& pair, const Edge_courses<Traits>& courses)
    : Base(pair, &courses), m_is_flat(m_metric.points, pair.input_mesh())
  {}

  // Leaves decisions open that need more than `most_digits` binary digits and more roots. Such a
  // decision is almost certainly a tie.
  void allow_roots(std::size_t most = few_roots) { m_most_roots = most; }

  // Returns whether the edge of `h`, which can be flipped, is locally Delaunay. The stored lengths
  // decide if their errors allow it.
  bool is_Delaunay(Halfedge_index h)
  {
    const Euclidean_geometry_traits<double>::Is_locally_Delaunay by_lengths{
      certified_length_error()};
    const Diamond<double> lengths = diamond(m_pair.length_map(), h, m_mesh);
    return by_lengths.is_certain(lengths) || (by_lengths(lengths) && is_exactly_Delaunay(h));
  }

  // Returns whether the edge of `h` is locally Delaunay, independently of the stored lengths. An
  // edge that all digits and few roots leave undecided counts as a tie: it remains. Certificates
  // decide it with many roots. Exact traits leave none undecided.
  bool is_exactly_Delaunay(Halfedge_index h, bool has_exact_squares = false)
  {
    if(has_exact_squares || Is_exact<Traits>::value)
      return (has_exact_squares ? Delaunay_sign_by_squares(h) : Delaunay_sign(h)) != NEGATIVE;
    bool result = true;
    const std::size_t most = std::exchange(m_most_roots, few_roots);
    try {
      result = Delaunay_sign(h) != NEGATIVE;
    } catch(const Numerical_error&) { // result stays true
    }
    m_most_roots = most;
    return result;
  }

  // Returns the sign of pi minus the sum of the angles opposite to the edge of `h`: ZERO is a tie.
  Sign Delaunay_sign(Halfedge_index h)
  {
    const auto is_exact = [this](Edge_index e) { return has_exact_square(m_mesh.halfedge(e)); };
    const auto around = edges_around(h, m_mesh);
    return is_exact(m_mesh.edge(h)) && std::all_of(around.begin(), around.end(), is_exact)
             ? Delaunay_sign_by_squares(h)
             : compare_with_pi(m_mesh.prev(h), m_mesh.prev(m_mesh.opposite(h)));
  }

  // Returns whether the edge of `h` is a straight line in space between vertices of T1.
  bool is_straight_in_space(Halfedge_index h)
  {
    return !m_metric.points.empty() && !has_inserted_end(h) && has_exact_square(h);
  }

  // Returns the Delaunay sign of `h` from squared lengths. The edges of its diamond are edges of T1
  // or straight lines in space.
  Sign Delaunay_sign_by_squares(Halfedge_index h)
  {
    ++m_count.exact;
    if(!m_metric.points.empty()) {
      if(has_inserted_corner(h))
        return sign_by_places(h);
      const auto [i, j, k, l] = corner_positions(h, m_metric.points, m_mesh);
      return compare_opposite_angles(i, j, k, l);
    }
    return m_metric.squared_lengths.empty() ? sign_by_squares<Exact_ring>(h)
                                            : sign_by_squares<K>(h);
  }

  // Returns the sign of pi minus the angle of the union of the two faces of `h` at its source.
  Sign convexity_at_source(Halfedge_index h)
  {
    const Halfedge_index following = m_mesh.next(m_mesh.opposite(h));
    return is_straight_corner(m_mesh.prev(h), following) ? ZERO : compare_with_pi(h, following);
  }

  // Returns whether the union of the two faces of `h` is strictly convex at its ends.
  bool is_convex(Halfedge_index h)
  {
    return convexity_at_source(h) == POSITIVE &&
           convexity_at_source(m_mesh.opposite(h)) == POSITIVE;
  }

  // Returns the sign of pi minus the sum of the angles between consecutive outgoing halfedges.
  template <typename Fan>
  Sign fan_sign(const Fan& outgoing)
  {
    const double rest = pi<double>() - rounded_fan_angle(outgoing);
    return std::abs(rest) > fan_tolerance()
             ? CGAL::sign(rest)
             : decide([&](const auto& development) {
                 return sign_of_imaginary(turn_over(outgoing, development));
               });
  }

  // Returns whether the fan sign is POSITIVE. If many digits are needed, the sum must differ from
  // pi by more than `flat_fan_tolerance()`.
  template <typename Fan>
  bool is_less_than_pi(const Fan& outgoing) const
  {
    const double rest = pi<double>() - rounded_fan_angle(outgoing);
    return std::abs(rest) > fan_tolerance() ? rest > 0 : is_nearly_pi_but_less(outgoing);
  }

  // Returns whether the fan sign is POSITIVE for a sum within `fan_tolerance()` of pi. Nearly all
  // such sums are ties, which numbers of type `double` cannot decide.
  template <typename Fan>
  bool is_nearly_pi_but_less(const Fan& outgoing) const
  {
    bool result = false;
    const auto attempt = [&](auto& corners) {
      const auto product = turn_over(outgoing, this->development(corners));
      const Uncertain<Sign> sign = sign_of_imaginary(product);
      result = certainly(sign == POSITIVE);
      return is_certain(sign) ||
             product.radius <= flat_fan_tolerance() * std::abs(to_double(product.x));
    };
    this->try_with_many_digits(attempt);
    return result;
  }

  // Returns whether the two faces at the edge of `input` in T1 are coplanar, side by side.
  bool is_flat(Halfedge_index input) { return m_is_flat(input); }

  Sign orientation(Halfedge_index h)
  {
    return decide([&](const auto& development) { return sign_of_imaginary(development.angle(h)); });
  }

  // Returns whether the face of `h` has the orientation of the faces of T1 in which it lies. The
  // face may have zero area only if all these faces have zero area.
  bool is_oriented(Halfedge_index h)
  {
    const Sign sign = orientation(h);
    return sign == POSITIVE ||
           (sign == ZERO && !passes_triangle(h, true) && !passes_triangle(m_mesh.next(h), true) &&
            !passes_triangle(m_mesh.prev(h), true));
  }

  // Returns whether the edge of `h`, laid out straight, passes between the ends of the edges of T1
  // that it crosses. It may touch an end only where triangles of T1 have no area.
  bool is_straight(Halfedge_index h)
  {
    const Sign sign =
      decide([&](const auto& development) { return straightness(development.strip(h)); });
    return sign == POSITIVE || (sign == ZERO && passes_triangle(h, false));
  }

  // Returns the sign of s - `t`, where s is the position at which `h` crosses an edge of T1 as
  // crossing `m`. It follows from the heights of both ends of the straight edge `h` over the edge
  // of T1. If `h` runs along the edge of T1, the sign is ZERO.
  template <typename Lazy_number>
  Sign compare_place(Halfedge_index h, std::size_t m, const Lazy_number& t)
  {
    const Halfedge_index o = m_mesh.opposite(h);
    const Lazy_number rest = 1 - t;
    return decide<Exact_field>([&](const auto& development) {
      const auto from_source = development.strip(h).crossed[m];
      const auto from_target = development.strip(o).crossed[m_courses.count(h) - 1 - m];
      return sign_of_imaginary(
        development.number(rest) * height(from_source) * squared_length(from_target) -
        development.number(t) * height(from_target) * squared_length(from_source));
    });
  }

  const Decision_count& count() const { return m_count; }

  // Returns the sign `predicate(development)`, which is called with more and more digits. If there
  // are few roots, exact numbers are faster than many digits. Coplanar faces are an example. If the
  // input consists of numbers of type `double`, the last numbers are of type `Exact`. `Corners`
  // are the exact corners.
  template <typename Exact = Exact_ring,
            template <typename, typename> class Corners = Exact_corners, typename Predicate>
  Sign decide(const Predicate& predicate)
  {
    Uncertain<Sign> sign = Uncertain<Sign>::indeterminate();
    try_with_more_digits([&](auto& corners) {
      sign = predicate(development(corners));
      const bool is_first = std::is_same_v<decltype(corners), Rounded<double>&>;
      if(is_certain(sign))
        ++(is_first ? m_count.floating_point : m_count.multiprecision);
      else if(std::is_same_v<decltype(corners), Rounded<Double_double>&>)
        sign = sign_by_roots<Exact, Corners>(predicate, few_roots);
      return is_certain(sign);
    });
    if(!is_certain(sign) && m_most_roots > few_roots)
      sign = sign_by_roots<Exact, Corners>(predicate, m_most_roots);
    if(!is_certain(sign))
      throw Numerical_error("an exact decision involves more than " + std::to_string(m_most_roots) +
                            " independent square roots, or too many triangles");
    return get_certain(sign);
  }

  // Returns a number whose imaginary part is the height of the origin over a side, times the length
  // of the side.
  template <typename Side>
  static auto height(const Side& side)
  {
    return conj(side.source) * side.vector;
  }

  template <typename Side>
  static auto squared_length(const Side& side)
  {
    return conj(side.vector) * side.vector;
  }

private:
  // Returns whether the squared length of the edge of `h` is known without roots. Such an edge is
  // an edge of T1 or a straight line in space, also between inserted vertices.
  bool has_exact_square(Halfedge_index h)
  {
    if(is_input_edge(h))
      return true;
    if(m_metric.points.empty())
      return false;
    const Edge_course course = m_courses(h);
    for(std::size_t m = 0; m < course.size(); ++m)
      if(!m_is_flat(course[m]))
        return false;
    return true;
  }

  // Returns whether a vertex of the diamond of `h` is inserted.
  bool has_inserted_corner(Halfedge_index h) const
  {
    return has_inserted_end(h) || has_inserted_end(m_mesh.next(h)) ||
           has_inserted_end(m_mesh.next(m_mesh.opposite(h)));
  }

  // Returns the position of the vertex `v` of T2 in space, exactly.
  std::array<Exact_field, 3> exact_position(Vertex_index v) const
  {
    const auto number = [](double x) { return Exact_field(x); };
    std::array<Exact_field, 3> result;
    if(!m_pair.is_inserted(v)) {
      std::transform(m_metric.points[v].begin(), m_metric.points[v].end(), result.begin(), number);
      return result;
    }
    const auto [f, b] = face_location(m_pair.inserted_vertex(v), m_pair.input_mesh());
    const auto corner = sides(f, m_pair.input_mesh());
    const Exact_field sum = number(b[0]) + number(b[1]) + number(b[2]);
    for(std::size_t c = 0; c < 3; ++c)
      for(std::size_t x = 0; x < 3; ++x)
        result[x] +=
          number(b[c]) * number(m_metric.points[m_pair.input_mesh().source(corner[c])][x]) / sum;
    return result;
  }

  // Returns the Delaunay sign of `h` if all edges of its diamond are straight lines in space.
  Sign sign_by_places(Halfedge_index h) const
  {
    const Halfedge_index next = m_mesh.next(h), beyond = m_mesh.next(m_mesh.opposite(h));
    const auto i = exact_position(m_mesh.source(h)), j = exact_position(m_mesh.target(h)),
               k = exact_position(m_mesh.target(next)), l = exact_position(m_mesh.target(beyond));
    const auto square = [](const auto& p, const auto& q) {
      const std::array<Exact_field, 3> u{q[0] - p[0], q[1] - p[1], q[2] - p[2]};
      return Exact_field(u[0] * u[0] + u[1] * u[1] + u[2] * u[2]);
    };
    return compare_opposite_angles(
      Diamond<Exact_field>{square(i, j), square(j, k), square(k, i), square(i, l), square(l, j)});
  }

  // ---- Stages ----

  template <typename Exact, template <typename, typename> class Corners, typename Predicate>
  Uncertain<Sign> sign_by_roots(const Predicate& predicate, std::size_t maximum)
  {
    typedef std::conditional_t<std::is_same_v<Number, double>, Exact, Number> Of_squares;
    return m_metric.squared_lengths.empty()
             ? sign_by_roots_over<Corners<Exact, Number>>(predicate, maximum)
             : sign_by_roots_over<Corners<Of_squares, Number>>(predicate, maximum);
  }

  template <typename Corners, typename Predicate>
  Uncertain<Sign> sign_by_roots_over(const Predicate& predicate, std::size_t maximum)
  {
    Corners corners(exact_input(m_pair), m_is_flat, maximum, most_vectors);
    const Uncertain<Sign> sign = predicate(development(corners));
    if(corners.is_open())
      return Uncertain<Sign>::indeterminate();
    ++m_count.exact;
    return sign;
  }

  // ---- Predicates ----

  // Returns the sign of pi minus the sum of the angles at the sources of two halfedges.
  Sign compare_with_pi(Halfedge_index a, Halfedge_index b)
  {
    return decide([&](const auto& development) {
      return compare_sum_with_pi(development.angle(a), development.angle(b));
    });
  }

  // ---- Fans ----

  template <typename Fan>
  double rounded_fan_angle(const Fan& outgoing) const
  {
    double sum = 0;
    for(std::size_t i = 0; i + 1 < outgoing.size(); ++i)
      sum += rounded_angle(outgoing[i]);
    return sum;
  }

  // Returns whether both edges lie on one edge of T1, with the vertex between them.
  bool is_straight_corner(Halfedge_index before, Halfedge_index after) const
  {
    return m_pair.is_inserted(m_mesh.source(after)) && before != m_mesh.opposite(after) &&
           m_pair.coordinates().is_shared(m_mesh.edge(before)) &&
           m_pair.coordinates().is_shared(m_mesh.edge(after));
  }

  // The angles 0 and 2 pi have the same sine as pi, so the cosines decide.
  template <typename Complex>
  static Uncertain<Sign> compare_sum_with_pi(const Complex& a, const Complex& b)
  {
    const Uncertain<Sign> sine = sign_of_imaginary(a, b);
    if(!is_certain(sine) || get_certain(sine) != ZERO)
      return sine;
    const Uncertain<Sign> cos_a = sign_of_real(a), cos_b = sign_of_real(b);
    if(!is_certain(cos_a) || !is_certain(cos_b))
      return Uncertain<Sign>::indeterminate();
    return get_certain(cos_a) == get_certain(cos_b) ? get_certain(cos_a) : ZERO;
  }

  // ---- Squared lengths ----

  // Returns whether `h` crosses a triangle of T1 with positive area (or with zero area), or has
  // such a triangle on its left.
  bool passes_triangle(Halfedge_index h, bool has_area) const
  {
    const auto is_one = [&](Halfedge_index side) {
      return (area_sign(side, exact_input(m_pair)) != ZERO) == has_area;
    };
    const Halfedge_index outgoing = m_pair.input_outgoing_before(h);
    const Delta_complex& input = m_pair.input_mesh();
    if(is_one(outgoing.is_valid() ? outgoing : input.halfedge(m_pair.input_location(h).first)))
      return true;
    const Edge_course course = m_courses(h);
    for(std::size_t m = 0; m < course.size(); ++m)
      if(is_one(opposite(course[m])))
        return true;
    return false;
  }

  template <typename R>
  R exact_square(Halfedge_index h) const
  {
    return exact_squared_length<R>(m_pair.input_halfedge(h), exact_input(m_pair));
  }

  template <typename R>
  Sign sign_by_squares(Halfedge_index h) const
  {
    return compare_opposite_angles(
      diamond_of([&](Halfedge_index x) -> R { return exact_square<R>(x); }, h, m_mesh));
  }

  Flat_edges m_is_flat;
  std::size_t m_most_roots = many_roots;
  Decision_count m_count;
};

template <typename Traits>
Exact_decisions<Traits> exact_decisions(const Triangulation_pair<Traits>& pair)
{
  return Exact_decisions<Traits>(pair);
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_EXACT_DECISIONS_H
