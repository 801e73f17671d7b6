// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_EXACT_DECISIONS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_EXACT_DECISIONS_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Triangulation_pair.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/Development.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/Input_corners.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/exact_squares.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/flipped_length.h>
#include <CGAL/Intrinsic_triangulations/tolerances.h>

#include <CGAL/Uncertain.h>
#include <CGAL/enum.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>
#include <string>
#include <type_traits>
#include <unordered_map>
#include <utility>

namespace CGAL::Intrinsic_triangulations::internal {

// How many decisions were made at each stage.
struct Decision_count
{
  std::size_t floating_point = 0, multiprecision = 0, exact = 0;
};

// What floating point says about an edge of T2 that has been laid out.
struct Straight_edge
{
  bool is_certain; // that it is straight
  double length;   // NaN if it is not known up to `certified_length_error()`
};

// Decisions about T2, each derived anew from the metric of T1: in floating point with error bounds,
// with more and more digits, and in the end exactly.
template <typename Traits, typename Crossings>
class Exact_decisions
{
  typedef Triangulation_pair<Traits> Pair;
  typedef Input_metric_of<Traits> Metric;
  typedef Exact_number_of<typename Metric::Number> K;
  typedef decltype(std::declval<Pair>().input()) Input;
  template <typename N>
  using Rounded = Rounded_corners<N, Metric, Input>;
  typedef Exact_corners<Metric, Input> Exact;

  static constexpr std::size_t maximal_number_of_roots = 10;

public:
  Exact_decisions(const Pair& pair, const Crossings& crossings)
    : m_pair(pair), m_mesh(pair.mesh()), m_metric(pair.input_metric()), m_crossings(crossings)
  {}

  // Returns the sign of pi minus the sum of the angles opposite to the edge of `h`: ZERO is a tie.
  Sign Delaunay_sign(Halfedge_index h)
  {
    const Halfedge_index o = m_mesh.opposite(h);
    const Diamond<Halfedge_index> around{h, m_mesh.next(h), m_mesh.prev(h), m_mesh.next(o),
                                         m_mesh.prev(o)};
    if(!has_exact_square(around.ij) || !has_exact_square(around.jk) ||
       !has_exact_square(around.ki) || !has_exact_square(around.il) || !has_exact_square(around.lj))
      return compare_with_pi(around.ki, around.lj);
    ++m_count.exact;
    return m_metric.squared_lengths.empty() ? exact_sign<Exact_ring>(around)
                                            : exact_sign<K>(around);
  }

  // returns the sign of pi minus the angle of the union of the two faces of `h` at its source
  Sign convexity_at_source(Halfedge_index h)
  {
    const Halfedge_index following = m_mesh.next(m_mesh.opposite(h));
    return is_straight_corner(m_mesh.prev(h), following) ? ZERO : compare_with_pi(h, following);
  }

  // returns whether the union of the two faces of `h` is strictly convex at its ends
  bool is_convex(Halfedge_index h)
  {
    return convexity_at_source(h) == POSITIVE &&
           convexity_at_source(m_mesh.opposite(h)) == POSITIVE;
  }

  // returns the orientation of the face of `h`
  Sign orientation(Halfedge_index h)
  {
    return decide([&](const auto& development) { return sign_of_imaginary(development.angle(h)); });
  }

  // Returns whether the edge of `h`, laid out straight, passes between the ends of the edges of T1
  // that it crosses. It may touch an end only where triangles of T1 have no area.
  bool is_straight(Halfedge_index h)
  {
    const Sign sign =
      decide([&](const auto& development) { return straightness(development.strip(h)); });
    return sign == POSITIVE || (sign == ZERO && passes_face_without_area(h));
  }

  // Returns the sign of the place on the halfedge `h` where it crosses an edge of T1 as crossing `m`,
  // minus `t`: from the heights of both ends of `h` over that edge. `h` is straight. If it runs along
  // that edge, the sign is ZERO.
  template <typename Lazy_number>
  Sign compare_place(Halfedge_index h, std::size_t m, const Lazy_number& t)
  {
    const Halfedge_index o = m_mesh.opposite(h);
    const Lazy_number rest = 1 - t;
    return decide([&](const auto& development) {
      const auto from_source = development.strip(h).crossed[m];
      const auto from_target = development.strip(o).crossed[m_crossings.count(h) - 1 - m];
      return sign_of_imaginary(
        development.number(rest) * height(from_source) * squared_length(from_target) -
        development.number(t) * height(from_target) * squared_length(from_source));
    });
  }

  // Throws `Invalid_input` if T1 is given by lengths that violate the triangle inequality. Those
  // that obey it by more than rounding need no second look.
  void check_triangles() const
  {
    const Delta_complex& input = m_pair.input_mesh();
    const auto length = [&](Halfedge_index h) { return m_pair.input_length(input.edge(h)); };
    Exact corners(m_metric, m_pair.input(), 1);
    for(Face_index f : input.faces()) {
      const Halfedge_index h = input.halfedge(f);
      const double a = length(h), b = length(input.next(h)), c = length(input.prev(h));
      if((std::min)({b + c - a, c + a - b, a + b - c}) <= rounding_unit<double>() * (a + b + c) &&
         corners.area_sign(corner_at_source(h, input)) == NEGATIVE)
        throw Invalid_input("the triangle inequality fails in face " + std::to_string(f.idx()) +
                            " by less than rounding");
    }
  }

  // whether the edge of `h` is a whole edge of T1
  bool is_input_edge(Halfedge_index h) const
  {
    return m_pair.coordinates().is_shared(m_mesh.edge(h)) && !has_inserted_end(h);
  }

  // the cheapest way to both
  Straight_edge straight_edge(Halfedge_index h) const
  {
    if(is_input_edge(h))
      return {true, m_pair.input_length(m_pair.input_mesh().edge(m_pair.input_halfedge(h)))};
    if(m_crossings.count(h) == 1 && !has_inserted_end(h))
      return other_diagonal(m_crossings(h, 0));
    Rounded<double> corners(m_metric, m_pair.input());
    const auto strip = development(corners).strip(h);
    return {certainly(straightness(strip) == POSITIVE), rounded_length(strip, corners)};
  }

  // Returns the length of the edge of `h`, correct to `certified_length_error()`.
  // \throws Numerical_error if it is not positive and finite
  double length(Halfedge_index h) const
  {
    if(m_pair.coordinates().is_shared(m_mesh.edge(h)))
      return m_pair.shared_length(h);
    double length = rounded_length<double>(h);
    for(long bits = 128; bits <= 512 && std::isnan(length); bits *= 4) {
      const Long_float_precision precision(bits);
      length = rounded_length<Long_float>(h);
    }
    if(!m_pair.traits().is_length_object()(length))
      throw Numerical_error("edge " + std::to_string(m_mesh.edge(h).idx()) +
                            " has no positive finite length");
    return length;
  }

  // returns the angle at the source of `h` in its face
  double rounded_angle(Halfedge_index h) const
  {
    return std::arg(
      rounded_corner(h, [](const std::complex<double>& corner) { return std::abs(corner); }));
  }

  // Returns (k - i) / (j - i) for the face ijk of the halfedge `h` from i to j, its imaginary part
  // correct up to a small relative error. It is not positive if the face has no area.
  std::complex<double> rounded_corner(Halfedge_index h) const
  {
    return rounded_corner(h, [](const std::complex<double>& corner) { return corner.imag(); });
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

  // returns the side from which a face is laid out without loss of digits
  Halfedge_index shortest_side(Face_index f) const
  {
    const auto side = sides(f, m_mesh);
    return *std::min_element(side.begin(), side.end(), [&](Halfedge_index a, Halfedge_index b) {
      return m_pair.length(m_mesh.edge(a)) < m_pair.length(m_mesh.edge(b));
    });
  }

  const Decision_count& count() const { return m_count; }

  // Returns the sign `predicate(development)`, which is asked for with more and more digits. Roots
  // of few numbers, as where many faces are coplanar, are faster than many digits.
  template <typename Predicate>
  Sign decide(const Predicate& predicate)
  {
    Uncertain<Sign> sign = sign_by_balls<double>(predicate, m_count.floating_point);
    for(long bits : {128, 512}) {
      if(is_certain(sign))
        return get_certain(sign);
      const Long_float_precision precision(bits);
      sign = sign_by_balls<Long_float>(predicate, m_count.multiprecision);
      if(!is_certain(sign) && bits == 128)
        sign = sign_by_roots(predicate, 2);
    }
    if(!is_certain(sign))
      sign = sign_by_roots(predicate, maximal_number_of_roots);
    if(!is_certain(sign))
      throw Numerical_error("an exact decision involves more than " +
                            std::to_string(maximal_number_of_roots) + " independent square roots");
    return get_certain(sign);
  }

  // its imaginary part is the height of the origin over a side, times the length of the side
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
  bool has_inserted_end(Halfedge_index h) const
  {
    return m_pair.is_inserted(m_mesh.source(h)) || m_pair.is_inserted(m_mesh.target(h));
  }

  // what lengths say about the other diagonal of two faces of T1; `rounding_unit()` covers them
  Straight_edge other_diagonal(Halfedge_index input) const
  {
    const auto length = diamond(m_pair.input_length_map(), input, m_pair.input_mesh());
    const Bounded_length flipped = flipped_length(length, input_length_error());
    return {Euclidean_geometry_traits<double>::Is_convex()(length),
            flipped.is_good() ? flipped.length : std::numeric_limits<double>::quiet_NaN()};
  }

  template <typename Corners>
  auto development(Corners& corners) const
  {
    return Development<Traits, Crossings, Corners>(m_pair, m_crossings, corners);
  }

  // ---- Stages ----

  template <typename N, typename Predicate>
  Uncertain<Sign> sign_by_balls(const Predicate& predicate, std::size_t& count) const
  {
    Rounded<N> corners(m_metric, m_pair.input());
    const Uncertain<Sign> sign = predicate(development(corners));
    count += is_certain(sign);
    return sign;
  }

  template <typename Predicate>
  Uncertain<Sign> sign_by_roots(const Predicate& predicate, std::size_t maximum)
  {
    Exact corners(m_metric, m_pair.input(), maximum);
    const Uncertain<Sign> sign = predicate(development(corners));
    if(corners.has_too_many_roots())
      return Uncertain<Sign>::indeterminate();
    ++m_count.exact;
    return sign;
  }

  // ---- Predicates ----

  // the sign of pi minus the sum of the angles at the sources of two halfedges
  Sign compare_with_pi(Halfedge_index a, Halfedge_index b)
  {
    return decide([&](const auto& development) {
      return compare_sum_with_pi(development.angle(a), development.angle(b));
    });
  }

  // whether the edges lead along one edge of T1, through the vertex between them
  bool is_straight_corner(Halfedge_index before, Halfedge_index after) const
  {
    return m_pair.is_inserted(m_mesh.source(after)) && before != m_mesh.opposite(after) &&
           m_pair.coordinates().is_shared(m_mesh.edge(before)) &&
           m_pair.coordinates().is_shared(m_mesh.edge(after));
  }

  // 0 and 2 pi have the same sine as pi; there the cosines decide
  template <typename Complex>
  static Uncertain<Sign> compare_sum_with_pi(const Complex& a, const Complex& b)
  {
    const Uncertain<Sign> sine = sign_of_imaginary(a * b);
    if(!is_certain(sine) || get_certain(sine) != ZERO)
      return sine;
    const Uncertain<Sign> cos_a = sign_of_real(a), cos_b = sign_of_real(b);
    if(!is_certain(cos_a) || !is_certain(cos_b))
      return Uncertain<Sign>::indeterminate();
    return get_certain(cos_a) == get_certain(cos_b) ? get_certain(cos_a) : ZERO;
  }

  template <typename Strip>
  static Uncertain<Sign> straightness(const Strip& strip)
  {
    const auto direction = conj(strip.end);
    Sign least = POSITIVE;
    bool is_known = true;
    for(const auto& side : strip.crossed)
      for(const Uncertain<Sign> sign : {sign_of_imaginary(direction * side.target),
                                        -sign_of_imaginary(direction * side.source)}) {
        is_known = is_known && is_certain(sign);
        if(is_certain(sign))
          least = (std::min)(least, get_certain(sign));
      }
    return is_known || least == NEGATIVE ? Uncertain<Sign>(least)
                                         : Uncertain<Sign>::indeterminate();
  }

  template <typename N>
  double rounded_length(Halfedge_index h) const
  {
    Rounded<N> corners(m_metric, m_pair.input());
    return rounded_length(development(corners).uncrossed_strip(h), corners);
  }

  // The error is small in comparison with `size(corner)`, if more digits can help.
  template <typename Size>
  std::complex<double> rounded_corner(Halfedge_index h, const Size& size) const
  {
    std::pair<std::complex<double>, double> corner = corner_and_error<double>(h);
    const auto is_accurate = [&] {
      return corner.second <= size(corner.first) * certified_length_error();
    };
    for(long bits = 128; bits <= 512 && !is_accurate(); bits *= 4) {
      const Long_float_precision precision(bits);
      corner = corner_and_error<Long_float>(h);
    }
    return corner.first;
  }

  template <typename N>
  std::pair<std::complex<double>, double> corner_and_error(Halfedge_index h) const
  {
    Rounded<N> corners(m_metric, m_pair.input());
    const auto [j, k] = development(corners).ends(h);
    const auto product = k * conj(j), square = j * conj(j);
    return {{CGAL::to_double(N(product.x / square.x)), CGAL::to_double(N(product.y / square.x))},
            product.radius / CGAL::to_double(square.x)};
  }

  template <typename Strip, typename Corners>
  static double rounded_length(const Strip& strip, const Corners& corners)
  {
    const auto length = root(strip.end * conj(strip.end)) * corners.length(strip.first.halfedge);
    const double midpoint = CGAL::to_double(length.x);
    return length.radius <= midpoint * certified_length_error() / 2
             ? midpoint
             : std::numeric_limits<double>::quiet_NaN();
  }

  // ---- Squared lengths ----

  bool passes_face_without_area(Halfedge_index h)
  {
    const Delta_complex& input = m_pair.input_mesh();
    Exact corners(m_metric, m_pair.input(), 1);
    for(std::size_t m = 0; m < m_crossings.count(h); ++m)
      for(Halfedge_index side : {m_crossings(h, m), input.opposite(m_crossings(h, m))})
        if(corners.area_sign(corner_at_source(side, input)) == ZERO)
          return true;
    return false;
  }

  // Returns whether the squared length of the edge of `h` is known without roots: it is an edge of
  // T1, or a straight line in space.
  bool has_exact_square(Halfedge_index h)
  {
    if(is_input_edge(h))
      return true;
    if(m_metric.points.empty() || has_inserted_end(h))
      return false;
    for(std::size_t m = 0; m < m_crossings.count(h); ++m)
      if(!is_flat(m_pair.input_mesh().edge(m_crossings(h, m))))
        return false;
    return true;
  }

  bool is_flat(Edge_index input)
  {
    const auto [place, is_new] = m_is_flat.emplace(input, false);
    if(is_new)
      place->second =
        is_flat_in_space(m_pair.input_mesh().halfedge(input), m_metric.points, m_pair.input_mesh());
    return place->second;
  }

  template <typename R>
  R exact_square(Halfedge_index h) const
  {
    if(!m_metric.points.empty())
      return squared_distance<R>(m_metric.points[m_mesh.source(h)],
                                 m_metric.points[m_mesh.target(h)]);
    const Edge_index e = m_pair.input_mesh().edge(m_pair.input_halfedge(h));
    if constexpr(std::is_same_v<R, K>)
      if(!m_metric.squared_lengths.empty())
        return K(m_metric.squared_lengths[e]);
    return R(CGAL::square(R(m_pair.input_length(e))));
  }

  template <typename R>
  Sign exact_sign(const Diamond<Halfedge_index>& around) const
  {
    return compare_opposite_angles(
      Diamond<R>{exact_square<R>(around.ij), exact_square<R>(around.jk), exact_square<R>(around.ki),
                 exact_square<R>(around.il), exact_square<R>(around.lj)});
  }

  const Pair& m_pair;
  const Delta_complex& m_mesh;
  const Metric& m_metric;
  Crossings m_crossings;
  std::unordered_map<Edge_index, bool> m_is_flat; // edges of T1 that have been looked at
  Decision_count m_count;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_EXACT_DECISIONS_H
