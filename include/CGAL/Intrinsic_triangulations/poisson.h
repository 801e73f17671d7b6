// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_POISSON_H
#define CGAL_INTRINSIC_TRIANGULATIONS_POISSON_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Factorization.h>
#include <CGAL/Intrinsic_triangulations/Mesh_components.h>
#include <CGAL/Intrinsic_triangulations/internal/validity/check_finite.h>
#include <CGAL/Intrinsic_triangulations/operators.h>
#include <CGAL/Intrinsic_triangulations/sparse_assembly.h>
#include <CGAL/Intrinsic_triangulations/tolerances.h>

#include <boost/property_map/property_map.hpp>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {
template <typename FT>
class Heat_method;
} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsOperators
/// solves \f$-\Delta u = f\f$ on a triangulated surface for one right-hand side after the other;
/// the matrix is factorized once.
///
/// Values can be prescribed at vertices (Dirichlet). On the rest of the boundary the normal
/// derivative is zero. On a component without prescribed values, a solution exists only if the
/// integral of \f$f\f$ vanishes, and is unique up to a constant. So \f$f\f$ is replaced by \f$f\f$
/// minus its mean, and the solution has mean zero.
///
/// The object does not refer to the mesh, and is valid as long as connectivity and lengths do not
/// change.
///
/// \tparam FT_ a floating point type
template <typename FT_ = double>
class Poisson_solver
{
public:
  /// the type of values.
  typedef FT_ FT;
  /// the type of functions: a value for each vertex, by its index.
  typedef Eigen::Matrix<FT, Eigen::Dynamic, 1> Vector;
  /// the type of several functions, a column for each.
  typedef Eigen::Matrix<FT, Eigen::Dynamic, Eigen::Dynamic> Columns;

  /// factorizes the matrix of a surface. Complexity: a sparse Cholesky factorization.
  /// \param surface a model of `IntrinsicSurface`, with any number of components; isolated vertices
  ///   are components
  /// \param is_fixed a readable property map from its vertices to `bool`: where values are
  ///   prescribed; by default nowhere
  /// \throws Numerical_error if the area of a face is zero or out of range, or if rounding leaves
  ///         the matrix without a factorization
  template <typename Surface, typename VertexIsFixedMap = boost::static_property_map<bool>>
  explicit Poisson_solver(const Surface& surface,
                          const VertexIsFixedMap& is_fixed = VertexIsFixedMap(false))
    : Poisson_solver(surface, cotan_laplacian(surface), is_fixed)
  {}

  /// factorizes the matrix of the surface of `other`, with values prescribed at other vertices.
  /// Complexity: a sparse Cholesky factorization.
  /// \param other a solver for the surface
  /// \param is_fixed a readable property map from its vertices to `bool`: where values are
  ///   prescribed
  /// \throws Numerical_error if rounding leaves the matrix without a factorization
  template <typename VertexIsFixedMap>
  Poisson_solver(const Poisson_solver& other, const VertexIsFixedMap& is_fixed)
    : Poisson_solver(other.m_components, other.m_laplacian, other.m_area,
                     fixed_vertices(other.m_area.size(), is_fixed), other.m_order)
  {}

  /// solves with prescribed values. Complexity: linear in the size of the factorization.
  /// \param moments the integrals \f$\int f \varphi_i\f$ against the hat functions: the product of
  ///   `mass_matrix()` with the values of \f$f\f$, or the result of `divergence_matrix()`. Their
  ///   values at vertices with prescribed values are ignored
  /// \param values the values; only values at vertices where they are prescribed are read
  /// \throws Invalid_input if a moment or a value that is read is infinite or NaN
  Vector solve(const Vector& moments, const Vector& values) const
  {
    check_moments(moments);
    const Vector prescribed = prescribed_part(values);
    return with_unknowns(prescribed, m_factorization.solve(right_side(moments, prescribed)));
  }

  /// solves with zero at the vertices where values are prescribed.
  /// \throws Invalid_input if a moment is infinite or NaN
  Vector solve(const Vector& moments) const { return solve(moments, Vector::Zero(m_area.size())); }

  /// solves with zero at the vertices where values are prescribed, for all columns at once.
  /// \throws Invalid_input if a moment is infinite or NaN
  Columns solve_columns(const Columns& moments) const
  {
    const Vector prescribed = Vector::Zero(m_area.size());
    Columns unknowns(m_unknowns.cols(), moments.cols()), result(m_area.size(), moments.cols());
    for(Eigen::Index k = 0; k < moments.cols(); ++k)
      check_moments(moments.col(k));
    for(Eigen::Index k = 0; k < moments.cols(); ++k)
      unknowns.col(k) = right_side(moments.col(k), prescribed);
    unknowns = m_factorization.solve_columns(unknowns);
    for(Eigen::Index k = 0; k < moments.cols(); ++k)
      result.col(k) = with_unknowns(prescribed, unknowns.col(k));
    return result;
  }

private:
  friend class internal::Heat_method<FT>;

  typedef Eigen::SparseMatrix<FT> Matrix;

  // Constructs the solver with an elimination order for all vertices.
  template <typename Surface, typename VertexIsFixedMap>
  Poisson_solver(const Surface& surface, const Elimination_order& order,
                 const VertexIsFixedMap& is_fixed)
    : Poisson_solver(surface, cotan_laplacian(surface), order, is_fixed)
  {}

  template <typename Surface, typename VertexIsFixedMap>
  Poisson_solver(const Surface& surface, const Matrix& laplacian, const Elimination_order& order,
                 const VertexIsFixedMap& is_fixed)
    : Poisson_solver(Mesh_components(surface.mesh()), laplacian,
                     lumped_mass_matrix(surface).diagonal(),
                     fixed_vertices(surface.mesh().num_vertices(), is_fixed), order)
  {}

  template <typename Surface, typename VertexIsFixedMap>
  Poisson_solver(const Surface& surface, const Matrix& laplacian, const VertexIsFixedMap& is_fixed)
    : Poisson_solver(surface, laplacian, fill_reducing_order(laplacian), is_fixed)
  {}

  Poisson_solver(const Mesh_components& components, const Matrix& laplacian, const Vector& area,
                 const std::vector<char>& is_fixed, const Elimination_order& order)
    : m_components(components),
      m_laplacian(laplacian),
      m_area(area),
      m_total_area(sums(area)),
      m_is_fixed(is_fixed),
      m_has_fixed(std::find(is_fixed.begin(), is_fixed.end(), char(1)) != is_fixed.end()),
      m_order(order),
      m_is_anchored(anchored_components()),
      m_unknowns(select_unknowns()),
      m_factorization(m_unknowns.transpose() * m_laplacian * m_unknowns, order_of_unknowns(),
                      "cotan Laplacian")
  {}

  static std::size_t index(Eigen::Index v) { return static_cast<std::size_t>(v); }

  template <typename Size, typename VertexIsFixedMap>
  static std::vector<char> fixed_vertices(Size number_of_vertices, const VertexIsFixedMap& is_fixed)
  {
    std::vector<char> result(static_cast<std::size_t>(number_of_vertices), 0);
    for(std::size_t v = 0; v < result.size(); ++v)
      result[v] = get(is_fixed, Vertex_index(static_cast<Vertex_index::size_type>(v))) ? 1 : 0;
    return result;
  }

  std::vector<char> anchored_components() const
  {
    std::vector<char> result(m_components.size(), 0);
    for(std::size_t v = 0; v < m_is_fixed.size(); ++v)
      if(m_is_fixed[v])
        result[m_components[v]] = 1;
    return result;
  }

  // Returns the matrix that maps the unknowns to all vertices. On a component without prescribed
  // values, all vertices but the first are unknown.
  Matrix select_unknowns() const
  {
    std::vector<char> is_anchored(m_is_anchored);
    std::vector<std::size_t> unknowns;
    for(std::size_t v = 0; v < m_is_fixed.size(); ++v) {
      char& anchored = is_anchored[m_components[v]];
      if(anchored && !m_is_fixed[v])
        unknowns.push_back(v);
      anchored = 1;
    }
    return selection_matrix<FT>(m_is_fixed.size(), unknowns);
  }

  Eigen::Index vertex_of_unknown(Eigen::Index i) const { return m_unknowns.innerIndexPtr()[i]; }

  // Restricts the order of all vertices to the unknowns, because a part of a good order is good for
  // this part of the matrix.
  Elimination_order order_of_unknowns() const
  {
    std::vector<int> number(m_is_fixed.size(), -1);
    for(Eigen::Index i = 0; i < m_unknowns.cols(); ++i)
      number[index(vertex_of_unknown(i))] = static_cast<int>(i);
    Elimination_order result(m_unknowns.cols());
    Eigen::Index k = 0;
    for(const int v : m_order)
      if(const int i = number[static_cast<std::size_t>(v)]; i >= 0)
        result[k++] = i;
    return result;
  }

  Eigen::Index component(Eigen::Index v) const
  {
    return static_cast<Eigen::Index>(m_components[index(v)]);
  }

  template <typename Moments>
  void check_moments(const Moments& moments) const
  {
    for(Eigen::Index v = 0; v < moments.size(); ++v)
      if(!m_is_fixed[index(v)])
        internal::check_finite(moments[v], index(v), "the moment");
  }

  // Returns the prescribed values, and zero at other vertices.
  Vector prescribed_part(const Vector& values) const
  {
    Vector result = Vector::Zero(m_area.size());
    for(Eigen::Index v = 0; m_has_fixed && v < result.size(); ++v)
      if(m_is_fixed[index(v)]) {
        internal::check_finite(values[v], index(v), "the value");
        result[v] = values[v];
      }
    return result;
  }

  // Returns the right side of the equations for the unknowns.
  Vector right_side(const Vector& moments, const Vector& prescribed) const
  {
    const Vector density = free_means(moments);
    Vector rest = moments;
    if(m_has_fixed)
      rest -= m_laplacian * prescribed;
    Vector result(m_unknowns.cols());
    for(Eigen::Index i = 0; i < result.size(); ++i) {
      const Eigen::Index v = vertex_of_unknown(i);
      result[i] = rest[v] - m_area[v] * density[component(v)];
    }
    return result;
  }

  // Returns the solution with mean zero on components without prescribed values.
  Vector with_unknowns(Vector prescribed, const Vector& unknowns) const
  {
    Vector& result = prescribed;
    for(Eigen::Index i = 0; i < unknowns.size(); ++i)
      result[vertex_of_unknown(i)] += unknowns[i];
    const Vector mean = free_means(m_area.cwiseProduct(result));
    for(Eigen::Index v = 0; v < result.size(); ++v)
      result[v] -= mean[component(v)];
    return prescribed;
  }

  // Adds up moments on each component.
  template <typename Moments>
  Vector sums(const Moments& moments) const
  {
    if(m_components.size() == 1) // several sums at once
      return Vector::Constant(1, moments.sum());
    Vector result = Vector::Zero(static_cast<Eigen::Index>(m_components.size()));
    for(Eigen::Index v = 0; v < moments.size(); ++v)
      result[component(v)] += moments[v];
    return result;
  }

  // Returns the mean on each component of a density with these moments, zero where values are
  // prescribed.
  template <typename Moments>
  Vector free_means(const Moments& moments) const
  {
    Vector result = sums(moments);
    for(Eigen::Index c = 0; c < result.size(); ++c)
      result[c] = !m_is_anchored[index(c)] && m_total_area[c] > 0
                    ? FT(internal::Digits<FT>::few(result[c] / m_total_area[c]))
                    : FT(0);
    return result;
  }

  Mesh_components m_components;
  Matrix m_laplacian;
  Vector m_area;       // a third of the area around each vertex
  Vector m_total_area; // of each component
  std::vector<char> m_is_fixed;
  bool m_has_fixed;
  Elimination_order m_order;       // of all vertices
  std::vector<char> m_is_anchored; // components where a value is prescribed
  Matrix m_unknowns;
  Factorization<FT> m_factorization;
};

/// \ingroup PkgIntrinsicTriangulationsOperators
/// solves \f$-\Delta u = f\f$ (see `Poisson_solver`).
/// Complexity: a sparse Cholesky factorization.
/// \param surface a model of `IntrinsicSurface`
/// \param density the values of \f$f\f$ at the vertices
/// \param is_fixed a readable property map from the vertices to `bool`: where values are
///   prescribed; by default nowhere
/// \param values the values; only values at vertices where they are prescribed are read
/// \returns the values of \f$u\f$ at the vertices; zero at isolated vertices
/// \throws Invalid_input if a density or a value that is read is infinite or NaN
/// \throws Numerical_error as the constructor of `Poisson_solver`
template <typename Surface, typename FT,
          typename VertexIsFixedMap = boost::static_property_map<bool>>
Eigen::Matrix<FT, Eigen::Dynamic, 1>
solve_poisson(const Surface& surface, const Eigen::Matrix<FT, Eigen::Dynamic, 1>& density,
              const VertexIsFixedMap& is_fixed = VertexIsFixedMap(false),
              const Eigen::Matrix<FT, Eigen::Dynamic, 1>& values = {})
{
  internal::check_all_finite(density, "the density");
  return Poisson_solver<FT>(surface, is_fixed).solve(mass_matrix(surface) * density, values);
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_POISSON_H
