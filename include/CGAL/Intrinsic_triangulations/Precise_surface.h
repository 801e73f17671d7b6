// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_PRECISE_SURFACE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_PRECISE_SURFACE_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/Multiprecision_float.h>
#include <CGAL/Intrinsic_triangulations/Triangulation_pair.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/Development.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/Exact_decisions.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/Input_corners.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/Input_metric.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Edge_courses.h>
#include <CGAL/Intrinsic_triangulations/thin_faces.h>

#include <CGAL/number_utils.h>

#include <boost/property_map/property_map.hpp>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <complex>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

template <typename Rounded, typename Scalar>
Eigen::SparseMatrix<Rounded> with_scalar(const Eigen::SparseMatrix<Scalar>& matrix)
{
  return matrix.unaryExpr([](const Scalar& x) { return rounded(x); });
}

template <typename Rounded, typename Scalar>
Eigen::Matrix<Rounded, Eigen::Dynamic, 1>
with_scalar(const Eigen::Matrix<Scalar, Eigen::Dynamic, 1>& values)
{
  return values.unaryExpr([](const Scalar& x) { return rounded(x); });
}

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsOperators
/// the surface of \f$T_2\f$ with lengths from the exact metric of \f$T_1\f$, in 2560 binary digits.
/// With them cotangents, areas and angles of the thinnest faces are those of the exact metric, and
/// faces of no area are recognized: operators leave them out, as no integral depends on them.
///
/// Operators of this surface are matrices of `Multiprecision_float`. Their Cholesky factorization
/// (`Factorization`) eliminates the rows of the thinnest faces with all digits, and the others in
/// `double`. All other operations take about 0.1 ms for each face.
///
/// The object refers to the connectivity of \f$T_2\f$, which must not change as long as it is used.
///
/// \tparam Traits_ geometry traits for which certificates are possible, see `certify_Delaunay()`
/// \cgalModels `IntrinsicSurface`
template <typename Traits_ = Euclidean_geometry_traits<double>>
class Precise_surface
{
  typedef Triangulation_pair<Traits_> Pair;

public:
  /// the geometry.
  typedef Traits_ Traits;
  /// the type of lengths.
  typedef Multiprecision_float FT;
  /// a readable property map from edges to their lengths.
  typedef boost::iterator_property_map<const FT*, boost::typed_identity_property_map<Edge_index>,
                                       FT, const FT&>
    Length_map;

  /// computes the lengths of the edges of \f$T_2\f$, which are straight.
  /// Complexity: linear in the edges and crossings.
  /// \throws Numerical_error if a length is not positive and finite
  explicit Precise_surface(const Pair& pair)
    : m_mesh(&pair.mesh()), m_length(pair.mesh().num_edges())
  {
    const internal::Edge_courses<Traits> courses(pair, Concurrency());
    internal::Exact_decisions<Traits> decisions(pair, courses);
    Corners corners(internal::exact_input(pair));
    const internal::Development<Traits, Corners> development(pair, courses, corners);
    for(const Edge_index e : m_mesh->edges()) {
      const Halfedge_index h = m_mesh->halfedge(e);
      m_length[e.idx()] = decisions.is_straight_in_space(h) ? distance_in_space(h, pair)
                                                            : length(h, development, corners);
      if(!(m_length[e.idx()] > 0) || !CGAL::is_finite(CGAL::to_double(m_length[e.idx()])))
        throw Numerical_error("edge " + std::to_string(e.idx()) + " has no positive finite length");
    }
  }

  /// returns the connectivity of \f$T_2\f$.
  const Delta_complex& mesh() const { return *m_mesh; }
  /// returns the lengths.
  Length_map length_map() const { return Length_map(m_length.data()); }

private:
  typedef internal::Rounded_corners<FT, typename Pair::Metric::Number> Corners;

  // Differences of coordinates are exact.
  static FT distance_in_space(Halfedge_index h, const Pair& pair)
  {
    const auto& points = pair.input_metric().points;
    const auto u =
      internal::vector_between<FT>(points[pair.mesh().source(h)], points[pair.mesh().target(h)]);
    return sqrt(internal::dot(u, u));
  }

  template <typename Development>
  static FT length(Halfedge_index h, const Development& development, const Corners& corners)
  {
    const auto strip = development.uncrossed_strip(h);
    return sqrt(FT(strip.end.x * strip.end.x + strip.end.y * strip.end.y)) *
           corners.length(strip.first.halfedge).x;
  }

  const Delta_complex* m_mesh;
  std::vector<FT> m_length;
};

/// \ingroup PkgIntrinsicTriangulationsOperators
/// calls `f(surface)` with the surface itself.
template <typename Surface, typename Function>
auto with_resolved_areas(const Surface& surface, const Function& f)
{
  return f(surface);
}

/// \ingroup PkgIntrinsicTriangulationsOperators
/// calls `f(surface)` with the surface of \f$T_2\f$: as a `Precise_surface` if its lengths do not
/// determine the areas of faces (`has_unresolved_areas()`), and with the stored lengths otherwise.
/// \returns what `f` returns, of one type for both
template <typename Traits, typename Function>
auto with_resolved_areas(const Intrinsic_triangulation<Traits>& tri, const Function& f)
{
  const auto surface = tri.intrinsic();
  if constexpr(internal::has_metric<Traits>())
    if(has_unresolved_areas(surface))
      return f(Precise_surface<Traits>(tri));
  return f(surface);
}

/// \ingroup PkgIntrinsicTriangulationsOperators
/// returns the values of a function, or the entries of a matrix, rounded to `double`.
template <typename Matrix>
auto rounded_values(const Matrix& values)
{
  typedef typename Matrix::Scalar Scalar;
  if constexpr(std::is_same_v<Scalar, double> || std::is_same_v<Scalar, std::complex<double>>)
    return values;
  else {
    typedef decltype(internal::rounded(Scalar())) Rounded;
    return internal::with_scalar<Rounded>(values);
  }
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_PRECISE_SURFACE_H
