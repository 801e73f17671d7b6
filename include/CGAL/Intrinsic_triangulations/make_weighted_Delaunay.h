// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_MAKE_WEIGHTED_DELAUNAY_H
#define CGAL_INTRINSIC_TRIANGULATIONS_MAKE_WEIGHTED_DELAUNAY_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Edge_stack.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/make_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/named_parameters.h>
#include <CGAL/Intrinsic_triangulations/tolerances.h>
#include <CGAL/Intrinsic_triangulations/weighted_formulas.h>

#include <boost/property_map/function_property_map.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsWeights
/// returns whether every edge of `tri` that could be flipped is weighted Delaunay. With floating
/// point numbers the tolerance is one-sided, as in `is_Delaunay()`. Complexity: linear.
template <typename Traits, typename WeightMap>
bool is_weighted_Delaunay(const Intrinsic_triangulation<Traits>& tri, const WeightMap& weight)
{
  const Delta_complex& mesh = tri.mesh();
  const Is_locally_weighted_Delaunay<typename Traits::FT> is_good;
  for(Edge_index e : mesh.edges())
    if(const Halfedge_index h = mesh.halfedge(e);
       !mesh.is_border(e) && !tri.is_constrained(e) &&
       !is_good(diamond(tri.length_map(), h, mesh), diamond_weights(weight, h, mesh)))
      return false;
  return true;
}

/// \ingroup PkgIntrinsicTriangulationsWeights
/// the result of `make_weighted_Delaunay()`.
template <typename FT>
struct Weighted_Delaunay_result
{
  /// the number of flips.
  std::size_t flips = 0;
  /// the vertices that others hide, as their weights are too small, in increasing order.
  std::vector<Vertex_index> hidden_vertices;
  /// the weights of the vertices of \f$T_2\f$, by index, for which it is weighted Delaunay.
  /// Visible vertices have their given weights. Hidden vertices have the least weight with which
  /// others do not hide them.
  std::vector<FT> weights;

  /// returns `weights` as a property map, which refers to this object.
  auto weight_map() const
  {
    return boost::make_function_property_map<Vertex_index>(
      [this](Vertex_index v) { return weights[v.idx()]; });
  }
};

namespace internal {

// Decisions by the stored lengths and weights. An edge that is not weighted Delaunay and cannot be
// flipped waits for larger weights.
template <typename Traits>
class Weighted_flipping
{
  typedef typename Traits::FT FT;
  typedef Intrinsic_triangulation<Traits> Triangulation;

public:
  Weighted_flipping(Triangulation& tri, std::vector<FT>& weights) : m_tri(tri), m_weights(weights)
  {}

  bool is_certainly_Delaunay(Edge_index e) const
  {
    const Halfedge_index h = m_tri.mesh().halfedge(e);
    return m_tri.mesh().is_border(e) ||
           m_is_good.is_certain(diamond(m_tri.length_map(), h, m_tri.mesh()), weights(h));
  }

  bool is_Delaunay(Edge_index e) const
  {
    return satisfies_condition(e) || !m_tri.is_flippable(m_tri.mesh().halfedge(e));
  }

  // Returns whether that was possible. The new edge is Delaunay, up to rounding of lengths.
  bool flip(Halfedge_index h)
  {
    if(!succeeds<Traits>([&] { m_tri.flip(h); }))
      return false;
    m_has_failed = m_has_failed || !satisfies_condition(m_tri.mesh().edge(h));
    return true;
  }

  bool has_failed() const { return m_has_failed; }

  // If an edge is not weighted Delaunay, and the union of its faces is not convex, one end is
  // hidden. Raises the weight of this end until the edge is weighted Delaunay. As lifted points,
  // the end lies above the triangle of the three others, and comes down to it: it is not moved too
  // far. Returns whether such an edge was found.
  bool raise_weights()
  {
    bool result = false;
    for(Edge_index e : m_tri.mesh().edges())
      if(!satisfies_condition(e) && !m_tri.is_flippable(m_tri.mesh().halfedge(e)))
        result = raise_weight(hidden_end(e)) || result;
    return result;
  }

private:
  Diamond_weights<FT> weights(Halfedge_index h) const
  {
    return diamond_weights(boost::make_function_property_map<Vertex_index>(
                             [this](Vertex_index v) { return m_weights[v.idx()]; }),
                           h, m_tri.mesh());
  }

  bool satisfies_condition(Edge_index e) const
  {
    const Halfedge_index h = m_tri.mesh().halfedge(e);
    return m_tri.mesh().is_border(e) || m_tri.is_constrained(e) ||
           m_is_good(diamond(m_tri.length_map(), h, m_tri.mesh()), weights(h));
  }

  // Returns the halfedge of `e` from the end at which the diamond is not convex. The sum of the
  // cotangents of its two angles is less than at the other end.
  Halfedge_index hidden_end(Edge_index e) const
  {
    const Halfedge_index h = m_tri.mesh().halfedge(e), o = opposite(h);
    if(m_tri.mesh().next(h) == o)
      return o;
    return m_tri.mesh().prev(h) == o || cotangents_at_target(h) > cotangents_at_target(o) ? h : o;
  }

  FT cotangents_at_target(Halfedge_index h) const
  {
    return cotangents_at_source(diamond(m_tri.length_map(), opposite(h), m_tri.mesh()));
  }

  // The condition is linear in the weight of the source of `h`. Returns whether that has changed.
  bool raise_weight(Halfedge_index h)
  {
    const Diamond<FT> length = diamond(m_tri.length_map(), h, m_tri.mesh());
    const auto [left, right] = weighted_triangles(length, weights(h));
    const FT sum = left.scaled_height() * quadrupled_area(length.ij, length.il, length.lj) +
                   right.scaled_height() * quadrupled_area(length.ij, length.jk, length.ki);
    FT& weight = m_weights[m_tri.mesh().source(h).idx()];
    const FT before = weight;
    weight -= sum * (length.ij * length.ij) / cotangents_at_target(h);
    if(!(weight > before))
      throw Numerical_error("rounding of the lengths hides vertex " +
                            std::to_string(m_tri.mesh().source(h).idx()));
    return true;
  }

  Triangulation& m_tri;
  std::vector<FT>& m_weights;
  Is_locally_weighted_Delaunay<FT> m_is_good;
  bool m_has_failed = false;
};

// Flips until an edge that is not weighted Delaunay has a hidden end.
template <typename Traits, typename Visitor>
std::size_t flip_with_weights(Intrinsic_triangulation<Traits>& tri,
                              std::vector<typename Traits::FT>& weights, std::size_t limit,
                              Visitor& visitor)
{
  const Flipping_result result = flip_in_rounds(
    tri, [&] { return Weighted_flipping<Traits>(tri, weights); }, limit, rounds_of_flips(), visitor,
    Concurrency());
  check_flip_limit(result.end == Flipping_result::End::limit);
  if(!result.is_Delaunay())
    throw Numerical_error(
      "rounding of the lengths keeps the triangulation from becoming weighted Delaunay");
  return result.flips;
}

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsWeights
/// flips edges of `tri` until it is weighted Delaunay for the weights of its vertices. Then the
/// surface of lifted points \f$(x, |x|^2 - w)\f$, developed over any two neighboring faces, is
/// convex. Boundary and constrained edges stay. The weights may have any sign; if all are equal
/// the result is Delaunay.
///
/// A vertex whose weight is too small is hidden by others: no triangulation with this vertex is
/// weighted Delaunay. Its weight is then raised to the least weight with which others do not hide
/// it, so that all its edges are ties. The result names such vertices.
///
/// The stored lengths decide, with the one-sided tolerance of `Is_locally_weighted_Delaunay`. If
/// there were more flips than edges, lengths are recomputed from \f$T_1\f$.
///
/// \tparam Traits a model of `IntrinsicGeometryTraits` for Euclidean triangles
/// \tparam WeightMap a model of `ReadablePropertyMap` with key type `Vertex_index` and a value type
///   convertible to `Traits::FT`
/// \tparam NamedParameters a sequence of named parameters
/// \param tri the triangulation
/// \param weight the weights of the vertices of \f$T_2\f$, such as squared radii
/// \param np
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{number_of_iterations}
///     \cgalParamDescription{the number of flips that are allowed}
///     \cgalParamType{`std::size_t`}
///     \cgalParamDefault{a hundred million plus a thousand for each edge}
///   \cgalParamNEnd
///   \cgalParamNBegin{visitor}
///     \cgalParamDescription{is notified of every flip}
///     \cgalParamType{a model of `FlipVisitor`; it is copied unless `std::ref()` refers to it}
///     \cgalParamDefault{`Default_flip_visitor`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// Complexity: linear in the edges and flips, times the number of times that weights are raised.
/// \returns the number of flips, the hidden vertices and the weights for which `tri` is weighted
///          Delaunay
/// \throws Flip_limit_exceeded if more flips than allowed were needed
/// \throws Numerical_error if a length is not positive and finite, or rounding of the lengths
///         prevents the postcondition
/// \throws Overflow_error if a normal coordinate is out of range
/// After an exception `tri` is a valid triangulation of the same surface.
/// \post `is_weighted_Delaunay(tri, result.weight_map())`
template <typename Traits, typename WeightMap,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
auto make_weighted_Delaunay(Intrinsic_triangulation<Traits>& tri, const WeightMap& weight,
                            const NamedParameters& np = CGAL::parameters::default_values())
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  typedef typename Traits::FT FT;
  const Delta_complex& mesh = tri.mesh();
  const auto limit = static_cast<std::size_t>(
    choose_parameter(get_parameter(np, CGAL::internal_np::number_of_iterations),
                     default_flip_limit(mesh.number_of_edges())));
  Default_flip_visitor silent;
  auto&& visitor = internal::visitor_of(np, silent);
  Weighted_Delaunay_result<FT> result;
  result.weights.assign(mesh.num_vertices(), FT(0));
  for(Vertex_index v : mesh.vertices())
    result.weights[v.idx()] = FT(get(weight, v));
  do
    result.flips += internal::flip_with_weights(tri, result.weights, limit - result.flips, visitor);
  while(internal::Weighted_flipping<Traits>(tri, result.weights).raise_weights());
  for(Vertex_index v : mesh.vertices())
    if(result.weights[v.idx()] > FT(get(weight, v)))
      result.hidden_vertices.push_back(v);
  return result;
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_MAKE_WEIGHTED_DELAUNAY_H
