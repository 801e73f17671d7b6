// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_POISSON_H
#define CGAL_INTRINSIC_TRIANGULATIONS_POISSON_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Edge_point.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/internal/operators/Factorization.h>
#include <CGAL/Intrinsic_triangulations/internal/operators/Mesh_components.h>
#include <CGAL/Intrinsic_triangulations/internal/operators/Sparse_assembly.h>
#include <CGAL/Intrinsic_triangulations/internal/side_access.h>
#include <CGAL/Intrinsic_triangulations/operators.h>

#include <boost/property_map/property_map.hpp>

#include <Eigen/Dense>
#include <Eigen/SparseCore>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsOperators
/// solves \f$-\Delta u = f\f$ on a triangulated surface for one right-hand side after the other;
/// the matrix is factorized once.
///
/// Values can be prescribed at vertices (Dirichlet). On the rest of the boundary the normal
/// derivative is zero. On a component where nothing is prescribed there is a solution only if the
/// integral of
/// \f$f\f$ vanishes, and it can be shifted: there \f$f\f$ is replaced by \f$f\f$ less its mean, and
/// the solution has mean zero.
///
/// The object does not refer to the mesh, and holds for as long as connectivity and lengths stay.
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

  /// factorizes the matrix of a surface on which no values are prescribed.
  /// Complexity: a sparse Cholesky factorization.
  /// \param mesh the surface, with any number of components; isolated vertices are components
  /// \param length a readable property map from its edges to their lengths
  /// \throws Numerical_error if the area of a face is zero or out of range, or if rounding leaves
  ///         the matrix without a factorization
  template <typename EdgeLengthMap>
  Poisson_solver(const Delta_complex& mesh, const EdgeLengthMap& length)
    : Poisson_solver(mesh, length, boost::static_property_map<bool>(false))
  {}

  /// factorizes the matrix of a surface on which values are prescribed at some vertices; otherwise
  /// as above.
  /// \param mesh the surface
  /// \param length a readable property map from its edges to their lengths
  /// \param is_fixed a readable property map from its vertices to `bool`: where values are
  ///   prescribed
  template <typename EdgeLengthMap, typename VertexIsFixedMap>
  Poisson_solver(const Delta_complex& mesh, const EdgeLengthMap& length,
                 const VertexIsFixedMap& is_fixed)
    : Poisson_solver(internal::Mesh_components(mesh), cotan_laplacian(mesh, length),
                     lumped_mass_matrix(mesh, length).diagonal(),
                     fixed_vertices(mesh.num_vertices(), is_fixed))
  {}

  /// factorizes the matrix of the surface of `other`, with values prescribed at other vertices.
  /// \param other a solver for the surface
  /// \param is_fixed a readable property map from its vertices to `bool`: where values are
  ///   prescribed
  template <typename VertexIsFixedMap>
  Poisson_solver(const Poisson_solver& other, const VertexIsFixedMap& is_fixed)
    : Poisson_solver(other.m_components, other.m_laplacian, other.m_area,
                     fixed_vertices(other.m_area.size(), is_fixed))
  {}

  /// the same for one of the two triangulations of `tri`.
  template <typename Traits>
  Poisson_solver(Side side, const Intrinsic_triangulation<Traits>& tri)
    : Poisson_solver(internal::mesh_of(side, tri), internal::lengths_of(side, tri))
  {}

  /// the same for one of the two triangulations of `tri`.
  template <typename Traits, typename VertexIsFixedMap>
  Poisson_solver(Side side, const Intrinsic_triangulation<Traits>& tri,
                 const VertexIsFixedMap& is_fixed)
    : Poisson_solver(internal::mesh_of(side, tri), internal::lengths_of(side, tri), is_fixed)
  {}

  /// solves with zero at the vertices where values are prescribed.
  /// \param moments the integrals \f$\int f \varphi_i\f$ against the hat functions: the product of
  ///        `mass_matrix()` with the values of \f$f\f$, or what `divergence_matrix()` gives
  Vector solve(const Vector& moments) const { return solve(moments, Vector::Zero(m_area.size())); }

  /// solves with prescribed values. Complexity: linear in the size of the factorization.
  /// \param moments as above; they have no influence where values are prescribed
  /// \param values the values; only those at the vertices where they are prescribed are read
  Vector solve(const Vector& moments, const Vector& values) const
  {
    Vector result = Vector::Zero(m_area.size());
    for(Eigen::Index v = 0; v < result.size(); ++v)
      if(m_is_fixed[index(v)])
        result[v] = values[v];
    const Vector rest = moments - m_area.cwiseProduct(free_means(moments)) - m_laplacian * result;
    result += m_unknowns * m_factorization.solve(m_unknowns.transpose() * rest);
    return result - free_means(m_area.cwiseProduct(result));
  }

private:
  typedef Eigen::SparseMatrix<FT> Matrix;

  Poisson_solver(const internal::Mesh_components& components, const Matrix& laplacian,
                 const Vector& area, const std::vector<char>& is_fixed)
    : m_components(components),
      m_laplacian(laplacian),
      m_area(area),
      m_is_fixed(is_fixed),
      m_is_anchored(anchored_components()),
      m_unknowns(select_unknowns()),
      m_factorization(m_unknowns.transpose() * m_laplacian * m_unknowns, "cotan Laplacian")
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

  // The matrix that places the unknowns among all vertices. On a component where nothing is
  // prescribed, all but its first vertex are unknown.
  Matrix select_unknowns() const
  {
    std::vector<char> is_anchored(m_is_anchored);
    internal::Sparse_assembly<FT> assembly(m_is_fixed.size());
    std::size_t count = 0;
    for(std::size_t v = 0; v < m_is_fixed.size(); ++v) {
      char& anchored = is_anchored[m_components[v]];
      if(anchored && !m_is_fixed[v])
        assembly.add(v, count++, FT(1));
      anchored = 1;
    }
    return assembly.matrix(m_is_fixed.size(), count);
  }

  // For each vertex the mean over its component of a density with these moments, zero where values
  // are prescribed.
  Vector free_means(const Vector& moments) const
  {
    const auto component = [&](Eigen::Index v) {
      return static_cast<Eigen::Index>(m_components[index(v)]);
    };
    Vector integral = Vector::Zero(static_cast<Eigen::Index>(m_components.size())), area = integral;
    for(Eigen::Index v = 0; v < moments.size(); ++v) {
      integral[component(v)] += moments[v];
      area[component(v)] += m_area[v];
    }
    Vector result = Vector::Zero(moments.size());
    for(Eigen::Index v = 0; v < moments.size(); ++v)
      if(const auto c = component(v); !m_is_anchored[index(c)] && area[c] > 0)
        result[v] = integral[c] / area[c];
    return result;
  }

  internal::Mesh_components m_components;
  Matrix m_laplacian;
  Vector m_area; // a third of the area around each vertex
  std::vector<char> m_is_fixed;
  std::vector<char> m_is_anchored; // components where a value is prescribed
  Matrix m_unknowns;
  internal::Factorization<FT> m_factorization;
};

/// \ingroup PkgIntrinsicTriangulationsOperators
/// solves \f$-\Delta u = f\f$ where no values are prescribed (see `Poisson_solver`).
/// Complexity: a sparse Cholesky factorization.
/// \param mesh the surface
/// \param length a readable property map from its edges to their lengths
/// \param density the values of \f$f\f$ at the vertices
/// \returns the values of \f$u\f$ at the vertices; zero at an isolated one
/// \throws Numerical_error as the constructor of `Poisson_solver`
template <typename EdgeLengthMap, typename FT>
Eigen::Matrix<FT, Eigen::Dynamic, 1>
solve_poisson(const Delta_complex& mesh, const EdgeLengthMap& length,
              const Eigen::Matrix<FT, Eigen::Dynamic, 1>& density)
{
  return Poisson_solver<FT>(mesh, length).solve(mass_matrix(mesh, length) * density);
}

/// \ingroup PkgIntrinsicTriangulationsOperators
/// the same for one of the two triangulations of `tri`.
template <typename Traits, typename FT>
Eigen::Matrix<FT, Eigen::Dynamic, 1>
solve_poisson(Side side, const Intrinsic_triangulation<Traits>& tri,
              const Eigen::Matrix<FT, Eigen::Dynamic, 1>& density)
{
  return solve_poisson(internal::mesh_of(side, tri), internal::lengths_of(side, tri), density);
}

/// \ingroup PkgIntrinsicTriangulationsOperators
/// solves \f$-\Delta u = f\f$ with prescribed values (see `Poisson_solver`).
/// Complexity: a sparse Cholesky factorization.
/// \param mesh the surface
/// \param length a readable property map from its edges to their lengths
/// \param density the values of \f$f\f$ at the vertices
/// \param is_fixed a readable property map from the vertices to `bool`: where values are prescribed
/// \param values the values; only those at the vertices where they are prescribed are read
/// \returns the values of \f$u\f$ at the vertices
/// \throws Numerical_error as the constructor of `Poisson_solver`
template <typename EdgeLengthMap, typename FT, typename VertexIsFixedMap>
Eigen::Matrix<FT, Eigen::Dynamic, 1>
solve_poisson(const Delta_complex& mesh, const EdgeLengthMap& length,
              const Eigen::Matrix<FT, Eigen::Dynamic, 1>& density, const VertexIsFixedMap& is_fixed,
              const Eigen::Matrix<FT, Eigen::Dynamic, 1>& values)
{
  const Poisson_solver<FT> solver(mesh, length, is_fixed);
  return solver.solve(mass_matrix(mesh, length) * density, values);
}

/// \ingroup PkgIntrinsicTriangulationsOperators
/// the same for one of the two triangulations of `tri`.
template <typename Traits, typename FT, typename VertexIsFixedMap>
Eigen::Matrix<FT, Eigen::Dynamic, 1>
solve_poisson(Side side, const Intrinsic_triangulation<Traits>& tri,
              const Eigen::Matrix<FT, Eigen::Dynamic, 1>& density, const VertexIsFixedMap& is_fixed,
              const Eigen::Matrix<FT, Eigen::Dynamic, 1>& values)
{
  return solve_poisson(internal::mesh_of(side, tri), internal::lengths_of(side, tri), density,
                       is_fixed, values);
}

} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_POISSON_H
