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

#include <boost/property_map/property_map.hpp>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <cmath>
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
/// the surface of \f$T_2\f$ with 2560 binary digits for lengths on faces whose stored lengths do
/// not determine the area (see `has_unresolved_areas()`). These lengths come from the exact metric
/// of \f$T_1\f$. Other edges have their stored lengths. So cotangents, areas and angles of the
/// thinnest faces are exact up to these digits. Faces of no area are recognized, and operators
/// leave them out, as no integral depends on them.
///
/// Operators of this surface are matrices of `Multiprecision_float`. Their Cholesky factorization
/// (`Factorization`) eliminates the rows of the thinnest faces with all digits, and the others in
/// `double`.
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
  /// \throws Overflow_error if there are more crossings than a `Surface_mesh` can number
  explicit Precise_surface(const Pair& pair)
    : m_mesh(&pair.mesh()), m_length(pair.mesh().num_edges())
  {
    const auto surface = pair.intrinsic();
    for(const Edge_index e : m_mesh->edges())
      m_length[e.idx()] = surface.length_map()[e];
    const internal::Edge_courses<Traits> courses(pair, Concurrency());
    Long_lengths lengths(pair, courses);
    for(const Face_index f : m_mesh->faces())
      if(!internal::has_resolved_area(f, surface))
        for(const Halfedge_index h : sides(f, *m_mesh))
          if(FT& length = m_length[m_mesh->edge(h).idx()]; !length.is_long())
            length = FT(lengths(h));
  }

  /// returns the connectivity of \f$T_2\f$.
  const Delta_complex& mesh() const { return *m_mesh; }
  /// returns the lengths.
  Length_map length_map() const { return Length_map(m_length.data()); }

private:
  // Stores the lengths of edges with all digits.
  class Long_lengths
  {
    typedef typename FT::Long Number;
    typedef internal::Rounded_corners<Number, typename Pair::Metric::Number> Corners;

  public:
    Long_lengths(const Pair& pair, const internal::Edge_courses<Traits>& courses)
      : m_pair(pair),
        m_decisions(pair, courses),
        m_corners(internal::exact_input(pair)),
        m_development(pair, courses, m_corners)
    {}

    Number operator()(Halfedge_index h)
    {
      const Number result = m_decisions.is_straight_in_space(h) ? distance(h) : length(h);
      if(!(result > 0) || !std::isfinite(static_cast<double>(result)))
        throw Numerical_error("edge " + std::to_string(m_pair.mesh().edge(h).idx()) +
                              " has no positive finite length");
      return result;
    }

  private:
    // Differences of coordinates are exact.
    Number distance(Halfedge_index h) const
    {
      const auto& points = m_pair.input_metric().points;
      const auto u = internal::vector_between<Number>(points[m_pair.mesh().source(h)],
                                                      points[m_pair.mesh().target(h)]);
      return sqrt(internal::dot(u, u));
    }

    Number length(Halfedge_index h) const
    {
      const auto strip = m_development.uncrossed_strip(h);
      return sqrt(Number(strip.end.x * strip.end.x + strip.end.y * strip.end.y)) *
             m_corners.length(strip.first.halfedge).x;
    }

    const Pair& m_pair;
    internal::Exact_decisions<Traits> m_decisions;
    Corners m_corners;
    internal::Development<Traits, Corners> m_development;
  };

  const Delta_complex* m_mesh;
  std::vector<FT> m_length;
};

/// \ingroup PkgIntrinsicTriangulationsOperators
/// calls `f(surface)` with the surface itself. Complexity: the complexity of `f`.
template <typename Surface, typename Function>
auto with_resolved_areas(const Surface& surface, const Function& f)
{
  return f(surface);
}

/// \ingroup PkgIntrinsicTriangulationsOperators
/// calls `f(surface)` with the surface of \f$T_2\f$ of `tri`. It is a `Precise_surface` if its
/// lengths do not determine the areas of faces (`has_unresolved_areas()`). Otherwise it has the
/// stored lengths. Complexity: linear, plus the complexity of `f` and of `Precise_surface`.
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
/// returns the values of a function, or the entries of a matrix, rounded to `double`. Complexity:
/// linear.
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
