// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_SIGNED_HEAT_DISTANCE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_SIGNED_HEAT_DISTANCE_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Edge_point.h>
#include <CGAL/Intrinsic_triangulations/Mesh_components.h>
#include <CGAL/Intrinsic_triangulations/Surface_curve.h>
#include <CGAL/Intrinsic_triangulations/Surface_view.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/internal/operators/Heat_flow.h>
#include <CGAL/Intrinsic_triangulations/internal/operators/Heat_method.h>
#include <CGAL/Intrinsic_triangulations/internal/operators/Vertex_vector_heat.h>
#include <CGAL/Intrinsic_triangulations/named_parameters.h>
#include <CGAL/Intrinsic_triangulations/operators.h>
#include <CGAL/Intrinsic_triangulations/poisson.h>
#include <CGAL/Intrinsic_triangulations/sparse_assembly.h>
#include <CGAL/Intrinsic_triangulations/tangent_frames.h>
#include <CGAL/Intrinsic_triangulations/tolerances.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <boost/pending/disjoint_sets.hpp>
#include <boost/property_map/property_map.hpp>

#include <Eigen/Dense>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsOperators
/// computes signed distances to curves on a triangulated surface by the signed heat method
/// \cgalCite{FC24}, for one curve after the other; the matrices are factorized once.
///
/// The distance is negative on the left of the curve and positive on its right: negative inside a
/// loop that runs counterclockwise around a region. The normals of the curve flow over the surface
/// like heat. Of the functions with mean zero over each part of the curve, the distance is the one
/// whose gradient comes closest to their directions. Two segments are in one part if their faces
/// have a common vertex. Gaps of a curve are bridged. Beyond the end of a curve, or if a closed
/// curve does not separate the surface, no signed distance exists. Then the result is only smooth.
///
/// Distances are approximate, also on the curve. Heat rounds off the level sets of curves whose
/// curvature varies. This error grows with the square root of the time. So normals flow for a time
/// and for four times that, and their directions are combined to cancel it. With a short time, the
/// result depends slightly on the directions of edges, however short they are. Errors are smaller
/// on Delaunay triangulations.
///
/// The object refers to the surface, which must not change as long as it is used.
///
/// \tparam Surface a model of `IntrinsicSurface` with floating point lengths
template <typename Surface>
class Signed_heat_distance
{
public:
  /// the type of distances.
  typedef Length_of<Surface> FT;
  static_assert(std::is_constructible<Tangent_frames<FT>, const Surface&>::value,
                "vertices of a soup have no tangent spaces; vertices of its tufted cover have");
  /// the type of functions: a value for each vertex, by its index.
  typedef Eigen::Matrix<FT, Eigen::Dynamic, 1> Vector;

  /// prepares for distances on a surface. Complexity: three sparse Cholesky factorizations, two of
  /// complex matrices.
  ///
  /// \param surface any number of components, with or without boundary
  /// \param np
  /// \cgalNamedParamsBegin
  ///   \cgalParamNBegin{time_step_factor}
  ///     \cgalParamDescription{the shorter time for which heat flows, in squared mean edge lengths}
  ///     \cgalParamType{a number}
  ///     \cgalParamDefault{1}
  ///   \cgalParamNEnd
  /// \cgalNamedParamsEnd
  /// \throws Numerical_error if the area of a face is zero or out of range, or if rounding leaves a
  ///         matrix without a factorization
  /// \throws Invalid_input if the factor is not positive and finite
  template <typename NamedParameters = CGAL::parameters::Default_named_parameters>
  explicit Signed_heat_distance(const Surface& surface,
                                const NamedParameters& np = CGAL::parameters::default_values())
    : m_surface(internal::view_of(surface)),
      m_components(surface.mesh()),
      m_flow(m_surface, m_components, internal::checked_time_step_factor<FT>(np)),
      m_divergence(divergence_matrix(surface)),
      m_poisson(internal::Heat_method<FT>::poisson_solver(surface, m_flow.order(),
                                                          boost::static_property_map<bool>(false)))
  {}

  /// computes the signed distance of every vertex to a curve; infinite on a component without a
  /// segment of positive length. Complexity: for each part of the curve, linear in the size of the
  /// factorizations.
  /// \param curve segments, with the negative side on their left
  /// \throws Underflow_error if normals underflow somewhere, at distances as in `Heat_distance`
  /// \throws Numerical_error if normals cancel on a whole component
  Vector distances(const Surface_curve<FT>& curve) const
  {
    const std::vector<FT> length = length_on_components(curve);
    auto [normals, rounded] = m_flow.spread(curve);
    normalize(normals, length);
    normalize(rounded, length);
    Vector result = m_poisson.solve(m_divergence * (rounded - FT(2) * normals));
    equalize_means(result, curve);
    subtract_mean(result, curve, length);
    return result;
  }

private:
  typedef Eigen::SparseMatrix<FT> Matrix;
  typedef Eigen::Matrix<FT, Eigen::Dynamic, Eigen::Dynamic> Small_matrix;

  std::size_t component(Face_index f) const
  {
    return m_components[m_surface.mesh().source(m_surface.mesh().halfedge(f)).idx()];
  }

  std::vector<FT> length_on_components(const Surface_curve<FT>& curve) const
  {
    std::vector<FT> result(m_components.size(), FT(0));
    for(const Curve_segment<FT>& segment : curve)
      result[component(segment.face)] += internal::segment_length(m_surface, segment);
    return result;
  }

  // Scales normals on faces to unit length. Normals that cancel exactly are zero.
  void normalize(Vector& field, const std::vector<FT>& length) const
  {
    using std::hypot;
    std::vector<char> is_zero(m_components.size(), 1);
    for(Face_index f : m_surface.mesh().faces()) {
      auto vector = field.template segment<2>(2 * Eigen::Index(f.idx()));
      const FT norm = hypot(vector[0], vector[1]);
      if(!(norm > 0))
        continue;
      if(norm < least_norm())
        throw Underflow_error("the normals of the curve do not reach face " +
                              std::to_string(f.idx()) + "; a greater time step factor is needed");
      vector /= norm;
      is_zero[component(f)] = 0;
    }
    for(std::size_t c = 0; c < length.size(); ++c)
      if(is_zero[c] && length[c] > 0)
        throw Numerical_error("the normals of the curve cancel everywhere");
  }

  // Returns the least norm that has lost no digits.
  static FT least_norm()
  {
    return (std::numeric_limits<FT>::min)() / std::numeric_limits<FT>::epsilon();
  }

  // Calls `visit(v, weight)` for the vertices whose values determine the integral over a segment.
  template <typename Visit>
  void for_each_weight(const Curve_segment<FT>& segment, const Visit& visit) const
  {
    const auto h = sides(segment.face, m_surface.mesh());
    const FT half = internal::segment_length(m_surface, segment) / 2;
    for(std::size_t k = 0; k < 3; ++k)
      visit(m_surface.mesh().source(h[k]).idx(), half * (segment.source[k] + segment.target[k]));
  }

  // Returns a number of the part of each segment.
  std::vector<std::size_t> parts(const Surface_curve<FT>& curve) const
  {
    const Delta_complex& mesh = m_surface.mesh();
    boost::disjoint_sets_with_storage<> sets(mesh.num_vertices());
    for(const Curve_segment<FT>& segment : curve)
      for(Halfedge_index h : sides(segment.face, mesh))
        sets.union_set(mesh.source(h).idx(), mesh.target(h).idx());
    std::map<std::size_t, std::size_t> number; // of each representative
    std::vector<std::size_t> result;
    for(const Curve_segment<FT>& segment : curve) {
      const std::size_t v = sets.find_set(mesh.source(mesh.halfedge(segment.face)).idx());
      result.push_back(number.try_emplace(v, number.size()).first->second);
    }
    return result;
  }

  // Returns a column for each part of the curve after the first part on its component. Its product
  // with a function is the difference of the means over both parts.
  Matrix differences_of_means(const Surface_curve<FT>& curve) const
  {
    const std::vector<std::size_t> part = parts(curve);
    std::vector<Eigen::Triplet<FT>> weights, differences;
    for(std::size_t i = 0; i < curve.size(); ++i)
      for_each_weight(curve[i], [&](std::size_t v, const FT& weight) {
        weights.emplace_back(static_cast<int>(v), static_cast<int>(part[i]), weight);
      });
    const std::size_t size = curve.empty() ? 0 : *std::max_element(part.begin(), part.end()) + 1;
    const Matrix integrals = matrix_of(weights, m_surface.mesh().num_vertices(), size);
    std::vector<int> first(m_components.size(), -1); // part
    int columns = 0;
    for(int p = 0; p < integrals.cols(); ++p) {
      const FT length = integrals.col(p).sum();
      if(!(length > 0))
        continue;
      int& f = first[m_components[static_cast<std::size_t>(
        typename Matrix::InnerIterator(integrals, p).row())]];
      if(f == -1)
        f = p;
      else {
        differences.emplace_back(p, columns, 1 / length);
        differences.emplace_back(f, columns++, -1 / FT(integrals.col(f).sum()));
      }
    }
    return integrals * matrix_of(differences, size, static_cast<std::size_t>(columns));
  }

  // Makes the means over all parts of the curve on a component equal. The gradient remains as close
  // to the normals as this permits.
  void equalize_means(Vector& distance, const Surface_curve<FT>& curve) const
  {
    const Matrix differences = differences_of_means(curve);
    if(differences.cols() == 0)
      return;
    Small_matrix responses(differences.cols(), differences.cols());
    for(Eigen::Index i = 0; i < differences.cols(); ++i)
      responses.col(i) = differences.transpose() * m_poisson.solve(Vector(differences.col(i)));
    const Vector forces = responses.ldlt().solve(Vector(differences.transpose() * distance));
    distance -= m_poisson.solve(Vector(differences * forces));
  }

  void subtract_mean(Vector& distance, const Surface_curve<FT>& curve,
                     const std::vector<FT>& length) const
  {
    std::vector<FT> integral(m_components.size(), FT(0));
    for(const Curve_segment<FT>& segment : curve)
      for_each_weight(segment, [&](std::size_t v, const FT& weight) {
        integral[m_components[v]] += weight * distance[static_cast<Eigen::Index>(v)];
      });
    for(Eigen::Index v = 0; v < distance.size(); ++v) {
      const std::size_t c = m_components[static_cast<std::size_t>(v)];
      distance[v] = length[c] > 0
                      ? FT(distance[v] - internal::Digits<FT>::few(integral[c] / length[c]))
                      : std::numeric_limits<FT>::infinity();
    }
  }

  Surface_view<Length_map_of<Surface>> m_surface;
  Mesh_components m_components;
  internal::Vertex_vector_heat<Surface_view<Length_map_of<Surface>>> m_flow;
  Eigen::SparseMatrix<FT> m_divergence;
  Poisson_solver<FT> m_poisson;
};

/// \ingroup PkgIntrinsicTriangulationsOperators
/// computes the signed distance of every vertex to a curve (see `Signed_heat_distance`).
/// Complexity: three sparse Cholesky factorizations.
/// \param surface a model of `IntrinsicSurface` with floating point lengths
/// \param curve segments, with the negative side on their left
/// \param np as for `Signed_heat_distance`
/// \throws Numerical_error, Invalid_input as `Signed_heat_distance`
template <typename Surface, typename NamedParameters = CGAL::parameters::Default_named_parameters>
auto signed_heat_distance(const Surface& surface, const Surface_curve<Length_of<Surface>>& curve,
                          const NamedParameters& np = CGAL::parameters::default_values())
{
  return Signed_heat_distance<Surface>(surface, np).distances(curve);
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_SIGNED_HEAT_DISTANCE_H
