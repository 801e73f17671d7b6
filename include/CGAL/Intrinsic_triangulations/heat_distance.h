// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_HEAT_DISTANCE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_HEAT_DISTANCE_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Distance_sources.h>
#include <CGAL/Intrinsic_triangulations/Factorization.h>
#include <CGAL/Intrinsic_triangulations/Surface_view.h>
#include <CGAL/Intrinsic_triangulations/for_each_in_chunks.h>
#include <CGAL/Intrinsic_triangulations/internal/operators/Heat_method.h>
#include <CGAL/Intrinsic_triangulations/named_parameters.h>
#include <CGAL/Intrinsic_triangulations/poisson.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <boost/property_map/property_map.hpp>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsOperators
/// computes geodesic distances on a triangulated surface by the heat method \cgalCite{CWW17}. Two
/// matrices are factorized once, for any number of sets of sources.
///
/// Sources are vertices, or with `Distance_sources` points anywhere and curves. The distance is
/// zero at every vertex that is a source. Of the functions with this property, the gradient of the
/// distance comes closest to the direction away from the sources.
///
/// Distances are approximate. On a Delaunay triangulation with evenly spread vertices their errors
/// are one to three percent on average; on others they can be large. Refinement reduces the error
/// only up to a limit, unless the `time_step_factor` is increased too.
///
/// The object does not refer to the mesh, and is valid as long as connectivity and lengths do not
/// change.
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
  /// the type of several functions, a column for each.
  typedef Eigen::Matrix<FT, Eigen::Dynamic, Eigen::Dynamic> Columns;

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
  /// \throws Invalid_input if the factor is not positive, or is above \f$1.6 \cdot 10^{13}\f$
  template <typename Surface, typename NamedParameters = CGAL::parameters::Default_named_parameters>
  explicit Heat_distance(const Surface& surface,
                         const NamedParameters& np = CGAL::parameters::default_values())
    : m_flow(surface, np),
      m_method(surface),
      m_poisson(
        Method::poisson_solver(surface, m_flow.order(), boost::static_property_map<bool>(false)))
  {}

  /// computes the distance of every vertex to the nearest source. It is exactly zero at the sources
  /// and infinite on a component without a source. Elsewhere it can be below zero by an error of
  /// the method. Complexity: linear in the size of the factorizations; if a component has more than
  /// one source, another sparse Cholesky factorization.
  /// \param sources a range of vertices
  /// \throws Underflow_error if heat underflows somewhere. With `double`, this happens at distances
  ///         of about 1400 mean edge lengths, and less with a factor below one
  template <typename VertexRange>
  Vector distances(const VertexRange& sources) const
  {
    return distances_from(m_method.values_of(sources));
  }

  /// computes the distance of every vertex to one source. Complexity: linear in the size of the
  /// factorizations.
  Vector distances(Vertex_index source) const { return distances(std::array{source}); }

  /// computes the distance of every vertex to the nearest of some vertices, points and curves on
  /// the surface. At the ends of an edge with sources, it is the distance within the edge. At the
  /// corners of a face with sources, it is the distance within the face. A curve counts as many
  /// sources. Complexity: linear in the size of the factorizations; if a component has more than
  /// one source, another sparse Cholesky factorization.
  template <typename Surface>
  Vector distances(const Distance_sources<Surface>& sources) const
  {
    return distances_from(m_method.values_of(sources));
  }

  /// computes the distance of every vertex from each of some sources. Complexity: linear in the
  /// size of the factorizations for each source, and several times less than with `distances()`.
  /// \param sources a random access range of vertices, of ranges of vertices, or of
  ///   `Distance_sources`
  /// \param np
  /// \cgalNamedParamsBegin
  ///   \cgalParamNBegin{concurrency_tag}
  ///     \cgalParamDescription{whether several threads are used}
  ///     \cgalParamType{`CGAL::Sequential_tag`, `CGAL::Parallel_tag`, or
  ///       `CGAL::Parallel_if_available_tag`}
  ///     \cgalParamDefault{`CGAL::Sequential_tag`}
  ///   \cgalParamNEnd
  /// \cgalNamedParamsEnd
  /// \returns a matrix with a column for each source, equal to the result of `distances()` up to
  ///   rounding. It does not depend on the number of threads.
  template <typename SourceRange,
            typename NamedParameters = CGAL::parameters::Default_named_parameters>
  Columns distances_from_each(const SourceRange& sources,
                              const NamedParameters& np = CGAL::parameters::default_values()) const
  {
    constexpr std::size_t sources_at_once = 8;
    Columns result(m_method.number_of_vertices(), static_cast<Eigen::Index>(sources.size()));
    const auto compute = [&](std::size_t begin, std::size_t end) {
      std::vector<typename Method::Source_values> values;
      for(std::size_t i = begin; i < end; ++i)
        values.push_back(m_method.values_of(sources[i]));
      distances_from(values, result.middleCols(static_cast<Eigen::Index>(begin),
                                               static_cast<Eigen::Index>(end - begin)));
    };
    for_each_chunk(concurrency_of(np), sources.size(), compute, sources_at_once);
    return result;
  }

private:
  typedef internal::Heat_method<FT> Method;

  // Solves for all sets of sources at once, except for sets that prescribe values.
  template <typename Result>
  void distances_from(const std::vector<typename Method::Source_values>& sources,
                      Result&& result) const
  {
    Columns columns(result.rows(), result.cols());
    for(Eigen::Index k = 0; k < columns.cols(); ++k)
      columns.col(k) = sources[static_cast<std::size_t>(k)].moments;
    columns = m_flow.spread_columns_everywhere(columns);
    for(Eigen::Index k = 0; k < columns.cols(); ++k)
      columns.col(k) = m_method.moments(columns.col(k));
    const Columns distances = m_poisson.solve_columns(columns);
    for(Eigen::Index k = 0; k < columns.cols(); ++k) {
      const auto& values = sources[static_cast<std::size_t>(k)];
      result.col(k) = m_method.without_error_at_sources(
        values.are_several ? with_prescribed(columns.col(k), values) : Vector(distances.col(k)),
        values);
    }
  }

  Vector with_prescribed(const Vector& moments, const typename Method::Source_values& sources) const
  {
    return Poisson_solver<FT>(m_poisson, sources.prescribed()).solve(moments, sources.distance);
  }

  Vector distances_from(const typename Method::Source_values& sources) const
  {
    const Vector moments = m_method.moments(m_flow.spread_everywhere(sources.moments));
    const Vector distance =
      sources.are_several ? with_prescribed(moments, sources) : m_poisson.solve(moments);
    return m_method.without_error_at_sources(distance, sources);
  }

  internal::Heat_flow<FT> m_flow;
  Method m_method;
  Poisson_solver<FT> m_poisson;
};

/// \ingroup PkgIntrinsicTriangulationsOperators
/// computes the geodesic distance of every vertex to the nearest source (see `Heat_distance`).
/// Complexity: two sparse Cholesky factorizations, one after the other in the same memory.
/// \param surface a model of `IntrinsicSurface`
/// \param sources a vertex, an `Edge_point`, a `Face_location`, a `Surface_point`, a
///        `Curve_segment`, a range of one of these, such as a `Surface_curve`, or
///        `Distance_sources`
/// \param np as for `Heat_distance`
/// \throws Numerical_error, Invalid_input as `Heat_distance`
template <typename Surface, typename Sources,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
auto heat_distance(const Surface& surface, const Sources& sources,
                   const NamedParameters& np = CGAL::parameters::default_values())
{
  typedef Length_of<Surface> FT;
  Distance_sources<Surface> all(surface);
  all.add(sources);
  std::optional<internal::Heat_flow<FT>> flow(std::in_place, surface, np);
  const internal::Heat_method<FT> method(surface);
  const auto values = method.values_of(all);
  const auto moments = method.moments(flow->spread_everywhere(values.moments));
  const Elimination_order order = flow->order();
  flow.reset(); // the other factor comes in its place
  const auto poisson =
    internal::Heat_method<FT>::poisson_solver(surface, order, values.prescribed());
  return method.without_error_at_sources(poisson.solve(moments, values.distance), values);
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_HEAT_DISTANCE_H
