// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_HEAT_DISTANCE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_HEAT_DISTANCE_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Distance_sources.h>
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
/// Sources are vertices, or with `Distance_sources` points anywhere and curves. The distance is
/// zero at every vertex that is a source: it is the function with this property whose gradient
/// comes closest to the direction away from the sources. Without the condition, the function with
/// that gradient takes different values at different sources, by many edge lengths if these fill a
/// region, so that subtracting a constant does not suffice; for one source it does.
///
/// Distances are approximate: on a Delaunay triangulation with evenly spread vertices their errors
/// are one to three percent on average; on others errors can be large. Since the time step
/// decreases with the edge lengths, refinement reduces the error only up to a limit, unless the
/// `time_step_factor` is increased too.
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
      m_mean_length(internal::time_steps(surface, FT(1), m_flow.components())),
      m_gradient(gradient_matrix(surface)),
      m_divergence(divergence_matrix(surface)),
      m_poisson(surface, m_flow.order())
  {
    for(FT& length : m_mean_length)
      length = CGAL::sqrt(length);
  }

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
    std::vector<Part> parts;
    for(Vertex_index v : sources)
      parts.push_back(Part::at_vertex(v));
    return distances_from(parts);
  }

  /// computes the distance of every vertex to one source. Complexity: linear in the size of the
  /// factorizations.
  Vector distances(Vertex_index source) const { return distances(std::array{source}); }

  /// computes the distance of every vertex to the nearest of some vertices, points and curves on
  /// the surface. At the ends of an edge and the corners of a face in which there are sources, it
  /// is the distance within the edge or face. A curve counts as many sources. Complexity: linear
  /// in the size of the factorizations; if a component has more than one source, another sparse
  /// Cholesky factorization.
  template <typename Surface>
  Vector distances(const Distance_sources<Surface>& sources) const
  {
    return distances_from(sources.m_parts);
  }

private:
  typedef internal::Source_part<FT> Part;

  // What the sources determine directly.
  struct Source_values
  {
    Vector moments;           // of the heat
    Vector distance;          // infinite where it is not known
    bool are_several = false; // on some component

    bool is_known(Eigen::Index v) const { return distance[v] < infinity(); }
  };

  static FT infinity() { return std::numeric_limits<FT>::infinity(); }

  std::size_t component(Eigen::Index v) const
  {
    return m_flow.components()[static_cast<std::size_t>(v)];
  }

  Vector distances_from(const std::vector<Part>& parts) const
  {
    const Source_values sources = values_of(parts);
    const Vector descent = unit_descent(m_flow.spread_everywhere(sources.moments));
    const Vector moments = -(m_divergence * descent);
    Vector result = sources.are_several ? with_known(sources).solve(moments, sources.distance)
                                        : m_poisson.solve(moments);
    subtract_error_at_sources(result, sources);
    return result;
  }

  // On a curve, there is as much heat as with a vertex for each mean edge length.
  Source_values values_of(const std::vector<Part>& parts) const
  {
    const Eigen::Index n = m_flow.rates().size();
    Source_values result{Vector::Zero(n), Vector::Constant(n, infinity())};
    std::vector<char> has_source(m_flow.components().size(), 0);
    for(const Part& part : parts) {
      if(part.is_vertex() && result.distance[part.vertex().idx()] == 0)
        continue;
      const std::size_t c = component(part.vertex().idx());
      const FT unit = part.length > 0 ? m_mean_length[c] : FT(1);
      for(const auto& [v, moment, distance] : part.corners) {
        result.moments[v.idx()] += moment / unit;
        result.distance[v.idx()] = (std::min)(result.distance[v.idx()], distance);
      }
      result.are_several = result.are_several || has_source[c] || part.length > 0;
      has_source[c] = 1;
    }
    return result;
  }

  // against the gradient of the heat, of length one; zero where the gradient is
  Vector unit_descent(const Vector& heat) const
  {
    Vector field = -(m_gradient * heat);
    for(Eigen::Index i = 0; i < field.size(); i += 2)
      if(const FT norm = std::hypot(field[i], field[i + 1]); norm > 0)
        field.template segment<2>(i) /= norm;
    return field;
  }

  Poisson_solver<FT> with_known(const Source_values& sources) const
  {
    return Poisson_solver<FT>(m_poisson,
                              boost::make_function_property_map<Vertex_index>(
                                [&](Vertex_index v) { return sources.is_known(v.idx()); }));
  }

  // Where there are several sources on a component, the values there are known already.
  void subtract_error_at_sources(Vector& distance, const Source_values& sources) const
  {
    std::vector<FT> error(m_flow.components().size(), FT(0)), weight = error;
    for(Eigen::Index v = 0; v < distance.size(); ++v)
      if(sources.is_known(v)) {
        error[component(v)] += sources.moments[v] * (distance[v] - sources.distance[v]);
        weight[component(v)] += sources.moments[v];
      }
    // without a source, all distances become infinite
    for(Eigen::Index v = 0; v < distance.size(); ++v)
      if(const std::size_t c = component(v); weight[c] > 0)
        distance[v] -= error[c] / weight[c];
      else
        distance[v] = infinity();
  }

  internal::Heat_flow<FT> m_flow;
  std::vector<FT> m_mean_length; // of the edges of each component
  Eigen::SparseMatrix<FT> m_gradient, m_divergence;
  Poisson_solver<FT> m_poisson;
};

/// \ingroup PkgIntrinsicTriangulationsOperators
/// computes the geodesic distance of every vertex to the nearest source (see `Heat_distance`).
/// Complexity: two sparse Cholesky factorizations.
/// \param surface a model of `IntrinsicSurface`
/// \param sources a vertex, an `Edge_point`, a `Face_location`, a `Curve_segment`, a range of one
///        of these, such as a `Surface_curve`, or `Distance_sources`
/// \param np as for `Heat_distance`
/// \throws Numerical_error, Invalid_input as `Heat_distance`
template <typename Surface, typename Sources,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
auto heat_distance(const Surface& surface, const Sources& sources,
                   const NamedParameters& np = CGAL::parameters::default_values())
{
  Distance_sources<Surface> all(surface);
  all.add(sources);
  return Heat_distance<Length_of<Surface>>(surface, np).distances(all);
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_HEAT_DISTANCE_H
