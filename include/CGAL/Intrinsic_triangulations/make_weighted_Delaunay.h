// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_MAKE_WEIGHTED_DELAUNAY_H
#define CGAL_INTRINSIC_TRIANGULATIONS_MAKE_WEIGHTED_DELAUNAY_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Double_double.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/Input_metric.h>
#include <CGAL/Intrinsic_triangulations/internal/flipping/Exact_flipping.h>
#include <CGAL/Intrinsic_triangulations/internal/validity/check_finite.h>
#include <CGAL/Intrinsic_triangulations/internal/weights/Supporting_triangles.h>
#include <CGAL/Intrinsic_triangulations/internal/weights/Weighted_flipping.h>
#include <CGAL/Intrinsic_triangulations/make_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/named_parameters.h>
#include <CGAL/Intrinsic_triangulations/weighted_formulas.h>

#include <boost/property_map/function_property_map.hpp>

#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsWeights
/// returns whether every edge of `tri` that could be flipped is weighted Delaunay. `weight` is a
/// readable property map from vertices to squared lengths. With floating point numbers the
/// tolerance is one-sided, as in `is_Delaunay()`. Complexity: linear.
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

// Flips until all edges that can be flipped are weighted Delaunay, by stored lengths.
template <typename Traits, typename Visitor>
Flipping_result flip_with_weights(Intrinsic_triangulation<Traits>& tri,
                                  std::vector<typename Traits::FT>& weights, std::size_t limit,
                                  Visitor& visitor)
{
  typedef Weighted_flipping<Stored_lengths<Traits>> Flipping;
  return flip_in_rounds(
    tri, [&] { return Flipping(tri, weights); }, limit, rounds_of_flips(), visitor, Concurrency());
}

// Notes flips, and checks their end.
inline void note_flips(const Flipping_result& result, std::size_t& flips)
{
  flips += result.flips;
  check_flip_limit(result.end == Flipping_result::End::limit);
  if(!result.is_Delaunay())
    throw Numerical_error("rounding of the lengths prevents a weighted Delaunay triangulation");
}

// Flips and raises the weights of hidden vertices, alternately. Adds the number of flips to
// `flips`.
template <typename Flip, typename Raise>
void hide_vertices(std::size_t& flips, const Flip& flip, const Raise& raise)
{
  do
    note_flips(flip(), flips);
  while(raise());
}

// Returns the vertices whose weights have been raised.
template <typename FT>
std::vector<Vertex_index> raised_vertices(const Delta_complex& mesh, const std::vector<FT>& given,
                                          const std::vector<FT>& raised)
{
  std::vector<Vertex_index> result;
  for(Vertex_index v : mesh.vertices())
    if(raised[v.idx()] > given[v.idx()])
      result.push_back(v);
  return result;
}

// \throws Numerical_error if a face has almost no area
template <typename Traits>
void check_areas(const Intrinsic_triangulation<Traits>& tri)
{
  for(Face_index f : tri.mesh().faces()) {
    const auto [a, b, c] = side_lengths(tri.mesh().halfedge(f), tri);
    if(!has_area(a, b, c, Stored_lengths<Traits>::error()))
      throw Numerical_error("rounding of the lengths does not determine the area of face " +
                            std::to_string(f.idx()));
  }
}

// Flips and raises weights by stored lengths.
template <typename Traits, typename Visitor>
void flip_and_hide(Intrinsic_triangulation<Traits>& tri,
                   Weighted_Delaunay_result<typename Traits::FT>& result, std::size_t limit,
                   Visitor& visitor)
{
  typedef Weighted_flipping<Stored_lengths<Traits>> Flipping;
  Supporting_triangles<typename Traits::FT> triangles;
  const auto given = result.weights;
  hide_vertices(
    result.flips,
    [&] { return flip_with_weights(tri, result.weights, limit - result.flips, visitor); },
    [&] { return Flipping(tri, result.weights).raise_weights(triangles); });
  result.hidden_vertices = raised_vertices(tri.mesh(), given, result.weights);
  if(has_exact_decisions<Traits>() && !result.hidden_vertices.empty())
    check_areas(tri); // only hidden vertices need such faces, and ties replace them
}

// Resets T2 to T1, with its inserted vertices, if edges are bent.
template <typename Traits, typename Visitor>
void straighten_edges(Intrinsic_triangulation<Traits>& tri, Visitor& visitor)
{
  if(!Exact_flipping<Traits>(tri).find_lengths())
    restart_from_input(tri, visitor);
}

// Returns a weight with all of its digits.
template <typename FT, typename Weight>
FT with_all_digits(const Weight& weight)
{
  if constexpr(std::is_same_v<Weight, Double_double>)
    return FT(weight.high()) + FT(weight.low());
  else
    return FT(static_cast<double>(weight));
}

// Flips and raises weights by many digits of lengths and weights, after flips by stored lengths.
// Rounded weights of hidden vertices can be equal to the given ones. If decisions are to be exact,
// ties up to rounding of the result stay.
template <typename Traits, typename WeightMap, typename Visitor>
void flip_and_hide_precisely(Intrinsic_triangulation<Traits>& tri, const WeightMap& weight,
                             Weighted_Delaunay_result<double>& result, bool is_exact,
                             std::size_t limit, Visitor& visitor)
{
  typedef Many_digits_lengths<Traits> Lengths;
  typedef typename Lengths::FT FT;
  result.flips += flip_with_weights(tri, result.weights, limit - result.flips, visitor).flips;
  straighten_edges(tri, visitor);
  std::vector<FT> given(result.weights.size(), 0);
  for(Vertex_index v : tri.mesh().vertices())
    given[v.idx()] = with_all_digits<FT>(get(weight, v));
  auto precise = given;
  Weighted_flipping<Lengths> flipping(tri, precise);
  Supporting_triangles<FT> triangles;
  hide_vertices(
    result.flips,
    [&] { return flip_to_Delaunay(tri.mesh(), flipping, limit - result.flips, visitor); },
    [&] { return flipping.raise_weights(triangles); });
  result.hidden_vertices = raised_vertices(tri.mesh(), given, precise);
  if(!is_exact && !result.hidden_vertices.empty()) {
    Tie_flipping<Lengths> ties(flipping, tri.mesh(), result.hidden_vertices,
                               FT(rounding_unit<double>()));
    note_flips(flip_to_Delaunay(tri.mesh(), ties, limit - result.flips, visitor), result.flips);
  }
  flipping.lengths().store();
  for(std::size_t i = 0; i < precise.size(); ++i)
    result.weights[i] = static_cast<double>(precise[i]);
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
/// These weights are the least solution of all conditions: they do not depend on the first
/// triangulation. A sparse linear system gives the weights of vertices that hide each other.
///
/// The stored lengths decide, with the one-sided tolerance of `Is_locally_weighted_Delaunay`. If
/// there were more flips than edges, lengths are recomputed from \f$T_1\f$. With
/// `exact_decisions`, lengths and weights with 155 decimal digits decide, computed from the exact
/// surface and from all digits of weights of type `Double_double`. They also decide if rounding
/// prevents the result, or if rounding changes the weight of a hidden vertex. The reasons are faces
/// with little area, and weights that exceed squared lengths by \f$2^{23}\f$. Weights and lengths
/// of the result are rounded.
///
/// Faces of hidden vertices can have almost no area, because hidden vertices can be almost on lines
/// with others. Edges of such faces that are ties up to rounding are flipped until they are
/// Delaunay. With `exact_decisions`, they stay.
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
///   \cgalParamNBegin{exact_decisions}
///     \cgalParamDescription{whether 155 decimal digits decide, in 10 to 100 times the time}
///     \cgalParamType{`bool`}
///     \cgalParamDefault{`false`}
///   \cgalParamNEnd
///   \cgalParamNBegin{visitor}
///     \cgalParamDescription{is notified of every flip}
///     \cgalParamType{a model of `FlipVisitor`; it is copied unless `std::ref()` refers to it}
///     \cgalParamDefault{`Default_flip_visitor`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// Complexity: linear in the edges and flips, times the number of times that linear systems are
/// solved.
/// \returns the number of flips, the hidden vertices and the weights for which `tri` is weighted
///          Delaunay
/// \throws Flip_limit_exceeded if more flips than allowed were needed
/// \throws Invalid_input if a weight is NaN, or beyond the squares of lengths: \f$2^{254}\f$ for
///         `double`
/// \throws Numerical_error if a length is not positive and finite, or rounding of lengths or
///         weights prevents the postcondition
/// \throws Overflow_error if a normal coordinate is out of range
///
/// After an exception `tri` is a valid triangulation of the same surface.
/// \post `is_weighted_Delaunay(tri, result.weight_map())`, up to rounding of the weights of hidden
///       vertices
template <typename Traits, typename WeightMap,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
auto make_weighted_Delaunay(Intrinsic_triangulation<Traits>& tri, const WeightMap& weight,
                            const NamedParameters& np = CGAL::parameters::default_values())
{
  typedef typename Traits::FT FT;
  const Delta_complex& mesh = tri.mesh();
  const std::size_t limit = internal::flip_limit(mesh, np);
  Default_flip_visitor silent;
  auto&& visitor = internal::visitor_of(np, silent);
  Weighted_Delaunay_result<FT> result;
  result.weights.assign(mesh.num_vertices(), FT(0));
  for(Vertex_index v : mesh.vertices())
    result.weights[v.idx()] = FT(get(weight, v));
  internal::check_weights(result.weights);
  [[maybe_unused]] const bool is_exact = internal::are_exact_decisions_wanted<Traits>(np);
  if constexpr(internal::has_exact_decisions<Traits>() && !internal::Is_exact<Traits>::value) {
    const std::vector<double> given = result.weights;
    if(is_exact ||
       !internal::succeeds<Traits>([&] { internal::flip_and_hide(tri, result, limit, visitor); })) {
      result.weights = given;
      internal::flip_and_hide_precisely(tri, weight, result, is_exact, limit, visitor);
    }
  } else
    internal::flip_and_hide(tri, result, limit, visitor);
  return result;
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_MAKE_WEIGHTED_DELAUNAY_H
