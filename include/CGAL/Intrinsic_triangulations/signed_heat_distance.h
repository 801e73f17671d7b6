// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_SIGNED_HEAT_DISTANCE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_SIGNED_HEAT_DISTANCE_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Edge_point.h>
#include <CGAL/Intrinsic_triangulations/Factorization.h>
#include <CGAL/Intrinsic_triangulations/Flat_face.h>
#include <CGAL/Intrinsic_triangulations/Mesh_components.h>
#include <CGAL/Intrinsic_triangulations/Surface_curve.h>
#include <CGAL/Intrinsic_triangulations/Surface_view.h>
#include <CGAL/Intrinsic_triangulations/connection_laplacian.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/internal/operators/Heat_method.h>
#include <CGAL/Intrinsic_triangulations/internal/operators/Part_means.h>
#include <CGAL/Intrinsic_triangulations/named_parameters.h>
#include <CGAL/Intrinsic_triangulations/operators.h>
#include <CGAL/Intrinsic_triangulations/poisson.h>
#include <CGAL/Intrinsic_triangulations/tangent_frames.h>
#include <CGAL/Intrinsic_triangulations/tolerances.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// Computes frames at the vertices like `Tangent_frames`, but angles on the boundary are angles of
// the surface. So no curvature is spread around a boundary vertex. A field that is parallel inside
// is parallel along the boundary.
template <typename Surface>
class Vertex_frames
{
public:
  typedef Length_of<Surface> FT;
  typedef std::complex<FT> Complex;

  explicit Vertex_frames(const Surface& surface)
    : m_surface(surface), m_angle(surface.mesh().num_halfedges()), m_scale(m_angle.size())
  {
    const Tangent_frames<FT> frames(surface);
    const Delta_complex& mesh = surface.mesh();
    for(Halfedge_index h : mesh.halfedges()) {
      const Vertex_index v = mesh.source(h);
      const bool is_boundary = mesh.is_border(mesh.halfedge(v));
      m_scale[h.idx()] = is_boundary ? FT(1) : frames.scale(v);
      m_angle[h.idx()] = is_boundary ? FT(frames.angle(h) / frames.scale(v)) : frames.angle(h);
    }
  }

  // Returns the parallel transport from the source of `h` to its target.
  Complex transport(Halfedge_index h) const
  {
    return -std::polar(FT(1), m_angle[opposite(h).idx()] - m_angle[h.idx()]);
  }

  // Returns the rotations that map vectors from the corners of a face to its frame, and keep the
  // directions of bisectors.
  std::array<Complex, 3> to_face(Face_index f) const
  {
    const auto h = sides(f, m_surface.mesh());
    const Flat_face<FT> face(h[0], m_surface);
    std::array<Complex, 3> result;
    for(std::size_t k = 0; k < 3; ++k) {
      const FT half = angle_at_source(h[k], m_surface) / 2;
      const FT bisector = m_angle[h[k].idx()] + m_scale[h[k].idx()] * half;
      result[k] = face.direction(k) * std::polar(FT(1), half - bisector);
    }
    return result;
  }

private:
  Surface m_surface;                // a view
  std::vector<FT> m_angle, m_scale; // of each halfedge, at its source
};

// Computes the heat flow of tangent vectors at vertices, from and to faces, for a time and for four
// times this time.
template <typename Surface>
class Vertex_vector_heat
{
public:
  typedef Length_of<Surface> FT;
  typedef std::complex<FT> Complex;
  typedef Eigen::Matrix<FT, Eigen::Dynamic, 1> Vector;
  typedef Eigen::Matrix<Complex, Eigen::Dynamic, 1> Field;

  // `factor` is the shorter time in squared mean edge lengths.
  Vertex_vector_heat(const Surface& surface, const Mesh_components& components, const FT& factor)
    : m_surface(surface),
      m_frames(surface),
      m_short(matrix(components, factor), "heat flow of vectors"),
      m_long(matrix(components, FT(4) * factor), m_short.order(), "heat flow of vectors")
  {}

  // Returns the elimination order of the vertices, which other matrices of the surface can use,
  // too.
  const Elimination_order& order() const { return m_short.order(); }

  // Returns the heat from the unit normals on the right of the segments of a curve, times a common
  // factor. The first field is after the shorter time, the second one after the longer time.
  std::array<Field, 2> spread(const Surface_curve<FT>& curve) const
  {
    const Field sources = normalized(moments(curve));
    return {m_short.solve(sources), m_long.solve(sources)};
  }

  // Returns the mean on each face, with components as in gradient_matrix().
  Vector means_on_faces(const Field& heat) const
  {
    Vector result = Vector::Zero(2 * Eigen::Index(mesh().num_faces()));
    for(Face_index f : mesh().faces()) {
      const auto h = sides(f, mesh());
      const auto to_face = m_frames.to_face(f);
      Complex mean(0);
      for(std::size_t k = 0; k < 3; ++k)
        mean += heat[mesh().source(h[k]).idx()] / FT(3) * to_face[k];
      result[2 * Eigen::Index(f.idx())] = mean.real();
      result[2 * Eigen::Index(f.idx()) + 1] = mean.imag();
    }
    return result;
  }

private:
  const Delta_complex& mesh() const { return m_surface.mesh(); }

  Eigen::SparseMatrix<Complex> matrix(const Mesh_components& components, const FT& factor) const
  {
    return plus_diagonal(connection_laplacian(mesh(), weights(components, factor), m_frames),
                         decay_rates(m_surface, factor, components));
  }

  // Returns cotan weights minus the entries of the mass matrix divided by the time. The mass matrix
  // lies between the lumped and the consistent one: a face of area A adds A / 48 to off-diagonal
  // entries. So the flow depends less on the directions and sizes of edges. On uniform meshes,
  // A / 24 would leave errors of fourth order. On other meshes, A / 48 leaves smaller errors.
  // A tenth of each weight remains, so that heat reaches all faces.
  std::vector<FT> weights(const Mesh_components& components, const FT& factor) const
  {
    const std::vector<FT> time = time_steps(m_surface, factor, components);
    const std::vector<FT> cotan = cotan_weights(m_surface);
    std::vector<FT> result = cotan;
    for(Face_index f : mesh().faces()) {
      const std::size_t component = components[mesh().source(mesh().halfedge(f)).idx()];
      const FT entry = Face_metric<FT>(f, m_surface).area() / (FT(48) * time[component]);
      for(Halfedge_index h : sides(f, mesh()))
        result[mesh().edge(h).idx()] -= entry;
    }
    for(std::size_t e = 0; e < result.size(); ++e)
      result[e] = (std::max)({result[e], cotan[e] / FT(10), FT(0)});
    return result;
  }

  // Returns the integrals of the normals of a curve against hat functions. They are zero if they
  // cancel up to rounding.
  Field moments(const Surface_curve<FT>& curve) const
  {
    Field result = Field::Zero(Eigen::Index(mesh().num_vertices()));
    Vector total = Vector::Zero(result.size());
    for(const Curve_segment<FT>& segment : curve) {
      const auto h = sides(segment.face, mesh());
      const auto to_face = m_frames.to_face(segment.face);
      const Complex along = Flat_face<FT>(h[0], m_surface).between(segment.source, segment.target);
      for(std::size_t k = 0; k < 3; ++k) {
        const FT weight = (segment.source[k] + segment.target[k]) / 2;
        result[mesh().source(h[k]).idx()] +=
          weight * along * Complex(0, -1) * std::conj(to_face[k]);
        total[mesh().source(h[k]).idx()] += weight * norm_of(along);
      }
    }
    for(Eigen::Index v = 0; v < result.size(); ++v)
      if(std::abs(result[v]) <= rounding_unit<FT>() * total[v])
        result[v] = FT(0);
    return result;
  }

  static Field normalized(const Field& moments)
  {
    const FT greatest =
      moments.size() == 0 ? FT(0) : Digits<FT>::few(moments.cwiseAbs().maxCoeff());
    return greatest > 0 ? Field(moments / greatest * Heat_flow<FT>::unit()) : moments;
  }

  Surface m_surface; // a view
  Vertex_frames<Surface> m_frames;
  Factorization<Complex> m_short, m_long;
};

} // namespace internal

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
  ///     \cgalParamDefault{0.7}
  ///   \cgalParamNEnd
  /// \cgalNamedParamsEnd
  /// \throws Numerical_error if the area of a face is zero or out of range, or if rounding leaves a
  ///         matrix without a factorization
  /// \throws Invalid_input if the factor is not positive, or is above \f$1.6 \cdot 10^{13}\f$
  template <typename NamedParameters = CGAL::parameters::Default_named_parameters>
  explicit Signed_heat_distance(const Surface& surface,
                                const NamedParameters& np = CGAL::parameters::default_values())
    : m_surface(internal::view_of(surface)),
      m_components(surface.mesh()),
      m_flow(m_surface, m_components,
             internal::checked_time_step_factor<FT>(np, internal::time_step_factor_of_normals())),
      m_divergence(divergence_matrix(surface)),
      m_poisson(internal::Heat_method<FT>::poisson_solver(surface, m_flow.order(),
                                                          boost::static_property_map<bool>(false)))
  {}

  /// computes the signed distance of every vertex to a curve; infinite on a component without a
  /// segment of positive length. Complexity: linear in the size of the factorizations, for each
  /// iteration that makes the means over several parts equal. The number of iterations grows like
  /// the square root of the number of parts.
  /// \param curve segments, with the negative side on their left
  /// \throws Underflow_error if normals do not reach a face, or underflow, since the time is short
  /// \throws Numerical_error if normals cancel on a whole component, or means over parts of the
  ///         curve differ by more than 2^-20 of the greatest distance
  Vector distances(const Surface_curve<FT>& curve) const
  {
    const std::vector<FT> length = length_on_components(curve);
    const auto [heat, later_heat] = m_flow.spread(curve);
    const Vector normals = directions(heat, length), rounded = directions(later_heat, length);
    Vector result = m_poisson.solve(m_divergence * (rounded - FT(2) * normals));
    internal::Part_means(m_surface, m_components, m_poisson, curve).equalize(result);
    subtract_mean(result, curve, length);
    return result;
  }

private:
  typedef internal::Vertex_vector_heat<Surface_view<Length_map_of<Surface>>> Flow;
  typedef typename Flow::Field Field;

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

  // Returns the unit normals on faces. Normals that cancel exactly are zero.
  Vector directions(const Field& heat, const std::vector<FT>& length) const
  {
    using std::hypot;
    Vector field = m_flow.means_on_faces(heat);
    std::vector<char> is_zero(m_components.size(), 1);
    for(Face_index f : m_surface.mesh().faces()) {
      auto vector = field.template segment<2>(2 * Eigen::Index(f.idx()));
      const FT norm = hypot(vector[0], vector[1]);
      if(!(norm > 0))
        continue;
      if(norm < least_norm())
        throw no_reach(f);
      vector /= norm;
      is_zero[component(f)] = 0;
    }
    for(std::size_t c = 0; c < length.size(); ++c)
      if(is_zero[c] && length[c] > 0)
        throw Numerical_error("the normals of the curve cancel everywhere");
    check_reach(heat, length);
    return field;
  }

  // Checks that heat reaches a corner of each face. No heat flows along edges whose weights have
  // been dropped, as all edges if the time is too short for the mass matrix.
  void check_reach(const Field& heat, const std::vector<FT>& length) const
  {
    const Delta_complex& mesh = m_surface.mesh();
    for(Face_index f : mesh.faces()) {
      const auto h = sides(f, mesh);
      if(length[component(f)] > 0 && std::all_of(h.begin(), h.end(), [&](Halfedge_index side) {
           return heat[mesh.source(side).idx()] == FT(0);
         }))
        throw no_reach(f);
    }
  }

  static Underflow_error no_reach(Face_index f)
  {
    return Underflow_error("the normals of the curve do not reach face " + std::to_string(f.idx()) +
                           "; a greater time step factor is needed");
  }

  // Returns the least norm that has lost no digits.
  static FT least_norm()
  {
    return (std::numeric_limits<FT>::min)() / std::numeric_limits<FT>::epsilon();
  }

  void subtract_mean(Vector& distance, const Surface_curve<FT>& curve,
                     const std::vector<FT>& length) const
  {
    std::vector<FT> integral(m_components.size(), FT(0));
    for(const Curve_segment<FT>& segment : curve)
      internal::for_each_weight(m_surface, segment, [&](std::size_t v, const FT& weight) {
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
  Flow m_flow;
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
