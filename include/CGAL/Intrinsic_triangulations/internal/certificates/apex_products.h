// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_APEX_PRODUCTS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_APEX_PRODUCTS_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Double_double.h>
#include <CGAL/Intrinsic_triangulations/Surface_view.h>
#include <CGAL/Intrinsic_triangulations/Triangulation_pair.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/Input_metric.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/exact_squares.h>
#include <CGAL/Intrinsic_triangulations/triangle_formulas.h>

#include <CGAL/number_utils.h>

#include <boost/config.hpp>

#include <algorithm>
#include <limits>
#include <type_traits>

namespace CGAL::Intrinsic_triangulations::internal {

template <typename Traits>
Exact_surface<typename Input_metric_of<Traits>::Number>
exact_input(const Triangulation_pair<Traits>& pair)
{
  return {pair.input(), pair.input_metric()};
}

// Returns the square of pq, or NaN if products of the squares of three sides may underflow or
// overflow. Products of Long_float never do.
template <typename N>
N square_in_range(const N& pq, const N& pr, const N& qr)
{
  constexpr bool is_bounded = std::is_floating_point_v<N> || std::is_same_v<N, Double_double>;
  constexpr double least = is_bounded ? 1e-100 : 0,
                   greatest = is_bounded ? 1e100 : std::numeric_limits<double>::infinity();
  return (std::min)({pq, pr, qr}) > N(least) && (std::max)({pq, pr, qr}) < N(greatest)
           ? pq
           : N(std::numeric_limits<double>::quiet_NaN());
}

// Stores products of the sides of a triangle pqr on the left of pq. These are the scalar products
// of pq with pr and with qr, and the length of their vector product. The squared lengths of the
// sides are stored, too. The square of pq is NaN if products may leave the range of numbers.
template <typename N>
struct Apex_products
{
  N with_pr, with_qr, across;
  N square_pq, square_pr, square_qr;
};

// Returns the products of the triangle of the halfedge pq, from positions. Divided by the square of
// pq, the products yield vectors to r. These have a relative error of 20 u, for the rounding unit
// u, however thin the triangle is. Components of vectors have an error of one u. So a scalar
// product has an error of 5 u, relative to the product of both lengths. The vector product with the
// shorter side at r has 9 u; the quotients add 7 u. Inlined, the products of two triangles are
// computed at once.
template <typename N>
BOOST_FORCEINLINE Apex_products<N> apex_products(const Position& p, const Position& q,
                                                 const Position& r)
{
  const auto pq = vector_between<N>(p, q), pr = vector_between<N>(p, r),
             qr = vector_between<N>(q, r);
  const N square_pq = dot(pq, pq), square_pr = dot(pr, pr), square_qr = dot(qr, qr);
  const auto normal = cross(pq, square_pr < square_qr ? pr : qr);
  return {N(dot(pq, pr)),
          N(dot(pq, qr)),
          N(sqrt(dot(normal, normal))),
          square_in_range(square_pq, square_pr, square_qr),
          square_pr,
          square_qr};
}

// Returns the products, computed from lengths. No difference in the formulas cancels digits.
template <typename N>
BOOST_FORCEINLINE Apex_products<N> apex_products(const N& pq, const N& qr, const N& rp)
{
  const N half(0.5), square_pr(rp * rp), square_qr(qr * qr);
  return {N(half * doubled_corner_product(qr, pq, rp)),
          N(-half * doubled_corner_product(rp, pq, qr)),
          N(half * sqrt(squared_quadrupled_area(pq, qr, rp))),
          square_in_range(N(pq * pq), square_pr, square_qr),
          square_pr,
          square_qr};
}

// Returns the products of the triangle on the left of `h`.
// \pre `input` has no squared lengths
template <typename N, typename Number>
Apex_products<N> apex_products(Halfedge_index h, const Exact_surface<Number>& input)
{
  const Delta_complex& mesh = input.mesh();
  const auto& points = input.metric.points;
  if(!points.empty())
    return apex_products<N>(points[mesh.source(h)], points[mesh.target(h)],
                            points[mesh.target(mesh.next(h))]);
  const auto [a, b, c] = side_lengths(h, input);
  return apex_products<N>(N(a), N(b), N(c));
}

// Stores the coordinates of r along pq, from p and from q, and its height over pq. All are divided
// by the length of pq.
template <typename N>
struct Apex_ratios
{
  N from_source, from_target, across;
};

// Returns the products of the triangle on the left of `h`; NaN if products may leave the range of
// numbers.
// \pre `input` has no squared lengths
template <typename N, typename Number>
Apex_ratios<N> apex_ratios(Halfedge_index h, const Exact_surface<Number>& input)
{
  const auto products = apex_products<N>(h, input);
  const N inverse = N(1) / products.square_pq;
  return {N(products.with_pr * inverse), N(products.with_qr * inverse),
          N(products.across * inverse)};
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CERTIFICATES_APEX_PRODUCTS_H
