// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_WEIGHTS_WEIGHTED_FLIPPING_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_WEIGHTS_WEIGHTED_FLIPPING_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Decimal_float.h>
#include <CGAL/Intrinsic_triangulations/Euclidean_geometry_traits.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/internal/flipping/Flipped_lengths.h>
#include <CGAL/Intrinsic_triangulations/internal/weights/Supporting_triangles.h>
#include <CGAL/Intrinsic_triangulations/make_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/tolerances.h>
#include <CGAL/Intrinsic_triangulations/weighted_formulas.h>

#include <boost/property_map/function_property_map.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Returns the number whose ninth decimal digit is about `error`.
template <typename FT>
FT error_of_nine_digits(const FT& error)
{
  return FT(std::ldexp(1., 30)) * error;
}

// Returns whether the union of two faces is convex for all lengths within this relative error.
template <typename FT>
bool is_certainly_convex(const Diamond<FT>& d, const FT& error)
{
  const FT square = d.ij * d.ij, margin = error * (square + d.jk * d.jk + d.ki * d.ki) *
                                          (square + d.il * d.il + d.lj * d.lj);
  return cotangents_at_source(d) > margin &&
         cotangents_at_source(Diamond<FT>{d.ij, d.il, d.lj, d.jk, d.ki}) > margin;
}

// Provides the stored lengths of T2.
template <typename Traits>
class Stored_lengths
{
  typedef Intrinsic_triangulation<Traits> Triangulation;

public:
  typedef typename Traits::FT FT;

  explicit Stored_lengths(Triangulation& tri) : m_tri(tri) {}

  const Triangulation& triangulation() const { return m_tri; }
  auto length_map() const { return m_tri.length_map(); }
  // Returns the relative error that decisions assume for a length.
  static FT error() { return rounding_unit<FT>(); }
  // Returns the relative error of a rounded weight.
  static FT weight_error()
  {
    return is_rounded<FT>() ? FT(std::numeric_limits<FT>::epsilon() / 2) : FT(0);
  }
  // Returns the least squared area, relative to squared lengths, that determines weights to 9
  // digits. Returns zero if no more precise lengths are available.
  static FT least_squared_area()
  {
    return has_exact_decisions<Traits>() ? error_of_nine_digits(error()) : FT(0);
  }

  bool is_flippable(Halfedge_index h) const { return m_tri.is_flippable(h); }

  // Flips the edge of `h`, and returns whether this was possible.
  bool flip(Halfedge_index h)
  {
    return succeeds<Traits>([&] { m_tri.flip(h); });
  }

private:
  Triangulation& m_tri;
};

// Provides the lengths of T2 on the exact surface of T1, with 155 decimal digits.
template <typename Traits>
class Many_digits_lengths : public Flipped_lengths<Traits, Decimal_float<155>>
{
  typedef Flipped_lengths<Traits, Decimal_float<155>> Base;

public:
  typedef typename Base::FT FT;

  using Base::Base;

  // Flips keep more digits than this error. Weights that depend on each other converge linearly to
  // this accuracy.
  static FT error() { return FT(std::ldexp(1., -128)); }
  static FT weight_error() { return error(); }
  static FT least_squared_area() { return FT(0); }

  bool is_flippable(Halfedge_index h) const
  {
    return Base::can_be_turned(h) && is_certainly_convex(Base::diamond(h), error());
  }
};

// Decides by lengths and weights. An edge that is not weighted Delaunay and cannot be flipped waits
// for larger weights.
template <typename Lengths>
class Weighted_flipping
{
  typedef typename Lengths::FT FT;

public:
  template <typename Triangulation>
  Weighted_flipping(Triangulation& tri, std::vector<FT>& weights)
    : m_lengths(tri), m_mesh(tri.mesh()), m_weights(weights), m_is_good_edge(m_mesh.num_edges())
  {}

  Lengths& lengths() { return m_lengths; }

  bool is_certainly_Delaunay(Edge_index e) const
  {
    const Halfedge_index h = m_mesh.halfedge(e);
    return m_mesh.is_border(e) || m_is_good_edge[e.idx()] ||
           m_is_good.is_certain(length(h), weights(h));
  }

  bool is_Delaunay(Edge_index e) const
  {
    return satisfies_condition(e) || !m_lengths.is_flippable(m_mesh.halfedge(e));
  }

  // Returns whether an edge can be flipped, and is Delaunay afterwards, too. Lengths have this
  // relative error.
  bool is_tie(Halfedge_index h, const FT& error) const
  {
    const Diamond<FT> d = length(h);
    if(!m_lengths.is_flippable(h) || !is_certainly_convex(d, Lengths::error()))
      return false;
    const Diamond_weights<FT> w = weights(h);
    const FT kl = typename Euclidean_geometry_traits<FT>::Compute_flipped_length()(d);
    return Is_locally_weighted_Delaunay<FT>{error}(Diamond<FT>{kl, d.lj, d.jk, d.ki, d.il},
                                                   Diamond_weights<FT>{w.k, w.l, w.j, w.i});
  }

  // Flips an edge, and returns whether this was possible. The new edge is Delaunay, up to rounding
  // of lengths.
  bool flip(Halfedge_index h)
  {
    if(!m_lengths.flip(h))
      return false;
    m_is_good_edge[m_mesh.edge(h).idx()] = false;
    for(Edge_index e : edges_around(h, m_mesh))
      m_is_good_edge[e.idx()] = false;
    m_has_failed = m_has_failed || !satisfies_condition(m_mesh.edge(h));
    return true;
  }

  bool has_failed() const { return m_has_failed; }

  // Returns whether an end of `e` is hidden, after all possible flips.
  bool has_hidden_end(Edge_index e) const
  {
    return !satisfies_condition(e) && !m_lengths.is_flippable(m_mesh.halfedge(e));
  }

  // Adds triangles that hide vertices to `triangles`. If an edge is not weighted Delaunay and its
  // diamond is not convex, the triangle of three corners hides the fourth. Hidden vertices are
  // moved into their triangles, as lifted points. In the end, no vertex lies above a triangle that
  // was found, so weights are not raised too far. Returns whether a triangle was found.
  bool raise_weights(Supporting_triangles<FT>& triangles)
  {
    std::set<Vertex_index> hidden;
    for(Edge_index e : m_mesh.edges())
      if(has_hidden_end(e)) {
        const Halfedge_index h = hidden_end(e);
        triangles.set(m_mesh.source(h), supporting_triangle(h));
        hidden.insert(m_mesh.source(h));
      }
    if(hidden.empty())
      return false;
    const std::vector<FT> before = m_weights;
    triangles.set_weights(m_weights);
    triangles.check_digits(m_weights, error_of_nine_digits(Lengths::weight_error()));
    for(Vertex_index v : m_mesh.vertices())
      if(m_weights[v.idx()] != before[v.idx()])
        forget_edges_around(v);
    for(Vertex_index v : hidden)
      if(!(m_weights[v.idx()] > before[v.idx()]))
        throw Numerical_error("rounding of weights and lengths hides vertex " +
                              std::to_string(v.idx()));
    return true;
  }

  Diamond<FT> length(Halfedge_index h) const { return diamond(m_lengths.length_map(), h, m_mesh); }

private:
  Diamond_weights<FT> weights(Halfedge_index h) const
  {
    return diamond_weights(boost::make_function_property_map<Vertex_index>(
                             [this](Vertex_index v) { return m_weights[v.idx()]; }),
                           h, m_mesh);
  }

  bool satisfies_condition(Edge_index e) const
  {
    const Halfedge_index h = m_mesh.halfedge(e);
    m_is_good_edge[e.idx()] = m_is_good_edge[e.idx()] || m_mesh.is_border(e) ||
                              m_lengths.triangulation().is_constrained(e) ||
                              m_is_good(length(h), weights(h));
    return m_is_good_edge[e.idx()];
  }

  // Returns the halfedge of `e` from the end at which the diamond is not convex. The sum of the
  // cotangents of its two angles is less than at the other end.
  Halfedge_index hidden_end(Edge_index e) const
  {
    const Halfedge_index h = m_mesh.halfedge(e), o = opposite(h);
    if(m_mesh.next(h) == o)
      return o;
    return m_mesh.prev(h) == o || cotangents_at_target(h) > cotangents_at_target(o) ? h : o;
  }

  FT cotangents_at_target(Halfedge_index h) const
  {
    return cotangents_at_source(length(opposite(h)));
  }

  // Returns the triangle that hides the source of `h`, from the other corners of its diamond. The
  // sum of heights is linear in the weights, and vanishes if the lifted point is in the triangle.
  // All corners of the only edge of a vertex lie at its other end.
  Supporting_triangle<FT> supporting_triangle(Halfedge_index h) const
  {
    const Diamond<FT> length = this->length(h);
    const Halfedge_index o = opposite(h);
    const Vertex_index target = m_mesh.target(h);
    if(m_mesh.prev(h) == o)
      return {-length.ij * length.ij,
              {std::pair(target, FT(1)), std::pair(target, FT(0)), std::pair(target, FT(0))}};
    const FT left = determined_area(length.ij, length.jk, length.ki),
             right = determined_area(length.ij, length.il, length.lj),
             unit = length.ij * length.ij / cotangents_at_target(h);
    const FT of_target = -cotangents_at_source(length) * unit / (length.ij * length.ij);
    return {-unit * (doubled_corner_product(length.ij, length.jk, length.ki) * right +
                     doubled_corner_product(length.ij, length.il, length.lj) * left),
            {std::pair(target, of_target > 0 ? of_target : FT(0)),
             std::pair(m_mesh.target(m_mesh.next(h)), FT(2 * right * unit)),
             std::pair(m_mesh.target(m_mesh.next(o)), FT(2 * left * unit))}};
  }

  // Returns four times the area of a triangle.
  // \throws Numerical_error if rounding of the sides changes it too much
  static FT determined_area(const FT& a, const FT& b, const FT& c)
  {
    const FT area = quadrupled_area(a, b, c), squares = a * a + b * b + c * c;
    if(area * area < Lengths::least_squared_area() * squares * squares)
      throw Numerical_error("rounding of the lengths does not determine the area of a face");
    return area;
  }

  void forget_edges_around(Vertex_index v)
  {
    for_each_outgoing_halfedge(v, m_mesh, [&](Halfedge_index out) {
      m_is_good_edge[m_mesh.edge(out).idx()] = false;
      if(!m_mesh.is_border(out))
        m_is_good_edge[m_mesh.edge(m_mesh.next(out)).idx()] = false;
    });
  }

  Lengths m_lengths;
  const Delta_complex& m_mesh;
  std::vector<FT>& m_weights;
  mutable std::vector<char> m_is_good_edge; // known to satisfy the condition
  Is_locally_weighted_Delaunay<FT> m_is_good{Lengths::error()};
  bool m_has_failed = false;
};

// Returns whether the area of a triangle is far above its error, if this is the relative error of
// its sides.
template <typename FT>
bool has_area(const FT& a, const FT& b, const FT& c, const FT& error)
{
  const FT squares = a * a + b * b + c * c;
  return squared_quadrupled_area(a, b, c) > 16 * error * squares * squares;
}

// Flips ties beside faces with almost no area until they are Delaunay, if one of the corners is
// hidden. All edges of a hidden vertex are ties.
template <typename Lengths>
class Tie_flipping
{
  typedef typename Lengths::FT FT;

public:
  // Lengths have the relative error `error`.
  Tie_flipping(Weighted_flipping<Lengths>& flipping, const Delta_complex& mesh,
               const std::vector<Vertex_index>& hidden, const FT& error)
    : m_flipping(flipping),
      m_mesh(mesh),
      m_error(error),
      m_is_hidden(mesh.num_vertices(), 0),
      m_is_good{error}
  {
    for(Vertex_index v : hidden)
      m_is_hidden[v.idx()] = 1;
  }

  bool is_certainly_Delaunay(Edge_index e) const
  {
    return m_mesh.is_border(e) || m_is_good.is_certain(m_flipping.length(m_mesh.halfedge(e)));
  }

  bool is_Delaunay(Edge_index e) const
  {
    const Halfedge_index h = m_mesh.halfedge(e);
    const Diamond<FT> d = m_flipping.length(h);
    return m_is_good(d) ||
           (has_area(d.ij, d.jk, d.ki, m_error) && has_area(d.ij, d.il, d.lj, m_error)) ||
           !has_hidden_corner(h) || !m_flipping.is_tie(h, m_error);
  }

  bool flip(Halfedge_index h) { return m_flipping.flip(h); }

private:
  bool has_hidden_corner(Halfedge_index h) const
  {
    const auto corners = diamond_corners(h, m_mesh);
    return std::any_of(corners.begin(), corners.end(),
                       [&](Vertex_index v) { return m_is_hidden[v.idx()] != 0; });
  }

  Weighted_flipping<Lengths>& m_flipping;
  const Delta_complex& m_mesh;
  FT m_error;
  std::vector<char> m_is_hidden;
  typename Euclidean_geometry_traits<FT>::Is_locally_Delaunay m_is_good;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_WEIGHTS_WEIGHTED_FLIPPING_H
