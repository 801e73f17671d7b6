// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_WEIGHTS_WEIGHT_FORM_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_WEIGHTS_WEIGHT_FORM_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/weighted_formulas.h>

#include <CGAL/Uncertain.h>
#include <CGAL/enum.h>

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Stores a linear function of the weights of four corners, with real coefficients. A vertex can be
// several of these corners.
template <typename Number>
struct Weight_form
{
  Number constant;
  std::array<std::pair<Vertex_index, Number>, 4> terms;

  // Returns the value for the weights `weight(v)`.
  template <typename Weight>
  Number value(const Weight& weight) const
  {
    Number result = constant;
    for(const auto& [v, coefficient] : terms)
      result = result + coefficient * weight(v);
    return result;
  }
};

template <typename Complex>
Complex squared_norm(const Complex& z)
{
  return real_part(z * conj(z));
}

// Represents a face ijk in the plane, seen from its side ij. The corners j and k have positions
// from i in a unit L, and k conj(j) = x + i y. Let h be the height of the power center over ij.
// Then 2 h |j| L is
//   ((|k|^2 - x) |j|^2 L^2 + w_i (|j|^2 - x) + w_j x - w_k |j|^2) / y.
//
// The members are k conj(j) and the coefficients of the numerator.
template <typename Complex>
struct Height_form
{
  Complex product, constant, of_source, of_target, of_apex;

  Height_form(const std::pair<Complex, Complex>& ends, const Complex& squared_unit)
    : product(ends.second * conj(ends.first)),
      of_target(real_part(product)),
      of_apex(-squared_norm(ends.first))
  {
    constant = (of_target - squared_norm(ends.second)) * of_apex * squared_unit;
    of_source = -of_apex - of_target;
  }
};

// Returns a function of the weights around the edge of `h`, with a positive factor. It is the
// signed length of the dual edge, which is not negative if and only if the edge is weighted
// Delaunay. `development` is to scale.
template <typename Development>
auto dual_edge_form(Halfedge_index h, const Delta_complex& mesh, const Development& development)
{
  typedef typename Development::Complex Complex;
  const Halfedge_index o = opposite(h);
  const Height_form<Complex> left(development.ends(h), development.squared_unit(h)),
    right(development.ends(o), development.squared_unit(o));
  const auto sum = [&](const Complex& of_left, const Complex& of_right) {
    return imaginary_part(of_left * right.product + of_right * left.product);
  };
  const auto [i, j, k, l] = diamond_corners(h, mesh);
  return Weight_form<Complex>{sum(left.constant, right.constant),
                              {std::pair(i, sum(left.of_source, right.of_target)),
                               std::pair(j, sum(left.of_target, right.of_source)),
                               std::pair(k, imaginary_part(left.of_apex * right.product)),
                               std::pair(l, imaginary_part(right.of_apex * left.product))}};
}

// Returns the sign of the dual edge of the edge of `h`, if the digits of `development` determine
// it. Balls `weights.ball<N>(v)` contain the weights.
template <typename Development, typename Weights>
Uncertain<Sign> rounded_dual_edge_sign(Halfedge_index h, const Delta_complex& mesh,
                                       const Development& development, const Weights& weights)
{
  typedef decltype(Development::Complex::x) N;
  return sign_of_real(dual_edge_form(h, mesh, development).value([&](Vertex_index v) {
    return weights.template ball<N>(v);
  }));
}

// Represents a lower bound of the weight of the source of a halfedge. The lifted points of a convex
// surface are convex along geodesics. A geodesic begins at the end of the halfedge and passes its
// source. It ends in the last of `faces` faces, counterclockwise from the halfedge, whose angles
// add up to pi or more.
//
// If all angles at the source add up to at most pi, `faces` is zero. Then the bound is the weight
// of the target minus the squared length of the halfedge.
struct Weight_bound
{
  Halfedge_index halfedge;
  std::size_t faces = 0;
  bool is_certain = true; // whether it is decided which face the geodesic ends in

  // Returns the outgoing halfedges at the faces, counterclockwise, and the following one.
  std::vector<Halfedge_index> fan(const Delta_complex& mesh) const
  {
    std::vector<Halfedge_index> result{halfedge};
    do
      result.push_back(next_around_source(result.back(), mesh));
    while(faces > 0 ? result.size() <= faces : result.back() != halfedge);
    return result;
  }

  // Returns the source, and the corners on which its bound depends.
  std::array<Vertex_index, 4> corners(const Delta_complex& mesh) const
  {
    const Vertex_index i = mesh.source(halfedge), j = mesh.target(halfedge);
    if(faces == 0)
      return {i, j, j, j};
    const std::vector<Halfedge_index> outgoing = fan(mesh);
    return {i, j, mesh.target(outgoing[faces - 1]), mesh.target(outgoing[faces])};
  }
};

// Returns the weight of the source i minus its bound, up to a positive factor, as a function of
// weights. The corners j, p and q have positions from i in a unit L, and the geodesic meets the
// side pq. Let p conj(j) = x + i a, q conj(j) = y + i c and r = a y - c x. The function is
//   ((a - c) |j|^2 - r) w_i + r w_j + |j|^2 (c w_p - a w_q)
//     + |j|^2 (a |q|^2 - c |p|^2 - r) L^2.
template <typename Development>
auto weight_bound_form(const Weight_bound& bound, const Delta_complex& mesh,
                       const Development& development)
{
  typedef typename Development::Complex Complex;
  const auto corner = bound.corners(mesh);
  const auto end = development.ends(bound.halfedge, bound.faces + 1);
  const Complex &j = end.front(), square = squared_norm(j),
                squared_unit = development.squared_unit(bound.halfedge);
  if(bound.faces == 0) {
    const Complex zero = development.number(0), one = development.number(1);
    return Weight_form<Complex>{square * squared_unit,
                                {std::pair(corner[0], one), std::pair(corner[1], -one),
                                 std::pair(corner[2], zero), std::pair(corner[3], zero)}};
  }
  const Complex &p = end[end.size() - 2], &q = end.back(), p_j = p * conj(j), q_j = q * conj(j),
                a = imaginary_part(p_j), c = imaginary_part(q_j),
                r = a * real_part(q_j) - c * real_part(p_j);
  return Weight_form<Complex>{
    square * (a * squared_norm(q) - c * squared_norm(p) - r) * squared_unit,
    {std::pair(corner[0], (a - c) * square - r), std::pair(corner[1], r),
     std::pair(corner[2], c * square), std::pair(corner[3], -(a * square))}};
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_WEIGHTS_WEIGHT_FORM_H
