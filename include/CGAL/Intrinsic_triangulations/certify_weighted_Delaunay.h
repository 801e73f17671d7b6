// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CERTIFY_WEIGHTED_DELAUNAY_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CERTIFY_WEIGHTED_DELAUNAY_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delaunay_certificate.h>
#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/exact_numbers.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/for_each_in_chunks.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/Certifier.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/Exact_decisions.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/Input_corners.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/exact_triangles.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Edge_courses.h>
#include <CGAL/Intrinsic_triangulations/internal/validity/check_finite.h>
#include <CGAL/Intrinsic_triangulations/internal/weights/Hidden_weights.h>
#include <CGAL/Intrinsic_triangulations/internal/weights/Vertex_weights.h>
#include <CGAL/Intrinsic_triangulations/internal/weights/Weight_elimination.h>
#include <CGAL/Intrinsic_triangulations/internal/weights/Weight_form.h>
#include <CGAL/Intrinsic_triangulations/named_parameters.h>
#include <CGAL/Intrinsic_triangulations/tolerances.h>
#include <CGAL/Intrinsic_triangulations/weighted_formulas.h>

#include <CGAL/Uncertain.h>
#include <CGAL/enum.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsCertificates
/// the result of `certify_weighted_Delaunay()`. The edges that it names violate the weighted
/// Delaunay condition, or it is undecided whether they do.
struct Weighted_Delaunay_certificate : Delaunay_certificate
{
  /// the vertices that count as hidden, although their weights are great enough to be visible.
  std::vector<Vertex_index> visible_vertices;
  /// the vertices for which it is undecided whether they are hidden.
  std::vector<Vertex_index> possibly_visible_vertices;

  /// returns the number of edges and vertices about which something remains undecided.
  std::size_t undecided() const
  {
    return Delaunay_certificate::undecided() + possibly_visible_vertices.size();
  }
  /// returns whether the triangulation certainly is geodesic and weighted Delaunay, and exactly the
  /// given vertices are hidden.
  bool is_weighted_Delaunay() const
  {
    return is_Delaunay() && visible_vertices.empty() && possibly_visible_vertices.empty();
  }
};

namespace internal {

// Represents the local weighted Delaunay condition.
template <typename Traits>
class Weighted_Delaunay_condition
{
public:
  Weighted_Delaunay_condition(const Delta_complex& mesh, const Vertex_weights& weights)
    : m_mesh(mesh), m_weights(weights)
  {}

  // Returns whether the edge of `h` is weighted Delaunay for any rounding of lengths. The weights
  // of its corners must be known exactly.
  bool is_certain(Halfedge_index h, const Diamond<double>& length) const
  {
    const auto corners = diamond_corners(h, m_mesh);
    const auto given = [&](std::size_t i) { return m_weights.given(corners[i]); };
    return std::none_of(corners.begin(), corners.end(),
                        [&](Vertex_index v) { return m_weights.is_hidden(v); }) &&
           Is_locally_weighted_Delaunay<double>{certified_length_error()}.is_certain(
             length, {given(0), given(1), given(2), given(3)});
  }

  // Returns the sign of the dual edge of the edge of `h`: ZERO is a tie.
  // \throws Numerical_error if it is not determined
  Sign sign(Halfedge_index h, Exact_decisions<Traits>& decisions) const
  {
    if(m_weights.ties().count(m_mesh.edge(h)) > 0)
      return ZERO;
    if(!m_weights.is_enclosed())
      throw Numerical_error("the weights of hidden vertices are not enclosed");
    decisions.allow_roots(most_roots);
    return decisions.template decide<Exact_field, Exact_corners_to_scale>(
      [&](const auto& development) { return sign_in(development, h); });
  }

private:
  // Fractions with more roots take minutes.
  static constexpr std::size_t most_roots = 4;

  template <typename Development>
  Uncertain<Sign> sign_in(const Development& development, Halfedge_index h) const
  {
    if constexpr(Development::is_rounded)
      return rounded_dual_edge_sign(h, m_mesh, development, m_weights);
    else
      return Weight_elimination<Development>(m_mesh, m_weights, development).sign(h);
  }

  const Delta_complex& m_mesh;
  const Vertex_weights& m_weights;
};

// Decides which vertices have smaller weights than they need to be visible.
inline void check_hidden_vertices(const Vertex_weights& weights,
                                  Weighted_Delaunay_certificate& certificate)
{
  for(const auto& [v, hidden] : weights.hidden()) {
    const Long_float excess = hidden.value - Long_float(weights.given(v)), error(hidden.error);
    if(excess < -error)
      certificate.visible_vertices.push_back(v);
    else if(!(excess > error) || !hidden.bound.is_certain)
      certificate.possibly_visible_vertices.push_back(v);
  }
}

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsCertificates
/// certifies that \f$T_2\f$ is a geodesic weighted Delaunay triangulation of the surface of
/// \f$T_1\f$ for weights of its vertices, however it was made. The surface and the weights count
/// as exact, as in `certify_Delaunay()`.
///
/// The given weights of hidden vertices must be less than the least weights with which others do
/// not hide these vertices (\ref it_weights). The least weights solve a linear system. Intervals of
/// 1024 bits enclose them, and exact elimination decides edges that may be ties.
///
/// A decision remains undecided if 1024 bits do not distinguish its sign from zero. It must also
/// involve more than four square roots that are independent over the rationals, or the weights of
/// more than 64 hidden vertices.
///
/// Complexity: as `certify_Delaunay()`, plus the solution of the linear system.
/// \tparam Traits as for `certify_Delaunay()`
/// \tparam WeightMap a model of `ReadablePropertyMap` with key type `Vertex_index` and value type
///   `double`
/// \tparam NamedParameters a sequence of named parameters
/// \param tri the triangulation
/// \param weight the weights for which it is to be weighted Delaunay, as they were given to
///        `make_weighted_Delaunay()`
/// \param hidden the vertices that others hide, such as
///        `Weighted_Delaunay_result::hidden_vertices`
/// \param np
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{concurrency_tag}
///     \cgalParamDescription{whether several threads are used; see \ref it_parallel}
///     \cgalParamType{`CGAL::Sequential_tag`, `CGAL::Parallel_tag` or
///                    `CGAL::Parallel_if_available_tag`}
///     \cgalParamDefault{`CGAL::Sequential_tag`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
/// \throws Invalid_input if \f$T_1\f$ is given by lengths that violate the triangle inequality, or
///         a weight is NaN or beyond the squares of lengths: \f$2^{254}\f$ for `double`
/// \pre `hidden` are vertices of `tri`
template <typename Traits, typename WeightMap,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
Weighted_Delaunay_certificate
certify_weighted_Delaunay(const Intrinsic_triangulation<Traits>& tri, const WeightMap& weight,
                          const std::vector<Vertex_index>& hidden,
                          const NamedParameters& np = CGAL::parameters::default_values())
{
  static_assert(internal::has_metric<Traits>(), "a certificate needs the traits of "
                                                "certify_Delaunay()");
  std::vector<double> given(tri.mesh().num_vertices(), 0.);
  for(Vertex_index v : tri.mesh().vertices())
    given[v.idx()] = get(weight, v);
  internal::check_weights(given);
  internal::check_exact_triangles(internal::exact_input(tri));
  const Concurrency concurrency = concurrency_of(np);
  const internal::Edge_courses<Traits> courses(tri, concurrency);
  internal::Vertex_weights weights(std::move(given));
  for(Vertex_index v : hidden) {
    CGAL_precondition(tri.mesh().has_valid_index(v));
    weights.hidden()[v];
  }
  std::vector<Vertex_index> visible =
    internal::Hidden_weights<Traits>(tri, courses, weights).enclose();
  typedef internal::Weighted_Delaunay_condition<Traits> Condition;
  Weighted_Delaunay_certificate result{
    internal::Certifier<Traits, Condition>(tri, courses, concurrency, {tri.mesh(), weights}).run(),
    std::move(visible),
    {}};
  internal::check_hidden_vertices(weights, result);
  return result;
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CERTIFY_WEIGHTED_DELAUNAY_H
