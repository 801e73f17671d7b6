// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_VECTOR_HEAT_H
#define CGAL_INTRINSIC_TRIANGULATIONS_VECTOR_HEAT_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Factorization.h>
#include <CGAL/Intrinsic_triangulations/connection_laplacian.h>
#include <CGAL/Intrinsic_triangulations/internal/operators/Heat_method.h>
#include <CGAL/Intrinsic_triangulations/internal/validity/check_finite.h>
#include <CGAL/Intrinsic_triangulations/named_parameters.h>
#include <CGAL/Intrinsic_triangulations/tangent_frames.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <Eigen/Core>

#include <array>
#include <cmath>
#include <complex>
#include <utility>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsOperators
/// transports tangent vectors from some vertices to all others by the vector heat method
/// \cgalCite{SSC19b}: approximately along shortest geodesics from the nearest source. The two
/// matrices are factorized once.
///
/// Tangent vectors are complex numbers in the frames of `Tangent_frames`, with normalized angles
/// also at corners of the boundary. A Delaunay triangulation should be used: edges of negative
/// weight (see `cotan_laplacian()`) do not carry vectors.
///
/// The object does not refer to the mesh, and is valid as long as connectivity and lengths do not
/// change.
///
/// \tparam FT_ a floating point type
template <typename FT_ = double>
class Vector_heat
{
public:
  /// the type of numbers.
  typedef FT_ FT;
  /// the type of vector fields: a tangent vector for each vertex, by its index.
  typedef Eigen::Matrix<std::complex<FT>, Eigen::Dynamic, 1> Vector_field;
  /// a vertex and a tangent vector at it.
  typedef std::pair<Vertex_index, std::complex<FT>> Source;

  /// prepares for transport on a surface. Complexity: two sparse Cholesky factorizations.
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
  explicit Vector_heat(const Surface& surface,
                       const NamedParameters& np = CGAL::parameters::default_values())
    : m_frames(surface),
      m_flow(surface, np),
      m_vector_flow(
        internal::plus_diagonal(internal::connection_laplacian(
                                  surface.mesh(), internal::nonnegative_weights(surface), m_frames),
                                m_flow.rates()),
        m_flow.order(), "heat flow of vectors")
  {}

  /// returns the frames of the tangent spaces.
  const Tangent_frames<FT>& frames() const { return m_frames; }

  /// transports vectors to all vertices. At a vertex, the direction agrees with the directions of
  /// nearby sources. Its length is an average of their lengths; with one source, the length of its
  /// vector. A vector is zero on a component without a source, and if vectors from several sides
  /// cancel exactly. Complexity: linear in the size of the factorizations.
  /// \param sources a range of `Source`, not two at one vertex
  /// \throws Invalid_input if a vector is infinite or NaN
  /// \throws Underflow_error if the heat is below the range of `FT` somewhere (see `Heat_distance`)
  template <typename SourceRange>
  Vector_field transport(const SourceRange& sources) const
  {
    Vector_field vectors = Vector_field::Zero(m_flow.rates().size());
    Vector is_source = Vector::Zero(vectors.size());
    for(const Source& source : sources) {
      internal::check_finite(source.second, source.first.idx(), "the vector");
      vectors[source.first.idx()] = source.second;
      is_source[source.first.idx()] = FT(1);
    }
    const FT longest = vectors.size() == 0 ? FT(0) : vectors.cwiseAbs().maxCoeff();
    if(longest > 0) // by parts, since a division by a complex number squares it
      vectors = vectors.unaryExpr([&](const std::complex<FT>& z) { return z / longest; });
    return longest * spread(vectors, is_source);
  }

  /// transports the vector `vector` at `source` to all vertices, as the function for ranges does.
  Vector_field transport(Vertex_index source, const std::complex<FT>& vector) const
  {
    return transport(std::array{Source(source, vector)});
  }

private:
  typedef Eigen::Matrix<FT, Eigen::Dynamic, 1> Vector;

  // Computes directions from the heat of the vectors, and lengths from the heat of their lengths
  // divided by the heat of the sources.
  Vector_field spread(const Vector_field& vectors, const Vector& is_source) const
  {
    const Vector heat = m_flow.spread_everywhere(is_source);
    const Vector length = m_flow.spread(vectors.cwiseAbs());
    Vector_field result = m_vector_flow.solve(m_flow.unit() * vectors);
    for(Eigen::Index v = 0; v < result.size(); ++v)
      if(const FT norm = std::abs(result[v]); norm > 0)
        result[v] = result[v] / norm * (length[v] / heat[v]);
    return result;
  }

  Tangent_frames<FT> m_frames;
  internal::Heat_flow<FT> m_flow;
  Factorization<std::complex<FT>> m_vector_flow;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_VECTOR_HEAT_H
