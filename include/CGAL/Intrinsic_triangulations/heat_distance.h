// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_HEAT_DISTANCE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_HEAT_DISTANCE_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Edge_point.h>
#include <CGAL/Intrinsic_triangulations/Surface_view.h>
#include <CGAL/Intrinsic_triangulations/internal/operators/Heat_flow.h>
#include <CGAL/Intrinsic_triangulations/named_parameters.h>
#include <CGAL/Intrinsic_triangulations/operators.h>
#include <CGAL/Intrinsic_triangulations/poisson.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <boost/property_map/function_property_map.hpp>

#include <Eigen/Dense>
#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsOperators
/// computes geodesic distances on a triangulated surface by the heat method \cgalCite{CWW17}, for
/// one set of sources after the other; the two matrices are factorized once.
///
/// The distance is zero at every source: it is the function with this property whose gradient comes
/// closest to the direction away from the sources. Without the condition, the function with that
/// gradient takes different values at different sources, by many edge lengths if these fill a
/// region, so that no constant subtracted from it is right; one source needs no more than a
/// constant.
///
/// Distances are approximate: on a Delaunay triangulation with evenly spread vertices they are off
/// by one to three percent on average, on others they can be far off. Refinement makes the error
/// smaller, but since the time step shrinks along, not without end; a greater `time_step_factor` on
/// a finer mesh does.
///
/// The object does not refer to the mesh, and holds for as long as connectivity and lengths stay.
///
/// \tparam FT_ a floating point type
template <typename FT_ = double>
class Heat_distance
{
public:
  /// the type of distances.
  typedef FT_ FT;
  /// the type of functions: a value for each vertex, by its index.
  typedef Eigen::Matrix<FT, Eigen::Dynamic, 1> Vector;

  /// prepares for distances on a surface. Complexity: two sparse Cholesky factorizations.
  ///
  /// \param surface a model of `IntrinsicSurface`, with any number of components, with or without
  ///   boundary
  /// \param np
  /// \cgalNamedParamsBegin
  ///   \cgalParamNBegin{time_step_factor}
  ///     \cgalParamDescription{the time for which heat flows, in squared mean edge lengths}
  ///     \cgalParamType{a number}
  ///     \cgalParamDefault{1}
  ///   \cgalParamNEnd
  /// \cgalNamedParamsEnd
  /// \throws Numerical_error if the area of a face is zero or out of range, or if rounding leaves a
  ///         matrix without a factorization
  /// \throws Invalid_input if the factor is not positive and finite
  template <typename Surface, typename NamedParameters = CGAL::parameters::Default_named_parameters>
  explicit Heat_distance(const Surface& surface,
                         const NamedParameters& np = CGAL::parameters::default_values())
    : m_flow(surface, np),
      m_gradient(gradient_matrix(surface)),
      m_divergence(divergence_matrix(surface)),
      m_poisson(surface, m_flow.order())
  {}

  /// computes the distance of every vertex to the nearest source. It is exactly zero at the sources
  /// and infinite on a component without a source; elsewhere it can be below zero by an error of
  /// the method. Complexity: linear in the size of the factorizations; if a component has more than
  /// one source, another sparse Cholesky factorization.
  /// \param sources a range of vertices
  /// \throws Numerical_error if the heat is below the range of `FT` somewhere: with `double` that
  ///         takes some 1400 mean edge lengths (and less with a factor below one)
  template <typename VertexRange>
  Vector distances(const VertexRange& sources) const
  {
    const Vector is_source = m_flow.indicator(sources);
    const Vector descent = unit_descent(m_flow.spread_everywhere(is_source));
    const Vector moments = -(m_divergence * descent);
    Vector result = has_several_sources(is_source) ? with_zero_at(is_source).solve(moments)
                                                   : m_poisson.solve(moments);
    subtract_value_at_source(result, is_source);
    return result;
  }

  /// computes the distance of every vertex to one source. Complexity: linear in the size of the
  /// factorizations.
  Vector distances(Vertex_index source) const { return distances(std::array{source}); }

private:
  // against the gradient of the heat, of length one; zero where the gradient is
  Vector unit_descent(const Vector& heat) const
  {
    Vector field = -(m_gradient * heat);
    for(Eigen::Index i = 0; i < field.size(); i += 2)
      if(const FT norm = std::hypot(field[i], field[i + 1]); norm > 0)
        field.template segment<2>(i) /= norm;
    return field;
  }

  bool has_several_sources(const Vector& is_source) const
  {
    const auto count = m_flow.number_of_sources(is_source);
    return std::any_of(count.begin(), count.end(), [](std::size_t n) { return n > 1; });
  }

  Poisson_solver<FT> with_zero_at(const Vector& is_source) const
  {
    return Poisson_solver<FT>(m_poisson,
                              boost::make_function_property_map<Vertex_index>(
                                [&](Vertex_index v) { return is_source[v.idx()] != 0; }));
  }

  // Where there are several sources on a component, the values there are zero already.
  void subtract_value_at_source(Vector& distance, const Vector& is_source) const
  {
    const auto& components = m_flow.components();
    const auto component = [&](Eigen::Index v) { return components[static_cast<std::size_t>(v)]; };
    // without a source, all distances become infinite
    std::vector<FT> at_source(components.size(), -std::numeric_limits<FT>::infinity());
    for(Eigen::Index v = 0; v < distance.size(); ++v)
      if(is_source[v] != 0)
        at_source[component(v)] = distance[v];
    for(Eigen::Index v = 0; v < distance.size(); ++v)
      distance[v] -= at_source[component(v)];
  }

  internal::Heat_flow<FT> m_flow;
  Eigen::SparseMatrix<FT> m_gradient, m_divergence;
  Poisson_solver<FT> m_poisson;
};

/// \ingroup PkgIntrinsicTriangulationsOperators
/// computes the geodesic distance of every vertex to the nearest source (see `Heat_distance`).
/// Complexity: two sparse Cholesky factorizations.
/// \param surface a model of `IntrinsicSurface`
/// \param sources a vertex or a range of vertices
/// \param np as for `Heat_distance`
/// \throws Numerical_error, Invalid_input as `Heat_distance`
template <typename Surface, typename Sources,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
auto heat_distance(const Surface& surface, const Sources& sources,
                   const NamedParameters& np = CGAL::parameters::default_values())
{
  return Heat_distance<Length_of<Surface>>(surface, np).distances(sources);
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_HEAT_DISTANCE_H
